"""Files that are too deep, or no files at all: an answer, no traceback, and nobody waits."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from aseme_dsl.runtime.channel.persist import Kept

PROGRAM = (
    "system S\nmessage Score { int own }\ntopic game { state Score persist }\n"
    "srm r { liveness { r = A } activities { A takes 1s reads game.state.Score writes game.state.Score } }\n"
    "team t { ann : r }\n"
)
DEEP = "[" * 100_000

FILES = {
    "state": ("states/ann.json", ["run", "s.aseme", "--state", "states"]),
    "input": ("input.jsonl", ["run", "s.aseme", "--input", "input.jsonl"]),
    "trace": ("t.jsonl", ["trace", "t.jsonl"]),
    "model": ("m.aseme", ["check", "m.aseme"]),
    "configuration": ("pyproject.toml", ["check"]),
}


def asemec(folder: Path, arguments: list[str]) -> subprocess.CompletedProcess[str]:
    """In a process of its own: what hangs must not hang the tests."""
    command = [sys.executable, "-m", "aseme_dsl", *arguments]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=60)


@pytest.mark.parametrize("name", FILES)
def test_a_file_that_is_nested_too_deeply_is_told(tmp_path: Path, name: str) -> None:
    (tmp_path / "s.aseme").write_text(PROGRAM, "utf-8")
    file, arguments = FILES[name]
    (tmp_path / file).parent.mkdir(exist_ok=True)
    text = f"a = {DEEP}" if name == "configuration" else DEEP
    (tmp_path / file).write_text(text, "utf-8")
    done = asemec(tmp_path, arguments)
    assert done.returncode in (0, 1, 2), done.stderr
    assert Path(file).name in done.stdout + done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes with a name")
@pytest.mark.parametrize("name", FILES)
def test_nobody_waits_for_a_pipe(tmp_path: Path, name: str) -> None:
    (tmp_path / "s.aseme").write_text(PROGRAM, "utf-8")
    file, arguments = FILES[name]
    (tmp_path / file).parent.mkdir(exist_ok=True)
    os.mkfifo(tmp_path / file)
    done = asemec(tmp_path, arguments)
    assert done.returncode in (0, 1, 2), done.stderr
    assert "Traceback" not in done.stderr
    if name != "configuration":  # a folder's pyproject.toml that is no file is none
        assert Path(file).name in done.stdout + done.stderr


def test_kept_states_that_cannot_be_read_are_a_reason_and_no_error(tmp_path: Path) -> None:
    (tmp_path / "ann.json").write_text(f'{{"states": {DEEP}', "utf-8")
    os.mkfifo(tmp_path / "bob.json")
    kept = Kept(tmp_path)
    for agent, reason in (("ann", "in each other"), ("bob", "not a regular file")):
        found, errors = kept.load(agent, {})
        assert found == []
        assert reason in errors[0]
