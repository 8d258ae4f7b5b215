"""What this project makes of a behaviour: the plain class in its forms, and the agent's class."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

from benchmarks.behaviours.aseme import camel, channel, labels, names
from benchmarks.behaviours.description import Behaviour, Change
from benchmarks.peers.driving import Running, with_attributes, with_dictionary


def running(behaviour: Behaviour, folder: str, form: str) -> Running:
    """A machine that has been started.

    Raises:
        NotImplementedError: there is no such form.
    """
    if form == "agent":
        return agent(behaviour, folder)
    kind = class_of(behaviour, folder, form)
    # One that is tracked is told of changes; that pays where they are rarer than events.
    module = sys.modules[kind.__module__]
    board = vars(module)[f"{kind.__name__}Blackboard"]
    is_tracked = hasattr(board, "changed") and not any(change for _, change in behaviour.steps)
    chart = kind(board(tracked=True) if is_tracked else board())
    leaves = leaves_of(behaviour, chart.configuration)
    is_machine = form.startswith(("send", "post"))
    if is_machine:
        from aseme_dsl.runtime.plain.machine import Machine

        machine = Machine(chart)
        machine.start()
        if not behaviour.ends:
            send = machine.send if form.startswith("send") else machine.post
        elif form.startswith("send"):
            send = machine.done
        else:
            raise NotImplementedError("ends of activities are not posted")
    else:
        chart.start()
        send = chart.done if behaviour.ends else chart.send

    def make(message: str, member: str, value: object) -> object:
        # A compiled module knows the class that it has imported first.
        return getattr(module, camel(message))(**{member: value})

    if isinstance(chart.bb, dict):
        running = with_dictionary(send, chart.bb, leaves, make, slot)
    else:
        running = with_attributes(send, chart.bb, leaves, "bb.changed()" if is_tracked else "", make, slot)
    running.told = told(behaviour)
    return running


def instances(
    behaviour: Behaviour, number: int, folder: str, form: str
) -> tuple[list[Any], Callable[[Any], object]]:
    """Blackboards, and what makes a machine with one.

    Raises:
        NotImplementedError: there is no such form, or it has no blackboard of its own.
    """
    if form == "agent":
        raise NotImplementedError("an agent's class keeps its blackboards")
    machine = class_of(behaviour, folder, form)
    if form.startswith(("send", "post")):
        from aseme_dsl.runtime.plain.machine import Machine

        def make(bb: Any) -> object:
            made = Machine(machine(bb))
            made.start()
            return made

    else:

        def make(bb: Any) -> object:
            made = machine(bb)
            made.start()
            return made

    return [machine().bb for _ in range(number)], make


MODULES = {
    "dict": "dict",
    "typed": "typed",
    "send": "typed",
    "post": "typed",
    "send_dict": "dict",
    "post_dict": "dict",
    "native": "native",
}
"""The folder with the class of each form."""


def slot(message: str) -> str:
    """Where a message is on a typed blackboard."""
    return channel(message).replace(".", "_")


def class_of(behaviour: Behaviour, folder: str, form: str) -> type[Any]:
    """The plain class of a behaviour.

    Raises:
        NotImplementedError: it was not built.
    """
    if not (Path(folder) / behaviour.name / MODULES[form]).exists():
        raise NotImplementedError(f"there is no {form} build")
    package = package_of(behaviour, folder, MODULES[form])
    module = importlib.import_module(f"{package.__name__}.{behaviour.name}")
    found: type[Any] = getattr(module, camel(behaviour.name))
    return found


def agent(behaviour: Behaviour, folder: str) -> Running:
    """The agent's class with its whole step: inputs, blackboards, effects."""
    from aseme_dsl.runtime.chart.inputs import Completed, Happened, Input, Sample, Written

    package = package_of(behaviour, folder, "agent")
    chart = package.CHARTS[behaviour.name]("agent")
    chart.step(0, ())
    now = 0
    inputs: list[Input] = []
    events = {event: Happened(event) for event, _ in behaviour.steps}
    ends = told(behaviour)
    tokens = {label: chart.RUNNING[label][1] for label in ends.values()}

    def send(event: str) -> None:
        nonlocal now
        now += 1
        inputs.append(events[event])
        chart.step(now, inputs)
        inputs.clear()

    def done(state: str) -> None:
        nonlocal now
        now += 1
        # With the token of its last start, which an activity gets with its name.
        inputs.append(Completed(state, getattr(chart, tokens[state], 0)))
        chart.step(now, inputs)
        inputs.clear()

    def setter(change: Change) -> Callable[[], object]:
        written = [Written(flag, value) for flag, value in change if "." not in flag]
        if len(written) == len(change):
            return lambda: inputs.extend(written)
        messages = sys.modules[f"{package.__name__}.messages"]
        new = []
        for flag, value in change:
            message, dot, member = flag.partition(".")
            if dot:
                new.append((channel(message), getattr(messages, camel(message))(**{member: value})))

        def arrive() -> None:
            inputs.extend(written)
            inputs.extend(Sample(place, message, "camera", now, ("camera", now)) for place, message in new)

        return arrive

    leaves = leaves_of(behaviour, chart.configuration)
    return Running(done if ends else send, chart.variable, setter, leaves, ends)


def told(behaviour: Behaviour) -> dict[str, str]:
    """What ours is told when an activity ends: the label of its state, by the event that stands for it."""
    label = labels(behaviour) if behaviour.ends else {}
    return {event: label[state] for event, state in behaviour.ends}


def leaves_of(
    behaviour: Behaviour, configuration: Callable[[], tuple[str, ...]]
) -> Callable[[], tuple[str, ...]]:
    """What says which basic states are active, of a configuration of labels."""

    @cache
    def called() -> dict[str, str]:  # when it is asked for: to make a machine does not include it
        basic = {state.name for state in behaviour.states if state.kind == "basic"}
        return {label: name for label, name in names(behaviour).items() if name in basic}

    return lambda: tuple(called()[label] for label in configuration() if label in called())


def package_of(behaviour: Behaviour, folder: str, form: str) -> ModuleType:
    """The generated package of a behaviour in one form."""
    root = Path(folder) / behaviour.name / form
    name = camel(behaviour.name)
    for module in [module for module in sys.modules if module == name or module.startswith(f"{name}.")]:
        del sys.modules[module]
    sys.path.insert(0, str(root))
    try:
        importlib.invalidate_caches()
        return importlib.import_module(name)
    finally:
        sys.path.remove(str(root))
