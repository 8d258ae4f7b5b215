"""What the faces of a generated chart share: names, questions about states, values that are computed.

A face is a class that runs a statechart: the one of an agent (`step.py`), and the one of a program that knows
no agents (`plain.py`).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import assert_never

from aseme_dsl.amola.expression import StateValue, Value
from aseme_dsl.amola.meant import states_meant
from aseme_dsl.amola.messages import Kind, Type
from aseme_dsl.amola.statechart import Node, NodeType, Statechart, Variable, transition_text
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.expressions import NOTHING, Known, Names, Piece, constant_names, evaluate, holds
from aseme_dsl.codegen.flat import FlatChart
from aseme_dsl.codegen.place import place

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


@dataclass
class Method:
    """The lines of a method being written, with the names it uses."""

    names: Names
    lines: list[str] = field(default_factory=list)

    def add(self, depth: int, *lines: str) -> None:
        self.lines += ["    " * depth + line for line in lines]


class Face:
    """A statechart on its way to a class: what both faces ask and write."""

    def __init__(self, system: System, chart: Statechart, flat: FlatChart, taken: Iterable[str]) -> None:
        """`taken` are names that mean something in the module, besides those of messages and enums."""
        self.system = system
        self.chart = chart
        self.flat = flat
        self.identifiers = Identifiers()
        self.document_types = {item.name for item in system.messages} | {item.name for item in system.enums}
        self.constants = constant_names(system.enums, {*self.document_types, *taken})
        self.enums: set[tuple[str, str]] = set()
        self.messages: set[str] = set()
        self.methods: list[list[str]] = []
        self.tables: list[str] = []
        self.guards: set[int] = set()
        self.fields = {
            (message.name, item.name): (item.label == "optional", item.type.name)
            for message in system.messages
            for item in message.fields
        }
        self.variables = {variable.name: variable for variable in chart.variables}

    def _names(self, region: int, prefix: str = "") -> Names:
        """The names that the code of a region may use; locals get the prefix."""
        raise NotImplementedError

    def _method(self, signature: str, document: str, method: Method) -> None:
        """Write a method, with only those locals that its lines use."""
        raise NotImplementedError

    def _held(self, region: int) -> tuple[str, str]:
        """What the method of a condition is given: as its parameters, and as its arguments."""
        raise NotImplementedError

    def _time(self, label: str) -> str:
        return self.identifiers.name(("time", label), f"t_{label}")

    def _count(self, label: str) -> str:
        return self.identifiers.name(("count", label), f"n_{label}")

    def _place(self, number: int) -> str:
        transition = self.chart.transitions[number]
        text = transition_text(transition)
        target = self.chart.node(transition.target)
        named = f" {target.name}" if target.name != target.label else ""
        ends = f"{transition.source} -> {transition.target}{named}"
        return "  ".join(part for part in (ends, text, f"({place(transition.span)})") if part)

    def _python(self, kind: Type) -> str:
        if kind.kind in (Kind.ENUM, Kind.MESSAGE):
            self.messages.add(kind.name)
            return kind.name
        return _PYTHON[kind.kind]

    def _initial(self, variable: Variable) -> str:
        value = variable.initial.value
        if variable.type.kind is Kind.AGENT:
            return "None"
        if variable.type.kind is Kind.ENUM:
            constant = str(value)
            self.enums.add((variable.type.name, constant))
            return self.constants[variable.type.name, constant]
        return repr(float(value)) if variable.type.kind is Kind.DOUBLE else repr(value)

    def _leaf_title(self, leaf: Node, number: int) -> str:
        """A leaf for people: its label, what it is, and for an activity whether it still runs."""
        if leaf.type is not NodeType.BASIC:
            return f"{leaf.label} {leaf.type.value}"
        return f"{leaf.label} {leaf.name} {'runs' if number == self.flat.leaf[leaf.label] else 'is complete'}"

    def _leaf_complete(self, leaf: Node, number: int) -> str | bool:
        """Whether a leaf is complete: known for the number, or a condition for an AND."""
        match leaf.type:
            case NodeType.START:
                return True
            case NodeType.BASIC:
                return number != self.flat.leaf[leaf.label]
            case NodeType.AND:
                ends = []
                for region in self.flat.regions_of(leaf.label):
                    end = self.chart.end_of(region.label)
                    if end is None:
                        return False
                    ends.append(f"self.r{region.number} == {self.flat.leaf[end.label]}")
                return " and ".join(ends)
            case NodeType.END | NodeType.OR | NodeType.CONDITION:
                return False
            case _:
                assert_never(leaf.type)

    def _key(self, label: str) -> str:
        return label.replace(".", "_")

    def _guard(self, method: Method, region: int, number: int, condition: Value) -> str:
        """The condition in line, or as a method of its own where evaluating it may raise."""
        before = method.names.may_raise
        method.names.may_raise = False
        self._asked_by(number, method.names)
        code, _ = holds(condition, method.names)
        raises, method.names.may_raise = method.names.may_raise, before
        if not raises:
            return code
        if number not in self.guards:
            self.guards.add(number)
            guard = Method(self._names(region))
            self._asked_by(number, guard.names)
            code, _ = holds(condition, guard.names)
            guard.add(2, "try:", f"    return {code}", "except Exception as error:")
            guard.add(3, f"return self.fault({number}, error)")
            parameters, _ = self._held(region)
            signature = f"_holds_{number}(self, {parameters}) -> bool"
            self._method(signature, f"The condition of {docstring(self._place(number))}.", guard)
        return f"self._holds_{number}({self._held(region)[1]})"

    def _asked_by(self, number: int, names: Names) -> None:
        """Let the names of states in the expression of a transition mean what they mean there."""
        self._asked_at(self.flat.transition(number).source, names)

    def _asked_at(self, source: str, names: Names) -> None:
        names.outcomes = partial(self.flat.asked_of, source)
        names.states = partial(self._about_states, source)

    def _about_states(self, source: str, value: StateValue) -> str:
        """The code of `in(T)`, `done(T)` or `count(T)` in a transition out of `source`."""
        meant = states_meant(self.chart, source, value.state)
        if value.question == "count":
            return f"self.{self._count(meant[0].label)}"
        ask = self._is_active if value.question == "in" else self._is_done
        found = [code for node in meant if (code := ask(node)) is not None]
        code = " or ".join(f"({code})" if " and " in code else code for code in found) or "False"
        return f"({code})" if len(found) > 1 else code

    def _is_active(self, node: Node) -> str | None:
        region = self.flat.region_number[node.label]
        first, last = self.flat.range[node.label]
        return f"self.r{region} == {first}" if first == last else f"{first} <= self.r{region} <= {last}"

    def _is_done(self, node: Node) -> str | None:
        region = self.flat.region_number[node.label]
        if node.type is NodeType.OR:
            end = self.chart.end_of(node.label)
            return None if end is None else f"self.r{region} == {self.flat.leaf[end.label]}"
        number = self.flat.leaf[node.label]
        if node.type is NodeType.BASIC:
            return f"self.r{region} == {number + 1}"
        complete = self._leaf_complete(node, number)
        return None if complete is False else f"self.r{region} == {number} and {complete}"

    def _computed(
        self,
        method: Method,
        depth: int,
        number: int,
        values: Sequence[Value],
        use: Callable[..., list[str]],
    ) -> None:
        """Compute values and use them; an absent or raising one is a fault."""
        before, method.names.may_raise = method.names.may_raise, False
        self._asked_by(number, method.names)
        pieces: list[Piece] = []
        known: Known = NOTHING
        for value in values:
            pieces.append(evaluate(value, method.names, known))
            known = pieces[-1].known
        needs = [need for piece in pieces for need in piece.needs]
        raises, method.names.may_raise = method.names.may_raise, before
        if raises:
            method.add(depth, "try:")
            depth += 1
        if needs:
            method.add(depth, f"if {' and '.join(needs)}:")
            method.add(depth + 1, *use(*pieces))
            method.add(depth, "else:", f"    self.fault({number}, ABSENT)")
        else:
            method.add(depth, *use(*pieces))
        if raises:
            method.add(depth - 1, "except Exception as error:", f"    self.fault({number}, error)")


def natural(attribute: tuple[str, str, str | None]) -> list[tuple[int, str]]:
    """Orders b2 before b10."""
    parts = re.split(r"(\d+)", attribute[0])
    return [(int(part), "") if part.isdigit() else (-1, part) for part in parts]


def docstring(text: str) -> str:
    """A text as it stands in a docstring."""
    return text.replace("\\", "\\\\").replace('"', "'")


def mail_name(number: int) -> str:
    """The local name of what a transition takes."""
    return f"mail_{number}"
