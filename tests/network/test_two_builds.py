"""Robots of two builds in one team on four machines: what fits goes on, the rest is refused to its sender.

NETWORK_RUNS=N has N such teams, and prints what was refused and how soon: `dev.py long` does.
"""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.network.machines import machines
from tests.network.talkers import NAMES, OFFICE, TEAM, Story, Talkers, deployed, project
from tests.support.network import own_name
from tests.support.waiting import LONG

RUNS = int(os.environ.get("NETWORK_RUNS", "0"))
SOON = 1.0
"""So many seconds after it has sent something a sender knows that it is refused."""
OLD = (
    TEAM.replace(
        "topic team { signal Tick queued }", "topic team { signal Tick queued  signal Count queued }"
    )
    .replace("message Question { int n }", "message Question { int n }\nmessage Count { int n }")
    .replace("writes team.signal.Tick", "writes team.signal.Tick, team.signal.Count")
    .replace("robot4.team.signal.Tick", "robot4.team.signal.Tick, robot4.team.signal.Count")
    .replace("robot1.team.signal.Tick,", "robot1.team.signal.Tick, robot1.team.signal.Count,")
)
NEW = (
    OLD.replace("int n  string who }", "int n  string who  optional int more }")  # fits
    .replace("Think takes 300ms", "Think takes 310ms")  # fits
    .replace(
        "message Count { int n }", "message Count { int n  int of }"
    )  # the new build refuses the old one
    .replace("message Question { int n }", "message Question { double n }")  # another protocol
)
SAY = """
from aseme_dsl.runtime import Context
from monas.TALK.messages import Count, Tick


class Say:
    def execute(self, context: Context) -> None:
        Say.n = getattr(Say, "n", 0) + 1
        context.publish("team.signal.Tick", Tick(n=Say.n, who=context.agent))
        if Say.n >= 100:
            context.publish("team.signal.Count", Count(n=Say.n))
"""
OF_OLD, OF_NEW = NAMES[:2], NAMES[2:]

pytest.importorskip("zenoh")
pytestmark = pytest.mark.skipif(not RUNS, reason="long: set NETWORK_RUNS, or run python3 dev.py long")


@pytest.mark.parametrize("run", range(max(1, RUNS)))
def test_robots_of_two_builds_talk_and_know_what_is_refused(tmp_path: Path, run: int) -> None:
    name = own_name("Two")
    with machines((*NAMES, OFFICE), seed=run) as network:
        configuration = deployed(tmp_path, network)
        counting = SAY.replace("Count(n=Say.n)", "Count(n=Say.n, of=1)")
        old = project(tmp_path / "old", configuration, OLD, name, SAY)
        new = project(tmp_path / "new", configuration, NEW, name, counting)
        teams = [Talkers(folder, network, {}) for folder in (old, new)]
        for team, robots in zip(teams, (OF_OLD, OF_NEW), strict=True):
            for robot in robots:
                team.begin(robot)
        time.sleep(20.0)
        command = (
            f"cd {old} && {sys.executable} -m aseme_dsl team status --key ../operator.toml -o out --json"
        )
        status = json.loads(network.run(OFFICE, "sh", "-c", command))
        for process in (one for team in teams for one in team.processes.values()):
            process.terminate()
        consoles = {
            robot: process.communicate(timeout=LONG)[0]
            for team in teams
            for robot, process in team.processes.items()
        }
        stories = {robot: Story(robot, team.trace(robot), 0.0) for team in teams for robot in team.processes}
    said = {one["agents"][0]["name"]: one["peers"] for one in status["processes"]}
    times = []
    for robot, story in stories.items():
        others = OF_NEW if robot in OF_OLD else OF_OLD
        for peer in set(NAMES) - {robot}:
            assert len(story.heard[peer]) > 100 and story.misplaced(peer) == []
            assert bool(said[robot][peer]["incompatible"]) == (peer in others)
        times += list(refusals(story))
        for peer in others:
            assert f"{peer} does not read Question, since it is of another build" in consoles[robot]
            assert f"{peer} is of another build" in consoles[robot]
    print(
        f"{len(times)} kinds of messages refused, their senders knew it after {max(times):.3f} s at the most",
        flush=True,
    )
    assert len(times) == 10 and max(times) < SOON  # Question from each to two, Count from robot1 to two


def refusals(story: Story) -> Iterator[float]:
    """So long after it had sent the first of something a robot knew that another one refuses it."""
    met = {r["peer"]: story.at(r) for r in story.records if r["kind"] == "peer" and r["what"] == "connected"}
    for record in story.records:
        if record["kind"] == "peer" and record["what"] == "rejected":
            name, peer = record["reason"].partition(":")[0], record["peer"]
            first = next(
                story.at(r)
                for r in story.records
                if r.get("channel", r.get("message")) == name
                and (r["kind"] == "message" or (r["kind"] == "agent_message" and peer in r["to"]))
            )
            yield story.at(record) - max(first, met[peer])
