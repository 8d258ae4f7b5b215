"""Labels: text for Graphviz' HTML-like labels, wrapped into lines, and tables of it."""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Callable, Iterable, Sequence
from functools import lru_cache, partial

from aseme_dsl.diagrams.look import style
from aseme_dsl.records import dataclass

# Among them are those that would turn the direction of all text behind them.
_UNPRINTABLE = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ud800-\udfff\ufffe\uffff]")
_PIECES = re.compile(r"\S+\s*")
_HUMPS = re.compile(r"(?<=[_.(])|(?<=[a-z0-9])(?=[A-Z])")

# How far each character from blank to tilde takes a line of Arial or Helvetica, in thousandths of its size.
_ADVANCES = (
    *(278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278),
    *(556, 556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556),
    *(1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778),
    *(667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556),
    *(333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556),
    *(556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584),
)
_BOLD_ADVANCES = (
    *(278, 333, 474, 556, 556, 889, 722, 238, 333, 333, 389, 584, 278, 333, 278, 278),
    *(556, 556, 556, 556, 556, 556, 556, 556, 556, 556, 333, 333, 584, 584, 584, 611),
    *(975, 722, 722, 722, 722, 667, 611, 778, 722, 278, 556, 722, 611, 833, 722, 778),
    *(667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 333, 278, 333, 584, 556),
    *(333, 556, 611, 556, 611, 556, 333, 611, 611, 278, 278, 556, 278, 889, 611, 611),
    *(611, 611, 389, 556, 333, 611, 556, 778, 556, 556, 500, 389, 280, 389, 584),
)
_SIGNS = {"←": 1000, "→": 1000, "…": 1000, "·": 333, "≤": 549, "×": 584}

_SLACK = 1.03
"""How much wider text may be in another font."""


class Html(str):
    """A label in Graphviz' HTML-like language, without the angle brackets around it."""

    __slots__ = ()


def printable(text: str) -> str:
    """The text without what XML and Graphviz cannot hold: control characters become pictures."""

    def picture(match: re.Match[str]) -> str:
        code = ord(match[0])
        return chr(0x2400 + code) if code < 0x20 else "\ufffd"

    return _UNPRINTABLE.sub(picture, text)


def escaped(text: str) -> str:
    """The text for use inside an HTML-like label, where Graphviz reads backslashes as well."""
    text = printable(text).replace("\\", "\\\\")
    text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")
    return text.replace("\n", "<BR/>")


def wrapped(text: str, width: int, most: int | None = None) -> tuple[str, ...]:
    """The text in lines of at most `width` characters, broken at blanks, else inside words where they join.

    With `most`, further lines are left out and the last one ends in "…". No other character is lost but for
    the blanks at the breaks.
    """
    lines: list[str] = []
    for paragraph in printable(text).split("\n"):
        line = ""
        for piece in _PIECES.findall(paragraph.strip()):
            for part in _parts(piece, width):
                if line and len(line) + len(part.rstrip()) > width:
                    lines.append(line.rstrip())
                    line = ""
                line += part
        lines.append(line.rstrip())
    if most is not None and len(lines) > most:
        lines = [*lines[: most - 1], lines[most - 1][: width - 2] + " …"]
    return tuple(lines)


def _parts(piece: str, width: int) -> Iterable[str]:
    """A word as it is if it fits into a line, else cut where its words join, else anywhere."""
    if len(piece.rstrip()) <= width:
        return [piece]
    return [
        hump[start : start + width] for hump in _HUMPS.split(piece) for start in range(0, len(hump), width)
    ]


def fitted(text: str, room: float, size: float, *, bold: bool = False, most: int = 0) -> tuple[str, ...]:
    """The text in lines of at most `room` points, broken as by `wrapped`; of `most` lines the last has "…".

    A single character stays, however little room there is.
    """
    room /= _SLACK
    measured = partial(text_width, size=size, bold=bold)
    lines: list[str] = []
    line = ""
    for piece in _PIECES.findall(printable(text).strip()):
        for part in [piece] if measured(piece.rstrip()) <= room else _cut(piece, room, measured):
            if line and measured((line + part).rstrip()) > room:
                lines.append(line.rstrip())
                line = ""
            line += part
    lines.append(line.rstrip())
    if most and len(lines) > most:
        last = lines[most - 1]
        while last and measured(f"{last} …") > room:
            last = last[:-1].rstrip()
        lines = [*lines[: most - 1], f"{last} …"]
    return tuple(lines)


def _cut(piece: str, room: float, measured: Callable[[str], float]) -> Iterable[str]:
    """A word that is too wide for a line, cut where its words join, else anywhere."""
    for hump in _HUMPS.split(piece):
        while measured(hump.rstrip()) > room and len(hump) > 1:
            end = next((at for at in range(2, len(hump)) if measured(hump[:at]) > room), 2) - 1
            yield hump[:end]
            hump = hump[end:]
        yield hump


def short(text: str, most: int) -> str:
    """The text, cut to `most` characters."""
    return text if len(text) <= most else f"{text[: most - 3]}..."


def room_for(text: str, size: float, *, bold: bool = False) -> float:
    """How much room a line of text takes, with a little more for other fonts."""
    return text_width(text, size, bold=bold) * _SLACK


@lru_cache(10_000)
def text_width(text: str, size: float, *, bold: bool = False) -> float:
    """How wide a line of text is, in points: for ASCII as in Arial and Helvetica, else about."""
    advances = _BOLD_ADVANCES if bold else _ADVANCES
    return sum(_advance(char, advances) for char in text) * size / 1000


def _advance(char: str, advances: Sequence[int]) -> int:
    if " " <= char <= "~":
        return advances[ord(char) - ord(" ")]
    if char in _SIGNS:
        return _SIGNS[char]
    return 1000 if unicodedata.east_asian_width(char) in "WF" else 640


def font(content: str, *, size: int | None = None, colour: str | None = None, bold: bool = False) -> str:
    """The content in another size, colour or weight."""
    attributes = f' POINT-SIZE="{size}"' if size else ""
    attributes += f' COLOR="{colour}"' if colour else ""
    if bold:
        content = f"<B>{content}</B>"
    return f"<FONT{attributes}>{content}</FONT>" if attributes else content


@dataclass(frozen=True, slots=True)
class Cell:
    """A cell of a table: lines of text over `columns` columns, with rules at the `sides` (`TB`).

    It gets a width, as Graphviz' own metrics differ from machine to machine; the built-in ones know only
    ASCII, and nothing of bold.
    """

    lines: tuple[str, ...]
    columns: int = 1
    bold: bool = False
    colour: str = ""
    ink: str = ""
    align: str = "LEFT"
    size: int = style.TEXT_SIZE
    tooltip: str = ""
    sides: str = ""

    @property
    def width(self) -> float:
        """How wide its text is, with a little room for other fonts."""
        return max(room_for(line, self.size, bold=self.bold) for line in self.lines)


def cell_html(cell: Cell, padding: int = 4) -> str:
    """The `<TD>` of a cell."""
    attributes = f' ALIGN="{cell.align}" BALIGN="{cell.align}"'
    if cell.columns > 1:
        attributes += f' COLSPAN="{cell.columns}"'
    if cell.colour:
        attributes += f' BGCOLOR="{cell.colour}"'
    if cell.sides:
        attributes += f' SIDES="{cell.sides}" VALIGN="TOP"'
    attributes += f' WIDTH="{math.ceil(cell.width) + 2 * padding}"'
    content = "<BR/>".join(escaped(line) or " " for line in cell.lines)
    size = cell.size if cell.size != style.TEXT_SIZE else None
    return f"<TD{attributes}>{font(content, size=size, colour=cell.ink or None, bold=cell.bold)}</TD>"


def table(
    rows: Sequence[Sequence[Cell]], *, border: int = 0, cell_border: int = 1, padding: int = 4, fill: str = ""
) -> Html:
    """A table of cells, one sequence a row; `fill` colours all of it and rounds its corners."""
    content = "".join(f"<TR>{''.join(cell_html(cell, padding) for cell in row)}</TR>" for row in rows)
    attributes = f'BORDER="{border}" CELLBORDER="{cell_border}" CELLSPACING="0" CELLPADDING="{padding}"'
    attributes += f' STYLE="ROUNDED" BGCOLOR="{fill}"' if fill else ""
    return Html(f'<TABLE {attributes} COLOR="{style.RULE_COLOUR}">{content}</TABLE>')


def table_lines(rows: Sequence[Sequence[Cell]]) -> tuple[str, ...]:
    """All lines of a table that a reader must find in the drawing."""
    return tuple(line for row in rows for cell in row for line in cell.lines if line)
