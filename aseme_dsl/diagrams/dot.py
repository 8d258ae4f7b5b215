"""DOT: a drawing as plain data (boxes, groups of boxes, lines between them), and its text.

The text depends on the data alone: same data, same bytes. What a finished picture must show follows from the
same data, so that nothing can be drawn which is not checked.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from aseme_dsl.diagrams.labels import Html, printable, short

_LONGEST = 3000
"""Characters of a tooltip, at most 15 000 when escaped: older versions read no string beyond 16 384."""

Attributes = Mapping[str, str]
"""Graphviz attributes; a value that is `Html` is an HTML-like label, all others are plain text."""


class Kind(StrEnum):
    """What is drawn."""

    BOX = "box"
    GROUP = "group"
    LINE = "line"
    SHEET = "sheet"


@dataclass(frozen=True, slots=True)
class Shown:
    """What a picture must contain: an element of this id, and in it these lines of text.

    `inside` is the id of the group whose border must be around it. An empty id is the whole picture.
    """

    id: str
    kind: Kind
    lines: tuple[str, ...] = ()
    inside: str | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Box:
    """A node. `id` names it in DOT and in the SVG."""

    id: str
    attributes: Attributes = field(default_factory=dict)
    lines: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Group:
    """A cluster: boxes and groups with a border around them."""

    id: str
    items: tuple[Box | Group, ...]
    attributes: Attributes = field(default_factory=dict)
    lines: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Line:
    """An edge between two boxes. Without an id it is a help for the layout and promises nothing."""

    source: str
    target: str
    id: str | None = None
    attributes: Attributes = field(default_factory=dict)
    lines: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class Sheet:
    """A whole drawing, with the defaults of its boxes and lines; `lines` are the text of its own label."""

    name: str
    items: tuple[Box | Group, ...]
    edges: tuple[Line, ...]
    graph: Attributes
    node: Attributes
    edge: Attributes
    lines: tuple[str, ...] = ()


def cluster(group_id: str) -> str:
    """The name of a group's cluster, which is what `lhead` and `ltail` take."""
    return f"cluster_{group_id}"


def text(sheet: Sheet) -> str:
    """The drawing in the DOT language."""
    import graphviz

    def new(name: str | None) -> Any:
        return graphviz.Digraph(name=None if name is None else _plain(name, is_label=False))

    def fill(graph: Any, children: Sequence[Box | Group], made: Mapping[str, Any]) -> None:
        for item in children:
            if isinstance(item, Group):
                graph.subgraph(made[item.id])
            else:
                graph.node(item.id, **_values({"id": item.id, **item.attributes}))

    made: dict[str, Any] = {}
    for group in reversed(list(groups(sheet.items))):  # inner groups before those around them
        graph = new(cluster(group.id))
        graph.attr("graph", **_values({"id": group.id, **group.attributes}))
        fill(graph, group.items, made)
        made[group.id] = graph
    whole = new(sheet.name)
    whole.attr("graph", **_values(sheet.graph))
    whole.attr("node", **_values(sheet.node))
    whole.attr("edge", **_values(sheet.edge))
    fill(whole, sheet.items, made)
    for line in sheet.edges:
        own = {} if line.id is None else {"id": line.id}
        whole.edge(line.source, line.target, **_values(own | dict(line.attributes)))
    return str(whole.source)


def _values(attributes: Attributes) -> dict[str, Any]:
    return {
        name: f"<{value}>" if isinstance(value, Html) else _plain(value, is_label=name == "label")
        for name, value in attributes.items()
    }


def _plain(text: str, *, is_label: bool) -> Any:
    """Text that is shown as it is: Graphviz would read entities, backslashes and angle brackets in it.

    It reads backslashes once in a label, and twice in a tooltip. A tooltip that is too long is cut.
    """
    import graphviz

    text = printable(text) if is_label else short(printable(text), _LONGEST).replace("\\", "\\\\")
    return graphviz.escape(text.replace("&", "&amp;"))


def groups(items: Sequence[Box | Group]) -> Sequence[Group]:
    """All groups in the items, each before those in it."""
    found: list[Group] = []
    stack = list(reversed(items))
    while stack:
        item = stack.pop()
        if isinstance(item, Group):
            found.append(item)
            stack.extend(reversed(item.items))
    return found


def shown(sheet: Sheet) -> tuple[Shown, ...]:
    """Everything that a picture of the drawing must contain."""
    found: list[Shown] = []
    stack: list[tuple[Box | Group, str | None]] = [(item, None) for item in reversed(sheet.items)]
    while stack:
        item, inside = stack.pop()
        kind = Kind.GROUP if isinstance(item, Group) else Kind.BOX
        found.append(Shown(item.id, kind, item.lines, inside))
        if isinstance(item, Group):
            stack.extend((child, item.id) for child in reversed(item.items))
    found.extend(Shown(line.id, Kind.LINE, line.lines) for line in sheet.edges if line.id is not None)
    found.append(Shown("", Kind.SHEET, sheet.lines))
    return tuple(found)
