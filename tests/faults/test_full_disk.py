"""A disk that is really full, under the states that are kept and under the trace: the run goes on."""

from __future__ import annotations

import json
import signal
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.faults.test_operate import Here, here
from tests.faults.test_persist import ADD, COUNTING, kept
from tests.support.waiting import LONG, wait_until

__all__ = ["here"]


@pytest.fixture
def disk(tmp_path: Path, here: Here) -> Iterator[Path]:
    """A file system of 64 kB; what runs there has ended before it goes."""
    place = tmp_path / "disk"
    place.mkdir()
    command = ["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", str(place)]
    try:
        made = subprocess.run(command, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        pytest.skip("NOT TRIED, a full disk: there is no `mount` here")
    if made.returncode != 0:
        pytest.skip(f"NOT TRIED, a full disk: only root can mount one ({made.stderr.strip()})")
    yield place
    for process in here.running:
        process.kill()
        process.wait()
    subprocess.run(["umount", str(place)], check=True)


def fill(path: Path) -> None:
    """Write until nothing more goes in."""
    with pytest.raises(OSError, match="No space left"), path.open("ab", buffering=0) as file:
        while True:
            file.write(bytes(1024))


def start(here: Here, *arguments: str) -> None:
    here.write("memory.aseme", COUNTING)
    (here.folder / "activities").mkdir()
    here.write("activities/add.py", ADD)
    here.start("memory.aseme", "-o", "out", "--activities", "activities", *arguments)


def told(trace: Path) -> list[str]:
    """Why states were not kept, by the whole lines of a trace that is being written."""
    lines = trace.read_text("utf-8").splitlines(keepends=True) if trace.exists() else []
    records = [json.loads(line) for line in lines if line.endswith("\n")]
    return [
        line["reason"] for line in records if line["kind"] == "fault" and "are not kept" in line["reason"]
    ]


def test_under_the_kept_states(here: Here, disk: Path) -> None:
    states, trace = disk / "one.json", here.folder / "run.jsonl.part"
    start(here, "--state", "disk", "--trace", "run.jsonl")
    wait_until(lambda: kept(states) > 0)

    def is_full() -> list[str]:
        fill(disk / "other")  # again: the last attempt to write may have left some room
        return told(trace)

    assert "No space left on device" in wait_until(is_full)[0]

    def stands_still() -> tuple[int, int] | None:
        """The count and the number of reasons, if neither changes for a while."""
        fill(disk / "other")
        before = kept(states), len(told(trace))
        time.sleep(0.6)
        return before if (kept(states), len(told(trace))) == before else None

    # The last that could be kept, whole; and the reason is not repeated.
    before, _ = wait_until(stands_still)
    assert before > 0
    assert here.running[0].poll() is None
    (disk / "other").unlink()
    wait_until(lambda: kept(states) > before)


def test_under_the_trace(here: Here, disk: Path) -> None:
    start(here, "--state", "kept", "--trace", "disk/run.jsonl")
    (process,) = here.running
    trace, states = disk / "run.jsonl.part", here.folder / "kept" / "one.json"

    def lines() -> list[str]:
        return trace.read_text("utf-8", "replace").splitlines(keepends=True) if trace.exists() else []

    def written() -> int:
        return sum(1 for line in lines() if '"count.state.Count"' in line)

    # The run goes on when no more can be written: for much longer than a line takes to be written.
    wait_until(lambda: kept(states) > written() + 200 > 200, pause=0.05)
    process.send_signal(signal.SIGINT)
    said, _ = process.communicate(timeout=LONG)
    assert "No space left on device" in said
    assert len(lines()) > 10
    assert all(json.loads(line) for line in lines() if line.endswith("\n"))
