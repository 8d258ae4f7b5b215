"""Tries: which ways of a move were tried."""

from __future__ import annotations

from collections.abc import Callable, Sequence


class Tries:
    """The ways on which a move was made, by the decisions on them."""

    __slots__ = ("_behind", "_over", "is_over")

    def __init__(self) -> None:
        self._behind: dict[int, Tries] = {}
        """What was tried behind each answer of the first decision."""
        self._over: set[int] = set()
        """The answers behind which there is nothing new."""
        self.is_over = False
        """Whether all ways were tried."""

    @property
    def has_begun(self) -> bool:
        """Whether any way was tried."""
        return bool(self.is_over or self._over or self._behind)

    def next(self, before: Sequence[int], width: int, draw: Callable[[int], int]) -> int:
        """One of so many answers to the decision behind those `before`; a new way, if there is one."""
        here = self
        for answer in before:
            here = here._behind.setdefault(answer, Tries())
        free = [answer for answer in range(width) if answer not in here._over]
        return free[draw(len(free))] if free else draw(width)

    def add(self, way: Sequence[int], widths: Sequence[int]) -> None:
        """The move was made on a way; so many answers there were to each of its decisions."""
        path = [self]
        for answer in way:
            path.append(path[-1]._behind.setdefault(answer, Tries()))
        path[-1].is_over = True
        for place in reversed(range(len(way))):
            here, answer = path[place], way[place]
            if not path[place + 1].is_over:
                break
            here._over.add(answer)
            here._behind.pop(answer, None)
            here.is_over = len(here._over) == widths[place]


__all__ = ["Tries"]
