"""Did-you-mean: the declared name that is closest to a misspelt one."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches
from itertools import islice

_MANY = 200
"""With more candidates than this, only those that begin or end like the name are compared with it."""


def closest(name: str, candidates: Iterable[str]) -> str | None:
    """The candidate most like `name` (case and underscores count little), or None if none is close."""
    pool = sorted(set(candidates))
    folded: dict[str, str] = {}
    for candidate in pool:
        folded.setdefault(candidate.replace("_", "").lower(), candidate)
    exact = folded.get(name.replace("_", "").lower())
    if exact is not None and exact != name:
        return exact
    wanted = name.replace("_", "").lower()
    if len(folded) > _MANY:
        # Comparing is slow, and a large file may have many wrong names: look only where a slip is likely.
        likely = (item for item in folded if item[:2] == wanted[:2] or item[-2:] == wanted[-2:])
        folded = {item: folded[item] for item in islice(likely, _MANY)}
    matches = get_close_matches(wanted, folded, n=1, cutoff=0.65)
    return folded[matches[0]] if matches else None
