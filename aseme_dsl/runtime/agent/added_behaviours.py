"""Added behaviours: what an agent does beside its statechart, as JADE's behaviours; a user subclasses these.

An agent runs one action at a time, between its steps. An action takes no time and does not block: it ends, or
it is a generator that yields its pauses in seconds. What is not done and does not `block` is
run again: at once if it has received a message, else after 10 ms.
"""

from __future__ import annotations

from collections.abc import Generator, Hashable, Mapping
from types import MappingProxyType
from typing import Any, NoReturn, Protocol

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.agent.data_store import HasDataStore
from aseme_dsl.runtime.message.free import ACLMessage, MessageTemplate
from aseme_dsl.runtime.time.clock import nanoseconds

ALL, ANY = "all", "any"
"""When a parallel behaviour is done: when all of its behaviours are, or one of them."""


@dataclass(frozen=True, slots=True)
class Pause:
    """What a generator waits for: a moment (ns of the run), a message, or what comes first of both."""

    until: int | None
    message: bool = True


class Scheduling(Protocol):
    """Who runs the behaviours of an agent, as a behaviour sees it."""

    def now(self) -> int: ...
    def block(self, behaviour: Behaviour, until: int | None) -> None: ...
    def restart(self, behaviour: Behaviour) -> None: ...
    def receive(self, template: MessageTemplate | None) -> ACLMessage | None: ...
    def send(self, message: ACLMessage) -> ACLMessage: ...
    def log(self, behaviour: Behaviour, text: str) -> None: ...


class Behaviour(HasDataStore):
    """One thing that an agent does. A subclass overrides `action` and `done`.

    Raises RuntimeError where a method needs an agent and it was not added to one.
    """

    agent: Any = None
    """The agent that it was added to."""
    parent: CompositeBehaviour | None = None
    _runs_in: Scheduling | None = None
    _has_run: bool = False

    def on_start(self) -> None:
        """Called once, before its first action; to be overridden."""

    def action(self) -> object:
        """What it does; to be overridden. A generator may take time."""
        raise NotImplementedError

    def done(self) -> bool:
        """Whether it has done all; asked after each action."""
        raise NotImplementedError

    def on_end(self) -> object:
        """Called when it is done; to be overridden. In an FSM, what it returns chooses the transition."""
        return None

    def reset(self) -> None:
        """Called before it starts once more, in an FSM; to be overridden."""

    @property
    def name(self) -> str:
        """The name of its class."""
        return type(self).__name__

    # ---- for an action -----------------------------------------------------------------------

    def receive(self, template: MessageTemplate | None = None) -> ACLMessage | None:
        """Take the oldest message that waits and that the template matches, or None."""
        return self._running.receive(template)

    def blocking_receive(
        self, template: MessageTemplate | None = None, seconds: float | None = None
    ) -> Waiting:
        """The next such message, or None after so many seconds.

        To be used as `message = yield from self.blocking_receive(…)`.

        Only this behaviour waits; the others and the statechart continue.
        """
        return Waiting(self._running, template, seconds)

    def send(self, message: ACLMessage) -> ACLMessage:
        """Send a message; gives it as it was sent, with the `reply_with` that an answer names.

        Raises:
            LookupError: it belongs to a protocol of the system, whose participants alone send it.
            ValueError: it has no receiver.
        """
        return self._running.send(message)

    def block(self, seconds: float | None = None) -> None:
        """After this action, wait for a message, or for so many seconds. Returns at once, as in JADE."""
        running = self._running
        running.block(self, None if seconds is None else running.now() + nanoseconds(seconds))

    def restart(self) -> None:
        """Wait no longer after `block`."""
        self._running.restart(self)

    def log(self, text: str) -> None:
        """Write a line into the trace."""
        self._running.log(self, str(text))

    # ---- for who runs it ---------------------------------------------------------------------

    @property
    def _running(self) -> Scheduling:
        if self._runs_in is None:
            raise RuntimeError(f"{self.name} is not a behaviour of an agent: add it with add_behaviour")
        return self._runs_in

    def _renew(self) -> None:
        """It starts, perhaps not for the first time."""

    def _due(self, now: int) -> int | None:
        """The moment of its next action; None: at once, or when something happens."""
        return None

    def _problem(self) -> str | None:
        """Why it cannot be added."""
        for name in ("action", "done"):
            if getattr(type(self), name) is getattr(Behaviour, name):
                return f"{self.name} has no {name}"
        return None


class Waiting:
    """A message that a behaviour waits for, to be used with `yield from`."""

    __slots__ = ("_running", "_seconds", "_template")

    def __init__(self, running: Scheduling, template: MessageTemplate | None, seconds: float | None) -> None:
        self._running = running
        self._template = template
        self._seconds = seconds

    def __iter__(self) -> Generator[Pause, None, ACLMessage | None]:
        running = self._running
        until = None if self._seconds is None else running.now() + nanoseconds(self._seconds)
        while True:
            message = running.receive(self._template)
            if message is not None:
                return message
            if until is not None and running.now() >= until:
                return None
            yield Pause(until)

    def __getattr__(self, name: str) -> NoReturn:
        raise AttributeError(f"{name}: write `message = yield from self.blocking_receive(…)`")

    def __bool__(self) -> NoReturn:
        raise TypeError("write `message = yield from self.blocking_receive(…)`")


class SimpleBehaviour(Behaviour):
    """Its action is run until `done` says that it is."""


class OneShotBehaviour(Behaviour):
    """Its action is run once."""

    def done(self) -> bool:
        return True


class CyclicBehaviour(Behaviour):
    """Its action is run for ever."""

    def done(self) -> bool:
        return False


class WakerBehaviour(Behaviour):
    """`on_wake` is called once, after `seconds`."""

    seconds: float | None = None
    _moment: int | None = None

    def __init__(self, seconds: float | None = None) -> None:
        if seconds is not None:
            self.seconds = seconds

    def on_wake(self) -> object:
        """What it does when its time has come; to be overridden."""
        raise NotImplementedError

    def action(self) -> object:
        return self.on_wake()

    def done(self) -> bool:
        return True

    def _renew(self) -> None:
        self._moment = None

    def _due(self, now: int) -> int | None:
        if self._moment is None:
            self._moment = now + nanoseconds(self.seconds or 0)
        return self._moment

    def _problem(self) -> str | None:
        if type(self).on_wake is WakerBehaviour.on_wake:
            return f"{self.name} has no on_wake"
        if self.seconds is None or self.seconds < 0:
            return f"{self.name} does not say after how many seconds it wakes: {self.name}(seconds=2)"
        return super()._problem()


class TickerBehaviour(Behaviour):
    """`on_tick` is called every `seconds`, the first time after one period."""

    seconds: float | None = None
    tick_count: int = 0
    """How often it has ticked, this time included."""
    _stopped: bool = False
    _moment: int | None = None

    def __init__(self, seconds: float | None = None) -> None:
        if seconds is not None:
            self.seconds = seconds

    def on_tick(self) -> object:
        """What it does at each tick; to be overridden."""
        raise NotImplementedError

    def stop(self) -> None:
        """This tick is the last."""
        self._stopped = True

    def action(self) -> object:
        self.tick_count += 1
        return self.on_tick()

    def done(self) -> bool:
        return self._stopped

    def _renew(self) -> None:
        self.tick_count, self._stopped, self._moment = 0, False, None

    def _due(self, now: int) -> int | None:
        period = nanoseconds(self.seconds or 0)
        if self._moment is None:
            self._moment = now
        self._moment += ((now - self._moment) // period + 1) * period
        return self._moment

    def _problem(self) -> str | None:
        if type(self).on_tick is TickerBehaviour.on_tick:
            return f"{self.name} has no on_tick"
        if self.seconds is None or nanoseconds(self.seconds) <= 0:
            return f"{self.name} does not say how many seconds its period has: {self.name}(seconds=2)"
        return super()._problem()


class CompositeBehaviour(Behaviour):
    """A behaviour with others in it."""

    exit_value: object = None
    """What `on_end` of the behaviour that ended last in it has returned; its own `on_end` returns it, too."""
    _sub: tuple[Behaviour, ...] = ()

    def add_sub_behaviour(self, behaviour: Behaviour) -> None:
        """One more behaviour is in it, behind the others. Raises TypeError, and RuntimeError once it runs."""
        if not isinstance(behaviour, Behaviour):
            raise TypeError(f"{behaviour!r} is not a behaviour")
        if self._runs_in is not None:
            raise RuntimeError(f"{self.name} runs: add what is in it before you add it to the agent")
        around: Behaviour | None = self
        while around is not None and around is not behaviour:
            around = around.parent
        if behaviour.parent is not None or behaviour._runs_in is not None or around is not None:
            raise TypeError(f"{behaviour.name} is in use: make another object for {self.name}")
        behaviour.parent = self
        self._sub = (*self._sub, behaviour)

    @property
    def sub_behaviours(self) -> tuple[Behaviour, ...]:
        """What is in it."""
        return self._sub

    def action(self) -> object:
        """Nothing: what is in it acts."""

    def done(self) -> bool:
        return False

    def on_end(self) -> object:
        return self.exit_value

    def _first(self) -> tuple[Behaviour, ...]:
        """What starts with it."""
        return self._sub[:1]

    def _after(self, ended: Behaviour, result: object) -> tuple[Behaviour, ...] | None:
        """What starts after one in it has ended; None: it is done."""
        raise NotImplementedError

    def _problem(self) -> str | None:
        if type(self).action is not CompositeBehaviour.action:
            return f"{self.name} overrides action: what is in it acts"
        return super()._problem() if self._sub else f"{self.name} has no behaviours in it"


class SequentialBehaviour(CompositeBehaviour):
    """Its behaviours run one after the other."""

    def _after(self, ended: Behaviour, result: object) -> tuple[Behaviour, ...] | None:
        place = next(number for number, item in enumerate(self._sub) if item is ended)
        return self._sub[place + 1 : place + 2] or None


class ParallelBehaviour(CompositeBehaviour):
    """Its behaviours run beside each other. It is done when all, one or so many are; the rest is removed."""

    when: str | int = ALL
    _ended: int = 0

    def __init__(self, when: str | int | None = None) -> None:
        if when is not None:
            self.when = when

    def _first(self) -> tuple[Behaviour, ...]:
        self._ended = 0
        return self._sub

    def _after(self, ended: Behaviour, result: object) -> tuple[Behaviour, ...] | None:
        self._ended += 1
        wanted = self.when if isinstance(self.when, int) else 1 if self.when == ANY else len(self._sub)
        return None if self._ended >= wanted else ()

    def _problem(self) -> str | None:
        is_number = isinstance(self.when, int) and 1 <= self.when <= len(self._sub)
        if self.when not in (ALL, ANY) and not is_number:
            return (
                f"{self.name}.when is {self.when!r}: it can be {ALL!r}, {ANY!r} or a number of its behaviours"
            )
        return super()._problem()


class FSMBehaviour(CompositeBehaviour):
    """Its behaviours are states; what `on_end` of one returns chooses the transition to the next."""

    _states: Mapping[str, Behaviour] = MappingProxyType({})
    _lasts: frozenset[str] = frozenset()
    _initial: str | None = None
    _ways: Mapping[tuple[str, Hashable], str] = MappingProxyType({})
    _defaults: Mapping[str, str] = MappingProxyType({})
    current: str | None = None
    """The name of the state that runs."""

    def register_first_state(self, behaviour: Behaviour, name: str) -> None:
        """The state in which it starts."""
        self.register_state(behaviour, name)
        self._initial = name

    def register_state(self, behaviour: Behaviour, name: str) -> None:
        """A state. Raises ValueError if there is one of that name."""
        if name in self._states:
            raise ValueError(f"{self.name} has a state {name} already")
        self.add_sub_behaviour(behaviour)
        self._states = {**self._states, name: behaviour}

    def register_last_state(self, behaviour: Behaviour, name: str) -> None:
        """A state with which it is done."""
        self.register_state(behaviour, name)
        self._lasts |= {name}

    def register_transition(self, source: str, target: str, event: Hashable) -> None:
        """When `on_end` of the source returns this event, the target is next."""
        self._ways = {**self._ways, (source, event): target}

    def register_default_transition(self, source: str, target: str) -> None:
        """When the source has ended and no other transition has its event, the target is next."""
        self._defaults = {**self._defaults, source: target}

    def _first(self) -> tuple[Behaviour, ...]:
        self.current = self._initial
        return (self._states[self._initial or ""],)

    def _after(self, ended: Behaviour, result: object) -> tuple[Behaviour, ...] | None:
        name = next(name for name, item in self._states.items() if item is ended)
        if name in self._lasts:
            return None
        target = self._ways.get((name, result), self._defaults.get(name))
        if target is None:
            raise LookupError(
                f"state {name} has ended with {result!r}, and {self.name} has no transition for that"
            )
        self.current = target
        return (self._states[target],)

    def _problem(self) -> str | None:
        if self._sub and self._initial is None:
            return f"{self.name} has no first state: register_first_state"
        named = [*((source, target) for (source, _), target in self._ways.items()), *self._defaults.items()]
        for name in (name for pair in named for name in pair):
            if name not in self._states:
                known = ", ".join(self._states) or "none"
                return f"{self.name} has a transition with {name}; its states are {known}"
        left = {source for source, _ in named} | self._lasts
        stuck = next((name for name in self._states if name not in left), None)
        if stuck is not None:
            return f"no transition of {self.name} leaves {stuck}: register it as a last state"
        return super()._problem()


__all__ = [
    "ALL",
    "ANY",
    "Behaviour",
    "CompositeBehaviour",
    "CyclicBehaviour",
    "FSMBehaviour",
    "OneShotBehaviour",
    "ParallelBehaviour",
    "Pause",
    "Scheduling",
    "SequentialBehaviour",
    "SimpleBehaviour",
    "TickerBehaviour",
    "Waiting",
    "WakerBehaviour",
]
