"""A running machine of whatever make, and what drives it through the steps of a behaviour."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import cycle, islice
from typing import Any

from benchmarks.behaviours.description import Behaviour, Change
from benchmarks.peers.adapters.python_code import function


@dataclass(slots=True)
class Running:
    """A machine that has been started.

    `value` reads a flag or counter, `setter` makes what sets flags before an event; `leaves` is there where
    the machine can say which basic states are active.
    """

    send: Callable[[str], object]
    value: Callable[[str], Any]
    setter: Callable[[Change], Callable[[], object]]
    leaves: Callable[[], tuple[str, ...]] | None = None


def with_dictionary(
    send: Callable[[str], object],
    bb: dict[str, Any],
    leaves: Callable[[], tuple[str, ...]] | None = None,
    further: str = "",
) -> Running:
    """A machine whose blackboard is a dictionary. `further` is done after flags were set."""

    def setter(change: Change) -> Callable[[], object]:
        lines = [f"bb[{flag!r}] = {value}" for flag, value in change]
        return function("", [*lines, further] if further else lines, bb)

    return Running(send, bb.__getitem__, setter, leaves)


def with_attributes(
    send: Callable[[str], object],
    bb: Any,
    leaves: Callable[[], tuple[str, ...]] | None = None,
    further: str = "",
) -> Running:
    """A machine whose blackboard is an object. `further` is done after flags were set."""

    def setter(change: Change) -> Callable[[], object]:
        lines = [f"bb.{flag} = {value}" for flag, value in change]
        return function("", [*lines, further] if further else lines, bb)

    return Running(send, lambda name: getattr(bb, name), setter, leaves)


def blackboard(behaviour: Behaviour) -> dict[str, Any]:
    """A dictionary with all flags false, all counters 0, and what else there is at first.

    It is made by a literal, as a person would write it: where the keys lie in it depends on how it is made.
    """
    first = dict.fromkeys(behaviour.flags, "False") | dict.fromkeys(behaviour.counters, "0")
    entries = ", ".join(f"{name!r}: {value}" for name, value in (first | dict(behaviour.values)).items())
    found: dict[str, Any] = function("", [f"return {{{entries}}}"], {})()
    return found


def driver(running: Running, behaviour: Behaviour) -> Callable[[int], None]:
    """What drives a machine through the steps, all of them so many times."""
    send = running.send
    events = [event for event, _ in behaviour.steps]
    if not any(change for _, change in behaviour.steps):

        def drive(times: int) -> None:
            for _ in range(times):
                for event in events:
                    send(event)

        return drive
    steps = [(running.setter(change), event) for event, change in behaviour.steps]

    def drive_with_changes(times: int) -> None:
        for _ in range(times):
            for change, event in steps:
                change()
                send(event)

    return drive_with_changes


def follow(running: Running, behaviour: Behaviour, steps: int) -> dict[str, Any]:
    """Drive a machine through so many steps; its counters, and its active states after each if it can say."""
    leaves = [] if running.leaves is None else [running.leaves()]
    prepared = [(running.setter(change) if change else None, event) for event, change in behaviour.steps]
    for change, event in islice(cycle(prepared), steps):
        if change is not None:
            change()
        running.send(event)
        if running.leaves is not None:
            leaves.append(running.leaves())
    return {
        "counters": {counter: running.value(counter) for counter in behaviour.counters},
        "leaves": leaves or None,
    }
