"""`asemec run`."""

from __future__ import annotations

import gzip
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.cli.support import GOOD, Here, asemec, command
from tests.support.traces import records_of

SCRIPT = """\
{"at": "2500ms", "channel": "eyes.state.Seen", "message": {"ball": true}}
{"at": "3500ms", "agent": "one", "channel": "eyes.state.Seen", "message": {"ball": true, "home": true}}
{"at": "5500ms", "channel": "eyes.state.Seen", "message": {"home": true}}
"""

WRONG = """\
from world import Court
class Late(Court):
    def __repr__(self):
        return "late" * 20
    now_ns = property(lambda self: "now", lambda self, value: None)
class Deaf(Court):
    def __repr__(self):
        return "deaf" * 20
    def advance(self):
        pass
class Still(Court):
    def advance(self, until_ns):
        pass
class Raising(Court):
    def advance(self, until_ns):
        if until_ns > 1_000_000_000:
            return 1 / 0
        super().advance(until_ns)
empty, none, late, deaf = lambda seed: {}, lambda seed: None, Late, Deaf
still, raising = Still, Raising
"""

WORLD = '''\
"""A world with a counter for the robots to look at."""


class Body:
    payload_limit = 10

    def __init__(self, name):
        self.name = name

    def sense(self):
        return None

    def act(self, command):
        pass

    def say(self, payload):
        return True

    def hear(self):
        return []


class Court:
    def __init__(self, seed):
        self.seed, self.now_ns, self.step_ns = seed, 0, 100_000_000
        self.bodies = {name: Body(name) for name in ("one", "two")}
        self.over = False

    def advance(self, until_ns):
        while self.now_ns + self.step_ns <= until_ns:
            self.now_ns += self.step_ns
            self.over = self.now_ns >= 2_000_000_000


def court(seed):
    return Court(seed)


def body(name):
    return Body(name)


def notes(world):
    return [f"whistle at {second} s" for second in range(1, world.now_ns // 1_000_000_000 + 1)]


def result(world):
    return f"the court of seed {world.seed} is closed"


def broken(**anything):
    raise RuntimeError("no court today")
'''

PROJECT = """\
[tool.asemec]
files = ["good.aseme"]
output = "made"
activities = "skills"

[tool.asemec.run]
world = "world:court"
progress = "world:notes"
summary = "world:result"
duration = "30s"
seed = 9
"""


@pytest.fixture
def script(folder: Path) -> Path:
    (folder / "script.jsonl").write_text(SCRIPT)
    return folder / "script.jsonl"


@pytest.fixture
def project(folder: Path) -> Path:
    """A project with a world of its own."""
    (folder / "world.py").write_text(WORLD)
    (folder / "pyproject.toml").write_text(PROJECT)
    (folder / "good.aseme").write_text(GOOD.replace("takes 1s", "takes 1s simulated"))
    (folder / "skills").mkdir()
    return folder


def trace(path: Path) -> list[dict[str, object]]:
    return records_of(path)


def test_a_team_plays_until_all_have_finished(here: Here, script: Path) -> None:
    done = here("run", "good.aseme", "--input", "script.jsonl")
    assert done.code == 0, done.err
    lines = done.out.splitlines()
    assert lines[0] == "Walker -> out: files: 14 created"
    assert "    0.00 s  one  Stand" in lines
    assert "    3.00 s  one  Walk" in lines
    assert "    3.00 s  two  Walk" in lines
    assert "finished after 6 s (virtual, seed 1): all agents completed" in lines
    assert "  one (robot) completed" in lines
    assert trace(Path("out/trace.jsonl.gz"))[-1]["reason"] == "finished"
    for part in ("models/iac.robot.json", "diagrams/iac.robot.svg", "monas/Walker/robot/plan.py"):
        assert (Path("out") / part).exists()


def test_it_ends_in_time(here: Here, folder: Path) -> None:
    assert "stopped after 60 s (virtual, seed 1): time limit reached" in here("run", "good.aseme").out
    assert (
        "stopped after 3 s (virtual, seed 7): time limit"
        in here("run", "good.aseme", "--for", "3s", "--seed", "7").out
    )


def test_the_same_seed_gives_the_same_trace(folder: Path, script: Path) -> None:
    for name, hash_seed in (("a", "1"), ("b", "2")):
        arguments = [
            "run",
            "good.aseme",
            "--input",
            "script.jsonl",
            "--seed",
            "5",
            "--trace",
            f"{name}.jsonl",
        ]
        assert asemec(*arguments, cwd=folder, PYTHONHASHSEED=hash_seed).code == 0
    assert (folder / "a.jsonl").read_bytes() == (folder / "b.jsonl").read_bytes()


def test_quiet_and_verbose(here: Here, script: Path) -> None:
    quiet = here("run", "good.aseme", "--input", "script.jsonl", "--quiet").out
    assert "one  Stand" not in quiet
    assert "finished after 6 s" in quiet
    verbose = here("run", "good.aseme", "--input", "script.jsonl", "--verbose").out
    assert "one  start of (Walk | Stand) -> Stand  else" in verbose
    assert verbose.count("one  Stand") > 1


def test_deadlines_that_pass_are_told(here: Here, folder: Path) -> None:
    (folder / "late.aseme").write_text("""system Late
srm r {
  liveness { r = Brew+ . Done }
  activities { Brew takes 9s within 2s  Done takes 1s }
  control r {
    repeat Brew : error [count(Brew) < 3]
    leave Brew : error
    leave Brew :
  }
}
""")
    done = here("run", "late.aseme")
    told = [line.split(maxsplit=2)[2] for line in done.err.splitlines() if "deadline: " in line]
    assert told == ["r  deadline: Brew is not done within 2 s (late.aseme:3:18)"] * 3
    (folder / "late.aseme").write_text((folder / "late.aseme").read_text().replace("< 3", "< 9"))
    done = here("run", "late.aseme")
    assert done.err.count("deadline: Brew") == 3
    assert "... 9 missed deadlines of Brew of r (late.aseme:3:18), see the trace\n" in done.err


def test_what_comes_again_after_something_else_is_told_again(here: Here, folder: Path) -> None:
    text = """system Again
srm robot {
  liveness { robot = ((A || B) . C)~ }
  activities { A takes 1s  B takes 1s  C takes 1s }
}
"""
    (folder / "again.aseme").write_text(text)
    done = here("run", "again.aseme", "--for", "6s")
    told = [line.split()[-1] for line in done.out.splitlines() if line.split()[-1:] in (["A"], ["B"], ["C"])]
    assert "".join(told).startswith("ABCABC")


def test_an_activity_is_told_again_behind_one_that_was_left_at_once(here: Here, folder: Path) -> None:
    """`B` does not run, since the same step leaves it; the second `A` is another one than the first."""
    (folder / "again.aseme").write_text(
        "system Again srm r { var n : int = 0 liveness { r = A . B . A } activities { A takes 1s B takes 2s }"
        " control r { enter A#2 : when [n >= 0] enter B : / n += 1 } }"
    )
    done = here("run", "again.aseme", "-o", "again")
    assert [line.split() for line in done.out.splitlines() if "  r  " in line] == [
        ["0.00", "s", "r", "A"],
        ["1.00", "s", "r", "A"],
    ]


def test_json(here: Here, script: Path) -> None:
    done = here("run", "good.aseme", "--input", "script.jsonl", "--json")
    result = done.json["result"]
    assert (result["system"], result["reason"], result["time"], result["seed"]) == (
        "Walker",
        "finished",
        6 * 10**9,
        1,
    )
    assert [(agent["name"], agent["finished"]) for agent in result["agents"]] == [
        ("one", True),
        ("two", True),
    ]
    assert result["trace"] == str(Path("out/trace.jsonl.gz"))
    assert "Stand" in done.err
    failed = here("run", "bad.aseme", "--json")
    assert (failed.code, failed.json["result"], failed.json["errors"]) == (1, None, 2)


def test_a_file_with_errors_is_not_played(here: Here, folder: Path) -> None:
    done = here("run", "bad.aseme")
    assert done.code == 1
    assert "error[" in done.err
    assert not (folder / "out").exists()


class TestPlans:
    def test_one_plan_alone(self, here: Here, script: Path) -> None:
        done = here("run", "good.aseme", "--role", "robot", "--for", "1s")
        assert "    0.00 s  one  Stand" in done.out
        assert "  two  " not in done.out
        done = here("run", "good.aseme", "--role", "Walker.robot", "--agent", "solo", "--for", "1s")
        assert "    0.00 s  solo  Stand" in done.out

    def test_what_a_robot_carries_is_listed(self, here: Here, folder: Path) -> None:
        (folder / "other.aseme").write_text(GOOD.replace("Walker", "Runner"))
        here("build", "good.aseme", "-o", "out")
        assert here("run", "out", "--list").out.startswith("Walker.robot ")
        result = here("run", "out", "--list", "--json").json
        (plan,) = result["plans"]
        assert (plan["plan"], plan["states"], plan["agents"]) == ("Walker.robot", 9, ["one", "two"])

    def test_a_robot_needs_no_source(self, here: Here, folder: Path, script: Path) -> None:
        here("build", "good.aseme", "-o", "out")
        (folder / "out" / "models").rename(folder / "models")
        (folder / "good.aseme").unlink()
        done = here("run", "out", "--input", "script.jsonl")
        assert done.code == 0, done.err
        assert "one  Walk" in done.out
        assert "->" not in done.out

    def test_of_several_systems_one_plan_is_chosen(self, here: Here, folder: Path) -> None:
        (folder / "other.aseme").write_text(GOOD.replace("Walker", "Runner"))
        here("build", "good.aseme", "other.aseme", "-o", "both")
        (folder / "robot" / "monas").mkdir(parents=True)
        for system in ("Walker", "Runner"):
            (folder / "both" / system / "monas" / system).rename(folder / "robot" / "monas" / system)
        assert len(here("run", "robot", "--list").out.splitlines()) == 2
        done = here("run", "robot", "--for", "1s")
        assert done.code == 2
        assert "choose a plan of Runner.robot, Walker.robot" in done.err
        assert "several plans are called `robot`" in here("run", "robot", "--role", "robot").err
        assert here("run", "robot", "--role", "Runner.robot", "--for", "1s").code == 0

    def test_a_plan_that_is_not_there(self, here: Here, folder: Path) -> None:
        done = here("run", "good.aseme", "--role", "robbot")
        assert done.code == 2
        assert "error[E032]: no plan is called `robbot`\n   hint: did you mean `robot`?" in done.err
        told = here("run", "good.aseme", "--role", "robbot", "--json")
        assert (told.code, told.json["result"]) == (2, None)

    def test_without_a_team_the_only_role_plays(self, here: Here, folder: Path) -> None:
        (folder / "good.aseme").write_text(GOOD.partition("team")[0])
        assert "    0.00 s  robot  Stand" in here("run", "good.aseme", "--for", "1s").out


class TestScripts:
    @pytest.mark.parametrize(
        ("line", "words"),
        [
            ("{", "script.jsonl:1:1: error[E031]: not JSON"),
            ('{"at": "soon", "event": "x"}', "is not a duration"),
            ('{"channel": "eyes.state.Sun", "message": {}}', "is not a channel"),
            ('{"channel": "eyes.state.Seen", "message": {"ball": 3}}', "script.jsonl:1:1: error[E031]"),
            ('{"agent": "three", "event": "Bumped"}', "there are one, two"),
        ],
    )
    def test_a_wrong_line_is_said(self, here: Here, script: Path, line: str, words: str) -> None:
        script.write_text(line)
        done = here("run", "good.aseme", "--input", "script.jsonl")
        assert done.code == 1
        assert words in done.err

    def test_a_script_that_cannot_be_read(self, here: Here, script: Path) -> None:
        assert "missing.jsonl cannot be read" in here("run", "good.aseme", "--input", "missing.jsonl").err
        script.write_bytes(b"\xff")
        assert "is not UTF-8" in here("run", "good.aseme", "--input", "script.jsonl").err


class TestActivities:
    def write(self, folder: Path, text: str) -> None:
        (folder / "skills").mkdir(exist_ok=True)
        (folder / "skills" / "stand.py").write_text(text)
        (folder / "good.aseme").write_text(GOOD.replace("Walk takes 1s", "Walk takes 1s simulated"))

    def test_they_may_log_and_import_messages(self, here: Here, folder: Path) -> None:
        self.write(
            folder,
            "from monas.Walker.messages import Seen\n"
            "class Stand:\n"
            "    def execute(self, context):\n"
            "        context.log(f'{Seen(ball=True)}')\n",
        )
        done = here("run", "good.aseme", "--activities", "skills", "--for", "1s")
        assert "one  Stand: Seen(ball=True, home=False)" in done.out

    def test_one_that_fails_stops_its_agent_with_the_place(self, here: Here, folder: Path) -> None:
        self.write(folder, "class Stand:\n    def execute(self, context):\n        1 / 0\n")
        done = here("run", "good.aseme", "--activities", "skills", "--for", "5s")
        assert done.code == 1
        assert "Traceback" not in done.err
        assert "one (robot) failed:" in done.err
        assert "ZeroDivisionError" in done.err
        assert "one  crash: Stand: ZeroDivisionError: division by zero (stand.py:3)" in done.err

    @pytest.mark.parametrize(
        ("text", "words"),
        [
            ("class Stand", "error[E546]: this is not Python"),
            (
                "import nothing_of_that_name\nclass Stand:\n    def execute(self, context): return 1\n",
                "ModuleNotFoundError",
            ),
            ("class Sit: pass", "stand.py:1:1: error[E546]: the code of the activity `Stand` has no class"),
        ],
    )
    def test_one_that_cannot_be_loaded(self, here: Here, folder: Path, text: str, words: str) -> None:
        self.write(folder, text)
        done = here("run", "good.aseme", "--activities", "skills")
        assert done.code == 1
        assert words in done.err
        assert "Traceback" not in done.err


class TestProjects:
    def test_it_is_played_as_it_says(self, here: Here, project: Path) -> None:
        done = here("run", ".")
        assert done.code == 0, done.err
        lines = done.out.splitlines()
        assert "whistle at 1 s" in lines
        assert "whistle at 2 s" in lines
        assert "the court of seed 9 is closed" in lines
        assert "stopped after 2 s (virtual, seed 9): the world is over" in lines
        assert "one  Stand" not in done.out
        assert (project / "made/trace.jsonl.gz").exists()

    def test_from_anywhere(
        self,
        here: Here,
        project: Path,
        tmp_path_factory: pytest.TempPathFactory,
        monkeypatch: pytest.MonkeyPatch,
    ) -> None:
        elsewhere = tmp_path_factory.mktemp("elsewhere")
        monkeypatch.chdir(elsewhere)
        done = here("run", project)
        assert done.code == 0, done.err
        assert "whistle at 2 s" in done.out
        assert not list(elsewhere.iterdir())

    def test_the_command_line_goes_first(self, here: Here, project: Path) -> None:
        done = here("run", ".", "--for", "1s", "--seed", "3", "--trace", "mine.jsonl", "-o", "out")
        assert "stopped after 1 s (virtual, seed 3): time limit reached" in done.out
        assert Path("mine.jsonl").exists()
        assert Path("out/monas").exists()

    def test_another_file_of_the_folder_is_not_the_project(self, here: Here, project: Path) -> None:
        (project / "other.aseme").write_text(
            GOOD.replace("Walker", "Runner").replace("takes 1s", "takes 1s simulated")
        )
        done = here("run", "other.aseme", "-o", "out", "--for", "1s")
        assert "whistle" not in done.out
        assert "one  Stand" in done.out

    @pytest.mark.parametrize(
        ("function", "words"),
        [
            ("world:broken", "broken failed: RuntimeError: no court today"),
            ("world:nothing", "no function nothing in module world"),
            ("nowhere:court", "no function court in module nowhere"),
            ("faulty:court", "faulty cannot be imported: SyntaxError"),
            (
                "wrong:empty",
                "wrong:empty gave {}, which is not a world: it needs bodies, the bodies by the names of the"
                " agents; step_ns, how long one step of it lasts, in whole ns; now_ns, how far it has been"
                " simulated, in whole ns; advance, a method that is given the time up to which to simulate,"
                " in ns\n",
            ),
            ("wrong:none", "wrong:none gave None, which is not a world: it needs bodies,"),
            ("wrong:late", "a Late, which is not a world: it needs now_ns, how far it has been simulated"),
            ("wrong:deaf", "a Deaf, which is not a world: it needs advance, a method that is given the time"),
            ("wrong:still", "the world stands still: after advance(100000000) its now_ns is 0, and its step"),
            ("wrong:raising", "advance failed: ZeroDivisionError: division by zero ({folder}/wrong.py:17)"),
        ],
    )
    def test_a_world_that_cannot_be_made(self, here: Here, project: Path, function: str, words: str) -> None:
        (project / "faulty.py").write_text("def court(:\n")
        (project / "wrong.py").write_text(WRONG)
        words = words.replace("{folder}", str(project))
        done = here("run", ".", "--world", function)
        assert done.code == 1
        assert words in done.err
        assert "Traceback" not in done.err

    def test_bodies_without_a_world(self, here: Here, project: Path) -> None:
        done = here("run", ".", "--body", "one=world:body", "--for", "1s")
        assert done.code == 0, done.err
        done = here("run", ".", "--body", "three=world:body", "--for", "1s")
        assert done.code == 1
        assert "error[E032]: there is no agent `three` for a body\n   hint: there are one, two" in done.err

    def test_several_systems_and_no_choice(self, here: Here, project: Path) -> None:
        (project / "other.aseme").write_text(GOOD.replace("Walker", "Runner"))
        (project / "bad.aseme").unlink()
        (project / "pyproject.toml").write_text("[tool.asemec.run]\nseed = 1\n")
        done = here("run", ".")
        assert done.code == 2
        assert "contains 2 systems (good.aseme, other.aseme)" in done.err


def test_ctrl_c_ends_a_run_with_its_trace_whole(folder: Path) -> None:
    process = subprocess.Popen(
        command("run", "good.aseme", "--for", "1000000min"),
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None
    while "Stand" not in process.stdout.readline():
        assert process.poll() is None
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert ": interrupted" in out
    assert "Traceback" not in err
    assert trace(folder / "out/trace.jsonl.gz")[-1]["reason"] == "interrupted"


def test_what_is_built_within_the_second_of_the_build_before_is_what_runs(here: Here, folder: Path) -> None:
    """Python knows a module that it has compiled by the second and the size."""
    plan = folder / "out/monas/Walker/robot/plan.py"
    said = []
    for text in (GOOD, GOOD.replace("Stand takes 1s", "Stand takes 9s")):
        (folder / "good.aseme").write_text(text)
        assert here("build", "good.aseme").code == 0
        os.utime(plan, (1_000_000_000, 1_000_000_000))
        arguments = ("run", "out", "--verbose", "--for", "8s")
        said.append(asemec(*arguments, cwd=folder, PYTHONDONTWRITEBYTECODE="", PYTHONPYCACHEPREFIX="").out)
    assert [text.count("one  Stand\n") for text in said] == [9, 1]


def test_real_time(here: Here, folder: Path) -> None:
    done = here("run", "good.aseme", "--real", "--for", "50ms")
    assert done.code == 0, done.err
    assert "time limit reached" in done.out
    assert trace(Path("out/trace.jsonl.gz"))[0]["clock"] == "real"


def test_a_trace_that_cannot_be_written(here: Here, folder: Path) -> None:
    done = here("run", "good.aseme", "--trace", "good.aseme/trace.jsonl", "--for", "1s")
    assert done.code == 1
    assert "cannot be written" in done.err
    assert (folder / "good.aseme").read_text() == GOOD


def test_activities_and_functions_come_from_nowhere_else(folder: Path) -> None:
    """What a run has imported is gone from `sys.path` afterwards."""
    program = (
        "import sys; from aseme_dsl.cli import main; before = list(sys.path);"
        "code = main(['run', 'good.aseme', '--for', '1s', '--quiet']); print(code, sys.path == before)"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, cwd=folder, env=os.environ
    )
    assert done.stdout.splitlines()[-1] == "0 True"


def test_processes_need_zenoh_and_it_is_said_how_to_get_it(tmp_path: Path) -> None:
    (tmp_path / "zenoh.py").write_text("raise ImportError\n")
    (tmp_path / "walk.aseme").write_text(GOOD)
    paths = {"PYTHONPATH": os.pathsep.join([str(tmp_path), *sys.path])}
    for words in (("run", "walk.aseme", "--process-per-agent"), ("node", "one", "walk.aseme")):
        done = asemec(*words, cwd=tmp_path, **paths)
        assert done.code == 1
        assert 'pip install "aseme-dsl[zenoh]"' in done.err and "Traceback" not in done.err


def test_a_robot_that_the_team_does_not_have(here: Here, folder: Path) -> None:
    done = here("node", "onne", "good.aseme")
    assert done.code == 2
    assert "good.aseme: error[E032]: there is no robot `onne`" in done.err
    assert "hint: did you mean `one`? there are one, two" in done.err


STUCK = """\
system Stuck
message Go { int n }
topic t { signal Go }
srm r {
  liveness { r = A . B }
  activities { A takes 1s  B takes 1s }
  control r {
    enter B : [has(t.signal.Go)]
  }
}
"""


class TestTheEnd:
    """What a run leaves open is said, and an agent that waits for ever is a failure (U2)."""

    @pytest.fixture(autouse=True)
    def _file(self, folder: Path) -> None:
        (folder / "stuck.aseme").write_text(STUCK)

    def test_an_agent_that_waits_for_ever_is_named_and_the_code_is_1(self, here: Here) -> None:
        done = here("run", "stuck.aseme", "--quiet")
        assert done.code == 1
        assert "idle since 1 s: r waits for input from outside" in done.out
        assert "deadlock" not in done.out
        assert "r (r) waits after A (stuck.aseme:5) for [has(t.signal.Go)] (stuck.aseme:8)" in done.out

    def test_it_may_be_allowed(self, here: Here) -> None:
        done = here("run", "stuck.aseme", "--quiet", "--allow", "waiting")
        assert done.code == 0
        assert "idle since 1 s" in done.out

    def test_what_no_input_can_end_is_a_deadlock(self, here: Here, folder: Path) -> None:
        text = STUCK.replace("liveness", "var n : int = 0  liveness").replace("has(t.signal.Go)", "n > 0")
        (folder / "locked.aseme").write_text(text)
        done = here("run", "locked.aseme", "--quiet")
        assert done.code == 1
        assert "deadlock since 1 s: no input, timer or activity is pending that could wake r" in done.out

    def test_as_json(self, here: Here) -> None:
        done = here("run", "stuck.aseme", "--json")
        result = done.json["result"]
        assert done.code == 1
        assert (result["stuck"], result["idle"], result["idle_since"]) == (["r"], ["r"], 1_000_000_000)
        assert result["agents"][0]["waits"][0]["awaits"][0]["what"] == "[has(t.signal.Go)]"

    def test_the_end_of_the_time_is_no_deadlock(self, here: Here) -> None:
        done = here("run", "stuck.aseme", "--quiet", "--for", "500ms")
        assert done.code == 0
        assert "deadlock" not in done.out
        assert "waits" not in done.out

    @pytest.mark.parametrize("options", [(), ("--real",)], ids=["virtual", "real"])
    def test_a_region_that_waits_beside_one_that_runs_is_named(
        self, here: Here, folder: Path, options: tuple[str, ...]
    ) -> None:
        text = STUCK.replace("r = A . B", "r = (A . B) || Lie~").replace(
            "B takes", "Lie takes 60min  B takes"
        )
        (folder / "dog.aseme").write_text(text.replace("A takes 1s", "A takes 1ms"))
        done = here("run", "dog.aseme", "--quiet", "--for", "1s", *options)
        assert done.code == 0  # the agent has something to do
        (line,) = (line for line in done.out.splitlines() if "waits" in line)
        what, _, since = line.rpartition(", since ")
        assert what == "  r (r) waits after A (dog.aseme:5) for [has(t.signal.Go)] (dog.aseme:8)"
        assert re.fullmatch(r"0\.\d+ s", since)

    @pytest.mark.parametrize("control", ["enter B : after(1min)", "repeat (A . B) every 1min :"])
    def test_one_that_waits_for_a_time_beside_one_that_runs_is_not(
        self, here: Here, folder: Path, control: str
    ) -> None:
        text = STUCK.replace("r = A . B", "r = (A . B)~ || Lie~").replace(
            "B takes", "Lie takes 60min  B takes"
        )
        (folder / "dog.aseme").write_text(text.replace("enter B : [has(t.signal.Go)]", control))
        done = here("run", "dog.aseme", "--quiet", "--for", "10s")
        assert (done.code, "waits" in done.out) == (0, False)

    def test_faults_are_listed_once_of_each_kind(self, here: Here, folder: Path) -> None:
        text = (
            STUCK.replace("signal Go }", "signal Go  state Go }")
            .replace("A . B", "(A . B)+")
            .replace("enter B : [has(t.signal.Go)]", "enter B : / t.signal.Go.n = t.state.Go.n")
            .replace("  }\n}", "    repeat (A . B) : [true]\n  }\n}")
        )
        (folder / "faulty.aseme").write_text(text)
        done = here("run", "faulty.aseme", "--quiet", "--for", "10s")
        lines = done.out.splitlines()
        first = next(number for number, line in enumerate(lines) if "faults; the first of each kind:" in line)
        assert re.fullmatch(r"\s+\d+ times, first by r at 1 s: .* \(faulty.aseme:8\)", lines[first + 1])


def test_a_compressed_trace_is_written_over_and_another_file_is_not(here: Here, folder: Path) -> None:
    words = ("run", "good.aseme", "-o", "out", "--for", "1s", "--allow", "waiting", "-q")
    for _ in range(2):
        assert here(*words, "--trace", "again.jsonl.gz").code == 0
    (folder / "mine.jsonl.gz").write_bytes(gzip.compress(b"my notes"))
    done = here(*words, "--trace", "mine.jsonl.gz")
    assert (done.code, "is not a trace that asemec wrote" in done.err) == (2, True), done.err
