"""Names: the diagnostics about names that every phase gives in the same words."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Concatenate, ParamSpec

from aseme_dsl.compiler.read.builtins import PERFORMATIVES
from aseme_dsl.diagnostics import Diagnostic, Related, closest, surely
from aseme_dsl.diagnostics.problems.absences import NoPerformative, Unknown
from aseme_dsl.diagnostics.problems.names import DeclaredTwice
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span

P = ParamSpec("P")


def unknown(
    problem: Callable[Concatenate[str, str | None, tuple[str, ...], P], Unknown],
    name: tree.Name,
    candidates: Iterable[str],
    *values: P.args,
    **named: P.kwargs,
) -> Diagnostic:
    """`name` is none of the candidates; `values` are the further fields of the problem."""
    pool = tuple(sorted(set(candidates)))
    found = problem(name.text, None, pool, *values, **named)
    if found.certain is not None:
        return Diagnostic(found, name.span)
    return Diagnostic(found.but(close=closest(name.text, pool)), name.span, fix=surely(name.text, pool))


def declared_twice(what: str, name: tree.Name, first: Span) -> Diagnostic:
    """`name` has a declaration already, at `first`."""
    return Diagnostic(DeclaredTwice(what, name.text), name.span, (Related(first, "first declared here"),))


def unknown_performative(name: tree.Name) -> Diagnostic:
    """E512."""
    return unknown(NoPerformative, name, PERFORMATIVES)
