"""Math: the functions of `import math`. Angles are in degrees."""

from __future__ import annotations

import math
from typing import TypeVar

Number = TypeVar("Number", int, float)


def floor(number: float) -> int:
    """The largest whole number that is not larger."""
    return math.floor(number)


def ceil(number: float) -> int:
    """The smallest whole number that is not smaller."""
    return math.ceil(number)


def round(number: float) -> int:
    """The nearest whole number; a half goes away from zero, other than in Python."""
    whole = math.trunc(number)
    return whole + sign(number) if abs(number - whole) >= 0.5 else whole


def sign(number: float) -> int:
    """-1, 0 or 1."""
    return (number > 0) - (number < 0)


def sqrt(number: float) -> float:
    """Raises ValueError for a negative number."""
    return math.sqrt(number)


def power(base: float, exponent: float) -> float:
    """Raises ValueError where the result is not a real number, OverflowError where it is too large."""
    return math.pow(base, exponent)


def hypot(x: float, y: float) -> float:
    """The length of a way of x to one side and y to the other."""
    return math.hypot(x, y)


def clamp(number: Number, least: Number, most: Number) -> Number:
    """`number`, but not less than `least` and not more than `most`."""
    return max(least, min(most, number))


def sin(angle: float) -> float:
    """The sine of an angle."""
    return math.sin(math.radians(angle))


def cos(angle: float) -> float:
    """The cosine of an angle."""
    return math.cos(math.radians(angle))


def tan(angle: float) -> float:
    """The tangent of an angle."""
    return math.tan(math.radians(angle))


def atan2(y: float, x: float) -> float:
    """The direction of the point (x, y)."""
    return math.degrees(math.atan2(y, x))


def turned(angle: float) -> float:
    """The same direction as a number above -180 and up to 180."""
    return 180.0 - (180.0 - angle) % 360.0


def turn_from(one: float, to: float) -> float:
    """How far it is to turn from one direction to another, left positive."""
    return turned(to - one)


def radians(angle: float) -> float:
    """An angle as its arc."""
    return math.radians(angle)


def degrees(radians: float) -> float:
    """An angle from its arc."""
    return math.degrees(radians)
