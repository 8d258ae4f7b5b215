"""Watching: whether a run of the team keeps the properties and clauses of its system."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from aseme_dsl.play.evaluate import NotEvaluated
from aseme_dsl.play.observer import KINDS, Observer
from aseme_dsl.play.scenario import Expectation, Refused, Script
from aseme_dsl.play.sight.deciding import decided_by
from aseme_dsl.play.sight.insight import Asked, Kept, Present, asked_by, kept
from aseme_dsl.play.sight.sightings import LAG, Later, Reporter, Sighting
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.monitor.rules import Verdict
from aseme_dsl.runtime.time.clock import shown
from aseme_dsl.source import Source, Span

if TYPE_CHECKING:
    from pathlib import Path

    from aseme_dsl.project.settings.configuration import Configuration
    from aseme_dsl.runtime.chart.chart import Chart
    from aseme_dsl.runtime.chart.plan import Plan
    from aseme_dsl.runtime.team.team import Team
    from aseme_dsl.runtime.trace.records import Record
    from aseme_dsl.runtime.version.loading import Loaded

Breach = Mapping[str, object]
"""The members of a line `breach` of a trace."""
BROKEN = "a property or clause is broken"
"""Why a run ends with `--strict`."""


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

    @property
    def breach(self) -> Breach:
        """What a trace says of it."""
        assumed = None if self.assumed is None else str(self.assumed)
        return {"of": self.of, "at": str(self.span), "broken": self.time_ns, "assumed": assumed}


def script_for(
    root: Source | Path,
    sources: Mapping[str, str] | None,
    configuration: Configuration,
    team: Mapping[str, str],
) -> Script | Refused | None:
    """What the properties and clauses of a system without errors say of a team; None if it has none."""
    from aseme_dsl.compiler.phases import inspect_files, watched_of
    from aseme_dsl.project.building.project import options_of

    found = watched_of(inspect_files(root, sources, options_of(configuration)), team)
    if found.refused is not None:
        return found.refused
    return found.scripts[0] if found.scripts[0].expectations else None


def script_of(
    loaded: Loaded, root: Path | Source | None, configuration: Configuration, team: Mapping[str, str]
) -> Script | Refused | None:
    """What the properties and clauses of a generated system say of a team; None if it has none.

    They are read in the file `root`, or else in the texts from which it was generated.
    """
    if root is None or not may_say_something(loaded.sources):
        return script_in(loaded.sources, configuration, team)
    return script_for(root, None, configuration, team)


def script_in(
    sources: Mapping[str, str], configuration: Configuration, team: Mapping[str, str]
) -> Script | Refused | None:
    """What the properties and clauses in texts say of a team, of which the first is the root."""
    if not may_say_something(sources):
        return None
    first, *_ = sources
    return script_for(Source(first, sources[first]), sources, configuration, team)


def may_say_something(sources: Mapping[str, str]) -> bool:
    """Whether texts may have properties, clauses or guarantees in them, by their words."""
    return any(word in text for text in sources.values() for word in ("property", "clause", "guarantees"))


class Watch:
    """Watches one run: a listener of its trace.

    In virtual time it looks at each line at once. In real time, and at agents in other processes, it looks
    `LAG` ns later.
    """

    def __init__(
        self,
        script: Script,
        tell: Callable[[str], None],
        is_strict: bool,
        plans: Iterable[Plan] | None = None,
        observer: Observer | None = None,
    ) -> None:
        """`tell` is given a line for each that is broken; with `is_strict` that ends the run. The `plans` of
        the roles are given for a run in real time, and for a recorded one. An `observer`
        has to continue after a breach."""
        self._script = script
        self._observer = Observer(script, {}, goes_on=True) if observer is None else observer
        self._kinds = frozenset(kind for kind in KINDS if self._observer.wants(kind, None))
        self._tell = tell
        self._is_strict = is_strict
        self._told: set[int] = set()
        self._later = None if plans is None else Later(self._observer, plans)
        self._reporter = None if self._later is None else Reporter(self.asked, self._later.take)
        self.stopped: str | None = None
        """Since when and why nothing is watched any more."""
        self.record: Callable[[Breach], None] = lambda breach: None
        """Called for each that is broken: it writes the line of the trace."""

    @property
    def asked(self) -> Asked:
        """What is asked of the inside of agents."""
        return asked_by(self._script.conditions)

    def begin(self, team: Team) -> None:
        """The run of the team begins."""
        if self._reporter is None:
            self._observer.begin(Present(team))
        else:
            self._reporter.begin(team)
        clock = team.driver.clock
        self.record = lambda breach: team.trace.write("breach", clock.now(), **breach)
        team.at_end.append(lambda: self.finish(clock.now()))

    def wants(self, kind: str, what: str | None) -> bool:
        return self._observer.wants(kind, what)

    def __call__(self, record: Record) -> None:
        if self._reporter is None:
            self._see(lambda: self._observer(record), record["time"])
        else:
            self._reporter(record)

    def settled(self, team: Team) -> str | None:
        """Nothing is left to do at this instant; why the run ends, if it does."""
        return self.look(team.driver.clock.now())

    # ---- of a run with a process for each agent --------------------------------------------------

    def hear(self, text: str) -> None:
        """A sighting by the process of an agent. Raises ValueError for another text."""
        assert self._later is not None
        self._later.hear(text)

    def crash(self, agent: str, moment: int) -> None:
        """The process of an agent has stopped dead."""
        assert self._later is not None
        self._later.crash(agent, moment)

    # ---- of a recorded run ----------------------------------------------------------------------

    def see(self, record: Record, chart: Chart | None) -> None:
        """The next line of a trace; `chart` is that of its agent behind it, if it has been followed."""
        is_step = record["kind"] == "step" and chart is not None
        self.show(record, kept(chart, self.asked) if is_step and chart is not None else None)

    def show(self, record: Record, inside: Kept | None) -> None:
        """The next line of a trace; that of a step with the inside of its agent after it, if it is known."""
        assert self._later is not None
        agent, kind = record.get("agent", ""), record["kind"]
        if kind == "life" and record.get("what") == "crash" and agent in dict(self._script.team):
            self._later.crash(agent, record["time"])
        elif kind in self._kinds:
            self._later.take(Sighting(record, inside))
        self.look(record["time"])

    # ---- what is seen ---------------------------------------------------------------------------

    def look(self, moment: int) -> str | None:
        """The time is `moment`; why the run ends, if it does."""
        later = self._later
        self._see(self._observer.settled if later is None else lambda: later.pass_to(moment - LAG), moment)
        self._judge()
        return BROKEN if self._told and self._is_strict else None

    def finish(self, moment: int) -> None:
        """The run has ended at this moment."""
        later = self._later
        end = (lambda: self._observer.rest(moment)) if later is None else (lambda: later.pass_to(moment))
        self._see(end, moment)
        self._judge()

    def _see(self, call: Callable[[], object], moment: int) -> None:
        """Show something to the observer, unless a condition could not be evaluated."""
        if self.stopped is not None:
            return
        try:
            call()
        except NotEvaluated as problem:
            self._stop(moment, str(problem))

    def _stop(self, moment: int, why: str) -> None:
        self.stopped = f"properties and clauses are not watched from {shown(moment)} on: {why}"
        self._tell(self.stopped)

    # ---- what is broken --------------------------------------------------------------------------

    def _judge(self) -> None:
        states = self._observer.states
        broken = [number for number, state in enumerate(states) if state.verdict is Verdict.BROKEN]
        for number in sorted(set(broken) - self._told, key=lambda number: (states[number].at, number)):
            self._told.add(number)
            found = self.of(number, "broken")
            self._tell(found.text)
            self.record(found.breach)
        stranger = None if self._later is None else self._later.stranger
        if stranger is not None and self.stopped is None:
            agent, since = stranger
            self._stop(since, f"{agent} runs another version of its role")

    def end(self) -> tuple[Watched, ...]:
        """What has become of them in a run that has ended (see `finish`)."""
        found = []
        is_cut = self.stopped is not None
        for number, item in enumerate(self._script.expectations):
            state = self._observer.states[number]
            if state.verdict is Verdict.BROKEN:
                verdict = "broken"
            elif not self._observer.met.issuperset(item.witnesses):
                verdict = "open" if is_cut else "vacuous"
            elif is_cut or self._observer.is_awaited(number, self._observer.now):
                verdict = "open"
            else:
                verdict = "kept"
            found.append(self.of(number, verdict))
        return tuple(found)

    def of(self, number: int, verdict: str) -> Watched:
        """What is said of a statement with this verdict."""
        item, state = self._script.expectations[number], self._observer.states[number]
        broken = self._observer.assumed.broken
        is_late = verdict == "broken" and broken is not None and broken[1] <= state.at
        assumed = broken[0].span if broken is not None and is_late else None
        return Watched(item.of, item.span, verdict, state.at if verdict == "broken" else 0, assumed)


def watch_of_agent(
    script: Script, agent: str, tell: Callable[[str], None], is_strict: bool, plans: Iterable[Plan]
) -> Watch | None:
    """Watches one agent in real time, whose process sees no other; reports what that cannot decide."""
    decided = decided_by(script, agent)
    _tell_all(tell, f"watched for {agent} only", decided.partly)
    _tell_all(tell, "not decided here", decided.elsewhere)
    if decided.elsewhere:
        tell("  other agents decide it: `asemec run --process-per-agent` watches the whole team")
    return Watch(decided.script, tell, is_strict, plans) if decided.script.expectations else None


def _tell_all(tell: Callable[[str], None], what: str, items: Sequence[Expectation]) -> None:
    for item in items:
        tell(f"{what}: {item.of} ({item.span})")


__all__ = [
    "BROKEN",
    "Breach",
    "Watch",
    "Watched",
    "may_say_something",
    "script_for",
    "script_in",
    "script_of",
    "watch_of_agent",
]
