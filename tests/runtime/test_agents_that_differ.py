"""What is set in agents, and chance, in runs: by the seed, after a crash, and under another version."""

from __future__ import annotations

from random import Random

from aseme_dsl.runtime.faults import Crash, Faults
from tests.faults.changing import version
from tests.runtime.playing import MS, SECOND, Played, make, play

TEAM = """
system S
srm R {
  var limit : int = 50
  liveness { R = Count(limit + index)~ }
  activities { Count(to : int) takes 400ms }
}
team T { keeper : R with limit = 80  many[1..2] : R with limit = index * 100 }
"""

CHANCE = """
system S
srm R { liveness { R = Roll(random())~ }  activities { Roll(of : double) takes 100ms } }
team T { one, two : R }
"""


def given(run: Played, agent: str) -> list[object]:
    return [
        value
        for record in run.of("activity", what="start", agent=agent)
        for value in record["arguments"].values()
    ]


def test_each_agent_begins_with_what_is_set_in_it() -> None:
    run = play(TEAM, until=500 * MS)
    assert [given(run, name)[0] for name in ("keeper", "many1", "many2")] == [81, 101, 202]


def test_one_that_is_started_again_has_it_again() -> None:
    faults = Faults(crashes=(Crash("keeper", at=600 * MS, down=100 * MS),))
    run = play(TEAM, until=900 * MS, faults=faults)
    assert given(run, "keeper") == [81, 81, 81]


def test_a_run_is_decided_by_its_seed() -> None:
    run = play(CHANCE, until=350 * MS, seed=7)
    for name in ("one", "two"):
        chance = Random(f"7/{name}")
        assert given(run, name) == [chance.random() for _ in range(4)]
    assert given(play(CHANCE, until=350 * MS, seed=8), "one") != given(run, "one")


def test_what_is_drawn_is_in_the_line_of_the_step() -> None:
    run = play(CHANCE, until=50 * MS)
    (step,) = run.of("step", agent="one")
    assert step["functions"] == [{"function": "random", "value": given(run, "one")[0]}]


def test_another_version_goes_on_with_the_generator() -> None:
    team, records = make(CHANCE, until=1 * SECOND)
    team.swap(version(CHANCE.replace("100ms", "50ms")), at=250 * MS)
    team.run()
    drawn = [
        record["arguments"]["of"]
        for record in records
        if record["kind"] == "activity" and record["what"] == "start" and record["agent"] == "one"
    ]
    chance = Random("1/one")
    assert drawn == [chance.random() for _ in drawn] and len(drawn) > 10
