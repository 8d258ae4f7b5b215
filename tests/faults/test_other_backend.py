"""Teams of jade_like, and of both kinds, as real processes: they talk, are changed, and come back."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.faults.team import NAME, TEAM, project, signals_from, started
from tests.faults.test_restarted_version import CHANGED, ROBOTS, begun_as, swap, swapped_to

pytest.importorskip("zenoh")

OWN = """\
from jade_like.TALK.robot import agent, behaviours


class Robot(behaviours.Robot):
    def on_start(self) -> None:
        self.log("begins")

    def on_end(self) -> None:
        self.log("is left")


class TALKRobotAgent(agent.RobotAgent):
    def setup(self) -> None:
        self.use(Robot)
""".replace("TALK", NAME)


def logs(trace: list[dict[str, object]]) -> list[object]:
    return [record["text"] for record in trace if record["kind"] == "log"]


def test_robots_with_behaviours_are_changed_and_come_back(tmp_path: Path) -> None:
    folder = project(tmp_path)
    (folder / "activities" / f"{NAME.lower()}_robot_agent.py").write_text(OWN)
    with started(folder, "--backend", "jade_like") as run:
        run.wait_for_talk()
        assert logs(run.trace("robot1")) == ["begins"]
        swap(run, CHANGED)
        run.wait_for(lambda: all(swapped_to(run, name) for name in ROBOTS))
        new = swapped_to(run, "robot1")
        assert new != begun_as(run, "robot1", 1)
        run.robots()["robot2"].kill()
        run.wait_for(lambda: logs(run.trace("robot2", 2)))
        assert begun_as(run, "robot2", 2) == new
        run.wait_for(lambda: signals_from(run.trace("robot2", 2), "robot1"))
        assert logs(run.trace("robot1")) == ["begins"]  # it goes on: nothing was left
    (version,) = (path for path in (folder / "out" / "versions").iterdir() if path.is_dir())
    assert {path.name for path in version.iterdir()} == {"monas", "jade_like", "activities"}


MIXED = (
    TEAM.replace(
        "team T { robot[1..3] : robot }", "srm other { includes robot  liveness { other = robot } }\n"
    )
    + """
team T { robot1, robot2 : robot  robot3 : other }
"""
)


def test_robots_of_both_kinds_talk(tmp_path: Path) -> None:
    folder = project(tmp_path, text=MIXED)
    with started(folder, "--backend", "other=jade_like") as run:
        run.wait_for_talk()
        swap(run, MIXED.replace("Say every 20ms", "Say every 25ms"))
        run.wait_for(lambda: all(swapped_to(run, name) for name in ROBOTS))
