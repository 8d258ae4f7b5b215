"""Saving: counterexamples as scenarios in a file, and as sequence diagrams."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.diagrams.sequence.sequence_svg import drawn
from aseme_dsl.grammar.layout.adding import addition
from aseme_dsl.project.proving.results import Case, Result
from aseme_dsl.project.testing.story_pictures import diagram_of_story, file_names


def saved(results: Iterable[Result], path: Path, root: Path) -> tuple[str, int]:
    """What a file contains with the counterexamples behind what it has, and how many it did not have.

    A new file imports the `root`.
    """
    text = outside.read_text(path) if path.exists() else f'import "{_from(path, root)}"\n'
    new = 0
    for case in cases_of(results):
        added = addition(text, case.roles, case.text)
        if added is not None:
            text, new = text + added, new + 1
    return text, new


def cases_of(results: Iterable[Result]) -> Iterator[Case]:
    """The counterexamples that are scenarios."""
    return (item.case for item in results if item.case is not None)


def pictures(results: Iterable[Result]) -> Iterator[tuple[str, str]]:
    """An SVG for each counterexample, with a name for its file; names are different."""
    cases = list(cases_of(results))
    for name, case in zip(file_names(item.title for item in cases), cases, strict=True):
        yield f"{name}.svg", drawn(diagram_of_story(case.title, case.story, case.remark, dict(case.team)))


def _from(path: Path, root: Path) -> str:
    """The root as the file names it."""
    return Path(os.path.relpath(root.resolve(), path.resolve().parent)).as_posix()


__all__ = ["cases_of", "pictures", "saved"]
