"""What conversations remember that makes no difference any more, and is forgotten.

What is forgotten, and why nothing reads it later:

- the last messages taken, of each kind: code of activities alone reads them, and none runs here;
- which messages were answered when a part ended: it is asked while an agent takes its inputs in, and between
  two moves none waits;
- that there were places which no message has taken, once there are none;
- the names that answers use for messages: only rounds of answers compare them, so they stay if a protocol
  counts answers;
- which performative an agent was sent last: a part that ends asks only whether an answer was asked for, and
  not even that of agents that have answered;
- what was said last, of each type: a part that ends early repeats it only with a performative of farewell.

An agent that has ended takes nothing: the news of a loss does nothing there, and `not_understood` is never
answered. So both may be dropped on their way. An agent message is not dropped: it is answered.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

from aseme_dsl.proofs.explore.surroundings import Underway, Ways
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.chart.inputs import AgentMessage
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.conversation.losses import ASKING, FAREWELLS
from aseme_dsl.runtime.conversation.participation import Desk, Participation
from aseme_dsl.runtime.message.acl import NOT_UNDERSTOOD, AclMessage

_HEARD = AgentMessage("", "", "", None, "", "", ("", 0))
"""Stands for a message that was taken of an agent, if only that matters."""


@dataclass(frozen=True, slots=True)
class Dropped:
    """Something that was dropped on its way, with the number of messages before it that keep their order."""

    sender: str
    receiver: str
    item: Underway
    before: int


class Spent:
    """Forgets what makes no difference any more in the conversations of a team."""

    def __init__(self, plans: Sequence[Plan]) -> None:
        self._counts = any(info.counts for plan in plans for info in plan.branches)
        """Whether answers are counted: then it matters which message they name."""
        self.heard: list[Dropped] | None = None
        """What is dropped from now on, if something asks for it."""

    def sent(self, acl: AclMessage) -> AclMessage:
        """A message that is sent, without the names that no answer uses."""
        return acl if self._counts else replace(acl, reply_with="", in_reply_to="")

    def forget(self, desk: Desk) -> None:
        """Forget what makes no difference any more at the desk of an agent, between two moves."""
        desk.returned.clear()
        for part in [part for part, places in desk.free.items() if not places]:
            del desk.free[part]
        for place in desk.branches.values():
            self._forget(place)

    def _forget(self, place: Participation) -> None:
        place.taken.clear()
        for name, mail in place.answered.items():
            if mail is not _HEARD and not self._counts:
                place.answered[name] = _HEARD
        for name, performative in [*place.told.items()]:
            if name in place.answered:
                del place.told[name]
            elif performative != "":
                place.told[name] = "request" if performative in ASKING else "inform"
        last = {message for performative, message in place.info.sends if performative in FAREWELLS}
        for message in [message for message in place.said if message not in last]:
            del place.said[message]

    def drop(self, ways: Ways, agents: Mapping[str, Agent], desks: Mapping[str, Desk]) -> None:
        """Drop what is on its way to agents that have ended, and that does nothing when it comes there."""
        for (sender, receiver), waiting in ways.ways.items():
            if waiting and agents[receiver].over:
                kept: list[Underway] = []
                for item in waiting:
                    if not _does_nothing(item, desks[receiver]):
                        kept.append(item)
                    elif self.heard is not None:
                        before = sum(not other.overtakes for other in kept)
                        self.heard.append(Dropped(sender, receiver, item, before))
                if len(kept) < len(waiting):
                    waiting[:] = kept


def _does_nothing(item: Underway, desk: Desk) -> bool:
    """Whether something does nothing when it comes to an agent that has ended: news of a loss, and
    `not_understood`, which is never answered."""
    if item.kind != "mail" or not isinstance(item.give, partial):
        return False
    acl = next((part for part in item.give.args if isinstance(part, AclMessage)), None)
    if acl is not None:
        return acl.performative == NOT_UNDERSTOOD
    place = next((part for part in item.give.args if isinstance(part, Participation)), None)
    return place is not None and desk.branches.get(place.info.label) is not place


__all__ = ["Dropped", "Spent"]
