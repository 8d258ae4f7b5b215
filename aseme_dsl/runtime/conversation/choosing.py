"""Choosing: which agent of several gets a message to `one` of those that play a participant."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping, Sequence

from aseme_dsl.runtime.conversation.participation import Conversation, Desk
from aseme_dsl.runtime.ports import Receiver


class Choosing:
    """Whom each agent has addressed how long ago, for those that choose one of several."""

    def __init__(self) -> None:
        self._count = itertools.count(1)
        self._addressed: dict[tuple[str, str], int] = {}

    def sent(self, agent: Receiver, receivers: Iterable[str]) -> None:
        """An agent has sent a message."""
        if agent.plan.chooses:
            number = next(self._count)
            self._addressed.update(((agent.name, name), number) for name in receivers)

    def one_of(
        self,
        agent: Receiver,
        players: Sequence[str],
        asked: Iterable[str],
        desk: Desk,
        conversations: Mapping[str, Conversation],
    ) -> str | None:
        """The player that the agent addressed least recently, of several the first in the team's order.

        Those with which it has an open conversation come last; those that are `asked` in this one do not
        count.
        """
        busy = {
            name
            for place in desk.branches.values()
            if (conversation := conversations.get(place.conversation or "")) is not None
            for part, names in conversation.members.items()
            for name in names
            if (name, part) not in conversation.past
        }
        left = [name for name in players if name not in set(asked)]
        return min(
            left,
            key=lambda name: (name in busy, self._addressed.get((agent.name, name), 0)),
            default=None,
        )


__all__ = ["Choosing"]
