"""Export: the statecharts of a system as files of another tool."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path, PurePath

from aseme_dsl.amola.expression import Named, values_of
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.diagnostics import Diagnostic, closest
from aseme_dsl.interop.export.formats import File, Format, files_of
from aseme_dsl.interop.export.lowering import place
from aseme_dsl.interop.export.scxml import DataModel
from aseme_dsl.project.files.write import DISK, Disk, Planned, Written, write

FOLDER = "export"
"""The part of the files in their manifest."""


_WITHOUT_NAMES = (Format.SCXML, Format.XSTATE, Format.SISMIC, Format.STCT)
"""Formats that have no names for expressions."""


class NoSuchChart(Exception):
    """A name means no statechart; the text says which there are."""


def chosen(system: System, names: Sequence[str]) -> tuple[Statechart, ...]:
    """The statecharts called `iac.ROLE`, `eac.PROTOCOL` or by the role; without names those of all roles.

    Raises:
        NoSuchChart: there is none of that name.
    """
    if not names:
        return system.iacs
    return tuple(_chart(system, name) for name in dict.fromkeys(names))


def _chart(system: System, name: str) -> Statechart:
    found = system.chart(name) or system.iac(name) or system.eac(name)
    if found is None:
        known = [f"{chart.kind.lower()}.{chart.name}" for chart in system.statecharts]
        near = closest(name, known)
        hint = f"did you mean {near}?" if near else f"there are {', '.join(known) or 'none'}"
        raise NoSuchChart(f"no statechart is called {name}; {hint}")
    return found


def exported(
    system: System, charts: Iterable[Statechart], format_: Format, datamodel: DataModel
) -> tuple[tuple[File, ...], tuple[Diagnostic, ...]]:
    """The files of all charts; none where one of them cannot be expressed."""
    files: list[File] = []
    found: list[Diagnostic] = []
    for chart in charts:
        made, refused = files_of(system, chart, format_, datamodel)
        files += made
        found += refused
    return (() if found else tuple(files)), tuple(found)


def written_out(charts: Iterable[Statechart], format_: Format) -> tuple[str, ...]:
    """A note with the place of its first use for each `let` of which a format has the value, not the name."""
    if format_ not in _WITHOUT_NAMES:
        return ()
    found: dict[str, str] = {}
    for chart in charts:
        for transition in chart.transitions:
            for value in values_of(transition.expression):
                if isinstance(value, Named):
                    found.setdefault(value.name, place(value.span))
    return tuple(f"{where}: `let {name}` is written out where it is used" for name, where in found.items())


def into_folder(
    system: System, folder: Path, files: Iterable[File], *, force: bool, disk: Disk = DISK
) -> Written:
    """Write the files into a folder; what is not ours there is not overwritten without `force`."""
    source = PurePath(system.span.source.path).name if system.span else system.name
    planned = [Planned(name, text.encode(), FOLDER) for name, text in files]
    return write(
        folder, planned, parts=frozenset(), system=system.name, source=source, force=force, disk=disk
    )


__all__ = ["NoSuchChart", "chosen", "exported", "into_folder", "written_out"]
