"""Activity given: whether the Python of an activity takes what the system gives it."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from aseme_dsl.diagnostics import Diagnostic, Related, closest
from aseme_dsl.source import Span

if TYPE_CHECKING:
    from aseme_dsl.amola.srm import Activity

Function = ast.FunctionDef | ast.AsyncFunctionDef


def wrong_parameters(
    execute: Function, activity: Activity, place: Callable[[ast.expr | ast.stmt], Span]
) -> Iterator[Diagnostic]:
    """E546 if `execute` takes no context; W530 for what the activity is given and `execute` does not take,
    and the other way round."""
    taken = execute.args
    positional = [*taken.posonlyargs, *taken.args]
    after_context = positional[2:]
    without_default = positional[: len(positional) - len(taken.defaults)][2:]
    wanted = [item.arg for item in without_default]
    wanted += [
        item.arg for item, default in zip(taken.kwonlyargs, taken.kw_defaults, strict=True) if default is None
    ]
    accepted = [item.arg for item in (*after_context, *taken.kwonlyargs)]
    given = [item.name for item in activity.parameters]
    related = (Related(activity.span, "the activity"),)
    where = place(execute)
    start = where.source.text.find("execute", where.start)
    name = Span(where.source, start, start + len("execute"))
    if len(positional) < 2 and taken.vararg is None and not execute.decorator_list:
        shown = ", ".join(["self", "context", *(item.name for item in activity.parameters)])
        message = "`execute` takes no context, and is called with one"
        yield Diagnostic("E546", message, name, related, hint=f"write `def execute({shown})`")
        return
    missing = [] if taken.kwarg is not None else [item for item in given if item not in accepted]
    extra = [item for item in wanted if item not in given]
    signature = ", ".join(["self", "context", *given])
    for parameter in missing:
        near = closest(parameter, extra)
        if near is not None:
            extra.remove(near)
        yield Diagnostic(
            "W530",
            f"`{activity.name}` is given `{parameter}`, which its `execute` does not take",
            name,
            related,
            hint=f"did you mean `{parameter}` where it takes `{near}`?"
            if near is not None
            else f"write `def execute({signature})`",
        )
    for parameter in extra:
        yield Diagnostic(
            "W530",
            f"`execute` takes `{parameter}`, which `{activity.name}` is not given",
            name,
            related,
            hint=f"say so among the activities, `{activity.name}({parameter} : …)`, or leave it out",
        )


__all__ = ["wrong_parameters"]
