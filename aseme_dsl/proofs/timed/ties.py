"""Ties: moments for the moves of a run that was found without times; some of them are tied to each other."""

from __future__ import annotations

from collections.abc import Sequence

from aseme_dsl.records import dataclass

_GAPS = (10**9, 10**8, 10**7, 10**6, 10**3)
"""So long, or as long as is possible, two moves are apart (ns)."""


@dataclass(frozen=True, slots=True)
class Tie:
    """Move `later` is from `least` to `most` ns behind move `earlier`; before that is over if it `is_less`.

    Where `most` is None, there is no end.
    """

    later: int
    earlier: int
    least: int
    most: int | None = None
    is_less: bool = False


def just(later: int, earlier: int, duration: int) -> Tie:
    """One move is just so long behind another one."""
    return Tie(later, earlier, duration, duration)


def before(later: int, earlier: int, duration: int) -> Tie:
    """One move is made before so much has passed since another one."""
    return Tie(later, earlier, 0, duration, is_less=True)


def found_for(count: int, ties: Sequence[Tie]) -> tuple[int, ...] | None:
    """The earliest moments of moves; None if there are none."""
    for gap in _GAPS:
        found = _solved(count, ties, gap)
        if found is not None:
            return found
    # What is due may change nothing when it comes: then it may come before.
    needed = [tie for tie in ties if not tie.is_less]
    if _solved(count, needed, _GAPS[-1]) is None:
        return None
    for tie in dict.fromkeys(tie for tie in ties if tie.is_less):
        if _solved(count, [*needed, tie], _GAPS[-1]) is not None:
            needed.append(tie)
    return next(found for gap in _GAPS if (found := _solved(count, needed, gap)) is not None)


def _solved(count: int, ties: Sequence[Tie], gap: int) -> tuple[int, ...] | None:
    """Longest ways in the graph of what is at least so much later than what."""
    fixed = {tie.later for tie in ties if tie.least == tie.most}
    if just(1, 0, 0) in ties:
        fixed.add(0)
    edges = [  # two that are due may be due at the same moment
        (number - 1, number, 0 if {number - 1, number} <= fixed else gap) for number in range(1, count + 1)
    ]
    for tie in ties:
        if tie.least:
            edges.append((tie.earlier, tie.later, tie.least))
        if tie.most is not None:
            edges.append((tie.later, tie.earlier, (gap if tie.is_less else 0) - tie.most))
    moments = [0] * (count + 1)
    for _ in range(count + 2):
        changed = False
        for source, target, least in edges:
            if moments[source] + least > moments[target]:
                moments[target] = moments[source] + least
                changed = True
        if not changed:
            return None if moments[0] else tuple(moments[1:])
    return None


__all__ = ["Tie", "before", "found_for", "just"]
