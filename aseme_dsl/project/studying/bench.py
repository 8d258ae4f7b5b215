"""Bench: what a step of a system's own statecharts costs, with inputs that they can take or once took.

The inputs are drawn by a seed, or are those that agents got in a recorded run. They are played to fresh
charts: to the agent's and, where a role has one, to the plain one. Before the plain chart is timed, it must
be in the same configuration after every step.
"""

from __future__ import annotations

import gc
import statistics
import time
import tracemalloc
from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.project.building.build import Choice, build
from aseme_dsl.project.studying.course import Course, Runner, begun, doings, plain_begun, plain_player, player
from aseme_dsl.project.studying.drawn import drawn_anew
from aseme_dsl.project.studying.recorded import NobodyThere, Recording, recorded
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.plain.machine import Machine
from aseme_dsl.runtime.plain.plain import ActivityFailed
from aseme_dsl.runtime.version.loading import importing, load_system
from aseme_dsl.runtime.workers.process_wide import uncollected

if TYPE_CHECKING:
    from aseme_dsl.amola.statechart import Statechart
    from aseme_dsl.amola.system import System
    from aseme_dsl.runtime.plain.plain import Plain

STEPS = 2000
"""How many inputs are drawn."""
_INSTANCES = 200
"""How many instances are made to see how much memory one takes."""
_FEW = 500
"""With fewer steps, several charts are played to in a round."""
_IDLE = 2000
"""How many steps without an input are timed."""


@dataclass(frozen=True, slots=True)
class Timed:
    """One way to run a role: ns of CPU for a step with its inputs and for one without, bytes an instance."""

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
    starts: int
    """How many statecharts begin: one where the first has come to its end, or one for each agent of a run."""
    steps: int
    """How many steps are played, those aside with which statecharts begin."""
    inputs: int
    activities: int
    """How many states have an activity."""
    visited: int
    """How many of these were active."""
    taken: int
    """How many of the transitions were taken."""
    agents: tuple[Played, ...] = ()
    """Whose recorded inputs these are."""
    ways: Mapping[str, Timed] = field(default_factory=dict)
    refused: tuple[str, ...] = ()
    one_by_one: int = 0
    """How many steps the plain statechart makes of those steps: it takes ends and events one by one."""
    left_out: str = ""
    """Why the plain statechart, which there is, was not timed."""


@dataclass(frozen=True, slots=True)
class Played:
    """An agent whose recorded steps were played; `until` is why not all of them, if so."""

    trace: str
    agent: str
    steps: int
    inputs: int
    until: str = ""


@dataclass(frozen=True, slots=True)
class Bench:
    """What was measured of a system, with the seed that its inputs came from, or the traces with them."""

    system: str
    seed: int
    load: float
    """How long it takes to import all that was generated for agents, in ms of CPU."""
    roles: tuple[Measured, ...]
    traces: tuple[str, ...] = ()
    problems: tuple[str, ...] = ()
    """What has to be said of the traces."""


class Different(Exception):
    """The two faces of a role do not agree, so that nothing is timed; the text says where."""


def bench(
    system: System,
    folder: Path,
    path: Sequence[Path] = (),
    *,
    roles: Sequence[str] = (),
    steps: int | None = None,
    rounds: int = 7,
    seed: int = 1,
    traces: Sequence[Path] = (),
) -> Bench:
    """Generate a system into `folder` (a temporary one), and measure its roles (or some of them).

    `path` are the folders in which the functions of conditions are found. With `traces`, the inputs are those
    recorded there, `steps` of each agent at the most; without, so many (`STEPS`) are drawn by the seed.

    Raises:
        Different: the faces of a role do not agree.
        NotPlayable: a trace is not one of these roles as they are.
    """
    build(system, folder, Choice(only=frozenset({"monas"})))
    package = folder / "monas" / system.name
    loaded = load_system(package, path)
    messages = vars(loaded.modules[f"monas.{system.name}.messages"])
    wanted = [chart for chart in system.iacs if not roles or chart.name in roles]
    kinds = {chart.name: loaded.charts[chart.name] for chart in wanted}
    recordings = recordings_of(traces, system.name, kinds, messages, steps)
    plain, refused = plain_classes(system, folder, path)
    found: list[Measured] = []
    for chart in wanted:
        kind = kinds[chart.name]
        if traces:
            courses, agents = _courses(recordings, chart.name)
        else:
            asked = STEPS if steps is None else steps
            courses, agents = drawn_anew(system, chart, kind, messages, asked, seed), ()
        measured = _measured(chart, kind, plain.get(chart.name), courses, rounds, recorded=bool(traces))
        found.append(replace(measured, agents=agents, refused=refused.get(chart.name, ())))
    loads: list[float] = []
    for _ in range(rounds):
        begun_at = time.process_time()
        load_system(package, path)
        loads.append(1000 * (time.process_time() - begun_at))
    return Bench(
        system.name,
        recordings[0].seed if recordings else seed,
        statistics.median(loads),
        tuple(found),
        tuple(str(item.path) for item in recordings),
        tuple(item.problem for item in recordings if item.problem is not None),
    )


def recordings_of(
    traces: Sequence[Path],
    system: str,
    kinds: Mapping[str, type[Chart]],
    messages: Mapping[str, type[object]],
    most: int | None = None,
) -> list[Recording]:
    """What the agents of these roles got, by the traces of one run or of several.

    Raises:
        NotPlayable: a trace cannot be played, or none of them has such agents.
    """
    found: list[Recording] = []
    for number, trace in enumerate(traces, 1):
        try:
            found.append(recorded(trace, system, kinds, messages, most))
        except NobodyThere:
            if number == len(traces) and not found:
                raise
    return found


def _courses(recordings: Sequence[Recording], role: str) -> tuple[list[Course], tuple[Played, ...]]:
    """The courses of a role, and whose they are."""
    found = [(str(item.path), course) for item in recordings for course in item.courses[role]]
    played = tuple(
        Played(trace, item.agent, len(item.steps) - 1, item.inputs, item.until) for trace, item in found
    )
    return [course for _, course in found if len(course.steps) > 1], played


def plain_classes(
    system: System, folder: Path, path: Sequence[Path]
) -> tuple[dict[str, type[Plain]], dict[str, tuple[str, ...]]]:
    """The plain class of each role that has one; of the others, what they do that plain ones cannot."""
    from aseme_dsl.backends.plain.generate import class_names
    from aseme_dsl.codegen.plain_limits import limits

    refused: dict[str, tuple[str, ...]] = {}
    for chart in system.iacs:
        found = tuple(dict.fromkeys(limit.what.value for limit in limits(chart, system.activities)))
        if found:
            refused[chart.name] = found
    possible = replace(system, iacs=tuple(chart for chart in system.iacs if chart.name not in refused))
    if not possible.iacs:
        return {}, refused
    build(possible, folder / "alone", Choice(only=frozenset({"plain"}), backends=("plain",)))
    with importing([folder / "alone" / "plain", *path]):
        package = import_module(system.name)
    return {role: getattr(package, name) for role, name in class_names(possible).items()}, refused


# ---- measuring ---------------------------------------------------------------------------------


def _measured(
    chart: Statechart,
    kind: type[Chart],
    plain: type[Plain] | None,
    courses: Sequence[Course],
    rounds: int,
    *,
    recorded: bool,
) -> Measured:
    left_out, one_by_one = "", 0
    makers: dict[str, Callable[[], _Pass]] = {"agent": lambda: _agent_pass(kind, courses)}
    instances: dict[str, Callable[[], object]] = {"agent": lambda: kind("one")}
    if plain is not None and courses:
        try:
            one_by_one = sum(compare(plain, kind, course) for course in courses)
        except Different as different:
            if not recorded:
                raise
            left_out = str(different)
        else:
            queued = partial(_queued, plain)
            makers |= {
                "plain": lambda: plain_pass(plain, kind, courses, lambda made: made),
                "Machine.send": lambda: plain_pass(plain, kind, courses, Machine),
                "Machine.post": lambda: plain_pass(plain, kind, courses, Machine, "post"),
            }
            instances |= {"plain": plain, "Machine.send": queued, "Machine.post": queued}
    return Measured(
        chart.name,
        len(chart.states),
        len(kind.REGIONS),
        len(chart.transitions),
        len(courses),
        sum(len(course.steps) - 1 for course in courses),
        sum(course.inputs for course in courses),
        len(kind.RUNNING),
        len(kind.RUNNING.keys() & {label for course in courses for label in course.visited}),
        len({number for course in courses for number in course.taken}),
        ways=_timed(makers, instances, rounds) if courses else {},
        one_by_one=one_by_one,
        left_out=left_out,
    )


def compare(plain: type[Plain], kind: type[Chart], course: Course) -> int:
    """Play a course to a plain chart; how many steps it makes of it, the start aside.

    Raises:
        Different: it is not where the agent's was.
    """
    chart = plain_begun(plain, course, _fresh(kind, course))
    name = plain.__name__
    doing_all = doings(chart, chart, course, _fresh(kind, course))
    for number, doing in enumerate(doing_all):
        try:
            plain_player(chart, [doing])()
        except ActivityFailed as failed:
            raise Different(f"{name}: in step {number} {failed}") from failed
        found, wanted = chart.configuration(), course.trail[number]
        if found != wanted:
            inputs = course.steps[number].inputs
            what = ", ".join(f"{type(item).__name__.lower()} {_about(item)}" for item in inputs) or "no input"
            at_once = "; it takes them one after the other" if len(inputs) > 1 else ""
            raise Different(
                f"{name}: after step {number} ({what}{at_once}) {found}, and as an agent {wanted}"
            )
    return sum(len(doing.calls) for doing in doing_all) - 1


def _about(item: object) -> str:
    """What an input is about."""
    return next(
        str(getattr(item, name))
        for name in ("channel", "label", "name", "variable", "message")
        if hasattr(item, name)
    )


_Pass = tuple[Callable[[], None], Callable[[], object], int]
"""What plays all courses to fresh charts, what makes a step without inputs afterwards, and how many steps."""


def _agent_pass(kind: type[Chart], courses: Sequence[Course]) -> _Pass:
    plays: list[Callable[[], None]] = []
    for course in _often(courses):
        chart = _fresh(kind, course)
        player(chart, course.steps[:1])()
        plays.append(player(chart, course.steps[1:]))
    return _one_by_one(plays), partial(chart.step, course.steps[-1].now, ()), _number(courses)


def plain_pass(
    plain: type[Plain],
    kind: type[Chart],
    courses: Sequence[Course],
    made: Callable[[Plain], Runner],
    send: str = "send",
) -> _Pass:
    """What plays courses to fresh plain charts, each run by what is `made` of it: itself, or a `Machine`."""
    plays: list[Callable[[], None]] = []
    for course in _often(courses):
        chart = plain_begun(plain, course, _fresh(kind, course))
        runner = made(chart)
        first, *others = doings(chart, runner, course, _fresh(kind, course), send)
        plain_player(chart, [first])()
        plays.append(plain_player(chart, others))
    return _one_by_one(plays), runner.step, _number(courses)


def _one_by_one(plays: Sequence[Callable[[], None]]) -> Callable[[], None]:
    def play_all() -> None:
        for play in plays:
            play()

    return play_all


def _fresh(kind: type[Chart], course: Course) -> Chart:
    """A chart that has not made the first step of a course."""
    return begun(kind, course.agent, course.seed, course.queue)


def _often(courses: Sequence[Course]) -> list[Course]:
    """The courses, several times where they are short: a chart may come to its end soon."""
    return [*courses] * _times(courses)


def _number(courses: Sequence[Course]) -> int:
    """How many steps are timed."""
    return _times(courses) * sum(len(course.steps) - 1 for course in courses)


def _times(courses: Sequence[Course]) -> int:
    return max(1, _FEW // sum(len(course.steps) - 1 for course in courses))


def _timed(
    makers: Mapping[str, Callable[[], _Pass]],
    instances: Mapping[str, Callable[[], object]],
    rounds: int,
) -> dict[str, Timed]:
    """The medians of interleaved rounds."""
    steps: dict[str, list[float]] = {name: [] for name in makers}
    idle: dict[str, list[float]] = {name: [] for name in makers}
    with uncollected():
        for _ in range(rounds):
            for name, make in makers.items():
                play, tick, number = make()
                begun_at = time.process_time_ns()
                play()
                steps[name].append((time.process_time_ns() - begun_at) / number)
                begun_at = time.process_time_ns()
                for _ in range(_IDLE):
                    tick()
                idle[name].append((time.process_time_ns() - begun_at) / _IDLE)
                gc.collect(0)
    memory = {name: _memory(make) for name, make in instances.items()}
    return {
        name: Timed(
            statistics.median(steps[name]),
            statistics.median(idle[name]),
            memory[name],
        )
        for name in makers
    }


def _queued(plain: type[Plain]) -> object:
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


__all__ = [
    "STEPS",
    "Bench",
    "Different",
    "Measured",
    "Played",
    "Timed",
    "bench",
    "compare",
    "plain_classes",
    "plain_pass",
    "recordings_of",
]
