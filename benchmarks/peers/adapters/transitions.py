"""transitions: its hierarchical machine, or the flat one where there is no hierarchy."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from transitions import Machine
from transitions.extensions import HierarchicalMachine
from transitions.extensions.nesting import NestedState

from benchmarks.behaviours.description import Behaviour, State, walk
from benchmarks.peers.adapters.python_code import Blackboard, Send, function, guard_function, statements

DISTRIBUTION = "transitions"

NestedState.separator = "."


AT_ONCE = "at_once"
"""The trigger of transitions that wait for no event."""


class Model:
    """What the machine is about: it gets the state and the triggers."""


def maker(behaviour: Behaviour, bb: Blackboard) -> Callable[[], Send]:
    """What makes a running model of a machine that is made once."""
    is_flat = all(state.kind == "basic" for state in behaviour.root.children)
    path: dict[str, str] = {}

    def definition(state: State, around: str) -> dict[str, Any]:
        path[state.name] = around + state.name
        found: dict[str, Any] = {"name": state.name}
        if state.entry:
            found["on_enter"] = [function("*_", statements(state.entry), bb)]
        if state.exit:
            found["on_exit"] = [function("*_", statements(state.exit), bb)]
        children = [definition(child, f"{path[state.name]}.") for child in state.children]
        if state.kind == "or":
            found["children"] = children
            found["initial"] = state.children[0].name
        elif state.kind == "and":
            found["parallel"] = children
        return found

    root = behaviour.root
    states = [definition(child, "") for child in root.children]
    ways: list[dict[str, Any]] = []
    for state in behaviour.states[1:]:
        for way in state.transitions:
            item: dict[str, Any] = {
                "trigger": way.event or AT_ONCE,
                "source": path[state.name],
                "dest": path[way.target],
            }
            if way.guard:
                item["conditions"] = [guard_function("*_", way.guard, bb)]
            if way.actions:
                item["before"] = [function("*_", statements(way.actions), bb)]
            ways.append(item)
    at_once = {AT_ONCE} if any(way["trigger"] == AT_ONCE for way in ways) else set()
    # An event that no active state waits for is an error in a nested parallel state, even if it is to be
    # ignored: so there is a way for it that is never open.
    for child in root.children if any(state.kind == "and" for state in behaviour.states) else ():
        for event in sorted({*(event for event, _ in behaviour.steps), *at_once} - always_awaited(child)):
            never = {"trigger": event, "source": child.name, "dest": child.name}
            ways.append(never | {"conditions": [lambda *_: False]})
    # The initial state is entered with its actions only by a transition: from a state before all others.
    states.append({"name": "before"})
    ways.append({"trigger": "begin", "source": "before", "dest": root.children[0].name})
    machine = (Machine if is_flat else HierarchicalMachine)(
        model=None,
        states=states,
        transitions=ways,
        initial="before",
        auto_transitions=False,
        ignore_invalid_triggers=True,
    )
    events = {event for event, _ in behaviour.steps}

    def make() -> Send:
        model = Model()
        machine.add_model(model)
        model.begin()  # type: ignore[attr-defined]
        triggers = {event: getattr(model, event, nothing) for event in events}
        if at_once:
            # It has no transitions without an event: a program asks again until there is none left.
            go_on = getattr(model, AT_ONCE)

            def send(event: str) -> None:
                triggers[event]()
                while go_on():
                    pass

            while go_on():
                pass
            return send
        if len(triggers) == 1:
            (trigger,) = triggers.values()
            return lambda event: trigger()
        return lambda event: triggers[event]()

    return make


def nothing() -> bool:
    """What an event does that no transition waits for."""
    return False


def always_awaited(state: State) -> set[str]:
    """The events for which one region of a parallel state has a transition in each of its states."""
    found: set[str] = set()
    for region in state.children:
        waiting = [{way.event for way in item.transitions} for item in walk(region) if item.kind == "basic"]
        found |= set.intersection(*waiting)
    return found
