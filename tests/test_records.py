"""Classes of data do what those of the standard library do, and are compiled when they are used."""

from __future__ import annotations

import copy
import dataclasses
import inspect
import operator
import pickle
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass as of_library
from dataclasses import field, fields, replace
from types import FunctionType

import pytest

from aseme_dsl.records import dataclass as ours

Maker = Callable[..., Callable[[type], type]]


def classes(dataclass: Maker) -> Iterator[type]:
    """Classes of every kind that the package has, made by one maker or the other."""

    @dataclass(frozen=True, slots=True)
    class Point:
        """A place."""

        x: int
        y: int = 0

    @dataclass(frozen=True, slots=True)
    class Above(Point):
        z: int = field(default=1, compare=False)

    @dataclass(frozen=True, slots=True)
    class Bag:
        x: int
        words: list[str] = field(default_factory=list, hash=False)
        more: int = field(default=3, kw_only=True, repr=False)

    @dataclass(frozen=True, slots=True)
    class Twice:
        x: int
        double: int = field(init=False, repr=False)
        seen: list[int] = field(init=False, default_factory=list, compare=False)
        last: int = field(init=False, default=7)

        def __post_init__(self) -> None:
            object.__setattr__(self, "double", 2 * self.x)

    @dataclass(frozen=True, slots=True, eq=False)
    class Same:
        x: int

    @dataclass(frozen=True)
    class Open:
        x: int
        y: tuple[int, ...] = ()

    @dataclass(slots=True)
    class Counter:
        x: int
        counts: list[int] = field(default_factory=lambda: [1])

    @dataclass
    class Plain:
        x: int
        y: str = "yes"

    @dataclass(slots=True, unsafe_hash=True)
    class Often:
        x: int
        y: int = 2

    @dataclass(frozen=True, slots=True)
    class Spoken:
        x: int

        def __repr__(self) -> str:
            return "spoken"

        def __eq__(self, other: object) -> bool:
            return True

    @dataclass(frozen=True, slots=True, order=True)
    class Sorted:
        x: int
        y: int = 0

    @dataclass(frozen=True, slots=True, kw_only=True)
    class Named:
        x: int

    @dataclass(frozen=True, slots=True)
    class Nothing:
        pass

    yield from (Point, Above, Bag, Twice, Same, Open, Counter, Plain, Often, Spoken, Sorted, Named, Nothing)


PAIRS = list(zip(classes(of_library), classes(ours), strict=True))

CALLS: list[tuple[tuple[object, ...], dict[str, object]]] = [
    ((), {}),
    ((1,), {}),
    ((2,), {}),
    ((1, 5), {}),
    ((1, 5, 6), {}),
    ((), {"x": 1}),
    ((1,), {"more": 4}),
    ((1,), {"x": 1}),
    ((1,), {"unknown": 1}),
    (([],), {}),
]


def said(doing: Callable[..., object], *places: object, **names: object) -> object:
    """What comes of it, an exception included; a default `repr` has an address in it, which differs."""
    try:
        return str(doing(*places, **names)).partition(" at 0x")[0]
    except Exception as error:
        return type(error), str(error)


def facts(kind: type) -> Iterator[tuple[str, object]]:
    yield "signature", str(inspect.signature(kind))
    yield "fields", [(item.name, item.type, item.default, item.kw_only) for item in fields(kind)]
    yield "is matched", kind.__match_args__
    yield "slots", getattr(kind, "__slots__", None)
    yield "names", (kind.__qualname__, kind.__init__.__qualname__)
    made = []
    for places, names in CALLS:
        yield f"{places} {names}", said(kind, *places, **names)
        with suppress(TypeError):
            made.append(kind(*places, **names))
    for one in made:
        yield "hash", said(hash, one) if kind.__hash__ is not object.__hash__ else "its identity"
        yield "equal", [one == other for other in made] + [one == 1, one != one]
        yield "less", [said(operator.lt, one, other) for other in made]
        yield "copies", [said(operator.eq, one, copy.copy(one)), said(operator.eq, one, copy.deepcopy(one))]
        yield "replaced", said(replace, one, x=9)
        yield "as dictionary", dataclasses.asdict(one)
        for item in fields(kind)[:1]:
            another = copy.copy(one)
            yield "assigned", (said(setattr, another, item.name, 3), getattr(another, item.name))
            yield "deleted", (said(delattr, another, item.name), hasattr(another, item.name))


@pytest.mark.parametrize(("library", "own"), PAIRS, ids=lambda kind: kind.__name__)
def test_it_does_what_a_dataclass_of_the_standard_library_does(library: type, own: type) -> None:
    assert list(facts(own)) == list(facts(library))


@ours(frozen=True, slots=True)
class Kept:
    """One that can be pickled: it has a place in a module."""

    x: int
    words: tuple[str, ...] = ()


def test_no_name_is_assigned() -> None:
    with pytest.raises(dataclasses.FrozenInstanceError, match="cannot assign to field 'other'"):
        setattr(Kept(1), "other", 2)  # noqa: B010


def test_pickled_and_back() -> None:
    assert pickle.loads(pickle.dumps(Kept(1, ("a",)))) == Kept(1, ("a",))


def test_a_method_is_compiled_when_it_is_first_used() -> None:
    @ours(frozen=True, slots=True)
    class Late:
        x: int

    methods = ("__init__", "__eq__", "__hash__")

    def compiled() -> list[str]:
        return [name for name in methods if isinstance(vars(Late)[name], FunctionType)]

    assert compiled() == []
    one = Late(1)
    assert compiled() == ["__init__"]
    assert one == Late(1)
    assert hash(one) == hash((1,))
    assert compiled() == ["__init__", "__eq__", "__hash__"]


def test_one_that_contains_itself_has_a_text() -> None:
    @ours(slots=True)
    class Loop:
        inner: object = None

    loop = Loop()
    loop.inner = loop
    assert repr(loop) == "test_one_that_contains_itself_has_a_text.<locals>.Loop(inner=...)"
