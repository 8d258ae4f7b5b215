"""Meaning: which messages, topics, enums and functions expressions speak of, and each expression as text.

The fields of a message come from a .proto file, or else from what expressions compare them with.
"""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field

from aseme_dsl.amola.expression import duration_text
from aseme_dsl.amola.messages import BOOL, DOUBLE, INT, STRING, EnumType, Kind, Message, Type
from aseme_dsl.amola.python_names import taken_as_member, taken_as_type
from aseme_dsl.interop.emf.expressions import (
    Applied,
    Compared,
    Constant,
    Expression,
    ForeignAction,
    ForeignExpression,
    ForeignMember,
    ForeignMessage,
    Joined,
    Negated,
    Null,
    PublishAll,
    PublishMessage,
    Reread,
    SetMember,
    SetTimer,
    TimedOut,
    Untranslatable,
    parts_of,
)
from aseme_dsl.interop.emf.identifiers import Names, is_reserved
from aseme_dsl.records import dataclass

Key = tuple[str, str]
"""A message and the name of one of its fields."""


@dataclass(frozen=True, slots=True)
class Known:
    """What files beside the models say: messages and enums of .proto files, constants of headers, and the
    variables of the models."""

    messages: Mapping[str, Message] = field(default_factory=dict)
    enums: Mapping[str, EnumType] = field(default_factory=dict)
    constants: Mapping[str, int] = field(default_factory=dict)
    variables: Mapping[str, Type] = field(default_factory=dict)


@dataclass(slots=True)
class _Field:
    """What is seen of a field that no .proto file declares."""

    kinds: set[str] = field(default_factory=set)
    constants: dict[str, None] = field(default_factory=dict)


@dataclass(slots=True)
class Meaning:
    """What all expressions together speak of. Expressions are added first; then they can be written."""

    known: Known
    fields: dict[Key, _Field] = field(default_factory=dict)
    channels: dict[tuple[str, str, str], None] = field(default_factory=dict)
    functions: dict[str, tuple[tuple[Type, ...], Type]] = field(default_factory=dict)
    used_constants: dict[str, None] = field(default_factory=dict)
    called: dict[str, _Field] = field(default_factory=dict)
    enums: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """The enums that follow from comparisons, by name."""
    enum_of: dict[str, str] = field(default_factory=dict)
    """The enum of each of their constants."""

    # ---- what is seen ------------------------------------------------------------------------

    def add(self, expression: ForeignExpression) -> None:
        """Look at an expression. Raises Untranslatable, and then nothing of it is kept."""
        for value, _ in _values(expression):
            for item in parts_of(value):
                self._check(item)
        for value, is_condition in _values(expression):
            self._see(value, is_condition)
        for action in expression.actions:
            match action:
                case SetMember(member=member, value=value):
                    self._see_channel(member.of)
                    self._see_pair(member, value)
                case PublishMessage(message=message):
                    self._see_channel(message)
                case SetTimer() | Reread() | PublishAll():
                    pass

    def _check(self, item: Expression) -> None:
        match item:
            case ForeignMessage(topic=topic, message=message):
                if topic in ("signal", "state", "data") or keyword.iskeyword(topic):
                    raise Untranslatable(f"no topic can be called `{topic}`")
                if taken_as_type(message):
                    raise Untranslatable(f"no message can be called `{message}`")
            case ForeignMember(of=of, path=path):
                self._check(of)
                self._path(item)
                if of.message not in self.known.messages and (len(path) > 1 or path[0][1] is not None):
                    raise Untranslatable(f"only a .proto file can say what is in `{of.message}`")
            case Compared(left=left, right=right):
                for one, other in ((left, right), (right, left)):
                    if isinstance(one, Constant) and one.named and not self._has_type(one):
                        self._check_constant(one, other)
                    if isinstance(one, Null) and not isinstance(other, ForeignMessage):
                        raise Untranslatable("`NULL` is compared with what is not a message")
            case Negated(operand=operand):
                self._check_bare(operand)
            case Joined(operands=operands):
                for operand in operands:
                    self._check_bare(operand)
            case Applied(function=name, arguments=arguments):
                if is_reserved(name):
                    raise Untranslatable(f"no function can be called `{name}`")
                for argument in arguments:
                    self._check_bare(argument)
            case Constant() | Null() | TimedOut():
                pass

    def _has_type(self, constant: Constant) -> bool:
        return constant.text in self.known.variables or constant.text in self.known.constants

    def _check_constant(self, constant: Constant, other: Expression) -> None:
        if not isinstance(other, ForeignMember):
            raise Untranslatable(f"nothing declares `{constant.text}`")
        declared = self._declared(other)
        if declared is None:
            return
        enum = self.known.enums.get(declared.name) if declared.kind is Kind.ENUM else None
        if enum is None:
            raise Untranslatable(
                f"the value of `{constant.text}` is unknown: name the header that defines it"
            )
        if constant.text not in {name for name, _ in enum.constants}:
            raise Untranslatable(f"`{enum.name}` has no constant `{constant.text}`")

    def _check_bare(self, value: Expression) -> None:
        if isinstance(value, Constant) and value.named and not self._has_type(value):
            raise Untranslatable(f"nothing declares `{value.text}`")

    def _see(self, value: Expression, is_condition: bool) -> None:
        if is_condition:
            self._see_condition(value)
        for item in parts_of(value):
            match item:
                case ForeignMessage():
                    self._see_channel(item)
                case ForeignMember(of=of):
                    self._see_channel(of)
                case Compared(left=left, right=right):
                    self._see_pair(left, right)
                    self._see_pair(right, left)
                case Negated(operand=operand):
                    self._see_condition(operand)
                case Joined(operands=operands):
                    for operand in operands:
                        self._see_condition(operand)
                case Applied(function=name):
                    self.called.setdefault(name, _Field())
                case Constant(text=text, named=True) if text in self.known.constants:
                    self.used_constants[text] = None
                case Constant() | Null() | TimedOut():
                    pass

    def _see_channel(self, message: ForeignMessage) -> None:
        self.channels[message.channel] = None

    def _see_condition(self, value: Expression) -> None:
        seen = self._seen(value)
        if seen is not None:
            seen.kinds.add("bool")

    def _see_pair(self, one: Expression, other: Expression) -> None:
        seen = self._seen(one)
        if seen is None:
            return
        match other:
            case Constant(text=text, named=True):
                if text in self.known.variables:
                    seen.kinds.add(self.known.variables[text].kind.value)
                elif text in self.known.constants:
                    seen.kinds.add("int")
                else:
                    seen.kinds.add("enum")
                    seen.constants[text] = None
            case Constant(text=text):
                seen.kinds.add(_literal_kind(text))
            case ForeignMember() | Applied():
                seen.kinds.add("int")
            case _:
                pass

    def _seen(self, value: Expression) -> _Field | None:
        match value:
            case ForeignMember(of=of, path=path) if self._declared(value) is None:
                return self.fields.setdefault((of.message, path[0][0]), _Field())
            case Applied(function=name):
                return self.called.setdefault(name, _Field())
        return None

    # ---- types -------------------------------------------------------------------------------

    def settle(self) -> None:
        """Name the enums that follow: fields that are compared with one constant have one enum."""
        names = Names(taken={*self.known.enums, *self.known.messages, *(key[2] for key in self.channels)})
        groups: list[tuple[dict[str, None], str]] = []
        for (_, name), seen in self.fields.items():
            if not seen.constants:
                continue
            merged, first = dict(seen.constants), name
            for group, title in [item for item in groups if item[0].keys() & seen.constants.keys()]:
                groups.remove((group, title))
                merged, first = {**group, **merged}, title
            groups.append((merged, first))
        for constants, title in groups:
            name = names.new("".join(word[:1].upper() + word[1:] for word in title.split("_")), "Value")
            self.enums[name] = tuple(constants)
            self.enum_of |= dict.fromkeys(constants, name)

    def field_type(self, key: Key) -> Type:
        """The type of a field that no .proto file declares."""
        seen = self.fields[key]
        if seen.constants and not seen.kinds & {"double", "string"}:
            return Type(Kind.ENUM, self.enum_of[next(iter(seen.constants))])
        return _type_of(seen.kinds)

    def _path(self, member: ForeignMember) -> tuple[list[str], Type | None]:
        """The steps of a member as they are written here, and its type if a .proto file says it."""
        message = self.known.messages.get(member.of.message)
        steps: list[str] = []
        if message is None:
            for name, index in member.path:
                if taken_as_member(name):
                    raise Untranslatable(f"no field can be called `{name}`")
                steps.append(name if index is None else f"{name}[{index}]")
            return steps, None
        found: Type | None = None
        for name, index in member.path:
            declared = None
            if message is not None:
                declared = next(
                    (f for f in message.fields if f.name.rstrip("_").lower() == name.rstrip("_").lower()),
                    None,
                )
            if declared is None:
                raise Untranslatable(f"`{member.of.message}` of the .proto file has no field `{name}`")
            found = declared.type
            if found.element is not None and index is not None:
                found = found.element
            steps.append(declared.name if index is None else f"{declared.name}[{index}]")
            message = self.known.messages.get(found.name) if found.kind is Kind.MESSAGE else None
        return steps, found

    def _declared(self, member: ForeignMember) -> Type | None:
        return self._path(member)[1]

    def _type(self, value: Expression) -> Type | None:
        match value:
            case ForeignMember(of=of, path=path):
                return self._declared(value) or self.field_type((of.message, path[0][0]))
            case ForeignMessage(message=name):
                return Type(Kind.MESSAGE, name)
            case Applied(function=name):
                return _type_of(self.called[name].kinds)
            case Constant(text=text, named=True):
                return self.known.variables.get(text, INT)
            case Constant(text=text):
                return Type(Kind(_literal_kind(text)))
        return None

    # ---- text --------------------------------------------------------------------------------

    def condition(self, value: Expression) -> str:
        """A condition in the language. Raises Untranslatable."""
        return self._boolean(value, 0)

    def _boolean(self, value: Expression, least: int) -> str:
        """`least` is how tight it must bind: 1 inside `&&`, 2 behind `!`."""
        match value:
            case Joined(operator=operator, operands=operands):
                own = 0 if operator == "||" else 1
                text = f" {operator} ".join(self._boolean(item, own + 1) for item in operands)
                return f"({text})" if least > own else text
            case Negated(operand=Joined() as inner):
                return f"!({self._boolean(inner, 0)})"
        return self._atom(value, least)

    def _atom(self, value: Expression, least: int) -> str:
        """A condition without `&&` and `||`, with `!has(…) ||` for a message that may be missing."""
        inner, negated = value, False
        while isinstance(inner, Negated):
            inner, negated = inner.operand, not negated
        if isinstance(inner, Joined):
            return self._boolean(Negated(inner) if negated else inner, least)
        text = self._plain(inner, negated)
        optional = [item for item in _messages(inner) if item.optional]
        if not optional or isinstance(inner, ForeignMessage):
            return text
        absent = [f"!has({_path_text(item)})" for item in dict.fromkeys(optional)]
        text = " || ".join([*absent, text])
        return f"({text})" if least else text

    def _plain(self, value: Expression, negated: bool) -> str:
        sign = "!" if negated else ""
        match value:
            case Constant(text=text, named=True) if text in self.known.variables:
                return f"{sign}{text}"
            case Constant(text="true" | "false"):
                return f"{sign}{value.text}"
            case TimedOut(timer=timer):
                return f"{sign}expired({timer})"
            case ForeignMessage():
                return f"{sign}has({_path_text(value)})"
            case Compared():
                text = self._compared(value)
                return (
                    f"!({text})"
                    if negated and not text.startswith(("has(", "!has("))
                    else _flipped(text, negated)
                )
            case ForeignMember() | Applied():
                kind = self._type(value)
                if kind == BOOL:
                    return f"{sign}{self._value(value)}"
                if kind in (INT, DOUBLE):
                    return f"{self._value(value)} {'==' if negated else '!='} 0"
        raise Untranslatable("a value that is not a truth value stands as a condition")

    def _compared(self, value: Compared) -> str:
        left, right, operator = value.left, value.right, value.operator
        if isinstance(left, Null) or isinstance(right, Null):
            message = right if isinstance(left, Null) else left
            if not isinstance(message, ForeignMessage) or operator not in ("==", "!="):
                raise Untranslatable("`NULL` is compared with what is not a message")
            return f"{'!' if operator == '==' else ''}has({_path_text(message)})"
        for one, other in ((left, right), (right, left)):
            if (
                self._type(one) == BOOL
                and isinstance(other, Constant)
                and other.text in ("0", "1", "true", "false")
            ):
                is_true = (other.text in ("1", "true")) == (operator == "==")
                if operator in ("==", "!="):
                    return self._plain(one, not is_true)
        return f"{self._value(left)} {operator} {self._value(right)}"

    def _value(self, value: Expression) -> str:
        match value:
            case Constant(text=text, named=True):
                if self._has_type(value):
                    return text
                enum = self.enum_of.get(text) or self._proto_enum(text)
                if enum is None:
                    raise Untranslatable(f"nothing declares `{text}`")
                return f"{enum}.{text}"
            case Constant(text=text):
                return text
            case ForeignMessage():
                return _path_text(value)
            case ForeignMember(of=of):
                return ".".join([_path_text(of), *self._path(value)[0]])
            case Applied(function=name, arguments=arguments):
                types = tuple(self._type(argument) or BOOL for argument in arguments)
                before = self.functions.setdefault(name, (types, _type_of(self.called[name].kinds)))
                if before[0] != types:
                    raise Untranslatable(f"`{name}` is called with values of other types elsewhere")
                return f"{name}({', '.join(self._value(argument) for argument in arguments)})"
        raise Untranslatable("a condition stands where a value is expected")

    def _proto_enum(self, constant: str) -> str | None:
        for name, enum in self.known.enums.items():
            if constant in {item for item, _ in enum.constants}:
                return name
        return None

    def actions(self, actions: Iterable[ForeignAction]) -> str:
        """Actions in the language, "" for what happens anyway."""
        return "; ".join(filter(None, map(self._action, actions)))

    def _action(self, action: ForeignAction) -> str:
        match action:
            case SetTimer(timer=timer, milliseconds=amount):
                return f"start_timer({timer}, {duration_text(amount * 1_000_000)})"
            case SetMember(member=member, value=value):
                return f"{self._value(member)} = {self._value(value)}"
            case PublishMessage(message=message):
                return f"write_messages.{_path_text(message)}"
            case Reread():
                return "read_messages"
            case PublishAll():
                return ""

    def text(self, expression: ForeignExpression, *, may_wait: bool) -> str:
        """The whole; the condition of a state that `may_wait` for what is inside it gets `when`."""
        parts = [expression.event]
        if expression.condition is not None:
            when = "when " if may_wait and not expression.event else ""
            parts.append(f"{when}[{self.condition(expression.condition)}]")
        done = self.actions(expression.actions)
        parts.append(f"/ {done}" if done else "")
        return " ".join(filter(None, parts))

    # ---- declarations ------------------------------------------------------------------------

    def declarations(self, module: str) -> Iterator[str]:
        """The lines that declare all that is used and that no .proto file declares."""
        for name, constants in self.enums.items():
            yield f"enum {name} {{ {' '.join(constants)} }}"
        for name in dict.fromkeys(key[2] for key in self.channels):
            if name not in self.known.messages:
                fields = [f"{self.field_type(key)} {key[1]}" for key in self.fields if key[0] == name]
                yield f"message {name} {{ {'  '.join(fields)} }}"
        for topic in dict.fromkeys(key[0] for key in self.channels):
            yield f"topic {topic} {{"
            for kind in ("state", "signal", "data"):
                names = [key[2] for key in self.channels if key[:2] == (topic, kind)]
                if names:
                    yield f"  {kind} {', '.join(names)}"
            yield "}"
        for name in self.used_constants:
            yield f"let {name} = {self.known.constants[name]}"
        for name, (types, result) in self.functions.items():
            given = ", ".join(f"{kind} {_parameter(kind, number)}" for number, kind in enumerate(types, 1))
            yield f'function {name}({given}) : {result} = "{module}:{name}"'


def _values(expression: ForeignExpression) -> Iterator[tuple[Expression, bool]]:
    if expression.condition is not None:
        if isinstance(expression.condition, Constant) and expression.condition.named:
            yield Negated(Negated(expression.condition)), True
        else:
            yield expression.condition, True
    for action in expression.actions:
        if isinstance(action, SetMember):
            yield Compared("==", action.member, action.value), False


def _messages(value: Expression) -> Iterator[ForeignMessage]:
    for item in parts_of(value):
        if isinstance(item, ForeignMessage):
            yield item
        elif isinstance(item, ForeignMember):
            yield item.of


def _path_text(message: ForeignMessage) -> str:
    return f"{message.topic}.{message.kind}.{message.message}"


def _flipped(text: str, negated: bool) -> str:
    if not negated:
        return text
    return text[1:] if text.startswith("!") else f"!{text}"


def _literal_kind(text: str) -> str:
    if text in ("true", "false"):
        return "bool"
    return "string" if text.startswith('"') else "double" if "." in text else "int"


def _type_of(kinds: set[str]) -> Type:
    """The widest of what is seen."""
    for kind, found in (("string", STRING), ("double", DOUBLE), ("int", INT), ("bool", BOOL)):
        if kind in kinds:
            return found
    return BOOL


def _parameter(kind: Type, number: int) -> str:
    word = re.sub(r"\W", "", kind.name or "").lower()
    return f"{word[:1] or 'x'}{number}"


__all__ = ["Known", "Meaning"]
