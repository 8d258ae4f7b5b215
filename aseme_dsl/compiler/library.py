"""Library: which file of the standard library declares a name, for the hint that it is not imported."""

from __future__ import annotations

import re
from functools import cache

from aseme_dsl.standard_library import standard_library

_DECLARED = re.compile(r"^(?:enum|message|topic|function|let|aip)\s+(\w+)", re.MULTILINE)


def providers(name: str) -> str | None:
    """``"`import soccer` declares it"``, or None."""
    found = _declared().get(name)
    if not found:
        return None
    return " or ".join(f"`import {item}`" for item in found) + " declares it"


@cache
def _declared() -> dict[str, tuple[str, ...]]:
    found: dict[str, tuple[str, ...]] = {}
    for path in sorted(standard_library().glob("*.aseme")):
        for name in _DECLARED.findall(path.read_text("utf-8")):
            if path.stem not in found.get(name, ()):
                found[name] = (*found.get(name, ()), path.stem)
    return found


def declared_by(library: str) -> frozenset[str]:
    """The names that a file of the standard library declares; none if there is no such file."""
    return frozenset(name for name, files in _declared().items() if library in files)
