"""Repeated lines: the same `on` line for each activity of a formula, which one line for the formula says."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.amola.expression import After, Failed, expression_text
from aseme_dsl.amola.statechart import State, Statechart, StateType, TransitionKind
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.use import SameLineForAll
from aseme_dsl.source import Span

FEWEST = 3
"""Of how many lines it is worth a word that one is enough."""


def check_repeated_lines(chart: Statechart) -> Iterator[Diagnostic]:
    """N442: all activities inside a state have the same `on` line."""
    lines: dict[str, dict[str, Span]] = {}
    for transition in chart.transitions:
        span = transition.expression.span
        is_about_activity = any(isinstance(event, After | Failed) for event in transition.expression.events)
        if transition.kind is TransitionKind.ON and span is not None and not is_about_activity:
            text = expression_text(transition.expression)
            lines.setdefault(text, {}).setdefault(transition.source, span)
    for places in lines.values():
        if len({*places.values()}) < FEWEST:
            continue
        around = _around(chart, frozenset(places))
        if around is not None:
            first, *others = sorted({*places.values()}, key=lambda span: span.start)
            name = None if around.parent is None else around.name
            problem = SameLineForAll(len(places), chart.name, name)
            yield Diagnostic(problem, first, tuple(Related(span, "and here") for span in others))


def _around(chart: Statechart, labels: frozenset[str]) -> State | None:
    """The innermost state whose activities are exactly those of the labels."""
    found = None
    for state in chart.states:
        inside = {
            item.label
            for item in chart.states
            if item.type is StateType.BASIC and item.label.startswith(f"{state.label}.")
        }
        if inside == labels:
            found = state
    return found


__all__ = ["check_repeated_lines"]
