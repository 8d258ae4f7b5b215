"""Machine: the complete runtime of a plain statechart: queue, run to completion, trace, threads.

A plain chart (`plain.py`) may not be called while it runs. Through a machine it may: what comes during a
step, from a method that the step calls or from another thread, waits in one queue and is taken after it.
"""

from __future__ import annotations

import copy
from collections.abc import Callable
from typing import Generic, TypeVar

from aseme_dsl.runtime.plain.plain import Plain, unknown_event

Trace = Callable[[str, str, bool], object]
"""Told after each step which it was (`start`, `send`, `step`, `done`, `failed`), of what, if it took any."""

Call = Callable[[str], object]
Waiting = list[tuple[Call, str]]
"""The steps that are to be made, in order, each with what it is given."""

C = TypeVar("C", bound=Plain)
T = TypeVar("T")


class Machine(Generic[C]):
    """A running plain chart that any method and any thread may give events.

    One token stands for the right to run the chart. A caller that gets it runs its own step and the steps
    that are queued meanwhile (post-and-help). A caller that does not get it queues its step and returns: no
    caller waits.

    What a step raises goes to the caller whose thread runs it; what is queued waits for the next caller, who
    makes these steps before his own.
    """

    __slots__ = ("__weakref__", "_make", "_queue", "_strict", "_trace", "chart", "post", "send")

    send: Callable[[str], bool]
    """One step with an event; whether anything was taken. False, too, if it had to be queued."""
    post: Callable[[str], object]
    """The same for those who do not ask, such as other threads."""

    def __init__(self, chart: C, trace: Trace | None = None, *, strict: bool = False) -> None:
        """`strict`: to send an event that no transition waits for is a mistake, a ValueError."""
        self.chart = chart
        self._trace = trace
        self._strict = strict
        self._queue = Waiting()
        core = chart.send if trace is None else _traced(chart.send, trace, "send")
        send, self._make = _stepping(core, self._queue)
        self.send = _known(send, chart) if strict else send
        self.post = self.send

    def __repr__(self) -> str:
        waiting = len(self._queue)
        return f"<Machine of {self.chart!r}{f', {waiting} steps wait' if waiting else ''}>"

    def __copy__(self) -> Machine[C]:
        make, (_, chart, *rest) = self.__reduce__()
        return make(type(self), copy.copy(chart), *rest)  # never two machines of one chart

    def __reduce__(self) -> tuple[Callable[..., Machine[C]], tuple[object, ...]]:
        if self._queue:
            raise RuntimeError(f"{self!r} cannot be copied while steps wait")
        return _machine, (type(self), self.chart, self._trace, self._strict)

    def start(self) -> bool:
        """Enter the root, and take transitions until none is enabled."""
        chart = self.chart
        return self._run("start", "", lambda _: chart.start())

    def step(self, before: Callable[[C], object] | None = None) -> bool:
        """One step without an event, for what the blackboard says; whether anything was taken.

        `before` gets the chart when its turn comes, so that it may write to the blackboard. If a thread
        writes there at another time, a step of another thread may see only a part of the values.
        """
        chart = self.chart
        if before is None:
            return self._run("step", "", lambda _: chart.step())

        def call(_: str) -> bool:
            before(chart)
            return chart.step()

        return self._run("step", "", call)

    def done(self, label: str, outcome: str | None = None) -> bool:
        """One step, before which the activity of a BASIC state has returned; whether anything was taken.

        `outcome` is the name of how it has ended, for activities that say so.

        Raises:
            KeyError: the statechart has no such state, or can never be in it.
        """
        chart = self.chart
        if outcome is None:
            return self._run("done", label, chart.done)
        return self._run("done", label, lambda label: chart.done(label, outcome))

    def failed(self, label: str, reason: str) -> bool:
        """One step, before which the activity of a BASIC state has failed; whether anything was taken.

        Raises:
            KeyError: the statechart has no such state, or can never be in it.
            ActivityFailed: the step has not left the state: no `error` transition has taken it.
        """
        chart = self.chart
        return self._run("failed", label, lambda label: chart.failed(label, reason))

    def _run(self, what: str, argument: str, call: Call) -> bool:
        """Make a step as `send` does, but any."""
        return self._make(call if self._trace is None else _traced(call, self._trace, what), argument)


def _stepping(
    core: Callable[[str], bool], queue: Waiting
) -> tuple[Callable[[str], bool], Callable[[Call, str], bool]]:
    """`send`, and what makes any step: functions that share the token, which is their variable `free`.

    To delete it is to take it. No other thread comes in between, nor does a signal (Ctrl-C) before the `try`
    that gives it back, since Python asks for signals after calls and jumps only. Nothing is as quick.
    """
    free = None

    def send(event: str) -> bool:
        nonlocal free
        if queue:
            return _queued(queue, drain, core, event)
        try:
            del free
        except NameError:
            return _queued(queue, drain, core, event)
        try:
            taken = core(event)
        finally:
            free = None  # noqa: F841 (the next one deletes it)
        if queue:
            drain()
        return taken

    def make(call: Call, argument: str) -> bool:
        nonlocal free
        if queue:
            return _queued(queue, drain, call, argument)
        try:
            del free
        except NameError:
            return _queued(queue, drain, call, argument)
        try:
            taken = call(argument)
        finally:
            free = None  # noqa: F841 (the next one deletes it)
        if queue:
            drain()
        return bool(taken)

    def drain() -> None:
        """Make the steps that are queued, unless another thread does."""
        nonlocal free
        while queue:
            try:
                del free
            except NameError:
                return
            steps: Waiting = []
            try:
                while queue:
                    # All at once, since the first of many leaves a list slowly; a deque needs much memory.
                    number = len(queue)
                    steps = queue[:number][::-1]
                    del queue[:number]
                    while steps:
                        call, argument = steps.pop()
                        call(argument)
            finally:
                queue[:0] = steps[::-1]  # one has raised something
                free = None

    return send, make


def _machine(kind: type[Machine[C]], chart: C, trace: Trace | None, strict: bool) -> Machine[C]:
    """What a copied machine is made with."""
    return kind(chart, trace, strict=strict)


def _known(call: Callable[[str], T], chart: Plain) -> Callable[[str], T]:
    """The same for the events of the chart only."""
    events = frozenset(chart.EVENTS)

    def checked(event: str) -> T:
        if event not in events:
            raise unknown_event(type(chart), event)
        return call(event)

    return checked


def _queued(queue: Waiting, drain: Callable[[], None], call: Call, argument: str) -> bool:
    """Queue a step, and make all queued steps unless another thread does; whether this step took anything."""
    taken: list[object] = []
    queue.append((lambda argument: taken.append(call(argument)), argument))
    drain()
    return any(taken)


def _traced(call: Call, trace: Trace, what: str) -> Callable[[str], bool]:
    """The step, with a call of `trace` after it."""

    def traced(argument: str) -> bool:
        taken = bool(call(argument))
        trace(what, argument, taken)
        return taken

    return traced


__all__ = ["Machine", "Trace"]
