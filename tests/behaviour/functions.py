"""Python functions that the texts of the suite declare."""

from __future__ import annotations

from typing import Any


def even(number: int) -> bool:
    return number % 2 == 0


def inverse(number: int) -> float:
    return 1 / number


def far(message: Any) -> bool:
    return bool(message.x > 10)


def fails(number: int) -> bool:
    raise ValueError(f"never call me with {number}")
