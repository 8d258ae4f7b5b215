"""Trace schema: what the lines of a trace look like, as JSON Schema."""

from __future__ import annotations

import json
from pathlib import Path

Schema = dict[str, object]

LATEST = 2**63 - 1
"""No time and no number of a trace is larger."""


def schema() -> Schema:
    """The JSON Schema of one line."""
    path = Path(__file__).parent / "schemas" / "trace.schema.json"
    found: Schema = json.loads(path.read_text("utf-8"))
    return found


def lines_of(whole: Schema) -> list[Schema]:
    """The schemas of the kinds of lines, which have the kind as `title`."""
    lines = whole["oneOf"]
    assert isinstance(lines, list)
    return lines


def line_schema(kind: str) -> Schema:
    """The JSON Schema of one kind of line, complete in itself; of any object, for an unknown kind."""
    whole = schema()
    definitions = whole["$defs"]
    assert isinstance(definitions, dict)

    def complete(part: object) -> object:
        return complete_object(part) if isinstance(part, dict) else completed_list(part)

    def complete_object(part: Schema) -> Schema:
        if "$ref" in part:
            name = str(part["$ref"]).rpartition("/")[2]
            return {**complete_object(definitions[name]), **{k: v for k, v in part.items() if k != "$ref"}}
        return {key: complete(value) for key, value in part.items()}

    def completed_list(part: object) -> object:
        return [complete(item) for item in part] if isinstance(part, list) else part

    unknown: Schema = {"title": kind, "type": "object"}
    return complete_object(next((line for line in lines_of(whole) if line["title"] == kind), unknown))
