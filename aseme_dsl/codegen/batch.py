"""The plain class of a statechart to code that runs thousands of instances at once.

What is translated is the code that `plain.py` has written, statement by statement, so that there is one place
that says what a step does. Where the class has a slot (`self.r3`) or its blackboard a value (`bb.n`), the
instances have an array with an element each:

    arrays     for NumPy. `sel` are the instances for which a line is done: a test splits them, a `return` or
               `break` takes some of them out of what follows
    elements   for numba. A function of one instance `i`, and a loop over all

Both understand just what `plain.py` writes; anything else is a mistake here, and raises.
"""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass, field
from typing import Any

from aseme_dsl.codegen.plain import PlainCode
from aseme_dsl.runtime.plain.batch import TABLES
from aseme_dsl.runtime.plain.plain import ROUNDS

START, STEP = "start", "step"
"""The modes of a step that are no event."""

TABLES_AND_TIME = ", ".join((*TABLES.values(), "now"))
ARGUMENTS = f"i, {TABLES_AND_TIME}"
"""What a function for numba is given."""

LONG = 1000
"""A loop with more lines than this is with a call: numba would take very long to compile it."""


@dataclass(frozen=True, slots=True)
class Array:
    """What the instances have one of each: its name, its NumPy type, and what it begins with.

    `seen`: it is on the blackboard, where the program that simulates sees and sets it.
    """

    name: str
    dtype: str
    initial: bool | int | float = 0
    seen: bool = False
    constants: tuple[tuple[str, int], ...] = ()
    """Of an enum: their names and numbers."""


@dataclass(frozen=True, slots=True)
class BatchCode:
    """The parts of a module: what the instances have, which steps there are, and both translations."""

    arrays: tuple[Array, ...]
    methods: Mapping[str, str]
    """The name of the step with each event that has one."""
    tables: tuple[str, ...]
    """What is said of the regions, as in the plain class."""
    for_numpy: tuple[str, ...]
    """Methods, indented as in a class."""
    for_numba: tuple[str, ...]
    """Functions of an instance, each before those that call it; and the loops over all instances."""


def generate_batch(code: PlainCode, variables: Sequence[Array]) -> BatchCode:
    """Both translations of a plain class that has no functions, messages or faults.

    `variables` are those on its blackboard.
    """
    functions = _functions(code)
    arrays = [*variables, *_slots(code, variables), Array("stuck", "?")]
    owners = {("bb" if item.seen else "self", item.name): item for item in arrays}
    kinds = {key: item.dtype for key, item in owners.items()}
    places = {key: _place(item, arrays) for key, item in owners.items()}
    pending = sorted({item.name.removeprefix("p_") for item in arrays if item.name.startswith("p_")})
    known = _Known(kinds, tuple(pending), frozenset(functions), places)
    events = {name.removeprefix(_ON): name for name in functions if name.startswith(_ON)}
    modes = (START, STEP, *events.values())
    for_numpy = [line for name, item in functions.items() for line in (*_ForNumpy(known, item).of(name), "")]
    called = {other for item in functions.values() for other in _called(item, functions)}
    loops = {name: _ForNumba(known, functions[name]).loop(name) for name in modes if name not in called}
    loops = {name: lines for name, lines in loops.items() if len(lines) <= LONG}
    for_numba: list[str] = []
    for name in _callees_first(functions):
        if name not in loops:
            for_numba += [*_ForNumba(known, functions[name]).of(name), "", ""]
    for name in modes:
        for_numba += [*(loops.get(name) or _calling_loop(name)), "", ""]
    return BatchCode(tuple(arrays), events, _tables(code), tuple(for_numpy), tuple(for_numba))


def _place(array: Array, arrays: Sequence[Array]) -> str:
    """Where numba finds a value of the instance `i`: all of one type are in a table, in this order."""
    same = [other for other in arrays if other.dtype == array.dtype]
    return f"{TABLES[array.dtype]}[i, {same.index(array)}]"


# ---- what was written ---------------------------------------------------------------------------

_ON = "on_"


@dataclass(frozen=True, slots=True)
class _Function:
    """A piece of the plain class: the statements, and whether they give a truth, a number or nothing."""

    body: tuple[ast.stmt, ...]
    gives: str


@dataclass(frozen=True, slots=True)
class _Known:
    """What a translation has to know of the whole."""

    kinds: Mapping[tuple[str, str], str]
    """The NumPy type of what the class (`self`) and its blackboard (`bb`) have."""
    pending: tuple[str, ...]
    functions: frozenset[str]
    places: Mapping[tuple[str, str], str]
    """Where numba finds it."""


def _functions(code: PlainCode) -> dict[str, _Function]:
    """The step of each mode (`start`, `step`, `on_EVENT`) and the methods that they call, by name."""
    tree = _WithoutFaults().visit(
        _Constants({**dict(code.numbers), "ROUNDS": ROUNDS}).visit(ast.parse("\n".join(code.body)))
    )
    (written,) = (node for node in tree.body if isinstance(node, ast.ClassDef))
    methods = {node.name: node for node in written.body if isinstance(node, ast.FunctionDef)}
    found: dict[str, _Function] = {}
    for name, method in methods.items():
        body = tuple(method.body[1:])  # without what it is for
        if name == "send":
            found |= {_ON + event: _Function(part, "bool") for event, part in _by_event(body, methods)}
        elif name not in ("__init__", "due") and not name.startswith("_on_"):
            returns = method.returns.id if isinstance(method.returns, ast.Name) else "None"
            found[name] = _Function(body, returns)
    return found


class _Constants(ast.NodeTransformer):
    """Names of constants become what they are."""

    def __init__(self, constants: Mapping[str, int]) -> None:
        self._constants = constants

    def visit_Name(self, node: ast.Name) -> ast.expr:
        return ast.Constant(self._constants[node.id]) if node.id in self._constants else node


_PRESENT = ast.Constant(True)
"""What is no longer asked."""


class _WithoutFaults(ast.NodeTransformer):
    """What may fail or be absent is refused: what is tried is done, and a condition has no arguments.

    What is true, false or absent is `(v := True if C else False if D else None) is not None` before it is
    used. Here it is never absent, and `v` is C.
    """

    def __init__(self) -> None:
        self._truths: dict[str, ast.expr] = {}

    def visit_Try(self, node: ast.Try) -> list[ast.stmt]:
        self.generic_visit(node)
        return node.body

    def visit_If(self, node: ast.If) -> ast.AST | list[ast.stmt] | None:
        if ast.unparse(node.test) == "self.faulty":
            return None
        self.generic_visit(node)
        return node.body if node.test is _PRESENT else node

    def visit_Compare(self, node: ast.Compare) -> ast.AST:
        match node:
            case ast.Compare(
                left=ast.NamedExpr(target=target, value=ast.IfExp(test=test)), ops=[ast.IsNot()]
            ):
                self._truths[target.id] = self.visit(test)
                return _PRESENT
        return self.generic_visit(node)

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.AST:
        self.generic_visit(node)
        if isinstance(node.op, ast.And):
            node.values = [value for value in node.values if value is not _PRESENT] or [_PRESENT]
        return node if len(node.values) > 1 else node.values[0]

    def visit_Name(self, node: ast.Name) -> ast.expr:
        return deepcopy(self._truths[node.id]) if node.id in self._truths else node

    def visit_Call(self, node: ast.Call) -> ast.AST:
        if re.fullmatch(r"self\._holds_\d+", ast.unparse(node.func)):
            node.args.clear()
        return self.generic_visit(node)


def _by_event(
    body: Sequence[ast.stmt], methods: Mapping[str, ast.FunctionDef]
) -> Iterator[tuple[str, tuple[ast.stmt, ...]]]:
    """What `send` does with each event."""
    statement = body[0]
    while isinstance(statement, ast.If) and isinstance(statement.test, ast.Compare):
        (event,) = statement.test.comparators
        assert isinstance(event, ast.Constant)
        if isinstance(statement.test.ops[0], ast.NotEq):  # there is one only, and with others it has ended
            yield str(event.value), tuple(body[1:])
            return
        part = tuple(statement.body)
        own = re.fullmatch(r"return self\.(_on_\w+)\(\)", ast.unparse(part[0]))
        yield str(event.value), tuple(methods[own[1]].body[1:]) if own is not None else part
        if not statement.orelse:
            return
        statement = statement.orelse[0]
    if ast.unparse(statement).startswith("method = _EVENTS"):  # many events are found in a table
        for name, method in methods.items():
            if name.startswith("_on_"):
                yield name.removeprefix("_on_"), tuple(method.body[1:])


def _slots(code: PlainCode, variables: Sequence[Array]) -> Iterator[Array]:
    """What the class keeps: regions, times, counts, copies of variables, and what was written of these."""
    (line,) = (line for line in code.body if line.lstrip().startswith("__slots__"))
    by_name = {item.name: item for item in variables}
    for name in re.findall(r'"(\w+)"', line):
        copy = re.fullmatch(r"v\d+_(\w+)", name)
        if copy is not None:
            yield Array(name, by_name[copy[1]].dtype)
        elif name not in ("bb", "writes", "now", "faulty"):
            yield Array(name, "?" if f"    {name}: bool" in code.body else "i8")
    for name in sorted(set(re.findall(r"self\.writes = \(\d+, '(\w+)'", "\n".join(code.body)))):
        yield Array(f"w_{name}", by_name[name].dtype)
        yield Array(f"p_{name}", "i8", -1)


def _tables(code: PlainCode) -> tuple[str, ...]:
    """The lines that say which leaves the regions have, which regions an AND has, what runs and circles."""
    first = next(place for place, line in enumerate(code.body) if line.startswith("    NAMES"))
    last = next(place for place, line in enumerate(code.body) if place > first and not line)
    lines = code.body[first:last]
    return tuple(re.sub(r": ClassVar\[.*\] = ", " = ", line) for line in lines if "MESSAGES" not in line)


def _called(function: _Function, functions: Iterable[str]) -> list[str]:
    """Which of the functions a function calls."""
    text = "\n".join(map(ast.unparse, function.body))
    return [other for other in functions if f"self.{other}()" in text]


def _callees_first(functions: Mapping[str, _Function]) -> list[str]:
    """The names of functions, each behind those that it calls. None calls itself."""
    found: list[str] = []
    waiting = list(functions)[::-1]
    while waiting:
        name = waiting[-1]
        called = [other for other in _called(functions[name], functions) if other not in found]
        if called:
            waiting += called
            continue
        waiting.pop()
        if name not in found:
            found.append(name)
    return found


# ---- translating --------------------------------------------------------------------------------


@dataclass(slots=True)
class _Translation:
    """What both translations have in common: the statements and expressions that `plain.py` writes."""

    known: _Known
    function: _Function
    lines: list[str] = field(default_factory=list)
    truths: set[str] = field(default_factory=set)
    """The locals that are true or false; the others are numbers."""
    aliases: set[str] = field(default_factory=set)
    """The locals that are the number of a region as it was when it was looked at."""
    count: int = 0

    def __post_init__(self) -> None:
        for node in ast.walk(ast.Module(list(self.function.body), [])):
            if isinstance(node, ast.Assign):
                for target in node.targets:
                    if not isinstance(target, ast.Name):
                        continue
                    if isinstance(node.value, ast.Constant) and isinstance(node.value.value, bool):
                        self.truths.add(target.id)
                    elif ast.unparse(node) == f"{target.id} = self.{target.id}":
                        self.aliases.add(target.id)

    @property
    def locals(self) -> list[str]:
        """The locals that need a place, in the order in which they come."""
        names: dict[str, None] = {}
        for node in ast.walk(ast.Module(list(self.function.body), [])):
            if isinstance(node, ast.Assign):
                for target in node.targets:
                    if isinstance(target, ast.Name) and target.id not in (*self.aliases, "bb", "now"):
                        names[target.id] = None
        return list(names)

    def kind(self, node: ast.expr) -> str:
        """Whether an expression is a truth (`?`), a whole number or another."""
        match node:
            case ast.Compare() | ast.BoolOp() | ast.UnaryOp(op=ast.Not()):
                return "?"
            case ast.Constant(value=bool()):
                return "?"
            case ast.Attribute(value=ast.Name(owner), attr=name):
                return self.known.kinds[owner, name]
            case ast.Name(id=name):
                return "?" if name in self.truths else "i8"
        return "i8"

    def writes(self, node: ast.stmt) -> tuple[int, str, ast.expr] | None:
        """The region, the variable and the value of `self.writes = (region, name, value, self.writes)`."""
        match node:
            case ast.Assign(
                targets=[ast.Attribute(attr="writes")],
                value=ast.Tuple(
                    elts=[ast.Constant(value=int(region)), ast.Constant(value=str(name)), value, _]
                ),
            ):
                return region, name, value
        return None

    def called(self, node: ast.AST) -> str | None:
        """The method that `self.name()` calls."""
        match node:
            case ast.Call(func=ast.Attribute(value=ast.Name("self"), attr=name), args=[]):
                assert name in self.known.functions, name
                return name
        return None


def _is_spreading(node: ast.stmt) -> bool:
    return isinstance(node, ast.If) and ast.unparse(node.test) == "self.writes is not None"


def _exits(node: ast.stmt) -> bool:
    """Whether a statement may end the function, or the loop that it stands in."""
    return any(isinstance(item, ast.Return | ast.Break | ast.Raise) for item in ast.walk(node))


def _unknown(node: ast.AST) -> AssertionError:
    return AssertionError(f"a plain class has no {ast.unparse(node)}")


class _ForNumpy(_Translation):
    """A method over the instances `sel`; what it gives stands in their order."""

    def of(self, name: str) -> list[str]:
        gives = self.function.gives
        self.line(1, f"def do_{name}(self, sel: Selection) -> {'None' if gives == 'None' else 'Any'}:")
        text = "\n".join(map(ast.unparse, self.function.body))
        if re.search(r"\bbb\b|self\.writes", text):
            self.line(2, "bb = self.bb")
        if re.search(r"\bnow\b", text):
            self.line(2, "now = self.now")
        for local in self.locals:
            self.line(2, f"{local} = self.nothing({'bool' if local in self.truths else 'int'})")
        if gives != "None":
            self.line(2, f"out = self.nothing({gives})")
        last = self.function.body[-1]
        early = self.function.body[:-1] if isinstance(last, ast.Return) else self.function.body
        if any(isinstance(item, ast.Return) for node in early for item in ast.walk(node)):
            self.line(2, "here = self.all()")
        self.block(2, self.function.body, "sel", is_whole=True)
        if gives != "None":
            self.line(2, "return out[sel]")
        return [*self.lines, "        pass"] if len(self.lines) == 1 else self.lines

    def line(self, depth: int, text: str) -> None:
        self.lines.append("    " * depth + text)

    def new(self, letter: str) -> str:
        self.count += 1
        return f"{letter}{self.count}"

    def block(
        self, depth: int, statements: Sequence[ast.stmt], sel: str, loop: str = "", *, is_whole: bool = False
    ) -> None:
        """Statements, the later of them for those instances that the earlier have left here.

        `is_whole`: they are all that there is.
        """
        for place, node in enumerate(statements):
            self.statement(depth, node, sel, loop, is_last=is_whole and place + 1 == len(statements))
            if place + 1 == len(statements) or isinstance(node, ast.While) or not _exits(node):
                continue
            stays = [f"{loop}[{sel}]"] if loop else []
            if any(isinstance(item, ast.Return) for item in ast.walk(node)):
                stays.append(f"here[{sel}]")
            rest = self.new("s")
            self.line(depth, f"{rest} = pick({sel}, {' & '.join(stays)})")
            sel = rest

    def statement(self, depth: int, node: ast.stmt, sel: str, loop: str, *, is_last: bool) -> None:
        written = self.writes(node)
        if written is not None:
            self.write(depth, *written, sel)
        elif isinstance(node, ast.If) and _is_spreading(node):
            self.spread(depth, sel)
        else:
            self.plain(depth, node, sel, loop, is_last=is_last)

    def plain(self, depth: int, node: ast.stmt, sel: str, loop: str, *, is_last: bool) -> None:
        match node:
            case ast.Assign(targets=targets, value=value):
                targets = [t for t in targets if not self.is_passing(t)]
                code = self.value(value, sel) if targets else ""
                for target in targets:
                    self.line(depth, f"{self.place(target)}[{sel}] = {code}")
            case ast.AugAssign(target=target, op=operator, value=value):
                sign = _SIGNS[type(operator)]
                self.line(depth, f"{self.place(target)}[{sel}] {sign}= {self.value(value, sel)}")
            case ast.If(test=test, body=body, orelse=otherwise):
                found, inner = self.new("t"), self.new("s")
                self.line(depth, f"{found} = {self.truth(test, sel)}")
                self.line(depth, f"{inner} = pick({sel}, {found})")
                rest = self.new("s") if otherwise else ""
                if rest:  # before the body, since what was found may be a view of what the body writes
                    self.line(depth, f"{rest} = pick({sel}, ~{found})")
                self.line(depth, f"if {inner}.size:")
                self.block(depth + 1, body, inner, loop)
                if rest:
                    self.block(depth, otherwise, rest, loop)
            case ast.While(body=body):
                self.line(depth, f"live, looping = {sel}, self.all()")
                self.line(depth, "while True:")
                self.block(depth + 1, body, "live", "looping")
                self.line(depth + 1, "live = pick(live, looping[live])")
                self.line(depth + 1, "if not live.size:")
                self.line(depth + 2, "break")
            case ast.Break():
                self.line(depth, f"{loop}[{sel}] = False")
            case ast.Raise():
                self.line(depth, f"self.stuck[{sel}] = True")
                self.line(depth, f"{loop}[{sel}] = False")
            case ast.Return(value=value):
                assert value is not None
                self.line(depth, f"out[{sel}] = {self.value(value, sel)}")
                if not is_last:
                    self.line(depth, f"here[{sel}] = False")
            case ast.Expr(value=ast.Call() as call) if self.called(call):
                self.line(depth, self.value(call, sel))
            case ast.Pass() | ast.Expr(value=ast.Constant() | ast.Attribute() | ast.Compare() | ast.BoolOp()):
                self.line(depth, "pass")
            case _:
                raise _unknown(node)

    def is_passing(self, target: ast.expr) -> bool:
        return isinstance(target, ast.Name) and target.id in (*self.aliases, "bb", "now")

    def write(self, depth: int, region: int, name: str, value: ast.expr, sel: str) -> None:
        """What a region writes counts more than what those before it in the document have written."""
        later = self.new("s")
        self.line(depth, f"{later} = pick({sel}, self.p_{name}[{sel}] <= {region})")
        self.line(depth, f"self.p_{name}[{later}] = {region}")
        self.line(depth, f"self.w_{name}[{later}] = {self.value(value, later)}")

    def spread(self, depth: int, sel: str) -> None:
        for name in self.known.pending:
            written = self.new("s")
            self.line(depth, f"{written} = pick({sel}, self.p_{name}[{sel}] >= 0)")
            self.line(depth, f"bb.{name}[{written}] = self.w_{name}[{written}]")
            self.line(depth, f"self.p_{name}[{written}] = -1")

    def place(self, target: ast.expr) -> str:
        match target:
            case ast.Attribute(value=ast.Name("bb" | "self"), attr=_) | ast.Name():
                return ast.unparse(target)
        raise _unknown(target)

    def truth(self, node: ast.expr, sel: str) -> str:
        if _is_constant(node):
            return f"self.everywhere({bool(_folded(node))})[{sel}]"
        code = self.value(node, sel)
        return code if self.kind(node) == "?" else f"({code} != 0)"

    def value(self, node: ast.expr, sel: str) -> str:
        match node:
            case ast.Constant(value=bool() | int() | float() as value):
                return repr(value)
            case ast.Name(id="now"):
                return "now"
            case ast.Name(id=name) if name in self.aliases:
                return f"self.{name}[{sel}]"
            case ast.Name() | ast.Attribute():
                return f"{self.place(node)}[{sel}]"
            case ast.UnaryOp(op=ast.Not(), operand=operand):
                return f"~{self.truth(operand, sel)}"
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return f"-{self.value(operand, sel)}"
            case ast.BoolOp(op=operator, values=values):
                sign = " & " if isinstance(operator, ast.And) else " | "
                return f"({sign.join(self.truth(value, sel) for value in values)})"
            case ast.Compare(left=left, ops=operators, comparators=rest):
                sides = [self.value(side, sel) for side in (left, *rest)]
                tests = [
                    f"({sides[place]} {_SIGNS[type(operator)]} {sides[place + 1]})"
                    for place, operator in enumerate(operators)
                ]
                return tests[0] if len(tests) == 1 else f"({' & '.join(tests)})"
            case ast.BinOp(left=left, op=operator, right=right):
                # To NumPy the sum of two truths is a truth.
                one, other = (
                    f"{self.value(side, sel)} * 1" if self.kind(side) == "?" else self.value(side, sel)
                    for side in (left, right)
                )
                return f"({one} {_SIGNS[type(operator)]} {other})"
            case ast.Call(func=ast.Name(id=name), args=values) if name in _BUILT_IN:
                return _BUILT_IN[name]([self.value(value, sel) for value in values])
            case ast.Call() if (called := self.called(node)) is not None:
                return f"self.do_{called}({sel})"
        raise _unknown(node)


_SIGNS: Mapping[type[ast.AST], str] = {
    ast.Add: "+",
    ast.Sub: "-",
    ast.Mult: "*",
    ast.Div: "/",
    ast.FloorDiv: "//",
    ast.Mod: "%",
    ast.BitAnd: "&",
    ast.BitOr: "|",
    ast.Eq: "==",
    ast.NotEq: "!=",
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Is: "==",
    ast.IsNot: "!=",
}


_OPERATIONS: Mapping[type[ast.AST], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Is: operator.is_,
    ast.IsNot: operator.is_not,
}


def _is_constant(node: ast.expr) -> bool:
    """Whether nothing in an expression differs from instance to instance."""
    return all(
        not isinstance(item, ast.Name | ast.Attribute) or (isinstance(item, ast.Name) and item.id in _FOLDED)
        for item in ast.walk(node)
    )


def _folded(node: ast.expr) -> Any:
    """What an expression of constants gives, for which no array says how many there are of it."""
    match node:
        case ast.Constant(value=value):
            return value
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            return not _folded(operand)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -_folded(operand)
        case ast.BoolOp(op=sign, values=values):
            folded = [_folded(value) for value in values]
            return all(folded) if isinstance(sign, ast.And) else any(folded)
        case ast.BinOp(left=left, op=sign, right=right):
            return _OPERATIONS[type(sign)](_folded(left), _folded(right))
        case ast.Compare(left=left, ops=signs, comparators=rest):
            sides = [_folded(side) for side in (left, *rest)]
            pairs = zip(signs, sides, sides[1:], strict=False)
            return all(_OPERATIONS[type(sign)](one, other) for sign, one, other in pairs)
        case ast.Call(func=ast.Name(id=name), args=values) if name in _FOLDED:
            return _FOLDED[name](*map(_folded, values))
    raise _unknown(node)


_FOLDED: Mapping[str, Callable[..., Any]] = {"abs": abs, "float": float, "int": int, "max": max, "min": min}


def _nested(function: str) -> Callable[[Sequence[str]], str]:
    def write(values: Sequence[str]) -> str:
        code = values[0]
        for value in values[1:]:
            code = f"{function}({code}, {value})"
        return code

    return write


_BUILT_IN: Mapping[str, Callable[[Sequence[str]], str]] = {
    "abs": lambda values: f"abs({values[0]})",
    "float": lambda values: f"({values[0]} * 1.0)",
    "int": lambda values: f"whole({values[0]})",
    "max": _nested("larger"),
    "min": _nested("smaller"),
}


class _ForNumba(_Translation):
    """A function of the instance `i`, given all arrays, or the loop over all instances."""

    def of(self, name: str) -> list[str]:
        head = f"def do_{name}({ARGUMENTS}):"
        body = _Elements(self).all(self.function.body)
        if (self.function.gives == "bool" or name == START) and not isinstance(
            self.function.body[-1], ast.Return
        ):
            body.append("return False")
        return ["@compiled", head, *(f"    {line}" for line in body or ["pass"])]

    def loop(self, name: str) -> list[str]:
        """All instances, without a call for each: with so many arrays that takes as long as a step."""
        body = _Elements(self, in_loop=True).all(self.function.body)
        if body and body[-1] == "continue":
            del body[-1]
        return [*_loop(name), *(f"            {line}" for line in ("out[i] = False", *body))]


def _calling_loop(name: str) -> list[str]:
    """The loop over all instances with a call, for what others call, too, or what is long."""
    return [*_loop(name), f"            out[i] = do_{name}({ARGUMENTS})"]


def _loop(name: str) -> list[str]:
    """How a loop over all instances begins; `out` says which make the step, and then what came of it."""
    return [
        "@compiled",
        f"def each_{name}(out, {TABLES_AND_TIME}):",
        "    for i in range(len(out)):",
        "        if out[i]:",
    ]


class _Elements(ast.NodeTransformer):
    """Slots and values on the blackboard become elements of arrays."""

    def __init__(self, translation: _ForNumba, *, in_loop: bool = False) -> None:
        self._translation = translation
        self._known = translation.known
        self._in_loop = in_loop

    def all(self, nodes: Iterable[ast.stmt]) -> list[str]:
        return [line for node in nodes for line in self.lines(node)]

    def lines(self, node: ast.stmt) -> list[str]:
        if isinstance(node, ast.Assign) and ast.unparse(node) in ("bb = self.bb", "now = self.now"):
            return []
        changed = self.visit(node)
        nodes = changed if isinstance(changed, list) else [changed]
        return [line for item in nodes for line in ast.unparse(ast.fix_missing_locations(item)).splitlines()]

    def visit_Attribute(self, node: ast.Attribute) -> ast.AST:
        assert isinstance(node.value, ast.Name), ast.unparse(node)
        return ast.parse(self._known.places[node.value.id, node.attr], mode="eval").body

    def visit_Call(self, node: ast.Call) -> ast.AST:
        called = self._translation.called(node)
        if called is not None:
            return ast.parse(f"do_{called}({ARGUMENTS})", mode="eval").body
        assert isinstance(node.func, ast.Name) and node.func.id in _BUILT_IN, ast.unparse(node)
        return self.generic_visit(node)

    def visit_Assign(self, node: ast.Assign) -> ast.AST | list[ast.stmt]:
        written = self._translation.writes(node)
        if written is None:
            return self.generic_visit(node)
        region, name, value = written
        new = ast.unparse(self.visit(value))
        by, what = (self._known.places["self", f"{letter}_{name}"] for letter in "pw")
        return ast.parse(f"if {by} <= {region}:\n    {by} = {region}\n    {what} = {new}").body

    def visit_If(self, node: ast.If) -> ast.AST | list[ast.stmt]:
        if not _is_spreading(node):
            return self.generic_visit(node)
        return [
            item
            for name in self._known.pending
            for by, what in [[self._known.places["self", f"{letter}_{name}"] for letter in "pw"]]
            for item in ast.parse(
                f"if {by} >= 0:\n    {self._known.places['bb', name]} = {what}\n    {by} = -1"
            ).body
        ]

    def visit_While(self, node: ast.While) -> ast.AST:
        if any(isinstance(item, ast.Return) for item in ast.walk(node)):
            raise _unknown(node)
        return self.generic_visit(node)

    def visit_Return(self, node: ast.Return) -> ast.AST | list[ast.stmt]:
        changed = self.generic_visit(node)
        if not self._in_loop:
            return changed
        assert isinstance(changed, ast.Return) and changed.value is not None
        return [*ast.parse(f"out[i] = {ast.unparse(changed.value)}").body, ast.Continue()]

    def visit_Raise(self, node: ast.Raise) -> list[ast.stmt]:
        return [*ast.parse(f"{self._known.places['self', 'stuck']} = True").body, ast.Break()]
