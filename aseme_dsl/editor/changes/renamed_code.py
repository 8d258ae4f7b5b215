"""Renamed code: with an activity go its Python module and class, with an outcome what the class returns."""

from __future__ import annotations

import ast
import io
import tokenize
from collections.abc import Iterator, Mapping
from dataclasses import field
from pathlib import Path

from aseme_dsl.diagnostics import Edit
from aseme_dsl.editor.files.index import Kind, Symbol
from aseme_dsl.editor.files.python_places import outcome_places, read_python
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.naming import class_name, module_name
from aseme_dsl.source import Source, Span


@dataclass(frozen=True, slots=True)
class Code:
    """The changes in Python files by their paths, and the files that get other names: from which to which."""

    edits: Mapping[str, tuple[Edit, ...]] = field(default_factory=dict)
    moves: tuple[tuple[Path, Path], ...] = ()


class Unreadable(Exception):
    """Why the code cannot go with the name, for people."""


def renamed_code(names: Mapping[Symbol, str], folder: Path | None) -> Code:
    """What changes in the folder of the activities if things get these names.

    Raises:
        Unreadable: A file cannot be read, or there is one of the new name.
    """
    edits: dict[str, dict[int, Edit]] = {}
    moves: list[tuple[Path, Path]] = []
    for symbol, new in names.items() if folder is not None else ():
        assert folder is not None
        found: list[Edit] = []
        if symbol.kind is Kind.ACTIVITY:
            old_file, new_file = (folder / f"{module_name(name)}.py" for name in (symbol.name, new))
            if not old_file.is_file():
                continue
            found += _class_edits(folder, old_file, symbol.name, new)
            if new_file != old_file:
                if new_file.exists():
                    raise Unreadable(f"there is a file {new_file} already")
                moves.append((old_file, new_file))
        elif symbol.kind is Kind.OUTCOME:
            found += (Edit(span, new) for span in outcome_places(folder, symbol.owner, symbol.name))
        for edit in found:
            edits.setdefault(edit.span.source.path, {})[edit.span.start] = edit
    return Code(
        {path: tuple(found[start] for start in sorted(found)) for path, found in edits.items()}, tuple(moves)
    )


def _class_edits(folder: Path, file: Path, old: str, new: str) -> Iterator[Edit]:
    """The class, in its own module and in those beside it that import it from there."""
    for path in sorted(folder.glob("*.py")):
        source = read_python(path)
        if source is None:
            if path == file:
                raise Unreadable(f"{path} cannot be read")
            continue
        modules = [] if path == file else _imports(source, module_name(old), class_name(old))
        if path != file and not modules:
            continue
        for start, text in _words(source):
            if text == class_name(old) != class_name(new):
                yield Edit(Span(source, start, start + len(text)), class_name(new))
            elif text == module_name(old) != module_name(new) and any(
                first <= start < last for first, last in modules
            ):
                yield Edit(Span(source, start, start + len(text)), module_name(new))


def _imports(source: Source, module: str, name: str) -> list[tuple[int, int]]:
    """Where a module is named from which the class is imported."""
    try:
        tree = ast.parse(source.text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return []
    return [
        (source.line_start(item.lineno), source.text.find("import", source.line_start(item.lineno)))
        for item in ast.walk(tree)
        if isinstance(item, ast.ImportFrom)
        and item.module is not None
        and item.module.rpartition(".")[2] == module
        and any(alias.name == name for alias in item.names)
    ]


def _words(source: Source) -> Iterator[tuple[int, str]]:
    """Every name and word with the offset at which it begins."""
    try:
        for token in tokenize.generate_tokens(io.StringIO(source.text).readline):
            if token.type == tokenize.NAME:
                yield source.line_start(token.start[0]) + token.start[1], token.string
    except (tokenize.TokenError, SyntaxError) as error:
        raise Unreadable(f"{source.path} is not Python: fix it first") from error


__all__ = ["Code", "Unreadable", "renamed_code"]
