"""Snapshots: what a `process` activity sees, taken when it starts and sent to another process."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity import access
from aseme_dsl.runtime.activity.context import (
    Context,
    Doing,
    Port,
    Publish,
    SetVariable,
    check_message,
    matches,
)
from aseme_dsl.runtime.activity.returning import as_outcome
from aseme_dsl.runtime.chart.board import Board
from aseme_dsl.runtime.chart.inputs import AgentMessage, Identity, Sample
from aseme_dsl.runtime.chart.plan import ActivityInfo, Variable
from aseme_dsl.runtime.conversation.directory import Directory
from aseme_dsl.runtime.world.body import AnyBody

if TYPE_CHECKING:
    from aseme_dsl.runtime.activity.execution import Execution


class BoardCopy(Board):
    """Some channels of a blackboard, as they were."""

    __slots__ = ("_ages",)

    def __init__(self, board: Board, channels: Iterable[str]) -> None:
        super().__init__()
        self.part()
        self._ages = dict(board.EXPIRES)
        for channel in channels:
            if channel in board._states:
                self._states[channel] = dict(board._states[channel])
            if channel in board._data:
                self._data[channel] = board._data[channel].copy()
            if channel in board._signals:
                self._signals[channel] = list(board._signals[channel])

    def expire(self, now: int) -> list[Sample]:
        return self.drop_older(now, self._ages)


@dataclass(frozen=True, slots=True)
class Snapshot:
    """An activity's agent at one moment: what the activity reads, visible variables, agent messages."""

    agent: str
    activity: str
    label: str
    now: int
    chance_seed: str
    info: ActivityInfo
    board: Board
    variables: dict[str, tuple[Variable, object]]
    """Those that its state can see, with their values."""
    mail: tuple[AgentMessage, ...] | None
    """What waits; None outside a protocol's participant."""
    received: tuple[AgentMessage, ...]
    """What was taken."""
    arguments: dict[str, object]
    """What it is given, by parameter."""


@dataclass(frozen=True, slots=True)
class TookSignal:
    """The activity has taken this signal out of its snapshot."""

    channel: str
    sender: str
    identity: Identity


@dataclass(frozen=True, slots=True)
class TookMail:
    """The activity has taken this agent message out of its snapshot."""

    identity: Identity


Told = Doing | TookSignal | TookMail
"""What the agent receives while the activity runs."""


class SnapshotPort:
    """The port of a context that stands on a snapshot; what is done is handed to `tell`."""

    def __init__(
        self,
        snapshot: Snapshot,
        tell: Callable[[Told], None],
        now: Callable[[], int],
        wait: Callable[[int], None],
        is_cancelled: Callable[[], bool],
    ) -> None:
        self._snapshot = snapshot
        self._tell = tell
        self._clock = now
        self._wait = wait
        self._is_cancelled = is_cancelled
        self._mail = list(snapshot.mail or ())
        self._received = list(snapshot.received)
        self._chance: random.Random | None = None

    @property
    def agent(self) -> str:
        return self._snapshot.agent

    @property
    def label(self) -> str:
        return self._snapshot.label

    @property
    def activity(self) -> str:
        return self._snapshot.activity

    @property
    def cancelled(self) -> bool:
        return self._is_cancelled()

    @property
    def body(self) -> AnyBody:
        raise LookupError("a 'process' activity cannot reach the robot's body: publish what it is to do")

    @property
    def directory(self) -> Directory:
        raise LookupError("a 'process' activity cannot reach the directory: let another look")

    @property
    def random(self) -> random.Random:
        if self._chance is None:
            self._chance = random.Random(self._snapshot.chance_seed)
        return self._chance

    def now(self) -> int:
        return self._clock()

    def wait(self, duration: int) -> None:
        self._wait(duration)

    async def sleep(self, duration: int) -> None:
        raise RuntimeError("a 'process' activity waits with context.wait(…)")

    def newest(self, channel: str, host: str | None) -> Sample | None:
        access.check_read(self._snapshot.info, channel)
        self._snapshot.board.expire(self.now())
        return self._snapshot.board.newest(channel, host)

    def history(self, channel: str, host: str | None) -> tuple[Sample, ...]:
        access.check_read(self._snapshot.info, channel)
        return self._snapshot.board.history(channel, host)

    def looks_back(self, channel: str, duration: int | None) -> int:
        return access.check_look_back(self._snapshot.info, channel, duration)

    def frozen(self) -> Port:
        """What it sees stands still already; now its time does, too."""
        now = self.now()
        return SnapshotPort(self._snapshot, self._tell, lambda: now, self._wait, self._is_cancelled)

    def take(self, channel: str, host: str | None) -> Sample | None:
        access.check_read(self._snapshot.info, channel)
        self._snapshot.board.expire(self.now())
        item = self._snapshot.board.take(channel, host)
        if item is not None:
            self._tell(TookSignal(channel, item.sender, item.identity))
        return item

    def variable(self, name: str) -> object:
        variable, value = self._variable(name)
        access.check_get(self._snapshot.info, variable, name)
        return value

    def receive(
        self, performative: str | None, message: str | None, sender: str | None
    ) -> AgentMessage | None:
        if self._snapshot.mail is None:
            raise LookupError(f"{self.activity} is not part of a protocol's participant here")
        for item in self._mail:
            if matches(item, performative, message, sender):
                self._mail.remove(item)
                self._received.append(item)
                self._tell(TookMail(item.identity))
                return item
        return None

    def received(self) -> tuple[AgentMessage, ...]:
        if self._snapshot.mail is None:
            raise LookupError(f"{self.activity} is not part of a protocol's participant here")
        return tuple(self._received)

    def do(self, doing: Doing) -> None:
        match doing:  # checked here, so that the error has the place in the code
            case Publish(channel, message):
                check_message(channel, message)
                access.check_publish(self._snapshot.info, channel)
            case SetVariable(name):
                variable, _ = self._variable(name)
                access.check_set(self._snapshot.info, variable, name)
        self._tell(doing)

    def _variable(self, name: str) -> tuple[Variable, object]:
        try:
            return self._snapshot.variables[name]
        except KeyError:
            known = ", ".join(sorted(self._snapshot.variables)) or "none"
            raise LookupError(f"no variable {name} here; there is {known}") from None


class FrozenPort(SnapshotPort):
    """The port of a context that stands on a snapshot, in the process of its agent."""

    def __init__(self, execution: Execution) -> None:
        agent = execution.owner.agent
        with agent.driver.guard(agent):
            snapshot = snapshot_of(execution)
        super().__init__(
            snapshot,
            lambda told: tell(execution, told),
            lambda: snapshot.now,
            execution.wait,
            lambda: execution.cancelled,
        )
        self._execution = execution

    @property
    def body(self) -> AnyBody:
        return self._execution.body

    @property
    def random(self) -> random.Random:
        return self._execution.random

    @property
    def directory(self) -> Directory:
        return self._execution.directory

    async def sleep(self, duration: int) -> None:
        await self._execution.sleep(duration)


def snapshot_of(execution: Execution) -> Snapshot:
    """What the activity sees now. Called while its agent is guarded."""
    agent = execution.owner.agent
    board = BoardCopy(execution.board, execution.info.reads)
    names = {variable.name.partition("@")[0] for variable in agent.plan.variables}
    variables: dict[str, tuple[Variable, object]] = {}
    for name in sorted(names):
        try:
            variable = agent.plan.variable_of(name, execution.label)
        except LookupError:
            continue  # the variable of a participant that the activity does not belong to
        variables[name] = variable, agent.chart.variable(variable.name)
    mail = None if execution.branch is None else tuple(agent.chart.mail[execution.branch])
    return Snapshot(
        agent.name,
        execution.activity,
        execution.label,
        execution.now(),
        execution.chance_seed,
        execution.info,
        board,
        variables,
        mail,
        () if execution.branch is None else execution.received(),
        execution.arguments,
    )


def tell(execution: Execution, told: Told) -> None:
    """Do in the agent what its activity says. Raises what the activity's own context would raise."""
    agent = execution.owner.agent
    match told:
        case TookSignal(channel, sender, identity):
            with agent.driver.guard(agent):
                item = execution.board.newest(channel, sender)
                if item is not None and item.identity == identity:
                    execution.take(channel, sender)
        case TookMail(identity):
            with agent.driver.guard(agent):
                agent.requests.take_mail(execution, None, None, None, identity)
        case _:
            execution.do(told)


def run_snapshot(execution: Execution) -> None:
    """Run a `process` activity in this thread, on a snapshot as if it were in another process."""
    error: BaseException | None = None
    try:
        execution.context.raise_if_cancelled()
        port = SnapshotPort(
            snapshot_of(execution),
            lambda told: tell(execution, told),
            execution.now,
            execution.wait,
            lambda: execution.cancelled,
        )
        assert execution.code is not None
        execution.result = as_outcome(execution.code().execute(Context(port), **execution.arguments))
    except BaseException as raised:  # of any type: the agent must hear of it
        error = raised
    execution.returned(error)
