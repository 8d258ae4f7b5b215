"""Names that types, members and constants cannot have: in generated Python they mean something else."""

from __future__ import annotations

import keyword

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
