"""Goals: what serves each goal of a system, what serves none, and how often goals were reached in runs."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from aseme_dsl.amola.statechart import Origin
from aseme_dsl.amola.suc import UseCase, folded
from aseme_dsl.amola.system import System
from aseme_dsl.play.coverage.measure import is_counted, written_formulas
from aseme_dsl.play.coverage.seen import Seen
from aseme_dsl.play.coverage.serving import Place, Serving, serving
from aseme_dsl.play.scenario import InPlaces, Scenario
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Named:
    """Something with a name, the role or protocol it is of, and its place."""

    of: str
    name: str
    span: Span | None


@dataclass(frozen=True, slots=True)
class GoalSum:
    """A goal: what serves it, and how often it was reached, in how many of the runs."""

    name: str
    actor: str
    text: str
    span: Span
    use_cases: tuple[Named, ...]
    formulas: tuple[Named, ...]
    states: tuple[Named, ...]
    scenarios: tuple[Named, ...]
    times: int
    runs: int


@dataclass(frozen=True, slots=True)
class Dangling:
    """A goal that nothing serves, or something that serves no goal: which `kind` of thing, and why."""

    kind: str
    item: Named
    reason: str


@dataclass(frozen=True, slots=True)
class Goals:
    """All goals of a system, and what dangles."""

    system: str
    goals: tuple[GoalSum, ...]
    dangling: tuple[Dangling, ...]
    runs: int
    """How many traces and files of coverage there are."""
    played: int = 0
    """The traces and scenarios that are in them."""


def goals_of(system: System, scenarios: Iterable[Scenario], runs: Sequence[Seen]) -> Goals:
    """The goals of a system, with the scenarios that name their states, and what runs have reached."""
    cases = serving(system)
    by_name = {folded(case.name): case for case in system.suc.usecases}
    spoken = [(scenario, frozenset(_places(scenario))) for scenario in scenarios]
    goals: list[GoalSum] = []
    served: set[Place] = set()
    used: set[str] = set()
    for goal in system.sag.goals:
        case = by_name[folded(goal.name)]
        inside = list(_with_included(case, by_name))
        used.update(item.name for item in inside)
        states = dict.fromkeys(place for item in inside for place in cases[item.name].states)
        served.update(states)
        found = cases[case.name]
        goals.append(
            GoalSum(
                goal.name,
                goal.depender,
                goal.requirements,
                goal.span,
                tuple(Named(", ".join(item.participants), item.name, item.span) for item in inside),
                tuple(_formulas(system, states)),
                tuple(_states(system, states)),
                tuple(
                    Named("", scenario.name, scenario.span)
                    for scenario, places in spoken
                    if any(_serves(place, states) for place in places)
                ),
                sum(found.times(run) for run in runs),
                sum(found.times(run) > 0 for run in runs),
            )
        )
    dangling = (
        *_without_states(goals, cases),
        *_without_scenario(goals, spoken),
        *_unused_cases(system, used),
        *_unserving_formulas(system, served, goals),
        *_unserving_scenarios(spoken, served, goals),
    )
    played = sum(run.scenarios + run.traces for run in runs)
    return Goals(system.name, tuple(goals), dangling, len(runs), played)


def _with_included(case: UseCase, by_name: Mapping[str, UseCase]) -> Iterable[UseCase]:
    """A use case and all that it includes, each once."""
    found: dict[str, UseCase] = {}
    waiting = [case]
    while waiting:
        item = waiting.pop()
        if item.name not in found:
            found[item.name] = item
            waiting += (by_name[folded(name)] for name in reversed(item.includes))
    return found.values()


def _states(system: System, places: Iterable[Place]) -> Iterable[Named]:
    for role, label in places:
        chart = system.iac(role)
        assert chart is not None
        state = chart.by_label[label]
        yield Named(role, chart.title(state), state.span)


def _formulas(system: System, places: Iterable[Place]) -> Iterable[Named]:
    """The formulas, and processes of participants, from which states come."""
    spans = {origin: span for origin, span in written_formulas(system)}
    found: dict[Origin, None] = {}
    for role, label in places:
        chart = system.iac(role)
        assert chart is not None
        found[chart.by_label[label].origin] = None
    return [Named(item.owner, item.name, spans[item]) for item in found if item in spans]


def _places(scenario: Scenario) -> Iterable[Place]:
    """The states that a scenario names."""
    for script in scenario.scripts[:1]:
        roles = dict(script.team)
        for condition in script.conditions:
            if isinstance(condition, InPlaces):
                for agent, labels in condition.places.items():
                    for label in labels:
                        yield roles[agent], label


def _serves(place: Place, states: Iterable[Place]) -> bool:
    """Whether a state is one of these, or inside one."""
    role, label = place
    return any(role == other and f"{label}.".startswith(f"{around}.") for other, around in states)


# ---- what dangles -----------------------------------------------------------------------------------


def _without_states(goals: Iterable[GoalSum], cases: Mapping[str, Serving]) -> Iterable[Dangling]:
    for goal in goals:
        missing = [item.name for item in goal.use_cases if not cases[item.name].is_served]
        if not goal.states:
            reason = "no state serves it"
        elif missing:
            reason = f"no state serves {', '.join(missing)}, which it includes"
        else:
            continue
        yield Dangling("goal", Named(goal.actor, goal.name, goal.span), reason)


def _without_scenario(
    goals: Sequence[GoalSum], spoken: Sequence[tuple[Scenario, frozenset[Place]]]
) -> Iterable[Dangling]:
    if spoken:
        for goal in goals:
            if goal.states and not goal.scenarios:
                named = Named(goal.actor, goal.name, goal.span)
                yield Dangling("goal", named, "no scenario names a state that serves it")


def _unused_cases(system: System, used: set[str]) -> Iterable[Dangling]:
    if system.sag.goals:
        for case in system.suc.usecases:
            if case.name not in used:
                named = Named(", ".join(case.participants), case.name, case.span)
                yield Dangling("use case", named, "no goal includes it")


def _unserving_formulas(system: System, served: set[Place], goals: Sequence[GoalSum]) -> Iterable[Dangling]:
    """Formulas of which no state serves a goal, or is around or inside one that does."""
    if not goals:
        return
    for origin, span in written_formulas(system):
        places = [
            (chart.name, state.label)
            for chart in system.iacs
            for state in chart.states
            if state.origin == origin and is_counted(state)
        ]
        if places and not any(_is_near(place, served) for place in places):
            named = Named(origin.owner, origin.name, span)
            yield Dangling("formula", named, "its states serve no goal")


def _is_near(place: Place, served: Iterable[Place]) -> bool:
    role, label = place
    return any(
        role == other and (f"{label}.".startswith(f"{around}.") or f"{around}.".startswith(f"{label}."))
        for other, around in served
    )


def _unserving_scenarios(
    spoken: Sequence[tuple[Scenario, frozenset[Place]]], served: set[Place], goals: Sequence[GoalSum]
) -> Iterable[Dangling]:
    if goals:
        for scenario, places in spoken:
            if not any(_serves(place, served) for place in places):
                named = Named("", scenario.name, scenario.span)
                yield Dangling("scenario", named, "it names no state that serves a goal")


__all__ = ["Dangling", "GoalSum", "Goals", "Named", "goals_of"]
