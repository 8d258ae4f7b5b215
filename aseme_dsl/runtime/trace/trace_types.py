"""Trace types: reads and checks the usual line of a trace with msgspec, where that is installed.

It is ten times as fast as Python. What it reads, the parser of Python reads in the same way; where it finds
nothing wrong, `trace_check` finds nothing either. All other lines are left to these, also those with members
that the schema does not know.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from types import ModuleType
from typing import Annotated, Any, Literal, cast

from aseme_dsl.runtime.trace.trace_schema import LATEST, Schema, line_schema, lines_of, schema


def decoded(text: str) -> object:
    """What a piece of JSON says; None if it is not read."""
    module = _msgspec()
    try:
        return None if module is None else cast(object, module.json.decode(text))
    except (ValueError, RecursionError):
        return None


def is_right(record: Mapping[str, object], kind: str) -> bool:
    """Whether nothing is wrong with a line of this kind. False: there may be something."""
    module, whole = _msgspec(), _type_of(kind)
    if module is None or whole is None:
        return False
    try:
        module.convert(record, whole)
    except (ValueError, RecursionError):
        return False
    return True


def beginning(text: str, kind: str) -> dict[str, object] | None:
    """Kind, time, agent and sequence of a line of this kind, as far as it has them.

    None: there may be something wrong with the line.
    """
    read = _reader(kind)
    if read is None:
        return None
    try:
        line = read(text)
    except (ValueError, RecursionError):
        return None
    found: dict[str, object] = {"kind": kind, "time": line.time}
    agent, number = getattr(line, "agent", None), getattr(line, "sequence", None)
    if type(agent) is str:
        found["agent"] = agent
    if type(number) is int:
        found["sequence"] = number
    return found


@cache
def _msgspec() -> ModuleType | None:
    try:
        import msgspec
    except ImportError:
        return None
    return msgspec


@cache
def _kinds() -> frozenset[str]:
    return frozenset(str(line["title"]) for line in lines_of(schema()))


@cache
def _reader(kind: str) -> Callable[[str], Any] | None:
    module, whole = _msgspec(), _type_of(kind)
    return None if module is None or whole is None else module.json.Decoder(whole).decode


@cache
def _type_of(kind: str) -> Any:
    """The type of the lines of a kind; None if there is none."""
    module = _msgspec()
    return None if module is None or kind not in _kinds() else _type(module, line_schema(kind))


def _type(module: Any, part: Schema) -> Any:
    """A type of what a part of a schema allows, or of less."""
    if "const" in part or "enum" in part:
        allowed = cast("list[object]", part.get("enum", [part.get("const")]))
        is_text = all(isinstance(item, str) for item in allowed)
        return Literal[tuple(allowed)] if is_text else Annotated[int, module.Meta(ge=1, le=0)]  # nothing
    said = part.get("type")
    if said is None:
        return Any
    found: Any = None
    for name in cast("list[str]", said if isinstance(said, list) else [said]):
        kind = _plain_type(module, name, part)
        found = kind if found is None else found | kind
    return found


def _plain_type(module: Any, name: str, part: Schema) -> Any:
    match name:
        case "object":
            return _object(module, part)
        case "array":
            return _list(module, part)
        case "string":
            form = part.get("pattern")
            return str if form is None else Annotated[str, module.Meta(pattern=str(form))]
        case "integer":
            return Annotated[int, module.Meta(ge=-LATEST, le=LATEST)]
        case "number":
            return Annotated[int, module.Meta(ge=-LATEST, le=LATEST)] | float
        case "boolean":
            return bool
        case "null":
            return type(None)
        case _:
            raise AssertionError(f"a schema has the type {name}")


def _object(module: Any, part: Schema) -> Any:
    required = cast("list[str]", part.get("required", []))
    members = dict.fromkeys(required, Schema()) | cast("dict[str, Schema]", part.get("properties", {}))
    others = part.get("additionalProperties")
    if not members:
        other = _type(module, cast(Schema, others)) if isinstance(others, dict) else Any
        return dict.__class_getitem__((str, other))
    fields: list[Any] = []
    for name, item in members.items():
        kind = _type(module, item)
        fields.append((name, kind) if name in required else (name, kind | module.UnsetType, module.UNSET))
    return module.defstruct("Part", fields, kw_only=True, forbid_unknown_fields=True, gc=False)


def _list(module: Any, part: Schema) -> Any:
    most = cast("int | None", part.get("maxItems"))
    first = [_type(module, item) for item in cast("list[Schema]", part.get("prefixItems", []))]
    if first and len(first) == most == part.get("minItems"):
        return tuple.__class_getitem__(tuple(first))
    every = _type(module, cast(Schema, part["items"])) if isinstance(part.get("items"), dict) else Any
    limits = module.Meta(min_length=part.get("minItems", 0), max_length=most)
    return Annotated[list.__class_getitem__(every), limits]


__all__ = [
    "beginning",
    "decoded",
    "is_right",
]
