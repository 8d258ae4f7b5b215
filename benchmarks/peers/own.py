"""The peers with a role of anybody's file: `python -m benchmarks.peers --file FILE [--role ROLE]`.

The inputs are those of `asemec bench`: drawn, or of recorded runs. Who does not enter and leave every state
as often as the reference interpreter is not timed. What cannot be told to peers is refused with the reason.
"""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.diagnostics import has_errors, render_text
from aseme_dsl.project.building.build import Choice, build
from aseme_dsl.project.building.project import compile_root
from aseme_dsl.project.studying.bench import Different, compare, plain_classes, plain_pass, recordings_of
from aseme_dsl.project.studying.course import Course
from aseme_dsl.project.studying.drawn import drawn
from aseme_dsl.project.studying.recorded import NotPlayable
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.plain.machine import Machine
from aseme_dsl.runtime.plain.plain import Plain
from aseme_dsl.runtime.version.loading import Loaded, load_system
from benchmarks.behaviours import counts
from benchmarks.behaviours.description import Behaviour, as_json, entered, instrumented, left, walk
from benchmarks.behaviours.own import Refused, described, identifier, one_by_one
from benchmarks.peers.contenders import CORE_TYPED, PEERS, POST, SEND, Failed, Process
from benchmarks.peers.environment import Environment, prepare
from benchmarks.peers.measuring import Series

STEPS = 500
"""How many inputs are drawn, and how many recorded steps are played at the most: some libraries are slow."""
SLICE = 0.05
"""Seconds of CPU time that one measurement aims at."""
MOST = 20
"""So many machines are made for one measurement at the most."""


@dataclass(slots=True)
class Role:
    """What was found of a role."""

    name: str
    states: int = 0
    transitions: int = 0
    steps: int = 0
    agent: str = ""
    """Whose recorded inputs these are."""
    series: dict[str, Series] = field(default_factory=dict)
    """By contender; the ratios are those to `Machine.send` of the same round."""
    left_out: dict[str, str] = field(default_factory=dict)
    """Why a contender was not timed."""
    refused: str = ""
    """Why none was."""
    places: str = ""
    """The same with the places in the file, where it is no plain statechart."""


@dataclass(slots=True)
class Found:
    """What was found of a file."""

    system: str
    origin: str
    roles: list[Role] = field(default_factory=list)
    versions: dict[str, str] = field(default_factory=dict)


def measured(
    file: Path, roles: Sequence[str], traces: Sequence[Path], rounds: int, say: Callable[[str], None]
) -> Found:
    """Compare the roles of a file, or some of them.

    Raises:
        ValueError: the file has mistakes, or no such role; or a trace is not one of these roles.
    """
    compiled = compile_root(file)
    if compiled.system is None or has_errors(compiled.diagnostics):
        raise ValueError(render_text(compiled.diagnostics))
    system = compiled.system
    known = [chart.name for chart in system.iacs]
    strange = [role for role in roles if role not in known]
    if strange:
        raise ValueError(f"{system.name} has no role {strange[0]}; there are {', '.join(known)}")
    origin = f"recorded in {', '.join(map(str, traces))}" if traces else f"{STEPS} drawn inputs"
    found = Found(system.name, origin)
    path = [compiled.configuration.folder, file.parent]
    with tempfile.TemporaryDirectory(prefix="aseme-peers-") as folder:
        build(system, Path(folder), Choice(only=frozenset({"monas"})))
        loaded = load_system(Path(folder) / "monas" / system.name, path)
        plain, _ = plain_classes(system, Path(folder), path)
        charts = [chart for chart in system.iacs if not roles or chart.name in roles]
        courses = _courses(system, charts, loaded, traces)
        environment: Environment | None = None
        for chart in charts:
            role = Role(chart.name)
            found.roles.append(role)
            try:
                kind = loaded.charts[chart.name]
                if len(courses[chart.name].steps) < 2:
                    nothing = (
                        "it does nothing in the trace" if traces else "there is nothing that it could take"
                    )
                    raise Refused(nothing)
                course = one_by_one(kind, courses[chart.name])
                behaviour = described(system, chart, kind, course, path)
            except Refused as refused:
                role.refused, role.places = str(refused), refused.places
                say(f"{chart.name} is not compared: {refused}")
                continue
            if environment is None:
                environment = prepare()
            say(f"{chart.name}: {len(course.steps) - 1} steps")
            states = behaviour.states
            role.states, role.steps = len(states), len(behaviour.steps)
            role.agent = course.agent if traces else ""
            role.transitions = sum(len(state.transitions) for state in states)
            _compare(
                role, chart, kind, plain[chart.name], course, behaviour, loaded, environment, rounds, found
            )
    return found


def _courses(
    system: System, charts: Sequence[Statechart], loaded: Loaded, traces: Sequence[Path]
) -> dict[str, Course]:
    """One course of each role: drawn, or the beginning of the longest that is recorded."""
    messages = vars(loaded.modules[f"monas.{system.name}.messages"])
    kinds = {chart.name: loaded.charts[chart.name] for chart in charts}
    if not traces:
        return {chart.name: drawn(system, chart, kinds[chart.name], messages, STEPS, 1) for chart in charts}
    found: dict[str, list[Course]] = {name: [] for name in kinds}
    try:
        for recording in recordings_of(traces, system.name, kinds, messages, STEPS):
            for name, courses in recording.courses.items():
                found[name] += courses
    except NotPlayable as problem:
        raise ValueError(str(problem)) from problem
    return {
        name: max(
            courses,
            key=lambda course: len(course.steps),
            default=Course("", (), (), frozenset(), frozenset()),
        )
        for name, courses in found.items()
    }


def _compare(
    role: Role,
    chart: Statechart,
    kind: type[Chart],
    plain: type[Plain],
    course: Course,
    behaviour: Behaviour,
    loaded: Loaded,
    environment: Environment,
    rounds: int,
    found: Found,
) -> None:
    """Check and time everybody with one role."""
    messages = vars(loaded.modules[f"monas.{found.system}.messages"])
    entries, exits, trail = counts.counts_of(kind.PLAN, course, messages)
    if tuple(trail) != course.trail:
        raise ValueError(f"{role.name}: the reference interpreter goes another way")
    whole = instrumented(behaviour)
    names = {identifier(node): node.label for node in chart.states}
    expected: dict[str, int] = {}
    for state in list(walk(behaviour.root))[1:]:
        expected[entered(state.name)] = entries.get(names[state.name], 0)
        expected[left(state.name)] = exits.get(names[state.name], 0)
    timers: dict[str, Callable[[], float]] = {}
    try:
        compare(plain, kind, course)
    except Different as different:
        raise ValueError(str(different)) from different
    for contender, made, send in (
        (CORE_TYPED, _itself, "send"),
        (SEND, Machine, "send"),
        (POST, Machine, "post"),
    ):
        timers[contender.key] = _ours(plain, kind, course, made, send)
    processes: list[Process] = []
    try:
        for contender in PEERS:
            reason = environment.missing.get(contender.distribution, "")
            if not reason and contender.is_node:
                reason = "conditions and actions are told in Python"
            if not reason:
                process = Process(contender, environment)
                processes.append(process)
                reason = _checked(process, behaviour, whole, expected, found)
            if reason:
                role.left_out[contender.key] = reason
            else:
                timers[contender.key] = _peer(process, behaviour)
        for number in range(rounds):
            seconds: dict[str, float] = {}
            for key in timers if number % 2 == 0 else reversed(timers):
                seconds[key] = timers[key]()
            for key, spent in seconds.items():
                series = role.series.setdefault(key, Series())
                series.seconds.append(spent)
                series.ratios.append(spent / seconds[SEND.key])
    finally:
        for process in processes:
            process.end()


def _itself(chart: Plain) -> Any:
    return chart


def _checked(
    process: Process, behaviour: Behaviour, whole: Behaviour, expected: Mapping[str, int], found: Found
) -> str:
    """Why a peer is not timed, "" if it is: whether it counts what the reference interpreter counts."""
    try:
        found.versions[process.contender.key] = process.ask("version")["version"]
        counters = process.ask("check", behaviour=as_json(whole), steps=len(whole.steps))["counters"]
    except Failed as failed:
        text = str(failed)
        return (
            text.removeprefix("NotImplementedError: ")
            if "NotImplementedError" in text
            else f"it raised {text}"
        )
    for name, number in expected.items():
        if counters[name] != number:
            what, _, state = name.partition("_")
            return f"{state} is {what} {counters[name]} times, not {number}"
    return ""


def _ours(
    plain: type[Plain], kind: type[Chart], course: Course, made: Callable[[Plain], Any], send: str
) -> Callable[[], float]:
    def once() -> float:
        play, _, number = plain_pass(plain, kind, [course], made, send)
        begun = time.process_time()
        play()
        return (time.process_time() - begun) / number

    return lambda: min(once() for _ in range(3))


def _peer(process: Process, behaviour: Behaviour) -> Callable[[], float]:
    data = as_json(behaviour)
    spent = process.ask("time", behaviour=data, times=1)["seconds"]
    times = max(1, min(MOST, round(SLICE / max(spent, 1e-6))))
    number = len(behaviour.steps) * times
    return lambda: process.ask("time", behaviour=data, times=times)["seconds"] / number
