"""Asking: an agent of a recorded run as it was at a time, with what led there, to be asked."""

from __future__ import annotations

import json
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from shlex import quote
from typing import cast

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.play.asking.answer import Answer, Asking
from aseme_dsl.play.asking.changes import Made, Moment, Trial
from aseme_dsl.play.asking.parts import Part, Tree, asked
from aseme_dsl.play.asking.past import Past
from aseme_dsl.play.asking.question import DEPTH, NotAsked, Question, goal_of
from aseme_dsl.play.asking.said import Back, Said
from aseme_dsl.play.asking.search import Search
from aseme_dsl.play.asking.telling import Teller
from aseme_dsl.play.asking.unsent import Unsent
from aseme_dsl.play.asking.ways import Goal, leading, may_lead
from aseme_dsl.play.inputs import Earlier
from aseme_dsl.play.replay import Difference, Model, NotReplayable, Replay
from aseme_dsl.project.testing.replaying import compiled, generated
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.following import Shape
from aseme_dsl.runtime.chart.inputs import Input
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.time.clock import at_text, shown
from aseme_dsl.runtime.trace.records import Record, agents_of
from aseme_dsl.runtime.trace.trace_reading import Line, TraceReader, fitting

BACK = 12
"""So many other agents are asked for one question at the most."""


@dataclass(frozen=True, slots=True)
class AskedModel:
    """The step class of a role with probes, its conditions by transition, and its statechart."""

    model: Model
    chart: Statechart
    conditions: Mapping[int, Tree]
    parts: Sequence[Part]
    shape: Shape


class NoSuchAgent(Exception):
    """A trace has no agent of that name; `team` has."""

    def __init__(self, team: tuple[str, ...]) -> None:
        super().__init__(team)
        self.team = team


class Differs(Exception):
    """The steps of an agent, made again, differ from those in the trace: no answer would be sure."""

    def __init__(self, difference: Difference) -> None:
        super().__init__(difference)
        self.difference = difference


@contextmanager
def questions(path: Path) -> Iterator[Questions]:
    """A trace that can be asked; what is made of its model is removed afterwards.

    Raises:
        TraceError: it cannot be read.
    """
    with ExitStack() as stack:
        yield Questions(TraceReader(path), stack)


@dataclass(frozen=True, slots=True)
class _Run:
    """Steps of an agent by a model that it does not run any more, or that are before what was read."""

    line: int
    time: int
    model: str
    taken: tuple[tuple[int, ...], ...]


@dataclass(frozen=True, slots=True)
class _Read:
    """An agent, with what it did before the steps that it can be asked about, the newest first."""

    asking: Asking
    former: Callable[[Collection[int]], Iterator[_Run]]
    """Gives those in which one of some transitions was taken."""


@dataclass(slots=True)
class _Asked:
    """What has been asked for one question: of which agents, for what."""

    chain: tuple[tuple[str, str], ...]
    all: set[tuple[str, str]]

    def further(self, agent: str, what: str) -> _Asked:
        self.all.add((agent, what))
        return _Asked((*self.chain, (agent, what)), self.all)


class Questions:
    """A trace that can be asked about its agents."""

    def __init__(self, reader: TraceReader, stack: ExitStack) -> None:
        self._reader = reader
        self._stack = stack
        self._known: dict[str, AskedModel] = {}
        self._made: dict[tuple[tuple[str, str], ...], dict[str, AskedModel]] = {}
        self.team = tuple(str(item["name"]) for item in agents_of(reader.header().record))

    def answer(self, question: Question) -> Answer:
        """The answer to a question.

        Raises:
            TraceError: the trace cannot be read.
            NotReplayable: it does not say enough.
            Differs: its steps, made again, are others.
            NoSuchAgent: it has no such agent.
            NotAsked: the role of the agent has nothing of that name.
        """
        agent, what = question.agent, question.what
        read = self._read(agent, question.at, question.depth, _Asked(((agent, what),), {(agent, what)}))
        return self._why(read, question) if question.is_why else self._whynot(read, what)

    def at(self, agent: str, now: int) -> Asking:
        """An agent after all that it has done by a time (ns), or by the end of the run.

        Raises as `answer`.
        """
        return self._read(agent, now, DEPTH, _Asked((), set())).asking

    def _why(self, read: _Read, question: Question) -> Answer:
        """Why an agent has reached a goal, by the model that it ran when it last did."""
        present = _goal(read.asking.teller.plan, question.what)
        answer = None if isinstance(present, NotAsked) else read.asking.why(present)
        if answer is not None and answer.is_so:
            return answer
        for run, goal in self._former(read, question.what):
            then = self._read(question.agent, run.time, 0, _Asked((), set()), run.line).asking.why(goal)
            if then.is_so:
                return replace(then, now=read.asking.moment.now, where=read.asking.where(goal))
        if answer is None:
            assert isinstance(present, NotAsked)
            raise present
        return answer

    def _whynot(self, read: _Read, what: str) -> Answer:
        """Why an agent has not reached a goal, by the model that it runs."""
        goal = _goal(read.asking.teller.plan, what)
        if isinstance(goal, Goal):
            return read.asking.whynot(goal)
        for run, _ in self._former(read, what):
            raise NotAsked(f"{goal}; until {shown(run.time)} it ran another model that has it")
        raise goal

    def _former(self, read: _Read, what: str) -> Iterator[tuple[_Run, Goal]]:
        """The former steps that may have led to what is asked for, the newest first."""
        found = ((model, _goal(item.shape.plan, what)) for model, item in self._known.items())
        goals = {model: goal for model, goal in found if isinstance(goal, Goal)}
        numbers = {one for model, goal in goals.items() for one in leading(self._known[model].shape, goal)}
        for run in read.former(numbers):
            goal = goals.get(run.model)
            if goal is not None and may_lead(self._known[run.model].shape, goal, run.taken):
                yield run, goal

    # ---- one agent -------------------------------------------------------------------------------

    def _read(self, agent: str, now: int, depth: int, asked: _Asked, last: int | None = None) -> _Read:
        """An agent at a time (ns), or right after the last line that is to be read.

        It is read from its newest checkpoint that is not later; from the begin, where that does not do.
        """
        if agent not in self.team:
            raise NoSuchAgent(self.team)
        past_of = (agent, now, depth, asked, last)
        try:
            since = now if last is None else max(0, now - 1)
            return self._from(self._reader.since(since, (agent,)), self._reader.before, *past_of)
        except NotReplayable:
            return self._from(iter(self._reader), None, *past_of)

    def _from(
        self,
        lines: Iterator[Line],
        earlier: Earlier | None,
        agent: str,
        now: int,
        depth: int,
        asked: _Asked,
        last: int | None,
    ) -> _Read:
        steps: list[tuple[_Run, Made]] = []
        given: dict[str, object] = {}
        models: list[tuple[int, str]] = []
        first = number = end = 0

        def before(name: str, chart: Chart, record: Record, inputs: Sequence[Input]) -> None:
            if record["taken"]:
                ways = _ways(record)
                answers = tuple((call["function"], call["value"]) for call in record.get("functions", ()))
                made = Made(Moment(chart.save(), record["time"], tuple(inputs), answers), ways)
                steps.append((_Run(number, record["time"], chart.PLAN.model, ways), made))
            for call in record.get("functions", ()):
                given[call["function"]] = call["value"]

        def looked_up(texts: Collection[str]) -> Iterable[Line]:
            return () if earlier is None else earlier(first, texts)

        past = Past(self._plan, looked_up)
        replay = Replay(self._models, (agent,), earlier, before)
        for line in lines:
            if line.record["time"] > now or (last is not None and line.number > last):
                end = now
                break
            end = line.record["time"]
            if line.number > number + 1:
                first, past.begin = line.number, line.record["time"]
            number = line.number
            with fitting(self._reader.path, line):
                past.line(line.record)
            difference = replay.line(line.record, number)
            if difference is not None:
                raise Differs(difference)
            runs = past.members[agent].model
            if runs != (models[-1][1] if models else None):
                models.append((number, runs))
        chart = replay.agents[agent].chart
        own = chart.PLAN.model
        # A step of another version, or of another role, cannot be tried on this one.
        mine = [made for run, made in steps if run.model == own]
        model = self._known[own]
        trial = Trial(model.model, model.parts, agent, chart.seed, given)
        unsent = Unsent(agent, trial.plan, past, self._back(now, depth, asked))
        teller = Teller(agent, model.chart, trial, past, unsent)
        asking = Asking(
            teller, Search(trial, model.conditions, unsent.pending), Moment(chart.save(), end), mine
        )

        def former(numbers: Collection[int]) -> Iterator[_Run]:
            yield from (run for run, _ in reversed(steps) if run.model != own)
            text = f'"agent":{json.dumps(agent, ensure_ascii=False)},"step"'
            takes = [text for number in numbers for text in _texts_of(number)]
            wanted = partial(_holds_one, takes)
            for line in () if earlier is None else self._reader.before(first, (text,), wanted):
                if line.record["kind"] == "step" and line.record["agent"] == agent:
                    ran = next(item for at, item in reversed(models) if at < line.number)
                    if ran in self._known:
                        yield _Run(line.number, line.record["time"], ran, _ways(line.record))

        return _Read(asking, former)

    def _back(self, now: int, depth: int, asked: _Asked) -> Back:
        """Asks other agents at this time why they have not sent something."""

        def back(agent: str, what: str) -> tuple[Said, ...]:
            if (agent, what) in asked.chain:
                return (Said(f"so {agent} waits for what is asked for here: each waits for the other"),)
            if (agent, what) in asked.all:
                return (Said("which is explained above"),)
            if not depth or len(asked.all) > BACK:
                return (Said(f"why not, says `asemec whynot {agent} {quote(what)} --at {at_text(now)}`"),)
            try:
                asking = self._read(agent, now, depth - 1, asked.further(agent, what)).asking
            except NotReplayable as problem:
                return (Said(f"{agent} cannot be asked: {problem}"),)
            except Differs as problem:
                step = problem.difference.step
                return (Said(f"{agent} cannot be asked: its step {step} differs in a replay"),)
            return _first(asking, asking.whynot(goal_of(asking.teller.plan, what)))

        return back

    # ---- models ----------------------------------------------------------------------------------

    def _plan(self, model: str) -> Plan | None:
        return self._known[model].model.kind.PLAN if model in self._known else None

    def _models(self, sources: Mapping[str, str]) -> dict[str, Model]:
        key = tuple(sorted(sources.items()))
        if key not in self._made:
            self._made[key] = asked_models(sources, self._stack)
            self._known.update(self._made[key])
        return {name: item.model for name, item in self._made[key].items()}


def _goal(plan: Plan, what: str) -> Goal | NotAsked:
    try:
        return goal_of(plan, what)
    except NotAsked as problem:
        return problem


def _first(asking: Asking, answer: Answer) -> tuple[Said, ...]:
    """What has to be otherwise first, of an answer that explains a line of another one."""
    if len(answer.stages) < 2:
        return answer.said[:1]
    first = replace(answer.said[0], text=answer.said[0].text.removeprefix("1. "))
    transitions = asking.teller.plan.transitions
    ends = (transitions[item.stage.ways[-1][-1]].target for item in answer.stages[1:])
    return first, Said(f"and behind that: {', '.join(map(asking.teller.state, ends))}")


def _texts_of(transition: int) -> Iterator[str]:
    """What holds the number of a transition in a line: alone, as the first of some, the last, or between."""
    yield from (f"[{transition}]", f"[{transition},", f",{transition}]", f",{transition},")


def _holds_one(texts: Collection[str], line: str) -> bool:
    return any(text in line for text in texts)


def _ways(record: Record) -> tuple[tuple[int, ...], ...]:
    return tuple(tuple(way["transitions"]) for way in record["taken"])


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
        result[hashes[role]] = AskedModel(
            Model(own, messages), charts[role], conditions, found.parts, Shape(plan)
        )
    return result


__all__ = ["Differs", "NoSuchAgent", "Questions", "at_text", "questions"]
