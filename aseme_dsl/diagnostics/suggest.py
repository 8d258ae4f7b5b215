"""Did-you-mean: the declared name that is closest to a misspelt one."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches


def closest(name: str, candidates: Iterable[str]) -> str | None:
    """The candidate most like `name` (case and underscores count little), or None if none is close."""
    pool = sorted(set(candidates))
    folded: dict[str, str] = {}
    for candidate in pool:
        folded.setdefault(candidate.replace("_", "").lower(), candidate)
    exact = folded.get(name.replace("_", "").lower())
    if exact is not None and exact != name:
        return exact
    matches = get_close_matches(name.replace("_", "").lower(), folded, n=1, cutoff=0.65)
    return folded[matches[0]] if matches else None
