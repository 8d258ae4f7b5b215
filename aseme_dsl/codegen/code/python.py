"""Code as data to Python's text."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import assert_never

from aseme_dsl.codegen.code.tree import (
    All,
    AnyOf,
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
    blocks_of,
)

Gates = Mapping[Field, frozenset[Expr]]
"""What says of many conditions that they still do not hold, with what on the blackboard they read."""


def text_of(expr: Expr) -> str:
    """An expression in Python."""
    match expr:
        case Name(name=name) | EnumName(name=name):
            return name
        case Field(base=base, name=name):
            return f"{text_of(base)}.{name}"
        case Const(value=value):
            return repr(value)
        case Compared(left=left, rest=rest):
            return " ".join((text_of(left), *(f"{sign} {text_of(side)}" for sign, side in rest)))
        case All(parts=parts):
            return " and ".join(map(text_of, parts))
        case AnyOf(parts=parts):
            return " or ".join(map(text_of, parts))
        case Group(inner=inner):
            return f"({text_of(inner)})"
        case Bind(local=local, value=value):
            return f"{local.name} := {text_of(value)}"
        case Infix(operator=operator, left=left, right=right):
            return f"{text_of(left)} {operator} {text_of(right)}"
        case CallOf(function=function, arguments=arguments):
            return f"{text_of(function)}({', '.join(map(text_of, arguments))})"
        case Negated(operand=operand):
            return f"not {text_of(operand)}"
        case Minus(operand=operand):
            return f"-{text_of(operand)}"
        case Item(base=base, index=index):
            return f"{text_of(base)}[{text_of(index)}]"
        case Truth(yes=yes, no=no):
            return f"True if {text_of(yes)} else False if {text_of(no)} else None"
        case Choice(test=test, yes=yes, no=no):
            return f"{text_of(yes)} if {text_of(test)} else {text_of(no)}"
        case Listed(elements=elements):
            return f"({', '.join(map(text_of, elements))}{',' if len(elements) == 1 else ''})"
        case _:
            assert_never(expr)


def length(block: Iterable[Statement]) -> int:
    """How many lines a block has, before anything is said about what was written in it."""
    lines = 0
    stack = [*block]
    while stack:
        statement = stack.pop()
        match statement:
            case If(arms=arms, otherwise=otherwise):
                lines += sum(1 + len(arm.before) for arm in arms) + (otherwise is not None)
            case Guarded() | Ended() | Forgive():
                lines += 2
            case Spread(places=places):
                lines += 3 + len(places)
            case _:
                lines += 1
        for inner in blocks_of(statement):
            stack += inner
    return lines


def lines_of(block: Iterable[Statement], depth: int = 0, gates: Gates | None = None) -> list[str]:
    """The lines of a block, indented so many times."""
    writer = _Writer(gates or {})
    writer.block(tuple(block), depth)
    return writer.lines


@dataclass(slots=True)
class _Writer:
    gates: Gates
    lines: list[str] = field(default_factory=list)
    before: deque[tuple[int, tuple[Expr, ...]] | None] = field(default_factory=lambda: deque(maxlen=2))
    """Of the last two lines, the gates that they open, and how deep that stands."""

    def block(self, block: Block, depth: int) -> None:
        for statement in block:
            self.statement(statement, depth)

    def inner(self, block: Block, depth: int) -> None:
        """A block that may not be empty."""
        self.block(block, depth)
        if all(isinstance(item, Note) for item in block):
            self.line(depth, "pass")

    def line(self, depth: int, text: str, note: str = "") -> None:
        self.before.append(None)
        self.lines.append(f"{'    ' * depth}{text}{f'  # {note}' if note else ''}")

    def statement(self, statement: Statement, depth: int) -> None:
        match statement:
            case Note(text=text):
                self.line(depth, f"# {text}")
            case Set(targets=targets, value=value, note=note):
                places = "".join(f"{text_of(target)} = " for target in targets)
                self.line(depth, places + text_of(value), note)
            case Update(target=target, operator=operator, value=value, note=note):
                self.line(depth, f"{text_of(target)} {operator}= {text_of(value)}", note)
            case Do(value=value):
                self.line(depth, text_of(value))
            case Pass():
                self.line(depth, "pass")
            case Return(value=value):
                self.line(depth, f"return {text_of(value)}")
            case If():
                self.branches(statement, depth)
            case Loop(body=body):
                self.line(depth, "while True:")
                self.inner(body, depth + 1)
            case Break():
                self.line(depth, "break")
            case Fail(value=value):
                self.line(depth, f"raise {text_of(value)}")
            case Guarded(body=body, handler=handler):
                self.line(depth, "try:")
                self.inner(body, depth + 1)
                self.line(depth, "except Exception as error:")
                self.inner(handler, depth + 1)
            case Ended(body=body, end=end):
                self.line(depth, "try:")
                self.inner(body, depth + 1)
                self.line(depth, "finally:")
                self.inner(end, depth + 1)
            case Wrote(place=place):
                self.wrote(place, depth)
            case Remember(region=region, name=name, copy=copy):
                self.line(depth, f"self.writes = ({region}, {name!r}, {text_of(copy)}, self.writes)")
            case Spread(board=board, places=places):
                self.line(depth, "if self.writes is not None:")
                self.line(depth + 1, f"self.spread({text_of(board)})")
                self.line(depth + 1, "self.writes = None")
                for place in places:
                    self.wrote(place, depth + 1)
            case Forgive():
                self.line(depth, "if self.faulty:")
                self.line(depth + 1, "self.faulty = ()")
            case _:
                assert_never(statement)

    def branches(self, statement: If, depth: int) -> None:
        for place, arm in enumerate(statement.arms):
            for text in arm.before:
                self.line(depth, f"# {text}")
            self.line(depth, f"{'elif' if place else 'if'} {text_of(arm.test)}:", arm.note)
            self.inner(arm.body, depth + 1)
        if statement.otherwise is not None:
            self.line(depth, "else:", statement.note)
            self.inner(statement.otherwise, depth + 1)

    def wrote(self, place: Expr, depth: int) -> None:
        """Open the gates of the conditions that read what was written, unless that was just said."""
        opened = tuple(gate for gate, read in self.gates.items() if place in read)
        if opened and (depth, opened) not in self.before:
            self.line(depth, f"{' = '.join(map(text_of, opened))} = False")
            self.before[-1] = depth, opened
