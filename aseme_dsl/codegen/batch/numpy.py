"""A step for NumPy: a method over the instances `sel`; what it gives stands in their order."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from aseme_dsl.codegen.batch.simple import Function, bare, exits, otherwise_of, returns, unknown
from aseme_dsl.codegen.code.python import text_of
from aseme_dsl.codegen.code.tree import (
    NOW,
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
    inside,
    statements,
)
from aseme_dsl.codegen.plain.names import BB


class ForNumpy:
    """A method: a test splits the instances, `return` and `break` take some of them out of what follows."""

    def __init__(
        self, function: Function, kinds: Mapping[tuple[str, str], str], pending: Sequence[str]
    ) -> None:
        """`kinds` are the NumPy types of what the class (`self`) and its blackboard (`bb`) have."""
        self._function = function
        self._kinds = kinds
        self._pending = pending
        self._truths = function.truths
        self._aliases = function.aliases
        self._lines: list[str] = []
        self._count = 0
        self.used: set[str] = set()
        """The functions of the runtime that are called."""

    def lines(self) -> list[str]:
        """The method, indented as in a class."""
        function = self._function
        gives = function.gives
        self._line(
            1, f"def do_{function.name}(self, sel: Selection) -> {'None' if gives == 'None' else 'Any'}:"
        )
        writes = any(isinstance(item, Remember | Spread) for item in statements(function.body))
        if writes or BB.name in function.uses:
            self._line(2, "bb = self.bb")
        if NOW.name in function.uses:
            self._line(2, "now = self.now")
        for local in function.locals:
            self._line(2, f"{local} = self.nothing({'bool' if local in self._truths else 'int'})")
        if gives != "None":
            self._line(2, f"out = self.nothing({gives})")
        early = function.body[:-1] if isinstance(function.body[-1], Return) else function.body
        if returns(early):
            self._line(2, "here = self.all()")
        self._block(2, function.body, "sel", is_whole=True)
        if gives != "None":
            self._line(2, "return out[sel]")
        return [*self._lines, "        pass"] if len(self._lines) == 1 else self._lines

    def _line(self, depth: int, text: str) -> None:
        self._lines.append("    " * depth + text)

    def _new(self, letter: str) -> str:
        self._count += 1
        return f"{letter}{self._count}"

    def _call(self, function: str, *arguments: str) -> str:
        """The call of a function of the runtime."""
        self.used.add(function)
        return f"{function}({', '.join(arguments)})"

    # ---- statements ------------------------------------------------------------------------

    def _block(self, depth: int, block: Block, sel: str, loop: str = "", *, is_whole: bool = False) -> None:
        """Statements, the later of them for those instances that the earlier have left here.

        `is_whole`: they are all that there is.
        """
        for place, item in enumerate(block):
            is_last = place + 1 == len(block)
            self._statement(depth, item, sel, loop, ends=is_whole and is_last)
            if is_last or isinstance(item, Loop) or not exits(item):
                continue
            stays = [f"{loop}[{sel}]"] if loop else []
            if returns((item,)):
                stays.append(f"here[{sel}]")
            rest = self._new("s")
            self._line(depth, f"{rest} = {self._call('pick', sel, ' & '.join(stays))}")
            sel = rest

    def _statement(self, depth: int, item: Statement, sel: str, loop: str, *, ends: bool) -> None:
        match item:
            case Remember(region=region, name=name, copy=copy):
                self._write(depth, region, name, copy, sel)
            case Spread():
                self._spread(depth, sel)
            case Set(targets=targets, value=value):
                places = [target for target in targets if not self._is_alias(target)]
                code = self._value(value, sel) if places else ""
                for place in places:
                    self._line(depth, f"{text_of(place)}[{sel}] = {code}")
            case Update(target=target, operator=operator, value=value):
                self._line(depth, f"{text_of(target)}[{sel}] {operator}= {self._value(value, sel)}")
            case If():
                self._branches(depth, item, sel, loop)
            case Loop(body=body):
                self._line(depth, f"live, looping = {sel}, self.all()")
                self._line(depth, "while True:")
                self._block(depth + 1, body, "live", "looping")
                self._line(depth + 1, f"live = {self._call('pick', 'live', 'looping[live]')}")
                self._line(depth + 1, "if not live.size:")
                self._line(depth + 2, "break")
            case Break():
                self._line(depth, f"{loop}[{sel}] = False")
            case Fail():
                self._line(depth, f"self.stuck[{sel}] = True")
                self._line(depth, f"{loop}[{sel}] = False")
            case Return(value=value):
                self._line(depth, f"out[{sel}] = {self._value(value, sel)}")
                if not ends:
                    self._line(depth, f"here[{sel}] = False")
            case Do(value=value):
                self._line(depth, self._done(value, sel))
            case Pass():
                self._line(depth, "pass")
            case _:
                raise unknown(item)

    def _done(self, expr: Expr, sel: str) -> str:
        """An expression for what it does: nothing, unless something is called."""
        match bare(expr):
            case CallOf(function=Field(base=base)) as call if base == SELF:
                return self._value(call, sel)
            case Const() | Field() | Compared() | All() | AnyOf():
                return "pass"
            case other:
                raise unknown(other)

    def _branches(self, depth: int, item: If, sel: str, loop: str) -> None:
        found, inner = self._new("t"), self._new("s")
        otherwise = otherwise_of(item)
        self._line(depth, f"{found} = {self._truth(item.arms[0].test, sel)}")
        self._line(depth, f"{inner} = {self._call('pick', sel, found)}")
        rest = self._new("s") if otherwise else ""
        if rest:  # before the body, since what was found may be a view of what the body writes
            self._line(depth, f"{rest} = {self._call('pick', sel, f'~{found}')}")
        self._line(depth, f"if {inner}.size:")
        self._block(depth + 1, item.arms[0].body, inner, loop)
        if rest:
            self._block(depth, otherwise, rest, loop)

    def _is_alias(self, target: Expr) -> bool:
        return isinstance(target, Name) and target.name in self._aliases

    def _write(self, depth: int, region: int, name: str, value: Expr, sel: str) -> None:
        """What a region writes counts more than what those before it in the document have written."""
        later = self._new("s")
        self._line(depth, f"{later} = {self._call('pick', sel, f'self.p_{name}[{sel}] <= {region}')}")
        self._line(depth, f"self.p_{name}[{later}] = {region}")
        self._line(depth, f"self.w_{name}[{later}] = {self._value(value, later)}")

    def _spread(self, depth: int, sel: str) -> None:
        for name in self._pending:
            written = self._new("s")
            self._line(depth, f"{written} = {self._call('pick', sel, f'self.p_{name}[{sel}] >= 0')}")
            self._line(depth, f"bb.{name}[{written}] = self.w_{name}[{written}]")
            self._line(depth, f"self.p_{name}[{written}] = -1")

    # ---- expressions -----------------------------------------------------------------------

    def _is_truth(self, expr: Expr) -> bool:
        """Whether an expression is true or false; the others are numbers."""
        match bare(expr):
            case Compared() | All() | AnyOf() | Negated() | Const(value=bool()):
                return True
            case Field(base=Name(name=owner), name=name):
                return self._kinds[owner, name] == "?"
            case Name(name=name):
                return name in self._truths
        return False

    def _truth(self, expr: Expr, sel: str) -> str:
        if _is_constant(expr):
            return f"self.everywhere({bool(_folded(expr))})[{sel}]"
        code = self._value(expr, sel)
        return code if self._is_truth(expr) else f"({code} != 0)"

    def _value(self, expr: Expr, sel: str) -> str:
        match bare(expr):
            case Const(value=bool() | int() | float() as value):
                return repr(value)
            case Name(name=NOW.name):
                return NOW.name
            case Name(name=name) if name in self._aliases:
                return f"self.{name}[{sel}]"
            case Name() | Field() as place:
                return f"{text_of(place)}[{sel}]"
            case Negated(operand=operand):
                return f"~{self._truth(operand, sel)}"
            case Minus(operand=operand):
                return f"-{self._value(operand, sel)}"
            case All(parts=parts):
                return f"({' & '.join(self._truth(part, sel) for part in parts)})"
            case AnyOf(parts=parts):
                return f"({' | '.join(self._truth(part, sel) for part in parts)})"
            case Compared(left=left, rest=rest):
                sides = [self._value(side, sel) for side in (left, *(side for _, side in rest))]
                tests = [
                    f"({sides[place]} {_EQUAL.get(sign, sign)} {sides[place + 1]})"
                    for place, (sign, _) in enumerate(rest)
                ]
                return tests[0] if len(tests) == 1 else f"({' & '.join(tests)})"
            case Infix(operator=operator, left=left, right=right):
                # To NumPy the sum of two truths is a truth.
                one, other = (
                    f"{self._value(side, sel)} * 1" if self._is_truth(side) else self._value(side, sel)
                    for side in (left, right)
                )
                return f"({one} {operator} {other})"
            case CallOf(function=Field(base=base, name=name)) if base == SELF:
                return f"self.do_{name}({sel})"
            case CallOf(function=Name(name=name), arguments=arguments):
                return self._built_in(name, [self._value(item, sel) for item in arguments])
            case other:
                raise unknown(other)

    def _built_in(self, name: str, values: Sequence[str]) -> str:
        match name:
            case "abs":
                return f"abs({values[0]})"
            case "float":
                return f"({values[0]} * 1.0)"
            case "int":
                return self._call("whole", values[0])
            case "max" | "min":
                code = values[0]
                for value in values[1:]:
                    code = self._call({"max": "larger", "min": "smaller"}[name], code, value)
                return code
        raise unknown(Name(name))


_EQUAL = {"is": "==", "is not": "!="}
"""What comparisons are between numbers."""

_FOLDED: Mapping[str, Callable[..., Any]] = {"abs": abs, "float": float, "int": int, "max": max, "min": min}

_OPERATIONS: Mapping[str, Callable[[Any, Any], Any]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "//": operator.floordiv,
    "%": operator.mod,
    "==": operator.eq,
    "!=": operator.ne,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
    "is": operator.is_,
    "is not": operator.is_not,
}


def _is_constant(expr: Expr) -> bool:
    """Whether nothing in an expression differs from instance to instance."""
    return all(
        not isinstance(item, Name | Field) or (isinstance(item, Name) and item.name in _FOLDED)
        for item in inside(expr)
    )


def _folded(expr: Expr) -> Any:
    """What an expression of constants gives, for which no array says how many there are of it."""
    match bare(expr):
        case Const(value=value):
            return value
        case Negated(operand=operand):
            return not _folded(operand)
        case Minus(operand=operand):
            return -_folded(operand)
        case All(parts=parts):
            return all(_folded(part) for part in parts)
        case AnyOf(parts=parts):
            return any(_folded(part) for part in parts)
        case Infix(operator=sign, left=left, right=right):
            return _OPERATIONS[sign](_folded(left), _folded(right))
        case Compared(left=left, rest=rest):
            sides = [_folded(side) for side in (left, *(side for _, side in rest))]
            pairs = zip(rest, sides, sides[1:], strict=False)
            return all(_OPERATIONS[sign](one, other) for (sign, _), one, other in pairs)
        case CallOf(function=Name(name=name), arguments=arguments) if name in _FOLDED:
            return _FOLDED[name](*map(_folded, arguments))
        case other:
            raise unknown(other)


__all__ = ["ForNumpy"]
