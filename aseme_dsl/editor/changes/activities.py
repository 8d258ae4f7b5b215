"""Activities: what an activity that formulas name may still lack: its entry in the role, its Python class."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from aseme_dsl.diagnostics import Edit
from aseme_dsl.editor.answers.navigation import PythonFolders
from aseme_dsl.editor.changes.rewriting import Refused, piece_at
from aseme_dsl.editor.files.index import Kind
from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.text import tree
from aseme_dsl.runtime.message.naming import module_name
from aseme_dsl.source import Span


def activity_at(view: View, offset: int) -> str | None:
    """The activity whose name stands at an offset."""
    found = view.occurrence_at(offset)
    return found.symbol.name if found is not None and found.symbol.kind is Kind.ACTIVITY else None


def description(view: View, offset: int) -> Iterator[tuple[str, Edit]]:
    """The edit that describes the activity at `offset` in its role, if nothing does."""
    name = activity_at(view, offset)
    if name is None or name in view.program.inspection.activities:
        return
    try:
        piece = piece_at(view.source, offset)
    except Refused:
        return
    role = piece.declaration
    if not isinstance(role, tree.Srm):
        return
    text = piece.text
    line = f"{name} takes 100ms"
    if role.activities:
        last = role.activities[-1].span
        indent = text[text.rfind("\n", 0, last.start) + 1 : last.start]
        at, entry = last.end, f"\n{indent if not indent.strip() else '    '}{line}"
    else:
        behind = max((item.span.end for item in role.formulas), default=role.name.span.end)
        brace = text.find("}", behind)
        if brace < 0:
            return
        at, entry = brace + 1, f"\n  activities {{\n    {line}\n  }}"
    at += piece.first
    yield f"Describe the activity `{name}`", Edit(Span(view.source, at, at), entry)


def lacks_class(view: View, offset: int, folders: PythonFolders) -> str | None:
    """The activity at `offset` if there is no module for its class yet."""
    name = activity_at(view, offset)
    if name is None or folders.activities is None or (_module(folders.activities, name)).exists():
        return None
    return name


def activity_class(view: View, offset: int, folders: PythonFolders) -> tuple[Path, str]:
    """The module of the activity at `offset`, as `asemec build` would write it first.

    Raises:
        Refused: There is no such activity, its module is there, or the system has errors.
    """
    from aseme_dsl.backends.backend import BackendOptions, find_backend

    name = lacks_class(view, offset, folders)
    system = view.program.inspection.analysis.system
    if name is None or folders.activities is None:
        raise Refused("there is no activity here that lacks a class")
    if system is None:
        raise Refused("mend the errors first: the class says what its activity reads and writes")
    path = _module(folders.activities, name)
    for artefact in find_backend("monas").generate(system, BackendOptions(folders.templates)):
        if artefact.kept and artefact.path.endswith(f"/{path.name}"):
            return path, artefact.text
    raise Refused(f"no role does `{name}`")


def _module(folder: Path, activity: str) -> Path:
    return folder / f"{module_name(activity)}.py"


__all__ = ["activity_at", "activity_class", "description", "lacks_class"]
