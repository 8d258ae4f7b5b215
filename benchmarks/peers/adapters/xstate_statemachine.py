"""xstate-statemachine: XState's form of a machine, and its synchronous interpreter."""

from __future__ import annotations

import logging
from collections.abc import Callable
from typing import Any

from xstate_statemachine import MachineLogic, SyncInterpreter, create_machine

from benchmarks.behaviours.description import Behaviour, State
from benchmarks.peers.adapters.python_code import Blackboard, Send, function, guard_function, statements

DISTRIBUTION = "xstate-statemachine"


def maker(behaviour: Behaviour, bb: Blackboard) -> Callable[[], Send]:
    """What makes a running interpreter of a machine that is made once."""
    actions: dict[str, Callable[..., Any]] = {}
    guards: dict[str, Callable[..., bool]] = {}

    def definition(state: State) -> dict[str, Any]:
        found: dict[str, Any] = {"id": state.name}
        for key, listed in (("entry", state.entry), ("exit", state.exit)):
            if listed:
                name = f"{key}_{state.name}"
                actions[name] = function("interpreter, context, event, action", statements(listed), bb)
                found[key] = [name]
        if state.kind == "or":
            found["initial"] = state.children[0].name
        elif state.kind == "and":
            found["type"] = "parallel"
        if state.children:
            found["states"] = {child.name: definition(child) for child in state.children}
        on: dict[str, list[dict[str, Any]]] = {}
        for number, way in enumerate(state.transitions):
            item: dict[str, Any] = {"target": f"#{way.target}", "reenter": True}
            if way.guard:
                name = f"guard_{state.name}_{number}"
                guards[name] = guard_function("context, event", way.guard, bb)
                item["guard"] = name
            if way.actions:
                name = f"do_{state.name}_{number}"
                actions[name] = function("interpreter, context, event, action", statements(way.actions), bb)
                item["actions"] = [name]
            on.setdefault(way.event, []).append(item)
        at_once = on.pop("", None)
        if at_once:
            found["always"] = at_once
        if on:
            found["on"] = on
        return found

    config = definition(behaviour.root)
    machine = create_machine(config, logic=MachineLogic(actions, guards))
    return lambda: SyncInterpreter(machine).start().send


logging.disable()
