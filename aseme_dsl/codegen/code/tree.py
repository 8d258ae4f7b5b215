"""Code as data: the few expressions and statements of which generated steps consist.

What uses what, and how a block ends, is asked of these, never of the text that is written of them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TypeAlias, assert_never

from aseme_dsl.records import dataclass

# ---- expressions --------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Const:
    """A constant, as `repr` writes it."""

    value: object


@dataclass(frozen=True, slots=True)
class Name:
    """A local, `self`, or what a module has: a function, an imported constant."""

    name: str


@dataclass(frozen=True, slots=True)
class EnumName:
    """The module's name of an enum's constant, with its number."""

    name: str
    number: int


@dataclass(frozen=True, slots=True)
class Field:
    """`base.name`."""

    base: Expr
    name: str


@dataclass(frozen=True, slots=True)
class Item:
    """`base[index]`."""

    base: Expr
    index: Expr


@dataclass(frozen=True, slots=True)
class CallOf:
    """`function(arguments)`."""

    function: Expr
    arguments: tuple[Expr, ...] = ()


@dataclass(frozen=True, slots=True)
class Negated:
    """`not operand`."""

    operand: Expr


@dataclass(frozen=True, slots=True)
class Minus:
    """`-operand`."""

    operand: Expr


@dataclass(frozen=True, slots=True)
class Infix:
    """`left operator right`, of numbers."""

    operator: str
    left: Expr
    right: Expr


@dataclass(frozen=True, slots=True)
class Compared:
    """`left < right`, and longer: `first <= x <= last`."""

    left: Expr
    rest: tuple[tuple[str, Expr], ...]


@dataclass(frozen=True, slots=True)
class All:
    """`a and b and …`; none of the parts is such a one. Written with `all_of`."""

    parts: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class AnyOf:
    """`a or b or …`."""

    parts: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class Group:
    """`(inner)`."""

    inner: Expr


@dataclass(frozen=True, slots=True)
class Bind:
    """`local := value`."""

    local: Name
    value: Expr


@dataclass(frozen=True, slots=True)
class Truth:
    """True where `yes` holds, False where `no` does, else absent."""

    yes: Expr
    no: Expr


@dataclass(frozen=True, slots=True)
class Choice:
    """`yes if test else no`."""

    test: Expr
    yes: Expr
    no: Expr


@dataclass(frozen=True, slots=True)
class Listed:
    """A tuple."""

    elements: tuple[Expr, ...]


Expr: TypeAlias = (
    Const
    | Name
    | EnumName
    | Field
    | Item
    | CallOf
    | Negated
    | Minus
    | Infix
    | Compared
    | All
    | AnyOf
    | Group
    | Bind
    | Truth
    | Choice
    | Listed
)

TRUE, FALSE, NONE = Const(True), Const(False), Const(None)
SELF, NOW = Name("self"), Name("now")


def own(name: str) -> Field:
    """`self.name`."""
    return Field(SELF, name)


def own_call(name: str, *arguments: Expr) -> CallOf:
    """`self.name(arguments)`."""
    return CallOf(own(name), arguments)


def compared(left: Expr, operator: str, right: Expr) -> Compared:
    """A comparison of two."""
    return Compared(left, ((operator, right),))


def within(first: int, value: Expr, last: int) -> Compared:
    """`first <= value <= last`."""
    return Compared(Const(first), (("<=", value), ("<=", Const(last))))


def all_of(parts: Iterable[Expr]) -> Expr:
    """The parts joined by `and`; TRUE of none."""
    found: list[Expr] = []
    for part in parts:
        found += part.parts if isinstance(part, All) else (part,)
    if not found:
        return TRUE
    return found[0] if len(found) == 1 else All(tuple(found))


def any_of(parts: Iterable[Expr]) -> Expr:
    """The parts joined by `or`; FALSE of none."""
    found = tuple(parts)
    if not found:
        return FALSE
    return found[0] if len(found) == 1 else AnyOf(found)


def parts_of(expr: Expr) -> tuple[Expr, ...]:
    """The expressions directly in an expression, in the order in which they are written."""
    match expr:
        case Const() | Name() | EnumName():
            return ()
        case Field(base=base):
            return (base,)
        case Item(base=base, index=index):
            return (base, index)
        case CallOf(function=function, arguments=arguments):
            return (function, *arguments)
        case Negated(operand=operand) | Minus(operand=operand):
            return (operand,)
        case Infix(left=left, right=right):
            return (left, right)
        case Compared(left=left, rest=rest):
            return (left, *(side for _, side in rest))
        case All(parts=parts) | AnyOf(parts=parts):
            return parts
        case Group(inner=inner):
            return (inner,)
        case Bind(local=local, value=value):
            return (local, value)
        case Truth(yes=yes, no=no):
            return (yes, no)
        case Choice(test=test, yes=yes, no=no):
            return (yes, test, no)
        case Listed(elements=elements):
            return elements
        case _:
            assert_never(expr)


def inside(expr: Expr) -> Iterator[Expr]:
    """An expression and all that is in it."""
    stack = [expr]
    while stack:
        item = stack.pop()
        yield item
        stack += parts_of(item)


# ---- statements ---------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Note:
    """A comment on a line of its own."""

    text: str


@dataclass(frozen=True, slots=True)
class Set:
    """`target = value`, of several targets `one = other = value`; with a note behind it."""

    targets: tuple[Expr, ...]
    value: Expr
    note: str = ""


@dataclass(frozen=True, slots=True)
class Update:
    """`target += value`, with any operator of numbers."""

    target: Expr
    operator: str
    value: Expr
    note: str = ""


@dataclass(frozen=True, slots=True)
class Do:
    """An expression for what it does."""

    value: Expr


@dataclass(frozen=True, slots=True)
class Pass:
    """Nothing."""


@dataclass(frozen=True, slots=True)
class Return:
    """`return value`."""

    value: Expr


@dataclass(frozen=True, slots=True)
class Arm:
    """A test with what is done where it holds; `before` are comments above it, `note` is one behind it."""

    test: Expr
    body: Block
    note: str = ""
    before: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class If:
    """The first arm whose test holds, else `otherwise`, if there is that.

    `gate`: it asks whether anything has changed since all conditions in it did not hold.
    """

    arms: tuple[Arm, ...]
    otherwise: Block | None = None
    note: str = ""
    gate: bool = False


@dataclass(frozen=True, slots=True)
class Loop:
    """`while True`."""

    body: Block


@dataclass(frozen=True, slots=True)
class Break:
    """`break`."""


@dataclass(frozen=True, slots=True)
class Fail:
    """`raise value`."""

    value: Expr


@dataclass(frozen=True, slots=True)
class Guarded:
    """`try` with what is done with an `error`."""

    body: Block
    handler: Block


@dataclass(frozen=True, slots=True)
class Ended:
    """`try: body finally: end`."""

    body: Block
    end: Block


@dataclass(frozen=True, slots=True)
class Wrote:
    """`place` on the blackboard was written: conditions that read it are to be looked at again."""

    place: Expr


@dataclass(frozen=True, slots=True)
class Remember:
    """A region has written a variable into its copy: others see it after the step."""

    region: int
    name: str
    copy: Expr


@dataclass(frozen=True, slots=True)
class Spread:
    """The end of a step: what regions have written into copies goes to the blackboard `board`."""

    board: Expr
    places: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class Forgive:
    """The end of a step: forget which conditions failed to evaluate; the next step reports them again."""


Statement: TypeAlias = (
    Note
    | Set
    | Update
    | Do
    | Pass
    | Return
    | If
    | Loop
    | Break
    | Fail
    | Guarded
    | Ended
    | Wrote
    | Remember
    | Spread
    | Forgive
)
Block: TypeAlias = tuple[Statement, ...]


def when(test: Expr, *body: Statement, note: str = "") -> If:
    """`if test:` with nothing otherwise."""
    return If((Arm(test, body, note),))


def blocks_of(statement: Statement) -> tuple[Block, ...]:
    """The blocks in a statement."""
    match statement:
        case If(arms=arms, otherwise=otherwise):
            return (*(arm.body for arm in arms), *(() if otherwise is None else (otherwise,)))
        case Loop(body=body):
            return (body,)
        case Guarded(body=body, handler=end) | Ended(body=body, end=end):
            return (body, end)
        case _:
            return ()


def statements(block: Iterable[Statement]) -> Iterator[Statement]:
    """All statements of a block, those inside others too, in the order in which they are written."""
    stack = list(block)[::-1]
    while stack:
        statement = stack.pop()
        yield statement
        stack += [item for part in blocks_of(statement)[::-1] for item in part[::-1]]


def expressions(statement: Statement) -> Iterator[Expr]:
    """The expressions directly in a statement; what it only writes is left out if it is a local."""
    match statement:
        case Note() | Pass() | If() | Loop() | Break() | Guarded() | Ended():
            if isinstance(statement, If):
                yield from (arm.test for arm in statement.arms)
        case Set(targets=targets, value=value):
            yield from (target for target in targets if not isinstance(target, Name))
            yield value
        case Update(target=target, value=value):
            yield from (target, value)
        case Do(value=value) | Return(value=value) | Fail(value=value):
            yield value
        case Wrote(place=place):
            yield place
        case Remember(copy=copy):
            yield from (own("writes"), copy)
        case Spread(board=board, places=places):
            yield from (own("writes"), board, *places)
        case Forgive():
            yield own("faulty")
        case _:
            assert_never(statement)


def expressions_in(block: Iterable[Statement]) -> Iterator[Expr]:
    """All expressions in a block with all that is in them."""
    for statement in statements(block):
        for expr in expressions(statement):
            yield from inside(expr)


def names_in(block: Iterable[Statement]) -> frozenset[str]:
    """The locals and names of the module that a block uses."""
    found: set[str] = set()
    stack: list[Expr] = []
    for statement in statements(block):
        stack += expressions(statement)
    while stack:
        item = stack.pop()
        if isinstance(item, Field):  # most are
            item = item.base
        if isinstance(item, Name | EnumName):
            found.add(item.name)
        elif not isinstance(item, Const):
            stack += parts_of(item)
    return frozenset(found)


def sets_local(statement: Statement, name: str) -> bool:
    """Whether a statement gives a local a value."""
    return isinstance(statement, Set) and Name(name) in statement.targets


def always_returns(block: Iterable[Statement]) -> bool:
    """Whether a block always ends its method: its last statement does, or all branches that it has."""
    waiting = [tuple(block)]
    while waiting:
        last = next((item for item in reversed(waiting.pop()) if not isinstance(item, Note)), None)
        if isinstance(last, Return):
            continue
        if not isinstance(last, If) or last.otherwise is None:
            return False
        waiting += blocks_of(last)
    return True
