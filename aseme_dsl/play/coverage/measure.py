"""Measure: the parts of a system's models, each with whether runs have reached it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from enum import StrEnum

from aseme_dsl.amola.expression import Literal, Value
from aseme_dsl.amola.statechart import Origin, OriginKind, State, Statechart, StateType, transition_text
from aseme_dsl.amola.system import System
from aseme_dsl.play.coverage.decisions import deciding, decisions_of
from aseme_dsl.play.coverage.reach import Reach, never_holds, reach_of
from aseme_dsl.play.coverage.seen import RoleSeen, Seen
from aseme_dsl.play.coverage.serving import Place, Serving, serving
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


class Kind(StrEnum):
    """What is counted, in the order of reports."""

    GOALS = "goals"
    USE_CASES = "use cases"
    FORMULAS = "formulas"
    STATES = "states"
    TRANSITIONS = "transitions"
    CONDITIONS = "conditions"
    OUTCOMES = "outcomes"


class Status(StrEnum):
    COVERED = "covered"
    MISSED = "missed"
    NEVER = "never"
    """It can never be reached."""
    UNMEASURED = "not measured"


@dataclass(frozen=True, slots=True)
class Item:
    """A part of a model. `of` is its role, actor or protocol, `times` how often it was reached.

    `label` is that of a state, or of the source of a transition; `number` is that of the transition.
    """

    kind: Kind
    of: str
    name: str
    status: Status
    times: int
    span: Span | None
    reason: str = ""
    label: str = ""
    number: int | None = None


@dataclass(frozen=True, slots=True)
class Share:
    """How much of one kind was covered; `total` is without what can never be reached."""

    covered: int
    total: int
    never: int
    unmeasured: int

    @property
    def percent(self) -> float | None:
        """The covered part of what was measured; None if nothing was."""
        measured = self.total - self.unmeasured
        if measured == 0:
            return None if self.unmeasured else 100.0
        return 100 * self.covered / measured


@dataclass(frozen=True, slots=True)
class Coverage:
    """What runs have reached of a system."""

    system: str
    items: tuple[Item, ...]
    scenarios: int
    traces: int
    notes: tuple[str, ...] = ()

    def of(self, kind: Kind) -> Iterator[Item]:
        return (item for item in self.items if item.kind is kind)

    def share(self, kind: Kind) -> Share:
        counts = [item.status for item in self.of(kind)]
        never = counts.count(Status.NEVER)
        return Share(
            counts.count(Status.COVERED), len(counts) - never, never, counts.count(Status.UNMEASURED)
        )


def measured(system: System, seen: Seen) -> Coverage:
    """What runs of a system have reached of it."""
    reaches = {chart.name: reach_of(chart) for chart in system.iacs}
    items = [
        *_use_cases(system, seen, serving(system), reaches),
        *_formulas(system, seen, reaches),
        *(item for chart in system.iacs for item in _chart(chart, seen, reaches[chart.name])),
        *_outcomes(system, seen, reaches),
    ]
    order = list(Kind)
    items.sort(key=lambda item: order.index(item.kind))
    notes = [f"{count} × {reason}" if count > 1 else reason for reason, count in seen.left_out.items()]
    idle = [chart.name for chart in system.iacs if chart.name not in seen.roles]
    notes += [f"no agent had the role {name}" for name in idle]
    return Coverage(system.name, tuple(items), seen.scenarios, seen.traces, tuple(notes))


def _reached(times: int, can_be: bool, reason: str = "no path leads to it") -> tuple[Status, str]:
    if times:
        return Status.COVERED, ""
    return (Status.MISSED, "") if can_be else (Status.NEVER, reason)


# ---- goals and use cases ----------------------------------------------------------------------------


def _use_cases(
    system: System, seen: Seen, cases: Mapping[str, Serving], reaches: Mapping[str, Reach]
) -> Iterator[Item]:
    owners = {goal.name: goal.depender for goal in system.sag.goals}
    for case in system.suc.usecases:
        found = cases[case.name]
        times = found.times(seen)
        if found.is_outside and not found.is_served:
            status, reason = Status.UNMEASURED, "its participants are outside of the system"
        elif not found.is_served:
            status, reason = Status.NEVER, "no state serves it"
        else:
            status, reason = _reached(times, found.can_be(reaches))
        if case.name in owners:
            yield Item(Kind.GOALS, owners[case.name], case.name, status, times, case.span, reason)
        of = ", ".join(case.participants)
        yield Item(Kind.USE_CASES, of, case.name, status, times, case.span, reason)


# ---- formulas ---------------------------------------------------------------------------------------


def written_formulas(system: System) -> Iterator[tuple[Origin, Span]]:
    """The formulas of all roles and the processes of all participants, as the origins of states."""
    for srm in system.srms:
        for formula in srm.formulas:
            yield Origin(OriginKind.FORMULA, srm.name, formula.name), formula.span
    for aip in system.aips:
        for participant in aip.participants:
            yield Origin(OriginKind.PROTOCOL, aip.name, participant.name), participant.span


def _formulas(system: System, seen: Seen, reaches: Mapping[str, Reach]) -> Iterator[Item]:
    for origin, span in written_formulas(system):
        states = [(chart, state) for chart in system.iacs for state in chart.states if state.origin == origin]
        times = max(
            (seen.roles[c.name].entered[s.label] for c, s in states if c.name in seen.roles), default=0
        )
        if states:
            can_be = any(state.label in reaches[chart.name].states for chart, state in states)
            status, reason = _reached(times, can_be)
        else:
            status, reason = Status.NEVER, "no state of a role comes from it"
        yield Item(Kind.FORMULAS, origin.owner, origin.name, status, times, span, reason)


# ---- statecharts ------------------------------------------------------------------------------------

_WIDEST = 40
"""So long is the name of a state in that of a transition."""


def is_counted(state: State) -> bool:
    """Whether a state has a name, and an agent can be in it for some time: the parts of an AND have none."""
    return state.type in (StateType.BASIC, StateType.OR, StateType.AND) and state.name != state.label


def _chart(chart: Statechart, seen: Seen, reach: Reach) -> Iterator[Item]:
    found = seen.roles.get(chart.name, RoleSeen())
    for state in chart.states:
        if is_counted(state):
            times = found.entered[state.label]
            status, reason = _reached(times, state.label in reach.states)
            name = chart.title(state)
            yield Item(Kind.STATES, chart.name, name, status, times, state.span, reason, state.label)
    for number, item in enumerate(chart.transitions):
        times = found.taken[number]
        why = _never_taken(item.source in reach.states, item.expression.condition)
        status, reason = _reached(times, number in reach.transitions, why)
        name = _way_title(chart, number)
        yield Item(Kind.TRANSITIONS, chart.name, name, status, times, item.span, reason, item.source, number)
    yield from _conditions(chart, seen, reach)


def _never_taken(is_entered: bool, condition: Value | None) -> str:
    if not is_entered:
        return "no path leads to it"
    return "its condition is constant" if never_holds(condition) else "its source is never complete"


def _way_title(chart: Statechart, number: int) -> str:
    """A transition in words: from where to where, and with what."""
    item = chart.transitions[number]
    text = "reactive" if item.reactive else transition_text(item)
    return f"{_ends_of(chart, number)} {text}".rstrip()


def _ends_of(chart: Statechart, number: int) -> str:
    item = chart.transitions[number]
    source, *targets = (_cut(chart.title(chart.by_label[label])) for label in (item.source, *item.targets))
    target = f"({', '.join(targets)})" if item.into else targets[0]
    return f"{source} -> {target}" if item.changes_state else source


def _cut(text: str) -> str:
    return text if len(text) <= _WIDEST else f"{text[: _WIDEST - 1]}…"


def _conditions(chart: Statechart, seen: Seen, reach: Reach) -> Iterator[Item]:
    for decision in decisions_of(chart):
        number = decision.transition
        evaluations = seen.evaluations.get((chart.name, number), set())
        shown = deciding(evaluations, len(decision.parts))
        item = chart.transitions[number]
        for place, (part, text) in enumerate(zip(decision.parts, decision.texts, strict=True)):
            reason = ""
            if place in shown:
                status = Status.COVERED
            elif isinstance(part, Literal):
                status, reason = Status.NEVER, "it is constant"
            elif number not in reach.transitions:
                status, reason = Status.NEVER, "its transition is never taken"
            elif not seen.evaluated:
                status, reason = (
                    Status.UNMEASURED,
                    (
                        "the traces cannot be replayed"
                        if seen.traces or seen.scenarios
                        else "nothing was played"
                    ),
                )
            else:
                status, reason = Status.MISSED, _lacks(evaluations, place)
            yield Item(
                Kind.CONDITIONS,
                chart.name,
                f"{text} ({_ends_of(chart, number)})",
                status,
                int(place in shown),
                part.span if part.span.source.path else item.span,
                reason,
                item.source,
                number,
            )


def _lacks(evaluations: Iterable[str], place: int) -> str:
    """What a part lacks to have been shown to decide."""
    values = {item[place] for item in evaluations} - {"-"}
    match sorted(values):
        case []:
            return "it was never evaluated"
        case ["T"]:
            return "it always held"
        case ["F"]:
            return "it never held"
    return "it never made the difference"


# ---- outcomes ---------------------------------------------------------------------------------------


def _outcomes(system: System, seen: Seen, reaches: Mapping[str, Reach]) -> Iterator[Item]:
    for aip in system.aips:
        for item in aip.outcomes:
            places = [place for where in item.when for place in _places(system, aip.name, where)]
            times = sum(seen.roles[role].entered[label] for role, label in places if role in seen.roles)
            if not item.when:
                status, reason = Status.UNMEASURED, "nothing says when it is so"
            else:
                can_be = any(label in reaches[role].states for role, label in places)
                status, reason = _reached(times, can_be)
            yield Item(Kind.OUTCOMES, aip.name, item.text, status, times, aip.span, reason)
    for chart in system.iacs:
        for name, states in _performed(chart).items():
            activity = system.activity(name)
            for outcome in activity.ends if activity is not None else ():
                found = seen.roles.get(chart.name, RoleSeen())
                times = sum(found.ended[state.label, outcome] for state in states)
                status = Status.COVERED if times else Status.MISSED
                title = f"{outcome} of {name}"
                assert activity is not None
                yield Item(Kind.OUTCOMES, chart.name, title, status, times, activity.span)


def _places(system: System, protocol: str, where: str) -> Iterator[Place]:
    """The states that `X@participant` means, in the roles that play the participant."""
    name, _, participant = where.partition("@")
    origin = Origin(OriginKind.PROTOCOL, protocol, participant)
    for chart in system.iacs:
        own = {
            mine
            for srm in system.srms
            for plays in srm.plays
            if srm.name == chart.name and (plays.protocol, plays.participant) == (protocol, participant)
            for abstract, mine in plays.bindings
            if abstract == name
        }
        for state in chart.states:
            if state.origin == origin and not own.union((name,)).isdisjoint(
                (state.name.partition("(")[0], state.activity)
            ):
                yield chart.name, state.label


def _performed(chart: Statechart) -> Mapping[str, Sequence[State]]:
    """The states that perform each activity."""
    found: dict[str, list[State]] = {}
    for state in chart.states:
        if state.activity is not None:
            found.setdefault(state.activity, []).append(state)
    return found


__all__ = [
    "Coverage",
    "Item",
    "Kind",
    "Share",
    "Status",
    "is_counted",
    "measured",
    "written_formulas",
]
