"""Terminal: what stands in a file or comes from a robot cannot order a terminal to do something."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TextIO

_ORDERS = re.compile(
    r"\x1b(?!\[[0-9;]*[mK]|\]8;;[\x20-\x7e]*\x1b\\|\\)|[\x00-\x08\x0b\x0c\x0e-\x1a\x1c-\x1f\x7f-\x9f]"
)
"""Control characters, and escape sequences other than colours, links, and the rest of a progress line."""


def harmless(text: str) -> str:
    """The text with another character for each that would order a terminal to do something."""
    return text if text.isprintable() else _ORDERS.sub("\N{REPLACEMENT CHARACTER}", text)


def protect(stream: TextIO) -> None:
    """Have only harmless text reach a stream, if it is a terminal."""
    if stream.isatty():
        stream.write = _harmlessly(stream.write)  # type: ignore[method-assign]


def _harmlessly(write: Callable[[str], int]) -> Callable[[str], int]:
    return lambda text: write(harmless(text))


__all__ = ["harmless", "protect"]
