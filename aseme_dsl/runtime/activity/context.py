"""Context: all that an activity sees of its agent, and all that it can do to it."""

from __future__ import annotations

import random
from typing import Any, Protocol, TypeVar, overload

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart import history
from aseme_dsl.runtime.chart.inputs import LOST, AgentMessage, Sample
from aseme_dsl.runtime.conversation.directory import AgentDirectory, Directory, Offer, Withdraw
from aseme_dsl.runtime.time.clock import SECOND, nanoseconds
from aseme_dsl.runtime.world.body import AnyBody

MessageT = TypeVar("MessageT")


class Cancelled(BaseException):
    """The activity's state was left. Not an `Exception`, so that a careless `except` does not swallow it."""


# ---- what an activity can do -------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Publish:
    """Publish a message, to all or to one agent."""

    channel: str
    message: Any
    host: str | None


@dataclass(frozen=True, slots=True)
class SetVariable:
    """Write a variable of the role or of the protocol's participant."""

    name: str
    value: Any


@dataclass(frozen=True, slots=True)
class RaiseEvent:
    """Raise an event for the agent's transitions."""

    name: str


@dataclass(frozen=True, slots=True)
class Prepare:
    """Give the content of the next agent message of this type that a transition sends."""

    message: Any


@dataclass(frozen=True, slots=True)
class Send:
    """Send an agent message, to a participant or to one agent."""

    performative: str
    message: Any
    to: str
    within: int | None = None
    """An answer is wanted within so many ns."""


@dataclass(frozen=True, slots=True)
class Log:
    """Write a line into the trace."""

    text: str


Doing = Publish | SetVariable | RaiseEvent | Prepare | Send | Log | Offer | Withdraw


class Port(Protocol):
    """What stands behind a context: the agent itself, or a snapshot of it in another process."""

    @property
    def agent(self) -> str: ...
    @property
    def label(self) -> str: ...
    @property
    def activity(self) -> str: ...
    @property
    def cancelled(self) -> bool: ...
    @property
    def body(self) -> AnyBody: ...
    @property
    def random(self) -> random.Random: ...
    @property
    def directory(self) -> Directory: ...
    def now(self) -> int: ...
    def wait(self, duration: int) -> None: ...
    async def sleep(self, duration: int) -> None: ...
    def newest(self, channel: str, host: str | None) -> Sample | None: ...
    def history(self, channel: str, host: str | None) -> tuple[Sample, ...]: ...
    def looks_back(self, channel: str, duration: int | None) -> int: ...
    def frozen(self) -> Port: ...
    def take(self, channel: str, host: str | None) -> Sample | None: ...
    def variable(self, name: str) -> Any: ...
    def receive(
        self, performative: str | None, message: str | None, sender: str | None
    ) -> AgentMessage | None: ...
    def received(self) -> tuple[AgentMessage, ...]: ...
    def do(self, doing: Doing) -> None: ...


class Context:
    """All that an activity may do, as one thin face: each method makes one call on its port.

    May be used from any thread, as long as the activity lasts.

    Channels are written as in the document: `vision.state.Ball`. What the activity reads or writes without
    having declared it raises UndeclaredError, a LookupError whose text has the line to add. After the
    activity was cancelled, what it publishes, writes, raises or sends is dropped.
    """

    __slots__ = ("_port",)

    def __init__(self, port: Port) -> None:
        self._port = port

    # ---- where and when ----------------------------------------------------------------------

    @property
    def agent(self) -> str:
        """The name of the agent."""
        return self._port.agent

    @property
    def activity(self) -> str:
        """The name of the activity."""
        return self._port.activity

    @property
    def label(self) -> str:
        """The label of the state that started the activity."""
        return self._port.label

    @property
    def now_ns(self) -> int:
        """The time in ns since the run began."""
        return self._port.now()

    @property
    def body(self) -> AnyBody:
        """The robot's body. Raises LookupError if the agent has none here."""
        return self._port.body

    @property
    def random(self) -> random.Random:
        """Random generator of this activity start; equal seeds give equal numbers."""
        return self._port.random

    def log(self, text: str) -> None:
        """Write a line into the trace."""
        self._port.do(Log(str(text)))

    @property
    def directory(self) -> AgentDirectory:
        """Which agents there are, and what each offers. Raises LookupError in an activity of kind process."""
        return AgentDirectory(self._port)

    # ---- cancellation ------------------------------------------------------------------------

    @property
    def cancelled(self) -> bool:
        """Whether the state was left: the activity should end, and what it still does is dropped."""
        return self._port.cancelled

    def raise_if_cancelled(self) -> None:
        """Raise Cancelled if the state was left."""
        if self._port.cancelled:
            raise Cancelled

    def wait(self, seconds: float) -> None:
        """Let time pass; with the virtual clock, virtual time. For activities of kind thread and process.

        Raises:
            Cancelled: the state was left, before or meanwhile.
        """
        self._port.wait(nanoseconds(seconds))

    async def sleep(self, seconds: float) -> None:
        """Let time pass in an `async` activity; cancellation arrives as `asyncio.CancelledError`."""
        await self._port.sleep(nanoseconds(seconds))

    # ---- reading -----------------------------------------------------------------------------

    @overload
    def read(self, channel: str, kind: None = None, sender: str | None = None) -> Any: ...
    @overload
    def read(self, channel: str, kind: type[MessageT], sender: str | None = None) -> MessageT | None: ...
    def read(self, channel: str, kind: type[object] | None = None, sender: str | None = None) -> Any:
        """The message that a condition would see, or None: a signal is taken by that.

        With `kind` the result is typed: `context.read("vision.state.Ball", Ball)`. Raises TypeError if the
        channel carries another message.
        """
        item = self._port.take(channel, sender) if _is_signal(channel) else self._port.newest(channel, sender)
        if item is None:
            return None
        if kind is not None and not isinstance(item.message, kind):
            raise TypeError(f"{channel} carries {type(item.message).__name__}, not {kind.__name__}")
        return item.message

    def latest_message(self, channel: str, sender: str | None = None) -> Any:
        """The latest message of a channel (of that sender), or None. A signal is only looked at."""
        item = self._port.newest(channel, sender)
        return None if item is None else item.message

    def latest_sample(self, channel: str, sender: str | None = None) -> Sample | None:
        """Like `latest_message`, with the sender and the time of measurement."""
        return self._port.newest(channel, sender)

    def age(self, channel: str, *, sender: str | None = None) -> float | None:
        """How many seconds ago the newest message of a channel was measured, or None if there is none."""
        item = self._port.newest(channel, sender)
        return None if item is None else (self._port.now() - item.time) / SECOND

    def snapshot(self) -> Context:
        """The same context, but all that is read from it is as it is at this moment: of one step.

        Its time stands still, too. What is published, written or taken through it is done in the agent.
        """
        return Context(self._port.frozen())

    # ---- histories ---------------------------------------------------------------------------
    #
    # The activity declares how far it looks back at a data channel: `reads vision.data.Ball for 2s`. To look
    # further back raises UndeclaredError. Without `sender`, the messages of all senders are one history.

    def history(
        self, channel: str, sender: str | None = None, *, seconds: float | None = None
    ) -> tuple[Sample, ...]:
        """The last seconds of a data channel, by default all that is declared; oldest first, with times."""
        moment = self._back(channel, seconds)
        return history.since(self._port.history(channel, sender), moment)

    def at(self, channel: str, seconds_ago: float, *, sender: str | None = None) -> Any:
        """The message as it was so long ago, the newest that was measured by then, or None."""
        moment = self._back(channel, seconds_ago)
        found = history.at(self._port.history(channel, sender), moment)
        return None if found is None else found.message

    def interpolated(
        self, channel: str, member: str, seconds_ago: float, *, sender: str | None = None
    ) -> float | None:
        """A member (`pose.x`) so long ago, on the straight line between the measurements before and after.

        None before the first and after the last measurement. Raises TypeError for what is not a number.
        """
        moment = self._back(channel, seconds_ago)
        return history.interpolated(self._port.history(channel, sender), moment, member)

    def mean(self, channel: str, member: str, seconds: float, *, sender: str | None = None) -> float | None:
        """The mean of a member (`pose.x`) over the last seconds, or None if nothing was measured in them."""
        moment = self._back(channel, seconds)
        return history.mean(self._port.history(channel, sender), moment, member)

    def _back(self, channel: str, seconds: float | None) -> int:
        """The moment so long ago, or as long as is declared. Raises LookupError for any other channel."""
        if channel.split(".", 2)[1:2] != ["data"]:
            raise LookupError(f"{channel} is not a data channel: only data has a history")
        duration = self._port.looks_back(channel, None if seconds is None else nanoseconds(seconds))
        return self._port.now() - duration

    def consume(self, channel: str, sender: str | None = None) -> Any:
        """The oldest waiting signal (of that sender), which is consumed, or None."""
        item = self._port.take(channel, sender)
        return None if item is None else item.message

    def get_variable(self, name: str) -> Any:
        """A variable of the protocol's participant or of the role. Raises LookupError if there is none."""
        return self._port.variable(name)

    # ---- writing -----------------------------------------------------------------------------

    def publish(self, channel: str, message: object, to: str | None = None) -> None:
        """Publish a message, to all or to one agent. Raises TypeError for the wrong type."""
        self._port.do(Publish(channel, message, to))

    def set_variable(self, name: str, value: object) -> None:
        """Write a variable.

        A list is copied. Raises LookupError if there is no such variable, TypeError if it is of another type,
        OutOfBounds if it cannot hold the value.
        """
        self._port.do(SetVariable(name, tuple(value) if isinstance(value, list) else value))

    def raise_event(self, name: str) -> None:
        """Raise an event: transitions that wait for it see it in the agent's next step."""
        self._port.do(RaiseEvent(name))

    # ---- agent messages ----------------------------------------------------------------------

    def prepare(self, message: object) -> None:
        """Give what the next `send` of this message type contains.

        Inside a protocol's participant it is for that participant's transitions, elsewhere for any.

        Raises TypeError for what is not a message.
        """
        self._port.do(Prepare(message))

    def send(self, performative: str, message: object, to: str, reply_within: float | None = None) -> None:
        """Send an agent message in this participant's conversation, to a participant or to one agent.

        `reply_within` says that an answer is wanted within so many seconds. The receiver sees it as
        `AgentMessage.reply_by`; the sender still waits, unless a transition has `after(…)`.

        Raises LookupError outside a protocol's participant, and for what the protocol does not let this
        activity send. That is what a transition sends, what `sends … by` leaves to another activity, and the
        same message to the same agent again without `repeatedly`. Nothing is sent then.
        """
        self._port.do(
            Send(performative, message, to, None if reply_within is None else nanoseconds(reply_within))
        )

    def receive(
        self, performative: str | None = None, message: str | None = None, sender: str | None = None
    ) -> AgentMessage | None:
        """Take the oldest agent message of this kind that waits for this participant, or None.

        It waits for nothing: an activity that wants to, waits in between.
        """
        return self._port.receive(performative, message, sender)

    def last_received(
        self, performative: str | None = None, message: str | None = None, sender: str | None = None
    ) -> AgentMessage | None:
        """The last agent message of this kind that this participant has taken in its conversation, or None.

        So an activity sees what the transition into its state has taken. Of each kind and sender the last one
        is kept, until the participant is left.
        """
        for mail in reversed(self._port.received()):
            if matches(mail, performative, message, sender):
                return mail
        return None


def check_message(channel: str, message: object) -> None:
    """Whether a message is of the type that a channel carries, by its name.

    Raises:
        LookupError: what is not a channel.
        TypeError: it is of another type.
    """
    parts = channel.split(".")
    if len(parts) != 3 or parts[1] not in ("signal", "state", "data"):
        raise LookupError(f"{channel!r} is not a channel: it is written like vision.state.Ball")
    if type(message).__name__ != parts[2]:
        raise TypeError(f"{channel} carries {parts[2]}, not {type(message).__name__}")


def matches(mail: AgentMessage, performative: str | None, message: str | None, sender: str | None) -> bool:
    """Whether an agent message is of a kind and from a sender, where they are given."""
    return (
        mail.performative != LOST
        and performative in (None, mail.performative)
        and message in (None, mail.message)
        and sender in (None, mail.sender)
    )


def _is_signal(channel: str) -> bool:
    return channel.split(".", 2)[1:2] == ["signal"]
