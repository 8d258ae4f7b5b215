"""A token: a piece of text that knows where it stands."""

from __future__ import annotations


class Token(str):
    """The text of a terminal, and the offset in the source at which it begins."""

    __slots__ = ("start",)
    start: int

    @property
    def end(self) -> int:
        return self.start + len(self)


def token(text: str, start: int) -> Token:
    """`text`, which stands at `start`."""
    made = Token(text)
    made.start = start
    return made
