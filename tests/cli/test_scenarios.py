"""`asemec test`: what it prints for people and programs, its exit codes, and seeds in several processes."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.cli.support import GOOD, Here

SCENARIOS = """
scenario "it stands" {
  one : robot
  by 1s one in Stand
}
scenario "it walks" {
  one : robot
  by 3s one in Walk
}
scenario "nobody is home" {
  every one has [eyes.state.Seen.home] leads to two in Stand within 1s
  for 2s
}
scenario "in its world" { world no_such_world:make  by 1s one in Stand }
scenario "it takes its time" {
  one : robot
  activity Stand takes 500ms..1500ms
  by 700ms one in Walk
}
"""


@pytest.fixture
def tested(here: Here, folder: Path) -> Here:
    (folder / "good.aseme").write_text(GOOD + SCENARIOS)
    return here


def test_people_read_verdict_place_and_story(tested: Here) -> None:
    done = tested("test", "good.aseme", "-k", "it walks")
    assert done.code == 1
    assert (
        done.out
        == """\
failed   it walks  seed 1  3 s
  good.aseme:22:3: `one in Walk` has not come by 3 s: one is in Stand
   22 |   by 3s one in Walk
      |   ^^^^^^^^^^^^^^^^^
    0 s  one  enters Stand : else (good.aseme:9)
                not to Walk, as not [eyes.state.Seen.ball] (good.aseme:8), with eyes.state.Seen.ball = absent
    3 s  one  Stand returns; Stand -> Stand : else (good.aseme:11), else (good.aseme:9), the 3rd time
                not to end of robot, as not [eyes.state.Seen.home] (good.aseme:10), with eyes.state.Seen.home = absent
                not to Walk, as not [eyes.state.Seen.ball] (good.aseme:8), with eyes.state.Seen.ball = absent
    then, at 3 s:
         one  is in Stand (good.aseme:5) since 3 s: its activity has not returned
  ask next: asemec whynot one Walk --at 3s TRACE (`asemec test --traces DIR` writes it)
1 scenario: 1 failed
"""  # noqa: E501
    )


def test_a_failure_is_drawn_and_what_cannot_be_written_is_a_failure(tested: Here, folder: Path) -> None:
    assert tested("test", "good.aseme", "-k", "walks", "--stories", "drawn").code == 1
    assert [path.name for path in (folder / "drawn").iterdir()] == ["it-walks.svg"]
    assert "aseme-talk" in (folder / "drawn" / "it-walks.svg").read_text()
    share = tested("test", "good.aseme", "-k", "stands", "--stories", "drawn")
    assert (share.code, len(list((folder / "drawn").iterdir()))) == (0, 1)


def test_programs_read_json(tested: Here) -> None:
    done = tested("test", "good.aseme", "--json", "-j", "1")
    assert done.code == 1
    assert done.json["format"] == 1
    assert [tuple(item.values()) for item in done.json["scenarios"]] == [
        ("it stands", "passed", 1, 1_000_000_000, ""),
        (
            "it walks",
            "failed",
            1,
            3_000_000_000,
            "good.aseme:22:3: `one in Walk` has not come by 3 s: one is in Stand",
        ),
        (
            "nobody is home",
            "vacuous",
            1,
            2_000_000_000,
            "good.aseme:25:3: what it speaks of has not happened",
        ),
        (
            "in its world",
            "error",
            1,
            0,
            "good.aseme:28:10: no function make in module no_such_world: No module named 'no_such_world'",
        ),
        (
            "it takes its time",
            "failed",
            1,
            700_000_000,
            "good.aseme:32:3: `one in Walk` has not come by 0.7 s: one is in Stand",
        ),
    ]
    assert list(done.json["scenarios"][0]) == ["name", "verdict", "seed", "time_ns", "reason"]


def test_ci_services_read_junit_and_commands(tested: Here) -> None:
    suites = ElementTree.fromstring(tested("test", "good.aseme", "--format", "junit", "-j", "1").out)
    assert suites.attrib == {"name": "asemec test", "tests": "5", "failures": "3", "errors": "1"}
    cases = {case.attrib["name"]: [(part.tag, part.attrib["type"]) for part in case] for case in suites[0]}
    assert cases == {
        "it stands": [],
        "it walks": [("failure", "failed")],
        "nobody is home": [("failure", "vacuous")],
        "in its world": [("error", "error")],
        "it takes its time": [("failure", "failed")],
    }
    done = tested("test", "good.aseme", "--format", "github", "-k", "walks")
    place = "file=good.aseme,line=22,endLine=22,col=3,endColumn=20"
    reason = "`one in Walk` has not come by 3 s: one is in Stand"
    assert (done.code, done.out) == (1, f"::error {place},title=it walks::{reason}\n")
    assert tested("test", "good.aseme", "--format", "junit", "--json").code == 2


def test_the_exit_code_says_whether_all_have_passed(tested: Here, folder: Path) -> None:
    assert tested("test", "good.aseme", "-k", "stands").code == 0
    assert tested("test", "good.aseme", "-k", "home").code == 1
    wrong = tested("test", "good.aseme", "-k", "stand up")
    assert (wrong.code, "Scenarios: it stands" in wrong.err) == (2, True)
    assert tested("test", "good.aseme", "--seeds", "0").code == 2
    assert tested("test", "bad.aseme").code == 1
    (folder / "good.aseme").write_text(GOOD)
    none = tested("test", "good.aseme")
    said, _, example = none.out.partition("\nwrite one in the file, for example:\n")
    assert (none.code, said) == (0, "0 scenarios")
    (folder / "good.aseme").write_text(GOOD + example.replace("3s", "9s"))
    assert "1 scenario: 1 " in tested("test", "good.aseme").out


def test_the_same_seeds_give_the_same_in_several_processes(tested: Here) -> None:
    alone = tested("test", "good.aseme", "--seeds", "9", "-j", "1", "--json")
    beside = tested("test", "good.aseme", "--seeds", "9", "-j", "2", "--json")
    assert alone.out == beside.out


def test_points_are_counted_and_any_role_is_the_chosen_agent(here: Here, folder: Path) -> None:
    scenarios = """scenario "worth two" { points 2  at 0ms any robot in Stand }
scenario "worth three" { points 3  at 0ms any robot in Walk }
"""
    (folder / "good.aseme").write_text(GOOD + scenarios)
    both = here("test", "good.aseme")
    assert (both.code, "2 agents play robot" in both.out, "--role robot=one" in both.out) == (1, True, True)
    chosen = here("test", "good.aseme", "--role", "robot=two")
    assert chosen.out.splitlines()[-2:] == ["2 scenarios: 1 passed, 1 failed", "2 of 5 points"], chosen.out
    found = here("test", "good.aseme", "--role", "robot=two", "--json").json["scenarios"]
    assert [(item["verdict"], item["points"]) for item in found] == [("passed", 2), ("failed", 3)]
    other = here("test", "good.aseme", "--role", "robot=three")
    assert (other.code, "three does not take part as robot" in other.out) == (1, True)
    wrong = here("test", "good.aseme", "--role", "robt=one")
    assert (wrong.code, "Did you mean 'robot'?" in wrong.err) == (2, True)
    assert here("test", "good.aseme", "--role", "robot").code == 2


WATCHED = """
property "it moves" { always some robot in robot  every one in Stand leads to one in Walk within 2s }
property "it never sits" { every two in Walk leads to two in Stand  eventually one in Walk }
"""


def test_a_run_watches_properties(here: Here, folder: Path) -> None:
    (folder / "good.aseme").write_text(GOOD + WATCHED)
    done = here("run", "good.aseme", "-o", "out", "--for", "9s", "--allow", "waiting")
    told = [line.strip() for line in done.out.splitlines() if "good.aseme:" in line or "kept" in line]
    assert done.code == 1
    assert told == [
        'broken at 2 s: property "it moves" (good.aseme:16:51)',
        'broken at 2 s: property "it moves" (good.aseme:16:51)',
        'vacuous: property "it never sits" (good.aseme:17:28)',
        'open: property "it never sits" (good.aseme:17:69)',
        "1 of 4 statements of properties and clauses are kept",
    ], done.out
    strict = here("run", "good.aseme", "-o", "out", "--for", "9s", "--strict", "--json")
    found = strict.json["result"]
    assert (strict.code, found["time"], [item["verdict"] for item in found["watched"]]) == (
        1,
        2_000_000_001,  # nothing else happens then
        ["kept", "broken", "vacuous", "open"],
    )
    alone = here("run", "good.aseme", "-o", "out", "--role", "robot", "--agent", "two", "--for", "1s")
    assert (alone.code, "1 of 2 statements" in alone.out) == (0, True), alone.out


SHRINKS = """
scenario "nobody walks" {
  given home in 0..1
  given far in 0..300
  at 100ms two receives eyes.state.Seen { ball = true }
  at 200ms one receives eyes.state.Seen { home = home > 5 }
  at 500ms one receives eyes.state.Seen { ball = far > 17 }
  crash two at 700ms
  never one in Walk  // a comment
  for 5s
}
"""


def test_a_failure_is_shrunk_and_saved_as_a_scenario(here: Here, folder: Path) -> None:
    (folder / "good.aseme").write_text(GOOD + SHRINKS)
    done = here("test", "good.aseme", "--save", "found.aseme")
    assert done.code == 1
    assert "  with home = 0, far = 18" in done.out.splitlines(), done.out
    shown = "  shown is a shorter run with the same reason, without the inputs of lines 19, 20, 22:"
    assert shown in done.out.splitlines(), done.out
    saved = (folder / "found.aseme").read_text()
    assert (
        saved
        == """\
// fails with seed 1
scenario "nobody walks, shrunk" {
  table (home, far) { (0, 18) }
  at 500ms one receives eyes.state.Seen { ball = far > 17 }
  never one in Walk  // a comment
  for 5s
}
"""
    )
    (folder / "good.aseme").write_text(GOOD + SHRINKS + saved)
    again = here("test", "good.aseme", "-k", "shrunk")
    assert (again.code, "failed   nobody walks, shrunk" in again.out) == (1, True), again.out


def test_an_input_that_nothing_reads_costs_one_run(here: Here, folder: Path) -> None:
    text = 'scenario "s" {\n  given far in 0..300\n  %s\n  for 1s\n}\n'
    for line, runs in (("", ""), ("at 0ms one receives eyes.state.Seen { ball = far > 17 }", "  100 runs")):
        (folder / "good.aseme").write_text(GOOD + text % line)
        assert here("test", "good.aseme", "-j", "1").out.startswith(f"passed   s  seed 1  1 s{runs}\n")


AWAITED = """
scenario "it comes home, and sits down" {
  one : robot
  at 500ms  one receives eyes.state.Seen { ball = true }
  at 600ms  one receives eyes.state.Seen { ball = true }
  at 2500ms one receives eyes.state.Seen { home = true }
  in order one in Walk, one in Stand
  for 4s
}
"""


def test_what_has_not_come_is_not_made_smaller_by_leaving_out_what_leads_to_it(
    here: Here, folder: Path
) -> None:
    (folder / "good.aseme").write_text(GOOD + AWAITED)
    done = here("test", "good.aseme")
    lines = done.out.splitlines()
    assert done.code == 1
    shown = "  shown is a shorter run with the same reason, without the input of line 18:"
    assert shown in lines, done.out
    assert (
        "    2.5 s  one  receives eyes.state.Seen { ball = false, home = true }, an input of the scenario"
        in lines
    ), done.out


KNOWN = """
scenario "it walks when it sees the ball" {
  one : robot
  at 500ms one receives eyes.state.Seen { ball = false  home = false }
  at 2s    one in Walk
  for 4s
}
"""


def test_what_an_agent_knows_when_something_has_not_come_is_not_left_out(here: Here, folder: Path) -> None:
    (folder / "good.aseme").write_text(GOOD + KNOWN)
    done = here("test", "good.aseme")
    assert done.code == 1
    assert "shorter run" not in done.out
    assert "receives eyes.state.Seen { ball = false, home = false }, an input of the scenario" in done.out


LATE = """
scenario "it walks" {
  one : robot
  at 1500ms one in Walk
  for 4s
}
"""


def test_a_story_ends_where_the_expectation_is_broken(here: Here, folder: Path) -> None:
    (folder / "good.aseme").write_text(GOOD + LATE)
    done = here("test", "good.aseme")
    assert "good.aseme:18:3: `one in Walk` is not so at 1.5 s: one is in Stand" in done.out
    assert "  1 s  one  Stand returns; Stand -> Stand" in done.out, done.out
    assert "2 s" not in done.out


TOLD = """
scenario "values" {
  at 500ms one receives eyes.state.Seen { ball = true  home = true }
  at 2s one has [!eyes.state.Seen.home && eyes.state.Seen.ball]
}
scenario "order" {
  at 500ms one receives eyes.state.Seen { ball = true }
  in order one in Stand, one in Walk, two in Walk
  for 4s
}
"""


def test_a_failure_says_what_was_read_what_is_missing_and_what_the_scenario_gave(
    here: Here, folder: Path
) -> None:
    (folder / "good.aseme").write_text(GOOD + TOLD)
    lines = [line.strip() for line in here("test", "good.aseme").out.splitlines()]
    read = "eyes.state.Seen.home = true, eyes.state.Seen.ball = true"
    condition = "`one has [!eyes.state.Seen.home && eyes.state.Seen.ball]`"
    assert f"good.aseme:18:3: {condition} is not so at 2 s: one has {read}" in lines
    missing = "`two in Walk` (part 3 of 3) has not come by 4 s; the part before, `one in Walk`, came at 1 s"
    assert f"good.aseme:22:3: {missing}" in lines
    given = "receives eyes.state.Seen { ball = true, home = true }, an input of the scenario"
    assert f"0.5 s  one  {given}" in lines


INTERRUPTED = """\
system Guard
message Stop { int n }
topic t { signal Stop }
srm r {
  liveness { r = (Walk . Rest) [> Flee }
  activities { Walk takes 5s  Rest takes 1s  Flee takes 1s }
  control r { enter Flee : when [t.signal.Stop.n > 0] }
}
team T { bob : r }
scenario "rests" { by 3s bob in Rest }
"""


def test_a_story_says_what_may_interrupt_a_wait(here: Here, folder: Path) -> None:
    (folder / "guard.aseme").write_text(INTERRUPTED)
    told = here("test", "guard.aseme").out.split("then, at 3 s:\n")[1]
    assert [line.strip() for line in told.splitlines()[:4]] == [
        "bob  is in Walk (guard.aseme:5) since 0 s: its activity has not returned,"
        " and until then it may be left by when [t.signal.Stop.n > 0] (guard.aseme:7), an interrupt",
        "with t.signal.Stop.n = absent",
        "t.signal.Stop has not come: no role of these agents sends it",
        "ask next: asemec whynot bob Rest --at 3s TRACE (`asemec test --traces DIR` writes it)",
    ]


def test_a_failure_in_a_table_shows_its_row(here: Here, folder: Path) -> None:
    table = """
scenario "it sees" {
  one : robot
  table (ball, expected) { (true, Walk) (false, Walk) }
  at 500ms one receives eyes.state.Seen { ball = ball }
  at 1500ms one in expected
  for 2s
}
"""
    (folder / "good.aseme").write_text(GOOD + table)
    done = here("test", "good.aseme")
    assert done.code == 1
    assert "  with the row ball = false, expected = Walk" in done.out.splitlines(), done.out


def test_who_answers_and_leaves_at_once_is_waited_for(here: Here, folder: Path) -> None:
    """Its answer is still on its way when its part is over."""
    text = """\
system Market
message Task { string id }
aip call {
  participant seller {
    sends cfp Task
    receives refuse Task
    process = Announce . Collect+ . Choose
  }
  participant bidder [1..*] { sends refuse Task  receives cfp Task  process = Consider }
  control seller {
    enter  Collect+ : / send cfp Task { id = "t1" } to bidder
    leave  Collect  : when [all_answered(bidder)]
    repeat Collect  : refuse Task from bidder
  }
  control bidder {
    enter Consider : cfp Task from seller
    leave Consider : / send refuse Task { .. } to seller
  }
}
srm desk  { plays call.seller  liveness { desk = seller } activities { Announce takes 1s  Collect takes 1s } }
srm robot { plays call.bidder  liveness { robot = bidder } activities { Consider takes 1s  Choose takes 1s } }
team T { shop : desk  r[1..3] : robot }
scenario "slow" {
  network delay 2s..2s
  at 5900ms shop in Collect
  never untaken Task by shop
  by 6100ms shop in Choose
  for 10s
}
"""
    (folder / "a.aseme").write_text(text)
    done = here("test", "a.aseme")
    assert done.code == 0, done.out
