"""Replay: what a trace holds is enough to make each step again, and a difference is found where it is."""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.play.replay import Difference, NotReplayable, Replay
from aseme_dsl.project.testing.replaying import models_of, replay, replayed_to
from aseme_dsl.runtime.trace import checkpoint, trace_blocks, trace_gzip
from aseme_dsl.runtime.trace.checkpoint import state_of
from aseme_dsl.runtime.trace.packed import unpacked
from aseme_dsl.runtime.trace.records import Record, as_record
from aseme_dsl.runtime.trace.trace_reading import TraceReader
from tests.faults.changing import version
from tests.faults.test_seeded import TALK, faults
from tests.faults.test_swap import NET
from tests.runtime.conversation.test_counting_answers import AUCTION
from tests.runtime.playing import MS, SECOND, check_line, lines_of, make
from tests.support.generated import generate
from tests.support.lanes import kept

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted(path.parent.name for path in (ROOT / "examples").glob("*/pyproject.toml"))

CHANCE = """
system Dice
function even(int n) : bool = "tests.play.test_replay:even"
srm r {
  var n : int = 0
  liveness { r = (Roll . (Left | Right))+ }
  activities { Roll takes 50ms  Left takes 20ms  Right takes 20ms }
  control r {
    enter Left  : [even(n)] weight 2 / n = n + 1
    enter Right : [n >= 0] weight 1 / n = n + 2
    repeat (Roll . (Left | Right)) : [n >= 0]
  }
}
"""

calls = [0]


def even(n: int) -> bool:
    """A function that may be called in the run, and not in the replay."""
    calls[0] += 1
    if n == 6:
        raise ValueError("not 6")
    return n % 2 == 0


def recorded(
    text: str, tmp_path: Path, changes: Any = None, file: str = "trace.jsonl", **options: Any
) -> list[Record]:
    """The records of a run that go into a file."""
    made = generate(text)
    path = tmp_path / file
    team, _ = make(made, version=version(made), trace=path, **options)
    if changes is not None:
        changes(team)
    team.run()
    lines = lines_of(path)
    for line in lines:
        check_line(line)
    return lines


def replayed(lines: list[Record]) -> tuple[int, Difference | None]:
    """How many steps were made again, and the first difference."""
    with ExitStack() as stack:
        again = Replay(lambda sources: models_of(sources, stack))
        for line in lines:
            found = again.line(line)
            if found is not None:
                return again.steps, found
        return again.steps, None


def steps(lines: list[Record]) -> int:
    return sum(line["kind"] == "step" for line in lines)


@pytest.fixture(autouse=True)
def often(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(checkpoint, "EVERY", 200)
    monkeypatch.setattr(checkpoint, "SHARE", 1)


@pytest.mark.parametrize("seed", range(int(os.environ.get("REPLAY_RUNS", "3"))))
@pytest.mark.parametrize("text", [TALK, AUCTION.replace("ACTIVITIES", ""), NET])
def test_runs_with_faults(text: str, seed: int, tmp_path: Path) -> None:
    chance = random.Random(f"replay {seed}")
    names = [name for name, _ in generate(text).package.TEAM]
    lines = recorded(text, tmp_path, until=2 * SECOND, faults=faults(chance, names))
    assert replayed(lines) == (steps(lines), None)


@pytest.mark.parametrize("name", kept(EXAMPLES, lambda name: name in ("auction", "cell", "patrol")))
def test_examples(name: str, tmp_path: Path) -> None:
    trace, seconds = tmp_path / "trace.jsonl.gz", os.environ.get("REPLAY_SECONDS", "5")
    words = ["run", f"{ROOT}/examples/{name}", "-o", f"{tmp_path}/out", "--trace", f"{trace}"]
    words += ["--for", f"{seconds}s", "--quiet", "--allow", "waiting"]
    subprocess.run([sys.executable, "-m", "aseme_dsl", *words], check=True)
    found = replay(trace)
    assert (found.difference, found.problem) == (None, None)
    assert found.steps == steps(lines_of(trace)) > 0


def test_a_swap_while_inputs_wait(tmp_path: Path) -> None:
    text = """
        system Walker
        message Seen { int n }
        topic eyes { signal Seen queued }
        srm robot {
          liveness { robot = LOOP+ }
          activities { Walk takes 70ms }
          control robot { leave LOOP : [eyes.signal.Seen.n > 900]  repeat LOOP : else }
        }
    """
    new = version(text.replace("LOOP", "(Look . Walk)").replace("Walk takes", "Look takes 20ms  Walk takes"))
    script = [
        {"at": f"{at}ms", "channel": "eyes.signal.Seen", "message": {"n": at}} for at in range(0, 600, 7)
    ]

    def change(team: Any) -> None:
        team.swap(new, at=210 * MS)

    lines = recorded(text.replace("LOOP", "Walk"), tmp_path, change, script=script, until=SECOND)
    assert any(line["kind"] == "swap" and line["what"] == "done" for line in lines)
    assert any(line["kind"] == "checkpoint" and line.get("anew") for line in lines)
    assert replayed(lines) == (steps(lines), None)


def test_a_message_that_comes_though_no_condition_reads_it(tmp_path: Path) -> None:
    text = """
        system Own
        message Note { int n }
        topic t { signal Note }
        srm r {
          var n : int = 0
          liveness { r = A }
          activities { A takes 50ms }
          control r {
            enter A : / write_messages.t.signal.Note
            leave A : when [n > 9] / t.signal.Note.n = 3
          }
        }
    """
    lines = recorded(text, tmp_path, until=SECOND)
    assert any(line["kind"] == "step" and line["inputs"] == [["me", 1]] for line in lines)
    assert replayed(lines) == (steps(lines), None)


def test_functions_are_not_called_and_chance_is_the_same(tmp_path: Path) -> None:
    lines = recorded(CHANCE, tmp_path, until=SECOND)
    before = calls[0]
    assert replayed(lines) == (steps(lines), None)
    assert calls[0] == before > 0


@pytest.mark.parametrize("file", ["trace.jsonl.gz", "trace.jsonl"])
@pytest.mark.parametrize("text", [TALK, AUCTION.replace("ACTIVITIES", ""), NET])
def test_a_replay_from_near_a_moment_is_the_same(
    text: str, file: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(checkpoint, "EVERY", 2000)
    monkeypatch.setattr(trace_blocks, "BLOCK", 1500)
    monkeypatch.setattr(trace_gzip, "BLOCK", 1500)
    chance = random.Random("near")
    names = [name for name, _ in generate(text).package.TEAM]
    lines = recorded(text, tmp_path, file=file, until=2 * SECOND, faults=faults(chance, names))
    reader = TraceReader(tmp_path / file)
    begins, shorter = set(), 0
    with ExitStack() as stack:
        models = {"": models_of(unpacked(lines[0]["sources"]), stack)}
        for moment in range(0, 2 * SECOND, 130 * MS):
            begins.add([line.number for line, _ in zip(reader.since(moment), range(2), strict=False)][-1])
            near, difference = replayed_to(reader, moment, lambda _: models[""])
            assert difference is None
            whole = Replay(lambda _: models[""])
            for line in lines:
                if line["time"] <= moment:
                    assert whole.line(line) is None
            shorter += near.steps < whole.steps
            for name, agent in whole.agents.items():
                here, there = near.agents[name].chart.save(), agent.chart.save()
                assert state_of(here, shared=False) == state_of(there, shared=False), (moment, name)
    assert len(begins) > 3 and shorter > 10  # it does begin in the middle


def changed(lines: list[Record], kind: str, number: int, **members: Any) -> list[Record]:
    """The lines with other members in one of a kind."""
    found = [place for place, line in enumerate(lines) if line["kind"] == kind][number]
    other = as_record({**json.loads(json.dumps(lines[found])), **members})
    return [*lines[:found], other, *lines[found + 1 :]]


def test_a_difference_is_found_where_it_is(tmp_path: Path) -> None:
    text = "system S  srm r { liveness { r = A . B . C }  activities { A takes 1s B takes 1s C takes 1s } }"
    lines = recorded(text, tmp_path)
    way = [{"transitions": [1], "source": "0.2", "target": "0.3", "text": ""}]
    number, found = replayed(changed(lines, "step", 2, taken=way))
    assert found is not None
    assert (number, found.agent, found.step, found.time, found.what) == (
        3,
        "me",
        3,
        2 * SECOND,
        "transitions",
    )
    assert found.expected == ("A -> B (test.aseme:1:38)",)
    assert found.got == ("B -> C (test.aseme:1:42)",)
    _, found = replayed(changed(lines, "checkpoint", 0, state=lines_with_other_time(lines)))
    assert found is not None
    assert found.what == "the state at a checkpoint"
    assert found.expected == ("values: 7",)


def lines_with_other_time(lines: list[Record]) -> list[Any]:
    state: Any = json.loads(json.dumps(next(line["state"] for line in lines if line["kind"] == "checkpoint")))
    state[1][0] = 7
    return state


def test_what_cannot_be_replayed_says_why(tmp_path: Path) -> None:
    lines = recorded("system S  srm r { liveness { r = A }  activities { A takes 1s } }", tmp_path)
    header = {key: value for key, value in lines[0].items() if key != "sources"}
    with pytest.raises(NotReplayable, match="does not hold the model"):
        replayed([as_record(header), *lines[1:]])
    with pytest.raises(NotReplayable, match="does not have step 1 of me"):
        replayed([line for line in lines if line.get("step") != 1])
    with pytest.raises(NotReplayable, match="does not say what the input"):
        replayed([line for line in lines if line.get("what") != "end"])
    with pytest.raises(NotReplayable, match="cannot be read"):
        replayed(changed(lines, "header", 0, sources="x"))
    with pytest.raises(NotReplayable, match="of a model 123"):
        replayed(changed(lines, "header", 0, agents=[{**lines[0]["agents"][0], "model": "123"}]))  # type: ignore[dict-item]
    with pytest.raises(NotReplayable, match="no agent eve; there are me"):
        replay(tmp_path / "trace.jsonl", ["eve"])
    assert replay(tmp_path / "trace.jsonl", ["me"]).steps == steps(lines)
