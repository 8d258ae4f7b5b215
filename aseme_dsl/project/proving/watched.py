"""Watched: the properties and clauses of a system in each state of a team that is explored."""

from __future__ import annotations

from collections.abc import (
    Callable,
    Iterable,
    Iterator,
    Mapping,
    MutableSequence,
    Sequence,
)
from dataclasses import replace
from functools import partial
from typing import assert_never

from aseme_dsl.amola import expression as e
from aseme_dsl.codegen.plan import value_term
from aseme_dsl.play.conversations import Clauses
from aseme_dsl.play.observer import Observer
from aseme_dsl.play.scenario import (
    AllOf,
    AnyOf,
    Breached,
    Condition,
    Expectation,
    Failed,
    Faulty,
    Holds,
    InPlaces,
    NotSo,
    Says,
    Script,
    Untaken,
    all_parts,
)
from aseme_dsl.play.sight.insight import Insight, Live
from aseme_dsl.project.proving.results import Key
from aseme_dsl.proofs.explore.alone import reads_of
from aseme_dsl.proofs.explore.explored import Explored
from aseme_dsl.proofs.explore.needed import Asked
from aseme_dsl.proofs.explore.search import Monitors
from aseme_dsl.proofs.explore.surroundings import NOW
from aseme_dsl.proofs.timed.search import Due
from aseme_dsl.proofs.timed.stamp import Mark, Stamp
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.chart.board import NEVER
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.monitor.rules import (
    AfterFirst,
    Always,
    At,
    Before,
    InOrder,
    LeadsTo,
    Never,
    NotWithin,
    Rule,
    Sometime,
    State,
    Until,
    Verdict,
    conditions_of,
    ended,
)
from aseme_dsl.source import Span

_PARTS: Mapping[type, tuple[str, ...]] = {
    Observer: (
        *("states", "broken", "failures", "_agents", "_held", "_said", "_arrived", "_unread", "_is_over"),
        "_clauses",
    ),
    Clauses: ("_talks", "_of", "_due", "_early", "_active", "broken"),
}
_ONLY_KEPT = ("_said", "_arrived", "_unread", "failures", "broken")
_OF_PLACES = ("_agents", "_held")
"""What follows from where the agents are, if no condition asks for anything else."""


_OF_MORE = (e.Bound, e.Sender, e.LossReason, e.Outcome, e.StateValue, e.RoundValue, e.Index, e.Random)
"""What conditions ask for that is not in a message, a variable or a timer."""


def layout_of(
    watched: Watched | None,
) -> tuple[Mapping[type, tuple[str, ...]], Mapping[type, frozenset[str]]]:
    """What of an observer belongs to the state of a team, and what of that makes no difference."""
    if watched is None:
        return {}, {}
    asks = any(isinstance(item, Holds | Says) for item in conditions_in(watched.observer.script))
    unkeyed = frozenset((*_ONLY_KEPT, *(() if asks else _OF_PLACES)))
    return _PARTS, {Observer: unkeyed, Clauses: frozenset(("broken", "_active", "_of", "_due"))}


def conditions_in(script: Script | None) -> Iterator[Condition]:
    """The conditions that the expectations of a script speak of, with those inside."""
    if script is None:
        return
    for number in _numbers_in(script):
        yield script.conditions[number]


def unread_of(script: Script, item: Expectation, plans: Mapping[str, Plan]) -> str:
    """That an agent neither reads nor fills the message that it is said to have; empty if it does. `plans`
    are those of the agents."""
    found = (
        f"{condition.agent} does not read {part.channel}, so it never has one"
        for condition in conditions_in(replace(script, expectations=(item,)))
        if isinstance(condition, Holds)
        for part in e.walk(condition.value)
        if isinstance(part, e.Member)
        and str(part.channel) not in reads_of(plans[condition.agent]) | _filled(plans[condition.agent])
    )
    return next(found, "")


def _filled(plan: Plan) -> frozenset[str]:
    """The channels of the messages whose members the actions of a role set."""
    targets = (action[1] for item in plan.transitions for action in item.actions if action[0] == "fill")
    return frozenset(str(target[2]) for target in targets if isinstance(target, tuple))


def _numbers_in(script: Script) -> Iterable[int]:
    numbers = (
        number for item in script.expectations for number in (*conditions_of(item.rule), *item.witnesses)
    )
    return dict.fromkeys(all_parts(script.conditions, numbers))


def hears(script: Script | None) -> bool:
    """Whether conditions ask for messages that are sent, or that nothing takes."""
    return any(isinstance(item, Says | Untaken | Breached | Faulty) for item in conditions_in(script))


def names_in(script: Script | None) -> frozenset[str]:
    """The variables and timers that conditions ask for."""
    found: set[str] = set()
    for item in conditions_in(script):
        if isinstance(item, Holds):
            for part in e.walk(item.value):
                if isinstance(part, e.VariableValue):
                    found.add(part.name.partition("@")[0])
                elif isinstance(part, e.Expired):
                    found.add(part.timer)
    return frozenset(found)


def messages_in(script: Script | None, kinds: Iterable[str]) -> frozenset[str]:
    """The types of messages, out of `kinds`, of which conditions ask when they come or what is in them."""
    found: set[str] = set()
    for item in conditions_in(script):
        match item:
            case Holds(value=value):
                found.update(_channel(part).rpartition(".")[2] for part in e.walk(value))
            case Says(what=what, is_kind=is_kind):
                found.add(what if is_kind else what.rpartition(".")[2])
            case _:
                pass
    return frozenset(found).intersection(kinds)


def terms_in(script: Script | None) -> Iterator[tuple[object, str]]:
    """What conditions ask of values: as terms of plans, with the type of the message they name, or ""."""
    for item in conditions_in(script):
        match item:
            case Holds(value=value):
                yield value_term(value), ""
            case Says(what=what, condition=value) if value is not None:
                yield value_term(value), what.rpartition(".")[2]
            case _:
                pass


def _channel(part: e.Value) -> str:
    """The channel whose messages a value asks for."""
    match part:
        case e.Member():
            return str(part.channel)
        case e.Age() | e.At() | e.Mean():
            return str(part.message.channel) if isinstance(part.message, e.Member) else ""
        case _:
            return ""


def asked_by(script: Script) -> Asked | None:
    """What the expectations of a script are about; None if they may be about anything."""
    roles = dict(script.team)
    states: dict[str, set[str]] = {}
    channels: set[str] = set()
    if any(item.protocol is not None for item in script.expectations):
        return None
    for item in conditions_in(script):
        match item:
            case InPlaces(places=places):
                for agent, labels in places.items():
                    states.setdefault(roles[agent], set()).update(labels)
            case Says(what=what, is_kind=False):
                channels.add(what)
            case Holds(value=value):
                if any(isinstance(part, _OF_MORE) for part in e.walk(value)):
                    return None
                channels.update(_channel(part) for part in e.walk(value))
            case AllOf() | AnyOf() | NotSo():
                pass
            case Says() | Untaken() | Breached() | Faulty() | Failed():
                return None
            case _:
                assert_never(item)
    found = {role: frozenset(labels) for role, labels in states.items()}
    return Asked(found, frozenset(channels - {""}), names_in(script))


class Watched:
    """Shows the observer of scenarios what happens in a team that is explored."""

    def __init__(self, script: Script) -> None:
        self.observer = Observer(_from_now(_only_asked(script)), {}, goes_on=True)
        self.observer._now = NOW
        self._retired: set[int] = set()
        self._explored: Explored | None = None

    def begin(self, explored: Explored) -> None:
        """It is about this team."""
        self._explored = explored
        explored.has_crashed = self._crash
        self.observer.begin(self)

    def _crash(self, agent: str) -> None:
        """An agent crashes: no step says so. That it may is what is assumed."""
        self.observer.forget(agent)
        self.observer.look_now()

    # ---- the surroundings of the observer ----------------------------------------------------

    def now(self) -> int:
        return NOW

    def at(self, moment: int, call: Callable[[], None]) -> None:
        """No moment comes."""

    def insight(self, agent: str) -> Insight:
        assert self._explored is not None
        return Live(next(item.chart for item in self._explored.agents if item.name == agent))

    def numbers_of(self, names: Sequence[str]) -> tuple[int, ...]:
        """The expectations of these names."""
        return tuple(
            number for number, item in enumerate(self.observer.script.expectations) if named(item) in names
        )

    # ---- with times --------------------------------------------------------------------------

    def begin_moment(self) -> None:
        """What the observer sees from now on happens at the moment of a new move."""
        assert self._explored is not None
        self.observer._now = self._explored.driver.clock.now()

    def dues(self) -> Sequence[Due]:
        """What is awaited, or forbidden, by a moment."""
        clauses = self.observer._clauses
        found = [
            self._due(number, rule, state, partial(self._forget, self.observer.states, number), "")
            for number, item in enumerate(self.observer.script.expectations)
            for rule, state in ((item.rule, self.observer.states[number]),)
            if item.protocol is None
        ]
        for place, talk in enumerate(clauses._talks.values()):
            found += [
                self._due(number, clauses._clauses[number].rule, state, forget, f"{place}")
                for number, state in talk.states.items()
                for forget in (partial(self._forget, talk.states, number),)
            ]
        return [item for item in found if item is not None]

    def _forget(self, states: MutableSequence[State] | dict[int, State], number: int) -> None:
        rule = self.observer.script.expectations[number].rule
        kept = State(Verdict.KEPT)
        states[number] = kept if isinstance(rule, Never) else replace(states[number], due=None)

    def _due(
        self, number: int, rule: Rule, state: State, forget: Callable[[], None], place: str
    ) -> Due | None:
        if number in self._retired or state.verdict is not Verdict.OPEN:
            return None
        name = f"due {number} {place}"
        match rule:
            case LeadsTo(within=within) if within is not None and isinstance(state.due, Stamp):
                return Due(number, Mark(name, state.due.origin, state.due.offset), 0, True, forget)
            case NotWithin() if isinstance(state.due, Stamp):
                return Due(number, Mark(name, state.due.origin, state.due.offset), 0, False, forget)
            case Sometime(until=until) if until != NEVER:
                return Due(number, Mark(name, 0, int(until) - NOW), 0, True, forget)
            case Never(before=before) if before != NEVER:
                return Due(number, Mark(name, 0, int(before) - NOW), -1, False, forget)
            case _:
                return None

    # ---- what the search asks ----------------------------------------------------------------

    @property
    def monitors(self) -> Monitors:
        return Monitors(self._awaited, self._broken, met=lambda: self.observer.met)

    def _awaited(self) -> frozenset[int]:
        observer = self.observer
        return frozenset(
            number
            for number in range(len(observer.states))
            if number not in self._retired and observer.is_awaited(number, NOW)
        )

    def _broken(self) -> Sequence[int]:
        observer = self.observer
        self._end_talks()
        for number in self._retired:
            observer.states[number] = State(Verdict.KEPT)
        found = [
            number
            for number, state in enumerate(observer.states)
            if state.verdict is Verdict.BROKEN and number not in self._retired
        ]
        for number in found:
            self._retired.add(number)
            observer.states[number] = State(Verdict.KEPT)
        observer.broken = None
        observer._clauses.broken.clear()
        return found

    def _end_talks(self) -> None:
        """What is awaited in a conversation does not come when all have left it and none may join it."""
        assert self._explored is not None
        clauses = self.observer._clauses
        for name, talk in list(clauses._talks.items()):
            for number, state in talk.states.items():
                if number in self._retired:
                    talk.states[number] = State(Verdict.KEPT)
                elif state.verdict is Verdict.BROKEN:
                    self.observer.states[number] = state
            if talk.places or self._explored.may_be_joined(name):
                continue
            for number, state in talk.states.items():
                rule = clauses._clauses[number].rule
                if ended(rule, state, NOW).verdict is Verdict.BROKEN and number not in self._retired:
                    self.observer.states[number] = State(Verdict.BROKEN)
            del clauses._talks[name]


def _only_asked(script: Script) -> Script:
    """The same without the conditions of which no expectation speaks: looking at them would decide values."""
    asked = set(_numbers_in(script))
    conditions = [item if number in asked else AnyOf(()) for number, item in enumerate(script.conditions)]
    return replace(script, conditions=tuple(conditions))


def _from_now(script: Script) -> Script:
    """The same with moments that are counted from the moment at which an explored team stands."""
    return replace(
        script,
        expectations=tuple(replace(item, rule=_rule_from_now(item.rule)) for item in script.expectations),
    )


def _rule_from_now(rule: Rule) -> Rule:
    match rule:
        case Sometime(since=since, until=until) if until != NEVER:
            return replace(rule, since=NOW + since, until=NOW + until)
        case Never(before=before) if before != NEVER:
            return replace(rule, before=NOW + before)
        case _:
            return rule


def named(item: Expectation) -> str:
    """The name of a property; a clause is called as it is written."""
    if item.of.startswith("clause"):
        return as_written(item.span)
    return item.of.removeprefix("property ").strip('"')


def as_written(clause: Span) -> str:
    """What a clause says, in one line."""
    return " ".join(clause.text.split()).removeprefix("clause ")


def key_of(item: Expectation) -> Key:
    """That of the answer."""
    return named(item), str(item.span)


def asks_for_more(script: Script, item: Expectation) -> bool:
    """Whether an expectation asks for what is not tried so that all cases are there: ages, the history of a
    channel, what functions give."""
    return any(
        isinstance(part, e.Age | e.At | e.Mean)
        or (isinstance(part, e.Call) and not part.function.target.startswith("builtin:"))
        for condition in conditions_in(replace(script, expectations=(item,)))
        if isinstance(condition, Holds | Says)
        for value in ((condition.value if isinstance(condition, Holds) else condition.condition),)
        if value is not None
        for part in e.walk(value)
    )


def left_out_of_times(rule: Rule, agents: Iterable[Agent]) -> str:
    """What is not explored with times; empty if all is."""
    match rule:
        case At() | AfterFirst():
            return "it asks what is so at one moment"
        case Sometime(since=since) if since not in (0, NOW):
            return "it asks for something from a moment on"
        case _:
            pass
    for agent in agents:
        chart = type(agent.chart)
        resumed = next((item for item in agent.plan.transitions if item.resume), None)
        if resumed is not None and (chart.TIMES or chart.PART_TIMERS):
            return f"the time that stands still until `{resumed.text}` ({resumed.at}) is not measured"
    return ""


def is_timed(rule: Rule) -> bool:
    """Whether a rule speaks of how long something takes."""
    match rule:
        case LeadsTo(within=within):
            return within is not None
        case Never(before=before):
            return before != NEVER
        case Sometime(until=until):
            return until != NEVER
        case NotWithin() | At() | AfterFirst():
            return True
        case Always() | InOrder() | Before() | Until():
            return False
        case _:
            assert_never(rule)


__all__ = [
    "Watched",
    "asked_by",
    "asks_for_more",
    "conditions_in",
    "hears",
    "is_timed",
    "layout_of",
    "left_out_of_times",
    "messages_in",
    "named",
    "names_in",
    "terms_in",
    "unread_of",
]
