"""`asemec optimise`: how many agents are worth it, which settings are best, and what slows them."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from tests.cli.support import Here, asemec

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


def test_what_does_not_finish_has_no_time(here: Here, trips: Path) -> None:
    done = here(
        *("optimise", trips, "--vary", "one.trips=1,9", "--measure", "time", "--runs", "1", "--for", "8s"),
        *("--quicker", "1", "-o", trips.parent / "found"),
    )
    assert done.code == 0, done.err
    assert "- 1 run of one.trips = 9 gave no measure: it did not finish in time." in done.out
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
        "    return 'much'\n",
        "utf-8",
    )
    base = ("optimise", "trips.aseme", "--runs", "3", "--for", "1s", "--quicker", "1", "--json", "-j", "1")
    done = here(*base, "--world", "place:make", "--measure", "place:measure")
    assert done.code == 0, done.err
    assert done.json["result"]["rows"][0]["measure"]["mean"] == 20
    wrong = here(*base, "--world", "place:make", "--measure", "place:word")
    assert wrong.code == 1
    assert "place:word gave 'much', which is no number" in wrong.err


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (
            ["--vary", "carier=1..3", "--measure", "Carry"],
            "no range of the team called carier; did you mean carrier?",
        ),
        (
            ["--vary", "maker=1..3", "--measure", "Carry"],
            "no range of the team called maker; there is only carrier.\n",
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
        ("carrier=8..1", "8..1 is no range"),
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
    assert re.search(r"how often it is done a minute: .*Carry", done.err) and "MODULE:FUNCTION" in done.err
    assert "\n  time, for how long" in done.err


def test_a_value_of_another_type_is_refused(here: Here, trips: Path) -> None:
    done = here("optimise", trips, "--vary", "one.trips=many", "--measure", "Walk")
    assert done.code == 1
    assert "'many' is no int, which trips of walker is" in done.err


def test_where_the_report_cannot_go_nothing_is_played(
    here: Here, feed: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("aseme_dsl.build.study.run", None)
    (feed.parent / "file").write_text("mine", "utf-8")
    for folder, why in (
        ("file", "it is a file"),
        ("file/of/it", "there is a file where its folder should be"),
    ):
        done = here("optimise", feed, "--measure", "Carry", "-j", "1", "-o", feed.parent / folder)
        assert done.code == 1 and done.out == ""
        assert f"error[E009]: {feed.parent / folder} cannot be written: {why}" in done.err


def test_a_report_that_cannot_be_left_is_printed(here: Here, feed: Path) -> None:
    out = feed.parent / "found"
    (out / "report.md").mkdir(parents=True)
    base = ("optimise", feed, "--measure", "Carry", "--runs", "1", "--for", "5s", "-o", out)
    done = here(*base)
    assert done.code == 1
    assert "| Carry per minute |" in done.out
    assert "report.md is a folder, and a file must go there" in done.err
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
    assert f"Not tried, {why}: Rest." in done.out
    trips.write_text(
        "system Loops\nsrm robot {\n  liveness { robot = Rest~ || Walk~ }\n  activities { Walk takes 2s }\n"
        "}\nteam Loops { one : robot }\n",
        "utf-8",
    )
    other = here(*base, "--measure", "Rest")
    assert "None of the 1 that could be tried is a bottleneck" in other.out


def test_if_nothing_was_measured_nothing_is_concluded(here: Here, feed: Path) -> None:
    done = here(
        *("optimise", feed, "--measure", "time", "--runs", "2", "--for", "5s", "-j", "1"),
        *("-o", feed.parent / "found"),
    )
    assert done.code == 0, done.err
    assert "**Nothing was measured:** no run gave a number." in done.out
    assert "Every seed gave the same" not in done.out and "times as quick" not in done.out


def test_a_run_of_no_time_is_refused(here: Here, feed: Path) -> None:
    done = here("optimise", feed, "--measure", "Carry", "--for", "0s")
    assert done.code == 2
    assert "in 0s nothing can be measured" in done.err


def test_what_an_agent_does_several_times_at_once_is_counted_as_often(here: Here, trips: Path) -> None:
    trips.write_text(
        "system Loads\nsrm porter {\n  liveness { porter = Carry || Lift || Lift }\n"
        "  activities { Carry takes 1s  Lift takes 1s }\n}\nteam Loads { one : porter }\n",
        "utf-8",
    )
    done = here("optimise", trips, "--measure", "time", "--runs", "1", "-o", trips.parent / "found")
    assert "Lift 200 %, Carry 100 %" in done.out
    assert "what an agent does several times at once is counted as often" in done.out
