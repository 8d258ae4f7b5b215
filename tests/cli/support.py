"""The command line, as tests call it."""

from __future__ import annotations

import io
import json
import os
import subprocess
import sys
from contextlib import chdir, redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from unittest.mock import patch

from aseme_dsl.cli import main

GOOD = """\
system Walker
message Seen { bool ball  bool home }
topic eyes { state Seen }
srm robot {
  liveness { robot = (Walk | Stand)+ }
  activities { Walk takes 1s  Stand takes 1s }
  control robot {
    enter Walk  : [eyes.state.Seen.ball]
    enter Stand : else
    leave  (Walk | Stand) : [eyes.state.Seen.home]
    repeat (Walk | Stand) : else
  }
}
team Walkers { one, two : robot }
"""
"""A small system: it stands until it sees the ball, then walks until it is home."""

BAD = GOOD.replace("eyes.state.Seen.ball]\n    enter Stand", "eyes.state.Sen.ball]\n    enter Stand").replace(
    "Stand : else", "Sit : else"
)
"""The same with two mistakes."""

WARNED = GOOD[: GOOD.index("  control")].replace("(Walk | Stand)+", "Walk . Stand || Walk") + "}\n"
"""A system with a warning (W300)."""


@dataclass(frozen=True)
class Done:
    """How a command ended."""

    code: int
    out: str
    err: str

    @property
    def json(self) -> Any:
        return json.loads(self.out)


def asemec(
    *arguments: object, cwd: Path | None = None, input: bytes | None = None, **environment: str
) -> Done:
    """Start asemec as a process of its own."""
    done = subprocess.run(
        command(*arguments),
        cwd=cwd,
        input=input if input is not None else b"",
        capture_output=True,
        env={**os.environ, **environment},
        timeout=600,
    )
    return Done(done.returncode, done.stdout.decode(), done.stderr.decode())


def asemec_here(*arguments: object, cwd: Path | None = None) -> Done:
    """Call asemec in this process, where nothing captures the streams: it takes half the time."""
    out, err = io.StringIO(), io.StringIO()
    with chdir(cwd or "."), redirect_stdout(out), redirect_stderr(err):
        code = main([str(argument) for argument in arguments])
    return Done(code, out.getvalue(), err.getvalue())


def command(*arguments: object) -> list[str]:
    """The command line of a process of its own."""
    return [sys.executable, "-m", "aseme_dsl", *(str(argument) for argument in arguments)]


def save(path: Path, text: str) -> None:
    """Write a file as many editors do: a new one takes its name, so that nobody ever sees half of it."""
    new = path.with_name(f".{path.name}.new")
    new.write_text(text, "utf-8")
    new.replace(path)


class Here:
    """Calls asemec in this process: far faster, with the same streams and exit codes.

    A process of its own is for what belongs to one: signals, a terminal, its environment.
    """

    def __init__(self, capture: Any) -> None:
        self._capture = capture

    def __call__(self, *arguments: object, input: bytes = b"") -> Done:
        self._capture.readouterr()
        with patch.object(sys, "stdin", io.TextIOWrapper(io.BytesIO(input), "utf-8")):
            code = main([str(argument) for argument in arguments])
        out, err = self._capture.readouterr()
        return Done(code, out, err)
