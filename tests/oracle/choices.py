"""Random decisions that are written down, so that a failing example can be repeated and made simpler."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from random import Random
from typing import TypeVar

T = TypeVar("T")


class Choices:
    """Decisions by chance, or those of an earlier run again (`replay`); after its end always the first.

    What stands first in a list is what a failing example becomes in the end.
    """

    def __init__(self, seed: int | str = 0, replay: Sequence[int] | None = None) -> None:
        self.seed = seed
        self._random = Random(seed)
        self._replay = replay
        self.made: list[int] = []

    def number(self, least: int, most: int) -> int:
        """A number from `least` to `most`."""
        if self._replay is None:
            choice = self._random.randint(0, most - least)
        else:
            place = len(self.made)
            choice = min(self._replay[place], most - least) if place < len(self._replay) else 0
        self.made.append(choice)
        return least + choice

    def one_of(self, options: Sequence[T]) -> T:
        return options[self.number(0, len(options) - 1)]

    def one_in(self, count: int) -> bool:
        """True once in `count` times."""
        return self.number(0, count - 1) == count - 1

    def weighted(self, **weights: int) -> str:
        """One of the names, as often as its weight says."""
        place = self.number(0, sum(weights.values()) - 1)
        for name, weight in weights.items():
            if place < weight:
                return name
            place -= weight
        raise AssertionError


def simplest(made: Sequence[int], fails: Callable[[list[int]], bool], attempts: int) -> list[int]:
    """Fewer and smaller decisions with which it still fails: parts are left out, numbers made small.

    Gives up after so many attempts that were of no use in a row.
    """
    best = list(made)
    useless = 0

    def better(candidate: list[int]) -> bool:
        nonlocal best, useless
        if candidate == best or useless >= attempts:
            return False
        if fails(candidate):
            best, useless = candidate, 0
            return True
        useless += 1
        return False

    changed = True
    while changed and useless < attempts:
        changed = False
        size = len(best) // 2
        while size:
            place = len(best) - size
            while place >= 0:
                changed |= better(best[:place] + best[place + size :])
                place -= size
            size //= 2
        for place in range(len(best)):
            if place < len(best) and best[place]:
                changed |= better([*best[:place], 0, *best[place + 1 :]])
            if place < len(best) and best[place] > 1:
                changed |= better([*best[:place], best[place] // 2, *best[place + 1 :]])
    return best
