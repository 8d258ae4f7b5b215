"""Memory: what phases have found, from one analysis to the next, as long as what they have read is the same.

A phase is a function. Its result is taken again if its inputs are the same objects, or equal where they are
plain values. Of a mapping and of a question (a function among the inputs) only those answers count that the
phase has asked for. So nobody has to say on what a phase depends, and a memory never changes what comes out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from types import FunctionType
from typing import Any, Protocol, TypeVar, cast

_T = TypeVar("_T")

_PLAIN = (str, int, float, bool, frozenset, type(None))
_ABSENT = object()


@dataclass(frozen=True, slots=True)
class _Asked:
    """What was asked of an input: a key of a mapping (or all keys), or the arguments of a question."""

    input: int
    question: Any
    answer: Any


@dataclass(slots=True)
class _Entry:
    """A result, what it came from, and the number of the analysis that has used it last."""

    inputs: tuple[Any, ...]
    asked: list[_Asked]
    result: Any
    used: int


_ALL_KEYS = object()


class Recall(Protocol):
    """`Memory.recall`: a function's result, from memory if it can be."""

    def __call__(self, function: Callable[..., _T], *inputs: Any) -> _T: ...


KEPT = 50
"""For how many analyses what is not asked for is kept: while there are errors, some phases have to wait."""


class Memory:
    """The results of one program's phases. What many analyses do not ask for is forgotten."""

    def __init__(self) -> None:
        self._entries: dict[tuple[Any, ...], list[_Entry]] = {}
        self._values: dict[object, Any] = {}
        self._number = 0

    def recall(self, function: Callable[..., _T], *inputs: Any) -> _T:
        """`function(*inputs)`, or what it was when it was asked for before; nobody may change the result."""
        entries = self._entries.setdefault((function, *map(_key, inputs)), [])
        for entry in entries:
            if _is_same(entry, inputs):
                entry.used = self._number
                return cast(_T, entry.result)
        asked: list[_Asked] = []
        result = function(*(_traced(item, index, asked) for index, item in enumerate(inputs)))
        entries.append(_Entry(inputs, asked, result, self._number))
        return result

    def same(self, name: object, value: _T) -> _T:
        """`value`, or the equal one of this name of the analysis before."""
        before = self._values.get(name, _ABSENT)
        if before is not _ABSENT and type(before) is type(value) and before == value:
            kept: _T = before
            return kept
        self._values[name] = value
        return value

    def end(self) -> None:
        """An analysis is over."""
        self._number += 1
        if self._number % 10:
            return
        for key, entries in list(self._entries.items()):
            entries[:] = [item for item in entries if item.used >= self._number - KEPT]
            if not entries:
                del self._entries[key]


def _is_traced(item: Any) -> bool:
    return isinstance(item, (Mapping, FunctionType))


def _key(item: Any) -> object:
    if isinstance(item, _PLAIN):
        return item
    return None if _is_traced(item) else id(item)


def _is_same(entry: _Entry, inputs: tuple[Any, ...]) -> bool:
    for before, now in zip(entry.inputs, inputs, strict=True):
        if before is not now and not isinstance(now, _PLAIN) and not _is_traced(now):
            return False
    return all(_answers_as_before(item, inputs[item.input]) for item in entry.asked)


def _answers_as_before(item: _Asked, now: Any) -> bool:
    if isinstance(now, Mapping):
        if item.question is _ALL_KEYS:
            return bool(tuple(now) == item.answer)
        answer = now.get(item.question, _ABSENT)
    else:
        answer = now(*item.question)
    return answer is item.answer or bool(answer == item.answer)


def _traced(item: Any, index: int, asked: list[_Asked]) -> Any:
    if isinstance(item, Mapping):
        return _TracedMapping(item, index, asked)
    if isinstance(item, FunctionType):

        def question(*arguments: Any) -> Any:
            answer = item(*arguments)
            asked.append(_Asked(index, arguments, answer))
            return answer

        return question
    return item


class _TracedMapping(Mapping[Any, Any]):
    """A mapping that notes what it is asked for."""

    __slots__ = ("_asked", "_index", "_mapping")

    def __init__(self, mapping: Mapping[Any, Any], index: int, asked: list[_Asked]) -> None:
        self._mapping = mapping
        self._index = index
        self._asked = asked

    def __getitem__(self, key: Any) -> Any:
        value = self._mapping.get(key, _ABSENT)
        self._asked.append(_Asked(self._index, key, value))
        if value is _ABSENT:
            raise KeyError(key)
        return value

    def __iter__(self) -> Iterator[Any]:
        keys = tuple(self._mapping)
        self._asked.append(_Asked(self._index, _ALL_KEYS, keys))
        return iter(keys)

    def __len__(self) -> int:
        return len(tuple(iter(self)))


__all__ = ["Memory", "Recall"]
