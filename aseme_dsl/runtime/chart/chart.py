"""Chart: what the generated step classes have in common: a synchronous step from inputs to effects.

A chart has no thread, clock or socket in it. The shell (`agent.py`) gives it the time and the inputs and
carries its effects out; simulation, replay and tests do the same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from random import Random
from typing import Any, ClassVar

from aseme_dsl.runtime.chart.board import NEVER, QUEUE, Board, built
from aseme_dsl.runtime.chart.functions import checked, find_function, results_of
from aseme_dsl.runtime.chart.inputs import (
    AgentMessage,
    Cancel,
    Completed,
    Crashed,
    Fault,
    FunctionResult,
    Happened,
    Input,
    Joined,
    Left,
    LeftOut,
    MailTaken,
    Outcome,
    Publication,
    Sample,
    Sending,
    Start,
    Written,
)
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.time.clock import shown

ROUNDS = 1000
"""A step that does not settle in so many rounds never will, unless they have made what waits become less."""

ABSENT = "absent value"
"""Why an action was not done that needs a message which is not there."""

INACTIVE = -1
"""A region's number while its AND is not active."""

Seen = tuple[tuple[object, ...], tuple[object, ...]]
"""What a condition reads: messages, and the values of variables and timers."""


class Chart:
    """A running statechart. Subclasses are generated; see `semantics.md` for what a step does.

    A region is an integer slot with the number of its active leaf; a BASIC state has two numbers, one while
    its activity runs and the next one when it is complete.
    """

    __slots__ = (
        "_faults",
        "_functions",
        "agent",
        "chance",
        "drains",
        "effects",
        "events",
        "failed",
        "failure",
        "finished",
        "index",
        "mail",
        "now",
        "outcome",
        "outcomes",
        "pending",
        "queue",
        "seed",
        "spent",
        "started",
        "taken",
        "tokens",
        "woken",
        "writes",
    )

    PLAN: ClassVar[Plan]
    AGENT: ClassVar[type[Any] | None] = None
    """What shows the chart as an agent with behaviours (`behaviours.py`), if it is to be shown so."""
    MESSAGES: ClassVar[Mapping[str, Any]] = {}
    """The message class of each channel that the chart publishes, and of each message it sends."""
    READERS: ClassVar[Mapping[str, tuple[int, ...]]] = {}
    """The numbers of the regions that read a channel."""
    RUNNING: ClassVar[Mapping[str, tuple[str, str, int]]] = {}
    """For each BASIC state the slots of its region's leaf and token, and its number while it runs."""
    VARIABLES: ClassVar[Mapping[str, tuple[str, ...]]] = {}
    """The slots that hold a variable: one, or one for each region that uses it."""
    REGIONS: ClassVar[tuple[str, ...]] = ()
    TIMES: ClassVar[Mapping[str, str]] = {}
    """The slots that hold when a state was entered, for those states where it matters."""
    COUNTS: ClassVar[Mapping[str, str]] = {}
    """The slots that hold how often a state was entered, for those states that a condition counts."""
    WAKES: ClassVar[Mapping[str, tuple[tuple[str, str, tuple[tuple[int, int], ...]], ...]]] = {}
    """Of each variable that wakes another region than the one that writes it: the copy that is read there,
    the slot of that region's leaf, and the first and last numbers of the leaves at which a condition reads
    it."""
    MISSED: ClassVar[Mapping[str, tuple[tuple[int, str, tuple[tuple[int, int], ...]], ...]]] = {}
    """Of each signal that a condition may miss: the number of a region, the slot of its leaf, and the first
    and last numbers of the leaves at which such a condition reads it."""
    WITHIN: ClassVar[Mapping[str, int]] = {}
    """The deadlines of BASIC states: how long their activities have from the entry, in ns."""
    KEPT: ClassVar[Mapping[str, str]] = {}
    """The slots of what is remembered of states that may be resumed: the numbers of their regions' leaves."""
    MARKS: ClassVar[Mapping[int, tuple[str, str]]] = {}
    """For each `on` transition the slots of what it saw when it was taken last, and of the time it waited."""
    LEAVES: ClassVar[tuple[tuple[str, ...], ...]] = ()
    """The labels of each region's leaves by their numbers."""

    def __init__(self, agent: str) -> None:
        self.agent = agent
        self.now = 0
        self.started = False
        self.finished = False
        self.failure: str | None = None
        self.tokens = 0
        self.failed: dict[str, str] = {}
        self.outcomes: dict[str, str | None] = {}
        """How the activities of states have ended, None for those that have not; the last is the newest."""
        self.events: set[str] = set()
        self.spent: set[tuple[int, str]] = set()
        """The events that a transition of a region has taken in this step."""
        self.mail: dict[str, list[AgentMessage]] = {info.label: [] for info in self.PLAN.branches}
        self.writes: list[tuple[int, str, Any]] = []
        self.drains = False
        """Whether a step has dropped a signal behind which another one waits; reset like `woken`."""
        self.woken = False
        """Whether a step has written what another region reads; whoever makes the next one resets it."""
        self.pending: Callable[[], Iterable[Sample]] = tuple
        self.queue = QUEUE
        """How many signals of a queued channel may wait in a region."""
        self._faults: set[int] = set()
        self._functions: dict[str, tuple[Callable[..., Any], tuple[type, ...]]] = {}
        self.index = dict(self.PLAN.numbers).get(agent, 1)
        """The agent's number, in the range of agents of which it is one."""
        self.seed = 1
        self.chance: Random | None = None
        """What `random()` draws from; made with the first draw, from the run's seed and the agent's name."""
        self.outcome = Outcome()
        self.taken = self.outcome.taken
        self.effects = self.outcome.effects

    def settle(self) -> None:
        """Give the variables what the team sets in this agent."""
        for agent, name, value in self.PLAN.settings:
            if agent == self.agent:
                slots = self.VARIABLES[name]
                kind = type(getattr(self, slots[0]))
                self.set_variable(name, kind(value))

    # ---- generated -------------------------------------------------------------------------

    def enter(self) -> None:
        """Enter the root: its START becomes active."""
        raise NotImplementedError

    def round(self) -> bool:
        """One round over all regions; whether anything moved."""
        raise NotImplementedError

    def leave(self) -> None:
        """Leave everything: running activities are cancelled."""
        raise NotImplementedError

    def is_finished(self) -> bool:
        """Whether the root's END is active."""
        raise NotImplementedError

    def due(self, now: int) -> int | None:
        """The next moment after `now` at which time alone may enable something that is waited for."""
        raise NotImplementedError

    def configuration(self) -> tuple[str, ...]:
        """The labels of the active leaves, region by region in document order."""
        raise NotImplementedError

    def boards(self) -> tuple[Board | None, ...]:
        """The blackboard of each region, None where the region is not active."""
        raise NotImplementedError

    # ---- questions between steps -----------------------------------------------------------

    def board_of(self, label: str) -> Board:
        """The blackboard of the region around a BASIC state."""
        return getattr(self, "b" + self.RUNNING[label][0][1:])  # type: ignore[no-any-return]

    def set_variable(self, name: str, value: Any) -> None:
        """Set every copy of a variable."""
        for slot in self.VARIABLES[name]:
            setattr(self, slot, value)

    def variable(self, name: str) -> Any:
        """The value of a variable between steps."""
        return getattr(self, self.VARIABLES[name][0])

    # ---- the step --------------------------------------------------------------------------

    def step(self, now: int, inputs: Iterable[Input]) -> Outcome:
        """Take the inputs together, go on until nothing is enabled, and say what happened.

        `now` is in ns and never goes back. A finished or failed chart does nothing.
        """
        outcome = self.outcome = Outcome()
        self.taken = outcome.taken
        self.effects = outcome.effects
        if self.finished or self.failure is not None:
            outcome.finished, outcome.failure = self.finished, self.failure
            return outcome
        self.now = now
        for item in inputs:
            self._RECEIVE[type(item)](self, item)
        if self.WITHIN:
            self._fail_the_late()
        if not self.started:
            self.started = True
            self.enter()
        rounds = 0
        bound, waiting = ROUNDS, NEVER if self.READERS or self.mail else 0
        while self.round():
            rounds += 1
            if rounds == bound:
                left = self._waiting()
                if left >= waiting:
                    self._stop(self._unsettled(rounds))
                    break
                bound, waiting = bound + ROUNDS, left  # a queue that becomes shorter comes to an end
        self._end_step(outcome)
        return outcome

    def _arrived(self, item: Sample) -> None:
        boards = self.boards()
        for region in self.READERS.get(item.channel, ()):
            board = boards[region]
            if board is None or item.written_by == self.REGIONS[region]:
                continue
            if item.identity in board.ahead:
                board.ahead.discard(item.identity)
            else:
                self._put(region, board, item)

    def _completed(self, item: Completed) -> None:
        leaf, owner, number = self.RUNNING[item.label]
        runs = getattr(self, leaf) == number and item.label not in self.failed
        if runs and getattr(self, owner) == item.token:
            setattr(self, leaf, number + 1)
            if item.outcome is not None:
                self._ended(item.label, item.outcome)

    def _crashed(self, item: Crashed) -> None:
        leaf, owner, number = self.RUNNING[item.label]
        if getattr(self, leaf) == number and getattr(self, owner) == item.token:
            self.failed[item.label] = item.reason

    def _happened(self, item: Happened) -> None:
        self.events.add(item.name)

    def _written(self, item: Written) -> None:
        for slot in self.VARIABLES[item.variable]:
            setattr(self, slot, item.value)

    def _mailed(self, item: AgentMessage) -> None:
        self.mail[item.branch].append(item)

    _RECEIVE: ClassVar[Mapping[type[Input], Callable[[Any, Any], None]]] = {
        Sample: _arrived,
        Completed: _completed,
        Crashed: _crashed,
        Happened: _happened,
        Written: _written,
        AgentMessage: _mailed,
    }

    def _put(self, region: int, board: Board, item: Sample) -> None:
        """Put a message on a region's board, unless too many wait there that nobody takes."""
        if item.channel in board.QUEUED and board.waits(item.channel) >= self.queue:
            self.effects.append(LeftOut(self.REGIONS[region], item.channel))
        else:
            board.put(item, self.now)

    def _fail_the_late(self) -> None:
        """Cancel the activities whose deadline has passed: their states have failed."""
        for label, within in self.WITHIN.items():
            leaf, owner, number = self.RUNNING[label]
            if getattr(self, leaf) != number or label in self.failed:
                continue
            if self.now - getattr(self, self.TIMES[label]) >= within:
                reason = self.failed[label] = f"not done within {shown(within)}"
                activity = self.PLAN.by_label[label].activity or ""
                self.effects.append(Cancel(label, activity, getattr(self, owner), reason))

    def _ended(self, label: str, outcome: str | None) -> None:
        self.outcomes.pop(label, None)
        self.outcomes[label] = outcome

    def _end_step(self, outcome: Outcome) -> None:
        if self.writes and self._spread_writes():
            self.woken = outcome.again = True
        if self.READERS:
            for board in self.boards():
                if board is not None and board.asked:
                    self._end_signals(board, outcome)
        if self.failed and self.failure is None:
            label, reason = next(iter(self.failed.items()))
            name = self.PLAN.by_label[label].name
            self._stop(f"activity {name} of state {label} failed: {reason}")
        if self.events:
            self.events.clear()
            self.spent.clear()
        if self._faults:
            self._faults.clear()
        self.finished = outcome.finished = self.is_finished()
        outcome.failure = self.failure

    def _end_signals(self, board: Board, outcome: Outcome) -> None:
        """Drop the signals that a region has looked at. Another step follows if others wait behind them, or
        if a transition of an active state there may miss them."""
        for channel in board.end_step():
            if board.waits(channel):
                self.drains = outcome.again = True
            for region, slot, leaves in self.MISSED.get(channel, ()):
                if self.boards()[region] is board and _is_at(getattr(self, slot), leaves):
                    outcome.again = True

    def _waiting(self) -> int:
        """How many signals and agent messages wait."""
        mail = sum(map(len, self.mail.values())) if self.mail else 0
        if not self.READERS:
            return mail
        return mail + sum(board.waiting() for board in self.boards() if board is not None)

    def _spread_writes(self) -> bool:
        """Let all regions see what was written; whether that wakes one of them."""
        found = {name: value for _, name, value in sorted(self.writes, key=lambda write: write[0])}
        self.writes.clear()
        wakes = False
        for name, value in found.items():
            wakes = wakes or any(self._reads_anew(copy, value) for copy in self.WAKES.get(name, ()))
            self.set_variable(name, value)
        return wakes

    def _reads_anew(self, copy: tuple[str, str, tuple[tuple[int, int], ...]], value: Any) -> bool:
        """Whether a transition of an active state reads a copy of a variable that has another value yet."""
        slot, region, leaves = copy
        return getattr(self, slot) != value and _is_at(getattr(self, region), leaves)

    def _stop(self, reason: str) -> None:
        self.failure = reason
        self.leave()
        self._spread_writes()

    def _unsettled(self, rounds: int) -> str:
        ways = dict.fromkeys(self.PLAN.way(taken) for taken in self.taken[-8:])
        return f"the step does not settle after {rounds} rounds: {', '.join(ways)}"

    # ---- what generated code calls ---------------------------------------------------------

    def begin(self, label: str, activity: str, arguments: tuple[tuple[str, Any], ...] = ()) -> int:
        """Start an activity; the token is its own."""
        self.tokens += 1
        self.effects.append(Start(label, activity, self.tokens, arguments))
        return self.tokens

    def not_given(self, label: str, what: str, error: Exception | None = None) -> int:
        """An activity cannot start, for something that it is to be given: its state has failed."""
        reason = "" if error is None else f" cannot be computed: {type(error).__name__}: {error}"
        self.failed[label] = what + reason
        return 0

    def begin_again(self, label: str, activity: str) -> int:
        """Start the activity of an active state anew, with what it is given now."""
        begin = getattr(self, f"_begin_{label.replace('.', '_')}", None)
        token: int = self.begin(label, activity) if begin is None else begin(self.now)
        return token

    def await_outcome(self, label: str) -> None:
        """A state whose activity ends with an outcome is entered: there is none until it has."""
        self._ended(label, None)

    def last_outcome(self, labels: tuple[str, ...]) -> str | None:
        """The outcome of that of the states which ended or was entered last; None if it has not ended."""
        last = next((label for label in reversed(self.outcomes) if label in labels), "")
        return self.outcomes.get(last)

    def cancel(self, label: str, activity: str, token: int) -> None:
        """Leave a state whose activity runs, or has failed."""
        if self.failed and self.failed.pop(label, None) is not None:
            return
        self.effects.append(Cancel(label, activity, token))

    def renew(self, variable: str) -> None:
        """A branch's variable starts anew: what was written to it before, in this step, is forgotten."""
        self.writes = [write for write in self.writes if write[1] != variable]

    def join(self, branch: str) -> None:
        """A protocol branch is entered."""
        self.effects.append(Joined(branch))

    def part(self, branch: str) -> None:
        """A protocol branch is left; what waits there is given up."""
        self.mail[branch].clear()
        self.effects.append(Left(branch))

    def fault(self, transition: int, reason: object) -> bool:
        """Note, once a step, that something of a transition could not be done; always False."""
        if transition not in self._faults:
            self._faults.add(transition)
            text = f"{type(reason).__name__}: {reason}" if isinstance(reason, Exception) else str(reason)
            self.effects.append(Fault(transition, text))
        return False

    def call(self, name: str, *arguments: Any) -> Any:
        """Call a function of the document and note its result.

        Raises:
            FunctionError: it does not exist, or gives something else than it declares.
        """
        known = self._functions.get(name)
        if known is None:
            target, result = next((t, r) for n, t, r, _ in self.PLAN.functions if n == name)
            known = self._functions[name] = (find_function(target), results_of(result))
        value = checked(name, known[0](*arguments), known[1])
        self.effects.append(FunctionResult(name, value))
        return value

    def random(self) -> float:
        """The next number in [0, 1) of this agent."""
        if self.chance is None:
            self.chance = Random(f"{self.seed}/{self.agent}")
        value = self.chance.random()
        self.effects.append(FunctionResult("random", value))
        return value

    @staticmethod
    def is_news(mark: Seen | None, seen: Seen) -> bool:
        """Whether there is another message or another value than when an `on` transition was taken last."""
        if mark is None:
            return True
        other = any(one is not new for one, new in zip(mark[0], seen[0], strict=True))
        return other or mark[1] != seen[1]

    def miss(self, region: int) -> None:
        """A region that is entered does not see the events of this step."""
        self.spent.update((region, name) for name in self.events)

    def failed_inside(self, label: str) -> bool:
        """Whether an activity of the state or inside it has failed."""
        return any(item == label or item.startswith(label + ".") for item in self.failed)

    def waiting_mail(
        self, branch: str, performative: str, message: str, participant: str
    ) -> AgentMessage | None:
        """The oldest agent message of that kind that waits in a branch."""
        return next(self.letters(branch, [(performative, message, participant)]), None)

    def take_mail(self, branch: str, performative: str, message: str, participant: str) -> None:
        """A transition takes the oldest agent message of that kind."""
        item = self.waiting_mail(branch, performative, message, participant)
        if item is not None:
            self.take_letter(item)

    def letters(self, branch: str, kinds: Iterable[tuple[str, str, str]]) -> Iterator[AgentMessage]:
        """The agent messages of these kinds that wait in a branch: kind by kind, the oldest first."""
        waiting = self.mail[branch]
        for kind in kinds:
            for item in waiting:
                if (item.performative, item.message, item.participant) == kind:
                    yield item

    def take_letter(self, item: AgentMessage) -> None:
        """A transition takes an agent message, unless another part of it has done so."""
        if any(other is item for other in self.mail[item.branch]):
            self.mail[item.branch] = [other for other in self.mail[item.branch] if other is not item]
            self.effects.append(MailTaken(item.branch, item.identity))

    def publish(self, region: int, board: Board, channel: str, drafts: Board | None = None) -> None:
        """Publish the region's drafts of a channel; the region itself sees a message to all at once.

        `drafts` are those of a region inside it, out of which a transition leads.
        """
        label = self.REGIONS[region]
        for host, message in (drafts or board).take_drafts(channel, self.MESSAGES[channel]):
            self.effects.append(Publication(channel, message, host, label))
            if host in (None, self.agent) and channel in board.CHANNELS:
                own = Sample(channel, message, self.agent, self.now, (self.agent, 0), label)
                self._put(region, board, own)

    def send(
        self,
        branch: str,
        performative: str,
        message: str,
        participant: str,
        members: Mapping[tuple[str, ...], Any] | None = None,
        to: str | None = None,
        excepts: tuple[str, ...] = (),
    ) -> None:
        """Send an agent message with these members, or with the content that was prepared for it."""
        content = built(self.MESSAGES[message](), members or {})
        filled = members is not None
        self.effects.append(Sending(branch, performative, message, content, participant, filled, to, excepts))

    def read_messages(self, region: int, board: Board) -> None:
        """Let the region see what has arrived since the step began."""
        pending = tuple(self.pending())
        # What came in this step is out of it already; what waits no more was left out for a newer one.
        board.ahead.intersection_update([item.identity for item in pending])
        for item in pending:
            if (
                item.channel in board.CHANNELS
                and item.written_by != self.REGIONS[region]
                and item.identity not in board.ahead
            ):
                board.ahead.add(item.identity)
                self._put(region, board, item)


def _is_at(leaf: int, leaves: Iterable[tuple[int, int]]) -> bool:
    """Whether the number of an active leaf is one of these."""
    return any(first <= leaf <= last for first, last in leaves)
