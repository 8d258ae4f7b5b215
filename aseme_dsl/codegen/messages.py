"""Messages: the text of the generated module `messages`: enums, messages, and how they go over a wire."""

from __future__ import annotations

import base64
import textwrap
from collections.abc import Callable, Iterator
from pathlib import PurePath

from aseme_dsl.amola.messages import EnumType, Field, Kind, Message
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.place import in_docstring, place
from aseme_dsl.codegen.proto import descriptor_set, full_name
from aseme_dsl.codegen.radio import codes
from aseme_dsl.source import Span

_PYTHON = {
    Kind.BOOL: ("bool", "False"),
    Kind.INT: ("int", "0"),
    Kind.DOUBLE: ("float", "0.0"),
    Kind.STRING: ("str", '""'),
    Kind.BYTES: ("bytes", 'b""'),
    Kind.DURATION: ("int", "0"),
}

_WIDTH = 88
"""The line length of an unconfigured ruff: what is shorter stays on one line there and everywhere."""


def generate_messages(system: System) -> str:
    """The module: `IntEnum`s, frozen dataclasses, `CHANNELS` (text to class) and `SCHEMA` (the wire).

    The same system gives the same text, which passes ruff (check and format) and mypy --strict.
    """
    return "\n".join(_lines(system, place)) + "\n"


def meaning_of_messages(system: System) -> str:
    """What that module means: a text that is another one if it does, wherever the messages stand."""
    return "\n".join(_lines(system, lambda span: ""))


def _lines(system: System, shown: Callable[[Span], str]) -> Iterator[str]:
    messages = in_order(system.messages)
    spans = [enum.span for enum in system.enums] + [message.span for message in messages]
    sources = dict.fromkeys(PurePath(span.source.path).name for span in spans if shown(span))
    yield f'"""Messages of {system.name}. Generated: a change here is lost with the next build.'
    yield ""
    yield from textwrap.wrap(in_docstring(f"From {', '.join(sources) or 'no declarations'}."), _WIDTH)
    yield '"""'
    yield ""
    yield "from __future__ import annotations"
    yield ""
    if messages:
        yield "import dataclasses"
    if system.enums:
        yield "import enum"
    if messages or system.enums:
        yield ""
    yield "from aseme_dsl.runtime.message import wire"
    for enum in system.enums:
        yield from _enum(enum, shown(enum.span))
    for message in messages:
        yield from _message(system, message, shown(message.span))
    yield from _schema(system, messages)


def in_order(messages: tuple[Message, ...]) -> tuple[Message, ...]:
    """Each message after those that are in its defaults, otherwise as they are."""
    by_name = {message.name: message for message in messages}
    found: dict[str, Message] = {}
    for message in messages:
        stack = [(message, iter(message.fields))]
        while stack:
            owner, rest = stack[-1]
            for field in rest:
                if field.type.kind is Kind.MESSAGE and not field.label and field.type.name not in found:
                    inner = by_name[field.type.name]
                    stack.append((inner, iter(inner.fields)))
                    break
            else:
                found.setdefault(owner.name, owner)
                stack.pop()
    return tuple(found.values())


def _enum(enum: EnumType, shown: str) -> Iterator[str]:
    yield ""
    yield ""
    yield f"class {enum.name}(enum.IntEnum):"
    yield f'    """{in_docstring(shown)}"""'
    yield ""
    for name, number in enum.constants:
        yield f"    {name} = {number}"


def _message(system: System, message: Message, shown: str) -> Iterator[str]:
    yield ""
    yield ""
    yield "@dataclasses.dataclass(frozen=True, slots=True)"
    yield f"class {message.name}:"
    yield f'    """{in_docstring(shown)}"""'
    if message.fields:
        yield ""
    for field in message.fields:
        yield from _member(system, field)
    if message.fields:
        yield ""
        yield "    def __post_init__(self) -> None:"
        yield "        wire.check(self)"


def _member(system: System, field: Field) -> Iterator[str]:
    if field.type.kind in _PYTHON:
        kind, default = _PYTHON[field.type.kind]
    else:
        kind = field.type.name
        default = f"dataclasses.field(default_factory={kind})"
    if field.type.kind is Kind.ENUM:
        enum = system.enum(field.type.name)
        assert enum is not None
        default = f"{enum.name}.{enum.constants[0][0]}"
    if field.label == "repeated":
        kind, default = f"tuple[{kind}, ...]", "()"
    elif field.label == "optional":
        kind, default = f"{kind} | None", "None"
    line = f"    {field.name}: {kind} = {default}"
    if len(line) <= _WIDTH:
        yield line
        return
    # Too long for one line: the comma keeps a formatter with a longer line from joining it again.
    if default.startswith("dataclasses.field("):
        yield f"    {field.name}: {kind} = dataclasses.field("
        yield f"        default_factory={field.type.name},"
        yield "    )"
    else:
        yield line + "  # fmt: skip"


def _schema(system: System, messages: tuple[Message, ...]) -> Iterator[str]:
    channels = [rules.channel for topic in system.topics for rules in topic.channels]
    yield ""
    if system.enums or messages:
        yield ""
    yield from _mapping(
        "CHANNELS: dict[str, type[object]] = {", [f'"{channel}": {channel.message},' for channel in channels]
    )
    yield '"""The class of the messages of each channel."""'
    yield ""
    yield '_DESCRIPTORS = """'
    yield from textwrap.wrap(base64.b64encode(descriptor_set(system)).decode("ascii"), 76)
    yield '"""'
    yield ""
    yield "SCHEMA = wire.Schema("
    yield "    descriptors=_DESCRIPTORS,"
    yield from _mapping(
        "    classes={", [f'{message.name}: "{full_name(system, message)}",' for message in messages], "},"
    )
    yield "    channels=CHANNELS,"
    on_air = [
        f'"{rules.channel}": "{codes(system, rules.channel.message)}",'
        for topic in system.topics
        if topic.radio is not None
        for rules in topic.channels
    ]
    yield from _mapping("    radio={", on_air, "},")
    durations = [
        f'"{message.name}.{field.name}",'
        for message in messages
        for field in message.fields
        if field.type.kind is Kind.DURATION
    ]
    if durations:
        yield from _mapping("    durations=(", durations, "),")
    yield ")"
    yield '"""How messages become bytes."""'


def _mapping(opening: str, entries: list[str], closing: str = "}") -> Iterator[str]:
    indent = opening[: len(opening) - len(opening.lstrip())]
    if not entries:
        yield opening + closing
        return
    yield opening
    yield from (f"{indent}    {entry}" for entry in entries)
    yield indent + closing
