"""Activities: what an activity that formulas name may still lack: its entry in the role, its Python class."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from aseme_dsl.diagnostics import Diagnostic, Edit
from aseme_dsl.diagnostics.problems.python.code import CodeNamedOtherwise, NoCode
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
    """The activity or the module at `offset` that has to have a class, if its file is not there yet."""
    name = activity_at(view, offset)
    if name is None:
        name = _module_at(view, offset)
    elif (said := view.program.inspection.activities.get(name)) is not None and not said.has_code:
        return None
    if name is None or folders.activities is None or _file(folders.activities, name).exists():
        return None
    return name


def _module_at(view: View, offset: int) -> str | None:
    """The module whose name stands at an offset in its description, if its code is found by its name."""
    system = view.program.inspection.analysis.system
    whole = view.program.inspection.loaded.layout.whole
    for chart in system.iacs if system is not None else ():
        for module in chart.modules:
            span = whole(module.statement.span)
            is_here = view.program.path_of(span.source) == view.path
            if is_here and not module.target and span.start <= offset <= span.start + len(module.name):
                return module.name
    return None


def lacks_file(view: View, problem: Diagnostic, folders: PythonFolders) -> str | None:
    """The activity or module without code, if to write its file fixes the problem."""
    if problem.span is None or not isinstance(problem.problem, NoCode | CodeNamedOtherwise):
        return None
    return lacks_class(view, problem.span.start, folders)


def activity_class(view: View, offset: int, folders: PythonFolders) -> tuple[Path, str]:
    """The file of the activity or the module at `offset`, as `asemec build` would write it first.

    Raises:
        Refused: There is no such activity, its module is there, or the system has errors.
    """
    from aseme_dsl.backends.backend import BackendOptions, find_backend

    name = lacks_class(view, offset, folders)
    system = view.program.inspection.analysis.system
    if name is None or folders.activities is None:
        raise Refused("there is no activity here that lacks a class")
    if system is None:
        raise Refused("fix the errors first: the class says what its activity reads and writes")
    path = _file(folders.activities, name)
    for artefact in find_backend("monas").generate(system, BackendOptions(folders.templates)):
        if artefact.kept and artefact.path.endswith(f"/{path.name}"):
            return path, artefact.text
    raise Refused(f"no role does `{name}`")


def _file(folder: Path, activity: str) -> Path:
    return folder / f"{module_name(activity)}.py"


__all__ = ["activity_at", "activity_class", "description", "lacks_class", "lacks_file"]
