"""Blocks: a statechart as the nested forms that the compact layout knows, or the reason why it is not."""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.amola.statechart import State, Statechart, StateType
from aseme_dsl.diagrams.look.labels import short
from aseme_dsl.records import dataclass

Link = tuple[int, ...]
"""Transitions with the same two ends, by their place in the chart, in the order in which they are tried."""

DEEPEST = 120
"""The most levels that are drawn: a drawing of more is unreadable."""


class NotCompact(ValueError):
    """A chart has no compact drawing; the text says which state is the reason, and why."""


@dataclass(frozen=True, slots=True)
class Activity:
    """A BASIC state."""

    label: str


@dataclass(frozen=True, slots=True)
class Parallel:
    """An AND with its regions in document order."""

    label: str
    regions: tuple[Group | Closed, ...]


@dataclass(frozen=True, slots=True)
class Cut:
    """What interrupts a part (`A [> B`): how it is entered, and what it is."""

    enter: Link
    part: Part


@dataclass(frozen=True, slots=True)
class Part:
    """A block on a line: `again` leads back to it, `onward` to what follows (a state, or the END)."""

    block: Block
    again: Link
    onward: Link
    cuts: tuple[Cut, ...] = ()


@dataclass(frozen=True, slots=True)
class Branch:
    """A line of parts. One without parts passes by: `enter` leads to the END."""

    enter: Link
    parts: tuple[Part, ...]


@dataclass(frozen=True, slots=True)
class Group:
    """An OR: `enter` leads to the `choice` and on to one of the branches, or to the only branch."""

    label: str
    start: str
    end: str | None
    choice: str | None
    enter: Link
    branches: tuple[Branch, ...]
    reactive: Link = ()


@dataclass(frozen=True, slots=True)
class Closed:
    """A composite that is drawn without what is inside, and why if that has no compact drawing."""

    label: str
    reason: str = ""


Block = Activity | Parallel | Group | Closed


def blocks(chart: Statechart, top: str, closed: frozenset[str] = frozenset()) -> Group:
    """The OR `top` of a chart as blocks, with the composites `closed` closed, and those without a formula.

    Raises NotCompact if the outermost one has none.
    """
    if chart.levels > DEEPEST:
        raise NotCompact(f"it has {chart.levels} levels, more than {DEEPEST}")
    return _Reader(chart, closed - {top}).group(chart.node(top))


class _Reader:
    """Reads one chart: the links between its states are taken away as they are used."""

    def __init__(self, chart: Statechart, closed: frozenset[str]) -> None:
        self._chart = chart
        self._closed = closed
        places = {id(item): place for place, item in enumerate(chart.transitions)}
        self._links: dict[str, dict[tuple[str, bool, bool], list[int]]] = {}
        for state in chart.states:
            for item in chart.outgoing_edges(state.label):
                ends = (item.target, item.first, item.reactive)
                self._links.setdefault(state.label, {}).setdefault(ends, []).append(places[id(item)])

    def group(self, state: State) -> Group:
        inside = self._chart.children(state.label)
        for way in (way for item in inside for way in self._chart.outgoing_edges(item.label) if way.into):
            ends = f"from {self._called(way.source)} into several regions of {self._called(way.target)}"
            raise NotCompact(f"the arrow {ends} belongs to no formula")
        start = self._only(state, inside, StateType.START)
        end = next((item.label for item in inside if item.type is StateType.END), None)
        first, enter = self._onward(start, {item.label for item in inside})
        choice = first if self._chart.node(first).type is StateType.CONDITION else None
        left = {item.label for item in inside} - {start, end, choice}
        reactive: list[int] = []
        branches = []
        ways = [(first, enter)] if choice is None else self._ways(choice)
        for target, link in ways:
            parts, back = self._line(target, end, left)
            reactive += back
            branches.append(Branch(link, parts))
        if left:
            raise NotCompact(f"no line of the formula leads to {self._called(min(left))}")
        for item in inside:
            if rest := self._links.get(item.label):
                (target, _, _) = next(iter(rest))
                ends = f"from {self._called(item.label)} to {self._called(target)}"
                raise NotCompact(f"the arrow {ends} belongs to no formula")
        entered = () if choice is None else enter
        return Group(state.label, start, end, choice, entered, tuple(branches), tuple(reactive))

    def _called(self, label: str) -> str:
        """`state Search (0.2)`: a nested drawing shows the label only of what has no other name."""
        name = self._chart.node(label).name
        return f"state {label}" if name == label else f"state {short(name, 40)} ({label})"

    def _only(self, state: State, inside: Iterable[State], kind: StateType) -> str:
        found = [item.label for item in inside if item.type is kind]
        if len(found) != 1:
            raise NotCompact(f"{self._called(state.label)} has {len(found)} states {kind.value}")
        return found[0]

    def _ways(self, label: str) -> list[tuple[str, Link]]:
        """The links of a choice, in the order in which they are tried."""
        found = self._links.pop(label, {})
        if any(first or reactive for _, first, reactive in found):
            raise NotCompact(f"the choice {label} has an interrupt")
        return [(target, tuple(link)) for (target, _, _), link in found.items()]

    def _onward(self, label: str, inside: set[str]) -> tuple[str, Link]:
        ways = self._ways(label)
        if len(ways) != 1 or ways[0][0] not in inside:
            raise NotCompact(f"{self._called(label)} has {len(ways)} ways onward")
        return ways[0]

    def _line(self, label: str | None, end: str | None, left: set[str]) -> tuple[tuple[Part, ...], list[int]]:
        """The parts from a state to the END, and the reactive transitions from them."""
        parts: list[Part] = []
        back: list[int] = []
        while label is not None and label != end:
            part, label, reactive = self._part(label, end, left)
            parts.append(part)
            back += reactive
        return tuple(parts), back

    def _part(self, label: str, end: str | None, left: set[str]) -> tuple[Part, str | None, list[int]]:
        if label not in left:
            raise NotCompact(f"lines lead to {self._called(label)} in several ways")
        left.remove(label)
        links = self._links.pop(label, {})
        again: Link = ()
        back: list[int] = []
        onward: list[tuple[str, Link]] = []
        cuts: list[tuple[str, Link]] = []
        for (to, first, reactive), places in links.items():
            if reactive:
                back += places
            elif first:
                cuts.append((to, tuple(places)))
            elif to == label:
                again = tuple(places)
            else:
                onward.append((to, tuple(places)))
        cut = {other for other, _ in cuts}
        cuts = [
            (other, (*link, *(place for goal, more in onward if goal == other for place in more)))
            for other, link in cuts
        ]
        onward = [item for item in onward if item[0] not in cut]
        if len(onward) > 1:
            raise NotCompact(f"{self._called(label)} has {len(onward)} ways onward")
        target: str | None = onward[0][0] if onward else None
        way = onward[0][1] if onward else ()
        interrupts = []
        for other, entered in cuts:
            part, after, reactive_too = self._part(other, end, left)
            back += reactive_too
            if after not in (None, end) or target not in (None, end):
                raise NotCompact(f"what interrupts {self._called(label)} does not lead where it leads")
            interrupts.append(Cut(entered, part))
        return Part(self._block(label), again, way, tuple(interrupts)), target, back

    def _block(self, label: str) -> Block:
        state = self._chart.node(label)
        match state.type:
            case StateType.BASIC:
                return Activity(label)
            case StateType.AND | StateType.OR if label in self._closed:
                return Closed(label)
            case StateType.AND:
                regions = self._chart.children(label)
                if left := next((item.label for item in regions if item.label in self._links), None):
                    raise NotCompact(f"an arrow leads from the region {left}")
                return Parallel(label, tuple(self._whole(item) for item in regions))
            case StateType.OR:
                return self._whole(state)
            case _:
                raise NotCompact(f"{self._called(label)} is a {state.type.value} where a formula has none")

    def _whole(self, state: State) -> Group | Closed:
        """An OR, closed if it has no formula."""
        if state.label in self._closed:
            return Closed(state.label)
        try:
            return self.group(state)
        except NotCompact as reason:
            states = set(inside(self._chart, state.label)) - {state.label}
            ends = ((item.source, item.target, *item.into) for item in self._chart.transitions)
            if any(len({label in states for label in labels}) > 1 for labels in ends):
                raise
            return Closed(state.label, str(reason))


def inside(chart: Statechart, label: str) -> tuple[str, ...]:
    """The states in a state, itself first, in document order."""
    found = [label]
    for item in chart.children(label):
        found += inside(chart, item.label)
    return tuple(found)


__all__ = [
    "Activity",
    "Block",
    "Branch",
    "Closed",
    "Cut",
    "Group",
    "Link",
    "NotCompact",
    "Parallel",
    "Part",
    "blocks",
]
