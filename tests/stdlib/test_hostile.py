"""External agents that do not keep to a protocol of the library: nobody waits for ever, and nobody fails."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from aseme_dsl.codegen.opening import openings_of
from tests.runtime.playing import MS
from tests.stdlib.hostile import (
    MALLORY,
    Kind,
    Mallory,
    Move,
    against,
    aip_of,
    endings,
    finish,
    left_waiting,
    sent_by,
    taken,
    team_of,
)
from tests.stdlib.library import PROTOCOLS, Protocol, generated, protocol

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


def openers_of(item: Protocol) -> set[Kind]:
    eac = generated(item.name).system.eac(item.name)
    assert eac is not None
    return {kind for part in aip_of(item).participants for kind in openings_of(eac, part)}


@pytest.mark.parametrize("item", PROTOCOLS, ids=str)
def test_what_opens_a_part(item: Protocol) -> None:
    """Nothing that takes back, rejects or reports."""
    assert {kind[0] for kind in openers_of(item)} <= set(
        "request query_if query_ref request_when propose subscribe cfp inform proxy".split()
    )


@pytest.mark.parametrize("item", [item for item in PROTOCOLS if item.name != "recruiting"], ids=str)
def test_a_stranger_in_a_known_conversation_changes_nothing(item: Protocol) -> None:
    """It sends every move but those that open, again and again, to everybody, and knows the conversation.

    Not so in recruiting: the client takes the one who agrees first for the one whom the recruiter has found.
    """
    team, records = team_of(item, {})
    openers = openers_of(item)
    stranger = Mallory(team, item.name, "", [], [])
    for moment in range(60, 4000, 470):
        for part in dict.fromkeys(item.parts.values()):
            for performative, message in sent_by(item, part):
                for to in item.parts if (performative, message) not in openers else ():
                    team.driver.at(
                        moment * MS,
                        lambda to=to, performative=performative, message=message, part=part: stranger.say(
                            to, performative, message, part, f"{item.name}-ann-1"
                        ),
                    )
    run = finish(team, records)
    assert endings(run) == endings(finish(*team_of(item, {})))
    assert [entry for entry in taken(run) if entry[2] == MALLORY] == []
    assert left_waiting(run) == []


@pytest.mark.parametrize("item", PROTOCOLS, ids=str)
def test_a_stranger_with_a_conversation_of_its_own_disables_nobody(item: Protocol) -> None:
    """What does not open the protocol takes no instance: the conversation of the team is as without it."""
    team, records = team_of(item, {})
    stranger = Mallory(team, item.name, "", [], [])
    openers = openers_of(item)
    for part in dict.fromkeys(item.parts.values()):
        for performative, message in sent_by(item, part):
            for to in item.parts if (performative, message) not in openers else ():
                team.driver.at(
                    10 * MS,
                    lambda to=to, performative=performative, message=message, part=part: stranger.say(
                        to, performative, message, part, "of-mallory"
                    ),
                )
    run = finish(team, records)
    assert endings(run) == endings(finish(*team_of(item, {})))
    assert left_waiting(run) == []
