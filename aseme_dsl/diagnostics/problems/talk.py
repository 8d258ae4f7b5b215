"""Talk: agent messages between the participants of protocols (E205, E226, E512, E53x to E57x, W55x, N75x)."""

from __future__ import annotations

from typing import Literal

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.problems.names import Reserved, reserved_for
from aseme_dsl.diagnostics.wording import a, listed


class ExchangeOutsideProtocol(Problem):
    """What only a participant of a protocol does: send, receive or ask for who is lost."""

    code = "E205"
    what: Literal["sent", "received", "lost", "answered"]

    @property
    def message(self) -> str:
        if self.what == "lost":
            return "who is lost is a participant of a protocol"
        if self.what == "answered":
            return "the answers to an agent message are those of a participant of a protocol"
        return f"an agent message is {self.what} by a participant of a protocol"

    hint = "write it in the `control` of a participant of an `aip`"


class BoundNameTaken(Problem):
    """A name for what a transition takes that something else has."""

    code = "E226"
    name: str
    reserved: Reserved

    @property
    def message(self) -> str:
        return f"`{self.name}` cannot name the received message"

    @property
    def hint(self) -> str:
        return reserved_for(self.name, self.reserved)


class EventWithoutMessage(Problem):
    code = "E512"
    performative: str

    @property
    def message(self) -> str:
        return f"the message of `{self.performative}` is missing"

    @property
    def hint(self) -> str:
        return f"an agent message is `{self.performative} Message from participant`"


class NotAlwaysBound(Problem):
    """A name that another event of the line, or `when` (`on_when`), would not give a message to."""

    code = "E530"
    name: str
    on_when: bool

    @property
    def message(self) -> str:
        return f"`{self.name}` would not be there {'on `when`' if self.on_when else 'when this has happened'}"

    @property
    def hint(self) -> str:
        if self.on_when:
            return "write the condition as a line of its own"
        return "write it as a line of its own, or give all the same name for the same type of message"


class ExceptOfOneAgent(Problem):
    code = "E531"
    message = "one agent has no exceptions"
    hint = "`except` is said of a participant"


class NotAnAgent(Problem):
    """A value of another `type`; `bound` is the name of the agent message that it is."""

    code = "E531"
    type: str
    bound: str | None

    @property
    def message(self) -> str:
        return f"an agent is wanted here, not {a(self.type)}"

    @property
    def hint(self) -> str:
        if self.bound is not None:
            return f"write `sender({self.bound})`"
        return "an agent is a variable of type `agent`, or the sender of what was taken: `sender(b)`"


class NobodyReceives(Problem):
    code = "E532"
    performative: str
    type: str
    lists: bool

    @property
    def message(self) -> str:
        return f"no participant of the protocol receives `{self.performative} {self.type}`"

    @property
    def hint(self) -> str:
        said = f"{self.performative} {self.type}"
        if not self.lists:
            return f"write a line in its control that takes it: `{said} from …`"
        return f"write `receives {said}` in the participant that shall get it"


class MessageHasAName(Problem):
    """`path` is what follows the performative and the type."""

    code = "E533"
    name: str
    path: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"the message is called `{self.name}` here"

    @property
    def hint(self) -> str:
        return f"write `{'.'.join((self.name, *self.path))}`"


class NotTaken(Problem):
    code = "E533"
    performative: str
    type: str
    in_protocol: bool

    @property
    def message(self) -> str:
        return f"no `{self.performative} {self.type}` is taken here"

    @property
    def hint(self) -> str:
        if not self.in_protocol:
            return "agent messages are known in the `control` of a participant of an `aip`"
        line = f"only the line that takes it knows it, `{self.performative} {self.type} from …`"
        return f"{line}: keep what is needed in a variable there"


class InitialAgent(Problem):
    code = "E534"
    type: str

    @property
    def message(self) -> str:
        return f"a variable of type {self.type} has no initial value"

    @property
    def hint(self) -> str:
        value = "sender(b)" if self.type == "agent" else f"topic.state.{self.type}"
        return f"it is set when a message has come: `/ best = {value}`"


class AnswersInAction(Problem):
    code = "E575"
    question: str

    @property
    def message(self) -> str:
        return f"`{self.question}` is used outside a condition"

    hint = "use it in the condition of the transition, in two lines if necessary"


class AnswersOfNobody(Problem):
    code = "E576"
    participant: str
    asked: str

    @property
    def message(self) -> str:
        return f"`{self.participant}` sends `{self.asked}` no message that it could answer"

    @property
    def hint(self) -> str:
        return f"name a participant that `{self.participant}` sends a message to"


class ContentIncomplete(Problem):
    """`missing` are the members, those of inner messages by their paths."""

    code = "E577"
    type: str
    missing: tuple[str, ...]

    @property
    def message(self) -> str:
        fields = listed(self.missing)
        return f"the content of `{self.type}` leaves out {fields}"

    hint = "fill every field, or end with `..` to leave the others at their defaults"


class RestOfNoMessage(Problem):
    code = "E578"
    name: str

    @property
    def message(self) -> str:
        return f"`{self.name}` is not a message"

    hint = "name a message after `..`: a variable, or what was received (`propose Bid b from …` / `{ ..b }`)"


class RestDoesNotFit(Problem):
    """`lacking` are the members that `name`, a message of the type `source`, does not have so."""

    code = "E578"
    name: str
    source: str
    type: str
    lacking: tuple[str, ...]

    @property
    def message(self) -> str:
        fields = listed(self.lacking)
        return f"`{self.name}` is a `{self.source}`, which does not give {fields} of `{self.type}`"

    hint = "fill these fields before `..`"


class DeadlineInThePast(Problem):
    code = "E579"
    message = "the deadline of the answer is not greater than zero"
    hint = "write how long the receiver has: `reply_by 2s`"


class AnswerWithoutMessage(Problem):
    """A word behind `when busy` that is neither `queue` nor `refuse`, and no message behind it."""

    code = "E596"
    word: str

    @property
    def message(self) -> str:
        return f"`{self.word}` alone does not answer an invitation"

    hint = "write `queue`, `refuse`, or a message that the participant sends: `refuse Job { … }`"


class AnswerNotConstant(Problem):
    """A part of the content of an answer that depends on the agent or the invitation."""

    code = "E596"
    message = "the answer of a busy participant must be constant"
    hint = "write a constant; without braces the content is that of the invitation"


class AnswerWithoutContent(Problem):
    """The answer is to say what the invitation says, which is a message of another type."""

    code = "E596"
    performative: str
    type: str
    invitation: str

    @property
    def message(self) -> str:
        return f"`{self.performative} {self.type}` has no content; the invitation is `{self.invitation}`"

    @property
    def hint(self) -> str:
        return f"write `{self.performative} {self.type} {{ … }}` with a value for each field, or `{{ .. }}`"


class NeverInvited(Problem):
    code = "E596"
    participant: str

    @property
    def message(self) -> str:
        return f"nothing invites `{self.participant}`: it opens its conversations itself"

    hint = "remove `when busy`"


class AnswersDiffer(Problem):
    code = "E596"
    participant: str

    @property
    def message(self) -> str:
        return f"a busy `{self.participant}` answers in two ways"

    hint = "say the same wherever the participant is played: an invitation does not name the instance"


class BoundNameUnused(Problem):
    code = "W551"
    name: str

    @property
    def message(self) -> str:
        return f"nothing uses `{self.name}` here"

    hint = "use it, or leave the name out"


class WaitsForEver(Problem):
    """`agent_message` is the performative and the type."""

    code = "W553"
    participant: str
    sender: str
    agent_message: str

    @property
    def message(self) -> str:
        return (
            f"deadlock: `{self.participant}` waits here for `{self.agent_message}`, "
            f"which `{self.sender}` cannot have sent"
        )

    @property
    def hint(self) -> str:
        return (
            f"let `{self.sender}` send it before it waits itself, or end the wait otherwise: "
            f"`after(10s)`, `lost {self.sender}`"
        )


class NoAgentPlays(Problem):
    """`role` is one that plays the participant, of which the team has no agent."""

    code = "W554"
    participant: str
    protocol: str
    least: int
    team: str
    role: str

    @property
    def message(self) -> str:
        return (
            f"`{self.participant}` of `{self.protocol}` wants {_agents(self.least)} at least, and no agent "
            f"of {self.team} plays it"
        )

    @property
    def hint(self) -> str:
        return (
            "its messages reach no agent, and an agent that waits for it waits for ever: give the role "
            f"to an agent of the team, `name : {self.role}`"
        )


class TooFewAgents(Problem):
    """A team that has `present` agents that may take part beside the one that opens the conversation.

    `least` and `most` are what the protocol says; None is any number.
    """

    code = "W554"
    participant: str
    protocol: str
    least: int
    most: int | None
    team: str
    present: int

    @property
    def message(self) -> str:
        there = {0: "no other agent", 1: "one agent"}.get(self.present, f"{self.present} agents")
        return (
            f"`{self.participant}` of `{self.protocol}` wants {_agents(self.least)} at least, and "
            f"{self.team} has {there}"
        )

    @property
    def hint(self) -> str:
        most = "*" if self.most is None else self.most
        return (
            "what is sent to them is sent to none of them then: let more agents play it, or be content with "
            f"fewer: `participant {self.participant} [{max(1, self.present)}..{most}]`"
        )


class NothingLeft(Problem):
    code = "N760"
    type: str

    @property
    def message(self) -> str:
        return f"all fields of `{self.type}` are filled: `..` has no effect"

    hint = "remove `..`"


def _agents(count: int) -> str:
    return f"{count} agent{'' if count == 1 else 's'}"


class SentByTransitionToo(Problem):
    """A message that a transition sends and whose `sends` entry names activities, too."""

    code = "E566"
    agent_message: str
    activities: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"a transition sends `{self.agent_message}`, so no activity may"

    @property
    def hint(self) -> str:
        return f"remove `by {' or '.join(self.activities)}`, or the `send` of the transition"


class SenderNotKnown(Problem):
    """A message from one agent that no participant, or one of several, sends."""

    code = "E567"
    agent: str
    agent_message: str
    senders: tuple[str, ...]
    lists: bool
    """Whether a participant has a list of what it sends; else its lines say it."""

    @property
    def message(self) -> str:
        if not self.senders:
            return f"no other participant sends `{self.agent_message}`, so `{self.agent}` cannot"
        return f"`{self.agent}` may be {' or '.join(self.senders)}: each sends `{self.agent_message}`"

    @property
    def hint(self) -> str:
        if not self.senders and self.lists:
            return "add the message to the `sends` list of the participant that the agent plays"
        if not self.senders:
            return f"write the line that sends it: `/ send {self.agent_message} {{ .. }} to …`"
        return f"write `{self.agent_message} m from {self.senders[0]} [sender(m) == {self.agent}]`"


class AgentAmongOthers(Problem):
    """A message from one agent beside other events, or on a line with `when`."""

    code = "E567"
    agent: str
    message = "a message from one agent stands beside other events"

    @property
    def hint(self) -> str:
        return f"write the events that are not from `{self.agent}` on a line of their own"


class SendsRace(Problem):
    """Two participants that may each send before the other's message has come, and then wait for ever."""

    code = "W575"
    participant: str
    agent_message: str
    other: str
    other_message: str

    @property
    def message(self) -> str:
        return (
            f"`{self.participant}` may send `{self.agent_message}` while `{self.other}` sends "
            f"`{self.other_message}`, and neither can receive the other's message then"
        )

    @property
    def hint(self) -> str:
        return (
            f"let one wait for the other, or receive the other's message after the send: "
            f"`{self.other_message} from {self.other}`"
        )


class ContentNotPrepared(Problem):
    """`ends`: the message is sent on the way to END, where no state can fail."""

    code = "W576"
    performative: str
    type: str
    ends: bool

    @property
    def message(self) -> str:
        failing = "the agent" if self.ends else "the state that is entered"
        return f"nothing prepares the content of `{self.performative} {self.type}`: {failing} fails"

    @property
    def hint(self) -> str:
        return f"write `send {self.performative} {self.type} {{ … }}`, or `{{ .. }}` for defaults"


class ContentNotPreparedInCode(Problem):
    """No Python of the `activities` that run before prepares the message that a part sends."""

    code = "W576"
    performative: str
    type: str
    activities: tuple[str, ...]

    @property
    def message(self) -> str:
        names = " and ".join(f"`{name}`" for name in self.activities)
        said = f"{self.performative} {self.type}"
        return f"the Python of {names} prepares no `{self.type}`: `send {said}` has no content"

    @property
    def hint(self) -> str:
        return f"call `context.prepare({self.type}(…))`, or write `{self.type} {{ .. }}` for defaults"


class SentByAnyActivity(Problem):
    """A message that no transition sends, without the activity that does."""

    code = "N755"
    participant: str
    agent_message: str
    activities: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"any activity of `{self.participant}` may send `{self.agent_message}`"

    @property
    def hint(self) -> str:
        one = self.activities[0] if self.activities else "ActivityThatSends"
        line = f"write `sends {self.agent_message} by {one}`"
        if len(self.activities) > 1:
            return f"{line}, with the activity that sends it: {', '.join(self.activities)}"
        return line


__all__ = [
    "AgentAmongOthers",
    "ContentNotPrepared",
    "ContentNotPreparedInCode",
    "NoAgentPlays",
    "SenderNotKnown",
    "SendsRace",
    "SentByAnyActivity",
    "SentByTransitionToo",
    "TooFewAgents",
    "WaitsForEver",
]
