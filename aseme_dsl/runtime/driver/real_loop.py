"""The event loop of `async` activities in real time. Apart, because asyncio takes long to import."""

from __future__ import annotations

import asyncio
import selectors
import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, cast

from aseme_dsl.runtime.activity.stacks import place_of
from aseme_dsl.runtime.driver.virtual_loop import run_async
from aseme_dsl.runtime.ports import Complain

if TYPE_CHECKING:
    from aseme_dsl.runtime.activity.execution import Execution


class RealLoop:
    """An event loop in a thread of its own. When an activity blocks it, another takes its place."""

    def __init__(self, ended: Callable[[Execution], None], complain: Complain) -> None:
        self._ended = ended
        self._complain = complain
        self._loop, self._thread = _start(complain)
        self._blocked: list[tuple[asyncio.AbstractEventLoop, threading.Thread]] = []
        self._unheard = 0

    def launch(self, execution: Execution) -> None:
        """Run the code of an activity."""
        loop = self._loop
        execution.handle = (loop, None)
        loop.call_soon_threadsafe(self._begin, loop, execution)

    def cancel(self, execution: Execution) -> None:
        """Tell an activity that its state was left; once more, if it does not listen."""
        loop, _ = _handle(execution)
        loop.call_soon_threadsafe(_cancel, execution)

    def look(self, patience: int) -> None:
        """Report a loop that has done nothing between so many calls of this, and begin another."""
        if self._unheard >= patience:
            place = place_of(self._thread.ident)
            self._blocked.append((self._loop, self._thread))
            self._loop, self._thread = _start(self._complain)
            self._unheard = 0
            # Not before there is another: what begins because of this must not be held up, too.
            self._complain(
                f"an async activity blocks the event loop{place}: the others in it stand still, later ones "
                "run in a new loop"
            )
        self._unheard += 1
        self._loop.call_soon_threadsafe(self._heard, self._loop)

    def close(self) -> None:
        """Let the loops end."""
        for loop, _ in (*self._blocked, (self._loop, self._thread)):
            loop.call_soon_threadsafe(loop.stop)

    def join(self, seconds: Callable[[], float]) -> None:
        """Wait for the loop to end, so many seconds at the most."""
        self._thread.join(seconds())

    def _heard(self, loop: asyncio.AbstractEventLoop) -> None:
        if loop is self._loop:
            self._unheard = 0

    def _begin(self, loop: asyncio.AbstractEventLoop, execution: Execution) -> None:
        task = loop.create_task(run_async(execution))
        execution.handle = (loop, task)
        task.add_done_callback(lambda done: self._end(execution, done))

    def _end(self, execution: Execution, task: asyncio.Task[None]) -> None:
        if task.cancelled():  # before it began: nothing of it has run that could say so
            execution.returned(asyncio.CancelledError())
        self._ended(execution)


def _handle(execution: Execution) -> tuple[asyncio.AbstractEventLoop, asyncio.Task[None] | None]:
    """The loop and the task of an activity, which `launch` has given it."""
    return cast("tuple[asyncio.AbstractEventLoop, asyncio.Task[None] | None]", execution.handle)


def _cancel(execution: Execution) -> None:
    _, task = _handle(execution)
    if task is not None:
        task.cancel()


def _start(complain: Complain) -> tuple[asyncio.AbstractEventLoop, threading.Thread]:
    """An event loop that selects with `select`, whose timeouts are not rounded to whole milliseconds."""
    loop = asyncio.SelectorEventLoop(selectors.SelectSelector())

    def handle(_: asyncio.AbstractEventLoop, context: dict[str, object]) -> None:
        error = context.get("exception")
        complain(f"{context.get('message')}{f': {error!r}' if error is not None else ''}")

    def work() -> None:
        asyncio.set_event_loop(loop)
        try:
            loop.run_forever()
        finally:
            for task in asyncio.all_tasks(loop):  # those that do not end are reported already
                task._log_destroy_pending = False  # type: ignore[attr-defined]
            loop.run_until_complete(loop.shutdown_asyncgens())
            loop.close()

    loop.set_exception_handler(handle)
    thread = threading.Thread(target=work, name="aseme async", daemon=True)
    thread.start()
    return loop, thread
