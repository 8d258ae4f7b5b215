"""A robot that is started again after a swap plays the version that its team plays by then."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.cli import main
from tests.faults.team import TEAM, Started, project, signals_from, started

pytest.importorskip("zenoh")

CHANGED = TEAM.replace("Say~ || Hear~", "Say~ || Hear~ || Watch~").replace(
    "activities {", "activities {\n    Watch takes 1s simulated"
)
AGAIN = CHANGED.replace("Say every 20ms", "Say every 25ms")
ROBOTS = ("robot1", "robot2", "robot3")


def swap(run: Started, text: str, *arguments: str) -> None:
    """Change the team as an operator does."""
    (run.folder / "changed.aseme").write_text(text)
    assert main(["team", "swap", f"{run.folder}/changed.aseme", *arguments, "-o", f"{run.folder}/out"]) == 0


def begun_as(run: Started, robot: str, life: int) -> str:
    """The model with which a robot has begun a life."""
    trace = run.trace(robot, life)
    return next(agent["model"] for agent in trace[0]["agents"] if agent["name"] == robot)


def swapped_to(run: Started, robot: str, life: int = 1) -> str | None:
    """The model to which a robot was changed last in a life, if it was."""
    found = [r["model"] for r in run.trace(robot, life) if r["kind"] == "swap" and r["what"] == "done"]
    return found[-1] if found else None


def hears_again(run: Started, listener: str, speaker: str) -> bool:
    """Whether a robot has heard the beginning of a second life of another one, and goes on hearing."""
    trace = run.trace(listener)
    news = [
        n
        for n, r in enumerate(trace)
        if r["kind"] == "peer" and (r["peer"], r["what"]) == (speaker, "restarted")
    ]
    since = signals_from(trace[news[-1] :], speaker) if news else []
    return since[:1] == [1] and len(since) > 20


def test_it_begins_as_its_team_goes_on(tmp_path: Path) -> None:
    with started(project(tmp_path)) as run:
        run.wait_for_talk()
        swap(run, CHANGED)
        run.wait_for(lambda: all(swapped_to(run, name) for name in ROBOTS))
        new = swapped_to(run, "robot1")
        assert new != begun_as(run, "robot1", 1)
        run.robots()["robot2"].kill()
        run.wait_for(lambda: hears_again(run, "robot1", "robot2") and run.trace("robot2", 2))
        assert begun_as(run, "robot2", 2) == new
        run.wait_for(lambda: signals_from(run.trace("robot2", 2), "robot1"))
        # the operators reach it where they reach the others, and can change it once more
        swap(run, AGAIN)
        run.wait_for(lambda: swapped_to(run, "robot2", 2))
        last = swapped_to(run, "robot2", 2)
        assert last not in (None, new)
        # now all of them: nobody is left who could tell
        for process in run.robots().values():
            process.kill()
        run.wait_for(lambda: all(run.trace(name, 2 + (name == "robot2")) for name in ROBOTS))
        assert {begun_as(run, name, 2 + (name == "robot2")) for name in ROBOTS} == {last}
        assert run.end() == 130


def test_a_new_run_begins_with_what_is_built_and_one_robot_alone_keeps_its_own(tmp_path: Path) -> None:
    with started(project(tmp_path)) as run:
        run.wait_for_talk()
        built = begun_as(run, "robot1", 1)
        swap(run, CHANGED, "--agent", "robot3")
        run.wait_for(lambda: swapped_to(run, "robot3"))
        new = swapped_to(run, "robot3")
        run.robots()["robot3"].kill()
        run.robots()["robot1"].kill()
        run.wait_for(lambda: run.trace("robot1", 2) and run.trace("robot3", 2))
        assert (begun_as(run, "robot1", 2), begun_as(run, "robot3", 2)) == (built, new)
        assert run.end() == 130
    for trace in (tmp_path / "out").glob("trace.*"):
        trace.unlink()
    with started(tmp_path) as run:
        run.wait_for_talk()
        assert {begun_as(run, name, 1) for name in ROBOTS} == {built}
        assert run.end() == 130
