"""Search: the fewest things that have to be otherwise for an agent to get somewhere, tried out.

Each stage makes the steps of one instant, with something changed, from where the one before it has led. What
is found has happened in a trial, and does not happen when one of the changes is left out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from heapq import heappop, heappush
from typing import assert_never

from aseme_dsl.amola.expression import Member, Outcome, Value, walk
from aseme_dsl.play.asking.changes import (
    Change,
    Coming,
    Drawing,
    Ending,
    Failing,
    Holding,
    Lacking,
    Moment,
    Raising,
    Trial,
    Tried,
    Waiting,
)
from aseme_dsl.play.asking.parts import Denied, Fact, Joined, Part, Tree, parts_in
from aseme_dsl.play.asking.reading import board_in
from aseme_dsl.play.asking.ways import Goal, Map, Stage, known_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import LOST, AgentMessage, Completed, Crashed, Happened
from aseme_dsl.runtime.chart.plan import Transition, is_in
from aseme_dsl.runtime.trace.records import Record

STAGES = 100
"""A way has so many stages at the most."""
TRIALS = 200
"""So much is tried for one stage."""
ALTERNATIVES = 12
"""So many ways of making a condition hold, or not hold, are looked at."""
WAYS = 12
"""So many first transitions are tried that something else always prevents."""

Conditions = Mapping[int, Tree]
"""The conditions of a role's transitions, by their numbers."""


@dataclass(frozen=True, slots=True)
class Needed:
    """A stage, with the moment at which it begins, and what has to be otherwise then."""

    stage: Stage
    moment: Moment
    changes: tuple[Change, ...]


@dataclass(frozen=True, slots=True)
class Prevented:
    """A way that cannot be taken, with any change: `by` is taken instead; nothing is, if it is empty."""

    way: tuple[int, ...]
    by: tuple[int, ...] = ()
    before: int = 0
    """How many transitions of the same stage can be taken before it."""


@dataclass(frozen=True, slots=True)
class Found:
    """What has to be otherwise, stage by stage; empty stages: no way leads there, or (`prevented`) none that
    was tried."""

    stages: tuple[Needed, ...]
    prevented: tuple[Prevented, ...] = ()
    is_far: bool = False
    """Whether the way that was tried has too many stages."""


Pending = Callable[[Coming], Record | None]
"""Gives the line of the sending of an agent message that is still under way."""


class Search:
    """Looks for what has to be otherwise for one agent."""

    def __init__(self, trial: Trial, conditions: Conditions, pending: Pending) -> None:
        self._trial = trial
        self._pending = pending
        self._conditions = conditions
        self._plan = trial.plan
        self._waiting = [number for number, item in enumerate(self._plan.transitions) if item.events]
        self._map = Map(trial.shape, type(trial.chart))

    def find(self, moment: Moment, goal: Goal) -> Found:
        """The fewest changes found after which the goal is reached."""
        banned: set[int] = set()
        prevented: list[Prevented] = []
        for _ in range(WAYS):
            found = self._tried(moment, goal, banned)
            if found is None:
                return Found((), tuple(prevented), is_far=True)
            if isinstance(found, Prevented):
                prevented.append(found)
                banned.update(found.way[-1:])
                continue
            return Found(self._least(goal, found), tuple(prevented))
        return Found((), tuple(prevented))

    def active(self, moment: Moment) -> frozenset[str]:
        """The labels of the active states."""
        known = known_of(self._plan, self._trial.look(moment))
        return frozenset(str(label) for kind, label in known if kind == "in")

    def ways_into(self, moment: Moment, goal: Goal) -> tuple[Stage, ...]:
        """The ways of one stage that lead to the goal from a state that is active."""
        return tuple(self._map.into(goal, self.active(moment)))

    def events(self, moment: Moment, number: int) -> Iterator[Change]:
        """What takes its events from a transition, one change for each of them that is there."""
        item = self._plan.transitions[number]
        found = (self._lacking(moment, item, event) for event in item.events)
        return (change for change in found if change is not None)

    def condition(self, number: int) -> Tree | None:
        """The condition of a transition."""
        return self._conditions.get(number)

    def reached(self, goal: Goal, moment: Moment, changes: Sequence[Change] = ()) -> bool:
        """Whether the steps of this moment reach the goal, with something changed."""
        return _reaches(goal, self._trial.run(moment, changes))

    def stage(self, moment: Moment, stage: Stage) -> Needed | Prevented:
        """What has to be otherwise for one stage."""
        found = self._stage(moment, stage)
        return found if isinstance(found, Prevented) else Needed(stage, moment, found[0])

    def _tried(self, moment: Moment, goal: Goal, banned: set[int]) -> tuple[Needed, ...] | Prevented | None:
        """One way to the goal, or what prevents its first stage that does not work; None if it is too far."""
        done: list[Needed] = []
        now = moment
        been = {moment.saved}
        for _ in range(STAGES):
            found = self._next(now, goal, banned)
            if not isinstance(found, tuple):
                return found or ()
            stage, changes, tried = found
            done.append(Needed(stage, now, changes))
            if _reaches(goal, tried):
                return tuple(done)
            if tried.failure is not None or tried.after in been:
                return Prevented(stage.ways[-1])
            been.add(tried.after)
            now = Moment(tried.after, now.now)
        return None

    def _next(
        self, moment: Moment, goal: Goal, banned: set[int]
    ) -> tuple[Stage, tuple[Change, ...], Tried] | Prevented | None:
        """The next stage to a goal; None if no way leads there."""
        known = tuple(known_of(self._plan, self._trial.look(moment)))
        ready = frozenset(number for number in self._waiting if any(self.events(moment, number)))
        stages = self._map.stages(known, goal, banned, ready)
        if not stages:
            return None
        first, last = stages[0], goal if len(stages) == 1 else None
        found = self._stage(moment, first, last)
        if not isinstance(found, Prevented):
            return first, *found
        passed = (number for way in first.ways[: found.before] for number in way)
        for number in [item for item in passed if item in self._conditions]:
            # What its condition needs may be in the way of what follows.
            others = self._map.stages(known, goal, {*banned, number}, ready)
            last = goal if len(others) == 1 else None
            other = self._stage(moment, others[0], last) if others else found
            if not isinstance(other, Prevented):
                return others[0], *other
        if found.before:  # what follows needs something else than what comes before it
            first = replace(first, ways=first.ways[: found.before])
            found = self._stage(moment, first)
        return found if isinstance(found, Prevented) else (first, *found)

    # ---- one stage -------------------------------------------------------------------------------

    def _stage(
        self, moment: Moment, stage: Stage, goal: Goal | None = None
    ) -> tuple[tuple[Change, ...], Tried] | Prevented:
        """The fewest things that have to be otherwise for a stage, and for a goal that it is to reach.

        What changes least is tried first.
        """
        first = (*self._endings(moment, stage), *self._event(moment, stage.ways[0]))
        heap: list[tuple[int, int, tuple[Change, ...]]] = [(len(first), 0, first)]
        known = {frozenset(first)}
        prevented = Prevented(stage.ways[0])
        for trial in range(TRIALS):
            if not heap:
                break
            changes = heappop(heap)[2]
            tried = self._trial.run(moment, changes)
            place, missed = followed(stage.ways, tried.taken)
            if missed is None and (goal is None or _reaches(goal, tried)):
                return changes, tried
            way = stage.ways[-1 if missed is None else missed]
            if missed is None:  # what was resumed there is left at once
                target = self._plan.transitions[way[-1]].target
                additions, by = self._against(moment, way, target, tried, changes, place)
            else:
                additions, by = self._additions(moment, way, tried, changes, place)
            if missed is None or missed > prevented.before or by or not trial:
                prevented = Prevented(way, by, missed or 0)
            for more in additions:
                if frozenset(more) not in known:
                    known.add(frozenset(more))
                    heappush(heap, (len(more), len(known), more))
        return prevented

    def _additions(
        self, moment: Moment, way: tuple[int, ...], tried: Tried, changes: tuple[Change, ...], place: int
    ) -> tuple[list[tuple[Change, ...]], tuple[int, ...]]:
        """What may help a transition that was not taken, and what was taken instead, from some place on."""
        forced = _forced(changes)
        for number in way:
            tree = self._conditions.get(number)
            if tree is not None and _comes_to(tree, tried) is False:
                found = _alternatives(tree, True, tried, forced)
                return [(*changes, *self._holding(moment, item)) for item in found if item], ()
        return self._against(moment, way, self._plan.transitions[way[0]].source, tried, changes, place)

    def _against(
        self,
        moment: Moment,
        way: tuple[int, ...],
        source: str,
        tried: Tried,
        changes: tuple[Change, ...],
        place: int,
    ) -> tuple[list[tuple[Change, ...]], tuple[int, ...]]:
        """What keeps the first transition that leaves a state, from some place on, from being taken."""
        forced = _forced(changes)
        for at, other in enumerate(tried.taken[place:], place):
            first = self._plan.transitions[other[0]]
            if first.kind != "external" or not (is_in(first.source, source) or is_in(source, first.source)):
                continue
            drawn = self._drawn(way, other, changes)
            if drawn is not None:
                return [drawn], other
            more: list[tuple[Change, ...]] = []
            for number in other:
                tree = self._conditions.get(number)
                found = () if tree is None else _alternatives(tree, False, tried, forced, at)
                more += ((*changes, *self._holding(moment, item)) for item in found if item)
            gone = self._without(moment, other, changes)
            return [*more, *([] if gone is None else [(*changes, gone)])], other
        return [], ()

    def _drawn(
        self, way: tuple[int, ...], other: tuple[int, ...], changes: tuple[Change, ...]
    ) -> tuple[Change, ...] | None:
        """The changes, with a draw that passes one branch more; None if the draw does not decide."""
        for number, taken in zip(way, other, strict=False):
            if number == taken:
                continue
            mine, theirs = self._plan.transitions[number], self._plan.transitions[taken]
            if mine.weight is None or theirs.weight is None or mine.source != theirs.source:
                return None
            before = next((item for item in changes if isinstance(item, Drawing)), None)
            passed = 0 if before is None else before.passed + 1
            others = (item for item in changes if item is not before)
            there_are = len(self._plan.outgoing(mine.source))
            return (*others, Drawing(number, passed)) if passed < there_are else None
        return None

    def _without(self, moment: Moment, other: tuple[int, ...], changes: tuple[Change, ...]) -> Change | None:
        """What takes its event from another transition."""
        for number in other:
            item = self._plan.transitions[number]
            for event in item.events:
                found = self._lacking(moment, item, event)
                if found is not None and found not in changes:
                    return found
        return None

    def _lacking(self, moment: Moment, item: Transition, event: tuple[object, ...]) -> Change | None:
        chart = self._trial.look(moment)
        match event:
            case ("after", int(duration)):
                slot = chart.TIMES.get(item.source)
                if slot is not None and moment.now - getattr(chart, slot) >= duration:
                    return Waiting(item.source, 0)
            case ("raised", str(name)):
                raised = (one for one in moment.inputs if isinstance(one, Happened) and one.name == name)
                return next(map(Lacking, raised), None)
            case ("received", performative, message, participant):
                return self._unsent(moment, item, (performative, message, participant))
            case ("lost", participant):
                return self._unsent(moment, item, (LOST, "", participant))
            case ("error",):
                failed = (
                    one for one in moment.inputs if isinstance(one, Crashed) and is_in(one.label, item.source)
                )
                return next(map(Lacking, failed), None)
        return None

    def _unsent(self, moment: Moment, item: Transition, kind: tuple[object, ...]) -> Change | None:
        chart = self._trial.look(moment)
        branch = self._branch(item)
        waiting = [one for one in moment.inputs if isinstance(one, AgentMessage)]
        for one in (*waiting, *(chart.mail.get(branch, ()))):
            if (one.performative, one.message, one.participant) == kind and one.branch == branch:
                return Lacking(one)
        return None

    # ---- what begins a stage -----------------------------------------------------------------------

    def _endings(self, moment: Moment, stage: Stage) -> Iterable[Change]:
        """The activities that end, unless the step takes their ends anyway."""
        chart = self._trial.look(moment)
        ended = {item.label for item in moment.inputs if isinstance(item, Completed)}
        ended.update(str(label) for kind, label in known_of(self._plan, chart) if kind == "done")
        for ending in stage.endings:
            if ending.label not in ended:
                outcome = self._outcome(stage.ways[0], ending)
                yield replace(ending, outcome=outcome)

    def _outcome(self, way: tuple[int, ...], ending: Ending) -> str | None:
        """How an activity ends: as a condition of the way asks for."""
        if ending.outcome is None:
            return None
        activity = self._plan.by_label[ending.label].activity
        info = next(item for item in self._plan.activities if item.name == activity)
        for number in way:
            for part in parts_in(self._conditions.get(number)):
                asked = [item for item in walk(part.value) if isinstance(item, Outcome)]
                names = {getattr(item, "value", None) for item in walk(part.value)}
                if any(item.activity == activity for item in asked):
                    fits = [end for end in info.ends if (end in names) is not part.negated]
                    if fits:
                        return fits[0]
        return ending.outcome

    def _event(self, moment: Moment, way: tuple[int, ...]) -> Iterable[Change]:
        """What makes one of the events of a way happen, unless one has."""
        chart = self._trial.look(moment)
        source = self._plan.transitions[way[0]].source
        for number in way:
            item = self._plan.transitions[number]
            if item.every is not None and moment.now - getattr(chart, chart.TIMES[source]) < item.every:
                yield Waiting(source, item.every)
            if not item.events or any(self._is_there(moment, item, event) for event in item.events):
                continue
            possible = (self._happening(moment, source, item, event) for event in item.events)
            found = next((one for one in possible if one is not None), None)
            if found is not None:
                yield found

    def _is_there(self, moment: Moment, item: Transition, event: tuple[object, ...]) -> bool:
        return self._lacking(moment, item, event) is not None

    def _happening(
        self, moment: Moment, source: str, item: Transition, event: tuple[object, ...]
    ) -> Change | None:
        chart = self._trial.look(moment)
        match event:
            case ("after", int(duration)):
                return Waiting(source, duration) if source in chart.TIMES else None
            case ("raised", str(name)):
                return Raising(name)
            case ("received", str(performative), str(message), str(participant)):
                return self._coming(Coming(self._branch(item), performative, message, participant))
            case ("lost", str(participant)):
                return Coming(self._branch(item), LOST, "", participant)
            case ("error",):
                running = (
                    label
                    for label, (slot, _, number) in chart.RUNNING.items()
                    if is_in(label, item.source) and getattr(chart, slot) == number
                )
                return next(map(Failing, running), None)
        return None

    def _coming(self, coming: Coming) -> Coming:
        """An agent message comes: one that is still under way, if there is one."""
        record = self._pending(coming)
        if record is None:
            return coming
        return replace(coming, waiting=self._trial.waiting(coming, record))

    def _branch(self, item: Transition) -> str:
        """The branch in whose conversation a transition is."""
        label = item.source
        if label in self._plan.branch_labels and item.kind == "external":
            label = label.rpartition(".")[0]
        return self._plan.branch_of(label) or ""

    def _holding(self, moment: Moment, wanted: Iterable[tuple[Part, bool]]) -> Iterable[Change]:
        for part, is_true in wanted:
            yield Holding(part, is_true, tuple(self._absent(moment, part)) if is_true else ())

    def _absent(self, moment: Moment, part: Part) -> Iterable[tuple[str, str | None]]:
        """The messages that a part of a condition reads, and that are not there."""
        chart = self._trial.look(moment)
        board = board_in(chart, part.region)
        for item in dict.fromkeys(_members(part.value)):
            if board is None or board.newest(*item) is None:
                yield item

    # ---- fewer -------------------------------------------------------------------------------------

    def _least(self, goal: Goal, stages: tuple[Needed, ...]) -> tuple[Needed, ...]:
        """Without the changes that are not needed."""
        found, before = stages, None
        while found != before:  # without one of them another one may not be needed any more
            before, found = found, self._fewer(goal, found)
        return found

    def _fewer(self, goal: Goal, stages: tuple[Needed, ...]) -> tuple[Needed, ...]:
        """Without those changes that can be left out one after the other, the last one first."""
        found = list(stages)
        for place in reversed(range(len(found))):
            for change in reversed(found[place].changes):
                fewer = tuple(item for item in found[place].changes if item is not change)
                other = [*found[:place], replace(found[place], changes=fewer), *found[place + 1 :]]
                if self.happens(goal, other):
                    found = other
        return tuple(found)

    def happens(self, goal: Goal, stages: Sequence[Needed]) -> bool:
        """Whether the goal is reached, if at each stage this was otherwise."""
        if not stages:
            return False
        moment = stages[0].moment
        for stage in stages:
            tried = self._trial.run(moment, stage.changes)
            if _reaches(goal, tried):
                return True
            moment = Moment(tried.after, moment.now)
        return False


def followed(ways: Sequence[tuple[int, ...]], taken: Sequence[tuple[int, ...]]) -> tuple[int, int | None]:
    """How far what was taken follows these ways, and the place of the first of them that is missed."""
    place = 0
    for number, way in enumerate(ways):
        found = (at for at in range(place, len(taken)) if taken[at][: len(way)] == way)
        at = next(found, None)
        if at is None:
            return place, number
        place = at + 1
    return place, None


def _reaches(goal: Goal, tried: Tried) -> bool:
    taken = {number for way in tried.taken for number in way}
    return not goal.states.isdisjoint(tried.entered) or not goal.transitions.isdisjoint(taken)


def _forced(changes: Iterable[Change]) -> dict[Fact, bool]:
    return {item.part.fact: item.is_true for item in changes if isinstance(item, Holding)}


def _members(value: Value) -> Iterator[tuple[str, str | None]]:
    """The channels whose messages a value reads, with their senders; `has` is a question of its own."""
    for item in walk(value):
        if isinstance(item, Member):
            yield str(item.channel), item.host


def _comes_to(tree: Tree, tried: Tried, place: int | None = None) -> bool | None:
    """What a condition came to; None if that is not known."""
    match tree:
        case Part():
            return tried.holds(tree, place)
        case Joined(needs_all=needs_all, parts=parts):
            found = [_comes_to(item, tried, place) for item in parts]
            if (not needs_all) in found:
                return not needs_all
            return None if None in found else needs_all
        case Denied(part=part):
            inner = _comes_to(part, tried, place)
            return None if inner is None else not inner
        case _:
            assert_never(tree)


_Facts = tuple[tuple[Part, bool], ...]
"""Facts that have to be otherwise."""


def _alternatives(
    tree: Tree, wanted: bool, tried: Tried, forced: Mapping[Fact, bool], place: int | None = None
) -> Sequence[_Facts]:
    """Which facts have to be otherwise for a condition to hold, or not to; the fewest first.

    Parts that were not asked count as they have to be, unless nothing else is left.
    """
    for unknown in (False, True):
        found = _needed(tree, wanted, tried, forced, place, unknown)
        if found and found != [()]:
            return sorted(found, key=len)[:ALTERNATIVES]
    return ()


def _needed(
    tree: Tree, wanted: bool, tried: Tried, forced: Mapping[Fact, bool], place: int | None, unknown: bool
) -> list[_Facts]:
    match tree:
        case Part():
            holds = tried.holds(tree, place)
            if holds is wanted or (holds is None and not unknown):
                return [()]
            return [] if tree.fact in forced else [((tree, wanted is not tree.negated),)]
        case Denied(part=part):
            return _needed(part, not wanted, tried, forced, place, unknown)
        case Joined(needs_all=needs_all, parts=parts):
            each = [_needed(item, wanted, tried, forced, place, unknown) for item in parts]
            if needs_all is not wanted:
                return sorted((item for found in each for item in found), key=len)[:ALTERNATIVES]
            together: list[_Facts] = [()]
            for found in each:
                pairs = (_joined(one, other) for one in together for other in found)
                together = sorted((pair for pair in pairs if pair is not None), key=len)[:ALTERNATIVES]
            return together
        case _:
            assert_never(tree)


def _joined(one: _Facts, other: _Facts) -> _Facts | None:
    """Both; None if they contradict each other."""
    found = {part.fact: (part, is_true) for part, is_true in one}
    for part, is_true in other:
        if found.setdefault(part.fact, (part, is_true))[1] is not is_true:
            return None
    return tuple(found.values())


__all__ = ["Conditions", "Found", "Needed", "Pending", "Prevented", "Search", "followed"]
