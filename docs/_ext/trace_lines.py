"""`{trace-lines}`: what stands in each kind of line of a trace, from the JSON schema."""

from __future__ import annotations

from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective
from tables import inline, table

from aseme_dsl.runtime.trace.trace_schema import schema

COMMON = ("kind", "time")


class TraceLines(SphinxDirective):
    """A section for each kind of line."""

    def run(self) -> list[nodes.Node]:
        document = schema()
        return [_section(line) for line in document["oneOf"]]


def _section(line: dict[str, Any]) -> nodes.section:
    kind = line["title"]
    section = nodes.section(ids=[f"trace-{kind}"], names=[f"trace-{kind}"])
    section += nodes.title("", "", nodes.literal("", kind))
    section += nodes.paragraph("", "", *inline(line["description"]))
    required = set(line["required"])
    rows = [
        [f"`{name}`" + ("" if name in required else " (not always)"), _type(member), _meaning(member)]
        for name, member in line["properties"].items()
        if name not in COMMON
    ]
    if any(row[2] for row in rows):
        section += table(["member", "is", "meaning"], rows, [25, 20, 55])
    else:
        section += table(["member", "is"], [row[:2] for row in rows], [25, 20])
    return section


def _type(member: dict[str, Any]) -> str:
    if "$ref" in member:
        return str(member["$ref"].rpartition("/")[2])
    if "enum" in member:
        return ", ".join(f"`{value}`" for value in member["enum"])
    if "const" in member:
        return f"`{member['const']}`".replace("True", "true").replace("False", "false")
    if member.get("type") == "array":
        return f"list of {_type(member['items'])}"
    kind = member.get("type", "any value")
    return " or ".join(kind) if isinstance(kind, list) else str(kind)


def _meaning(member: dict[str, Any]) -> str:
    inner = member.get("items", member)
    text = str(member.get("description", ""))
    if inner.get("type") == "object" and "properties" in inner:
        members = ", ".join(f"`{name}`" for name in inner["properties"])
        text = f"{text} Each has {members}.".strip()
    return text


def setup(app: Sphinx) -> dict[str, bool]:
    """Make the directive known to Sphinx."""
    app.add_directive("trace-lines", TraceLines)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
