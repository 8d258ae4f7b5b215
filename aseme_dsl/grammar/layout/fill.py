"""Breaking a line that is too long: at its loosest places first, as few as possible, aligned.

The places of a line make a tree: what stands between the loosest places, in which stand the next loosest.
The tree is built and written without recursion, as formulas may be nested as deep as their authors like.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field

from aseme_dsl.grammar.layout.pieces import GLUED, Piece
from aseme_dsl.records import dataclass

WIDTH = 110
"""How long a line may be, comments at its end not counted."""

FARTHEST = 72
"""The last column at which a continued line begins."""

STEP = 2


@dataclass(slots=True)
class _Node:
    """A run of pieces; `parts` are separated by places of one level, or there are none.

    `start` is how wide it is up to the first comment that ends a line; if there is none, its width.
    """

    first: int
    end: int
    width: int
    start: int
    hard: bool
    parts: list[_Node] = field(default_factory=list)


def flat(pieces: Sequence[Piece]) -> str:
    """The pieces on one line."""
    return "".join([
        piece.text if not index else " " * piece.blanks + piece.text for index, piece in enumerate(pieces)
    ])  # fmt: skip


def fill(pieces: Sequence[Piece], column: int, indentation: int, width: int = WIDTH) -> list[str]:
    """The lines of pieces of which the first stands at `column`.

    The first line is without what stands before it; the others are whole. Where nothing else says so, a
    continued line begins deeper than `indentation`.
    """
    if not any(piece.is_hard for piece in pieces):
        text = flat(pieces)
        if column + len(text) <= width:
            return [text]
    return _Writer(pieces, column, indentation, width).write(_tree(pieces))


def _tree(pieces: Sequence[Piece]) -> _Node:
    """The places at which the pieces may be broken, the loosest on top."""
    open_: list[tuple[int, list[_Node]]] = []
    current = _atom(pieces, 0)
    while current.end < len(pieces):
        level = pieces[current.end].level
        following = _atom(pieces, current.end)
        while open_ and open_[-1][0] > level:
            current = _joined(open_.pop()[1], current, pieces)
        if open_ and open_[-1][0] == level:
            open_[-1][1].append(current)
        else:
            open_.append((level, [current]))
        current = following
    while open_:
        current = _joined(open_.pop()[1], current, pieces)
    return current


def _atom(pieces: Sequence[Piece], first: int) -> _Node:
    """The pieces from `first` that are glued together."""
    end = first + 1
    while end < len(pieces) and pieces[end].level == GLUED:
        end += 1
    width = start = -pieces[first].blanks
    hard = False
    for piece in pieces[first:end]:
        start = start if hard else width + piece.blanks + len(piece.text.partition("\n")[0])
        width += piece.blanks + len(piece.text)
        hard = hard or piece.is_hard
    return _Node(first, end, width, start, hard)


def _joined(parts: list[_Node], last: _Node, pieces: Sequence[Piece]) -> _Node:
    parts.append(last)
    width = start = -pieces[parts[0].first].blanks
    hard = False
    for part in parts:
        if not hard:
            start = width + pieces[part.first].blanks + part.start
        width += pieces[part.first].blanks + part.width
        hard = hard or part.hard
    return _Node(parts[0].first, last.end, width, start, hard, parts)


class _Writer:
    def __init__(self, pieces: Sequence[Piece], column: int, indentation: int, width: int) -> None:
        self.pieces = pieces
        self.width = width
        self.lines: list[str] = []
        self.line: list[str] = []
        self.at = column
        self.fresh = True  # nothing stands on this line yet
        self.ended = False  # a comment has ended this line
        self.broken = False  # what was written last is itself on several lines
        self.depth = 0
        self.starts = {0: indentation + 2 * STEP}  # by depth: the column of its first piece
        self.shifts: dict[int, int] = {}  # by depth: how much deeper a continued line begins

    def write(self, root: _Node) -> list[str]:
        # Each entry is a node, its index in its parent, and the parent's depth. An int instead of a node is a
        # depth: it follows a node that was broken over several lines, and resets the shift to its number.
        todo: list[tuple[_Node | int, int, int]] = [(root, 0, -1)]
        while todo:
            node, number, around = todo.pop()
            if isinstance(node, int):
                self.shifts[node] = number
                self.broken = True
                continue
            depth = self.pieces[node.first].depth
            if number and not self._begins_here(node) and self._start(depth) < self.at:
                self._new_line(depth)
            self.broken = False
            if not node.parts or self._fits(node):
                for piece in self.pieces[node.first : node.end]:
                    self._piece(piece)
                continue
            inner = self.pieces[node.parts[1].first].depth
            before = self.shifts.get(inner, 0)
            todo.append((inner, before, 0))
            if inner == around:
                self.shifts[inner] = before + STEP
            todo += [(part, index, inner) for index, part in reversed(list(enumerate(node.parts)))]
        self._flush()
        return self.lines

    def _fits(self, node: _Node) -> bool:
        blanks = 0 if self.fresh else self.pieces[node.first].blanks
        return not node.hard and not self.ended and self.at + blanks + node.width <= self.width

    def _begins_here(self, node: _Node) -> bool:
        """Whether a node need not begin a line: it fits, and what is before it is on one line."""
        blanks = 0 if self.fresh else self.pieces[node.first].blanks
        return not self.ended and not self.broken and self.at + blanks + node.start <= self.width

    def _piece(self, piece: Piece) -> None:
        if self.ended or (piece.above and not self.fresh):
            self._new_line(piece.depth)
        for comment in piece.above:
            self._put(comment)
            self._new_line(piece.depth)
        if not self.fresh:
            self._put(" " * piece.blanks)
        if piece.depth > self.depth:
            self.starts[piece.depth] = self.at
        self.depth = piece.depth
        self._put(piece.text)
        for comment in piece.after:
            self._put("  " + comment)
            self.ended = True

    def _put(self, text: str) -> None:
        *lines, last = text.split("\n")
        for line in lines:
            self.lines.append("".join([*self.line, line]))
            self.line = []
            self.at = 0
        self.line.append(last)
        self.at += len(last)
        self.fresh = False

    def _start(self, depth: int) -> int:
        """The column of a new line for a piece of `depth`."""
        if depth > self.depth:
            return self._start(self.depth) + STEP
        while depth not in self.starts:  # no piece of this depth has been before
            depth -= 1
        return min(self.starts[depth] + self.shifts.get(depth, 0), FARTHEST)

    def _new_line(self, depth: int) -> None:
        start = self._start(depth)
        self._flush()
        self.line = [" " * start]
        self.at = start
        self.fresh = True
        self.ended = False

    def _flush(self) -> None:
        self.lines.append("".join(self.line))
        self.line = []
