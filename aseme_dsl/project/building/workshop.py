"""Workshop: what is known of the roots of a project from one compilation to the next, for `--watch`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.grammar.parsing.parts import InParts, Layout, Numbers, Parts
from aseme_dsl.project.building.earlier import Earlier, KnownBuild
from aseme_dsl.project.files.stamp import Stamp, stamp_of
from aseme_dsl.project.files.write import Seen
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source


@dataclass(slots=True)
class KnownRoot:
    """What phases have found in a root (`memory`), in its Python (`code`), and what was built of it."""

    built: KnownBuild
    memory: Memory = field(default_factory=Memory)
    code: Memory = field(default_factory=Memory)
    earlier: Earlier = field(init=False)

    def __post_init__(self) -> None:
        self.earlier = Earlier(self.built)

    def begin(self, layout: Layout) -> Earlier:
        """What a build that begins now may take from those before."""
        self.built.begin(layout)
        return self.earlier


class Workshop:
    """The state of a watch: every root by its path, and the parts of every file. For one thread."""

    def __init__(self) -> None:
        self._numbers = Numbers()
        self._roots: dict[str, KnownRoot] = {}
        self._parts: dict[str, Parts] = {}
        self.stamps: Mapping[str, Stamp | None] = {}
        """The stamps of files as they were before the present work began."""

    def about(self, path: str) -> KnownRoot:
        """What is known of a root."""
        if path not in self._roots:
            self._roots[path] = KnownRoot(KnownBuild(self._numbers))
            self._roots[path].earlier.seen = Seen(look=self.look)
        return self._roots[path]

    def look(self, path: str) -> Stamp | None:
        """What a file is: as it was looked at, else now."""
        return self.stamps[path] if path in self.stamps else stamp_of(path)

    def read(self, source: Source) -> InParts:
        """A file, of which only what has changed is read (see `compiler.load.Read`)."""
        return self._parts.setdefault(source.path, Parts(self._numbers)).read(source)


__all__ = ["KnownRoot", "Workshop"]
