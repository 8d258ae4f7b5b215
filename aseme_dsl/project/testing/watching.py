"""Watching: whether a run of the team keeps the properties and clauses of its system."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from aseme_dsl.play.observer import Observer
from aseme_dsl.play.scenario import Refused, Script
from aseme_dsl.runtime.monitor.rules import Verdict
from aseme_dsl.runtime.time.clock import shown
from aseme_dsl.source import Span

if TYPE_CHECKING:
    from collections.abc import Mapping

    from aseme_dsl.project.building.project import Compiled
    from aseme_dsl.runtime.team.team import Team
    from aseme_dsl.runtime.trace.records import Record


@dataclass(frozen=True, slots=True)
class Watched:
    """What a property or clause (`of`) says, and whether it was so.

    `verdict` is `kept`, `broken`, `open` (something is awaited still) or `vacuous` (what it speaks of has not
    happened).
    """

    of: str
    span: Span
    verdict: str
    time_ns: int = 0
    """When it was broken."""
    assumed: Span | None = None
    """The assumption that was broken before it."""

    @property
    def text(self) -> str:
        """`broken at 3 s: property "it stops" (a.aseme:7:3)`."""
        when = f" at {shown(self.time_ns)}" if self.verdict == "broken" else ""
        since = "" if self.assumed is None else f"; the assumption {self.assumed} was broken before"
        return f"{self.verdict}{when}: {self.of} ({self.span}){since}"


def script_for(compiled: Compiled, team: Mapping[str, str]) -> Script | Refused | None:
    """What the properties and clauses of a system say of a team; None if it has none."""
    from aseme_dsl.compiler.phases import inspect_files, watched_of
    from aseme_dsl.project.building.project import options_of

    system = compiled.system
    if system is None or not (
        any(aip.clauses for aip in system.aips) or any("property" in item.text for item in system.sources)
    ):
        return None
    found = watched_of(inspect_files(compiled.root, None, options_of(compiled.configuration)), team)
    if found.refused is not None:
        return found.refused
    return found.scripts[0] if found.scripts[0].expectations else None


class Watch:
    """Watches one run in virtual time: a listener of its trace."""

    def __init__(self, script: Script, tell: Callable[[str], None], is_strict: bool) -> None:
        """`tell` is given a line for each that is broken; with `is_strict` that ends the run."""
        self._script = script
        self._observer = Observer(script, {})
        self._tell = tell
        self._is_strict = is_strict
        self._told: set[int] = set()

    def begin(self, team: Team) -> None:
        """The run of the team begins."""
        self._observer.begin(team)

    def wants(self, kind: str, what: str | None) -> bool:
        return self._observer.wants(kind, what)

    def __call__(self, record: Record) -> None:
        self._observer(record)

    def settled(self, team: Team) -> str | None:
        """Nothing is left to do at this instant; why the run ends, if it does."""
        self._observer.settled(team)
        for number, state in enumerate(self._observer.states):
            if state.verdict is Verdict.BROKEN and number not in self._told:
                self._told.add(number)
                self._tell(self._of(number, "broken").text)
        return "a property or clause is broken" if self._told and self._is_strict else None

    def end(self, moment: int) -> tuple[Watched, ...]:
        """What has become of them in a run that ended at this moment."""
        self._observer.rest(moment)
        found = []
        for number, item in enumerate(self._script.expectations):
            state = self._observer.states[number]
            if state.verdict is Verdict.BROKEN:
                verdict = "broken"
            elif not self._observer.met.issuperset(item.witnesses):
                verdict = "vacuous"
            elif self._observer.is_awaited(number, moment):
                verdict = "open"
            else:
                verdict = "kept"
            found.append(self._of(number, verdict))
        return tuple(found)

    def _of(self, number: int, verdict: str) -> Watched:
        item, state = self._script.expectations[number], self._observer.states[number]
        broken = self._observer.assumed.broken
        is_late = verdict == "broken" and broken is not None and broken[1] <= state.at
        assumed = broken[0].span if broken is not None and is_late else None
        return Watched(item.of, item.span, verdict, state.at if verdict == "broken" else 0, assumed)


__all__ = ["Watch", "Watched", "script_for"]
