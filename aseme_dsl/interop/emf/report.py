"""Report: what became of each element of a foreign model."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from enum import StrEnum

from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


class Fate(StrEnum):
    """What became of an element."""

    KEPT = "taken over"
    CHANGED = "translated"
    HOLE = "to be decided"
    DIFFERS = "means something else"
    ADDED = "added"
    LEFT_OUT = "left out"


@dataclass(frozen=True, slots=True)
class Row:
    """An element, where it stands in the foreign file (None for what was added), and where it is now."""

    fate: Fate
    element: str
    place: Span | None
    now: str


def summary(rows: Iterable[Row]) -> str:
    """How many elements had which fate, on one line."""
    counts = Counter(row.fate for row in rows)
    return ", ".join(f"{counts[fate]} {fate}" for fate in Fate if counts[fate])


def worth_reading(rows: Iterable[Row]) -> Iterator[str]:
    """A line for each element that needs a look: holes, what was added and what was left out."""
    for row in rows:
        if row.fate not in (Fate.KEPT, Fate.CHANGED):
            place = f"{row.place}: " if row.place is not None else ""
            yield f"{place}{row.fate}: {row.element}{f' ({row.now})' if row.now else ''}"


def as_markdown(title: str, rows: Iterable[Row]) -> str:
    """The whole report as a page: the table of all elements, those that need a look first."""
    listed = list(rows)
    order = (Fate.HOLE, Fate.DIFFERS, Fate.LEFT_OUT, Fate.ADDED, Fate.CHANGED, Fate.KEPT)
    lines = [f"# {title}", "", summary(listed) or "nothing", ""]
    for fate in order:
        members = [row for row in listed if row.fate is fate]
        if members:
            lines += [f"## {fate.capitalize()}", "", "| element | in | now |", "| --- | --- | --- |"]
            lines += [
                f"| {_cell(row.element)} | {_cell(str(row.place or ''))} | {_cell(row.now)} |"
                for row in members
            ]
            lines.append("")
    return "\n".join(lines)


def _cell(text: str) -> str:
    plain = text.replace("\\", "\\\\")
    for sign in "|<>*_`[]":
        plain = plain.replace(sign, f"\\{sign}")
    return plain


__all__ = ["Fate", "Row", "as_markdown", "summary", "worth_reading"]
