"""Mutated examples through `check`, `build` and `fmt`: no traceback, and each is done in time.

`MUTATIONS` says how many are tried (`python3 dev.py long`: 20 000). What breaks a rule is kept as a file.
"""

from __future__ import annotations

import contextlib
import io
import os
import shutil
import tempfile
import time
from collections.abc import Iterator
from itertools import islice
from pathlib import Path

import pytest

from aseme_dsl.cli.program import run_program
from tests.support.grammatical import mutants

ROOT = Path(__file__).parents[2]
FILES = sorted([*ROOT.glob("examples/*/*.aseme"), *ROOT.glob("tests/acceptance/*.aseme")])
MUTATIONS = int(os.environ.get("MUTATIONS", "500"))
CHUNKS = min(20, MUTATIONS) if MUTATIONS <= 1000 else MUTATIONS // 100
SECONDS = 2.0
"""Of CPU, for one command."""


@pytest.fixture
def projects(tmp_path: Path) -> list[Path]:
    """A copy of each file, in a copy of its folder."""
    copies = []
    for file in FILES:
        folder = tmp_path / file.parent.name
        if not folder.exists():
            shutil.copytree(file.parent, folder, ignore=shutil.ignore_patterns("build", "__pycache__"))
        copies.append(folder / file.name)
    return copies


def answers(path: Path, text: str) -> Iterator[str]:
    """What is wrong with how the commands answer the text."""
    for command in (["check"], ["build", "--output", str(path.parent / "mutant")], ["fmt"]):
        path.write_text(text, "utf-8")
        said, taken, code = "", SECONDS + 1, 0
        for _ in range(2):  # what was slow is tried once more: this machine may have been busy
            shutil.rmtree(path.parent / "mutant", ignore_errors=True)
            out = io.StringIO()
            begun = time.process_time()
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
                code = run_program([*command, str(path)])
            said, taken = out.getvalue(), min(taken, time.process_time() - begun)
            if taken <= SECONDS:
                break
        if code not in (0, 1) or "Traceback" in said:
            yield f"{command[0]}: exit code {code}\n{said[-1500:]}"
        if taken > SECONDS:
            yield f"{command[0]}: {taken:.1f} s of CPU"


def wrong_answers(projects: list[Path], seed: int, number: int) -> list[str]:
    texts = [path.read_text("utf-8") for path in projects]
    wrong = []
    for index, (which, text) in enumerate(islice(mutants(texts, seed), number)):
        path = projects[which]
        found = list(answers(path, text))
        path.write_text(texts[which], "utf-8")
        if found:
            kept = Path(tempfile.gettempdir()) / f"mutant-{seed}-{index}-{path.name}"
            kept.write_text(text, "utf-8")
            wrong.append("\n".join([str(kept), *found]))
    return wrong


@pytest.mark.parametrize("seed", range(CHUNKS))
def test_a_mutation_of_an_example_is_answered_in_words_and_in_time(seed: int, projects: list[Path]) -> None:
    wrong = wrong_answers(projects, seed, MUTATIONS // CHUNKS)
    assert not wrong, "\n\n".join(wrong)
