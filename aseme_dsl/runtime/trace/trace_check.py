"""Trace check: whether a line has the members that its kind has in the schema, each of the right type.

Readers rely on it: a line that they are given has what it should have, also in a trace that was made by
others. Members and kinds that the schema does not know come from another version, and are not looked at. Nor
are the bounds of numbers and texts, which do no reader any harm.

Where msgspec is installed, it looks first, in a tenth of the time: see `trace_types`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from functools import cache
from typing import TypeAlias, cast

from aseme_dsl.runtime.trace.records import Record
from aseme_dsl.runtime.trace.trace_schema import LATEST, Schema, line_schema, lines_of, schema
from aseme_dsl.runtime.trace.trace_types import is_right

Check: TypeAlias = Callable[[object], "str | None"]
"""What is wrong with a value, said of it: ` is missing`; None if nothing is."""

_TYPES: Mapping[str, tuple[type, str]] = {
    "string": (str, "a text"),
    "integer": (int, "a whole number"),
    "boolean": (bool, "true or false"),
    "array": (list, "a list"),
    "object": (dict, "an object"),
    "null": (type(None), "null"),
}


def wrong_in(record: Record) -> str | None:
    """What is wrong with a line: `agents is missing`, `taken.0.source is not a text`."""
    kind = record["kind"]
    if is_right(record, kind):
        return None
    check = _checks().get(kind)
    found = None if check is None else check(record)
    return None if found is None else found.removeprefix(".")


@cache
def _checks() -> Mapping[str, Check]:
    return {str(line["title"]): _check(line_schema(str(line["title"]))) for line in lines_of(schema())}


def _check(part: Schema) -> Check:
    """The check that a part of a schema asks for."""
    if "const" in part or "enum" in part:
        allowed = cast("list[object]", part.get("enum", [part.get("const")]))
        text = f" is none of {', '.join(map(str, allowed))}" if len(allowed) > 1 else f" is not {allowed[0]}"
        return lambda value: None if value in allowed else text
    said = part.get("type")
    if said is None:
        return lambda value: None
    names = cast("list[str]", said if isinstance(said, list) else [said])
    types = frozenset(kind for name in names for kind in _kinds(name))
    text = f" is not {' or '.join(_TYPES[name][1] if name in _TYPES else 'a number' for name in names)}"
    inner = [
        (kind, check)
        for kind, check in (
            (dict, _members(part)),
            (list, _items(part)),
            (str, _text(part)),
            (int, _number),
        )
        if kind in types and check is not None
    ]
    if not inner:
        return lambda value: None if type(value) in types else text

    def checked(value: object) -> str | None:
        kind = type(value)
        if kind not in types:
            return text
        for wanted, check in inner:
            if kind is wanted:
                return check(value)
        return None

    return checked


def _kinds(name: str) -> tuple[type, ...]:
    return (int, float) if name == "number" else (_TYPES[name][0],)


def _members(part: Schema) -> Check | None:
    """The members of an object."""
    members = {
        name: _check(item) for name, item in cast("dict[str, Schema]", part.get("properties", {})).items()
    }
    required = cast("list[str]", part.get("required", []))
    others = part.get("additionalProperties")
    other = _check(cast(Schema, others)) if isinstance(others, dict) else None
    if not members and not required and other is None:
        return None

    def checked(value: object) -> str | None:
        found = cast("dict[str, object]", value)
        for name in required:
            if name not in found:
                return f".{name} is missing"
        for name, item in found.items():
            check = members.get(name, other)
            wrong = None if check is None else check(item)
            if wrong is not None:
                return f".{name}{wrong}"
        return None

    return checked


def _items(part: Schema) -> Check | None:
    """The items of a list."""
    most = cast("int | None", part.get("maxItems"))
    least = cast(int, part.get("minItems", 0)) if most is not None else 0
    first = [_check(item) for item in cast("list[Schema]", part.get("prefixItems", []))]
    every = _check(cast(Schema, part["items"])) if isinstance(part.get("items"), dict) else None
    if not least and most is None and not first and every is None:
        return None

    def checked(value: object) -> str | None:
        found = cast("list[object]", value)
        if len(found) < least or (most is not None and len(found) > most):
            return f" has {len(found)} items"
        for place, item in enumerate(found):
            check = first[place] if place < len(first) else every
            wrong = None if check is None else check(item)
            if wrong is not None:
                return f".{place}{wrong}"
        return None

    return checked


def _text(part: Schema) -> Check | None:
    """A text of a certain form."""
    if "pattern" not in part:
        return None
    form = re.compile(str(part["pattern"]))
    return lambda value: None if form.search(cast(str, value)) else " has another form"


def _number(value: object) -> str | None:
    """A whole number of 64 bits."""
    return None if -LATEST <= cast(int, value) <= LATEST else " is too large"


__all__ = ["LATEST", "wrong_in"]
