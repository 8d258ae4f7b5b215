"""The behaviours of the benchmarks: their text is the chart that is described, and ours does what it says."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

from aseme_dsl.amola.expression import action_text, event_text, value_text
from aseme_dsl.amola.statechart import NodeType
from benchmarks.behaviours.aseme import labels
from benchmarks.behaviours.catalogue import BEHAVIOURS
from benchmarks.behaviours.counts import Course, course_of
from benchmarks.behaviours.description import as_json, from_json, instrumented
from benchmarks.peers.adapters import by_hand, compiled
from benchmarks.peers.compiling import compiled_into, system_of
from benchmarks.peers.driving import follow
from benchmarks.peers.measuring import differences

SMALL = [name for name in BEHAVIOURS if name != "ring_1000"]
"""With the largest the interpreter takes seconds; the benchmark itself checks it."""
WRITTEN = [name for name in SMALL if not name.startswith("ring_")]
STEPS = 600
"""More than one turn of the inputs."""


@cache
def course(name: str) -> Course:
    return course_of(BEHAVIOURS[name], STEPS)


@pytest.mark.parametrize("name", BEHAVIOURS)
def test_the_text_is_the_chart_that_is_described(name: str) -> None:
    behaviour = BEHAVIOURS[name]
    chart = system_of(behaviour).statecharts[-1]
    label = labels(behaviour)
    states = {label[state.name]: (state.kind.upper(), state.name) for state in behaviour.states}
    nodes = {
        node.label: (str(node.type), node.name) for node in chart.nodes if node.type is not NodeType.START
    }
    assert nodes == states

    described = [
        (label[state.name], label[way.target], way.event, _condition(way.guard))
        for state in behaviour.states
        for way in state.transitions
    ]
    initial = {label[s.name]: label[s.children[0].name] for s in behaviour.states if s.kind == "or"}
    ways = []
    for transition in chart.transitions:
        written = transition.expression
        if chart.node(transition.source).type is NodeType.START:
            assert not written.events
            assert written.condition is None
            assert initial.pop(transition.source.rpartition(".")[0]) == transition.target
        else:
            condition = "" if written.condition is None else value_text(written.condition)
            (event,) = written.events
            ways.append((transition.source, transition.target, event_text(event), condition))
    assert not initial
    assert sorted(ways) == sorted(described)
    for state in behaviour.states:  # their order counts
        mine = [way for way in ways if way[0] == label[state.name]]
        assert mine == [way for way in described if way[0] == label[state.name]]

    entry = {label[state.name]: [_action(action) for action in state.entry] for state in behaviour.states}
    for transition in chart.transitions:
        done = [action_text(action) for action in transition.expression.actions]
        assert done == entry[transition.target], f"{transition.source} -> {transition.target}"


def _condition(guard: tuple[tuple[str, bool], ...]) -> str:
    return " && ".join(flag if wanted else f"!{flag}" for flag, wanted in guard)


def _action(action: tuple[object, ...]) -> str:
    if action[0] == "count":
        return f"{action[1]} = {action[1]} + 1"
    return f"{action[1]} = {str(action[2]).lower()}"


@pytest.mark.parametrize("form", ["dict", "slots"])
@pytest.mark.parametrize("name", WRITTEN)
def test_what_is_written_by_hand_does_what_the_interpreter_does(name: str, form: by_hand.Form) -> None:
    behaviour = BEHAVIOURS[name]
    found = follow(by_hand.running(behaviour, form), behaviour, STEPS)
    assert differences(found, behaviour, course(name)) == ""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("compiled")
    compiled_into(found, [BEHAVIOURS[name] for name in SMALL])
    return found


@pytest.mark.parametrize("form", ["typed", "dict", "send", "post", "agent"])
@pytest.mark.parametrize("name", SMALL)
def test_what_is_compiled_does_what_the_interpreter_does(name: str, form: str, folder: Path) -> None:
    behaviour = BEHAVIOURS[name]
    found = follow(compiled.running(behaviour, str(folder), form), behaviour, STEPS)
    assert differences(found, behaviour, course(name)) == ""


def test_a_difference_is_found() -> None:
    behaviour = BEHAVIOURS["player"]
    found = follow(by_hand.running(behaviour), behaviour, STEPS)
    wrong = found | {"counters": found["counters"] | {"entered_Stand": 2}}
    assert differences(wrong, behaviour, course("player")) == "entered_Stand is 2, not 1"
    leaves = [*found["leaves"][:7], ("Stand",), *found["leaves"][8:]]
    assert differences(found | {"leaves": leaves}, behaviour, course("player")).startswith("after step 7")


def test_the_player_comes_into_every_state() -> None:
    assert min(course_of(BEHAVIOURS["player"], 1024).entries.values()) > 0


@pytest.mark.parametrize("name", SMALL)
def test_a_behaviour_survives_its_json(name: str) -> None:
    behaviour = instrumented(BEHAVIOURS[name])
    data = as_json(behaviour)
    assert as_json(from_json(data)) == data
