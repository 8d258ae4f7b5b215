"""`asemec prove` answers each statement, about all agents, or says why there is no answer."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from tests.cli.support import Done, Here

ONE_TWO = """\
system Pair
srm one { liveness { one = (Look . Walk)~ } }
srm two { liveness { two = Look . Rest } }
"""

FETCH = """\
system Fetch
message Thing { int number }
aip fetch {
  participant asker { process = Ask . Thank }
  participant bringer { process = Hear . Bring }
  control asker {
    enter Ask   : / send request Thing { number = 1 } to bringer
    enter Thank : inform Thing from bringer
  }
  control bringer {
    enter Hear  : request Thing from asker
    enter Bring : / send inform Thing { number = 1 } to asker
  }
}
"""


def answers(done: Done) -> list[tuple[str, str, str]]:
    """(verdict, name, place) of what the file says."""
    found = [
        (item["verdict"], item["name"], item["at"].partition(":")[2])
        for item in done.json["results"]
        if item["at"] is not None and not item["name"].startswith("role ")
    ]
    return sorted(found)


def test_each_statement_of_a_property_is_answered(prove: Callable[..., Done]) -> None:
    good = "never ann in Look  every ann in Look leads to ann in Walk"
    team = f'team Walkers {{ ann : one }}\nproperty "good" {{ {good} }}\n'
    done = prove(ONE_TWO + team, "--json")
    assert answers(done) == [("PROVED", "good", "5:38"), ("REFUTED", "good", "5:19")]
    assert done.code == 1
    assert answers(prove(ONE_TWO + team, "good", "--json")) == answers(done)


COUNTING = """\
system Count
message Word { int n }
topic air { signal Word }
srm one {
  var n : int = 0
  liveness { one = (Say . [Nap])~ }
  activities { Say writes air.signal.Word }
  control one { exit Say : / n = n + 1  enter Nap : [n == 50]  skip Nap : else }
}
srm two {
  liveness { two = (Wait . (Hear | Doze))~ }
  control two { enter Hear : [has(air.signal.Word) && air.signal.Word.n < 9]  enter Doze : else }
}
team Day { ann : one  bob : two }
"""
"""Each agent alone ends all its waits; more states are reached than a small limit allows."""


def test_a_property_is_not_a_question_of_its_name(prove: Callable[..., Done]) -> None:
    text = COUNTING + 'property "deadlock" { never (ann in Nap && bob in Doze) }\n'
    found = {
        item["at"] is None: item["verdict"]
        for item in prove(text, "--states", "20", "--json").json["results"]
        if item["name"] == "deadlock"
    }
    assert found == {True: "PROVED", False: "UNDECIDED"}


def test_the_same_clause_of_two_protocols_is_answered_twice(prove: Callable[..., Done]) -> None:
    fetch = FETCH.removesuffix("}\n") + "  clause Bring@bringer before Thank@asker\n}\n"
    early = fetch.partition("aip fetch")[2].replace("Hear . Bring", "Hear . Nod . Bring")
    roles = (
        "srm wants { plays fetch.asker, early.asker as second liveness { wants = asker . second } }\n"
        "srm gives { plays fetch.bringer, early.bringer as second liveness { gives = bringer . second } }\n"
        "team Both { ann : wants  bob : gives }\n"
    )
    text = f"{fetch}aip early{early.replace('enter Bring', 'enter Nod  ')}{roles}"
    done = prove(text, "Bring@bringer before Thank@asker", "--json")
    found = sorted((item["of"], item["verdict"]) for item in done.json["results"])
    expected = [
        ("protocol early", "REFUTED"),
        ("protocol fetch", "PROVED"),
        ("team", "PROVED"),
        ("team", "REFUTED"),
    ]
    assert (done.code, found) == (1, expected)


def test_counterexamples_of_two_protocols_are_played_from_one_file(here: Here, folder: Path) -> None:
    waits = FETCH.replace("process = Hear . Bring", "var n : int = 0  process = Hear . [Bring]")
    waits = waits.replace("enter Bring : ", "skip Bring : else  enter Bring : [n > 3] ")
    (folder / "it.aseme").write_text(waits + "aip late" + waits.partition("aip fetch")[2])
    done = here("prove", "it.aseme", "deadlock", "--save", "found.aseme", "--json")
    assert [item["verdict"] for item in done.json["results"]] == ["REFUTED", "REFUTED"], done.out
    played = here("test", "found.aseme", "--json")
    assert [item["verdict"] for item in played.json["scenarios"]] == ["failed", "failed"], played.out


def test_without_a_team_there_is_an_agent_of_each_role(prove: Callable[..., Done]) -> None:
    text = ONE_TWO + 'property "awake" { never two in Rest }\nproperty "apart" { never one in Walk }\n'
    done = prove(text, "--json")
    assert answers(done) == [("REFUTED", "apart", "5:20"), ("REFUTED", "awake", "4:20")]
    assert {item["bounds"].partition(";")[0] for item in done.json["results"]} == {"1 one, 1 two"}


def test_the_agents_of_all_teams_are_explored(prove: Callable[..., Done]) -> None:
    teams = 'team Day { ann : one }\nteam Night { bob : two }\nproperty "awake" { never bob in Rest }\n'
    done = prove(ONE_TWO + teams, "awake", "--json")
    assert answers(done) == [("REFUTED", "awake", "6:20")]


def test_a_statement_about_nobody_is_undecided(prove: Callable[..., Done]) -> None:
    team = 'team Day { ann : one }\nproperty "awake" { never two in Rest  never ann in Rest }\n'
    done = prove(ONE_TWO + team.replace("  never ann in Rest", ""), "--json")
    (item,) = (item for item in done.json["results"] if item["name"] == "awake")
    assert (done.code, item["verdict"], item["reason"]) == (3, "UNDECIDED", "two does not take part")


def test_a_role_of_no_agent_is_said_not_to_be_explored(prove: Callable[..., Done]) -> None:
    team = "team Day { ann : one }\n"
    done = prove(ONE_TWO + team, "--json")
    (item,) = (item for item in done.json["results"] if item["name"] == "role two")
    assert (done.code, item["verdict"]) == (0, "UNDECIDED")
    assert item["reason"] == "it is not explored: no agent has this role"
    assert len(prove(ONE_TWO + team, "deadlock", "--json").json["results"]) == 1


def test_what_cannot_be_watched_hides_nothing_else(prove: Callable[..., Done]) -> None:
    text = ONE_TWO + (
        "team Day { ann : one  bob : one }\n"
        'property "which" { never one in Walk }\n'
        'property "awake" { never ann in Walk }\n'
    )
    done = prove(text, "--json")
    assert answers(done) == [("REFUTED", "awake", "6:20"), ("UNDECIDED", "which", "5:26")], done.out
    (item,) = (item for item in done.json["results"] if item["name"] == "which")
    assert item["reason"].startswith("2 agents play one: name one")


def test_a_property_without_roles_is_undecided(prove: Callable[..., Done]) -> None:
    done = prove(FETCH + 'property "done" { eventually Thank@asker }\n', "--json")
    assert [(verdict, name) for verdict, name, _ in answers(done)] == [("UNDECIDED", "done")]


def test_a_built_in_question_with_nothing_to_ask_is_vacuous(prove: Callable[..., Done]) -> None:
    done = prove(ONE_TWO, "orphan messages", "agreement", "deadlock", "--json")
    found = {item["name"]: (item["verdict"], item["reason"]) for item in done.json["results"]}
    assert (done.code, found) == (
        3,
        {
            "deadlock": ("PROVED", ""),
            "orphan messages": ("UNDECIDED", "vacuous: no agent sends or takes a message of a protocol"),
            "agreement": ("UNDECIDED", "vacuous: no protocol of the file has two outcomes with `when`"),
        },
    )


def test_a_model_for_spin_leaves_out_no_agent_and_no_property(here: Here, folder: Path) -> None:
    roles = (
        "srm wants { plays fetch.asker liveness { wants = asker } }\n"
        "srm gives { plays fetch.bringer liveness { gives = bringer } }\n"
        "team Both { ann : wants  bob : gives  eve : gives }\n"
    )
    (folder / "it.aseme").write_text(FETCH + roles)
    done = here("export", "promela", "it.aseme", "--chart", "team")
    assert done.code == 1 and "a second agent of the role gives" in done.err, done.err
    few = (
        roles.replace("  eve : gives", "")
        + 'srm idle { liveness { idle = Nap } }\nproperty "nap" { never idle in Nap }\n'
    )
    (folder / "it.aseme").write_text(FETCH + few)
    done = here("export", "promela", "it.aseme", "--chart", "team")
    assert done.code == 1 and "the property nap: idle does not take part" in done.err, done.err
