"""Names of a step class: its attributes, the slots of its boards, and the methods that are written."""

from __future__ import annotations

from dataclasses import field

from aseme_dsl.amola.expression import (
    After,
)
from aseme_dsl.amola.statechart import State
from aseme_dsl.codegen.code.face import Face
from aseme_dsl.codegen.code.python import text_of
from aseme_dsl.codegen.code.tree import (
    NOW,
    Expr,
    Field,
    Name,
    inside,
    own,
)
from aseme_dsl.codegen.code.values import Names
from aseme_dsl.codegen.program.program import Program
from aseme_dsl.records import dataclass


@dataclass
class Method:
    """The lines of a method being written for a region, and the names that these use."""

    names: Names
    region: int
    lines: list[str] = field(default_factory=list)
    used: set[str] = field(default_factory=set)

    def add(self, depth: int, *lines: str) -> None:
        """Add lines, indented so many times."""
        self.lines += ["    " * depth + line for line in lines]

    def take(self, depth: int, other: Method) -> None:
        """Add the lines of another one, indented so many times more."""
        self.add(depth, *other.lines)
        self.used |= other.used

    def code(self, expr: Expr) -> str:
        """An expression as it is written here."""
        self.used |= {part.name for part in inside(expr) if isinstance(part, Name)}
        return text_of(expr)

    @property
    def b(self) -> str:
        """The local that is the blackboard of the region."""
        return self.code(Name("b"))

    @property
    def now(self) -> str:
        """The local that is the time of the step."""
        return self.code(NOW)


class StepNames(Face):
    """What a step class calls what it has, and what it turned out to use."""

    def __init__(self, program: Program, class_name: str) -> None:
        super().__init__(program, (class_name,))
        self.class_name = class_name
        self.history = program.history
        self.published: set[str] = set()
        self.methods: list[list[str]] = []
        self.tables: list[str] = []
        self.guards: set[int] = set()
        self.used: set[str] = set()
        """What the module needs of the runtime and of Python's library."""
        self._known: set[str] = set()
        self.slots = {region.number: self._region_slots(region.number) for region in self.flat.regions}
        self.seen = {
            region: {message: Field(Name("b"), slot) for message, slot in slots.items()}
            for region, slots in self.slots.items()
        }

    def _region_slots(self, region: int) -> dict[tuple[str, str | None], str]:
        found: dict[tuple[str, str | None], str] = {}
        for member in self.uses.members.get(region, ()):
            channel, host = str(member.channel), member.host
            wish = f"{host}_{channel}" if host else channel
            found[channel, host] = self.identifiers.name((channel, host), wish)
        return found

    def variable(self, name: str, region: int) -> str:
        """The attribute that holds a variable for the expressions of a region."""
        plain = name.replace("@", "_")
        regions = self.uses.variable_regions[name]
        if len(regions) < 2:
            return self.identifiers.name(("variable", name), f"v_{plain}")
        return self.identifiers.name(("variable", name, region), f"v{region}_{plain}")

    def copies(self, name: str) -> list[str]:
        """All attributes that hold a variable."""
        regions = self.uses.variable_regions[name]
        return list(dict.fromkeys(self.variable(name, region) for region in regions or (0,)))

    def kept(self, node: State) -> str:
        """What is remembered of a composite that may be resumed."""
        return self.identifiers.name(("kept", node.label), f"m_{node.label}")

    def mark(self, number: int) -> str:
        """What an `on` transition has seen when it was taken last."""
        return self.identifiers.name(("mark", number), f"o_{number}")

    def past(self, number: int) -> str:
        """The longest `after` by which an `on` transition was taken."""
        return self.identifiers.name(("past", number), f"a_{number}")

    def has_mark(self, number: int) -> bool:
        """Whether a transition may be taken without an event, and must know what it has seen."""
        expression = self.chart.transitions[number].expression
        return expression.when or not expression.events

    def has_time(self, number: int) -> bool:
        """Whether a transition waits for a time."""
        return any(isinstance(event, After) for event in self.chart.transitions[number].expression.events)

    def _names(self, region: int, prefix: str) -> Names:
        variables: dict[str, Expr] = {name: own(self.variable(name, region)) for name in self.variables}
        names = Names(self.seen[region], variables, self.fields, self.constants, self.enums, prefix=prefix)
        names.message = self._message
        return names

    def _message(self, message: str) -> Expr:
        """The class of a message that is made."""
        self.published.add(message)
        return Name(message)

    def time_name(self, label: str) -> str:
        """The attribute with the time at which a state was entered."""
        return self.time(label).name

    def count_name(self, label: str) -> str:
        """The attribute with the number of entries of a state."""
        return self.count(label).name

    # ---- methods ---------------------------------------------------------------------------

    def writing(self, region: int, prefix: str = "") -> Method:
        """The lines of a method for a region; its locals get the prefix."""
        return Method(self._names(region, prefix), region)

    def is_new(self, name: str) -> bool:
        """Whether this is the first time that a method is asked for."""
        known = name in self._known
        self._known.add(name)
        return not known

    def method(self, signature: str, document: str, method: Method, *, has_board: bool = False) -> None:
        """Write a method with those locals that its lines use; `has_board`: it is given the blackboard."""
        lines = [f"    def {signature}:", f'        """{document}"""']
        if "b" in method.used and not has_board:
            lines.append(f"        b = self.b{method.region}")
        self.methods.append([*lines, *method.lines])
        self.used |= method.used


class Part:
    """A part of a step class that is written, with what all of them ask."""

    def __init__(self, names: StepNames) -> None:
        self.names = names
        self.flat = names.flat
        self.history = names.history
        self.chart = names.chart
        self.uses = names.uses
        self.registers = names.registers


def mail_name(number: int) -> str:
    """The local name of what a transition takes."""
    return f"mail_{number}"


__all__ = ["Method", "Part", "StepNames", "mail_name"]
