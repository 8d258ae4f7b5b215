"""A team of real processes: what happens when one is killed, stopped, or when its supervisor ends."""

from __future__ import annotations

import signal
from pathlib import Path

import pytest

from tests.cli.support import asemec
from tests.faults.team import NAME, Started, gone, project, signals_from, started
from tests.runtime.playing import check_line
from tests.support.waiting import LONG, long_enough

pytest.importorskip("zenoh")


def in_order(numbers: list[int]) -> bool:
    """None is lost, doubled or overtaken since the first."""
    return numbers == list(range(numbers[0], numbers[0] + len(numbers)))


def test_a_team_plays_to_its_end(tmp_path: Path) -> None:
    folder = project(tmp_path)

    def played(seconds: int) -> tuple[Started, int, int]:
        with started(folder, "--for", f"{seconds}s", "-v") as run:
            code = run.process.wait(LONG)
            run.end()
        return run, code, seconds

    def have_talked(found: tuple[Started, int, int]) -> bool:
        run, _, _ = found
        return all(signals_from(run.trace("robot1"), other) for other in ("robot2", "robot3"))

    run, code, seconds = long_enough(played, have_talked)
    assert code == 0, run.lines
    assert run.said(r"stopped \(3 processes\): time limit reached")
    assert run.said(r"^robot1 \| .*robot1  Say")
    for name in ("robot1", "robot2", "robot3"):
        trace = run.trace(name)
        assert trace[0]["kind"] == "header" and trace[-1]["kind"] == "finish"
        assert trace[-1]["time"] >= seconds * 1_000_000_000
        for record in trace:
            check_line(record)
    for other in ("robot2", "robot3"):
        assert in_order(signals_from(run.trace("robot1"), other))


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_all(tmp_path: Path, number: int) -> None:
    with started(project(tmp_path)) as run:
        run.wait_for_talk()
        robots = list(run.robots().values())
        code, reason = (0, "terminated") if number == signal.SIGTERM else (130, "interrupted")
        assert run.end(number) == code
        assert gone(robots)
    assert run.said(rf"stopped \(3 processes\): {reason}")
    assert [run.trace(name)[-1]["reason"] for name in ("robot1", "robot2", "robot3")] == ["terminated"] * 3


def test_no_process_is_left_when_the_supervisor_is_killed(tmp_path: Path) -> None:
    with started(project(tmp_path)) as run:
        run.wait_for_talk()
        robots = list(run.robots().values())
        assert len(robots) == 3
        run.process.kill()
        assert gone(robots)


def test_a_killed_robot_is_started_again_and_the_others_know(tmp_path: Path) -> None:
    with started(project(tmp_path)) as run:
        run.wait_for_talk()
        run.robots()["robot2"].kill()
        run.wait_for(lambda: signals_from(run.trace("robot2", 2), "robot1"))
        run.wait_for(lambda: "robot2 restarted" in run.news("robot1"))
        run.wait_for(lambda: 1 in signals_from(run.trace("robot1"), "robot2")[1:])
        assert run.end() == 130
    assert run.said("robot2 was ended by SIGKILL; it is started again in 0.2 s")
    assert run.said("robot2, started 2 times")
    known = ("robot2 connected", "robot2 gone", "robot2 reconnected", "robot2 restarted")
    news = [item for item in run.news("robot1") if item in known]
    assert news[:3] == ["robot2 connected", "robot2 gone", "robot2 restarted"]
    numbers = signals_from(run.trace("robot1"), "robot2")
    second = numbers.index(1, 1)
    assert in_order(numbers[:second]) and in_order(numbers[second:])
    # nobody else was disturbed
    assert in_order(signals_from(run.trace("robot3"), "robot1"))


def test_a_robot_that_stands_still_is_gone_and_comes_back(tmp_path: Path) -> None:
    folder = project(tmp_path, lease="500ms")
    with started(folder) as run:
        run.wait_for_talk()
        robot = run.robots()["robot2"]
        robot.suspend()
        run.wait_for(lambda: "robot2 gone" in run.news("robot1") and "robot2 gone" in run.news("robot3"))
        before = len(signals_from(run.trace("robot3"), "robot1"))
        run.wait_for(lambda: len(signals_from(run.trace("robot3"), "robot1")) > before + 20)
        robot.resume()
        run.wait_for(lambda: "robot2 reconnected" in run.news("robot1"))
        count = len(signals_from(run.trace("robot2"), "robot1"))
        run.wait_for(lambda: len(signals_from(run.trace("robot2"), "robot1")) > count + 50)
        assert run.end() == 130
    for mine, other in (("robot2", "robot1"), ("robot1", "robot2"), ("robot3", "robot1")):
        assert in_order(signals_from(run.trace(mine), other)), (mine, other)
    assert [
        r for r in run.trace("robot1") if r["kind"] == "lost" and r["reason"].startswith("it ended")
    ] == []


def test_a_robot_that_always_dies_is_given_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    say = "import os\n\n\nclass Say:\n    def execute(self, context):\n        os._exit(7)\n"
    with started(project(tmp_path, say=say), "--for", f"{LONG:g}s", "-q") as run:
        run.wait_for(lambda: run.said(r"robot1 has ended with exit code 7; it is started again in 0\.8 s"))
        run.end()


def test_what_cannot_be_started_is_said(tmp_path: Path) -> None:
    network = 'tls = { authority = "a.pem", certificate = "b.pem", key = "c.pem" }\n'
    folder = project(tmp_path, configuration='hosts = { robot9 = "127.0.0.1" }\n' + network)
    run = Started(folder)
    assert run.process.wait(LONG) == 1
    run.end()
    assert run.said("there is no agent robot9 in the team; there are robot1, robot2, robot3")


def test_each_robot_says_what_its_run_has_left_open(tmp_path: Path) -> None:
    text = (
        f"system {NAME}\n"
        "message Offer { int price }\n"
        "aip trade {\n"
        "  participant buyer { sends request Offer  receives agree Offer  process = Ask . Got }\n"
        "  participant seller {\n"
        "    var ready : bool = false\n"
        "    sends agree Offer  receives request Offer  process = Answer . Tell\n"
        "  }\n"
        "  control buyer {\n"
        "    enter Ask : / send request Offer to seller\n"
        "    enter Got : agree Offer from seller\n"
        "  }\n"
        "  control seller {\n"
        "    enter Answer : request Offer from buyer\n"
        "    enter Tell : [ready] / send agree Offer to buyer\n"
        "  }\n"
        "}\n"
        "srm b { plays trade.buyer  liveness { b = Rest . buyer }"
        "  activities { Rest takes 500ms  Ask takes 1ms  Got takes 1ms } }\n"
        "srm s { plays trade.seller  liveness { s = seller }"
        "  activities { Answer takes 1ms  Tell takes 1ms } }\n"
        "team T { bob : b  sue : s }\n"
    )
    (tmp_path / "trade.aseme").write_text(text)
    options = ("--process-per-agent", "--quiet", "--json")
    done = long_enough(
        lambda seconds: asemec("run", "trade.aseme", "--for", f"{seconds}s", *options, cwd=tmp_path),
        lambda done: (
            "Offer from seller" in done.out
            and "[ready]" in done.out
            and all(
                len(talk["members"]) == 2
                for robot in done.json["result"]["robots"]
                for talk in robot["end"]["conversations"]
            )
        ),
    )
    assert done.code == 0, done.out + done.err
    for robot, awaited in zip(
        done.json["result"]["robots"], ("agree Offer from seller", "[ready]"), strict=True
    ):
        end = robot["end"]
        assert [item["protocol"] for item in end["conversations"]] == ["trade"]
        members = end["conversations"][0]["members"]
        assert sorted(item["agent"] for item in members) == ["bob", "sue"]
        assert [item["here"] for item in members if item["agent"] == robot["name"]] == [True]
        assert end["agents"][0]["waits"][0]["awaits"][0]["what"] == awaited
        assert end["stuck"] == []
