"""Seen: what the process of a robot tells its supervisor, which watches the properties of the whole team."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import TYPE_CHECKING

from aseme_dsl.play.sight.sightings import Reporter, asked_of, told

if TYPE_CHECKING:
    from aseme_dsl.runtime.team.team import Team
    from aseme_dsl.runtime.trace.records import Record


class Seen:
    """A listener of the trace of a robot's process. It never ends the run."""

    def __init__(self, asked: str, tell: Callable[[str], None]) -> None:
        """`asked` is what the supervisor asks of the inside of agents; `tell` is given each sighting."""
        self._reporter = Reporter(asked_of(asked), lambda sighting: tell(told(sighting)))
        self._team: Team | None = None

    def begin(self, team: Team) -> None:
        """The run begins."""
        self._team = team
        self._reporter.begin(team)

    def wants(self, kind: str, what: str | None) -> bool:
        return self._reporter.wants(kind, what)

    def __call__(self, record: Record) -> None:
        self._reporter(record)

    def settled(self, team: Team) -> None:
        """Nothing is left to do at this instant."""

    def record(self, breach: str) -> None:
        """Write into the trace what the supervisor has found broken, as JSON."""
        if self._team is not None:
            self._team.trace.write("breach", self._team.driver.clock.now(), **json.loads(breach))
