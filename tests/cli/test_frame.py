"""What is around the commands: help, exit codes, signals, streams, and that nothing heavy is loaded early."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from array import array
from fcntl import ioctl
from pathlib import Path
from termios import FIONREAD

import pytest

import aseme_dsl
from aseme_dsl.cli import main
from aseme_dsl.cli.program import COMMANDS
from aseme_dsl.cli.team import NAMES as TEAM
from tests.cli.support import GOOD, Here, asemec, command
from tests.support.terminal import shown


def test_version_of_the_module_and_the_script() -> None:
    assert asemec("--version").out == f"asemec {aseme_dsl.__version__}\n"
    script = Path(sys.executable).with_name("asemec")
    done = subprocess.run([script, "-V"], capture_output=True, text=True)
    assert done.stdout == f"asemec {aseme_dsl.__version__}\n"


@pytest.mark.parametrize(
    "arguments", [["--version"], ["--help"], ["check", "--help"], ["completion", "bash"]]
)
def test_nothing_heavy_is_loaded_early(arguments: list[str]) -> None:
    program = f"import sys; from aseme_dsl.cli import main; main({arguments!r}); print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    loaded = {name.partition(".")[0] for name in done.stdout.splitlines()[-1].split()}
    assert not loaded & {"textx", "arpeggio", "jinja2", "graphviz", "networkx", "jsonschema", "google"}


def test_help_names_every_command(here: Here) -> None:
    done = here("--help")
    assert done.code == 0
    for name in COMMANDS:
        assert f"\n  {name} " in done.out


@pytest.mark.parametrize("name", [*COMMANDS, *(f"team {name}" for name in TEAM)])
def test_every_command_has_help_with_an_example(here: Here, name: str) -> None:
    done = here(*name.split(), "--help")
    assert done.code == 0
    assert "Example:" in done.out
    assert f"asemec {name}" in done.out
    assert here(*name.split(), "-h").out == done.out


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["chekc"], "Did you mean 'check'?"),
        (["status"], "`asemec status` is `asemec team status` now"),
        (["swap", "team.aseme"], "`asemec swap` is `asemec team swap` now"),
        (["switch", "a", "b"], "`asemec switch` is `asemec team switch` now"),
        (["select", "a", "b"], "`asemec select` is `asemec team switch` now"),
        (["team", "statsu"], "Did you mean 'status'?"),
        (["team", "status", "--watch"], "--watch needs a terminal"),
        (["team", "stop", "--within", "soon"], "is not a duration"),
        (["team", "logs", "--last", "0"], "--last"),
        (["fly"], "Commands: new, check, explain"),
        (["check", "--nothing"], "No such option"),
        (["import"], "Missing argument"),
        (["run", "x.aseme", "--for", "5 apples"], "is not a duration"),
        (["run", "x.aseme", "--body", "nonsense"], "[AGENT=]MODULE:FUNCTION"),
        (["run", "x.aseme", "--world", "nonsense"], "MODULE:FUNCTION"),
        (["diagram", "x.aseme", "--depth", "0"], "--depth"),
        (["build", "--only", "moddels"], "Did you mean 'models'?"),
        (["build", "--backend", "monnas"], "Did you mean 'monas'?"),
        (["completion", "tcsh"], "tcsh"),
        (["new", "3d"], "cannot name a system"),
    ],
)
def test_wrong_use_is_2(here: Here, arguments: list[str], words: str) -> None:
    done = here(*arguments)
    assert done.code == 2
    assert words in done.err
    assert done.out == ""


def test_our_own_mistakes_show_no_traceback(
    here: Here, monkeypatch: pytest.MonkeyPatch, folder: Path
) -> None:
    def broken(*arguments: object) -> None:
        raise KeyError("the drawer is empty")

    monkeypatch.setattr("aseme_dsl.project.building.project.check", broken)
    done = here("check", "good.aseme")
    assert done.code == 70
    assert "Traceback" not in done.err
    assert "internal error: KeyError: 'the drawer is empty'" in done.err
    assert "asemec --debug check good.aseme" in done.err
    done = here("--debug", "check", "good.aseme")
    assert done.code == 70
    assert "Traceback" in done.err


def test_too_little_memory_is_said(here: Here, monkeypatch: pytest.MonkeyPatch, folder: Path) -> None:
    def greedy(*arguments: object) -> None:
        raise MemoryError

    monkeypatch.setattr("aseme_dsl.project.building.project.check", greedy)
    done = here("check", "good.aseme")
    assert (done.code, done.err) == (1, "asemec: out of memory\n")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_it_with_nothing_half_done(tmp_path: Path, number: signal.Signals) -> None:
    """While more of standard input is awaited."""
    process = subprocess.Popen(
        command("build", "-", "-o", tmp_path / "out"),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdin is not None
    process.stdin.write(GOOD)
    process.stdin.flush()
    unread = array("i", [1])
    while unread[0]:
        assert process.poll() is None
        time.sleep(0.05)
        ioctl(process.stdin, FIONREAD, unread)
    process.send_signal(number)
    out, err = process.communicate(timeout=60)
    assert process.returncode == {signal.SIGINT: 130, signal.SIGTERM: 143}[number]
    assert "Traceback" not in err
    assert out == ""
    assert not (tmp_path / "out").exists()


def test_a_broken_pipe_is_quiet(folder: Path) -> None:
    many = "\n".join(f"enum E{number} {{ }}" for number in range(2000))
    (folder / "many.aseme").write_text(f"system Many\n{many}")
    process = subprocess.Popen(
        command("check", "many.aseme"), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    assert process.stderr is not None
    process.stdout.readline()
    process.stdout.close()
    assert process.stderr.read() == ""
    process.stderr.close()
    assert process.wait(60) == 141


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="this system has no /dev/full")
def test_full_standard_output_is_said(folder: Path) -> None:
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(command("check", "good.aseme"), stdout=full, stderr=subprocess.PIPE, text=True)
    assert done.returncode == 1
    assert "No space left on device" in done.stderr
    assert "Traceback" not in done.stderr


def test_a_narrow_character_set_is_no_problem(folder: Path) -> None:
    (folder / "odd.aseme").write_text("system Ωmega …", "utf-8")
    done = asemec("check", "odd.aseme", PYTHONIOENCODING="ascii")
    assert done.code == 1
    assert "\\u2126" in done.out or "\\u03a9" in done.out


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completion_scripts(here: Here, shell: str) -> None:
    done = here("completion", shell)
    assert done.code == 0
    assert "_ASEMEC_COMPLETE" in done.out


def test_completion_completes() -> None:
    environment = {"_ASEMEC_COMPLETE": "bash_complete", "COMP_WORDS": "asemec dia", "COMP_CWORD": "1"}
    assert asemec(**environment).out.splitlines() == ["plain,diagram"]
    environment |= {"COMP_WORDS": "asemec diagram --form", "COMP_CWORD": "2"}
    assert asemec(**environment).out.splitlines() == ["plain,--format"]


class TestColour:
    def test_none_in_a_pipe(self, folder: Path) -> None:
        assert "\x1b[" not in asemec("check", "bad.aseme", cwd=folder).out

    def test_always(self, here: Here, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        assert "\x1b[31" in here("check", "bad.aseme", "--color", "always").out
        monkeypatch.setenv("NO_COLOR", "1")
        assert "\x1b[31" in here("check", "bad.aseme", "--color", "always").out

    def test_on_a_terminal_unless_not_wanted(self, folder: Path) -> None:
        def seen(*arguments: str, **environment: str) -> str:
            environment = {**os.environ, "TERM": "xterm", **environment}
            return shown(command("check", "bad.aseme", *arguments), environment)

        assert "\x1b[31" in seen()
        assert "\x1b[" not in seen(NO_COLOR="1")
        assert "\x1b[" not in seen("--color", "never")
        assert "\x1b[" not in seen(TERM="dumb")


def test_main_leaves_the_signals_of_its_caller_alone(folder: Path) -> None:
    before = signal.getsignal(signal.SIGTERM), signal.getsignal(signal.SIGINT)
    main(["check", "good.aseme"])
    assert (signal.getsignal(signal.SIGTERM), signal.getsignal(signal.SIGINT)) == before
