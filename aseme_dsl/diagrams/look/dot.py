"""DOT: a drawing as plain data (boxes, groups of boxes, lines between them), and its text.

The text depends on the data alone: same data, same bytes. What a finished picture must show follows from the
same data, so that nothing can be drawn which is not checked.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from enum import StrEnum
from functools import lru_cache

from aseme_dsl.diagrams.look.labels import Html, printable, short
from aseme_dsl.records import dataclass

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
    """A whole drawing, with the defaults of its boxes and lines; `lines` are the text of its own label.

    `about` says what it shows, for readers who cannot see it.
    """

    name: str
    items: tuple[Box | Group, ...]
    edges: tuple[Line, ...]
    graph: Attributes
    node: Attributes
    edge: Attributes
    lines: tuple[str, ...] = ()
    about: str = ""


def cluster(group_id: str) -> str:
    """The name of a group's cluster, which is what `lhead` and `ltail` take."""
    return f"cluster_{group_id}"


def text(sheet: Sheet) -> str:
    """The drawing in the DOT language."""
    lines = [f"digraph {_value(sheet.name, is_label=False)} {{"]
    for what, attributes in (("graph", sheet.graph), ("node", sheet.node), ("edge", sheet.edge)):
        if attributes:
            lines.append(f"\t{what}{_list(attributes, first=())}")
    stack: list[tuple[Box | Group | None, str]] = [(item, "\t") for item in reversed(sheet.items)]
    while stack:
        item, margin = stack.pop()
        if item is None:
            lines.append(f"{margin}}}")
        elif isinstance(item, Group):
            lines.append(f"{margin}subgraph {_value(cluster(item.id), is_label=False)} {{")
            lines.append(f"{margin}\tgraph{_list({'id': item.id, **item.attributes}, first=())}")
            stack.append((None, margin))
            stack += ((inner, f"{margin}\t") for inner in reversed(item.items))
        else:
            lines.append(f"{margin}{_name(item.id)}{_list({'id': item.id, **item.attributes})}")
    for line in sheet.edges:
        own = {} if line.id is None else {"id": line.id}
        ends = f"{_end(line.source)} -> {_end(line.target)}"
        lines.append(f"\t{ends}{_list(own | dict(line.attributes))}")
    return "\n".join((*lines, "}\n"))


def _list(attributes: Attributes, first: Sequence[str] = ("label",)) -> str:
    """Attributes in their order: those that come first, then by their names."""
    names = [*(name for name in first if name in attributes), *sorted(attributes.keys() - set(first))]
    values = ((name, attributes[name]) for name in names)
    said = (
        f"{name}=<{value}>"
        if isinstance(value, Html)
        else f"{name}={_value(value, is_label=name == 'label')}"
        for name, value in values
    )
    return f" [{' '.join(said)}]" if names else ""


@lru_cache(10_000)
def _value(text: str, *, is_label: bool) -> str:
    """Text that is shown as it is: Graphviz would read entities, backslashes and angle brackets in it.

    It reads backslashes once in a label, and twice in a tooltip. A tooltip that is too long is cut.
    """
    from graphviz import escape
    from graphviz.quoting import quote

    text = printable(text) if is_label else short(printable(text), _LONGEST).replace("\\", "\\\\")
    return str(quote(escape(text.replace("&", "&amp;"))))


@lru_cache(10_000)
def _name(text: str) -> str:
    from graphviz.quoting import quote

    return str(quote(text))


@lru_cache(10_000)
def _end(text: str) -> str:
    from graphviz.quoting import quote_edge

    return str(quote_edge(text))


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
