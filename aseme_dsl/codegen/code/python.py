"""Code as data to Python's text."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping
from dataclasses import field
from typing import assert_never

from aseme_dsl.codegen.code import tree
from aseme_dsl.records import dataclass

Gates = Mapping[tree.Field, frozenset[tree.Expr]]
"""What says of many conditions that they still do not hold, with what on the blackboard they read."""


def text_of(expr: tree.Expr) -> str:
    """An expression in Python."""
    match expr:
        case tree.Name(name=name) | tree.EnumName(name=name):
            return name
        case tree.Field(base=base, name=name):
            return f"{text_of(base)}.{name}"
        case tree.Const(value=value):
            return repr(value)
        case tree.Compared(left=left, rest=rest):
            return " ".join((text_of(left), *(f"{sign} {text_of(side)}" for sign, side in rest)))
        case tree.All(parts=parts):
            return " and ".join(map(text_of, parts))
        case tree.AnyOf(parts=parts):
            return " or ".join(map(text_of, parts))
        case tree.Group(inner=inner):
            return f"({text_of(inner)})"
        case tree.Bind(local=local, value=value):
            return f"{local.name} := {text_of(value)}"
        case tree.Infix(operator=operator, left=left, right=right):
            return f"{text_of(left)} {operator} {text_of(right)}"
        case tree.CallOf(function=function, arguments=arguments):
            return f"{text_of(function)}({', '.join(map(text_of, arguments))})"
        case tree.Negated(operand=operand):
            return f"not {text_of(operand)}"
        case tree.Minus(operand=operand):
            return f"-{text_of(operand)}"
        case tree.Item(base=base, index=index):
            return f"{text_of(base)}[{text_of(index)}]"
        case tree.Truth(yes=yes, no=no):
            return f"True if {text_of(yes)} else False if {text_of(no)} else None"
        case tree.Choice(test=test, yes=yes, no=no):
            return f"{text_of(yes)} if {text_of(test)} else {text_of(no)}"
        case tree.Listed(elements=elements):
            return f"({', '.join(map(text_of, elements))}{',' if len(elements) == 1 else ''})"
        case _:
            assert_never(expr)


def length(block: Iterable[tree.Statement]) -> int:
    """How many lines a block has, before anything is said about what was written in it."""
    lines = 0
    stack = [*block]
    while stack:
        statement = stack.pop()
        match statement:
            case tree.If(arms=arms, otherwise=otherwise):
                lines += sum(1 + len(arm.before) for arm in arms) + (otherwise is not None)
            case tree.Guarded() | tree.Ended() | tree.Forgive():
                lines += 2
            case tree.Spread(places=places):
                lines += 3 + len(places)
            case _:
                lines += 1
        for inner in tree.blocks_of(statement):
            stack += inner
    return lines


def lines_of(block: Iterable[tree.Statement], depth: int = 0, gates: Gates | None = None) -> list[str]:
    """The lines of a block, indented so many times."""
    writer = _Writer(gates or {})
    writer.block(tuple(block), depth)
    return writer.lines


@dataclass(slots=True)
class _Writer:
    gates: Gates
    lines: list[str] = field(default_factory=list)
    before: deque[tuple[int, tuple[tree.Expr, ...]] | None] = field(default_factory=lambda: deque(maxlen=2))
    """Of the last two lines, the gates that they open, and how deep that stands."""

    def block(self, block: tree.Block, depth: int) -> None:
        for statement in block:
            self.statement(statement, depth)

    def inner(self, block: tree.Block, depth: int) -> None:
        """A block that may not be empty."""
        self.block(block, depth)
        if all(isinstance(item, tree.Note) for item in block):
            self.line(depth, "pass")

    def line(self, depth: int, text: str, note: str = "") -> None:
        self.before.append(None)
        self.lines.append(f"{'    ' * depth}{text}{f'  # {note}' if note else ''}")

    def statement(self, statement: tree.Statement, depth: int) -> None:
        match statement:
            case tree.Note(text=text):
                self.line(depth, f"# {text}")
            case tree.Set(targets=targets, value=value, note=note):
                places = "".join(f"{text_of(target)} = " for target in targets)
                self.line(depth, places + text_of(value), note)
            case tree.Update(target=target, operator=operator, value=value, note=note):
                self.line(depth, f"{text_of(target)} {operator}= {text_of(value)}", note)
            case tree.Do(value=value):
                self.line(depth, text_of(value))
            case tree.Pass():
                self.line(depth, "pass")
            case tree.Return(value=value):
                self.line(depth, f"return {text_of(value)}")
            case tree.If():
                self.branches(statement, depth)
            case tree.Loop(body=body):
                self.line(depth, "while True:")
                self.inner(body, depth + 1)
            case tree.Break():
                self.line(depth, "break")
            case tree.Fail(value=value):
                self.line(depth, f"raise {text_of(value)}")
            case tree.Guarded(body=body, handler=handler):
                self.line(depth, "try:")
                self.inner(body, depth + 1)
                self.line(depth, "except Exception as error:")
                self.inner(handler, depth + 1)
            case tree.Ended(body=body, end=end):
                self.line(depth, "try:")
                self.inner(body, depth + 1)
                self.line(depth, "finally:")
                self.inner(end, depth + 1)
            case tree.Wrote(place=place):
                self.wrote(place, depth)
            case tree.Remember(region=region, name=name, copy=copy):
                self.line(depth, f"self.writes = ({region}, {name!r}, {text_of(copy)}, self.writes)")
            case tree.Spread(board=board, places=places):
                self.line(depth, "if self.writes is not None:")
                self.line(depth + 1, f"self.spread({text_of(board)})")
                self.line(depth + 1, "self.writes = None")
                for place in places:
                    self.wrote(place, depth + 1)
            case tree.Forgive():
                self.line(depth, "if self.faulty:")
                self.line(depth + 1, "self.faulty = ()")
            case _:
                assert_never(statement)

    def branches(self, statement: tree.If, depth: int) -> None:
        for place, arm in enumerate(statement.arms):
            for text in arm.before:
                self.line(depth, f"# {text}")
            self.line(depth, f"{'elif' if place else 'if'} {text_of(arm.test)}:", arm.note)
            self.inner(arm.body, depth + 1)
        if statement.otherwise is not None:
            self.line(depth, "else:", statement.note)
            self.inner(statement.otherwise, depth + 1)

    def wrote(self, place: tree.Expr, depth: int) -> None:
        """Open the gates of the conditions that read what was written, unless that was just said."""
        opened = tuple(gate for gate, read in self.gates.items() if place in read)
        if opened and (depth, opened) not in self.before:
            self.line(depth, f"{' = '.join(map(text_of, opened))} = False")
            self.before[-1] = depth, opened
