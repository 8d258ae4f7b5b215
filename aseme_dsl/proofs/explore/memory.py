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
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import fields, is_dataclass
from enum import Enum, auto
from functools import lru_cache, partial
from hashlib import blake2b
from operator import attrgetter, is_, itemgetter
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
from aseme_dsl.runtime.chart.board import Known, SavedBoard, whole
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.inputs import Sample
from aseme_dsl.runtime.chart.saving import NOTHING, Saved

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


def _never(item: object, content: object) -> bool:
    return False


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
    is_same: Callable[[Any, Any], bool] = _never
    """Whether an object holds the very objects of a content; it may do so though this is not found."""
    keyed: Callable[[Any], Collection[object]] | None = None
    """Gives what makes a difference of a content, where that is some of its attributes."""


_Atom = tuple[str, int] | int | Callable[[], object]
"""A part of an object that is not the same in equal states: a name that counts up, or the identity of an
object that is meant. A function gives what depends on the order in a dictionary."""


class _Held:
    """An object with what it holds. What is made of that once stays with it, as long as it holds the same."""

    __slots__ = ("atoms", "content", "inside", "is_fixed", "item", "kind", "later", "shape")

    def __init__(self, item: object, kind: _Class, content: Any) -> None:
        self.item = item
        self.kind = kind
        self.content = content
        self.is_fixed = True
        """Whether it holds the same as long as it holds the same objects."""
        self.inside: list[object] = []
        """The objects in it."""
        self.later: list[object] = []
        """Those that make no difference."""
        self.shape = b""
        """What makes a difference, with a slot for each of its `atoms`."""
        self.atoms: tuple[_Atom, ...] | None = None
        """None if they are not known, or cannot be told from the shape."""


@dataclass(frozen=True, slots=True)
class Section:
    """What the objects of one section hold: those of one agent, or those that the team has in common."""

    objects: tuple[_Held, ...]
    found: Mapping[int, int]
    """Where objects stand, by their identities."""
    places: Mapping[int, int]
    """The same of those that make a difference; these come first."""
    shape: bytes
    """Stands for all that makes a difference, without the numbers of names that count up."""
    names: tuple[tuple[str, int], ...]
    """These names with their numbers, in the order of their occurrence."""
    meant: Mapping[int, tuple[int, int]]
    """The objects of other sections that are meant, with their sections and places there."""


Picture = tuple[Section, ...]
"""What all objects of a team hold, by sections."""

_MISSING = object()
_NAME = "@"
"""Stands before a name that is looked for, among those that count up."""
_NOTHING = marshal.dumps((), 2)
"""The shape of what holds nothing."""
_SHAPES = 20_000
"""So many shapes of messages and boards are kept."""
_PARTS = attrgetter(*(item.name for item in fields(Sample)))
"""Gives what is in a message of a channel."""
_CHANGING = frozenset((_Kind.LIST, _Kind.DICT, _Kind.SET))


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
        self._groups: Sequence[Sequence[str]] = ()
        """The names that are looked for outside of charts."""
        self._same: tuple[type, ...] = ()
        self._mentions: dict[str, tuple[str, ...]] = {}
        """Which of these names are in texts, for those that were seen."""
        self.shapes: dict[int, tuple[object, bytes, tuple[_Atom, ...] | None]] = {}
        """The shapes of messages and of all messages of boards, with their atoms, by their identities."""

    # ---- names -------------------------------------------------------------------------------

    def watch(self, groups: Sequence[Sequence[str]], same: tuple[type, ...]) -> None:
        """Look for these names outside of charts. Where a dictionary has all names of a group, with objects
        of the `same` classes, it says nothing of them."""
        self._groups, self._same = groups, same

    def mentioned(self, picture: Picture) -> frozenset[str]:
        """The names that stand outside of charts."""
        return frozenset(name[1:] for section in picture for name, _ in section.names if name[:1] == _NAME)

    def mentions(self, text: str) -> tuple[str, ...]:
        """The names that stand in a text, alone or within more."""
        if not self._groups:
            return ()
        if text not in self._mentions:
            self._mentions[text] = tuple(name for some in self._groups for name in some if name in text)
        return self._mentions[text]

    def is_of_all(self, name: object, content: Mapping[object, object]) -> bool:
        """Whether a dictionary has the same for a name and for all others of its group."""
        return bool(self._groups) and any(
            name in some
            and all(other in content and isinstance(content[other], self._same) for other in some)
            for some in self._groups
        )

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
        last = self._last[number]
        before, known = ({}, ()) if last is None else (last.found, last.objects)
        places: dict[int, int] = {}
        found: list[_Held] = []
        todo: list[object] = []
        later: list[object] = []
        self._gather(self._roots[number], todo)
        keyed = -1
        while todo or later:
            if not todo:  # what can only be reached by what makes no difference
                keyed = len(found) if keyed < 0 else keyed
                todo, later = later, []
            item = todo.pop()
            own = id(item)
            if own in places or own in others:
                continue
            place = before.get(own)
            if place is None:
                held = self._held(item, None)
            else:
                held = known[place]
                if not (held.is_fixed and held.kind.is_same(item, held.content)):
                    held = self._held(item, held)
            places[own] = len(found)
            found.append(held)
            if held.inside:
                todo += held.inside
            if held.later:
                later += held.later
        objects = tuple(found)
        keyed = len(found) if keyed < 0 else keyed
        if last is not None and _is_alike(objects[:keyed], others, last):
            return Section(objects, places, last.places, last.shape, last.names, last.meant)
        differ = places if keyed == len(found) else dict(itertools.islice(places.items(), keyed))
        keying = _Keying(self, differ, others)
        shape = keying.shape(objects[:keyed])
        return Section(objects, places, differ, shape, tuple(keying.names), keying.meant)

    def _held(self, item: object, last: _Held | None) -> _Held:
        """An object with what it holds, which may be what it held last."""
        kind = self.class_of(type(item))
        content, parts = _content(item, kind)
        if last is not None and last.is_fixed:
            if kind.has_dict:
                is_same = _has_same(content, last.content)
            else:
                is_same = type(content) is tuple and _are_same(content, last.content)
            if is_same:
                return last
        held = _Held(item, kind, content)
        if not content and kind.kind in _CHANGING:
            held.shape, held.atoms = _NOTHING, ()
            return held
        if (
            last is not None
            and kind.keyed is not None
            and _are_same(kind.keyed(content), kind.keyed(last.content))
        ):
            held.shape, held.atoms = last.shape, last.atoms
        if not kind.unkeyed:
            held.is_fixed = self._gather(parts, held.inside)
            return held
        for name, part in zip(content if kind.has_dict else kind.names, parts, strict=True):
            if not self._gather((part,), held.later if name in kind.unkeyed else held.inside):
                held.is_fixed = False
        return held

    def _gather(self, parts: Iterable[object], found: list[object]) -> bool:
        """Add those of the parts that may change, and what is in those that cannot; whether the latter stay
        the same: a function may set what it refers to."""
        plain = self._plain
        is_fixed = True
        for part in parts:
            own = type(part)
            if own in plain:
                continue
            kind = self.class_of(own).kind
            if own in plain:
                continue
            if kind is _Kind.TUPLE:
                parts_of: Any = part
                is_fixed &= self._gather(parts_of, found)
            elif kind is _Kind.CALL:
                is_fixed &= self._gather(_inside(part), found) and own is not FunctionType
            else:
                found.append(part)
        return is_fixed

    def take_back(self, picture: Picture) -> None:
        """Let all objects hold what they held then."""
        for number, section in enumerate(picture):
            now = self._now[number]
            if now is section:
                continue
            same = frozenset() if now is None else frozenset(map(id, now.objects))
            for held in section.objects:
                if id(held) not in same:
                    _PUT[held.kind.kind](held.item, held.kind, held.content)
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
                return _Class(found, is_same=_IS_SAME.get(found, _never))
        unkeyed = _of_class(layout.unkeyed, kind)
        own = next((layout.parts[base] for base in kind.__mro__ if base in layout.parts), None)
        if own is not None:
            read = _reading(own)
            keyed = _without(own, unkeyed)
            return _Class(_Kind.OBJECT, own, unkeyed, read=read, is_same=partial(_holds, read), keyed=keyed)
        slots = [
            name
            for base in kind.__mro__
            for name, what in vars(base).items()
            if isinstance(what, MemberDescriptorType)
        ]
        has_dict = any("__dict__" in vars(base) for base in kind.__mro__)
        names = tuple(dict.fromkeys(slots))
        read = _reading(names)
        is_same = _never if has_dict else partial(_holds, read)
        return _Class(
            _Kind.OBJECT,
            names,
            unkeyed,
            has_dict,
            read,
            is_same,
            None if has_dict else _without(names, unkeyed),
        )

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


def _is_alike(objects: Sequence[_Held], others: Mapping[int, tuple[int, int]], last: Section) -> bool:
    """Whether all that makes a difference is as it was: the same objects hold what they held."""
    known = last.objects[: len(last.places)]
    return (
        len(known) == len(objects)
        and all(
            now is before
            or (
                now.item is before.item
                and now.content == before.content
                and (now.kind.kind is not _Kind.DICT or [*now.content] == [*before.content])
            )
            for now, before in zip(objects, known, strict=True)
        )
        and all(others.get(item) == place for item, place in last.meant.items())
    )


def _holds(read: Callable[[Any], Collection[object]], item: object, content: Collection[object]) -> bool:
    try:
        return all(map(is_, read(item), content))
    except AttributeError:
        return False


def _has_same(item: Mapping[object, object], content: Mapping[object, object]) -> bool:
    return _are_same(item, content) and all(map(is_, item.values(), content.values()))


def _are_same(some: Collection[object], others: Collection[object]) -> bool:
    return len(some) == len(others) and all(map(is_, some, others))


def _reading(names: Sequence[str]) -> Callable[[Any], tuple[object, ...]]:
    """What reads these attributes of an object."""
    if len(names) > 1:
        return attrgetter(*names)
    return lambda item: tuple([getattr(item, name) for name in names])


def _without(names: Sequence[str], unkeyed: Collection[str]) -> Callable[[Any], Collection[object]] | None:
    """What gives a content without what makes no difference; None if all of it does."""
    kept = [place for place, name in enumerate(names) if name not in unkeyed]
    if len(kept) == len(names) or len(kept) < 2:
        return None
    return itemgetter(*kept)


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
    if kind.kind is _Kind.OBJECT:  # the usual case
        return _attributes(item, kind)
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
    return _count(int(next(iter(value.__reduce__()[1])))) if type(value) is _COUNT else value


@dataclass(frozen=True, slots=True)
class _Count:
    """A counter, by its next number."""

    next: int


_count = lru_cache(_Count)


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


class _Depends(Exception):
    """What makes a difference in an object cannot be said without its atoms, or may change."""


_IS_SAME: Mapping[_Kind, Callable[[Any, Any], bool]] = {
    _Kind.LIST: _are_same,
    _Kind.SET: _are_same,
    _Kind.DICT: _has_same,
}


class _Keying:
    """Makes the shape of one section."""

    def __init__(
        self, memory: Memory, places: Mapping[int, int], others: Mapping[int, tuple[int, int]]
    ) -> None:
        self._memory = memory
        self._places = places
        self._others = others
        self._atoms: list[_Atom] | None = None
        """The atoms of an object, for each of which there is a slot; None: they stand there themselves."""
        self.names: dict[tuple[str, int], int] = {}
        self.meant: dict[int, tuple[int, int]] = {}
        self._is_own = False
        """Whether the values of a chart are looked at."""

    def shape(self, objects: Iterable[_Held]) -> bytes:
        # What has no atoms is what it was.
        found = tuple([held.shape if held.atoms == () else self._known(held) for held in objects])
        # The second version writes equal values equally.
        return blake2b(marshal.dumps(cast(Any, found), 2), digest_size=16).digest()

    def _known(self, held: _Held) -> object:
        """What makes a difference in an object; most of it is made once."""
        if held.atoms is None:
            self._find(held)
        if held.atoms is not None:
            found = self._found(held.atoms)
            if found is not None:
                return (held.shape, found) if found else held.shape
        return self._object(held.item, held.kind, held.content)

    def _find(self, held: _Held) -> None:
        if held.kind.kind is _Kind.CHART:
            return
        self._atoms = []
        try:
            shape = self._object(held.item, held.kind, held.content)
            held.shape, held.atoms = marshal.dumps(cast(Any, shape), 2), tuple(self._atoms)
        except _Depends:
            pass
        finally:
            self._atoms = None

    def _found(self, atoms: Iterable[_Atom]) -> tuple[object, ...] | None:
        """What stands in the slots; None if an object is meant that does not belong to the team here."""
        names, places = self.names, self._places
        found: list[object] = []
        for atom in atoms:
            if isinstance(atom, tuple):
                found.append(names.setdefault(atom, len(names)))
                continue
            if not isinstance(atom, int):
                found.append(self._value(atom()))
                continue
            place: object = places.get(atom)
            if place is None:
                place = self._place(atom)
            if place is None:
                return None
            found.append(place)
        return tuple(found)

    def _place(self, meant: int) -> object:
        """Where an object stands; None if it does not belong to the team."""
        place = self._places.get(meant)
        if place is not None:
            return place
        other = self._others.get(meant)
        if other is not None:
            self.meant[meant] = other
        return other

    def _object(self, item: object, kind: _Class, content: Any) -> object:
        if not content:  # what holds nothing
            return ()
        value = self._value
        match kind.kind:
            case _Kind.LIST:
                return tuple([value(part) for part in content])
            case _Kind.DICT:
                return tuple(
                    [
                        (
                            name if self._memory.is_of_all(name, content) else value(name),
                            part if type(part) in _SIMPLE else value(part),
                        )
                        for name, part in _sorted(content)
                    ]
                )
            case _Kind.SET:
                return self._set(content)
            case _Kind.CHART:
                return self._chart(item, content)
            case _:
                held = content.items() if kind.has_dict else zip(kind.names, content, strict=True)
                found = [
                    part if type(part) in _SIMPLE else value(part)
                    for name, part in held
                    if name not in kind.unkeyed
                ]
                order = self._memory.ordered(type(item))
                if order is not None and self._atoms is not None:
                    self._atoms.append(partial(order, item))
                elif order is not None:
                    found.append(value(order(item)))
                return tuple(found)

    def _set(self, content: Iterable[object]) -> object:
        """A set by its members in an order that depends on their atoms."""
        known = 0 if self._atoms is None else len(self._atoms)
        found = tuple(sorted(map(repr, map(self._value, content))))
        if self._atoms is not None and len(self._atoms) > known:
            raise _Depends
        return found

    def _chart(self, item: Any, saved: Saved) -> object:
        value = self._value
        kept = itertools.compress(saved.values, _not_tokens(type(item).places))
        self._is_own = True
        values = [part if type(part) in _SIMPLE else value(part) for part in kept]
        self._is_own = False
        boards = [None if board is None else self._board(board) for board in saved.boards]
        return tuple(values), tuple(boards), None if saved.seldom is NOTHING else value(tuple(saved.seldom))

    def _board(self, saved: SavedBoard) -> object:
        messages, *others = whole(saved)
        return self._messages(messages), *[self._value(part) if part else () for part in others]

    def _messages(self, held: Known) -> object:
        """The messages on a board; most of it is made once."""
        shape, atoms = self._shaped(held, held.messages)
        found = None if atoms is None else self._found(atoms)
        if found is None:
            return self._value(held.messages())
        return (shape, found) if found else shape

    def _shaped(self, whole: object, parts: Callable[[], object]) -> tuple[bytes, tuple[_Atom, ...] | None]:
        """The shape and the atoms of what is never changed; they are made once."""
        known = self._memory.shapes.get(id(whole))
        if known is None:
            outer, self._atoms = self._atoms, []
            try:
                shape = marshal.dumps(cast(Any, self._value(parts())), 2)
                known = whole, shape, tuple(self._atoms)
            except _Depends:
                known = whole, b"", None
            finally:
                self._atoms = outer
            if len(self._memory.shapes) > _SHAPES:
                self._memory.shapes.clear()
            self._memory.shapes[id(whole)] = known
        return known[1], known[2]

    def _sample(self, item: Sample) -> object:
        """A message, which is the same one on most boards, with a slot for each of its atoms."""
        shape, atoms = self._shaped(item, partial(_PARTS, item))
        if self._atoms is None or atoms is None:
            raise _Depends
        self._atoms += atoms
        return shape

    def _value(self, value: Any) -> object:
        kind = type(value)
        if kind in _SIMPLE:
            return value
        if kind is str:
            return self._text(value)
        if kind is frozenset:
            return self._set(value) if value else ()
        if kind is Sample and self._atoms is not None:
            return self._sample(value)
        if kind is tuple:
            if len(value) == 2 and type(value[1]) is int and self._is_sender(value[0]):
                self._mention(value[0])
                return value[0], self._renamed(f"{value[0]}-", value[1])  # an identity
            return tuple([self._value(part) for part in value])
        place = self._place(id(value))
        if place is None:
            return self._other(value)
        if self._atoms is None:
            return "@", place
        self._atoms.append(id(value))
        return "@", ...

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
            if self._atoms is not None and isinstance(call, FunctionType) and call.__closure__:
                raise _Depends  # it may set what it refers to
            return (getattr(call, "__qualname__", ""), *map(self._value, _inside(value)))
        kind = self._memory.class_of(type(value))
        if kind.kind is _Kind.VALUE:
            return (type(value).__name__, *(self._value(getattr(value, name)) for name in kind.names))
        if kind.kind is _Kind.PLAIN:
            return type(value).__name__
        if self._atoms is not None:
            raise _Depends  # elsewhere, it may belong to the team
        if is_dataclass(value):  # a message
            return (type(value).__name__, *(self._value(getattr(value, item.name)) for item in fields(value)))
        return type(value).__name__

    def _text(self, text: str) -> object:
        self._mention(text)
        found = self._memory.numbered(text)
        return text if found is None else (found[0], self._renamed(*found))

    def _mention(self, text: str) -> None:
        """Note the names in a text that are looked for."""
        for name in () if self._is_own else self._memory.mentions(text):
            if self._atoms is not None:
                self._atoms.append((f"{_NAME}{name}", 0))
            else:
                self.names.setdefault((f"{_NAME}{name}", 0), len(self.names))

    def _renamed(self, name: str, number: int) -> object:
        if self._atoms is not None:
            self._atoms.append((name, number))
            return ...
        return self.names.setdefault((name, number), len(self.names))


@lru_cache
def _not_tokens(places: tuple[str, ...]) -> tuple[bool, ...]:
    """Which of the places of a chart are none of tokens."""
    return tuple(not _is_token(name) for name in places)


def _is_token(name: str) -> bool:
    """Whether an attribute of a chart tells one start of an activity from another."""
    return name == "tokens" or (name[0] == "k" and name[1:].isdigit())


__all__ = ["Layout", "Memory", "Picture", "Section"]
