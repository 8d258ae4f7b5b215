"""Building again: after any edit, a workshop writes and says what a build from nothing would."""

from __future__ import annotations

import os
import random
import re
import shutil
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from aseme_dsl.diagnostics import has_errors
from aseme_dsl.project.building.build import Report, build, choose
from aseme_dsl.project.building.project import Compiled, compile_root
from aseme_dsl.project.building.watch import Changes, Watch, watched
from aseme_dsl.project.building.workshop import Workshop
from tests.support.large import large_project

LINES = 150
PATIENCE = 300.0
"""How long a change may stay unseen, in s: an answer to whether it is seen at all."""

ACTIVITIES = Path("out", "monas", "activities")
ROOT = Path("plant.aseme")


def made(output: Path, workshop: Workshop | None) -> tuple[Compiled, Report | None]:
    """What there is to say of the project here, and what was built of it, if there is no error."""
    compiled = compile_root(ROOT, workshop=workshop)
    if compiled.system is None:
        return compiled, None
    only = ("models", "proto", "monas", "jade_like")
    choice = choose(compiled.configuration, only=only, backends=("monas", "jade_like"))
    earlier = None if workshop is None else workshop.about(str(ROOT)).begin(compiled.layout)
    report = build(compiled.system, output, choice, earlier=earlier)
    assert not has_errors(report.diagnostics), report.diagnostics
    return compiled, report


class Rebuilding:
    """A project here that is watched and built again after each edit."""

    def __init__(self) -> None:
        self.workshop, self.watch = Workshop(), Watch()
        self.again()

    def again(self) -> None:
        """Build; what comes out is what a build from nothing makes of the same folder."""
        shutil.rmtree("fresh", ignore_errors=True)
        if Path("out").exists():
            shutil.copytree("out", "fresh", copy_function=shutil.copy2)
        self.workshop.stamps = self.watch.begin()
        compiled, report = made(Path("out"), self.workshop)
        written = report.written if report is not None else None
        paths, code = watched((str(ROOT),), [compiled], None, None, self.workshop)
        new = () if written is None else (*written.created, *written.changed, *written.removed)
        self.watch.depend(paths, new, code)
        cold, _ = made(Path("fresh"), None)
        assert [repr(item) for item in compiled.diagnostics] == [repr(item) for item in cold.diagnostics]
        assert contents(Path("out")) == contents(Path("fresh"))

    def wait(self) -> Changes:
        """What has changed since then."""
        return seen(self.watch)


def seen(watch: Watch) -> Changes:
    """What has changed."""
    end = time.monotonic() + PATIENCE
    changes = watch.wait(lambda: time.monotonic() > end)
    assert changes is not None, "the change is not seen"
    return changes


def contents(folder: Path) -> dict[str, bytes]:
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


def replaced(name: str, pattern: str, new: str) -> None:
    """Put something else in the place of the first thing in a file that is so."""
    path = Path(name)
    text, number = re.subn(pattern, new, path.read_text("utf-8"), count=1)
    assert number, pattern
    path.write_text(text, "utf-8")


def a_duration(choice: random.Random) -> None:
    replaced("hall1.aseme", r"(Setup1 +takes) \d+s", rf"\1 {choice.randrange(4, 1000)}s")


def a_condition(choice: random.Random) -> None:
    replaced("hall1.aseme", r"count % 7 == \d+", f"count % 7 == {choice.randrange(10, 1000)}")


def a_formula(choice: random.Random) -> None:
    name = f"Wash{choice.randrange(10_000)}"
    replaced("hall1.aseme", r"(produce1 +=) ", rf"\1 {name} . ")
    replaced("hall1.aseme", "activities {", f"activities {{\n    {name} takes 1s  uses arm1")


def a_name(choice: random.Random) -> None:
    path = Path("hall1.aseme")
    name = f"Polish1x{choice.randrange(10_000)}"
    path.write_text(re.sub(r"\bPolish1\w*", name, path.read_text("utf-8")), "utf-8")


def a_type(choice: random.Random) -> None:
    text = Path("types.aseme").read_text("utf-8")
    old, new = ("double weight", "int weight") if "double weight" in text else ("int weight", "double weight")
    replaced("types.aseme", old, new)


def a_field(choice: random.Random) -> None:
    replaced("types.aseme", "message Bid +{", f"message Bid {{ int extra{choice.randrange(10_000)} ")


def a_team(choice: random.Random) -> None:
    replaced("plant.aseme", "team Plant {", f"team Plant {{\n  more{choice.randrange(10_000)} : machine2")


def an_unused_import(choice: random.Random) -> None:
    replaced("plant.aseme", "system Plant\n", f"system Plant\nimport runtime // {choice.random()}\n")


def no_import(choice: random.Random) -> None:
    Path("hall1.aseme").write_text(
        re.sub('^import "types.aseme"', "// no import", Path("hall1.aseme").read_text("utf-8")), "utf-8"
    )


def nonsense(choice: random.Random) -> None:
    replaced("hall1.aseme", "liveness {", "liveness { {")


def other_lines(choice: random.Random) -> None:
    path = Path(choice.choice(["types.aseme", "hall1.aseme", "plant.aseme"]))
    path.write_text(f"// {choice.random()}\n" * choice.randrange(1, 4) + path.read_text("utf-8"), "utf-8")


def no_file(choice: random.Random) -> None:
    Path("hall1.aseme").unlink()


def code_that_is_filled_in(choice: random.Random) -> None:
    name = choice.choice(["unit1.state.Reading1", "unit1.state.Readin", "plant.signal.Order"])
    with (ACTIVITIES / "cut1.py").open("a", encoding="utf-8") as file:
        file.write(f"        context.read({name!r})  # {choice.random()}\n")


def code_that_is_none(choice: random.Random) -> None:
    (ACTIVITIES / "drill1.py").write_text(f"class Drill1: {choice.random()} (", "utf-8")


def code_that_helps(choice: random.Random) -> None:
    (ACTIVITIES / "helper.py").write_text(
        f"def look(context):\n    return context.read('unit1.state.R{choice.random()}')\n", "utf-8"
    )


def no_code(choice: random.Random) -> None:
    (ACTIVITIES / choice.choice(["cut1.py", "test1.py", "load2.py"])).unlink(missing_ok=True)
    a_duration(choice)


def no_output(choice: random.Random) -> None:
    files = sorted(
        path for path in Path("out").rglob("*") if path.is_file() and ACTIVITIES not in path.parents
    )
    choice.choice([path for path in files if path.name != ".asemec.json"]).unlink()
    a_duration(choice)


EDITS: tuple[Callable[[random.Random], None], ...] = (
    a_duration,
    a_condition,
    a_formula,
    a_name,
    a_type,
    a_field,
    a_team,
    an_unused_import,
    other_lines,
    code_that_is_filled_in,
    code_that_is_none,
    code_that_helps,
    no_code,
    no_output,
)
MISTAKES: tuple[Callable[[random.Random], None], ...] = (no_import, nonsense, no_file)
"""Edits that are taken back afterwards."""


@pytest.mark.parametrize("seed", [1])
@pytest.mark.long
def test_any_edits_give_what_a_build_from_nothing_gives(
    seed: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for name, text in large_project(LINES).items():
        Path(name).write_text(text, "utf-8")
    project = Rebuilding()
    choice = random.Random(seed)
    edits = [*EDITS, *MISTAKES]
    choice.shuffle(edits)
    for edit in edits:
        before = Path("hall1.aseme").read_text("utf-8")
        edit(choice)
        project.wait()
        project.again()
        if edit in MISTAKES:
            Path("hall1.aseme").write_text(before, "utf-8")
            project.wait()
            project.again()


def test_what_was_edited_last_is_seen_among_thousands(tmp_path: Path) -> None:
    files = [tmp_path / f"{number}.py" for number in range(3000)]
    for path in files:
        path.touch()
        os.utime(path, (1, 1))
    watch = Watch()
    watch.begin()
    names = [str(path) for path in files]
    watch.depend([*names, str(tmp_path / "new.aseme")], (), set(names))
    for path in (files[2345], tmp_path / "new.aseme", files[7], files[7]):
        path.write_text(path.read_text("utf-8") + "x" if path.exists() else "", "utf-8")
        changes = seen(watch)
        assert [Path(name).name for name in changes.all] == [path.name]
        watch.begin()
        watch.depend([*names, str(tmp_path / "new.aseme")], (), set(names))


def test_a_machine_that_stands_still_while_a_file_changes_sees_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Then all the time is over for which is waited until nothing more changes."""
    monkeypatch.setattr("aseme_dsl.project.building.watch._PATIENCE", 0.0)
    path = tmp_path / "team.aseme"
    watch = Watch()
    watch.begin()
    watch.depend([str(path)])
    for text in ("system One", "system Three"):
        path.write_text(text, "utf-8")
        assert seen(watch).all == (str(path),)
        watch.begin()
        watch.depend([str(path)])
