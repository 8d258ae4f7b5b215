"""Copies of what was read of a text: for another process, and for the text as it is after an edit."""

from __future__ import annotations

import io
import pickle
from bisect import bisect_left
from typing import TypeVar, cast

from aseme_dsl.source import Source, Span

_T = TypeVar("_T")


class _Pickler(pickle.Pickler):
    def __init__(self, file: io.BytesIO, source: Source, spans: bool) -> None:
        super().__init__(file, pickle.HIGHEST_PROTOCOL)
        self._source = source
        self._kind = Span if spans else Source

    def persistent_id(self, item: object) -> tuple[int, int] | tuple[()] | None:
        if type(item) is Span and self._kind is Span and item.source is self._source:
            return item.start, item.end
        return () if item is self._source else None


class _Unpickler(pickle.Unpickler):
    def __init__(self, file: io.BytesIO, source: Source, before: Source | None = None) -> None:
        super().__init__(file)
        self._source = source
        self._edit = _edit(before.text, source.text) if before is not None else (0, 0, 0)

    def persistent_load(self, found: tuple[int, int] | tuple[()]) -> Source | Span:
        if not found:
            return self._source
        begin, end, shift = self._edit
        start, stop = found
        if start >= end:
            return Span(self._source, start + shift, stop + shift)
        # What begins or ends in what was edited goes as far as the edit does.
        last = end + shift
        return Span(
            self._source,
            start if start <= begin else min(start, last),
            stop if stop <= begin else stop + shift if stop >= end else min(stop, last),
        )


def dump(found: object, source: Source) -> bytes:
    """What was read of a text, without the text."""
    file = io.BytesIO()
    _Pickler(file, source, spans=False).dump(found)
    return file.getvalue()


def load(found: bytes, source: Source) -> object:
    """What was dumped, as if it had been read of this source, which has the same text."""
    made: object = _Unpickler(io.BytesIO(found), source).load()
    return made


def moved(found: _T, before: Source, after: Source) -> _T:
    """What was read of a text, with its places in the text as it is after one edit."""
    file = io.BytesIO()
    _Pickler(file, before, spans=True).dump(found)
    file.seek(0)
    return cast(_T, _Unpickler(file, after, before).load())


def _edit(before: str, after: str) -> tuple[int, int, int]:
    """Where two texts begin to differ, where that ends in the first, how much longer the second is."""
    begin = _same(before, after)
    same = _same(before[begin:][::-1], after[begin:][::-1])
    return begin, len(before) - same, len(after) - len(before)


def _same(one: str, other: str) -> int:
    """How many characters two texts have in common at their beginnings."""
    lengths = range(1, min(len(one), len(other)) + 1)
    return bisect_left(lengths, True, key=lambda length: one[:length] != other[:length])


__all__ = ["dump", "load", "moved"]
