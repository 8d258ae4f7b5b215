"""Problems of values: types, operators, numbers, outcomes and lists (E50x, E516, E52x, E53x)."""

from __future__ import annotations

from aseme_dsl.diagnostics.problem import Problem
from aseme_dsl.diagnostics.wording import a, listed

_UNIT = "a duration has a unit: 200ms, 1.5s, 2min"
_ROUND = "round it: `floor`, `ceil` and `round` of `import math` give an int"
_NUMBERS = ("int", "double")


# ---- E500, E505, E506 and E509: types -----------------------------------------------------------


class OtherTypeWanted(Problem):
    """`listed` is the value in brackets, where that would fit."""

    code = "E500"
    wanted: str
    type: str
    is_enum: bool
    listed: str | None

    @property
    def message(self) -> str:
        return f"{a(self.wanted)} is wanted here, not {a(self.type)}"

    @property
    def hint(self) -> str | None:
        if self.wanted == "duration" and self.type in _NUMBERS:
            return _UNIT
        if self.is_enum:
            return f"a constant of `{self.wanted}` is wanted"
        return None if self.listed is None else f"write `{self.listed}`"


class NoTypeOfVariable(Problem):
    code = "E500"
    message = "a variable or an input cannot hold bytes"
    hint = "it holds a bool, int, double, string, duration, agent, a constant of an enum, a message or a list"


class DifferentBranches(Problem):
    """`c ? a : b` with values of these types."""

    code = "E500"
    first: str
    second: str

    @property
    def message(self) -> str:
        if self.first == self.second:
            return f"`?` gives one of two values, and this is a whole {self.first}"
        return f"`?` gives values of one type: this is {self.second}, and before the ':' stands {self.first}"

    hint = "write two values of the same type, or two numbers"


class OperandTypes(Problem):
    """`types` are those of the operands."""

    code = "E500"
    operator: str
    types: tuple[str, ...]

    @property
    def message(self) -> str:
        return f"`{self.operator}` does not take {' and '.join(map(a, self.types))}"

    @property
    def hint(self) -> str | None:
        if len(self.types) == 1:
            return None
        if self.operator in "+-" and "duration" in self.types and not set(_NUMBERS).isdisjoint(self.types):
            return _UNIT
        if (self.operator, *self.types) == ("/", "duration", "double"):
            return "a duration is divided by an int; multiply it by a double"
        return None


class WhenWithoutCondition(Problem):
    code = "E505"
    message = "`when` needs a condition"
    hint = "write `when [condition]`"


class NotABool(Problem):
    """`operator` is that whose operand it is; None for a whole condition."""

    code = "E505"
    operator: str | None
    type: str
    is_message: bool

    @property
    def message(self) -> str:
        what = "a condition"
        if self.operator is not None:
            what = f"{'the' if self.operator == '!' else 'an'} operand of `{self.operator}`"
        return f"{what} must be a bool, not {a(self.type)}"

    @property
    def hint(self) -> str | None:
        if self.is_message:
            return "write `has(…)` to ask whether the message is there"
        return "compare it with something: `… > 0`" if self.type in _NUMBERS else None


class DoubleForInt(Problem):
    code = "E506"
    message = "a double does not fit an int"

    @property
    def hint(self) -> str:
        return _ROUND


class NotComparable(Problem):
    """Two values of different types; `kinds` are those of the types, such as `enum` and `message`."""

    code = "E509"
    types: tuple[str, str]
    kinds: tuple[str, str]

    @property
    def message(self) -> str:
        return f"{a(self.types[0])} and {a(self.types[1])} cannot be compared"

    @property
    def hint(self) -> str | None:
        of_kind = dict(zip(self.kinds, self.types, strict=True))
        is_number = not of_kind.keys().isdisjoint(_NUMBERS)
        if "list" in of_kind:
            return "compare its size or an element, `size(x)`, `x[0]`, or ask `contains(x, …)`"
        if "message" in of_kind:
            message = self.types[self.kinds.index("message")]
            return f"name a member of `{message}`, or write `has(…)` to ask whether it is there"
        if "duration" in of_kind and is_number:
            return _UNIT
        if "enum" in of_kind and is_number:
            return f"compare it with a constant of `{of_kind['enum']}`"
        if self.kinds == ("enum", "enum"):
            return f"the constants of `{self.types[0]}` and those of `{self.types[1]}` are different things"
        if "enum" in of_kind and "string" in of_kind:
            enum = of_kind["enum"]
            return f"a constant of `{enum}` is written without quotes: `{enum}.…`"
        if "string" in of_kind and is_number:
            return "a text stands in double quotes, a number does not"
        return "a bool is a condition as it stands: `x` or `!x`" if "bool" in of_kind else None


class ListsCompared(Problem):
    code = "E509"
    message = "two lists cannot be compared"
    hint = "compare their sizes or elements: `size(x)`, `x[0]`"


class NotOrdered(Problem):
    code = "E509"
    operator: str
    type: str
    is_enum: bool

    @property
    def message(self) -> str:
        what = f"constants of `{self.type}`" if self.is_enum else f"values of type {self.type}"
        return f"`{self.operator}` does not order {what}"

    hint = "`<`, `<=`, `>`, `>=` are for numbers, durations and strings"


# ---- E516: numbers ------------------------------------------------------------------------------


class NotComputed(Problem):
    """`reason` is what Python says; `has_larger` where another type would hold the result."""

    code = "E516"
    reason: str
    has_larger: bool = False

    @property
    def message(self) -> str:
        return f"the value cannot be computed: {self.reason}"

    @property
    def hint(self) -> str | None:
        return "a double can be larger" if self.has_larger else None


class TooLarge(Problem):
    code = "E516"
    written: str
    is_duration: bool

    @property
    def message(self) -> str:
        return f"{self.written} does not fit 64 bits"

    @property
    def hint(self) -> str:
        return "the longest duration is 292 years" if self.is_duration else "a double can be larger"


# ---- E520, E521 and E526: outcomes and random values---------------------------------------------


class OutcomeInQuotes(Problem):
    code = "E520"
    outcome: str

    message = "an outcome is written without quotes"

    @property
    def hint(self) -> str:
        return f"write `{self.outcome}`"


class OutcomeOrdered(Problem):
    code = "E521"
    operator: str

    @property
    def message(self) -> str:
        return f"outcomes are compared with `==` or `!=`, not with `{self.operator}`"


class OutcomeAlone(Problem):
    """`written` is what asks for it."""

    code = "E521"
    written: str
    activity: str | None
    ends: tuple[str, ...]

    @property
    def message(self) -> str:
        what = "the reason of a loss" if self.activity is None else "an outcome"
        return f"{what} is not a value of its own: it is compared with a name"

    @property
    def hint(self) -> str:
        return f"write `{self.written} == {self.ends[0]}`; {_answers(self.activity, self.ends)}"


class OutcomeComparedWithValue(Problem):
    code = "E521"
    activity: str | None
    ends: tuple[str, ...]

    @property
    def message(self) -> str:
        what = "the reason of a loss" if self.activity is None else "an outcome"
        return f"{what} is compared with a name only"

    @property
    def hint(self) -> str:
        return _answers(self.activity, self.ends)


def _answers(activity: str | None, names: tuple[str, ...]) -> str:
    """The names that an outcome of an activity, or (None) the reason of a loss, is compared with."""
    return f"reasons are {listed(names)}" if activity is None else f"`{activity}` ends {listed(names, 'or')}"


class ReasonOfOther(Problem):
    """`known` is the name of the agent that the event has lost, if it has one."""

    code = "E560"
    name: str
    known: str | None

    @property
    def message(self) -> str:
        return f"`{self.name}` is not an agent that this line has lost"

    @property
    def hint(self) -> str:
        if self.known is not None:
            return f"write `reason({self.known})`"
        return f"name the agent in the event: `lost participant {self.name}`"


class RandomInCondition(Problem):
    code = "E526"
    message = "a condition is looked at many times: `random()` would be another number each time"
    hint = "draw it in an action on the way, `/ chance = random()`, and ask for the variable"


class RandomInLogic(Problem):
    code = "E526"
    message = "`random()` is not drawn in `&&`, `||`, `!` and the condition of `? :`"
    hint = "keep it in a variable first: `/ chance = random(); …`"


# ---- E535, E536 and W552: lists -----------------------------------------------------------------


class ElementOfOther(Problem):
    code = "E535"
    written: str
    type: str

    @property
    def message(self) -> str:
        return f"`{self.written}` is {a(self.type)}: only a list has elements"

    hint = "a repeated member of a message is a list, and so is `[a, b]`"


class IndexNotInt(Problem):
    code = "E535"
    type: str

    @property
    def message(self) -> str:
        return f"an element is chosen by an int, not by {a(self.type)}"

    @property
    def hint(self) -> str | None:
        return _ROUND if self.type == "double" else None


class ListInList(Problem):
    code = "E536"
    message = "a list does not hold lists"
    hint = "write its elements"


class MixedList(Problem):
    code = "E536"
    first: str
    type: str

    @property
    def message(self) -> str:
        return f"the elements of a list are of one type: {a(self.first)}, not {a(self.type)}"


class EmptyList(Problem):
    code = "E536"
    message = "nothing says what this list would hold"
    hint = "`[]` stands where a repeated member is filled: `items = []`"


class NoElement(Problem):
    """`last` is the index of the last element; None before the first."""

    code = "W552"
    index: int
    last: int | None

    @property
    def message(self) -> str:
        return f"there is no element {self.index}: this is always absent"

    @property
    def hint(self) -> str:
        if self.last is None:
            return "the first element is 0; the last one of `x` is `x[size(x) - 1]`"
        return f"the last one is {self.last}: the first is 0"
