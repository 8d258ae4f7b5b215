"""Which backend is built and played: on the command line, in a project, for all roles or for one."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.support import GOOD, Here, asemec
from tests.support.traces import records_of, texts_of

TWO = """\
system Pair
message Seen { bool ball }
topic eyes { state Seen }
srm walker { liveness { walker = Walk~ } activities { Walk takes 1s writes eyes.state.Seen } }
srm watcher { liveness { watcher = Watch~ } activities { Watch takes 1s reads eyes.state.Seen } }
team Pair { a : walker  b : watcher }
"""

OWN = """\
from jade_like.Walker.robot import agent, behaviours


class Walk(behaviours.Walk):
    def on_start(self) -> None:
        self.log(f"{self.agent.name} sets out")


class WalkerRobotAgent(agent.RobotAgent):
    def setup(self) -> None:
        self.use(Walk)
"""

SEEN = '{"at": "0s", "channel": "eyes.state.Seen", "message": {"ball": true}}\n'


def files(folder: Path) -> set[str]:
    """The generated Python in an output folder."""
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*.py")}


def test_what_jade_like_writes(here: Here, folder: Path) -> None:
    done = here("build", "good.aseme", "--backend", "jade_like", "-o", "out")
    assert done.code == 0
    assert files(folder / "out") == {
        "jade_like/Walker/__init__.py",
        "jade_like/Walker/messages.py",
        "jade_like/Walker/robot/__init__.py",
        "jade_like/Walker/robot/agent.py",
        "jade_like/Walker/robot/behaviours.py",
        "jade_like/Walker/robot/plan.py",
        "jade_like/Walker/robot/step.py",
        "monas/activities/walker_robot_agent.py",
        "monas/activities/stand.py",
        "monas/activities/walk.py",
    }


def test_both_backends_have_the_same_plans_steps_messages_and_activities(here: Here, folder: Path) -> None:
    done = here(
        "build",
        "good.aseme",
        "--backend",
        "jade_like",
        "--backend",
        "monas",
        "--only",
        "monas",
        "--only",
        "jade_like",
    )
    assert done.code == 0
    written = files(folder / "out")
    for path in ("messages.py", "robot/plan.py", "robot/step.py"):
        one, other = (folder / "out" / name / "Walker" / path for name in ("monas", "jade_like"))
        assert one.read_bytes() == other.read_bytes()
    assert {path for path in written if "activities" in path} == {
        "monas/activities/walker_robot_agent.py",
        "monas/activities/stand.py",
        "monas/activities/walk.py",
    }
    assert "files: 15 created" in done.out


def test_what_is_the_users_stays_whichever_backend_is_built(here: Here, folder: Path) -> None:
    here("build", "good.aseme", "--backend", "jade_like")
    own = folder / "out/monas/activities/walker_robot_agent.py"
    own.write_text(OWN)
    walk = folder / "out/monas/activities/walk.py"
    walk.write_text("class Walk:\n    def execute(self, context):\n        context.wait(0.5)\n")
    for backend in ("monas", "jade_like"):
        assert here("build", "good.aseme", "--backend", backend).code == 0
        assert own.read_text() == OWN
        assert "wait(0.5)" in walk.read_text()


def test_an_own_behaviour_is_heard_in_a_run(here: Here, folder: Path) -> None:
    here("build", "good.aseme", "--backend", "jade_like")
    (folder / "out/monas/activities/walker_robot_agent.py").write_text(OWN)
    (folder / "in.jsonl").write_text(SEEN)
    done = asemec("run", "out", "--for", "2500ms", "--input", "in.jsonl", cwd=folder)
    assert done.code == 0, done.err
    trace = records_of(folder / "out/trace.jsonl.gz")
    logs = [(line["time"], line["text"]) for line in trace if line["kind"] == "log"]
    assert logs[:3] == [(0, "one sets out"), (0, "two sets out"), (1_000_000_000, "one sets out")]


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ("import nothing_of_that_name", "walker_robot_agent.py cannot be imported: ModuleNotFoundError"),
        ("class Robot:\n    pass", "walker_robot_agent.py has no class WalkerRobotAgent"),
        (
            "class WalkerRobotAgent:\n    pass",
            "WalkerRobotAgent is not a subclass of jade_like.Walker.robot.agent.RobotAgent",
        ),
    ],
)
def test_a_class_of_the_user_that_does_not_fit_is_said_before_the_run(
    here: Here, folder: Path, wrong: str, said: str
) -> None:
    here("build", "good.aseme", "--backend", "jade_like", "--only", "jade_like")
    (folder / "out/monas/activities/walker_robot_agent.py").write_text(wrong + "\n")
    done = here("run", "out")
    assert done.code == 1
    assert said in done.err
    assert "Traceback" not in done.err


def test_systems_that_share_a_folder_of_activities_have_agents_of_their_own(here: Here, folder: Path) -> None:
    (folder / "other.aseme").write_text(GOOD.replace("system Walker", "system Runner"))
    for name in ("good", "other"):
        assert here("scaffold", f"{name}.aseme", "--activities", "mine").code == 0
        done = here(
            "build",
            f"{name}.aseme",
            "--backend",
            "jade_like",
            "-o",
            f"out_{name}",
            "--activities",
            "mine",
        )
        assert done.code == 0, done.err
    written = {path.name for path in (folder / "mine").glob("*_agent.py")}
    assert written == {"walker_robot_agent.py", "runner_robot_agent.py"}


@pytest.mark.parametrize("name", ["monas", "jade_like"])
@pytest.mark.parametrize("backend", ["monas", "jade_like"])
def test_activities_import_messages_under_either_name(
    here: Here, folder: Path, name: str, backend: str
) -> None:
    """Also in processes of their own."""
    (folder / "pair.aseme").write_text(TWO.replace("~", ""))
    (folder / "activities").mkdir()
    (folder / "activities/walk.py").write_text(
        f"from {name}.Pair.messages import Seen\n\n\nclass Walk:\n    kind = 'process'\n\n"
        "    def execute(self, context):\n        context.publish('eyes.state.Seen', Seen(ball=True))\n"
    )
    (folder / "activities/watch.py").write_text(
        f"from {name}.Pair.messages import Seen\n\n\nclass Watch:\n"
        "    def execute(self, context):\n"
        "        while (seen := context.latest_message('eyes.state.Seen')) is None:\n"
        "            context.wait(0.05)\n"
        "        assert type(seen) is Seen\n        context.log('seen')\n"
    )
    done = here(
        *("run", "pair.aseme", "--backend", backend, "--activities", "activities"),
        *("--real", "--for", "60s"),
    )
    assert done.code == 0, done.out + done.err
    assert "all agents completed" in done.out
    assert '"text":"seen"' in "".join(texts_of(folder / "out/trace.jsonl.gz"))


# ---- which one ----------------------------------------------------------------------------------


def played(folder: Path) -> set[str]:
    """The backends whose packages a folder has."""
    return {path.parent.parent.name for path in folder.glob("*/*/messages.py")}


def test_the_project_says_which_backend_and_which_for_a_role(here: Here, folder: Path) -> None:
    (folder / "good.aseme").write_text(TWO)
    (folder / "pyproject.toml").write_text(
        '[tool.asemec]\nfiles = ["good.aseme"]\nbackends = ["jade_like"]\n'
        '[tool.asemec.roles]\nwalker = "monas"\n'
    )
    assert here("run", ".", "--for", "2s").code == 0
    assert played(folder / "out") == {"monas", "jade_like"}
    assert here("run", ".", "--for", "2s", "--backend", "jade_like", "-o", "other").code == 0
    assert played(folder / "other") == {"jade_like"}
    assert (
        here(
            "run", ".", "--for", "2s", "--backend", "watcher=monas", "--backend", "monas", "-o", "third"
        ).code
        == 0
    )
    assert played(folder / "third") == {"monas"}


def test_agents_are_played_also_where_a_project_builds_none(here: Here, folder: Path) -> None:
    (folder / "pyproject.toml").write_text('[tool.asemec]\nbackends = ["plain"]\n')
    assert here("run", "good.aseme", "--for", "2s").code == 0
    assert played(folder / "out") == {"monas", "plain"}


def test_a_role_that_there_is_not(here: Here, folder: Path) -> None:
    (folder / "pyproject.toml").write_text('[tool.asemec]\n\n[tool.asemec.roles]\nrobbot = "jade_like"\n')
    done = here("build", "good.aseme")
    assert done.code == 1
    assert done.err.startswith(
        "pyproject.toml:4:1: error[E010]: [tool.asemec.roles] names a role `robbot`, which the system"
        " does not have\n"
    )
    assert "hint: did you mean `robot`?" in done.err


def test_a_role_of_one_of_several_systems(here: Here, folder: Path) -> None:
    (folder / "pair.aseme").write_text(TWO)
    (folder / "pyproject.toml").write_text(
        '[tool.asemec]\nfiles = ["good.aseme", "pair.aseme"]\n[tool.asemec.roles]\nwalker = "jade_like"\n'
    )
    assert here("build").code == 0
    done = here("run", "out/Pair", "--for", "1s")
    assert done.code == 0, done.err


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--backend", "jadelike"], "Unknown backend 'jadelike'. Did you mean 'jade_like'?"),
        (["--backend", "robot=jadelike"], "Unknown backend 'jadelike'. Did you mean 'jade_like'?"),
        (["--backend", "robt=jade_like"], "Unknown role 'robt'. Did you mean 'robot'?"),
    ],
)
@pytest.mark.parametrize("command", ["build", "run"])
def test_what_there_is_not_is_wrong_use(
    here: Here, folder: Path, command: str, arguments: list[str], said: str
) -> None:
    done = here(command, "good.aseme", *arguments)
    assert done.code == 2
    assert said in done.err
    assert not (folder / "out").exists()


def test_roles_must_be_a_table_of_names(here: Here, folder: Path) -> None:
    (folder / "pyproject.toml").write_text('[tool.asemec]\nroles = "jade_like"\n')
    done = here("build", "good.aseme")
    assert done.code == 1
    assert '`roles` must be a table of backends by role, such as { dispatcher = "jade_like" }' in done.err


def test_what_runs_from_an_output_folder_is_what_is_there(here: Here, folder: Path) -> None:
    here("build", "good.aseme", "--backend", "jade_like")
    assert here("run", "out", "--for", "1s").code == 0
    done = here("run", "out", "--for", "1s", "--backend", "robot=monas")
    assert done.code == 1
    assert "there is no generated package in" in done.err
    assert "build it first" in done.err


def test_packages_of_different_models_are_no_team(here: Here, folder: Path) -> None:
    here("build", "good.aseme", "--backend", "jade_like")
    (folder / "good.aseme").write_text(GOOD.replace("Walk takes 1s", "Walk takes 2s"))
    here("build", "good.aseme", "--backend", "monas")
    done = here("run", "out", "--backend", "monas", "--backend", "robot=jade_like")
    assert done.code == 1
    assert "are of different models: build both" in done.err


LISTENS = TWO.replace("state Seen }", "state Seen  signal Seen }").replace(
    "srm watcher {", "srm watcher { control watcher { enter Watch : [eyes.signal.Seen.ball] }"
)


def test_a_plain_class_is_made_of_the_roles_that_are_asked_for(here: Here, folder: Path) -> None:
    (folder / "pair.aseme").write_text(LISTENS)
    refused = here("build", "pair.aseme", "--only", "plain")
    assert (refused.code, "E320" in refused.err) == (1, True)
    done = here("build", "pair.aseme", "--only", "plain", "--backend", "walker=plain")
    assert done.code == 0, done.err
    package = {"plain/Pair/__init__.py", "plain/Pair/messages.py"}
    assert files(folder / "out") == package | {"plain/Pair/walker.py", "plain/Pair/walker_watched.py"}
    assert (folder / "out/plain/Pair/__init__.py").read_text().count("Watcher") == 0


def test_plain_classes_of_some_roles_are_made_beside_the_agents_of_all(here: Here, folder: Path) -> None:
    (folder / "pair.aseme").write_text(LISTENS)
    (folder / "pyproject.toml").write_text('[tool.asemec.roles]\nwalker = "plain"\n')
    done = here("build", "pair.aseme")
    assert done.code == 0, done.err
    made = files(folder / "out")
    assert {"monas/Pair/walker/step.py", "monas/Pair/watcher/step.py", "plain/Pair/walker.py"} <= made
    assert "plain/Pair/watcher.py" not in made
    played = here("run", "pair.aseme", "--for", "1s")
    assert played.code == 0, played.err


def test_what_plays_agents_has_no_use_for_a_plain_class(here: Here, folder: Path) -> None:
    done = here("run", "good.aseme", "--backend", "robot=plain")
    assert done.code == 2
    assert "Backend plain cannot run agents; use one of monas, jade_like for robot." in done.err


NO_NAMES_FOR_PYTHON = """\
system False_
message M { int n }
topic t { state M }
srm none {
  liveness { none = None . True . false_ }
  activities { None reads t.state.M  True takes 1s  false_ takes 1s }
}
team T { me : none }
"""


@pytest.mark.parametrize("backend", ["monas", "jade_like", "plain"])
def test_names_that_python_has_for_its_constants(backend: str, folder: Path, here: Here) -> None:
    (folder / "odd.aseme").write_text(NO_NAMES_FOR_PYTHON, "utf-8")
    assert here("build", "odd.aseme", "-o", "out", "--backend", backend).code == 0
    for path in (folder / "out").rglob("*.py"):
        compile(path.read_bytes(), str(path), "exec")
    if backend != "plain":
        done = here("run", "odd.aseme", "-o", "out", "--backend", backend)
        assert (done.code, "Traceback" in done.err) == (0, False), done.err
