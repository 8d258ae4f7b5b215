"""Clauses are about the participants of their own protocol, also where another one has the same names."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.support import Here

DIG = """system Works
aip dig {
  participant worker { process = Rest . Dig }
  clause CLAUSE
}
aip paint { participant worker { process = Rest . Dig } }
srm digger  { plays dig.worker    liveness { digger = worker }  activities { Rest takes 1s  Dig takes 1s } }
srm painter { plays paint.worker  liveness { painter = worker } }
team T { a : digger  b : painter }
scenario "all" { for 5s }
"""


@pytest.mark.parametrize("clause", ["at most one Dig@worker", "at most one worker"])
def test_a_clause_does_not_count_agents_of_another_protocol(here: Here, folder: Path, clause: str) -> None:
    (folder / "a.aseme").write_text(DIG.replace("CLAUSE", clause))
    assert here("test", "a.aseme").out.startswith("passed   all")
    done = here("prove", "a.aseme", clause)
    assert done.out.startswith(f"PROVED    {clause} of team"), done.out
    assert done.code == 0


def test_a_clause_of_a_protocol_that_nobody_plays_is_not_asked_of_the_team(here: Here, folder: Path) -> None:
    text = DIG.replace("CLAUSE", "at most one Dig@worker").replace("a : digger", "a : painter")
    (folder / "a.aseme").write_text(text)
    done = here("prove", "a.aseme", "--json")
    about = [item["of"] for item in done.json["results"] if item["name"] == "at most one Dig@worker"]
    assert about == ["protocol dig"]


def test_outcomes_of_another_protocol_do_not_count(here: Here, folder: Path) -> None:
    text = DIG.replace("clause CLAUSE", 'outcome "dug" when Dig@worker').replace("a : digger", "a : painter")
    (folder / "a.aseme").write_text(text.replace("for 5s", 'for 5s never outcome "dug"'))
    assert "no agent that takes part has this place" in here("test", "a.aseme").out
