"""Radio: the encoding of messages for the small radio of robots, and their sizes in bytes.

A message is one byte that identifies its type, then its fields in order:

| field | bytes |
| --- | --- |
| bool, enum | 1 |
| int | 4, signed |
| double | 4, single precision |
| duration | 4, signed, whole milliseconds |
| message | the bytes of its fields |

An optional field has one more byte before it, which says whether it is present.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

from aseme_dsl.amola.messages import EnumType, Field, Kind, Message
from aseme_dsl.amola.system import System
from aseme_dsl.records import dataclass

KIND_BYTES = 1
SIZES = {Kind.BOOL: 1, Kind.ENUM: 1, Kind.INT: 4, Kind.DOUBLE: 4, Kind.DURATION: 4}
MOST_KINDS = 256
CODES = {Kind.BOOL: "?", Kind.ENUM: "e", Kind.INT: "i", Kind.DOUBLE: "f", Kind.DURATION: "m"}
"""What `runtime.wire` calls them; "o" stands before an optional one."""


@dataclass(frozen=True, slots=True)
class Part:
    """A member that is sent, by its path; `size` includes the byte of an optional one."""

    path: tuple[Field, ...]
    size: int

    @property
    def name(self) -> str:
        return ".".join(field.name for field in self.path)


@dataclass(frozen=True, slots=True)
class Unfit:
    """A member that no radio message can have, and why."""

    path: tuple[Field, ...]
    why: Literal["repeated", "recursive", "optional", "wide", "long"]

    @property
    def name(self) -> str:
        return ".".join(field.name for field in self.path)


def parts(
    message: Message,
    message_named: Callable[[str], Message | None],
    enum_named: Callable[[str], EnumType | None],
) -> tuple[Part | Unfit, ...]:
    """What is sent for `message`, in order; messages inside it are flattened."""
    found: list[Part | Unfit] = []
    stack: list[tuple[tuple[Field, ...], tuple[str, ...]]] = [
        ((field,), (message.name,)) for field in reversed(message.fields)
    ]
    while stack:
        path, around = stack.pop()
        field = path[-1]
        extra = 1 if field.label == "optional" else 0
        if field.label == "repeated":
            found.append(Unfit(path, "repeated"))
        elif field.type.kind is Kind.MESSAGE:
            inner = message_named(field.type.name)
            if inner is None:
                continue
            if inner.name in around:
                found.append(Unfit(path, "recursive"))
                continue
            if extra:
                found.append(Unfit(path, "optional"))
                continue
            stack += [((*path, item), (*around, inner.name)) for item in reversed(inner.fields)]
        elif field.type.kind is Kind.ENUM:
            enum = enum_named(field.type.name)
            if enum is not None and any(not 0 <= number <= 255 for _, number in enum.constants):
                found.append(Unfit(path, "wide"))
            else:
                found.append(Part(path, extra + SIZES[Kind.ENUM]))
        elif field.type.kind in SIZES:
            found.append(Part(path, extra + SIZES[field.type.kind]))
        else:
            found.append(Unfit(path, "long"))
    return tuple(found)


def codes(system: System, name: str) -> str:
    """The members of a message that fits a radio as one letter each, in the order in which they are sent."""
    message = system.message(name)
    assert message is not None
    found = ""
    for part in parts(message, system.message, system.enum):
        assert isinstance(part, Part)
        last = part.path[-1]
        found += ("o" if last.label == "optional" else "") + CODES[last.type.kind]
    return found
