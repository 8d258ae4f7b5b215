"""Agents of the team that leave a protocol before its end: the others' parts end, and they agree on how."""

from __future__ import annotations

import pytest

from tests.stdlib.hostile import endings, finish, team_of, wrongs
from tests.stdlib.leaving import AGENTS, ALL, WAYS, ends_in_errors, moments, of, swaps
from tests.stdlib.library import Protocol, protocol
from tests.support.lanes import alternating


@pytest.mark.parametrize(("who", "way"), alternating(AGENTS, WAYS), ids=str)
def test_an_agent_leaves_at_any_moment(who: tuple[str, str], way: str) -> None:
    name, agent = who
    item = protocol(name)
    found = {}
    for moment in moments(name, agent, way):
        run = WAYS[way](item, agent, moment)
        wrong = wrongs(item, run, agent) + [str(record) for record in run.of("error")]
        took_part = run.of("conversation", agent=agent)
        said = {other: ending for other, ending in endings(run).items() if other != agent}
        # Only the client hears from the one whom a recruiter has found.
        heard = {ending for other, ending in said.items() if item.parts[other] != "recruiter"}
        if took_part and way != "returns" and {"TIMED_OUT", "UNKNOWN", "NOT_UNDERSTOOD"} & heard:
            wrong += [f"they are not told that it has left: {said}"]
        if wrong:
            found[moment] = wrong
    assert found == {}


def test_who_plays_another_role_is_replaced() -> None:
    run = WAYS["changes role"](protocol("request"), "bob", 1.1)
    assert [r["reason"] for r in run.of("conversation", what="leave", agent="bob")] == ["replaced"]


@pytest.mark.parametrize(("name", "agent"), AGENTS if ALL else AGENTS[:2], ids=str)
def test_nobody_leaves_by_a_swap(name: str, agent: str) -> None:
    """It is refused while its states are in the way, and the conversation goes on without a change."""
    item = protocol(name)
    run = swaps(item, agent, 0.12)
    assert {record["what"] for record in run.of("swap")} == {"refused"}
    assert endings(run) == endings(finish(*team_of(item, {})))


def activities_of(item: Protocol, agent: str) -> list[str]:
    states = of(item).plan(f"{item.parts[agent]}_role").states
    return [state.activity for state in states if state.activity in item.acts]


@pytest.mark.parametrize(("who", "caught"), alternating(AGENTS, [True, False]), ids=str)
def test_any_activity_of_an_agent_fails(who: tuple[str, str], caught: bool) -> None:
    name, agent = who
    item = protocol(name)
    found = {}
    for activity in activities_of(item, agent):
        if wrong := wrongs(item, ends_in_errors(item, agent, activity, caught=caught), agent):
            found[activity] = wrong
    assert found == {}
