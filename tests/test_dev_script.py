"""`dev.py`: what it says on a machine that lacks something, and that it stops where a check fails."""

from __future__ import annotations

import importlib.util
import json
import os
import platform
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TextIO

import pytest

import dev

ROOT = Path(__file__).resolve().parent.parent


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A checkout without `.venv`, in a folder whose name has a blank."""
    folder = tmp_path / "my robots"
    folder.mkdir()
    for name in ("dev.py", "pyproject.toml"):
        shutil.copy(ROOT / name, folder / name)
    return folder


def run_without(module: str, checkout: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Run the script with a Python in which `module` is missing, as Debian's is without python3-venv."""
    patched = checkout.parent / "patched"
    patched.mkdir()
    (patched / "sitecustomize.py").write_text(f"import sys\nsys.modules[{module!r}] = None\n", "utf-8")
    return subprocess.run(
        [sys.executable, str(checkout / "dev.py"), *arguments],
        cwd=checkout.parent,
        env={**os.environ, "PYTHONPATH": str(patched)},
        capture_output=True,
        text=True,
    )


@pytest.mark.parametrize("module", ["venv", "ensurepip"])
@pytest.mark.parametrize("command", ["play", "test"])
def test_a_missing_venv_package_is_named_before_anything_is_made(
    module: str, command: str, checkout: Path
) -> None:
    result = run_without(module, checkout, command)
    major, minor = sys.version_info[:2]
    assert result.returncode == 1
    assert f"sudo apt install python{major}.{minor}-venv" in result.stderr
    assert f"`{module}` is not installed" in result.stderr
    assert "Traceback" not in result.stderr
    assert not (checkout / ".venv").exists()


def test_an_old_python_is_told_which_one_is_needed() -> None:
    with pytest.raises(
        dev.SetupError, match=r"needs Python 3\.11 or newer, and /usr/bin/python3 is Python 3\.9"
    ):
        dev.check_python((3, 9), "/usr/bin/python3")


def test_a_broken_venv_module_is_reported_in_its_own_words(
    checkout: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    in_checkout(checkout, monkeypatch)
    (checkout / ".venv").write_text("a file stands in the way", "utf-8")
    assert dev.main(["test"]) == 1
    assert "could not be made" in capsys.readouterr().err


def test_wrong_use_is_exit_code_2(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as exit_:
        dev.main(["dance"])
    assert exit_.value.code == 2


def in_checkout(checkout: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the imported module work in `checkout` instead of in ours."""
    monkeypatch.setattr(dev, "ROOT", checkout)
    venv = checkout / ".venv"
    for name, path in {"VENV": venv, "PYTHON": venv / "bin" / "python"}.items():
        monkeypatch.setattr(dev, name, path)
    monkeypatch.setattr(dev, "STAMP", venv / dev.STAMP.name)
    monkeypatch.setattr(dev, "LOG", venv / dev.LOG.name)


@pytest.fixture
def installed(checkout: Path, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """A checkout with an environment but without pip's work: what would be installed is collected."""
    in_checkout(checkout, monkeypatch)
    requirements: list[str] = []
    monkeypatch.setattr(dev, "install", requirements.append)
    monkeypatch.setattr(dev, "has_usable_environment", lambda: True)
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", str(checkout / ".venv")], check=True)
    return requirements


def test_the_second_run_installs_nothing(checkout: Path, installed: list[str]) -> None:
    dev.set_up("dev")
    assert installed == [f"{checkout}[dev]"]
    dev.set_up("dev")
    dev.set_up("")
    assert len(installed) == 1


def test_the_tests_need_more_than_the_game(checkout: Path, installed: list[str]) -> None:
    dev.set_up("")
    dev.set_up("dev")
    assert installed == [str(checkout), f"{checkout}[dev]"]


def test_a_changed_dependency_is_installed_and_a_changed_setting_is_not(
    checkout: Path, installed: list[str]
) -> None:
    dev.set_up("dev")
    project = checkout / "pyproject.toml"
    text = project.read_text("utf-8")
    project.write_text(text.replace("line-length = 110", "line-length = 100"), "utf-8")
    dev.set_up("dev")
    assert len(installed) == 1
    project.write_text(text.replace('"click>=8.1,<9"', '"click>=8.2,<9"'), "utf-8")
    dev.set_up("dev")
    assert len(installed) == 2


def test_an_installation_that_broke_off_is_done_again(
    checkout: Path, installed: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    dev.set_up("dev")
    project = checkout / "pyproject.toml"
    text = project.read_text("utf-8")

    def interrupted(requirement: str) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(dev, "install", interrupted)
        project.write_text(text.replace('"click>=8.1,<9"', '"click>=8.2,<9"'), "utf-8")
        assert dev.main(["test"]) == 130
    project.write_text(text, "utf-8")
    dev.set_up("dev")
    assert len(installed) == 2


def test_a_pip_that_fails_is_quoted_and_leaves_no_stamp(
    checkout: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    in_checkout(checkout, monkeypatch)
    project = checkout / "pyproject.toml"
    project.write_text('[build-system]\nrequires = ["./nowhere"]\n[project]\nname = "x"\n', "utf-8")
    assert dev.main(["test"]) == 1
    said = capsys.readouterr().err
    assert "nowhere" in said
    assert "pip could not install aseme-dsl" in said
    assert not (checkout / ".venv" / dev.STAMP.name).exists()


Recorder = Callable[[dict[str, int]], list[list[str]]]


@pytest.fixture
def record(monkeypatch: pytest.MonkeyPatch) -> Recorder:
    """Record what would be started, with the exit code that a module is to have."""

    def start(codes: dict[str, int]) -> list[list[str]]:
        started: list[list[str]] = []

        def in_environment(
            arguments: list[str], variables: dict[str, str] | None = None, output: TextIO | None = None
        ) -> int:
            started.append(arguments)
            if output is not None:
                output.write(f"{arguments[1]} says this\n")
            return codes.get(arguments[-1] if len(arguments) == 1 else arguments[1], 0)

        monkeypatch.setattr(dev, "set_up", lambda extra: None)
        monkeypatch.setattr(dev, "in_environment", in_environment)
        return started

    return start


def test_all_checks_run_in_order_and_pytest_closes(
    record: Recorder, capsys: pytest.CaptureFixture[str]
) -> None:
    started = record({})
    assert dev.main(["test", "tests/amola", "-x"]) == 0
    modules = [arguments[1] for arguments in started]
    assert [*modules[:2], *sorted(modules[2:4]), *modules[4:]] == ["ruff", "ruff", "mypy", "sphinx", "pytest"]
    assert started[-1][-2:] == ["tests/amola", "-x"]
    assert capsys.readouterr().out.split("\n")[2:6] == [
        "== mypy",
        "mypy says this",
        "== documentation",
        "sphinx says this",
    ]


def test_the_first_failing_check_ends_it(record: Recorder, capsys: pytest.CaptureFixture[str]) -> None:
    started = record({"mypy": 3})
    assert dev.main(["test"]) == 3
    assert sorted(arguments[1] for arguments in started) == ["mypy", "ruff", "ruff", "sphinx"]
    assert "mypy failed (exit code 3)" in capsys.readouterr().err


@pytest.mark.parametrize(("failed", "further"), [(1, []), (dev.FEW, []), (dev.FEW + 1, []), (1, ["-x"])])
def test_a_few_failed_tests_are_run_once_more_alone(
    record: Recorder,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    failed: int,
    further: list[str],
) -> None:
    """With `-x`, and where much fails, that says nothing of the rest."""
    monkeypatch.setattr(dev, "FAILED", tmp_path / "lastfailed")
    dev.FAILED.write_text(json.dumps({f"tests/test_it.py::test_{number}": True for number in range(failed)}))
    started = record({"pytest": 1})
    assert dev.main(["test", *further]) == 1
    again = [arguments for arguments in started if "--last-failed" in arguments]
    assert len(again) == (failed <= dev.FEW and not further)
    assert ("tests/test_it.py::test_0" in capsys.readouterr().out) == bool(again)


def test_the_long_lane_measures_and_plays_many_random_charts(record: Recorder) -> None:
    started = record({})
    assert dev.main(["long"]) == 0
    assert started == [command for _, command, _ in dev.LONG]
    assert ["-m", "pytest", "tests/oracle"] in started


def test_the_unit_lane_is_there(record: Recorder) -> None:
    started = record({})
    assert dev.main(["unit", "-x"]) == 0
    assert started[0][:2] == ["-m", "pytest"]
    assert started[0][-len(dev.UNIT) - 1 :] == [*dev.UNIT, "-x"]
    for path in dev.UNIT:
        assert (ROOT / path.removeprefix("--ignore=")).exists()


def test_each_python_that_is_found_counts_once(tmp_path: Path) -> None:
    spec = importlib.util.spec_from_file_location("pythons", ROOT / "ci" / "pythons.py")
    assert spec is not None and spec.loader is not None
    pythons = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(pythons)
    for name, answer in {"old": "3.10.9 3 10", "new": "3.99.1 3 99", "broken": ""}.items():
        (tmp_path / name).write_text(f"#!/bin/sh\necho {answer}\n", "utf-8")
        (tmp_path / name).chmod(0o755)
    old, new, broken = (str(tmp_path / name) for name in ("old", "new", "broken"))
    found = pythons.versions([old, broken, "/no/python", new, sys.executable, sys.executable, new])
    assert found == {"3.99.1": new, platform.python_version(): sys.executable}


def test_play_passes_its_arguments_and_its_exit_code_on(record: Recorder) -> None:
    started = record({"aseme_dsl": 7})
    assert dev.main(["play", "--seed", "3"]) == 7
    assert started == [[*dev.PLAY, "--seed", "3"]]


def test_what_is_started_works_from_the_root_with_the_environments_tools(
    checkout: Path, installed: list[str], capfd: pytest.CaptureFixture[str]
) -> None:
    question = (
        "import json, os, shutil, sys; print(json.dumps([os.getcwd(), sys.prefix, shutil.which('python')]))"
    )
    assert dev.in_environment(["-c", question]) == 0
    venv = checkout / ".venv"
    assert json.loads(capfd.readouterr().out) == [str(checkout), str(venv), str(venv / "bin" / "python")]


def test_what_is_started_keeps_its_bytecode(
    checkout: Path,
    installed: list[str],
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("PYTHONDONTWRITEBYTECODE", "1")
    assert dev.in_environment(["-c", "import sys; print(sys.dont_write_bytecode)"]) == 0
    assert capfd.readouterr().out == "False\n"


def test_what_is_started_gets_no_variable_that_changes_a_python(
    checkout: Path,
    installed: list[str],
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    for name in ("PYTHONPATH", "PYTHONWARNINGS", "PYTHONOPTIMIZE", "ASEME_DSL_VENV"):
        monkeypatch.setenv(name, "1")
    question = "import os; print([name for name in os.environ if name.startswith(('PYTHON', 'ASEME_DSL'))])"
    assert dev.in_environment(["-c", question]) == 0
    assert capfd.readouterr().out == "[]\n"


def test_what_it_starts_hears_ctrl_c_where_the_shell_has_it_ignored() -> None:
    asks = "import signal, sys; sys.exit(signal.getsignal(signal.SIGINT) is signal.SIG_IGN)"
    program = (
        "import signal, sys\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\n"
        f"sys.path.insert(0, {str(Path(__file__).parents[1])!r})\nimport dev\n"
        f"dev.PYTHON = dev.Path(sys.executable)\ndev.set_up = print\ndev.PLAY = ['-c', {asks!r}]\n"
        "sys.exit(dev.main(['play']))"
    )
    assert subprocess.run([sys.executable, "-c", program]).returncode == 0
