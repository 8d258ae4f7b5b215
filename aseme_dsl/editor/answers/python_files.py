"""Python files: from the class of an activity to its places in the models, and what fixes its code."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence
from pathlib import Path

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.editor.answers.navigation import Place
from aseme_dsl.editor.files.index import Kind, Symbol, Use
from aseme_dsl.editor.files.program import Program
from aseme_dsl.editor.files.python_places import offset_of
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.naming import class_name, module_name
from aseme_dsl.source import Source, Span


@dataclass(frozen=True, slots=True)
class ActivityClass:
    """A class that does an activity: the place of its name, all of it, and the activity in each program."""

    name: Span
    whole: Span
    activities: tuple[tuple[Program, Symbol], ...]


def activity_classes(source: Source, programs: Sequence[Program]) -> tuple[ActivityClass, ...]:
    """The classes of a module in the activities folder that activities of these programs are done by."""
    try:
        body = ast.parse(source.text).body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return ()
    known = [
        (program, symbol)
        for program in programs
        for symbol in sorted({item.symbol for item in program.index.all()}, key=lambda item: item.name)
        if symbol.kind is Kind.ACTIVITY and module_name(symbol.name) == Path(source.path).stem
    ]
    found = []
    for item in body:
        own = tuple(
            one for one in known if isinstance(item, ast.ClassDef) and class_name(one[1].name) == item.name
        )
        if own and isinstance(item, ast.ClassDef):
            start = offset_of(source, item.lineno, item.col_offset)
            end = offset_of(source, item.end_lineno or item.lineno, item.end_col_offset or 0)
            name = source.text.index(item.name, start + len("class"))
            found.append(
                ActivityClass(Span(source, name, name + len(item.name)), Span(source, start, end), own)
            )
    return tuple(found)


def class_at(classes: Sequence[ActivityClass], offset: int) -> ActivityClass | None:
    """The class around an offset."""
    return next((item for item in classes if item.whole.start <= offset <= item.whole.end), None)


def places(found: ActivityClass) -> tuple[Place, ...]:
    """Everywhere the activity stands in the models, where it is described first."""
    described: list[Place] = []
    used: list[Place] = []
    for program, symbol in found.activities:
        for item in program.index.of(symbol):
            span = program.whole(item.span)
            is_description = item.use is Use.DECLARATION or isinstance(item.node, tree.Activity)
            (described if is_description else used).append(Place(program.path_of(span.source), span))
    return tuple(dict.fromkeys((*described, *used)))


def problems(
    path: str, start: int, end: int, programs: Sequence[Program]
) -> Iterator[tuple[Program, Diagnostic]]:
    """What there is to say of the code from `start` to `end`."""
    seen = set()
    for program in programs:
        for item in program.diagnostics:
            span = item.span
            if span is None or program.place_of(item) != path or (span.start > end or span.end < start):
                continue
            if (item.problem, span.start) not in seen:
                seen.add((item.problem, span.start))
                yield program, item


__all__ = ["ActivityClass", "activity_classes", "class_at", "places", "problems"]
