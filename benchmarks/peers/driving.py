"""A running machine of whatever make, and what drives it through the steps of a behaviour."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from itertools import cycle, islice
from typing import Any

from benchmarks.behaviours.description import Behaviour, Change
from benchmarks.peers.adapters.python_code import function, made


@dataclass(slots=True)
class Running:
    """A machine that has been started.

    `value` reads a flag or counter, `setter` makes what sets flags before an event; `leaves` is there where
    the machine can say which basic states are active. `told` says what is sent for an event, where that is
    not its name.
    """

    send: Callable[[str], object]
    value: Callable[[str], Any]
    setter: Callable[[Change], Callable[[], object]]
    leaves: Callable[[], tuple[str, ...]] | None = None
    told: Mapping[str, str] = field(default_factory=dict)


MakeMessage = Callable[[str, str, bool | str], object]
"""What makes a message, of its name, and of the name and value of its member."""


def with_dictionary(
    send: Callable[[str], object],
    bb: dict[str, Any],
    leaves: Callable[[], tuple[str, ...]] | None = None,
    make: MakeMessage = made,
    place: Callable[[str], str] = str,
) -> Running:
    """A machine whose blackboard is a dictionary. `place` says where a message is there, by its name."""

    def setter(change: Change) -> Callable[[], object]:
        values, known = _messages(change, make, place)
        return function("", [f"bb[{flag!r}] = {value}" for flag, value in values], bb, **known)

    return Running(send, bb.__getitem__, setter, leaves)


def with_attributes(
    send: Callable[[str], object],
    bb: Any,
    leaves: Callable[[], tuple[str, ...]] | None = None,
    further: str = "",
    make: MakeMessage = made,
    place: Callable[[str], str] = str,
) -> Running:
    """A machine whose blackboard is an object. `further` is done after flags were set.

    `place` says where a message is there, by its name.
    """

    def setter(change: Change) -> Callable[[], object]:
        values, known = _messages(change, make, place)
        lines = [f"bb.{flag} = {value}" for flag, value in values]
        return function("", [*lines, further] if further else lines, bb, **known)

    return Running(send, lambda name: getattr(bb, name), setter, leaves)


def _messages(
    change: Change, make: MakeMessage, place: Callable[[str], str]
) -> tuple[list[tuple[str, Any]], dict[str, object]]:
    """What is set, with names for the messages; and these. They are made before: they do not change."""
    values: list[tuple[str, Any]] = []
    known: dict[str, object] = {}
    for flag, value in change:
        message, dot, member = flag.partition(".")
        if dot:
            known[f"new_{message}"] = make(message, member, value)
            values.append((place(message), f"new_{message}"))
        else:
            values.append((flag, value))
    return values, known


def blackboard(behaviour: Behaviour) -> dict[str, Any]:
    """A dictionary with all flags false, all counters 0, and what else there is at first.

    It is made by a literal, as a person would write it: where the keys lie in it depends on how it is made.
    """
    first = dict.fromkeys(behaviour.flags, "False") | dict.fromkeys(behaviour.counters, "0")
    first |= dict.fromkeys([message for message, _ in behaviour.messages], "None")
    entries = ", ".join(f"{name!r}: {value}" for name, value in (first | dict(behaviour.values)).items())
    found: dict[str, Any] = function("", [f"return {{{entries}}}"], {})()
    return found


def driver(running: Running, behaviour: Behaviour) -> Callable[[int], None]:
    """What drives a machine through the steps, all of them so many times."""
    send, told = running.send, running.told
    events = [told.get(event, event) for event, _ in behaviour.steps]
    if not any(change for _, change in behaviour.steps):

        def drive(times: int) -> None:
            for _ in range(times):
                for event in events:
                    send(event)

        return drive
    changes = [running.setter(change) if change else None for _, change in behaviour.steps]
    steps = list(zip(changes, events, strict=True))

    def drive_with_changes(times: int) -> None:
        for _ in range(times):
            for change, event in steps:
                if change is not None:
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
        running.send(running.told.get(event, event))
        if running.leaves is not None:
            leaves.append(running.leaves())
    return {
        "counters": {counter: running.value(counter) for counter in behaviour.counters},
        "leaves": leaves or None,
    }
