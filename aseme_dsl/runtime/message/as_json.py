"""Messages as JSON and back, the way Protocol Buffers spell them: enums by name, bytes in base64."""

# msgspec writes enums as numbers and not-a-number as null, and passes over unknown members. Robots import
# only the standard library and protobuf.

from __future__ import annotations

import base64
import math
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from enum import IntEnum
from functools import cache
from types import NoneType, UnionType
from typing import TypeVar, Union, cast, get_args, get_origin, get_type_hints, overload

_T = TypeVar("_T")

_WORDS = {"NaN": math.nan, "Infinity": math.inf, "-Infinity": -math.inf}


class StandIn:
    """A number that stands for others of its type, where a team is explored: it stays as it is."""

    __slots__ = ()


def to_json(value: object) -> object:
    """A value of a message as what `json` can write. Raises TypeError for what no message contains."""
    if type(value) is float:
        if math.isfinite(value):
            return value
        return "NaN" if value != value else ("Infinity" if value > 0 else "-Infinity")
    kind: type = type(value)
    if kind is bool or kind is int or kind is str or value is None:
        return value
    if hasattr(kind, "__dataclass_fields__"):
        return {name: to_json(getattr(value, name)) for name in _names(kind)}
    if isinstance(value, IntEnum):
        return value.name
    if issubclass(kind, StandIn):
        return value
    if isinstance(value, (tuple, list)):
        return [to_json(item) for item in value]
    if isinstance(value, (bytes, bytearray)):
        return base64.b64encode(value).decode("ascii")
    if isinstance(value, (bool, int, float, str)):
        return to_json(kind.__mro__[1](value))
    raise TypeError(f"a message does not contain a {kind.__name__}: {value!r}")


@overload
def from_json(kind: type[_T], data: object) -> _T: ...
@overload
def from_json(kind: object, data: object) -> object: ...
def from_json(kind: object, data: object) -> object:
    """The value of type `kind` that `to_json` wrote as `data`; members not given have their defaults.

    Raises:
        ValueError: `data` does not fit; it says which member.
    """
    try:
        return _reader(kind)(data)
    except (ValueError, TypeError, LookupError, ArithmeticError):
        return _read(kind, data, "")  # which says what is wrong, and where


@cache
def _reader(kind: object) -> Callable[[object], object]:
    """What reads values of a type that fit, four times as fast as `_read`; it raises something for others."""
    origin = get_origin(kind)
    if origin in (Union, UnionType):
        there = _reader(next(arm for arm in get_args(kind) if arm is not NoneType))
        return lambda data: None if data is None else there(data)
    if origin in (tuple, list):
        item = _reader(get_args(kind)[0])
        return lambda data: tuple([item(value) for value in _of(list, data)])
    if is_dataclass(kind) and isinstance(kind, type):
        return _message_reader(kind)
    if isinstance(kind, type) and issubclass(kind, IntEnum):
        members = kind.__members__
        return lambda data: members[_of(str, data)]
    if kind is float:
        return lambda data: data if type(data) is float else float(_of(int, data))
    if kind in (bool, int, str):
        plain = cast("type[object]", kind)
        return lambda data: _of(plain, data)
    return lambda data: _read(kind, data, "")


def _message_reader(kind: type) -> Callable[[object], object]:
    readers: dict[str, Callable[[object], object]] = {}

    def read(data: object) -> object:
        if not readers:  # not before: a message may have a list of its own kind in it
            readers.update({name: _reader(item) for name, item in member_types(kind).items()})
        return kind(**{name: readers[name](value) for name, value in _of(dict, data).items()})

    return read


def _of(kind: type[_T], data: object) -> _T:
    """The data, if they are of exactly this type. Raises TypeError."""
    if type(data) is not kind:
        raise TypeError
    return data


@cache
def _names(kind: type) -> tuple[str, ...]:
    return tuple(item.name for item in fields(kind))


@cache
def member_types(kind: type[object]) -> dict[str, object]:
    """The types of a message's members."""
    hints = get_type_hints(kind)
    return {item.name: hints[item.name] for item in fields(cast(type, kind))}


def _read(kind: object, data: object, place: str) -> object:
    origin = get_origin(kind)
    if origin in (Union, UnionType):
        if data is None:
            return None
        return _read(next(arm for arm in get_args(kind) if arm is not NoneType), data, place)
    if origin in (tuple, list):
        if not isinstance(data, list):
            raise _misfit(place, "a list", data)
        item = get_args(kind)[0]
        return tuple(_read(item, value, f"{place}[{number}]") for number, value in enumerate(data))
    if is_dataclass(kind) and isinstance(kind, type):
        return _read_message(kind, data, place)
    if isinstance(kind, type) and issubclass(kind, IntEnum):
        return _read_enum(kind, data, place)
    if kind is bool and isinstance(data, bool):
        return data
    if kind is int and isinstance(data, int) and not isinstance(data, bool):
        return data
    if kind is float and isinstance(data, (int, float)) and not isinstance(data, bool):
        try:
            return float(data)
        except OverflowError as error:
            raise _misfit(place, "a number", "one that is too large") from error
    if kind is float and isinstance(data, str) and data in _WORDS:
        return _WORDS[data]
    if kind is str and isinstance(data, str):
        return data
    if kind is bytes and isinstance(data, str):
        try:
            return base64.b64decode(data, validate=True)
        except ValueError as error:
            raise _misfit(place, "bytes in base64", data) from error
    raise _misfit(place, f"a {getattr(kind, '__name__', kind)}", data)


def _read_message(kind: type, data: object, place: str) -> object:
    if not isinstance(data, dict):
        raise _misfit(place, f"a {kind.__name__}", data)
    types = member_types(kind)
    strangers = [name for name in data if name not in types]
    if strangers:
        known = ", ".join(types) or "none"
        raise ValueError(f"{place or kind.__name__} has no member {strangers[0]}; it has {known}")
    inside = place + "." if place else ""
    return kind(**{name: _read(types[name], value, inside + name) for name, value in data.items()})


def _read_enum(kind: type[IntEnum], data: object, place: str) -> IntEnum:
    if isinstance(data, str):
        name = data.removeprefix(kind.__name__ + ".")
        if name in kind.__members__:
            return kind[name]
    elif isinstance(data, int) and not isinstance(data, bool):
        try:
            return kind(data)
        except ValueError:
            pass
    raise _misfit(place, f"one of {', '.join(kind.__members__)}", data)


def only_known(kind: object, data: object) -> object:
    """JSON of another build without the members that a type does not have.

    A constant that it does not have is left out where it is optional.
    """
    arms = get_args(kind)
    if get_origin(kind) in (Union, UnionType):
        inner = next(arm for arm in arms if arm is not NoneType)
        if isinstance(inner, type) and issubclass(inner, IntEnum) and data not in inner.__members__:
            return None
        return only_known(inner, data)
    if get_origin(kind) in (tuple, list) and isinstance(data, list):
        return [only_known(arms[0], item) for item in data]
    if is_dataclass(kind) and isinstance(kind, type) and isinstance(data, dict):
        types = member_types(kind)
        return {name: only_known(types[name], value) for name, value in data.items() if name in types}
    return data


def _misfit(place: str, wanted: str, data: object) -> ValueError:
    return ValueError(f"{place + ': ' if place else ''}{wanted} is wanted, not {data!r}")
