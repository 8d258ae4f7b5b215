"""Python places: where the Python of activities, functions and modules is. It is parsed, never imported."""

from __future__ import annotations

import ast
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.runtime.message.naming import class_name, module_name
from aseme_dsl.source import Source, Span


def activity_place(folder: Path | None, activity: str) -> Span | None:
    """The class of an activity in the folder of the activities."""
    if folder is None:
        return None
    return _defined(folder / f"{module_name(activity)}.py", class_name(activity))


def target_place(folders: tuple[Path, ...], target: str) -> Span | None:
    """The function or class that `module:name` means, seen from the first of the folders that has it."""
    module, _, name = target.partition(":")
    for folder in folders:
        base = folder.joinpath(*module.split("."))
        for path in (base.with_suffix(".py"), base / "__init__.py"):
            found = _defined(path, name)
            if found is not None:
                return found
    return None


def outcome_places(folder: Path | None, activity: str, outcome: str) -> tuple[Span, ...]:
    """Where the class of an activity returns an outcome: what is between the quotes."""
    source = read_python(folder / f"{module_name(activity)}.py") if folder is not None else None
    if source is None:
        return ()
    try:
        body = ast.parse(source.text).body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return ()
    found = []
    for item in body:
        if isinstance(item, ast.ClassDef) and item.name == class_name(activity):
            for returned in ast.walk(item):
                value = returned.value if isinstance(returned, ast.Return) else None
                for part in ast.walk(value) if value is not None else ():
                    if isinstance(part, ast.Constant) and part.value == outcome:
                        start = offset_of(source, part.lineno, part.col_offset) + 1
                        span = Span(source, start, start + len(outcome))
                        found += [span] if span.text == outcome else []
    return tuple(sorted(found, key=lambda span: span.start))


def read_python(path: Path) -> Source | None:
    """The text of a Python file; None if there is none that can be read."""
    try:
        return Source(str(path), outside.read_text(path).replace("\r\n", "\n"))
    except (OSError, UnicodeDecodeError, ValueError):
        return None


def offset_of(source: Source, line: int, column: int) -> int:
    """The offset of a place as `ast` tells it: the column in bytes."""
    return source.line_start(line) + len(source.line(line).encode()[:column].decode(errors="replace"))


def _defined(path: Path, name: str) -> Span | None:
    """Where a module defines a name (`Class.method` too); the beginning of the file if it cannot be said."""
    source = read_python(path)
    if source is None:
        return None
    text = source.text
    try:
        body: list[ast.stmt] = ast.parse(text).body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return Span(source, 0, 0)
    place = Span(source, 0, 0)
    for part in name.split("."):
        found = next((item for item in body if _defines(item, part)), None)
        if found is None:
            return place
        start = offset_of(source, found.lineno, found.col_offset)
        begin = text.find(part, start)
        place = Span(source, begin, begin + len(part)) if begin >= 0 else Span(source, start, start)
        body = found.body if isinstance(found, ast.ClassDef) else []
    return place


def _defines(item: ast.stmt, name: str) -> bool:
    if isinstance(item, (ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)):
        return item.name == name
    if isinstance(item, ast.Assign):
        return any(isinstance(target, ast.Name) and target.id == name for target in item.targets)
    return isinstance(item, ast.AnnAssign) and isinstance(item.target, ast.Name) and item.target.id == name
