"""Figures: from the source that a page names or holds to pictures, or to what is wrong with it."""

from __future__ import annotations

import os
import time
from collections import OrderedDict
from collections.abc import Iterable
from dataclasses import field
from pathlib import Path

from aseme_dsl.diagnostics import Diagnostic, Severity, render_text
from aseme_dsl.diagrams import DrawingFailed, NoSuchState
from aseme_dsl.diagrams.look.words import words
from aseme_dsl.diagrams.rendering.drawn import WHOLE
from aseme_dsl.diagrams.rendering.store import Store, key_of
from aseme_dsl.documents.request import Request
from aseme_dsl.project.building.build import with_labels
from aseme_dsl.project.building.draw import NoSuchDrawing, choose
from aseme_dsl.project.building.project import Compiled, compile_root, path_of
from aseme_dsl.project.files.stamp import CLOCK
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source

_MOST = 16
"""So many compiled sources are kept."""


@dataclass(frozen=True, slots=True)
class Picture:
    """A drawing for a page: `name` as its file may be called, its SVG and its DOT text.

    `alt` says what it shows; `key` is another one for another picture.
    """

    name: str
    svg: bytes
    dot: str
    alt: str
    key: str


@dataclass(frozen=True, slots=True)
class Problem:
    """What keeps pictures from being drawn. `line` is that of the page where it holds the source, or None."""

    text: str
    line: int | None = None


@dataclass(frozen=True, slots=True)
class Figures:
    """What a page gets: pictures or problems, never both; `report` shows the problems as a terminal would.

    `files` are those that decide what comes out, by their absolute paths.
    """

    pictures: tuple[Picture, ...]
    problems: tuple[Problem, ...]
    files: tuple[Path, ...]
    report: str = ""


@dataclass(slots=True)
class Drawer:
    """Makes figures; remembers what it has compiled and drawn, for as long as nothing has changed."""

    store: Store = field(default_factory=Store)
    _compiled: OrderedDict[tuple[str, str | None], tuple[_Stamp, Compiled]] = field(
        default_factory=OrderedDict
    )

    def figures(self, root: Path | Source, request: Request) -> Figures:
        """The figures that a request wants of a file, or of the text that a page holds.

        That text stands at the line of the page where it begins, and imports what is beside the page.
        """
        compiled = self._compile(root)
        files = _read_by(compiled, root)
        if compiled.system is None:
            bad = [item for item in compiled.diagnostics if item.severity is Severity.ERROR]
            problems = tuple(_problem(item, root) for item in bad)
            return Figures((), problems, files, render_text(bad))
        configuration = compiled.configuration
        system = with_labels(compiled.system, request.labels or configuration.labels or "plain")
        try:
            asked = request.options(configuration.expressions or "numbered")
            chosen = [item for options in asked for item in choose(system, request.models, options)]
            drawings = {item.name: item for item in chosen}.values()
            if not drawings:
                raise NoSuchDrawing(f"{system.name} has nothing to draw")
            for drawing in drawings:
                if drawing.states > WHOLE:
                    raise DrawingFailed(
                        f"{drawing.name} has {drawing.states} states, which is too much for one picture:"
                        " say `at` which state or to which `depth`"
                    )
            pictures = tuple(
                Picture(
                    drawing.name,
                    self.store.render(drawing, "svg"),
                    drawing.dot,
                    request.alt or words(system, drawing),
                    key_of(drawing),
                )
                for drawing in drawings
            )
        except (NoSuchDrawing, NoSuchState, DrawingFailed) as problem:
            text = str(problem)
            return Figures((), (Problem(text),), files, text)
        return Figures(pictures, (), files)

    def _compile(self, root: Path | Source) -> Compiled:
        key = (path_of(root), root.text if isinstance(root, Source) else None)
        known = self._compiled.get(key)
        if known is not None and known[0] == _stamp(_read_by(known[1], root)):
            self._compiled.move_to_end(key)
            return known[1]
        begun = time.time_ns() - CLOCK
        compiled = compile_root(root)
        stamp = _stamp(_read_by(compiled, root))
        if any(changed >= begun for _, changed, _ in stamp):  # perhaps after it was read
            self._compiled.pop(key, None)
            return compiled
        self._compiled[key] = (stamp, compiled)
        while len(self._compiled) > _MOST:
            self._compiled.popitem(last=False)
        return compiled


_Stamp = tuple[tuple[str, int, int], ...]


def _stamp(files: Iterable[Path]) -> _Stamp:
    """What changes when one of the files does."""
    found = []
    for path in files:
        try:
            state = path.stat()
            found.append((str(path), state.st_mtime_ns, state.st_size))
        except OSError:
            found.append((str(path), 0, -1))
    return tuple(found)


def _read_by(compiled: Compiled, root: Path | Source) -> tuple[Path, ...]:
    """The files that a compilation has read or missed, with the project's configuration."""
    found = dict.fromkeys(map(Path, compiled.depends))
    if isinstance(root, Source):  # the page itself
        found.pop(Path(os.path.realpath(root.path)), None)
    if compiled.configuration.path is not None:
        found[Path(os.path.realpath(compiled.configuration.path))] = None
    return tuple(found)


def _problem(item: Diagnostic, root: Path | Source) -> Problem:
    """A diagnostic in a line; what is in the page's own source has the page's line."""
    text = f"{item.severity}[{item.code}]: {item.message}"
    if item.hint is not None:
        text += f"; {item.hint}"
    if item.span is None:
        return Problem(text)
    if item.span.source.path == path_of(root) and isinstance(root, Source):
        return Problem(text, item.span.line)
    return Problem(f"{item.span}: {text}")
