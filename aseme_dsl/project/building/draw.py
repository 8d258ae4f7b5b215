"""Draw: some of the drawings of a system, into a folder, one file or standard output."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from fnmatch import fnmatchcase
from functools import partial
from pathlib import Path, PurePath
from typing import TYPE_CHECKING

from aseme_dsl.diagnostics import closest
from aseme_dsl.project.files.write import DISK, Disk, Planned, Written, write
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System
    from aseme_dsl.diagrams import Drawing, Options

FOLDER = "diagrams"
"""Where drawings go unless something else is said."""


class NoSuchDrawing(LookupError):
    """A system has no drawing of this name; the text says which there are."""


@dataclass(frozen=True, slots=True)
class Drawn:
    """Pictures by file name, and what must be said of them."""

    files: tuple[tuple[str, bytes], ...]
    notes: tuple[str, ...]


def choose(system: System, names: Sequence[str], options: Options) -> tuple[Drawing, ...]:
    """The drawings of these names (`iac.player`, `iac.*`, or `iac` for all that begin so), or all.

    A name such as `iac.player.tree` is that of another layout.

    Raises:
        NoSuchDrawing: a name fits none.
        NoSuchState: no statechart has the state `options.at`.
    """
    from aseme_dsl.diagrams import drawings

    found = drawings(system, options)
    if not names:
        return tuple(found)
    chosen: list[Drawing] = []
    for name in names:
        fits = [item for item in found if _fits(item.name, name)]
        if not fits:
            others = _other_layouts(system, options)
            drawn = {item.name for item in found}
            found += [
                item
                for called, draw in others.items()
                if _fits(called, name)
                for item in draw()
                if item.name not in drawn
            ]
            fits = [item for item in found if _fits(item.name, name)]
        if not fits:
            every = [*(item.name for item in found), *others]
            near = closest(name, every)
            known = ", ".join(dict.fromkeys(every)) or "none"
            hint = f"did you mean {near}? There are {known}" if near else f"there are {known}"
            raise NoSuchDrawing(f"{system.name} has no drawing {name}; {hint}")
        chosen += [item for item in fits if item not in chosen]
    return tuple(item for item in found if item in chosen)


def _other_layouts(system: System, options: Options) -> dict[str, Callable[[], list[Drawing]]]:
    """What draws each statechart in the layouts that were not asked for, by the name of the drawing."""
    from aseme_dsl.diagrams import Layout, draw_statechart, label_of
    from aseme_dsl.diagrams.look.drawing import piece_name

    made: dict[str, Callable[[], list[Drawing]]] = {}
    for chart in system.statecharts:
        at = None if options.at is None else label_of(chart, options.at)
        if options.layout is None or (at is not None and at not in chart.by_label):
            continue
        for layout in (item for item in Layout if item is not options.layout):
            name = f"{chart.kind.lower()}.{chart.name}"
            name = name if layout is Layout.COMPACT else f"{name}.{layout}"
            name = name if at is None else piece_name(name, at)
            made[name] = partial(draw_statechart, chart, replace(options, layout=layout), system.activities)
    return made


def _fits(drawing: str, name: str) -> bool:
    if any(character in name for character in "*?["):
        return fnmatchcase(drawing, name)
    return drawing == name or drawing.startswith(f"{name}.") or drawing.startswith(f"{name}@")


def _silently(number: int, of: int, name: str) -> None:
    """No progress is shown."""


def draw_all(
    drawings: Sequence[Drawing], format: str, begins: Callable[[int, int, str], None] = _silently
) -> Drawn:
    """The pictures of the drawings, in order.

    `begins` is called before each with its number (from 1), how many there are, and its name.

    Raises:
        DrawingFailed: one cannot be drawn.
    """
    from aseme_dsl.diagrams import draw

    files: list[tuple[str, bytes]] = []
    notes: list[str] = []
    for number, drawing in enumerate(drawings, 1):
        begins(number, len(drawings), drawing.name)
        drawn = draw(drawing, format)
        files += drawn.files
        notes += drawn.notes
    return Drawn(tuple(files), tuple(notes))


def larger_than_a_screen(drawings: Sequence[Drawing]) -> tuple[str, ...]:
    """What is to be said of drawings that nothing has divided into pages."""
    from aseme_dsl.diagrams import PageSize

    width, height = PageSize.SCREEN.room
    large = [item.name for item in drawings if item.size[0] > width or item.size[1] > height]
    if not large:
        return ()
    verb, them = ("is", "it") if len(large) == 1 else ("are", "them")
    said = f"larger than a screen of {width:g} × {height:g} px: --page screen divides {them} into pages"
    return (f"{', '.join(large)} {verb} {said}",)


def into_folder(system: System, folder: Path, drawn: Drawn, *, force: bool, disk: Disk = DISK) -> Written:
    """Write the pictures into a folder; what is not ours there is not overwritten without `force`."""
    source = PurePath(system.span.source.path).name if system.span else system.name
    files = [Planned(name, content, FOLDER) for name, content in drawn.files]
    return write(folder, files, parts=frozenset(), system=system.name, source=source, force=force, disk=disk)
