"""SCXML that is exported and read again is the same machine: states, transitions, data and what is done.

A statechart goes out as a machine (see `interop/export/machine.py`), and that machine is compared. Identity
is meant literally but for this: conditions and values are texts, and ids of delayed events mean the events.
What the language cannot take over (an event with content, a choice of several assignments) is only known to
be there. `test_round_trip` compares what the machines do.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from aseme_dsl.interop.export.lowering import lowered
from aseme_dsl.interop.export.machine import (
    ALWAYS,
    NEVER,
    Act,
    Const,
    Datum,
    Emit,
    If,
    Machine,
    Raise,
    Schedule,
    Set,
    Shape,
    Unschedule,
    Vertex,
)
from aseme_dsl.interop.export.script import EcmaScript
from aseme_dsl.interop.export.scxml import FINISHED, scxml
from aseme_dsl.interop.machines import machine as foreign
from aseme_dsl.interop.machines.scxml import read_scxml
from aseme_dsl.source import Source
from tests.interop.exports.taming import tamed
from tests.interop.exports.test_schema import PACED
from tests.oracle.charts import text
from tests.oracle.choices import Choices
from tests.support.generated import system_of

EXAMPLES = int(os.environ.get("ASEME_ROUND_TRIPS", "25"))
SCRIPT = EcmaScript()
_SHAPES = {Shape.PARALLEL: "parallel", Shape.FINAL: "final"}
Done = tuple[str, ...]


def went_out(machine: Machine) -> dict[str, object]:
    """All that a machine says."""
    root = machine.root
    around = {
        "id": "",
        "shape": "state",
        "initial": (root.id,),
        "entry": [],
        "exit": [],
        "moves": [],
        "inside": [root.id, FINISHED],
    }
    end = {**around, "id": FINISHED, "shape": "final", "initial": (), "inside": []}
    scheduled = {act.event for act in _flat(_all(machine)) if isinstance(act, Schedule)}
    states = [around, *(_vertex(machine, item, scheduled) for item in root.inside()), end]
    data = machine.data or (Datum("asemec", True, ""),)
    return {
        "name": machine.name,
        "data": [(item.name, _text(SCRIPT.constant(item.initial))) for item in data],
        "states": states,
    }


def _all(machine: Machine) -> Iterator[Act]:
    for vertex in machine.root.inside():
        yield from (*vertex.entry, *vertex.exit)
        for move in vertex.moves:
            yield from move.acts
    for handler in machine.handlers:
        yield from handler.acts


def _flat(acts: Iterable[Act]) -> Iterator[Act]:
    for act in acts:
        yield act
        if isinstance(act, If):
            yield from _flat((*act.then, *act.otherwise))


def _vertex(machine: Machine, vertex: Vertex, scheduled: set[str]) -> dict[str, object]:
    moves = [
        (
            (),
            move.targets,
            "" if move.condition == ALWAYS else _text(SCRIPT.condition(move.condition)),
            [*_acts(move.acts, scheduled)],
        )
        for move in vertex.moves
    ]
    if vertex is machine.root:
        if machine.ended != NEVER:
            moves.append(((), (FINISHED,), _text(SCRIPT.condition(machine.ended)), []))
        moves += [((item.event,), (), "", [*_acts(item.acts, scheduled)]) for item in machine.handlers]
    return {
        "id": vertex.id,
        "shape": _SHAPES.get(vertex.shape, "state"),
        "initial": (vertex.children[0].id,) if vertex.shape is Shape.COMPOUND else (),
        "entry": [*_acts(vertex.entry, scheduled)],
        "exit": [*_acts(vertex.exit, scheduled)],
        "moves": moves,
        "inside": [child.id for child in vertex.children],
    }


def _acts(acts: Iterable[Act], scheduled: set[str]) -> Iterator[Done]:
    for act in acts:
        match act:
            case Set():
                yield "assign", act.name, _text(SCRIPT.term(act.value))
            case Raise():
                yield "raise", act.event
            case Schedule(delay=Const(value=int() as delay)):
                yield "cancel", act.event
                yield "later", act.event, str(delay)
            case Schedule():
                yield "cancel", act.event
                yield ("other",)
            case Unschedule():
                if act.event in scheduled:
                    yield "cancel", act.event
            case Emit(parameters=()):
                yield "raise", act.event
            case If(then=(Set() as one,), otherwise=()):
                condition, value = SCRIPT.condition(act.condition), SCRIPT.term(one.value)
                yield "assign", one.name, _text(f"({condition}) ? ({value}) : ({one.name})")
            case Emit() | If():
                yield ("other",)


def came_home(machine: foreign.Machine, document: str) -> dict[str, object]:
    """The same of a machine that was read."""
    events = dict(reversed(found) for found in re.findall(r'<send event="([^"]+)" id="([^"]+)"', document))
    return {
        "name": machine.name,
        "data": [(item.name, item.value) for item in machine.data],
        "states": [_node(node, events) for node in machine.nodes()],
    }


def _node(node: foreign.Node, events: dict[str, str]) -> dict[str, object]:
    return {
        "id": node.id if node.is_named else "",
        "shape": node.shape.value,
        "initial": node.initial,
        "entry": [*_doings(node.entry, events)],
        "exit": [*_doings(node.exit, events)],
        "moves": [
            (move.events, move.targets, move.guard, [*_doings(move.does, events)]) for move in node.moves
        ],
        "inside": [child.id for child in node.children],
    }


def _doings(items: Iterable[foreign.Doing], events: dict[str, str]) -> Iterator[Done]:
    last: Done = ()
    for item in items:
        done: Done
        match item:
            case foreign.Assigning():
                done = "assign", item.variable, item.value
            case foreign.Raising():
                done = "raise", item.event
            case foreign.Delaying():
                done = "later", item.event, str(item.delay)
            case foreign.Cancelling():
                done = "cancel", events[item.id]
            case foreign.Noting() | foreign.Other():
                done = ("other",)
        if done[0] != "cancel" or done != last:  # one event may have several ids
            yield done
        last = done


def _text(said: str) -> str:
    return " ".join(said.split())


def check(source: str, *, tame: bool = False) -> int:
    """How many machines of a system came home as they went out."""
    system = tamed(system_of(source)) if tame else system_of(source)
    same = 0
    for chart in system.statecharts:
        machine, refused = lowered(system, chart)
        if not refused:
            document = scxml(machine)
            assert came_home(read_scxml(Source("m.scxml", document)), document) == went_out(machine)
            same += 1
    return same


@settings(
    max_examples=EXAMPLES,
    deadline=None,
    suppress_health_check=list(HealthCheck),
    phases=(Phase.explicit, Phase.generate),  # a smaller seed is not a smaller chart
)
@given(seed=st.integers(0, 10**9))
def test_what_is_read_back_is_what_went_out(seed: int) -> None:
    check(text(Choices(seed)), tame=True)


@pytest.mark.parametrize("path", ["testbehavior", "kouretes"])
def test_charts_of_the_papers_are_read_back(path: str) -> None:
    file = Path(__file__).parents[3] / f"tests/acceptance/{path}.aseme"
    assert check(file.read_text("utf-8")) > 0


def test_several_places_that_start_one_timer_are_read_back() -> None:
    assert check(PACED) == 1


def test_another_machine_is_noticed() -> None:
    system = system_of(PACED)
    machine, _ = lowered(system, system.iacs[0])
    document = scxml(machine)
    for written, instead in (
        ('target="end_0_3"', 'target="end_0_2_4"'),
        ('delay="3s"', 'delay="4s"'),
        ('expr="true"', 'expr="false"'),
        ('<final id="asemec', '<state id="asemec'),
        (' amola:type="END"', ""),
        ('initial="start_0_2_1"', 'initial="Dark_0_2_2"'),
    ):
        changed = document.replace(written, instead, 1)
        assert changed != document
        assert came_home(read_scxml(Source("m.scxml", changed)), changed) != went_out(machine)
