"""Outcome values: `outcome(Grasp) == held`, typed: an activity that has outcomes, and one of these."""

from __future__ import annotations

from aseme_dsl.amola import expression as amola
from aseme_dsl.amola.expression import Literal, Value
from aseme_dsl.amola.messages import Kind, Type
from aseme_dsl.compiler.names.checker import Checker
from aseme_dsl.compiler.names.symbols import ActivityForm
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.compiler.types.calls import is_given, only_name
from aseme_dsl.diagnostics import Related, surely
from aseme_dsl.diagnostics.problems.expressions import values as problems
from aseme_dsl.diagnostics.problems.expressions.absences import NoActivityWithOutcomes, NoOutcome, NoOutcomes
from aseme_dsl.grammar.text import tree


def is_about_outcome(written: tree.Binary) -> bool:
    """Whether one side is `outcome(…)`."""
    return _asked(written.left) is not None or _asked(written.right) is not None


def compare_outcome(checker: Checker, written: tree.Binary) -> Value | None:
    """`outcome(Grasp) == held`, in whichever order (E520, E521)."""
    call = _asked(written.left)
    other = written.right
    if call is None:
        call, other = _asked(written.right), written.left
    assert call is not None
    activity = _activity(checker, call)
    if activity is None:
        return None
    kind = Type(Kind.OUTCOME, activity.name)
    constant = _constant(checker, activity, kind, other)
    if written.operator not in ("==", "!="):
        checker.report(problems.OutcomeOrdered(written.operator), written.operator_span)
        return None
    if constant is None:
        return None
    asked = amola.Outcome(activity.name, kind, call.span)
    if _asked(written.left) is call:
        return amola.Compare(written.operator, asked, constant, written.span)
    return amola.Compare(written.operator, constant, asked, written.span)


def alone(checker: Checker, written: tree.Call) -> None:
    """`outcome(…)` that is not compared (E521), or asks for nothing that has outcomes (E520)."""
    activity = _activity(checker, written)
    if activity is not None:
        problem = problems.OutcomeAlone(written.span.text, activity.name, activity.ends)
        checker.report(problem, written.span)


def _asked(written: tree.Expression) -> tree.Call | None:
    while isinstance(written, tree.Parenthesised):
        written = written.inner
    is_call = isinstance(written, tree.Call) and written.function.text == "outcome"
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


def _constant(
    checker: Checker, activity: ActivityForm, kind: Type, written: tree.Expression
) -> Literal | None:
    """The name that an outcome is compared with."""
    while isinstance(written, tree.Parenthesised):
        written = written.inner
    if isinstance(written, tree.Text) and written.text in activity.ends:
        checker.report(problems.OutcomeInQuotes(written.text), written.span, fix=written.text)
        return None
    if not isinstance(written, tree.Path) or len(written.segments) != 1:
        checker.report(problems.OutcomeComparedWithValue(activity.name, activity.ends), written.span)
        return None
    name = written.segments[0]
    if name.text in activity.ends:
        return Literal(name.text, kind, name.span)
    checker.diagnostics.append(unknown(NoOutcome, name, activity.ends, activity.name, activity.ends))
    return None


__all__ = ["alone", "compare_outcome", "is_about_outcome"]
