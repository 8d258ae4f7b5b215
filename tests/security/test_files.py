"""What somebody can do whose files you open."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.cli.support import GOOD, asemec
from tests.security.lines import line

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
