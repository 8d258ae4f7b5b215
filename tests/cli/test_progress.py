"""Progress of long work: one line, on a terminal alone; and lines of the source as wide as that."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from importlib.util import find_spec
from pathlib import Path

import pytest

from tests.cli.support import GOOD, command
from tests.support.terminal import shown as terminal

AT_A_TERMINAL = {**os.environ, "TERM": "xterm", "CI": ""}
WORK = {
    "diagram": (("--format", "dot", "-o", "drawn"), "drawing 1 of 2: srm.robot"),
    "optimise": (("--measure", "Walk", "--runs", "2", "--quicker", "1", "--for", "1s"), "2 of 2 runs"),
    "build": ((), "Walker: drawing: 0 of 4"),
    "run": (("--for", "1s", "--allow", "waiting"), "Walker: drawing: 0 of 4"),
}


@pytest.mark.parametrize("name", WORK)
def test_on_a_terminal_a_line_says_how_far_it_is(folder: Path, name: str) -> None:
    arguments, line = WORK[name]
    said = terminal(command(name, "good.aseme", *arguments), AT_A_TERMINAL)
    assert f"\r\x1b[K{line}" in said
    assert re.search(r"\r\x1b\[K(?!.*(?:drawing|of \d+ runs))", said, re.DOTALL), said  # it is taken away


SERVICE, DUMB = {"CI": "true", "TERM": "xterm"}, {"CI": "", "TERM": "dumb"}


@pytest.mark.parametrize(("name", "where"), [*((name, SERVICE) for name in WORK), ("diagram", DUMB)])
def test_in_the_log_of_a_service_there_is_no_such_line(
    folder: Path, name: str, where: dict[str, str]
) -> None:
    said = terminal(command(name, "good.aseme", *WORK[name][0]), {**os.environ, **where})
    assert "\r\x1b" not in said and "drawing" not in said and " runs\r" not in said


@pytest.mark.parametrize("name", WORK)
def test_a_pipe_gets_no_such_line(folder: Path, name: str) -> None:
    done = subprocess.run(
        command(name, "good.aseme", *WORK[name][0]),
        capture_output=True,
        text=True,
        env=AT_A_TERMINAL,
        timeout=600,
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    assert "\r" not in done.stdout


@pytest.mark.long
def test_native_builds_say_how_many_modules_are_compiled(folder: Path) -> None:
    if find_spec("mypyc") is None or find_spec("setuptools") is None:
        pytest.skip("NOT TRIED, for the extra `native` is not installed")
    if shutil.which("cc") is None:
        pytest.skip("NOT TRIED, for there is no C compiler here: apt install gcc libc6-dev")
    one = GOOD.replace("team Walkers { one, two : robot }", "")
    (folder / "one.aseme").write_text(one)
    said = terminal(
        command("build", "one.aseme", "--backend", "plain", "--native", "--only", "plain"),
        AT_A_TERMINAL,
    )
    assert "\r\x1b[KWalker: compiling to machine code: 0 of 1" in said
    assert "\r\x1b[KWalker: compiling to machine code: 1 of 1\r\x1b[K" in said


LONG = GOOD.replace(
    "    enter Stand : else\n",
    "    enter Stand : [" + " || ".join(["eyes.state.Seen.ball"] * 9) + " || eyes.state.Sen.ball]\n",
)


@pytest.mark.parametrize("columns", [30, 60, 80, 200])
def test_lines_of_the_source_are_as_wide_as_the_terminal(folder: Path, columns: int) -> None:
    """The underlined place is always in view."""
    (folder / "long.aseme").write_text(LONG)
    said = terminal(command("check", "long.aseme", "--color", "never"), AT_A_TERMINAL, columns=columns)
    shown = [line for line in said.splitlines() if re.match(r" *\d* \| ", line)]
    assert shown and all(len(line) <= columns for line in shown), said
    text, underline = shown[:2]
    place = underline.index("^"), underline.rindex("^") + 1
    assert text[slice(*place)] in ("eyes.state.Sen", "Sen", "Sen.ball", "eyes.state.Sen.ball"), said
