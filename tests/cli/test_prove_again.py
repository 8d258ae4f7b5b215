"""`asemec prove` of a file that has counterexamples of it already, as the editor inserts them."""

from __future__ import annotations

from pathlib import Path

from tests.cli.support import Here

WAIT = """system Wait
message Tool { int number }
aip loan {
  participant asker { process = Ask }
  participant giver { process = Look . Lend }
  control asker { enter Ask : / send request Tool { .. } to giver }
  control giver { enter Look : request Tool from asker  leave Lend : inform Tool from asker }
}
"""
"""The giver waits for ever for a message that nobody sends."""

TWO = f"""{WAIT}
aip gift {{
  participant asker {{ process = Ask . Hope }}
  participant giver {{ process = Look }}
  control asker {{ enter Ask : / send request Tool {{ .. }} to giver  leave Hope : inform Tool from giver }}
  control giver {{ enter Look : request Tool from asker }}
}}
"""
"""Two protocols whose participants have the same names."""

WALK = """system Walk
srm robot { liveness { robot = (Walk . Rest)~ }  activities { Walk waits  Rest takes 1s } }
team T { x : robot }
property "never rests" { never x in Walk }
"""


def test_a_protocol_is_proved_beside_its_own_counterexample(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(WAIT)
    before = here("prove", "a.aseme", "deadlock", "--save", "a.aseme")
    assert before.out.startswith("REFUTED   deadlock of protocol loan: giver waits"), before.out
    text = (folder / "a.aseme").read_text()
    assert "srm proved_loan_asker" in text
    again = here("prove", "a.aseme", "deadlock", "--save", "a.aseme")
    assert (again.code, again.out) == (1, before.out)
    assert (folder / "a.aseme").read_text() == text


def test_a_property_is_proved_beside_its_own_counterexample(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(WALK)
    before = here("prove", "a.aseme", "never rests", "--save", "a.aseme")
    again = here("prove", "a.aseme", "never rests")
    assert before.out.startswith("REFUTED   never rests of team")
    assert (again.code, again.out) == (1, before.out)


def test_a_protocol_is_explored_by_its_name(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(TWO)
    for asked in (["gift"], ["gift", "deadlock"]):
        done = here("prove", "a.aseme", *asked, "--json")
        assert {item["of"] for item in done.json["results"]} == {"protocol gift"}
    assert {item["name"] for item in done.json["results"]} == {"deadlock"}
    wrong = here("prove", "a.aseme", "gift", "deadlok")
    assert wrong.code == 2 and "did you mean `deadlock`?" in wrong.err


def test_what_a_participant_is_given_is_saved_once(here: Here, folder: Path) -> None:
    text = WAIT.replace("participant giver {", "participant giver { given patience : int")
    (folder / "a.aseme").write_text(text)
    before = here("prove", "a.aseme", "--save", "a.aseme")
    assert before.out.count("REFUTED") > 1
    again = here("prove", "a.aseme")
    assert (again.code, again.out) == (1, before.out)


def test_how_to_ask_again_keeps_what_was_asked(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(TWO)
    again = "asemec prove a.aseme loan deadlock --states 5 --robots 3 --horizon 4s"
    done = here("prove", "a.aseme", "deadlock", "--states", "1", "--robots", "3", "--horizon", "4s")
    assert done.out.splitlines()[-1] == f"hint: to decide it, ask for it alone, with a larger limit: {again}"
    assert here(*again.split()[1:]).code in {0, 1, 3}
    assert "; 1 state]" in done.out


def test_assumptions_that_exclude_each_other_are_the_reason(here: Here, folder: Path) -> None:
    text = """system Sky
message Sun { bool up }
topic sky { state Sun from outside }
srm robot {
  liveness { robot = (Walk | Rest)~ }
  control robot { enter Rest : [!sky.state.Sun.up]  enter Walk : else }
}
team T { x : robot }
property "rests" {
  assume x has [sky.state.Sun.up == true]
  assume x has [sky.state.Sun.up == false]
  never x in Walk
}
"""
    (folder / "a.aseme").write_text(text)
    done = here("prove", "a.aseme", "rests")
    assert done.code == 3
    assert "UNDECIDED rests of team" in done.out and "exclude each other [" in done.out, done.out


def test_another_counterexample_with_the_same_title_is_saved_too(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(WALK.replace("Walk . Rest", "Rest . Walk"))
    here("prove", "a.aseme", "never rests", "--save", "found.aseme")
    (folder / "a.aseme").write_text(WALK)
    here("prove", "a.aseme", "never rests", "--save", "found.aseme")
    text = (folder / "found.aseme").read_text()
    assert 'scenario "never rests of team" {' in text and 'scenario "never rests of team 2" {' in text


def test_participants_of_two_protocols_with_the_same_names_play_their_own(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(TWO)
    done = here("prove", "a.aseme", "deadlock", "--save", "found.aseme")
    assert "protocol loan: giver waits" in done.out and "protocol gift: asker waits" in done.out
    tested = here("test", "found.aseme", "--json").json["scenarios"]
    assert [item["verdict"] for item in tested] == ["failed", "failed"], tested


def test_what_is_asked_of_a_protocol_that_cannot_be_played_stays_undecided(here: Here, folder: Path) -> None:
    name = "proved_loan_asker"
    role = f"srm {name} {{ plays loan.asker  liveness {{ {name} = asker . Rest }} }}\n"
    (folder / "a.aseme").write_text(WAIT + role)
    done = here("prove", "a.aseme", "deadlock")
    reason = "it cannot be played alone: the role `proved_loan_asker` is declared twice"
    assert f"UNDECIDED deadlock of protocol loan: {reason}" in done.out
    assert done.code == 3
