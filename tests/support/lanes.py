"""Lanes: most tests run always; what takes long runs in the second lane only, `python3 dev.py long`."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from typing import Any

import pytest

IS_LONG = "LONG_TESTS" in os.environ
"""Whether this is the second lane."""


def kept(items: Iterable[Any], is_kept: Callable[[Any], object]) -> list[Any]:
    """Parameters of a test, of which those that are not kept are tried in the second lane only.

    The items of a test with several parameters are tuples.
    """
    return [
        pytest.param(
            *(item if isinstance(item, tuple) else (item,)), marks=() if is_kept(item) else pytest.mark.long
        )
        for item in items
    ]


def alternating(some: Iterable[Any], others: Iterable[Any]) -> list[Any]:
    """Each of some with each of the others: every other pair, as on a chessboard, is always tried."""
    pairs = [((i + j) % 2, (one, other)) for i, one in enumerate(some) for j, other in enumerate(others)]
    return [
        *kept((pair for colour, pair in pairs if colour == 0), lambda pair: True),
        *kept((pair for colour, pair in pairs if colour == 1), lambda pair: False),
    ]


__all__ = ["IS_LONG", "alternating", "kept"]
