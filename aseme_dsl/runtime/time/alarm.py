"""Alarm: the one moment at which an agent is to step next because time alone may enable something."""

from __future__ import annotations

from collections.abc import Callable

from aseme_dsl.runtime.time.timers import Scheduler, Timer


class Alarm:
    """One moment at most, at which an agent is woken. Called while the agent is guarded."""

    def __init__(
        self,
        scheduler: Scheduler,
        errand: Callable[[Callable[[], None]], None],
        ring: Callable[[], None],
    ) -> None:
        """At its moment, `errand` gives the agent a call, which ends with `ring`."""
        self._scheduler = scheduler
        self._errand = errand
        self._ring = ring
        self._timer: Timer | None = None

    def set(self, moment: int | None) -> None:
        """Ring at this moment and at no other one; None: not at all."""
        timer = self._timer
        if timer is not None:
            if timer.moment == moment and timer.call is not None:
                return
            timer.cancel()
            self._timer = None
        if moment is not None:
            self._timer = self._scheduler.at(moment, self._come)

    def cancel(self) -> None:
        """Ring no more."""
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def is_due(self, now: int) -> bool:
        """Whether the moment has come, though the agent has not been woken yet."""
        return self._timer is not None and self._timer.moment <= now

    def _come(self) -> None:
        self._errand(self._wake)

    def _wake(self) -> None:
        self._timer = None
        self._ring()


__all__ = ["Alarm"]
