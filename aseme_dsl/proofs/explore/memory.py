"""Memory: the whole state of a team between two steps: a picture to come back to, and a key to compare.

The objects of a team are changed in place. A picture has what each object held. Taking it back gives all of
them that again, and they stay the same objects: so a call that waits, or a part in a conversation, still
means them.

Keys forget what makes no difference: numbers that only count up are renamed in the order of their occurrence.
"""

from __future__ import annotations

import itertools
import marshal
import re
import threading
from collections import deque
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from enum import Enum, auto
from functools import partial
from hashlib import blake2b
from operator import attrgetter
from types import (
    BuiltinFunctionType,
    FunctionType,
    MappingProxyType,
    MemberDescriptorType,
    MethodType,
    ModuleType,
)
from typing import Any, cast

from aseme_dsl.proofs.explore.deciding.later import content_of
from aseme_dsl.proofs.explore.deciding.order import AnyNumber
from aseme_dsl.proofs.explore.deciding.unread import place_of
from aseme_dsl.proofs.timed.stamp import Stamp
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.board import Whole, whole
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.saving import Saved

_PLAIN = (
    *(type(None), bool, int, float, str, bytes, type, Enum),
    *(ModuleType, BuiltinFunctionType, MappingProxyType),
    *(type(threading.Lock()), type(threading.RLock())),
)
_SIMPLE = frozenset((type(None), bool, int, float, bytes))
_COUNT = type(itertools.count())
_NUMBERED = re.compile(r"(.*\D)([0-9]+)")


class _Kind(Enum):
    """How the content of an object is taken and put back."""

    PLAIN = auto()
    VALUE = auto()
    CHART = auto()
    LIST = auto()
    DICT = auto()
    SET = auto()
    TUPLE = auto()
    CALL = auto()
    OBJECT = auto()

    __hash__ = object.__hash__  # that of an Enum is slow


@dataclass(frozen=True, slots=True)
class Layout:
    """Which objects and attributes of a team are its state."""

    values: tuple[type, ...]
    """The classes whose objects are never changed."""
    constant: tuple[type, ...]
    """The classes whose objects are the same in all states."""
    parts: Mapping[type, tuple[str, ...]]
    """The attributes of classes that belong to the state, where these are not all."""
    unkeyed: Mapping[type, frozenset[str]]
    """The attributes that belong to it, and make no difference."""
    ordered: Mapping[type, Callable[[Any], object]]
    """What of an object depends on the order in a dictionary; no other order in one makes a difference."""


@dataclass(frozen=True, slots=True)
class _Class:
    """What is known of the objects of a class."""

    kind: _Kind
    names: tuple[str, ...] = ()
    """The attributes that belong to the state; of one that `has_dict`, all in `__dict__` do, too."""
    unkeyed: frozenset[str] = frozenset()
    has_dict: bool = False
    read: Callable[[Any], Any] = lambda item: ()
    """Gives the attributes together, if all are there."""


_Held = tuple[tuple[object, _Class, Any], ...]
"""Objects with what is known of their classes, and with their contents."""


@dataclass(frozen=True, slots=True)
class Section:
    """What the objects of one section hold: those of one agent, or those that the team has in common."""

    objects: _Held
    places: Mapping[int, int]
    """Where objects stand among those that make a difference, by their identities."""
    shape: bytes
    """Stands for all that makes a difference, without the numbers of names that count up."""
    names: tuple[tuple[str, int], ...]
    """These names with their numbers, in the order of their occurrence."""
    meant: Mapping[int, tuple[int, int]]
    """The objects of other sections that are meant, with their sections and places there."""


Picture = tuple[Section, ...]
"""What all objects of a team hold, by sections."""

_MISSING = object()


class Memory:
    """Takes pictures of all that can be reached from the roots, and makes keys of them."""

    def __init__(
        self,
        sections: Sequence[Sequence[object]],
        layout: Layout,
        senders: Iterable[str],
        protocols: Iterable[str],
        decided: Callable[[Iterable[int]], str],
    ) -> None:
        """`sections` are the roots of each section. The last one is what the others have in common: it may
        mean objects of the others, but these do not mean its objects, nor each other's.

        What these `senders` send is numbered, and so are the conversations of the `protocols`. `decided` says
        what has been decided of contents and numbers.
        """
        self._decided = decided
        self._roots = tuple(tuple(reversed(roots)) for roots in sections)
        self._now: list[Section | None] = [None] * len(sections)
        """What the objects of each section hold, unless they may have been changed."""
        self._last: list[Section | None] = [None] * len(sections)
        """What they held when it was last known."""
        self._layout = layout
        self.senders = frozenset(senders)
        talks = (f"{protocol}-{name}-" for protocol in protocols for name in self.senders)
        self._prefixes = frozenset((*(f"{name}-" for name in self.senders), *talks))
        self._classes: dict[type, _Class] = {}
        self._plain: set[type] = set()
        """The classes whose objects have nothing in them that may change."""
        self._texts: dict[str, tuple[str, int] | None] = {}
        """Whether texts are names that count up, for those that were seen."""

    # ---- pictures ----------------------------------------------------------------------------

    def touch(self, section: int) -> None:
        """Objects of a section may be changed from now on, until the next picture."""
        for number in (section, -1):
            self._last[number] = self._now[number] or self._last[number]
            self._now[number] = None

    def picture(self) -> Picture:
        """What all objects hold now."""
        found: list[Section] = []
        places: dict[int, tuple[int, int]] = {}
        for number, known in enumerate(self._now):
            section = known if known is not None else self._section(number, places)
            self._now[number] = section
            found.append(section)
            if number + 1 < len(self._now):
                places |= {item: (number, place) for item, place in section.places.items()}
        return tuple(found)

    def _section(self, number: int, others: Mapping[int, tuple[int, int]]) -> Section:
        known, plain = self._classes, self._plain
        seen = set(others)
        found: list[tuple[object, _Class, Any]] = []
        todo = list(self._roots[number])
        later: list[object] = []
        keyed = -1
        while todo or later:
            if not todo:  # what can only be reached by what makes no difference
                keyed = len(found) if keyed < 0 else keyed
                todo, later = later, []
            item = todo.pop()
            own = type(item)
            if id(item) in seen or own in plain:
                continue
            kind = known.get(own) or self._class(own)
            if own in plain:
                continue
            seen.add(id(item))
            content, inside = _content(item, kind)
            if kind.kind is not _Kind.TUPLE and kind.kind is not _Kind.CALL:
                found.append((item, kind, content))
            if kind.unkeyed:
                for name, part in zip(content if kind.has_dict else kind.names, inside, strict=True):
                    (later if name in kind.unkeyed else todo).append(part)
            else:
                todo += [part for part in inside if type(part) not in plain]
        objects = tuple(found)
        keyed = len(found) if keyed < 0 else keyed
        last = self._last[number]
        if last is not None and _is_alike(objects[:keyed], others, last):
            return replace(last, objects=objects)
        keying = _Keying(self, objects[:keyed], others)
        shape = keying.shape()
        return Section(objects, keying.places, shape, tuple(keying.names), keying.meant)

    def take_back(self, picture: Picture) -> None:
        """Let all objects hold what they held then."""
        for number, section in enumerate(picture):
            if self._now[number] is not section:
                for item, kind, content in section.objects:
                    _PUT[kind.kind](item, kind, content)
                self._now[number] = section

    def _class(self, kind: type) -> _Class:
        found = self._classes[kind] = self._find(kind)
        if found.kind in (_Kind.PLAIN, _Kind.VALUE):
            self._plain.add(kind)
        return found

    def _find(self, kind: type) -> _Class:
        layout = self._layout
        if issubclass(kind, (*_PLAIN, *layout.constant)) or kind is _COUNT:
            return _Class(_Kind.PLAIN)
        if issubclass(kind, (_Count, *layout.values)):
            unkeyed = _of_class(layout.unkeyed, kind)
            names = tuple(item.name for item in fields(cast(Any, kind)) if item.name not in unkeyed)
            return _Class(_Kind.VALUE, names)
        if issubclass(kind, Chart):
            return _Class(_Kind.CHART)
        for base, found in _CONTAINERS.items():
            if issubclass(kind, base):
                return _Class(found)
        unkeyed = _of_class(layout.unkeyed, kind)
        own = next((layout.parts[base] for base in kind.__mro__ if base in layout.parts), None)
        if own is not None:
            return _Class(_Kind.OBJECT, own, unkeyed, read=_reading(own))
        slots = [
            name
            for base in kind.__mro__
            for name, what in vars(base).items()
            if isinstance(what, MemberDescriptorType)
        ]
        has_dict = any("__dict__" in vars(base) for base in kind.__mro__)
        names = tuple(dict.fromkeys(slots))
        return _Class(_Kind.OBJECT, names, unkeyed, has_dict, _reading(names))

    # ---- keys --------------------------------------------------------------------------------

    def key(self, picture: Picture) -> bytes:
        """The same for two states that differ in nothing but names that count up."""
        numbers: dict[str, dict[int, int]] = {}
        digest = blake2b(digest_size=16)
        for section in picture:
            digest.update(section.shape)
            for name, number in section.names:
                known = numbers.setdefault(name, {})
                digest.update(b"%s %d " % (name.encode(), known.setdefault(number, len(known))))
        digest.update(self._decided(numbers.get("", ())).encode())
        return digest.digest()

    def numbered(self, text: str) -> tuple[str, int] | None:
        """A name that counts up as what stands before the number, and the number."""
        if text not in self._texts:
            found = _NUMBERED.fullmatch(text)
            is_one = found is not None and found[1] in self._prefixes
            self._texts[text] = (found[1], int(found[2])) if found is not None and is_one else None
        return self._texts[text]

    def ordered(self, kind: type) -> Callable[[Any], object] | None:
        """What of an object of this class depends on the order in a dictionary."""
        return self._layout.ordered.get(kind)

    def class_of(self, kind: type) -> _Class:
        return self._classes.get(kind) or self._class(kind)


def _of_class(table: Mapping[type, frozenset[str]], kind: type) -> frozenset[str]:
    return frozenset(name for base, names in table.items() if issubclass(kind, base) for name in names)


def _is_alike(objects: _Held, others: Mapping[int, tuple[int, int]], last: Section) -> bool:
    """Whether all that makes a difference is as it was: the same objects hold what they held."""
    known = last.objects[: len(last.places)]
    return (
        len(known) == len(objects)
        and all(
            one is other and held == before and (kind.kind is not _Kind.DICT or [*held] == [*before])
            for (one, kind, held), (other, _, before) in zip(objects, known, strict=True)
        )
        and all(others.get(item) == place for item, place in last.meant.items())
    )


def _reading(names: Sequence[str]) -> Callable[[Any], tuple[object, ...]]:
    """What reads these attributes of an object."""
    if len(names) > 1:
        return attrgetter(*names)
    return lambda item: tuple([getattr(item, name) for name in names])


_CONTAINERS = {
    list: _Kind.LIST,
    deque: _Kind.LIST,
    dict: _Kind.DICT,
    set: _Kind.SET,
    tuple: _Kind.TUPLE,
    frozenset: _Kind.TUPLE,
    FunctionType: _Kind.CALL,
    MethodType: _Kind.CALL,
    partial: _Kind.CALL,
}


def _content(item: Any, kind: _Class) -> tuple[Any, Iterable[object]]:
    """What an object holds, and the objects in it."""
    match kind.kind:
        case _Kind.CHART:
            return item.save(), ()
        case _Kind.LIST:
            held = tuple(item)
            return held, held
        case _Kind.DICT:
            pairs = _sorted(item)
            return item.copy(), [part for pair in pairs for part in pair]
        case _Kind.SET:
            return tuple(item), item
        case _Kind.TUPLE:
            return None, item
        case _Kind.CALL:
            return None, _inside(item)
        case _:
            return _attributes(item, kind)


def _sorted(item: dict[Any, Any]) -> Iterable[tuple[Any, Any]]:
    return sorted(item.items(), key=_by_name) if len(item) > 1 else item.items()


def _by_name(pair: tuple[object, object]) -> str:
    name = pair[0]
    return name if type(name) is str else repr(name)


def _attributes(item: Any, kind: _Class) -> tuple[Any, Iterable[object]]:
    try:
        held = kind.read(item)
    except AttributeError:
        held = tuple([getattr(item, name, _MISSING) for name in kind.names])
    if _COUNT in map(type, held):
        held = tuple([_counted(value) for value in held])
    if not kind.has_dict:
        return held, held
    named = dict(zip(kind.names, held, strict=True)) | vars(item)
    return named, named.values()


def _counted(value: Any) -> object:
    """A counter as its next number, any other value as it is."""
    return _Count(int(next(iter(value.__reduce__()[1])))) if type(value) is _COUNT else value


@dataclass(frozen=True, slots=True)
class _Count:
    """A counter, by its next number."""

    next: int


def _inside(call: Any) -> list[object]:
    """What a call that waits refers to."""
    if isinstance(call, partial):
        return [call.func, *call.args, *call.keywords.values()]
    if isinstance(call, MethodType):
        return [call.__self__]
    return [cell.cell_contents for cell in call.__closure__ or ()]


def _put_list(item: Any, kind: _Class, content: Any) -> None:
    item.clear()
    item.extend(content)


def _put_all(item: Any, kind: _Class, content: Any) -> None:
    item.clear()
    item.update(content)


def _put_attributes(item: Any, kind: _Class, content: Any) -> None:
    held = content.items() if kind.has_dict else zip(kind.names, content, strict=True)
    for name, value in held:
        if type(value) is _Count:
            object.__setattr__(item, name, itertools.count(value.next))
        elif value is not _MISSING:
            object.__setattr__(item, name, value)
        elif hasattr(item, name):
            object.__delattr__(item, name)


_PUT: Mapping[_Kind, Callable[[Any, _Class, Any], None]] = {
    _Kind.CHART: lambda item, kind, content: item.load(content),
    _Kind.LIST: _put_list,
    _Kind.DICT: _put_all,
    _Kind.SET: _put_all,
    _Kind.OBJECT: _put_attributes,
}


class _Keying:
    """Makes the shape of one section."""

    def __init__(self, memory: Memory, objects: _Held, others: Mapping[int, tuple[int, int]]) -> None:
        self._memory = memory
        self._objects = objects
        self._others = others
        self.places = {id(item): place for place, (item, _, _) in enumerate(objects)}
        self.names: dict[tuple[str, int], int] = {}
        self.meant: dict[int, tuple[int, int]] = {}

    def shape(self) -> bytes:
        found = tuple([self._object(*item) for item in self._objects])
        # The second version writes equal values equally.
        return blake2b(marshal.dumps(cast(Any, found), 2), digest_size=16).digest()

    def _object(self, item: object, kind: _Class, content: Any) -> object:
        if not content:  # what holds nothing
            return ()
        value = self._value
        match kind.kind:
            case _Kind.LIST:
                return tuple([value(part) for part in content])
            case _Kind.DICT:
                return tuple([(value(name), value(part)) for name, part in _sorted(content)])
            case _Kind.SET:
                return tuple(sorted(map(repr, map(value, content))))
            case _Kind.CHART:
                return self._chart(item, content)
            case _:
                held = content.items() if kind.has_dict else zip(kind.names, content, strict=True)
                found = [value(part) for name, part in held if name not in kind.unkeyed]
                order = self._memory.ordered(type(item))
                return tuple(found) if order is None else (*found, value(order(item)))

    def _chart(self, item: Any, saved: Saved) -> object:
        names = type(item).places
        values = [
            self._value(part) for name, part in zip(names, saved.values, strict=True) if not _is_token(name)
        ]
        boards = [None if board is None else self._board(whole(board)) for board in saved.boards]
        return tuple(values), tuple(boards), self._value(tuple(saved.seldom))

    def _board(self, held: Whole) -> object:
        return tuple([self._value(part) if part else () for part in (held[0].messages(), *held[1:])])

    def _value(self, value: Any) -> object:
        kind = type(value)
        if kind in _SIMPLE:
            return value
        if kind is str:
            return self._text(value)
        if kind is frozenset:
            return tuple(sorted(map(repr, map(self._value, value)))) if value else ()
        if kind is tuple:
            if len(value) == 2 and type(value[1]) is int and self._is_sender(value[0]):
                return value[0], self._renamed(f"{value[0]}-", value[1])  # an identity
            return tuple([self._value(part) for part in value])
        place = self.places.get(id(value))
        if place is not None:
            return "@", place
        other = self._others.get(id(value))
        if other is not None:
            self.meant[id(value)] = other
            return "@", *other
        return self._other(value)

    def _is_sender(self, value: object) -> bool:
        return type(value) is str and value in self._memory.senders

    def _other(self, value: Any) -> object:
        if type(value) is AnyNumber:
            return "", self._renamed("", value.number), value.offset
        if isinstance(value, Stamp):
            return int(value)
        if isinstance(value, Enum):
            return value.name
        content = content_of(value)
        if content is not None:
            return "", self._renamed("", content.number), place_of(value)[1]
        if isinstance(value, tuple):
            return tuple([self._value(part) for part in value])
        if isinstance(value, partial | MethodType | FunctionType):
            call: Any = value.func if isinstance(value, partial) else value
            return (getattr(call, "__qualname__", ""), *map(self._value, _inside(value)))
        kind = self._memory.class_of(type(value))
        if kind.kind is _Kind.VALUE:
            return (type(value).__name__, *(self._value(getattr(value, name)) for name in kind.names))
        if kind.kind is _Kind.PLAIN:
            return type(value).__name__
        if is_dataclass(value):  # a message
            return (type(value).__name__, *(self._value(getattr(value, item.name)) for item in fields(value)))
        return type(value).__name__

    def _text(self, text: str) -> object:
        found = self._memory.numbered(text)
        return text if found is None else (found[0], self._renamed(*found))

    def _renamed(self, name: str, number: int) -> int:
        return self.names.setdefault((name, number), len(self.names))


def _is_token(name: str) -> bool:
    """Whether an attribute of a chart tells one start of an activity from another."""
    return name == "tokens" or (name[0] == "k" and name[1:].isdigit())


__all__ = ["Layout", "Memory", "Picture", "Section"]
