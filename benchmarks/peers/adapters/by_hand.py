"""The behaviours as they are written by hand."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from typing import Any

from benchmarks.behaviours.description import Behaviour
from benchmarks.peers.driving import Running, blackboard, with_dictionary

MODULES = {"deep_leaf": "deep", "deep_top": "deep"}
"""The module of a behaviour, where it is called otherwise."""


def machine_of(behaviour: Behaviour) -> type[Any]:
    """The class that was written for a behaviour.

    Raises:
        NotImplementedError: nobody writes that by hand.
    """
    if behaviour.name.startswith("ring_"):
        raise NotImplementedError("nobody writes a thousand states by hand")
    name = MODULES.get(behaviour.name, behaviour.name)
    found: type[Any] = importlib.import_module(f"benchmarks.behaviours.by_hand.{name}").Machine
    return found


def running(behaviour: Behaviour) -> Running:
    """A machine that has been started."""
    bb = blackboard(behaviour)
    machine = machine_of(behaviour)(bb)
    machine.start()
    return with_dictionary(machine.send, bb, machine.leaves)


def instances(behaviour: Behaviour, number: int) -> tuple[list[dict[str, Any]], Callable[[Any], object]]:
    """Blackboards, and what makes a machine with one."""
    machine = machine_of(behaviour)

    def make(bb: dict[str, Any]) -> object:
        made = machine(bb)
        made.start()
        return made

    return [blackboard(behaviour) for _ in range(number)], make
