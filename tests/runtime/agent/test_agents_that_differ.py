"""What is set in agents, and chance, in runs: by the seed, after a crash, and under another version."""

from __future__ import annotations

from random import Random

from aseme_dsl.runtime.team.faults import Crash, Faults
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


def limits(changed: str, before: str = TEAM) -> dict[str, list[object]]:
    """What each agent is given from the swap on."""
    team, records = make(before, until=1 * SECOND)
    team.swap(version(changed), at=250 * MS)
    team.run()
    found: dict[str, list[object]] = {}
    for record in records:
        if record["kind"] == "activity" and record["what"] == "start" and record["time"] > 250 * MS:
            found.setdefault(record["agent"], []).extend(record["arguments"].values())
    return found


def test_what_another_version_sets_in_an_agent_holds_from_the_swap_on() -> None:
    assert limits(TEAM.replace("limit = 80", "limit = 90"))["keeper"][-1] == 91


def test_what_it_sets_for_the_first_time_holds_too() -> None:
    assert limits(TEAM, TEAM.replace(" with limit = 80", ""))["keeper"][-1] == 81


def test_a_variable_keeps_what_it_holds_where_the_same_is_set_or_nothing() -> None:
    counting = TEAM.replace("activities", "control R { repeat Count : / limit = limit + 1 }  activities", 1)
    expected = [82, 83]
    assert limits(counting.replace("limit = index * 100", "limit = 7"), counting)["keeper"] == expected
    assert limits(counting.replace(" with limit = 80", ""), counting)["keeper"] == expected
