"""A running machine of whatever make, and what drives it through the steps of a behaviour."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import cycle, islice
from typing import Any, Literal

from benchmarks.behaviours.description import Behaviour, Change
from benchmarks.peers.adapters.python_code import changes, function


@dataclass(slots=True)
class Running:
    """A machine that has been started, with its blackboard.

    `changed` is called after flags were set, where the machine asks for that. `leaves` is there where the
    machine can say which basic states are active.
    """

    send: Callable[[str], object]
    bb: Any
    kind: Literal["dict", "attributes"] = "dict"
    changed: bool = False
    leaves: Callable[[], tuple[str, ...]] | None = None

    def value(self, name: str) -> Any:
        """A flag or counter."""
        return self.bb[name] if self.kind == "dict" else getattr(self.bb, name)


def blackboard(behaviour: Behaviour) -> dict[str, Any]:
    """A dictionary with all flags false and all counters 0."""
    return dict.fromkeys(behaviour.flags, False) | dict.fromkeys(behaviour.counters, 0)


def setters(running: Running, behaviour: Behaviour) -> list[Callable[[], object] | None]:
    """What sets the flags before each step; None where none is set."""

    def setter(change: Change) -> Callable[[], object] | None:
        if not change:
            return None
        lines = changes(change, running.kind)
        if running.changed:
            lines.append("bb.changed()")
        return function("", lines, running.bb)

    return [setter(change) for _, change in behaviour.steps]


def driver(running: Running, behaviour: Behaviour) -> Callable[[int], None]:
    """What drives a machine through the steps, all of them so many times."""
    send = running.send
    events = [event for event, _ in behaviour.steps]
    before = setters(running, behaviour)
    if not any(before):

        def drive(times: int) -> None:
            for _ in range(times):
                for event in events:
                    send(event)

        return drive
    assert all(before), "either all steps change something or none does"
    steps = list(zip(before, events, strict=True))

    def drive_with_changes(times: int) -> None:
        for _ in range(times):
            for change, event in steps:
                change()  # type: ignore[misc]
                send(event)

    return drive_with_changes


def follow(running: Running, behaviour: Behaviour, steps: int) -> dict[str, Any]:
    """Drive a machine through so many steps; its counters, and its active states after each if it can say."""
    leaves = []
    if running.leaves is not None:
        leaves.append(running.leaves())
    prepared = zip(setters(running, behaviour), (event for event, _ in behaviour.steps), strict=True)
    for change, event in islice(cycle(list(prepared)), steps):
        if change is not None:
            change()
        running.send(event)
        if running.leaves is not None:
            leaves.append(running.leaves())
    return {
        "counters": {counter: running.value(counter) for counter in behaviour.counters},
        "leaves": leaves or None,
    }
