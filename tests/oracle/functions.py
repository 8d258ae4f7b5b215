"""Python functions that the random texts declare: pure, and some of them raise."""

from __future__ import annotations

from typing import Any


def even(number: int) -> bool:
    return number % 2 == 0


def shy(number: int) -> bool:
    if number == 2:
        raise ValueError("not with 2")
    return number > 2


def inverse(number: float) -> float:
    return 1 / number


def weight(message: Any) -> int:
    return int(message.x) + int(message.inner.y)
