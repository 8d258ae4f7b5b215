"""The input of the language server, with limits: no message is larger or deeper than an editor's can be."""

from __future__ import annotations

import asyncio
import re
from collections.abc import Callable
from typing import BinaryIO

from aseme_dsl import outside

LARGEST = 64 << 20
"""The largest message, in bytes: several times the largest file that is compiled."""
_LONGEST_HEADER = 1000
_LENGTH = re.compile(rb"Content-Length: *(\d+)\s*", re.IGNORECASE)
_NOTHING = b'{"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":"refused"}}'
"""Stands for a message that was refused: it takes back a request that was never made."""


class Limits:
    """Looks at the input from an editor. Invalid messages are reported, and left out."""

    def __init__(self, tell: Callable[[str], None]) -> None:
        self._tell = tell

    def line(self, line: bytes) -> bytes:
        """A line of a header; nothing where the input behind it cannot be read."""
        length = _LENGTH.fullmatch(line)
        digits = len(length[1].lstrip(b"0")) if length is not None else 0
        if digits > 20 or (length is not None and int(length[1]) > LARGEST):
            self._tell(f"the editor announces a message of more than {LARGEST >> 20} MB: the server ends")
            return b""
        if len(line) >= _LONGEST_HEADER:
            self._tell(
                "what the editor sends is not a message of the language server protocol: the server ends"
            )
            return b""
        return line

    def content(self, content: bytes) -> bytes:
        """The content of a message, or of one that does nothing."""
        try:
            if not isinstance(outside.loads(content, LARGEST), dict):
                raise ValueError("it is not a JSON object")
        except ValueError as problem:
            self._tell(f"a message of the editor is left out: {problem}")
            return _NOTHING
        return content


class BoundedInput:
    """A stream that a thread reads."""

    def __init__(self, stream: BinaryIO, limits: Limits) -> None:
        self._stream = stream
        self._limits = limits

    def readline(self) -> bytes:
        """A line of a header; nothing at the end."""
        return self._limits.line(self._stream.readline(_LONGEST_HEADER))

    def read(self, size: int) -> bytes:
        """The content of a message."""
        content = self._stream.read(size)
        return self._limits.content(content) if len(content) == size else content


class BoundedReader:
    """A stream that an event loop reads."""

    def __init__(self, stream: asyncio.StreamReader, limits: Limits) -> None:
        self._stream = stream
        self._limits = limits

    async def readline(self) -> bytes:
        """A line of a header; nothing at the end."""
        try:
            line = await self._stream.readline()
        except ValueError:  # longer than a stream holds
            line = bytes(_LONGEST_HEADER)
        return self._limits.line(line)

    async def readexactly(self, size: int) -> bytes:
        """The content of a message.

        Raises:
            asyncio.IncompleteReadError: The stream ends before.
        """
        return self._limits.content(await self._stream.readexactly(size))


__all__ = ["LARGEST", "BoundedInput", "BoundedReader", "Limits"]
