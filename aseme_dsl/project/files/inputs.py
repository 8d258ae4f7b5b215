"""Inputs: which `.aseme` files a command line means: files, folders, patterns and `-`."""

from __future__ import annotations

import glob
import os
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.compiler.read.load import LARGEST
from aseme_dsl.diagnostics import Diagnostic, Problem
from aseme_dsl.diagnostics.problems import files as wrong
from aseme_dsl.records import dataclass
from aseme_dsl.source import STANDARD_INPUT, Source

_TOKEN = re.compile(r'//[^\n]*|/\*.*?(?:\*/|\Z)|"(?:[^"\\\n]|\\.)*"|[{}]|\w+', re.DOTALL)


@dataclass(frozen=True, slots=True)
class Inputs:
    """What was meant.

    `roots` are files (or the text of standard input) to be compiled on their own. `others` are files found in
    folders that declare no system: other files import them, so that they are not roots. `outputs` are the
    output folders that were named, by the roots that were built into them.
    """

    roots: tuple[Path | Source, ...]
    others: tuple[Path, ...]
    diagnostics: tuple[Diagnostic, ...]
    outputs: Mapping[Path, Path] = field(default_factory=dict)

    def output_of(self, root: Path | Source) -> Path | None:
        """The output folder by which a root was named, if it was."""
        return self.outputs.get(root) if isinstance(root, Path) else None


def find_inputs(arguments: Sequence[str], read_standard_input: Callable[[], bytes]) -> Inputs:
    """The files that `arguments` mean, in the order given, each once.

    A folder means every `*.aseme` in it, at any depth, except in hidden folders and in virtual environments.
    A pattern (`*`, `?`, `[…]`, `**`) that no file is called by is matched here. A file that is named need not
    exist: reading it will say so.
    """
    roots: dict[str, Path | Source] = {}
    others: dict[str, Path] = {}
    diagnostics: list[Diagnostic] = []
    for argument in arguments:
        if argument == "-":
            text = _standard_input(read_standard_input, diagnostics) if "-" not in roots else None
            if text is not None:
                roots["-"] = Source(STANDARD_INPUT, text)
            continue
        path = Path(argument)
        if is_folder(path):
            problems = len(diagnostics)
            found = list(_files_below(path, diagnostics))
            if not found and len(diagnostics) == problems:
                diagnostics.append(Diagnostic(wrong.NoSourceInFolder(argument), None, path=argument))
            for file in found:
                (roots if declares_system(file) else others)[_identity(file)] = file
        elif glob.has_magic(argument) and not _exists(path):
            # Path.glob takes no absolute pattern.
            matches = [Path(match) for match in sorted(glob.glob(argument, recursive=True))]  # noqa: PTH207
            files = [match for match in matches if match.suffix == ".aseme" and not is_folder(match)]
            if not files:
                diagnostics.append(Diagnostic(wrong.NothingMatches(argument), None, path=argument))
            roots.update((_identity(file), file) for file in files)
        elif _is_trace(path) and _exists(path):
            diagnostics.append(Diagnostic(wrong.TraceAsSource(argument), None, path=argument))
        else:
            roots[_identity(path)] = path
    left = {identity: path for identity, path in others.items() if identity not in roots}
    return Inputs(tuple(roots.values()), tuple(left.values()), tuple(diagnostics))


def declares_system(path: Path) -> bool:
    """Whether a file has a `system` declaration; True for one that cannot be read, so that this gets said."""
    try:
        text = outside.read_text(path)
    except (OSError, UnicodeDecodeError):
        return True
    depth = 0
    for token in _TOKEN.finditer(text):
        match token[0]:
            case "{":
                depth += 1
            case "}":
                depth = max(0, depth - 1)
            case "system" if depth == 0:
                return True
    return False


def _files_below(folder: Path, diagnostics: list[Diagnostic]) -> Iterator[Path]:
    """Every `*.aseme` at any depth, in the order of their names."""

    def unreadable(problem: OSError) -> None:
        path = str(problem.filename)
        reason = problem.strerror or str(problem)
        diagnostics.append(Diagnostic(wrong.FolderCannotBeRead(path, reason), None, path=path))

    for root, folders, files in os.walk(folder, onerror=unreadable):
        folders[:] = sorted(name for name in folders if is_searched(Path(root, name)))
        yield from (Path(root, name) for name in sorted(files) if name.endswith(".aseme"))


def is_searched(folder: Path) -> bool:
    """Hidden folders hold no sources; a virtual environment has the standard library's, not the project's."""
    return not folder.name.startswith(".") and not (folder / "pyvenv.cfg").exists()


def _standard_input(read: Callable[[], bytes], diagnostics: list[Diagnostic]) -> str | None:
    """The text of standard input, checked as a file would be."""

    def fail(problem: Problem) -> None:
        diagnostics.append(Diagnostic(problem, None, path=STANDARD_INPUT))

    try:
        content = read()
    except OSError as problem:
        fail(wrong.CannotBeRead(STANDARD_INPUT, problem.strerror or str(problem)))
        return None
    if len(content) > LARGEST:
        fail(wrong.InputTooLarge(LARGEST))
        return None
    if b"\0" in content:
        fail(wrong.NotText(STANDARD_INPUT, content.index(0)))
        return None
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        line = content.count(b"\n", 0, problem.start) + 1
        fail(wrong.NotUtf8(STANDARD_INPUT, content[problem.start], line))
        return None


def _is_trace(path: Path) -> bool:
    return path.name.removesuffix(".part").endswith((".jsonl", ".jsonl.gz", ".mcap"))


def _identity(path: Path) -> str:
    """The file itself, where links lead to it, too."""
    try:
        return os.path.realpath(path)
    except ValueError:  # a NUL character: reading it says so
        return str(path)


def is_folder(path: Path) -> bool:
    """Whether there is a folder; False where that cannot be found out."""
    try:
        return path.is_dir()
    except (OSError, ValueError):
        return False


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):
        return False
