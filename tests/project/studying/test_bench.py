"""`asemec bench`: what a step costs, with inputs that charts can take; the ways to run a role must agree."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import pytest

from aseme_dsl.project.building.build import Choice, build
from aseme_dsl.project.building.project import compile_root
from aseme_dsl.project.studying.bench import Bench, Different, bench, compare, plain_classes
from aseme_dsl.project.studying.bench_report import markdown
from aseme_dsl.project.studying.drawn import drawn
from aseme_dsl.runtime.version.loading import load_system
from tests.cli.support import BAD, GOOD, asemec_here
from tests.support.lamp import LAMP

ROOT = Path(__file__).parents[3]
FILES = [
    *sorted((ROOT / "tests" / "acceptance").glob("*.aseme")),
    *sorted((ROOT / "examples" / "home").glob("*.aseme")),
]


def measured(root: Path, folder: Path, steps: int = 60, seed: int = 1) -> Bench:
    system = compile_root(root).system
    assert system is not None
    return bench(system, folder, [root.parent], steps=steps, rounds=2, seed=seed)


@pytest.mark.parametrize("file", FILES, ids=lambda path: path.name)
def test_every_role_takes_its_inputs(file: Path, tmp_path: Path) -> None:
    found = measured(file, tmp_path)
    system = compile_root(file).system
    assert system is not None
    assert [item.role for item in found.roles] == [chart.name for chart in system.iacs]
    for item in found.roles:
        assert item.steps and item.visited and item.taken
        assert item.visited <= item.activities and item.taken <= item.transitions
        timed = item.ways["agent"]
        assert timed.step > 0 and timed.idle > 0 and timed.memory > 0
        assert ("plain" in item.ways) != bool(item.refused)
    assert re.search(rf"\n\| {found.roles[0].role} +\| agent +\| +\d+ \|", markdown(found))


def test_a_plain_statechart_is_compared_and_timed_beside(tmp_path: Path) -> None:
    (tmp_path / "lamp.aseme").write_text(LAMP, "utf-8")
    item = measured(tmp_path / "lamp.aseme", tmp_path / "out", steps=400).roles[0]
    assert list(item.ways) == ["agent", "plain", "Machine.send", "Machine.post"]
    assert (item.steps, item.visited, item.activities, item.refused) == (400, 2, 2, ())
    assert item.taken == item.transitions
    assert item.ways["Machine.send"].memory > item.ways["plain"].memory + 500  # it has a queue


def test_a_role_that_comes_to_its_end_is_begun_anew(tmp_path: Path) -> None:
    text = "system Short\nsrm one { liveness { one = Go . Stop } }\nsrm two { liveness { two = Go~ } }\n"
    (tmp_path / "short.aseme").write_text(text, "utf-8")
    found = measured(tmp_path / "short.aseme", tmp_path / "out", steps=60)
    one, two = found.roles
    assert (one.steps, two.steps, two.starts) == (60, 60, 1) and one.starts >= 20
    assert list(one.ways) == ["agent", "plain", "Machine.send", "Machine.post"]
    said = markdown(found)
    assert f"`one` came to its end before all inputs were played, and was begun {one.starts} times." in said
    assert "`two` came to its end" not in said


def test_variables_that_are_called_otherwise_on_the_blackboard(tmp_path: Path) -> None:
    """`changed` is a method of a blackboard that is told of changes: the variable is `changed_2` there."""
    text = LAMP.replace("touched", "changed").replace("touch [", "touch [changed < 2 && ")
    text = text.replace("liveness", "activities { Dark writes changed }\n  liveness")
    (tmp_path / "lamp.aseme").write_text(text, "utf-8")
    item = measured(tmp_path / "lamp.aseme", tmp_path / "out", steps=400).roles[0]
    assert list(item.ways) == ["agent", "plain", "Machine.send", "Machine.post"]


def test_variables_that_are_called_like_what_others_are_renamed_to(tmp_path: Path) -> None:
    text = LAMP.replace("touched", "changed")
    text = text.replace("var changed : int = 0", "var changed : int = 0 var changed_2 : int = 5")
    text = text.replace("RED]", "RED && changed < 2 && changed_2 == 5]")
    (tmp_path / "lamp.aseme").write_text(text, "utf-8")
    item = measured(tmp_path / "lamp.aseme", tmp_path / "out", steps=400).roles[0]
    assert list(item.ways) == ["agent", "plain", "Machine.send", "Machine.post"]


def test_a_seed_draws_the_same(tmp_path: Path) -> None:
    file = ROOT / "tests" / "acceptance" / "kouretes.aseme"
    one, same, other = (
        [(item.steps, item.visited, item.taken) for item in measured(file, tmp_path / name, seed=seed).roles]
        for name, seed in (("one", 1), ("same", 1), ("other", 2))
    )
    assert one == same
    assert one != other


def test_nothing_is_timed_where_the_ways_to_run_a_role_disagree(tmp_path: Path) -> None:
    (tmp_path / "lamp.aseme").write_text(LAMP, "utf-8")
    system = compile_root(tmp_path / "lamp.aseme").system
    assert system is not None
    build(system, tmp_path, Choice(only=frozenset({"monas"})))
    loaded = load_system(tmp_path / "monas" / "Lamp")
    messages = vars(loaded.modules["monas.Lamp.messages"])
    kind = loaded.charts["lamp"]
    course = drawn(system, system.iacs[0], kind, messages, 50, 1)
    plain = plain_classes(system, tmp_path, ())[0]["lamp"]
    assert compare(plain, kind, course) == 50
    with pytest.raises(Different, match="after step 50"):
        compare(plain, kind, replace(course, trail=(*course.trail[:-1], ("0.9",))))


def test_the_command(tmp_path: Path) -> None:
    (tmp_path / "good.aseme").write_text(GOOD, "utf-8")
    (tmp_path / "bad.aseme").write_text(BAD, "utf-8")
    done = asemec_here("bench", "good.aseme", "--steps", "50", "--rounds", "1", "--seed", "7", cwd=tmp_path)
    assert done.code == 0 and done.out.startswith("# Walker\n\nSeed 7;"), done.err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["bad.aseme", "good.aseme"]
    said = asemec_here("bench", "good.aseme", "--steps", "50", "--rounds", "1", "--json", cwd=tmp_path).json
    assert said["format"] == 1 and said["seed"] == 1
    assert said["roles"][0]["ways"]["agent"]["step"] > 0
    assert asemec_here("bench", "bad.aseme", cwd=tmp_path).code == 1
    wrong = asemec_here("bench", "good.aseme", "--plot", "bench.png", cwd=tmp_path)
    assert wrong.code == 2 and ".svg" in wrong.err
    wrong = asemec_here("bench", "good.aseme", "--role", "robott", cwd=tmp_path)
    assert wrong.code == 2 and "Did you mean 'robot'?" in wrong.err


def test_no_file_of_the_user_is_written_over(tmp_path: Path) -> None:
    (tmp_path / "good.aseme").write_text(GOOD, "utf-8")
    (tmp_path / "top.aseme").write_text('import "good.aseme"\n', "utf-8")
    run = asemec_here("run", "good.aseme", "--for", "2s", "--trace", "run.jsonl", cwd=tmp_path)
    assert run.code == 0, run.err
    (tmp_path / "mine.svg").write_text("<svg/>\n", "utf-8")
    (tmp_path / "pyproject.toml").write_text("[tool.asemec]\n", "utf-8")
    (tmp_path / "link.md").symlink_to("good.aseme")
    before = {path: path.read_bytes() for path in tmp_path.iterdir() if path.is_file()}
    few = ("bench", "good.aseme", "--steps", "20", "--rounds", "1")
    for arguments, text in (
        (("-o", "good.aseme"), "good.aseme is read"),
        (("-o", "link.md"), "link.md is read"),
        (("-o", "top.aseme"), "top.aseme is there already"),
        (("-o", "pyproject.toml"), "pyproject.toml is there already"),
        (("--inputs", "run.jsonl", "-o", "run.jsonl"), "run.jsonl is read"),
        (("-o", "run.jsonl"), "is not the report of a bench that asemec wrote"),
        (("--plot", "mine.svg"), "is not a plot that asemec wrote"),
        (("-o", "new.svg", "--plot", "./new.svg"), "would be written twice"),
        (("--inputs", "run.jsonl", "--inputs", "./run.jsonl"), "run.jsonl is given twice"),
    ):
        done = asemec_here(*few, *arguments, cwd=tmp_path)
        assert done.code == 2 and done.out == "" and text in done.err, done.err
    assert {path: path.read_bytes() for path in tmp_path.iterdir() if path.is_file()} == before
    for _ in range(2):  # what asemec wrote, it writes again
        assert asemec_here(*few, "-o", "bench.md", "--plot", "bench.svg", cwd=tmp_path).code == 0


def test_the_report_and_its_plot_as_files(tmp_path: Path) -> None:
    (tmp_path / "good.aseme").write_text(GOOD, "utf-8")
    few = ("--steps", "50", "--rounds", "1")
    files = ("-o", "out/bench.md", "--plot", "out/pictures/bench.svg")
    done = asemec_here("bench", "good.aseme", *few, *files, cwd=tmp_path)
    assert done.code == 0 and done.out.splitlines() == ["out/pictures/bench.svg", "out/bench.md"], done.err
    assert "](pictures/bench.svg)" in (tmp_path / "out" / "bench.md").read_text("utf-8")
    plot = (tmp_path / "out" / "pictures" / "bench.svg").read_text("utf-8")
    assert "robot, agent" in plot and "robot, Machine.send" in plot and "idle tick" in plot
    (tmp_path / "file").touch()
    done = asemec_here("bench", "good.aseme", *few, "-o", "file/bench.md", cwd=tmp_path)
    assert done.code == 1 and "Traceback" not in done.err and "file" in done.err
