"""`aseme_dsl.records.dataclass` makes what the standard library's `dataclass` makes."""

from __future__ import annotations

import copy
import dataclasses
import pickle
from collections.abc import Callable
from dataclasses import FrozenInstanceError, field, replace
from functools import cached_property
from typing import Any

import pytest

from aseme_dsl import records

DECORATORS = pytest.mark.parametrize("dataclass", [records.dataclass, dataclasses.dataclass])


@records.dataclass(frozen=True, slots=True)
class Kept:
    """A class of a module, so that it can be pickled."""

    name: str
    more: tuple[int, ...] = ()
    aside: list[int] = field(default_factory=list, compare=False, repr=False)


@DECORATORS
@pytest.mark.parametrize("slots", [True, False])
@pytest.mark.parametrize("frozen", [True, False])
def test_objects_are_made_compared_and_shown(dataclass: Any, frozen: bool, slots: bool) -> None:
    @dataclass(frozen=frozen, slots=slots)
    class Base:
        name: str
        number: int = 3

    @dataclass(frozen=frozen, slots=slots)
    class Sub(Base):
        parts: list[int] = field(default_factory=list)
        twice: int = field(init=False, default=0)
        aside: str = field(default="", compare=False, repr=False)
        found: dict[str, int] = field(init=False, repr=False, default_factory=dict)

        def __post_init__(self) -> None:
            object.__setattr__(self, "twice", 2 * self.number)

    one = Sub("a", parts=[1], aside="x")
    assert (one.name, one.number, one.parts, one.twice, one.aside, one.found) == ("a", 3, [1], 6, "x", {})
    assert Sub("a").parts is not Sub("a").parts
    assert one == Sub("a", 3, [1]) and one != Sub("b", 3, [1])
    assert Base("a") != one and Base("a") == Base("a", 3)
    assert repr(one).endswith(".Sub(name='a', number=3, parts=[1], twice=6)")
    assert replace(one, number=5) == Sub("a", 5, [1])
    assert [item.name for item in dataclasses.fields(Sub)] == [
        *("name", "number", "parts", "twice", "aside", "found")
    ]
    assert Sub.__match_args__ == ("name", "number", "parts", "aside")  # type: ignore[attr-defined]
    assert dataclasses.asdict(Base("a")) == {"name": "a", "number": 3}
    assert hasattr(one, "__dict__") is not slots
    if frozen:
        assert hash(Base("a")) == hash(("a", 3))
    else:
        with pytest.raises(TypeError, match="unhashable"):
            hash(Base("a"))


@DECORATORS
def test_wrong_arguments_are_refused_the_first_and_every_time(dataclass: Any) -> None:
    @dataclass(frozen=True, slots=True)
    class Pair:
        left: int
        right: int

    for _ in range(2):
        with pytest.raises(TypeError, match="missing 1 required positional argument: 'right'"):
            Pair(1)  # type: ignore[call-arg]
        with pytest.raises(TypeError, match="unexpected keyword argument 'top'"):
            Pair(1, 2, top=3)  # type: ignore[call-arg]


@DECORATORS
@pytest.mark.parametrize("slots", [True, False])
def test_what_is_frozen_cannot_be_changed(dataclass: Any, slots: bool) -> None:
    @dataclass(frozen=True, slots=slots)
    class Ice:
        cold: int

    class Water(Ice):
        pass

    def change(what: Callable[[], None], message: str) -> None:
        with pytest.raises(FrozenInstanceError, match=message):
            what()

    for kind in (Ice, Water):
        ice = kind(1)
        change(lambda ice=ice: setattr(ice, "cold", 2), "cannot assign to field 'cold'")  # type: ignore[misc]
        change(lambda ice=ice: delattr(ice, "cold"), "cannot delete field 'cold'")  # type: ignore[misc]
    if dataclass is records.dataclass or not slots:  # the standard library of Python 3.11 cannot do it
        change(lambda: setattr(Ice(1), "warm", 2), "cannot assign to field 'warm'")
        water = Water(1)
        water.warm = 2  # type: ignore[attr-defined]
        assert water.warm == 2  # type: ignore[attr-defined]


@DECORATORS
def test_methods_of_the_class_itself_stay(dataclass: Any) -> None:
    @dataclass(frozen=True)
    class Own:
        name: str

        def __eq__(self, other: object) -> bool:
            return isinstance(other, Own)

        def __repr__(self) -> str:
            return "own"

        @cached_property
        def long(self) -> str:
            return self.name * 2

    @dataclass(frozen=True, slots=True)
    class Hashed:
        name: str

        def __hash__(self) -> int:
            return 7

    @dataclass(frozen=True, slots=True, eq=False)
    class Identity:
        name: str

    assert Own("a") == Own("b") and repr(Own("a")) == "own" and Own("a").long == "aa"
    assert hash(Own("a")) == hash(("a",))
    assert hash(Hashed("a")) == 7 and Hashed("a") == Hashed("a")
    same = Identity("a")
    assert same != Identity("a") and same == same and len({same, Identity("a")}) == 2


@DECORATORS
def test_what_holds_itself_can_be_shown(dataclass: Any) -> None:
    @dataclass
    class Ring:
        next: Any = None

    ring = Ring()
    ring.next = ring
    assert repr(ring).endswith("Ring(next=...)")
    nothing = float("nan")
    assert Ring(nothing) == Ring(nothing)  # as tuples are equal


@DECORATORS
def test_ordered_classes_are_ordered(dataclass: Any) -> None:
    @dataclass(frozen=True, slots=True, order=True)
    class Number:
        value: int

    assert sorted([Number(2), Number(1)]) == [Number(1), Number(2)]


def test_copies_and_pickles_are_equal() -> None:
    kept = Kept("a", (1, 2), [3])
    for other in (copy.copy(kept), copy.deepcopy(kept), pickle.loads(pickle.dumps(kept))):
        assert other == kept and other.aside == [3] and type(other) is Kept


def test_a_method_is_written_once() -> None:
    @records.dataclass(frozen=True, slots=True)
    class Point:
        x: int

    early = Point.__init__
    Point(1)
    made = Point.__init__
    assert Point(2).x == 2 and Point.__init__ is made and made is not early
    point = Point.__new__(Point)
    early(point, 5)  # whoever has taken the method before still has one
    assert point.x == 5 and Point.__init__ is made
