"""Run state: why a run in real time is to end, and what its watching thread is asked to do."""

from __future__ import annotations

import threading
from collections.abc import Callable

PAUSE = 0.01
"""How long, in seconds, at least passes between two questions whether the run is over."""


class RunState:
    """Whether a run is in progress. May be used from any thread."""

    def __init__(self) -> None:
        self.ends: str | None = None
        """The reason for which the run ends, when it does."""
        self.error: BaseException | None = None
        """What the runtime itself has raised."""
        self.watch = False
        """Whether each step is news."""
        self.news = False
        self.urgent = False
        self._condition = threading.Condition()

    def stop(self, reason: str) -> None:
        """End the run, unless it ends for another reason already. Also called by signal handlers."""
        if self.ends is None:
            self.ends = reason
        self.tell()

    def fail(self, error: BaseException) -> None:
        """End the run with an error of the runtime."""
        self.error = error
        self.stop("error")

    def tell(self) -> None:
        """There is news for the thread that runs, which cannot wait."""
        with self._condition:
            self.news = self.urgent = True
            self._condition.notify()

    def notice(self) -> None:
        """There is news for the thread that runs, which can wait a little."""
        self.news = True
        with self._condition:
            self._condition.notify()

    def forget(self) -> None:
        """The news so far are known."""
        self.news = self.urgent = False

    def wait_for_news(self, seconds: float) -> None:
        """Wait for news, but no longer than this."""
        with self._condition:
            if not self.news:
                self._condition.wait(max(0.0, seconds))
            if self.watch and not self.urgent:
                # Who steps does not ring meanwhile.
                self._condition.wait_for(lambda: self.urgent, min(PAUSE, max(0.0, seconds)))

    def wait_while(self, busy: Callable[[], object], rest: Callable[[], float]) -> None:
        """Wait while something is busy; `rest` gives how long, in seconds, that may still take."""
        with self._condition:
            while busy() and (seconds := rest()) > 0:
                self._condition.wait(min(seconds, 0.05))
