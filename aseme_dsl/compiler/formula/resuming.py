"""Resuming: `resume T`, the lines of control that go on with T where it was cut short."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.amola.liveness import ungrouped
from aseme_dsl.amola.operators import Operator
from aseme_dsl.compiler.formula.formulas import Formulas
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar.text import tree

RESUME = "resume"
"""The verb of these lines."""


def check_resuming(line: tree.Way, formulas: Formulas, played: frozenset[str]) -> Iterator[Diagnostic]:
    """W430 for a term that has nothing to go on with: an activity, or a participant that the role plays."""
    term = ungrouped(line.term.formula)
    if term.operator is not Operator.NAME or term.name in formulas.named:
        return
    if term.name in played:
        message = f"`{term.name}` is a participant: a conversation that was left cannot be resumed"
    else:
        message = f"`{term.name}` is an activity: it starts anew, as by `enter {term.name}`"
    yield Diagnostic(
        "W430",
        message,
        line.verb.span.to(line.term.span),
        hint="write `enter`, or resume the formula around it",
    )


__all__ = ["RESUME", "check_resuming"]
