"""Bounds: what a bounded variable refuses to hold."""

from __future__ import annotations

from collections.abc import Sized

from aseme_dsl.runtime.chart.plan import Variable


class OutOfBounds(ValueError):
    """A number that a variable cannot hold."""


def check(name: str, least: float, most: float, value: object) -> None:
    """Raises OutOfBounds for a number that is not between the two."""
    if not (isinstance(value, int | float) and least <= value <= most):
        raise OutOfBounds(f"variable {name.partition('@')[0]} of {least}..{most} cannot be {value!r}")


def check_length(name: str, length: int, items: Sized) -> None:
    """Raises OutOfBounds for a list that is too long."""
    if len(items) > length:
        own = name.partition("@")[0]
        raise OutOfBounds(f"list {own} of at most {length} elements cannot have {len(items)}")


def check_place(name: str, items: Sized, place: int) -> None:
    """Raises OutOfBounds for an element that a list does not have."""
    if not 0 <= place < len(items):
        own = name.partition("@")[0]
        raise OutOfBounds(f"list {own} of {len(items)} elements has no element {place}")


def check_variable(variable: Variable, value: object) -> None:
    """Raises OutOfBounds where a variable has bounds that the value is not within."""
    if variable.bounds is not None:
        check(variable.name, *variable.bounds, value)
    if variable.length is not None and isinstance(value, list | tuple):
        check_length(variable.name, variable.length, value)


def admits(variable: Variable, value: object) -> bool:
    """Whether a variable may hold a value of its type."""
    try:
        check_variable(variable, value)
    except OutOfBounds:
        return False
    return True
