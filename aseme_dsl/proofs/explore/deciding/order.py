"""Order: numbers that may be any, and what comparisons have told of them.

Such a number stands for all numbers at once. Each comparison of it with another one is decided when it is
made, and holds from then on: what is known are bounds of differences, as in a zone. So each way through the
decisions is that of some numbers, and each number goes one of the ways.

A sum or a product of such numbers may be any number at each look. Then there may be ways that no numbers go:
what happens on none of the ways does not happen, but what may happen on one of them perhaps cannot.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import fields, is_dataclass, replace
from fractions import Fraction
from typing import NoReturn, TypeVar, cast

from aseme_dsl.proofs.explore.deciding.choosing import Choices
from aseme_dsl.proofs.timed.zone import Zone, at_most, kept, less_than, narrowed, unbounded
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.as_json import StandIn

_T = TypeVar("_T")

_ONE = 1 << 100
"""What stands for 1 in the bounds of a zone, which are whole numbers."""
_MOST = 1 << 180
"""The greatest number in parts of `_ONE`: sums of some are less than the bound of a zone that is none."""


class Unanswerable(BaseException):
    """A program asks more of a number that may be any than how it compares. Nothing that runs catches it."""


class Some(StandIn):
    """Stands for a number that may be any, where values are listed: one that is made when it is chosen."""

    __slots__ = ("is_whole",)

    def __init__(self, *, is_whole: bool) -> None:
        self.is_whole = is_whole


WHOLE, REAL = Some(is_whole=True), Some(is_whole=False)


@dataclass(slots=True)
class Known:
    """What is known of the numbers that there are."""

    zone: Zone = Zone()
    whole: frozenset[int] = frozenset()
    """Those that are of type int."""
    loose: frozenset[int] = frozenset()
    """Those that were computed from others."""
    made: int = 0
    """How many there have been."""


class AnyNumber(StandIn):
    """A number that may be any, or what is more or less than one by a constant."""

    __slots__ = ("_order", "number", "offset")

    def __init__(self, order: Order, number: int, offset: int = 0) -> None:
        """`number` tells it from others, and is below 0. The `offset` is in parts of `_ONE`."""
        self._order = order
        self.number = number
        self.offset = offset

    @property  # type: ignore[misc]
    def __class__(self) -> type[object]:  # type: ignore[override]
        """It is taken where a number of its type is."""
        return int if self._order.is_whole(self) else float

    def __repr__(self) -> str:
        return f"any number {-self.number}" + (f" + {Fraction(self.offset, _ONE)}" if self.offset else "")

    def __hash__(self) -> int:
        return hash((self.number, self.offset))

    def __eq__(self, other: object) -> bool:
        return _is_number(other) and self._order.same(self, cast("Number", other))

    def __lt__(self, other: Number) -> bool:
        return self._order.less(self, other)

    def __gt__(self, other: Number) -> bool:
        return self._order.less(other, self)

    def __le__(self, other: Number) -> bool:
        return not self._order.less(other, self)

    def __ge__(self, other: Number) -> bool:
        return not self._order.less(self, other)

    def __add__(self, other: Number) -> Number:
        return self._order.moved(self, other, 1)

    __radd__ = __add__

    def __sub__(self, other: Number) -> Number:
        return self._order.moved(self, other, -1)

    def __rsub__(self, other: Number) -> AnyNumber:
        return self._order.computed(self, other)

    def __mul__(self, other: Number) -> AnyNumber:
        return self._order.computed(self, other)

    __rmul__ = __mul__

    def __truediv__(self, other: Number) -> AnyNumber:
        if type(other) is AnyNumber or not other:
            raise Unanswerable("a division by what may be 0")
        return self._order.number(is_whole=False, is_loose=True)

    def __neg__(self) -> AnyNumber:
        return self._order.computed(self)

    def __abs__(self) -> AnyNumber:
        if self >= 0:
            return self
        found = self._order.computed(self)
        self._order.suppose(found, 0, None)
        return found

    def __floordiv__(self, other: Number) -> Number:
        if type(other) is AnyNumber or other <= 0:
            raise Unanswerable("a division by what may be 0, or less")
        if 0 <= self < other:
            return 0
        found = self._order.computed(self)
        self._order.suppose(found, *((1, None) if self >= other else (None, -1)))
        return found

    def _refuse(self, *_: object) -> NoReturn:
        raise Unanswerable(f"{self!r} is asked for its value")

    __bool__ = __int__ = __float__ = __index__ = __round__ = __trunc__ = __floor__ = __ceil__ = _refuse
    __str__ = __format__ = __mod__ = __rmod__ = __rfloordiv__ = __rtruediv__ = _refuse
    __pow__ = __rpow__ = __complex__ = __reduce_ex__ = _refuse


Number = int | float | AnyNumber


class Order:
    """The numbers of a team that may be any. `known` belongs to its state."""

    def __init__(self, choices: Choices) -> None:
        self.known = Known()
        self.is_exact = True
        """Whether nothing was decided of a number that was computed from others: then each way is that of
        some numbers."""
        self.compared: set[int] = set()
        """What such numbers were compared with, in parts of `_ONE`, where both answers were possible."""
        self.asks: Callable[[], bool] = lambda: True
        """Whether comparisons are those of the program. Others compare only whether a number is the same."""
        self._choices = choices
        self.is_of_others = False
        """Whether agents that are not explored may have given the numbers."""
        self._asked = 0

    # ---- numbers -----------------------------------------------------------------------------

    def number(self, *, is_whole: bool, is_loose: bool = False) -> AnyNumber:
        """One of which nothing is known; `is_loose`: it was computed from others, and how is forgotten."""
        known = self.known
        known.made += 1
        found = AnyNumber(self, -known.made)
        known.zone = unbounded(known.zone, found.number)
        if is_whole:
            known.whole |= {found.number}
        if is_loose:
            known.loose |= {found.number}
        return found

    def made(self, value: _T) -> _T:
        """A value in which new numbers are where it has some that may be any."""
        if isinstance(value, Some):
            return cast("_T", self.number(is_whole=value.is_whole))
        if is_dataclass(value) and not isinstance(value, type):
            held = {item.name: getattr(value, item.name) for item in fields(value)}
            made = {name: self.made(part) for name, part in held.items()}
            if any(made[name] is not held[name] for name in made):
                return cast("_T", replace(value, **made))
        return value

    def suppose(self, number: object, least: float | None, most: float | None) -> None:
        """A number that may be any is not less and not more than these."""
        if type(number) is AnyNumber:
            for one, other in ((least, number), (number, most)):
                if one is not None and other is not None:
                    self._narrow(self._not_less(other, one))

    def moved(self, number: AnyNumber, by: Number, sign: int) -> Number:
        """A number and another one, or less that one: exact, if the other one or the difference is known."""
        if type(by) is not AnyNumber:
            return AnyNumber(self, number.number, number.offset + sign * _scaled(by))
        if sign < 0 and by.number == number.number:
            found = Fraction(number.offset - by.offset, _ONE)
            return int(found) if self.is_whole(number) else float(found)
        return self.computed(number, by)

    def computed(self, *numbers: Number) -> AnyNumber:
        """What is computed from numbers: it may be any."""
        return self.number(is_whole=all(map(self.is_whole, numbers)), is_loose=True)

    def is_whole(self, number: Number) -> bool:
        """Whether a number is of type int."""
        if type(number) is not AnyNumber:
            return isinstance(number, int)
        return number.number in self.known.whole and number.offset % _ONE == 0

    # ---- comparisons -------------------------------------------------------------------------

    def less(self, one: Number, other: Number) -> bool:
        """Whether a number is less than another one."""
        ways = [(True, self._less(one, other)), (False, self._not_less(one, other))]
        return self._decided(one, other, ways)

    def same(self, one: Number, other: Number) -> bool:
        """Whether two numbers are equal."""
        if type(one) is type(other) is AnyNumber and one.number == other.number:
            return one.offset == other.offset
        if not self.asks():
            return False
        ways = [
            (True, self._same(one, other)),
            (False, self._less(one, other)),
            (False, self._less(other, one)),
        ]
        return self._decided(one, other, ways)

    def _decided(self, one: Number, other: Number, ways: Sequence[tuple[bool, Zone | None]]) -> bool:
        """One of the answers about two numbers, of which each holds in a part of what may be so."""
        if not self.asks():
            raise Unanswerable("numbers are compared by what is not the program")
        possible = [(answer, zone) for answer, zone in ways if zone is not None]
        self._asked += 1
        if len(possible) > 1:
            self.is_exact = self.is_exact and self._is_exact(one, other)
            row, column, by = self._difference(one, other)
            if 0 in (row, column):
                self.compared.add(by if column == 0 else -by)
        place = self._choices.of(("order", self._asked), range(len(possible)), is_of_others=self.is_of_others)
        answer, zone = possible[place]
        if not self._is_loose(one, other):
            self.known.zone = zone
        return answer

    def _is_loose(self, *numbers: Number) -> bool:
        """Whether one of these was computed from others. What is decided of it is not remembered."""
        return any(type(item) is AnyNumber and item.number in self.known.loose for item in numbers)

    def _is_exact(self, one: Number, other: Number) -> bool:
        """Whether each of the answers about two numbers is right for some. The bounds do not say whether an
        int is between two doubles."""
        known = self.known
        kinds = {item.number in known.whole for item in (one, other) if type(item) is AnyNumber}
        return not self._is_loose(one, other) and len(kinds) == 1

    def _narrow(self, zone: Zone | None) -> None:
        assert zone is not None
        self.known.zone = zone

    def _less(self, one: Number, other: Number) -> Zone | None:
        """What may be so if a number is less than another one; None if nothing."""
        row, column, by = self._difference(one, other)
        if self._are_whole(row, column):
            return narrowed(self.known.zone, row, column, at_most((-(-by // _ONE) - 1) * _ONE))
        return narrowed(self.known.zone, row, column, less_than(by))

    def _not_less(self, one: Number, other: Number, zone: Zone | None = None) -> Zone | None:
        """What may be so if it is not; of a `zone`, if that is more than what is known."""
        row, column, by = self._difference(one, other)
        least = -(-by // _ONE) * _ONE if self._are_whole(row, column) else by
        return narrowed(zone or self.known.zone, column, row, at_most(-least))

    def _same(self, one: Number, other: Number) -> Zone | None:
        """What may be so if two numbers are equal."""
        zone = self._not_less(one, other)
        return None if zone is None else self._not_less(other, one, zone)

    def _difference(self, one: Number, other: Number) -> tuple[int, int, int]:
        """Two rows, and the number with which their difference compares as the one with the other."""
        (row, less), (column, more) = self._place(one), self._place(other)
        return row, column, more - less

    def _place(self, number: Number) -> tuple[int, int]:
        if type(number) is not AnyNumber:
            return 0, _scaled(number)
        row = self.known.zone.place(number.number)
        assert row is not None, "a number was forgotten that is still there"
        return row, number.offset

    def _are_whole(self, *rows: int) -> bool:
        known = self.known
        return all(row == 0 or known.zone.clocks[row - 1] in known.whole for row in rows)

    @property
    def beside(self) -> tuple[float, ...]:
        """Numbers with which such ones were compared, and the next ones beside each."""
        found = {Fraction(item, _ONE) + by for item in self.compared for by in (-1, 0, 1)}
        return tuple(float(item) for item in sorted(found))

    # ---- what belongs to the state -----------------------------------------------------------

    def keep(self, numbers: Collection[int]) -> bool:
        """Forget all numbers but these; whether there was one to forget."""
        known = self.known
        there = known.zone.clocks
        left = [number for number in there if number in numbers]
        if len(left) == len(there):
            return False
        known.zone = kept(known.zone, left)
        known.whole &= set(left)
        known.loose &= set(left)
        return True

    def shown(self, numbers: Sequence[int]) -> str:
        """What is known of these numbers, the same for other numbers of which the same is known."""
        found = kept(self.known.zone, numbers)
        known = self.known
        return repr((found.rows, [(number in known.whole, number in known.loose) for number in numbers]))


def _is_number(value: object) -> bool:
    return type(value) is AnyNumber or (isinstance(value, int | float) and not isinstance(value, bool))


def _scaled(value: Number) -> int:
    """A number of which all is known in parts of `_ONE`."""
    try:
        found = Fraction(cast("float", value)) * _ONE
    except (OverflowError, ValueError):
        raise Unanswerable(f"a number is compared with {value}") from None
    if found.denominator != 1 or abs(found) > _MOST:
        raise Unanswerable(f"a number is compared with {value}, which has too many digits")
    return found.numerator


__all__ = ["REAL", "WHOLE", "AnyNumber", "Known", "Number", "Order", "Some", "Unanswerable"]
