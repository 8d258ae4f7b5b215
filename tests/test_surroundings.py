"""The results do not depend on how the tests are started."""

from __future__ import annotations

import os
import pty
import signal
import subprocess
import sys
from fnmatch import fnmatch
from pathlib import Path

import pytest

from tests.support.terminal import shown

TESTS = Path(__file__).parent

HOSTILE = {
    "COLUMNS": "31",
    "FORCE_COLOR": "1",
    "LC_ALL": "C",
    "LINES": "7",
    "NO_COLOR": "1",
    "PYTHONDONTWRITEBYTECODE": "1",
    "PYTHONPATH": "/nowhere",
    "PYTHONUTF8": "0",
    "PYTHONWARNINGS": "ignore",
    "TERM": "xterm-256color",
}


def test_the_surroundings_are_known() -> None:
    assert not {name for name in os.environ if name.startswith(("PYTHON", "LC_"))}
    assert not {"COLUMNS", "LINES", "NO_COLOR", "FORCE_COLOR"} & set(os.environ)
    assert (os.environ["LANG"], os.environ["TERM"]) == ("C.UTF-8", "dumb")
    assert Path(os.environ["HOME"]).is_dir()
    mask = os.umask(0)
    os.umask(mask)
    assert mask == 0o022
    assert signal.getsignal(signal.SIGINT) is not signal.SIG_IGN


@pytest.mark.skipif("HOSTILE" in os.environ, reason="it starts the test above")
@pytest.mark.parametrize("workers", ["0", "1"])
def test_however_they_are_started(workers: str) -> None:
    environment = {name: value for name, value in os.environ.items() if name != "HOME"} | HOSTILE
    test = f"{__file__}::test_the_surroundings_are_known"
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-n", workers, test]
    done = subprocess.run(
        # A shell that ignores a signal hands that on.
        ["sh", "-c", 'umask 077; trap "" INT; exec "$0" "$@"', *command],
        env=environment | {"HOSTILE": "1"},
        cwd=Path(__file__).parents[1],
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout
    assert "1 passed" in done.stdout


def test_without_a_terminal_a_test_that_needs_one_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    def none() -> tuple[int, int]:
        raise OSError("out of pty devices")

    monkeypatch.setattr(pty, "openpty", none)
    with pytest.raises(pytest.skip.Exception, match="no pseudo-terminal here: out of pty devices"):
        shown(["true"])


def test_pytest_passes_over_no_folder_of_tests(pytestconfig: pytest.Config) -> None:
    passed_over = pytestconfig.getini("norecursedirs")
    folders = {path.parent for path in TESTS.rglob("test_*.py")}
    inner = {folder.relative_to(TESTS) for folder in folders}
    left_out = [
        folder.as_posix()
        for folder in inner
        if any(fnmatch(part, pattern) for part in folder.parts for pattern in passed_over)
    ]
    assert left_out == []
