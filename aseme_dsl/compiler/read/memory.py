"""Memory: keeps the results of phases from one analysis to the next, as long as their inputs are the same.

A phase is a function. Its result is reused if its inputs are the same objects, or equal plain values. Three
kinds of input are compared by their answers only: mappings, functions among the inputs, and values that all
phases share (`shared`). Only the answers that the phase has asked for count. So a phase need not declare its
dependencies, and a memory never changes a result.

If a phase does the same for each of many things (`each`), the unchanged ones cost next to nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from operator import is_
from types import FunctionType
from typing import Any, Protocol, TypeVar, cast

from aseme_dsl.compiler.read.pieces import InPieces, finished
from aseme_dsl.records import dataclass

_T = TypeVar("_T")
_K = TypeVar("_K", bound=Hashable)

_PLAIN = (str, int, float, bool, frozenset, type(None))
_ABSENT = object()
_KEYS = object()

KEPT = 50
"""For how many analyses what is not asked for is kept: while there are errors, some phases have to wait."""

_REMEMBERED = 4
"""How many different values of one name are remembered: to change something and change it back is common."""

_Question = tuple[Any, ...]
"""Of which input (its number, or a `_Shared`), what was asked: a name, and a key or arguments."""


@dataclass(slots=True)
class _Entry:
    """A result, what it came from, and the number of the analysis that has used it last.

    `asked` are the answers of its inputs, `shared` those of what is shared, as they were when the shared had
    this `age`.
    """

    inputs: tuple[object, ...]
    asked: dict[_Question, object]
    shared: dict[_Question, object]
    result: object
    used: int
    age: int


@dataclass(slots=True)
class _Batch:
    """What a function was done for the last time: the entries by the identities of what each was of.

    The `items` are kept because no others have their identities then.
    """

    items: tuple[tuple[Any, ...], ...]
    common: tuple[object, ...]
    entries: dict[tuple[int, ...], _Entry]
    results: tuple[object, ...]


class Recall(Protocol):
    """`Memory.recall`: a function's result, from memory if it can be."""

    def __call__(self, function: Callable[..., _T], *inputs: object) -> _T: ...


class Memory:
    """The results of one program's phases. What many analyses do not ask for is forgotten."""

    def __init__(self, kept: int = KEPT) -> None:
        self._kept = kept
        self._entries: dict[tuple[object, ...], list[_Entry]] = {}
        self._values: dict[object, list[Any]] = {}
        self._mappings: dict[object, dict[Any, Any]] = {}
        self._batches: dict[object, _Batch] = {}
        self._shared: dict[object, _Shared] = {}
        self.protos: dict[str, Any] = {}
        """What was read of .proto files (see `load`), by where they are."""
        self._asked: dict[_Question, object] | None = None  # by the phase that runs now
        self._number = 0
        self._runs = 0  # how often something was found out
        self._age = 0
        self._is_older = False  # a shared value was replaced since it was asked last
        self._answers: dict[_Question, object] = {}  # the last answers of shared values
        self._changed: set[_Question] = set()  # questions whose answer has changed with a new age

    def recall(self, function: Callable[..., _T], *inputs: object) -> _T:
        """`function(*inputs)`, or its earlier result for the same inputs. Do not modify the result.

        The function must not recall anything itself.
        """
        return cast(_T, self._entry(function, inputs).result)

    def each(
        self, function: Callable[..., _T], inputs: Iterable[tuple[object, ...]], *common: object
    ) -> tuple[_T, ...]:
        """`recall(function, *item, *common)` for each of the inputs; see `each_in_pieces`."""
        return finished(self.each_in_pieces(function, inputs, *common))

    def each_in_pieces(
        self, function: Callable[..., _T], inputs: Iterable[tuple[Any, ...]], *common: Any
    ) -> InPieces[tuple[_T, ...]]:
        """`recall(function, *item, *common)` for each of the inputs, all as long; a piece is one done.

        If all results are those of the last call, the same tuple is returned. Do not modify a mapping after
        passing it here: the same object counts as unchanged. Two mappings are compared only once.
        """
        if self._is_older:
            self._ask_again()
        items = tuple(inputs)
        before = self._batches.get(function)
        changed: set[_Question] | None = None
        if before is not None and items:
            changed = _difference(before.common, common, len(items[0]))
        known = {} if before is None or changed is None else before.entries
        entries: dict[tuple[int, ...], _Entry] = {}
        found: list[Any] = []
        for item in items:
            key = tuple(map(id, item))
            entry = known.get(key)
            if entry is None or not self._holds(entry, changed):
                number = self._runs
                entry = self._entry(function, (*item, *common))
                if self._runs != number:
                    yield
            entry.used, entry.age = self._number, self._age
            entries[key] = entry
            found.append(entry.result)
        results = tuple(found)
        if (
            before is not None
            and len(results) == len(before.results)
            and all(map(is_, results, before.results))
        ):
            results = before.results
        self._batches[function] = _Batch(items, common, entries, results)
        return results

    def _holds(self, entry: _Entry, changed: set[_Question] | None) -> bool:
        """Whether an entry of the last time still does, but for what was `changed` of what all have."""
        if entry.age < self._age - 1 or (changed and not changed.isdisjoint(entry.asked)):
            return False
        return entry.age == self._age or self._changed.isdisjoint(entry.shared)

    def _entry(self, function: Callable[..., object], inputs: tuple[object, ...]) -> _Entry:
        if self._is_older:
            self._ask_again()
        entries = self._entries.setdefault((function, *map(_key, inputs)), [])
        for entry in entries:
            if self._is_same(entry, inputs):
                entry.used = self._number
                return entry
        self._runs += 1
        assert self._asked is None
        asked: dict[_Question, object] = {}
        self._asked = asked
        try:
            result = function(*(_traced(item, index, asked) for index, item in enumerate(inputs)))
        finally:
            self._asked = None
        # What is equal to a result before is that result, so that what depends on it stays as it is.
        result = next((item.result for item in entries if item.result == result), result)
        shared = {question: answer for question, answer in asked.items() if isinstance(question[0], _Shared)}
        own = {question: answer for question, answer in asked.items() if question not in shared}
        self._answers.update(shared)
        entries.append(_Entry(inputs, own, shared, result, self._number, self._age))
        return entries[-1]

    def _ask_again(self) -> None:
        """Find out which answers of what is shared have changed."""
        self._is_older = False
        self._age += 1
        self._changed = set()
        for question, before in self._answers.items():
            now = _answer((), question)
            if now is not before and now != before:
                self._changed.add(question)
                self._answers[question] = now

    def same(self, name: object, value: _T) -> _T:
        """`value`, or the equal one of this name of one of the last analyses."""
        values: list[_T] = self._values.setdefault(name, [])
        if values and values[0] is value:
            return value
        found = next((item for item in values if type(item) is type(value) and item == value), value)
        if not values or values[0] is not found:
            values[:] = [found, *(item for item in values if item is not found)][:_REMEMBERED]
        return found

    def same_values(self, name: object, values: dict[_K, _T]) -> dict[_K, _T]:
        """The values as the equal ones that the keys had the last time; that very mapping if all are so."""
        before = self._mappings.get(name)
        if before is not None:
            if before == values and list(before) == list(values):
                return before
            values = {
                key: known if (known := before.get(key, value)) is value or known == value else value
                for key, value in values.items()
            }
        self._mappings[name] = values
        return values

    def shared(self, name: object, value: _T) -> _T:
        """Something that answers as `value` does, and remains the same object in later analyses.

        What phases keep of it answers for the latest analysis.
        """
        found = self._shared.setdefault(name, _Shared(self))
        if object.__getattribute__(found, "_target") is not value:
            object.__setattr__(found, "_target", value)
            self._is_older = True
        return cast(_T, found)

    @contextmanager
    def trial(self) -> Iterator[None]:
        """What is analysed meanwhile is of a program that only might be: then all is as it was.

        What was found out is kept, as always.
        """
        before = {name: object.__getattribute__(shared, "_target") for name, shared in self._shared.items()}
        try:
            yield
        finally:
            for name, value in before.items():
                self.shared(name, value)

    def is_about(self, name: object, value: object) -> bool:
        """Whether what is shared by this name answers as this very object does."""
        found = self._shared.get(name)
        return found is not None and object.__getattribute__(found, "_target") is value

    def end(self) -> None:
        """An analysis is over."""
        self._number += 1
        if self._number % min(10, self._kept):
            return
        for key, entries in list(self._entries.items()):
            entries[:] = [item for item in entries if item.used >= self._number - self._kept]
            if not entries:
                del self._entries[key]
        asked = {
            question for entries in self._entries.values() for item in entries for question in item.shared
        }
        self._answers = {question: answer for question, answer in self._answers.items() if question in asked}

    def note(self, question: _Question, answer: object) -> None:
        """Something shared was asked."""
        if self._asked is not None:
            self._asked[question] = answer

    def _is_same(self, entry: _Entry, inputs: tuple[object, ...]) -> bool:
        for before, now in zip(entry.inputs, inputs, strict=True):
            if before is not now and _kind(now) is _OTHER:
                return False
        for question, answer in entry.asked.items():
            now = _answer(inputs, question)
            if now is not answer and now != answer:
                return False
        if entry.age < self._age - 1:
            for question, answer in entry.shared.items():
                now = self._answers[question]
                if now is not answer and now != answer:
                    return False
        elif entry.age < self._age and not self._changed.isdisjoint(entry.shared):
            return False
        entry.age = self._age
        return True


_OTHER, _IS_PLAIN, _IS_TRACED = range(3)
_kinds: dict[type, int] = {}
"""Which of these a type is: to find out takes longer than to look it up."""


def _kind(item: object) -> int:
    kind = _kinds.get(type(item))
    if kind is None:
        kind = _IS_PLAIN if isinstance(item, _PLAIN) else _OTHER
        if isinstance(item, (Mapping, FunctionType)):
            kind = _IS_TRACED
        _kinds[type(item)] = kind
    return kind


def _key(item: object) -> object:
    kind = _kind(item)
    return id(item) if kind is _OTHER else item if kind is _IS_PLAIN else None


def _difference(before: tuple[object, ...], now: tuple[object, ...], first: int) -> set[_Question] | None:
    """What has another answer than before, of inputs that have numbers from `first` on; None if that cannot
    be said, since there is something else altogether."""
    found: set[_Question] = set()
    for number, (old, new) in enumerate(zip(before, now, strict=True), first):
        if old is new or (_kind(new) is _IS_PLAIN and type(old) is type(new) and old == new):
            continue
        if not isinstance(new, Mapping) or not isinstance(old, Mapping):
            return None
        for key, value in new.items():
            known = old.get(key, _ABSENT)
            if known is not value and known != value:
                found.add((number, key))
        found |= {(number, key) for key in old if key not in new}
        if tuple(old) != tuple(new):
            found.add((number, _KEYS))
    return found


def _answer(inputs: tuple[Any, ...], question: _Question) -> Any:
    """What the answer is now."""
    subject = question[0]
    if isinstance(subject, _Shared):
        value = getattr(object.__getattribute__(subject, "_target"), question[1])
        if len(question) == 2:
            return value
        return value(*question[2]) if callable(value) else _looked_up(value, question[2])
    now = inputs[subject]
    if type(now) is dict or isinstance(now, Mapping):  # the first is quicker, and nearly always so
        return _looked_up(now, question[1])
    return now(*question[1])


def _looked_up(mapping: Mapping[object, object], key: object) -> object:
    return tuple(mapping) if key is _KEYS else mapping.get(key, _ABSENT)


def _traced(item: object, index: int, asked: dict[_Question, object]) -> object:
    if isinstance(item, Mapping):
        return _TracedMapping(item, lambda key, answer: asked.__setitem__((index, key), answer))
    if isinstance(item, FunctionType):

        def question(*arguments: object) -> object:
            answer = asked[index, arguments] = item(*arguments)
            return answer

        return question
    return item


class _TracedMapping(Mapping[object, object]):
    """A mapping that tells what it is asked for."""

    __slots__ = ("_mapping", "_note")

    def __init__(self, mapping: Mapping[object, object], note: Callable[[object, object], None]) -> None:
        self._mapping = mapping
        self._note = note

    def __getitem__(self, key: object) -> object:
        value = self._mapping.get(key, _ABSENT)
        self._note(key, value)
        if value is _ABSENT:
            raise KeyError(key)
        return value

    def __iter__(self) -> Iterator[object]:
        keys = tuple(self._mapping)
        self._note(_KEYS, keys)
        return iter(keys)

    def __len__(self) -> int:
        return len(tuple(iter(self)))


class _Shared:
    """Stands for an object of which each analysis makes a new one, and tells what it is asked for."""

    __slots__ = ("_memory", "_target")
    _memory: Memory
    _target: object

    def __init__(self, memory: Memory) -> None:
        self._memory = memory
        self._target = None

    def __getattr__(self, name: str) -> object:
        value = getattr(self._target, name)
        memory = self._memory
        if callable(value):

            def asked(*arguments: object) -> object:
                answer = value(*arguments)
                memory.note((self, name, arguments), answer)
                return answer

            return asked
        if isinstance(value, Mapping):
            return _TracedMapping(value, lambda key, answer: memory.note((self, name, key), answer))
        memory.note((self, name), value)
        return value


__all__ = ["Memory", "Recall"]
