"""Trace blocks: where in a trace of JSON lines a reader can begin, without what comes before."""

from __future__ import annotations

import json
import re
import struct
import zlib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from io import BufferedReader
from itertools import takewhile

from aseme_dsl import outside
from aseme_dsl.runtime.trace.trace_mcap import LONGEST

BLOCK = 256 << 10
"""So many bytes of lines are a block; the last line of one may be longer."""
LEVEL = 5
"""How hard a block is compressed: 6 makes a match a fifteenth smaller, and takes half as long again."""
OPEN = 1
"""The flag of a block that another one with the same lines and further ones will replace."""
CHANGED = 2
"""The flag of a block with a line that tells which model or plan an agent runs from there on."""

_START = b"\x1f\x8b\x08\x04\0\0\0\0\0\xff"
"""How a member of a gzip file begins that has further members in its header (RFC 1952)."""
_FIELD = b"AS"
_FIXED = struct.Struct("<BQQQqq")
"""Flags, bytes in the file, the number of the first line from 1, how many lines, and the times of the first
and of the last one."""
_LONGEST_FIELD = 60_000
_MARKED = re.compile(
    rb'\n\{"kind":"(checkpoint|swap|select)","time":(-?\d+)(?:,"agent":("(?:[^"\\]|\\.)*"))?'
)
"""It begins with the end of a line, which is found sixteen times as fast as the begin of the next."""
_TIME = re.compile(rb'"time": ?(-?\d+)')
CHANGES = (b"swap", b"select")
"""The kinds of lines that tell which model or plan an agent runs from there on."""


@dataclass(frozen=True, slots=True)
class Block:
    """A part of a trace that can be read by itself: its place in the file, and what is in it."""

    offset: int
    size: int
    line: int
    """The number of its first line, from 1."""
    lines: int
    first: int
    """The time of its first line, in ns."""
    last: int
    """The time of its last line, in ns."""
    checkpoints: Mapping[str, int] = field(default_factory=dict)
    """Of each agent that has a checkpoint here the time of the first one, in ns."""
    flags: int = 0

    @property
    def is_open(self) -> bool:
        """Whether another block with these lines and further ones will replace it."""
        return bool(self.flags & OPEN)

    @property
    def changes(self) -> bool:
        """Whether a line tells which model or plan an agent runs from there on."""
        return bool(self.flags & CHANGED)


def block_of(data: bytes, offset: int, size: int, line: int, flags: int = 0) -> Block:
    """What is in a part of a trace: whole lines, of which the first has the number `line`."""
    checkpoints: dict[str, int] = {}
    for found in _MARKED.finditer(b"\n" + data):
        if found[1] in CHANGES:
            flags |= CHANGED
        elif found[3] is not None:
            checkpoints.setdefault(str(outside.loads(found[3])), int(found[2]))
    first = _time(data, 0)
    last = _time(data, data.rfind(b"\n", 0, -1) + 1)
    return Block(offset, size, line, data.count(b"\n"), first, last, checkpoints, flags)


def _time(data: bytes, place: int) -> int:
    found = _TIME.search(data, place)
    return 0 if found is None else int(found[1])


def packed(data: bytes, line: int, flags: int = 0) -> bytes:
    """Lines, of which the first has the number `line`, as a member of a gzip file that says what is in it."""
    block = block_of(data, 0, 0, line, flags)
    marks = b""
    if block.checkpoints:
        marks = zlib.compress(json.dumps(dict(block.checkpoints), separators=(",", ":")).encode())
        if len(marks) > _LONGEST_FIELD:  # of a hundred thousand agents: a reader begins further up
            marks = b""
    packer = zlib.compressobj(LEVEL, zlib.DEFLATED, -zlib.MAX_WBITS)
    content = packer.compress(data) + packer.flush()
    length = _FIXED.size + len(marks)
    size = len(_START) + 2 + 4 + length + len(content) + 8
    told = _FIXED.pack(block.flags, size, line, block.lines, block.first, block.last)
    return b"".join(
        (
            _START,
            struct.pack("<H2sH", 4 + length, _FIELD, length),
            told,
            marks,
            content,
            struct.pack("<II", zlib.crc32(data), len(data) & 0xFFFFFFFF),
        )
    )


def packed_blocks(file: BufferedReader, offset: int = 0) -> Iterator[Block]:
    """The blocks of a compressed trace from a place on, as far as their headers say.

    Only the headers are read. None in a file that another program has compressed.
    """
    while True:
        file.seek(offset)
        start = file.read(len(_START) + 6 + _FIXED.size)
        if len(start) < len(_START) + 6 + _FIXED.size or not start.startswith(_START):
            return
        _, name, length = struct.unpack_from("<H2sH", start, len(_START))
        flags, size, line, lines, first, last = _FIXED.unpack_from(start, len(_START) + 6)
        if name != _FIELD or length < _FIXED.size or size <= len(start):
            return
        marks: object = {}
        if length > _FIXED.size:
            try:
                told = file.read(length - _FIXED.size)
                marks = outside.loads(zlib.decompressobj().decompress(told, LONGEST))
            except (ValueError, zlib.error):
                return
        if not isinstance(marks, dict) or not all(isinstance(moment, int) for moment in marks.values()):
            return
        yield Block(offset, size, line, lines, first, last, marks, flags)
        offset += size


def plain_blocks(file: BufferedReader) -> Iterator[Block]:
    """The blocks of a trace that is not compressed: its lines are read, but not decoded."""
    offset, line = 0, 1
    file.seek(0)
    while data := file.read(BLOCK):
        data += next(outside.lines(file, LONGEST), b"")
        block = block_of(data, offset, len(data), line)
        yield block
        offset += len(data)
        line += block.lines


def is_ours(file: BufferedReader) -> bool:
    """Whether a compressed file begins as a trace does, as far as it has been written."""
    file.seek(0)
    start = file.read(len(_START))
    file.seek(0)
    return _START.startswith(start)


def unpacked(data: bytes) -> bytes:
    """The lines of a block of a compressed file. Raises zlib.error if it is damaged or not whole."""
    reader = zlib.decompressobj(zlib.MAX_WBITS + 16)
    found = reader.decompress(data, LONGEST + BLOCK)
    if not reader.eof:
        raise zlib.error("it is not whole")
    return found


def start_for(blocks: Iterable[Block], moment: int, agents: Iterable[str]) -> Block | None:
    """The newest block from which on each agent has a checkpoint not later than `moment`; None if none is.

    `blocks` are those from the first on.
    """
    missing = set(agents)
    known = list(takewhile(lambda block: block.first <= moment, blocks))
    for block in reversed(known):
        missing.difference_update(
            name for name, first in block.checkpoints.items() if name in missing and first <= moment
        )
        if not missing:
            return block
    return None


__all__ = [
    "BLOCK",
    "CHANGES",
    "OPEN",
    "Block",
    "block_of",
    "is_ours",
    "packed",
    "packed_blocks",
    "plain_blocks",
    "start_for",
    "unpacked",
]
