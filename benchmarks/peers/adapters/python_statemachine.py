"""python-statemachine: a class made from a definition."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from statemachine.io import create_machine_class_from_definition

from benchmarks.behaviours.description import Behaviour, State
from benchmarks.peers.adapters.python_code import Blackboard, Send, function, guard_function, statements

DISTRIBUTION = "python-statemachine"


def maker(behaviour: Behaviour, bb: Blackboard) -> Callable[[], Send]:
    """What makes a running machine of a class that is made once."""

    def definition(state: State, is_initial: bool) -> dict[str, Any]:
        found: dict[str, Any] = {}
        if is_initial:
            found["initial"] = True
        if state.entry:
            found["enter"] = function("", statements(state.entry), bb)
        if state.exit:
            found["exit"] = function("", statements(state.exit), bb)
        if state.kind == "and":
            found["parallel"] = True
        if state.children:
            found["states"] = {
                child.name: definition(child, state.kind == "or" and child is state.children[0])
                for child in state.children
            }
        on: dict[str | None, list[dict[str, Any]]] = {}
        for way in state.transitions:
            item: dict[str, Any] = {"target": way.target}
            if way.guard:
                item["cond"] = guard_function("", way.guard, bb)
            if way.actions:
                item["on"] = function("", statements(way.actions), bb)
            on.setdefault(way.event or None, []).append(item)
        if on:
            found["on"] = on
        return found

    root = behaviour.root
    made = create_machine_class_from_definition(
        "Machine",
        {child.name: definition(child, child is root.children[0]) for child in root.children},
        validate_trap_states=False,
        validate_disconnected_states=False,
    )
    return lambda: made().send
