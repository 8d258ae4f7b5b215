"""Transition expressions, resolved and typed: `event [condition] / actions` (P1, Figure 6, and beyond).

Nesting is bounded by the compiler (E103), so walking an expression may recurse.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from enum import StrEnum
from operator import add, eq, ge, gt, le, lt, mod, mul, ne, sub, truediv

from aseme_dsl.amola.messages import AGENT, BOOL, DOUBLE, DURATION, INT, Bounds, Channel, Function, Kind, Type
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

# ---- values ------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Literal:
    """A constant; a duration's value is in ns. The initial value of an enum is its constant's name.

    That of an agent or a message is empty: there is none at first, nor after `clear(now)`.
    """

    value: bool | int | float | str
    type: Type
    span: Span


@dataclass(frozen=True, slots=True)
class EnumConstant:
    """`PlayerState.PLAYING`; `number` is its value on the wire."""

    constant: str
    number: int
    type: Type
    span: Span


@dataclass(frozen=True, slots=True)
class VariableValue:
    """A variable of the role or of a played participant; `name` is its key in the statechart.

    With a `path` it is a member of the message that the variable holds, which is of the type `message`.
    """

    name: str
    type: Type
    span: Span
    bounds: Bounds | None = None
    path: tuple[str, ...] = ()
    message: str = ""

    @property
    def may_be_unset(self) -> bool:
        """Whether the variable holds nothing at first: it is absent then."""
        return bool(self.path) or self.type.begins_unset


@dataclass(frozen=True, slots=True)
class ParameterValue:
    """A parameter of the formula, or an input of the participant, whose control it stands in.

    No chart has any: see `substituted`. With a `path` it is a member of the message that an input is.
    """

    name: str
    type: Type
    span: Span
    path: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Member:
    """A message on the blackboard (`path` is empty) or a member of it. `host` None means of any sender."""

    host: str | None
    channel: Channel
    path: tuple[str, ...]
    type: Type
    span: Span


@dataclass(frozen=True, slots=True)
class Bound:
    """The agent message that the transition takes (`path` is empty), or a member of it: never absent itself.

    `name` is how it is written: `b` after `propose Bid b from contractor`, else `propose.Bid`.
    """

    name: str
    message: str
    path: tuple[str, ...]
    type: Type
    span: Span


@dataclass(frozen=True, slots=True)
class Sender:
    """Who has sent the agent message that the transition takes, or (`lost`) which agent is lost."""

    name: str
    span: Span
    lost: bool = False
    type: Type = AGENT


LOSS = Type(Kind.OUTCOME, "lost participant")
"""The type of the reasons for a loss."""
LOSS_REASONS = (
    "left",
    "failed",
    "crashed",
    "timed_out",
    "replaced",
    "incompatible",
    "exhausted",
    "completed",
)
"""Why an agent's part in a conversation is over: only the last of them has reached its END."""


@dataclass(frozen=True, slots=True)
class LossReason:
    """`reason(gone)`: why the part of the agent that the transition has lost is over.

    It is compared with a Literal of the same type, whose value is the reason.
    """

    name: str
    span: Span
    type: Type = LOSS


@dataclass(frozen=True, slots=True)
class Call:
    """A pure function, one of the built-in ones (`function.target` starts with "builtin:"), or a probe."""

    function: Function
    arguments: tuple[Value, ...]
    type: Type
    span: Span


@dataclass(frozen=True, slots=True)
class ListValue:
    """`[a, b]`: as many values of one type; absent where one of them is."""

    elements: tuple[Value, ...]
    type: Type
    span: Span


@dataclass(frozen=True, slots=True)
class Element:
    """`x.items[i]`, or (`path`) a member of that element: absent where the list has no such element."""

    list: Value
    index: Value
    path: tuple[str, ...]
    type: Type
    span: Span


@dataclass(frozen=True, slots=True)
class Size:
    """`size(x.items)`: how many elements a list has."""

    list: Value
    span: Span
    type: Type = INT


@dataclass(frozen=True, slots=True)
class Contains:
    """`contains(x.items, v)`: whether an element of the list, or its member at the path, equals the value."""

    list: Value
    value: Value
    span: Span
    path: tuple[str, ...] = ()
    type: Type = BOOL


@dataclass(frozen=True, slots=True)
class Find:
    """`find(x.items.id, v)`: the number of the first element that, or whose member at the path, equals the
    value; absent where there is none."""

    list: Value
    value: Value
    span: Span
    path: tuple[str, ...] = ()
    type: Type = INT


class Change(StrEnum):
    """What becomes of a list, by the words of the action."""

    APPEND = "append"
    """`append(xs, v)`: v is behind the others."""
    REMOVE = "remove"
    """`remove(xs, v)`: without the first element that equals v."""
    DROP = "drop"
    """`remove(xs[i])`: without the element with the number i."""
    PUT = "put"
    """`xs[i] = v`: with v in place of the element with the number i."""


@dataclass(frozen=True, slots=True)
class Changed:
    """A list as an action changes it.

    `value` is what is appended, removed or put, `index` the number of the one that is dropped or replaced.
    """

    change: Change
    list: VariableValue
    value: Value | None
    index: Value | None
    type: Type
    span: Span

    @property
    def given(self) -> tuple[Value, ...]:
        """What the action computes besides the list: the number of an element before its value."""
        return tuple(item for item in (self.index, self.value) if item is not None)


@dataclass(frozen=True, slots=True)
class Fill:
    """`f.g = value` in the braces of a message."""

    path: tuple[str, ...]
    type: Type
    value: Value
    span: Span


@dataclass(frozen=True, slots=True)
class NewMessage:
    """`Order { id = 7, ..now }`: absent where something that it is made of is.

    Members that are not filled have their defaults, which `is_default` says explicitly, or are those of the
    message `rest` that are `taken`.
    """

    message: str
    fills: tuple[Fill, ...]
    rest: Value | None
    taken: tuple[str, ...]
    is_default: bool
    type: Type
    span: Span

    @property
    def given(self) -> tuple[Value, ...]:
        """What it is made of, from left to right."""
        rest = () if self.rest is None else (self.rest,)
        return (*(item.value for item in self.fills), *rest)


@dataclass(frozen=True, slots=True)
class Has:
    """Whether a message or an optional member is there, or an agent in its variable: never absent itself."""

    message: Member | Bound | VariableValue
    span: Span
    type: Type = BOOL


@dataclass(frozen=True, slots=True)
class Age:
    """How long ago a state or data message was measured, or an agent message sent, in ns.

    Absent without a message; the agent message that a transition takes is always there.
    """

    message: Member | Bound
    span: Span
    type: Type = DURATION


@dataclass(frozen=True, slots=True)
class At:
    """A data message (or member) as it was at now + `offset` (which is ≤ 0): the newest measured by then."""

    message: Member
    offset: Value
    type: Type
    span: Span


@dataclass(frozen=True, slots=True)
class Mean:
    """The mean of a numeric member of a data message over the last `window`."""

    message: Member
    window: Value
    type: Type
    span: Span


@dataclass(frozen=True, slots=True)
class Expired:
    """Whether a timer of the region has run out; false before it was started."""

    timer: str
    span: Span
    type: Type = BOOL


@dataclass(frozen=True, slots=True)
class Outcome:
    """`outcome(Grasp)`: how the activity has ended last; absent from the entry of its state until it has.

    It is compared with a Literal of the same type, whose value is the name of an outcome. Which state of
    several with that activity is meant: amola/meant.py.
    """

    activity: str
    type: Type
    span: Span


@dataclass(frozen=True, slots=True)
class StateValue:
    """`in(T)`, `done(T)`, `count(T)`: whether the state T is active, whether it is complete, and how often it
    was entered since its loop began. Never absent.

    `question` is the word, `state` the name. Which state is meant, and which loop: amola/meant.py.
    """

    question: str
    state: str
    type: Type
    named: Span
    """Where the name stands."""
    span: Span


@dataclass(frozen=True, slots=True)
class RoundValue:
    """`invited(q)`, `answered(q)`, `all_answered(q)`: to how many agents the participant's last send to `q`
    went, how many of them have answered or are lost, and whether all have. Never absent."""

    question: str
    participant: str
    type: Type
    named: Span
    """Where the name stands."""
    span: Span


@dataclass(frozen=True, slots=True)
class Holds:
    """Whether a condition holds; never absent. It occurs only where `reactive` or a weight generates it."""

    operand: Value
    span: Span
    type: Type = BOOL


@dataclass(frozen=True, slots=True)
class Index:
    """`index`: the agent's number (3 for `carrier3` of `carrier[1..8]`), in an instance of `A[3]` its own."""

    span: Span
    type: Type = INT


@dataclass(frozen=True, slots=True)
class Random:
    """`random()`: a double in [0, 1), another each time; in actions and arguments only."""

    span: Span
    type: Type = DOUBLE


@dataclass(frozen=True, slots=True)
class Not:
    operand: Value
    span: Span
    type: Type = BOOL


@dataclass(frozen=True, slots=True)
class Logic:
    """`&&` or `||` over two or more operands, evaluated from the left (Kleene)."""

    operator: str
    operands: tuple[Value, ...]
    span: Span
    type: Type = BOOL


@dataclass(frozen=True, slots=True)
class Compare:
    operator: str  # < <= > >= == !=
    left: Value
    right: Value
    span: Span
    type: Type = BOOL


@dataclass(frozen=True, slots=True)
class Arithmetic:
    """`+ - * / %`. Ints stay ints but for `/`; durations add, and scale by numbers."""

    operator: str
    left: Value
    right: Value
    type: Type
    span: Span


@dataclass(frozen=True, slots=True)
class Negate:
    operand: Value
    type: Type
    span: Span


@dataclass(frozen=True, slots=True)
class Conditional:
    """`condition ? yes : no`. Only the one that is chosen is looked at."""

    condition: Value
    yes: Value
    no: Value
    type: Type
    span: Span


@dataclass(frozen=True, slots=True)
class Named:
    """A use of `let NAME = expression`: stands for the expression, shown by its name."""

    name: str
    expression: Value
    type: Type
    span: Span


Value = (
    Literal
    | EnumConstant
    | VariableValue
    | ParameterValue
    | Member
    | Bound
    | Sender
    | LossReason
    | Call
    | ListValue
    | Element
    | Size
    | Contains
    | Find
    | Changed
    | NewMessage
    | Has
    | Age
    | At
    | Mean
    | Expired
    | Holds
    | Outcome
    | Index
    | Random
    | StateValue
    | RoundValue
    | Not
    | Logic
    | Compare
    | Arithmetic
    | Conditional
    | Negate
    | Named
)

# ---- events ------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class After:
    """`after(d)`: `duration` ns since the source was entered."""

    duration: int
    span: Span


@dataclass(frozen=True, slots=True)
class Received:
    """`inform Done from contractor`: an agent message of the conversation.

    `name` is what it is called in the condition and the actions, if it has a name.
    """

    performative: str
    message: str
    participant: str
    span: Span
    name: str = ""


@dataclass(frozen=True, slots=True)
class Lost:
    """`lost contractor c`: an agent that plays the participant in the conversation is lost."""

    participant: str
    span: Span
    name: str = ""


@dataclass(frozen=True, slots=True)
class Raised:
    """A bare name: an event raised by an activity."""

    name: str
    span: Span


@dataclass(frozen=True, slots=True)
class Failed:
    """`error`: an activity inside the source failed."""

    span: Span


Event = After | Received | Lost | Raised | Failed

# ---- actions -----------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Assign:
    """`target = value`. A Member target fills the draft that the next Publish of its channel sends.

    `operator` is that of `target += value`, whose value is the sum.
    """

    target: VariableValue | Member
    value: Value
    span: Span
    operator: str = ""


@dataclass(frozen=True, slots=True)
class Publish:
    """`write_messages.topic.kind.Message`."""

    channel: Channel
    span: Span


@dataclass(frozen=True, slots=True)
class ReadMessages:
    """`read_messages`: the executing region sees what has arrived since the step began."""

    span: Span


@dataclass(frozen=True, slots=True)
class StartTimer:
    timer: str
    duration: Value
    span: Span


@dataclass(frozen=True, slots=True)
class Send:
    """`send accept_proposal Award { task = job } to best`.

    To all who play `participant` but those of `excepts` (to `one` of them), or to the one agent `to`. `fills`
    is None where an activity has prepared what the message says. Members that are not filled have their
    defaults, which `is_default` says explicitly, or are those of the message `rest` that are `taken`. An
    answer is wanted within `reply_by`.
    """

    performative: str
    message: str
    participant: str
    span: Span
    fills: tuple[Fill, ...] | None = None
    to: Value | None = None
    excepts: tuple[Value, ...] = ()
    is_default: bool = False
    rest: Value | None = None
    taken: tuple[str, ...] = ()
    reply_by: Value | None = None
    one: bool = False

    @property
    def values(self) -> tuple[Value, ...]:
        """What it computes, from left to right."""
        single = tuple(item for item in (self.rest, self.reply_by, self.to) if item is not None)
        return (*(item.value for item in self.fills or ()), *single, *self.excepts)


@dataclass(frozen=True, slots=True)
class Evaluate:
    """An expression as an action, as Figure 6 allows: its value is dropped."""

    value: Value
    span: Span


@dataclass(frozen=True, slots=True)
class Raise:
    """`raise name`: the event comes alone in a step that follows at the same instant."""

    name: str
    span: Span


Action = Assign | Publish | ReadMessages | StartTimer | Send | Raise | Evaluate


@dataclass(frozen=True, slots=True)
class TransitionExpression:
    """What decides whether a transition is taken and what it does.

    Several `events` are joined by `or`; `when` makes the condition count whether or not the source is
    complete; `otherwise` is `else`. With `every`, it is not taken before so many ns since the source was
    entered. The default is the empty expression: the source is complete. A branch of a random choice has a
    `weight`, and `draw`, made of the conditions and weights of the choice: whether it is open and drawn.
    """

    events: tuple[Event, ...] = ()
    when: bool = False
    otherwise: bool = False
    condition: Value | None = None
    actions: tuple[Action, ...] = ()
    span: Span | None = None
    every: int | None = None
    weight: int | None = None
    draw: Value | None = None

    @property
    def is_unconditional(self) -> bool:
        """Neither event nor condition nor `else`: taken on completion."""
        return not self.events and self.guard is None and not self.otherwise

    @property
    def guard(self) -> Value | None:
        """What has to hold for the transition to be taken: the condition and, with a weight, the draw."""
        return self.condition if self.draw is None else self.draw

    @property
    def is_for_errors(self) -> bool:
        """Whether it waits for nothing but the failure of an activity."""
        return not self.when and bool(self.events) and all(isinstance(e, Failed) for e in self.events)

    @property
    def apart_from_errors(self) -> tuple[TransitionExpression, ...]:
        """In two where it waits for a failure or something else: what waits for the latter comes first."""
        failures = tuple(event for event in self.events if isinstance(event, Failed))
        others = tuple(event for event in self.events if not isinstance(event, Failed))
        if not failures or not others:
            return (self,)
        return replace(self, events=others), replace(self, events=failures)


EMPTY = TransitionExpression()
NEVER = TransitionExpression(when=True, condition=Literal(False, BOOL, Span(Source("", ""), 0, 0)))
"""The expression of the entry transition of `B` of `A [> B` if no `enter B` line gives one."""


def operands(value: Value) -> tuple[Value, ...]:
    """The parts that a value is computed from, from left to right."""
    if type(value) in _WITHOUT_PARTS:  # most are: each pattern would be tried
        return ()
    match value:  # the most frequent first
        case Compare(left=left, right=right) | Arithmetic(left=left, right=right):
            return (left, right)
        case Logic(operands=parts):
            return parts
        case Not(operand=operand) | Negate(operand=operand) | Holds(operand=operand):
            return (operand,)
        case Call(arguments=arguments):
            return arguments
        case ListValue(elements=elements):
            return elements
        case Element(list=whole, index=index):
            return (whole, index)
        case Size(list=whole):
            return (whole,)
        case Contains(list=whole, value=wanted) | Find(list=whole, value=wanted):
            return (whole, wanted)
        case Changed(list=whole):
            return (whole, *value.given)
        case NewMessage(given=given):
            return given
        case Conditional(condition=condition, yes=yes, no=no):
            return (condition, yes, no)
        case At(message=message, offset=offset):
            return (message, offset)
        case Mean(message=message, window=window):
            return (message, window)
        case Has(message=message) | Age(message=message):
            return (message,)
        case Named(expression=expression):
            return (expression,)
    return ()


_WITHOUT_PARTS = frozenset(
    (
        Literal,
        EnumConstant,
        VariableValue,
        ParameterValue,
        Member,
        Bound,
        Sender,
        LossReason,
        Expired,
        Outcome,
        Index,
        Random,
        StateValue,
        RoundValue,
    )
)


def _rebuilt(value: Value, parts: tuple[Value, ...]) -> Value:
    """The value computed from other parts, as many as `operands` gives."""
    match value:
        case Call():
            return replace(value, arguments=parts)
        case ListValue():
            return replace(value, elements=parts)
        case Element():
            return replace(value, list=parts[0], index=parts[1])
        case Size():
            return replace(value, list=parts[0])
        case Contains() | Find():
            return replace(value, list=parts[0], value=parts[1])
        case Changed(list=whole):
            given = iter(parts[1:])
            return replace(
                value,
                list=parts[0] if isinstance(parts[0], VariableValue) else whole,
                index=None if value.index is None else next(given),
                value=None if value.value is None else next(given),
            )
        case NewMessage(fills=fills, rest=rest):
            given = iter(parts)
            return replace(
                value,
                fills=tuple(replace(item, value=next(given)) for item in fills),
                rest=None if rest is None else next(given),
            )
        case Logic():
            return replace(value, operands=parts)
        case Not() | Negate() | Holds():
            return replace(value, operand=parts[0])
        case Compare() | Arithmetic():
            return replace(value, left=parts[0], right=parts[1])
        case Conditional():
            return replace(value, condition=parts[0], yes=parts[1], no=parts[2])
        case Named():
            return replace(value, expression=parts[0])
        case At(message=message):
            return replace(value, message=_member(parts[0], message), offset=parts[1])
        case Mean(message=message):
            return replace(value, message=_member(parts[0], message), window=parts[1])
        case Has(message=message):
            part = parts[0]
            return replace(
                value, message=part if isinstance(part, Member | Bound | VariableValue) else message
            )
        case Age(message=message):
            part = parts[0]
            return replace(value, message=part if isinstance(part, Member | Bound) else message)
    return value


def _member(value: Value, before: Member) -> Member:
    return value if isinstance(value, Member) else before


def rewritten(value: Value, change: Callable[[Value], Value]) -> Value:
    """The value with `change` applied to everything in it, parts first; the same object if nothing changes.

    Nesting is bounded, so this may recurse.
    """
    before = operands(value)
    parts = tuple(rewritten(part, change) for part in before)
    if any(part is not other for part, other in zip(parts, before, strict=True)):
        value = _rebuilt(value, parts)
    return change(value)


def rewritten_expression(
    written: TransitionExpression, change: Callable[[Value], Value]
) -> TransitionExpression:
    """The expression with `change` applied to all values in it, targets of assignments included."""
    condition = None if written.condition is None else rewritten(written.condition, change)
    draw = None if written.draw is None else rewritten(written.draw, change)
    actions = tuple(_rewritten_action(action, change) for action in written.actions)
    if (
        condition is written.condition
        and draw is written.draw
        and all(action is other for action, other in zip(actions, written.actions, strict=True))
    ):
        return written
    return replace(written, condition=condition, actions=actions, draw=draw)


def _rewritten_action(action: Action, change: Callable[[Value], Value]) -> Action:
    match action:
        case Assign(target=target, value=value):
            new, changed = rewritten(value, change), change(target)
            if not isinstance(changed, VariableValue | Member):
                changed = target
            if new is value and changed is target:
                return action
            return replace(action, target=changed, value=new)
        case StartTimer(duration=duration):
            new = rewritten(duration, change)
            return action if new is duration else replace(action, duration=new)
        case Evaluate(value=value):
            new = rewritten(value, change)
            return action if new is value else replace(action, value=new)
        case Send(fills=fills, rest=rest, reply_by=reply_by, to=to, excepts=excepts):
            values = tuple(rewritten(item, change) for item in action.values)
            if all(item is other for item, other in zip(values, action.values, strict=True)):
                return action
            given = iter(values)
            return replace(
                action,
                fills=None if fills is None else tuple(replace(item, value=next(given)) for item in fills),
                rest=None if rest is None else next(given),
                reply_by=None if reply_by is None else next(given),
                to=None if to is None else next(given),
                excepts=tuple(next(given) for _ in excepts),
            )
    return action


def substituted(value: Value, values: Mapping[str, Value]) -> Value:
    """The value with what the parameters of its formula (and `index`, under INSTANCE) stand for."""
    return rewritten(value, lambda item: _standing_for(item, values))


def substituted_expression(
    written: TransitionExpression, values: Mapping[str, Value]
) -> TransitionExpression:
    """The expression with what the parameters of its formula stand for."""
    if not values:
        return written
    return rewritten_expression(written, lambda item: _standing_for(item, values))


def _standing_for(value: Value, values: Mapping[str, Value]) -> Value:
    match value:
        case ParameterValue(name=name):
            return values.get(name, value)
        case Index():
            return values.get(INSTANCE, value)
    return value


INSTANCE = "[n]"
"""The key of the number of an instance among the values of parameters."""


def walk(value: Value) -> Iterator[Value]:
    """The value and everything in it, from left to right."""
    stack = [value]
    while stack:
        item = stack.pop()
        yield item
        stack.extend(reversed(operands(item)))


def values_of(expression: TransitionExpression) -> Iterator[Value]:
    """Every value read by the condition and the actions, with everything in it; assignment targets not."""
    if expression.guard is not None:
        yield from walk(expression.guard)
    for action in expression.actions:
        match action:
            case Assign(value=value) | Evaluate(value=value) | StartTimer(duration=value):
                yield from walk(value)
            case Send():
                for value in action.values:
                    yield from walk(value)


def taken_message(expression: TransitionExpression) -> bool:
    """Whether the condition or the actions speak of the agent message that the transition takes."""
    return any(isinstance(value, Bound | Sender | LossReason) for value in values_of(expression))


# ---- what operators give -------------------------------------------------------------------------

COMPARE: Mapping[str, Callable[[float, float], bool]] = {
    "==": eq,
    "!=": ne,
    "<": lt,
    "<=": le,
    ">": gt,
    ">=": ge,
}
TURNED = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}
"""What an order is called if its sides change places."""
COMPUTE: Mapping[str, Callable[[float, float], float]] = {
    "+": add,
    "-": sub,
    "*": mul,
    "/": truediv,
    "%": mod,
}


def computed(value: Arithmetic, left: float, right: float) -> float:
    """What generated code makes of two numbers. Raises ArithmeticError or ValueError if there is none."""
    if value.type == DURATION and value.operator == "/" and value.right.type == INT:
        return left // right
    found = COMPUTE[value.operator](left, right)
    return int(found) if value.type == DURATION and DOUBLE in (value.left.type, value.right.type) else found


# ---- spelling ----------------------------------------------------------------------------------

_BINDING = {"||": 1, "&&": 2, "==": 3, "!=": 3, "<": 3, "<=": 3, ">": 3, ">=": 3}
_BINDING |= {"+": 4, "-": 4, "*": 5, "/": 5, "%": 5}
_UNARY = 6
_ATOM = 7


def _binding(value: Value) -> int:
    match value:
        case Logic(operator=operator) | Compare(operator=operator) | Arithmetic(operator=operator):
            return _BINDING[operator]
        case Not():
            return _BINDING["=="]  # `!a == b` is not in the language: it could be read in two ways
        case Negate():
            return _UNARY
        case Conditional():
            return 0
    return _ATOM


def duration_text(nanoseconds: int) -> str:
    """A duration as it is written: `200ms`, `1.5s`, `2min`."""
    sign, amount = ("-", -nanoseconds) if nanoseconds < 0 else ("", nanoseconds)
    for unit, size in (("min", 60_000_000_000), ("s", 1_000_000_000), ("ms", 1_000_000)):
        if amount >= size and amount % size == 0:
            return f"{sign}{amount // size}{unit}"
    if amount >= 1_000_000_000:
        return f"{sign}{_decimal(amount, 1_000_000_000)}s"
    return f"{sign}{_decimal(amount, 1_000_000)}ms"


def _decimal(amount: int, unit: int) -> str:
    whole, rest = divmod(amount, unit)
    return f"{whole}.{str(rest).rjust(len(str(unit)) - 1, '0').rstrip('0')}" if rest else str(whole)


def _number(number: int | float) -> str:
    """The shortest digits that mean this number, without an exponent: the language has none."""
    text = repr(number)
    if "e" not in text:
        return text
    from decimal import Decimal

    text = format(Decimal(text), "f")
    return text if "." in text else f"{text}.0"


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def value_text(value: Value, *, expand: bool = False) -> str:
    """A value in canonical spelling; with `expand`, what a `let` stands for instead of its name."""

    def show(item: Value, least: int = 0) -> str:
        match item:
            case Literal(value=constant, type=kind):
                text = _literal_text(constant, kind)
            case EnumConstant(constant=constant, type=kind):
                text = f"{kind.name}.{constant}"
            case VariableValue(name=name, path=path):
                text = ".".join((name.split("@")[0], *path))
            case ParameterValue(name=name, path=path):
                text = ".".join((name, *path))
            case Member(host=host, channel=channel, path=path):
                text = ".".join(([host] if host else []) + [str(channel), *path])
            case Bound(name=name, path=path):
                text = ".".join((name, *path))
            case Sender(name=name, lost=lost):
                text = name if lost else f"sender({name})"
            case LossReason(name=name):
                text = f"reason({name})"
            case Call(function=function, arguments=arguments):
                text = f"{function.name}({', '.join(show(a) for a in arguments)})"
            case ListValue(elements=elements):
                text = f"[{', '.join(show(element) for element in elements)}]"
            case Element(list=whole, index=index, path=path):
                text = ".".join((f"{show(whole, _ATOM)}[{show(index)}]", *path))
            case Size(list=whole):
                text = f"size({show(whole)})"
            case Contains(list=whole, value=wanted, path=path) | Find(list=whole, value=wanted, path=path):
                word = "find" if isinstance(item, Find) else "contains"
                searched = ".".join((show(whole, _ATOM if path else 0), *path))
                text = f"{word}({searched}, {show(wanted)})"
            case Changed(change=change, list=whole):
                text = _changed_text(change, show(whole), [show(part) for part in item.given])
            case NewMessage(message=message):
                text = f"{message}{_content_text(item.fills, item.rest, item.is_default, expand)}"
            case Has(message=message):
                text = f"has({show(message)})"
            case Age(message=message):
                text = f"age({show(message)})"
            case At(message=message, offset=extra):
                text = f"at({show(message)}, {show(extra)})"
            case Mean(message=message, window=extra):
                text = f"mean({show(message)}, {show(extra)})"
            case Expired(timer=timer):
                text = f"expired({timer})"
            case Outcome(activity=activity):
                text = f"outcome({activity})"
            case Index():
                text = "index"
            case Random():
                text = "random()"
            case StateValue(question=question, state=state):
                text = f"{question}({state})"
            case RoundValue(question=question, participant=participant):
                text = f"{question}({participant})"
            case Holds(operand=operand):
                text = f"holds({show(operand)})"
            case Not(operand=operand):
                text = f"!{show(operand, _UNARY)}"
            case Negate(operand=operand):
                text = f"-{show(operand, _UNARY)}"
            case Logic(operator=operator, operands=parts):
                text = f" {operator} ".join(show(p, _BINDING[operator] + 1) for p in parts)
            case Compare(operator=operator, left=left, right=right):
                text = f"{show(left, 4)} {operator} {show(right, 4)}"
            case Arithmetic(operator=operator, left=left, right=right):
                own = _BINDING[operator]
                text = f"{show(left, own)} {operator} {show(right, own + 1)}"
            case Conditional(condition=condition, yes=yes, no=no):
                text = f"{show(condition, 1)} ? {show(yes, 1)} : {show(no)}"
            case Named(name=name, expression=expression):
                return show(expression, least) if expand else name
        return f"({text})" if _binding(item) < least else text

    return show(value)


def _changed_text(change: Change, whole: str, given: Sequence[str]) -> str:
    match change:
        case Change.DROP:
            return f"remove({whole}[{given[0]}])"
        case Change.PUT:
            return f"{whole}[{given[0]}] = {given[1]}"
    return f"{change.value}({whole}, {given[0]})"


def _content_text(fills: Sequence[Fill], rest: Value | None, is_default: bool, expand: bool) -> str:
    """` { id = 7, ..now }`"""
    said = [f"{'.'.join(item.path)} = {value_text(item.value, expand=expand)}" for item in fills]
    if rest is not None:
        said.append(f"..{value_text(rest, expand=expand)}")
    elif is_default:
        said.append("..")
    return f" {{ {', '.join(said)} }}" if said else " { }"


def _literal_text(constant: bool | int | float | str, kind: Type) -> str:
    if isinstance(constant, bool):
        return "true" if constant else "false"
    if kind.kind is Kind.OUTCOME:
        return str(constant)
    if kind.kind is Kind.LIST:
        return "[]"
    if kind.kind is Kind.MESSAGE:
        return ""
    if isinstance(constant, str):
        return f"{kind}.{constant}" if kind.kind is Kind.ENUM else _quoted(constant)
    return duration_text(int(constant)) if kind == DURATION else _number(constant)


def event_text(event: Event) -> str:
    """An event as it is written."""
    match event:
        case After(duration=duration):
            return f"after({duration_text(duration)})"
        case Received(performative=performative, message=message, participant=participant, name=name):
            return f"{performative} {message}{' ' if name else ''}{name} from {participant}"
        case Lost(participant=participant, name=name):
            return f"lost {participant} {name}".rstrip()
        case Raised(name=name):
            return name
        case Failed():
            return "error"


def action_text(action: Action, *, expand: bool = False) -> str:
    """An action in canonical spelling; with `expand`, what a `let` stands for instead of its name."""
    match action:
        case Assign(target=target, value=value):
            if action.operator and isinstance(value, Arithmetic):
                return f"{value_text(target)} {action.operator}= {value_text(value.right, expand=expand)}"
            if isinstance(value, Changed):
                return value_text(value, expand=expand)
            if isinstance(value, Literal) and value.type.begins_unset:
                return f"clear({value_text(target)})"
            return f"{value_text(target)} = {value_text(value, expand=expand)}"
        case Publish(channel=channel):
            return f"write_messages.{channel}"
        case ReadMessages():
            return "read_messages"
        case StartTimer(timer=timer, duration=duration):
            return f"start_timer({timer}, {value_text(duration, expand=expand)})"
        case Send(performative=performative, message=message, participant=participant, to=to):
            content = ""
            if action.fills is not None:
                content = _content_text(action.fills, action.rest, action.is_default, expand)
            if action.reply_by is not None:
                content += f" reply_by {value_text(action.reply_by, expand=expand)}"
            one = "one " if action.one else ""
            receiver = f"{one}{participant}" if to is None else value_text(to, expand=expand)
            text = f"send {performative} {message}{content} to {receiver}"
            others = ", ".join(value_text(item, expand=expand) for item in action.excepts)
            return f"{text} except {others}" if others else text
        case Raise(name=name):
            return f"raise {name}"
        case Evaluate(value=value):
            return value_text(value, expand=expand)


def events_text(expression: TransitionExpression) -> str | None:
    """The event part as it is written (`else` and `when` count as events here), or None."""
    if expression.otherwise:
        return "else"
    parts = [event_text(event) for event in expression.events]
    if expression.when:
        parts.append("when")
    if expression.every is not None:
        parts.append(f"every {duration_text(expression.every)}")
    return " or ".join(parts) if parts else None


def expression_text(expression: TransitionExpression) -> str:
    """The whole expression in canonical spelling: empty for the empty one."""
    parts = []
    events = events_text(expression)
    if events:
        parts.append(events)
    if expression.condition is not None:
        parts.append(f"[{value_text(expression.condition)}]")
    if expression.weight is not None:
        parts.append(f"weight {expression.weight}")
    if expression.actions:
        parts.append("/ " + "; ".join(action_text(action) for action in expression.actions))
    return " ".join(parts)
