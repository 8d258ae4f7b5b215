"""Names of a plain class: its slots, what is on its blackboard, and the methods that are written."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeAlias

from aseme_dsl.amola.expression import Call, Failed, Random
from aseme_dsl.amola.messages import Kind, Type
from aseme_dsl.amola.statechart import State, StateType
from aseme_dsl.codegen.code.face import Face, Identifiers
from aseme_dsl.codegen.code.tree import (
    FALSE,
    NOW,
    TRUE,
    Block,
    CallOf,
    Const,
    Expr,
    Field,
    Item,
    Name,
    Negated,
    Set,
    Statement,
    all_of,
    compared,
    names_in,
    own,
    within,
)
from aseme_dsl.codegen.code.values import Names, function_key, may_fail
from aseme_dsl.codegen.plain.options import TAKEN, PlainOptions
from aseme_dsl.codegen.program.program import EventProgram
from aseme_dsl.records import dataclass

BB = Name("bb")

Parameter: TypeAlias = tuple[str, str]
"""What a method is given: its name, and its type with what stands for it otherwise."""


@dataclass(frozen=True, slots=True)
class Method:
    """A method that is written: its name and parameters, what it gives, what it is for, what it does."""

    name: str
    gives: str
    document: str
    body: Block
    parameters: tuple[Parameter, ...] = ()


class PlainNames(Face):
    """The names in a plain class, each by a method for one kind of thing, and the names that are used."""

    def __init__(
        self, program: EventProgram, class_name: str, board_name: str, options: PlainOptions
    ) -> None:
        super().__init__(program, {*TAKEN, class_name, f"Watched{class_name}", board_name})
        self.program = program
        self.class_name = class_name
        self.board_name = board_name
        self.options = options
        self.rests = program.rests
        self.events = program.events
        self.following = program.following
        self.copied = program.copied
        self.truths = frozenset(
            region.number
            for region in self.flat.regions
            if region.size == 2 and len(self.flat.leaves(region.number)) == 2
        )
        """The regions with two leaves, of which neither has two numbers."""
        self.used: set[str] = {"Plain", "Any"} if options.mapping else {"Plain"}
        """What the module needs of Python's library and of the runtime, besides what its steps name."""
        self.methods: list[Method] = []
        """The methods that steps call, in the order in which they were needed."""
        self.tables: list[str] = []
        self.function_names = Identifiers()
        for name in ("_EVENTS", "_PLACES"):
            self.function_names.name(("reserved", name), name)
        self.functions: dict[str, tuple[str, str, str]] = {}
        self.board_names = Identifiers()
        # The blackboard of the watched class is that of the other one, which may have these.
        for name in ("tracked", "changed") if options.gates or options.watched else ():
            self.board_names.name(("reserved", name), name)
        for name in self.variables:
            self.on_board(name)
        chart = program.chart
        self.is_timed = bool(self.registers.timed or self.registers.timers)
        self.may_fail = options.watched or any(
            isinstance(event, Failed) for item in chart.transitions for event in item.expression.events
        )
        self.has_chance = any(isinstance(value, Random) for _, value in chart.values())
        self.faults = any(may_fail(value) for _, value in chart.values()) or any(
            variable.is_limited for variable in chart.variables
        )
        self.seen = {key: self.place_on_board(slot) for key, (slot, _) in self.message_slots().items()}
        self._variables = {region.number: self._variables_of(region.number) for region in self.flat.regions}

    # ---- the blackboard --------------------------------------------------------------------

    def on_board(self, name: str) -> str:
        """What a variable is called on the blackboard: as in the document, if that is free."""
        return self.board_names.name(("variable", name), name)

    def renamed(self) -> dict[str, str]:
        """The variables that are called otherwise on the blackboard."""
        return {name: called for name in self.variables if (called := self.on_board(name)) != name}

    def place_on_board(self, name: str) -> Expr:
        """Where something of that name is."""
        return Item(BB, Const(name)) if self.options.mapping else Field(BB, name)

    def variable_on_board(self, name: str) -> Expr:
        """Where a variable is."""
        return self.place_on_board(self.on_board(name))

    def message_slots(self) -> dict[tuple[str, str | None], tuple[str, str]]:
        """The places of the messages that conditions read, by channel and sender, with their types."""
        found: dict[tuple[str, str | None], tuple[str, str]] = {}
        for members in self.uses.members.values():
            for member in members:
                key = str(member.channel), member.host
                wish = f"{member.host}_{key[0]}" if member.host else key[0]
                found[key] = self.board_names.name(key, wish), member.channel.message
        return found

    def board_type(self) -> str:
        """The type of the blackboard."""
        return "dict[str, Any]" if self.options.mapping else self.board_name

    # ---- slots -----------------------------------------------------------------------------

    def copy(self, name: str, region: int) -> Field:
        """The copy that a region has of a variable during a step."""
        return own(self.identifiers.name(("variable", name, region), f"v{region}_{name}"))

    def time(self, label: str) -> Field:
        """When a state was entered; states of which one is active at most have one place for that."""
        region = self.flat.region_number[label]
        timed, outermost = self.registers.timed, self.flat.regions[region].label
        deep = sum(around.label in timed for around in self.flat.around(label))
        if label != outermost and outermost in timed:
            deep += 1
        return own(self.identifiers.name(("time", region, deep), f"t{region}_{deep}"))

    def timer(self, region: int, timer: str) -> Field:
        """When a timer of a region runs out."""
        return own(self.identifiers.name(("timer", region, timer), f"timer{region}_{timer}"))

    def outcome(self, labels: tuple[str, ...]) -> Field:
        """How the activity of the last of some states has ended."""
        number = self.registers.outcomes.index(labels)
        name = f"outcome{number}_{self.chart.node(labels[0]).name}"
        return own(self.identifiers.name(("outcome", labels), name))

    def outcomes_of(self, label: str) -> list[Field]:
        """Where is kept how the activity of a state has ended."""
        return [self.outcome(labels) for labels in self.registers.outcomes if label in labels]

    # ---- values ----------------------------------------------------------------------------

    def _variables_of(self, region: int) -> dict[str, Expr]:
        return {
            name: self.copy(name, region)
            if region in self.copied.get(name, ())
            else self.variable_on_board(name)
            for name in self.variables
        }

    def variable(self, name: str, region: int) -> Expr:
        """Where a region finds a variable."""
        return self._variables[region][name]

    def names(self, region: int, prefix: str = "") -> Names:
        """What the values of a region may name; locals get the prefix."""
        variables = self._variables[region]
        names = Names(self.seen, variables, self.fields, self.constants, self.enums, prefix=prefix)
        names.called = self._called
        names.timer = lambda timer: self.timer(region, timer)
        names.last_outcome = self.outcome
        names.message = self._message
        return names

    def _called(self, call: Call, arguments: Sequence[Expr]) -> Expr:
        """The call of a function of the document, which stands under a name of its own in the module."""
        key = function_key(call)
        name = self.function_names.name(key, f"_{call.function.name}")
        self.functions[name] = (call.function.target, key, str(call.type))
        return CallOf(Name(name), tuple(arguments))

    def _message(self, message: str) -> Expr:
        """The class of a message that is made."""
        self.messages.add(message)
        name = self.imported(message)
        self.used.add(name)
        return Name(name)

    def python(self, kind: Type) -> str:
        name = super().python(kind)
        return self.imported(name) if kind.kind in (Kind.ENUM, Kind.MESSAGE) else name

    def imported(self, name: str) -> str:
        """What a message or an enum is called in the module."""
        called = name
        while called in TAKEN or (called != name and called in self.document_types):
            called += "_"
        return called

    # ---- where it stands -------------------------------------------------------------------

    def last(self, leaf: State) -> int:
        """The last number of a leaf."""
        return self.flat.leaf[leaf.label] + self.rests.width(leaf) - 1

    def title(self, leaf: State, number: int) -> str:
        """A leaf for people; of an activity that is not waited for there is nothing more to say."""
        if self.rests.width(leaf) == 1 and leaf.type is StateType.BASIC:
            return f"{leaf.label} {leaf.name}"
        return self.leaf_title(leaf, number)

    def at(self, region: int, number: int) -> Expr:
        name = own(f"r{region}")
        if region in self.truths:
            return name if number else Negated(name)
        return compared(name, "==", Const(number))

    def complete(self, leaf: State, number: int) -> Expr:
        if leaf.type is StateType.AND:
            found = super().complete(leaf, number)
            if found == FALSE:
                return FALSE
            parts = (
                self.at(region.number, self.flat.leaf[end.label])
                for region in self.flat.regions_of(leaf.label)
                if (end := self.chart.end_of(region.label)) is not None and region.size > 1
            )
            return all_of(parts)
        return super().complete(leaf, number)

    def is_active(self, node: State) -> Expr | None:
        """Whether a state is active: what is left keeps its number, so what is around it counts."""
        found = self.flat.range.get(node.label)
        if found is None:
            return None
        return self.is_inside(self.flat.region_number[node.label], *found)

    def is_inside(self, region: int, first: int, last: int) -> Expr:
        """Whether a region, and those around it, are at one of these numbers."""
        tests: list[Expr] = []
        around: int | None = region
        while around is not None:
            if first == last and self.flat.regions[around].size > 1:
                tests.append(self.at(around, first))
            elif last - first + 1 < self.flat.regions[around].size:
                tests.append(within(first, own(f"r{around}"), last))
            parent = self.chart.node(self.flat.regions[around].label).parent
            around = self.flat.enclosing(around)
            if parent is not None:
                first = last = self.flat.leaf[parent]
        return all_of(reversed(tests))

    def is_done(self, node: State) -> Expr | None:
        region = self.flat.region_number[node.label]
        if node.type is StateType.OR:
            end = self.chart.end_of(node.label)
            return None if end is None else self.is_active(end)
        number = self.flat.leaf.get(node.label)
        if number is None:
            return None
        if node.type is StateType.BASIC:
            return self.is_inside(region, number + 1, number + 1)
        complete = self.complete(node, number)
        if complete == FALSE:
            return None
        tests = (self.is_inside(region, number, number), complete)
        return all_of(test for test in tests if test != TRUE)

    # ---- methods ---------------------------------------------------------------------------

    def method(
        self,
        name: str,
        gives: str,
        document: str,
        body: Iterable[Statement],
        parameters: tuple[Parameter, ...] = (),
    ) -> None:
        """Write a method that steps call; what it is given it need not fetch."""
        given = frozenset(parameter for parameter, _ in parameters)
        self.methods.append(Method(name, gives, document, with_locals(body, given), parameters))


def with_locals(body: Iterable[Statement], given: frozenset[str] = frozenset()) -> Block:
    """A body with those locals of a method that it uses and is not given."""
    body = tuple(body)
    names = names_in(body) - given
    found: list[Statement] = []
    if BB.name in names:
        found.append(Set((BB,), own("bb")))
    if NOW.name in names:
        found.append(Set((NOW,), own("now")))
    return (*found, *body)


__all__ = ["BB", "Method", "Parameter", "PlainNames", "with_locals"]
