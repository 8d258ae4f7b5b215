"""`asemec new`."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.support import Here


def test_a_new_project_is_checked_played_and_tested(
    here: Here, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert here("new", "my-patrol").code == 0
    made = folder / "my-patrol"
    monkeypatch.chdir(made)
    assert here("check", "--strict").out == "no problems found in 1 file\n"
    done = here("run", ".")
    assert done.code == 0, done.err
    assert done.err == ""
    assert "scout (robot) completed" in done.out
    assert (made / "out/diagrams/iac.robot.svg").exists()
    tests = subprocess.run(
        [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider"],
        cwd=made,
        capture_output=True,
        text=True,
    )
    assert tests.returncode == 0, tests.stdout


def test_generated_and_given_code_passes_ruff(here: Here, folder: Path) -> None:
    here("new", "patrol")
    assert here("build", "patrol", "--only", "monas").code == 0
    done = subprocess.run(
        [sys.executable, "-m", "ruff", "check", "--isolated", "."],
        cwd=folder / "patrol",
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout


def test_it_says_what_it_made(here: Here, folder: Path) -> None:
    done = here("new", "patrol")
    assert done.code == 0
    assert str(Path("patrol/patrol.aseme")) in done.out.splitlines()
    assert done.out.splitlines()[-1] == "Next: asemec run patrol"
    assert here("new", "second", "--json").json["created"]


def test_names(here: Here, folder: Path) -> None:
    for given, module, system in (
        ("my-patrol", "my_patrol", "MyPatrol"),
        ("MyTeam", "my_team", "MyTeam"),
        ("a b", "a_b", "AB"),
    ):
        assert here("new", given).code == 0
        assert f"system {system}" in (folder / given / f"{module}.aseme").read_text()
    assert here("new", "x1", "--name", "Other").code == 0
    assert (folder / "x1" / "other.aseme").exists()


@pytest.mark.parametrize("name", ["1st", "_", "été", "none", "true"])
def test_names_that_no_system_can_have(here: Here, folder: Path, name: str) -> None:
    done = here("new", name)
    assert done.code == 2
    assert "cannot name a system" in done.err
    assert not (folder / name).exists()


def test_into_an_existing_folder_but_over_nothing(here: Here, folder: Path) -> None:
    (folder / "patrol").mkdir()
    (folder / "patrol/notes.txt").write_text("mine")
    assert here("new", "patrol").code == 0
    (folder / "patrol/patrol.aseme").write_text("edited")
    (folder / "patrol/README.md").unlink()
    done = here("new", "patrol")
    assert done.code == 1
    assert "patrol.aseme exists already" in done.err
    assert (folder / "patrol/patrol.aseme").read_text() == "edited"
    assert not (folder / "patrol/README.md").exists()


def test_where_nothing_can_be_written(here: Here, folder: Path) -> None:
    done = here("new", "good.aseme/patrol")
    assert done.code == 1
    assert "error[E009]" in done.err
