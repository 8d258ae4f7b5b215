"""Translates expressions to Python: conditions in a true and a false form, values with their requirements.

The three-valued logic of absent messages disappears at compile time. A condition becomes a Python condition
that holds where it is true; its negation becomes one that holds where it is false. A value comes with the
messages that must be present to compute it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field
from types import MappingProxyType

from aseme_dsl.amola.expression import (
    Age,
    Arithmetic,
    At,
    Bound,
    Call,
    Change,
    Changed,
    Compare,
    Conditional,
    Contains,
    Element,
    EnumConstant,
    Expired,
    Find,
    Has,
    Holds,
    Index,
    ListValue,
    Literal,
    Logic,
    LossReason,
    Mean,
    Member,
    Named,
    Negate,
    NewMessage,
    Not,
    Outcome,
    ParameterValue,
    Random,
    RoundValue,
    Sender,
    Size,
    StateValue,
    Value,
    VariableValue,
    walk,
)
from aseme_dsl.amola.messages import DOUBLE, DURATION, INT, PROBE, EnumType, Type, list_of
from aseme_dsl.amola.python_names import kept_apart
from aseme_dsl.codegen.code.tree import (
    NONE,
    NOW,
    All,
    Bind,
    CallOf,
    Choice,
    Compared,
    Const,
    EnumName,
    Expr,
    Field,
    Group,
    Infix,
    Item,
    Listed,
    Minus,
    Name,
    Negated,
    Truth,
    all_of,
    any_of,
    compared,
    inside,
    own,
    own_call,
)
from aseme_dsl.codegen.program.moves import may_raise, raises
from aseme_dsl.records import dataclass

Known = Mapping[Expr, Expr]
"""Where a message is known to be at this point, with the local that is it."""

NOTHING: Known = MappingProxyType({})


@dataclass(frozen=True, slots=True)
class Piece:
    """Python code of a value; `needs` must hold before it may be evaluated, in this order."""

    code: Expr
    needs: tuple[Expr, ...] = ()
    known: Known = field(default_factory=lambda: NOTHING)


def _none(activity: str) -> tuple[str, ...]:
    return ()


def _nowhere(value: StateValue) -> Expr:
    raise LookupError(f"no transition asks {value.question}({value.state})")


def _in_no_branch(value: RoundValue) -> Expr:
    raise LookupError(f"no transition of a participant asks {value.question}({value.participant})")


def _by_key(call: Call, arguments: Sequence[Expr]) -> Expr:
    return own_call("call", Const(function_key(call)), *arguments)


def _of_board(timer: str) -> Expr:
    timers = Field(Name("b"), "timers")
    return CallOf(Field(timers, "get"), (Const(timer), Name("NEVER")))


def _of_engine(labels: tuple[str, ...]) -> Expr:
    if len(labels) == 1:
        return CallOf(Field(own("outcomes"), "get"), (Const(labels[0]),))
    return own_call("last_outcome", Const(labels))


@dataclass
class Names:
    """The names of one generated method and what the emitted code turned out to use."""

    slots: Mapping[tuple[str, str | None], Expr]
    """The code that reads the message of (channel, sender)."""
    variables: Mapping[str, Expr]
    """The code that reads each variable."""
    fields: Mapping[tuple[str, str], tuple[bool, str]] = field(default_factory=dict)
    """For (message, field) whether it may be absent in a message that is there, and its type's name."""
    constants: Mapping[tuple[str, str], str] = field(default_factory=dict)
    """The names of the constants of enums."""
    enums: set[tuple[str, str]] = field(default_factory=set)
    """The enums' constants that are used."""
    outcomes: Callable[[str], tuple[str, ...]] = _none
    """The states whose outcome is asked for by an activity's name."""
    last_outcome: Callable[[tuple[str, ...]], Expr] = _of_engine
    """The code for the outcome of that of some states which was entered or has ended last."""
    states: Callable[[StateValue], Expr] = _nowhere
    """The code that answers a question about a state."""
    rounds: Callable[[RoundValue], Expr] = _in_no_branch
    """The code that counts the answers to what was sent."""
    timer: Callable[[str], Expr] = _of_board
    """The code for the moment at which a timer runs out."""
    called: Callable[[Call, Sequence[Expr]], Expr] = _by_key
    """The code that calls a function of the document."""
    message: Callable[[str], Expr] = Name
    """The code for the class of a message."""
    prefix: str = ""
    mail: str = ""
    """The local name of the agent message that the transition takes."""
    locals: int = 0

    def local(self) -> Name:
        self.locals += 1
        return Name(f"m{self.prefix}{self.locals}")


def function_key(call: Call) -> str:
    """The name by which a plan knows an overload: `can_kick(Ball)`."""
    return f"{call.function.name}({', '.join(str(kind) for _, kind in call.function.parameters)})"


def constant_names(enums: Iterable[EnumType], taken: Iterable[str]) -> dict[tuple[str, str], str]:
    """The module-level names of enum constants: a global is read faster than an enum's attribute.

    Each has its own, and none of those that are taken: `A.B_C` is `A_B_C`, and `A_B.C` is `A_B_C_` then.
    """
    constants = ((enum.name, constant) for enum in enums for constant, _ in enum.constants)
    return kept_apart(((item, "_".join(item)) for item in constants), taken)


def holds(value: Value, names: Names, known: Known = NOTHING) -> tuple[Expr, Known]:
    """The Python condition under which `value` is true, and what is known where it is."""
    return _is(True, value, names, known)


def fails(value: Value, names: Names, known: Known = NOTHING) -> tuple[Expr, Known]:
    """The Python condition under which `value` is false, and what is known where it is."""
    return _is(False, value, names, known)


def _is(truth: bool, value: Value, names: Names, known: Known) -> tuple[Expr, Known]:
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
                codes.append(code if every else in_brackets(code))
                known = after if every else known
            return all_of(codes) if every else Group(any_of(codes)), known
        case Has(message=message):
            if isinstance(message, Bound) or message.path:
                there = all_of(evaluate(message, names, known).needs)
                return there if truth else Negated(Group(there)), known
            return compared(_place(message, names), "is not" if truth else "is", NONE), known
        case Holds(operand=operand):
            code, _ = _is(True, operand, names, known)
            return (Group(code) if truth else Negated(Group(code))), known
        case Literal(value=constant):
            return Const(bool(constant) is truth), known
        case Call(function=function, arguments=(number, inner)) if function.target == PROBE:
            code, known = _is(truth, inner, names, known)
            return own_call("probe", evaluate(number, names).code, Group(code)), known
        case Contains():
            piece = _contains(value, "in" if truth else "not in", names, known)
            return all_of((*piece.needs, piece.code)), piece.known
    piece = evaluate(value, names, known)
    return all_of((*piece.needs, piece.code if truth else _negated(value, piece.code))), piece.known


def in_brackets(code: Expr) -> Expr:
    """A condition as a part of `or`: in brackets if there is an `and` in it."""
    return Group(code) if any(isinstance(part, All) for part in inside(code)) else code


def _negated(value: Value, code: Expr) -> Expr:
    if isinstance(value, Compare) and value.operator == "==" and isinstance(code, Compared):
        equals = sum(isinstance(part, Compared) and part.rest[0][0] == "==" for part in inside(code))
        if equals == 1:
            return Compared(code.left, (("!=", code.rest[0][1]),))
    return Negated(_wrapped(code))


def _wrapped(code: Expr) -> Expr:
    return code if _is_word(code) else Group(code)


def _is_word(code: Expr) -> bool:
    """Whether an expression is one word, perhaps with dots in it."""
    match code:
        case Name() | EnumName():
            return True
        case Field(base=base):
            return _is_word(base)
        case Const(value=bool() | None):
            return True
        case Const(value=int() | float() as number):
            return number >= 0 and "-" not in repr(number)
    return False


def _place(message: Member | VariableValue, names: Names) -> Expr:
    """Where a message, or an agent, is looked for: None is there without one."""
    if isinstance(message, VariableValue):
        return names.variables[message.name]
    return _slot(message, names)


def _slot(message: Member, names: Names) -> Expr:
    return names.slots[str(message.channel), message.host]


def _there(local: Name, code: Expr) -> Expr:
    """Whether what some code gives is there, and is the local then."""
    return compared(Group(Bind(local, code)), "is not", NONE)


def _present(message: Member, names: Names, known: Known) -> tuple[Expr, tuple[Expr, ...], Known]:
    """The local of a message, what must hold for it to be there, what is known then."""
    slot = _slot(message, names)
    if slot in known:
        return known[slot], (), known
    local = names.local()
    return local, (_there(local, slot),), {**known, slot: local}


def evaluate(value: Value, names: Names, known: Known = NOTHING) -> Piece:
    """Python code that computes a value, and what must be present for it."""
    match value:
        case Named(expression=inner):
            return evaluate(inner, names, known)
        case Literal(value=constant, type=kind):
            return Piece(NONE if kind.begins_unset else Const(constant), known=known)
        case EnumConstant(constant=constant, type=kind, number=number):
            names.enums.add((kind.name, constant))
            return Piece(EnumName(names.constants[kind.name, constant], number), known=known)
        case ParameterValue(name=name):
            raise AssertionError(f"{name} is replaced where its formula is expanded")
        case VariableValue(name=name, type=kind, path=path):
            code = names.variables[name]
            if not value.may_be_unset:
                return Piece(code, known=known)
            local = names.local()
            return _path(local, value.message or kind.name, path, (_there(local, code),), names, known)
        case Bound(message=message, path=path):
            return _path(Field(Name(names.mail), "content"), message, path, (), names, known)
        case Sender():
            return Piece(Field(Name(names.mail), "sender"), known=known)
        case LossReason():
            return Piece(Field(Name(names.mail), "content"), known=known)
        case Member():
            return _member(value, names, known)
        case Age(message=message):
            if isinstance(message, Bound):
                return Piece(Group(Infix("-", NOW, Field(Name(names.mail), "since"))), known=known)
            slot = _slot(message, names)
            assert isinstance(slot, Field), "only what an agent knows has an age"
            _, needs, known = _present(message, names, known)
            measured = Field(slot.base, f"{slot.name}_time")
            return Piece(Group(Infix("-", NOW, measured)), needs, known)
        case At(message=message, offset=offset):
            return _at(message, offset, names, known)
        case Mean(message=message, window=window):
            extent = evaluate(window, names, known)
            local = names.local()
            channel, member = str(message.channel), ".".join(message.path)
            since = Infix("-", NOW, _wrapped(extent.code))
            given = (Const(channel), Const(message.host), since, Const(member))
            call = CallOf(Field(Name("b"), "mean"), given)
            return Piece(local, (*extent.needs, _there(local, call)), extent.known)
        case Expired(timer=timer):
            return Piece(compared(names.timer(timer), "<=", NOW), known=known)
        case Outcome(activity=activity):
            return _outcome(activity, names, known)
        case Index():
            return Piece(own("index"), known=known)
        case Random():
            return Piece(own_call("random"), known=known)
        case StateValue():
            return Piece(names.states(value), known=known)
        case RoundValue():
            return Piece(names.rounds(value), known=known)
        case Call():
            return _call(value, names, known)
        case ListValue():
            return _list(value, names, known)
        case Element():
            return _element(value, names, known)
        case Size(list=whole):
            piece = evaluate(whole, names, known)
            return Piece(CallOf(Name("len"), (piece.code,)), piece.needs, piece.known)
        case Contains():
            return _contains(value, "in", names, known)
        case Find():
            return _find(value, names, known)
        case Changed():
            return _changed(value, names, known)
        case NewMessage():
            return _new(value, names, known)
        case Compare(operator=operator, left=left, right=right):
            one, other = _pair(left, right, names, known)
            return Piece(compared(one.code, operator, other.code), one.needs + other.needs, other.known)
        case Arithmetic():
            return _arithmetic(value, names, known)
        case Negate(operand=operand):
            piece = evaluate(operand, names, known)
            return Piece(Group(Minus(piece.code)), piece.needs, piece.known)
        case Conditional():
            return _conditional(value, names, known)
        case Not() | Logic() | Has() | Holds():
            return _truth(value, names, known)


def _conditional(value: Conditional, names: Names, known: Known) -> Piece:
    """One of two values: what the other one needs does not matter."""
    test = _in_parentheses(evaluate(value.condition, names, known), value.condition)
    local = names.local()
    yes = evaluate(value.yes, names, test.known)
    no = evaluate(value.no, names, test.known)
    codes = [converted(piece, part.type, value.type) for piece, part in ((yes, value.yes), (no, value.no))]
    is_sure = not test.needs and not any(may_fail(part) for part in walk(value.condition))
    if is_sure and not yes.needs and not no.needs:
        return Piece(Group(Choice(test.code, *map(Group, codes))), known=known)
    # One expression gives the value, or None: so a type checker sees that what each one needs is there.
    found = [
        Group(Choice(all_of(part.needs), Group(code), NONE)) if part.needs else Group(code)
        for part, code in ((yes, codes[0]), (no, codes[1]))
    ]
    return Piece(local, (*test.needs, _there(local, Choice(test.code, *found))), test.known)


def _pair(left: Value, right: Value, names: Names, known: Known) -> tuple[Piece, Piece]:
    one = evaluate(left, names, known)
    other = evaluate(right, names, one.known)
    return _in_parentheses(one, left), _in_parentheses(other, right)


def _in_parentheses(piece: Piece, value: Value) -> Piece:
    while isinstance(value, Named):
        value = value.expression
    if isinstance(value, Compare | Contains | Expired | StateValue):
        return Piece(Group(piece.code), piece.needs, piece.known)
    return piece


def may_fail(value: Value) -> bool:
    """Whether a value may raise or be absent."""
    match value:
        case Call(function=function):
            return function.is_of_document
        case Arithmetic():
            return may_raise(value)
        case (
            NewMessage()
            | Member()
            | Element()
            | Find()
            | Outcome()
            | Age()
            | At()
            | Mean()
            | Bound()
            | Sender()
            | LossReason()
        ):
            return True
        case VariableValue():
            return value.may_be_unset
    return False


def _truth(value: Value, names: Names, known: Known) -> Piece:
    """A logic expression as a plain value: True, False, or absent where it neither holds nor fails."""
    if isinstance(value, Has):
        return Piece(Group(_is(True, value, names, known)[0]), known=known)
    if isinstance(value, Holds):
        return Piece(Group(holds(value.operand, names, known)[0]), known=known)
    yes, _ = holds(value, names, known)
    if not any(may_fail(part) for part in walk(value)):
        return Piece(Group(yes), known=known)
    no, _ = fails(value, names, known)
    local = names.local()
    return Piece(local, (_there(local, Truth(yes, no)),), known)


def _member(value: Member, names: Names, known: Known) -> Piece:
    local, needs, known = _present(value, names, known)
    return _path(local, value.channel.message, value.path, needs, names, known)


def _path(
    local: Expr, message: str, path: tuple[str, ...], needs: tuple[Expr, ...], names: Names, known: Known
) -> Piece:
    code: Expr = local
    for step in path:
        code = Field(code, step)
        is_optional, message = names.fields.get((message, step), (False, ""))
        if is_optional:
            inner = names.local()
            needs = (*needs, _there(inner, code))
            code = inner
    return Piece(code, needs, known)


def _at(message: Member, offset: Value, names: Names, known: Known) -> Piece:
    extent = evaluate(offset, names, known)
    local = names.local()
    moment = Infix("+", NOW, _wrapped(extent.code))
    given = (Const(str(message.channel)), Const(message.host), moment)
    needs = (*extent.needs, _there(local, CallOf(Field(Name("b"), "at"), given)))
    return _path(local, message.channel.message, message.path, needs, names, extent.known)


def _list(value: ListValue, names: Names, known: Known) -> Piece:
    """A tuple, as in messages."""
    codes: list[Expr] = []
    needs: tuple[Expr, ...] = ()
    for item in value.elements:
        piece = _in_parentheses(evaluate(item, names, known), item)
        codes.append(converted(piece, item.type, value.type.element or item.type))
        needs += piece.needs
        known = piece.known
    return Piece(Listed(tuple(codes)), needs, known)


def _element(value: Element, names: Names, known: Known) -> Piece:
    """An element, which must be there; a negative index is none here."""
    whole = evaluate(value.list, names, known)
    index = evaluate(value.index, names, whole.known)
    items, place = names.local(), names.local()
    size = CallOf(Name("len"), (Bind(items, whole.code),))
    there = Compared(size, ((">", Group(Bind(place, index.code))), (">=", Const(0))))
    needs = (*whole.needs, *index.needs, there)
    element = value.list.type.element
    message = "" if element is None else element.name
    return _path(Item(items, place), message, value.path, needs, names, index.known)


def _contains(value: Contains, word: str, names: Names, known: Known) -> Piece:
    whole, wanted = _pair(value.list, value.value, names, known)
    searched = _searched(whole.code, value.path)
    return Piece(compared(wanted.code, word, searched), whole.needs + wanted.needs, wanted.known)


def _find(value: Find, names: Names, known: Known) -> Piece:
    """The number of an element, which must be there; both sides are computed once."""
    whole, wanted = _pair(value.list, value.value, names, known)
    items, sought = names.local(), names.local()
    there = compared(
        Group(Bind(sought, wanted.code)), "in", Group(Bind(items, _searched(whole.code, value.path)))
    )
    number = CallOf(Field(items, "index"), (sought,))
    return Piece(number, (*whole.needs, *wanted.needs, there), wanted.known)


def _searched(items: Expr, path: tuple[str, ...]) -> Expr:
    """What is looked at in a list: its elements, or the members of them at a path."""
    return own_call("of_each", items, Const(path)) if path else items


def _changed(value: Changed, names: Names, known: Known) -> Piece:
    """The list that there is then. Putting and dropping raise where there is no such element."""
    whole = evaluate(value.list, names, known)
    needs, known = whole.needs, whole.known
    given: list[Expr] = [whole.code] if value.index is None else [Const(value.list.name), whole.code]
    for item, kind in ((value.index, INT), (value.value, value.type.element)):
        if item is not None and kind is not None:
            piece = _in_parentheses(evaluate(item, names, known), item)
            given.append(converted(piece, item.type, kind))
            needs, known = needs + piece.needs, piece.known
    return Piece(own_call(_CHANGES[value.change], *given), needs, known)


def _new(value: NewMessage, names: Names, known: Known) -> Piece:
    """A message that is made of its members, and of those of another one that are taken."""
    needs: tuple[Expr, ...] = ()
    members: list[Expr] = []
    for item in value.fills:
        piece = _in_parentheses(evaluate(item.value, names, known), item.value)
        members.append(Listed((Const(item.path), converted(piece, item.value.type, item.type))))
        needs, known = needs + piece.needs, piece.known
    rest: Expr = NONE
    if value.rest is not None:
        piece = evaluate(value.rest, names, known)
        rest, needs, known = piece.code, needs + piece.needs, piece.known
    given = (Listed(tuple(members)), rest, Const(value.taken))
    return Piece(own_call("made", names.message(value.message), *given), needs, known)


_CHANGES = {
    Change.APPEND: "appended",
    Change.REMOVE: "removed",
    Change.DROP: "dropped",
    Change.PUT: "put",
}
"""The methods of charts that give the changed list."""


def _outcome(activity: str, names: Names, known: Known) -> Piece:
    labels = names.outcomes(activity)
    local = names.local()
    return Piece(local, (_there(local, names.last_outcome(labels)),), known)


def _call(value: Call, names: Names, known: Known) -> Piece:
    codes: list[Expr] = []
    needs: tuple[Expr, ...] = ()
    for argument in value.arguments:
        piece = _in_parentheses(evaluate(argument, names, known), argument)
        codes.append(piece.code)
        needs += piece.needs
        known = piece.known
    if value.function.target.startswith("builtin:"):
        return Piece(CallOf(Name(value.function.target[8:]), tuple(codes)), needs, known)
    return Piece(names.called(value, codes), needs, known)


def _arithmetic(value: Arithmetic, names: Names, known: Known) -> Piece:
    one, other = _pair(value.left, value.right, names, known)
    left, right = value.left.type, value.right.type
    operator = value.operator
    code = Group(Infix(operator, one.code, other.code))
    if value.type == DURATION and DURATION in (left, right) and left != right:
        if operator == "/" and right == INT:
            code = Group(Infix("//", one.code, other.code))
        elif DOUBLE in (left, right):
            whole = CallOf(Name("int"), (Infix(operator, one.code, other.code),))
            return Piece(whole, one.needs + other.needs, other.known)
    return Piece(code, one.needs + other.needs, other.known)


def converted(piece: Piece, source: Type, target: Type) -> Expr:
    """The code of a value as another type takes it: an int becomes a double, also those in a list."""
    if target == list_of(DOUBLE) and source == list_of(INT):
        return CallOf(Name("tuple"), (CallOf(Name("map"), (Name("float"), piece.code)),))
    if target == DOUBLE and source == INT:
        return CallOf(Name("float"), (piece.code,))
    return piece.code


@dataclass(frozen=True, slots=True)
class Computed:
    """Values that an action needs: their pieces, what must be there for all, whether one may raise."""

    pieces: tuple[Piece, ...]
    needs: tuple[Expr, ...]
    raises: bool


def computed(values: Sequence[Value], names: Names) -> Computed:
    """Values that are computed one after the other."""
    pieces: list[Piece] = []
    known: Known = NOTHING
    for value in values:
        pieces.append(evaluate(value, names, known))
        known = pieces[-1].known
    needs = tuple(need for piece in pieces for need in piece.needs)
    return Computed(tuple(pieces), needs, any(map(raises, values)))
