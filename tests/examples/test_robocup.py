"""The example team: it compiles without a word, one seed is one match, it keeps its clauses and scores."""

from __future__ import annotations

import importlib.util
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.backends.backend import BackendOptions
from aseme_dsl.backends.monas import BACKEND
from aseme_dsl.compiler import analyse
from aseme_dsl.runtime import Loaded, Team, activities_in, load_system, make_team
from aseme_dsl.worlds.field import render
from aseme_dsl.worlds.field.match import Match
from tests.support.traces import texts_of

EXAMPLE = Path(__file__).parents[2] / "examples" / "robocup"
PICTURE = EXAMPLE.parents[1] / "docs" / "pictures" / "match.svg"
SECOND = 1_000_000_000
SEEDS = [int(word) for word in os.environ.get("MATCH_SEEDS", "11").split()]
"""The whole matches: one takes as long as a thousand small tests."""


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the example, so that playing it leaves nothing in the checkout."""
    folder = tmp_path_factory.mktemp("examples") / "robocup"
    shutil.copytree(EXAMPLE, folder, ignore=shutil.ignore_patterns("build", "__pycache__"))
    return folder


@dataclass
class Played:
    """One run of the command: what it printed, and what it left behind."""

    result: dict[str, Any]
    progress: str
    trace: bytes
    folder: Path


def play(project: Path, *arguments: str) -> Played:
    command = [sys.executable, "-m", "aseme_dsl", "run", str(project), "--json", *arguments]
    done = subprocess.run(command, capture_output=True, encoding="utf-8")
    assert done.returncode == 0, done.stdout + done.stderr
    result = json.loads(done.stdout)["result"]
    return Played(result, done.stderr, lines_of(Path(result["trace"])), Path(result["folder"]))


def lines_of(trace: Path) -> bytes:
    return "".join(f"{text}\n" for text in texts_of(trace)).encode()


@pytest.fixture(scope="module")
def twenty_seconds(project: Path) -> Played:
    return play(project, "--for", "20s", "--seed", "1")


def test_it_compiles_without_a_word() -> None:
    analysis = analyse(EXAMPLE / "kouretes.aseme")
    assert analysis.diagnostics == ()
    assert analysis.system is not None


def test_every_activity_is_written() -> None:
    """Nothing is left to a template, and no module stands there that no role uses."""
    system = analyse(EXAMPLE / "kouretes.aseme").system
    assert system is not None
    generated = BACKEND.generate(system, BackendOptions())
    used = {artefact.path.partition("/")[2] for artefact in generated if artefact.kept}
    assert {path.name for path in (EXAMPLE / "activities").glob("*.py")} == used | {"knowledge.py"}


def test_it_leaves_models_diagrams_code_a_trace_and_a_picture(twenty_seconds: Played, project: Path) -> None:
    folder = twenty_seconds.folder
    assert folder == project / "build"
    models = {path.name for path in (folder / "models").iterdir()}
    assert models >= {"sag.json", "suc.json", "aip.attack.json", "eac.attack.json"}
    assert models >= {"srm.player.json", "iac.player.json", "srm.goalie.json", "iac.goalie.json"}
    assert {path.stem for path in (folder / "diagrams").glob("*.svg")} >= {Path(name).stem for name in models}
    for role in ("player", "goalie"):
        assert (folder / "monas" / "Kouretes" / role / "plan.py").is_file()
        assert (folder / "monas" / "Kouretes" / role / "step.py").is_file()
    assert list((folder / "proto").glob("*.proto"))
    assert twenty_seconds.trace.startswith(b'{"kind":"header"')
    assert (folder / "match.svg").read_text("utf-8").startswith("<svg")


def test_it_tells_how_the_match_goes(twenty_seconds: Played) -> None:
    lines = twenty_seconds.progress.splitlines()
    assert any(line.startswith("0:05.0  0:0  [") and "robot1 NoGame" in line for line in lines)
    assert "so far: Kouretes" in twenty_seconds.result["summary"]
    assert "match.svg" in twenty_seconds.result["summary"]


def test_nothing_is_done_that_is_not_declared(twenty_seconds: Played) -> None:
    kinds = {json.loads(line)["kind"] for line in twenty_seconds.trace.splitlines()}
    assert not kinds & {"fault", "error", "refused", "radio_failed"}
    assert twenty_seconds.result["faults"] == 0


@pytest.mark.long
def test_one_seed_is_one_match(twenty_seconds: Played, project: Path) -> None:
    again = play(project, "--for", "20s", "--seed", "1", "--trace", str(project / "again.jsonl"))
    assert again.trace == twenty_seconds.trace
    other = play(project, "--for", "5s", "--seed", "2", "--trace", str(project / "other.jsonl"))
    begun = other.trace.splitlines()[1:-1]  # the first line names the seed
    assert begun != twenty_seconds.trace.splitlines()[1 : 1 + len(begun)]


# ---- whole matches ------------------------------------------------------------------------------


@dataclass
class Watched:
    """A whole match, and what its agents did."""

    score: tuple[int, int]
    failures: list[str | None]
    most_centers: int = 0
    """How many robots were in the center's branch at one instant, at the most."""
    attack: list[str] = field(default_factory=list)
    """The activities of the attack that have a place in its clauses, in the order of their starts."""
    picture: str = ""
    radio_messages: int = 0
    unsaid: int = 0


@pytest.fixture(scope="module")
def system(tmp_path_factory: pytest.TempPathFactory) -> Loaded:
    compiled = analyse(EXAMPLE / "kouretes.aseme").system
    assert compiled is not None
    folder = tmp_path_factory.mktemp("robocup") / "monas"
    for artefact in BACKEND.generate(compiled, BackendOptions()):
        path = folder / artefact.path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(artefact.text, encoding="utf-8")
    return load_system(folder / "Kouretes")


@pytest.fixture(scope="module")
def matches(system: Loaded) -> Mapping[int, Watched]:
    """The matches of some seeds, played when they are asked for."""
    return _Matches(system)


class _Matches(dict[int, Watched]):
    def __init__(self, system: Loaded) -> None:
        self._system = system

    def __missing__(self, seed: int) -> Watched:
        self[seed] = watch(self._system, seed)
        return self[seed]


def new_match(seed: int) -> Match:
    spec = importlib.util.spec_from_file_location("robocup_world", EXAMPLE / "world.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    match = module.make(seed=seed)
    assert isinstance(match, Match)
    return match


def watch(system: Loaded, seed: int) -> Watched:
    match = new_match(seed)
    seen = Watched((0, 0), [])
    branches = {
        plan.name: {info.participant: info.label + "." for info in plan.branches} for plan in system.plans
    }
    roles = dict(system.team)

    def look(team: Team) -> str | None:
        centers = sum(
            any(in_branch(agent.name, "center", label) for label in agent.chart.configuration())
            for agent in team.agents
        )
        seen.most_centers = max(seen.most_centers, centers)
        return "the match is over" if match.over else None

    def in_branch(agent: str, participant: str, label: str) -> bool:
        return label.startswith(branches[roles[agent]].get(participant, "-"))

    def listen(record: Mapping[str, Any]) -> None:
        if record["kind"] == "activity" and record["what"] == "start":
            for activity, participant in (("PassBall", "center"), ("KickBall", "center_for")):
                if record["activity"] == activity and in_branch(
                    record["agent"], participant, record["label"]
                ):
                    seen.attack.append(f"{activity}@{participant}")
        elif record["kind"] == "radio_failed":
            seen.unsaid += 1

    team = make_team(
        system,
        activities_in(EXAMPLE / "activities"),
        seed=seed,
        world=match,
        until_ns=140 * SECOND,
        stop=look,
        listeners=(listen,),
    )
    result = team.run()
    assert result.reason == "the match is over"
    seen.picture = render.svg(match)
    seen.score = match.result().score
    seen.failures = [agent.failure for agent in result.agents]
    seen.radio_messages = match.radio[0].said
    return seen


@pytest.mark.parametrize("seed", SEEDS)
def test_it_keeps_the_clauses_of_its_protocol(matches: Mapping[int, Watched], seed: int) -> None:
    """clause at most one center; clause PassBall@center before KickBall@center_for."""
    match = matches[seed]
    assert match.most_centers == 1
    passes = 0
    for activity in match.attack:
        passes += 1 if activity == "PassBall@center" else -1
        assert passes >= 0, match.attack


def test_the_attack_of_the_papers_is_seen(matches: Mapping[int, Watched]) -> None:
    assert {"PassBall@center", "KickBall@center_for"} <= set(matches[11].attack)


@pytest.mark.parametrize("seed", SEEDS)
def test_it_plays_well(matches: Mapping[int, Watched], seed: int) -> None:
    """A match is the same to the bit everywhere; that the team wins it is what a visitor should see."""
    match = matches[seed]
    assert match.failures == [None] * 4
    assert match.score[0] > match.score[1]


def test_the_picture_in_the_documentation_is_of_this_match(
    matches: Mapping[int, Watched], pytestconfig: pytest.Config
) -> None:
    if pytestconfig.getoption("--snapshot-update"):
        PICTURE.write_text(matches[11].picture, "utf-8")
    assert matches[11].picture == PICTURE.read_text("utf-8")


def test_it_stays_within_what_the_radio_takes(matches: Mapping[int, Watched]) -> None:
    match = matches[11]
    assert match.radio_messages > 500
    assert match.unsaid == 0
