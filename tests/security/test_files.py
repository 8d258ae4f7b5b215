"""What somebody can do whose files you open."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from tests.cli.support import GOOD, asemec, command
from tests.security.lines import line
from tests.support.terminal import shown

CALLS = GOOD.replace("srm robot", 'function f(bool a) : bool = "evil:f"\nsrm robot').replace(
    "[eyes.state.Seen.ball]", "[f(eyes.state.Seen.ball)]"
)
KEEPS = GOOD.replace("state Seen }", "state Seen persist }")


@line("the author of a `.aseme` file", "run code when the file is checked, formatted or built")
def test_no_module_that_a_text_names_is_imported(tmp_path: Path) -> None:
    (tmp_path / "w.aseme").write_text(CALLS)
    (tmp_path / "evil.py").write_text("open('ran', 'w').close()\ndef f(a): return a\n")
    assert asemec("check", "w.aseme", cwd=tmp_path).code == 0
    assert asemec("fmt", "w.aseme", cwd=tmp_path).code == 0
    assert asemec("build", "w.aseme", "-o", "out", cwd=tmp_path).code == 0
    assert not (tmp_path / "ran").exists()


@line("the author of a trace or state file", "run code, or hold up the reader, when the file is opened")
@pytest.mark.parametrize("kind", ["trace", "state"])
@pytest.mark.parametrize("how", ["deep", "pipe", "pickle"])
def test_a_recorded_file_is_only_read(tmp_path: Path, kind: str, how: str) -> None:
    (tmp_path / "w.aseme").write_text(KEEPS)
    file = tmp_path / "states" / "one.json" if kind == "state" else tmp_path / "t.jsonl"
    file.parent.mkdir(exist_ok=True)
    if how == "pipe":
        os.mkfifo(file)
    else:
        file.write_bytes(b"[" * 100_000 if how == "deep" else b"cos\nsystem\n(S'touch ran'\ntR.")
    opening = ("trace", "t.jsonl") if kind == "trace" else ("run", "w.aseme", "--state", "states", "-q")
    done = asemec(*opening, cwd=tmp_path)
    assert done.code in (0, 1, 2) and "Traceback" not in done.err, done.err
    assert file.name in done.out + done.err
    assert not (tmp_path / "ran").exists()


@line("the author of a trace or state file", "order your terminal to do something when the trace is shown")
@pytest.mark.parametrize("how", [("trace",), ("trace", "--lines")])
def test_a_trace_gives_a_terminal_no_orders(tmp_path: Path, how: tuple[str, ...]) -> None:
    (tmp_path / "w.aseme").write_text(GOOD)
    assert asemec("run", "w.aseme", "-o", "out", "-q", "--trace", "t.jsonl", cwd=tmp_path).code in (0, 1)
    lines = (tmp_path / "t.jsonl").read_text().splitlines()
    agent = json.loads(lines[1])["agent"]
    text = "\x1b]0;title\x07\x1b[2J\x1b[1;1H\x9b6n\x08 harmless"
    told = [
        {"kind": "log", "time": 0, "agent": agent, "activity": text, "label": "0", "text": text},
        {"kind": "fault", "time": 0, "agent": agent, "reason": text},
    ]
    lines[1:1] = [json.dumps(item) for item in told]
    (tmp_path / "t.jsonl").write_text("\n".join(lines) + "\n")
    seen = shown([*command(*how), "t.jsonl"], cwd=tmp_path)
    assert "harmless" in seen
    assert not {*"\x07\x08\x9b"} & {*seen} and "\x1b]" not in seen and "\x1b[2J" not in seen
