"""What a step with an event, or without one, may take while a leaf is active.

An event is a mode of its own; so are a step without one, and one with an event that nothing waits for.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property

from aseme_dsl.amola.expression import NEVER, After, Failed, Raised
from aseme_dsl.amola.statechart import State, StateType
from aseme_dsl.codegen.program.flat import FlatChart, Way, completes, paths
from aseme_dsl.codegen.program.resting import Resting, is_open
from aseme_dsl.codegen.program.uses import Uses

STEP = ""
"""The mode of a step without an event."""

OTHER = "*"
"""The mode of a step with an event that no transition waits for."""


class Events:
    """Of a flattened chart in which only some leaves are rested at: what the events open."""

    def __init__(self, flat: FlatChart, uses: Uses, rests: Resting) -> None:
        self._flat = flat
        self._chart = flat.chart
        self._uses = uses
        self._rests = rests

    @cached_property
    def modes(self) -> tuple[str, ...]:
        """The events, those first that most transitions wait for: they are asked about first."""
        names = Counter(
            event.name
            for transition in self._chart.transitions
            for event in transition.expression.events
            if isinstance(event, Raised)
        )
        return (*(name for name, _ in names.most_common()), STEP)

    @cached_property
    def touched(self) -> dict[str, dict[int, tuple[int, ...]]]:
        """The leaves for which it makes a difference which event it is: their places in their regions."""
        own: dict[str, frozenset[str]] = {}
        """The events that the transitions of a state wait for, and those of the states around it."""
        for node in self._chart.states:  # parents come before children
            around = own[node.parent] if node.parent is not None else frozenset()
            events = {
                event.name
                for segment in self._flat.segments(node.label)
                for event in segment.expression.events
                if isinstance(event, Raised)
            }
            own[node.label] = around | events
        found: dict[str, dict[int, list[int]]] = {}
        for region in self._flat.regions:
            for place, leaf in enumerate(self._flat.leaves(region.number)):
                events = set(own[leaf.label])
                for way in self.open_ways(OTHER, leaf):
                    for taken in paths(way):
                        target = self._flat.transition(taken[-1]).target
                        events.update(*(own[label] for label in self.rests_in(target)))
                        events.update(*(self._uses.awaited.get(n, ()) for n in self.regions_in(target)))
                for event in events:
                    found.setdefault(event, {}).setdefault(region.number, []).append(place)
        return {
            event: {region: tuple(sorted(places)) for region, places in self._with_ands(item).items()}
            for event, item in found.items()
        }

    def _with_ands(self, places: Mapping[int, Iterable[int]]) -> dict[int, set[int]]:
        """Places of leaves by their regions, with those of the ANDs around these regions."""
        found = {region: set(items) for region, items in places.items()}
        for inner in places:
            for region in self._flat.with_around(inner):
                around = self._chart.node(self._flat.regions[region].label).parent
                if around is not None:
                    found.setdefault(self._flat.region_number[around], set()).add(self._order[around])
        return found

    @cached_property
    def _order(self) -> dict[str, int]:
        """The place of each leaf among the leaves of its region."""
        regions = (self._flat.leaves(region.number) for region in self._flat.regions)
        return {leaf.label: place for leaves in regions for place, leaf in enumerate(leaves)}

    def rests_in(self, target: str) -> Iterator[str]:
        """The leaves at which regions rest when `target` has been entered."""
        stack = [target]
        while stack:
            label = self.rest(stack.pop())
            yield label
            if self._chart.node(label).type is StateType.AND:
                stack += [region.label for region in self._flat.regions_of(label)]

    def regions_in(self, target: str) -> Iterator[int]:
        """The regions that are entered with `target`."""
        for label in self.rests_in(target):
            if self._chart.node(label).type is StateType.AND:
                yield from (region.number for region in self._flat.regions_of(label))

    def open_paths(self, mode: str, leaf: State) -> Iterator[tuple[tuple[int, ...], bool]]:
        """The compound transitions that may be taken while a leaf is active, each with whether it certainly
        spends the event."""
        for way in self.open_ways(mode, leaf):
            for taken in paths(way):
                spends = self.spends(mode, taken)
                if spends is not None:
                    yield taken, spends == "yes"

    def open_ways(self, mode: str, leaf: State) -> Iterator[Way]:
        """The ways that may be taken while a leaf is active, if what they wait for is there."""
        for source in (leaf, *self._flat.around(leaf.label)):
            if source is leaf:
                complete = leaf.type is not StateType.BASIC or not (mode and self.is_left(leaf))
            else:
                complete = completes(leaf, source)
            for way in (*self._flat.first_ways(source.label), *self._flat.ways(source.label)):
                if complete or self._flat.waits_for_event(way):
                    yield way

    def spends(self, mode: str, taken: tuple[int, ...]) -> str | None:
        """What the transitions of a way spend in a mode; None if it is shut.

        "" is nothing, "yes" the event; "perhaps" depends on what else is there.
        """
        spends = ""
        for number in taken:
            expression = self._flat.transition(number).expression
            if expression is NEVER:
                return None
            if not expression.events:
                continue
            raised = any(isinstance(e, Raised) and e.name == mode for e in expression.events)
            timed = any(
                isinstance(e, After) or (isinstance(e, Failed) and mode == STEP) for e in expression.events
            )
            if not raised and not timed and not expression.when:
                return None
            if raised:
                spends = "perhaps" if timed else "yes"
        return spends

    def rest(self, target: str) -> str:
        """The leaf at which its region rests when `target` has been entered."""
        node = self._chart.node(target)
        while True:
            if node.type is StateType.OR:
                start = self._chart.start_of(node.label)
                assert start is not None
                node = start
            elif node.label in self._rests.passed:
                node = self._chart.node(self._rests.passed[node.label].target)
            else:
                return node.label

    def is_left(self, leaf: State) -> bool:
        """Whether a state is left as soon as it is complete: no step with an event finds it so."""
        ways = self._chart.outgoing_edges(leaf.label)
        return any(
            is_open(way.expression) and self._chart.node(way.target).type is not StateType.CONDITION
            for way in ways
        )


__all__ = ["OTHER", "STEP", "Events"]
