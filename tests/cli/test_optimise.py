"""`asemec optimise`: how many agents are worth it, which settings are best, and what slows them."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import time
from pathlib import Path

import pytest

from aseme_dsl.project.files.write import Written
from tests.cli.support import Done, Here, asemec, command
from tests.support.worded import worded

FEED = """\
system Feed

message Want { int place }
message Part { int number }

aip feed {
  participant carrier [1..*] {
    engage   "Its hands are empty."
    sends    request Want
    receives agree Part
    process  = Come . Wait . Carry
  }
  participant press {
    engage   "A carrier wants a part."
    sends    agree Part
    receives request Want
    process  = Press
  }
  outcome "A part has been carried away."
  control carrier {
    enter Wait  : / send request Want to press
    enter Carry : agree Part from press
  }
  control press {
    enter Press : request Want from carrier
    leave Press : / send agree Part to carrier
  }
}

srm robot {
  plays feed.carrier
  liveness { robot = carrier~ }
  activities { Come takes 1s  Wait takes 1ms  Carry takes 3s }
}
srm machine {
  plays feed.press
  liveness { machine = press~ }
  activities { Press takes 1s }
}

team Feed {
  maker         : machine
  carrier[1..4] : robot
}
"""
"""A press that makes a part a second, and carriers that are away with one for four."""

TRIPS = """\
system Trips
srm walker {
  var trips : int = 2
  var done  : int = 0
  liveness { walker = Rest . Walk+ }
  activities { Rest takes 1s  Walk takes 2s }
  control walker {
    enter  Walk : / done = done + 1
    repeat Walk : [done < trips] / done = done + 1
    leave  Walk : else
  }
}
team Trips { one : walker  others[1..2] : walker with trips = 1 }
"""


@pytest.fixture
def feed(tmp_path: Path) -> Path:
    path = tmp_path / "feed.aseme"
    path.write_text(FEED, "utf-8")
    return path


@pytest.fixture
def trips(tmp_path: Path) -> Path:
    path = tmp_path / "trips.aseme"
    path.write_text(TRIPS, "utf-8")
    return path


def test_as_many_carriers_are_worth_it_as_keep_the_press_busy(here: Here, feed: Path) -> None:
    done = here(
        *("optimise", feed, "--vary", "carrier=4..7", "--measure", "Carry", "--runs", "1", "--for", "2min"),
        *("-o", feed.parent / "found"),
    )
    assert done.code == 0, done.err
    assert "**Worth it: 5 carrier.** Going on to 6 gains +0.0 %" in done.out
    assert "**The bottleneck is Press.**" in done.out
    files = sorted(path.name for path in (feed.parent / "found").iterdir())
    assert files == ["bottleneck.svg", "measure.svg", "report.json", "report.md"]
    assert (feed.parent / "found" / "report.md").read_text("utf-8") in done.out


def test_a_study_is_the_same_in_one_process_and_in_two(here: Here, feed: Path) -> None:
    texts = []
    for start, jobs in ((here, "1"), (asemec, "2")):
        out = feed.parent / jobs
        arguments = ("--vary", "carrier=2,3", "--measure", "Carry", "--runs", "2", "--for", "20s", "-q")
        done = start("optimise", feed, *arguments, "-j", jobs, "-o", out)
        assert done.code == 0, done.err
        texts.append([path.read_bytes() for path in sorted(out.iterdir())])
    assert texts[0] == texts[1]


def test_nothing_is_left_among_the_files_of_the_user(here: Here, feed: Path) -> None:
    done = here("optimise", feed, "--measure", "Carry", "--runs", "1", "--for", "5s", "-o", feed.parent / "o")
    assert done.code == 0, done.err
    assert sorted(path.name for path in feed.parent.iterdir()) == ["feed.aseme", "o"]


def test_settings_are_varied_and_less_time_is_better(here: Here, trips: Path) -> None:
    done = here(
        *("optimise", trips, "--vary", "one.trips=3,2,5", "--measure", "time", "--runs", "2", "-j", "1"),
        *("--json", "-o", trips.parent / "found"),
    )
    assert done.code == 0, done.err
    result = done.json["result"]
    assert [row["measure"]["mean"] for row in result["rows"]] == [7.0, 5.0, 11.0]
    assert result["chosen"] == {"one.trips": "2"}
    assert [gain["activity"] for gain in result["quicker"]["gains"]] == ["Walk", "Rest"]


def test_a_setting_of_a_role_is_for_all_agents_that_a_size_gives(here: Here, trips: Path) -> None:
    done = here(
        *("optimise", trips, "--vary", "walker.trips=4", "--vary", "others=3", "--measure", "Walk"),
        *("--runs", "1", "--for", "9s", "--json", "-o", trips.parent / "found"),
    )
    assert done.code == 0, done.err
    (run,) = [run for run in done.json["result"]["runs"] if run["quicker"] is None]
    assert run["agents"] == 4
    assert run["done"] == {"Rest": 4, "Walk": 16}


def test_what_does_not_finish_takes_at_least_the_time_that_it_had(here: Here, trips: Path) -> None:
    done = here(
        *("optimise", trips, "--vary", "one.trips=1,9", "--measure", "time", "--runs", "1", "--for", "8s"),
        *("--quicker", "1", "-o", trips.parent / "found"),
    )
    assert done.code == 0, done.err
    assert (
        "- 1 of 1 run of one.trips = 9 had not finished: it counts as 8 s, and would take longer." in done.out
    )
    assert re.search(r"\| 9 +\| ≥ 8 .*\| 0 of 1", done.out) and re.search(r"\| 1 +\| 3 .*\| 1 of 1", done.out)
    assert "**Best: one.trips = 1** with 3." in done.out


def test_a_function_of_the_project_measures_its_world(
    here: Here, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "trips.aseme").write_text(TRIPS, "utf-8")
    (tmp_path / "place.py").write_text(
        "class Place:\n"
        "    bodies, step_ns, now_ns = {}, 10**8, 0\n"
        "    def advance(self, until_ns):\n"
        "        self.now_ns = until_ns // self.step_ns * self.step_ns\n"
        "def make(seed):\n"
        "    place = Place()\n"
        "    place.seed = seed\n"
        "    return place\n"
        "def measure(world):\n"
        "    return world.seed * 10\n"
        "def word(world):\n"
        "    return 'much'\n"
        "def endless(world):\n"
        "    return float('inf')\n"
        "def long(world):\n"
        "    return 10**400\n"
        "def odd(world):\n"
        "    import decimal\n"
        "    return decimal.Decimal('nan')\n"
        "def nothing(world):\n"
        "    return None\n",
        "utf-8",
    )
    base = ("optimise", "trips.aseme", "--runs", "3", "--for", "1s", "--quicker", "1", "--json", "-j", "1")
    done = here(*base, "--world", "place:make", "--measure", "place:measure")
    assert done.code == 0, done.err
    assert done.json["result"]["rows"][0]["measure"]["mean"] == 20
    for name, value in (
        ("word", "'much'"),
        ("endless", "inf"),
        ("long", "10000000"),
        ("odd", "Decimal('NaN')"),
    ):
        wrong = here(*base, "--world", "place:make", "--measure", f"place:{name}")
        assert wrong.code == 1
        assert f"place:{name} gave {value}" in wrong.err and "which is not a number" in wrong.err
    none = here(*base, "--world", "place:make", "--measure", "place:nothing")
    assert none.code == 1 and none.json["result"]["rows"][0]["measure"] is None


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (
            ["--vary", "carier=1..3", "--measure", "Carry"],
            "no range of the team called carier; did you mean carrier?",
        ),
        (
            ["--vary", "maker=1..3", "--measure", "Carry"],
            "maker is one agent of the team and no range: write `maker[1..2] : machine`.\n",
        ),
        (
            ["--vary", "maker.speed=1", "--measure", "Carry"],
            "no variable of machine called speed; there is none.\n",
        ),
        (
            ["--vary", "make.speed=1", "--measure", "Carry"],
            "no agent, range or role of the team called make; did you mean maker?",
        ),
        (["--measure", "Cary"], "no agent of the team does Cary; did you mean Carry?\n"),
    ],
)
def test_what_is_not_there_is_said_before_anything_is_played(
    here: Here, feed: Path, arguments: list[str], text: str
) -> None:
    done = here("optimise", feed, *arguments)
    assert done.code == 1
    assert text in done.err
    assert done.out == ""


@pytest.mark.parametrize(
    ("vary", "text"),
    [
        ("carrier", "is not written carrier=1..8"),
        ("carrier=8..1", "8..1 is not a range"),
        ("carrier=1..1000000", "1..1000000 are more than 1000 values, which is the most"),
        ("carrier=0..2", "a number from 1 on"),
        ("carrier=1-3", "or a range as 1..8"),
        ("carrier=1,1", "has the value 1 twice"),
        ("carrier=1,,2", "lacks a value"),
        ("a.b.c=1", "is not written"),
    ],
)
def test_a_knob_that_is_written_wrongly_is_wrong_use(here: Here, feed: Path, vary: str, text: str) -> None:
    done = here("optimise", feed, "--vary", vary, "--measure", "Carry")
    assert done.code == 2
    assert text in done.err


def test_without_a_measure_it_says_what_may_be_measured(here: Here, feed: Path) -> None:
    done = here("optimise", feed)
    assert done.code == 2 and "Missing option '--measure'" in done.err
    assert re.search(r"per minute\): .*Carry", done.err) and "MODULE:FUNCTION" in done.err
    assert "\n  time (seconds" in done.err


def test_a_value_of_another_type_is_refused(here: Here, trips: Path) -> None:
    done = here("optimise", trips, "--vary", "one.trips=many", "--measure", "Walk")
    assert done.code == 1
    assert "'many' is not of the type int, which trips of walker is" in done.err


def test_where_the_report_cannot_go_nothing_is_played(
    here: Here, feed: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("aseme_dsl.project.studying.study.run", None)
    (feed.parent / "file").write_text("mine", "utf-8")
    for folder, why in (
        ("file", "it is a file"),
        ("file/of/it", "there is a file where its folder should be"),
    ):
        done = here("optimise", feed, "--measure", "Carry", "-j", "1", "-o", feed.parent / folder)
        assert done.code == 1 and done.out == ""
        assert f"error[E009]: {feed.parent / folder} cannot be written: {why}" in done.err
    done = here("optimise", feed, "--measure", "Carry", "-j", "1", "-o", "/proc/of/it")
    assert done.code == 1 and done.out == "" and "error[E009]: /proc/of" in done.err
    (feed.parent / "some" / "bottleneck.svg").mkdir(parents=True)
    done = here("optimise", feed, "--measure", "Carry", "-j", "1", "-o", feed.parent / "some")
    assert done.code == 1 and done.out == "" and "bottleneck.svg is a folder" in done.err
    (feed.parent / "mine").mkdir()
    (feed.parent / "mine" / "report.md").write_text("# Mine\n", "utf-8")
    done = here("optimise", feed, "--measure", "Carry", "-j", "1", "-o", feed.parent / "mine")
    assert done.code == 2 and done.out == "" and "report.md is there already, and is not" in done.err


def test_a_report_that_cannot_be_left_is_printed(
    here: Here, feed: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = feed.parent / "found"
    problem = worded("E009", "the disk is full", None, path=str(out))
    written = Written(diagnostics=(problem,))
    monkeypatch.setattr("aseme_dsl.project.files.write.write_file", lambda *_: written)
    base = ("optimise", feed, "--measure", "Carry", "--runs", "1", "--for", "5s", "-o", out)
    done = here(*base)
    assert done.code == 1
    assert "| Carry per minute |" in done.out
    assert "the disk is full" in done.err
    told = here(*base, "--json")
    assert told.code == 1 and told.json["diagnostics"][0]["code"] == "E009"
    assert told.json["result"]["rows"][0]["measure"]["runs"] == 1


def test_activities_that_gain_the_same_are_named_together_and_one_run_has_no_interval(
    here: Here, feed: Path
) -> None:
    done = here(
        *("optimise", feed, "--vary", "carrier=1,2", "--measure", "Carry", "--runs", "1", "--for", "10s"),
        *("-o", feed.parent / "found"),
    )
    assert "**The bottleneck is Carry, Come or Press**: these runs do not tell which." in done.out
    assert "1 run of each, seed 1, 10 s of virtual time. One run has no interval" in done.out
    assert "95 % (boot" not in done.out and "all the same" not in done.out
    data = json.loads((feed.parent / "found" / "report.json").read_text("utf-8"))
    assert data["quicker"]["bottleneck"] == ["Carry", "Come", "Press"]


def test_what_was_not_tried_may_be_the_bottleneck(here: Here, trips: Path) -> None:
    base = ("optimise", trips, "--runs", "2", "--for", "9s", "-j", "1", "-o", trips.parent / "found")
    trips.write_text(TRIPS.replace("Rest takes 1s", ""), "utf-8")
    done = here(*base, "--measure", "time")
    assert "**Of the 1 that could be tried, the bottleneck is Walk.**" in done.out
    why = "for how long they last is said by their code or the world, and not by a `takes`"
    nobody = "for they have neither code nor a `takes`, and how long they last is made up"
    assert f"Not tried, {nobody}: Rest." in done.out
    assert "- In each run: activity Rest has neither code nor `takes`: it lasts 0.1 s." in done.out
    (trips.parent / "code").mkdir()
    (trips.parent / "code" / "rest.py").write_text(
        "class Rest:\n    def execute(self, context):\n        context.wait(1.0)\n", "utf-8"
    )
    trips.write_text(trips.read_text("utf-8").replace("Walk takes 2s", "Walk takes 2s simulated"), "utf-8")
    coded = here(*base, "--measure", "time", "--activities", trips.parent / "code")
    assert f"Not tried, {why}: Rest." in coded.out and "lasts" not in coded.out.replace(why, "")
    trips.write_text(
        "system Loops\nsrm robot {\n  liveness { robot = Rest~ || Walk~ }\n  activities { Walk takes 2s }\n"
        "}\nteam Loops { one : robot }\n",
        "utf-8",
    )
    other = here(*base, "--measure", "Rest")
    assert "None of the 1 that could be tried is a bottleneck" in other.out


def test_if_nothing_was_measured_nothing_is_concluded(here: Here, feed: Path) -> None:
    base = ("optimise", feed, "--vary", "carrier=1,2", "--runs", "2", "-j", "1", "-o", feed.parent / "found")
    assert here(*base, "--measure", "Carry", "--for", "10s").code == 0
    assert {path.suffix for path in (feed.parent / "found").iterdir()} == {".md", ".json", ".svg"}
    done = here(*base, "--measure", "time", "--for", "5s")
    assert done.code == 1, done.err
    assert "**Nothing was measured:** within 5 s no run finished." in done.out
    assert "Every seed gave the same" not in done.out and "times as quick" not in done.out
    left = sorted(path.name for path in (feed.parent / "found").iterdir())
    assert left == ["report.json", "report.md"]  # and no plot, nor that of another question


STARTING = """\
import pathlib, sys, time
if any("spawn_main" in item for item in sys.orig_argv):
    pathlib.Path("starting").touch()
    time.sleep(1)
"""
"""What each process does first: that of a worker says that it starts, and takes its time."""


def test_ctrl_c_while_the_workers_start_is_told_once(feed: Path) -> None:
    (feed.parent / "site").mkdir()
    (feed.parent / "site" / "sitecustomize.py").write_text(STARTING, "utf-8")
    path = os.pathsep.join([str(feed.parent / "site"), os.environ.get("PYTHONPATH", "")])
    process = subprocess.Popen(
        command("optimise", feed, "--measure", "Carry", "--runs", "20", "--for", "20min", "-j", "2"),
        cwd=feed.parent,
        env={**os.environ, "PYTHONPATH": path},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        start_new_session=True,
    )
    try:
        while not (feed.parent / "starting").exists():
            assert process.poll() is None
            time.sleep(0.01)
        os.killpg(process.pid, signal.SIGINT)
        said, _ = process.communicate(timeout=300)
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
    assert (process.returncode, said.strip()) == (130, "asemec: stopped")


def test_a_run_of_no_time_is_refused(here: Here, feed: Path) -> None:
    done = here("optimise", feed, "--measure", "Carry", "--for", "0s")
    assert done.code == 2
    assert "must be greater than zero" in done.err


def test_what_an_agent_does_several_times_at_once_is_counted_as_often(here: Here, trips: Path) -> None:
    trips.write_text(
        "system Loads\nsrm porter {\n  liveness { porter = Carry || Lift || Lift }\n"
        "  activities { Carry takes 1s  Lift takes 1s }\n}\nteam Loads { one : porter }\n",
        "utf-8",
    )
    done = here("optimise", trips, "--measure", "time", "--runs", "1", "-o", trips.parent / "found")
    assert "Lift 200 %, Carry 100 %" in done.out
    assert "What an agent does several times at once is counted as often" in done.out


FALLING = """\
system Falling
srm robot {
  var haste  : double = 0.0
  var chance : double = 0.0
  liveness { robot = (Look . (Go | Fall))~ }
  activities { Look takes 1s simulated  Go takes 1s simulated  Fall }
  control robot {
    enter Look : / chance = random()
    enter Fall : [chance < haste]
    enter Go   : else
  }
}
team Falling { r[1..2] : robot }
"""
"""The more haste, the sooner a robot is down for good, which is when its code of `Fall` raises."""


@pytest.fixture
def falling(tmp_path: Path) -> Path:
    path = tmp_path / "falling.aseme"
    path.write_text(FALLING, "utf-8")
    (tmp_path / "code").mkdir()
    (tmp_path / "code" / "fall.py").write_text(
        "class Fall:\n    def execute(self, context):\n        raise RuntimeError('fell')\n", "utf-8"
    )
    return path


@pytest.mark.long
def test_a_team_that_breaks_down_is_not_the_better_for_having_ended(here: Here, falling: Path) -> None:
    base = ("optimise", falling, "--activities", falling.parent / "code", "--quicker", "1", "-j", "1")
    base = (*base, "--vary", "robot.haste=0,0.5,1", "--runs", "3", "-o", falling.parent / "found")
    done = here(*base, "--measure", "Look", "--for", "20s", "--json")
    result = done.json["result"]
    assert [result["rows"][place]["measure"]["mean"] for place in (0, 2)] == [60, 6]
    assert result["rows"][1]["measure"]["mean"] < 30
    assert result["chosen"] == {"robot.haste": "0"}
    assert [row["failed"] for row in result["rows"]] == [0, 3, 3]
    told = here(*base, "--measure", "Look", "--for", "5s")
    assert "- An agent failed in 3 of 3 runs of robot.haste = 1: r1: activity Fall of state" in told.out
    timed = here(*base, "--measure", "time", "--for", "5s")
    assert re.search(r"\| 1 +\| – +\| – +\| 0 of 3", timed.out)
    assert "Such a run has no time." in timed.out


def test_a_team_that_waits_for_ever_has_not_been_quick(here: Here, tmp_path: Path) -> None:
    (tmp_path / "wait.aseme").write_text(
        "system Waiting\nmessage Seen { bool ball }\ntopic eyes { state Seen }\n"
        "srm robot {\n  liveness { robot = Look . Go }\n  activities { Look takes 1s  Go takes 1s }\n"
        "  control robot { enter Go : [eyes.state.Seen.ball] }\n}\nteam Waiting { one : robot }\n",
        "utf-8",
    )
    done = here(
        *(
            "optimise",
            tmp_path / "wait.aseme",
            "--measure",
            "Look",
            "--runs",
            "1",
            "--quicker",
            "1",
            "--json",
        ),
        *("-o", tmp_path / "found"),
    )
    (run,) = done.json["result"]["runs"]
    assert (run["done"], run["measure"]) == ({"Look": 1}, 1)


def test_reasons_that_are_not_those_of_all_runs_say_of_how_many(here: Here, falling: Path) -> None:
    done = here(
        *("optimise", falling, "--activities", falling.parent / "code", "--quicker", "1", "-j", "1"),
        *("--vary", "robot.haste=0.1", "--runs", "6", "--measure", "Look", "--for", "20s"),
        *("-o", falling.parent / "found"),
    )
    (line,) = re.findall(r"- An agent failed in . of 6 runs of robot.haste = 0.1: (.*)", done.out)
    assert len(re.findall(r"r[12]: .*?\((\d) runs?\)", line)) >= 1


STUCK = """\
system Stuck
srm robot {
  var haste  : double = 0.0
  var chance : double = 0.0
  liveness { robot = Draw . (Slow | (Fast . (Wait | Home))) }
  activities { Draw takes 1s  Slow takes 10s  Fast takes 1s  Wait takes 1000s  Home takes 1s }
  control robot {
    enter (Slow | (Fast . (Wait | Home))) : / chance = random()
    enter Slow : [haste == 0]
    enter (Fast . (Wait | Home)) : else
    enter Wait : [chance < haste]
    enter Home : else
  }
}
team Stuck { one : robot }
"""
"""With haste it is either much quicker, or does not get home at all."""


@pytest.mark.long
def test_the_few_that_finish_do_not_speak_for_all(here: Here, tmp_path: Path) -> None:
    (tmp_path / "stuck.aseme").write_text(STUCK, "utf-8")
    done = here(
        *("optimise", tmp_path / "stuck.aseme", "--vary", "robot.haste=0,0.8", "--measure", "time"),
        *("--runs", "10", "--quicker", "1", "-j", "1", "-o", tmp_path / "found"),
    )
    assert "**Best: robot.haste = 0** with 11." in done.out
    (known,) = re.findall(r"\| 0\.8 +\| ≥ [\d.]+ .*\| +(\d+) of 10 +\|", done.out)
    assert 0 < int(known) < 5
    assert (
        f"- {10 - int(known)} of 10 runs of robot.haste = 0.8 had not finished: they count as 60 s each"
        in done.out
    )


LIFT = """\
system Lift
message Go { int n }
aip lift {
  participant boss {
    engage "A beam lies there."
    sends request Go
    receives agree Go
    process = Ask . Note
  }
  participant lifter [2..8] {
    engage "Hands are empty."
    sends agree Go
    receives request Go
    process = Heave
  }
  outcome "The beam is up."
  control boss {
    enter Ask  : / send request Go to lifter
    enter Note : agree Go from lifter or after(10s)
  }
  control lifter {
    enter Heave : request Go from boss
    leave Heave : / send agree Go to boss
  }
}
srm chief { plays lift.boss liveness { chief = boss~ } activities { Ask takes 1s  Note takes 1s } }
srm hand { plays lift.lifter liveness { hand = lifter~ } activities { Heave takes 2s } }
team Site { chief : chief  worker[2..3] : hand }
"""
"""A beam that one alone does not lift."""


def test_from_nothing_to_something_is_worth_it(here: Here, tmp_path: Path) -> None:
    (tmp_path / "lift.aseme").write_text(LIFT, "utf-8")
    done = here(
        *("optimise", tmp_path / "lift.aseme", "--vary", "worker=3,1,2", "--measure", "Heave", "--runs", "2"),
        *("--quicker", "1", "-j", "1", "-o", tmp_path / "found"),
    )
    assert re.search(r"\| 2 .*\| \+40 from 0 +\|", done.out)
    assert "**Worth it: 3 worker**, and perhaps more" in done.out  # the sizes are compared upwards
    assert "- In 2 of 2 runs of worker = 1: request Go is not sent: lift takes 2 or more lifter" in done.out
    assert "- Every seed gave the same: these runs show no random effect." in done.out


WORK = """\
system Work
srm robot {
  var speed : double = 1.0
  liveness { robot = Work~ }
  activities { Work takes 1s  reads speed }
}
team Work { r[1..6] : robot }
"""
HALL = """\
import random
from decimal import Decimal
from fractions import Fraction
class Body:
    payload_limit = 0
    speed = 0
    def sense(self): return 0
    def act(self, command): self.speed = command
    def say(self, payload): return False
    def hear(self): return []
class Hall:
    step_ns = 100_000_000
    now_ns = 0
    def __init__(self, seed):
        self.seed = seed
        self.bodies = {f"r{number}": Body() for number in range(1, 7)}
    def advance(self, until): self.now_ns = until
make = Hall
def luck(hall): return 50 + random.Random(hall.seed).gauss(0, 10)
def paired(hall): return luck(hall) + sum(body.speed for body in hall.bodies.values())
def unpaired(hall): return random.Random(f"{hall.seed} {hall.bodies['r1'].speed}").random()
def pairs(hall): return 10 + 10 * (sum(body.speed > 0 for body in hall.bodies.values()) // 2)
CALLS = []
def calls(hall):
    CALLS.append(hall)
    return len(CALLS)
def fraction(hall): return Fraction(5, 2)
def decimal(hall): return Decimal("2.5")
def truth(hall): return True
def few(hall): return None if hall.seed == 1 and hall.bodies["r1"].speed == 2 else 3 * hall.bodies["r1"].speed
"""


@pytest.fixture
def work(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A project whose world knows how quick each robot is."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "work.aseme").write_text(WORK, "utf-8")
    (tmp_path / "hall.py").write_text(HALL, "utf-8")
    (tmp_path / "code").mkdir()
    (tmp_path / "code" / "work.py").write_text(
        "class Work:\n"
        "    def execute(self, context):\n"
        "        context.body.act(context.get_variable('speed'))\n"
        "        context.wait(1.0)\n",
        "utf-8",
    )
    (tmp_path / "pyproject.toml").write_text(
        '[tool.asemec]\nactivities = "code"\n[tool.asemec.run]\nworld = "hall:make"\n', "utf-8"
    )
    return tmp_path


def studied(here: Here, *arguments: str, runs: int = 5, jobs: int = 1) -> Done:
    base = ("optimise", "work.aseme", "--for", "2s", "--quicker", "1", "--runs", str(runs), "-j", str(jobs))
    return here(*base, *arguments)


@pytest.mark.long
def test_what_differs_with_each_seed_is_told_from_the_best_however_much_seeds_differ(
    here: Here, work: Path
) -> None:
    done = studied(here, "--vary", "robot.speed=1,1.5,2", "--measure", "hall:paired")
    assert "**Best: robot.speed = 2** with" in done.out and "Not to be told" not in done.out
    other = studied(here, "--vary", "robot.speed=1,1.5,2", "--measure", "hall:unpaired")
    assert re.search(r"Not to be told from it by these runs: robot.speed = .*; robot.speed = ", other.out)


@pytest.mark.long
def test_a_plateau_is_not_taken_for_the_end(here: Here, work: Path) -> None:
    done = studied(here, "--vary", "r=1..6", "--measure", "hall:pairs", runs=2)
    assert "**Worth it: 2 r.** Going on to 3 gains +0.0 %: less than 5 %." in done.out
    assert (
        "**But more are better again:** 4 r gain +50.0 % over it, and 6, the most here, +100.0 %." in done.out
    )


def test_what_a_run_leaves_in_modules_of_the_project_is_gone_with_it(here: Here, work: Path) -> None:
    counted = [studied(here, "--measure", "hall:calls", "--json", runs=3), None]
    counted[1] = asemec(
        *("optimise", "work.aseme", "--for", "2s", "--quicker", "1", "--runs", "3", "-j", "2", "--json"),
        *("--measure", "hall:calls"),
        cwd=work,
    )
    for done in counted:
        assert done is not None
        assert [run["measure"] for run in done.json["result"]["runs"]] == [1, 1, 1]


@pytest.mark.parametrize("name", ["fraction", "decimal"])
def test_numbers_of_other_kinds_are_numbers(here: Here, work: Path, name: str) -> None:
    done = studied(here, "--measure", f"hall:{name}", "--json", runs=1)
    assert done.json["result"]["rows"][0]["measure"]["mean"] == 2.5


def test_a_truth_is_no_number(here: Here, work: Path) -> None:
    done = studied(here, "--measure", "hall:truth", runs=1)
    assert done.code == 1 and "hall:truth gave True, which is not a number" in done.err


def test_what_gave_a_number_only_sometimes_is_not_chosen(here: Here, work: Path) -> None:
    done = studied(here, "--vary", "robot.speed=1,2", "--measure", "hall:few", runs=3)
    assert "- 1 of 3 runs of robot.speed = 2 gave no number: hall:few said None." in done.out
    assert "**Best: robot.speed = 1** with 3. Not judged" in done.out
    assert re.search(r"\| 2 +\| 6 .*\| 2 of 3", done.out)


def test_an_activity_that_takes_no_time_is_not_tried(here: Here, tmp_path: Path) -> None:
    text = "liveness { robot = (Look . Go)~ }\n  activities { Look takes 0s  Go takes 1s }"
    (tmp_path / "look.aseme").write_text(
        f"system Look\nsrm robot {{\n  {text}\n}}\nteam Look {{ one : robot }}\n", "utf-8"
    )
    done = here(
        *("optimise", tmp_path / "look.aseme", "--measure", "Go", "--runs", "1", "--for", "10s", "-j", "1"),
        *("-o", tmp_path / "found"),
    )
    assert "**The bottleneck is Go.**" in done.out
    assert "Not tried, for their `takes` is 0s: Look." in done.out


def test_lines_that_are_equal_are_one_and_the_ring_has_a_name(here: Here, trips: Path) -> None:
    done = here(
        *("optimise", trips, "--vary", "one.done=0,7,8,9,10", "--vary", "one.trips=2,1", "--measure", "Rest"),
        *("--runs", "1", "--quicker", "1", "--for", "5s", "-j", "1", "-o", trips.parent / "found"),
    )
    assert done.code == 0, done.err
    words = re.findall(r">([^<>]+)</text>", (trips.parent / "found" / "measure.svg").read_text("utf-8"))
    assert "one.done = 7; one.done = 8; one.done = 9 and 1 more" in words or any(
        "and 2 more" in w for w in words
    )
    assert "best" in words


def test_the_report_for_programs_says_its_format(here: Here, feed: Path) -> None:
    here("optimise", feed, "--measure", "Carry", "--runs", "1", "--for", "2s", "-o", feed.parent / "found")
    assert json.loads((feed.parent / "found" / "report.json").read_text("utf-8"))["format"] == 1
