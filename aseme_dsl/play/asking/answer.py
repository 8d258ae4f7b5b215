"""Answer: why an agent is not where is asked for, and why it is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import assert_never

from aseme_dsl.play.asking.changes import Change, Holding, Lacking, Made, Moment, Tried, Waiting
from aseme_dsl.play.asking.parts import Denied, Joined, Part, Tree, parts_in
from aseme_dsl.play.asking.said import Said
from aseme_dsl.play.asking.search import STAGES, Found, Needed, Search, followed
from aseme_dsl.play.asking.telling import Teller
from aseme_dsl.play.asking.ways import Goal, Stage, leads, narrowed
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import Completed
from aseme_dsl.runtime.chart.plan import is_in
from aseme_dsl.runtime.time.clock import shown

OTHERS = 6
"""So many other ways are listed."""
_NEVER = Said("it has never been there in this trace")


@dataclass(frozen=True, slots=True)
class Answer:
    """What is said of an agent at a time (ns), and `where` it was, as a phrase.

    `is_so`: what is asked for is so. `stages` are what has to be otherwise: they were tried, and `goal` is
    reached.
    """

    said: tuple[Said, ...]
    is_so: bool
    goal: Goal
    now: int
    where: str
    stages: tuple[Needed, ...] = ()


@dataclass(frozen=True, slots=True)
class Asking:
    """An agent at a moment, with the steps in which it took transitions before it, the last one last.

    All these steps are of the model that it ran at that moment.
    """

    teller: Teller
    search: Search
    moment: Moment
    steps: Sequence[Made]

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
            return self._answer(goal, Said(f"it has stopped: {over}"))
        if self._is_there(goal):
            if goal.by_code:
                return self._answer(goal, Said("the activity that sends it is active: its code decides"))
            return self._answer(goal, is_so=True)
        if chart.finished:
            return self._answer(goal, Said("it has finished: its END is active"))
        last = tuple(item for item in (self._by_module(goal),) if item is not None)
        modules = [
            Said(f"{name} publishes it in any state: its code decides when", last) for name in goal.modules
        ]
        if goal.is_for_modules:
            return self._answer(goal, *modules)
        at_once = self._at_once(goal)
        if at_once is not None:
            return at_once
        left = self._left(goal)
        found = self.search.find(self.moment, goal)
        said = [self._stage(item, number, len(found.stages)) for number, item in enumerate(found.stages)]
        said += self._prevented(found)
        first = found.stages[0].stage.ways[0] if found.stages else ()
        said += self._others(goal, first)
        if left is not None:
            moment, stage, other = left
            said.append(Said(self._instead(moment, stage.ways[0], other)))
        return self._answer(goal, *said, *modules, stages=found.stages)

    def _answer(
        self, goal: Goal, *said: Said, is_so: bool = False, stages: tuple[Needed, ...] = ()
    ) -> Answer:
        return Answer(said, is_so, goal, self.moment.now, self.where(goal), stages)

    def _is_there(self, goal: Goal) -> bool:
        """Whether the agent is where the goal says, or its last step of this very moment has led there."""
        if not goal.states.isdisjoint(self.search.active(self.moment)):
            return True
        last = self.steps[-1] if self.steps else None
        is_now = last is not None and last.moment.now == self.moment.now
        return last is not None and is_now and self._reaching(goal, last) is not None

    def _stage(self, item: Needed, number: int, count: int) -> Said:
        ways = item.stage.ways
        title = self.teller.passage(ways)
        place = f"{number + 1}. " if count > 1 else ""
        return Said(f"{place}{title}", tuple(self._needs(item)))

    def _needs(self, item: Needed) -> Iterator[Said]:
        return (self.teller.change(change, item.moment, item.changes) for change in item.changes)

    def _prevented(self, found: Found) -> Iterator[Said]:
        """Why ways were not taken, and why there is none."""
        for item in found.prevented:
            if item.by:
                yield Said(f"{self.teller.way(item.way)} is not possible: it goes {self.teller.way(item.by)}")
        if found.stages:
            return
        if found.is_far:
            yield Said(f"no way of at most {STAGES} steps was found, and longer ones are not tried")
        elif found.prevented:
            count = len(found.prevented)
            yield Said(f"no way was found, though {count} {'was' if count == 1 else 'were'} tried")
        else:
            yield Said("no way leads there from where it is")

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
                    return self._answer(goal, Said(title, tuple(self._needs(stages[0]))), stages=stages)
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
        published = [item for item in (self._by_module(goal),) if item is not None]
        if goal.is_for_modules:
            return self._answer(goal, *(published or (_NEVER,)), is_so=bool(published))
        for place in reversed(range(len(self.steps))):
            made = self.steps[place]
            way = self._reaching(goal, made)
            if way is not None:
                again = "" if self._leads(goal, way) else self._resumed(goal, place)
                title = f"at {shown(made.moment.now)} it went {self.teller.way(way)}{again}"
                decided = tuple(self._decided(goal, made, way))
                return self._answer(goal, Said(title, decided), *published, is_so=True)
        if self.teller.plan.states[0].label in goal.states:
            return self._answer(goal, Said("it is active from the begin of the role"), is_so=True)
        return self._answer(goal, *(published or (_NEVER,)), is_so=bool(published))

    def _by_module(self, goal: Goal) -> Said | None:
        """When a module has last published what is asked for."""
        past, agent = self.teller.past, self.teller.agent
        for name in goal.modules:
            record = past.last_published(goal.channel, (agent,)).get(agent)
            if record is not None and name == f"the module {record.get('activity')}":
                return Said(f"at {shown(record['time'])} {name} published it last, as its code decided")
        return None

    def _resumed(self, goal: Goal, place: int) -> str:
        """That a step resumed what is asked for, and when that was left before."""
        for made in reversed(self.steps[:place]):
            if not goal.states.isdisjoint(self.search.active(made.moment)):
                return f", which resumed it where it was left at {shown(made.moment.now)}"
        return ", which resumed it where it was left before"

    def _leads(self, goal: Goal, way: tuple[int, ...]) -> bool:
        return leads(self.teller.trial.shape, goal, way)

    def _reaching(self, goal: Goal, made: Made) -> tuple[int, ...] | None:
        """The transition of a step that has led to the goal, with the branches of choices behind it."""
        found = next((way for way in made.taken if self._leads(goal, way)), None)
        if found is not None:
            return found
        resuming = [way for way in made.taken if self.teller.plan.transitions[way[-1]].resume]
        return resuming[0] if resuming and self.search.reached(goal, made.moment) else None

    def _decided(self, goal: Goal, made: Made, way: tuple[int, ...]) -> Iterator[Said]:
        """What made it so: each of these was needed, or all are listed, if one would do."""
        moment, transitions = made.moment, self.teller.plan.transitions
        tried = self.teller.trial.run(moment)
        known: dict[Change, int] = {}
        for place, taken in enumerate(made.taken[: made.taken.index(way) + 1]):
            for change in self._deciding(moment, taken, tried, place):
                known.setdefault(change, place)
        mine = narrowed(self.teller.trial.shape, goal, way)
        needed = [item for item in known if not self.search.reached(mine, moment, (item,))]
        for change in needed or known:
            yield self.teller.cause(change, moment, known[change])
        weights = (transitions[number].weight for number in way)
        yield from (
            Said(f"it was drawn, with the weight {weight}") for weight in weights if weight is not None
        )
        if goal.by_code:
            yield Said("whether its activity sends is decided by its code")

    def _deciding(self, moment: Moment, taken: tuple[int, ...], tried: Tried, place: int) -> Iterator[Change]:
        """What let a step take a transition behind so many others, each as that it was not so."""
        transitions = self.teller.plan.transitions
        source = transitions[taken[0]].source
        ended = (item for item in moment.inputs if isinstance(item, Completed))
        yield from (Lacking(item) for item in ended if is_in(item.label, source))
        for number in taken:
            yield from self.search.events(moment, number)
            if transitions[number].every is not None:
                yield Waiting(source, 0)
            tree = self.search.condition(number)
            if tree is not None:
                yield from (Holding(part, part.negated) for part in _holding(tree, tried, place))
            if transitions[number].otherwise:
                facts = {item.part.fact: item for item in self._failed(number, tried, place)}
                yield from facts.values()

    def _failed(self, number: int, tried: Tried, place: int) -> Iterator[Holding]:
        """The parts that did not hold of the conditions that are tried before an `else`."""
        for other, _ in self.teller.plan.outgoing(self.teller.plan.transitions[number].source):
            tree = self.search.condition(other)
            for part in parts_in(tree):
                if tried.holds(part, place) is False:
                    yield Holding(part, not part.negated)


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
