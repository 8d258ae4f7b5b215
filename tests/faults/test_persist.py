"""What `persist` topics said last is there after a crash, whenever the process was killed."""

from __future__ import annotations

import json
import os
import random
import signal
import time
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime.activity.context import Context
from aseme_dsl.runtime.channel.persist import Kept
from tests.faults.test_operate import Here, here
from tests.runtime.playing import MS, make, play
from tests.support.generated import generate
from tests.support.waiting import LONG, wait_until

__all__ = ["here"]

COUNTING = """\
system Memory
message Count { int n }
topic count { state Count persist }
srm robot {
  liveness { robot = Add~ }
  activities { Add every 2ms reads count.state.Count writes count.state.Count }
}
team Memory { one : robot }
"""

ADD = """\
from monas.Memory.messages import Count


class Add:
    def execute(self, context):
        count = context.latest_message("count.state.Count")
        context.publish("count.state.Count", Count((count.n if count else 0) + 1))
"""


def kept(path: Path) -> int:
    """The count in the file of kept states, 0 if there is none yet."""
    if not path.exists():
        return 0
    (state,) = json.loads(path.read_text("utf-8"))["states"]
    return int(state["message"]["n"])


def test_kill_at_any_moment(here: Here) -> None:
    here.write("memory.aseme", COUNTING)
    (here.folder / "activities").mkdir()
    here.write("activities/add.py", ADD)
    path = here.folder / "kept" / "one.json"
    chance = random.Random(1)
    before = 0
    for life in range(5):
        process = here.start(
            "memory.aseme",
            *("-o", "out", "--state", "kept", "--activities", "activities", "--trace", f"{life}.jsonl"),
        )
        wait_until(lambda before=before: kept(path) > before)
        time.sleep(chance.random() * 0.6)
        process.send_signal(signal.SIGKILL)
        process.wait()
        now = kept(path)  # it can be read, whenever that was
        assert now > before
        before = now
    process = here.start(
        "memory.aseme",
        *("-o", "out", "--state", "kept", "--activities", "activities", "--trace", "last.jsonl"),
        *("--for", "1s"),
    )
    assert process.wait(LONG) == 0
    lines = [json.loads(line) for line in (here.folder / "last.jsonl").read_text("utf-8").splitlines()]
    restored = next(line for line in lines if line["kind"] == "message")
    assert (restored["via"], restored["message"]["n"]) == ("kept", before)


def test_a_state_is_kept_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("aseme_dsl.runtime.driver.real.LOOK", 600.0)  # the main thread does nothing meanwhile
    file = tmp_path / "kept" / "one.json"
    made = generate(COUNTING.replace("Add~", "Add").replace("every 2ms ", ""))
    found: list[int] = []

    class Add:
        def execute(self, context: Context) -> None:
            context.publish("count.state.Count", made.message("Count", n=7))
            wait_until(lambda: kept(file))
            found.append(kept(file))

    team, _ = make(made, {"Add": Add}, clock="real", state_directory=file.parent)
    assert team.run().reason == "finished"
    assert found == [7]


def test_the_writer_coalesces_and_ends(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made = generate(COUNTING)
    states, told, files = Kept(tmp_path), list[str](), list[int]()
    sync = os.fsync

    def slow(number: int) -> None:
        files.append(number)
        time.sleep(0.02)
        sync(number)

    monkeypatch.setattr("os.fsync", slow)
    states.begin(lambda agent, reason: told.append(reason))
    for number in range(1000):
        states.put("one", "count.state.Count", None, made.message("Count", n=number))
    wait_until(lambda: kept(tmp_path / "one.json") == 999)
    states.end(20)
    assert not told and len(files) < 200  # not each by itself


def test_where_nothing_can_be_kept_the_run_goes_on(tmp_path: Path) -> None:
    class Add:
        def execute(self, context: Context) -> None:
            count = context.latest_message("count.state.Count")
            kind = type(count) if count is not None else None
            if kind is not None:
                context.publish("count.state.Count", kind(count.n + 1))

    state = tmp_path / "kept"
    state.write_text("a file is no folder", "utf-8")
    script = [{"at": "1ms", "channel": "count.state.Count", "message": {"n": 1}}]
    options: dict[str, Any] = {"until": 100 * MS, "script": script, "state_directory": state}
    run = play(COUNTING, {"Add": Add}, **options)
    read, written = [fault["reason"] for fault in run.of("fault")]
    assert "cannot be read" in read
    assert "its states are not kept" in written
    assert run.result.reason == "time"
    assert run.of("message")[-1]["message"]["n"] > 10


def test_a_full_disk_is_told_once_and_what_was_kept_stays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = generate(COUNTING)
    states = Kept(tmp_path)
    states.put("one", "count.state.Count", None, made.message("Count", n=1))
    assert states.save() == []

    def full(number: int) -> None:
        raise OSError(28, "No space left on device")

    sync = os.fsync
    monkeypatch.setattr("os.fsync", full)
    states.put("one", "count.state.Count", None, made.message("Count", n=2))
    told = [reason for _ in range(3) for _, reason in states.save()]
    assert told == [f"its states are not kept in {tmp_path / 'one.json'}: No space left on device"]
    assert kept(tmp_path / "one.json") == 1
    monkeypatch.setattr("os.fsync", sync)
    assert states.save() == []
    assert kept(tmp_path / "one.json") == 2


def test_what_could_not_be_written_is_tried_again_without_anything_new(tmp_path: Path) -> None:
    from aseme_dsl.runtime.channel.persist import Kept
    from tests.support.generated import generate

    folder = tmp_path / "kept"
    told: list[str] = []
    folder.write_text("a file is no folder", "utf-8")
    states = Kept(folder)
    states.begin(lambda agent, reason: told.append(reason))
    try:
        states.put("one", "count.state.Count", None, generate(COUNTING).message("Count", n=7))
        wait_until(lambda: told)
        folder.unlink()
        wait_until(lambda: kept(folder / "one.json") == 7)
    finally:
        states.end(5.0)
    assert len(told) == 1
