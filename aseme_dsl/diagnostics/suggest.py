"""Did-you-mean: the declared name that is closest to a misspelt one."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import islice

_CLOSE = 0.65
"""How much of two names must agree for one to be taken for the other, from 0 to 1."""
_CLEARLY = 0.1
"""By how much more a candidate must agree than every other one to be the only answer."""
_MANY = 200
"""With more candidates than this, only those that begin or end like the name are compared with it."""


def closest(name: str, candidates: Iterable[str]) -> str | None:
    """The candidate most like `name` (case and underscores count little), or None if none is close."""
    pool = sorted(set(candidates))
    if not pool:
        return None
    from difflib import get_close_matches

    folded: dict[str, str] = {}
    for candidate in pool:
        folded.setdefault(_folded(candidate), candidate)
    exact = folded.get(_folded(name))
    if exact is not None and exact != name:
        return exact
    wanted = _folded(name)
    if len(folded) > _MANY:
        # Comparing is slow, and a large file may have many wrong names: look only where a typing error is
        # likely.
        likely = (item for item in folded if item[:2] == wanted[:2] or item[-2:] == wanted[-2:])
        folded = {item: folded[item] for item in islice(likely, _MANY)}
    matches = get_close_matches(wanted, folded, n=1, cutoff=_CLOSE)
    return folded[matches[0]] if matches else None


def surely(name: str, candidates: Iterable[str]) -> str | None:
    """The closest candidate if no other one is about as close: what may be put in place of `name`."""
    from difflib import SequenceMatcher, get_close_matches

    pool = set(candidates)
    near = closest(name, pool)
    if near is None:
        return None
    wanted, best = _folded(name), _folded(near)
    if wanted == best:
        return near if sum(_folded(other) == wanted for other in pool) == 1 else None
    least = SequenceMatcher(None, best, wanted).ratio() - _CLEARLY
    others = {folded for other in pool if (folded := _folded(other)) != best}
    return None if get_close_matches(wanted, others, n=1, cutoff=max(least, _CLOSE)) else near


def _folded(name: str) -> str:
    return name.replace("_", "").lower()
