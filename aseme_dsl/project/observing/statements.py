"""Statements: the properties and clauses of a model, watched over the lines of a log as they come."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace

from aseme_dsl.play.observer import KINDS, Observer
from aseme_dsl.play.scenario import Script
from aseme_dsl.play.sight.deciding import reduced
from aseme_dsl.play.sight.guards import Guards
from aseme_dsl.play.sight.insight import Kept
from aseme_dsl.play.sight.sightings import LAG
from aseme_dsl.play.sight.story import Happened
from aseme_dsl.play.sight.storyteller import Storyteller
from aseme_dsl.project.observing.evidence import Evidence, needs_of, never_in_a_log
from aseme_dsl.project.testing.watching import Watch, Watched
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.monitor.rules import State, Verdict
from aseme_dsl.runtime.trace.records import Record, agents_of, as_record

Plans = Mapping[tuple[str, str], Plan]
"""What agents may run, by the names of roles and the hashes of models."""
UNDECIDED = "undecided"
"""The verdict of a statement for which a log does not have all that it asks for."""
_OF_LOGS = frozenset(("gap", "checkpoint", "conversation", "swap", "select", "life"))
"""Lines that say what a log is the log of, beside those that the observer sees."""
_OF_STATES = ("activity", "conversation")
"""Lines with labels of states, which only the version that the agent ran explains."""
_OF_MEMBERS = ("step", "error")
"""Lines that only an agent of the team can have."""


@dataclass(frozen=True, slots=True)
class Statement:
    """What a property or clause says, and whether it was so; why it is undecided; what led to its breach."""

    watched: Watched
    reason: str = ""
    story: tuple[Happened, ...] = ()


class StoryWanted(Exception):
    """A statement is broken, and nothing was collected for its story."""


class _Observer(Observer):
    """Keeps the story of each statement from when it is broken."""

    def __init__(self, script: Script, *, is_hasty: bool) -> None:
        teller = None if is_hasty else Storyteller((name for name, _ in script.team), Guards({}))
        super().__init__(script, {}, goes_on=True, teller=teller)
        self.stories: dict[int, tuple[Happened, ...]] = {}

    def _take(self, place: int, state: State) -> None:
        super()._take(place, state)
        if state.verdict is Verdict.BROKEN and place not in self.stories:
            first, self.broken = self.broken, place
            self.stories[place] = self.story({})
            self.broken = first


class Statements:
    """Watches the properties and clauses of a model, without making any step again."""

    def __init__(
        self,
        script: Script,
        topics: Iterable[str],
        plans: Callable[[], Plans],
        tell: Callable[[Statement], None],
        *,
        is_trace: bool,
        is_hasty: bool = False,
    ) -> None:
        """If it `is_hasty`, nothing is collected for stories: what would tell one raises StoryWanted.

        `topics` are the types of what is sent on topics; `plans` gives what agents may run. `tell` hears
        of each that is broken, when it is seen."""
        kinds = frozenset(topics)
        all_needs = [needs_of(script, item, kinds) for item in script.expectations]
        self._all = script.expectations
        never = [never_in_a_log(needs, is_trace) for needs in all_needs]
        self._never = {number: reason for number, reason in enumerate(never) if reason is not None}
        """Why statements cannot be decided at all."""
        kept = [number for number, reason in enumerate(never) if reason is None]
        self._needs = [all_needs[number] for number in kept]
        self._script = reduced(script, [script.expectations[number] for number in kept])
        self._tell = tell
        found = plans() if kept else {}
        self._is_hasty = is_hasty
        self._observer = _Observer(self._script, is_hasty=is_hasty)
        self._watch: Watch | None = None
        if kept:
            self._watch = Watch(self._script, lambda text: None, False, found.values(), self._observer)
        self._plans = found
        self._models = {model: plan for (_, model), plan in found.items()}
        self._running: dict[str, Plan] = {}
        self._told: set[int] = set()
        self._roles = dict(script.team)
        self._moment = 0
        self._reasons: dict[int, str] = {}
        self.evidence = Evidence(is_one=False)
        self.is_needed = self._watch is not None
        """Whether lines have to be shown: whether anything can be decided."""
        self._is_trace = is_trace
        self.kinds = _OF_LOGS | {kind for kind in KINDS if self._observer.wants(kind, None)}
        """The kinds of lines of which more counts than the time, who it is about, and their number."""
        self._looked = 0
        """The time of the last line that the watch was shown."""
        self._passed_over: int | None = None
        """The time of the lines since then."""

    def header(self, record: Record) -> None:
        """The first line of a trace; of several, those of the other processes."""
        evidence = self.evidence
        found = {str(item["name"]): item for item in agents_of(record)}
        if not evidence.agents:
            evidence.is_one = not {"machine", "elsewhere", "network"} & record.keys()
            evidence.is_virtual = record.get("clock") == "virtual"
        evidence.agents |= frozenset(found)
        for name, item in found.items():
            role, model = str(item.get("role", "")), str(item.get("model", ""))
            plan = self._plans.get((role, model))
            if plan is not None and self._roles.get(name) == role:
                self._running[name] = plan
            elif name in self._roles:
                evidence.strangers[name] = f"{name} ran another version of {role} than that in the model"

    def begin(self, agents: Iterable[str]) -> None:
        """The log tells of the messages of these agents, and of nothing else."""
        self.evidence.agents |= frozenset(agents)

    def see(self, record: Record) -> None:
        """The next line."""
        evidence = self.evidence
        if self._is_trace:
            evidence.see(record)
            if record["kind"] in ("swap", "select"):
                self._changes(record)
        self._moment = max(self._moment, record["time"])
        is_seen = not self._is_passed_over(record) and evidence.missing is None
        if is_seen and (known := self._known(record)) is not None:
            self._show(known)
        if len(self._observer.stories) > len(self._told):
            self._judge()

    def _is_passed_over(self, record: Record) -> bool:
        """Whether a line tells the watch nothing but the time, which another one tells it soon."""
        moment, before = record["time"], self._passed_over
        is_soon = moment <= self._looked + LAG and self.evidence.missing is None
        if is_soon and record["kind"] not in self.kinds:
            self._passed_over = moment if before is None else max(moment, before)
            return True
        if before is not None and self._watch is not None:
            # What comes too late stays so, and nothing that is seen before lines are missing is lost.
            if self.evidence.missing is not None or moment <= before - LAG:
                self._watch.look(before)
            self._passed_over = None
        self._looked = max(self._looked, moment)
        return False

    def end(self) -> tuple[Statement, ...]:
        """What has become of all of them when the log has ended."""
        if self._watch is not None and self.evidence.missing is None:
            self._watch.finish(self._moment)
        self._judge()
        watched = enumerate(() if self._watch is None else self._watch.end())
        decided = iter([self._statement(number, item) for number, item in watched])
        return tuple(
            Statement(Watched(item.of, item.span, UNDECIDED), self._never[number])
            if number in self._never
            else next(decided)
            for number, item in enumerate(self._all)
        )

    def _known(self, record: Record) -> Record | None:
        """What a line says that can be understood; None if that is nothing.

        Of an agent that runs another version, messages can be, and that it has received some.
        """
        agent, kind = record.get("agent", ""), record["kind"]
        if agent in self.evidence.strangers:
            if kind in _OF_STATES:
                return None
            return _without_states(record) if kind == "step" else record
        return None if kind in _OF_MEMBERS and agent not in self._roles else record

    def _show(self, record: Record) -> None:
        plan = self._running.get(record.get("agent", "")) if record["kind"] == "step" else None
        inside = None if plan is None else Kept(plan, dict(plan.numbers).get(record["agent"], 1))
        if self._watch is not None:
            self._watch.show(record, inside)

    def _changes(self, record: Record) -> None:
        """An agent runs another plan from now on."""
        agent = record.get("agent", "")
        if agent not in self._roles or record.get("what", "done") != "done" or "reason" in record:
            return
        plan = self._models.get(str(record.get("model", "")))
        if plan is not None:
            self._running[agent] = plan
        else:
            self._running.pop(agent, None)
            self.evidence.strangers.setdefault(agent, f"{agent} has changed to another version of its role")

    def _judge(self) -> None:
        for number in sorted(self._observer.stories.keys() - self._told):
            self._told.add(number)
            reason = self.evidence.lacks(self._needs[number])
            if reason is None:
                self._tell(self._broken(number))
            else:
                self._reasons[number] = reason

    def _broken(self, number: int) -> Statement:
        assert self._watch is not None
        if self._is_hasty:
            raise StoryWanted
        story = tuple(map(self._told_of, self._observer.stories[number]))
        return Statement(self._watch.of(number, "broken"), story=story)

    def _told_of(self, item: Happened) -> Happened:
        """A line of a story: of an agent whose steps are not known, why, and not in which state it is."""
        why = self.evidence.strangers.get(item.agent) if item.stands else None
        return item if why is None else replace(item, text=why.removeprefix(f"{item.agent} "), at="")

    def _statement(self, number: int, item: Watched) -> Statement:
        """What has become of one: it is undecided where the log does not have what it asks for."""
        assert self._watch is not None
        if item.verdict == "broken" and number not in self._reasons:
            return self._broken(number)
        evidence = self.evidence
        reason = self._reasons.get(number) or evidence.lacks(self._needs[number])
        if reason is None and evidence.missing is not None:
            reason = evidence.missing[1]
        reason = reason or self._watch.stopped
        if reason is None and item.verdict != "vacuous":
            reason = evidence.lacks_conversations(self._script.expectations[number])
        return Statement(item) if reason is None else Statement(self._watch.of(number, UNDECIDED), reason)


def _without_states(step: Record) -> Record:
    """A step of which only the inputs are known."""
    return as_record({name: value for name, value in step.items() if name != "configuration"} | {"taken": []})


__all__ = ["UNDECIDED", "Plans", "Statement", "Statements", "StoryWanted"]
