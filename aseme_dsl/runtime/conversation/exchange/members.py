"""Members: who is here, who plays what, and who takes part in which conversation."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import Reason
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.conversation.directory import Directory
from aseme_dsl.runtime.conversation.invitations import Part
from aseme_dsl.runtime.conversation.participation import MESSAGES, Conversation, Desk, Participation
from aseme_dsl.runtime.ports import Receiver


@dataclass(slots=True)
class Members:
    """The agents and the conversations that are known in this process."""

    directory: Directory
    limit: int = MESSAGES
    """How many messages a conversation may have."""
    agents: dict[str, Receiver] = field(default_factory=dict)
    """Those of this process."""
    plans: dict[str, Plan] = field(default_factory=dict)
    """Of all agents, also of those in other processes, in the team's order."""
    desks: dict[str, Desk] = field(default_factory=dict)
    conversations: dict[str, Conversation] = field(default_factory=dict)
    over: dict[str, dict[tuple[str, str], Reason]] = field(default_factory=dict)
    """Who has left the conversations that are forgotten here but may continue elsewhere, the newest last."""
    held: str = ""
    """Why the agents here begin no conversation now, nor take part in a further one; empty if they may."""
    alike: set[frozenset[str]] = field(default_factory=set)
    """Pairs of versions of protocols that agents can play with each other although their messages differ."""
    opened: dict[tuple[str, str], int] = field(default_factory=dict)
    """How many conversations of a protocol an agent has opened."""
    _playing: dict[Part, list[str]] | None = None
    """Who plays a participant, in the team's order, once it was asked for."""

    def join_elsewhere(self, name: str, plan: Plan) -> None:
        """An agent of the team runs in another process, with this plan; it counts in the team's order."""
        self.plans[name] = plan
        self._playing = None
        self.directory.expect(name, plan)

    def renew(self, plans: Mapping[str, Plan]) -> None:
        """Agents follow these plans now."""
        self.plans.update(plans)
        self._playing = None
        for name, plan in plans.items():
            self.directory.follows(name, plan)

    def plays_alike(self, mine: str, theirs: str) -> bool:
        """Whether agents that play these versions of a protocol can take part in one conversation."""
        return mine == theirs or frozenset((mine, theirs)) in self.alike

    def known(self, name: str, protocol: str) -> Conversation:
        """The conversation with this name, which may be new here."""
        conversation = self.conversations.get(name)
        if conversation is None:
            past = self.over.pop(name, {})
            conversation = self.conversations[name] = Conversation(protocol, past=past, left=self.limit)
        return conversation

    def begin(self, protocol: str, agent: str, life: str) -> str:
        """Open a conversation; its name. `life` tells one start of a process from another."""
        while True:
            number = self.opened[protocol, agent] = self.opened.get((protocol, agent), 0) + 1
            name = f"{protocol}-{agent}-{life}{number}"
            if (
                name not in self.conversations and name not in self.over
            ):  # so may an external agent call its own
                break
        self.conversations[name] = Conversation(protocol, left=self.limit)
        return name

    def of(self, place: Participation | None) -> Conversation | None:
        """The conversation of a branch, if it is in one."""
        return self.conversations.get((place.conversation or "") if place is not None else "")

    def players(self, protocol: str, participant: str) -> list[str]:
        """The agents of the team that play a participant, in the team's order."""
        return self._by_part().get((protocol, participant), [])

    def protocols(self) -> Iterable[str]:
        """The protocols that some agent of the team plays."""
        return dict.fromkeys(protocol for protocol, _ in self._by_part())

    def _by_part(self) -> dict[Part, list[str]]:
        playing = self._playing
        if playing is None:
            playing = self._playing = {}
            for name, plan in self.plans.items():
                for part in dict.fromkeys((info.protocol, info.participant) for info in plan.branches):
                    playing.setdefault(part, []).append(name)
        return playing

    def present(self, agent: Receiver, protocol: str, participant: str) -> list[str]:
        """The other agents that play a participant and are there, in the team's order."""
        players = [
            name
            for name in self.players(protocol, participant)
            if name != agent.name and not self.directory.is_gone(name)
        ]
        outside = self.directory.players(protocol, participant)
        return players + [name for name in outside if name not in self.plans]

    def invite(self, place: Participation, name: str, part: str) -> str:
        """An agent shall take part, if it does not yet; the reason why it cannot."""
        members = self.conversations[place.conversation or ""].members.setdefault(part, [])
        if name in members:
            return ""
        _, most = place.info.size_of(part)
        if most is not None and len(members) >= most:
            return f"{', '.join(members)} takes part as {part} already"
        members.append(name)
        self.conversations[place.conversation or ""].chosen.add(part)
        return ""


__all__ = ["Members"]
