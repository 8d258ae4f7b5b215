"""From the blocks and lines of a file to its text."""

from __future__ import annotations

from collections.abc import Sequence

from aseme_dsl.grammar.layout.fill import STEP, WIDTH, fill, flat
from aseme_dsl.grammar.layout.pieces import Block, Piece, Row
from aseme_dsl.grammar.layout.rules import SHAPES, Braces
from aseme_dsl.grammar.layout.sections import UNLIMITED, add_comments, is_pinned, lines_of_section


def write_blocks(file: Block) -> str:
    """The text of a file, with `\\n` at the end of each line."""
    writer = _Writer()
    writer.entries(file, 0)
    return "".join([line + "\n" for line in writer.lines])


class _Writer:
    def __init__(self) -> None:
        self.lines: list[str] = []

    def entries(self, block: Block, indentation: int) -> None:
        """All that stands between the braces of a block."""
        section: list[Row] = []
        after_block = False  # at the top, blocks are set apart
        first = True
        for entry in block.entries:
            shown = _one_line(entry, indentation) if isinstance(entry, Block) else entry
            is_block = not isinstance(shown, Row)
            apart = not indentation and (after_block or (is_block and not _has_blank(entry)))
            if is_block or (entry.above and entry.above[0][0]) or entry.blank or apart:
                self.section(section, indentation)
                section = []
            if not section:
                self.above(entry, indentation, first, apart)
            if isinstance(shown, Row):
                section.append(shown)
            else:
                self.block(shown, indentation)
            after_block = is_block
            first = False
        self.section(section, indentation)
        own = block.before_close
        if block.inside_empty:
            own = (*own, (False, " ".join(block.inside_empty)))
        self.comments(own, indentation, first, after_block and not indentation)

    def block(self, block: Block, indentation: int) -> None:
        """A block whose braces are on different lines."""
        width = UNLIMITED if is_pinned(block.header) else WIDTH
        header, *others = fill(block.header.pieces, indentation, indentation, width)
        self.lines += [" " * indentation + header, *others]
        add_comments(self.lines, block.after_open, len(self.lines[-1]) + 2)
        self.entries(block, indentation + STEP)
        self.lines.append(" " * indentation + "}")
        add_comments(self.lines, block.trailing, len(self.lines[-1]) + 2)

    def section(self, rows: Sequence[Row], indentation: int) -> None:
        """Rows without a blank line between them; what is above the first one is written already."""
        if not rows:
            return
        for index, (row, lines) in enumerate(zip(rows, lines_of_section(rows, indentation), strict=True)):
            if index:
                self.comments(row.above, indentation)
            self.lines += lines

    def above(self, entry: Row | Block, indentation: int, first: bool, apart: bool) -> None:
        """The blank line and the comments before an entry that begins a section."""
        if not entry.above:
            if not first and (apart or entry.blank):
                self.lines.append("")
            return
        self.comments(entry.above, indentation, first, apart)
        if entry.blank:
            self.lines.append("")

    def comments(
        self, own: Sequence[tuple[bool, str]], indentation: int, first: bool = False, apart: bool = False
    ) -> None:
        """Comments on lines of their own."""
        for index, (blank, comment) in enumerate(own):
            if (blank or (apart and not index)) and not (first and not index):
                self.lines.append("")
            self.lines.append(" " * indentation + comment)


def _has_blank(entry: Row | Block) -> bool:
    return entry.blank or any(blank for blank, _ in entry.above)


def _one_line(block: Block, indentation: int) -> Row | Block:
    """A block as a row, if its author has begun it on one line, and it fits."""
    if not block.one_line or block.before_close or block.after_open:
        return block
    inside = _flat_entries(block)
    if inside is None or any(piece.is_hard for piece in block.header.pieces):
        return block
    *header, brace = block.header.pieces
    text = " ".join([brace.text, *([inside] if inside else []), *block.inside_empty, "}"])
    body = Piece(text, column=1)
    row = Row(block.rule, [*header, body], block.above, block.blank, block.trailing)
    if not is_pinned(row) and indentation + len(flat(row.pieces)) > WIDTH:
        return block
    return row


def _flat_entries(block: Block) -> str | None:
    """The entries of a block on one line; None if they cannot be."""
    texts: list[str] = []
    for entry in block.entries:
        if entry.above or entry.trailing:
            return None
        if isinstance(entry, Block):
            row = _one_line(entry, 0)
            if not isinstance(row, Row):
                return None
            texts.append(flat(row.pieces))
        elif any(piece.is_hard for piece in entry.pieces):
            return None
        else:
            texts.append(flat(entry.pieces))
    shape = SHAPES.get(block.rule)
    gap = shape.gap if isinstance(shape, Braces) else 2
    if block.rule == "Enum" and any(
        len(entry.pieces) > 1 for entry in block.entries if isinstance(entry, Row)
    ):
        gap = 2
    return (" " * gap).join(texts)
