"""The description of a role of anybody's file, with the inputs of a course as its steps.

A statechart that can be a plain one is told state by state, with what peers have for it: START and END are
states, a transition that waits for completion or for its time has a guard that says so, a choice is one
transition a branch. Conditions and actions are the Python that the compiler writes of them. What peers have
no means for is refused.
"""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields, is_dataclass, replace
from enum import IntEnum
from functools import partial
from pathlib import Path
from typing import Any

from aseme_dsl.amola.expression import (
    After,
    Assign,
    Call,
    Expired,
    Outcome,
    ParameterValue,
    Raised,
    Random,
    RoundValue,
    StartTimer,
    StateValue,
    VariableValue,
    values_of,
    walk,
)
from aseme_dsl.amola.statechart import State as ChartState
from aseme_dsl.amola.statechart import Statechart, StateType, Transition, TransitionKind
from aseme_dsl.amola.system import System
from aseme_dsl.backends.plain.generate import problems_of
from aseme_dsl.codegen.code.python import text_of
from aseme_dsl.codegen.code.tree import CallOf, Const, Expr, Item, Name, all_of
from aseme_dsl.codegen.code.values import Names, converted, evaluate, function_key, holds
from aseme_dsl.codegen.place import place
from aseme_dsl.codegen.program.flat import FlatChart, Way
from aseme_dsl.codegen.program.uses import Uses
from aseme_dsl.diagnostics import render_text
from aseme_dsl.project.studying.course import Course, Given, Recorder, begun, give, runs
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import Completed, Crashed, Happened, Input, Sample, Written
from aseme_dsl.runtime.plain.plain import NEVER
from benchmarks.behaviours import description
from benchmarks.behaviours.description import Action, Behaviour, Change, Guard, State

NO_EVENT = "go_on"
"""What is sent where the program around a statechart has only written to the blackboard."""

FAILURE = "failure"
"""What waits for the failure of an activity waits for this: it is never sent."""


_KNOWN = re.compile(r"bb|m\w*\d+|call_\d+|len|abs|min|max|float|int|tuple|map")
"""What code may name: the blackboard, locals, functions, and what Python has."""

KINDS: dict[StateType, description.Kind] = {StateType.OR: "or", StateType.AND: "and"}


class Refused(Exception):
    """A role, or what it is given, is not told to peers; the text says why, `places` where and how."""

    def __init__(self, text: str, places: str = "") -> None:
        super().__init__(text)
        self.places = places


def one_by_one(kind: type[Chart], course: Course) -> Course:
    """The course with one event or end of an activity a step, as peers take them.

    Raises:
        Refused: an activity crashes in it.
    """
    reference = begun(kind, course.agent, course.seed, course.queue)
    recorder = Recorder(begun(kind, course.agent, course.seed, course.queue), course.agent, course.seed)
    for given in course.steps:
        written = tuple(item for item in given.inputs if isinstance(item, Sample | Written))
        others = [item for item in given.inputs if not isinstance(item, Sample | Written)]
        alone: list[tuple[Input, ...]] = [(item,) for item in others if not isinstance(item, Completed)]
        for item in others:
            if isinstance(item, Crashed):
                raise Refused("an activity crashes in it")
            if isinstance(item, Completed) and runs(reference, item.label, item.token):
                _, owner, _ = kind.RUNNING[item.label]
                now = getattr(recorder.chart, owner, item.token)
                alone.append((Completed(item.label, now, item.outcome),))
        give(reference, given)
        for number, inputs in enumerate(alone or [()]):
            recorder.play(Given(given.now, (*(written if number == 0 else ()), *inputs)))
    return recorder.course()


def described(
    system: System, chart: Statechart, kind: type[Chart], course: Course, path: Sequence[Path] = ()
) -> Behaviour:
    """The role as a behaviour whose steps are those of a course with one input a step (`one_by_one`).

    `path` are the folders in which the functions of conditions are found.

    Raises:
        Refused: it is no plain statechart, or has what peers have no means for; all reasons at once.
    """
    found = _Describing(system, chart).behaviour(kind, course)
    return replace(found, path=tuple(str(folder.resolve()) for folder in path))


@dataclass(frozen=True, slots=True)
class _Path:
    """A transition, with those behind the choices that it leads to."""

    parts: tuple[Transition, ...]

    @property
    def target(self) -> str:
        return self.parts[-1].target


class _Describing:
    """Goes through the states of a chart."""

    def __init__(self, system: System, chart: Statechart) -> None:
        self.chart = chart
        self.flat = FlatChart(chart)
        self.name = {node.label: identifier(node) for node in chart.states}
        self.constants = {
            (enum.name, name): str(value) for enum in system.enums for name, value in enum.constants
        }
        self.slots: dict[tuple[str, str | None], str] = {}
        for members in Uses(self.flat).members.values():
            for member in members:
                key = str(member.channel), member.host
                self.slots[key] = re.sub(r"\W", "_", f"{member.host or 'any'}_{member.channel}")
        self.fields = {
            (message.name, item.name): (item.label == "optional", item.type.name)
            for message in system.messages
            for item in message.fields
        }
        self.timed = {
            node.label
            for node in chart.states
            for item in self.flat.segments(node.label)
            if item.expression.every is not None
            or any(isinstance(event, After) for event in item.expression.events)
        }
        """The states of which it matters when they were entered."""
        self.timers = dict.fromkeys(
            (self.flat.region_number[label], item.timer) for label, item in _timers(chart)
        )
        """By the numbers of the regions that they belong to."""
        self.functions: dict[str, tuple[str, str]] = {}
        """The functions that are called: by overload, the name in the code and where it is found."""
        problems = tuple(problems_of(system, chart))
        if problems:
            raise Refused("it is no plain statechart", render_text(problems))
        refused: dict[str, str] = {}
        for item in chart.transitions:
            for what in _refused(item):
                refused.setdefault(what, place(item.span))
        if refused:
            raise Refused("; ".join(f"{what} ({where})" for what, where in refused.items()))

    def behaviour(self, kind: type[Chart], course: Course) -> Behaviour:
        root = self.state(self.chart.root)
        begin = begun(kind, course.agent, course.seed, course.queue)
        values = [(f"var_{item.name}", _text(begin.variable(item.name))) for item in self.chart.variables]
        values += [(slot, "None") for slot in self.slots.values()]
        if self.is_timed:
            values += [("now", "0"), *((self.time(label), "0") for label in sorted(self.timed))]
            values += [(_timer(*key), str(NEVER)) for key in self.timers]
        flags = [self.flag(node) for node in self.chart.states if self.flag(node)]
        event, before = self.step(course.steps[0])
        if event != NO_EVENT:
            raise Refused("it was sent an event before it began")
        values += [(name, str(value)) for name, value in before]  # the last one counts
        steps = tuple(self.step(given) for given in course.steps[1:])
        name = re.sub(r"\W", "_", self.chart.name)
        functions = tuple(self.functions.values())
        return Behaviour(name, self.chart.name, root, tuple(flags), steps, tuple(values), functions)

    @property
    def is_timed(self) -> bool:
        """Whether the time matters."""
        return bool(self.timed or self.timers)

    def time(self, label: str) -> str:
        """What says on the blackboard when a state was entered."""
        return f"time_{self.name[label]}"

    # ---- states ------------------------------------------------------------------------------

    def flag(self, node: ChartState) -> str:
        """What says on the blackboard that a state is complete; "" where that is said otherwise."""
        if node.type is StateType.BASIC or (node.type is StateType.OR and self.chart.end_of(node.label)):
            return f"done_{self.name[node.label]}"
        return ""

    def complete(self, node: ChartState) -> Guard | None:
        """The flags that say it, none for what is complete always; None for what never is."""
        match node.type:
            case StateType.START:
                return ()
            case StateType.AND:
                inside = [self.complete(region) for region in self.chart.children(node.label)]
                return None if None in inside else tuple(part for parts in inside if parts for part in parts)
            case StateType.END:
                return None
        return ((self.flag(node), True),) if self.flag(node) else None

    def state(self, node: ChartState) -> State:
        children = [item for item in self.chart.children(node.label) if item.type is not StateType.CONDITION]
        children.sort(key=lambda item: item.type is not StateType.START)  # the initial one is the first
        entry: tuple[Action, ...] = (("set", self.flag(node), False),) if self.flag(node) else ()
        parent = self.chart.node(node.parent) if node.parent is not None else None
        if node.type is StateType.END and parent is not None:
            entry = (("set", self.flag(parent), True),)
        if node.label in self.timed:
            entry = (*entry, ("python", f"bb[{self.time(node.label)!r}] = bb['now']"))
        if self.chart.is_region(node.label):  # its timers go with it
            own = [key for key in self.timers if key[0] == self.flat.region_number[node.label]]
            entry = (*entry, *(("python", f"bb[{_timer(*key)!r}] = {NEVER}") for key in own))
        exits = tuple(
            action for item in self.chart.exits_of(node.label) for action in self.actions(item, node.label)
        )
        ways = tuple(self.transitions(node))
        inside = tuple(map(self.state, children))
        return State(self.name[node.label], KINDS.get(node.type, "basic"), inside, entry, exits, ways)

    def transitions(self, node: ChartState) -> Iterator[description.Transition]:
        for way in self.flat.ways(node.label):
            for path in self.paths(way):
                first = path.parts[0].expression
                guard: Guard = ()
                if not first.events and not first.when:
                    complete = self.complete(node)
                    if complete is None:
                        continue
                    guard = complete
                names = self.names(node.label)
                for part in path.parts:
                    if part.expression.every is not None:
                        guard = (*guard, self.since(node, part.expression.every))
                    if part.expression.condition is not None:
                        guard = (*guard, ("", self.code(text_of(holds(part.expression.condition, names)[0]))))
                actions = tuple(action for part in path.parts for action in self.actions(part, node.label))
                # With `when`, a condition counts whether or not an event is there.
                events = [
                    part.expression.events
                    for part in path.parts
                    if part.expression.events and not part.expression.when
                ]
                if len(events) > 1:
                    raise Refused("two events for one transition")
                target = self.name[path.target]
                for event in events[0] if events else [None]:
                    if isinstance(event, After):
                        late = self.since(node, event.duration)
                        yield description.Transition("", target, (late, *guard), actions)
                    else:
                        name = event.name if isinstance(event, Raised) else FAILURE if event else ""
                        yield description.Transition(name, target, guard, actions)

    def since(self, node: ChartState, duration: int) -> tuple[str, str]:
        """The condition that a state was entered so long ago."""
        return "", f"bb['now'] - bb[{self.time(node.label)!r}] >= {duration}"

    def paths(self, way: Way) -> Iterator[_Path]:
        """A way through each of the branches behind it, in the order in which they are tried."""
        own = self.flat.transition(way.number)
        if self.chart.node(own.target).type is not StateType.CONDITION:
            yield _Path((own,))
        for branch in way.branches:
            for path in self.paths(branch):
                yield _Path((own, *path.parts))

    # ---- code --------------------------------------------------------------------------------

    def names(self, label: str) -> Names:
        """What is read where, in the region of a state."""
        region = self.flat.region_number[label]
        slots: dict[tuple[str, str | None], Expr] = {key: _kept(slot) for key, slot in self.slots.items()}
        variables: dict[str, Expr] = {item.name: _kept(f"var_{item.name}") for item in self.chart.variables}
        timer = partial(_timer_code, region)
        return Names(slots, variables, self.fields, self.constants, timer=timer, called=self.called)

    def called(self, call: Call, arguments: Sequence[Expr]) -> Expr:
        """The code of a call of the document's functions."""
        names = self.functions
        name = names.setdefault(function_key(call), (f"call_{len(names) + 1}", call.function.target))[0]
        return CallOf(Name(name), tuple(arguments))

    def actions(self, transition: Transition, label: str) -> Iterator[Action]:
        """What a transition out of a state does."""
        names = self.names(label)
        for action in transition.expression.actions:
            match action:
                case Assign(target=VariableValue() as target, value=value):
                    piece = evaluate(value, names)
                    text = f"bb['var_{target.name}'] = {text_of(converted(piece, value.type, target.type))}"
                case StartTimer(timer=timer, duration=value):
                    piece = evaluate(value, names)
                    text = f"{text_of(names.timer(timer))} = now + {text_of(piece.code)}"
                case _:
                    continue
            needs = text_of(all_of(piece.needs)) if piece.needs else ""
            yield "python", self.code(f"if {needs}: {text}" if needs else text)

    def code(self, text: str) -> str:
        """What the compiler has written, with the time where peers find it."""
        text = re.sub(r"(?<![.'\w])now\b(?!')", "bb['now']", text)
        used = {node.id for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Name)}
        strange = [
            name
            for name in used
            if not re.fullmatch(r"bb|m\w*\d+|call_\d+|len|abs|min|max|float|int|sqrt", name)
        ]
        if strange:
            raise Refused(f"what only its runtime has: {', '.join(sorted(strange))}")
        return text

    # ---- what is given -----------------------------------------------------------------------

    def step(self, given: Given) -> tuple[str, Change]:
        change: list[tuple[str, str]] = [("now", str(given.now))] if self.is_timed else []
        event = NO_EVENT
        for item in given.inputs:
            match item:
                case Sample(channel, message, sender):
                    places = [self.slots.get((channel, host)) for host in (None, sender)]
                    change += [(place, _text(message)) for place in places if place is not None]
                case Written(variable, value):
                    change.append((f"var_{variable}", _text(value)))
                case Completed(label):
                    change.append((f"done_{self.name[label]}", "True"))
                case Happened(name):
                    event = name
        return event, tuple(change)


def _refused(transition: Transition) -> Iterator[str]:
    """What of a transition peers are not told."""
    expression = transition.expression
    if transition.first:
        yield "cutting short (`[>`)"
    if transition.kind is TransitionKind.ON:
        yield "`on`"
    for action in expression.actions:
        if not isinstance(action, Assign | StartTimer):
            yield "a function as an action"
    for value in values_of(expression):
        for part in walk(value):
            match part:
                case Random():
                    yield "chance"
                case StateValue(question=question, state=state):
                    yield f"`{question}({state})`"
                case RoundValue(question=question, participant=participant):
                    yield f"`{question}({participant})`"
                case Outcome():
                    yield "how an activity has ended"
                case ParameterValue():
                    yield "parameters"


def _timers(chart: Statechart) -> Iterator[tuple[str, StartTimer | Expired]]:
    """Where timers are started and asked for: the sources of the transitions."""
    for item in chart.transitions:
        for action in item.expression.actions:
            if isinstance(action, StartTimer):
                yield item.source, action
        for value in values_of(item.expression):
            for part in walk(value):
                if isinstance(part, Expired):
                    yield item.source, part


def _kept(name: str) -> Expr:
    """Where something of a name is on the blackboard."""
    return Item(Name("bb"), Const(name))


def _timer_code(region: int, name: str) -> Expr:
    return _kept(_timer(region, name))


def _timer(region: int, name: str) -> str:
    """What says on the blackboard when a timer runs out."""
    return f"timer_{region}_{name}"


def identifier(node: ChartState) -> str:
    """A name that says which state it is, and is an identifier everywhere."""
    is_word = re.fullmatch(r"[A-Za-z]\w*", node.name) is not None
    return f"{node.name if is_word else node.type.lower()}_{node.label.replace('.', '_')}"


def _text(value: Any) -> str:
    """A value in Python that needs no class of ours."""
    if isinstance(value, IntEnum):
        return str(int(value))
    if is_dataclass(value) and not isinstance(value, type):
        members = ", ".join(f"{item.name}={_text(getattr(value, item.name))}" for item in fields(value))
        return f"Message({members})"
    if isinstance(value, tuple | list):
        return f"({''.join(f'{_text(item)}, ' for item in value)})"
    if isinstance(value, float) and not math.isfinite(value):
        return f"float('{value}')"
    return repr(value)


__all__ = ["NO_EVENT", "Refused", "described", "identifier", "one_by_one"]
