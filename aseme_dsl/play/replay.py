"""Replay: the steps of a recorded run, made again by the step classes of its model from the trace alone.

Other lines tell what the inputs are that the line of a step names; what functions of the document gave stands
there itself. Each step must take the same transitions and lead to the same configuration. At a checkpoint,
the whole state must be the same. After a swap, a switch of the role or a restart, an agent continues with the
state of the checkpoint that follows. Where lines are left out behind the header, each agent begins with its
next checkpoint.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import field
from functools import partial
from time import perf_counter

from aseme_dsl.play.inputs import Earlier, Messages, RecordedInputs, identity_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.agent.renewal import renewed
from aseme_dsl.runtime.agent.state_transfer import same_states
from aseme_dsl.runtime.agent.untakable import Untakable
from aseme_dsl.runtime.chart.board import QUEUE
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.functions import TYPES
from aseme_dsl.runtime.chart.input_queue import Posted
from aseme_dsl.runtime.chart.inputs import (
    Completed,
    Crashed,
    FunctionResult,
    Input,
    MailTaken,
    Outcome,
    Sample,
)
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.chart.stepping import expired_signals
from aseme_dsl.runtime.message.as_json import from_json, to_json
from aseme_dsl.runtime.trace.checkpoint import saved_of, state_of
from aseme_dsl.runtime.trace.packed import unpacked
from aseme_dsl.runtime.trace.records import InputName, Record, agents_of


class NotReplayable(Exception):
    """The steps of a trace cannot be made again; the text says why."""


@dataclass(frozen=True, slots=True)
class Model:
    """The step class of a role, and the classes of its messages and enums by name."""

    kind: type[Chart]
    messages: Messages


Models = Callable[[Mapping[str, str]], Mapping[str, Model]]
"""From the files of a model to the roles' models, by their hashes. May raise NotReplayable."""


Before = Callable[[str, Chart, Record, Sequence[Input]], None]
"""Is shown a step of an agent: its chart before it, the line, and the inputs."""


@dataclass(frozen=True, slots=True)
class Difference:
    """The first thing that an agent does otherwise than the trace says."""

    agent: str
    time: int
    step: int
    what: str
    expected: tuple[str, ...]
    got: tuple[str, ...]


@dataclass(slots=True)
class _Former:
    """What an agent ran before a line of the trace."""

    until: int
    model: Model
    chart: Chart
    labels: Mapping[str, str] | None = None
    """The labels of its states in what it ran next, if that continues it."""


@dataclass(slots=True)
class _Agent:
    """An agent that is led along."""

    name: str
    model: Model
    chart: Chart
    steps: int = 0
    where: tuple[str, ...] = ()
    """Its configuration as the trace has it."""
    answers: deque[tuple[str, object]] = field(default_factory=deque)
    """What functions gave in the present step."""
    untakable: Untakable = field(default_factory=lambda: Untakable(lambda branch, identity: None))
    waits: bool = False
    """Whether its state is not known before its next checkpoint."""
    is_to_look: bool = False
    """Whether it has made a step and not looked yet at what can still be taken."""
    former: list[_Former] = field(default_factory=list)


class Replay:
    """Goes through the lines of a trace once."""

    def __init__(
        self,
        models: Models,
        only: Collection[str] = (),
        earlier: Earlier | None = None,
        before: Before = lambda *step: None,
    ) -> None:
        """`only` these agents; all, if it is empty. `earlier` gives the lines that may be left out.

        Each step is shown to `before`, before it is made.
        """
        self._models = models
        self._before = before
        self._only = only
        self._known: dict[str, Model] = {}
        self.agents: dict[str, _Agent] = {}
        self._reads: set[str] = set()
        self._inputs = RecordedInputs(self.agents, self._reads, earlier)
        self._seed = 1
        self._queue = QUEUE
        self.steps = 0
        """How many steps were made again."""
        self.seconds = 0.0
        """How long the steps themselves took."""
        self._kinds: Mapping[str, Callable[[Record], Difference | None]] = {
            "header": self._header,
            "step": self._step,
            "checkpoint": self._checkpoint,
            "consumed": self._consumed,
            "expired": self._expired,
            "error": self._failed,
            "swap": self._other_model,
            "select": self._other_model,
        }

    @property
    def plans(self) -> tuple[Plan, ...]:
        """Those of all roles of the models so far."""
        return tuple(model.kind.PLAN for model in self._known.values())

    def line(self, record: Record, number: int | None = None) -> Difference | None:
        """A line: the next one, or the one of this number; the difference, if one shows in it.

        Raises:
            NotReplayable: the trace does not say enough.
        """
        try:
            if self._inputs.line(record, number):
                for item in self.agents.values():
                    item.waits = True
            known = self._kinds.get(record["kind"])
            return None if known is None else known(record)
        except (LookupError, TypeError, ValueError, AttributeError) as problem:
            text = f"{type(problem).__name__}: {problem}"
            kind = record.get("kind", "?")
            raise NotReplayable(
                f"its line {self._inputs.number} ({kind}) cannot be read: {text}"
            ) from problem

    # ---- what the agents run -----------------------------------------------------------------

    def _header(self, record: Record) -> None:
        if "sources" not in record:
            raise NotReplayable(
                "it does not hold the model: an earlier version wrote it, or a build of one; record it anew"
            )
        self._learn(record)
        self._seed = int(record["seed"])
        self._queue = record.get("queue", QUEUE)
        there = {str(item["name"]): str(item["model"]) for item in agents_of(record)}
        unknown = [name for name in self._only if name not in there]
        if unknown:
            raise NotReplayable(f"it has no agent {unknown[0]}; there are {', '.join(there)}")
        for name, model in there.items():
            if not self._only or name in self._only:
                found = self._model(model)
                self.agents[name] = _Agent(name, found, self._chart(found, name))

    def _learn(self, record: Record) -> None:
        found = self._models(unpacked(record["sources"]))
        self._known.update(found)
        for item in found.values():
            self._reads.update(item.kind.READERS)

    def _model(self, model: str) -> Model:
        if model not in self._known:
            raise NotReplayable(
                f"it is of a model {model}, which this version of asemec does not make of its files:"
                " use the version that recorded it, or record it anew"
            )
        return self._known[model]

    def _chart(self, model: Model, name: str) -> Chart:
        chart = model.kind(name)
        chart.seed, chart.queue = self._seed, self._queue
        chart.stand_in(
            {item[0]: partial(self._answer, name, item[0], item[2]) for item in chart.PLAN.functions}
        )
        return chart

    def _answer(self, agent: str, function: str, result: str, *arguments: object) -> object:
        answers = self.agents[agent].answers
        if not answers or answers[0][0] != function:
            raise RuntimeError("it raised then")
        value = answers.popleft()[1]
        kinds = TYPES.get(result) or (self.agents[agent].model.messages.get(result),)
        return value if value is None or kinds[-1] is None else from_json(kinds[-1], value)

    def _other_model(self, record: Record) -> None:
        if "sources" in record and record["model"] not in self._known:
            self._learn(record)
        item = self.agents.get(record.get("agent", ""))
        if item is None or record.get("what", "done") != "done" or "reason" in record:
            return
        labels = None
        if record["kind"] == "swap":
            labels = same_states(item.chart.PLAN, self._model(record["model"]).kind.PLAN)
        item.former.append(_Former(self._inputs.number, item.model, item.chart, labels))
        if item.waits:
            item.model = self._model(record["model"])
            item.chart = self._chart(item.model, item.name)

    def _checkpoint(self, record: Record) -> Difference | None:
        item = self.agents.get(record["agent"])
        if item is None:
            return None
        self._look(item)
        model = self._model(record["model"])
        saved = saved_of(record["state"], model.messages)
        for conversation, participant, branch in record.get("parts", ()):
            self._inputs.part(item.name, conversation, participant, branch)
        if record.get("anew") or item.waits:
            item.waits, item.steps = False, record["step"]
            item.model = model
            item.chart = self._chart(model, item.name)
            item.chart.load(saved)
            item.where = item.chart.configuration() if item.chart.started else ()
            item.untakable.forget()
            return None
        if item.chart.finished or item.chart.failure is not None:
            return None  # what it has said farewell with is not in the trace
        expected, got = state_of(saved, shared=False), state_of(item.chart.save(), shared=False)
        if expected == got:
            return None
        names = ("model", "values", "blackboards", "further values")
        parts = [place for place in range(len(names)) if expected[place] != got[place]]
        texts = [(f"{names[place]}: {_apart(expected[place], got[place])}") for place in parts]
        others = [(f"{names[place]}: {_apart(got[place], expected[place])}") for place in parts]
        what = "the state at a checkpoint"
        return Difference(item.name, record["time"], item.steps, what, tuple(texts), tuple(others))

    # ---- between steps -----------------------------------------------------------------------

    def _look(self, item: _Agent) -> None:
        """Remove what nothing takes any more, as the agent did after its last step."""
        if item.is_to_look:
            item.is_to_look = False
            item.untakable.look(item.chart)

    def _consumed(self, record: Record) -> None:
        item = self.agents.get(record["agent"])
        if item is None or item.waits:
            return
        self._look(item)
        identity = identity_of(record["input"])
        for waiting in item.chart.mail.values():
            mail = next((mail for mail in waiting if mail.identity == identity), None)
            if mail is not None:
                item.chart.give_mail(mail)
                return
        item.chart.board_of(record["label"]).consume(identity)

    def _expired(self, record: Record) -> None:
        item = self.agents.get(record["agent"])
        if item is not None and not item.waits:
            self._look(item)
            expired_signals(item.chart, record["time"])

    def _failed(self, record: Record) -> None:
        """An agent has stopped: for a reason that its chart knows, or for another one."""
        item = self.agents.get(record["agent"])
        if item is not None and item.chart.failure is None:
            item.chart.failure = record["reason"]

    def _input(self, item: _Agent, name: InputName) -> Input:
        """An input as the agent's chart is given it."""
        identity = identity_of(name)
        run = None
        if item.former:
            said = self._inputs.said_at(item.name, identity)
            run = next((number for number, former in enumerate(item.former) if said < former.until), None)
        chart, messages = item.chart, item.model.messages
        if run is not None:
            chart, messages = item.former[run].chart, item.former[run].model.messages
        found = self._inputs.input(chart, messages, identity)
        if found is None:
            raise NotReplayable(f"it does not say what the input {list(name)} of {item.name} was")
        while run is not None:  # it waited while the agent changed to another model
            labels = item.former[run].labels
            run = run + 1 if run + 1 < len(item.former) else None
            chart, model = _run_by(item if run is None else item.former[run])
            found = renewed(Posted(identity, found), chart, model.messages, labels).input
        if isinstance(found, Completed | Crashed):
            self._inputs.forget(identity)
        return found

    # ---- the steps ---------------------------------------------------------------------------

    def _step(self, record: Record) -> Difference | None:
        item = self.agents.get(record["agent"])
        if item is None or item.waits:
            return None
        self._look(item)
        if record["step"] != item.steps + 1:
            raise NotReplayable(f"it does not have step {item.steps + 1} of {item.name}")
        item.steps += 1
        inputs = [self._input(item, name) for name in record["inputs"]]
        ahead = [self._input(item, name) for name in record["ahead"]] if "ahead" in record else []
        if "functions" in record:
            item.answers.extend(
                (call["function"], call["value"])
                for call in record["functions"]
                if call["function"] != "random"
            )
        chart = item.chart
        chart.drains = False
        if ahead:
            samples = [found for found in ahead if isinstance(found, Sample)]
            chart.pending = lambda: samples
        self._before(item.name, chart, record, inputs)
        before = perf_counter()
        outcome = chart.step(record["time"], inputs)
        self.seconds += perf_counter() - before
        chart.woken = False
        if ahead:
            chart.pending = tuple
        item.is_to_look = bool(chart.PLAN.branches) and outcome.failure is None and not outcome.finished
        item.where = tuple(record.get("configuration", item.where))
        self.steps += 1
        return _compared(item, record, outcome)


def _run_by(what: _Agent | _Former) -> tuple[Chart, Model]:
    return what.chart, what.model


def _compared(item: _Agent, record: Record, outcome: Outcome) -> Difference | None:
    """The first thing in which a step is another one than the recorded."""
    chart, plan = item.chart, item.chart.PLAN
    taken = [tuple(way["transitions"]) for way in record["taken"]]
    called = []
    mail = []
    for effect in outcome.effects:
        if type(effect) is FunctionResult:
            called.append((effect.function, to_json(effect.value)))
        elif type(effect) is MailTaken:
            mail.append(list(effect.identity))
    where = chart.configuration()
    said = [(call["function"], call["value"]) for call in record.get("functions", ())]
    if taken != outcome.taken:
        texts = tuple(map(plan.way, taken)), tuple(map(plan.way, outcome.taken))
        return Difference(item.name, record["time"], item.steps, "transitions", *texts)
    for what, expected, got in (
        ("configuration", item.where, where),
        ("results of functions", said, called),
        ("agent messages taken", record.get("agent_messages", []), mail),
        ("another step at once", (record.get("again", False),), (outcome.again,)),
        ("the end", (record.get("finished", False),), (outcome.finished,)),
    ):
        if expected != got:
            shown = tuple(map(str, expected)), tuple(map(str, got))
            return Difference(item.name, record["time"], item.steps, what, *shown)
    return None


def _apart(one: object, other: object) -> str:
    """The innermost part in which a value is another one."""
    while isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
        place = next(number for number, part in enumerate(one) if part != other[number])
        one, other = one[place], other[place]
    text = str(one)
    return text if len(text) < 200 else f"{text[:200]}…"


__all__ = ["Difference", "Model", "Models", "NotReplayable", "Replay"]
