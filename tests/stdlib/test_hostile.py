"""External agents that do not keep to a protocol of the library: nobody waits for ever, and nobody fails."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.stdlib.hostile import (
    Kind,
    Mallory,
    Move,
    against,
    endings,
    finish,
    left_waiting,
    sent_by,
    team_of,
)
from tests.stdlib.library import PROTOCOLS, protocol

WAYS: dict[str, Callable[[list[Kind]], list[Kind]]] = {
    "in order": lambda moves: moves,
    "each twice": lambda moves: [move for move in moves for _ in range(2)],
    "backwards": lambda moves: moves[::-1],
    "silent": lambda moves: [],
}
"""What a hostile agent makes of the moves of its part."""


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize(
    ("name", "agent"), [(item.name, agent) for item in PROTOCOLS for agent in item.parts], ids=str
)
def test_nobody_waits_for_a_hostile_agent(name: str, agent: str, way: str) -> None:
    item = protocol(name)
    moves = [Move(*move) for move in WAYS[way](sent_by(item, item.parts[agent]))]
    run = against(item, agent, moves)
    assert left_waiting(run) == []
    assert run.of("error") == []


def test_an_external_agent_that_never_answers_is_told_that_it_is_over() -> None:
    """The award goes to others; at its end the manager takes back what it has asked."""
    item = protocol("contract_net")
    team, records = team_of(item, {}, ["dan"])
    mallory = Mallory(team, item.name, "contractor", [], [])
    mallory.register()
    run = finish(team, records)
    assert endings(run)["ann"] == "DONE"
    assert [message.performative for message in mallory.heard if message.conversation] == ["cfp", "cancel"]


@pytest.mark.parametrize("name", ["auction", "dutch_auction"])
def test_who_never_offers_hears_no_more_than_the_auction(name: str) -> None:
    item = protocol(name)
    team, records = team_of(item, {}, ["bob"])
    mallory = Mallory(team, item.name, "bidder", [], [])
    mallory.register()
    run = finish(team, records)
    assert left_waiting(run) == []
    heard = [message.performative for message in mallory.heard if message.conversation]
    assert heard[-1] == "inform" and "cancel" not in heard
