"""What the trace tells of signals that expire, in virtual and in real time, in regions and in activities."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.runtime import Context, activities_in
from tests.runtime.playing import SECOND, Played, play
from tests.support.generated import generate

TEXT = """
system S
message M { int n }
topic t { signal M expires 100ms }
srm Speaker { liveness { Speaker = Say } activities { Say writes t.signal.M } }
srm Listener { liveness { Listener = Hear } activities { Hear takes 1s reads t.signal.M } }
team T { ann : Speaker  bob : Listener }
"""


def play_late(clock: str, kind_of: str = "thread") -> Played:
    """A signal at 0 ms and one at 250 ms, for an activity that looks at 200 ms and at 300 ms."""
    generated = generate(TEXT)

    class Say:
        def execute(self, context: Context) -> None:
            context.publish("t.signal.M", generated.message("M", n=1))
            context.wait(0.25)
            context.publish("t.signal.M", generated.message("M", n=2))

    class Hear:
        kind = kind_of

        def execute(self, context: Context) -> None:
            for pause in (0.2, 0.1):
                context.wait(pause)
                signal = context.consume("t.signal.M")
                context.log("none" if signal is None else str(signal.n))

    return play(generated, {"Say": Say, "Hear": Hear}, clock=clock, until=60 * SECOND)


@pytest.mark.parametrize("clock", ["virtual", "real"])
def test_the_trace_tells_of_a_signal_that_an_activity_came_too_late_for(clock: str) -> None:
    run = play_late(clock)
    assert [record["text"] for record in run.of("log")] == ["none", "2"]
    [record] = run.of("expired")
    assert (record["agent"], record["region"], record["channel"]) == ("bob", "0", "t.signal.M")
    first, _ = (item for item in run.of("message") if item.get("channel") == "t.signal.M")
    assert record["input"] == [first["agent"], first["sequence"]]
    assert record["time"] - first["time"] >= SECOND // 10


def test_it_tells_of_one_that_a_step_drops() -> None:
    text = """
        system S
        message M { int n }
        topic t { signal M expires 100ms }
        srm R { liveness { R = A . B } activities { A takes 1s  B takes 1s }
                control R { enter B : [has(t.signal.M)] } }
        team T { ann : R }
    """
    run = play(
        text,
        script=[
            {"at": "100ms", "channel": "t.signal.M", "message": {"n": 1}},
            {"at": "1500ms", "channel": "t.signal.M", "message": {"n": 2}},
        ],
    )
    [record] = run.of("expired")
    assert (record["time"], record["region"]) == (SECOND, "0")


HEAR = """
class Hear:
    kind = "process"
    def execute(self, context):
        context.log(str(context.latest_message("t.signal.M") is not None))
        context.wait(0.2)
        context.log(str(context.consume("t.signal.M")))
"""


def test_an_activity_in_a_process_of_its_own_is_not_given_one(tmp_path: Path) -> None:
    text = """
        system S
        message M { int n }
        topic t { signal M expires 200ms }
        srm R { liveness { R = A . Hear } activities { A takes 100ms  Hear reads t.signal.M } }
        team T { ann : R }
    """
    script = [{"at": "50ms", "channel": "t.signal.M", "message": {"n": 1}}]
    (tmp_path / "hear.py").write_text(HEAR)
    run = play(text, activities_in(tmp_path), script=script, path=[tmp_path])
    assert [record["text"] for record in run.of("log")] == ["True", "None"]
    assert [record["region"] for record in run.of("expired")] == ["0"]
