"""Unread messages: their content is decided when it is read, so what nothing reads is never tried."""

from __future__ import annotations

from collections.abc import Callable, Container
from functools import cache
from typing import Any, cast

from aseme_dsl.runtime.message.as_json import member_types

Ask = Callable[[tuple[str, ...], object], object]
"""Gives the member at a path, which is of a type; None for its default."""


class Unread:
    """A message whose content is decided when it is read; beside it stands the class of the message."""

    __slots__ = ()


@cache
def _unread(kind: type) -> type:
    own: dict[str, object] = {"__slots__": ("_ask", "_path", "_root"), "__hash__": object.__hash__}
    own |= {name: property(_reader(name, hint)) for name, hint in member_types(kind).items()}
    own["__repr__"] = own["__str__"] = _named
    return type(f"Unread{kind.__name__}", (Unread, kind), own)


def _named(message: Any) -> str:
    return ".".join((message._root, *message._path))


def _reader(name: str, hint: object) -> Callable[[Any], object]:
    inner = hasattr(hint, "__dataclass_fields__")

    def read(message: Any) -> object:
        path = (*message._path, name)
        if inner:
            return unread(cast(type, hint), message._root, message._ask, path)
        value = message._ask(path, hint)
        return getattr(_kind_of(message)(), name) if value is None else value

    return read


def _kind_of(message: object) -> type[Any]:
    return type(message).__mro__[2]


def unread(kind: type, root: str, ask: Ask, path: tuple[str, ...] = ()) -> object:
    """A message of which nothing is decided yet: that at a path of the message `root`."""
    message: object = object.__new__(_unread(kind))
    for slot, value in (("_ask", ask), ("_root", root), ("_path", path)):
        object.__setattr__(message, slot, value)
    return message


def decided(value: object, known: Container[object]) -> object:
    """A value with messages that are decided: a member whose (root, path) is not `known` has its default."""
    if isinstance(value, tuple):
        return tuple(decided(item, known) for item in value)
    return _decided(value, known) if isinstance(value, Unread) else value


def _decided(message: Any, known: Container[object]) -> object:
    kind: type = _kind_of(message)
    given: dict[str, object] = {}
    for name, hint in member_types(kind).items():
        if hasattr(hint, "__dataclass_fields__"):
            given[name] = decided(getattr(message, name), known)
        elif (message._root, ".".join((*message._path, name))) in known:
            given[name] = getattr(message, name)
    return kind(**given)


__all__ = ["Unread", "decided", "unread"]
