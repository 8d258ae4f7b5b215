"""Objects whose fields come by name, from something that was read."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

_T = TypeVar("_T")


def made(kind: type[_T], /, *values: object, **fields: object) -> _T:
    """An object of a class. What gives the fields has checked them: a type checker cannot."""
    make: Callable[..., _T] = kind
    return make(*values, **fields)
