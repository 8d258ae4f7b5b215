"""Catching up: agents that have missed a swap are held until they follow the newest epoch of their team."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

from aseme_dsl.runtime.transport import TransportError
from aseme_dsl.runtime.version.epochs import Epoch, epoch_of

if TYPE_CHECKING:
    from aseme_dsl.runtime.control.control import Control
    from aseme_dsl.runtime.team.team import Team

PAUSE = 1.0
"""Seconds between two questions for the epochs of the others."""
ANSWER = 1.0
"""So many seconds an answer is waited for."""
_TRY = 0.05


class CatchingUp:
    """Asks the agents elsewhere for their epochs, in a thread, and follows the newest one."""

    def __init__(self, team: Team, control: Control) -> None:
        self._team = team
        self._control = control
        self._closed = threading.Event()
        self._newest: Epoch | None = None
        self._thread = threading.Thread(target=self._ask_on, name="aseme epochs", daemon=True)

    def begin(self) -> None:
        """Begin to ask."""
        self._team.transport.tell_epoch(lambda: self._control.epoch.as_data())
        self._thread.start()

    def close(self) -> None:
        """Ask no more."""
        self._closed.set()
        self._thread.join(ANSWER + 0.5)

    def _ask_on(self) -> None:
        while not self._closed.wait(PAUSE if self._newest is None else _TRY):
            if not self._team.trace.begun:
                continue
            if self._newest is None:
                self._newest = self._newer()
            if self._newest is not None and self._follow(self._newest):
                self._newest = None

    def _newer(self) -> Epoch | None:
        """The newest epoch of those that are connected, if it is newer than ours."""
        found: Epoch | None = None
        for name, peer in self._team.peers().items():
            if self._closed.is_set() or not peer.alive:
                continue
            try:
                epoch = epoch_of(self._team.transport.ask_epoch(name, ANSWER))
            except TransportError:
                continue
            if epoch is None or not epoch.is_newer(self._control.epoch):
                self._control.doubted.pop(name, None)
            elif self._control.accepts(epoch, name) and epoch.is_newer(found or self._control.epoch):
                found = epoch
        return found

    def _follow(self, epoch: Epoch) -> bool:
        """One attempt; whether it is over: done, or an even newer one is followed."""
        try:
            over = self._control.follow(epoch)
        except Exception as error:  # of a new version's code, say
            self._control.hold(epoch, (f"{type(error).__name__}: {error}",))
            over = False
        if not over and self._control.held is not None and self._control.held.is_blocked:
            self._closed.wait(PAUSE)
            newest = self._newer()
            if newest is not None and newest.is_newer(epoch):
                self._newest = newest
        return over


__all__ = ["CatchingUp"]
