"""Adding: what a text gets at its end for one more scenario."""

from __future__ import annotations

import re

from aseme_dsl.grammar.layout import format_source
from aseme_dsl.source import Source

_TITLE = re.compile(r'scenario "((?:\\.|[^"\\])*)"')
_PIECE = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*|/\*.*?\*/|\s+', re.DOTALL)


def addition(text: str, roles: str, case: str) -> str | None:
    """What a file with a text gets at its end for a counterexample; None if it has that scenario already.

    A title that is in use gets a number. Roles that are there already are not added again.
    """
    there = {found[1] for found in _TITLE.finditer(text)}
    found = _TITLE.match(case)
    assert found is not None
    title, number = found[1], 2
    while title in there:
        if bare(_laid_out(_titled(title, case))) in bare(text):
            return None
        title, number = f"{found[1]} {number}", number + 1
    missing = [line for line in roles.splitlines() if not _declares(text, *line.split()[:2])]
    added = "".join(f"{line}\n" for line in missing) + _titled(title, case)
    between = "\n" if text.endswith("\n") or not text else "\n\n"
    return between + _laid_out(added)


def titled_apart(text: str, case: str) -> str:
    """A scenario with a title that none in a text has: a number is added if it is in use."""
    there = {found[1] for found in _TITLE.finditer(text)}
    found = _TITLE.match(case)
    assert found is not None
    title, number = found[1], 2
    while title in there:
        title, number = f"{found[1]} {number}", number + 1
    return _titled(title, case)


def _declares(text: str, word: str, name: str) -> bool:
    return re.search(rf"\b{word}\s+{re.escape(name)}\b", text) is not None


def _titled(title: str, case: str) -> str:
    """A scenario with another title."""
    return _TITLE.sub(lambda _: f'scenario "{title}"', case, count=1)


def _laid_out(text: str) -> str:
    return format_source(Source("case.aseme", text)).text


def bare(text: str) -> str:
    """A text without comments, in one line."""
    return _PIECE.sub(lambda found: found[0] if found[0].startswith('"') else " ", text).strip()


__all__ = ["addition", "bare", "titled_apart"]
