"""Expressions to Python: conditions in two forms (it holds, it fails), values with what must be present.

The three-valued logic of absent messages disappears at compile time: a condition is emitted as the Python
condition under which it is true, its negation as the one under which it is false.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

from aseme_dsl.amola.expression import (
    Age,
    Arithmetic,
    At,
    Bound,
    Call,
    Compare,
    Contains,
    Element,
    EnumConstant,
    Expired,
    Has,
    Holds,
    Index,
    ListValue,
    Literal,
    Logic,
    Mean,
    Member,
    Named,
    Negate,
    Not,
    Outcome,
    ParameterValue,
    Random,
    Sender,
    Size,
    StateValue,
    Value,
    VariableValue,
    walk,
)
from aseme_dsl.amola.messages import AGENT, DOUBLE, DURATION, INT, EnumType, Type, list_of
from aseme_dsl.amola.python_names import kept_apart

Known = Mapping[str, str]
"""Slots that are known to hold a message at this point, with the local name of the message."""

NOTHING: Known = MappingProxyType({})


LOCAL = "\x01"
"""May stand before the name of a local until its method is written: nothing of a document looks like that."""


@dataclass(frozen=True, slots=True)
class Piece:
    """Python code of a value; `needs` must hold before it may be evaluated, in this order."""

    code: str
    needs: tuple[str, ...] = ()
    known: Known = field(default_factory=lambda: NOTHING)


def _none(activity: str) -> tuple[str, ...]:
    return ()


def _nowhere(value: StateValue) -> str:
    raise LookupError(f"no transition asks {value.question}({value.state})")


def _by_key(call: Call, arguments: Sequence[str]) -> str:
    return f"self.call({', '.join([repr(function_key(call)), *arguments])})"


def _of_board(timer: str) -> str:
    return f"b.timers.get({timer!r}, NEVER)"


def _of_engine(labels: tuple[str, ...]) -> str:
    return f"self.outcomes.get({labels[0]!r})" if len(labels) == 1 else f"self.last_outcome({labels!r})"


@dataclass
class Names:
    """The names of one generated method and what the emitted code turned out to use."""

    slots: Mapping[tuple[str, str | None], str]
    """The code that reads the message of (channel, host)."""
    variables: Mapping[str, str]
    """The code that reads each variable."""
    fields: Mapping[tuple[str, str], tuple[bool, str]] = field(default_factory=dict)
    """For (message, field) whether it may be absent in a message that is there, and its type's name."""
    constants: Mapping[tuple[str, str], str] = field(default_factory=dict)
    """The names of the constants of enums."""
    enums: set[tuple[str, str]] = field(default_factory=set)
    """The enums' constants that are used."""
    outcomes: Callable[[str], tuple[str, ...]] = _none
    """The states whose outcome is asked for by an activity's name."""
    last_outcome: Callable[[tuple[str, ...]], str] = _of_engine
    """The code for the outcome of that of some states which was entered or has ended last."""
    states: Callable[[StateValue], str] = _nowhere
    """The code that answers a question about a state."""
    timer: Callable[[str], str] = _of_board
    """The code for the moment at which a timer runs out."""
    called: Callable[[Call, Sequence[str]], str] = _by_key
    """The code that calls a function of the document."""
    prefix: str = ""
    mail: str = ""
    """The local name of the agent message that the transition takes."""
    now: str = "now"
    """The code for the time of the step."""
    locals: int = 0
    may_raise: bool = False

    def local(self) -> str:
        self.locals += 1
        return f"m{self.prefix}{self.locals}"


def function_key(call: Call) -> str:
    """The name by which a plan knows an overload: `can_kick(Ball)`."""
    return f"{call.function.name}({', '.join(str(kind) for _, kind in call.function.parameters)})"


def constant_names(enums: Iterable[EnumType], taken: Iterable[str]) -> dict[tuple[str, str], str]:
    """The module-level names of enum constants: a global is read faster than an enum's attribute.

    Each has its own, and none of those that are taken: `A.B_C` is `A_B_C`, and `A_B.C` is `A_B_C_` then.
    """
    constants = ((enum.name, constant) for enum in enums for constant, _ in enum.constants)
    return kept_apart(((item, "_".join(item)) for item in constants), taken)


def holds(value: Value, names: Names, known: Known = NOTHING) -> tuple[str, Known]:
    """The Python condition under which `value` is true, and what is known where it is."""
    return _is(True, value, names, known)


def fails(value: Value, names: Names, known: Known = NOTHING) -> tuple[str, Known]:
    """The Python condition under which `value` is false, and what is known where it is."""
    return _is(False, value, names, known)


def _is(truth: bool, value: Value, names: Names, known: Known) -> tuple[str, Known]:
    match value:
        case Named(expression=inner):
            return _is(truth, inner, names, known)
        case Not(operand=operand):
            return _is(not truth, operand, names, known)
        case Logic(operator=operator, operands=parts):
            every = (operator == "&&") is truth  # a && b fails where one of them does
            codes = []
            for part in parts:
                code, after = _is(truth, part, names, known)
                codes.append(f"({code})" if not every and " and " in code else code)
                known = after if every else known
            return (" and ".join(codes) if every else f"({' or '.join(codes)})"), known
        case Has(message=message):
            if isinstance(message, Bound) or (isinstance(message, Member) and message.path):
                there = " and ".join(evaluate(message, names, known).needs)
                return there if truth else f"not ({there})", known
            return f"{_place(message, names)} is {'not ' if truth else ''}None", known
        case Holds(operand=operand):
            code, _ = _is(True, operand, names, known)
            return (f"({code})" if truth else f"not ({code})"), known
        case Literal(value=constant):
            return str(bool(constant) is truth), known
        case Contains():
            piece = _contains(value, "in" if truth else "not in", names, known)
            return " and ".join((*piece.needs, piece.code)), piece.known
    piece = evaluate(value, names, known)
    return " and ".join((*piece.needs, piece.code if truth else _negated(value, piece.code))), piece.known


def _negated(value: Value, code: str) -> str:
    if isinstance(value, Compare) and value.operator == "==" and code.count(" == ") == 1:
        return code.replace(" == ", " != ")
    return f"not {_wrapped(code)}"


def _wrapped(code: str) -> str:
    plain = code.replace(".", "").replace("_", "").removeprefix(LOCAL).isalnum()
    return code if plain or (code.startswith("self.call(") and code.count("(") == 1) else f"({code})"


def _place(message: Member | VariableValue, names: Names) -> str:
    """Where a message, or an agent, is looked for: None is there without one."""
    if isinstance(message, VariableValue):
        return names.variables[message.name]
    return _slot(message, names)


def _slot(message: Member, names: Names) -> str:
    return names.slots[str(message.channel), message.host]


def _present(message: Member, names: Names, known: Known) -> tuple[str, tuple[str, ...], Known]:
    """The local name of a message, what must hold for it to be there, what is known then."""
    slot = _slot(message, names)
    if slot in known:
        return known[slot], (), known
    local = names.local()
    return local, (f"({local} := {slot}) is not None",), {**known, slot: local}


def evaluate(value: Value, names: Names, known: Known = NOTHING) -> Piece:
    """Python code that computes a value, and what must be present for it."""
    match value:
        case Named(expression=inner):
            return evaluate(inner, names, known)
        case Literal(value=constant):
            return Piece(repr(constant), known=known)
        case EnumConstant(constant=constant, type=kind):
            names.enums.add((kind.name, constant))
            return Piece(names.constants[kind.name, constant], known=known)
        case ParameterValue(name=name):
            raise AssertionError(f"{name} is replaced where its formula is expanded")
        case VariableValue(name=name, type=kind):
            code = names.variables[name]
            if kind != AGENT:
                return Piece(code, known=known)
            local = names.local()
            return Piece(local, (f"({local} := {code}) is not None",), known)
        case Bound(message=message, path=path):
            return _path(f"{names.mail}.content", message, path, (), names, known)
        case Sender():
            return Piece(f"{names.mail}.sender", known=known)
        case Member():
            return _member(value, names, known)
        case Age(message=message):
            slot = _slot(message, names)
            _, needs, known = _present(message, names, known)
            return Piece(f"({names.now} - {slot}_time)", needs, known)
        case At(message=message, offset=offset):
            return _at(message, offset, names, known)
        case Mean(message=message, window=window):
            extent = evaluate(window, names, known)
            local = names.local()
            channel, member = str(message.channel), ".".join(message.path)
            call = f"b.mean({channel!r}, {message.host!r}, {names.now} - {_wrapped(extent.code)}, {member!r})"
            return Piece(local, (*extent.needs, f"({local} := {call}) is not None"), extent.known)
        case Expired(timer=timer):
            return Piece(f"{names.timer(timer)} <= {names.now}", known=known)
        case Outcome(activity=activity):
            return _outcome(activity, names, known)
        case Index():
            return Piece("self.index", known=known)
        case Random():
            return Piece("self.random()", known=known)
        case StateValue():
            return Piece(names.states(value), known=known)
        case Call():
            return _call(value, names, known)
        case ListValue():
            return _list(value, names, known)
        case Element():
            return _element(value, names, known)
        case Size(list=whole):
            piece = evaluate(whole, names, known)
            return Piece(f"len({piece.code})", piece.needs, piece.known)
        case Contains():
            return _contains(value, "in", names, known)
        case Compare(operator=operator, left=left, right=right):
            one, other = _pair(left, right, names, known)
            return Piece(f"{one.code} {operator} {other.code}", one.needs + other.needs, other.known)
        case Arithmetic():
            return _arithmetic(value, names, known)
        case Negate(operand=operand):
            piece = evaluate(operand, names, known)
            return Piece(f"(-{piece.code})", piece.needs, piece.known)
        case Not() | Logic() | Has() | Holds():
            return _truth(value, names, known)


def _pair(left: Value, right: Value, names: Names, known: Known) -> tuple[Piece, Piece]:
    one = evaluate(left, names, known)
    other = evaluate(right, names, one.known)
    return _in_parentheses(one, left), _in_parentheses(other, right)


def _in_parentheses(piece: Piece, value: Value) -> Piece:
    while isinstance(value, Named):
        value = value.expression
    if isinstance(value, Compare | Contains | Expired | StateValue):
        return Piece(f"({piece.code})", piece.needs, piece.known)
    return piece


def may_fail(value: Value) -> bool:
    """Whether a value may raise or be absent."""
    match value:
        case Call(function=function):
            return not function.target.startswith("builtin:")
        case Arithmetic():
            return _may_raise(value)
        case Member() | Element() | Outcome() | Age() | At() | Mean() | Bound() | Sender():
            return True
        case VariableValue(type=kind):
            return kind == AGENT
    return False


def _may_raise(value: Arithmetic) -> bool:
    """Whether there are numbers with which this raises: a zero to divide by, or an endless time.

    An `int` and a `duration` have 64 bits and so are never too large for a `double`, nor is a time that is
    multiplied by a number that a document can write.
    """
    if value.operator in ("/", "%"):
        return not _number(value.right)
    factors = [_number(item) for item in (value.left, value.right) if item.type == DOUBLE]
    return value.type == DURATION and None in factors


def _number(value: Value) -> float | None:
    """The number that a value always is, but for its sign; None if that is not known."""
    while isinstance(value, Named | Negate):
        value = value.expression if isinstance(value, Named) else value.operand
    if isinstance(value, Literal) and isinstance(value.value, int | float):
        return value.value
    return None


def _truth(value: Value, names: Names, known: Known) -> Piece:
    """A logic expression as a plain value: True, False, or absent where it neither holds nor fails."""
    if isinstance(value, Has):
        return Piece(f"({_is(True, value, names, known)[0]})", known=known)
    if isinstance(value, Holds):
        return Piece(f"({holds(value.operand, names, known)[0]})", known=known)
    yes, _ = holds(value, names, known)
    if not any(may_fail(part) for part in walk(value)):
        return Piece(f"({yes})", known=known)
    no, _ = fails(value, names, known)
    local = names.local()
    need = f"({local} := True if {yes} else False if {no} else None) is not None"
    return Piece(local, (need,), known)


def _member(value: Member, names: Names, known: Known) -> Piece:
    local, needs, known = _present(value, names, known)
    return _path(local, value.channel.message, value.path, needs, names, known)


def _path(
    local: str, message: str, path: tuple[str, ...], needs: tuple[str, ...], names: Names, known: Known
) -> Piece:
    code = local
    for step in path:
        code = f"{code}.{step}"
        is_optional, message = names.fields.get((message, step), (False, ""))
        if is_optional:
            inner = names.local()
            needs = (*needs, f"({inner} := {code}) is not None")
            code = inner
    return Piece(code, needs, known)


def _at(message: Member, offset: Value, names: Names, known: Known) -> Piece:
    extent = evaluate(offset, names, known)
    local = names.local()
    call = f"b.at({str(message.channel)!r}, {message.host!r}, {names.now} + {_wrapped(extent.code)})"
    needs = (*extent.needs, f"({local} := {call}) is not None")
    return _path(local, message.channel.message, message.path, needs, names, extent.known)


def _list(value: ListValue, names: Names, known: Known) -> Piece:
    """A tuple, as in messages."""
    codes: list[str] = []
    needs: tuple[str, ...] = ()
    for item in value.elements:
        piece = _in_parentheses(evaluate(item, names, known), item)
        codes.append(converted(piece, item.type, value.type.element or item.type))
        needs += piece.needs
        known = piece.known
    return Piece(f"({', '.join(codes)}{',' if len(codes) == 1 else ''})", needs, known)


def _element(value: Element, names: Names, known: Known) -> Piece:
    """An element, which must be there; a negative index is none here."""
    whole = evaluate(value.list, names, known)
    index = evaluate(value.index, names, whole.known)
    items, place = names.local(), names.local()
    there = f"len({items} := {whole.code}) > ({place} := {index.code}) >= 0"
    needs = (*whole.needs, *index.needs, there)
    element = value.list.type.element
    message = "" if element is None else element.name
    return _path(f"{items}[{place}]", message, value.path, needs, names, index.known)


def _contains(value: Contains, word: str, names: Names, known: Known) -> Piece:
    whole, wanted = _pair(value.list, value.value, names, known)
    return Piece(f"{wanted.code} {word} {whole.code}", whole.needs + wanted.needs, wanted.known)


def _outcome(activity: str, names: Names, known: Known) -> Piece:
    labels = names.outcomes(activity)
    local = names.local()
    return Piece(local, (f"({local} := {names.last_outcome(labels)}) is not None",), known)


def _call(value: Call, names: Names, known: Known) -> Piece:
    codes: list[str] = []
    needs: tuple[str, ...] = ()
    for argument in value.arguments:
        piece = _in_parentheses(evaluate(argument, names, known), argument)
        codes.append(piece.code)
        needs += piece.needs
        known = piece.known
    if value.function.target.startswith("builtin:"):
        return Piece(f"{value.function.target[8:]}({', '.join(codes)})", needs, known)
    names.may_raise = True
    return Piece(names.called(value, codes), needs, known)


def _arithmetic(value: Arithmetic, names: Names, known: Known) -> Piece:
    one, other = _pair(value.left, value.right, names, known)
    left, right = value.left.type, value.right.type
    operator = value.operator
    names.may_raise |= _may_raise(value)
    code = f"({one.code} {operator} {other.code})"
    if value.type == DURATION and DURATION in (left, right) and left != right:
        if operator == "/" and right == INT:
            code = f"({one.code} // {other.code})"
        elif DOUBLE in (left, right):
            code = f"int{code}"
    return Piece(code, one.needs + other.needs, other.known)


def converted(piece: Piece, source: Type, target: Type) -> str:
    """The code of a value as another type takes it: an int becomes a double, also those in a list."""
    if target == list_of(DOUBLE) and source == list_of(INT):
        return f"tuple(map(float, {piece.code}))"
    return f"float({piece.code})" if target == DOUBLE and source == INT else piece.code
