"""The behaviours of the benchmarks: their text is the chart that is described, and ours does what it says."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.amola.expression import action_text, event_text, value_text
from aseme_dsl.amola.statechart import StateType
from benchmarks.behaviours.aseme import labels
from benchmarks.behaviours.catalogue import BEHAVIOURS, MANY
from benchmarks.behaviours.counts import Course, course_of
from benchmarks.behaviours.description import (
    Behaviour,
    State,
    Transition,
    as_json,
    entered,
    from_json,
    instrumented,
    left,
)
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
    ended, ends = dict(behaviour.ended), dict(behaviour.ends)
    states = {
        label[state.name]: (state.kind.upper(), state.name)
        for state in behaviour.states
        if state.name not in ended
    }
    nodes = {
        node.label: (str(node.type), node.name) for node in chart.states if node.type is not StateType.START
    }
    assert nodes == states

    described = [
        (
            label[state.name],
            label[way.target],
            "" if way.event in ends else way.event,
            _condition(way.guard),
        )
        for state in behaviour.states
        for way in state.transitions
        if ended.get(way.target) != state.name
    ]
    assert all(ends[way.event] == state.name for state, way in _driven_by(behaviour, ends))
    initial = {label[s.name]: label[s.children[0].name] for s in behaviour.states if s.kind == "or"}
    ways = []
    for transition in chart.transitions:
        written = transition.expression
        if chart.node(transition.source).type is StateType.START:
            assert not written.events
            assert written.condition is None
            assert initial.pop(transition.source.rpartition(".")[0]) == transition.target
        else:
            condition = "" if written.condition is None else value_text(written.condition)
            events = "".join(event_text(event) for event in written.events)
            ways.append((transition.source, transition.target, events, condition))
    assert not initial
    assert sorted(ways) == sorted(described)
    for state in behaviour.states:  # their order counts
        if state.name in {*ended, *ended.values()}:
            continue
        mine = [way for way in ways if way[0] == label[state.name]]
        assert mine == [way for way in described if way[0] == label[state.name]]

    entry = {
        label[state.name]: [_action(action) for action in state.entry]
        for state in behaviour.states
        if state.name not in ended
    }
    for transition in chart.transitions:
        done = [action_text(action) for action in transition.expression.actions]
        assert done == entry[transition.target], f"{transition.source} -> {transition.target}"


def _driven_by(behaviour: Behaviour, ends: dict[str, str]) -> Iterator[tuple[State, Transition]]:
    """What waits for the end of an activity."""
    return ((state, way) for state in behaviour.states for way in state.transitions if way.event in ends)


def _condition(guard: tuple[tuple[str, bool], ...]) -> str:
    named = [(re.sub(r"^ball\.", "seen.state.Ball.", flag), wanted) for flag, wanted in guard]
    return " && ".join(flag if wanted else f"!{flag}" for flag, wanted in named)


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


@pytest.mark.parametrize("form", ["typed", "dict", "send", "post", "send_dict", "post_dict", "agent"])
@pytest.mark.parametrize("name", SMALL)
def test_what_is_compiled_does_what_the_interpreter_does(name: str, form: str, folder: Path) -> None:
    behaviour = BEHAVIOURS[name]
    if behaviour.ends and form.startswith("post"):
        with pytest.raises(NotImplementedError, match="ends of activities are not posted"):
            compiled.running(behaviour, str(folder), form)
        return
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


def test_a_loop_waits_for_a_message_and_is_still_there_meanwhile() -> None:
    behaviour = BEHAVIOURS["loops"]
    first = next(
        place for place, (_, change) in enumerate(behaviour.steps) if change == (("ball.near", True),)
    )
    ended = next(place for place, (event, _) in enumerate(behaviour.steps) if event == "a1_done")
    assert ended + 1 < first
    leaves = [configuration[0] for configuration in course("loops").leaves]
    assert leaves[: first + 2] == [*["A1"] * (first + 1), "B1"]
    assert leaves[len(behaviour.steps)] == "A1"


def test_a_state_that_has_ended_is_entered_before_and_left_afterwards() -> None:
    told = {state.name: state for state in instrumented(BEHAVIOURS["loops"]).states}
    count = "count"
    assert (told["A1"].entry, told["A1"].exit) == (((count, entered("A1")),), ())
    assert (told["A1_ended"].entry, told["A1_ended"].exit) == ((), ((count, left("A1")),))
    assert told["A2"].exit == ((count, left("A2")),)


@pytest.mark.parametrize("number", MANY)
def test_a_machine_of_which_there_are_many_has_so_many_regions(number: int, folder: Path) -> None:
    behaviour = MANY[number]
    compiled_into(folder, [behaviour])
    (board, *_), make = compiled.instances(behaviour, 1, str(folder), "typed")
    made: Any = make(board)
    assert len([slot for slot in type(made).__slots__ if slot != "bb"]) == number


@pytest.mark.parametrize("name", SMALL)
def test_a_behaviour_survives_its_json(name: str) -> None:
    behaviour = instrumented(BEHAVIOURS[name])
    data = as_json(behaviour)
    assert as_json(from_json(data)) == data
