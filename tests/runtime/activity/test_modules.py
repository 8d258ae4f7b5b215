"""Modules: what runs every so often beside the statechart, on both clocks and in four kinds."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime import Context, activities_in
from aseme_dsl.runtime.driver.real_time import RealTime
from aseme_dsl.runtime.team.team import TeamError
from tests.faults.changing import version
from tests.faults.test_activities import folder
from tests.runtime.playing import MS, Played, make, play
from tests.support.generated import generate

TEXT = """
system S
message Ball { int n }
topic vision { state Ball }
srm R {
  liveness { R = Search . Found }
  activities { Found takes 0ms }
  modules { Vision every 20ms  writes vision.state.Ball }
  control R { enter Found : when [vision.state.Ball.n == 4] }
}
"""
VISION = {
    "thread": """
        from {package}.messages import Ball
        class Vision:
            def __init__(self):
                self.seen = 0
            def execute(self, context):
                self.seen += 1
                context.publish("vision.state.Ball", Ball(self.seen))
        """,
    "async": """
        from {package}.messages import Ball
        class Vision:
            seen = 0
            async def execute(self, context):
                await context.sleep(0.001)
                self.seen += 1
                context.publish("vision.state.Ball", Ball(self.seen))
        """,
    "process": """
        from {package}.messages import Ball
        class Vision:
            kind = "process"
            seen = 0
            def execute(self, context):
                self.seen += 1
                context.publish("vision.state.Ball", Ball(self.seen))
        """,
    "step": """
        from {package}.messages import Ball
        class Vision:
            def execute(self, context):
                seen = 0
                while True:
                    seen += 1
                    context.publish("vision.state.Ball", Ball(seen))
                    yield
        """,
}


def events(run: Played, *what: str) -> list[str]:
    return [
        f"{record['time'] / MS:g} {record['what']}"
        for record in run.of("module")
        if not what or record["what"] in what
    ]


@pytest.mark.parametrize("clock", ["virtual", "real"])
@pytest.mark.parametrize("kind", VISION)
def test_a_module_runs_beside_the_chart_and_keeps_its_object(kind: str, clock: str, tmp_path: Path) -> None:
    generated = generate(TEXT)
    vision = VISION[kind].replace("{package}", generated.package.__name__)
    find = activities_in(folder(tmp_path, vision=vision))
    run = play(generated, find, clock=clock, path=[tmp_path], until=60_000 * MS)
    assert run.result.reason == "finished"
    assert [record["message"]["n"] for record in run.of("message")][:4] == [1, 2, 3, 4]
    assert {record["activity"] for record in run.of("message")} == {"Vision"}
    begin, *_, end = run.of("module")
    assert (begin["what"], begin["every"], end["what"]) == ("begin", 20 * MS, "end")
    assert end["beats"] >= 4
    if clock == "virtual":
        times = [record["time"] for record in run.of("message")]
        slept = MS if kind == "async" else 0
        assert times[:4] == [slept, 20 * MS + slept, 40 * MS + slept, 60 * MS + slept]
        assert end["time"] == run.result.end_ns


BESIDE = """
system S
srm R { liveness { R = Play } activities { Play takes 1s } modules { Work every 30ms CLAUSES } }
"""


def test_a_beat_that_comes_too_soon_is_missed_and_never_made_up_for() -> None:
    beats: list[int] = []

    class Work:
        def execute(self, context: Context) -> None:
            beats.append(context.now_ns // MS)
            context.wait(0.1 if len(beats) == 2 else 0)

    run = play(BESIDE.replace("CLAUSES", ""), {"Work": Work}, until=250 * MS)
    assert beats == [0, 30, 150, 180, 210, 240]
    assert [(r["time"] // MS, r["beats"]) for r in run.of("module", what="missed")] == [(150, 3)]


def test_a_module_that_raises_begins_anew_and_pauses_longer_each_time() -> None:
    beats: list[tuple[int, int]] = []

    class Work:
        def __init__(self) -> None:
            self.number = 0

        def execute(self, context: Context) -> None:
            self.number += 1
            beats.append((context.now_ns // MS, self.number))
            if 60 <= context.now_ns // MS < 400:
                raise ValueError("no camera")

    run = play(BESIDE.replace("CLAUSES", ""), {"Work": Work}, until=600 * MS)
    assert beats[:2] == [(0, 1), (30, 2)]
    failed = [moment for moment, _ in beats if 60 <= moment < 400]
    assert failed == [60, 90, 120, 210]
    assert beats[-3:] == [(540, 5), (570, 6), (600, 7)]
    crashes = run.of("module", what="crash")
    assert crashes[0]["reason"] == "ValueError: no camera"
    assert [record.get("pause", 0) // MS for record in crashes] == [0, 30, 90, 210]
    assert run.result.reason == "time" and not run.result.failed


def test_takes_is_how_long_a_beat_lasts_in_virtual_time() -> None:
    text = """
    system S
    message M { int n }
    topic t { state M }
    srm R { liveness { R = Play } activities { Play takes 100ms }
      modules { Work every 30ms takes 10ms writes t.state.M } }
    """
    generated = generate(text)

    class Work:
        def execute(self, context: Context) -> None:
            context.publish("t.state.M", generated.message("M", n=1))

    run = play(generated, {"Work": Work})
    assert [record["time"] // MS for record in run.of("message")] == [10, 40, 70, 100]


def test_a_beat_that_does_not_return_is_reported() -> None:
    class Work:
        def execute(self, context: Context) -> None:
            context.wait(1000)

    run = play(BESIDE.replace("CLAUSES", "").replace("1s", "5s"), {"Work": Work})
    (fault,) = run.of("fault")
    assert fault["reason"] == "module Work has not returned for 2 s: it misses its releases"
    assert run.result.reason == "finished"


def test_a_module_without_code_does_not_run_and_says_so() -> None:
    class Work:
        def execute(self, context: Context) -> None:
            """Called once each period."""

    for classes in ({}, {"Work": Work}):
        run = play(BESIDE.replace("CLAUSES", ""), classes)
        assert [fault["reason"] for fault in run.of("fault")] == ["module Work has no code: it does not run"]
        assert not run.of("module")


def test_code_is_found_where_the_document_says(tmp_path: Path) -> None:
    folder(
        tmp_path, legs_of_mine="class Legs:\n    def execute(self, context):\n        context.log('here')\n"
    )
    text = BESIDE.replace("CLAUSES", '= "legs_of_mine:Legs"')
    run = play(text, path=[tmp_path], until=10 * MS)
    assert run.of("log")[0]["activity"] == "Work"
    with pytest.raises(TeamError, match=r"module Work: legs_of_mine:Arms cannot be imported"):
        play(text.replace(":Legs", ":Arms"), path=[tmp_path], until=10 * MS)


def test_what_document_and_class_say_must_agree() -> None:
    class Work:
        kind = "process"

        def execute(self, context: Context) -> None:
            context.log("x")

    class Play:
        def execute(self, context: Context) -> Iterator[float]:
            yield 0.1

    with pytest.raises(
        TeamError, match="Work runs as 'process' by its class, and as 'async' by the document"
    ):
        play(BESIDE.replace("CLAUSES", "as async"), {"Work": Work})
    text = "system S srm R { liveness { R = Play } activities { Play as process } }"
    with pytest.raises(TeamError, match="Play runs as 'step' by its class, and as 'process' by the document"):
        play(text, {"Play": Play})


def test_a_module_that_ignores_its_cancellation_does_not_hold_up_the_end(tmp_path: Path) -> None:
    begun, release = threading.Event(), threading.Event()

    class Work:
        def execute(self, context: Context) -> None:
            begun.set()
            release.wait()

    class Play:
        def execute(self, context: Context) -> None:
            begun.wait()

    text = BESIDE.replace("CLAUSES", "").replace("1s", "50ms")
    activities = {"Work": Work, "Play": Play}
    run = play(text, activities, clock="real", real_time=RealTime(cancel_within=100 * MS))
    release.set()
    assert run.result.reason == "finished"
    assert run.result.left == ("me: Work",)


def test_a_process_module_whose_worker_is_killed_begins_anew(tmp_path: Path) -> None:
    work = """
    import os, signal
    class Work:
        kind = "process"
        beats = 0
        def execute(self, context):
            self.beats += 1
            context.log(f"{os.getpid()} {self.beats}")
            if self.beats == 2:
                os.kill(os.getpid(), signal.SIGKILL)
    """
    logs: list[str] = []

    def log(record: dict[str, Any]) -> None:
        if record["kind"] == "log":
            logs.append(record["text"])

    run = play(
        BESIDE.replace("CLAUSES", "").replace("1s", "60s"),
        activities_in(folder(tmp_path, work=work)),
        clock="real",
        path=[tmp_path],
        listeners=[log],
        stop=lambda team: "enough" if len(logs) >= 3 else None,
        until=60_000 * MS,
    )
    assert run.result.reason == "enough"
    assert [text.split()[1] for text in logs[:3]] == ["1", "2", "1"]
    assert logs[0].split()[0] == logs[1].split()[0] != logs[2].split()[0]
    assert run.of("module", what="crash")[0]["reason"] == "its process was killed by SIGKILL"


def test_a_swap_gives_modules_new_objects_and_the_new_period() -> None:
    text = BESIDE.replace("CLAUSES", "")
    beats: list[tuple[int, int]] = []

    class Work:
        def __init__(self) -> None:
            self.number = 0

        def execute(self, context: Context) -> None:
            self.number += 1
            beats.append((context.now_ns // MS, self.number))

    team, records = make(text, {"Work": Work}, until=200 * MS)
    team.swap(version(text.replace("every 30ms", "every 50ms"), {"Work": Work}), at=100 * MS)
    team.run()
    assert [record["what"] for record in records if record["kind"] == "swap"] == ["done"]
    assert beats == [(0, 1), (30, 2), (60, 3), (90, 4), (100, 1), (150, 2), (200, 3)]
    said = [(r["time"] // MS, r["what"]) for r in records if r["kind"] == "module"]
    assert said == [(0, "begin"), (100, "end"), (100, "begin"), (200, "end")]
