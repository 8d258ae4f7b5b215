"""Message types: the enums and messages of a document, and those of the .proto files that it imports."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from aseme_dsl.amola.messages import EnumType, Field, Kind, Message, ProtoFile
from aseme_dsl.amola.python_names import taken_as_constant, taken_as_member, taken_as_type
from aseme_dsl.compiler.read.builtins import reserved
from aseme_dsl.compiler.read.collector import Collector, type_named
from aseme_dsl.compiler.read.names import declared_twice
from aseme_dsl.diagnostics import Related
from aseme_dsl.diagnostics.problems import names as problems
from aseme_dsl.diagnostics.problems.files import TwoProtoFiles
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span

if TYPE_CHECKING:
    from aseme_dsl.interop.proto import ProtoImport

LARGEST_NUMBER = 2**29 - 1
RESERVED_NUMBERS = range(19_000, 20_000)
LARGEST_ENUM_NUMBER = 2**31 - 1


def imported_types(
    collector: Collector, protos: Sequence[ProtoImport]
) -> tuple[tuple[EnumType, ...], tuple[Message, ...], tuple[ProtoFile, ...]]:
    """The types of .proto files, each declared as if it stood before the document's own."""
    if not protos:
        return (), (), ()
    from aseme_dsl.interop.proto import join

    known: dict[str, tuple[ProtoFile, ProtoImport]] = {}
    for one in protos:
        for file in one.files:
            other, first = known.setdefault(file.name, (file, one))
            if other.descriptor != file.descriptor:
                related = Related(first.at, "the other one comes with this import")
                collector.report(TwoProtoFiles(file.name), one.at, related)
    own = {item.name.text for item in collector.every(tree.Enum)}
    own |= {item.name.text for item in collector.every(tree.Message)}
    enum_types, message_types, files = join(protos, own)
    collector.types.update((item.name, item.span) for item in enum_types)
    collector.types.update((item.name, item.span) for item in message_types)
    return enum_types, message_types, files


def _declare_type(collector: Collector, kind: str, name: tree.Name) -> bool:
    """Enter the name of an enum or message; whether it is the first of that name."""
    reason = _refusal(name.text, taken_as_type)
    if reason is not None:
        collector.report(problems.ReservedName(kind, name.text, reason), name.span)
        collector.wrong.add(name.text)
    if name.text in collector.types:
        collector.diagnostics.append(declared_twice("type", name, collector.types[name.text]))
        return False
    collector.types[name.text] = name.span
    return True


def _refusal(name: str, taken: Callable[[str], bool]) -> problems.Reserved | None:
    """Why neither the language nor the generated Python, where it would be `taken`, can have `name`."""
    return reserved(name) or ("generated" if taken(name) else None)


def enums(collector: Collector) -> tuple[EnumType, ...]:
    """The enums of the document, with their constants' numbers."""
    found = []
    for item in collector.every(tree.Enum):
        if _declare_type(collector, "enum", item.name):
            found.append(EnumType(item.name.text, _constants(collector, item), item.name.span))
    return tuple(found)


def _constants(collector: Collector, enum: tree.Enum) -> tuple[tuple[str, int], ...]:
    """The constants with their numbers: each one more than the one before it, from 0, unless it is given."""
    if not enum.constants:
        collector.report(problems.NoConstants(enum.name.text), enum.name.span)
    found: list[tuple[str, int]] = []
    names: dict[str, Span] = {}
    shapes: dict[str, tree.Name] = {}
    numbers: dict[int, tree.Name] = {}
    for item in enum.constants:
        name, number = item.name, item.number
        if number is None:
            number = found[-1][1] + 1 if found else 0
        reason = _refusal(name.text, taken_as_constant)
        if reason is not None:
            collector.report(problems.ReservedName("constant", name.text, reason), name.span)
        if name.text in names:
            collector.diagnostics.append(declared_twice("constant", name, names[name.text]))
            continue
        names[name.text] = name.span
        other = shapes.setdefault(_enum_shape(name.text), name)
        if other is not name:
            same = problems.SameConstant(name.text, other.text)
            collector.report(same, name.span, Related(other.span, "the other one"))
        if not found and number != 0:
            collector.report(problems.FirstConstantNotZero(number), name.span)
        if not -LARGEST_ENUM_NUMBER - 1 <= number <= LARGEST_ENUM_NUMBER:
            collector.report(problems.ConstantOutOfRange(number), item.span)
        elif number in numbers:
            twice = problems.NumberTwice("constant", name.text, number, numbers[number].text)
            collector.report(twice, item.span, Related(numbers[number].span, "used here"))
        numbers.setdefault(number, name)
        found.append((name.text, number))
    return tuple(found)


def _enum_shape(constant: str) -> str:
    """What protoc compares when it looks for constants that other languages could not tell apart."""
    return "".join(part[:1].upper() + part[1:].lower() for part in constant.split("_"))


def messages(
    collector: Collector, enum_names: Collection[str], imported: Iterable[Message]
) -> tuple[Message, ...]:
    """The messages of the document, with their fields' types and numbers."""
    declared = [
        item for item in collector.every(tree.Message) if _declare_type(collector, "message", item.name)
    ]
    # Fields may name messages that come later: all names first, then the fields.
    names = {item.name.text for item in declared} | {item.name for item in imported}
    found = []
    for item in declared:
        found.append(Message(item.name.text, _fields(collector, item, enum_names, names), item.name.span))
    _check_containment(collector, found)
    return tuple(found)


def _fields(
    collector: Collector, message: tree.Message, enum_names: Collection[str], messages: set[str]
) -> tuple[Field, ...]:
    """The fields with their numbers: those given, and for the others the smallest free ones in order."""
    given = {item.number for item in message.fields if item.number is not None}
    free = (
        number
        for number in range(1, LARGEST_NUMBER)
        if number not in given and number not in RESERVED_NUMBERS
    )
    found: list[Field] = []
    names: dict[str, Span] = {}
    shapes: dict[str, tree.Name] = {}
    numbers: dict[int, tree.Name] = {}
    for item in message.fields:
        name = item.name
        kind = type_named(collector, item.type, enum_names, messages)
        if kind is None:
            collector.wrong.add(message.name.text)
        _check_member_name(collector, name, enum_names, messages)
        number = next(free) if item.number is None else _checked_number(collector, item, numbers)
        if name.text in names:
            collector.diagnostics.append(declared_twice("field", name, names[name.text]))
            continue
        names[name.text] = name.span
        other = shapes.setdefault(_json_name(name.text), name)
        if other is not name:
            same = problems.SameField(name.text, other.text, _json_name(name.text))
            collector.report(same, name.span, Related(other.span, "the other one"))
        if kind is not None:
            found.append(Field(name.text, kind, number, item.label, name.span))
    return tuple(found)


def _check_member_name(
    collector: Collector, name: tree.Name, enum_names: Collection[str], messages: set[str]
) -> None:
    reason = _refusal(name.text, taken_as_member)
    if reason is None and (name.text in messages or name.text in enum_names):
        reason = "type"
    if reason is not None:
        collector.report(problems.ReservedName("field", name.text, reason), name.span)


def _checked_number(collector: Collector, item: tree.Field, numbers: dict[int, tree.Name]) -> int:
    number = item.number
    assert number is not None
    if not 1 <= number <= LARGEST_NUMBER or number in RESERVED_NUMBERS:
        collector.report(problems.FieldOutOfRange(number, LARGEST_NUMBER), item.span)
    elif number in numbers:
        twice = problems.NumberTwice("field", item.name.text, number, numbers[number].text)
        collector.report(twice, item.span, Related(numbers[number].span, "used here"))
    numbers.setdefault(number, item.name)
    return number


def _json_name(name: str) -> str:
    """As protoc makes it: no underscores, and a capital behind each."""
    return re.sub(r"_+(.?)", lambda match: match[1].upper(), name)


def _check_containment(collector: Collector, messages: list[Message]) -> None:
    """A message may contain itself only where it may also end: in an optional or repeated field."""
    by_name = {message.name: message for message in messages}
    done: set[str] = set()
    for message in messages:
        if message.name in done:
            continue
        chain: list[tuple[Message, Iterator[Field], Field | None]] = [(message, iter(message.fields), None)]
        while chain:
            owner, rest, _ = chain[-1]
            for item in rest:
                inner = by_name.get(item.type.name) if item.type.kind is Kind.MESSAGE else None
                if inner is None or item.label or inner.name in done:
                    continue
                around = [entry[0].name for entry in chain]
                if inner.name in around:
                    _report_circle(collector, chain[around.index(inner.name) :], item)
                    continue
                chain.append((inner, iter(inner.fields), item))
                break
            else:
                done.add(owner.name)
                chain.pop()


def _report_circle(
    collector: Collector, chain: list[tuple[Message, Iterator[Field], Field | None]], closing: Field
) -> None:
    path = (*(entry[0].name for entry in chain), chain[0][0].name)
    related = tuple(
        Related(entry[2].span, "through this field") for entry in chain[1:] if entry[2] is not None
    )
    collector.report(problems.MessageInItself(path), closing.span, *related)
    collector.wrong.update(entry[0].name for entry in chain)
