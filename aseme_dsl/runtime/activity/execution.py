"""Execution: one start of an activity, from the port of its context to the end that its agent hears of."""

from __future__ import annotations

import random
from collections.abc import Callable, Generator
from typing import Protocol

from aseme_dsl.runtime.activity import access
from aseme_dsl.runtime.activity import context as c
from aseme_dsl.runtime.activity.activities import Executable
from aseme_dsl.runtime.activity.returning import as_outcome
from aseme_dsl.runtime.chart.board import Board
from aseme_dsl.runtime.chart.input_queue import Errand
from aseme_dsl.runtime.chart.inputs import AgentMessage, Identity, Sample, SignalExpired, Start
from aseme_dsl.runtime.chart.plan import ActivityInfo
from aseme_dsl.runtime.chart.stepping import expired_signals
from aseme_dsl.runtime.conversation.conversation import Conversations
from aseme_dsl.runtime.conversation.directory import Directory, Offer, Withdraw
from aseme_dsl.runtime.conversation.moves import Sent
from aseme_dsl.runtime.message.convert import Messages
from aseme_dsl.runtime.ports import Driver, Stepping
from aseme_dsl.runtime.time.timers import Timer
from aseme_dsl.runtime.trace.trace import Trace
from aseme_dsl.runtime.world.body import AnyBody


def tell_expired(trace: Trace, now: int, agent: str, item: SignalExpired) -> None:
    """Let the trace tell of a signal that an agent has dropped."""
    identity = list(item.identity)
    trace.write("expired", now, agent=agent, input=identity, region=item.region, channel=item.channel)


class Drafts(Protocol):
    """What activities prepare for the messages of their agent."""

    def cancelled(self, branch: str | None, label: str) -> None: ...
    def add(self, branch: str | None, label: str, message: str, content: object) -> None: ...
    def begun_without_code(self, branch: str | None) -> None: ...


class Coded(Protocol):
    """Which activities of an agent have code."""

    def has_code(self, activity: str) -> bool: ...
    def has_code_in(self, branch: str, *, or_stand_in: bool) -> bool: ...


class Requests(Protocol):
    """What activities ask of their agent."""

    @property
    def prepared(self) -> Drafts: ...
    def perform(self, execution: Execution, doing: c.Doing) -> None: ...
    def take_mail(
        self,
        execution: Execution,
        performative: str | None,
        message: str | None,
        sender: str | None,
        identity: Identity | None = None,
    ) -> AgentMessage | None: ...
    def check_registered(self, wanted: bool) -> None: ...
    def register(self, doing: Offer | Withdraw) -> None: ...
    def check_send(self, execution: Execution, performative: str, message: str, to: str) -> None: ...


class Host(Stepping, Protocol):
    """An agent as its activities see it."""

    @property
    def driver(self) -> Driver[Execution]: ...
    @property
    def trace(self) -> Trace: ...
    @property
    def seed(self) -> int: ...
    @property
    def body(self) -> AnyBody | None: ...
    @property
    def conversations(self) -> Conversations: ...
    @property
    def messages(self) -> Messages: ...
    def errand(self, call: Errand) -> None: ...
    def begin(self) -> None: ...
    @property
    def requests(self) -> Requests: ...
    @property
    def code(self) -> Coded: ...
    def callback(self, label: str) -> type[Executable] | None: ...
    def take_note(self, branch: str, mail: AgentMessage) -> None: ...


class Owner(Protocol):
    """Whose executions they are: the agent's activities, or its modules."""

    agent: Host

    def check(self, execution: Execution, doing: c.Doing) -> None: ...
    def frozen(self, execution: Execution) -> c.Port: ...
    def returned(self, execution: Execution, error: BaseException | None) -> None: ...


class Execution:
    """One start of an activity: the port of its context, with a method for each call that a context makes.

    Its methods for the context may be called from the activity's thread; all else happens while the agent is
    guarded.
    """

    __slots__ = (
        "_chance",
        "board",
        "branch",
        "cancelled",
        "code",
        "dropped",
        "earlier",
        "error",
        "generator",
        "handle",
        "has_returned",
        "held",
        "info",
        "keeps",
        "kind",
        "made",
        "number",
        "opens",
        "owner",
        "result",
        "sent",
        "start",
        "started",
        "timer",
    )

    def __init__(
        self,
        owner: Owner,
        start: Start,
        info: ActivityInfo,
        code: Callable[[], Executable] | None,
        kind: str,
        number: int,
        branch: str | None,
        board: Board,
        now: int,
    ) -> None:
        """`code` makes (or is) the object whose `execute` is called; `number` says which start it is."""
        self.owner = owner
        self.start = start
        self.info = info
        self.code = code
        self.number = number
        self.started = now
        self.board = board
        self.branch = branch
        self.kind = kind
        self.cancelled: bool = False
        self.has_returned = False
        self.error: BaseException | None = None
        self.result: str | None = None
        """What the code has returned, see `as_outcome`."""
        self.opens: int | None = None
        """In virtual time, the moment from which what the activity does counts, until it has come."""
        self.held: list[c.Doing] = []
        self.dropped = 0
        self.sent: Sent = frozenset()
        self.made: Sent = frozenset()
        """What has left the agent since its state was entered."""
        self.earlier: Sent = frozenset()
        """What of that an earlier start has sent, before the participant was suspended: not sent again."""
        self.timer: Timer | None = None
        self.generator: Generator[object, None, object] | None = None
        self.keeps = ""
        """Who keeps the object of the code in a process of its own, `agent/module#generation`; "" where each
        start has its own object."""
        self.handle: object = None
        """What the driver keeps for it."""
        self._chance: random.Random | None = None

    # ---- the port ----------------------------------------------------------------------------

    @property
    def context(self) -> c.Context:
        """What the code is given. Not kept here: the context keeps the execution."""
        return c.Context(self)

    @property
    def agent(self) -> str:
        return self.owner.agent.name

    @property
    def label(self) -> str:
        return self.start.label

    @property
    def activity(self) -> str:
        return self.start.activity

    @property
    def arguments(self) -> dict[str, object]:
        """What it is given, by parameter."""
        return dict(self.start.arguments)

    @property
    def body(self) -> AnyBody:
        body = self.owner.agent.body
        if body is None:
            raise LookupError(f"agent {self.agent} has no body here: run it in a world")
        return body

    @property
    def random(self) -> random.Random:
        if self._chance is None:
            self._chance = random.Random(self.chance_seed)
        return self._chance

    @property
    def directory(self) -> Directory:
        return self.owner.agent.conversations.directory

    @property
    def chance_seed(self) -> str:
        """What the activity's random numbers depend on: the seed, the agent, the state and the start."""
        return f"{self.owner.agent.seed}/{self.agent}/{self.label}/{self.number}"

    def now(self) -> int:
        return self.owner.agent.driver.clock.now()

    def wait(self, duration: int) -> None:
        if self.kind not in ("thread", "process"):
            instead = "await context.sleep(…)" if self.kind == "async" else "yield the seconds"
            raise RuntimeError(f"a {self.kind!r} activity must not block; {instead} instead of wait")
        self.owner.agent.driver.wait(self, duration)

    async def sleep(self, duration: int) -> None:
        import asyncio

        await asyncio.sleep(duration / 1e9)

    def newest(self, channel: str, host: str | None) -> Sample | None:
        access.check_read(self.info, channel)
        agent = self.owner.agent
        with agent.driver.guard(agent):
            self._drop_expired()
            return self.board.newest(channel, host)

    def history(self, channel: str, host: str | None) -> tuple[Sample, ...]:
        access.check_read(self.info, channel)
        agent = self.owner.agent
        with agent.driver.guard(agent):
            return self.board.history(channel, host)

    def looks_back(self, channel: str, duration: int | None) -> int:
        return access.check_look_back(self.info, channel, duration)

    def frozen(self) -> c.Port:
        return self.owner.frozen(self)

    def take(self, channel: str, host: str | None) -> Sample | None:
        access.check_read(self.info, channel)
        agent = self.owner.agent
        with agent.driver.guard(agent):
            self._drop_expired()
            item = self.board.take(channel, host)
            if item is not None:
                agent.trace.write(
                    "consumed",
                    self.now(),
                    agent=agent.name,
                    input=list(item.identity),
                    label=self.label,
                    activity=self.activity,
                    token=self.start.token,
                )
            return item

    def _drop_expired(self) -> None:
        """Drop the signals that are too old. Called while the agent is guarded."""
        agent, now = self.owner.agent, self.now()
        for item in expired_signals(agent.chart, now):
            tell_expired(agent.trace, now, agent.name, item)

    def variable(self, name: str) -> object:
        agent = self.owner.agent
        variable = agent.plan.variable_of(name, self.label)
        access.check_get(self.info, variable, name)
        with agent.driver.guard(agent):
            return agent.chart.variable(variable.name)

    def receive(
        self, performative: str | None, message: str | None, sender: str | None
    ) -> AgentMessage | None:
        if self.branch is None:
            raise LookupError(f"{self.activity} is not part of a protocol's participant here")
        agent = self.owner.agent
        with agent.driver.guard(agent):
            return agent.requests.take_mail(self, performative, message, sender)

    def received(self) -> tuple[AgentMessage, ...]:
        if self.branch is None:
            raise LookupError(f"{self.activity} is not part of a protocol's participant here")
        if self.cancelled:  # another participation may have begun
            return ()
        return self.owner.agent.conversations.taken_by(self.owner.agent, self.branch)

    def do(self, doing: c.Doing) -> None:
        self.owner.check(self, doing)
        if self.cancelled:
            self.dropped += 1
        elif self.opens is not None:
            self.held.append(doing)
        else:
            self.owner.agent.requests.perform(self, doing)

    # ---- its end -----------------------------------------------------------------------------

    def run(self) -> None:
        """Run the code of a thread activity to its end, in this thread, and say how it ended."""
        self.returned(self._error())

    def _error(self) -> BaseException | None:
        """Run the code; what it raised. Apart, so that no frame holds an exception that holds the frame."""
        try:
            context = self.context
            context.raise_if_cancelled()
            assert self.code is not None
            self.result = as_outcome(self.code().execute(context, **self.arguments))
        except BaseException as raised:  # of any type: the agent must hear of it
            return raised
        return None

    def returned(self, error: BaseException | None) -> None:
        """The code has come to its end. May be called from any thread."""
        agent = self.owner.agent
        agent.errand(lambda: self.owner.returned(self, error))

    def forget(self) -> None:
        """Let go of what leads back here, so that all of it is freed at once and not by the collector."""
        self.error = None
        self.timer = None
        self.generator = None
        if self.kind == "step":  # else it belongs to the driver, which may still look at it
            self.handle = None
