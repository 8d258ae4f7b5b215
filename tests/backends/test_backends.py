"""Backends: templates of the user's own, and a backend that another package offers."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from aseme_dsl.backends.backend import (
    AGENTS,
    OWN,
    ROLE_MODULES,
    BackendOptions,
    UnknownBackend,
    backend_names,
    find_backend,
)
from aseme_dsl.backends.monas.generate import BACKEND
from aseme_dsl.runtime.message.naming import class_name, module_name
from tests.support.generated import system_of

WALKER = "system Walker\nsrm robot { liveness { robot = Walk . StandUp } activities { Walk takes 1s } }"

OUTSIDE = """
from aseme_dsl.backends.backend import Artefact


class Counting:
    name = "counting"

    def generate(self, system, options):
        lines = [f"{chart.name}: {len(chart.states)} states" for chart in system.statecharts]
        return (Artefact(f"{system.name}.txt", "\\n".join(lines) + "\\n"),)


BACKEND = Counting()
"""


def test_monas_is_found_by_its_name() -> None:
    assert "monas" in backend_names()
    assert find_backend("monas") is BACKEND


def test_an_unknown_backend_says_which_there_are() -> None:
    with pytest.raises(UnknownBackend, match=r"there is no backend monass; there are .*monas"):
        find_backend("monass")


def test_a_template_of_the_user_replaces_ours_by_name(tmp_path: Path) -> None:
    (tmp_path / "activity.py.j2").write_text("# {{ name }} of {{ roles | join(', ') }}\n", encoding="utf-8")
    texts = {a.path: a.text for a in BACKEND.generate(system_of(WALKER), BackendOptions(tmp_path))}
    assert texts["activities/walk.py"] == "# Walk of robot\n"
    assert "class RobotStep(Chart):" in texts["Walker/robot/step.py"]


@pytest.mark.parametrize("name", OWN)
def test_each_of_ours_has_the_name_that_finds_it_and_makes_the_same_again(name: str) -> None:
    backend = find_backend(name)
    made = backend.generate(system_of(WALKER), BackendOptions())
    assert backend.name == name
    assert made == backend.generate(system_of(WALKER), BackendOptions())
    assert made and not any(Path(item.path).is_absolute() or ".." in Path(item.path).parts for item in made)


@pytest.mark.parametrize("name", AGENTS)
def test_the_modules_of_a_role_are_those_that_are_said_of_its_backend(name: str) -> None:
    made = [Path(a.path) for a in find_backend(name).generate(system_of(WALKER), BackendOptions())]
    of_role = {path.stem for path in made if path.parent.name == "robot"}
    assert of_role - {"__init__"} == set(ROLE_MODULES[name])


def test_activities_are_kept_and_everything_else_is_generated_anew() -> None:
    artefacts = BACKEND.generate(system_of(WALKER), BackendOptions())
    assert {a.path for a in artefacts if a.kept} == {"activities/walk.py", "activities/stand_up.py"}


def test_a_backend_out_of_tree_is_built_like_ours(tmp_path: Path) -> None:
    """A package that is installed beside us, with its entry point, and `asemec build --backend`."""
    site = tmp_path / "site"
    information = site / "counting-1.0.dist-info"
    information.mkdir(parents=True)
    (site / "counting_backend.py").write_text(OUTSIDE, encoding="utf-8")
    (information / "METADATA").write_text(
        "Metadata-Version: 2.1\nName: counting\nVersion: 1.0\n", encoding="utf-8"
    )
    (information / "entry_points.txt").write_text(
        "[aseme_dsl.backends]\ncounting = counting_backend:BACKEND\n", encoding="utf-8"
    )
    (tmp_path / "walker.aseme").write_text(WALKER, encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-m", "aseme_dsl", "build", "walker.aseme", "-o", "out", "--backend", "counting"],
        cwd=tmp_path,
        env={"PYTHONPATH": f"{site}:{Path(__file__).parents[2]}"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out" / "counting" / "Walker.txt").read_text(encoding="utf-8") == "robot: 5 states\n"


@pytest.mark.parametrize(
    ("name", "module"),
    [
        ("WalkTowardsBall", "walk_towards_ball"),
        ("walk_towards_ball", "walk_towards_ball"),
        ("Import", "import_"),
        ("GPSFix", "gps_fix"),
        ("Scan2D", "scan2_d"),
    ],
)
def test_an_activity_s_module(name: str, module: str) -> None:
    assert module_name(name) == module


def test_an_activity_s_class() -> None:
    assert class_name("walk_towards_ball") == class_name("WalkTowardsBall") == "WalkTowardsBall"
