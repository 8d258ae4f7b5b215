"""A step for NumPy: a method over the instances `sel`; what it gives stands in their order."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping, Sequence
from typing import cast

from aseme_dsl.codegen.batch.simple import Function, bare, exits, otherwise_of, returns, unknown
from aseme_dsl.codegen.code import tree
from aseme_dsl.codegen.code.python import text_of
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
        writes = any(isinstance(item, tree.Remember | tree.Spread) for item in tree.statements(function.body))
        if writes or BB.name in function.uses:
            self._line(2, "bb = self.bb")
        if tree.NOW.name in function.uses:
            self._line(2, "now = self.now")
        for local in function.locals:
            self._line(2, f"{local} = self.nothing({'bool' if local in self._truths else 'int'})")
        if gives != "None":
            self._line(2, f"out = self.nothing({gives})")
        early = function.body[:-1] if isinstance(function.body[-1], tree.Return) else function.body
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

    def _block(
        self, depth: int, block: tree.Block, sel: str, loop: str = "", *, is_whole: bool = False
    ) -> None:
        """Statements, the later of them for those instances that the earlier have left here.

        `is_whole`: they are all that there is.
        """
        for place, item in enumerate(block):
            is_last = place + 1 == len(block)
            self._statement(depth, item, sel, loop, ends=is_whole and is_last)
            if is_last or isinstance(item, tree.Loop) or not exits(item):
                continue
            stays = [f"{loop}[{sel}]"] if loop else []
            if returns((item,)):
                stays.append(f"here[{sel}]")
            rest = self._new("s")
            self._line(depth, f"{rest} = {self._call('pick', sel, ' & '.join(stays))}")
            sel = rest

    def _statement(self, depth: int, item: tree.Statement, sel: str, loop: str, *, ends: bool) -> None:
        match item:
            case tree.Remember(region=region, name=name, copy=copy):
                self._write(depth, region, name, copy, sel)
            case tree.Spread():
                self._spread(depth, sel)
            case tree.Set(targets=targets, value=value):
                places = [target for target in targets if not self._is_alias(target)]
                code = self._value(value, sel) if places else ""
                for place in places:
                    self._line(depth, f"{text_of(place)}[{sel}] = {code}")
            case tree.Update(target=target, operator=operator, value=value):
                self._line(depth, f"{text_of(target)}[{sel}] {operator}= {self._value(value, sel)}")
            case tree.If():
                self._branches(depth, item, sel, loop)
            case tree.Loop(body=body):
                self._line(depth, f"live, looping = {sel}, self.all()")
                self._line(depth, "while True:")
                self._block(depth + 1, body, "live", "looping")
                self._line(depth + 1, f"live = {self._call('pick', 'live', 'looping[live]')}")
                self._line(depth + 1, "if not live.size:")
                self._line(depth + 2, "break")
            case tree.Break():
                self._line(depth, f"{loop}[{sel}] = False")
            case tree.Fail():
                self._line(depth, f"self.stuck[{sel}] = True")
                self._line(depth, f"{loop}[{sel}] = False")
            case tree.Return(value=value):
                self._line(depth, f"out[{sel}] = {self._value(value, sel)}")
                if not ends:
                    self._line(depth, f"here[{sel}] = False")
            case tree.Do(value=value):
                self._line(depth, self._done(value, sel))
            case tree.Pass():
                self._line(depth, "pass")
            case _:
                raise unknown(item)

    def _done(self, expr: tree.Expr, sel: str) -> str:
        """An expression for what it does: nothing, unless something is called."""
        match bare(expr):
            case tree.CallOf(function=tree.Field(base=base)) as call if base == tree.SELF:
                return self._value(call, sel)
            case tree.Const() | tree.Field() | tree.Compared() | tree.All() | tree.AnyOf():
                return "pass"
            case other:
                raise unknown(other)

    def _branches(self, depth: int, item: tree.If, sel: str, loop: str) -> None:
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

    def _is_alias(self, target: tree.Expr) -> bool:
        return isinstance(target, tree.Name) and target.name in self._aliases

    def _write(self, depth: int, region: int, name: str, value: tree.Expr, sel: str) -> None:
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

    def _is_truth(self, expr: tree.Expr) -> bool:
        """Whether an expression is true or false; the others are numbers."""
        match bare(expr):
            case tree.Compared() | tree.All() | tree.AnyOf() | tree.Negated() | tree.Const(value=bool()):
                return True
            case tree.Field(base=tree.Name(name=owner), name=name):
                return self._kinds[owner, name] == "?"
            case tree.Name(name=name):
                return name in self._truths
        return False

    def _truth(self, expr: tree.Expr, sel: str) -> str:
        if _is_constant(expr):
            return f"self.everywhere({bool(_folded(expr))})[{sel}]"
        code = self._value(expr, sel)
        return code if self._is_truth(expr) else f"({code} != 0)"

    def _value(self, expr: tree.Expr, sel: str) -> str:
        match bare(expr):
            case tree.Const(value=bool() | int() | float() as value):
                return repr(value)
            case tree.Name(name=tree.NOW.name):
                return tree.NOW.name
            case tree.Name(name=name) if name in self._aliases:
                return f"self.{name}[{sel}]"
            case tree.Name() | tree.Field() as place:
                return f"{text_of(place)}[{sel}]"
            case tree.Negated(operand=operand):
                return f"~{self._truth(operand, sel)}"
            case tree.Minus(operand=operand):
                return f"-{self._value(operand, sel)}"
            case tree.All(parts=parts):
                return f"({' & '.join(self._truth(part, sel) for part in parts)})"
            case tree.AnyOf(parts=parts):
                return f"({' | '.join(self._truth(part, sel) for part in parts)})"
            case tree.Compared(left=left, rest=rest):
                sides = [self._value(side, sel) for side in (left, *(side for _, side in rest))]
                tests = [
                    f"({sides[place]} {_EQUAL.get(sign, sign)} {sides[place + 1]})"
                    for place, (sign, _) in enumerate(rest)
                ]
                return tests[0] if len(tests) == 1 else f"({' & '.join(tests)})"
            case tree.Infix(operator=operator, left=left, right=right):
                # To NumPy the sum of two truths is a truth.
                one, other = (
                    f"{self._value(side, sel)} * 1" if self._is_truth(side) else self._value(side, sel)
                    for side in (left, right)
                )
                return f"({one} {operator} {other})"
            case tree.CallOf(function=tree.Field(base=base, name=name)) if base == tree.SELF:
                return f"self.do_{name}({sel})"
            case tree.CallOf(function=tree.Name(name=name), arguments=arguments):
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
        raise unknown(tree.Name(name))


_EQUAL = {"is": "==", "is not": "!="}
"""What comparisons are between numbers."""

_FOLDED: Mapping[str, Callable[..., object]] = {
    "abs": abs,
    "float": float,
    "int": int,
    "max": max,
    "min": min,
}

_OPERATIONS: Mapping[str, Callable[[float, float], object]] = {
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


def _is_constant(expr: tree.Expr) -> bool:
    """Whether nothing in an expression differs from instance to instance."""
    return all(
        not isinstance(item, tree.Name | tree.Field) or (isinstance(item, tree.Name) and item.name in _FOLDED)
        for item in tree.inside(expr)
    )


def _folded(expr: tree.Expr) -> object:
    """What an expression of constants gives, for which no array says how many there are of it."""
    match bare(expr):
        case tree.Const(value=value):
            return value
        case tree.Negated(operand=operand):
            return not _folded(operand)
        case tree.Minus(operand=operand):
            return -_number(operand)
        case tree.All(parts=parts):
            return all(_folded(part) for part in parts)
        case tree.AnyOf(parts=parts):
            return any(_folded(part) for part in parts)
        case tree.Infix(operator=sign, left=left, right=right):
            return _OPERATIONS[sign](_number(left), _number(right))
        case tree.Compared(left=left, rest=rest):
            sides = [_number(side) for side in (left, *(side for _, side in rest))]
            pairs = zip(rest, sides, sides[1:], strict=False)
            return all(_OPERATIONS[sign](one, other) for (sign, _), one, other in pairs)
        case tree.CallOf(function=tree.Name(name=name), arguments=arguments) if name in _FOLDED:
            return _FOLDED[name](*map(_folded, arguments))
        case other:
            raise unknown(other)


def _number(expr: tree.Expr) -> float:
    """The number that a constant operand of a comparison or of arithmetic stands for."""
    return cast(float, _folded(expr))


__all__ = ["ForNumpy"]
