"""Hostile participants: external agents that take part in a protocol, and do not keep to it."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from aseme_dsl.amola.aip import Aip
from aseme_dsl.codegen.opening import openings_of
from aseme_dsl.runtime.message.acl import AgentIdentifier, FipaMessage, fipa_name
from aseme_dsl.runtime.team.team import Team
from tests.runtime.playing import MS, SECOND, Played, check_line, make
from tests.stdlib.library import Act, Protocol, disagreement, generated, kind_of

MALLORY = "mallory"
LIMIT = 2 * 3600 * SECOND
"""Longer than any conversation of the library without an hour of silence in it."""

Kind = tuple[str, str]
"""A performative and a message type."""


@dataclass(frozen=True)
class Move:
    """What a hostile agent sends, and how many ms after its last move or what it has heard first."""

    performative: str
    message: str
    after: int = 1

    def __str__(self) -> str:
        return f"{self.after} {self.performative} {self.message}"


class Mallory:
    """An external agent with the moves that it makes once it is in a conversation, whatever it hears."""

    def __init__(
        self, team: Team, protocol: str, part: str, moves: Iterable[Move], to: Iterable[str]
    ) -> None:
        self.team, self.protocol, self.part = team, protocol, part
        self.moves, self.to = tuple(moves), tuple(to)
        self.heard: list[FipaMessage] = []
        self.conversation = ""
        team.conversations.add_external_agent(MALLORY, self._hear)

    def register(self) -> None:
        """Offer to take part."""
        service = {"services": [{"type": f"{self.protocol}.{self.part}"}]}
        content = json.dumps({"action": "register", "description": service})
        message = FipaMessage("request", AgentIdentifier(MALLORY), (), content)
        self.team.driver.at(0, lambda: self.team.conversations.receive_external("df", message))

    def open(self, at: int, performative: str, message: str) -> None:
        """Open a conversation at a moment, in ms, and go on with the moves."""
        self.conversation = "mallory-1"
        moment = at * MS
        self.team.driver.at(moment, lambda: self._say(performative, message))
        self._go_on(moment)

    def _hear(self, message: FipaMessage) -> None:
        self.heard.append(message)
        if not self.conversation and message.conversation:
            self.conversation = message.conversation
            self._go_on(self.team.driver.clock.now())

    def _go_on(self, moment: int) -> None:
        for move in self.moves:
            moment += move.after * MS
            self.team.driver.at(moment, lambda move=move: self._say(move.performative, move.message))

    def _say(self, performative: str, message: str) -> None:
        for name in self.to:
            self.say(name, performative, message, self.part, self.conversation)

    def say(
        self,
        to: str,
        performative: str,
        message: str,
        part: str,
        conversation: str,
        *,
        sender: str = MALLORY,
        answers: str = "",
    ) -> None:
        """Say something at once, as this participant, perhaps under another name or to another question."""
        parameters = (("X-message", message), ("X-participant", part))
        self.team.conversations.receive_external(
            to,
            FipaMessage(
                fipa_name(performative),
                AgentIdentifier(sender),
                (AgentIdentifier(to),),
                "{}",
                protocol=self.protocol,
                conversation=conversation,
                in_reply_to=answers,
                parameters=parameters,
            ),
        )


def aip_of(item: Protocol) -> Aip:
    return next(aip for aip in generated(item.name).system.aips if aip.name == item.name)


def sent_by(item: Protocol, part: str) -> list[Kind]:
    """What a participant may send."""
    found = next(p for p in aip_of(item).participants if p.name == part)
    return [(message.performative, message.message) for message in found.sends]


def received_by(item: Protocol, part: str) -> list[Kind]:
    """What a participant may receive."""
    found = next(p for p in aip_of(item).participants if p.name == part)
    return [(message.performative, message.message) for message in found.receives]


def openers_of(item: Protocol) -> set[Kind]:
    """What begins a part in the protocol."""
    eac = generated(item.name).system.eac(item.name)
    assert eac is not None
    return {kind for part in aip_of(item).participants for kind in openings_of(eac, part)}


def team_of(
    item: Protocol, acts: Mapping[str, Act], without: Iterable[str] = (), **options: Any
) -> tuple[Team, list[dict[str, Any]]]:
    """The team of a protocol, less some agents. Who begins waits until all others are there."""
    acts = {
        **item.acts,
        item.first: Act(takes=0.05, sets=item.acts[item.first].sets, says=item.acts[item.first].says),
        **acts,
    }
    made = generated(item.name)
    agents = [(name, f"{part}_role") for name, part in item.parts.items() if name not in without]
    classes = {name: kind_of(made, name, what) for name, what in acts.items()}
    return make(made, classes, agents=agents, until=LIMIT, **options)


def finish(team: Team, records: list[dict[str, Any]]) -> Played:
    result = team.run()
    for record in records[::7]:
        check_line(record)
    return Played(team, result, records)


def against(item: Protocol, agent: str, moves: Iterable[Move], acts: Mapping[str, Act] = {}) -> Played:
    """A run in which a hostile agent plays the part of an agent of the team."""
    team, records = team_of(item, acts, [agent])
    part = item.parts[agent]
    mallory = Mallory(team, item.name, part, moves, [name for name in item.parts if name != agent])
    if agent == next(iter(item.parts)):
        mallory.open(100, *sent_by(item, part)[0])
    else:
        mallory.register()
    return finish(team, records)


def endings(run: Played) -> dict[str, str]:
    """How each agent says that its part has ended, the last word counts."""
    return ended(run.records)


def ended(records: Iterable[Mapping[str, Any]]) -> dict[str, str]:
    """The same of the records of a trace."""
    return {
        record["agent"]: record["text"].removeprefix("ended ")
        for record in records
        if record["kind"] == "log" and record["text"].startswith("ended ")
    }


def left_waiting(run: Played) -> list[str]:
    """The agents that took part and still do at the end of the run, which ends all parts."""
    inside: dict[str, int] = {}
    for record in run.of("conversation"):
        if record["what"] in ("open", "join"):
            inside[record["agent"]] = inside.get(record["agent"], 0) + 1
        elif record["what"] == "leave" and record["time"] < LIMIT:
            inside[record["agent"]] -= 1
    return [agent for agent, count in inside.items() if count > 0]


def taken(run: Played) -> list[tuple[int, str, str, Kind]]:
    """Every message that an agent has taken: time, agent, sender and kind."""
    known: dict[tuple[str, int], Kind] = {}
    for record in run.records:
        if record["kind"] == "agent_message":
            known[record["agent"], record["sequence"]] = (record["performative"], record["message"])
        elif record["kind"] == "received":
            known[tuple(record["input"])] = (record["performative"], record["message"])
    found = []
    for step in run.of("step"):
        for sender, sequence in step.get("agent_messages", ()):
            kind = known.get((sender, sequence))
            if kind is not None:
                found.append((step["time"], step["agent"], sender, kind))
    return found


def sent(run: Played) -> list[tuple[int, str, str, Kind]]:
    """Every message that an agent of the team has sent: time, sender, receiver and kind."""
    return [
        (record["time"], record["agent"], to, (record["performative"], record["message"]))
        for record in run.of("agent_message")
        for to in record["to"]
    ]


ENDINGS = tuple(
    "NONE DONE REFUSED FAILED NOT_UNDERSTOOD TIMED_OUT CANCELLED LOST NOBODY LATE UNCONFIRMED UNKNOWN"
    " RETURNED EXPIRED WITHDRAWN NOT_TAKEN".split()
)


def wrongs(item: Protocol, run: Played, hostile: str) -> list[str]:
    """What a run may not show of the other agents, whatever a hostile one has done.

    Each part ends, without an error, with an ending of the protocol. They agree, for some ending of the
    hostile one; but what a broker that lies has said to the client and to the provider only it knows.
    """
    said = {agent: ending for agent, ending in endings(run).items() if agent != hostile}
    took_part = {record["agent"] for record in run.of("conversation") if record["what"] in ("open", "join")}
    found = [f"{agent} still takes part" for agent in left_waiting(run) if agent != hostile]
    found += [
        f"{record['agent']} fails: {record}" for record in run.of("error") if record["agent"] != hostile
    ]
    found += [
        f"{agent} ends with {said.get(agent, 'nothing')}"
        for agent in item.parts
        if agent in took_part - {hostile} and said.get(agent, "NONE") not in ENDINGS[1:]
    ]
    apart = [disagreement(item, {**said, hostile: ending}) for ending in ENDINGS]
    may_lie = item.parts[hostile] == "broker" and hostile not in {agent.name for agent in run.result.agents}
    return found + ([] if "" in apart or may_lie else [apart[0]])
