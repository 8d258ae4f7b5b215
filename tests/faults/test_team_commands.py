"""`asemec team` on real processes: who is there, who is not, what has happened, and an end in order."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress
from types import SimpleNamespace
from typing import Any

import pytest

from aseme_dsl.project.operating.telling import _process_lines
from aseme_dsl.runtime.control.control import Control
from aseme_dsl.runtime.time.synchronised import synchronised
from tests.faults.test_operate import Here, Running, here
from tests.support.waiting import LONG, wait_until

__all__ = ["here"]  # the fixture

PAIR = """\
system Pair
message Count { int n }
topic team { state Count  signal Count }
srm talker { liveness { talker = Tell~ } activities { Tell every 50ms takes 1ms } }
srm hearer { liveness { hearer = Wait~ } activities { Wait takes 1s } }
team Pair { ann : talker  bob : hearer }
"""


def node(here: Here, name: str) -> subprocess.Popen[str]:
    """One agent of the pair, in a process of its own."""
    return here.begin("node", name, "--from", "out", "-q")


@pytest.fixture
def pair(here: Here) -> Iterator[tuple[Here, subprocess.Popen[str], subprocess.Popen[str]]]:
    pytest.importorskip("zenoh")
    here.write("pair.aseme", PAIR)
    assert here.asemec("build", "pair.aseme", "-o", "out")[0] == 0
    ann, bob = node(here, "ann"), node(here, "bob")
    wait_until(lambda: connected(here), pause=0.1)
    yield here, ann, bob


def status(here: Here) -> tuple[int, dict[str, Any]]:
    code, said = here.asemec("team", "status", "--json")
    return code, json.loads(said)


def connected(here: Here) -> list[dict[str, Any]]:
    """What the two processes say of themselves, once each is connected with the other."""
    processes: list[dict[str, Any]] = status(here)[1].get("processes", [])
    peers = [peer for process in processes for peer in process["peers"].values()]
    return processes if len(peers) == 2 and all(peer["connected"] for peer in peers) else []


Pair = tuple[Here, subprocess.Popen[str], subprocess.Popen[str]]


def test_status_has_all_that_an_operator_looks_for(pair: Pair) -> None:
    here, _, _ = pair

    processes = connected(here)
    code, found = status(here)
    assert (code, found["format"], found["ok"]) == (0, 1, True)
    assert (found["members"], found["missing"], found["silent"]) == (["ann", "bob"], [], [])
    by_name = {process["agents"][0]["name"]: process for process in processes}
    ann = by_name["ann"]
    assert ann["process"]["memory"] > 1 << 20 and ann["process"]["cpu"] > 0
    assert ann["agents"][0]["states"] and ann["agents"][0]["waiting"] >= 0
    assert set(ann["peers"]) == {"bob"} and ann["elsewhere"] == ["bob"]
    code, text = here.asemec("team", "status")
    assert code == 0
    assert "  to bob       connected" in text and "MiB" in text


def test_a_member_that_does_not_answer_is_named(pair: Pair) -> None:
    here, _, bob = pair
    bob.send_signal(signal.SIGSTOP)
    code, said = here.asemec("team", "status")
    assert code == 1
    assert f"process {bob.pid} (bob) does not answer" in said
    assert "  ann          talker" in said
    bob.kill()
    bob.wait()
    code, found = status(here)
    assert code == 1
    assert (found["ok"], found["missing"]) == (False, ["bob"])
    code, said = here.asemec("team", "status")
    assert code == 1
    assert "bob does not answer: it runs in no process that was asked" in said


def test_logs_tell_what_has_happened(pair: Pair) -> None:
    here, _, bob = pair
    bob.kill()
    bob.wait()

    def gone() -> str:
        code, said = here.asemec("team", "logs")
        assert code == 0
        return said if "peer: gone" in said else ""

    assert "ann " in wait_until(gone, pause=0.1)
    code, said = here.asemec("team", "logs", "--json", "--last", "5", "--agent", "ann")
    assert code == 0
    lines = [json.loads(line) for line in said.splitlines()]
    assert 0 < len(lines) <= 5
    assert {"process", "number", "at", "record"} == set(lines[0])
    assert any(line["record"].get("what") == "gone" for line in lines)
    code, said = here.asemec("team", "logs", "--agent", "zoe")
    assert (code, said) == (0, "")


def test_stop_ends_agents_in_order_and_names_who_does_not_answer(pair: Pair) -> None:
    here, ann, bob = pair
    code, said = here.asemec("team", "stop", "zoe")
    assert code == 1
    assert "there is no agent zoe" in said
    bob.send_signal(signal.SIGSTOP)
    code, said = here.asemec("team", "stop", "--within", "30s")
    assert code == 1
    assert said.startswith("ann stopped\n")
    assert f"process {bob.pid} (bob) does not answer" in said
    assert ann.wait(LONG) == 0
    bob.send_signal(signal.SIGCONT)
    wait_until(lambda: "hearer" in here.asemec("team", "status")[1], pause=0.1)
    code, said = here.asemec("team", "stop", "bob", "--json")
    assert (code, json.loads(said)["stopped"]) == (0, ["bob"])
    assert bob.wait(LONG) == 0
    code, said = here.asemec("team", "stop")
    assert code == 1
    assert "nothing runs from out" in said


def test_two_agents_of_one_process_are_stopped_together(here: Here) -> None:
    here.write("pair.aseme", PAIR)
    process = here.start("pair.aseme", "-o", "out")
    here.agents()
    code, said = here.asemec("team", "stop", "ann")
    assert code == 1
    assert "ann runs in one process with bob: name them, too" in said
    code, said = here.asemec("team", "stop", "bob", "ann")
    assert (code, said) == (0, "ann stopped\nbob stopped\n")
    assert process.wait(LONG) == 0


def test_a_flood_of_questions_keeps_no_one_from_an_answer(pair: Pair) -> None:
    from aseme_dsl.runtime.control.control_socket import ControlError, ask, endpoints

    here, _, _ = pair
    paths = endpoints(here.folder / "out")
    for number in range(1000):
        with suppress(ControlError):
            ask(paths[number % 2], {"request": "logs", "after": -number, "most": 10**9})
    code, found = status(here)
    assert (code, found["ok"]) == (0, True)


def test_the_screen_shows_the_team_and_its_records(pair: Pair) -> None:
    pytest.importorskip("textual")
    import asyncio

    from textual.widgets import DataTable, Label, RichLog

    from aseme_dsl.cli.team.screen import Screen

    here, _, bob = pair
    screen = Screen(here.folder / "out", None)

    async def use() -> tuple[int, str, str, int]:
        async with screen.run_test(size=(200, 40)):
            await screen.renew()
            rows = screen.query_one(DataTable).row_count
            bob.kill()
            bob.wait()
            for _ in range(round(LONG)):
                await screen.renew()
                if "bob" in str(screen.query_one("#wrong", Label).content):
                    break
                await asyncio.sleep(0.1)
            wrong = str(screen.query_one("#wrong", Label).content)
            where = str(screen.query_one("#where", Label).content)
            return rows, where, wrong, len(screen.query_one(RichLog).lines)

    rows, where, wrong, records = asyncio.run(use())
    assert rows == 2
    assert "1 of 2 agents" in where
    assert "bob does not answer" in wrong
    assert records > 0


def test_a_clock_that_is_not_synchronised_is_reported() -> None:
    """(finding O6) Only where there are several machines: dates of one machine agree with each other."""
    with Running() as (team, _):
        status = Control(team).handle({"version": 1, "request": "status"})
    for difference, is_right, reported in ((0, False, False), (5_000_000, True, False), (-7, False, True)):
        status["clocks"] = {"far": {"difference": difference, "uncertainty": 1000}}
        status["process"]["synchronised"] = is_right
        said = [line for line in _process_lines(status) if "is not synchronised" in line]
        assert bool(said) is reported, said


@pytest.mark.parametrize(("returned", "found"), [(0, True), (1, True), (5, False), (-1, None)])
def test_the_system_says_whether_its_clock_is_synchronised(
    monkeypatch: pytest.MonkeyPatch, returned: int, found: bool | None
) -> None:
    if not sys.platform.startswith("linux"):
        pytest.skip("NOT TESTED: only Linux says that")
    library = SimpleNamespace(adjtimex=lambda buffer: returned)
    monkeypatch.setattr("ctypes.CDLL", lambda name: library)
    assert synchronised() is found
