"""What this project makes of a behaviour: the plain class in its forms, and the agent's class."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

from benchmarks.behaviours.aseme import camel, labels
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
    board = vars(sys.modules[kind.__module__])[f"{kind.__name__}Blackboard"]
    is_tracked = hasattr(board, "changed") and not any(change for _, change in behaviour.steps)
    chart = kind(board(tracked=True) if is_tracked else board())
    leaves = leaves_of(behaviour, chart.configuration)
    send = chart.send
    if form in ("send", "post"):
        from aseme_dsl.runtime.machine import Machine

        machine = Machine(chart)
        machine.start()
        send = machine.send if form == "send" else machine.post
    else:
        chart.start()
    if form == "dict":
        return with_dictionary(send, chart.bb, leaves)
    return with_attributes(send, chart.bb, leaves, "bb.changed()" if is_tracked else "")


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
    if form in ("send", "post"):
        from aseme_dsl.runtime.machine import Machine

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


MODULES = {"dict": "dict", "typed": "typed", "send": "typed", "post": "typed", "native": "native"}
"""The folder with the class of each form."""


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
    from aseme_dsl.runtime.inputs import Happened, Input, Written

    chart = package_of(behaviour, folder, "agent").CHARTS[behaviour.name]("agent")
    chart.step(0, ())
    now = 0
    inputs: list[Input] = []
    events = {event: Happened(event) for event, _ in behaviour.steps}

    def send(event: str) -> None:
        nonlocal now
        now += 1
        inputs.append(events[event])
        chart.step(now, inputs)
        inputs.clear()

    def setter(change: Change) -> Callable[[], object]:
        written = [Written(flag, value) for flag, value in change]
        return lambda: inputs.extend(written)

    return Running(send, chart.variable, setter, leaves_of(behaviour, chart.configuration))


def leaves_of(
    behaviour: Behaviour, configuration: Callable[[], tuple[str, ...]]
) -> Callable[[], tuple[str, ...]]:
    """What says which basic states are active, of a configuration of labels."""
    basic = {state.name for state in behaviour.states if state.kind == "basic"}
    names = {label: name for name, label in labels(behaviour).items() if name in basic}
    return lambda: tuple(names[label] for label in configuration() if label in names)


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
