"""Bench: what a step of a system's own statecharts costs, with inputs that they can take.

Inputs are drawn by a seed: events that transitions wait for, values for the messages that are read (near the
constants that conditions compare them with), ends of activities, agent messages that branches wait for. They
are drawn while one chart runs, and then played to fresh ones. The agents' step and the plain one, where a
role has one, must be in the same configuration after every step before anything is timed.
"""

from __future__ import annotations

import gc
import random
import statistics
import time
import tracemalloc
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from aseme_dsl.amola.expression import Literal, Raised, Received
from aseme_dsl.amola.messages import Kind, Type
from aseme_dsl.build.build import Choice, build
from aseme_dsl.runtime.chart import Chart
from aseme_dsl.runtime.inputs import Arrived, Completed, Happened, Input, Mail, Written
from aseme_dsl.runtime.loading import Loaded, importing, load_system
from aseme_dsl.runtime.machine import Machine
from aseme_dsl.runtime.naming import class_name

if TYPE_CHECKING:
    from aseme_dsl.amola.statechart import Statechart
    from aseme_dsl.amola.system import System
    from aseme_dsl.runtime.plain import Plain

MS = 1_000_000
_LONGEST = 50
"""Milliseconds between two inputs, at most; now and then it is a thousand times as long."""
_INSTANCES = 200
"""How many instances are made to see how much memory one takes."""
_FEW = 500
"""With fewer inputs, several charts are played to in a round."""
_IDLE = 2000
"""How many steps without an input are timed."""


@dataclass(frozen=True, slots=True)
class Timed:
    """One way to run a role: ns of CPU for a step with an input and for one without, bytes an instance."""

    step: float
    idle: float
    memory: float


@dataclass(frozen=True, slots=True)
class Measured:
    """A role. `refused` is why there is no plain statechart of it; `ways` are the ways to run it, by name."""

    role: str
    states: int
    regions: int
    transitions: int
    steps: int
    activities: int
    """How many states have an activity."""
    visited: int
    """How many of these were active."""
    taken: int
    """How many of the transitions were taken."""
    ways: Mapping[str, Timed] = field(default_factory=dict)
    refused: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Bench:
    """What was measured of a system, with the seed that its inputs came from."""

    system: str
    seed: int
    load: float
    """How long it takes to import all that was generated for agents, in ms of CPU."""
    roles: tuple[Measured, ...]


@dataclass(frozen=True, slots=True)
class Said:
    """One input as data: `kind` is `event`, `message`, `done`, `write` or `mail`; at `now` (ns)."""

    kind: str
    now: int
    name: str
    content: Mapping[str, Any] = field(default_factory=dict)
    token: int = 0
    outcome: str | None = None
    mail: tuple[str, str, str] = ("", "", "")
    """Branch, performative and participant of an agent message, whose type is `name`."""


class Different(Exception):
    """The two faces of a role do not agree, so that nothing is timed; the text says where."""


def bench(
    system: System,
    folder: Path,
    path: Sequence[Path] = (),
    *,
    roles: Sequence[str] = (),
    steps: int = 2000,
    rounds: int = 7,
    seed: int = 1,
) -> Bench:
    """Generate a system into `folder` (a temporary one), and measure its roles (or some of them).

    `path` are the folders in which the functions of conditions are found.

    Raises:
        Different: the faces of a role do not agree.
    """
    build(system, folder, Choice(only=frozenset({"monas"})))
    package = folder / "monas" / system.name
    loaded = load_system(package, path)
    loads: list[float] = []
    for _ in range(rounds):
        begun = time.process_time()
        load_system(package, path)
        loads.append(1000 * (time.process_time() - begun))
    wanted = [chart for chart in system.iacs if not roles or chart.name in roles]
    plain, refused = _plain(system, folder, path)
    found = [
        _measured(
            system, chart, loaded, plain.get(chart.name), refused.get(chart.name, ()), steps, rounds, seed
        )
        for chart in wanted
    ]
    return Bench(system.name, seed, statistics.median(loads), tuple(found))


def _plain(
    system: System, folder: Path, path: Sequence[Path]
) -> tuple[dict[str, type[Plain]], dict[str, tuple[str, ...]]]:
    """The plain class of each role that has one; of the others, what they do that plain ones cannot."""
    from aseme_dsl.codegen.plain_limits import limits

    refused: dict[str, tuple[str, ...]] = {}
    for chart in system.iacs:
        found = tuple(dict.fromkeys(limit.what for limit in limits(chart, system.activities)))
        if found:
            refused[chart.name] = found
    possible = replace(system, iacs=tuple(chart for chart in system.iacs if chart.name not in refused))
    if not possible.iacs:
        return {}, refused
    build(possible, folder / "alone", Choice(only=frozenset({"plain"}), backends=("plain",)))
    with importing([folder / "alone" / "plain", *path]):
        package = import_module(system.name)
    return {chart.name: getattr(package, class_name(chart.name)) for chart in possible.iacs}, refused


# ---- inputs ------------------------------------------------------------------------------------


class _Drawing:
    """Draws inputs that a chart can take."""

    def __init__(self, system: System, chart: Statechart, kind: type[Chart], chance: random.Random) -> None:
        self.chance = chance
        self.kind = kind
        self.messages = {message.name: message for message in system.messages}
        self.enums = {enum.name: enum for enum in system.enums}
        events = [event for item in chart.transitions for event in item.expression.events]
        self.events = sorted({event.name for event in events if isinstance(event, Raised)})
        self.channels = [
            (info.name, info.message) for info in kind.PLAN.channels if kind.READERS.get(info.name)
        ]
        awaited = dict.fromkeys(
            (event.performative, event.message, event.participant)
            for event in events
            if isinstance(event, Received)
        )
        self.mails = [
            (branch.label, *mail)
            for branch in kind.PLAN.branches
            for mail in awaited
            if mail[:2] in branch.receives
        ]
        written = {name for item in kind.PLAN.activities for name in item.variables}
        self.variables = [item for item in chart.variables if item.name in written]
        self.ends = {item.name: item.ends for item in kind.PLAN.activities}
        self.activity = {node.label: node.activity for node in chart.nodes}
        self.constants: dict[Kind, list[Any]] = {}
        for _, value in chart.values():
            if isinstance(value, Literal):
                self.constants.setdefault(value.type.kind, []).append(value.value)

    def next(self, chart: Chart, now: int) -> Said | None:
        """An input for a chart as it is; None if there is nothing that it could take."""
        running = [
            label for label, (leaf, _, number) in chart.RUNNING.items() if getattr(chart, leaf) == number
        ]
        active = chart.configuration()
        mails = [mail for mail in self.mails if any(label.startswith(f"{mail[0]}.") for label in active)]
        kinds = [
            *(["event"] * bool(self.events)),
            *(["message"] * 2 * bool(self.channels)),
            *(["done"] * 2 * bool(running)),
            *(["write"] * bool(self.variables)),
            *(["mail"] * 3 * bool(mails)),
        ]
        if not kinds:
            return None
        match self.chance.choice(kinds):
            case "event":
                return Said("event", now, self.chance.choice(self.events))
            case "message":
                channel, message = self.chance.choice(self.channels)
                return Said("message", now, channel, self.content(message))
            case "done":
                label = self.chance.choice(running)
                ends = self.ends.get(self.activity[label] or "", ())
                outcome = self.chance.choice(ends) if ends else None
                return Said(
                    "done", now, label, token=getattr(chart, chart.RUNNING[label][1]), outcome=outcome
                )
            case "write":
                variable = self.chance.choice(self.variables)
                return Said("write", now, variable.name, {"value": self.value(variable.type)})
            case _:
                branch, performative, message, participant = self.chance.choice(mails)
                content = self.content(message) if message else {}
                return Said("mail", now, message, content, mail=(branch, performative, participant))

    def content(self, name: str) -> dict[str, Any]:
        """Values for the members of a message, some of an optional one missing."""
        found: dict[str, Any] = {}
        for item in self.messages[name].fields:
            if item.label == "repeated":
                found[item.name] = tuple(self.value(item.type) for _ in range(self.chance.randrange(4)))
            elif item.label != "optional" or self.chance.random() < 0.7:
                found[item.name] = self.value(item.type)
        return found

    def value(self, kind: Type) -> Any:
        """A value of a type: more often than not near a constant of the chart's own conditions."""
        chance = self.chance
        known = self.constants.get(kind.kind, [])
        near = chance.choice(known) if known and chance.random() < 0.7 else None
        match kind.kind:
            case Kind.BOOL:
                return chance.random() < 0.5
            case Kind.INT | Kind.DURATION:
                return (0 if near is None else int(near)) + chance.randrange(-2, 3)
            case Kind.DOUBLE:
                return (chance.uniform(-1, 1) if near is None else float(near)) + chance.choice(
                    (-0.1, 0, 0.1)
                )
            case Kind.STRING:
                return "text" if near is None else str(near)
            case Kind.BYTES:
                return b"\x00"
            case Kind.ENUM:
                return ("enum", kind.name, chance.choice(self.enums[kind.name].constants)[0])
            case Kind.MESSAGE:
                return ("message", kind.name, self.content(kind.name))
        return None


def _made(name: str, content: Mapping[str, Any], messages: Mapping[str, Any]) -> Any:
    """A message of the class that a package has for it."""
    kind = messages[name]
    own = {item.name for item in fields(kind)}
    return kind(**{key: _value(item, messages) for key, item in content.items() if key in own})


def _value(value: Any, messages: Mapping[str, Any]) -> Any:
    match value:
        case ("enum", str(name), str(constant)):
            return messages[name][constant]
        case ("message", str(name), dict(content)):
            return _made(name, content, messages)
        case tuple():
            return tuple(_value(item, messages) for item in value)
    return value


def _agent_input(said: Said, number: int, messages: Mapping[str, Any]) -> Input:
    match said.kind:
        case "event":
            return Happened(said.name)
        case "message":
            message = _made(said.name.rpartition(".")[2], said.content, messages)
            return Arrived(said.name, message, "other", said.now, ("other", number))
        case "done":
            return Completed(said.name, said.token, said.outcome)
        case "write":
            return Written(said.name, _value(said.content["value"], messages))
    branch, performative, participant = said.mail
    content = _made(said.name, said.content, messages) if said.name else None
    return Mail(branch, performative, said.name, content, participant, "other", ("other", number))


# ---- measuring ---------------------------------------------------------------------------------

_Step = tuple[int, tuple[Input, ...]]
_Call = tuple[Callable[[str], object] | None, str, str | None, Any, int]
"""What is called with which text; before, what is put where on the blackboard, and the time."""


def _measured(
    system: System,
    chart: Statechart,
    loaded: Loaded,
    plain: type[Plain] | None,
    refused: tuple[str, ...],
    steps: int,
    rounds: int,
    seed: int,
) -> Measured:
    kind = loaded.charts[chart.name]
    messages = vars(loaded.modules[f"monas.{system.name}.messages"])
    said, script, trail, visited, taken = _drawn(system, chart, kind, messages, steps, seed)
    ways: dict[str, Timed] = {}
    if script:
        makers: dict[str, Callable[[], tuple[Callable[[], None], Callable[[], object], int]]] = {
            "agent": lambda: _agent_pass(kind, script)
        }
        if plain is not None:
            _compare(plain, said, trail)
            makers |= {
                "plain": lambda: _plain_pass(plain, said, lambda made: made),
                "Machine.send": lambda: _plain_pass(plain, said, Machine),
                "Machine.post": lambda: _plain_pass(plain, said, Machine, "post"),
            }
        instances: dict[str, Callable[[], object]] = {"agent": lambda: kind("one")}
        if plain is not None:
            queued = partial(_queued, plain)
            instances |= {"plain": plain, "Machine.send": queued, "Machine.post": queued}
        ways = _timed(makers, instances, rounds)
    return Measured(
        chart.name,
        len(chart.nodes),
        len(kind.REGIONS),
        len(chart.transitions),
        len(script),
        len(kind.RUNNING),
        len(visited & kind.RUNNING.keys()),
        len(taken),
        ways,
        refused,
    )


def _drawn(
    system: System, chart: Statechart, kind: type[Chart], messages: Mapping[str, Any], steps: int, seed: int
) -> tuple[list[Said], list[_Step], list[tuple[str, ...]], set[str], set[int]]:
    """Inputs as data and for an agent, each with the configuration after it; the states and transitions."""
    chance = random.Random(f"{seed} {chart.name}")
    drawing = _Drawing(system, chart, kind, chance)
    running = kind("one")
    running.settle()
    running.step(0, ())
    said: list[Said] = []
    script: list[_Step] = []
    trail = [running.configuration()]
    visited, taken = set(trail[0]), set[int]()
    now = 0
    while len(script) < steps and not running.finished and running.failure is None:
        now += chance.randrange(_LONGEST) * (1000 if chance.random() < 0.02 else 1) * MS
        item = drawing.next(running, now)
        if item is None:
            break
        inputs = (_agent_input(item, len(script) + 1, messages),)
        outcome = running.step(now, inputs)
        said.append(item)
        script.append((now, inputs))
        trail.append(running.configuration())
        visited.update(trail[-1])
        taken.update(number for numbers in outcome.taken for number in numbers)
    return said, script, trail, visited, taken


def _compare(kind: type[Plain], said: Sequence[Said], trail: Sequence[tuple[str, ...]]) -> None:
    """Play the inputs to a plain chart.

    Raises:
        Different: it is not where the agent's was.
    """
    chart = kind()
    chart.start()
    found = chart.configuration()
    if found != trail[0]:
        raise Different(f"{kind.__name__}: at first {found}, and as an agent {trail[0]}")
    calls = _calls(chart, chart, said)
    for number, (call, wanted) in enumerate(zip(calls, trail[1:], strict=True), start=1):
        _do(chart, [call])
        if chart.configuration() != wanted:
            raise Different(
                f"{kind.__name__}: after input {number} ({said[number - 1].kind} {said[number - 1].name}) "
                f"{chart.configuration()}, and as an agent {wanted}"
            )


def _calls(chart: Plain, runner: Any, said: Sequence[Said], send: str = "send") -> list[_Call]:
    """What the inputs are for a plain chart."""
    package = import_module(type(chart).__module__.rpartition(".")[0] + ".messages")
    slots = {channel: slot for slot, channel, host in chart.MESSAGES if host is None}
    found: list[_Call] = []
    for item in said:
        match item.kind:
            case "event":
                found.append((getattr(runner, send), item.name, None, None, item.now))
            case "done":
                found.append((runner.done, item.name, None, None, item.now))
            case "write":
                value = _value(item.content["value"], vars(package))
                found.append((None, "", item.name, value, item.now))
            case _:
                message = _made(item.name.rpartition(".")[2], item.content, vars(package))
                found.append((None, "", slots.get(item.name), message, item.now))
    return found


def _do(chart: Plain, calls: Sequence[_Call], step: Callable[[], object] | None = None) -> None:
    """Give a plain chart its inputs."""
    board = getattr(chart, "bb")  # noqa: B009  of each subclass another
    changed = getattr(board, "changed", None)
    step = step or chart.step
    timed = hasattr(chart, "now")
    for call, text, slot, message, now in calls:
        if timed:
            chart.now = now  # type: ignore[attr-defined]
        if call is not None:
            call(text)
            continue
        if slot is not None:
            setattr(board, slot, message)
            if changed is not None:
                changed()
        step()


_Pass = tuple[Callable[[], None], Callable[[], object], int]
"""What plays all inputs to a fresh chart, what makes a step without one afterwards, and how many inputs."""


def _agent_pass(kind: type[Chart], script: Sequence[_Step]) -> _Pass:
    charts = [kind("one") for _ in range(_fresh(script))]
    for chart in charts:
        chart.settle()
        chart.step(0, ())

    def play() -> None:
        for chart in charts:
            step = chart.step
            for now, inputs in script:
                step(now, inputs)

    return play, partial(charts[-1].step, script[-1][0], ()), len(charts) * len(script)


def _plain_pass(
    kind: type[Plain], said: Sequence[Said], made: Callable[[Any], Any], send: str = "send"
) -> _Pass:
    charts = [kind() for _ in range(_fresh(said))]
    runners = [made(chart) for chart in charts]
    for runner in runners:
        runner.start()
    calls = [_calls(chart, runner, said, send) for chart, runner in zip(charts, runners, strict=True)]

    def play() -> None:
        for chart, runner, own in zip(charts, runners, calls, strict=True):
            _do(chart, own, runner.step)

    return play, runners[-1].step, len(charts) * len(said)


def _fresh(inputs: Sequence[object]) -> int:
    """How many charts are played to: more than one where a chart comes to its end soon."""
    return max(1, _FEW // len(inputs))


def _timed(
    makers: Mapping[str, Callable[[], _Pass]],
    instances: Mapping[str, Callable[[], object]],
    rounds: int,
) -> dict[str, Timed]:
    """The medians of interleaved rounds."""
    steps: dict[str, list[float]] = {name: [] for name in makers}
    idle: dict[str, list[float]] = {name: [] for name in makers}
    enabled = gc.isenabled()
    gc.disable()
    try:
        for _ in range(rounds):
            for name, make in makers.items():
                play, tick, number = make()
                begun = time.process_time_ns()
                play()
                steps[name].append((time.process_time_ns() - begun) / number)
                begun = time.process_time_ns()
                for _ in range(_IDLE):
                    tick()
                idle[name].append((time.process_time_ns() - begun) / _IDLE)
                gc.collect(0)
    finally:
        if enabled:
            gc.enable()
    memory = {name: _memory(make) for name, make in instances.items()}
    return {
        name: Timed(
            statistics.median(steps[name]),
            statistics.median(idle[name]),
            memory[name],
        )
        for name in makers
    }


def _queued(plain: Callable[[], Any]) -> object:
    """A statechart with its queue."""
    return Machine(plain())


def _memory(make: Callable[[], object]) -> float:
    """Bytes of an instance, with its blackboard."""
    make()
    tracemalloc.start()
    try:
        before = tracemalloc.get_traced_memory()[0]
        kept = [make() for _ in range(_INSTANCES)]
        return (tracemalloc.get_traced_memory()[0] - before) / len(kept)
    finally:
        tracemalloc.stop()


# ---- telling -----------------------------------------------------------------------------------


def markdown(found: Bench) -> str:
    """The report for people."""
    lines = [
        f"# {found.system}",
        "",
        f"Seed {found.seed}; the code of all agents is imported in {found.load:.1f} ms of CPU. Times are CPU"
        " time of one thread, medians of interleaved rounds.",
        "",
        "| role | states | regions | inputs | activities started | transitions taken |",
        "| --- | ---: | ---: | ---: | ---: | ---: |",
    ]
    for item in found.roles:
        visited = f"{item.visited} of {item.activities}"
        numbers = (item.states, item.regions, item.steps, visited, f"{item.taken} of {item.transitions}")
        lines.append(f"| {item.role} | {' | '.join(map(str, numbers))} |")
    lines += [
        "",
        "| role | run as | step, ns | of the agent's | idle tick, ns | memory, bytes |",
        "| --- | --- | ---: | ---: | ---: | ---: |",
    ]
    for item in found.roles:
        lines += _rows(item)
    notes = [
        f"- `{item.role}` has no plain statechart: {', '.join(item.refused)}."
        for item in found.roles
        if item.refused
    ]
    return "\n".join([*lines, *([""] if notes else []), *notes]) + "\n"


def _rows(item: Measured) -> Iterator[str]:
    if not item.ways:
        yield f"| {item.role} | nothing that it could take | | | | |"
    for name, timed in item.ways.items():
        share = f"{timed.step / item.ways['agent'].step:.2f}"
        numbers = (f"{timed.step:.0f}", share, f"{timed.idle:.0f}", f"{timed.memory:.0f}")
        yield f"| {item.role} | {name} | {' | '.join(numbers)} |"


__all__ = ["Bench", "Different", "Measured", "Timed", "bench", "markdown"]
