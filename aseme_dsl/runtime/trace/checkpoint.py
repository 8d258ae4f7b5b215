"""Checkpoints: the saved state of a chart as the member of a line, and back.

A message, or what carries one, that stands in it several times is one object: conditions ask whether a
message is another one than before. So each is written once, and counted.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from enum import IntEnum
from typing import TypeAlias, Unpack, cast

from aseme_dsl.runtime.chart.board import Known, Messages, SavedBoard, SavedDrafts, saved_board, whole
from aseme_dsl.runtime.chart.inputs import AgentMessage, Identity, Sample
from aseme_dsl.runtime.chart.rounds import Round
from aseme_dsl.runtime.chart.saving import Saved, Seldom
from aseme_dsl.runtime.message.as_json import from_json, to_json

EVERY = 2 << 20
"""When so many characters of lines have been written, the agents' checkpoints follow: not much more has to be
read for the state at any moment."""
SHARE = 8
"""At least so many times as long as the last checkpoints are the lines up to the next ones."""

_Make: TypeAlias = Callable[[Unpack[tuple[object, ...]]], object]

_Board: TypeAlias = tuple[Messages, frozenset[Identity], tuple[tuple[str, int], ...], SavedDrafts]
"""A saved board as it is read."""

_CARRIERS = {"sample": cast(_Make, Sample), "mail": cast(_Make, AgentMessage)}
"""What carries messages, by how it is written: its members stand there in their order."""


def state_of(saved: Saved, *, shared: bool = True) -> list[object]:
    """A saved state as what `json` can write; if not `shared`, each object is written where it stands."""
    model, values, boards, seldom = saved
    every = tuple([None if held is None else whole(held) for held in boards])
    return cast("list[object]", _Writer(shared).written((model, values, every, seldom)))


class _Writer:
    def __init__(self, shared: bool) -> None:
        self._shared = shared
        self._known: dict[int, int] = {}

    def written(self, value: object) -> object:
        kind = type(value)
        if value is None or kind is bool or kind is int or kind is str:
            return value
        if isinstance(value, Known):
            value = value.messages()
        if isinstance(value, tuple):
            return [self.written(item) for item in value]
        if isinstance(value, frozenset):
            return {"set": sorted(map(self.written, value), key=repr)}
        if isinstance(value, IntEnum):
            return {"enum": [kind.__name__, value.name]}
        if is_dataclass(value):
            return self._object(value)
        if kind is float:
            found = to_json(value)
            return {"double": found} if isinstance(found, str) else found
        return {"bytes": to_json(value)}

    def _object(self, value: object) -> object:
        if self._shared:
            number = self._known.get(id(value))
            if number is not None:
                return {"again": number}
        if isinstance(value, Sample | AgentMessage):
            name = "sample" if isinstance(value, Sample) else "mail"
            found: object = {name: [self.written(getattr(value, item.name)) for item in fields(value)]}
        else:
            found = {"message": [type(value).__name__, to_json(value)]}
        self._known[id(value)] = len(self._known)
        return found


def saved_of(state: object, messages: Mapping[str, type[object]]) -> Saved:
    """The saved state that was written; `messages` are the classes of messages and enums by name.

    Raises:
        ValueError: it is none of this model.
    """
    try:
        model, values, boards, seldom = cast("list[list[object]]", _Reader(messages).read(state))
        saved = tuple([None if board is None else _board(cast(_Board, board)) for board in boards])
        found = Seldom(*seldom)  # type: ignore[arg-type]
        rounds = tuple([Round._make(item) for item in found.rounds])
        return Saved(str(model), tuple(values), saved, found._replace(rounds=rounds))
    except (TypeError, LookupError, AttributeError) as problem:
        raise ValueError(f"the state does not fit the model: {problem}") from problem


def _board(read: _Board) -> SavedBoard:
    messages, ahead, timers, drafts = read
    return saved_board((Known.of(messages), ahead, timers, drafts))


class _Reader:
    def __init__(self, messages: Mapping[str, type[object]]) -> None:
        self._messages = messages
        self._known: list[object] = []

    def read(self, value: object) -> object:
        if isinstance(value, list):
            return tuple([self.read(item) for item in value])
        if not isinstance(value, dict):
            return value
        ((name, content),) = value.items()
        match name:
            case "again":
                return self._known[content]
            case "set":
                return frozenset(self.read(item) for item in content)
            case "enum":
                return from_json(self._messages[content[0]], content[1])
            case "double":
                return from_json(float, content)
            case "bytes":
                return from_json(bytes, content)
        if name in _CARRIERS:
            found: object = _CARRIERS[name](*[self.read(item) for item in content])
        else:
            found = from_json(self._messages[content[0]], content[1])
        self._known.append(found)
        return found


__all__ = ["EVERY", "SHARE", "saved_of", "state_of"]
