"""Charts: the statechart of an `.iac`, `.eac`, `.model`, `.sct` or `.stct` file, of all three generations."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import field
from functools import cached_property

from aseme_dsl.amola.operators import Operator
from aseme_dsl.amola.statechart import StateType, label_key
from aseme_dsl.interop.emf.markup import DEEPEST, Element, Unreadable
from aseme_dsl.interop.emf.references import References
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

_LABEL = re.compile(r"(?:0|[1-9][0-9]{0,6})(?:\.(?:0|[1-9][0-9]{0,6})){0,200}")
_TYPES = {item.value: item for item in StateType}
SPELLINGS = tuple(spelling for operator in Operator for spelling in operator.row.originals)
"""What the tools wrote for operators in the names of states."""
LONGEST = 20_000
"""How many characters an expression may have."""


@dataclass(frozen=True, slots=True)
class ForeignState:
    """A state as the file has it. `label` is its place, `parent` that of the state around it."""

    label: str
    name: str
    type: StateType
    parent: str | None
    place: Span
    activity: str = ""
    actions: str = ""
    metadata: str = ""
    variables: tuple[str, ...] = ()
    was: str = ""
    """The label in the file, where it is another."""
    was_hollow: bool = False
    """Whether it is an OR without states in the file, which is still to be drawn: an activity here."""


@dataclass(frozen=True, slots=True)
class ForeignTransition:
    source: str
    target: str
    expression: str
    """On one line, "" if nothing is said."""
    place: Span
    metadata: str = ""


@dataclass(frozen=True, slots=True)
class ForeignVariable:
    name: str
    type: str
    place: Span


@dataclass(frozen=True)
class ForeignChart:
    """A statechart of the originals: states in document order, each after its parent."""

    name: str
    states: tuple[ForeignState, ...]
    transitions: tuple[ForeignTransition, ...]
    variables: tuple[ForeignVariable, ...]
    place: Span
    description: str = ""
    metadata: str = ""
    lost: tuple[tuple[str, Span], ...] = field(default=())
    """What the file has besides."""

    @cached_property
    def by_label(self) -> dict[str, ForeignState]:
        return {state.label: state for state in self.states}

    @cached_property
    def children(self) -> dict[str, tuple[ForeignState, ...]]:
        """The states directly inside each."""
        found: dict[str, list[ForeignState]] = {}
        for state in self.states:
            if state.parent is not None:
                found.setdefault(state.parent, []).append(state)
        return {label: tuple(states) for label, states in found.items()}

    def inside(self, label: str) -> tuple[ForeignState, ...]:
        return self.children.get(label, ())

    @cached_property
    def outgoing(self) -> dict[str, tuple[ForeignTransition, ...]]:
        found: dict[str, list[ForeignTransition]] = {}
        for item in self.transitions:
            found.setdefault(item.source, []).append(item)
        return {label: tuple(items) for label, items in found.items()}


def one_line(text: str) -> str:
    """A text on one line, without what cannot be printed: it may stand in a comment."""
    return "".join(c if c.isprintable() else "?" for c in " ".join(text.split()))


def is_chart(document: Element) -> bool:
    """Whether a file has states."""
    tops = document.children if document.tag == "XMI" else [document]
    return any(top.tag in ("Model", "Node") for top in tops)


def read_chart(document: Element) -> ForeignChart:
    """The statechart of a file. Raises Unreadable, with the reason, for what is not one."""
    return _Reader(document).chart()


@dataclass(slots=True)
class _Node:
    element: Element
    parent: _Node | None = None
    children: list[_Node] = field(default_factory=list)
    label: str = ""


class _Reader:
    def __init__(self, document: Element) -> None:
        self.document = document
        self.references = References(document)
        self.tops = self.references.tops
        self.model = next((top for top in self.tops if top.tag == "Model"), document)
        self.nodes: dict[int, _Node] = {}

    def chart(self) -> ForeignChart:
        roots = self._roots()
        if not roots:
            raise Unreadable("it has no state", self.model.place)
        if len(roots) > 1:
            names = ", ".join(f"`{one_line(root.element.get('name'))}`" for root in roots[:3])
            raise Unreadable(f"it has {len(roots)} states without a parent ({names})", roots[1].element.place)
        self._number(roots[0])
        states = tuple(self._states(roots[0]))
        variables = tuple(
            ForeignVariable(one_line(item.get("name")), one_line(item.get("type")), item.place)
            for item in self._of_kind("variables", "Variable")
        )
        name = one_line(self.model.get("name"))
        model = self.model
        return ForeignChart(
            name,
            states,
            tuple(self._transitions()),
            variables,
            model.place,
            one_line(model.get("description")),
            one_line(model.get("metadata")),
            tuple(self._lost()),
        )

    # ---- states ------------------------------------------------------------------------------

    def _of_kind(self, feature: str, kind: str) -> list[Element]:
        """What the model contains, and what stands beside it."""
        inside = (
            [] if self.model is self.document and self.document.tag == "XMI" else self.model.named(feature)
        )
        return [*inside, *(top for top in self.tops if top.tag == kind)]

    def _roots(self) -> list[_Node]:
        """The states that no other contains, with all others inside them."""
        waiting: list[tuple[Element, _Node | None]] = [
            (item, None) for item in self._of_kind("nodes", "Node")
        ]
        waiting.reverse()
        while waiting:
            element, parent = waiting.pop()
            node = self.nodes[id(element)] = _Node(element, parent)
            waiting += [(child, node) for child in reversed(list(element.named("Children")))]
        for node in self.nodes.values():
            if node.parent is None:
                node.parent = self._father(node.element)
        if all(node.parent is None for node in self.nodes.values()):
            self._parents_by_label()
        roots: list[_Node] = []
        for node in self.nodes.values():
            (roots if node.parent is None else node.parent.children).append(node)
        self._check_circles()
        return roots

    def _father(self, element: Element) -> _Node | None:
        """Of a flat file, the state around one: the feature is called `Father_of` there."""
        for feature in ("Father_of", "Father"):
            fathers = self.references.of(element, feature)
            if len(fathers) > 1:
                raise Unreadable(f"{_title(element)} has {len(fathers)} parents", element.place)
            if fathers:
                father = fathers[0]
                if isinstance(father, str) or id(father) not in self.nodes:
                    raise Unreadable(f"the parent of {_title(element)} is missing", element.place)
                return self.nodes[id(father)]
        return None

    def _parents_by_label(self) -> None:
        """Of the oldest files, whose states have no parents: `0.2` is around `0.2.1`."""
        by_label = {node.element.get("label"): node for node in self.nodes.values()}
        if len(by_label) == len(self.nodes):
            for label, node in by_label.items():
                node.parent = by_label.get(label.rpartition(".")[0]) if _LABEL.fullmatch(label) else None

    def _check_circles(self) -> None:
        sure: set[int] = set()
        for node in self.nodes.values():
            way: dict[int, None] = {}
            at: _Node | None = node
            while at is not None and id(at) not in sure:
                if id(at) in way:
                    raise Unreadable(f"{_title(at.element)} is inside itself", at.element.place)
                way[id(at)] = None
                at = at.parent
                if len(way) > DEEPEST:
                    raise Unreadable(f"its states are nested more than {DEEPEST} deep", node.element.place)
            sure.update(way)

    def _number(self, root: _Node) -> None:
        """Give each state its label: the file's, if they are places, otherwise new ones in document order."""
        nodes = list(_walk(root))
        written = [node.element.get("label") for node in nodes]
        are_places = len(set(written)) == len(written) and all(
            _LABEL.fullmatch(label) is not None and _is_place(label, node)
            for node, label in zip(nodes, written, strict=True)
        )
        if are_places:
            for node, label in zip(nodes, written, strict=True):
                node.label = label
                node.children.sort(key=lambda child: label_key(child.element.get("label")))
            return
        root.label = "0"
        for node in _walk(root):
            for number, child in enumerate(node.children, 1):
                child.label = f"{node.label}.{number}"

    def _states(self, root: _Node) -> Iterator[ForeignState]:
        for node in _walk(root):
            element, name = node.element, one_line(node.element.get("name"))
            kind = element.get("type")
            if kind not in _TYPES:
                said = (
                    f"the type `{one_line(kind)[:40]}`, which the language does not have"
                    if kind
                    else "no type"
                )
                raise Unreadable(f"{_title(element)} has {said}", element.place)
            is_hollow = kind == "OR" and not node.children and node.parent is not None
            if is_hollow and any(sign in name for sign in SPELLINGS):
                raise Unreadable(
                    f"{_title(element)} is OR and has nothing inside: its term stands twice in the formula,"
                    " and the tool lost one",
                    element.place,
                )
            written = one_line(element.get("label"))
            variables = [
                one_line(item.get("name"))
                for item in self.references.of(element, "variables")
                if isinstance(item, Element)
            ]
            yield ForeignState(
                node.label,
                name,
                StateType.BASIC if is_hollow else _TYPES[kind],
                None if node.parent is None else node.parent.label,
                element.place,
                one_line(element.get("activity")),
                one_line(element.get("actions")),
                one_line(element.get("metadata")),
                tuple(variables),
                "" if written == node.label else written or "-",
                is_hollow,
            )

    # ---- transitions -------------------------------------------------------------------------

    def _transitions(self) -> Iterator[ForeignTransition]:
        for element in self._of_kind("transitions", "Transition"):
            ends = [self._end(element, feature) for feature in ("source", "target")]
            text = one_line(element.get("TE"))
            if len(text) > LONGEST:
                raise Unreadable(f"an expression has more than {LONGEST} characters", element.place)
            yield ForeignTransition(ends[0], ends[1], text, element.place, one_line(element.get("metadata")))

    def _end(self, element: Element, feature: str) -> str:
        found = self.references.one(element, feature)
        if isinstance(found, Element) and id(found) in self.nodes:
            return self.nodes[id(found)].label
        name = one_line(element.get("name"))[:60]
        raise Unreadable(f"the {feature} of the transition `{name}` is missing", element.place)

    def _lost(self) -> Iterator[tuple[str, Span]]:
        known = {"nodes", "transitions", "variables", "Node", "Transition", "Variable", "Model"}
        within = [self.model] if self.model is not self.document else []
        for holder in dict.fromkeys(map(id, [self.document, *within])):
            element = self.document if holder == id(self.document) else self.model
            for child in element.children:
                if child.tag not in known:
                    yield one_line(child.tag), child.place


def _walk(root: _Node) -> Iterator[_Node]:
    waiting = [root]
    while waiting:
        node = waiting.pop()
        yield node
        waiting += reversed(node.children)


def _is_place(label: str, node: _Node) -> bool:
    around = "" if node.parent is None else node.parent.element.get("label")
    return label.rpartition(".")[0] == around


def _title(element: Element) -> str:
    name, label = (one_line(element.get(key))[:60] for key in ("name", "label"))
    return f"the state `{name or label}`" + (f" ({label})" if label and label != name else "")


__all__ = [
    "SPELLINGS",
    "ForeignChart",
    "ForeignState",
    "ForeignTransition",
    "ForeignVariable",
    "is_chart",
    "one_line",
    "read_chart",
]
