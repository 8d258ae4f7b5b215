"""Values: what can be written where an expression wants a value, a member or an action."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from aseme_dsl.amola.expression import Member, VariableValue, duration_text
from aseme_dsl.amola.messages import BOOL, ChannelKind, ChannelRules, EnumType, Function, Kind, Message, Type
from aseme_dsl.compiler.names.paths import unnamed
from aseme_dsl.compiler.names.scope import Scope, TypedLet
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.builtins import ACTIONS, FORMS
from aseme_dsl.compiler.types.typecheck import type_value
from aseme_dsl.editor.files.known import Known
from aseme_dsl.editor.typing.items import Item, ItemKind, escaped
from aseme_dsl.editor.typing.slots import Call, Slot, SlotKind, joined
from aseme_dsl.grammar.formulas.expression import read_expression
from aseme_dsl.grammar.formulas.words import Malformed
from aseme_dsl.grammar.text.token import Token
from aseme_dsl.source import Source

ACTION_FORMS = ("start_timer", "append", "remove", "clear")
"""The forms of the language that are actions, not values."""

_ABOUT_LISTS = ("append", "size", "contains", "find")
_ABOUT_MESSAGES = ("has", "age", "at", "mean")


def values(scope: Scope, known: Known, slot: Slot, text: str, wanted: Type | None = None) -> Iterator[Item]:
    """What may be a value in this slot; first what has the type that is wanted there."""
    wanted = wanted or _wanted(scope, slot, text)
    call = slot.calls[-1] if slot.calls else None
    if call is not None and call.argument == 0 and call.function in _ABOUT_MESSAGES:
        only_data = call.function in ("at", "mean")
        yield from _channels(
            scope, known, lambda rules: rules.channel.comm is ChannelKind.DATA or not only_data
        )
    elif wanted is not None and wanted.kind is Kind.MESSAGE:
        yield from _channels(scope, known, lambda rules: rules.channel.message == wanted.name)
        if slot.target or (call is not None and call.function == "append"):
            made = f"{wanted.name} {{ $0 }}"
            yield Item(wanted.name, ItemKind.MESSAGE, "a new message", "", made, is_snippet=True, rank=1)
    wants_list = call is not None and call.argument == 0 and call.function in _ABOUT_LISTS
    for name, (_, kind) in scope.variables.items():
        rank = 0 if wants_list and kind.kind is Kind.LIST else _rank(kind, wanted, 2)
        yield Item(name, ItemKind.VARIABLE, str(kind), rank=rank)
    for name, given in scope.parameters.items():
        yield Item(name, ItemKind.VARIABLE, str(given or ""), rank=_rank(given, wanted, 2))
    for let in scope.lets.values():
        found = let.value.type if let.value is not None else None
        detail = str(found) if found is not None else ""
        yield Item(
            let.name, ItemKind.LET, detail, known.documentation(let.span), rank=_rank(found, wanted, 2)
        )
    for enum in scope.symbols.enums:
        if wanted == Type(Kind.ENUM, enum.name):
            yield from constants(enum, known, prefix=f"{enum.name}.", rank=0)
        yield Item(enum.name, ItemKind.ENUM, "enum", known.documentation(enum.span), rank=6, goes_on=True)
    yield from topics(scope, known, rank=3)
    yield from agents(scope)
    yield from functions(scope, known, wanted)
    if slot.kind is SlotKind.VALUE:
        for name in FORMS:
            if name not in ACTION_FORMS and not (slot.decides and name == "random"):
                yield form(name, 4)
        if wanted in (None, BOOL):
            rank = 1 if wanted == BOOL else 5
            yield from (Item(word, ItemKind.WORD, "bool", rank=rank) for word in ("true", "false"))


def _rank(kind: Type | None, wanted: Type | None, otherwise: int) -> int:
    return 0 if wanted is not None and kind == wanted else otherwise


def topics(scope: Scope, known: Known, rank: int) -> Iterator[Item]:
    """The topics that carry anything."""
    for topic in scope.symbols.topics:
        carried = ", ".join(f"{rules.channel.comm} {rules.channel.message}" for rules in topic.channels)
        if carried:
            yield Item(
                topic.name,
                ItemKind.TOPIC,
                f"topic {{ {carried} }}",
                known.documentation(topic.span),
                rank=rank,
                goes_on=True,
            )


def agents(scope: Scope) -> Iterator[Item]:
    """The senders that a variable may name."""
    for team in scope.symbols.teams:
        for agent in team.agents:
            yield Item(agent.name, ItemKind.AGENT, f"agent: {agent.role}", rank=7, goes_on=True)


def members_to_fill(known: Known, message: str, path: Sequence[str] = ()) -> Iterator[Item]:
    """The members of a message, or of one inside it, each with its `=`."""
    filled = known.symbols.message(message)
    for name in path:
        inner = filled.field(name) if filled is not None else None
        filled = known.symbols.message(inner.type.name) if inner is not None else None
    for field in filled.fields if filled is not None else ():
        said = known.documentation(field.span)
        yield Item(field.name, ItemKind.MEMBER, str(field.type), said, f"{field.name} = ", rank=0)


def functions(scope: Scope, known: Known, wanted: Type | None) -> Iterator[Item]:
    """The declared functions and those that are built in, once each, with room for their arguments."""
    for name in scope.symbols.function_names:
        overloads = scope.symbols.overloads(name)
        first = overloads[0]
        detail = signature(first) + (f"  (+{len(overloads) - 1} more)" if len(overloads) > 1 else "")
        results = {item.result for item in overloads}
        arguments = ", ".join(
            f"${{{number}:{parameter}}}" for number, (parameter, _) in enumerate(first.parameters, 1)
        )
        yield Item(
            name,
            ItemKind.FUNCTION,
            detail,
            known.documentation(first.span),
            f"{name}({arguments})",
            is_snippet=True,
            rank=3 if wanted is not None and wanted in results else 4,
        )


def form(name: str, rank: int) -> Item:
    """What looks like a function and is part of the language."""
    example = FORMS[name]
    arguments = form_parameters(name)
    places = ", ".join(f"${{{number}:{escaped(item)}}}" for number, item in enumerate(arguments, 1))
    return Item(name, ItemKind.FUNCTION, example, "", f"{name}({places})", is_snippet=True, rank=rank)


def form_parameters(name: str) -> list[str]:
    """What stands between the parentheses in the example of a form."""
    return FORMS[name].removeprefix(f"{name}(").partition(")")[0].split(", ")


def outcomes(scope: Scope, slot: Slot) -> Iterator[Item]:
    """Activities that have outcomes, in `outcome(`; and behind `outcome(A) ==` those of one."""
    if slot.calls and slot.calls[-1].function == "outcome":
        for activity in scope.symbols.activities.values():
            if activity.ends:
                yield Item(activity.name, ItemKind.ACTIVITY, "ends " + ", ".join(activity.ends), rank=0)
    elif slot.left[:2] == ("outcome", "("):
        found = scope.symbols.activities.get(str(slot.left[2]))
        for name in found.ends if found is not None else ():
            yield Item(name, ItemKind.CONSTANT, f"outcome of {slot.left[2]}", rank=0)


def signature(function: Function) -> str:
    """`can_kick(Ball ball) : bool`"""
    parameters = ", ".join(f"{kind} {name}" for name, kind in function.parameters)
    return f"{function.name}({parameters}) : {function.result}"


def constants(enum: EnumType, known: Known, prefix: str = "", rank: int = 2) -> Iterator[Item]:
    """The constants of an enum, in its order."""
    for name, number in enum.constants:
        yield Item(f"{prefix}{name}", ItemKind.CONSTANT, f"{enum.name} = {number}", rank=rank)


def _channels(scope: Scope, known: Known, fits: object) -> Iterator[Item]:
    """Whole messages where they are published."""
    assert callable(fits)
    for topic in scope.symbols.topics:
        for rules in topic.channels:
            if fits(rules):
                message = scope.symbols.message(rules.channel.message)
                said = known.documentation(message.span) if message is not None else ""
                yield Item(str(rules.channel), ItemKind.MESSAGE, _rules(rules), said, rank=0)


def _rules(rules: ChannelRules) -> str:
    """What a topic says of a message on it: `state from camera every 33ms`."""
    words = [str(rules.channel.comm)]
    if rules.sources:
        words.append("from " + ", ".join(rules.sources))
    if rules.every is not None:
        words.append("every " + duration_text(rules.every))
    if rules.expires is not None:
        words.append("expires " + duration_text(rules.expires))
    words += ["queued"] * rules.queued + ["persist"] * rules.persist
    return " ".join(words)


def _behind(alias: str, symbols: Symbols) -> Iterator[Item]:
    """What a file that has an alias declares for expressions."""
    kinds = {item.name: ItemKind.TOPIC for item in symbols.topics}
    kinds |= {item.name: ItemKind.ENUM for item in symbols.enums}
    kinds |= {item.name.text: ItemKind.LET for item in symbols.lets}
    kinds |= {item.name: ItemKind.FUNCTION for item in symbols.functions}
    for name, kind in kinds.items():
        if name.startswith(f"{alias}_"):
            yield Item(name.removeprefix(f"{alias}_"), kind)


def members(scope: Scope, known: Known, path: Sequence[str], comms: Sequence[str] = ()) -> Iterator[Item]:
    """What may follow the dot behind a path; `comms` limits the classes of messages, if it names any."""
    symbols = scope.symbols
    first, rest = path[0], list(path[1:])
    if first in scope.variables:
        kind = scope.variables[first][1]
        yield from _fields(scope, known, symbols.message((kind.element or kind).name), rest)
        return
    if first in known.aliases and first not in scope.lets:
        if not rest:
            yield from _behind(first, symbols)
            return
        first = f"{first}_{rest.pop(0)}"
    if first in scope.lets:
        yield from _members_of_let(scope, known, scope.lets[first], rest)
        return
    enum = symbols.enum(first)
    if enum is not None:
        if not rest:
            yield from constants(enum, known)
        return
    topic = symbols.topic(first)
    if topic is None or (rest and symbols.topic(rest[0]) is not None and rest[0] not in tuple(ChannelKind)):
        if first in symbols.agents and not rest:
            yield from topics(scope, known, rank=2)
            return
        topic = symbols.topic(rest.pop(0)) if rest else None
    if topic is None:
        return
    channels = [item for item in topic.channels if not comms or item.channel.comm in comms]
    if not rest:
        for comm in dict.fromkeys(item.channel.comm for item in channels):
            carried = ", ".join(item.channel.message for item in channels if item.channel.comm is comm)
            yield Item(str(comm), ItemKind.CLASS, carried, rank=2, goes_on=True)
        return
    if len(rest) == 1:
        for rules in channels:
            if rules.channel.comm == rest[0]:
                message = symbols.message(rules.channel.message)
                said = known.documentation(message.span) if message is not None else ""
                yield Item(rules.channel.message, ItemKind.MESSAGE, _rules(rules), said, rank=2)
        return
    yield from _fields(scope, known, symbols.message(rest[1]), rest[2:])


def _members_of_let(scope: Scope, known: Known, let: TypedLet, rest: Sequence[str]) -> Iterator[Item]:
    message = unnamed(let.value) if let.value is not None else None
    if isinstance(message, Member | VariableValue) and message.type.kind is Kind.MESSAGE:
        yield from _fields(scope, known, scope.symbols.message(message.type.name), rest)


def _fields(scope: Scope, known: Known, message: Message | None, path: Sequence[str]) -> Iterator[Item]:
    for name in path:
        field = message.field(name) if message is not None else None
        message = scope.symbols.message(field.type.name) if field is not None else None
    for field in message.fields if message is not None else ():
        detail = f"{field.label} {field.type}".strip()
        yield Item(field.name, ItemKind.MEMBER, detail, known.documentation(field.span), rank=2)


def actions(scope: Scope, known: Known) -> Iterator[Item]:
    """What an action may begin with."""
    for name, (_, kind) in scope.variables.items():
        yield Item(name, ItemKind.VARIABLE, str(kind), insert=f"{name} = ", rank=1)
    for name in ACTION_FORMS:
        yield form(name, 2)
    reading, writing = ACTIONS
    yield Item(
        writing, ItemKind.WORD, "publish", "", f"{writing}.", rank=3, goes_on=True
    )  # fmt: skip
    yield Item(reading, ItemKind.WORD, "renew what is read in this step", rank=6)
    yield from topics(scope, known, rank=4)
    yield from agents(scope)


def _wanted(scope: Scope, slot: Slot, text: str) -> Type | None:
    """The type that a value should have, as far as what stands before it says."""
    if slot.left:
        return type_of(scope, slot.left, text)
    if slot.calls:
        return _parameter(scope, slot.calls[-1])
    return type_of(scope, slot.target, text) if slot.target else None


def _parameter(scope: Scope, call: Call) -> Type | None:
    """The type of an argument, if all functions of that name agree."""
    if call.function == "append" and call.argument == 1:
        known = scope.variables.get("".join(call.given[0]))
        return None if known is None else known[1].element
    kinds = {
        function.parameters[call.argument][1]
        for function in scope.symbols.overloads(call.function)
        if len(function.parameters) > call.argument
    }
    return kinds.pop() if len(kinds) == 1 else None


def type_of(scope: Scope, tokens: Sequence[Token], text: str) -> Type | None:
    """The type of an expression, if it is one."""
    try:
        written = read_expression(Source("<editor>", text), joined(text, tokens))
    except Malformed:
        return None
    value = type_value(written, scope)[0]
    return value.type if value is not None else None


__all__ = [
    "actions",
    "agents",
    "form",
    "form_parameters",
    "functions",
    "members",
    "outcomes",
    "signature",
    "topics",
    "type_of",
    "values",
]
