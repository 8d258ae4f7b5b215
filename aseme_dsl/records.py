"""`dataclass` as the standard library has it, made in a tenth of the time.

The standard library writes and compiles up to seven methods for each class while its module is imported. A
command uses few of them: they took half of the time of checking a small file. Here the standard library
finds the fields, and a method is written when it is called for the first time. It does the same.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterable
from reprlib import recursive_repr
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass  # so that type checkers know what it means
else:

    def dataclass(
        kind: type | None = None,
        /,
        *,
        frozen: bool = False,
        slots: bool = False,
        eq: bool = True,
        order: bool = False,
    ) -> Any:
        """The standard library's `dataclass`, with those of its arguments that are used here."""
        if order:  # as few are
            return dataclasses.dataclass(frozen=frozen, slots=slots, eq=eq, order=True)
        return _made(kind, frozen, slots, eq) if kind else lambda kind: _made(kind, frozen, slots, eq)


_Fields = tuple[dataclasses.Field[Any], ...]


def _made(kind: Any, frozen: bool, slots: bool, eq: bool) -> Any:
    own = {name for name, value in kind.__dict__.items() if value is not None}
    if "__doc__" not in own:
        kind.__doc__ = kind.__name__  # the standard library would look for a signature to put there
    made: Any = dataclasses.dataclass(init=False, repr=False, eq=False, slots=slots)(kind)
    missing = {"__init__": _frozen_init if frozen else _init, "__repr__": _repr}
    if eq:
        missing |= {"__eq__": _eq, "__hash__": _hash}
    for name in missing.keys() - own:
        setattr(made, name, _written_later(made, name, missing[name]))
    if eq and not frozen and "__hash__" not in own:
        made.__hash__ = None
    if frozen:
        _freeze(made, slots, own)
    return made


def _written_later(made: Any, name: str, write: Callable[[Any, _Fields], Any]) -> Any:
    """A method that writes the real one, and puts it in its own place, when it is called."""

    def method(self: Any, *arguments: Any, **named: Any) -> Any:
        if made.__dict__[name] is method:
            written = write(made, dataclasses.fields(made))
            written.__qualname__ = f"{made.__qualname__}.{name}"
            setattr(made, name, written)
        return made.__dict__[name](self, *arguments, **named)

    return method


def _freeze(made: Any, slots: bool, own: set[str]) -> None:
    names = {item.name for item in dataclasses.fields(made)}

    def refuse_to_set(self: Any, name: str, value: Any) -> None:
        if type(self) is made or name in names:
            raise dataclasses.FrozenInstanceError(f"cannot assign to field {name!r}")
        super(made, self).__setattr__(name, value)

    def refuse_to_delete(self: Any, name: str) -> None:
        if type(self) is made or name in names:
            raise dataclasses.FrozenInstanceError(f"cannot delete field {name!r}")
        super(made, self).__delattr__(name)

    made.__setattr__, made.__delattr__ = refuse_to_set, refuse_to_delete
    if slots and "__getstate__" not in own:
        made.__getstate__, made.__setstate__ = _state, _set_state


def _state(self: Any) -> list[Any]:
    """What of a frozen object with slots is copied and pickled."""
    return [getattr(self, item.name) for item in dataclasses.fields(self)]


def _set_state(self: Any, state: list[Any]) -> None:
    for item, value in zip(dataclasses.fields(self), state, strict=True):
        object.__setattr__(self, item.name, value)


_NOT_GIVEN: Any = object()


def _init(made: Any, fields: _Fields, assignment: str = "self.{} = {}") -> Any:
    parameters: list[str] = []
    body: list[str] = []
    known: dict[str, Any] = {"_set": object.__setattr__, "_NOT_GIVEN": _NOT_GIVEN}
    for item in fields:
        name = item.name
        if item.default_factory is not dataclasses.MISSING:
            known[f"_make_{name}"] = item.default_factory
            parameter, value = f"{name}=_NOT_GIVEN", f"_make_{name}()"
            if item.init:
                value += f" if {name} is _NOT_GIVEN else {name}"
        elif item.default is not dataclasses.MISSING:
            known[f"_default_{name}"] = item.default
            parameter, value = f"{name}=_default_{name}", name if item.init else f"_default_{name}"
        elif item.init:
            parameter = value = name
        else:
            continue  # `__post_init__` sets it
        if item.init:
            parameters.append(parameter)
        body.append(assignment.format(name, value))
    if hasattr(made, "__post_init__"):
        body.append("self.__post_init__()")
    return _compiled(made, "__init__", parameters, body or ["pass"], known)


def _frozen_init(made: Any, fields: _Fields) -> Any:
    return _init(made, fields, "_set(self, '{}', {})")


def _repr(made: Any, fields: _Fields) -> Any:
    shown = ", ".join(f"{item.name}={{self.{item.name}!r}}" for item in fields if item.repr)
    body = [f"return f'{{self.__class__.__qualname__}}({shown})'"]
    return recursive_repr()(_compiled(made, "__repr__", (), body, {}))


def _eq(made: Any, fields: _Fields) -> Any:
    mine, yours = (_tuple(who, (item for item in fields if item.compare)) for who in ("self", "other"))
    body = ["if other.__class__ is self.__class__:", f"  return {mine} == {yours}", "return NotImplemented"]
    return _compiled(made, "__eq__", ("other",), body, {})


def _hash(made: Any, fields: _Fields) -> Any:
    used = (item for item in fields if (item.compare if item.hash is None else item.hash))
    return _compiled(made, "__hash__", (), [f"return hash({_tuple('self', used)})"], {})


def _tuple(owner: str, fields: Iterable[dataclasses.Field[Any]]) -> str:
    return f"({''.join(f'{owner}.{item.name}, ' for item in fields)})"


def _compiled(
    made: Any, name: str, parameters: Iterable[str], body: Iterable[str], known: dict[str, Any]
) -> Any:
    text = "\n ".join((f"def {name}({', '.join(('self', *parameters))}):", *body))
    exec(compile(text, f"<{name} of {made.__qualname__}>", "exec"), known)
    return known[name]
