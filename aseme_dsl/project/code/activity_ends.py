"""Activity ends: whether the Python of an activity returns the outcomes that the system gives it."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from aseme_dsl.diagnostics import Diagnostic, Related, closest
from aseme_dsl.diagnostics.problems.python.code_words import OutcomeNotOfActivity, OutcomeNotReturned
from aseme_dsl.project.code.activity_access import Place

if TYPE_CHECKING:
    from aseme_dsl.amola.srm import Activity

Text = Callable[[ast.expr], str | None]


def wrong_outcomes(
    execute: ast.FunctionDef | ast.AsyncFunctionDef, activity: Activity, place: Place, text: Text
) -> Iterator[Diagnostic]:
    """W530 for what `execute` returns and the activity does not end, as far as it is written there."""
    if not activity.ends:
        return
    unsaid = OutcomeNotReturned(activity.name, activity.ends)
    related = (Related(activity.span, "the activity"),)
    returns = list(_returns(execute))
    for item in returns:
        if item.value is None or (isinstance(item.value, ast.Constant) and item.value.value is None):
            yield Diagnostic(unsaid, place(item), related)
            continue
        for value in _values(item.value):
            said = text(value)
            if said is not None and said not in activity.ends:
                problem = OutcomeNotOfActivity(
                    activity.name, said, closest(said, activity.ends), activity.ends
                )
                yield Diagnostic(problem, place(value), related)
    if not returns and _comes_to_its_end(execute):
        yield Diagnostic(unsaid, place(execute.body[-1]), related)


def _returns(execute: ast.FunctionDef | ast.AsyncFunctionDef) -> Iterator[ast.Return]:
    """The returns of a function, without those of functions inside it, in the order of the text."""
    stack: list[ast.AST] = list(reversed(execute.body))
    while stack:
        node = stack.pop()
        if isinstance(node, ast.Return):
            yield node
        elif not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef | ast.Lambda):
            stack += reversed(list(ast.iter_child_nodes(node)))


def _values(value: ast.expr) -> Iterator[ast.expr]:
    """What may be returned: both sides of `a if b else c`."""
    if isinstance(value, ast.IfExp):
        yield from _values(value.body)
        yield from _values(value.orelse)
    else:
        yield value


def _comes_to_its_end(execute: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    """Whether the body is code that may run to its end: what is empty counts as no code."""
    last = execute.body[-1]
    if isinstance(last, ast.Pass) or (isinstance(last, ast.Expr) and isinstance(last.value, ast.Constant)):
        return False
    return not isinstance(last, ast.Raise | ast.While | ast.Try | ast.With | ast.AsyncWith)


__all__ = ["wrong_outcomes"]
