"""JSON with places: each object, list and text knows where it begins. Size and depth are limited."""

from __future__ import annotations

import json
import re

from aseme_dsl.interop.emf.markup import Unreadable
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

DEEPEST = 200
MOST = 200_000
"""How many values a text may have."""

_SPACE = re.compile(r"[ \t\n\r]*")
_TEXT = re.compile(r'"(?:[^"\\\x00-\x1f]|\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4}))*"')
_WORD = re.compile(r"true|false|null|-?(?:0|[1-9][0-9]{0,400})(?:\.[0-9]{1,400})?(?:[eE][+-]?[0-9]{1,4})?")


@dataclass(frozen=True, slots=True)
class Value:
    """A value of JSON and its place. `members` are those of an object, `items` those of a list."""

    plain: str | int | float | bool | None
    place: Span
    members: dict[str, Value] | None = None
    items: tuple[Value, ...] | None = None

    @property
    def text(self) -> str:
        """The text, "" of what is none."""
        return self.plain if isinstance(self.plain, str) else ""

    def get(self, name: str) -> Value | None:
        """A member of an object that is there, and not null."""
        found = (self.members or {}).get(name)
        return None if found is None or found.is_null else found

    @property
    def is_null(self) -> bool:
        return self.plain is None and self.members is None and self.items is None

    def whole(self) -> object:
        """The value as Python has it."""
        if self.members is not None:
            return {name: value.whole() for name, value in self.members.items()}
        return self.plain if self.items is None else [value.whole() for value in self.items]

    def listed(self) -> tuple[Value, ...]:
        """The items of a list; of anything else that alone."""
        return (self,) if self.items is None else self.items


def read_json(source: Source) -> Value:
    """The value of a JSON text. Raises Unreadable."""
    reader = _Reader(source)
    found = reader.value(0)
    reader.skip()
    if reader.at < len(source.text):
        raise reader.error("something follows its end")
    return found


class _Reader:
    def __init__(self, source: Source) -> None:
        self.source = source
        self.text = source.text
        self.at = 0
        self.count = 0

    def place(self, start: int) -> Span:
        end = min(max(self.at, start + 1), len(self.text))
        line = self.text.find("\n", start, end)
        return Span(self.source, min(start, len(self.text)), end if line < 0 else line)

    def error(self, reason: str) -> Unreadable:
        return Unreadable(reason, self.place(min(self.at, len(self.text))))

    def skip(self) -> None:
        found = _SPACE.match(self.text, self.at)
        assert found is not None
        self.at = found.end()

    def value(self, depth: int) -> Value:
        self.skip()
        start = self.at
        self.count += 1
        if depth > DEEPEST:
            raise self.error(f"its values are nested more than {DEEPEST} deep")
        if self.count > MOST:
            raise self.error(f"it has more than {MOST} values")
        sign = self.text[start : start + 1]
        if sign == "{":
            return self.object(depth, start)
        if sign == "[":
            return self.list(depth, start)
        if sign == '"':
            return Value(self.string(), self.place(start))
        read = _WORD.match(self.text, start)
        if read is None:
            raise self.error("it is not JSON here: a value is missing" if sign else "it ends too early")
        self.at = read.end()
        return Value(json.loads(read[0]), self.place(start))

    def string(self) -> str:
        read = _TEXT.match(self.text, self.at)
        if read is None:
            raise self.error("it is not JSON here: a text that does not end, or has a wrong character")
        self.at = read.end()
        found: str = json.loads(read[0])
        return found

    def object(self, depth: int, start: int) -> Value:
        self.at += 1
        members: dict[str, Value] = {}
        self.skip()
        while not self.taken("}"):
            if members:
                self.need(",")
                self.skip()
            if self.text[self.at : self.at + 1] != '"':
                raise self.error("it is not JSON here: the name of a member is missing")
            name = self.string()
            if name in members:
                raise self.error(f"the member `{name[:40]}` stands twice")
            self.skip()
            self.need(":")
            members[name] = self.value(depth + 1)
            self.skip()
        return Value(None, self.place(start), members=members)

    def list(self, depth: int, start: int) -> Value:
        self.at += 1
        items: list[Value] = []
        self.skip()
        while not self.taken("]"):
            if items:
                self.need(",")
            items.append(self.value(depth + 1))
            self.skip()
        return Value(None, self.place(start), items=tuple(items))

    def taken(self, sign: str) -> bool:
        if self.text[self.at : self.at + 1] != sign:
            return False
        self.at += 1
        return True

    def need(self, sign: str) -> None:
        if not self.taken(sign):
            raise self.error(f"it is not JSON here: `{sign}` is missing")


__all__ = ["DEEPEST", "MOST", "Value", "read_json"]
