"""Trace blocks: where in a trace of JSON lines a reader can begin, without what comes before."""

from __future__ import annotations

import json
import os
import re
import struct
import zlib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field
from io import BufferedReader
from itertools import takewhile
from typing import Protocol

from aseme_dsl import outside
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.trace.trace_check import LATEST
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
_LARGEST_MARKS = 1 << 20
"""So many bytes the checkpoints in the header of a block have at most, unpacked."""
_PIECE = 1 << 16
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


class Damaged(Exception):
    """A compressed trace says what cannot be; the text says what, and where."""


class Unpacker(Protocol):
    """What `zlib.decompressobj` gives."""

    @property
    def eof(self) -> bool: ...

    @property
    def unused_data(self) -> bytes: ...

    @property
    def unconsumed_tail(self) -> bytes: ...

    def copy(self) -> Unpacker: ...

    def decompress(self, data: bytes, max_length: int = 0, /) -> bytes: ...


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

    Only the headers are read. None in a file that another program has compressed. The last one may be torn:
    it is as large as what is left of it.

    Raises:
        Damaged: the header of a block says what cannot be.
    """
    end = os.fstat(file.fileno()).st_size
    number: int | None = None
    while offset < end:
        block = _packed_block(file, offset, end)
        if block is None:
            return
        if block.size < 1 or block.lines < 0 or (number or block.line) != block.line < LATEST:
            raise Damaged(f"the header of the block at byte {offset} is damaged")
        yield block
        number = block.line + block.lines
        offset += block.size


def _packed_block(file: BufferedReader, offset: int, end: int) -> Block | None:
    """The block at a place of a file, which ends at `end`; None if none begins there."""
    file.seek(offset)
    start = file.read(len(_START) + 6 + _FIXED.size)
    if len(start) < len(_START) + 6 + _FIXED.size or not start.startswith(_START):
        return None
    _, name, length = struct.unpack_from("<H2sH", start, len(_START))
    flags, size, line, lines, first, last = _FIXED.unpack_from(start, len(_START) + 6)
    if name != _FIELD or length < _FIXED.size:
        return None
    if size <= len(start) or size > LONGEST + BLOCK:
        raise Damaged(f"the block at byte {offset} is said to have {size} bytes")
    marks = _marks(file.read(length - _FIXED.size), offset) if length > _FIXED.size else {}
    return Block(offset, min(size, end - offset), line, lines, first, last, marks, flags)


def _marks(packed_marks: bytes, offset: int) -> dict[str, int]:
    """The checkpoints of which the header of a block tells. Raises Damaged."""
    reader = zlib.decompressobj()
    try:
        told = reader.decompress(packed_marks, _LARGEST_MARKS)
        if not reader.eof:
            raise ValueError(f"it has more than {_LARGEST_MARKS >> 20} MB, or is not whole")
        found = outside.loads(told)
    except (ValueError, zlib.error) as problem:
        raise Damaged(f"the header of the block at byte {offset} is damaged: {problem}") from problem
    if not isinstance(found, dict) or not all(type(moment) is int for moment in found.values()):
        raise Damaged(f"the header of the block at byte {offset} is damaged: it has no checkpoints")
    return found


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


def unpacked_as_far_as_it_goes(data: bytes) -> bytes:
    """The same of a block that may be damaged or torn: what stands before that."""
    reader = zlib.decompressobj(zlib.MAX_WBITS + 16)
    found = bytearray()
    for place in range(0, len(data), _PIECE):
        piece, is_whole = as_far_as_it_goes(
            reader, data[place : place + _PIECE], LONGEST + BLOCK - len(found)
        )
        found += piece
        if not is_whole or reader.eof or len(found) >= LONGEST + BLOCK:
            break
    return bytes(found)


def as_far_as_it_goes(reader: Unpacker, data: bytes, most: int) -> tuple[bytes, bool]:
    """What a piece of compressed data unpacks to, `most` bytes of it, and whether it is whole."""
    before = reader.copy()
    try:
        return reader.decompress(data, most), True
    except zlib.error:
        pass
    found = b""
    for place in range(len(data)):  # it is lost from one byte on: what comes before is not
        try:
            found += before.decompress(data[place : place + 1], max(1, most - len(found)))
        except zlib.error:
            break
    return found[:most], False


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
    "Damaged",
    "as_far_as_it_goes",
    "block_of",
    "is_ours",
    "packed",
    "packed_blocks",
    "plain_blocks",
    "start_for",
    "unpacked",
    "unpacked_as_far_as_it_goes",
]
