"""Tidying: Python's collector of cycles works when no request waits for an answer."""

from __future__ import annotations

import asyncio
import gc

IDLE = 5.0
"""Seconds without a change after which there is time to tidy up."""

UNTIDY = 400_000
"""How many new objects, and as many as there were, make it necessary to look through all."""


class Tidying:
    """Frees what only cycles hold, once it is turned on: where the process is the server's own."""

    def __init__(self) -> None:
        self.tidies = False
        """Whether the process is the server's own, and so is Python's collector of cycles."""
        self._idle: asyncio.TimerHandle | None = None
        self.kept = self.grown = 0

    def busy(self) -> None:
        """Something is to be done first."""
        if self._idle is not None:
            self._idle.cancel()

    def later(self) -> None:
        """Tidy up when nothing has changed for a while."""
        self._idle = asyncio.get_running_loop().call_later(IDLE, self.tidy_all)

    def tidy_up(self) -> None:
        """Free what only cycles hold, of what has come since the last time (cli/lsp.py turns off all else).

        Models are many objects that live long: to look for cycles among all of them takes longer than to make
        them anew. So it is done when no request waits, or when they have become many more.
        """
        if not self.tidies:
            return
        gc.collect()
        self.grown += len(gc.get_objects())
        gc.freeze()
        if self.grown > 4 * max(self.kept, UNTIDY):
            self.tidy_all()
        elif self.grown > max(self.kept, UNTIDY):
            self.later()

    def tidy_all(self) -> None:
        """Free all objects that only cycles hold."""
        if not self.tidies:
            return
        gc.unfreeze()
        gc.collect()
        self.kept, self.grown = len(gc.get_objects()), 0
        gc.freeze()


__all__ = ["Tidying"]
