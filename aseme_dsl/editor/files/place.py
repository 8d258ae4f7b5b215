"""Place: where in a text the cursor stands, and what the grammar would take there.

Only the declaration around the cursor is read, and of it only the blocks that are still open. So a place is
found in a file of any length, however broken the rest of it is.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache

from aseme_dsl.editor.reading.reading import at_once
from aseme_dsl.grammar.parsing.expected import Expected, Step, expected_after
from aseme_dsl.grammar.parsing.parts import TooSlow
from aseme_dsl.grammar.text.lexer import Tokens
from aseme_dsl.grammar.text.recovery import declaration_begins
from aseme_dsl.grammar.text.token import Token, token
from aseme_dsl.records import dataclass

_PIECE = re.compile(r'//[^\n]*|/\*[\s\S]*?(?:\*/|\Z)|"(?:[^"\\\n]|\\.)*"?|[{}]')
_NAME_BEFORE = re.compile(r"[A-Za-z_][A-Za-z0-9_]*\Z|[0-9]+(?:\.[0-9]*)*\Z")
_DOTTED = re.compile(r"(?<![\w.])(?:[A-Za-z_][A-Za-z0-9_]*\s*\.\s*)+\Z")
_FILLED = re.compile(
    r"(?:\b(?:send|busy)\s+\w+\s+\w+|\bwrite_messages(?:\s*\.\s*\w+)+|[=(,?:]\s*\w+(?:\s*\.\s*\w+)*)\s*\Z"
)
"""A message that is sent, published or made, before the braces that fill it."""
_IN_ONE_PIECE = ("ControlToken", "BusyToken")
_MAY_BE_DOTTED = ("Path", "Reference", "EntryReference", "ProtocolName", "RoleName", "IncludedName")
_NAME_AFTER = re.compile(r"[A-Za-z0-9_]*")
_LONG = 12_000
"""How many characters of one open block are read at most."""


@dataclass(frozen=True, slots=True)
class Place:
    """The cursor at `offset`, in or beside the word `start … end`; in a text in quotes, that is what it says.

    `inside` is "code", "comment" or "text". `first` is where the declaration begins. `read` is the text from
    there to `start`, in which comments and closed blocks are blank. `block` is where its innermost open
    block begins in it (-1 outside). `expected` is what may follow. A dotted name whose begin, the `path`,
    stands there already, counts as still to come.
    """

    text: str
    offset: int
    start: int
    end: int
    inside: str
    first: int
    read: str
    block: int
    expected: tuple[Expected, ...]
    path: tuple[str, ...] = ()

    @property
    def half(self) -> str:
        """The part of the word before the cursor."""
        return self.text[self.start : self.offset]

    @property
    def rest_of_line(self) -> str:
        """What stands behind the word on its line."""
        stop = self.text.find("\n", self.end)
        return self.text[self.end : stop if stop >= 0 else len(self.text)]

    def begin_of(self, step: Step) -> int:
        """The offset at which a rule of the grammar has been begun."""
        return self.first + step.start

    def entry_of(self, expected: Expected) -> Step | None:
        """The entry of the innermost block, or the declaration, that what is expected is part of."""
        block = self.first + self.block if self.block >= 0 else -1
        return next((step for step in expected.steps[1:] if self.begin_of(step) > block), None)

    @property
    def entry(self) -> int | None:
        """Where the entry, or outside of all blocks the declaration, begins that the cursor is in."""
        steps = [step for item in self.expected if (step := self.entry_of(item)) is not None]
        begun = [self.begin_of(step) for step in steps if step.start < len(self.read.rstrip())]
        return min(begun, default=None)

    def tokens(self, since: Step) -> list[Token]:
        """The tokens from where the rule was begun up to the word."""
        return list(_tokens(self.read, since.start, self.first))

    def tokens_from(self, offset: int) -> list[Token]:
        """The tokens from an offset up to the word."""
        return list(_tokens(self.read, offset - self.first, self.first))


def place_at(text: str, offset: int) -> Place:
    """The place of a cursor before the character at `offset`."""
    offset = max(0, min(offset, len(text)))
    before = _NAME_BEFORE.search(text, max(0, offset - 100), offset)
    start = before.start() if before is not None else offset
    after = _NAME_AFTER.match(text, offset)
    end = after.end() if after is not None else offset
    first = begin_of_declaration(text, start)
    inside, piece, read, block = _read(text, first, start, offset)
    if inside == "comment":
        return Place(text, offset, start, end, inside, first, read, block, ())
    if inside == "text":
        start, end = piece + 1, _end_of_text(text, offset)
        if text.find("\n", piece, offset) >= 0:
            start = offset  # it was closed on its line
    expected = _expected(read)
    path: tuple[str, ...] = ()
    if block >= 0 and _FILLED.search(read, max(0, block - 200), block):
        # The grammar reads a message with its braces in one piece: what was expected before them still is.
        expected = tuple(item for item in _expected(read[:block]) if item.terminal in _IN_ONE_PIECE)
        block = _open_brace(read[:block])
    if not expected:
        read, expected, path = _in_dotted_name(read)
    if not expected and block >= 0:
        # What stands before in the block has gone wrong: begin again on the cursor's line.
        line = text.rfind("\n", 0, start) + 1 - first
        if line > block:
            read = read[: block + 1] + _blank(read[block + 1 : line]) + read[line:]
            expected = _expected(read)
            if not expected:
                read, expected, path = _in_dotted_name(read)
    return Place(text, offset, start, end, inside, first, read, block, expected, path)


def _open_brace(read: str) -> int:
    """Where the innermost block begins that is open at the end; -1 if none is."""
    depth = 0
    for index in range(len(read) - 1, -1, -1):
        depth += (read[index] == "}") - (read[index] == "{")
        if depth < 0:
            return index
    return -1


def _in_dotted_name(read: str) -> tuple[str, tuple[Expected, ...], tuple[str, ...]]:
    """The text without the begin of a dotted name at its end, which the grammar reads in one piece."""
    dotted = _DOTTED.search(read, max(0, len(read) - 200))
    if dotted is None:
        return read, (), ()
    expected = tuple(item for item in _expected(read[: dotted.start()]) if item.terminal in _MAY_BE_DOTTED)
    if not expected:
        return read, (), ()
    return read[: dotted.start()], expected, tuple(part.strip() for part in dotted.group().split(".")[:-1])


@lru_cache(maxsize=16)
def _expected(read: str) -> tuple[Expected, ...]:
    try:
        return at_once(expected_after, read)
    except TooSlow:
        return ()


def begin_of_declaration(text: str, offset: int) -> int:
    """Where the last declaration begins that begins before `offset`; 0 if none does."""
    line = text.rfind("\n", 0, offset) + 1
    while True:
        begin = declaration_begins(text, line)
        if begin is not None and begin < offset and not _in_comment(text, begin):
            return begin
        if line == 0:
            return 0
        line = text.rfind("\n", 0, line - 1) + 1


def end_of_declaration(text: str, begin: int) -> int:
    """Where the next declaration begins after the one that begins at `begin`; the end of the text if none."""
    line = text.find("\n", begin) + 1
    while line > 0:
        found = declaration_begins(text, line)
        if found is not None and not _in_comment(text, found):
            return found
        line = text.find("\n", line) + 1
    return len(text)


def _in_comment(text: str, offset: int) -> bool:
    """Whether a comment over several lines, begun at the begin of a line, goes beyond `offset`."""
    opened = text.rfind("/*", 0, offset)
    if opened < 0 or text.find("*/", opened, offset) >= 0:
        return False
    before = text[text.rfind("\n", 0, opened) + 1 : opened]
    return "//" not in before and before.count('"') % 2 == 0


def _read(text: str, first: int, start: int, offset: int) -> tuple[str, int, str, int]:
    """What the cursor is inside of, where that begins, the text up to it with blanks, and its open block.

    The block is the offset in the read text of the innermost `{` that is not closed, -1 if there is none.
    """
    inside, piece = "code", start
    parts: list[tuple[int, int]] = []  # what is to be blank
    open_: list[int] = []
    for found in _PIECE.finditer(text, first, offset):
        sign = found.group()
        if sign == "{":
            open_.append(found.start())
        elif sign == "}":
            if open_:
                opened = open_.pop()
                parts.append((opened + 1, found.start()))
        elif sign[0] == "/":
            if found.end() == offset and not (
                sign.startswith("/*") and sign.endswith("*/") and len(sign) > 3
            ):
                inside, piece = "comment", found.start()
            parts.append((found.start(), found.end()))
        elif found.end() == offset and not (len(sign) > 1 and sign[-1] == '"' and sign[-2:] != '\\"'):
            inside, piece = "text", found.start()
    stop = piece if inside != "code" else start
    read = text[first:stop]
    for begin, end in _outermost(parts, stop):
        read = read[: begin - first] + " " * (end - begin) + read[end - first :]
    block = next((item - first for item in reversed(open_) if item < stop), -1)
    if block >= 0 and len(read) - block > _LONG:
        read = _shortened(read, block)
    return inside, piece, read, block


def _outermost(parts: list[tuple[int, int]], stop: int) -> Iterator[tuple[int, int]]:
    reached = -1
    for begin, end in sorted(parts, key=lambda item: (item[0], -item[1])):
        if begin >= reached and begin < stop:
            yield begin, min(end, stop)
            reached = end


def _shortened(read: str, block: int) -> str:
    """Without the entries far above in a long block, up to a line that is indented as the first one."""
    indentation = _indentation(read, block + 1)
    line = read.find("\n", len(read) - _LONG // 2) + 1
    while 0 < line < len(read):
        blanks = len(read) - line - len(read[line:].lstrip(" \t"))
        if blanks <= indentation and read[line + blanks : line + blanks + 1] not in ("\n", "", "|", "."):
            return read[: block + 1] + _blank(read[block + 1 : line]) + read[line:]
        line = read.find("\n", line) + 1
    return read


def _indentation(read: str, begin: int) -> int:
    for line in read[begin : begin + 2000].split("\n")[1:]:
        if line.strip():
            return len(line) - len(line.lstrip())
    return 0


def _blank(text: str) -> str:
    return re.sub(r"[^\n]", " ", text)


def _end_of_text(text: str, offset: int) -> int:
    found = re.compile(r'(?:[^"\\\n]|\\.)*').match(text, offset)
    return found.end() if found is not None else offset


def _tokens(read: str, start: int, base: int) -> Iterator[Token]:
    piece = read[start:]
    tokens = Tokens(piece)
    for begin, end in zip(tokens.starts, tokens.ends, strict=True):
        yield token(piece[begin:end], base + start + begin)


__all__ = ["Place", "begin_of_declaration", "end_of_declaration", "place_at"]
