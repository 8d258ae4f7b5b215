"""Traces: the format, what can be followed in it, and what happens when it cannot be written."""

from __future__ import annotations

import signal
import subprocess
import sys
import textwrap
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.trace.trace_schema import schema
from tests.runtime.playing import MS, SECOND, lines_of, play
from tests.support.generated import generate
from tests.support.waiting import LONG

TEXT = """
system S
enum Mood { GOOD BAD }
message M { int n  Mood mood }
topic t { state M  signal M }
srm R {
  var x : int = 0
  liveness { R = (A . B)~ || C~ }
  activities {
    A every 50ms takes 10ms reads t.signal.M writes t.state.M, x
    C takes 30ms
  }
  control R {
    enter B : [t.state.M.mood == Mood.BAD && twice(t.state.M.n) > 2] / t.state.M.n = 0
    repeat (A . B) : when [t.signal.M.n == 3]
  }
}
function twice(int n) : int = "doubling:twice"
team T { ann, bob : R }
"""


def run_of(tmp_path: Path, **options: Any) -> Any:
    (tmp_path / "doubling.py").write_text("def twice(n):\n    return 2 * n\n")
    generated = generate(TEXT)

    class A:
        def execute(self, context: Context) -> None:
            context.publish("t.state.M", generated.message("M", n=context.random.randrange(5), mood=1))
            context.set_variable("x", 1)

    script = [{"at": "100ms", "agent": "bob", "channel": "t.signal.M", "message": {"n": 3, "mood": "BAD"}}]
    return play(generated, {"A": A}, path=[tmp_path], script=script, until=SECOND, **options)


def test_every_line_is_as_the_schema_says(tmp_path: Path) -> None:
    run_of(tmp_path, trace=tmp_path / "run.jsonl")
    validator = Draft202012Validator(schema())
    lines = lines_of(tmp_path / "run.jsonl")
    assert len(lines) > 50
    for line in lines:
        validator.validate(line)
    assert (lines[0]["kind"], lines[-1]["kind"]) == ("header", "finish")
    assert [agent["name"] for agent in lines[0]["agents"]] == ["ann", "bob"]


def test_the_schema_refuses_what_is_no_line() -> None:
    validator = Draft202012Validator(schema())
    assert not validator.is_valid({"kind": "step", "time": 0})
    assert not validator.is_valid({"kind": "log", "time": 0.5, "agent": "a", "activity": "A"})


def test_every_input_has_an_identity_that_one_step_cites(tmp_path: Path) -> None:
    """ "every input with its identity (agent, sequence) and every receipt citing it" """
    run = run_of(tmp_path)
    made = {(r["agent"], r["sequence"]): r for r in run.records if r.get("sequence") and r["kind"] != "step"}
    assert len(made) == sum(1 for r in run.records if r.get("sequence"))  # each identity once
    cited = [(step["agent"], tuple(identity)) for step in run.of("step") for identity in step["inputs"]]
    assert len(cited) == len(set(cited))
    assert all(identity in made for _, identity in cited)
    ends = {identity for identity, r in made.items() if r.get("what") == "end"}
    assert ends <= {identity for _, identity in cited}


def test_a_step_says_which_transitions_it_took_and_what_functions_gave(tmp_path: Path) -> None:
    run = run_of(tmp_path)
    calls = [step for step in run.of("step") if step.get("functions")]
    assert calls[0]["functions"][0]["function"] == "twice(int)"
    taken = [way for step in run.of("step") for way in step["taken"] if "twice" in way["text"]]
    plan = run.team.agents[0].plan
    assert plan.transitions[taken[0]["transitions"][0]].source == taken[0]["source"]


def test_a_trace_has_its_name_only_when_it_is_complete(tmp_path: Path) -> None:
    path = tmp_path / "run.jsonl"
    path.write_text("old")
    seen: list[str] = []

    class A:
        def execute(self, context: Context) -> None:
            seen.append(path.read_text())

    play("system S srm R { liveness { R = A } }", {"A": A}, trace=path)
    assert seen == ["old"]
    assert lines_of(path)[0]["kind"] == "header"
    assert not path.with_name("run.jsonl.part").exists()


def test_any_text_can_be_traced(tmp_path: Path) -> None:
    texts = ['"', "\\", "\n", "ω😀", "\ud800", "\x00"]

    class A:
        def execute(self, context: Context) -> None:
            for text in texts:
                context.log(text)

    path = tmp_path / "run.jsonl"
    assert play("system S srm R { liveness { R = A } }", {"A": A}, trace=path).result.trace_error is None
    assert [line["text"] for line in lines_of(path) if line["kind"] == "log"] == texts


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device that is always full")
def test_a_full_disk_ends_the_trace_and_not_the_run(tmp_path: Path) -> None:
    path = tmp_path / "run.jsonl"
    path.write_text("old")
    (tmp_path / "run.jsonl.part").symlink_to("/dev/full")
    run = run_of(tmp_path, trace=path)
    assert run.result.reason == "time"
    assert "No space left on device" in (run.result.trace_error or "")
    assert path.read_text() == "old"


def test_a_trace_that_cannot_be_begun_is_an_error_before_the_run(tmp_path: Path) -> None:
    with pytest.raises(OSError):
        run_of(tmp_path, trace=tmp_path / "nowhere" / "run.jsonl")


INTERRUPTED = """
import os, signal, sys
from pathlib import Path
sys.path.insert(0, {root!r})
from tests.runtime.playing import make

class A:
    def execute(self, context):
        try:
            context.wait(0.001)
            os.kill(os.getpid(), signal.{signal})
            while True:
                context.wait(1000 if {clock!r} == "real" else 1)
        finally:
            print("told")

team, records = make("system S srm R {{ liveness {{ R = A }} }}", {{"A": A}}, clock={clock!r},
    trace=Path({trace!r}))
result = team.run()
print(result.reason, records[-1]["kind"])
"""


@pytest.mark.parametrize("clock", ["virtual", "real"])
@pytest.mark.parametrize("number", ["SIGINT", "SIGTERM"])
def test_a_signal_ends_a_run_cleanly(clock: str, number: str, tmp_path: Path) -> None:
    """ "Ctrl-C/SIGTERM ends cleanly (trace closed, activities cancelled)" """
    root = str(Path(__file__).parents[3])
    trace = tmp_path / "run.jsonl"
    script = INTERRUPTED.format(root=root, signal=number, clock=clock, trace=str(trace))
    done = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(script)], capture_output=True, text=True, timeout=LONG
    )
    assert done.stderr == ""
    reason = "terminated" if (number, clock) == ("SIGTERM", "real") else "interrupted"
    assert done.stdout.splitlines() == ["told", f"{reason} finish"]
    lines = lines_of(trace)
    assert [line["what"] for line in lines if line["kind"] == "activity"] == ["start", "cancel", "late"]
    assert lines[-1]["reason"] == reason


def test_signals_are_handled_as_before_after_a_run() -> None:
    before = signal.getsignal(signal.SIGINT)
    play("system S srm R { liveness { R = A } }", until=10 * MS)
    assert signal.getsignal(signal.SIGINT) is before
