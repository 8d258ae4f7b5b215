"""Who takes part in what: participations of branches, conversations, and what stands at each agent's desk."""

from __future__ import annotations

from dataclasses import field
from typing import TypeVar

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.inputs import AgentMessage, Identity, Reason
from aseme_dsl.runtime.chart.plan import BranchInfo
from aseme_dsl.runtime.conversation.invitations import Invitations, Part
from aseme_dsl.runtime.message.acl import AgentIdentifier

MESSAGES = 1_000_000
"""So many messages a conversation has at the most, unless the project says otherwise."""

K = TypeVar("K")
V = TypeVar("V")

REMEMBERED = 4096
"""So many messages from elsewhere are known again, and of so many conversations that are over it is known who
has left them."""


def remember(known: dict[K, V], key: K, value: V) -> bool:
    """Know a value by its key, as the newest of `REMEMBERED`; whether the oldest is forgotten for it."""
    known[key] = value
    is_full = len(known) > REMEMBERED
    if is_full:
        del known[next(iter(known))]
    return is_full


@dataclass(slots=True)
class Participation:
    """A protocol branch that is entered: in which conversation it takes part, and what it has not taken."""

    info: BranchInfo
    conversation: str | None = None
    waiting: dict[Identity, AgentMessage] = field(default_factory=dict)
    taken: dict[tuple[str, str, str], AgentMessage] = field(default_factory=dict)
    """The last one taken of each kind and sender, the newest at the end."""
    answered: dict[str, AgentMessage] = field(default_factory=dict)
    """The last one taken of each sender: what is sent to it next is an answer to that."""
    said: dict[str, object] = field(default_factory=dict)
    """What it has sent last of each type of message."""
    completed: tuple[tuple[str, str], ...] = ()
    """Agents that have completed, each with its participant: lost once no message of them waits."""
    told: dict[str, str] = field(default_factory=dict)
    """The performative of what it has sent each agent last."""
    spoken: dict[str, int] = field(default_factory=dict)
    """In which step of the agent it has sent each agent the last message."""
    was_full: bool = False
    farewell: frozenset[str] = frozenset()
    """The agents that it has sent a message because it ends early."""
    suspended: bool = False
    """Whether the branch was left and may be resumed."""

    @property
    def part(self) -> Part:
        """The protocol and the participant."""
        return self.info.protocol, self.info.participant


@dataclass(frozen=True, slots=True)
class SaidOutside:
    """A message that agents which are not of the team were sent."""

    performative: str
    message: str
    receivers: tuple[str, ...]


@dataclass(slots=True)
class Conversation:
    """Who takes part or is invited, by participant."""

    protocol: str
    members: dict[str, list[str]] = field(default_factory=dict)
    past: dict[tuple[str, str], Reason] = field(default_factory=dict)
    """Whose part is over, by agent and participant, and why."""
    absent: frozenset[tuple[str, str]] = frozenset()
    """Those of `past` who may only be out of reach: they take part again if they come back."""
    places: dict[tuple[str, str], Participation] = field(default_factory=dict)
    """The branches here that take part, by agent and participant."""
    chosen: set[str] = field(default_factory=set)
    """The participants of which an agent here has invited those who take part: no other agent does."""
    invitations: int = 0
    """How many of its messages wait here for a participant to be entered or free."""
    outsiders: dict[str, tuple[AgentIdentifier, ...]] = field(default_factory=dict)
    """Who is to get what is said to an agent that is not of the team."""
    said_outside: dict[str, SaidOutside] = field(default_factory=dict)
    """What was said to such agents, by what an answer calls it, the newest last."""
    left: int = MESSAGES
    """How many more messages it may have, of those that are sent or come here; below 0 it is over."""
    forgotten: bool = False
    """Whether more was said to them than is remembered."""

    @property
    def is_exhausted(self) -> bool:
        """Whether it has had all the messages that it may have, and is over for all."""
        return self.left < 0

    def note(self, name: str, performative: str, message: str, receiver: str) -> None:
        """Remember that an agent that is not of the team was sent a message."""
        known = self.said_outside.get(name)
        receivers = (receiver,) if known is None else (*known.receivers, receiver)
        if remember(self.said_outside, name, SaidOutside(performative, message, receivers)):
            self.forgotten = True


@dataclass(slots=True)
class Desk:
    """An agent here: its branches that are entered, those of them that are free, and what waits for one."""

    branches: dict[str, Participation] = field(default_factory=dict)
    free: dict[Part, dict[str, Participation]] = field(default_factory=dict)
    invitations: Invitations = field(default_factory=Invitations)
    leaving: Reason | None = "left"
    """Why a part of the agent ends now, if it has not reached its END; None: the run is over."""
    heard: dict[tuple[object, ...], None] = field(default_factory=dict)
    """The messages from elsewhere that came last."""

    returned: dict[Identity, None] = field(default_factory=dict)
    """The messages that were answered when the part ended in which they waited, the newest last."""

    def first_free(self, part: Part) -> Participation | None:
        """The branch of a participant that was free first."""
        return next(iter(self.free.get(part, {}).values()), None)

    def was_heard(self, message: tuple[object, ...]) -> bool:
        """Whether a message has come before; from now on it has."""
        if message in self.heard:
            return True
        remember(self.heard, message, None)
        return False
