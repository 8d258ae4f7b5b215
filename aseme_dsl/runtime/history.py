"""Histories: what the kept messages of a data channel, oldest first, say of a moment or a span of time."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from operator import add
from typing import Any

from aseme_dsl.runtime.inputs import Arrived


def at(items: Sequence[Arrived], moment: int) -> Arrived | None:
    """The newest that was measured by then, or None."""
    return next((item for item in reversed(items) if item.time <= moment), None)


def since(items: Sequence[Arrived], moment: int) -> tuple[Arrived, ...]:
    """What was measured at that moment or later."""
    return tuple(item for item in items if item.time >= moment)


def mean(items: Sequence[Arrived], moment: int, member: str) -> float | None:
    """The mean of a member (`pose.x`) over what was measured since then, or None.

    A message in which the member is absent does not count.
    """
    path = member.split(".")
    found = (value_of(item.message, path) for item in items if item.time >= moment)
    values = [value for value in found if value is not None]
    # `sum` adds floats differently from one version of Python to another
    return reduce(add, values) / len(values) if values else None


def interpolated(items: Sequence[Arrived], moment: int, member: str) -> float | None:
    """A member (`pose.x`) at a moment, on the straight line between the measurements before and after.

    None before the first and after the last measurement in which the member is there. Raises TypeError for a
    member that is no number.
    """
    path = member.split(".")
    before: tuple[int, float] | None = None
    for item in items:
        value = value_of(item.message, path)
        if value is None:
            continue
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise TypeError(f"{member} is no number: {value!r}")
        if item.time == moment:
            return value
        if item.time > moment:
            if before is None:
                return None
            share = (moment - before[0]) / (item.time - before[0])
            return before[1] + share * (value - before[1])
        before = (item.time, value)
    return None


def value_of(message: Any, path: Sequence[str]) -> Any:
    """A member of a member …, or None where one on the way is absent."""
    for step in path:
        if message is None:
            return None
        message = getattr(message, step)
    return message
