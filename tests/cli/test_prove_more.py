"""`asemec prove` on teams that are too large to look at as a whole: what is left out makes no difference."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.test_prove import verdicts

ROBOT = """\
system Robots
message Ball { bool near }
topic eye { state Ball }
srm robot {
  var tired : bool = false
  liveness {
    robot = Look~ || play || (A1 . A2 . A3)~ || (B1 . B2 . B3)~ || (C1 . C2 . C3)~
    play  = Wait . (Kick | Rest)
  }
  activities { Look writes eye.state.Ball }
  control play {
    enter Kick : [eye.state.Ball.near && !tired]
    enter Rest : else
  }
}
team T { one, two, three : robot }
property "it never kicks" { never some robot in Kick }
property "one kicks" { never two of robot in Kick }
property "it rests after it has seen" { every received eye.state.Ball leads to some robot in (Kick or Rest) }
"""


def test_regions_that_do_not_matter_stand_still(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(ROBOT, "it never kicks", "one kicks")
    assert done.code == 1, done.out
    first, second = (line for line in done.out.splitlines() if line.startswith("REFUTED"))
    assert "only the regions that matter to it" in first
    assert "only the regions that matter to it" in second
    assert "robot: Ball.near is True" in done.out.replace("one:", "robot:").replace("two:", "robot:")


def test_a_region_that_writes_what_another_reads_matters(prove) -> None:  # type: ignore[no-untyped-def]
    rested = ROBOT.replace("var tired : bool = false", "var tired : bool = true")
    assert prove(rested, "it never kicks").code == 0
    for line in ("control robot { enter A2 : / tired = false }", "activities { B2 writes tired }"):
        text = rested.replace("  control play {", f"  {line}\n  control play {{")
        done = prove(text, "it never kicks", "--json")
        assert (done.code, verdicts(done)["it never kicks"]) == (1, "REFUTED"), line


def test_a_message_whose_coming_is_asked_for_comes_in_a_move(prove) -> None:  # type: ignore[no-untyped-def]
    (item,) = prove(ROBOT, "it rests after it has seen", "--robots", "1", "--json").json["results"]
    assert item["verdict"] != "PROVED" or "vacuous" not in item["reason"], item
    never = ROBOT.replace(
        'property "it never kicks" { never some robot in Kick }',
        'property "nothing is seen" { never received eye.state.Ball }',
    )
    done = prove(never, "nothing is seen", "--robots", "1")
    assert done.code == 1, done.out


def test_agents_that_do_not_meet_are_looked_at_apart(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(ROBOT, "deadlock", "dead states", "failures", "--robots", "3", "--json")
    assert set(verdicts(done).values()) == {"PROVED"}, done.out
    assert all("agents that do not meet apart" in item["bounds"] for item in done.json["results"])
    met = ROBOT.replace("topic eye { state Ball }", "topic eye { state Ball from robot }")
    done = prove(met, "deadlock", "--robots", "2", "--states", "300", "--json")
    assert "agents that do not meet apart" not in done.json["results"][0]["bounds"]


NUMBERS = """\
system Numbers
message Who { int first  int second }
message Me { int number }
topic team { state Who }
topic my { state Me }
srm robot {
  liveness { robot = Wait . (Both | Second | First | None) }
  control robot {
    enter Both   : [my.state.Me.number == team.state.Who.first && my.state.Me.number == team.state.Who.second
                    && team.state.Who.first != team.state.Who.second]
    enter First  : [my.state.Me.number == team.state.Who.first]
    enter Second : [my.state.Me.number == team.state.Who.second]
    enter None   : else
  }
}
team T { one : robot }
property "it is not both" { never one in Both }
property "it is one of them" { never one in None }
"""


def test_numbers_that_are_only_compared_with_each_other_stand_for_all(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(NUMBERS, "--json")
    found = {item["name"]: item for item in done.json["results"]}
    assert found["it is one of them"]["verdict"] == "REFUTED"
    assert found["dead states"]["verdict"] == "REFUTED"  # Both
    assert found["dead states"]["reason"].startswith("never reached: state Both, `[my.state.Me.number ==")
    assert found["deadlock"]["verdict"] == "PROVED"
    assert " in 1" not in found["deadlock"]["bounds"], found["deadlock"]


def test_members_of_messages_may_have_any_name(prove) -> None:  # type: ignore[no-untyped-def]
    text = """\
system Names
message Ball { bool content  bool at  int path  int root }
topic eye { state Ball }
srm robot {
  liveness { robot = Wait . (Kick | Rest) }
  control robot {
    enter Kick : [eye.state.Ball.content && eye.state.Ball.at && eye.state.Ball.path == eye.state.Ball.root]
    enter Rest : else
  }
}
team T { one : robot }
property "it rests" { never one in Kick }
"""
    done = prove(text, "it rests")
    assert (done.code, done.err) == (1, ""), done.out
    assert "one: Ball.content is True; one: Ball.at is True" in done.out


COUNTED = """\
system Cells
srm cell {
  liveness { cell = (Grasp+ . Rest)~ }
  control cell {
    repeat Grasp : [count(Grasp) < LIMIT]
    leave  Grasp :
  }
}
team T { one : cell }
property "it rests" { never one in Rest }
"""


def test_what_counts_without_end_has_an_end(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(COUNTED.replace("LIMIT", "3"), "--json")
    assert verdicts(done) == {
        "it rests": "REFUTED",
        "deadlock": "PROVED",
        "dead states": "PROVED",
        "failures": "PROVED",
    }
    endless = COUNTED.replace("count(Grasp) < LIMIT", "count(Grasp) > 0")
    assert verdicts(prove(endless, "dead states", "--json")) == {"dead states": "REFUTED"}


def test_a_message_that_never_came_is_not_there(prove) -> None:  # type: ignore[no-untyped-def]
    text = NUMBERS.replace("enter None   : else", "enter None   : [!has(my.state.Me)]")
    found = verdicts(prove(text, "deadlock", "it is one of them", "--json"))
    assert found["it is one of them"] == "REFUTED"


def test_a_kept_message_does_not_change(prove) -> None:  # type: ignore[no-untyped-def]
    """A message that a line has kept as a whole says the same when it is asked again."""
    text = """\
system Kept
message Ball { bool near }
topic eye { state Ball }
srm robot {
  var seen : Ball
  liveness { robot = Wait . Keep . ((Near . (Same | Other)) | Far) }
  control robot {
    enter Keep  : [has(eye.state.Ball)] / seen = eye.state.Ball
    enter Near . (Same | Other) : [seen.near]
    enter Far   : else
    enter Same  : [seen.near]
    enter Other : else
  }
}
team T { one : robot }
property "it stays" { never one in Other }
"""
    found = verdicts(prove(text, "dead states", "--json"))
    assert found == {"dead states": "REFUTED"}


def test_an_activity_with_a_deadline_matters_wherever_it_is(prove) -> None:  # type: ignore[no-untyped-def]
    text = """\
system Late
srm robot { liveness { robot = (Hold . Done)~ || (A . B)~ } activities { Hold within 1s } }
team T { one : robot }
property "it comes to B" { eventually one in B }
"""
    done = prove(text, "it comes to B")
    assert (done.code, "  1  one: 1 s have passed in Hold" in done.out) == (1, True), done.out
    done = prove(text.replace(" within 1s", " takes 1s"), "it comes to B")
    assert (done.code, "only the regions that matter to it; 3 states" in done.out) == (0, True), done.out


RAISED = """\
system Raised
srm robot {
  var ok : bool = false
  liveness { robot = (A . B)~ || (W . Alarm)~ }
  control robot { enter B : [ok] / raise done   enter Alarm : done }
}
team T { one : robot }
property "no alarm" { never one in Alarm }
property "an alarm" { eventually one in Alarm }
"""


def test_an_event_that_lines_raise_comes_of_them_alone(prove) -> None:  # type: ignore[no-untyped-def]
    found = verdicts(prove(RAISED, "--json"))
    assert (found["no alarm"], found["an alarm"], found["deadlock"]) == ("PROVED", "REFUTED", "REFUTED")
    found = verdicts(prove(RAISED.replace(": [ok] /", ": /"), "--json"))
    assert (found["no alarm"], found["an alarm"], found["deadlock"]) == ("REFUTED", "PROVED", "PROVED")
    outside = RAISED.replace("enter B : [ok] / raise done", "enter B : / ok = true")
    found = verdicts(prove(outside, "--json"))
    assert (found["no alarm"], found["an alarm"], found["deadlock"]) == ("REFUTED", "REFUTED", "PROVED")


def test_a_region_that_takes_an_event_before_the_states_around_it_matters(prove) -> None:  # type: ignore[no-untyped-def]
    text = """\
system Spent
srm robot {
  liveness {
    robot = (A . B)~ || play
    play  = work . Over
    work  = (X . Y)~ || Z~
  }
  control robot { enter B : / raise done }
  control play { enter Over : done }
  control work { on Y : done }
}
team T { one : robot }
property "it is over" { eventually one in Over }
"""
    done = prove(text, "it is over")
    assert (done.code, "only the regions that matter to it" in done.out) == (1, True), done.out
    assert prove(text.replace("  control work { on Y : done }\n", ""), "it is over").code == 0


def test_a_state_that_agents_with_other_settings_reach_is_not_dead(prove) -> None:  # type: ignore[no-untyped-def]
    text = """\
system Sides
srm robot {
  var left : bool = false
  liveness { robot = Wait . (Left | Right) }
  control robot { enter Left : [left]  enter Right : else }
}
team T { one : robot with left = true  two : robot }
"""
    (item,) = prove(text, "dead states", "--json").json["results"]
    assert (item["verdict"], item["reason"]) == ("PROVED", ""), item
    assert item["bounds"] == "2 robot; any delay; agents that do not meet apart; 6 states"
    (item,) = prove(text.replace(" with left = true", ""), "dead states", "--json").json["results"]
    assert (item["verdict"], "state Left" in item["reason"]) == ("REFUTED", True), item


PAIRS = """\
system Pairs
message Pair { int first  int second }
topic team { state Pair from eye }
srm eye { liveness { eye = Look+ } activities { Look writes team.state.Pair } }
srm robot {
  liveness { robot = Wait . (A | B) . Then . (C | D) }
  control robot {
    enter A : [team.state.Pair.first == team.state.Pair.second]
    enter B : [team.state.Pair.first != team.state.Pair.second]
    enter C : [team.state.Pair.first == team.state.Pair.second]
    enter D : [team.state.Pair.first != team.state.Pair.second]
  }
}
team T { one : robot  two : eye }
"""


def test_what_was_decided_of_messages_that_are_over_makes_no_states(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(PAIRS, "deadlock", "--json")
    assert done.json["results"][0]["bounds"].endswith("68 states")  # 96 with what the first one said


def test_an_age_that_is_kept_is_not_explored(prove) -> None:  # type: ignore[no-untyped-def]
    text = """\
system Old
message M { int k }
topic t { state M }
srm writer { liveness { writer = P . Q } control writer { enter Q : / write_messages.t.state.M } }
srm reader {
  var old : duration = 0s
  liveness { reader = A . B . (C | D) }
  control reader { enter B : [has(t.state.M)] / old = age(t.state.M)  enter C : [old > 5s]  enter D : else }
}
team T { one : writer  two : reader }
property "it is new" { never two in C }
"""
    (item,) = prove(text, "it is new", "--json").json["results"]
    assert item["verdict"] == "UNDECIDED"
    assert item["reason"] == "reader does more with an age than compare it with a constant"


def test_values_between_a_constant_and_a_bound_are_tried(prove) -> None:  # type: ignore[no-untyped-def]
    text = """\
system Bound
srm robot {
  var level : double 2.5..3.5 = 3.0
  liveness { robot = Look . (High | Low) }
  activities { Look writes level }
  control robot { enter High : [level > 3.0]  enter Low : else }
}
team T { one : robot }
property "it is never high" { never one in High }
"""
    done = prove(text, "it is never high")
    assert (done.code, "one: level is 3.5" in done.out) == (1, True), done.out


def test_agents_with_other_numbers_are_not_alike(prove) -> None:  # type: ignore[no-untyped-def]
    text = """\
system Numbered
srm robot {
  liveness { robot = Wait . Go . Rest }
  control robot { enter Go : [index == 1] }
}
team T { cell[1..2] : robot }
"""
    done = prove(text, "deadlock")
    assert "REFUTED   deadlock of team: cell2 waits after Wait for ever for [index == 1]" in done.out
    assert prove(text.replace("== 1", "< 3"), "deadlock").code == 0


def test_a_text_that_no_condition_names_is_tried(prove) -> None:  # type: ignore[no-untyped-def]
    text = """\
system Names
message Call { string name }
topic voice { state Call }
srm robot {
  liveness { robot = Wait . (Mine | Another | Rest) }
  control robot {
    enter Mine    : [voice.state.Call.name == "bob"]
    enter Another : [voice.state.Call.name != "bob"]
    enter Rest    : else
  }
}
team T { bob : robot }
property "it is mine" { never bob in Another }
"""
    assert prove(text, "it is mine").code == 1


@pytest.mark.parametrize(
    ("asked", "state", "said"),
    [
        ("t.state.Note.on && t.state.Note.x > 7", "A", "Note.x is 8"),
        ("t.state.Note.on && t.state.Note.x > 7", "B", ""),
        ("seen(t.state.Note)", "A", "seen() is True"),
    ],
)
def test_a_run_with_a_message_that_may_have_come_plays(  # type: ignore[no-untyped-def]
    prove, folder: Path, asked: str, state: str, said: str
) -> None:
    (folder / "nowhere.py").write_text("def seen(note: object) -> bool:\n    return False\n")
    text = f"""\
system Watch
message Note {{ int x  bool on }}
topic t {{ state Note }}
function seen(Note note) : bool = "nowhere:seen"
srm watcher {{
  liveness {{ watcher = Idle . (A | B) }}
  control watcher {{ enter A : [{asked}]  enter B : else }}
}}
team T {{ one : watcher }}
property "never there" {{ never one in {state} }}
"""
    (item,) = prove(text, "never there", "--json").json["results"]
    assert item["verdict"] == "REFUTED", item  # the run has been played
    assert said in str(item["counterexample"])
