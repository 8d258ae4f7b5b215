"""The flattened chart: regions, the numbers of their leaves, their outgoing transitions.

Inside a region the hierarchy of OR states disappears: one integer says which leaf (START, BASIC, END or AND)
is active. The leaves of a composite have consecutive numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property

from aseme_dsl.amola.expression import NEVER
from aseme_dsl.amola.statechart import (
    State,
    Statechart,
    StateType,
    Transition,
    TransitionKind,
)
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Way:
    """A transition by its number; into a CONDITION with its outgoing transitions, in the order of trying."""

    number: int
    branches: tuple[Way, ...] = ()


@dataclass(frozen=True, slots=True)
class FlatRegion:
    """A region: its number, its label and how many numbers its leaves have."""

    number: int
    label: str
    size: int


class FlatChart:
    """A statechart with its regions, their leaves, and the outgoing transitions of its states.

    The generators ask it many small questions; the answers are methods here, so that each is computed once.
    """

    def __init__(self, chart: Statechart, width: Callable[[State], int] | None = None) -> None:
        """`width` says how many numbers a leaf needs, none if it is never active between two rounds."""
        self.chart = chart
        self._width = width or _width
        self.region_number: dict[str, int] = {}
        """The number of the innermost region around each state."""
        self.leaf: dict[str, int] = {}
        """The number of each leaf in its region; a BASIC that is complete has the next one, if it has two."""
        self.range: dict[str, tuple[int, int]] = {}
        """The first and last number of the leaves of each state inside its region."""
        self.regions: tuple[FlatRegion, ...] = self._number()
        self.transition_number = {id(t): n for n, t in enumerate(chart.transitions)}
        self._around: dict[str, list[State]] = {}
        self._ways: dict[str, tuple[Way, ...]] = {}
        self._first_ways: dict[str, tuple[Way, ...]] = {}

    def _number(self) -> tuple[FlatRegion, ...]:
        labels: list[str] = []
        sizes: list[int] = []
        for node in self.chart.states:  # parents come before children, so document order
            if self.chart.is_region(node.label):
                self.region_number[node.label] = len(labels)
                labels.append(node.label)
                sizes.append(0)
            else:
                assert node.parent is not None
                self.region_number[node.label] = self.region_number[node.parent]
            if node.type in (StateType.OR, StateType.CONDITION):
                continue
            region = self.region_number[node.label]
            width = self._width(node)
            if not width:
                continue
            first, last = sizes[region], sizes[region] + width - 1
            self.leaf[node.label] = first
            sizes[region] += width
            for around in self._inside_region(node.label):
                known = self.range.get(around)
                self.range[around] = (known[0] if known else first, last)
        return tuple(FlatRegion(n, label, sizes[n]) for n, label in enumerate(labels))

    def _inside_region(self, label: str) -> Iterator[str]:
        """The label and the states around it up to its region, the region included."""
        while True:
            yield label
            if self.chart.is_region(label):
                return
            parent = self.chart.node(label).parent
            assert parent is not None
            label = parent

    def around(self, label: str) -> list[State]:
        """The OR states around a leaf inside its region, innermost first, the region itself excluded."""
        found = self._around.get(label)
        if found is None:
            found = [self.chart.node(item) for item in list(self._inside_region(label))[1:-1]]
            self._around[label] = found
        return found

    def sources_around(self, leaf: str) -> list[State]:
        """The states around a leaf inside its region that may have transitions, innermost first.

        The region itself is one of them where some lead out of its AND.
        """
        found = self.around(leaf)
        region = self.regions[self.region_number[leaf]]
        return [*found, self.chart.node(region.label)] if self.chart.outgoing(region.label) else found

    def place(self, taken: Sequence[int]) -> int:
        """The region in which a compound transition acts: that of its scope."""
        scopes = [self.chart.scope_of(self.transition(number)) for number in taken]
        return self.region_number[min(scopes, key=len)]

    @cached_property
    def leading_out(self) -> Mapping[int, int]:
        """The transitions that lead out of their region, by number, each with the region of its scope."""
        if len(self.regions) == 1:
            return {}
        found: dict[int, int] = {}
        for number, transition in enumerate(self.chart.transitions):
            if (
                transition.changes_state
                and (place := self.place((number,))) != self.region_number[transition.source]
            ):
                found[number] = place
        return found

    def is_left_from_inside(self, label: str) -> bool:
        """Whether a transition leads from inside an AND out of it."""
        return any(
            self.transition(number).source.startswith(f"{label}.")
            and place in (self.region_number[label], *self.regions_around(self.region_number[label]))
            for number, place in self.leading_out.items()
        )

    def places(self, number: int) -> frozenset[int]:
        """The regions in which the actions of a transition may count."""
        transition = self.transition(number)
        found = {self.leading_out.get(number, self.region_number[transition.source])}
        if self.leading_out and self.chart.node(transition.target).type is StateType.CONDITION:
            for branch in self.segments(transition.target):
                found.add(self.leading_out.get(self.transition_number[id(branch)], min(found)))
        return frozenset(found)

    def leaves(self, region: int) -> list[State]:
        """The leaves of a region in document order."""
        return self._leaves[region]

    @cached_property
    def _leaves(self) -> list[list[State]]:
        found: list[list[State]] = [[] for _ in self.regions]
        for node in self.chart.states:
            if node.label in self.leaf:
                found[self.region_number[node.label]].append(node)
        return found

    def regions_of(self, label: str) -> list[FlatRegion]:
        """The regions of an AND."""
        return [self.regions[self.region_number[node.label]] for node in self.chart.children(label)]

    def enclosing(self, region: int) -> int | None:
        """The region around a region."""
        parent = self.chart.node(self.regions[region].label).parent
        return None if parent is None else self.region_number[parent]

    @cached_property
    def branches(self) -> tuple[State, ...]:
        """The states that are the branch of a participant."""
        return tuple(node for node in self.chart.states if self.chart.is_branch(node))

    def regions_inside(self, label: str) -> list[FlatRegion]:
        """The regions inside a state, at any depth."""
        return [region for region in self.regions if region.label.startswith(f"{label}.")]

    @cached_property
    def staying(self) -> Mapping[str, tuple[int, ...]]:
        """The numbers of the `on` transitions of each state that has some."""
        found: dict[str, tuple[int, ...]] = {}
        for number, transition in enumerate(self.chart.transitions):
            if transition.kind is TransitionKind.ON:
                found[transition.source] = (*found.get(transition.source, ()), number)
        return found

    def transition(self, number: int) -> Transition:
        """The transition of that number in the template's order."""
        return self.chart.transitions[number]

    def ways(self, label: str) -> tuple[Way, ...]:
        """The outgoing transitions of a source in the order of trying, without those that are `first`."""
        found = self._ways.get(label)
        if found is None:
            found = tuple(self._way(item) for item in self.chart.outgoing(label) if not item.first)
            self._ways[label] = found
        return found

    def first_ways(self, label: str) -> tuple[Way, ...]:
        """The ways that are tried before anything inside the source."""
        found = self._first_ways.get(label)
        if found is None:
            found = tuple(
                self._way(item)
                for item in self.chart.outgoing(label)
                if item.first and item.expression is not NEVER
            )
            self._first_ways[label] = found
        return found

    def _way(self, transition: Transition) -> Way:
        target = self.chart.node(transition.target)
        branches = self.ways(target.label) if target.type is StateType.CONDITION else ()
        return Way(self.transition_number[id(transition)], branches)

    def waits_for_event(self, way: Way) -> bool:
        """Whether a way may be taken while its source is not complete."""
        expression = self.transition(way.number).expression
        return bool(expression.events) or expression.when

    def segments(self, label: str) -> Iterator[Transition]:
        """The transitions out of a source and out of the CONDITIONs they lead to."""
        stack = list(reversed((*self.first_ways(label), *self.ways(label))))
        while stack:
            way = stack.pop()
            yield self.transition(way.number)
            stack.extend(reversed(way.branches))

    @cached_property
    def sources(self) -> tuple[str, ...]:
        """The states that may be active and have transitions, in document order."""
        return tuple(
            node.label
            for node in self.chart.states
            if node.type is not StateType.CONDITION and self.chart.outgoing(node.label)
        )

    def regions_around(self, region: int) -> Iterator[int]:
        """The regions around a region, innermost first."""
        around = self.enclosing(region)
        while around is not None:
            yield around
            around = self.enclosing(around)

    def with_around(self, region: int) -> Iterator[int]:
        """A region and those around it, innermost first."""
        yield region
        yield from self.regions_around(region)


def completes(leaf: State, source: State) -> bool:
    """Whether a state is complete because this leaf in it is active: its END is."""
    return leaf.type is StateType.END and leaf.parent == source.label


def _width(leaf: State) -> int:
    return 2 if leaf.type is StateType.BASIC else 1


def paths(way: Way) -> Iterator[tuple[int, ...]]:
    """The compound transitions of a way, as the numbers of their segments."""
    if not way.branches:
        yield (way.number,)
    for branch in way.branches:
        for path in paths(branch):
            yield (way.number, *path)


__all__ = ["FlatChart", "FlatRegion", "Way", "completes", "paths"]
