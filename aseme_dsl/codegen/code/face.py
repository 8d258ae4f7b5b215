"""What both classes of a statechart call things: registers, constants, leaves, transitions for people."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import partial
from typing import assert_never

from aseme_dsl.amola.expression import RoundValue, StateValue
from aseme_dsl.amola.meant import states_meant
from aseme_dsl.amola.messages import Kind, Type
from aseme_dsl.amola.statechart import State, StateType, Variable, transition_text
from aseme_dsl.codegen.code.tree import (
    FALSE,
    TRUE,
    Const,
    Expr,
    Field,
    Group,
    all_of,
    any_of,
    compared,
    own,
    own_call,
    within,
)
from aseme_dsl.codegen.code.values import Names, constant_names, in_brackets
from aseme_dsl.codegen.place import place
from aseme_dsl.codegen.program.moves import completing_ends
from aseme_dsl.codegen.program.program import Program

_PYTHON = {
    Kind.BOOL: "bool",
    Kind.INT: "int",
    Kind.DOUBLE: "float",
    Kind.STRING: "str",
    Kind.BYTES: "bytes",
    Kind.DURATION: "int",
    Kind.AGENT: "str | None",
}


class Identifiers:
    """Python names for keys, each its own."""

    def __init__(self) -> None:
        self._taken: set[str] = set()
        self._names: dict[object, str] = {}

    def name(self, key: object, wish: str) -> str:
        if key not in self._names:
            base = re.sub(r"\W", "_", wish)
            name, number = base, 2
            while name in self._taken:
                name, number = f"{base}_{number}", number + 1
            self._taken.add(name)
            self._names[key] = name
        return self._names[key]


class Face:
    """The names of a statechart's class, and what of messages and enums it turned out to use."""

    def __init__(self, program: Program, taken: Iterable[str]) -> None:
        """`taken` are names that mean something in the module, besides those of messages and enums."""
        self.system = system = program.system
        self.chart = chart = program.chart
        self.flat = program.flat
        self.uses = program.uses
        self.registers = program.registers
        self.identifiers = Identifiers()
        self.document_types = {item.name for item in system.messages} | {item.name for item in system.enums}
        self.constants = constant_names(system.enums, {*self.document_types, *taken})
        self.enums: set[tuple[str, str]] = set()
        self.messages: set[str] = set()
        self.fields = {
            (message.name, item.name): (item.label == "optional", item.type.name)
            for message in system.messages
            for item in message.fields
        }
        self.variables = {variable.name: variable for variable in chart.variables}

    def time(self, label: str) -> Field:
        """When a state was entered."""
        return own(self.identifiers.name(("time", label), f"t_{label}"))

    def count(self, label: str) -> Field:
        """How often a state was entered."""
        return own(self.identifiers.name(("count", label), f"n_{label}"))

    def place(self, number: int) -> str:
        """A transition for people: from where it leads where, what was written, and where."""
        transition = self.chart.transitions[number]
        text = transition_text(transition)
        target = self.chart.node(transition.target)
        named = f" {target.name}" if target.name != target.label else ""
        targets = f"({', '.join(transition.into)})" if transition.into else f"{transition.target}{named}"
        ends = f"{transition.source} -> {targets}"
        return "  ".join(part for part in (ends, text, f"({place(transition.span)})") if part)

    def python(self, kind: Type) -> str:
        """A type as the module annotates it."""
        if kind.kind in (Kind.ENUM, Kind.MESSAGE):
            self.messages.add(kind.name)
            return kind.name
        if kind.element is not None:
            return f"tuple[{self.python(kind.element)}, ...]"
        return _PYTHON[kind.kind]

    def held(self, kind: Type) -> str:
        """A type of a variable as the module annotates it."""
        return f"{self.python(kind)} | None" if kind.kind is Kind.MESSAGE else self.python(kind)

    def bounded(self, name: str, code: Expr) -> Expr:
        """What a variable gets: code that raises where the value is outside of its bounds."""
        bounds, length = self.variables[name].bounds, self.variables[name].length
        if length is not None:
            return own_call("short", Const(name), Const(length), code)
        if bounds is None:
            return code
        return own_call("inside", Const(name), Const(bounds.least), Const(bounds.most), code)

    def is_bounded(self, name: str) -> bool:
        """Whether a write to a variable may fail for its value."""
        return self.variables[name].is_limited

    def initial(self, variable: Variable) -> str:
        """What a variable holds at first."""
        value = variable.initial.value
        if variable.type.begins_unset:
            return "None"
        if variable.type.kind is Kind.LIST:
            return "()"
        if variable.type.kind is Kind.ENUM:
            constant = str(value)
            self.enums.add((variable.type.name, constant))
            return self.constants[variable.type.name, constant]
        return repr(float(value)) if variable.type.kind is Kind.DOUBLE else repr(value)

    def leaf_title(self, leaf: State, number: int) -> str:
        """A leaf for people: its label, what it is, and for an activity whether it still runs."""
        if leaf.type is not StateType.BASIC:
            return f"{leaf.label} {leaf.type.value}"
        return f"{leaf.label} {leaf.name} {'runs' if number == self.flat.leaf[leaf.label] else 'is complete'}"

    def at(self, region: int, number: int) -> Expr:
        """The test whether a region has a number."""
        return compared(own(f"r{region}"), "==", Const(number))

    def complete(self, leaf: State, number: int) -> Expr:
        """Whether a leaf is complete: known for the number, or a condition for an AND."""
        match leaf.type:
            case StateType.START:
                return TRUE
            case StateType.BASIC:
                return Const(number != self.flat.leaf[leaf.label])
            case StateType.AND:
                ends = completing_ends(self.flat, leaf)
                if ends is None:
                    return FALSE
                return all_of(self.at(region, self.flat.leaf[end]) for region, end in ends)
            case StateType.END | StateType.OR | StateType.CONDITION:
                return FALSE
            case _:
                assert_never(leaf.type)

    def asked_by(self, number: int, names: Names) -> None:
        """Let the names of states in the expression of a transition mean what they mean there."""
        self.asked_at(self.flat.transition(number).source, names)

    def asked_at(self, source: str, names: Names) -> None:
        """Let the names of states mean what they mean in an expression that belongs to a state."""
        names.outcomes = partial(self.registers.asked_of, source)
        names.states = partial(self.about_states, source)
        names.rounds = partial(self.about_rounds, source)

    def about_rounds(self, source: str, value: RoundValue) -> Expr:
        """The code of `invited(q)`, `answered(q)` or `all_answered(q)` in a transition out of `source`."""
        return own_call(value.question, Const(self.chart.branch_of(source)), Const(value.participant))

    def about_states(self, source: str, value: StateValue) -> Expr:
        """The code of `in(T)`, `done(T)` or `count(T)` in a transition out of `source`."""
        meant = states_meant(self.chart, source, value.state)
        if value.question == "count":
            return self.count(meant[0].label)
        ask = self.is_active if value.question == "in" else self.is_done
        found = [code for node in meant if (code := ask(node)) is not None]
        code = any_of(map(in_brackets, found))
        return Group(code) if len(found) > 1 else code

    def is_active(self, node: State) -> Expr | None:
        """Whether a state is active; None if it never is."""
        region = self.flat.region_number[node.label]
        first, last = self.flat.range[node.label]
        return self.at(region, first) if first == last else within(first, own(f"r{region}"), last)

    def is_done(self, node: State) -> Expr | None:
        """Whether a state is active and complete; None if it never is."""
        region = self.flat.region_number[node.label]
        if node.type is StateType.OR:
            end = self.chart.end_of(node.label)
            return None if end is None else self.at(region, self.flat.leaf[end.label])
        number = self.flat.leaf[node.label]
        if node.type is StateType.BASIC:
            return self.at(region, number + 1)
        complete = self.complete(node, number)
        return None if complete == FALSE else all_of((self.at(region, number), complete))


def natural(name: str) -> list[tuple[int, str]]:
    """Orders b2 before b10."""
    parts = re.split(r"(\d+)", name)
    return [(int(part), "") if part.isdigit() else (-1, part) for part in parts]


def docstring(text: str) -> str:
    """A text as it stands in a docstring."""
    return text.replace("\\", "\\\\").replace('"', "'")


def key_of(label: str) -> str:
    """A label as a part of a name."""
    return label.replace(".", "_")
