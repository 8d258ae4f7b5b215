"""XState 5: the configuration of a machine as JSON. Guards and actions stand there by their names only."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator

from aseme_dsl.interop.emf.charts import one_line
from aseme_dsl.interop.emf.markup import Unreadable
from aseme_dsl.interop.machines.json_text import Value, read_json
from aseme_dsl.interop.machines.machine import (
    Datum,
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
from aseme_dsl.interop.machines.places import is_inside
from aseme_dsl.source import Source

_SHAPES = {"final": Shape.FINAL, "parallel": Shape.PARALLEL, "history": Shape.HISTORY}
_SHAPES |= {"atomic": Shape.STATE, "compound": Shape.STATE}
_HARMLESS = frozenset(("description", "meta", "tags", "version", "key", "$schema", "delimiter"))
_KNOWN = frozenset("id type initial states on always after entry exit invoke onDone context".split())
LONGEST = 2_000
"""How many characters a target may have."""
_OF_TRANSITIONS = frozenset(("target", "guard", "cond", "actions", "reenter"))
_OF_INVOKES = frozenset(("id", "src", "input", "onDone", "onError"))
_TIME = re.compile(r"[0-9]{1,12}")


def read_xstate(source: Source) -> Machine:
    """The machine of a JSON text. Raises Unreadable, with the place, for what is not one."""
    document = read_json(source)
    if document.members is None or not document.members.keys() & {"states", "initial", "on", "type"}:
        raise Unreadable("it is not the configuration of an XState machine", document.place)
    return _Reader(document).machine()


class _Reader:
    def __init__(self, document: Value) -> None:
        self.document = document
        self.lost: list[Lost] = []
        self.inner: dict[tuple[str, str], Node] = {}
        """The states by the id of the state around and their key."""
        self.named: dict[str, Node] = {}
        """The states that an `id` names."""
        self.taken: set[str] = set()

    def machine(self) -> Machine:
        name = self.id_of(self.document) or "machine"
        top = Node(f" {name} machine", Shape.STATE, self.document.place, is_named=False)
        root = self.node(self.document, name, top)
        top.children.append(root)
        waiting = [(self.document, root)]
        order: list[tuple[Value, Node]] = []
        while waiting:
            value, node = waiting.pop()
            order.append((value, node))
            states = value.get("states")
            inner: list[tuple[Value, Node]] = []
            for key, child in (states.members or {} if states is not None else {}).items():
                if child.members is None:
                    raise Unreadable(f"the state `{one_line(key)[:60]}` is not an object", child.place)
                if node.shape in (Shape.FINAL, Shape.HISTORY):
                    raise Unreadable(f"a {node.shape.value} state holds no states", child.place)
                made = self.node(child, key, node)
                node.children.append(made)
                inner.append((child, made))
            waiting += reversed(inner)
        for value, node in order:
            self.content(value, node)
        if not root.children:
            raise Unreadable("it has no states", self.document.place)
        is_target = any(root.id in move.targets for _, node in order for move in node.moves)
        if root.shape is Shape.STATE and not (root.moves or root.entry or root.exit or is_target):
            root.parent = None
            top = root
        return Machine(name, "XState", top, tuple(self.data()), self.lost)

    def id_of(self, value: Value) -> str:
        found = value.get("id")
        return one_line(found.text) if found is not None else ""

    def node(self, value: Value, key: str, parent: Node) -> Node:
        kind = value.get("type")
        shape = _SHAPES.get(kind.text) if kind is not None else Shape.STATE
        if shape is None:
            raise Unreadable("the type of a state is not one of XState", (kind or value).place)
        if parent.shape is Shape.PARALLEL and shape is Shape.FINAL:
            raise Unreadable("a final state cannot stand in a parallel one", value.place)
        name = one_line(key) or "state"
        while name in self.taken:
            name = f"{parent.id}.{name}"
        self.taken.add(name)
        node = Node(name, shape, value.place, parent)
        self.inner[parent.id, key] = node
        written = self.id_of(value)
        if written:
            if written in self.named:
                raise Unreadable(f"two states have the id `{written[:60]}`", value.place)
            self.named[written] = node
        return node

    def data(self) -> Iterator[Datum]:
        context = self.document.get("context")
        if context is None:
            return
        if context.members is None:
            self.lost.append(Lost("context", "it is not an object", context.place))
            return
        for name, value in context.members.items():
            said = json.dumps(value.plain)
            if value.members is not None or value.items is not None:
                said = "{}"
            yield Datum(one_line(name), said, value.place)

    # ---- what stands in a state --------------------------------------------------------------

    def content(self, value: Value, node: Node) -> None:
        self.others(value, _KNOWN | {"history", "target"})
        initial = value.get("initial")
        if initial is not None and node.shape is Shape.STATE:
            target = initial.get("target") or initial
            node.initial = (self.target(target, node, is_initial=True).id,)
            node.initial_does = self.doings(initial.get("actions"))
            self.others(initial, frozenset(("target", "actions")))
        node.entry = self.doings(value.get("entry"))
        node.exit = self.doings(value.get("exit"))
        invoke = value.get("invoke")
        if invoke is not None:
            self.invoke(invoke, node)
        for event, moves in self.of(value, "on"):
            self.moves(node, moves, (event,))
        for wait, moves in self.of(value, "after"):
            self.delayed(node, wait, moves)
        always = value.get("always")
        if always is not None:
            self.moves(node, always, ())
        done = value.get("onDone")
        if done is not None:
            self.moves(node, done, (f"done.state.{node.id}",))

    def of(self, value: Value, name: str) -> list[tuple[str, Value]]:
        found = value.get(name)
        if found is None:
            return []
        if found.members is None:
            raise Unreadable(f"`{name}` is not an object", found.place)
        return [(one_line(key), item) for key, item in found.members.items()]

    def invoke(self, value: Value, node: Node) -> None:
        for number, item in enumerate(value.listed()):
            source = item.get("src")
            name = one_line(source.text) if source is not None else ""
            if number or not name:
                self.lost.append(Lost("invoke", "a state performs one activity with a name", item.place))
                continue
            node.activity = name
            self.others(item, _OF_INVOKES)
            given = item.get("input")
            if given is not None:
                self.lost.append(Lost("input", "an activity declares what it is given", given.place))
            for key, event in (("onDone", "done.invoke"), ("onError", "error")):
                found = item.get(key)
                if found is not None:
                    self.moves(node, found, (event,))

    def delayed(self, node: Node, wait: str, moves: Value) -> None:
        if _TIME.fullmatch(wait):
            self.moves(node, moves, (), after=int(wait) * 1_000_000)
            return
        why = "a delay that is only named"
        self.lost.append(Lost(f"after {wait[:60]}", why, moves.place))

    def moves(self, node: Node, value: Value, events: tuple[str, ...], after: int | None = None) -> None:
        for item in value.listed():
            target = item if isinstance(item.plain, str) else item.get("target")
            reenter = item.get("reenter")
            targets = [self.target(one, node) for one in target.listed()] if target is not None else []
            stays = all(other is node or is_inside(other, node) for other in targets)
            guard, named = self.guard(item.get("guard") or item.get("cond"))
            self.others(item, _OF_TRANSITIONS)
            node.moves.append(
                Move(
                    tuple(one_line(event) for event in events),
                    tuple(other.id for other in targets),
                    item.place,
                    guard,
                    named,
                    self.doings(item.get("actions")),
                    stays and not (reenter is not None and reenter.plain is True),
                    after,
                )
            )

    def others(self, item: Value, known: frozenset[str]) -> None:
        """Note the members of an object that the language has nothing for."""
        for name, found in (item.members or {}).items():
            if name not in known and not found.is_null:
                why = "the language has nothing of the kind"
                self.lost.append(Lost(f"`{one_line(name)[:60]}`", why, found.place, name in _HARMLESS))

    def target(self, value: Value, node: Node, *, is_initial: bool = False) -> Node:
        """The state that a target names: `#id`, `.child`, `sibling` or `sibling.child`.

        Where a state begins, it names a state inside.
        """
        text = one_line(value.text)
        if not text:
            raise Unreadable("a target is not a text", value.place)
        if len(text) > LONGEST:
            raise Unreadable(f"a target has more than {LONGEST} characters", value.place)
        found: Node | None
        if text.startswith("#"):
            best, rest = text[1:], ""
            while best and best not in self.named:  # the longest id that it begins with
                best, _, left = best.rpartition(".")
                rest = f"{left}.{rest}" if rest else left
            found = self.named.get(best)
        elif text.startswith("."):
            found, rest = node, text[1:]
        else:
            found, rest = (node if is_initial else node.parent), text
        for key in rest.split(".") if rest else ():
            found = None if found is None else self.inner.get((found.id, key))
        if found is None or found.parent is None:
            raise Unreadable(f"there is no state `{text[:60]}`", value.place)
        return found

    # ---- guards and actions ------------------------------------------------------------------

    def guard(self, value: Value | None) -> tuple[str | None, str]:
        """A guard as an expression, which is known of `stateIn` alone, or its name."""
        if value is None:
            return "", ""
        kind = value.get("type")
        return None, _with_parameters(
            one_line(kind.text if kind is not None else value.text), value
        ) or "a guard"

    def doings(self, value: Value | None) -> tuple[Doing, ...]:
        return tuple(self.doing(item) for item in value.listed()) if value is not None else ()

    def doing(self, value: Value) -> Doing:
        kind = value.get("type")
        name = one_line(kind.text if kind is not None else value.text)
        given = value.get("params") or value
        event = given.get("event")
        said = (event.get("type") or event).text if event is not None else ""
        if name in ("raise", "xstate.raise") and said and given.get("delay") is None:
            if event is not None and event.members is not None:
                self.others(event, frozenset(("type",)))
            return Raising(one_line(said), value.place)
        if name in ("log", "xstate.log"):
            return Noting(_with_parameters("log", value), value.place)
        name = _with_parameters(one_line(name), value)
        why = "an action of the program: an activity does it, or an assignment"
        return Other(name or "an action", why, value.place)


def _with_parameters(name: str, value: Value) -> str:
    """The name of a guard or an action, and what it is given."""
    given = value.get("params")
    return name if given is None else f"{name} {one_line(json.dumps(given.whole()))}"[:300].strip()


__all__ = ["read_xstate"]
