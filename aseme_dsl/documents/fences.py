"""Fences: the fenced blocks of a Markdown page that ask for a diagram."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterator

from aseme_dsl.records import dataclass

SOURCE, DIAGRAM = "aseme", "aseme-diagram"
"""The languages of a block that is shown and drawn, and of one that is only drawn."""

_OPEN = re.compile(r"(?P<indent>[ \t]*)(?P<fence>`{3,}|~{3,})[ \t]*(?P<info>[^`\n]*)$")


class WrongFence(ValueError):
    """The line that opens a block cannot be understood."""


@dataclass(frozen=True, slots=True)
class Fence:
    """A block that asks for a diagram: `first` and `last` are the lines of its fences, from 0.

    `language` is `aseme` or `aseme-diagram`, `info` what stands behind that; `content` are the lines between,
    without `indent`.
    """

    first: int
    last: int
    indent: str
    fence: str
    language: str
    info: str
    content: tuple[str, ...]

    def options(self) -> dict[str, str]:
        """What stands behind the language: `model=iac.player depth=2 source caption="…"`.

        Raises:
            WrongFence: a quote is not closed, or an option is given twice.
        """
        try:
            words = shlex.split(self.info)
        except ValueError:
            raise WrongFence(f"a quote is not closed in: {self.info}") from None
        found: dict[str, str] = {}
        for word in words:
            name, _, value = word.partition("=")
            if name in found:
                raise WrongFence(f"{name!r} is given twice")
            found[name] = value
        return found


def fences(lines: list[str]) -> Iterator[Fence]:
    """The blocks of a page that ask for a diagram, in order; what stands in another block is none."""
    number = 0
    while number < len(lines):
        opened = _OPEN.match(lines[number])
        if opened is None:
            number += 1
            continue
        first, indent, fence = number, opened["indent"], opened["fence"]
        end = re.compile(rf"[ \t]*{fence[0]}{{{len(fence)},}}[ \t]*$")
        number += 1
        while number < len(lines) and not end.match(lines[number]):
            number += 1
        if number == len(lines):  # it is never closed: a paragraph
            number = first + 1
            continue
        language, _, info = opened["info"].partition(" ")
        if language == DIAGRAM or (language == SOURCE and re.search(r"(?:^|\s)diagram(=|\s|$)", info)):
            content = tuple(line.removeprefix(indent) for line in lines[first + 1 : number])
            yield Fence(first, number, indent, fence, language, info.strip(), content)
        number += 1
