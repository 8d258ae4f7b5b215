"""Asking: an agent of a recorded run as it was at a time, with what led there, to be asked."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import cast

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.play.asking.answer import Answer, Asking
from aseme_dsl.play.asking.changes import Made, Moment, Trial
from aseme_dsl.play.asking.parts import Part, Tree, asked
from aseme_dsl.play.asking.past import Past
from aseme_dsl.play.asking.question import goal_of
from aseme_dsl.play.asking.search import Search
from aseme_dsl.play.asking.telling import Said, Teller
from aseme_dsl.play.asking.ways import Goal
from aseme_dsl.play.inputs import Earlier
from aseme_dsl.play.replay import Model, NotReplayable, Replay
from aseme_dsl.project.testing.replaying import compiled, generated
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import Input
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.trace.records import Record, agents_of
from aseme_dsl.runtime.trace.trace_reading import Line, TraceReader

DEPTH = 1
"""So many times it is asked why another agent has not sent something, if nothing else is said."""


@dataclass(frozen=True, slots=True)
class AskedModel:
    """The step class of a role with probes, its conditions by transition, and its statechart."""

    model: Model
    chart: Statechart
    conditions: Mapping[int, Tree]
    parts: Sequence[Part]


class NoSuchAgent(Exception):
    """A trace has no agent of that name; `team` has."""

    def __init__(self, team: tuple[str, ...]) -> None:
        super().__init__(team)
        self.team = team


@contextmanager
def questions(path: Path) -> Iterator[Questions]:
    """A trace that can be asked; what is made of its model is removed afterwards.

    Raises:
        TraceError: it cannot be read.
    """
    with ExitStack() as stack:
        yield Questions(TraceReader(path), stack)


class Questions:
    """A trace that can be asked about its agents."""

    def __init__(self, reader: TraceReader, stack: ExitStack) -> None:
        self._reader = reader
        self._stack = stack
        self._known: dict[str, AskedModel] = {}
        self._made: dict[tuple[tuple[str, str], ...], dict[str, AskedModel]] = {}
        self.team = tuple(str(item["name"]) for item in agents_of(reader.header().record))

    def at(self, agent: str, now: int, depth: int = DEPTH) -> Asking:
        """An agent after all that it has done by a time (ns), or by the end of the run.

        It is read from its newest checkpoint that is not later; from the begin, where that does not do. Where
        a message of another agent has not come, that agent is asked, too, and so on `depth` times.

        Raises:
            TraceError: it cannot be read.
            NotReplayable: it does not say enough.
            NoSuchAgent: it has no such agent.
        """
        if agent not in self.team:
            raise NoSuchAgent(self.team)
        try:
            return self._at(agent, now, depth, self._reader.since(now, (agent,)), self._reader.before)
        except NotReplayable:
            return self._at(agent, now, depth, iter(self._reader), None)

    def why(self, agent: str, now: int, goal: Goal, depth: int = DEPTH) -> Answer:
        """Why an agent has reached a goal, when it last did until a time (ns)."""
        asking = self.at(agent, now, depth)
        answer = asking.why(goal)
        if answer.is_so or asking.first_line <= 2:
            return answer
        for line in self._reader.before(asking.first_line, (f'"agent":"{agent}","step"',)):
            record = line.record
            if record["kind"] == "step" and record["agent"] == agent:
                ways = tuple(tuple(way["transitions"]) for way in record["taken"])
                if asking.may_reach(goal, ways):
                    found = self.at(agent, record["time"], depth).why(goal)
                    if found.is_so:
                        return found
        return answer

    def _at(self, agent: str, now: int, depth: int, lines: Iterator[Line], earlier: Earlier | None) -> Asking:
        steps: list[Made] = []
        given: dict[str, object] = {}
        first = 0

        def before(name: str, chart: Chart, record: Record, inputs: Sequence[Input]) -> None:
            if record["taken"]:
                ways = tuple(tuple(way["transitions"]) for way in record["taken"])
                steps.append(Made(Moment(chart.save(), record["time"], tuple(inputs)), ways))
            for call in record.get("functions", ()):
                given[call["function"]] = call["value"]

        def looked_up(texts: Collection[str]) -> Iterable[Line]:
            return () if earlier is None else earlier(first, texts)

        def back(other: str, what: str) -> tuple[Said, ...]:
            if not depth or other == agent:
                return ()
            asking = self.at(other, now, depth - 1)
            said = asking.whynot(goal_of(asking.teller.plan, what)).said[:1]
            return tuple(replace(item, text=item.text.removeprefix("1. ")) for item in said)

        past = Past(self._plan, looked_up)
        replay = Replay(self._models, (agent,), earlier, before)
        end = 0
        for line in lines:
            if line.record["time"] > now:
                end = now
                break
            end = line.record["time"]
            if line.number > 1 and not first:
                first = line.number
            past.line(line.record)
            replay.line(line.record, line.number)
        chart = replay.agents[agent].chart
        model = self._known[chart.PLAN.model]
        # A step of another version, or of another role, cannot be tried on this one.
        steps = [item for item in steps if item.moment.saved.model == chart.PLAN.model]
        trial = Trial(model.model, model.parts, agent, chart.seed, given)
        teller = Teller(agent, model.chart, trial, past, given, back)
        return Asking(teller, Search(trial, model.conditions), Moment(chart.save(), end), steps, first)

    def _plan(self, model: str) -> Plan | None:
        return self._known[model].model.kind.PLAN if model in self._known else None

    def _models(self, sources: Mapping[str, str]) -> dict[str, Model]:
        key = tuple(sorted(sources.items()))
        if key not in self._made:
            self._made[key] = asked_models(sources, self._stack)
            self._known.update(self._made[key])
        return {name: item.model for name, item in self._made[key].items()}


def asked_models(sources: Mapping[str, str], stack: ExitStack) -> dict[str, AskedModel]:
    """The roles of a model's files by the hashes of their models; what is generated lasts as `stack`.

    Raises:
        NotReplayable: this version of asemec does not compile them, or they cannot be loaded.
    """
    from aseme_dsl.backends.shared.generate import role_models
    from aseme_dsl.project.building.build import Choice, with_labels

    system = with_labels(compiled(sources), Choice().labels)
    hashes = role_models(system)
    found = asked(system)
    kinds, messages = generated(found.system, stack)
    charts = {chart.name: chart for chart in system.iacs}
    result: dict[str, AskedModel] = {}
    for role, kind in kinds.items():
        plan = replace(kind.PLAN, model=hashes[role])
        own = cast("type[Chart]", type(kind.__name__, (kind,), {"__slots__": (), "PLAN": plan}))
        conditions = {number: tree for (name, number), tree in found.conditions.items() if name == role}
        result[hashes[role]] = AskedModel(Model(own, messages), charts[role], conditions, found.parts)
    return result


__all__ = ["NoSuchAgent", "Questions", "questions"]
