"""Answer: why an agent is not where is asked for, and why it is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import assert_never

from aseme_dsl.play.asking.changes import Change, Holding, Lacking, Made, Moment, Tried, Waiting
from aseme_dsl.play.asking.parts import Denied, Joined, Part, Tree
from aseme_dsl.play.asking.search import Needed, Prevented, Search, followed
from aseme_dsl.play.asking.telling import Said, Teller
from aseme_dsl.play.asking.ways import Goal, Stage
from aseme_dsl.runtime.chart.inputs import Completed
from aseme_dsl.runtime.chart.plan import is_in
from aseme_dsl.runtime.time.clock import shown

OTHERS = 6
"""So many other ways are listed."""


@dataclass(frozen=True, slots=True)
class Answer:
    """What is said. `stages` are what has to be otherwise: they were tried, and `goal` is reached."""

    said: tuple[Said, ...]
    is_so: bool
    """Whether what is asked for is so."""
    goal: Goal
    stages: tuple[Needed, ...] = ()


@dataclass(frozen=True, slots=True)
class Asking:
    """An agent at a moment, with the steps in which it took transitions before it, the last one last."""

    teller: Teller
    search: Search
    moment: Moment
    steps: Sequence[Made]
    first_line: int = 0
    """The number of the first line behind the header that was read."""

    def where(self, goal: Goal) -> str:
        """Where the agent is, as a phrase."""
        transitions = self.teller.plan.transitions
        return self.teller.where((*goal.states, *(transitions[number].target for number in goal.transitions)))

    # ---- why not ---------------------------------------------------------------------------------

    def whynot(self, goal: Goal) -> Answer:
        """Why the agent is not where the goal says, and what would have to be otherwise."""
        chart = self.teller.trial.look(self.moment)
        over = chart.failure or self.teller.past.members[self.teller.agent].over
        if over:
            return Answer((Said(f"it has stopped: {over}"),), False, goal)
        active = self.search.active(self.moment)
        last = self.steps[-1] if self.steps else None
        if not goal.states.isdisjoint(active) or (
            last is not None and last.moment.now == self.moment.now and self._reaching(goal, last) is not None
        ):
            code = Said("the activity that sends it is active: its code decides")
            return Answer((code,) if goal.by_code else (), not goal.by_code, goal)
        if chart.finished:
            return Answer((Said("it has finished: its END is active"),), False, goal)
        at_once = self._at_once(goal)
        if at_once is not None:
            return at_once
        left = self._left(goal)
        answer = self.search.find(self.moment, goal)
        said = [self._stage(item, number, len(answer.stages)) for number, item in enumerate(answer.stages)]
        said += self._prevented(answer.prevented)
        if answer.prevented and not answer.stages:
            said.append(Said(f"no way was found, though {len(answer.prevented)} were tried"))
        elif not answer.stages:
            said.append(Said("no way leads there from where it is"))
        first = answer.stages[0].stage.ways[0] if answer.stages else ()
        said += self._others(goal, first)
        if left is not None:
            moment, stage, other = left
            said.append(Said(self._instead(moment, stage.ways[0], other)))
        return Answer(tuple(said), False, goal, answer.stages)

    def _stage(self, item: Needed, number: int, count: int) -> Said:
        ways = item.stage.ways
        title = self.teller.passage(ways)
        place = f"{number + 1}. " if count > 1 else ""
        return Said(f"{place}{title}", tuple(self._needs(item)))

    def _needs(self, item: Needed) -> Iterator[Said]:
        return (self.teller.change(change, item.moment) for change in item.changes)

    def _prevented(self, items: Sequence[Prevented]) -> Iterator[Said]:
        for item in items:
            if item.by:
                yield Said(f"{self.teller.way(item.way)} is not possible: it goes {self.teller.way(item.by)}")

    def _others(self, goal: Goal, first: tuple[int, ...]) -> Iterator[Said]:
        """The other ways that lead there at once."""
        ways = [item for item in self.search.ways_into(self.moment, goal) if item.ways[0] != first]
        for stage in ways[:OTHERS]:
            found = self.search.stage(self.moment, stage)
            title = f"or {self.teller.passage(stage.ways)}"
            if isinstance(found, Needed):
                yield Said(title, tuple(self._needs(found)))
            elif found.by:
                yield Said(title, (Said(f"it goes {self.teller.way(found.by)}"),))
            else:
                source = self.teller.plan.transitions[found.way[0]].source
                yield Said(title, (Said(f"{self.teller.state(source)} is not complete"),))
        if len(ways) > OTHERS:
            yield Said(f"and {len(ways) - OTHERS} more ways")

    def _at_once(self, goal: Goal) -> Answer | None:
        """The answer where a step of this very moment could have led there, and took something else."""
        for made in reversed(self.steps):
            if made.moment.now != self.moment.now:
                return None
            stages = self.search.find(made.moment, goal).stages
            if len(stages) == 1:
                ways = stages[0].stage.ways
                place, missed = followed(ways, made.taken)
                other = None if missed is None else self._other(ways[missed], made.taken[place:])
                if missed is not None and other is not None:
                    title = self._instead(made.moment, ways[missed], other)
                    return Answer((Said(title, tuple(self._needs(stages[0]))),), False, goal, stages)
        return None

    # ---- what was done instead -------------------------------------------------------------------

    def _left(self, goal: Goal) -> tuple[Moment, Stage, tuple[int, ...]] | None:
        """The last step that left a state from which a way leads there, and what it took instead."""
        for made in reversed(self.steps):
            for stage in self.search.ways_into(made.moment, goal):
                way = self._other(stage.ways[0], made.taken)
                if way is not None and not self._leads(goal, way):
                    return made.moment, stage, way
        return None

    def _other(self, way: tuple[int, ...], taken: Sequence[tuple[int, ...]]) -> tuple[int, ...] | None:
        """The first of some transitions that leaves the source of a way."""
        source = self.teller.plan.transitions[way[0]].source
        for other in taken:
            scope, target, _ = self.teller.trial.shape.way(other)
            if target and source.startswith(f"{scope}."):
                return other
        return None

    def _instead(self, moment: Moment, way: tuple[int, ...], other: tuple[int, ...]) -> str:
        first = ", which is tried first" if self._is_first(way, other) else ""
        return f"at {shown(moment.now)} it went {self.teller.way(other)} instead{first}"

    def _is_first(self, way: tuple[int, ...], other: tuple[int, ...]) -> bool:
        """Whether the second of two transitions is tried before the first."""
        transitions = self.teller.plan.transitions
        at = next((place for place, (one, two) in enumerate(zip(way, other, strict=False)) if one != two), 0)
        mine, theirs = transitions[way[at]], transitions[other[at]]
        if mine.source == theirs.source:
            return theirs.priority < mine.priority
        if mine.first or theirs.first:
            return theirs.first
        return is_in(theirs.source, mine.source)

    # ---- why ---------------------------------------------------------------------------------------

    def why(self, goal: Goal) -> Answer:
        """What has led there: the last step that did, and what decided it."""
        for made in reversed(self.steps):
            way = self._reaching(goal, made)
            if way is not None:
                title = f"at {shown(made.moment.now)} it went {self.teller.way(way)}"
                return Answer((Said(title, tuple(self._decided(goal, made, way))),), True, goal)
        return Answer((Said("it has never been there in this trace"),), False, goal)

    def may_reach(self, goal: Goal, taken: Sequence[tuple[int, ...]]) -> bool:
        """Whether transitions that a step takes may lead to a goal."""
        transitions = self.teller.plan.transitions
        return any(self._leads(goal, way) or transitions[way[-1]].resume for way in taken)

    def _leads(self, goal: Goal, way: tuple[int, ...]) -> bool:
        shape = self.teller.trial.shape
        path = shape.way(way)[2]
        enters = bool(path) and not goal.states.isdisjoint(shape.entered(path))
        return enters or not goal.transitions.isdisjoint(way)

    def _reaching(self, goal: Goal, made: Made) -> tuple[int, ...] | None:
        """The transition of a step that has led to the goal, with the branches of choices behind it."""
        found = next((way for way in made.taken if self._leads(goal, way)), None)
        if found is not None or not self.may_reach(goal, made.taken):
            return found
        return made.taken[0] if self.search.reached(goal, made.moment) else None

    def _decided(self, goal: Goal, made: Made, way: tuple[int, ...]) -> Iterator[Said]:
        """What made it so: each of these was needed, or all are listed, if one would do."""
        moment, transitions = made.moment, self.teller.plan.transitions
        tried = self.teller.trial.run(moment)
        known: list[Change] = []
        for place, taken in enumerate(made.taken[: made.taken.index(way) + 1]):
            source = transitions[taken[0]].source
            known += (
                Lacking(item)
                for item in moment.inputs
                if isinstance(item, Completed) and is_in(item.label, source) and Lacking(item) not in known
            )
            for number in taken:
                known += (item for item in self.search.events(moment, number) if item not in known)
                if transitions[number].every is not None:
                    known.append(Waiting(source, 0))
                tree = self.search.condition(number)
                parts = _holding(tree, tried, place) if tree is not None else ()
                known += (Holding(part, part.negated) for part in parts)
                if transitions[number].otherwise:
                    facts = {item.part.fact: item for item in self._failed(number, tried, place)}
                    known += facts.values()
        needed = [item for item in known if not self.search.reached(goal, moment, (item,))]
        for change in needed or known:
            yield self.teller.cause(change, moment)
        weights = (transitions[number].weight for number in way)
        yield from (
            Said(f"it was drawn, with the weight {weight}") for weight in weights if weight is not None
        )
        if goal.by_code:
            yield Said("whether its activity sends is decided by its code")

    def _failed(self, number: int, tried: Tried, place: int) -> Iterator[Holding]:
        """The parts that did not hold of the conditions that are tried before an `else`."""
        for other, _ in self.teller.plan.outgoing(self.teller.plan.transitions[number].source):
            tree = self.search.condition(other)
            for part in () if tree is None else _parts_of(tree):
                if tried.holds(part, place) is False:
                    yield Holding(part, not part.negated)


def _parts_of(tree: Tree) -> Iterator[Part]:
    match tree:
        case Part():
            yield tree
        case Joined(parts=parts):
            for item in parts:
                yield from _parts_of(item)
        case Denied(part=part):
            yield from _parts_of(part)
        case _:
            assert_never(tree)


def _holding(tree: Tree, tried: Tried, place: int) -> Iterator[Part]:
    """The parts for which a condition holds, or (those that are not negated) did not matter."""
    match tree:
        case Part():
            if tried.holds(tree, place):
                yield tree
        case Joined(parts=parts):
            for item in parts:
                yield from _holding(item, tried, place)
        case Denied():
            pass
        case _:
            assert_never(tree)


__all__ = ["Answer", "Asking"]
