"""Activity given: whether the Python of an activity takes what the system gives it."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from aseme_dsl.diagnostics import Diagnostic, Related, closest
from aseme_dsl.diagnostics.problems.python import code_words as problems
from aseme_dsl.source import Span

if TYPE_CHECKING:
    from aseme_dsl.amola.srm import Activity

Function = ast.FunctionDef | ast.AsyncFunctionDef


def wrong_parameters(
    execute: Function, activity: Activity, what: str, place: Callable[[ast.expr | ast.stmt], Span]
) -> Iterator[Diagnostic]:
    """E546 for an `execute` that cannot be called with the context and what the activity is given.

    What a decorator makes of an `execute` is not known: then what does not fit is W530.
    """
    taken = execute.args
    decorators = [item for item in execute.decorator_list if not _is_static(item)]
    before = 1 if len(decorators) < len(execute.decorator_list) else 2
    positional = [*taken.posonlyargs, *taken.args]
    without_default = positional[: len(positional) - len(taken.defaults)]
    wanted = [item.arg for item in without_default[before:]]
    wanted += [
        item.arg for item, default in zip(taken.kwonlyargs, taken.kw_defaults, strict=True) if default is None
    ]
    by_name = taken.args[max(before - len(taken.posonlyargs), 0) :]
    accepted = [item.arg for item in (*by_name, *taken.kwonlyargs)]
    given = [item.name for item in activity.parameters]
    related = (Related(activity.span, f"the {what}"),)
    where = place(execute)
    start = where.source.text.find("execute", where.start)
    name = Span(where.source, start, start + len("execute"))
    parameters = (*("self", "context")[2 - before :], *given)
    if len(positional) < before and taken.vararg is None and not decorators:
        yield Diagnostic(problems.ExecuteTakesNoContext(parameters), name, related)
        return
    by_place = [
        item.arg
        for item in taken.posonlyargs[before:]
        if item.arg in given and (item.arg in wanted or taken.kwarg is None)
    ]
    by_place_only = problems.PerhapsByPlaceOnly if decorators else problems.ByPlaceOnly
    for parameter in by_place:
        yield Diagnostic(by_place_only(parameter, parameters), name, related)
    missing = [] if taken.kwarg is not None else [item for item in given if item not in accepted]
    missing = [item for item in missing if item not in by_place]
    extra = [item for item in wanted if item not in given]
    not_taken = problems.ParameterPerhapsNotTaken if decorators else problems.ParameterNotTaken
    for parameter in missing:
        near = closest(parameter, extra)
        if near is not None:
            extra.remove(near)
        yield Diagnostic(not_taken(activity.name, parameter, near, parameters), name, related)
    not_given = problems.ParameterPerhapsNotGiven if decorators else problems.ParameterNotGiven
    for parameter in extra:
        yield Diagnostic(not_given(what, activity.name, parameter), name, related)


def _is_static(decorator: ast.expr) -> bool:
    return isinstance(decorator, ast.Name) and decorator.id == "staticmethod"


__all__ = ["wrong_parameters"]
