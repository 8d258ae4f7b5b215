"""Schedule: moments for the moves of one run, such that each is made when it may be made."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from aseme_dsl.proofs.explore.search import Step
from aseme_dsl.proofs.timed.stamp import Window


def moments(
    steps: Sequence[Step], gap: int, further: Mapping[int, Sequence[Window]], margin: int = 0
) -> tuple[int, ...] | None:
    """When each move is made (ns after the start), as early as possible; two are `gap` ns apart at the least.

    Moves have `further` windows, too, by their origins. What is due comes `margin` ns after the moves before
    it, at the least. None if there are no such moments.
    """
    places = {0: 0, **{step.origin: number for number, step in enumerate(steps, 1)}}
    is_begun = bool(steps) and Window(0, 0, 0) in steps[0].windows  # it begins the run
    after = [(number, number + 1, 0 if is_begun and not number else gap) for number in range(len(steps))]
    """Move, later move, and the time between them at the least."""
    for number, step in enumerate(steps, 1):
        for item in (*step.windows, *further.get(step.origin, ())):
            since = places.get(item.origin)
            if since is None:
                continue
            after.append((since, number, item.low))
            if item.high is not None:
                own = margin if _is_before(item, step.windows) else 0
                after.append((number, since, own - item.high))
    found = [0] * (len(steps) + 1)
    for _ in range(len(found) + 1):
        is_done = True
        for since, number, least in after:
            if found[number] < found[since] + least:
                found[number] = found[since] + least
                is_done = False
        if is_done:
            return None if found[0] else tuple(found[1:])
    return None


def _is_before(item: Window, windows: Sequence[Window]) -> bool:
    """Whether a move is made before a window ends, and not since it does."""
    return (
        not item.low
        and bool(item.high)
        and not any(other.low and (other.origin, other.high) == (item.origin, item.high) for other in windows)
    )


__all__ = ["moments"]
