"""The one random distribution on the field: a bell curve that is the same on every Python."""

from __future__ import annotations

import random

_SQRT_3 = 1.7320508075688772
BOUND = 2 * _SQRT_3
"""No value of :func:`bell` is further from 0 than this."""


def bell(chance: random.Random) -> float:
    """A number with mean 0 and standard deviation 1, nearly normal and never beyond ±3.47.

    The sum of four uniform numbers. ``random.gauss`` would go through logarithms, whose last bit depends on
    the machine, and its method may change with the Python version; ``random.random`` promises neither will.
    """
    uniform = chance.random
    return (uniform() + uniform() + uniform() + uniform() - 2.0) * _SQRT_3
