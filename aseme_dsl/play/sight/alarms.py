"""Alarms: a run is looked at when something that is awaited is late, even if nothing else happens then."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from functools import partial

from aseme_dsl.play.sight.insight import Surroundings
from aseme_dsl.runtime.monitor.rules import Rule, State, deadline


class Alarms:
    """Looks at a run 1 ns after each moment by which a rule awaits something.

    Each rule has one alarm at a time, however often it begins to wait anew.
    """

    def __init__(self, look: Callable[[], None]) -> None:
        self._look = look
        self._surroundings: Surroundings | None = None
        self._due: dict[Hashable, int] = {}
        self._set: dict[Hashable, int] = {}
        """For which moment a rule has an alarm, which is not later than that at which it is due."""

    def begin(self, surroundings: Surroundings) -> None:
        """The run begins."""
        self._surroundings = surroundings

    def mind(self, key: Hashable, rule: Rule, state: State) -> None:
        """A rule, which the key names, has this state now."""
        due = deadline(rule, state)
        if due is None:
            self._due.pop(key, None)
        elif self._due.get(key) != due:
            self._due[key] = due
            self._ensure(key, due)

    def _ensure(self, key: Hashable, due: int) -> None:
        if self._surroundings is not None and self._set.get(key, due + 1) > due:
            self._set[key] = due
            self._surroundings.at(due + 1, partial(self._ring, key, due))

    def _ring(self, key: Hashable, moment: int) -> None:
        if self._set.get(key) == moment:
            del self._set[key]
        due = self._due.get(key)
        if due is None:
            return
        if due > moment:
            self._ensure(key, due)
        else:
            del self._due[key]
            self._look()


__all__ = ["Alarms"]
