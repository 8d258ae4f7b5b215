"""Trace schema: what the lines of a trace look like, as JSON Schema."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any


def schema() -> dict[str, Any]:
    """The JSON Schema of one line."""
    path = Path(__file__).parent / "schemas" / "trace.schema.json"
    found: dict[str, Any] = json.loads(path.read_text("utf-8"))
    return found


def line_schema(kind: str) -> dict[str, Any]:
    """The JSON Schema of one kind of line, complete in itself; of any object, for an unknown kind."""
    whole = schema()
    definitions = whole["$defs"]
    found = next(
        (line for line in whole["oneOf"] if line["title"] == kind), {"title": kind, "type": "object"}
    )

    def complete(part: Any) -> Any:
        if isinstance(part, dict):
            if "$ref" in part:
                name = part["$ref"].rpartition("/")[2]
                return {**complete(definitions[name]), **{k: v for k, v in part.items() if k != "$ref"}}
            return {key: complete(value) for key, value in part.items()}
        return [complete(item) for item in part] if isinstance(part, list) else part

    result: dict[str, Any] = complete(found)
    return result
