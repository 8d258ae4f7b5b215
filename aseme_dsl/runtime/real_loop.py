"""The event loop of `async` activities in real time. Apart, because asyncio takes long to import."""

from __future__ import annotations

import asyncio
import selectors
import threading
from collections.abc import Callable


def start_loop(complain: Callable[[str], None]) -> tuple[asyncio.AbstractEventLoop, threading.Thread]:
    """An event loop in a thread of its own, until it is stopped.

    It selects with `select`, whose timeouts are not rounded to whole milliseconds.
    """
    loop = asyncio.SelectorEventLoop(selectors.SelectSelector())

    def handle(_: asyncio.AbstractEventLoop, context: dict[str, object]) -> None:
        error = context.get("exception")
        complain(f"{context.get('message')}{f': {error!r}' if error is not None else ''}")

    def work() -> None:
        asyncio.set_event_loop(loop)
        try:
            loop.run_forever()
        finally:
            loop.run_until_complete(loop.shutdown_asyncgens())
            loop.close()

    loop.set_exception_handler(handle)
    thread = threading.Thread(target=work, name="aseme async", daemon=True)
    thread.start()
    return loop, thread
