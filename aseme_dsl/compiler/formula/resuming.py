"""Resuming: `resume T`, the lines of control that resume T where it was interrupted."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.amola.liveness import ungrouped
from aseme_dsl.amola.operators import Operator
from aseme_dsl.compiler.formula.formulas import Formulas
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.control import NothingToResume
from aseme_dsl.grammar.text import tree

RESUME = "resume"
"""The verb of these lines."""


def check_resuming(
    line: tree.Way, formulas: Formulas, played: frozenset[str], verb: str
) -> Iterator[Diagnostic]:
    """W430 for `resume` of an activity, which has no inner states to resume: `verb` does the same."""
    term = ungrouped(line.term.formula)
    if term.operator is not Operator.NAME or term.name in formulas.named or term.name in played:
        return
    span = line.verb.span.to(line.term.span)
    yield Diagnostic(NothingToResume(term.name, verb), span, fix=f"{verb} {line.term.span.text}")


__all__ = ["RESUME", "check_resuming"]
