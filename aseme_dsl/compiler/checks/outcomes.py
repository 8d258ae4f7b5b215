"""Outcomes: whether the activities that conditions ask after are there, and whether deadlines can be kept."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from aseme_dsl.amola.expression import Compare, Failed, Literal, Outcome, Value, duration_text
from aseme_dsl.amola.meant import performers
from aseme_dsl.amola.messages import Kind
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.activities import (
    BoundWithoutOutcome,
    DeadlineTooShort,
    MissedDeadlineStops,
    OutcomeOfNobody,
)
from aseme_dsl.source import Span


def check_outcomes(
    charts: Sequence[Statechart], activities: Mapping[str, Activity], memory: Memory
) -> InPieces[list[Diagnostic]]:
    """E520 for `outcome(A)` where no `A` is, or where the role's own activity for it has other outcomes."""
    found: dict[Span | None, Diagnostic] = {}
    asked = yield from memory.each_in_pieces(_asked, zip(charts))
    for chart, questions in zip(charts, asked, strict=True):
        for place, value in questions:
            problem = _absent(chart, place, value) or _otherwise(chart, value, activities)
            if problem is not None:
                found.setdefault(problem.span, problem)
    return list(found.values())


def _asked(chart: Statechart) -> tuple[tuple[str, Value], ...]:
    """The outcomes that are asked for, and what is compared, each with the state where it stands."""
    return tuple(
        (place, value)
        for place, value in chart.values()
        if isinstance(value, Outcome)
        or (
            isinstance(value, Compare)
            and any(isinstance(side, Outcome) for side in (value.left, value.right))
        )
    )


def _absent(chart: Statechart, source: str, value: Value) -> Diagnostic | None:
    if not isinstance(value, Outcome) or performers(chart, source, value.activity):
        return None
    return Diagnostic(OutcomeOfNobody(value.activity, chart.name), value.span)


def _otherwise(chart: Statechart, value: Value, activities: Mapping[str, Activity]) -> Diagnostic | None:
    if not isinstance(value, Compare):
        return None
    sides = (value.left, value.right)
    asked = next((side for side in sides if isinstance(side, Outcome)), None)
    wanted = next((s for s in sides if isinstance(s, Literal) and s.type.kind is Kind.OUTCOME), None)
    if asked is None or wanted is None or asked.activity == asked.type.name:
        return None
    own = activities.get(asked.activity)
    if own is not None and wanted.value in own.ends:
        return None
    related = (Related(own.span, "what is said of it"),) if own is not None else ()
    problem = BoundWithoutOutcome(asked.activity, str(asked.type), chart.name, str(wanted.value))
    return Diagnostic(problem, wanted.span, related)


def check_deadlines(charts: Iterable[Statechart], activities: Mapping[str, Activity]) -> Iterator[Diagnostic]:
    """W603 for a deadline that is shorter than what it takes, W604 for one whose passing stops the agent."""
    for activity in activities.values():
        if activity.within is not None and activity.takes is not None and activity.takes > activity.within:
            takes, within = duration_text(activity.takes), duration_text(activity.within)
            yield Diagnostic(DeadlineTooShort(activity.name, takes, within), activity.span)
    told: set[str] = set()
    for chart in charts:
        if chart.kind != "IAC":
            continue
        caught: dict[str, Span | None] | None = None
        for node in chart.states:
            said = activities.get(node.activity) if node.activity is not None else None
            if said is None or said.within is None or said.name in told:
                continue
            if caught is None:
                caught = _where_errors_are_taken(chart)
            taken = [
                caught[label]
                for label in (node.label, *(around.label for around in chart.ancestors(node.label)))
                if label in caught
            ]
            if None in taken:
                continue
            told.add(said.name)
            condition = taken[0] if taken else None
            related = [Related(said.span, "the deadline")]
            if condition is not None:
                related.append(Related(condition, "the condition, without which nothing takes the failure"))
            within = duration_text(said.within)
            problem = MissedDeadlineStops(chart.name, said.name, within, condition is not None)
            yield Diagnostic(problem, node.span, tuple(related))


def _where_errors_are_taken(chart: Statechart) -> dict[str, Span | None]:
    """The sources of `error` transitions; of one out of a choice, the states that lead there.

    Each with the condition on which alone it is taken. Several conditions beside each other are meant to
    leave nothing out.
    """
    leading: dict[str, list[str]] = {}
    for transition in chart.transitions:
        leading.setdefault(transition.target, []).append(transition.source)
    conditions: dict[str, list[Span | None]] = {}
    for transition in chart.transitions:
        expression = transition.expression
        if any(isinstance(event, Failed) for event in expression.events):
            span = None if expression.condition is None else expression.condition.span
            conditions.setdefault(transition.source, []).append(span)
    waiting = [(label, spans[0] if len(set(spans)) == 1 else None) for label, spans in conditions.items()]
    found: dict[str, Span | None] = {}
    while waiting:
        label, condition = waiting.pop()
        if label not in found or (condition is None and found[label] is not None):
            found[label] = condition
            if chart.node(label).type is StateType.CONDITION:
                waiting += [(source, condition) for source in leading.get(label, ())]
    return found


__all__ = ["check_deadlines", "check_outcomes"]
