"""Mutated examples through `check`, `fmt` and `build`: no traceback, and each is done in time.

`MUTATIONS` says how many are tried (`python3 dev.py long`: 20 000), `MUTATIONS_FROM` the first seed, with a
test for each. What breaks a rule is kept as a file.
"""

from __future__ import annotations

import contextlib
import io
import math
import os
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from itertools import islice
from pathlib import Path

import pytest

from aseme_dsl.cli.program import run_program
from tests.support.grammatical import mutants

ROOT = Path(__file__).parents[2]
FILES = sorted([*ROOT.glob("examples/*/*.aseme"), *ROOT.glob("tests/acceptance/*.aseme")])
SLOW = {"robocup": 1, "warehouse": 1, "acceptance": 2}
"""How often an example of these folders is chosen; the others, where much less is done, 3 times."""

MUTATIONS = int(os.environ.get("MUTATIONS", "40"))
CHUNKS = min(10, MUTATIONS) if MUTATIONS <= 1000 else MUTATIONS // 100
FIRST = int(os.environ.get("MUTATIONS_FROM", "0"))
SECONDS = 2.0
"""Of processors, for one command and all that it starts."""

WRITTEN = 2_000_000
"""What `build` may write in a further second, in bytes: a formula that is there 50 times is a large chart."""

BACKENDS = ("monas", "plain", "jade_like")
ONLY_BUILT = ("E008", "E109")
"""What `check` lets pass and `build` does not: files without a system, and holes, which it only notes."""

DRAWN = 4
"""One in so many programs is drawn, which takes most of the time: most of that is Graphviz's."""

Run = Callable[[Sequence[str]], int]


def copies(folder: Path, alone: bool) -> list[Path]:
    """A copy of each file: alone, or with the whole project."""
    found = []
    for file in FILES:
        place = folder / file.parent.name
        if alone:
            place.mkdir(exist_ok=True)
            shutil.copy(file, place)
        elif not place.exists():
            shutil.copytree(file.parent, place, ignore=shutil.ignore_patterns("build", "__pycache__"))
        found.append(place / file.name)
    return found


def used() -> float:
    """The seconds of processors that this process has used, and those that it has started."""
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


def written(folder: Path) -> int:
    """How many bytes are in the files of a folder, and of those in it."""
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())


def wrong_code(folder: Path) -> Iterator[str]:
    """Which of the Python files that were written no Python can read."""
    for path in sorted(folder.rglob("*.py")):
        try:
            compile(path.read_bytes(), str(path), "exec")
        except (SyntaxError, ValueError) as error:
            yield f"build: {path.name} is not Python: {error}"


def answers(path: Path, text: str, number: int, run: Run = run_program) -> Iterator[str]:
    """What is wrong with how the commands answer the text, which is the mutant of this number."""
    output = path.parent / "mutant"
    backend = BACKENDS[number % len(BACKENDS)]
    build = ["build", "--output", str(output), "--backend", backend]
    if number % DRAWN:
        build += ["--only", "models", "--only", "proto", "--only", backend]
    fine = False
    for command in (["check"], ["fmt"], build):
        if command is build and not fine and number % DRAWN:
            continue  # it would say again what `check` has said
        path.write_text(text, "utf-8")
        said, taken, code = "", math.inf, 0
        for _ in range(2):  # what took long is tried once more: something may have been imported
            shutil.rmtree(output, ignore_errors=True)
            out = io.StringIO()
            begun = used()
            with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
                code = run([*command, str(path)])
            said, taken = out.getvalue(), min(taken, used() - begun - written(output) / WRITTEN)
            if taken <= SECONDS:
                break
        if code not in (0, 1) or "Traceback" in said:
            yield f"{command[0]}: exit code {code}\n{said[-1500:]}"
        if taken > SECONDS:
            yield f"{command[0]}: {taken:.1f} s of processors"
        if command == ["check"]:
            fine = code == 0
        elif command is build:
            refused = fine and code == 1 and not any(f"[{known}]" in said for known in ONLY_BUILT)
            if refused and backend == "monas":  # the others cannot do all that the language can
                yield f"build: what `check` accepts is refused\n{said[-1500:]}"
            yield from wrong_code(output)


def wrong_answers(folder: Path, seed: int, number: int, run: Run = run_program) -> list[str]:
    files = copies(folder, alone=seed % 2 == 1)
    texts = [path.read_text("utf-8") for path in files]
    weights = [SLOW.get(path.parent.name, 3) for path in files]
    wrong = []
    for index, (which, text) in enumerate(islice(mutants(texts, seed, weights), number)):
        path = files[which]
        found = list(answers(path, text, index, run))
        path.write_text(texts[which], "utf-8")
        if found:
            kept = Path(tempfile.gettempdir()) / f"mutant-{seed}-{index}-{path.name}"
            kept.write_text(text, "utf-8")
            wrong.append("\n".join([f"{path.parent.name}: {kept}", *found]))
    return wrong


@pytest.mark.parametrize("seed", range(FIRST, FIRST + CHUNKS))
def test_a_mutation_of_an_example_is_answered_in_words_and_in_time(seed: int, tmp_path: Path) -> None:
    wrong = wrong_answers(tmp_path, seed, MUTATIONS // CHUNKS)
    assert not wrong, "\n\n".join(wrong)


def _fails(arguments: Sequence[str]) -> int:
    return 70 if arguments[0] == "check" else run_program(arguments)


def _shows_where_it_failed(arguments: Sequence[str]) -> int:
    if arguments[0] == "fmt":
        print("Traceback (most recent call last):")
    return run_program(arguments)


def _writes_no_python(arguments: Sequence[str]) -> int:
    if arguments[0] == "build":
        output = Path(arguments[arguments.index("--output") + 1])
        output.mkdir()
        (output / "team.py").write_text("class None: ...", "utf-8")
    return run_program(arguments)


@pytest.mark.parametrize(
    ("run", "said"),
    [
        (_fails, "check: exit code 70"),
        (_shows_where_it_failed, "Traceback"),
        (_writes_no_python, "team.py is not Python"),
    ],
)
def test_what_breaks_a_rule_is_told(run: Run, said: str, tmp_path: Path) -> None:
    wrong = wrong_answers(tmp_path, 0, 2, run)
    assert said in "\n".join(wrong)


def test_what_takes_too_long_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys.modules[__name__], "SECONDS", 1e-6)
    assert "s of processors" in "\n".join(wrong_answers(tmp_path, 0, 1))


def test_enough_mutants_can_be_built(tmp_path: Path) -> None:
    files = copies(tmp_path, alone=True)
    texts = [path.read_text("utf-8") for path in files]
    fine = 0
    for which, text in islice(mutants(texts, 1), 30):
        files[which].write_text(text, "utf-8")
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
            fine += run_program(["check", str(files[which])]) == 0
        files[which].write_text(texts[which], "utf-8")
    assert fine >= 2, "most of the phases see none of them"
