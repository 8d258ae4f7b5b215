"""Foreign files on a disk: read with what goes wrong as diagnostics."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from aseme_dsl.compiler.read.load import read_source
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.files import FileTooLarge
from aseme_dsl.source import Source

_LARGEST = 1_000_000
"""In bytes; the files of Monas have two thousand."""


def imported_modules(path: Path) -> tuple[str, tuple[Diagnostic, ...]]:
    """The `modules` block that a Monas `agents.xml` stands for."""
    from aseme_dsl.interop.monas_agents import modules_of

    source = read_source(path, largest=_LARGEST)
    if isinstance(source, Diagnostic):
        problem = source.problem
        if isinstance(problem, FileTooLarge):  # without the advice for sources
            problem = FileTooLarge(problem.path, problem.size, problem.most)
        return "", (replace(source, problem=problem),)
    return modules_of(Source(source.path, source.text.removeprefix("\ufeff").replace("\r\n", "\n")))
