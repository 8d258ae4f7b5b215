"""sismic: a statechart with code in texts, and its interpreter."""

from __future__ import annotations

from collections.abc import Callable

from sismic.interpreter import Interpreter
from sismic.model import (
    BasicState,
    CompoundState,
    Event,
    OrthogonalState,
    Statechart,
    Transition,
)

from benchmarks.behaviours.description import Behaviour, State
from benchmarks.peers.adapters.python_code import FUNCTIONS, Blackboard, Send, condition, statements

DISTRIBUTION = "sismic"


def maker(behaviour: Behaviour, bb: Blackboard, form: str = "") -> Callable[[], Send]:
    """What makes a running interpreter of a statechart that is made once.

    In the form `unchecked`, it does not look for contracts, of which no behaviour has any.
    """
    is_unchecked = form == "unchecked"
    chart = Statechart(behaviour.name)

    def make(state: State, parent: str | None) -> None:
        entry = "\n".join(statements(state.entry)) or None
        exit_ = "\n".join(statements(state.exit)) or None
        match state.kind:
            case "basic":
                chart.add_state(BasicState(state.name, on_entry=entry, on_exit=exit_), parent)
            case "or":
                initial = state.children[0].name
                chart.add_state(CompoundState(state.name, initial, on_entry=entry, on_exit=exit_), parent)
            case "and":
                chart.add_state(OrthogonalState(state.name, on_entry=entry, on_exit=exit_), parent)
        for child in state.children:
            make(child, state.name)

    make(behaviour.root, None)
    for state in behaviour.states:
        # Two that are enabled at once are an error unless their priorities differ.
        for priority, way in enumerate(reversed(state.transitions)):
            guard = condition(way.guard) or None
            action = "\n".join(statements(way.actions)) or None
            event = way.event or None
            chart.add_transition(Transition(state.name, way.target, event, guard, action, priority=priority))
    events = {event: Event(event) for event, _ in behaviour.steps}

    def start() -> Send:
        interpreter = Interpreter(
            chart, ignore_contract=is_unchecked, initial_context={"bb": bb, **FUNCTIONS}
        )
        interpreter.execute()
        queue, execute = interpreter.queue, interpreter.execute

        def send(event: str) -> None:
            queue(events[event])
            execute()

        return send

    return start
