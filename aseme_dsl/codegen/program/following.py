"""Whether something may be enabled after a transition that could not be taken before it.

Where nothing may be, a second round is not looked for; where one activity that has returned moves only its
own region, nothing else is looked at.
"""

from __future__ import annotations

from collections import Counter
from functools import cached_property

from aseme_dsl.amola.expression import NEVER, After, Failed, Raised
from aseme_dsl.amola.statechart import State, StateType, TransitionKind
from aseme_dsl.codegen.program.events import OTHER, STEP, Events
from aseme_dsl.codegen.program.flat import FlatChart, Way, completes
from aseme_dsl.codegen.program.moves import move_of
from aseme_dsl.codegen.program.resting import Resting


class Following:
    """What follows what is taken, mode by mode."""

    def __init__(self, flat: FlatChart, rests: Resting, events: Events) -> None:
        self._flat = flat
        self._chart = flat.chart
        self._rests = rests
        self._events = events

    def may_loop(self, mode: str) -> bool:
        """Whether some transition of a mode may need another round after it."""
        if not mode:
            return any(self.loops_at(mode, leaf) for leaves in self._leaves for leaf in leaves)
        touched = [
            self._flat.leaves(region)[place]
            for region, places in self._events.touched.get(mode, {}).items()
            for place in places
        ]
        others = self._looping.difference(leaf.label for leaf in touched)
        return bool(others) or any(self.loops_at(mode, leaf) for leaf in touched)

    @cached_property
    def _looping(self) -> frozenset[str]:
        """The leaves at which a step with an event that they do not wait for may need another round."""
        return frozenset(
            leaf.label for leaves in self._leaves for leaf in leaves if self.loops_at(OTHER, leaf)
        )

    @property
    def _leaves(self) -> list[list[State]]:
        return [self._flat.leaves(region.number) for region in self._flat.regions]

    def loops_at(self, mode: str, leaf: State) -> bool:
        """Whether a transition that is taken while a leaf is active may need another round after it."""
        region = self._flat.region_number[leaf.label]
        for taken, spent in self._events.open_paths(mode, leaf):
            if self._flat.transition(taken[0]).kind is TransitionKind.ON:
                if self.again_at(mode, leaf, spent):
                    return True
            elif self.again(mode, region, taken, spent):
                return True
        return False

    def again(self, mode: str, region: int, taken: tuple[int, ...], spent: bool) -> bool:
        """Whether something may be enabled after a transition that could not be taken before."""
        if self._rests.asked:
            return True
        target = self._flat.transition(taken[-1]).target
        leaf = self._events.rest(target)
        entered = move_of(self._flat, taken).scope
        if self.open_at(mode, leaf, spent, entered):
            return True
        return self._open_around(mode, self._chart.node(leaf), spent)

    def again_at(self, mode: str, leaf: State, spent: bool) -> bool:
        """Whether something may be enabled at an active leaf after an action that has left nothing."""
        if self._rests.asked:
            return True
        for source in (leaf, *self._flat.around(leaf.label)):
            done = source is leaf or completes(leaf, source)
            for way in (*self._flat.first_ways(source.label), *self._flat.ways(source.label)):
                if self._is_open(mode, way, done, spent=spent, entered=False):
                    return True
        return self._open_around(mode, leaf, spent)

    def _open_around(self, mode: str, ends: State, spent: bool) -> bool:
        """Whether something may be enabled around the region of a leaf in which something was taken."""
        around_region = self._chart.region_of(ends.label)
        complete = ends.type is StateType.END and ends.parent == around_region
        for around in self._chart.ancestors(around_region):
            for way in self._flat.ways(around.label):
                if self._is_open(mode, way, complete, spent=spent, entered=False):
                    return True
            complete = False
        return False

    def open_at(self, mode: str, label: str, spent: bool, scope: str) -> bool:
        """Whether something may be enabled at a leaf that was entered, or around it in its region."""
        stack = [(label, spent, scope)]
        while stack:
            label, spent, scope = stack.pop()
            if self._open_in(mode, label, spent, scope):
                return True
            if self._chart.node(label).type is StateType.AND:
                for region in self._flat.regions_of(label):
                    stack.append((self._events.rest(region.label), True, region.label))
        return False

    def _open_in(self, mode: str, label: str, spent: bool, scope: str) -> bool:
        """The same, without what is inside an AND."""
        leaf = self._chart.node(label)
        complete = leaf.type is StateType.START
        if leaf.type is StateType.AND:
            rests = [self._events.rest(region.label) for region in self._flat.regions_of(label)]
            complete = all(self._chart.node(rest).type is StateType.END for rest in rests)
        for source in (leaf, *self._flat.around(label)):
            is_new = source.label != scope and source.label.startswith(f"{scope}.")
            ended = completes(leaf, source)
            done = complete if source is leaf else ended
            for way in (*self._flat.first_ways(source.label), *self._flat.ways(source.label)):
                if self._is_open(mode, way, done, spent=spent, entered=is_new):
                    return True
        return False

    def _is_open(self, mode: str, way: Way, complete: bool, *, spent: bool, entered: bool) -> bool:
        expression = self._flat.transition(way.number).expression
        if expression is NEVER:
            return False
        if expression.when:
            return True
        if not expression.events:
            return complete
        return any(
            (event.name == mode and not spent)
            if isinstance(event, Raised)
            else mode == STEP
            if isinstance(event, Failed)
            else not (entered and isinstance(event, After) and event.duration > 0)
            for event in expression.events
        )

    def alone(self) -> list[bool]:
        """The regions in which something may move by itself: by the regions' numbers, whether in a step
        without an event nothing else does, as long as no other activity returns."""
        failing = any(
            isinstance(e, Failed) for item in self._chart.transitions for e in item.expression.events
        )
        moves = [
            any(self._moves_by_itself(leaf, complete=True) for leaf in leaves) for leaves in self._leaves
        ]
        inside = list(moves)
        for region in reversed(self._flat.regions[1:]):  # innermost first
            around = self._flat.enclosing(region.number)
            assert around is not None
            inside[around] |= inside[region.number]
        alone = [not failing]
        moving = Counter(
            self._chart.node(region.label).parent for region in self._flat.regions if inside[region.number]
        )
        for region in self._flat.regions[1:]:
            parent = self._chart.node(region.label).parent
            assert parent is not None
            is_calm = not self._moves_by_itself(self._chart.node(parent), complete=False)
            others = moving[parent] - inside[region.number]
            alone.append(alone[self._flat.region_number[parent]] and is_calm and not others)
        return alone

    def _moves_by_itself(self, leaf: State, *, complete: bool) -> bool:
        """Whether something may be taken while a leaf is active that has no event and rests there until then.

        `complete`: it may be complete. What is left as soon as it is complete does not rest.
        """
        for source in (leaf, *self._flat.around(leaf.label)):
            ended = complete if source is leaf else completes(leaf, source)
            rests = ended and not self._events.is_left(source)
            for way in (*self._flat.first_ways(source.label), *self._flat.ways(source.label)):
                waits = self._flat.waits_for_event(way)
                if (rests or waits) and self._events.spends(OTHER, (way.number,)) is not None:
                    return True
        return False


__all__ = ["Following"]
