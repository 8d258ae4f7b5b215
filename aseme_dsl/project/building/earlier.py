"""Earlier: what is known of a system from its builds before, so that only what has changed is made again."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import field
from typing import TYPE_CHECKING, TypeVar

from aseme_dsl.backends.backend import NOTHING_KNOWN, Known
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.grammar.parsing.parts import Layout, Lines, Numbers
from aseme_dsl.project.files.write import Seen
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.diagrams import Drawing
    from aseme_dsl.diagrams.rendering.drawn import Drawn

_T = TypeVar("_T")

_KEPT = 3
"""For how many builds what is not asked for is kept: to change something and change it back is common."""


class KnownBuild:
    """What earlier builds of one system have generated (see `backends.backend.Known`)."""

    def __init__(self, numbers: Numbers) -> None:
        self._memory = Memory(_KEPT)
        self._lines = Lines(numbers)

    def begin(self, layout: Layout) -> None:
        """A build begins, of files that lie in their parts like this."""
        self._memory.end()
        self._lines.lay_out(layout)

    def recall(self, function: Callable[..., _T], *inputs: object) -> _T:
        return self._memory.recall(function, *inputs)

    def each(
        self, function: Callable[..., _T], inputs: Iterable[tuple[object, ...]], *common: object
    ) -> tuple[_T, ...]:
        return self._memory.each(function, inputs, *common)

    def same(self, name: object, value: _T) -> _T:
        return self._memory.same(name, value)

    def same_values(self, name: object, values: dict[str, _T]) -> dict[str, _T]:
        return self._memory.same_values(name, values)

    def whole(self, text: str) -> str:
        return self._lines.whole(text)


@dataclass(slots=True)
class Earlier:
    """What a build may take from those before; the usual is nothing.

    `pictures` are the drawings by name, each with what came of it; `seen` is what was found in the folder.
    """

    known: Known = NOTHING_KNOWN
    pictures: dict[str, tuple[Drawing, Drawn]] = field(default_factory=dict)
    seen: Seen | None = None


__all__ = ["Earlier", "KnownBuild"]
