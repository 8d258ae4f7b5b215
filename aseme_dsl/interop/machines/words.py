"""Words: the names, events, variables and expressions of a machine in the language."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import field

from aseme_dsl.interop.emf.identifiers import INITIAL, Names
from aseme_dsl.interop.machines import ecmascript
from aseme_dsl.interop.machines.ecmascript import Said, Untranslatable
from aseme_dsl.interop.machines.machine import (
    Assigning,
    Delaying,
    Doing,
    Machine,
    Move,
    Node,
    Raising,
    Shape,
    matches,
)
from aseme_dsl.interop.machines.places import is_wrapped
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.acl import PERFORMATIVES

_NO_EVENTS = (*PERFORMATIVES, *"error after lost ignores weight raise".split())
"""What means something else where an event stands."""
_WORD = re.compile(r"[A-Za-z_$][\w$]*")
_FUNCTIONS = "has age at mean expired random outcome done index read_messages write_messages send"


@dataclass(frozen=True, slots=True)
class Variable:
    """A variable of the role: its name there, its type and its first value."""

    name: str
    type: str
    initial: str
    is_computed: bool = False
    """Whether its first value is not known before the machine runs."""


@dataclass(slots=True)
class Words:
    """What the names of a machine are in the language."""

    machine: Machine
    states: dict[str, str] = field(default_factory=dict)
    """The names of states that can be asked about, by id."""
    events: dict[str, str] = field(default_factory=dict)
    variables: dict[str, Variable] = field(default_factory=dict)
    missing: dict[str, str] = field(default_factory=dict)
    """The variables that the language cannot hold, each with the reason."""

    def typed(self) -> dict[str, tuple[str, str]]:
        return {name: (item.name, item.type) for name, item in self.variables.items()}

    def condition(self, text: str) -> str:
        """A condition of the language. Raises Untranslatable."""
        return ecmascript.condition(text, self.typed(), self.states.get)

    def value(self, text: str) -> Said:
        return ecmascript.value(text, self.typed(), self.states.get)

    def awaited(self, descriptor: str) -> list[str]:
        """The events that a descriptor is for, of those that the machine names."""
        if self.machine.format == "XState" and not descriptor.endswith("*"):
            return [self.events[descriptor]] if descriptor in self.events else []
        return [name for event, name in self.events.items() if matches(descriptor, event)]


def is_of_engine(event: str) -> bool:
    """Whether an event comes from the engine of SCXML or XState alone."""
    return event.split(".")[0] in ("done", "error", "xstate")


def words_of(machine: Machine) -> Words:
    """The names of all states, events and variables."""
    names = Names({*_FUNCTIONS.split()})
    found = Words(machine)
    variables = Names({*_FUNCTIONS.split()})
    for datum in machine.data:
        variables.of(datum.name, "v")
    names.taken |= variables.taken
    for node in machine.nodes():
        if node is machine.root:
            continue
        if node.shape is not Shape.HISTORY:
            found.states[node.id] = names.of(node.id, "S")
    _type_variables(found, variables)
    events = Names({*_NO_EVENTS, *variables.taken})
    for event in dict.fromkeys(_events(machine)):
        found.events[event] = events.of(event, "event")
    for node in machine.nodes():
        finals = [child for child in node.children if child.shape is Shape.FINAL]
        if len(finals) > 1:
            for final in finals:
                found.states.pop(final.id, None)
    return found


def _events(machine: Machine) -> Iterator[str]:
    """The events that a machine names."""
    for node in machine.nodes():
        for move in node.moves:
            for descriptor in move.events:
                plain = descriptor.removesuffix("*").removesuffix(".")
                if plain and not is_of_engine(plain):
                    yield plain
    for doing in _doings(machine):
        if isinstance(doing, Raising | Delaying) and not is_of_engine(doing.event):
            yield doing.event


def _doings(machine: Machine) -> Iterator[Doing]:
    for node in machine.nodes():
        yield from node.entry
        yield from node.exit
        yield from node.initial_does
        for move in node.moves:
            yield from move.does


def _type_variables(found: Words, names: Names) -> None:
    """Find the type of each variable: that of its first value and of all that are assigned to it."""
    for datum in machine_data(found.machine):
        try:
            said = ecmascript.value(datum[1], {}, lambda _: None) if datum[1] else None
        except Untranslatable as reason:
            found.missing[datum[0]] = f"its first value: {reason}"
            continue
        kind, initial = ("", "") if said is None else (said.type, said.text)
        found.variables[datum[0]] = Variable(names.of(datum[0], "v"), kind, initial, said is None)
    first = {name: item.type for name, item in found.variables.items()}
    typed = {name: (item.name, item.type or "int") for name, item in found.variables.items()}
    waiting = {
        number: item
        for number, item in enumerate(_doings(found.machine))
        if isinstance(item, Assigning) and item.variable in first
    }
    using: dict[str, dict[int, Assigning]] = {}
    for number, item in waiting.items():
        for name in _WORD.findall(item.value):
            using.setdefault(name, {})[number] = item
    while waiting:  # a type changes at most twice
        item = waiting.pop(next(iter(waiting)))
        try:
            kind = ecmascript.value(item.value, typed, lambda _: "x").type
        except Untranslatable:
            continue
        name, known = item.variable, first[item.variable]
        if not known or (known == "int" and kind == "double"):
            first[name] = kind
            if typed[name][1] != kind:
                typed[name] = (typed[name][0], kind)
                waiting |= using.get(name, {})
    for name, kind in first.items():
        given = found.variables[name]
        held = kind or "int"
        initial = given.initial or INITIAL[held]
        if held == "double" and initial.lstrip("-").isdigit():
            initial = f"{initial}.0"
        found.variables[name] = Variable(given.name, held, initial, given.is_computed)


def machine_data(machine: Machine) -> list[tuple[str, str]]:
    """The data, each once: of two with one name the first."""
    return list({datum.name: (datum.name, datum.value) for datum in reversed(machine.data)}.values())[::-1]


def delayed(machine: Machine) -> dict[str, tuple[Node, Delaying]]:
    """The events that a state sends to itself a while after its entry, and that it alone waits for."""
    found: dict[str, tuple[Node, Delaying]] = {}
    for node in machine.nodes():
        for doing in node.entry:
            if isinstance(doing, Delaying) and not is_wrapped(node):
                found[doing.event] = (node, doing)
    sends = Counter(item.event for item in _doings(machine) if isinstance(item, Raising | Delaying))
    waits: dict[str, list[tuple[Node, Move]]] = {}
    for node in machine.nodes():
        for move in node.moves:
            for plain in {item.removesuffix("*").removesuffix(".") for item in move.events if item != "*"}:
                waits.setdefault(plain, []).append((node, move))
    for event, (node, _) in list(found.items()):
        waiting = [item for plain, items in waits.items() if matches(plain, event) for item in items]
        own = all(item is node and event in move.events for item, move in waiting)
        if sends[event] != 1 or not own:
            del found[event]
    return found


__all__ = ["Variable", "Words", "delayed", "is_of_engine", "words_of"]
