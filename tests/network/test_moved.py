"""Robots that start again on other machines are found there, without a file changed on the others'.

NETWORK_RUNS=N has N teams, and prints how soon: `dev.py long` does.
"""

from __future__ import annotations

import os
import shutil
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from tests.network.machines import Machines, machines
from tests.network.talkers import NAMES, Story, Talkers, deployed, project
from tests.support.waiting import LONG, wait_until

RUNS = int(os.environ.get("NETWORK_RUNS", "0"))
SOON = 5.0
"""So many seconds after its process was started a robot is heard by each other one."""
FIRST, SECOND, *REST = NAMES
SPARE = ("spare", "other")
"""Machines on which no robot runs at the beginning."""

pytest.importorskip("zenoh")
pytestmark = pytest.mark.skipif(not RUNS, reason="long: set NETWORK_RUNS, or run python3 dev.py long")


@dataclass(slots=True)
class Moving(Talkers):
    """A team whose machines have a file of hosts each."""

    def home(self, machine: str) -> Path:
        """The folder of a machine: the file of hosts, and the project."""
        return self.folder.parents[1] / machine

    def know(self, machine: str, **places: str) -> None:
        """Write the file of hosts of a machine: which robot is on which machine."""
        lines = [f'{robot} = "{self.network.addresses[place][0]}"\n' for robot, place in places.items()]
        part = self.home(machine) / "part"
        part.write_text("".join(lines))
        part.replace(self.home(machine) / "hosts.toml")

    def trace_of(self, machine: str, robot: str) -> list[dict[str, Any]]:
        """What a robot has traced on a machine."""
        return Talkers(self.home(machine) / "p", self.network, {}).trace(robot)

    def wait_for(self, on: dict[str, str], since: float) -> float:
        """Until each robot, `on` its machine, has heard each other one since a moment; how long it took."""

        def heard(robot: str) -> set[str]:
            records = self.trace_of(on[robot], robot)
            origin = records[0]["machine"]["origin"]
            return {
                r["input"][0] for r in records if r["kind"] == "arrived" and origin + r["time"] > since * 1e9
            }

        def all_heard() -> bool:
            try:
                return all(heard(robot) >= set(NAMES) - {robot} for robot in NAMES)
            except Exception:  # a trace is not there yet
                return False

        wait_until(all_heard, 40, pause=0.2)
        return time.monotonic() - since

    def stories(self, on: dict[str, str]) -> dict[str, Story]:
        """End all robots; what each has to tell of its time on its machine."""
        over = time.monotonic()
        for process in self.processes.values():
            process.terminate()
        for process in self.processes.values():
            assert "Traceback" not in process.communicate(timeout=LONG)[0]
        return {robot: Story(robot, self.trace_of(machine, robot), over) for robot, machine in on.items()}

    def move(self, robot: str, machine: str) -> float:
        """Kill a robot and start it on another machine; when that was."""
        self.processes[robot].kill()
        self.processes[robot].communicate()
        at = time.monotonic()
        self.begin(robot, machine=machine, folder=self.home(machine) / "p")
        return at


def moving(folder: Path, network: Machines) -> Moving:
    """The team. Each of its machines has the project."""
    _, rest = deployed(folder, network).split("\n", 1)
    rest = rest.replace('interface = "eth0"\n', "")
    team = Moving(folder / "first" / "p", network, {})
    team.folder.parent.mkdir()
    team.know("first", **known())
    project(team.folder, f'hosts = "../hosts.toml"\n{rest}')
    for machine in (*NAMES, *SPARE):
        shutil.copytree(team.folder.parent, folder / machine)
    return team


def known(**moved: str) -> dict[str, str]:
    return {name: name for name in NAMES} | moved


@pytest.mark.parametrize("run", range(max(1, RUNS)))
def test_robots_that_move_are_found(tmp_path: Path, run: int) -> None:
    with machines((*NAMES, *SPARE), run) as network:
        team = moving(tmp_path, network)
        for robot in NAMES:
            team.begin(robot, folder=team.home(robot) / "p")
        on = known()
        team.wait_for(on, time.monotonic())
        time.sleep(1.0)

        spare, other = SPARE
        team.know(spare, **known(robot1=spare))
        on |= {FIRST: spare}
        one = team.wait_for(on, team.move(FIRST, spare))
        # Of two that have moved, neither knows where the other one is; then one is told while it runs.
        team.know(other, **known(robot2=other))
        on |= {SECOND: other}
        team.move(SECOND, other)
        time.sleep(6.0)
        records = team.trace_of(other, SECOND)
        assert not any(r["kind"] == "arrived" and r["input"][0] == FIRST for r in records)
        at = time.monotonic()
        team.know(other, **known(robot1=spare, robot2=other))
        two = team.wait_for(on, at)
        time.sleep(3.0)
        print(f"one heard by all {one:.2f} s after its start, two {two:.2f} s after the news", flush=True)
        stories = team.stories(on)
    quiet = max(stories[robot].silence(SECOND, at, stories[robot].over) for robot in REST)
    print(f"meanwhile the longest silence of {SECOND} was {quiet:.2f} s", flush=True)
    assert one < SOON and two < SOON
    assert [wrong for robot in REST for wrong in stories[robot].misplaced(SECOND, at)] == []
