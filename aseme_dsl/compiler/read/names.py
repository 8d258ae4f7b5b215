"""Names: the diagnostics about names that every phase gives in the same words."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from aseme_dsl.compiler.read.builtins import PERFORMATIVES
from aseme_dsl.diagnostics import Diagnostic, Related, closest, surely
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span


def unknown(
    code: str,
    what: str,
    name: tree.Name,
    candidates: Iterable[str],
    hint: str | None = None,
    *,
    certain: str | None = None,
) -> Diagnostic:
    """`name` is not declared; a declared one that is close is offered, else `hint`, else all.

    `certain` is a hint that is better than any name that is close.
    """
    if certain is not None:
        return Diagnostic(code, f"{what} `{name.text}`", name.span, hint=certain)
    pool = sorted(set(candidates))
    near = closest(name.text, pool)
    if near:
        hint = f"did you mean `{near}`?"
    elif hint is None and 0 < len(pool) <= 8:
        hint = "there " + ("is " if len(pool) == 1 else "are ") + listed(pool)
    return Diagnostic(code, f"{what} `{name.text}`", name.span, hint=hint, fix=surely(name.text, pool))


def declared_twice(what: str, name: tree.Name, first: Span) -> Diagnostic:
    """`name` has a declaration already, at `first`."""
    return Diagnostic(
        "E201",
        f"{what} `{name.text}` is declared twice",
        name.span,
        (Related(first, "first declared here"),),
        hint="rename one of them, or remove it",
    )


def unknown_performative(name: tree.Name) -> Diagnostic:
    """E512."""
    return unknown("E512", "FIPA has no performative", name, PERFORMATIVES, f"it has {listed(PERFORMATIVES)}")


def first_of(names: Sequence[str], most: int) -> str:
    """`a`, `b` and `c`; of more than `most` names the first ones, and how many more there are."""
    if len(names) <= most:
        return listed(names)
    return ", ".join(f"`{name}`" for name in names[:most]) + f" and {len(names) - most} more"


def listed(names: Iterable[str], word: str = "and") -> str:
    """`a`, `b` and `c`."""
    shown = [f"`{name}`" for name in names]
    return " ".join([", ".join(shown[:-1]), word, shown[-1]]) if len(shown) > 1 else "".join(shown)
