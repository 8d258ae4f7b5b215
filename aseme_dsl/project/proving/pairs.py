"""Pairs: whether two agents may be in some places at once, by what each of them must have heard.

Each agent is explored alone, with everything that may come to it. Where it is in the places, it has heard
some message, sent not too long ago. If no two such messages agree with what their sender guarantees, no two
agents are there at once. This is so also if agents crash and restart.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from enum import IntEnum
from itertools import combinations
from time import process_time
from types import UnionType
from typing import Union, cast, get_origin

from aseme_dsl.amola import expression as e
from aseme_dsl.amola.srm import Guarantee
from aseme_dsl.play.promises import is_on, is_so
from aseme_dsl.play.scenario import Breached, Expectation, InPlaces, Script
from aseme_dsl.project.proving.results import Bounds, Result, Verdict
from aseme_dsl.project.proving.scopes import Scope
from aseme_dsl.project.proving.watched import named
from aseme_dsl.proofs.explore.ages import thresholds_of
from aseme_dsl.proofs.explore.alone import Alone, Path, reads_of
from aseme_dsl.proofs.explore.deciding.later import content_of
from aseme_dsl.proofs.explore.deciding.staging import by_lines_of
from aseme_dsl.proofs.explore.explored import Assumed, Explored
from aseme_dsl.proofs.explore.needed import Asked
from aseme_dsl.proofs.explore.search import Eyes, Limits, Monitors, search
from aseme_dsl.proofs.standing import reached, said_in
from aseme_dsl.proofs.timed.search import Watching, search_with_times
from aseme_dsl.proofs.timed.stamp import Stamp
from aseme_dsl.proofs.timed.zone import FREE, Zone
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import Sample
from aseme_dsl.runtime.chart.plan import ChannelInfo, Plan, is_in
from aseme_dsl.runtime.message.as_json import member_types
from aseme_dsl.runtime.monitor.rules import Never
from aseme_dsl.runtime.time.clock import readable
from aseme_dsl.runtime.version.loading import Loaded


@dataclass(frozen=True, slots=True)
class _Fact:
    """A message that an agent has heard, sent between `least` and `most` ns ago; its known members."""

    channel: str
    members: tuple[tuple[Path, object], ...]
    least: int
    most: int | None


Heard = frozenset[_Fact]
"""What an agent has heard in some state."""


class _NotSo(Exception):
    """It cannot be shown in this way."""


def by_pairs(
    scope: Scope, script: Script, item: Expectation, loaded: Loaded, assumed: Assumed, limits: Limits
) -> Result | None:
    """The proof that no two agents are in the places of an expectation at once; None if there is none."""
    rule = item.rule
    condition = script.conditions[rule.condition] if isinstance(rule, Never) else None
    if not isinstance(condition, InPlaces) or condition.least < 2 or item.protocol is not None:
        return None
    if assumed.contradiction:
        return None
    try:
        return _Pairs(scope, script, loaded, assumed, limits).proved(item, condition)
    except _NotSo:
        return None


class _Pairs:
    def __init__(
        self, scope: Scope, script: Script, loaded: Loaded, assumed: Assumed, limits: Limits
    ) -> None:
        self._scope = scope
        self._loaded = loaded
        self._assumed = Assumed(fails=assumed.fails, takes=assumed.takes)
        self._given = assumed
        self._limits = limits
        self._until = process_time() + limits.seconds
        self._plans = {name: loaded.charts[role].PLAN for name, role in scope.team}
        self._promises = [
            (item.activity, item.guarantee) for item in script.conditions if isinstance(item, Breached)
        ]
        self._states = 0
        self._used: dict[str, None] = {}
        """What the proof assumes, for readers."""

    def proved(self, item: Expectation, condition: InPlaces) -> Result | None:
        for plan in self._plans.values():
            if any(info.sends or info.receives for info in plan.branches) or _names_senders(plan):
                raise _NotSo
        channels = self._guaranteed()
        if not channels:
            raise _NotSo
        sole = {channel: self._only_writer(channel) for channel in sorted(channels)}
        useful = {channel: channels[channel] for channel, writer in sole.items() if writer is not None}
        places = {agent: labels for agent, labels in condition.places.items() if labels}
        there = {agent: self._by_form(agent, labels, useful) for agent, labels in places.items()}
        is_so = self._are_excluded(there, channels, sole) and any(map(self._reaches, places, places.values()))
        if not is_so:
            heard = {agent: self._heard(agent, labels, useful, sole) for agent, labels in places.items()}
            there = {agent: found for agent, found in heard.items() if found}
            if not there:
                raise _NotSo  # what it speaks of never happens
            if not self._are_excluded(there, channels, sole):
                return None
        bounds = self._bounds(sum(map(bool, there.values())) > 1)
        return Result(named(item), self._scope.what, Verdict.PROVED, bounds, span=item.span)

    def _are_excluded(
        self,
        there: Mapping[str, frozenset[Heard]],
        channels: Mapping[str, Sequence[tuple[str, Guarantee]]],
        sole: Mapping[str, tuple[str, str] | None],
    ) -> bool:
        """Whether no two agents can have heard what they have."""
        return all(
            self._is_excluded(mine, its, channels, sole)
            for one, other in combinations(sorted(there), 2)
            for mine in there[one]
            for its in there[other]
        )

    def _bounds(self, is_timed: bool) -> Bounds:
        delay = self._given.delay
        within = "any delay"
        if is_timed and delay is not None:
            within = f"delay {readable(delay[0])} to {readable(delay[1])}"
        takes = (
            f"{name} takes {readable(least)} to {readable(most)}"
            for name, (least, most) in self._assumed.takes.items()
        )
        parts = (within, *takes, "all times", *self._used, "any crashes and restarts", "each agent alone")
        return Bounds(self._scope.agents, parts, self._states)

    # ---- what is known of messages -----------------------------------------------------------

    def _guaranteed(self) -> dict[str, list[tuple[str, Guarantee]]]:
        """The channels with states of which an activity guarantees something, as far as this can be used."""
        found: dict[str, list[tuple[str, Guarantee]]] = {}
        for activity, promise in self._promises:
            if promise.earlier is None or promise.within is None or _asks_for_presence(promise):
                continue
            for channel in map(str, promise.said.channels):
                if is_on(promise.earlier, channel) and self._is_fit(channel):
                    found.setdefault(channel, []).append((activity, promise))
        return found

    def _is_fit(self, channel: str) -> bool:
        """Whether only activities publish on a channel, and what comes is a state that was sent lately."""
        if channel.split(".")[1] != "state":
            return False
        for plan in self._plans.values():
            rule = next((info for info in plan.channels if info.name == channel), None)
            if rule is not None and (rule.is_from_outside or rule.persist):
                return False
            if channel in by_lines_of(plan) or any(channel in module.writes for module in plan.modules):
                return False
        return True

    def _only_writer(self, channel: str) -> tuple[str, str] | None:
        """The only agent and activity that publish on a channel; None if there may be others.

        Raises _NotSo: none ever does, so that nothing is ever heard.
        """
        found: list[tuple[str, str]] = []
        for agent, plan in self._plans.items():
            writers = {info.name for info in plan.activities if channel in info.writes}
            for activity in sorted(writers):
                labels = frozenset(state.label for state in plan.states if state.activity == activity)
                if self._reaches(agent, labels):
                    found.append((agent, activity))
        if not found:
            raise _NotSo
        return found[0] if len(found) == 1 else None

    # ---- one agent alone ---------------------------------------------------------------------

    def _fixed(self, agent: str) -> Mapping[str, Mapping[Path, object]]:
        """The members of messages that are assumed to hold one value at an agent."""
        self._used.update((text, None) for text in self._given.held.get(agent, ()))
        return self._given.has.get(agent, {})

    def _explored(
        self, agent: str, labels: frozenset[str], alone: Alone, eyes: Eyes, timed: bool
    ) -> Explored:
        role = dict(self._scope.team)[agent]
        asked = Asked({role: labels})
        team = [(agent, role)]
        return Explored(self._loaded, team, self._assumed, [eyes], asked=asked, with_times=timed, alone=alone)

    def _rest(self) -> Limits:
        left = max(0.0, self._until - process_time())
        return Limits(max(1, self._limits.states - self._states), left, self._limits.queue)

    def _end(self, explored: Explored, cut: str | None, states: int) -> None:
        """The search has ended. Raises _NotSo: it has not looked at all."""
        self._states += states
        values = explored.values
        if cut is not None or values.computed or values.bounds or explored.left_out:
            raise _NotSo

    def _reaches(self, agent: str, labels: frozenset[str]) -> bool:
        """Whether an agent may ever be in one of these states."""
        fixed = self._fixed(agent)
        if not labels & reached(self._plans[agent], fixed):
            return False
        eyes = Eyes()
        explored = self._explored(agent, labels, Alone(fixed=fixed), eyes, False)
        seen: list[bool] = []
        explored.stepped = lambda: seen.append(True) if _is_inside(explored, labels) and not seen else None
        graph = search(explored, eyes, None, self._rest(), lambda graph: bool(seen))
        if not seen:
            self._end(explored, graph.cut, len(graph.parents))
        else:
            self._states += len(graph.parents)
        return bool(seen)

    def _by_form(self, agent: str, labels: frozenset[str], channels: Iterable[str]) -> frozenset[Heard]:
        """What an agent has heard in each of the places, by the form of its statechart."""
        plan, fixed = self._plans[agent], self._fixed(agent)
        rules = {info.name: info for info in plan.channels}
        found: set[Heard] = set()
        for label in sorted(labels & reached(plan, fixed)):
            facts: list[_Fact] = []
            for item in said_in(plan, label, fixed, self._is_optional):
                if item.channel in channels:
                    most = self._sent(item.age, rules[item.channel])
                    facts.append(_Fact(item.channel, item.members, 0, most))
            found.add(frozenset(facts))
        return frozenset(found)

    def _sent(self, age: int | None, rule: ChannelInfo) -> int | None:
        """How long ago a message of this age was sent at the most, by the agent itself or another one."""
        delay = self._given.delay
        if age is None or rule.radio is None:
            return age
        return None if delay is None else max(age, age - rule.delay + delay[1])

    def _is_optional(self, channel: str, path: Path) -> bool:
        """Whether a member of a message may be absent."""
        kind: object = self._loaded.messages[channel.rpartition(".")[2]]
        for name in path:
            kind = member_types(cast(type, kind))[name]
            if get_origin(kind) in (Union, UnionType):
                return True
        return False

    def _heard(
        self,
        agent: str,
        labels: frozenset[str],
        channels: Mapping[str, Sequence[tuple[str, Guarantee]]],
        sole: Mapping[str, tuple[str, str] | None],
    ) -> frozenset[Heard]:
        """What an agent has heard in each state in which it is in one of the places."""
        plan = self._plans[agent]
        kept = frozenset((*channels, *thresholds_of(plan)[0])) & reads_of(plan)
        if any(channel.split(".")[1] != "state" for channel in kept):
            raise _NotSo
        members = {
            channel: frozenset(path for _, promise in channels[channel] for path in _members(promise))
            for channel in kept.intersection(channels)
        }
        delay = self._given.delay
        most = None if delay is None else delay[1]
        rules = {info.name: info for info in plan.channels}
        if self._given.loses and any(
            channel not in rules or rules[channel].radio is None for channel in kept
        ):
            most = None  # what is lost is sent again
        mine = {channel for info in plan.activities for channel in info.writes} & kept
        own = frozenset(channel for channel in mine if (sole.get(channel) or (agent, ""))[0] == agent)
        alone = Alone(kept, (0 if delay is None else delay[0], most), own, members, self._fixed(agent))
        eyes = Eyes()
        explored = self._explored(agent, labels, alone, eyes, True)
        notes = _Notes(explored, labels, alone)
        explored.stepped = notes.stepped
        watching = Watching(
            Monitors(broken=lambda: ()), begins=notes.begins, noted=notes.noted, stays=notes.stays
        )
        graph = search_with_times(explored, eyes, watching, self._rest(), None)
        self._end(explored, graph.cut, len(graph.parents))
        return frozenset(notes.found)

    # ---- two agents --------------------------------------------------------------------------

    def _is_excluded(
        self,
        one: Heard,
        other: Heard,
        channels: Mapping[str, Sequence[tuple[str, Guarantee]]],
        sole: Mapping[str, tuple[str, str] | None],
    ) -> bool:
        """Whether what two agents have heard cannot have been sent."""
        for mine in one:
            for its in other:
                if mine.channel != its.channel or not _differ(mine, its):
                    continue
                writer = sole[mine.channel]
                promises = [it for name, it in channels[mine.channel] if writer and name == writer[1]]
                ways = [self._breach(promises, *pair) for pair in ((mine, its), (its, mine))]
                if all(way is not None for way in ways):
                    self._used.update((text, None) for text in ways if text)
                    return True
        return False

    def _breach(self, promises: Iterable[Guarantee], first: _Fact, then: _Fact) -> str | None:
        """What is broken if one message was sent not after another; "" if it was not; None: nothing."""
        if first.most is not None and first.most < then.least:
            return ""
        for promise in promises:
            assert promise.within is not None
            is_near = first.most is not None and first.most - then.least <= promise.within
            if is_near and is_so(promise, self._told(then), self._told(first)) is True:
                activity = next(name for name, it in self._promises if it is promise)
                return f"{activity} {' '.join(promise.span.text.split())}"
        return None

    def _told(self, fact: _Fact) -> dict[str, object]:
        """The message as a trace tells it; what is not known is absent."""
        told: dict[str, object] = {}
        for path, value in fact.members:
            inside = told
            for name in path[:-1]:
                inside = cast("dict[str, object]", inside.setdefault(name, {}))
            inside[path[-1]] = value.name if isinstance(value, IntEnum) else value
        return told


class _Notes:
    """Notes what an agent has heard whenever it is in some places, also in the midst of a move."""

    def __init__(self, explored: Explored, labels: frozenset[str], alone: Alone) -> None:
        self.found: set[Heard] = set()
        self._explored = explored
        self._labels = labels
        self._alone = alone
        self._waiting: list[list[tuple[Sample, tuple[tuple[Path, object], ...]]]] = []

    def begins(self) -> None:
        self._waiting.clear()

    def stepped(self) -> None:
        if _is_inside(self._explored, self._labels):
            self._waiting.append(list(self._messages()))

    def noted(self, zone: Zone) -> None:
        for items in self._waiting:
            self.found.add(frozenset(self._dated(zone, *item) for item in items))
        self._waiting.clear()

    def stays(self, zone: Zone) -> None:
        if _is_inside(self._explored, self._labels):
            self.found.add(frozenset(self._dated(zone, *item) for item in self._messages()))

    def _messages(self) -> Iterator[tuple[Sample, tuple[tuple[Path, object], ...]]]:
        """The newest messages of the channels, with the members that are known."""
        (agent,) = self._explored.agents
        values = self._explored.later.decided.values
        for board in agent.chart.boards():
            for channel in self._alone.members if board is not None else ():
                item = board.newest(channel) if board is not None else None
                content = None if item is None else content_of(item.message)
                if item is None or content is None:
                    continue
                kind = content.kind.__name__
                known = (
                    (path, value)
                    for (number, _, path), value in values.items()
                    if number == content.number and self._explored.values.is_exact((kind, path), value)
                )
                yield item, tuple(sorted(known))

    def _dated(self, zone: Zone, item: Sample, members: tuple[tuple[Path, object], ...]) -> _Fact:
        """A message with the time since it was sent."""
        time = item.time
        place = zone.place(time.origin) if isinstance(time, Stamp) else None
        if place is None or not isinstance(time, Stamp):
            return _Fact(item.channel, members, 0, None)
        high = zone.rows[place][0]
        least, most = -(zone.rows[0][place] >> 1), None if high == FREE else high >> 1
        if item.identity[0] == "input" and time.origin > 0:  # the clock counts from when it has come
            delay = self._alone.delay
            upper = None if most is None or delay[1] is None else most + delay[1]
            return _Fact(item.channel, members, least + delay[0], upper)
        return _Fact(item.channel, members, least, most)


def _is_inside(explored: Explored, labels: frozenset[str]) -> bool:
    (agent,) = explored.agents
    if agent.over or agent.down or not agent.chart.started:
        return False
    return any(is_in(leaf, label) for leaf in agent.chart.configuration() for label in labels)


def _differ(one: _Fact, other: _Fact) -> bool:
    """Whether two messages cannot be the same one."""
    known = dict(one.members)
    return any(path in known and known[path] != value for path, value in other.members)


def equal_in(value: e.Value) -> Iterator[tuple[str, Path, object]]:
    """The members that have to be equal to a constant for a condition to be true."""
    match value:
        case e.Named(expression=inner):
            yield from equal_in(inner)
        case e.Logic(operator="&&", operands=parts):
            for part in parts:
                yield from equal_in(part)
        case e.Compare(operator="==", left=left, right=right):
            for member, constant in ((left, right), (right, left)):
                if isinstance(member, e.Member) and member.host is None and isinstance(constant, e.Literal):
                    yield str(member.channel), member.path, constant.value
        case _:
            pass


def _members(promise: Guarantee) -> Iterator[Path]:
    """The members that a guarantee asks for."""
    sents = (promise.said, promise.earlier)
    for value in (item.condition for item in sents if item is not None and item.condition is not None):
        for part in e.walk(value):
            if isinstance(part, e.ParameterValue):
                yield part.path


def _asks_for_presence(promise: Guarantee) -> bool:
    sents = (promise.said, promise.earlier)
    values = (item.condition for item in sents if item is not None and item.condition is not None)
    return any(isinstance(part, e.Has) for value in values for part in e.walk(value))


def _names_senders(plan: Plan) -> bool:
    """Whether a condition asks for what a certain agent has sent."""
    todo: list[object] = [part for item in plan.transitions for part in (item.condition, *item.actions)]
    todo += [term for state in plan.states for _, term in state.arguments]
    while todo:
        term = todo.pop()
        if isinstance(term, tuple):
            if term[:1] == ("member",) and term[1] is not None:
                return True
            todo += term
    return False


__all__ = ["by_pairs", "equal_in"]
