"""Unread: messages of which each member is decided when something reads it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import cast

from aseme_dsl.runtime.message.as_json import member_types

Path = tuple[str, ...]
"""The way to a member of a message, from outside."""
Member = Callable[[object, Path, object], object]
"""Gives the member at a path of what a message belongs to (its root), or None for its default. The last
argument is the type of the member."""


class Unread:
    """What messages are whose members are decided when they are read, beside being of their type."""

    __slots__ = ()


_READ = "@"
"""What reads both of a message, in the class that holds them: nothing else is called so."""


def unread_class(kind: type[object], member: Member, more: Mapping[str, object]) -> type[object]:
    """The class of unread messages of a type; `more` are attributes of it.

    What a message belongs to stands in a class of its own below the members: these may have any name.
    """
    held = type(kind.__name__, (Unread, kind), {"__slots__": ("path", "root")})
    setattr(held, _READ, (vars(held)["root"].__get__, vars(held)["path"].__get__))
    own: dict[str, object] = {"__slots__": (), **more}
    plain = kind()
    own |= {
        name: _read(name, hint, member, getattr(plain, name))
        for name, hint in member_types(cast("type", kind)).items()
    }
    return type(kind.__name__, (held,), own)


def _read(name: str, hint: object, member: Member, default: object) -> property:
    def read(message: object) -> object:
        root, path = place_of(message)
        value = member(root, (*path, name), hint)
        return default if value is None else value

    return property(read)


def unread(opened: type[object], root: object, path: Path) -> object:
    """A message of such a class: that at a path of its root."""
    message = object.__new__(opened)
    slots = vars(opened.__mro__[1])
    slots["root"].__set__(message, root)
    slots["path"].__set__(message, path)
    return message


def place_of(message: object) -> tuple[object, Path]:
    """What an unread message belongs to, and where it stands in that."""
    root, path = vars(type(message).__mro__[1])[_READ]
    return root(message), path(message)


def kind_of(message: object) -> type[object]:
    """The type of an unread message."""
    return type(message).__mro__[3]


__all__ = ["Member", "Path", "Unread", "kind_of", "place_of", "unread", "unread_class"]
