"""Pieces: long work that stops again and again, so that something else can be done in between."""

from __future__ import annotations

from collections.abc import Generator
from typing import TypeVar, cast

_T = TypeVar("_T")

InPieces = Generator[None, None, _T]
"""Work that is done in pieces: each `next` does one piece, `close` gives up the rest."""


def finished(work: InPieces[_T]) -> _T:
    """What comes out when all of it is done in one go."""
    while True:
        try:
            next(work)
        except StopIteration as end:
            return cast(_T, end.value)


__all__ = ["InPieces", "finished"]
