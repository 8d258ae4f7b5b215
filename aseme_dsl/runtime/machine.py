"""Machine: the complete runtime of a plain statechart: queue, run to completion, trace, threads.

A plain chart (`plain.py`) may not be called while it runs. Through a machine it may: what comes during a
step, from a method that the step calls or from another thread, waits in one queue and is taken after it.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Generic, TypeVar

from aseme_dsl.runtime.plain import Plain

Trace = Callable[[str, str, bool], object]
"""Told after each step which it was (`start`, `send`, `step`, `done`), of what, and if it took anything."""

C = TypeVar("C", bound=Plain)


class Machine(Generic[C]):
    """A running plain chart that any method and any thread may give events.

    One token stands for the right to run the chart: whoever can take it runs his step and what has been
    queued meanwhile (post-and-help); whoever cannot queues his and goes on. Nobody waits.

    What a step raises goes to the caller whose thread runs it; what is queued waits for the next caller.
    """

    __slots__ = ("_done", "_run", "_start", "_step", "chart", "post", "send")

    send: Callable[[str], bool]
    """One step with an event; whether anything was taken. False, too, if it had to be queued."""
    post: Callable[[str], None]
    """One step with an event, after what is queued: now, or by whoever makes a step at the moment."""

    def __init__(self, chart: C, trace: Trace | None = None) -> None:
        self.chart = chart
        core = chart.send if trace is None else _traced(chart, "send", trace)
        queue: deque[tuple[Callable[[str], bool], str]] = deque()
        token = [None]
        # One call of C takes the token, so no thread can come in between; closures, because their variables
        # are read faster than attributes, and `send` is short.

        def drain() -> None:
            """Make the steps that are queued, unless somebody else does."""
            while queue:
                try:
                    token.pop()
                except IndexError:
                    return
                try:
                    while queue:
                        call, argument = queue.popleft()
                        call(argument)
                finally:
                    token.append(None)

        def send(event: str) -> bool:
            try:
                token.pop()
            except IndexError:
                queue.append((core, event))
                if token:  # given back in between
                    drain()
                return False
            try:
                taken = core(event)
            finally:
                token.append(None)
            if queue:
                drain()
            return taken

        def run(call: Callable[[str], bool], argument: str) -> bool:
            try:
                token.pop()
            except IndexError:
                queue.append((call, argument))
                if token:
                    drain()
                return False
            try:
                taken = call(argument)
            finally:
                token.append(None)
            if queue:
                drain()
            return taken

        def post(event: str) -> None:
            if queue:
                queue.append((core, event))
                drain()
            else:
                send(event)

        self.send = send
        self.post = post
        self._run = run
        self._start = _called(chart.start, trace, "start")
        self._step = _called(chart.step, trace, "step")
        self._done = chart.done if trace is None else _traced(chart, "done", trace)

    def start(self) -> bool:
        """Enter the root, and go on until nothing is enabled."""
        return self._run(self._start, "")

    def step(self) -> bool:
        """One step without an event, for what the blackboard says; whether anything was taken."""
        return self._run(self._step, "")

    def done(self, label: str) -> bool:
        """One step, before which the activity of a BASIC state has returned; whether anything was taken."""
        return self._run(self._done, label)


def _called(method: Callable[[], bool | None], trace: Trace | None, what: str) -> Callable[[str], bool]:
    """A method without argument, as the queue holds it."""

    def call(argument: str) -> bool:
        taken = bool(method())
        if trace is not None:
            trace(what, argument, taken)
        return taken

    return call


def _traced(chart: Plain, what: str, trace: Trace) -> Callable[[str], bool]:
    """A method whose steps are told of."""
    method: Callable[[str], bool] = getattr(chart, what)

    def call(argument: str) -> bool:
        taken = method(argument)
        trace(what, argument, taken)
        return taken

    return call


__all__ = ["Machine", "Trace"]
