"""The operators of liveness formulas, in one table: how each is written, read, laid out and expanded.

Parser, printer, layout, expansion, limits, checks and the syntax files read it. To add an operator, add its
row here, and to the expansion what its template needs. A new member of `Fixity` or `Template` is named by
mypy in each place that must know it.
"""

from __future__ import annotations

from enum import Enum, StrEnum, auto
from typing import Self

from aseme_dsl.records import dataclass

NUMBER = "n"
"""A number in a sign."""


class Fixity(Enum):
    """Where an operator stands."""

    OPERAND = auto()  # it is a name
    BRACKET = auto()  # around its operand
    POSTFIX = auto()  # behind its operand
    INFIX = auto()  # between its operands


class Template(Enum):
    """Which states and transitions an operator becomes (P1, section 4.3)."""

    ACTIVITY = auto()  # a name: the state of what it names
    INSIDE = auto()  # parentheses: what stands in them
    CHAIN = auto()  # one operand after the other
    BRANCHES = auto()  # a CONDITION, from which one operand is entered
    CUT = auto()  # the first operand, from which the second can be entered at any time
    REGIONS = auto()  # an AND with a region for each operand
    BODY = auto()  # one operand, which may be passed by, repeated and left: see `Row`
    UNDECIDED = auto()  # a hole: there is no chart


@dataclass(frozen=True, slots=True)
class Row:
    """What the table says of an operator, besides its sign."""

    fixity: Fixity
    template: Template
    meaning: str
    """What it means: one line of documentation."""
    precedence: int = 0
    """Of infix operators: the larger, the tighter; each its own, from 0."""
    pairs: bool = False
    """Whether `A op B op C` is `(A op B) op C`, not one operator with three operands."""
    states: int = 0
    """How many states the template adds to those of its operands."""
    states_each: int = 0
    """How many more for each operand."""
    counted: bool = False
    """Whether a number is part of it: so often the template has its operand."""
    skips: bool = False
    """Of a BODY: whether it may be passed by."""
    repeats: bool = False
    """Of a BODY: whether it may be repeated."""
    leaves: bool = True
    """Of a BODY: whether it may be left."""
    spellings: tuple[str, ...] = ()
    """Other signs of the same; the layout writes the operator's own."""
    mistaken: tuple[str, ...] = ()
    """What the same is in other languages, and in no formula."""
    originals: tuple[str, ...] = ()
    """What the tools of the papers wrote for each part of its sign in the names of states."""


class Operator(StrEnum):
    """What a formula's node is; the value is its sign. `n` in a sign is a number, a blank the operand."""

    row: Row

    def __new__(cls, sign: str, row: Row) -> Self:
        """A member with its row."""
        made = str.__new__(cls, sign)
        made._value_ = sign
        made.row = row
        return made

    NAME = ("name", Row(Fixity.OPERAND, Template.ACTIVITY, "an activity, or another formula"))
    GROUP = (
        "( )",
        Row(Fixity.BRACKET, Template.INSIDE, "as one", originals=("_open_group_", "_close_group_")),
    )
    OPTION = (
        "[ ]",
        Row(
            Fixity.BRACKET,
            Template.BODY,
            "once or not at all",
            states=3,
            skips=True,
            originals=("_open_option_", "_close_option_"),
        ),
    )
    SEQUENCE = (
        ".",
        Row(
            Fixity.INFIX,
            Template.CHAIN,
            "one after the other",
            precedence=4,
            states=2,
            mistaken=(",", ";", "->"),
            originals=("_sequence_",),
        ),
    )
    CHOICE = (
        "|",
        Row(
            Fixity.INFIX,
            Template.BRANCHES,
            "one of both",
            precedence=2,
            states=3,
            mistaken=("/",),
            originals=("_or_",),
        ),
    )
    PARALLEL = (
        "||",
        Row(
            Fixity.INFIX,
            Template.REGIONS,
            "both at once",
            precedence=1,
            states=3,
            states_each=3,
            mistaken=("&&", "&"),
            originals=("_parallel_",),
        ),
    )
    ZERO_OR_MORE = (
        "*",
        Row(
            Fixity.POSTFIX,
            Template.BODY,
            "any number of times, or not at all",
            states=3,
            skips=True,
            repeats=True,
            originals=("_zero_or_more_times_",),
        ),
    )
    ONE_OR_MORE = (
        "+",
        Row(
            Fixity.POSTFIX,
            Template.BODY,
            "once or more",
            states=2,
            repeats=True,
            originals=("_one_or_more_times_",),
        ),
    )
    FOREVER = (
        "~",
        Row(
            Fixity.POSTFIX,
            Template.BODY,
            "forever",
            states=1,
            repeats=True,
            leaves=False,
            spellings=("ω", "^ω"),
            originals=("_forever_",),
        ),
    )
    INSTANCES = (
        "[n]",
        Row(
            Fixity.POSTFIX,
            Template.REGIONS,
            "so many at once",
            states=3,
            states_each=3,
            counted=True,
            spellings=("| |n",),
        ),
    )
    DISABLING = (
        "[>",
        Row(
            Fixity.INFIX,
            Template.CUT,
            "the second may interrupt the first",
            precedence=0,
            pairs=True,
            states=2,
            originals=("_disabledby_",),
        ),
    )
    HOLE = (
        "?",
        Row(Fixity.INFIX, Template.UNDECIDED, "an operator still to be chosen", precedence=3, states=3),
    )


INFIX = tuple(
    sorted(
        (operator for operator in Operator if operator.row.fixity is Fixity.INFIX),
        key=lambda operator: -operator.row.precedence,
    )
)
"""The infix operators, the tightest first."""

USUAL = (Operator.SEQUENCE, Operator.CHOICE, Operator.PARALLEL)
"""The infix operators that a hint names."""

INFIX_SIGNS = {operator.value: operator for operator in INFIX}

POSTFIX = {
    sign: operator
    for operator in Operator
    if operator.row.fixity is Fixity.POSTFIX
    for sign in (operator.value, *operator.row.spellings)
    if " " not in sign
}
"""The postfix operators by their signs, other spellings included."""

BRACKETS = {
    sign.split()[0]: (operator, sign.split()[1])
    for operator in Operator
    for sign in (operator.value, *operator.row.spellings)
    if " " in sign
}
"""What opens a bracket, with its operator and what closes it; `n` behind that is a number."""

OTHER_SPELLINGS = {
    spelling: operator.value
    for operator in Operator
    for spelling in operator.row.spellings
    if " " not in spelling
}
"""Signs that are not an operator's own, with the one that is."""

MISTAKEN = {other: operator for operator in Operator for other in operator.row.mistaken}
"""What people write who know other languages, with what they mean."""


def parts(sign: str) -> tuple[str, ...]:
    """The tokens of a postfix sign; `n` is a number: `[`, `n`, `]`."""
    before, number, after = sign.partition(NUMBER)
    return tuple(part for part in (before, number, after) if part)


def with_number(sign: str, number: int) -> str:
    """A sign as it is written behind an operand: `[3]`."""
    return sign.replace(NUMBER, str(number))


def is_choice(operator: Operator) -> bool:
    """Whether its template has a CONDITION: a branch is chosen, or its body is entered or passed by."""
    return operator.row.template is Template.BRANCHES or operator.row.skips
