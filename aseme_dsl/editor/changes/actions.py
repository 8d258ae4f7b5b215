"""Actions: what an editor offers to do about a place: to fix it, or to write it otherwise.

Fixes carry their edits. A refactoring is offered by name and carried out when it is chosen, because it makes
sure, by compiling, that the model means the same afterwards.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from enum import StrEnum

from aseme_dsl.amola.liveness import ungrouped
from aseme_dsl.amola.operators import Operator
from aseme_dsl.diagnostics import Diagnostic, Edit
from aseme_dsl.diagnostics.changes import UNSURE, apply, choose
from aseme_dsl.editor.answers.navigation import PythonFolders
from aseme_dsl.editor.changes.activities import description, lacks_class, lacks_file
from aseme_dsl.editor.changes.control_lines import missing_lines
from aseme_dsl.editor.changes.extract import extract
from aseme_dsl.editor.changes.inline import formula_at, inline
from aseme_dsl.editor.changes.naming import name_expression
from aseme_dsl.editor.changes.quick_fixes import Fix, fixes
from aseme_dsl.editor.changes.rewriting import Refused, differences, look, piece_at
from aseme_dsl.editor.files.program import errors_in_texts
from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass

CLASS = "class"
"""The refactoring that makes a new file: see `activities.activity_class`."""


class ActionKind(StrEnum):
    """What an action is for, as the protocol calls it."""

    QUICK_FIX = "quickfix"
    FIX_ALL = "source.fixAll"
    EXTRACT = "refactor.extract"
    INLINE = "refactor.inline"
    REWRITE = "refactor.rewrite"


@dataclass(frozen=True, slots=True)
class Action:
    """Something to do. Without `edits`, `carry_out` makes them: `name` says what, from `start` to `end`.

    `mends` are the problems that are fixed then. `explains` is a code whose page is shown instead.
    `cursor` is where the author has to continue writing, in the text that the edits make.
    """

    title: str
    kind: ActionKind
    edits: tuple[Edit, ...] = ()
    mends: tuple[Diagnostic, ...] = ()
    name: str = ""
    start: int = 0
    end: int = 0
    explains: str = ""
    preferred: bool = False
    cursor: int | None = None


def actions(view: View, start: int, end: int, folders: PythonFolders | None = None) -> tuple[Action, ...]:
    """What can be done about the text from `start` to `end`; `folders` is where its Python is."""
    here = [item for item in view.diagnostics if _touches(item, start, end)]
    found = (
        *_mending(view, here),
        *_starting(view, here, folders),
        *_all(view, here),
        *_rewriting(view, start, end),
    )
    return (*found, *_of_activity(view, start, end, folders)) if start == end else found


def carry_out(view: View, name: str, start: int, end: int) -> tuple[Edit, ...]:
    """The edits of a refactoring.

    Raises:
        Refused: It cannot be done, with the reason.
    """
    if name not in _REFACTORINGS:
        raise Refused(f"there is no refactoring {name}")
    return _REFACTORINGS[name](view, start, end)


_REFACTORINGS: Mapping[str, Callable[[View, int, int], tuple[Edit, ...]]] = {
    "extract": extract,
    "inline": lambda view, start, end: inline(view, start),
    "name": name_expression,
    "mend": lambda view, start, end: mend(view),
    "lines": lambda view, start, end: missing_lines(view, start),
}


def _touches(item: Diagnostic, start: int, end: int) -> bool:
    return item.span is not None and item.span.start <= end and start <= item.span.end


def _mending(view: View, here: list[Diagnostic]) -> Iterator[Action]:
    for item in here:
        for fix in fixes(view, item):
            mends = (item,) if fix.mends else ()
            yield Action(
                fix.title,
                ActionKind.QUICK_FIX,
                fix.edits,
                mends,
                explains=fix.explains,
                preferred=fix.is_the_one,
                cursor=fix.cursor,
            )


def _starting(view: View, here: list[Diagnostic], folders: PythonFolders | None) -> Iterator[Action]:
    """The quick fixes that start a file which is missing."""
    for item in here:
        name = None if folders is None else lacks_file(view, item, folders)
        if name is not None and item.span is not None:
            title = f"Start the Python file of `{name}`"
            start, end = item.span.start, item.span.end
            yield Action(title, ActionKind.QUICK_FIX, mends=(item,), name=CLASS, start=start, end=end)


def _all(view: View, here: list[Diagnostic]) -> Iterator[Action]:
    """One action for everything in the file that has one right answer."""
    chosen = _mendable(view, view.diagnostics)
    title = "Fix everything in the file that has one right answer"
    if chosen:
        yield Action(title, ActionKind.FIX_ALL, name="mend")
    if len(chosen) > 1 and any(item in chosen for item in here):
        yield Action(title, ActionKind.QUICK_FIX, name="mend")


def mend(view: View) -> tuple[Edit, ...]:
    """The edits that fix all in the file that has one right answer, and what shows itself only then."""
    text = view.source.text
    seen = {text}
    chosen = _mendable(view, view.diagnostics)
    while chosen:
        edits = [edit for item in chosen for edit in item.changes]
        text = apply(text, edits)
        if text in seen:
            break  # answers that undo each other: then neither is the right one
        seen.add(text)
        chosen = _mendable(view, look(view, text).analysis.diagnostics)
    return differences(view.source, text)


def _mendable(view: View, diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
    """What has one right answer that concerns this file only; of what overlaps, the first."""
    return choose(
        item
        for item in diagnostics
        if item.changes
        and item.code not in UNSURE
        and all(view.program.path_of(edit.span.source) == view.path for edit in item.changes)
    )


def _rewriting(view: View, start: int, end: int) -> Iterator[Action]:
    """Refactorings that may be possible; whether they are is found out when one is chosen."""
    broken = bool(errors_in_texts(view.diagnostics))
    try:
        piece = piece_at(view.source, start)
    except Refused:
        return
    first, last = start - piece.first, end - piece.first
    if start < end and broken:
        return
    if start < end:
        for owner in piece.owners:
            for item in owner.formulas.named.values():
                if item.formula.span.start <= first and last <= item.formula.span.end:
                    title = "Make a formula of what is selected"
                    yield Action(title, ActionKind.EXTRACT, name="extract", start=start, end=end)
                    return
        if any(_inside(item, first, last) for item in _expressions(piece.declaration)):
            title = "Give the selected expression a name (let)"
            yield Action(title, ActionKind.EXTRACT, name="name", start=start, end=end)
        return
    with suppress(Refused):
        owner, name = formula_at(piece, first)
        title = owner.titles[name]
        if name != owner.formulas.root and not broken:
            yield Action(
                f"Write `{title}` where it is used", ActionKind.INLINE, name="inline", start=start, end=end
            )
        if ungrouped(owner.formulas.named[name].formula).operator is not Operator.NAME:
            yield _lines(title, start, end)
        return
    for control in piece.declaration.controls:
        if control.name.span.start <= first <= control.name.span.end:
            yield _lines(control.name.text, start, end)


def _of_activity(view: View, start: int, end: int, folders: PythonFolders | None) -> Iterator[Action]:
    for title, edit in description(view, start):
        yield Action(title, ActionKind.REWRITE, (edit,))
    activity = lacks_class(view, start, folders) if folders is not None else None
    if activity is not None:
        title = f"Write the Python class of `{activity}`"
        yield Action(title, ActionKind.REWRITE, name=CLASS, start=start, end=end)


def _lines(title: str, start: int, end: int) -> Action:
    return Action(
        f"Write a control line for every transition of `{title}` that has none",
        ActionKind.REWRITE,
        name="lines",
        start=start,
        end=end,
    )


def _expressions(declaration: tree.Srm | tree.Aip) -> Iterator[tree.TransitionExpression]:
    for control in declaration.controls:
        yield from (entry.expression for entry in control.entries)


def _inside(item: tree.TransitionExpression, first: int, last: int) -> bool:
    return item.span.start <= first and last <= item.span.end


__all__ = ["CLASS", "Action", "ActionKind", "Fix", "actions", "carry_out", "mend"]
