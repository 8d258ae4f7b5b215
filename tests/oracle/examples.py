"""Examples of random charts: which ones are looked at, and one that fails made as simple as possible."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Callable, Iterable

import pytest

from tests.oracle.choices import Choices, simplest
from tests.support.generated import Generated

FIRST = int(os.environ.get("ORACLE_FIRST", "0"))

ROUNDS = 60
"""The bound of a step here: charts that do not settle are many, and a thousand rounds of them are slow."""

ATTEMPTS = 300

Play = Callable[[Choices], Iterable[object]]
"""Plays what decisions say, and gives something for each game."""


def how_many(usual: int) -> int:
    """How many examples are looked at: as many as usual, or as the environment says."""
    return int(os.environ.get("ORACLE_EXAMPLES", str(usual)))


def agree(play: Play, examples: int, group: int, groups: int) -> int:
    """Play the examples of a group; how many games there were.

    The test fails with the first example in which something goes wrong, made as simple as possible.
    """
    games = 0
    for seed in range(FIRST + group, FIRST + examples, groups):
        choices = Choices(seed)
        try:
            games += sum(1 for _ in play(choices))
        except Exception as error:
            kind = type(error)

            def fails(made: list[int], kind: type[Exception] = kind) -> bool:
                found = _difference(play, made)
                return found is not None and found.startswith(kind.__name__)

            made = simplest(choices.made, fails, ATTEMPTS)
            pytest.fail(f"example {seed}, made as simple as possible:\n{_difference(play, made)}")
    return games


def _difference(play: Play, made: list[int]) -> str | None:
    """What goes wrong with these decisions, or None."""
    try:
        for _ in play(Choices(replay=made)):
            pass
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    return None


def forget(made: Generated) -> None:
    """Take the package of an example out of memory and off the disk."""
    name = made.package.__name__
    for module in [module for module in sys.modules if module == name or module.startswith(name + ".")]:
        del sys.modules[module]
    shutil.rmtree(made.folder)
