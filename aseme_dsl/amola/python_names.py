"""Names in generated code: those that mean something else there, and how names are kept apart."""

from __future__ import annotations

import keyword
from collections.abc import Hashable, Iterable
from typing import TypeVar

_K = TypeVar("_K", bound=Hashable)

_TYPES = frozenset("bool int float str bytes tuple type object dataclasses enum wire typing".split())
_MODULE = frozenset({"CHANNELS", "DESCRIPTORS", "RADIO", "SCHEMA"})
_ENUM = frozenset(dir(int)) | {"name", "value", "mro"}


def taken_as_type(name: str) -> bool:
    """Whether no message and no enum can have this name: a class of the generated module `messages`."""
    return keyword.iskeyword(name) or name.startswith("_") or name in _TYPES or name in _MODULE


def taken_as_member(name: str) -> bool:
    """Whether no field of a message can have this name: an attribute of a dataclass."""
    return keyword.iskeyword(name) or name.startswith("__") or name in _TYPES


def taken_as_constant(name: str) -> bool:
    """Whether no enum constant can have this name: a member of an `IntEnum`."""
    return keyword.iskeyword(name) or name.startswith("_") or name in _ENUM


def free_name(name: str, taken: frozenset[str] | set[str]) -> str:
    """`name` with as many underscores behind it as it takes to be in none of `taken`."""
    name = name.lstrip("_") or "x"
    name += "_"
    while name in taken:
        name += "_"
    return name


def kept_apart(wishes: Iterable[tuple[_K, str]], taken: Iterable[str]) -> dict[_K, str]:
    """A name for each key: the one that it wishes, behind which there are as many underscores as it takes to
    be no other's, and none of `taken`."""
    known = set(taken)
    names: dict[_K, str] = {}
    for key, name in wishes:
        while name in known:
            name += "_"
        known.add(name)
        names[key] = name
    return names
