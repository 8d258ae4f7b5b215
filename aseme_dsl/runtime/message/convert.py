"""Converting: messages of one version of a system as messages of another, member by member."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import is_dataclass, replace
from enum import IntEnum
from typing import get_args, get_origin

from aseme_dsl.runtime.chart.inputs import AgentMessage, Sample
from aseme_dsl.runtime.message.as_json import from_json, member_types, to_json
from aseme_dsl.runtime.message.by_name import made

Messages = Mapping[str, type[object]]
"""The message classes of a version by name."""


def converted(message: object, messages: Messages) -> object:
    """A message as one of these classes: what has the same name and type there is taken over.

    Fields that are new have their default, those that are removed or of another type are lost. Raises
    LookupError if there is no message of that name.
    """
    kind: type = type(message)
    if not hasattr(kind, "__dataclass_fields__"):
        return message
    wanted: type | None = messages.get(kind.__name__)
    if wanted is None:
        raise LookupError(f"there is no message {kind.__name__}")
    if wanted is kind:
        return message
    known = member_types(kind)
    given: dict[str, object] = {}
    for name, hint in member_types(wanted).items():
        if name in known:
            try:
                given[name] = from_json(hint, to_json(getattr(message, name)))
            except ValueError:
                continue  # of another type
    return made(wanted, **given)


def like(value: object, example: object, messages: Messages) -> object:
    """The value of a variable as one that has the type of `example`. Raises LookupError if it is none."""
    if isinstance(example, IntEnum):
        kind = type(example)
        if not isinstance(value, IntEnum) or value.name not in kind.__members__:
            raise LookupError(f"{kind.__name__} has no constant {getattr(value, 'name', value)}")
        return kind[value.name]
    if isinstance(value, tuple):
        return tuple(converted(item, messages) for item in value)
    return converted(value, messages)


def arrived(item: Sample, messages: Messages) -> Sample:
    """What has arrived, with its message converted. Raises LookupError like `converted`."""
    message = converted(item.message, messages)
    return item if message is item.message else replace(item, message=message)


def mailed(item: AgentMessage, messages: Messages) -> AgentMessage:
    """An agent message with its content converted. Raises LookupError like `converted`."""
    content = converted(item.content, messages)
    return item if content is item.content else replace(item, content=content)


def same_shape(one: object, other: object) -> bool:
    """Whether two message classes have the same members."""
    if one is other:
        return True
    if one is None or other is None:
        return False
    return _shape(one) == _shape(other)


def _shape(kind: object) -> list[tuple[str, str]]:
    return [(name, _name(hint)) for name, hint in member_types(kind).items()]


def _name(hint: object) -> str:
    if is_dataclass(hint) and isinstance(hint, type):
        return f"{hint.__name__}{_shape(hint)}"
    if isinstance(hint, type) and issubclass(hint, IntEnum):
        return f"{hint.__name__}{[(item.name, item.value) for item in hint]}"
    inside = get_args(hint)
    return f"{get_origin(hint)}{[_name(item) for item in inside]}" if inside else str(hint)
