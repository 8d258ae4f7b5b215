"""Machine: the complete runtime of a plain statechart: queue, run to completion, trace, threads.

A plain chart (`plain.py`) may not be called while it runs. Through a machine it may: what comes during a
step, from a method that the step calls or from another thread, waits in one queue and is taken after it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Generic, TypeVar

from aseme_dsl.runtime.plain import Plain

Trace = Callable[[str, str, bool], object]
"""Told after each step which it was (`start`, `send`, `step`, `done`, `failed`), of what, if it took any."""

Call = Callable[[str], object]
Waiting = list[tuple[Call, str]]
"""The steps that are to be made, in order, each with what it is given."""

_RAISED: tuple[Call, str] = (lambda _: None, "")
"""Stands in the queue for the token after a step that has raised something, before all that waits."""

C = TypeVar("C", bound=Plain)
T = TypeVar("T")


class Machine(Generic[C]):
    """A running plain chart that any method and any thread may give events.

    One token stands for the right to run the chart: whoever can take it runs his step and what has been
    queued meanwhile (post-and-help); whoever cannot queues his and goes on. Nobody waits.

    What a step raises goes to the caller whose thread runs it; what is queued waits for the next caller, who
    makes these steps before his own.
    """

    __slots__ = ("_queue", "_token", "_trace", "chart", "post", "send")

    send: Callable[[str], bool]
    """One step with an event; whether anything was taken. False, too, if it had to be queued."""
    post: Callable[[str], None]
    """One step with an event, after what is queued: now, or by whoever makes a step at the moment."""

    def __init__(self, chart: C, trace: Trace | None = None, *, strict: bool = False) -> None:
        """`strict`: to send an event that no transition waits for is a mistake, a ValueError."""
        self.chart = chart
        self._trace = trace
        core = chart.send if trace is None else _traced(chart.send, trace, "send")
        queue = self._queue = Waiting()
        token = self._token = [None]
        # One call of C takes the token, so no thread can come in between; closures, because their variables
        # are read faster than attributes, and `send` is short.

        def send(event: str) -> bool:
            try:
                token.pop()
            except IndexError:
                return _later(queue, token, core, event)
            try:
                taken = core(event)
            except BaseException:
                queue.insert(0, _RAISED)
                raise
            token.append(None)
            if queue:
                _drain(queue, token)
            return taken

        def post(event: str) -> None:
            if queue:
                queue.append((core, event))
                _drain(queue, token)
            else:
                send(event)

        self.send = _known(send, chart) if strict else send
        self.post = _known(post, chart) if strict else post

    def start(self) -> bool:
        """Enter the root, and go on until nothing is enabled."""
        chart = self.chart
        return self._run("start", "", lambda _: chart.start())

    def step(self, before: Callable[[C], object] | None = None) -> bool:
        """One step without an event, for what the blackboard says; whether anything was taken.

        `before` is given the chart when it is its turn, so that it may write to the blackboard: what a thread
        writes on its own, a step of another may see half way through.
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
        queue, token = self._queue, self._token
        if self._trace is not None:
            call = _traced(call, self._trace, what)
        try:
            token.pop()
        except IndexError:
            return _later(queue, token, call, argument)
        try:
            taken = call(argument)
        except BaseException:
            queue.insert(0, _RAISED)
            raise
        token.append(None)
        if queue:
            _drain(queue, token)
        return bool(taken)


def _known(call: Callable[[str], T], chart: Plain) -> Callable[[str], T]:
    """The same for the events of the chart only."""
    events = frozenset(chart.EVENTS)

    def checked(event: str) -> T:
        if event not in events:
            from difflib import get_close_matches

            near = get_close_matches(event, chart.EVENTS, 1)
            known = "there is none" if not events else f"it waits for {', '.join(chart.EVENTS)}"
            hint = f"did you mean {near[0]!r}?" if near else known
            raise ValueError(f"{type(chart).__name__} waits for no event {event!r}; {hint}")
        return call(event)

    return checked


def _later(queue: Waiting, token: list[None], call: Call, argument: str) -> bool:
    """Queue a step; but where nobody runs the chart because the last step has raised, make all that waits."""
    if queue[:1] != [_RAISED]:
        queue.append((call, argument))
        if token:  # given back in between
            _drain(queue, token)
        return False
    taken: list[object] = []
    queue.append((lambda argument: taken.append(call(argument)), argument))
    _drain(queue, token)
    return any(taken)


def _drain(queue: Waiting, token: list[None]) -> None:
    """Make the steps that are queued, unless somebody else does."""
    while queue:
        try:
            token.pop() if token else queue.remove(_RAISED)
        except (IndexError, ValueError):
            return
        try:
            while queue:
                # All at once, since the first of many leaves a list slowly; a deque needs much memory.
                steps = queue[:]
                del queue[: len(steps)]
                steps.reverse()
                try:
                    while steps:
                        call, argument = steps.pop()
                        call(argument)
                finally:
                    queue[:0] = reversed(steps)  # one has raised something
        except BaseException:
            queue.insert(0, _RAISED)
            raise
        token.append(None)


def _traced(call: Call, trace: Trace, what: str) -> Callable[[str], bool]:
    """A step that is told of."""

    def traced(argument: str) -> bool:
        taken = bool(call(argument))
        trace(what, argument, taken)
        return taken

    return traced


__all__ = ["Machine", "Trace"]
