"""What commands work on: a file, a project, an output folder, or the project of the current folder."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.cli.support import GOOD, Here

PROJECT = '[tool.asemec]\nfiles = ["src/walker.aseme"]\noutput = "made"\n'


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "src").mkdir()
    (tmp_path / "src" / "walker.aseme").write_text(GOOD)
    (tmp_path / "pyproject.toml").write_text(PROJECT)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_trace_is_found_whatever_is_named(here: Here, project: Path) -> None:
    (project / "made").mkdir()
    done = here("run", "--for", "2s", "--allow", "waiting")
    assert done.code == 0, done.err
    assert (project / "made" / "trace.jsonl").is_file()
    for command in ("trace", "sniff"):
        said = here(command, "made/trace.jsonl").out
        for target in ([], ["."], ["made"], ["src/walker.aseme"], [str(project)]):
            again = here(command, *target)
            assert (again.code, again.out.replace(f"{project}/", "")) == (0, said), (command, target)


def test_the_project_around_the_current_folder_is_meant(here: Here, project: Path) -> None:
    os.chdir(project / "src")
    done = here("diagram", "--format", "dot", "-o", "drawn")
    assert done.code == 0, done.err
    assert list((project / "src" / "drawn").iterdir())
    assert here("run", "--for", "1s", "--allow", "waiting").code == 0
    assert here("trace").code == 0


def test_a_project_without_a_run_has_no_trace(here: Here, project: Path) -> None:
    for command in ("trace", "sniff"):
        done = here(command)
        assert done.code == 1 and "made/trace.jsonl" in done.err, done.err


def test_of_two_systems_one_is_named(here: Here, folder: Path) -> None:
    for command in ("run", "diagram", "view"):
        done = here(command, ".")
        assert done.code == 2 and "means 2 systems" in done.err, (command, done.err)
