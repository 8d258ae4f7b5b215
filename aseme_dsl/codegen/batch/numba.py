"""A step for numba: a function of one instance `i`, given all tables, or the loop over all instances.

What is written goes through the trees of `ast`, which sets brackets only where they are needed.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Mapping, Sequence

from aseme_dsl.codegen.batch.simple import Function, bare, otherwise_of, unknown
from aseme_dsl.codegen.code.tree import (
    SELF,
    All,
    AnyOf,
    Block,
    Break,
    CallOf,
    Compared,
    Const,
    Do,
    Expr,
    Fail,
    Field,
    If,
    Infix,
    Loop,
    Minus,
    Name,
    Negated,
    Pass,
    Remember,
    Return,
    Set,
    Spread,
    Statement,
    Update,
)
from aseme_dsl.runtime.plain.batch import TABLES

START, STEP = "start", "step"
"""The modes of a step besides events: the start, and a step without an event."""

TABLES_AND_TIME = (*TABLES.values(), "now")
"""What a loop for numba is given, besides `out`; and a function, besides `i`."""

BUILT_IN = ("abs", "float", "int", "max", "min")
"""The functions of Python that steps call."""

Place = tuple[str, int]
"""Where numba finds a value of the instance `i`: in which table, in which column."""


class ForNumba:
    """A step as a function, or as a loop."""

    def __init__(
        self, function: Function, places: Mapping[tuple[str, str], Place], pending: Sequence[str]
    ) -> None:
        """`places` are those of what the class (`self`) and its blackboard (`bb`) have."""
        self._function = function
        self._places = places
        self._pending = pending

    def lines(self) -> list[str]:
        """A function of the instance `i`."""
        function = self._function
        head = f"def do_{function.name}({', '.join(('i', *TABLES_AND_TIME))}):"
        body = _written(self._block(function.body))
        gives = function.gives == "bool" or function.name == START
        if gives and not isinstance(function.body[-1], Return):
            body.append("return False")
        return ["@compiled", head, *(f"    {line}" for line in body or ["pass"])]

    def loop(self) -> list[str]:
        """All instances, without a call for each: with so many arrays that takes as long as a step."""
        found = self._block(self._function.body, in_loop=True)
        if found and isinstance(found[-1], ast.Continue):
            del found[-1]
        return [
            *loop_over(self._function.name),
            *(f"            {line}" for line in ("out[i] = False", *_written(found))),
        ]

    # ---- statements ------------------------------------------------------------------------

    def _block(self, block: Block, *, in_loop: bool = False) -> list[ast.stmt]:
        return [item for statement in block for item in self._statement(statement, in_loop)]

    def _statement(self, statement: Statement, in_loop: bool) -> Iterator[ast.stmt]:
        match statement:
            case Set(targets=targets, value=value):
                yield _set(map(self._expr, targets), self._expr(value))
            case Update(target=target, operator=operator, value=value):
                place = self._expr(target)
                assert isinstance(place, ast.Name | ast.Subscript)
                yield ast.AugAssign(place, _OPERATORS[operator](), self._expr(value))
            case Do(value=value):
                yield ast.Expr(self._expr(value))
            case Pass():
                yield ast.Pass()
            case Return(value=value):
                if in_loop:
                    yield _set([_element("out")], self._expr(value))
                    yield ast.Continue()
                else:
                    yield ast.Return(self._expr(value))
            case If(arms=arms):
                test, body = self._expr(arms[0].test), self._block(arms[0].body, in_loop=in_loop)
                yield ast.If(test, body, self._block(otherwise_of(statement), in_loop=in_loop))
            case Loop(body=body):
                yield ast.While(ast.Constant(True), self._block(body), [])
            case Break():
                yield ast.Break()
            case Fail():
                yield _set([self._place("self", "stuck")], ast.Constant(True))
                yield ast.Break()
            case Remember(region=region, name=name, copy=copy):
                by, what = (self._place("self", f"{letter}_{name}") for letter in "pw")
                earlier = ast.Compare(by, [ast.LtE()], [ast.Constant(region)])
                kept = [_set([by], ast.Constant(region)), _set([what], self._expr(copy))]
                yield ast.If(earlier, list[ast.stmt](kept), [])
            case Spread():
                for name in self._pending:
                    by, what = (self._place("self", f"{letter}_{name}") for letter in "pw")
                    there = ast.Compare(by, [ast.GtE()], [ast.Constant(0)])
                    none = ast.UnaryOp(ast.USub(), ast.Constant(1))
                    spread = [_set([self._place("bb", name)], what), _set([by], none)]
                    yield ast.If(there, list[ast.stmt](spread), [])
            case _:
                raise unknown(statement)

    # ---- expressions -----------------------------------------------------------------------

    def _place(self, owner: str, name: str) -> ast.expr:
        table, column = self._places[owner, name]
        return ast.Subscript(ast.Name(table), ast.Tuple([ast.Name("i"), ast.Constant(column)]))

    def _expr(self, expr: Expr) -> ast.expr:
        match bare(expr):
            case Const(value=bool() | int() | float() as value):
                return ast.Constant(value) if value >= 0 else ast.UnaryOp(ast.USub(), ast.Constant(-value))
            case Name(name=name):
                return ast.Name(name)
            case Field(base=Name(name=owner), name=name):
                return self._place(owner, name)
            case Negated(operand=operand):
                return ast.UnaryOp(ast.Not(), self._expr(operand))
            case Minus(operand=operand):
                return ast.UnaryOp(ast.USub(), self._expr(operand))
            case All(parts=parts):
                return ast.BoolOp(ast.And(), list(map(self._expr, parts)))
            case AnyOf(parts=parts):
                return ast.BoolOp(ast.Or(), list(map(self._expr, parts)))
            case Infix(operator=operator, left=left, right=right):
                return ast.BinOp(self._expr(left), _OPERATORS[operator](), self._expr(right))
            case Compared(left=left, rest=rest):
                signs = [_COMPARISONS[sign]() for sign, _ in rest]
                return ast.Compare(self._expr(left), signs, [self._expr(side) for _, side in rest])
            case CallOf(function=Field(base=base, name=name)) if base == SELF:
                given = ("i", *TABLES_AND_TIME)
                return ast.Call(ast.Name(f"do_{name}"), [ast.Name(item) for item in given], [])
            case CallOf(function=Name(name=name), arguments=arguments) if name in BUILT_IN:
                return ast.Call(ast.Name(name), list(map(self._expr, arguments)), [])
            case other:
                raise unknown(other)


def calling_loop(name: str) -> list[str]:
    """The loop over all instances with a call, for what others call, too, or what is long."""
    return [*loop_over(name), f"            out[i] = do_{name}({', '.join(('i', *TABLES_AND_TIME))})"]


def loop_over(name: str) -> list[str]:
    """How a loop over all instances begins; `out` says which make the step, and then what came of it."""
    return [
        "@compiled",
        f"def each_{name}({', '.join(('out', *TABLES_AND_TIME))}):",
        "    for i in range(len(out)):",
        "        if out[i]:",
    ]


def _set(targets: Iterable[ast.expr], value: ast.expr) -> ast.Assign:
    return ast.Assign(list(targets), value)


def _element(array: str) -> ast.expr:
    return ast.Subscript(ast.Name(array), ast.Name("i"))


def _written(found: Iterable[ast.stmt]) -> list[str]:
    return [line for item in found for line in ast.unparse(ast.fix_missing_locations(item)).splitlines()]


_OPERATORS: Mapping[str, type[ast.operator]] = {
    "+": ast.Add,
    "-": ast.Sub,
    "*": ast.Mult,
    "/": ast.Div,
    "//": ast.FloorDiv,
    "%": ast.Mod,
    "&": ast.BitAnd,
    "|": ast.BitOr,
}

_COMPARISONS: Mapping[str, type[ast.cmpop]] = {
    "==": ast.Eq,
    "!=": ast.NotEq,
    "<": ast.Lt,
    "<=": ast.LtE,
    ">": ast.Gt,
    ">=": ast.GtE,
    "is": ast.Is,
    "is not": ast.IsNot,
}

__all__ = ["START", "STEP", "ForNumba", "calling_loop"]
