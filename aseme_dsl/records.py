"""`dataclass` as in the standard library, except that a method is compiled when it is first used.

Each start of `asemec` makes hundreds of classes of data, but objects of few of them. The standard library
compiles up to six methods for each class, which took half of the time of `asemec check` of a small file.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import MISSING, FrozenInstanceError, fields
from reprlib import recursive_repr
from types import FunctionType
from typing import TYPE_CHECKING, NoReturn

if TYPE_CHECKING:
    from dataclasses import dataclass  # to type checkers it is the same

    from _typeshed import DataclassInstance
else:

    def dataclass(kind=None, /, *, eq=True, frozen=False, slots=False, unsafe_hash=False, **rare):
        """Make a dataclass; with other arguments, as the standard library does."""
        chosen = {"eq": eq, "frozen": frozen, "slots": slots, "unsafe_hash": unsafe_hash, **rare}
        if kind is None:
            return lambda kind: dataclass(kind, **chosen)
        if rare:
            return dataclasses.dataclass(kind, **chosen)
        made = dataclasses.dataclass(kind, init=False, repr=False, eq=False, slots=slots)
        made.__doc__ = kind.__doc__
        methods = {"__init__": _Compiled(made, "__init__", _init), "__repr__": _repr}
        if eq:
            methods["__eq__"] = _Compiled(made, "__eq__", _eq)
        if unsafe_hash or (eq and frozen):
            methods["__hash__"] = _Compiled(made, "__hash__", _hash)
        elif eq:
            methods["__hash__"] = None
        if frozen:
            methods |= {"__setattr__": _no_assignment, "__delattr__": _no_deletion}
        if frozen and slots:
            methods |= {"__getstate__": _state, "__setstate__": _set_state}
        for name, method in methods.items():
            if vars(kind).get(name) is None:
                setattr(made, name, method)
        return made


class _LeftOut:
    """The default of a parameter whose field a function makes, shown as the standard library shows it."""

    def __repr__(self) -> str:
        return "<factory>"


_LEFT_OUT = _LeftOut()


class _Compiled:
    """Stands for a method until it is first asked for; then the method takes its place."""

    __slots__ = ("kind", "name", "text")

    def __init__(self, kind: type, name: str, text: Callable[[type], str]) -> None:
        self.kind = kind
        self.name = name
        self.text = text

    def __get__(self, instance: object, owner: type | None = None) -> object:
        method = _function(self.name, self.text(self.kind), self.kind)
        setattr(self.kind, self.name, method)
        return method.__get__(instance, owner)


def _function(name: str, text: str, kind: type) -> FunctionType:
    names: dict[str, object] = {
        "__name__": kind.__module__,
        "_set": object.__setattr__,
        "_LEFT_OUT": _LEFT_OUT,
    }
    for item in fields(kind):
        names[f"_given_{item.name}"] = item.default if item.default is not MISSING else item.default_factory
    exec(text, names)
    method = names[name]
    assert isinstance(method, FunctionType)
    method.__qualname__ = f"{kind.__qualname__}.{name}"
    if name == "__init__":
        types = {item.name: item.type for item in fields(kind) if item.init}
        method.__annotations__ = {**types, "return": None}
    return method


def _init(kind: type) -> str:
    """The text of `__init__`; `_given_X` is the default of the field X, or the function that makes it."""
    by_place, by_name, lines = ["self"], ["*"], []
    frozen = vars(kind).get("__setattr__") is _no_assignment
    for item in fields(kind):
        name, given = item.name, f"_given_{item.name}"
        is_made = item.default_factory is not MISSING
        has_default = is_made or item.default is not MISSING
        if item.init:
            default = f"={'_LEFT_OUT' if is_made else given}" if has_default else ""
            (by_name if item.kw_only else by_place).append(name + default)
            value = f"{given}() if {name} is _LEFT_OUT else {name}" if is_made else name
        elif has_default:
            value = f"{given}()" if is_made else given
        else:
            continue
        lines.append(f"_set(self, {name!r}, {value})" if frozen else f"self.{name} = {value}")
    if hasattr(kind, "__post_init__"):
        lines.append("self.__post_init__()")
    parameters = by_place + (by_name if len(by_name) > 1 else [])
    return f"def __init__({', '.join(parameters)}):\n " + "\n ".join(lines or ["pass"])


def _eq(kind: type) -> str:
    names = [item.name for item in fields(kind) if item.compare]
    return (
        "def __eq__(self, other):\n"
        f" if self.__class__ is other.__class__: return {_tuple('self', names)} == {_tuple('other', names)}\n"
        " return NotImplemented"
    )


def _hash(kind: type) -> str:
    names = [item.name for item in fields(kind) if (item.compare if item.hash is None else item.hash)]
    return f"def __hash__(self): return hash({_tuple('self', names)})"


def _tuple(owner: str, names: list[str]) -> str:
    return f"({''.join(f'{owner}.{name}, ' for name in names)})"


@recursive_repr()
def _repr(self: DataclassInstance) -> str:
    shown = ", ".join(f"{item.name}={getattr(self, item.name)!r}" for item in fields(self) if item.repr)
    return f"{type(self).__qualname__}({shown})"


def _no_assignment(self: object, name: str, value: object) -> NoReturn:
    raise FrozenInstanceError(f"cannot assign to field {name!r}")


def _no_deletion(self: object, name: str) -> NoReturn:
    raise FrozenInstanceError(f"cannot delete field {name!r}")


def _state(self: DataclassInstance) -> list[object]:
    return [getattr(self, item.name) for item in fields(self)]


def _set_state(self: DataclassInstance, state: list[object]) -> None:
    for item, value in zip(fields(self), state, strict=True):
        object.__setattr__(self, item.name, value)


__all__ = ["dataclass"]
