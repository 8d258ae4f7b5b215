"""Whichever backend an agent is of: the traces of monas, of jade_like and of teams of both are the same."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from aseme_dsl.diagnostics import has_errors
from aseme_dsl.project.building.build import Choice, activities_folder, build
from aseme_dsl.project.building.project import Compiled, compile_root
from aseme_dsl.project.playing.play import Request, load, play
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import Input, Outcome
from tests.support import asleep
from tests.support.lanes import kept

ROOT = Path(__file__).parents[2]
PROGRAMS = sorted(
    path
    for path in [*(ROOT / "tests/acceptance").glob("*.aseme"), *ROOT.glob("examples/*/*.aseme")]
    if "\nsystem " in path.read_text("utf-8")
)
SECOND = 1_000_000_000

INPUTS = {
    "testbehavior": [
        {"at": "0s", "channel": "game.state.GameState", "message": {"player_state": "PLAYING"}},
        {"at": "0s", "channel": "vision.state.Ball", "message": {"visible": True}},
        {"at": "3s", "channel": "vision.state.Ball", "message": {"visible": False}},
        {"at": "5s", "channel": "game.state.GameState", "message": {"player_state": "PENALISED"}},
        {"at": "8s", "channel": "game.state.GameState", "message": {"player_state": "FINISHED"}},
    ]
}
"""What programs are given that nobody else gives anything."""


def trace(compiled: Compiled, folder: Path, backend: str, roles: Mapping[str, str] | None = None) -> bytes:
    """The trace of a program whose agents are of a backend, but for these roles."""
    assert compiled.system is not None and isinstance(compiled.root, Path)
    configuration = compiled.configuration
    choice = Choice(backends=(backend,), roles=roles or {}, activities=configuration.activities)
    built = build(compiled.system, folder, replace(choice, only=frozenset(choice.generated)))
    assert not has_errors(built.diagnostics)
    loaded = load(folder, compiled.system.name, configuration, choice)
    kinds = {role: chart.__module__.partition(".")[0] for role, chart in loaded.charts.items()}
    assert kinds == {role: (roles or {}).get(role, backend) for role in loaded.charts}
    assert {kind for role, kind in kinds.items() if loaded.charts[role].AGENT is not None} <= {"jade_like"}
    lines = folder / f"trace.{backend}.{len(roles or {})}.jsonl"
    plan = None if loaded.team else next(iter(loaded.charts))
    script = folder / "input.jsonl"
    script.write_text(
        "".join(json.dumps(line) + "\n" for line in INPUTS.get(compiled.root.stem, ())), "utf-8"
    )
    request = Request(plan=plan, duration=10 * SECOND, seed=7, trace=lines, script=script)
    play(loaded, activities_folder(folder, choice), configuration, request, tell=lambda line: None)
    return lines.read_bytes()


@pytest.fixture(autouse=True)
def nothing_is_overlooked(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Whenever an agent goes to sleep, of either backend, no transition of it is enabled."""
    overlooked: list[str] = []

    def step(chart: Chart, now: int, inputs: Iterable[Input]) -> Outcome:
        try:
            return asleep.step(chart, now, inputs)
        except AssertionError as error:  # which an agent would take for a mistake in the step
            overlooked.append(str(error))
            raise

    monkeypatch.setattr(Chart, "step", step)
    yield
    assert overlooked == []


@pytest.mark.parametrize(
    "program",
    kept(PROGRAMS, lambda path: path.parent.name not in ("robocup", "warehouse")),
    ids=lambda path: f"{path.parent.name}-{path.stem}",
)
def test_one_seed_is_one_trace(program: Path, tmp_path: Path) -> None:
    project = tmp_path / "project"
    shutil.copytree(program.parent, project, ignore=shutil.ignore_patterns("build", "out", "__pycache__"))
    compiled, folder = compile_root(project / program.name), tmp_path / "out"
    expected = trace(compiled, folder, "monas")
    assert expected.count(b"\n") > 10
    assert trace(compiled, folder, "jade_like") == expected
    assert compiled.system is not None
    roles = [chart.name for chart in compiled.system.iacs]
    assert trace(compiled, folder, "monas", {roles[0]: "jade_like"}) == expected
    assert trace(compiled, folder, "jade_like", dict.fromkeys(roles[1:], "monas")) == expected
