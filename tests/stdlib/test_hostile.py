"""External agents that do not keep to a protocol of the library: nobody waits for ever, and nobody fails."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from tests.runtime.playing import MS, Played
from tests.stdlib.hostile import (
    MALLORY,
    Kind,
    Mallory,
    Move,
    against,
    endings,
    finish,
    left_waiting,
    openers_of,
    received_by,
    sent_by,
    taken,
    team_of,
    wrongs,
)
from tests.stdlib.leaving import AGENTS
from tests.stdlib.library import PROTOCOLS, Protocol, protocol
from tests.support.lanes import alternating

WAYS: dict[str, Callable[[list[Kind]], list[Move]]] = {
    "in order": lambda kinds: [Move(*kind) for kind in kinds],
    "each twice": lambda kinds: [Move(*kind) for kind in kinds for _ in range(2)],
    "backwards": lambda kinds: [Move(*kind) for kind in reversed(kinds)],
    "at their time": lambda kinds: [Move(*kind, after=900) for kind in kinds],
    "late": lambda kinds: [Move(*kind, after=75_000) for kind in kinds],
    "again and again": lambda kinds: [Move(*kind, after=130) for kind in kinds * 10],
    "silent": lambda kinds: [],
}
"""What a hostile agent makes of the moves of its part."""


@pytest.mark.parametrize(("who", "way"), alternating(AGENTS, WAYS), ids=str)
def test_nobody_waits_for_a_hostile_agent(who: tuple[str, str], way: str) -> None:
    """The others' parts end, with an ending of the protocol, and they agree on it."""
    name, agent = who
    item = protocol(name)
    run = against(item, agent, WAYS[way](sent_by(item, item.parts[agent])))
    if (name, agent, way) == ("subscribe", "ann", "silent"):  # who never has enough is told for ever
        assert left_waiting(run) == ["bob"]
    else:
        assert wrongs(item, run, agent) == []


@pytest.mark.parametrize(("name", "agent"), AGENTS, ids=str)
def test_what_is_taken_from_a_hostile_agent_is_said_by_its_part(name: str, agent: str) -> None:
    """It says all that anybody may say, as every part, to everybody."""
    item = protocol(name)
    part = item.parts[agent]
    team, records = team_of(item, {}, [agent])
    mallory = Mallory(team, name, part, [], [])
    if agent == next(iter(item.parts)):
        mallory.open(100, *sent_by(item, part)[0])
    else:
        mallory.register()

    def say_all() -> None:
        for as_part in dict.fromkeys(item.parts.values()):
            for kind in sent_by(item, as_part):
                for to in item.parts if mallory.conversation else ():
                    mallory.say(to, *kind, as_part, mallory.conversation)

    for moment in range(105, 4000, 310):
        team.driver.at(moment * MS, say_all)
    run = finish(team, records)
    assert wrongs(item, run, agent) == []
    for _, taker, sender, kind in taken(run):
        if sender == MALLORY:
            assert kind in received_by(item, item.parts[taker])
            assert kind in sent_by(item, part)


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


@pytest.mark.parametrize("item", PROTOCOLS, ids=str)
def test_what_opens_a_part(item: Protocol) -> None:
    """Nothing that takes back, rejects or reports."""
    assert {kind[0] for kind in openers_of(item)} <= set(
        "request query_if query_ref request_when propose subscribe cfp inform proxy".split()
    )


def strangers_moves(item: Protocol, *, openers: bool) -> Iterator[tuple[str, Kind, str]]:
    """To whom, what and as which part: all that anybody may say, to everybody."""
    opening = openers_of(item)
    for part in dict.fromkeys(item.parts.values()):
        for kind in sent_by(item, part):
            for to in item.parts if openers or kind not in opening else ():
                yield to, kind, part


def with_a_stranger(
    item: Protocol, *, openers: bool, since: int = 60, sender: str = MALLORY, answers: str = ""
) -> Played:
    """A stranger that knows the conversation says everything to everybody, again and again."""
    team, records = team_of(item, {})
    stranger = Mallory(team, item.name, "", [], [])

    def say_all() -> None:
        for to, kind, part in strangers_moves(item, openers=openers):
            stranger.say(to, *kind, part, f"{item.name}-ann-1", sender=sender, answers=answers)

    for moment in range(since, 4000, 470):
        team.driver.at(moment * MS, say_all)
    return finish(team, records)


@pytest.mark.parametrize("item", PROTOCOLS, ids=str)
def test_a_stranger_in_a_known_conversation_changes_nothing(item: Protocol) -> None:
    """It sends every move but those that open, again and again, to everybody, and knows the conversation."""
    run = with_a_stranger(item, openers=False)
    assert endings(run) == endings(finish(*team_of(item, {})))
    assert [entry for entry in taken(run) if entry[2] == MALLORY] == []
    assert left_waiting(run) == []


@pytest.mark.parametrize("item", PROTOCOLS, ids=str)
def test_nor_does_it_with_what_opens(item: Protocol) -> None:
    """Once all is over it may open a conversation of the same name, with who had no part in the first."""
    run = with_a_stranger(item, openers=True)
    without = finish(*team_of(item, {}))
    assert {agent: ending for agent, ending in endings(run).items() if agent in endings(without)} == endings(
        without
    )
    over = max(record["time"] for record in without.of("conversation"))
    assert [entry for entry in taken(run) if entry[2] == MALLORY and entry[0] <= over] == []
    assert {agent for _, agent, sender, _ in taken(run) if sender == MALLORY}.isdisjoint(endings(without))
    assert left_waiting(run) == []


@pytest.mark.parametrize("item", PROTOCOLS, ids=str)
def test_nor_does_it_under_the_name_of_another(item: Protocol) -> None:
    """It says to be an agent of the team, and answers what that one was asked."""
    without = finish(*team_of(item, {}))
    for agent in item.parts:
        run = with_a_stranger(item, openers=True, sender=agent, answers="ann-2")
        assert endings(run) == endings(without)
        assert taken(run) == taken(without)
        assert left_waiting(run) == []


@pytest.mark.parametrize("item", PROTOCOLS, ids=str)
def test_a_stranger_with_a_conversation_of_its_own_disables_nobody(item: Protocol) -> None:
    """What does not open the protocol takes no instance: the conversation of the team is as without it."""
    team, records = team_of(item, {})
    stranger = Mallory(team, item.name, "", [], [])

    def say_all() -> None:
        for to, kind, part in strangers_moves(item, openers=False):
            stranger.say(to, *kind, part, "of-mallory")

    team.driver.at(10 * MS, say_all)
    run = finish(team, records)
    assert endings(run) == endings(finish(*team_of(item, {})))
    assert left_waiting(run) == []


@pytest.mark.parametrize("item", PROTOCOLS, ids=str)
def test_a_stranger_that_was_there_first_has_a_conversation_of_its_own(item: Protocol) -> None:
    """It has guessed the name that the team's would have; the others are busy with it, and that is all."""
    run = with_a_stranger(item, openers=True, since=10)
    first = next(iter(item.parts))
    opened = {record["conversation"] for record in run.of("conversation", agent=first)}
    assert opened == {f"{item.name}-ann-2"}
    assert endings(run)[first] in ("UNKNOWN", "NOBODY", "WITHDRAWN")
    assert [entry for entry in taken(run) if entry[1] == first and entry[2] == MALLORY] == []
    assert left_waiting(run) == []
