"""Quick fixes: what can be done about one problem: fix it, allow it, declare what is missing, read of it."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.amola.operators import INFIX, Operator
from aseme_dsl.compiler.read.allow import OWN
from aseme_dsl.compiler.read.missing import Missing, insertions
from aseme_dsl.diagnostics import CODES, Diagnostic, Edit, Severity
from aseme_dsl.diagnostics.problems.syntax.entries import OperatorToChoose
from aseme_dsl.editor.changes.declaring import declarations
from aseme_dsl.editor.files.view import View
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Fix:
    """`is_the_one`: nothing else can have been meant. `mends`: the problem is fixed then.

    `cursor` is where the author has to continue writing: an offset in the text that the edits make.
    """

    title: str
    edits: tuple[Edit, ...] = ()
    is_the_one: bool = False
    mends: bool = True
    explains: str = ""
    cursor: int | None = None


def fixes(view: View, item: Diagnostic) -> Iterator[Fix]:
    """What can be done about a problem of the file."""
    yield from mending(item)
    yield from _operators(item)
    yield from (Fix(title, edits) for title, edits in declarations(view, item))
    skeleton = _skeleton(view, item)
    if skeleton is not None:
        yield Fix("Write what is missing, to be filled in", skeleton)
    if item.severity is not Severity.ERROR and item.code not in OWN and item.span is not None:
        allowed = _allow(view, item.span, item.code)
        cursor = allowed.span.start + len(allowed.text) - 1
        yield Fix(f"Allow {item.code} here, and say why", (allowed,), mends=False, cursor=cursor)
    yield Fix(f"Explain {item.code}: {CODES[item.code].title}", mends=False, explains=item.code)


def mending(item: Diagnostic) -> Iterator[Fix]:
    """What fixes a problem that has one right answer, wherever it is."""
    if item.changes:
        yield Fix(_title(item), item.changes, is_the_one=True)


def _operators(item: Diagnostic) -> Iterator[Fix]:
    """What may stand where an operator is still to be chosen."""
    if not isinstance(item.problem, OperatorToChoose) or item.span is None:
        return
    for operator in INFIX:
        if operator is not Operator.HOLE:
            edit = Edit(item.span, operator.value)
            yield Fix(f"Write `{operator}`: {operator.row.meaning}", (edit,))


def _title(item: Diagnostic) -> str:
    changes = item.changes
    if len(changes) > 1:
        return "Fix it" if item.hint is None else _sentence(item.hint)
    (edit,) = changes
    old, new = (" ".join(text.split()) for text in (edit.span.text, edit.text))
    if not old:
        return f"Insert `{new}`"
    return f"Write `{new}` instead of `{old}`" if new else f"Remove `{_cut(old)}`"


def _sentence(hint: str) -> str:
    first = hint.split("\n")[0]
    return first[:1].upper() + first[1:]


def _cut(text: str) -> str:
    return text if len(text) <= 40 else text[:39] + "…"


def _skeleton(view: View, item: Diagnostic) -> tuple[Edit, ...] | None:
    """The edits that write what a note says is missing."""
    for missing in view.program.inspection.analysis.missing:
        if missing.note.problem != item.problem:
            continue
        inside = view.program.whole(missing.inside) if missing.inside is not None else None
        edits = tuple(Edit(view.program.whole(edit.span), edit.text) for edit in missing.edits)
        located = Missing(item, missing.skeleton, inside, edits)
        place = located.place
        if place is None or view.program.path_of(place.source) != view.path:
            continue
        found = insertions(view.source.text, located)
        if found:
            return tuple(Edit(Span(view.source, at, at), text) for at, text in found)
    return None


def _allow(view: View, span: Span, code: str) -> Edit:
    """A comment above the line on which a problem begins; its reason is for the author to say."""
    text = view.source.text
    line = text.rfind("\n", 0, span.start) + 1
    indent = text[line : line + len(text[line:]) - len(text[line:].lstrip(" \t"))]
    return Edit(Span(view.source, line, line), f"{indent}// asemec: allow({code}) \n")


__all__ = ["Fix", "fixes", "mending"]
