"""From the parse tree of a file to its blocks, lines and pieces.

All tokens come from the leaves of the tree, in their order; none can get lost but those of `DROPPED`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from aseme_dsl.grammar.formulas.filling import apart
from aseme_dsl.grammar.formulas.statement import statement_starts
from aseme_dsl.grammar.layout.fill import STEP, WIDTH
from aseme_dsl.grammar.layout.gaps import Gaps
from aseme_dsl.grammar.layout.pieces import GLUED, Block, Gap, Piece, Row
from aseme_dsl.grammar.layout.rules import (
    DROPPED,
    EXPRESSIONS,
    FORMULAS,
    SHAPES,
    Braces,
    Line,
    Part,
    Shape,
    Words,
)
from aseme_dsl.grammar.layout.spacing import expression, formula, level_of
from aseme_dsl.grammar.parsing.progress import ParseNode
from aseme_dsl.grammar.text.token import Token, token
from aseme_dsl.grammar.text.tree import Comment
from aseme_dsl.source import Source

_TIGHT_AFTER = frozenset(("(", "[", "..", "@", "#", "."))
_TIGHT_BEFORE = frozenset((")", "]", ",", "..", "@", "#", "."))
_LIST, _BREAK = 0, 1
_OPERATORS = frozenset(("and", "or", "&&", "||"))
_JOINING = _OPERATORS | frozenset("leads before until within ends writes sends sets takes".split())
"""The words of a statement before which it is broken."""


def _width(row: Row, words: Sequence[Token]) -> int:
    """How wide a row is with the bracket with which these words begin, up to its end."""
    width = sum(piece.blanks + len(piece.text) for piece in row.pieces) + 1
    depth = 0
    for word in words:
        depth += (word == "(") - (word == ")")
        width += len(word) + (word == ",")
        if depth <= 0:
            break
    return width


def read_blocks(source: Source, tree: ParseNode, comments: Sequence[Comment]) -> Block:
    """The whole file as one block, whose braces are not written."""
    return _Reader(source, comments).file(tree)


class _Reader:
    """Collects the pieces of a file while it walks over the parse tree; `gaps` has the comments."""

    def __init__(self, source: Source, comments: Sequence[Comment]) -> None:
        self.source = source
        self.text = source.text
        self.gaps = Gaps(source.text, comments)
        self.end = 0  # of the last token
        self.trailing: list[str] = []  # where comments go that end its line
        self.row = Row("")
        self.shape: Line | Part | Braces | Words = Line()
        self.column: int | None = None  # the column that the next piece begins
        self.broken = False  # in words: a line was begun where lines count
        self.last = ""  # the last token
        self.loose = False  # the next piece is

    # ---- the file ------------------------------------------------------------------------------

    def file(self, tree: ParseNode) -> Block:
        found = Block("File", Row("File"))
        start: Row | None = None
        for child in tree[0]:
            if _is_terminal(child):
                if child.value:
                    start = start or self.begin("File")
                    self.keyword(child, 0)
            elif child.rule._attr_name == "declarations":
                if start is not None:
                    self.finish(start)
                    found.entries.append(start)
                    start = None
                found.entries += self.entries(child)
            else:
                self.assigned(child, 0)
        if start is not None:
            self.finish(start)
            found.entries.append(start)
        gap = self.gaps.between(self.end, len(self.text))
        first = not found.entries
        own = gap.own
        if first or gap.newline:
            own = (*(((False, " ".join(gap.trailing)),) if first and gap.trailing else ()), *own)
            if gap.leading:
                own = (*own, (gap.blank, " ".join(gap.leading)))
            if not first:
                self.end_line(gap)
        elif gap.leading:
            self.trailing.append(" ".join(gap.leading))
        found.before_close = own
        return found

    def entries(self, nodes: ParseNode) -> Iterator[Row | Block]:
        for node in nodes:
            while node.rule_name not in SHAPES:
                (node,) = node
            yield self.entry(node)

    def entry(self, node: ParseNode) -> Row | Block:
        shape = SHAPES[node.rule_name]
        if isinstance(shape, (Braces, Words)):
            return self.block(node, shape)
        row = self.begin(node.rule_name)
        self.line(node, shape, 0)
        self.finish(row)
        return row

    def begin(self, rule: str) -> Row:
        self.row = Row(rule)
        self.column = 0
        return self.row

    def finish(self, row: Row) -> None:
        self.trailing = row.trailing

    # ---- blocks --------------------------------------------------------------------------------

    def block(self, node: ParseNode, shape: Braces | Words) -> Block:
        found = Block(node.rule_name, self.begin(node.rule_name))
        self.shape = shape
        opened = False
        for child in node:
            if _is_terminal(child):
                self.keyword(child, 0)
            elif child.rule_name == "Open":
                self.opening(child, found)
                opened = True
            elif child.rule_name == "Close":
                self.closing(child[0].value, found)
            elif opened:
                self.body(child, shape, found)
            else:
                self.assigned(child, 0)
                self.shape = shape
        self.trailing = found.trailing
        return found

    def opening(self, node: ParseNode, found: Block) -> None:
        self.column = 1
        self.piece(node[0].value, 0)
        following = self.gaps.after(self.end)
        found.one_line = not following.newline
        self.trailing = found.after_open

    def body(self, node: ParseNode, shape: Braces | Words, found: Block) -> None:
        if isinstance(shape, Braces):
            found.entries += self.entries(node)
            return
        self.broken = False
        words = _words(node)
        starts = statement_starts(self.source, words, found.rule == "Property")
        found.entries += self.statements(words, starts)
        found.one_line = found.one_line and not self.broken

    def closing(self, brace: Token, found: Block) -> None:
        gap = self.gaps.between(self.end, brace.start)
        self.end = brace.end
        if gap.newline:
            self.end_line(gap)
            found.before_close = gap.own
            if gap.leading:
                found.before_close = (*gap.own, (gap.blank, " ".join(gap.leading)))
        elif gap.leading:
            found.inside_empty = gap.leading

    # ---- lines of words ------------------------------------------------------------------------

    def statements(self, words: Sequence[Token], starts: frozenset[int] | None) -> list[Row | Block]:
        """A row for each statement; braces opened at the end of a line hold lines of the author again.

        Without `starts`, where something is wrong, a row for each line of the author.
        """
        top: list[Row | Block] = []
        open_: list[Block] = []
        closing = _closing(words)
        entries = top
        row: Row | None = None
        inline = 0  # braces that stay in their row
        inside = 0  # brackets in the lines of the author, which do not end in them
        for index, word in enumerate(words):
            gap = self.gaps.between(self.end, word.start)
            begins = row is None or (gap.newline and not inline and inside <= 0)
            if row is not None and word == "(" and self.last == ")" and open_ and not inline:
                begins = begins or _width(row, words[index:]) > WIDTH - STEP * (len(open_) + 1)
            if starts is not None and not open_:
                begins = row is None or word.start in starts
            if begins and word != "}":
                if row is not None:
                    self.finish(row)
                    if not open_:
                        self.broken = True
                row = self.begin("Words")
                entries.append(row)
            inside = 0 if row is None or not open_ else inside + (word in "([") - (word in ")]")
            following = words[index + 1] if index + 1 < len(words) else None
            if word == "{":
                assert row is not None
                if not inline and self.holds_lines(words, index, closing[index], starts):
                    self.word(word, 1, row)
                    block = Block("Words", row)
                    entries[-1] = block
                    open_.append(block)
                    self.trailing = block.after_open
                    entries = block.entries
                    row = None
                    self.broken = True
                    continue
                inline += 1
            elif word == "}":
                if inline:
                    inline -= 1
                else:
                    if row is not None:
                        self.finish(row)
                    closed = open_.pop()
                    self.closing(word, closed)
                    self.trailing = closed.trailing
                    entries = open_[-1].entries if open_ else top
                    row = None
                    continue
            assert row is not None
            self.word(word, inline, row, following, starts is not None)
        if row is not None:
            self.finish(row)
        return top

    def holds_lines(
        self, words: Sequence[Token], opening: int, closing: int, starts: frozenset[int] | None
    ) -> bool:
        """Whether the line is broken behind an opening brace, and behind the closing one."""
        ends = closing + 1 == len(words) or words[closing + 1] == "}"
        ends = ends or (starts is not None and words[closing + 1].start in starts)
        return self._breaks(words, opening) and (ends or self._breaks(words, closing))

    def _breaks(self, words: Sequence[Token], index: int) -> bool:
        return "\n" in self.text[words[index].end : words[index + 1].start]

    def word(
        self, word: Token, inline: int, row: Row, following: Token | None = None, breaks: bool = False
    ) -> None:
        """A word of a row: with a blank before it where the author has one, and around `:` and `=`.

        `breaks`: a row that is too long is broken before the words that join its parts.
        """
        touches = word.start == self.end and word not in (":", "=") and self.last not in (":", "=")
        blanks = 0 if touches else 1
        depth, level = 0, GLUED
        if inline and row.pieces:
            before = row.pieces[-1].text
            if word in ("{", "}") or before == "{":
                blanks = 1
            elif following == "=" and before not in ("=", ",", "("):
                blanks = 2
        if breaks and row.pieces:
            last = row.pieces[-1]
            depth = last.depth + last.text.endswith(("(", "[", "{")) - (word in (")", "]", "}"))
            if word in _JOINING or self.last in _OPERATORS:
                blanks = max(blanks, 1)
            elif row.pieces[0].text == "world" and ":" in (word, self.last):
                blanks = 0
            if word in _JOINING or blanks == 2:
                level = level_of(depth, _BREAK)
            elif self.last == ",":
                level = level_of(depth, _LIST)
        if len(row.pieces) == 2 and row.pieces[1].text[0].isdigit() and blanks:
            self.column = 1
        self.piece(word, depth, blanks, level)

    # ---- lines ---------------------------------------------------------------------------------

    def line(self, node: ParseNode, shape: Shape, depth: int) -> None:
        """The pieces of a rule that stands on a line."""
        outer, self.shape = self.shape, shape
        columns = shape.columns if isinstance(shape, Line) else {}
        for child in node:
            if _is_terminal(child):
                if child.rule_name in DROPPED:
                    continue
                self.column = columns.get(child.value, self.column) if child.rule_name == "" else self.column
                self.keyword(child, depth)
                continue
            attribute = getattr(child.rule, "_attr_name", None)
            if attribute is None:
                self.part(child, columns, depth)
            else:
                self.column = columns.get(attribute, self.column)
                self.loose = isinstance(shape, Line) and attribute == shape.loose
                self.assigned(child, depth, columns)
        self.shape = outer

    def part(self, node: ParseNode, columns: Mapping[str, int], depth: int) -> None:
        while node.rule_name not in SHAPES:
            if _is_terminal(node):
                self.piece(node.value, depth)
                return
            (node,) = node
        self.column = columns.get(node.rule_name, self.column)
        self.line(node, SHAPES[node.rule_name], depth)

    def assigned(self, node: ParseNode, depth: int, columns: Mapping[str, int] | None = None) -> None:
        """What is assigned to an attribute: one thing, or a list."""
        first = node[0]
        if _is_terminal(first) and first.rule_name in FORMULAS:
            words = [leaf.value for leaf in node]
            self.tokens(words, formula(words, depth + 1))
            return
        if _is_terminal(first) and first.rule_name in EXPRESSIONS:
            words = apart(leaf.value for leaf in node)
            pieces = expression(words, depth + 1, transition=first.rule_name == "ControlToken")
            self.tokens(words, pieces)
            return
        is_list = any(_is_terminal(child) and child.rule_name == "sep" for child in node)
        separated = ""
        for child in node:
            inside = depth + is_list
            if _is_terminal(child) and child.rule_name == "sep":
                separated = child.value
                level = GLUED if separated == "," else level_of(inside, _LIST)
                self.piece(child.value, inside, level=level)
                continue
            level = level_of(inside, _LIST) if separated == "," else GLUED
            separated = ""
            before = len(self.row.pieces)
            if _is_terminal(child):
                self.piece(child.value, inside)
            else:
                self.part(child, columns or {}, inside)
            if level != GLUED and before < len(self.row.pieces):
                self.row.pieces[before].level = level

    def keyword(self, leaf: ParseNode, depth: int) -> None:
        shape = self.shape
        level = GLUED
        if isinstance(shape, (Line, Part)) and leaf.value in shape.breaks:
            level = level_of(depth, _BREAK)
        self.piece(leaf.value, depth, level=level)

    def tokens(self, words: Sequence[Token], pieces: Sequence[Piece]) -> None:
        pieces[0].blanks = 0 if self.last == "[" else 1
        for word, piece in zip(words, pieces, strict=True):
            self.piece(word, piece.depth, piece.blanks, piece.level, piece.text)

    # ---- pieces --------------------------------------------------------------------------------

    def piece(
        self,
        text: Token,
        depth: int,
        blanks: int | None = None,
        level: int = GLUED,
        written: str | None = None,
    ) -> None:
        """Add a token, and the comments before it."""
        if blanks is None:
            blanks = self.blanks(text)
        made = Piece(written or str(text), blanks, level, depth)
        if text[0] != '"' and (" " in text or "\n" in text or "\t" in text or "\r" in text):
            self.split(text, made)
        else:
            self.add(text, made)

    def split(self, text: Token, made: Piece) -> None:
        """A token in which the author has blanks: they are not kept, comments in it are."""
        begin = end = text.start
        written = ""
        for part in text.split():
            start = self.gaps.find(part, end)
            if self.gaps.has_comment(end, start):
                self.add(token(self.text[begin:end], begin), replace(made, text=written))
                made = replace(made, blanks=0, level=GLUED)
                begin, written = start, ""
            written += part
            end = start + len(part)
        self.add(token(self.text[begin:end], begin), replace(made, text=written))

    def add(self, text: Token, piece: Piece) -> None:
        gap = self.gaps.between(self.end, text.start)
        row = self.row
        piece.starts_line = gap.newline
        if not row.pieces:
            self.first(gap, row)
        else:
            if gap.trailing:
                row.pieces[-1].after += gap.trailing
            piece.above = (*gap.hanging, *(comment for _, comment in gap.own))
        if gap.leading:
            piece.text = " ".join([*gap.leading, piece.text])
            if piece.blanks == 0 and row.pieces:
                piece.blanks = 1
        if self.column is not None:
            piece.column = self.column
            self.column = None
        piece.loose = self.loose
        self.loose = False
        row.pieces.append(piece)
        self.end = text.end
        self.last = str(text)

    def first(self, gap: Gap, row: Row) -> None:
        """The comments before an entry."""
        row.above = gap.own
        row.blank = gap.blank
        if self.end == 0 and gap.trailing:
            row.above = ((False, " ".join(gap.trailing)), *row.above)
        else:
            self.end_line(gap)

    def end_line(self, gap: Gap) -> None:
        """Give the line before a gap the comments at its end."""
        if gap.trailing:
            self.trailing += [" ".join(gap.trailing), *gap.hanging]

    def blanks(self, text: Token) -> int:
        tight = text in _TIGHT_BEFORE or self.last in _TIGHT_AFTER or text in self.shape.tight.split()
        return 0 if tight else 1


def _is_terminal(node: ParseNode) -> bool:
    return not isinstance(node, list)


def _words(node: ParseNode) -> list[Token]:
    """The leaves below a node."""
    found: list[Token] = []
    todo = [node]
    while todo:
        item = todo.pop()
        if _is_terminal(item):
            found.append(item.value)
        else:
            todo.extend(reversed(item))
    return found


def _closing(words: Sequence[str]) -> dict[int, int]:
    """The index of the `}` of each `{`."""
    pairs: dict[int, int] = {}
    open_: list[int] = []
    for index, word in enumerate(words):
        if word == "{":
            open_.append(index)
        elif word == "}":
            pairs[open_.pop()] = index
    return pairs
