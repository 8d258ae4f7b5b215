"""Entries that stand together without a blank line: aligned as a table, comments at their ends, too."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from aseme_dsl.grammar.layout.fill import STEP, WIDTH, fill, flat
from aseme_dsl.grammar.layout.pieces import ORDER, Piece, Row
from aseme_dsl.grammar.layout.rules import SHAPES, Line
from aseme_dsl.records import dataclass

WIDEST = 56
"""A cell that is wider does not make its column wider: it sticks out."""

UNLIMITED = 1 << 30


@dataclass(slots=True)
class _Cell:
    column: int
    pieces: list[Piece]
    width: int
    on_new_line: bool
    may_break: bool
    unbreakable: bool
    moved: bool = False
    """It comes after a part of a later column, so it goes behind all of them."""


def lines_of_section(rows: Sequence[Row], indentation: int) -> list[list[str]]:
    """The lines of each row, complete."""
    tables: dict[str, list[int]] = {}
    for index, row in enumerate(rows):
        shape = SHAPES.get(row.rule)
        table = shape.table if isinstance(shape, Line) else ""
        tables.setdefault(table or row.rule, []).append(index)
    found: list[list[str]] = [[] for _ in rows]
    for members in tables.values():
        for index, lines in zip(
            members, _table([rows[index] for index in members], indentation), strict=True
        ):
            found[index] = lines
    _end_with_comments(rows, found)
    return found


def is_pinned(row: Row) -> bool:
    """Whether a comment speaks to asemec about what begins on the row's line, so that it must stay one."""
    comments = [*row.trailing, *(comment for piece in row.pieces for comment in piece.after)]
    return any(ORDER.search(comment) for comment in comments)


def _table(rows: Sequence[Row], indentation: int) -> list[list[str]]:
    cells = [_cells(row) for row in rows]
    shape = SHAPES.get(rows[0].rule)
    apart = shape.apart if isinstance(shape, Line) else -1
    widths = [UNLIMITED if is_pinned(row) else WIDTH for row in rows]
    while True:
        _pad(rows, cells)
        starts = _starts(cells, indentation, apart)
        lines = []
        breaks: list[_Cell] = []
        for row_cells, width in zip(cells, widths, strict=True):
            written, too_long = _row(row_cells, starts, indentation, width)
            lines.append(written)
            if too_long is not None:
                breaks.append(too_long)
        if not breaks:
            return lines
        for cell in breaks:  # lines only get more, so that this ends, and begins there the next time
            cell.on_new_line = True


def _cells(row: Row) -> list[_Cell]:
    shape = SHAPES.get(row.rule)
    may_break = isinstance(shape, Line) and bool(shape.clauses)
    firsts = [index for index, piece in enumerate(row.pieces) if piece.column is not None] or [0]
    last = firsts[-1]
    if any(piece.is_hard for piece in row.pieces[:last]) or row.pieces[last].above:
        firsts = [0]  # comments have broken the row, so it is not a part of a table
    cells: list[_Cell] = []
    for first, end in zip(firsts, [*firsts[1:], len(row.pieces)], strict=True):
        pieces = row.pieces[first:end]
        head = pieces[0]
        can = may_break and first > 0
        column = head.column or 0
        moved = bool(cells) and column < cells[-1].column
        if moved and isinstance(shape, Line):
            column = max(shape.columns.values())
        on_new_line = can and head.starts_line
        alone = len(pieces) == 1 and first > 0
        cells.append(_Cell(column, pieces, 0, on_new_line, can, alone, moved))
    return cells


def _pad(rows: Sequence[Row], cells: Sequence[Sequence[_Cell]]) -> None:
    """Make words of different lengths equally long, where what follows them is aligned."""
    shape = SHAPES.get(rows[0].rule)
    if isinstance(shape, Line):
        for column, always in shape.padded.items():
            found = [cell for row in cells for cell in row if cell.column == column and not cell.moved]
            found = [cell for cell in found if not cell.pieces[0].is_hard]
            if always or any(cell.on_new_line for cell in found):
                longest = max((len(cell.pieces[0].text) for cell in found), default=0)
                for cell in found:
                    if len(cell.pieces) > 1:
                        cell.pieces[1].blanks = 1 + longest - len(cell.pieces[0].text)
    for row in cells:
        for cell in row:
            if not any(piece.is_hard for piece in cell.pieces):
                cell.width = len(flat(cell.pieces))


def _starts(cells: Sequence[Sequence[_Cell]], indentation: int, apart: int) -> list[int]:
    """Where each column begins: behind the widest cell before it that something follows on its line."""
    columns = 1 + max(cell.column for row in cells for cell in row)
    widest = [0] * columns
    for row in cells:
        for cell, following in pairwise(row):
            if (
                not following.on_new_line
                and cell.width <= WIDEST
                and not any(piece.loose for piece in cell.pieces)
            ):
                widest[cell.column] = max(widest[cell.column], cell.width)
    starts = [indentation]
    for column, width in enumerate(widest, 1):
        starts.append(starts[-1] + width + 1 + (column == apart) if width else starts[-1])
    return starts


def _row(
    cells: Sequence[_Cell], starts: Sequence[int], indentation: int, width: int
) -> tuple[list[str], _Cell | None]:
    """The lines of a row; and the cell that should begin a new line, if there is one."""
    lines = [" " * indentation]
    column = 0
    for cell in cells:
        target = starts[cell.column]
        below = target if target > indentation else indentation + 2 * STEP
        if cell.on_new_line:
            lines.append("")
            target = below
        elif cell is not cells[0]:
            least = len(lines[-1]) + 1
            target = max(target, least) if cell.column > column else least
            if target + cell.width > width:
                if cell.may_break and below < target:
                    return lines, cell
                if cell.unbreakable:
                    target = least
        column = cell.column
        first, *others = fill(cell.pieces, target, indentation, width)
        lines[-1] = lines[-1].ljust(target) + first
        lines += others
    return lines, None


def _end_with_comments(rows: Sequence[Row], found: Sequence[list[str]]) -> None:
    """Comments at the ends of lines, one below the other."""
    ending = [lines for row, lines in zip(rows, found, strict=True) if row.trailing]
    column = max((len(lines[-1]) for lines in ending), default=0) + 2
    for row, lines in zip(rows, found, strict=True):
        add_comments(lines, row.trailing, column)


def add_comments(lines: list[str], comments: Sequence[str], column: int) -> None:
    """Add the first comment to the last line, at `column`, and the comments that continue it below."""
    for index, comment in enumerate(comments):
        if index:
            lines.append("")
        lines[-1] = lines[-1].ljust(column) + comment
