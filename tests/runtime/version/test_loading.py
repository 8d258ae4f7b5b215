"""Loading generated packages and activities from where they are."""

from __future__ import annotations

import importlib
import shutil
import sys
import textwrap
from pathlib import Path

import pytest

from aseme_dsl.backends.backend import BackendOptions
from aseme_dsl.backends.jade_like import BACKEND as JADE_LIKE
from aseme_dsl.backends.monas import BACKEND
from aseme_dsl.runtime import LoadError, TeamError, activities_in, find_plan, load_system, make_team, run
from aseme_dsl.runtime.message.naming import class_name, module_name
from aseme_dsl.runtime.time.clock import SECOND
from aseme_dsl.runtime.version.loading import RoleBackends, importing, load_beside, other_names
from tests.support.generated import system_of

TEXT = """
system Plant
message M { int n }
topic t { state M }
srm robot {
  liveness { robot = (PickUp . PutDown)~ }
  activities { PickUp takes 1s writes t.state.M }
  control robot { enter PutDown : [is_good(t.state.M)] }
}
srm desk { liveness { desk = Wait } }
function is_good(M m) : bool = "judging:is_good"
team T { r1, r2 : robot }
"""
PICK_UP = """
from monas.Plant.messages import M
from .helping import number

class PickUp:
    def execute(self, context):
        context.publish("t.state.M", M(n=number()))
"""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A project as a build leaves it: generated Python in `build`, activities and functions by hand."""
    for artefact in BACKEND.generate(system_of(TEXT), BackendOptions()):
        path = tmp_path / "build" / "monas" / artefact.path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(artefact.text, encoding="utf-8")
    activities = tmp_path / "activities"
    activities.mkdir()
    (activities / "pick_up.py").write_text(textwrap.dedent(PICK_UP))
    (activities / "helping.py").write_text("def number():\n    return 7\n")
    (tmp_path / "judging.py").write_text("def is_good(m):\n    return m.n == 7\n")
    return tmp_path


def test_a_team_is_run_from_where_it_was_generated(project: Path) -> None:
    loaded = load_system(project / "build" / "monas" / "Plant", path=[project])
    assert (loaded.name, sorted(loaded.charts)) == ("Plant", ["desk", "robot"])
    assert loaded.team == (("r1", "robot"), ("r2", "robot"))
    result = run(loaded, activities_in(project / "activities"), until_ns=10 * SECOND)
    assert result.reason == "time" and not result.failed
    assert find_plan("robot", "Plant") is loaded.charts["robot"].PLAN


def test_sys_path_is_as_before(project: Path) -> None:
    before = list(sys.path)
    loaded = load_system(project / "build" / "monas" / "Plant", path=[project])
    run(loaded, activities_in(project / "activities"), until_ns=SECOND)
    assert sys.path == before


def test_one_plan_can_be_run_alone(project: Path) -> None:
    loaded = load_system(project / "build" / "monas" / "Plant", path=[project])
    find = activities_in(project / "activities")
    team = make_team(loaded, find, plan="robot", agent="solo", until_ns=SECOND)
    assert [(agent.name, agent.role) for agent in team.agents] == [("solo", "robot")]
    with pytest.raises(TeamError, match="Plant has no plan cook; it has"):
        make_team(loaded, find, plan="cook")


def test_a_package_that_was_built_again_is_loaded_again(project: Path) -> None:
    folder = project / "build" / "monas" / "Plant"
    first = load_system(folder)
    second = load_system(folder)
    assert first.charts["robot"] is not second.charts["robot"]
    assert first.messages["M"]() != second.messages["M"]()


def test_what_is_no_generated_package_is_named(tmp_path: Path) -> None:
    with pytest.raises(LoadError, match="there is no generated package"):
        load_system(tmp_path / "monas" / "Nothing")
    broken = tmp_path / "monas" / "Broken"
    broken.mkdir(parents=True)
    (broken / "__init__.py").write_text("import nowhere_to_be_found\n")
    with pytest.raises(LoadError, match="ModuleNotFoundError: No module named 'nowhere_to_be_found'"):
        load_system(broken)
    (broken / "__init__.py").write_text("\n")
    (broken / "messages.py").write_text("")
    with pytest.raises(LoadError, match="not a package that asemec has generated"):
        load_system(broken)


def test_all_activities_that_cannot_be_loaded_are_named_before_the_run(project: Path) -> None:
    (project / "activities" / "pick_up.py").write_text("import nowhere_to_be_found\n")
    (project / "activities" / "put_down.py").write_text("class PutDwon:\n    pass\n")
    loaded = load_system(project / "build" / "monas" / "Plant", path=[project])
    with pytest.raises(TeamError) as raised:
        run(loaded, activities_in(project / "activities"))
    assert str(raised.value).splitlines() == [
        "pick_up.py cannot be imported: ModuleNotFoundError: No module named 'nowhere_to_be_found'",
        "put_down.py has no class PutDown",
    ]


@pytest.mark.parametrize(
    ("activity", "module", "kind"),
    [
        ("KickBall", "kick_ball", "KickBall"),
        ("kick_ball", "kick_ball", "KickBall"),
        ("CheckForBallObservation", "check_for_ball_observation", "CheckForBallObservation"),
        ("LEDHandler", "led_handler", "LEDHandler"),
        ("Move2Goal", "move2_goal", "Move2Goal"),
        ("Import", "import_", "Import"),
    ],
)
def test_names_of_modules_and_classes(activity: str, module: str, kind: str) -> None:
    assert (module_name(activity), class_name(activity)) == (module, kind)


def test_projects_may_have_modules_of_one_name(tmp_path: Path) -> None:
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "court.py").write_text(f"NAME = {name!r}\n", encoding="utf-8")
    seen = []
    for name in ("one", "two", "two", "one"):
        with importing([tmp_path / name]):
            seen.append(importlib.import_module("court").NAME)
    assert seen == ["one", "two", "two", "one"]


# ---- packages of several backends ----------------------------------------------------------------


@pytest.fixture
def two(project: Path) -> Path:
    """The same project, for which jade_like has generated a package, too."""
    for artefact in JADE_LIKE.generate(system_of(TEXT), BackendOptions()):
        path = project / "build" / "jade_like" / artefact.path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(artefact.text, encoding="utf-8")
    return project


def test_activities_import_the_messages_under_other_names(two: Path) -> None:
    shutil.rmtree(two / "build" / "monas")
    package = two / "build" / "jade_like" / "Plant"
    loaded = load_system(package, path=[two], mixture=RoleBackends(names=("monas", "jade_like")))
    result = run(loaded, activities_in(two / "activities"), until_ns=10 * SECOND)
    assert result.reason == "time" and not result.failed
    assert other_names(loaded.modules) == {"monas": "jade_like"}


def test_roles_are_taken_from_several_packages_that_have_the_same_messages(two: Path) -> None:
    mixture = RoleBackends({"desk": "jade_like", "of_another_system": "jade_like"}, ("monas", "jade_like"))
    loaded = load_system(two / "build" / "monas" / "Plant", path=[two], mixture=mixture)
    assert loaded.charts["robot"].AGENT is None
    assert loaded.charts["desk"].AGENT is not None
    assert loaded.modules["jade_like.Plant.messages"] is loaded.modules["monas.Plant.messages"]
    assert other_names(loaded.modules) == {"jade_like": "monas"}
    assert not run(loaded, activities_in(two / "activities"), until_ns=SECOND).failed


def test_a_version_beside_one_that_runs_leaves_its_modules_alone(two: Path) -> None:
    mixture = RoleBackends({"desk": "jade_like"}, ("monas", "jade_like"))
    package = two / "build" / "monas" / "Plant"
    loaded = load_system(package, path=[two], mixture=mixture)
    other = load_beside(package, loaded.modules, [two], mixture)
    assert other.charts["desk"] is not loaded.charts["desk"]
    assert other.messages["M"] is loaded.messages["M"]
    names = [name for name in loaded.modules if "Plant" in name]
    assert all(sys.modules[name] is loaded.modules[name] for name in names)


def test_a_package_of_another_project_is_not_taken_for_a_name(
    two: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """After `monas` was only another name, it may be a folder again."""
    load_system(two / "build" / "jade_like" / "Plant", mixture=RoleBackends(names=("monas", "jade_like")))
    elsewhere = tmp_path_factory.mktemp("elsewhere") / "build"
    shutil.copytree(two / "build" / "monas", elsewhere / "monas")
    loaded = load_system(elsewhere / "monas" / "Plant", mixture=RoleBackends(names=("monas", "jade_like")))
    assert str(loaded.modules["monas.Plant.messages"].__file__).startswith(str(elsewhere))
