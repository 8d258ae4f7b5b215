"""Lanes: most tests run always; what takes long runs in the second lane only, `python3 dev.py long`."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable
from typing import Any

import pytest

IS_LONG = "LONG_TESTS" in os.environ
"""Whether this is the second lane."""


def kept(items: Iterable[Any], is_kept: Callable[[Any], object]) -> list[Any]:
    """Parameters of a test, of which those that are not kept are tried in the second lane only.

    The items of a test with several parameters are tuples.
    """
    return [_tried(item if isinstance(item, tuple) else (item,), is_kept(item)) for item in items]


def alternating(some: Iterable[Any], others: Collection[Any]) -> list[Any]:
    """Each of some with each of the others: every other pair, as on a chessboard, is always tried."""
    return [
        _tried((one, other), (row + column) % 2 == 0)
        for row, one in enumerate(some)
        for column, other in enumerate(others)
    ]


def _tried(values: tuple[Any, ...], always: object) -> Any:
    return pytest.param(*values, marks=() if always else pytest.mark.long)


__all__ = ["IS_LONG", "alternating", "kept"]
