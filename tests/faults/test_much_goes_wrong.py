"""A team in which much goes wrong at once: what raises, hangs or is late is named, and the others go on."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime.activity.context import Context
from aseme_dsl.runtime.team.faults import Crash, Faults, Partition
from tests.cli.support import Here
from tests.faults.changing import version
from tests.runtime.playing import MS, SECOND, check_line, lines_of, make
from tests.support.generated import generate
from tests.support.network import own_name
from tests.support.traces import records_of
from tests.support.waiting import LONG, wait_until

ROOT = Path(__file__).resolve().parents[2]

TEAM = """\
// A team that looks for people after a flood: a leader asks three searchers, who charge when they must.
system Rescue

message Site    { int number  string place }
message Finding { int people }
message Power   { int percent }
message Alarm   { int level }
topic field { state Site  signal Finding queued }
topic body  { state Power persist }
topic base  { signal Alarm }

let low = 30

aip survey {
  participant leader {
    engage   "There are sites that nobody has seen."
    var answers : int = 0
    sends    request Site, cancel Site
    receives agree Site, refuse Site, inform Finding
    process  = Brief . gather . Conclude
    gather   = (Note)*
  }
  participant searcher [1..3] {
    engage   "Is awake."
    sends    agree Site, refuse Site, inform Finding
    receives request Site, cancel Site
    process  = Weigh . (Search | Decline)
  }
  outcome "It is known how many people are at the sites."
  outcome "Time is up."

  control leader {
    enter  Brief    : / send request Site { number = 1, place = "mill" } to searcher
  }
  control gather {
    enter  Note : inform Finding from searcher / answers = 1
    skip   Note : after(2s)
    repeat Note : inform Finding from searcher [answers < 3] / answers = answers + 1
    leave  Note : [answers >= 3]
    leave  Note : after(2s)
  }
  control searcher {
    enter Weigh   : request Site from leader
    enter Search  : [body.state.Power.percent >= low or !has(body.state.Power)]
                    / send agree Site { number = 1, .. } to leader
    enter Decline : else / send refuse Site { number = 1, .. } to leader
    leave Search  : / send inform Finding { people = 2 } to leader
  }
}

srm chief {
  plays survey.leader
  var rounds : int = 0
  liveness {
    chief = command || Watch~ || hear
    hear  = (Listen [> Recover)~
    command = Plan . (leader . Plan)+
  }
  activities {
    Plan     takes 200ms simulated
    Brief    takes 50ms simulated
    Note     takes 10ms simulated
    Conclude takes 100ms simulated
    Watch    every 250ms
    Listen   takes 40ms within 50ms
    Recover  takes 100ms simulated
  }
  control hear {
    enter Recover : error
  }
  control command {
    enter  (leader . Plan) : / rounds = rounds + 1
    repeat (leader . Plan) : [rounds < 5]
    leave  (leader . Plan) : else
  }
}

srm scout {
  plays survey.searcher
  var trips : int = 0
  liveness {
    scout  = (work [> Charge)~
    work   = tour || Sense~
    tour   = Look . Walk . (searcher . Walk)~
  }
  activities {
    Look    takes 100ms simulated
    Walk    takes 150ms simulated
    Weigh   takes 20ms simulated
    Search  takes 300ms simulated
    Decline takes 10ms simulated
    Sense   every 100ms writes body.state.Power
    Charge  takes 500ms writes body.state.Power
  }
  control scout {
    resume work            :
    enter  Charge          : when [body.state.Power.percent < low]
    repeat (work [> Charge) :
  }
}

srm medic {
  plays survey.searcher
  liveness { medic = (Wake . (searcher . Rest)~) || Drill }
  activities {
    Wake    takes 50ms simulated
    Rest    takes 100ms simulated
    Weigh   takes 20ms simulated
    Search  takes 300ms simulated
    Decline takes 10ms simulated
    Drill   takes 1s
  }
}

team Rescue { chief : chief  ann : scout  bob : scout  mia : medic }
"""
"""A deadline in the protocol, an interrupt, a resumed tour, and a battery that is known after a start."""

NEXT = TEAM.replace("let low = 30", "let low = 50").replace("[rounds < 5]", "[rounds < 9]")

ACTIVITIES = {
    "drill": """
from aseme_dsl.runtime import Context


class Drill:
    # Raises, deep in a helper.
    def execute(self, context: Context) -> None:
        _bore(0)


def _bore(depth: int) -> float:
    return 1 / depth
""",
    "listen": """
from aseme_dsl.runtime import Context


class Listen:
    # Is always late.
    def execute(self, context: Context) -> None:
        context.wait(0.08)
""",
    "sense": """
from aseme_dsl.runtime import Context
from battery import LEVELS
from monas.Rescue.messages import Power


class Sense:
    # The battery: each look costs 5 %.
    def execute(self, context: Context) -> None:
        LEVELS[context.agent] = LEVELS.get(context.agent, 100) - 5
        context.publish("body.state.Power", Power(percent=LEVELS[context.agent]))
""",
    "charge": """
from aseme_dsl.runtime import Context
from battery import LEVELS
from monas.Rescue.messages import Power


class Charge:
    def execute(self, context: Context) -> None:
        context.wait(0.5)
        LEVELS[context.agent] = 100
        context.publish("body.state.Power", Power(percent=100))
""",
    "watch": """
import time

from aseme_dsl.runtime import Context


class Watch:
    # Hangs, and does not look whether it was cancelled.
    def execute(self, context: Context) -> None:
        while True:
            time.sleep(0.05)
""",
}


@pytest.fixture
def here(capsys: pytest.CaptureFixture[str]) -> Here:
    """asemec in this process."""
    return Here(capsys)


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    name = own_name("Rescue")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "activities").mkdir()
    (tmp_path / "next").mkdir()
    (tmp_path / "pyproject.toml").write_text(
        '[tool.asemec]\nfiles = ["rescue.aseme"]\noutput = "out"\nactivities = "activities"\n'
    )
    (tmp_path / "rescue.aseme").write_text(TEAM.replace("Rescue", name))
    (tmp_path / "next/rescue.aseme").write_text(NEXT.replace("Rescue", name))
    (tmp_path / "battery.py").write_text("LEVELS: dict[str, int] = {}\n")
    for activity, code in ACTIVITIES.items():
        (tmp_path / f"activities/{activity}.py").write_text(code.lstrip().replace("Rescue", name))
    return tmp_path


def check_told(said: str, trace: list[dict[str, Any]]) -> None:
    """Each fault is named with its place, and the trace is whole."""
    assert "Traceback" not in said
    assert "mia  crash: Drill: ZeroDivisionError: division by zero (drill.py:" in said
    assert "mia (medic) failed: activity Drill of state" in said and "(rescue.aseme:104:" in said
    assert "chief  deadline: Listen is not done within 0.05 s (rescue.aseme:56:" in said
    assert (
        said.count("deadline: Listen") == 3
        and "missed deadlines of Listen of chief (rescue.aseme:56:" in said
    )
    for line in trace:
        check_line(line)
    assert (trace[0]["kind"], trace[-1]["kind"]) == ("header", "finish")


def test_in_virtual_time(project: Path, here: Here) -> None:
    hang = "    def execute(self, context: Context) -> None:\n        while not context.cancelled:\n"
    watch = f"from aseme_dsl.runtime import Context\n\n\nclass Watch:\n{hang}            context.wait(3600)\n"
    (project / "activities/watch.py").write_text(watch)
    first = here("run", ".", "--for", "8s", "--quiet", "--state", "memory")
    assert first.code == 1  # mia has failed
    trace = lines_of(project / "out/trace.jsonl.gz")
    check_told(first.out + first.err, trace)
    assert {line["agent"] for line in trace if line["kind"] == "activity" and line["time"] > 7 * SECOND} == {
        "chief", "ann", "bob"
    }  # fmt: skip
    assert sorted(path.name for path in (project / "memory").iterdir()) == ["ann.json", "bob.json"]
    assert here("trace", "out").code == 0 and here("sniff", "out").code == 0


class Watch:
    """Hangs until it is cancelled."""

    def execute(self, context: Context) -> None:
        while not context.cancelled:
            context.wait(3600)


class Drill:
    """Raises."""

    def execute(self, context: Context) -> None:
        raise RuntimeError("the drill is broken")


class Listen:
    """Is always late."""

    def execute(self, context: Context) -> None:
        context.wait(0.08)


@pytest.mark.parametrize("seed", range(6))
def test_with_lost_messages_and_another_version_in_the_middle(seed: int) -> None:
    made, following = generate(TEAM), generate(NEXT)
    messages = made.messages
    levels: dict[str, int] = {}

    class Sense:
        def execute(self, context: Context) -> None:
            levels[context.agent] = levels.get(context.agent, 100) - 5
            context.publish("body.state.Power", messages.Power(percent=levels[context.agent]))

    class Charge:
        def execute(self, context: Context) -> None:
            context.wait(0.5)
            levels[context.agent] = 100
            context.publish("body.state.Power", messages.Power(percent=100))

    activities = {"Watch": Watch, "Drill": Drill, "Listen": Listen, "Sense": Sense, "Charge": Charge}
    fallen = (Crash("bob", 2 * SECOND, 300 * MS),) if seed % 2 else ()
    cut = (Partition(frozenset({"ann"}), 3 * SECOND, 400 * MS),)
    wrong = Faults(seed, 0.3, 0.1, 30 * MS, fallen, cut)
    runs = []
    for _ in range(2):
        levels.clear()
        team, records = make(made, activities, until=15 * SECOND, faults=wrong)
        team.swap(version(following, activities), at=6 * SECOND, within=5 * SECOND)
        result = team.run()
        assert result.reason == "time"
        for record in records:
            check_line(record)
        runs.append(records)
    failed = {agent.name: agent.failure or "" for agent in result.agents if agent.failure}
    assert set(failed) == {"mia"} and "RuntimeError: the drill is broken" in failed["mia"]
    changed = {
        record.get("agent") for record in records if record["kind"] == "swap" and record["what"] == "done"
    }
    refused = [record for record in records if record["kind"] == "swap" and record["what"] == "refuse"]
    assert {"chief", "ann", "bob"} <= changed or refused
    assert records[-1]["kind"] == "finish"
    after = {r["agent"] for r in records if r["kind"] == "activity" and r["time"] > 14 * SECOND}
    assert {"chief", "ann", "bob"} <= after  # they go on
    assert runs[0] == runs[1]  # a run can be had again


def test_in_real_time_with_a_swap(project: Path, here: Here) -> None:
    process = subprocess.Popen(
        [
            sys.executable,
            "-m",
            "aseme_dsl",
            "run",
            ".",
            "--real",
            "--for",
            "8s",
            "--quiet",
            "--state",
            "memory",
        ],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )
    said: list[str] = []
    reader = threading.Thread(target=lambda: said.extend(process.stdout or ()), daemon=True)
    reader.start()
    try:
        wait_until(
            lambda: here("team", "status", "-o", "out").code == 0 or process.poll() is not None, pause=0.2
        )
        done = here("team", "swap", "next/rescue.aseme", "-o", "out", "--within", "6s")
        assert done.code == 0 or "nothing has changed:" in done.err  # on a slow machine
        assert (
            "did you mean bob?" in here("team", "switch", "bbo", "scout", "-o", "out").err
            or process.poll() is not None
        )
        assert process.wait(LONG) == 1
        reader.join(LONG)
    finally:
        with contextlib.suppress(ProcessLookupError):
            process.kill()
        if process.stdout is not None:
            process.stdout.close()
    text = "".join(said)
    trace = records_of(project / "out/trace.jsonl.gz")
    check_told(text, trace)
    changed = [line for line in trace if line["kind"] == "swap" and line["what"] == "done"]
    assert bool(changed) == (done.code == 0)
    assert "activity Watch of chief has not ended 1 s after it was cancelled" in text
