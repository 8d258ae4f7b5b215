"""Expressions: what KSE and the ASEME IDE write at a transition, read into a small tree.

    event [ condition ] / action ; action

What has no meaning without the code around it (`[readyToKick]`, `/timeout`) is Untranslatable, with the
reason: it becomes a hole.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from aseme_dsl.records import dataclass

DEEPEST = 50
"""How deep parentheses may be nested."""


class Untranslatable(Exception):
    """Why an expression is left to the user."""


@dataclass(frozen=True, slots=True)
class ForeignMessage:
    """`topic.State.Message`; `optional` is the old underscore: a missing message counts as true."""

    topic: str
    kind: str
    message: str
    optional: bool = False

    @property
    def channel(self) -> tuple[str, str, str]:
        return self.topic, self.kind, self.message


@dataclass(frozen=True, slots=True)
class ForeignMember:
    """Accessors of a message: `player_state()`, or `balls(0).x()` with the index behind the name."""

    of: ForeignMessage
    path: tuple[tuple[str, int | None], ...]


@dataclass(frozen=True, slots=True)
class Constant:
    """A number, a text in quotes, `true` or `false` as written; `named` if it is a name to be found."""

    text: str
    named: bool = False


@dataclass(frozen=True, slots=True)
class Applied:
    function: str
    arguments: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Null:
    """`NULL`, beside a message."""


@dataclass(frozen=True, slots=True)
class TimedOut:
    timer: str


@dataclass(frozen=True, slots=True)
class Negated:
    operand: Expression


@dataclass(frozen=True, slots=True)
class Joined:
    """`&&` or `||` of two or more."""

    operator: str
    operands: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Compared:
    operator: str
    left: Expression
    right: Expression


Expression = (
    ForeignMessage | ForeignMember | Constant | Applied | Null | TimedOut | Negated | Joined | Compared
)


@dataclass(frozen=True, slots=True)
class SetTimer:
    timer: str
    milliseconds: int


@dataclass(frozen=True, slots=True)
class SetMember:
    member: ForeignMember
    value: Expression


@dataclass(frozen=True, slots=True)
class PublishMessage:
    message: ForeignMessage


@dataclass(frozen=True, slots=True)
class Reread:
    """`process_messages`"""


@dataclass(frozen=True, slots=True)
class PublishAll:
    """`publish_all`: what is published goes out at the end of a step anyway."""


ForeignAction = SetTimer | SetMember | PublishMessage | Reread | PublishAll


@dataclass(frozen=True, slots=True)
class ForeignExpression:
    event: str = ""
    condition: Expression | None = None
    actions: tuple[ForeignAction, ...] = ()


_PERIOD = r"(?:boost::posix_time::)?"
_NOW = rf"{_PERIOD}microsec_clock::(?:local_time|universal_time)\(\)"
_WAKEUP = rf"{_PERIOD}from_iso_string\(_?(?P<topic>\w+)\.State\.TimeoutMsg\.wakeup\(\)\)"
_TIMED_OUT = (
    re.compile(rf"{_WAKEUP}<=?{_NOW}", re.ASCII),
    re.compile(rf"{_NOW}>=?{_WAKEUP}", re.ASCII),
    re.compile(
        rf"\({_NOW}-{_WAKEUP}\)\.total_(?:microseconds|milliseconds|seconds)\(\)>=?0(?![\w.])", re.ASCII
    ),
)
_START = re.compile(
    r"(?P<topic>\w+)\.State\.TimeoutMsg\.set_wakeup\("
    rf"{_PERIOD}to_iso_string\({_NOW}\+{_PERIOD}milli(?:sec|seconds)\((?P<ms>[0-9]{{1,9}})\)\)\)",
    re.ASCII,
)
_TOKEN = re.compile(
    r"""\s*(?: (?P<name>[A-Za-z_]\w*(?:::[A-Za-z_]\w*)*) | (?P<number>[0-9]+(?:\.[0-9]+)?)(?![\w.])
      | (?P<text>"(?:[^"\\]|\\.)*") | (?P<sign>&&|\|\||[=!<>]=|[-<>!()+*/%.,]) )""",
    re.VERBOSE | re.ASCII,
)
_KINDS = {"state": "state", "signal": "signal", "data": "data"}
_TIMER = re.compile(r"TimeoutAction\.(?P<timer>[A-Za-z_]\w*)\.(?P<ms>[0-9]{1,9})", re.ASCII)
_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_COMPARISONS = frozenset({"==", "!=", "<", "<=", ">", ">="})
_WORDS = {"and": "&&", "or": "||", "not": "!"}


def read_expression(text: str) -> ForeignExpression:
    """An expression that is not empty. Raises Untranslatable."""
    event, condition, action = _parts(text)
    actions = tuple(_actions(action)) if action else ()
    if event and not condition and _NAME.fullmatch(event) is None:
        return ForeignExpression("", _condition(event), actions)  # without its brackets
    if event and _NAME.fullmatch(event) is None:
        raise Untranslatable(f"`{event[:60]}` is not the name of an event")
    return ForeignExpression(event, _condition(condition) if condition is not None else None, actions)


def _parts(text: str) -> tuple[str, str | None, str]:
    """Event, condition (None if there are no brackets) and actions."""
    opening, slash = text.find("["), text.find("/")
    if opening < 0 or 0 <= slash < opening:
        event, _, action = text.partition("/")
        return event.strip(), None, action.strip()
    closing = text.find("]", opening)
    if closing < 0:
        raise Untranslatable("the condition has no `]`")
    rest = text[closing + 1 :].strip()
    if rest and not rest.startswith("/"):
        raise Untranslatable(f"`{rest[:40]}` stands behind the condition")
    condition = text[opening + 1 : closing].strip()
    if not condition:
        raise Untranslatable("the condition is empty")
    return text[:opening].strip(), condition, rest[1:].strip()


# ---- actions ------------------------------------------------------------------------------------


def _actions(text: str) -> Iterator[ForeignAction]:
    for part in filter(None, (item.strip() for item in _statements(text))):
        if part == "process_messages":
            yield Reread()
        elif part == "publish_all":
            yield PublishAll()
        elif (found := _TIMER.fullmatch(part)) is not None:
            yield SetTimer(found["timer"], int(found["ms"]))
        elif (found := _START.fullmatch(re.sub(r"\s+", "", part))) is not None:
            yield SetTimer(found["topic"], int(found["ms"]))
        else:
            yield from _published(part)


_PIECE = re.compile(r';|"(?:[^"\\]|\\.)*"?|[^;"]+')


def _statements(text: str) -> Iterator[str]:
    """What `;` separates, but not in quotes; a quote that is not closed goes to the end."""
    statement = ""
    for piece in _PIECE.findall(text):
        if piece != ";":
            statement += piece
        elif statement:
            yield statement
            statement = ""
    if statement:
        yield statement


def _published(part: str) -> Iterator[ForeignAction]:
    """`publish.t.C.M`, `t.C.M.set_x(v)`, and both in one."""
    publishes = part.startswith("publish.")
    reader = _Reader(part.removeprefix("publish."))
    value = reader.setter()
    if value is None:
        raise Untranslatable(f"the action `{part[:60]}` is not known")
    if isinstance(value, SetMember):
        yield value
    elif not publishes:
        raise Untranslatable(f"the action `{part[:60]}` is not known")
    message = value.member.of if isinstance(value, SetMember) else value
    if publishes and message.message != "TimeoutMsg":
        yield PublishMessage(message)


# ---- conditions ---------------------------------------------------------------------------------


def _condition(text: str) -> Expression:
    squeezed = re.sub(r"\s+", "", text)
    if "posix_time" in squeezed or "microsec_clock" in squeezed:
        for pattern in _TIMED_OUT:
            squeezed = pattern.sub(r"TimeoutCheck(\g<topic>)", squeezed)
        text = squeezed
    reader = _Reader(text)
    found = reader.either(0)
    reader.finished()
    return found


class _Reader:
    """Precedence climbing over the tokens of C++ expressions."""

    def __init__(self, text: str) -> None:
        self.tokens: list[tuple[str, str]] = []
        at, text = 0, text.rstrip()
        while at < len(text):
            found = _TOKEN.match(text, at)
            if found is None:
                raise Untranslatable(f"`{text[at:].strip()[:40]}` cannot be read")
            group = found.lastgroup or ""
            word = found[group]
            if group == "name" and word in _WORDS:
                group, word = "sign", _WORDS[word]
            self.tokens.append((group, word))
            at = found.end()
        self.at = 0

    def peek(self) -> tuple[str, str]:
        return self.tokens[self.at] if self.at < len(self.tokens) else ("end", "the end")

    def take(self, sign: str) -> bool:
        if self.peek() == ("sign", sign):
            self.at += 1
            return True
        return False

    def need(self, sign: str) -> None:
        if not self.take(sign):
            raise Untranslatable(f"`{sign}` is missing before `{self.peek()[1]}`")

    def finished(self) -> None:
        if self.at < len(self.tokens):
            raise Untranslatable(f"`{self.peek()[1]}` stands behind a whole condition")

    def either(self, depth: int) -> Expression:
        return self.joined("||", depth)

    def joined(self, operator: str, depth: int) -> Expression:
        if depth > DEEPEST:
            raise Untranslatable(f"its parentheses are nested more than {DEEPEST} deep")

        def part() -> Expression:
            return self.joined("&&", depth) if operator == "||" else self.compared(depth)

        parts = [part()]
        while self.take(operator):
            parts.append(part())
        return parts[0] if len(parts) == 1 else Joined(operator, tuple(parts))

    def compared(self, depth: int) -> Expression:
        left = self.value(depth)
        kind, operator = self.peek()
        if kind == "sign" and operator in _COMPARISONS:
            self.at += 1
            return Compared(operator, left, self.value(depth))
        return left

    def value(self, depth: int) -> Expression:
        found = self.unary(depth)
        kind, sign = self.peek()
        if kind == "sign" and sign in "+-*/%":
            raise Untranslatable(f"it computes (`{sign}`), which KSE could not translate")
        return found

    def unary(self, depth: int) -> Expression:
        if depth > DEEPEST:
            raise Untranslatable(f"it is nested more than {DEEPEST} deep")
        if self.take("!"):
            return Negated(self.unary(depth + 1))
        if self.take("-"):
            kind, word = self.peek()
            if kind != "number":
                raise Untranslatable("`-` stands before what is not a number")
            self.at += 1
            return Constant(f"-{word}")
        if self.take("("):
            inside = self.either(depth + 1)
            self.need(")")
            return inside
        return self.atom(depth)

    def atom(self, depth: int) -> Expression:
        kind, word = self.peek()
        self.at += 1
        if kind in ("number", "text"):
            return Constant(word)
        if kind != "name":
            raise Untranslatable(f"`{word}` stands where a value is expected")
        if word in ("true", "false"):
            return Constant(word)
        if word in ("NULL", "nullptr"):
            return Null()
        if self.peek() == ("sign", "."):
            return self.path(word)
        if self.take("("):
            return self.called(word, depth)
        return Constant(word.rpartition("::")[2], named=True)  # `Mode::ON`: the field says whose it is

    def called(self, name: str, depth: int) -> Expression:
        arguments: list[Expression] = []
        while not self.take(")"):
            if arguments:
                self.need(",")
            arguments.append(self.either(depth + 1))
        if name == "TimeoutCheck":
            match arguments:
                case [Constant(text=timer, named=True)]:
                    return TimedOut(timer)
            raise Untranslatable("`TimeoutCheck` needs the name of a timer")
        if "::" in name:
            raise Untranslatable(f"`{name}` is a function of C++")
        return Applied(name, tuple(arguments))

    def path(self, first: str) -> Expression:
        words = [first]
        while len(words) < 3 and self.take("."):
            kind, word = self.peek()
            if kind != "name":
                raise Untranslatable(f"a name is missing behind `{'.'.join(words)}.`")
            self.at += 1
            words.append(word)
        if len(words) < 3 or words[1].lower() not in _KINDS:
            raise Untranslatable(f"`{'.'.join(words)}` is not the path of a message")
        optional = first.startswith("_")
        message = ForeignMessage(
            first.removeprefix("_") or first, _KINDS[words[1].lower()], words[2], optional
        )
        steps: list[tuple[str, int | None]] = []
        while self.take("."):
            steps.append(self.accessor())
        return ForeignMember(message, tuple(steps)) if steps else message

    def accessor(self) -> tuple[str, int | None]:
        kind, word = self.peek()
        if kind != "name":
            raise Untranslatable("the name of a field is missing")
        self.at += 1
        if not self.take("("):
            return word, None
        kind, index = self.peek()
        if kind == "number" and index.isdigit() and len(index) < 10:
            self.at += 1
            self.need(")")
            return word, int(index)
        self.need(")")
        return word, None

    def setter(self) -> SetMember | ForeignMessage | None:
        """`t.C.M` or `t.C.M.set_x(v)`."""
        kind, word = self.peek()
        if kind != "name" or self.tokens[1:2] != [("sign", ".")]:
            return None
        self.at += 1
        for index, (group, name) in enumerate(self.tokens):
            if group == "name" and name.startswith("set_") and self.tokens[index - 1] == ("sign", "."):
                del self.tokens[index - 1]  # the path ends before it
                message = self.path(word)
                if not isinstance(message, ForeignMessage) or self.at != index - 1:
                    return None
                self.at += 1
                self.need("(")
                value = self.either(0)
                self.need(")")
                self.finished()
                return SetMember(ForeignMember(message, ((name.removeprefix("set_"), None),)), value)
        message = self.path(word)
        self.finished()
        return message if isinstance(message, ForeignMessage) else None


def parts_of(value: Expression) -> Iterator[Expression]:
    """An expression and all in it."""
    waiting = [value]
    while waiting:
        item = waiting.pop()
        yield item
        match item:
            case Applied(arguments=inner) | Joined(operands=inner):
                waiting += reversed(inner)
            case Negated(operand=operand):
                waiting.append(operand)
            case Compared(left=left, right=right):
                waiting += [right, left]
            case _:
                pass
