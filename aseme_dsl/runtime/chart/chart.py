"""Chart: what the generated step classes have in common: a synchronous step from inputs to effects.

A chart has no thread, clock or socket in it. The shell (`agent.py`) gives it the time and the inputs and
carries its effects out; simulation, replay and tests do the same.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from copy import copy
from random import Random
from typing import Any, TypeVar

from aseme_dsl.runtime.chart.board import NEVER, Board, built
from aseme_dsl.runtime.chart.bounds import OutOfBounds, check, check_length, check_place
from aseme_dsl.runtime.chart.functions import checked, find_function, results_of
from aseme_dsl.runtime.chart.history import value_of
from aseme_dsl.runtime.chart.inputs import (
    AgentMessage,
    Cancel,
    Fault,
    FunctionResult,
    Input,
    Joined,
    Left,
    MailTaken,
    Outcome,
    Publication,
    Resumed,
    Sample,
    Sending,
    Start,
    Suspended,
)
from aseme_dsl.runtime.chart.plan import is_in
from aseme_dsl.runtime.chart.saving import Saved, load, save
from aseme_dsl.runtime.chart.state import ChartState
from aseme_dsl.runtime.chart.stepping import (
    RECEIVE,
    count_waiting,
    end_step,
    expired_signals,
    fail_for_breach,
    fail_late_activities,
    livelock,
    put,
    set_outcome,
    stop,
)

ROUNDS = 1000
"""A step that does not settle in so many rounds never will, unless they have made what waits become less."""

ABSENT = "a value is absent"
"""Why an action was not done that needs a message which is not there."""

INACTIVE = -1
"""A region's number while its AND is not active."""

T = TypeVar("T")

Seen = tuple[tuple[object, ...], tuple[object, ...]]
"""What a condition reads: messages, and the values of variables and timers."""


class Chart(ChartState):
    """A running statechart. Subclasses are generated; see `semantics.md` for what a step does.

    Nearly all methods are operations of generated code, which calls each of them by its name.
    """

    __slots__ = ()

    # ---- the step --------------------------------------------------------------------------

    def step(self, now: int, inputs: Iterable[Input]) -> Outcome:
        """Take the inputs together, continue until nothing is enabled, and return what happened.

        `now` is in ns and never goes back. A finished or failed chart does nothing. If it has `raised`
        events, the first of them is for this step, and no inputs should be given.
        """
        outcome = self.outcome = Outcome()
        self.taken = outcome.taken
        self.effects = outcome.effects
        if self.finished or self.failure is not None:
            outcome.finished, outcome.failure = self.finished, self.failure
            return outcome
        self.now = now
        if self.EXPIRING:  # before a newer one of the same sender replaces it
            self.effects += expired_signals(self, now)
        for item in inputs:
            RECEIVE[type(item)](self, item)
        if self.raised:
            self.events.add(self.raised[0])
            self.raised = self.raised[1:]
        if self.EXPIRING:
            self.effects += expired_signals(self, now)
        if self.WITHIN:
            fail_late_activities(self)
        if not self.started:
            self.started = True
            self.enter()
        rounds = 0
        bound, waiting = ROUNDS, NEVER if self.READERS or self.mail else 0
        while self.round() or (self.breach is not None and fail_for_breach(self)):
            rounds += 1
            if rounds == bound:
                left = count_waiting(self)
                if left >= waiting:
                    stop(self, livelock(self, rounds))
                    break
                bound, waiting = bound + ROUNDS, left  # a queue that becomes shorter comes to an end
        end_step(self, outcome)
        if self._faults:
            self._faults.clear()
        return outcome

    def save(self) -> Saved:
        """The whole state between two steps, as a plain immutable value."""
        return save(self)

    def load(self, saved: Saved) -> None:
        """Take the state of a chart of the same model. Raises OtherModel for that of another one."""
        load(self, saved)

    # ---- what generated code calls ---------------------------------------------------------

    def begin(self, label: str, activity: str, arguments: tuple[tuple[str, object], ...] = ()) -> int:
        """Start an activity; the token is its own. Its state fails at once if a write on the way has."""
        if self.breach is not None and is_in(label, self.breach[0]):
            self.failed[label] = self.breach[1]
            self.breach = None
            return 0
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
        set_outcome(self, label, None)

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
        self.rounds.forget(branch)
        self.effects.append(Joined(branch))

    def part(self, branch: str, completed: bool = False) -> None:
        """A protocol branch is left, at its END or before; what waits is given up, unless it is held."""
        if branch in self.ABANDON and not completed and branch not in self.held:
            self.abandon(branch)
        timers = self._take_timers(branch)
        if branch in self.held and not completed:
            self.suspended[branch] = self.now, timers
            self.effects.append(Suspended(branch))
            return
        self.mail[branch] = ()
        self.rounds.forget(branch)
        self.effects.append(Left(branch, completed))

    def abandon(self, branch: str) -> None:
        """Do what a branch does when it is left before its END."""
        self.abandoning = True
        getattr(self, self.ABANDON[branch])()
        self.abandoning = False

    def hold(self, label: str) -> None:
        """The branches in a state that is left now, and may be resumed, are suspended."""
        if self.failure is None:
            self.held.update(branch for branch in self.mail if is_in(branch, label))

    def proceed(self, branch: str) -> bool:
        """Resume a branch that was suspended, and the time that stood still in it; False if it was not."""
        if branch not in self.suspended:
            return False
        passed = self._resume(branch)
        for label, slot in self.TIMES.items():
            if is_in(label, branch):
                setattr(self, slot, getattr(self, slot) + passed)
        for number, label in enumerate(self.REGIONS):
            if is_in(label, branch):
                inner = getattr(self, f"b{number}").timers
                inner.update({name: due + passed for name, due in inner.items()})
        return True

    def proceed_inside(self, branch: str) -> None:
        """Resume a branch inside a resumed one: its time stood still together with that."""
        if branch in self.suspended:
            self._resume(branch)

    def _resume(self, branch: str) -> int:
        """A branch is suspended no more, and its own timers run again; for how long it was, in ns."""
        moment, timers = self.suspended.pop(branch)
        passed = self.now - moment
        if timers:
            self._timers(branch).update({name: due + passed for name, due in timers.items()})
        self.effects.append(Resumed(branch))
        return passed

    def discard(self, label: str, but: str = "") -> None:
        """Discard the branches suspended in a state, except those held or in the state `but`."""
        for branch in [item for item in self.suspended if is_in(item, label) and item not in self.held]:
            if not but or not is_in(branch, but):
                del self.suspended[branch]
                self.part(branch)

    def _timers(self, branch: str) -> dict[str, int]:
        board: Board = getattr(self, self.PART_TIMERS[branch][0])
        return board.timers

    def _take_timers(self, branch: str) -> dict[str, int]:
        """The timers of a branch that is left, which then run no more."""
        if branch not in self.PART_TIMERS:
            return {}
        timers = self._timers(branch)
        return {name: timers.pop(name) for name in self.PART_TIMERS[branch][1] if name in timers}

    def fault(self, transition: int, reason: object) -> bool:
        """Note, once a step, that something of a transition could not be done; always False."""
        if isinstance(reason, OutOfBounds):
            self._fail_entered(transition, str(reason))
        self._note_fault(transition, _shown(reason))
        return False

    def unsent(self, transition: int, message: str, reason: object) -> None:
        """Note that a message is not sent, as a value of it is absent or raises; what is entered fails."""
        text = f"{message} is not sent: {_shown(reason)}"
        if not self.abandoning:  # a farewell enters nothing
            self._fail_entered(transition, text)
        self._note_fault(transition, text)

    def _note_fault(self, transition: int, text: str) -> None:
        if transition not in self._faults:
            self._faults.add(transition)
            self.effects.append(Fault(transition, text))

    def _fail_entered(self, transition: int, reason: str) -> None:
        """The state that the transition in hand enters will fail."""
        if self.breach is None and self.failure is None:
            way = self._way()
            target = self.PLAN.transitions[way[-1]].target if way else self.REGIONS[0]
            self.breach = target, f"{reason} ({self.PLAN.transitions[transition].at})"

    def probe(self, number: int, holds: bool) -> bool:
        """Whether a part of a condition holds, in code that is to be measured: a class inside may tell it."""
        return holds

    def call(self, name: str, *arguments: object) -> Any:
        """Call a function of the document and note its result.

        Raises:
            FunctionError: it does not exist, or gives something else than it declares.
        """
        known = self._functions.get(name)
        if known is None:
            target, result = next((t, r) for n, t, r, _ in self.PLAN.functions if n == name)
            known = self._functions[name] = (find_function(target), results_of(result))
        value = known[0](*arguments)
        if type(value) not in known[1]:
            checked(name, value, known[1])
        self.effects.append(FunctionResult(name, value))
        return value

    def stand_in(self, functions: Mapping[str, Callable[..., object]]) -> None:
        """Have these called instead of the functions of the document, all of which they are."""
        for name, _, result, _ in self.PLAN.functions:
            self._functions[name] = functions[name], results_of(result)

    def random(self) -> float:
        """The next number in [0, 1) of this agent."""
        if self.chance is None:
            self.chance = Random(f"{self.seed}/{self.agent}")
        value = self.chance.random()
        self.effects.append(FunctionResult("random", value))
        return value

    @staticmethod
    def inside(name: str, least: float, most: float, value: T) -> T:
        """The value that a bounded variable is to hold. Raises OutOfBounds if it cannot."""
        check(name, least, most, value)
        return value

    @staticmethod
    def short(name: str, length: int, items: tuple[T, ...]) -> tuple[T, ...]:
        """The list that a variable is to hold. Raises OutOfBounds if it is too long."""
        check_length(name, length, items)
        return items

    @staticmethod
    def appended(items: tuple[T, ...], item: T) -> tuple[T, ...]:
        """A list with one element more."""
        return (*items, item)

    @staticmethod
    def removed(items: tuple[T, ...], item: T) -> tuple[T, ...]:
        """A list without the first element that equals the item."""
        place = items.index(item) if item in items else len(items)
        return (*items[:place], *items[place + 1 :])

    @staticmethod
    def dropped(name: str, items: tuple[T, ...], place: int) -> tuple[T, ...]:
        """A list without the element at a place. Raises OutOfBounds if there is none."""
        check_place(name, items, place)
        return (*items[:place], *items[place + 1 :])

    @staticmethod
    def put(name: str, items: tuple[T, ...], place: int, item: T) -> tuple[T, ...]:
        """A list with another element at a place. Raises OutOfBounds if there is none."""
        check_place(name, items, place)
        return (*items[:place], item, *items[place + 1 :])

    @staticmethod
    def of_each(items: tuple[object, ...], path: tuple[str, ...]) -> tuple[object, ...]:
        """The members at a path of the elements of a list; None where an optional one is not there."""
        return tuple([value_of(item, path) for item in items])

    @staticmethod
    def made(
        kind: Any, members: Iterable[tuple[tuple[str, ...], object]], rest: object, taken: tuple[str, ...]
    ) -> Any:
        """A new message with these members; the others are those of `rest` that are `taken`, or have their
        defaults."""
        given = {name: copy(getattr(rest, name)) for name in taken}
        return built(kind, dict(members), given)

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
        for item in self.mail[branch]:
            if (
                item.performative == performative
                and item.message == message
                and item.participant == participant
            ):
                return item
        return None

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
        waiting = self.mail[item.branch]
        left = tuple([other for other in waiting if other is not item])
        if len(left) < len(waiting):
            self.mail[item.branch] = left
            self.rounds.taken(item)
            self.effects.append(MailTaken(item.branch, item.identity))

    def give_mail(self, item: AgentMessage) -> None:
        """An activity takes an agent message. Between two steps."""
        waiting = self.mail[item.branch]
        self.mail[item.branch] = tuple([other for other in waiting if other.identity != item.identity])
        self.rounds.taken(item)

    def invited(self, branch: str, participant: str) -> int:
        """How many agents the last send to a participant went to."""
        return self.rounds.count(branch, participant, ())[0]

    def answered(self, branch: str, participant: str) -> int:
        """How many of them have answered, or are lost."""
        return self.rounds.count(branch, participant, self.mail[branch])[1]

    def all_answered(self, branch: str, participant: str) -> bool:
        """Whether all of them have, and there is one."""
        invited, answered = self.rounds.count(branch, participant, self.mail[branch])
        return 0 < invited == answered

    def publish(self, region: int, board: Board, channel: str, drafts: Board | None = None) -> None:
        """Publish the region's drafts of a channel; the region itself sees a message to all at once.

        `drafts` are those of a region inside it, out of which a transition leads.
        """
        label = self.REGIONS[region]
        for host, message in (drafts or board).take_drafts(channel, self.MESSAGES[channel]):
            self.effects.append(Publication(channel, message, host, label))
            if host in (None, self.agent) and channel in board.CHANNELS:
                own = Sample(channel, message, self.agent, self.now, (self.agent, 0), label)
                put(self, region, board, own)

    def send(
        self,
        branch: str,
        performative: str,
        message: str,
        participant: str,
        members: Mapping[tuple[str, ...], object] | None = None,
        to: str | None = None,
        excepts: tuple[str, ...] = (),
        rest: object = None,
        taken: tuple[str, ...] = (),
        reply_within: int | None = None,
        one: bool = False,
    ) -> None:
        """Send an agent message with these members, or with the content that was prepared for it.

        Members that are not given are those of `rest` that are `taken`, or have their defaults.
        """
        content = self.made(self.MESSAGES[message], (members or {}).items(), rest, taken)
        filled = members is not None
        reply_by = None if reply_within is None else self.now + reply_within
        if to is None and (branch, participant) in self.PLAN.counted:
            self.rounds.sent(branch, participant)
        self.effects.append(
            Sending(
                branch,
                performative,
                message,
                content,
                participant,
                filled,
                to,
                excepts,
                reply_by,
                one,
                self._way(),
            )
        )

    def _way(self) -> tuple[int, ...]:
        """The compound transition that is being taken; what is done at an exit belongs to it."""
        if self.abandoning:
            return self.taken[-1]
        transitions = self.PLAN.transitions
        for way in reversed(self.taken):
            if transitions[way[0]].kind not in ("exit", "abandon"):
                return way
        return ()

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
                put(self, region, board, item)


def _shown(reason: object) -> str:
    """Why something was not done, in words; what Python has raised comes with its kind."""
    is_raised = isinstance(reason, Exception) and not isinstance(reason, OutOfBounds)
    return f"{type(reason).__name__}: {reason}" if is_raised else str(reason)
