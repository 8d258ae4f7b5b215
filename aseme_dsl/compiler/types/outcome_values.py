"""Outcome values: `outcome(Grasp) == held` and `reason(gone) == left`, typed: a question and an answer."""

from __future__ import annotations

from aseme_dsl.amola import expression as amola
from aseme_dsl.amola.expression import Literal, Value
from aseme_dsl.amola.messages import Kind, Type
from aseme_dsl.compiler.names.checker import Checker
from aseme_dsl.compiler.names.symbols import ActivityForm, Symbols
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.compiler.types.calls import is_given, only_name
from aseme_dsl.diagnostics import Related, surely
from aseme_dsl.diagnostics.problems.expressions import values as problems
from aseme_dsl.diagnostics.problems.expressions.absences import (
    NoActivityWithOutcomes,
    NoOutcome,
    NoOutcomes,
    NoReasonOfLoss,
)
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass

NAMED_RESULTS = ("outcome", "reason")
"""The questions whose answer is a name that only they know."""


@dataclass(frozen=True, slots=True)
class _Asked:
    """A question that is typed, with the names of its answers."""

    value: Value
    activity: ActivityForm | None
    """The activity whose outcome it is; None where it is about a loss."""
    names: tuple[str, ...]


def is_about_outcome(written: tree.Binary, symbols: Symbols | None = None) -> bool:
    """Whether one side is `outcome(…)` or `reason(…)`, and not a function that a document calls so."""
    call = _asked(written.left) or _asked(written.right)
    return call is not None and (symbols is None or not symbols.overloads(call.function.text))


def compare_outcome(checker: Checker, written: tree.Binary) -> Value | None:
    """`outcome(Grasp) == held`, in whichever order (E520, E521, E560)."""
    call = _asked(written.left)
    other = written.right
    if call is None:
        call, other = _asked(written.right), written.left
    assert call is not None
    asked = _question(checker, call)
    if asked is None:
        return None
    constant = _constant(checker, asked, other)
    if written.operator not in ("==", "!="):
        checker.report(problems.OutcomeOrdered(written.operator), written.operator_span)
        return None
    if constant is None:
        return None
    if _asked(written.left) is call:
        return amola.Compare(written.operator, asked.value, constant, written.span)
    return amola.Compare(written.operator, constant, asked.value, written.span)


def alone(checker: Checker, written: tree.Call) -> None:
    """A question that is not compared (E521), or asks for nothing that has answers (E520, E560)."""
    asked = _question(checker, written)
    if asked is not None:
        name = asked.activity.name if asked.activity is not None else None
        checker.report(problems.OutcomeAlone(written.span.text, name, asked.names), written.span)


def _question(checker: Checker, call: tree.Call) -> _Asked | None:
    if call.function.text == "reason":
        return _loss(checker, call)
    activity = _activity(checker, call)
    if activity is None:
        return None
    value = amola.Outcome(activity.name, Type(Kind.OUTCOME, activity.name), call.span)
    return _Asked(value, activity, activity.ends)


def _loss(checker: Checker, call: tree.Call) -> _Asked | None:
    """The agent that the transition has lost (E560)."""
    if not is_given(checker, "reason", call, 1):
        return None
    name = only_name(checker, "reason", call.arguments[0], "agent")
    if name is None:
        return None
    taken = checker.scope.taken
    if taken is None or not taken.lost or taken.name != name.text:
        known = taken.name if taken is not None and taken.lost else None
        checker.report(problems.ReasonOfOther(name.text, known), name.span)
        return None
    return _Asked(amola.LossReason(name.text, call.span), None, amola.LOSS_REASONS)


def _asked(written: tree.Expression) -> tree.Call | None:
    while isinstance(written, tree.Parenthesised):
        written = written.inner
    is_call = isinstance(written, tree.Call) and written.function.text in NAMED_RESULTS
    return written if is_call and isinstance(written, tree.Call) else None


def _activity(checker: Checker, written: tree.Call) -> ActivityForm | None:
    """The activity that is asked for, with its outcomes."""
    symbols = checker.scope.symbols
    if not is_given(checker, "outcome", written, 1):
        return None
    name = only_name(checker, "outcome", written.arguments[0], "activity")
    if name is None:
        return None
    found = symbols.activities.get(name.text)
    if found is not None and found.ends:
        return found
    if symbols.is_excused(name.text):
        return None
    with_outcomes = [item.name for item in symbols.activities.values() if item.ends]
    if found is not None and surely(name.text, with_outcomes) is None:
        related = (Related(found.span, "what is said of it"),)
        checker.report(NoOutcomes(name.text, None, tuple(with_outcomes)), name.span, related)
    else:
        checker.diagnostics.append(unknown(NoActivityWithOutcomes, name, with_outcomes))
    return None


def _constant(checker: Checker, asked: _Asked, written: tree.Expression) -> Literal | None:
    """The name that a question is compared with."""
    while isinstance(written, tree.Parenthesised):
        written = written.inner
    subject = asked.activity.name if asked.activity is not None else None
    if isinstance(written, tree.Text) and written.text in asked.names:
        checker.report(problems.OutcomeInQuotes(written.text), written.span, fix=written.text)
        return None
    if not isinstance(written, tree.Path) or len(written.segments) != 1:
        checker.report(problems.OutcomeComparedWithValue(subject, asked.names), written.span)
        return None
    name = written.segments[0]
    if name.text in asked.names:
        return Literal(name.text, asked.value.type, name.span)
    if subject is None:
        checker.diagnostics.append(unknown(NoReasonOfLoss, name, asked.names, asked.names))
    else:
        checker.diagnostics.append(unknown(NoOutcome, name, asked.names, subject, asked.names))
    return None


__all__ = ["NAMED_RESULTS", "alone", "compare_outcome", "is_about_outcome"]
