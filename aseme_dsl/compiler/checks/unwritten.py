"""Unwritten: conditions that never change, since nothing sets the variables of which they speak."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping

from aseme_dsl.amola.aip import Plays
from aseme_dsl.amola.expression import (
    Assign,
    Call,
    Literal,
    Logic,
    Named,
    Not,
    Value,
    VariableValue,
    operands,
)
from aseme_dsl.amola.messages import AGENT, Kind
from aseme_dsl.amola.srm import Activity, Srm
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.compiler.read.library import is_of_library
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.use import VariablesNeverSet
from aseme_dsl.source import Span

_SHOWN = 4
"""How many related places of a kind are shown at most."""


def check_unwritten(
    charts: Iterable[Statechart],
    srms: Iterable[Srm],
    activities: Mapping[str, Activity],
    settings: Collection[tuple[str, str]],
) -> Iterator[Diagnostic]:
    """N437 for a part of a condition that reads only constants and one variable, which nothing sets.

    - A part that reads anything else, as in `distance < limit`, is allowed: the variable may be a parameter.
    - A variable that several roles share is set if one of them sets it.
    - A variable of a protocol of the standard library must be set by each role that plays it; the diagnostic
      stands at that `plays`.
    - Variables of a participant are checked only if all its activities are simulated: code may set them
      without a `writes` clause.

    `settings` are those of the teams.
    """
    charts = list(charts)
    plays = {srm.name: srm.plays for srm in srms}
    declared = {(chart.name, item.name): item.span for chart in charts for item in chart.variables}
    written = {chart.name: _written(chart, activities, settings) for chart in charts}
    somewhere = {span for (chart, name), span in declared.items() if name.partition("@")[0] in written[chart]}
    told: dict[Span, list[tuple[str, Span, Span]]] = {}
    first: dict[Span, Span] = {}  # of each variable: the place of its diagnostic
    for chart in charts:
        for transition in chart.transitions:
            condition = transition.expression.condition
            for value in _fixed(condition) if condition is not None else ():
                span = declared.get((chart.name, value.name))
                name, _, scope = value.name.partition("@")
                if span is None or name in written[chart.name] or value.type == AGENT:
                    continue
                if scope and not _is_simulated(chart, scope, activities):
                    continue  # the code of its activities may set it without `writes`
                place: Span | None = value.span
                if is_of_library(span.source):
                    place = _place(chart, scope, plays.get(chart.name, ()))
                elif span in somewhere:
                    continue
                else:
                    place = first.setdefault(span, value.span)
                if place is not None and (name, span) not in [item[:2] for item in told.get(place, ())]:
                    told.setdefault(place, []).append((name, span, value.span))
    for place, items in told.items():
        related = [Related(span, "the variable") for _, span, _ in items[:_SHOWN]]
        related += [Related(item[2], "the condition") for item in items[:_SHOWN] if item[2] != place]
        yield Diagnostic(VariablesNeverSet(tuple(name for name, _, _ in items)), place, tuple(related))


def _is_simulated(chart: Statechart, scope: str, activities: Mapping[str, Activity]) -> bool:
    """Whether all activities of a participant's branch are simulated: no code sets its variables then."""
    names = {node.activity for node in chart.states if node.label.startswith(f"{scope}.") and node.activity}
    return all((said := activities.get(name)) is not None and not said.has_code for name in names)


def _written(
    chart: Statechart, activities: Mapping[str, Activity], settings: Collection[tuple[str, str]]
) -> set[str]:
    """The variables of a role that an action, an activity, a module or a team sets."""
    found = {name for role, name in settings if role == chart.name}
    for transition in chart.transitions:
        for action in transition.expression.actions:
            if (
                isinstance(action, Assign)
                and isinstance(action.target, VariableValue)
                and not _clears(action)
            ):
                found.add(action.target.name.partition("@")[0])
    performed = [activities[name] for node in chart.states if (name := node.activity or "") in activities]
    for said in (*performed, *(module.statement for module in chart.modules)):
        found.update(said.writes_variables)
    return found


def _clears(action: Assign) -> bool:
    """Whether an action is `clear(x)`, after which there is nothing."""
    value = action.value
    return isinstance(value, Literal) and value.value == "" and value.type.kind is Kind.MESSAGE


def _fixed(condition: Value) -> Iterator[VariableValue]:
    """The variables of those parts of a condition that speak of nothing but one variable and constants."""
    waiting = [condition]
    while waiting:
        value = waiting.pop()
        match value:
            case Logic():
                waiting += reversed(value.operands)
            case Not():
                waiting.append(value.operand)
            case Named():
                waiting.append(value.expression)
            case _:
                leaves = list(_leaves(value))
                variables = [leaf for leaf in leaves if isinstance(leaf, VariableValue)]
                if len({leaf.name for leaf in variables}) == 1 and all(
                    isinstance(leaf, VariableValue | Literal) for leaf in leaves
                ):
                    yield variables[0]


def _leaves(value: Value) -> Iterator[Value]:
    waiting = [value]
    while waiting:
        item = waiting.pop()
        parts = (item.expression,) if isinstance(item, Named) else operands(item)
        if parts and not isinstance(item, Call):  # what a function makes of it, it may be made for
            waiting += parts
        else:
            yield item


def _place(chart: Statechart, scope: str, plays: Iterable[Plays]) -> Span | None:
    """Where a role says that it plays the participant to whose branch a variable belongs."""
    if not scope:
        return None
    origin = chart.node(scope).origin
    return next(
        (item.span for item in plays if (item.protocol, item.participant) == (origin.owner, origin.name)),
        None,
    )


__all__ = ["check_unwritten"]
