"""statechart 0.4.2: states and transitions as objects."""

from __future__ import annotations

from collections.abc import Callable

import statechart as library

from benchmarks.behaviours.description import Behaviour, State
from benchmarks.peers.adapters.python_code import Blackboard, Send, function, guard_function, statements

DISTRIBUTION = "statechart"

AT_ONCE = "at_once"
"""The event of transitions that wait for none."""


def maker(behaviour: Behaviour, bb: Blackboard) -> Callable[[], Send]:
    """What makes a running statechart; nothing of it can be made once for all."""

    def start() -> Send:
        chart = library.Statechart(name=behaviour.name)
        made = {behaviour.root.name: chart}

        def make(state: State, context: object) -> None:
            kinds = {"basic": library.State, "or": library.CompositeState, "and": library.ConcurrentState}
            item = made[state.name] = kinds[state.kind](name=state.name, context=context)
            if state.entry:
                item.entry = function("event", statements(state.entry), bb)
            if state.exit:
                item.exit = function("event", statements(state.exit), bb)
            for child in state.children:
                make(child, item)

        for child in behaviour.root.children:
            make(child, chart)
        for state in behaviour.states:
            if state.kind == "or":
                initial = library.InitialState(made[state.name])
                library.Transition(start=initial, end=made[state.children[0].name])
            # One with a guard is put before those that are there: the last one is tried first.
            for way in reversed(state.transitions):
                guard = guard_function("event", way.guard, bb) if way.guard else None
                action = function("event", statements(way.actions), bb) if way.actions else None
                ends = made[state.name], made[way.target]
                library.Transition(*ends, event=way.event or AT_ONCE, guard=guard, action=action)
        chart.start()
        events = {event: library.Event(event) for event, _ in behaviour.steps}
        dispatch = chart.dispatch
        if any(not way.event for state in behaviour.states for way in state.transitions):
            # Its transitions without an event are for states that have ended: so a program asks, as long as
            # something moves.
            go_on = library.Event(AT_ONCE)

            def send(event: str) -> None:
                dispatch(events[event])
                while dispatch(go_on):
                    pass

            while dispatch(go_on):
                pass
            return send
        return lambda event: dispatch(events[event])

    return start
