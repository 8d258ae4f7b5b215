"""Unread messages of two versions: their content is decided when it is read, by their names."""

from __future__ import annotations

from collections.abc import Callable, Container
from functools import cache
from typing import Any

from aseme_dsl.proofs.explore.deciding.unread import Path, Unread, kind_of, place_of, unread_class
from aseme_dsl.proofs.explore.deciding.unread import unread as made
from aseme_dsl.runtime.message.as_json import member_types

Ask = Callable[[Path, object], object]
"""Gives the member at a path, which is of a type; None for its default."""


@cache
def _opened(kind: type) -> type[object]:
    more = {"__hash__": object.__hash__, "__repr__": _named, "__str__": _named}
    return unread_class(kind, _member, more)


def _named(message: Any) -> str:
    (name, _), path = _parts(message)
    return ".".join((name, *path))


def _parts(message: object) -> tuple[tuple[str, Ask], Path]:
    root: Any
    root, path = place_of(message)
    return root, path


def _member(root: Any, path: Path, hint: Any) -> object:
    _, ask = root
    if hasattr(hint, "__dataclass_fields__"):
        return made(_opened(hint), root, path)
    return ask(path, hint)


def unread(kind: type, name: str, ask: Ask) -> object:
    """A message of which nothing is decided yet, with its name."""
    return made(_opened(kind), (name, ask), ())


def decided(value: object, known: Container[object]) -> object:
    """A value with messages that are decided: a member whose (root, path) is not `known` has its default."""
    if isinstance(value, tuple):
        return tuple(decided(item, known) for item in value)
    return _decided(value, known) if isinstance(value, Unread) else value


def _decided(message: Any, known: Container[object]) -> object:
    kind: Any = kind_of(message)
    (root, _), path = _parts(message)
    given: dict[str, object] = {}
    for name, hint in member_types(kind).items():
        if hasattr(hint, "__dataclass_fields__"):
            given[name] = decided(getattr(message, name), known)
        elif (root, ".".join((*path, name))) in known:
            given[name] = getattr(message, name)
    return kind(**given)


__all__ = ["Unread", "decided", "unread"]
