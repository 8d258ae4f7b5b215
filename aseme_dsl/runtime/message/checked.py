"""Checked: what an activity writes into a message has the type that the message's field declares."""

from __future__ import annotations

from collections.abc import Callable
from enum import IntEnum
from functools import cache
from operator import attrgetter
from types import NoneType
from typing import get_args, get_origin

from aseme_dsl.runtime.message.as_json import StandIn, member_types

_Reader = Callable[[object, str], object]
"""Gives the value that a field keeps, from what was given and the field's name in errors."""


def check(message: object) -> None:
    """Hold a new message to the types of its fields.

    What means the same is converted: an integer to a double, a number to its enum constant, a list to a
    tuple, numpy's numbers and arrays to Python's.

    Raises:
        TypeError: A field has a value of another type.
        ValueError: An enum field has a number without a constant.
    """
    kind: type = type(message)
    values_of, types, fields = _rules(kind)
    values = values_of(message)
    if (*map(type, values),) == types:
        return  # the usual case, in one comparison
    for (name, exact, read), value in zip(fields, values, strict=True):
        if type(value) is not exact:
            object.__setattr__(message, name, read(value, f"{kind.__name__}.{name}"))


_Field = tuple[str, type | None, _Reader]
"""A field's name, the type whose values stay as they are (None: none), and how others are read."""


@cache
def _rules(
    kind: type,
) -> tuple[Callable[[object], tuple[object, ...]], tuple[type | None, ...], tuple[_Field, ...]]:
    """What gives the values of a message's fields, their types, and the fields."""
    fields = tuple((name, *_rule(hint)) for name, hint in member_types(kind).items())
    names = [name for name, _, _ in fields]
    values_of = attrgetter(*names) if len(names) > 1 else lambda message: (getattr(message, names[0]),)
    return values_of, tuple(exact for _, exact, _ in fields), fields


def _rule(hint: object) -> tuple[type | None, _Reader]:
    arms = get_args(hint)
    if get_origin(hint) is tuple:
        return None, _list_of(*_rule(arms[0]))
    if arms:
        exact, read = _rule(next(arm for arm in arms if arm is not NoneType))
        return exact, _optional(read)
    assert isinstance(hint, type)
    return hint, _one_of(hint)


def _optional(read: _Reader) -> _Reader:
    return lambda value, where: None if value is None else read(value, where)


def _list_of(exact: type | None, read: _Reader) -> _Reader:
    def items(value: object, where: str) -> object:
        value = _python(value)
        if not isinstance(value, (list, tuple)):
            raise _misfit(where, "a tuple", value)
        if type(value) is tuple and all(type(item) is exact for item in value):
            return value
        return tuple(
            item if type(item) is exact else read(item, f"{where}[{number}]")
            for number, item in enumerate(value)
        )

    return items


def _one_of(kind: type) -> _Reader:
    """How a value that is not exactly of this type becomes one."""
    if issubclass(kind, IntEnum):
        return lambda value, where: _constant(kind, value, where)
    make: Callable[[object], object] = kind
    wanted, bases = _WANTED.get(kind, (f"a {kind.__name__}", ()))

    def read(value: object, where: str) -> object:
        if issubclass(type(value), StandIn):
            return value
        value = _python(value)
        if isinstance(value, bases) and (kind is bool or not isinstance(value, bool)):
            try:
                return make(value)
            except OverflowError:
                pass  # an integer that no double can hold
        raise _misfit(where, wanted, value)

    return read


_WANTED: dict[type, tuple[str, tuple[type, ...]]] = {
    bool: ("True or False", (bool,)),
    int: ("an int", (int,)),
    float: ("a number", (float, int)),
    str: ("a str", (str,)),
    bytes: ("bytes", (bytes, bytearray, memoryview)),
}
"""What an error calls each type, and the types that are converted to it."""


def _constant(kind: type[IntEnum], value: object, where: str) -> IntEnum:
    value = _python(value)
    if isinstance(value, int) and not isinstance(value, (bool, IntEnum)):
        try:
            return kind(value)
        except ValueError:
            raise ValueError(f"{where}: {kind.__name__} has no constant with the number {value}") from None
    raise _misfit(where, f"one of {', '.join(kind.__members__)} of {kind.__name__}", value)


def _python(value: object) -> object:
    """A number or an array of numpy, which need not be installed, as Python's own."""
    convert = getattr(value, "tolist", None)
    return convert() if callable(convert) else value


def _misfit(where: str, wanted: str, value: object) -> TypeError:
    return TypeError(f"{where}: {wanted} is wanted, not {value!r}")
