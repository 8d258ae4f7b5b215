"""Library: which file of the standard library declares a name, for the hint that it is not imported."""

from __future__ import annotations

import re
from functools import cache

from aseme_dsl.source import Source, is_library_path
from aseme_dsl.standard_library import standard_library

_DECLARED = re.compile(r"^(enum|message|topic|function|let|aip)\s+(\w+)(\s*\{[^}]*|[^\n]*)", re.MULTILINE)


def providers(name: str, *kinds: str, carrying: str | None = None) -> tuple[str, ...]:
    """The files of the standard library that declare `name`, as an import calls them.

    Only what is declared as one of `kinds`, if any are given, counts; of topics, with `carrying` only those
    that carry that message.
    """
    found: list[str] = []
    for kind, library, rest in _declared().get(name, ()):
        fits = not kinds or kind in kinds
        carries = carrying is None or kind != "topic" or re.search(rf"\b{re.escape(carrying)}\b", rest)
        if fits and carries and library not in found:
            found.append(library)
    return tuple(found)


@cache
def _declared() -> dict[str, tuple[tuple[str, str, str], ...]]:
    """Of each name: what it is declared as, in which file, and the rest of the line."""
    found: dict[str, tuple[tuple[str, str, str], ...]] = {}
    for path in sorted(standard_library().glob("*.aseme")):
        for kind, name, rest in _DECLARED.findall(path.read_text("utf-8")):
            found[name] = (*found.get(name, ()), (kind, path.stem, rest))
    return found


def is_of_library(source: Source) -> bool:
    """Whether a text is that of a file of the standard library, wherever that is, or a part of it."""
    if is_library_path(source.path):
        return True
    name = source.path.replace("\\", "/").rpartition("/")[2]
    return name in _files() and source.text == _text_of(name)


@cache
def _files() -> frozenset[str]:
    return frozenset(path.name for path in standard_library().glob("*.aseme"))


@cache
def _text_of(name: str) -> str:
    return (standard_library() / name).read_text("utf-8")


def declared_by(library: str) -> frozenset[str]:
    """The names that a file of the standard library declares; none if there is no such file."""
    return frozenset(
        name for name, files in _declared().items() if any(library == item for _, item, _ in files)
    )
