"""What goes into a step and what comes out of it: the step itself touches nothing outside its chart."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal, TypeVar, dataclass_transform, get_args

from aseme_dsl.records import dataclass

_T = TypeVar("_T")
_EffectT = TypeVar("_EffectT")


@dataclass_transform(frozen_default=True)
def made_often(kind: type[_T]) -> type[_T]:
    """An immutable dataclass: type checkers enforce it, since a frozen one takes four times as long."""
    return dataclass(slots=True, unsafe_hash=True)(kind)


Identity = tuple[str, int]
"""Who sent something, and which of the sender's it is: (agent, sequence)."""


LOST = "lost"
"""The performative of what tells that an agent's part in a conversation is over; the content says why."""

Reason = Literal[
    "left", "failed", "crashed", "timed_out", "replaced", "incompatible", "exhausted", "completed"
]
"""Why an agent's part in a conversation is over: only what has `completed` has reached its END."""
REASONS: tuple[Reason, ...] = get_args(Reason)


# ---- inputs ------------------------------------------------------------------------------------


@made_often
class Sample:
    """A message on a channel (`vision.state.Ball`), measured at `time` (ns).

    `written_by` is the label of the agent's own region that wrote it, which saw it at once; None for
    messages of others and of activities.
    """

    channel: str
    message: object
    sender: str
    time: int
    identity: Identity
    written_by: str | None = None


@made_often
class Completed:
    """The activity that was started with `token` in the state `label` has returned.

    `outcome` is the outcome, if it has several.
    """

    label: str
    token: int
    outcome: str | None = None


@made_often
class Crashed:
    """The activity that was started with `token` in the state `label` has raised."""

    label: str
    token: int
    reason: str


@made_often
class Happened:
    """An event that an activity raised."""

    name: str


@made_often
class Written:
    """A variable that an activity wrote."""

    variable: str
    value: object


@made_often
class AgentMessage:
    """An agent message for the protocol branch at `branch`, to wait there until something takes it.

    When an agent's part is over, one with the performative `LOST` and without a message comes from that
    agent; its content is a `Reason`.
    """

    branch: str
    performative: str
    message: str
    content: object
    participant: str
    sender: str
    identity: Identity
    reply_with: str = ""
    """What an answer to it calls it."""
    reply_by: int | None = None
    """Until when its sender wants an answer, in ns of the run, if it says so."""
    in_reply_to: str = ""
    """What the message that it answers is called, if its sender says so."""
    sent: int | None = None
    """When it was sent, in ns of the run, never later than it has come. None for one of an external agent, or
    while the clock of another machine is not known."""
    came: int = 0
    """When the chart got it, in ns of the run, if it is not known when it was sent."""

    @property
    def since(self) -> int:
        """The moment from which its age counts."""
        return self.came if self.sent is None else self.sent


@made_often
class Addressed:
    """A message that the branch has sent to a participant goes to these agents; answers call it `name`."""

    branch: str
    participant: str
    agents: tuple[str, ...]
    name: str


@made_often
class Settled:
    """Nothing can be taken of an agent that was addressed: it is lost, or what it sent is not accepted."""

    branch: str
    participant: str
    agent: str
    in_reply_to: str = ""


Input = Sample | Completed | Crashed | Happened | Written | AgentMessage | Addressed | Settled


# ---- effects -----------------------------------------------------------------------------------


@made_often
class Start:
    """Start the activity of the state `label`; what it answers must carry `token`.

    `arguments` are what it is given, by parameter.
    """

    label: str
    activity: str
    token: int
    arguments: tuple[tuple[str, object], ...] = ()


@made_often
class Cancel:
    """Tell the activity started with `token` that its state was left, or (`reason`) has failed."""

    label: str
    activity: str
    token: int
    reason: str | None = None


@made_often
class Publication:
    """Publish `message`; to all when `host` is None. `region` is the label of the region that wrote it."""

    channel: str
    message: object
    host: str | None
    region: str


@made_often
class Sending:
    """Send an agent message in the conversation of the protocol branch at `branch`.

    To all who play `participant` but those in `excepts`, or to the one agent `to`. What is `filled` is as it
    shall be; otherwise an activity may have prepared what it says.
    """

    branch: str
    performative: str
    message: str
    content: object
    participant: str
    filled: bool = False
    to: str | None = None
    excepts: tuple[str, ...] = ()
    reply_by: int | None = None
    """Until when an answer is wanted, in ns of the run."""
    one: bool = False
    """Whether it goes to one agent of those that play the participant."""
    way: tuple[int, ...] = ()
    """The numbers of the transitions that send it, those of a compound transition together."""


@made_often
class MailTaken:
    """A transition has taken the agent message with this identity."""

    branch: str
    identity: Identity


@made_often
class Joined:
    """The protocol branch at `branch` was entered."""

    branch: str


@made_often
class Left:
    """The protocol branch at `branch` was left; `completed` says whether its END was reached."""

    branch: str
    completed: bool = False


@made_often
class Suspended:
    """The protocol branch at `branch` was left, and a transition may resume it: its part is not over."""

    branch: str


@made_often
class Resumed:
    """The protocol branch at `branch`, which was suspended, is resumed."""

    branch: str


@made_often
class FunctionResult:
    """A function of the document was called and gave `value`."""

    function: str
    value: object


@made_often
class Fault:
    """Something in transition number `transition` of the plan could not be done."""

    transition: int
    reason: str


@made_often
class SignalExpired:
    """A signal was dropped in a region that had not taken it, at the age that its topic says."""

    region: str
    channel: str
    identity: Identity


@made_often
class LeftOut:
    """A signal of a queued channel was left out in a region, where too many wait already."""

    region: str
    channel: str


Effect = (
    Start
    | Cancel
    | Publication
    | Sending
    | MailTaken
    | Joined
    | Left
    | Suspended
    | Resumed
    | FunctionResult
    | Fault
    | SignalExpired
    | LeftOut
)


@dataclass(slots=True, init=False)
class Outcome:
    """What one step did.

    `taken` holds the numbers (in the plan's order) of the transitions taken, those of a compound
    transition together. `again` asks for another step at once, because a signal waits behind one that was
    dropped. `failure` says why the agent stopped, where it did.
    """

    taken: list[tuple[int, ...]]
    effects: list[Effect]
    finished: bool
    again: bool
    failure: str | None

    def __init__(self, *, finished: bool = False) -> None:  # each step makes one: faster than a dataclass's
        self.taken = []
        self.effects = []
        self.finished = finished
        self.again = False
        self.failure = None

    def of(self, kind: type[_EffectT]) -> Iterable[_EffectT]:
        """The effects of one kind, in order."""
        return (effect for effect in self.effects if isinstance(effect, kind))
