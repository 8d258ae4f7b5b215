"""The event loop of `async` activities in virtual time. Apart, because asyncio takes long to import."""

from __future__ import annotations

import asyncio
import contextvars
from collections import deque
from collections.abc import Awaitable, Callable
from typing import TYPE_CHECKING, Any, cast

from aseme_dsl.runtime.activity.returning import as_outcome
from aseme_dsl.runtime.time.clock import nanoseconds
from aseme_dsl.runtime.time.timers import Scheduler

if TYPE_CHECKING:
    from aseme_dsl.runtime.activity.execution import Execution


async def run_async(execution: Execution) -> None:
    """Run the code of an async activity to its end, and say how it ended."""
    execution.returned(await _error(execution))


async def _error(execution: Execution) -> BaseException | None:
    """Run the code; what it raised. Apart, so that no frame holds an exception that holds the frame."""
    try:
        context = execution.context
        context.raise_if_cancelled()
        assert execution.code is not None
        made = execution.code().execute(context, **execution.arguments)
        execution.result = as_outcome(await cast("Awaitable[object]", made))
    except BaseException as raised:  # of any type: the agent must hear of it
        return raised
    return None


class VirtualLoop:
    """An event loop in virtual time: tasks, futures and timers, nothing that waits for the world outside.

    Of `asyncio.AbstractEventLoop` it has what `asyncio` itself uses for those.
    """

    def __init__(
        self,
        scheduler: Scheduler,
        soon: Callable[[Callable[[], None]], None],
        complain: Callable[[str], None],
    ) -> None:
        """`soon` has a call made at this instant; `complain` gets what goes wrong in the loop."""
        self._scheduler = scheduler
        self._soon = soon
        self._complain = complain
        self._ready: deque[asyncio.Handle] = deque()
        self._pumping = False
        self._tasks: list[asyncio.Task[Any]] = []
        self._self: Any = self

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"virtual time has no event loop with {name}: nothing comes from outside")

    def time(self) -> float:
        return self._scheduler.clock.now() / 1e9

    def call_soon(
        self, callback: Callable[..., object], *args: Any, context: contextvars.Context | None = None
    ) -> asyncio.Handle:
        handle = asyncio.Handle(callback, args, self._self, context)
        self._make_ready(handle)
        return handle

    call_soon_threadsafe = call_soon

    def call_later(
        self,
        delay: float,
        callback: Callable[..., object],
        *args: Any,
        context: contextvars.Context | None = None,
    ) -> asyncio.TimerHandle:
        moment = self._scheduler.clock.now() + nanoseconds(max(delay, 0.0))
        handle = asyncio.TimerHandle(moment / 1e9, callback, args, self._self, context)
        self._scheduler.at(moment, lambda: self._make_ready(handle))
        return handle

    def call_at(
        self,
        when: float,
        callback: Callable[..., object],
        *args: Any,
        context: contextvars.Context | None = None,
    ) -> asyncio.TimerHandle:
        return self.call_later(when - self.time(), callback, *args, context=context)

    def _timer_handle_cancelled(self, handle: asyncio.TimerHandle) -> None:
        """A cancelled handle is passed over when its time comes."""

    def create_future(self) -> asyncio.Future[Any]:
        return asyncio.Future(loop=self._self)

    def create_task(self, coro: Any, **options: Any) -> asyncio.Task[Any]:
        task: asyncio.Task[Any] = asyncio.Task(coro, loop=self._self, **options)
        self._tasks.append(task)
        task.add_done_callback(self._tasks.remove)
        return task

    def run_in_executor(self, executor: Any, func: Callable[..., Any], *args: Any) -> asyncio.Future[Any]:
        """Virtual time has no second thread: the function is called at once."""
        future = self.create_future()
        try:
            future.set_result(func(*args))
        except Exception as error:
            future.set_exception(error)
        return future

    def is_running(self) -> bool:
        return self._pumping

    def is_closed(self) -> bool:
        return False

    def get_debug(self) -> bool:
        return False

    def call_exception_handler(self, context: dict[str, Any]) -> None:
        error = context.get("exception")
        self._complain(f"{context.get('message')}{f': {error!r}' if error is not None else ''}")

    def shut(self) -> None:
        """Give up the tasks that have not ended."""
        for task in self._tasks:
            task._log_destroy_pending = False  # type: ignore[attr-defined]

    def _make_ready(self, handle: asyncio.Handle) -> None:
        if not handle.cancelled():
            self._ready.append(handle)
            if len(self._ready) == 1 and not self._pumping:
                self._soon(self._pump)

    def _pump(self) -> None:
        """Run what is ready, until nothing is."""
        outer = asyncio._get_running_loop()
        asyncio._set_running_loop(self._self)
        self._pumping = True
        try:
            while self._ready:
                handle = self._ready.popleft()
                if not handle.cancelled():
                    handle._run()
        finally:
            self._pumping = False
            asyncio._set_running_loop(outer)
