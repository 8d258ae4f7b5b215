"""SCXML: a W3C state machine, read from XML without document types and entities."""

from __future__ import annotations

import re
from collections.abc import Iterator, Set
from itertools import count

from aseme_dsl.interop.emf.charts import one_line
from aseme_dsl.interop.emf.markup import Element, Unreadable, read_markup
from aseme_dsl.interop.machines.machine import (
    Assigning,
    Cancelling,
    Datum,
    Delaying,
    Doing,
    Lost,
    Machine,
    Move,
    Node,
    Noting,
    Other,
    Raising,
    Shape,
)
from aseme_dsl.source import Source

OWN = "urn:asemec:amola"
"""The namespace of the attributes that say which state of an `.aseme` file one is."""
END = "END"
"""The `type` in that namespace of an END. It is a `<state>`: SCION ends a session where all states that are
active are final, also inner ones. It does what is to be done on their exit, and forgets what is delayed."""

_SHAPES = {
    "scxml": Shape.STATE,
    "state": Shape.STATE,
    "parallel": Shape.PARALLEL,
    "final": Shape.FINAL,
    "history": Shape.HISTORY,
}
_DELAY = re.compile(r"\s*([0-9]{0,9}(?:\.[0-9]{1,9})?)\s*(ms|s|m|h)?\s*", re.ASCII)
_UNITS = {"ms": 1_000_000, "s": 1_000_000_000, "m": 60_000_000_000, "h": 3_600_000_000_000}
_LONGEST_DELAY = 1_000_000 * 3_600_000_000_000
_SELF = ("", "#_internal", "#_scxml_")
_NO_HARM = frozenset(("metadata",))
_LANGUAGES = ("", "ecmascript", "javascript", "jexl", "groovy", "null", "python", "cplusplus")
"""The data models whose simple expressions are read: these mean the same in all of them."""


_ATTRIBUTES = {
    tag: frozenset(words.split())
    for tag, words in {
        "scxml": "initial name xmlns version datamodel binding schemaLocation",
        "state": "id initial src",
        "parallel": "id src",
        "final": "id src",
        "history": "id type",
        "initial": "",
        "onentry": "",
        "onexit": "",
        "transition": "event cond target type",
        "datamodel": "",
        "data": "id src expr",
        "invoke": "type src id",
        "raise": "event",
        "log": "label expr",
        "assign": "location expr",
        "cancel": "sendid",
        "script": "src",
        "if": "cond",
    }.items()
}
"""The attributes that are read. What cannot be taken over as a whole is listed with all its attributes."""


def read_scxml(source: Source) -> Machine:
    """The machine of an SCXML text. Raises Unreadable, with the place, for what is not one."""
    document = read_markup(source)
    if document.tag != "scxml":
        raise Unreadable(f"`<{one_line(document.tag)[:40]}>` is not an SCXML document", document.place)
    return _Reader(document).machine()


def delay(text: str) -> int | None:
    """A delay as in CSS, in ns; None for another text."""
    read = _DELAY.fullmatch(text)
    if read is None or read[1] in ("", "."):
        return None
    found = round(float(read[1]) * _UNITS[read[2] or "ms"])
    return found if found <= _LONGEST_DELAY else None


class _Reader:
    def __init__(self, document: Element) -> None:
        self.document = document
        self.data: list[Datum] = []
        self.lost: list[Lost] = []
        self.ids: set[str] = set()
        self.numbers = count()
        model = document.said("datamodel")
        self.language = model if model not in _LANGUAGES else ""

    def machine(self) -> Machine:
        root = self.node(self.document, None)
        waiting = [(self.document, root)]
        while waiting:
            element, node = waiting.pop()
            inner = [
                child for child in element.children if child.tag in _SHAPES and not self.is_foreign(child)
            ]
            for child in inner:
                if child.tag == "scxml" or node.shape in (Shape.FINAL, Shape.HISTORY):
                    raise Unreadable(f"<{child.tag}> cannot stand in <{element.tag}>", child.place)
                if node.shape is Shape.PARALLEL and child.tag == "final":
                    raise Unreadable("<final> cannot stand in <parallel>", child.place)
                made = self.node(child, node)
                node.children.append(made)
            waiting += reversed(list(zip(inner, node.children, strict=True)))
        if not root.children:
            raise Unreadable("it has no state", self.document.place)
        name = one_line(self.document.said("name"))
        machine = Machine(name, "SCXML", root, tuple(self.data), self.lost)
        _check_targets(machine, self.ids)
        return machine

    def node(self, element: Element, parent: Node | None) -> Node:
        """A state, without the states in it."""
        shape, name = _SHAPES[element.tag], one_line(element.said("id"))
        if element.tag == "state" and element.prefixed.get("type") == OWN and element.get("type") == END:
            shape = Shape.FINAL
        if parent is not None and name:
            if name in self.ids:
                raise Unreadable(f"two states have the id `{name[:60]}`", element.place)
            self.ids.add(name)
        node = Node(
            name or f" {element.tag} {next(self.numbers)}",  # no id of a file begins with a blank
            shape,
            element.place,
            parent,
            initial=tuple(element.said("initial").split()),
            is_named=bool(name),
        )
        self.attributes(element)
        if element.tag != "scxml" and element.said("src"):
            self.lost.append(Lost("`src`", "what is in the state stands in another file", element.place))
        if element.said("binding") == "late":
            self.lost.append(Lost("`binding`", "variables have their first values at once", element.place))
        for child in element.children:
            if self.is_foreign(child):
                self.lose(child, "it is of another namespace", is_harmless=True)
            elif child.tag not in _SHAPES:
                self.part(node, element, child)
        return node

    def attributes(self, element: Element) -> None:
        """Note the attributes that say something else than the Recommendation."""
        for name in sorted(
            element.attributes.keys() - _ATTRIBUTES.get(element.tag, element.attributes.keys())
        ):
            what = f"`{one_line(name)[:60]}` of <{element.tag}>"
            why = "the language has nothing of the kind"
            self.lost.append(Lost(what, why, element.place, name in element.prefixed))

    def part(self, node: Node, element: Element, child: Element) -> None:
        """What stands in a state besides states."""
        self.attributes(child)
        match child.tag:
            case "transition":
                node.moves.append(self.move(child))
            case "onentry":
                node.entry += tuple(self.content(child))
            case "onexit":
                node.exit += tuple(self.content(child))
            case "initial":
                first = next(child.named("transition"), None)
                if first is None:
                    raise Unreadable("<initial> has no transition", child.place)
                node.initial = tuple(first.said("target").split())
                self.attributes(first)
                node.initial_does = tuple(self.content(first))
                for other in child.children:
                    if other is not first:
                        self.lose(other, "<initial> has one transition")
            case "datamodel":
                for datum in child.children:
                    if datum.tag == "data":
                        self.datum(datum)
                    else:
                        self.lose(datum, "a data model has <data>", is_harmless=self.is_foreign(datum))
            case "invoke":
                name = one_line(child.said("id") or child.said("src") or child.said("type") or "invoke")
                if node.activity:
                    self.lose(child, "a state performs one activity")
                    return
                node.activity = name
                for attribute in ("src", "type"):
                    if one_line(child.said(attribute)) not in ("", name):
                        what = f"`{attribute}` of <invoke>"
                        self.lost.append(Lost(what, f"the activity is called {name}", child.place, True))
                self.inside(child, "an activity declares what it is given")
            case "script" if element.tag == "scxml":
                node.entry += tuple(self.script(child))
            case _:
                self.lose(child, "the language has nothing of the kind", is_harmless=child.tag in _NO_HARM)

    def is_foreign(self, element: Element) -> bool:
        """Whether an element is of another namespace than the document."""
        return element.namespace not in ("", self.document.namespace)

    def lose(self, element: Element, why: str, *, is_harmless: bool = False) -> None:
        self.lost.append(Lost(f"<{one_line(element.tag)[:60]}>", why, element.place, is_harmless))

    def inside(self, element: Element, why: str) -> None:
        for child in element.children:
            self.lose(child, why)

    def datum(self, element: Element) -> None:
        self.attributes(element)
        name = one_line(element.said("id"))
        value = one_line(element.said("expr") or element.text)
        if element.said("src"):
            self.lose(element, "its value stands in another file")
            return
        self.data.append(Datum(name, value, element.place))

    # ---- transitions and what they do --------------------------------------------------------

    def move(self, element: Element) -> Move:
        events = tuple(element.said("event").split())
        guard = self.expression(element.said("cond"))
        return Move(
            events,
            tuple(element.said("target").split()),
            element.place,
            guard,
            one_line(element.said("cond")) if guard is None else "",
            tuple(self.content(element)),
            element.said("type") == "internal",
        )

    def expression(self, text: str) -> str | None:
        """A condition, or None for one in another language."""
        return None if self.language and text else one_line(text)

    def content(self, element: Element) -> Iterator[Doing]:
        for child in element.children:
            self.attributes(child)
            match child.tag:
                case _ if self.is_foreign(child):
                    yield _other(child, "it is of another namespace")
                case "raise" if child.said("event"):
                    yield Raising(one_line(child.said("event")), child.place)
                case "assign":
                    yield self.assign(child)
                case "log":
                    text = " ".join(filter(None, (child.said("label"), child.said("expr"))))
                    yield Noting(one_line(f"log {text}"), child.place)
                case "send":
                    yield self.send(child)
                case "cancel" if child.said("sendid"):
                    yield Cancelling(one_line(child.said("sendid")), child.place)
                case "script":
                    yield from self.script(child)
                case "if":
                    yield from self.choice(child)
                case _:
                    yield _other(child, f"the language has no <{one_line(child.tag)[:40]}>")

    def assign(self, element: Element) -> Doing:
        if self.language:
            return _other(element, f"it is in the language {self.language[:40]}")
        value = element.said("expr") or element.text
        return Assigning(one_line(element.said("location")), one_line(value), element.place)

    def script(self, element: Element) -> Iterator[Doing]:
        from aseme_dsl.interop.machines.ecmascript import Untranslatable, assignments

        if self.language or element.said("src"):
            yield _other(element, "it is in another language or file")
            return
        try:
            found = assignments(element.text)
        except Untranslatable as reason:
            yield _other(element, str(reason))
            return
        for name, value in found:
            yield Assigning(name, value, element.place)

    def send(self, element: Element) -> Doing:
        event, target = element.said("event"), element.said("target")
        computed = [name for name in element.attributes if name.endswith("expr") or name == "idlocation"]
        if not event or computed or element.said("namelist") or element.children:
            return _other(element, "only an event without content, which is not computed, is raised")
        if target not in _SELF:
            return _other(element, f"it is for `{one_line(target)[:60]}`: send it from an activity")
        if element.said("type") not in ("", "scxml", "http://www.w3.org/TR/scxml/#SCXMLEventProcessor"):
            return _other(element, "its type is not that of SCXML")
        name, wait = one_line(event), element.said("delay")
        if not wait:
            return Raising(name, element.place, target != "#_internal")
        after = delay(wait)
        if after is None:
            return _other(element, f"`{one_line(wait)[:40]}` is not a delay")
        if not after:
            return Raising(name, element.place, True)
        return Delaying(name, after, element.place, one_line(element.said("id")))

    def choice(self, element: Element) -> Iterator[Doing]:
        """`<if>` around assignments: each variable becomes what the branch that is taken gives it."""
        branches: list[tuple[str, list[Element]]] = [(element.said("cond"), [])]
        for child in element.children:
            if child.tag in ("elseif", "else"):
                branches.append((child.said("cond") if child.tag == "elseif" else "else", []))
            else:
                branches[-1][1].append(child)
        names = {item.said("location") for _, inside in branches for item in inside}
        plain = all(item.tag == "assign" and item.said("expr") for _, inside in branches for item in inside)
        if self.language or not plain or len(names) != 1 or any(len(inside) > 1 for _, inside in branches):
            yield _other(element, "only a choice of one assignment is an action")
            return
        if not all(cond for cond, _ in branches) or len(branches) > 20:
            yield _other(element, "its conditions are not complete")
            return
        (name,) = names
        value = name
        for cond, inside in reversed(branches):
            wanted = inside[0].said("expr") if inside else name
            value = wanted if cond == "else" else f"({cond}) ? ({wanted}) : ({value})"
        yield Assigning(one_line(name), one_line(value), element.place)


def _other(element: Element, why: str) -> Other:
    said = " ".join(f'{key}="{value}"' for key, value in list(element.attributes.items())[:8])
    inner = one_line(element.text)
    text = f"<{element.tag}{' ' if said else ''}{said}>{' ' if inner else ''}{inner}"
    return Other(one_line(text)[:300], why, element.place)


def _check_targets(machine: Machine, ids: Set[str]) -> None:
    for node in machine.nodes():
        for move in node.moves:
            for target in move.targets:
                if target not in ids:
                    raise Unreadable(f"there is no state `{target[:60]}`", move.place)
        for target in node.initial:
            if target not in ids:
                raise Unreadable(f"there is no state `{target[:60]}`", node.place)


__all__ = ["END", "OWN", "delay", "read_scxml"]
