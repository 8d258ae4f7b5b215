"""Rounds: who was addressed by the last send to a participant, and who of them has answered."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from typing import NamedTuple

from aseme_dsl.runtime.chart.inputs import LOST, Addressed, AgentMessage, Settled

REMEMBERED = 100
"""So many earlier rounds are kept, so that a late answer to one of them does not count in this one."""

Key = tuple[str, str]
"""The label of a protocol branch, and a participant."""


class Round(NamedTuple):
    """One send to a participant.

    An agent has answered if a message of it was `taken`. It also counts if it is `settled` and no message
    of it waits: else the last bid would be left behind. An agent is settled if it is lost, or what it
    has sent was refused or unexpected.
    """

    key: Key
    agents: tuple[str, ...] = ()
    name: str = ""
    """What answers call the message that was sent."""
    taken: frozenset[str] = frozenset()
    settled: frozenset[str] = frozenset()
    earlier: tuple[str, ...] = ()
    """What answers call the messages of earlier rounds, the newest last."""

    def count(self, waiting: Collection[str]) -> int:
        """How many have answered, while messages of some agents wait."""
        return sum(
            name in self.taken or (name in self.settled and name not in waiting) for name in self.agents
        )


class Rounds:
    """The rounds of one chart."""

    __slots__ = ("_rounds",)

    def __init__(self) -> None:
        self._rounds: dict[Key, Round] = {}

    def sent(self, branch: str, participant: str) -> None:
        """A transition sends to a participant: no agent has been addressed yet, none has answered."""
        key = branch, participant
        before = self._rounds.get(key)
        earlier = () if before is None else (*before.earlier, before.name)[-REMEMBERED:]
        self._rounds[key] = Round(key, earlier=tuple(filter(None, earlier)))

    def addressed(self, item: Addressed) -> None:
        """It is known who gets a message."""
        key = item.branch, item.participant
        before = self._rounds.get(key)
        if before is None or before.name:  # an activity has sent it
            self.sent(item.branch, item.participant)
        self._rounds[key] = self._rounds[key]._replace(agents=item.agents, name=item.name)

    def settled(self, item: Settled) -> None:
        """An agent will not answer any more, or has in a way that nothing can take."""
        found = self._rounds.get((item.branch, item.participant))
        if found is not None and item.in_reply_to not in found.earlier:
            self._rounds[found.key] = found._replace(settled=found.settled | {item.agent})

    def taken(self, mail: AgentMessage) -> None:
        """A transition or an activity takes an agent message."""
        found = self._rounds.get((mail.branch, mail.participant))
        if found is not None and mail.performative != LOST and mail.in_reply_to not in found.earlier:
            self._rounds[found.key] = found._replace(taken=found.taken | {mail.sender})

    def forget(self, branch: str) -> None:
        """A branch is entered or left."""
        for key in [key for key in self._rounds if key[0] == branch]:
            del self._rounds[key]

    def count(self, branch: str, participant: str, mail: Iterable[AgentMessage]) -> tuple[int, int]:
        """How many agents were addressed, and how many of them have answered, while `mail` waits."""
        found = self._rounds.get((branch, participant))
        if found is None:
            return 0, 0
        waiting = {
            item.sender for item in mail if item.participant == participant and item.performative != LOST
        }
        return len(found.agents), found.count(waiting)

    def carried(self, labels: Mapping[str, str]) -> Rounds:
        """The same rounds in a chart in which the branches have these labels."""
        new = Rounds()
        for (branch, participant), found in self._rounds.items():
            if branch in labels:
                key = labels[branch], participant
                new._rounds[key] = found._replace(key=key)
        return new

    def save(self) -> tuple[Round, ...]:
        """The rounds as a value."""
        return tuple(self._rounds.values())

    def load(self, saved: Iterable[Round]) -> None:
        """Have the rounds that were saved, and no others."""
        self._rounds = {item.key: item for item in saved}

    def __bool__(self) -> bool:
        return bool(self._rounds)


__all__ = ["Round", "Rounds"]
