"""The steps of a plain class as batches do them: nothing fails or is absent, and constants are numbers."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from typing import assert_never

from aseme_dsl.codegen.code.tree import (
    SELF,
    All,
    AnyOf,
    Arm,
    Bind,
    Block,
    Break,
    CallOf,
    Choice,
    Compared,
    Const,
    Do,
    Ended,
    EnumName,
    Expr,
    Fail,
    Field,
    Forgive,
    Group,
    Guarded,
    If,
    Infix,
    Item,
    Listed,
    Loop,
    Minus,
    Name,
    Negated,
    Note,
    Pass,
    Remember,
    Return,
    Set,
    Spread,
    Statement,
    Truth,
    Update,
    Wrote,
    all_of,
    expressions_in,
    names_in,
    own,
    statements,
)
from aseme_dsl.codegen.plain.names import BB
from aseme_dsl.codegen.plain.options import PlainMethod
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.plain.plain import ROUNDS


@dataclass(frozen=True, slots=True)
class Function:
    """A piece of the plain class: the statements, and whether they give a truth, a number or nothing."""

    name: str
    gives: str
    body: Block
    uses: frozenset[str]
    """The names that the method of the plain class uses."""

    @property
    def called(self) -> frozenset[str]:
        """The methods that it calls."""
        return frozenset(
            item.function.name
            for item in expressions_in(self.body)
            if isinstance(item, CallOf) and isinstance(item.function, Field) and item.function.base == SELF
        )

    @property
    def truths(self) -> frozenset[str]:
        """The locals that are true or false; the others are numbers."""
        return frozenset(
            target.name
            for item in statements(self.body)
            if isinstance(item, Set) and isinstance(item.value, Const) and isinstance(item.value.value, bool)
            for target in item.targets
            if isinstance(target, Name)
        )

    @property
    def aliases(self) -> frozenset[str]:
        """The locals that are the number of a region as it was when it was looked at."""
        return frozenset(
            target.name
            for item in statements(self.body)
            if isinstance(item, Set) and len(item.targets) == 1
            for target in item.targets
            if isinstance(target, Name) and item.value == own(target.name)
        )

    @property
    def locals(self) -> list[str]:
        """The locals that need a place: those outside of branches and loops first."""
        names: dict[str, None] = {}
        waiting = deque(self.body)
        while waiting:
            item = waiting.popleft()
            if isinstance(item, Set):
                found = (target.name for target in item.targets if isinstance(target, Name))
                names.update(dict.fromkeys(name for name in found if name not in self.aliases))
            elif isinstance(item, If):
                waiting += (*item.arms[0].body, *otherwise_of(item))
            elif isinstance(item, Loop):
                waiting += item.body
        return list(names)


def simple(method: PlainMethod) -> Function:
    """A method of the plain class without what may fail or be absent."""
    body = _Simple({}).block(method.body) or (Pass(),)
    return Function(method.name, method.gives, body, names_in(method.body))


def otherwise_of(statement: If) -> Block:
    """What is done where the first test of several does not hold."""
    if len(statement.arms) > 1:
        return (If(statement.arms[1:], statement.otherwise),)
    return statement.otherwise or ()


def exits(statement: Statement) -> bool:
    """Whether a statement may end the function, or the loop that it stands in."""
    return any(isinstance(item, Return | Break | Fail) for item in statements((statement,)))


def returns(block: Iterable[Statement]) -> bool:
    """Whether there is a `return` in a block."""
    return any(isinstance(item, Return) for item in statements(block))


def bare(expr: Expr) -> Expr:
    """An expression without the brackets around it."""
    while isinstance(expr, Group):
        expr = expr.inner
    return expr


def unknown(node: Expr | Statement) -> AssertionError:
    """Plain classes of which nothing is refused have no such code."""
    return AssertionError(f"a batch has no {type(node).__name__}: {node}")


_PRESENT = Const(True)
"""What is no longer asked: it is always there."""


@dataclass(frozen=True, slots=True)
class _Simple:
    """What may be true, false or absent is never absent here: its local is the condition `yes` of `Truth`."""

    truths: dict[Name, Expr]

    def block(self, block: Iterable[Statement]) -> Block:
        return tuple(item for statement in block for item in self.statement(statement))

    def statement(self, statement: Statement) -> Iterator[Statement]:
        match statement:
            case Note() | Wrote() | Forgive():
                return
            case Set(targets=(Name(name=BB.name | "now"),)):
                return
            case Set(targets=targets, value=value):
                yield Set(targets, self.expr(value))
            case Update(target=target, operator=operator, value=value):
                yield Update(target, operator, self.expr(value))
            case Do(value=value):
                yield Do(self.expr(value))
            case Return(value=value):
                yield Return(self.expr(value))
            case If():
                yield from self.branches(statement)
            case Loop(body=body):
                yield Loop(self.block(body))
            case Guarded(body=body) | Ended(body=body):
                yield from self.block(body)
            case Remember(region=region, name=name, copy=copy):
                yield Remember(region, name, self.expr(copy))
            case Pass() | Break() | Fail() | Spread():
                yield statement
            case _:
                assert_never(statement)

    def branches(self, statement: If) -> Iterator[Statement]:
        arms: list[Arm] = []
        otherwise = statement.otherwise
        for arm in statement.arms:
            test = self.expr(arm.test)
            body = self.block(arm.body)
            if test is _PRESENT:
                if not arms:
                    yield from body
                    return
                yield If(tuple(arms), body)
                return
            arms.append(Arm(test, body or (Pass(),)))
        yield If(tuple(arms), None if otherwise is None else self.block(otherwise) or (Pass(),))

    def expr(self, expr: Expr) -> Expr:
        match expr:
            case Name(name="ROUNDS"):
                return Const(ROUNDS)
            case Name():
                return self.truths.get(expr, expr)
            case EnumName(number=number):
                return Const(number)
            case Const() | Field():
                return expr
            case Compared(left=Group(inner=Bind(local=local, value=Truth(yes=yes))), rest=(("is not", _),)):
                self.truths[local] = self.expr(yes)
                return _PRESENT
            case Compared(left=left, rest=rest):
                return Compared(self.expr(left), tuple((sign, self.expr(side)) for sign, side in rest))
            case All(parts=parts):
                found = [part for part in map(self.expr, parts) if part is not _PRESENT]
                return all_of(found) if found else _PRESENT
            case AnyOf(parts=parts):
                return AnyOf(tuple(map(self.expr, parts)))
            case Group(inner=inner):
                changed = self.expr(inner)
                return changed if changed is _PRESENT else Group(changed)
            case Negated(operand=operand):
                return Negated(self.expr(operand))
            case Minus(operand=operand):
                return Minus(self.expr(operand))
            case Infix(operator=operator, left=left, right=right):
                return Infix(operator, self.expr(left), self.expr(right))
            case CallOf(function=Field(base=base) as function) if base == SELF:
                return CallOf(function)  # what may raise is given the blackboard, which is known here
            case CallOf(function=function, arguments=arguments):
                return CallOf(function, tuple(map(self.expr, arguments)))
            case Item() | Bind() | Truth() | Choice() | Listed():
                raise unknown(expr)
            case _:
                assert_never(expr)


__all__ = ["Function", "bare", "exits", "otherwise_of", "returns", "simple", "unknown"]
