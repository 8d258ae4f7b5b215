"""Solver: whether conditions can hold and fail together, and the simplest values that make them.

The answer is the same on every run: z3 has fixed seeds and a budget that is counted, not timed. Each unknown
in turn gets the first possible value of a list: 0, the values that the conditions mention, their neighbours.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from decimal import Decimal
from fractions import Fraction
from itertools import pairwise
from typing import Any, TypeVar, assert_never

from aseme_dsl.amola import expression as e
from aseme_dsl.amola.messages import Kind
from aseme_dsl.proofs.encoding import Encoder
from aseme_dsl.proofs.evaluate import Values, holds
from aseme_dsl.proofs.terms import Formula
from aseme_dsl.proofs.unknowns import (
    AGE,
    CALL,
    EXPIRED,
    HAS,
    PRESENCES,
    RAISES,
    SET,
    THERE,
    Key,
    Unknown,
    Vocabulary,
    identity,
    is_unknown_function,
    presences,
    unknowns_of,
)
from aseme_dsl.records import dataclass

_T = TypeVar("_T")

BUDGET = 400_000
"""What z3 may spend on one question, in its own units: an ordinary one needs a few thousand."""

_MOST_CANDIDATES = 32
_SECOND = 1_000_000_000
_MILLISECOND = 1_000_000

Way = tuple[e.Value, ...]
"""Conditions that must all hold for something to be open; none for what is always open."""


class Undecided(Exception):
    """The budget was exhausted, or doubles are not the real numbers that z3 takes them for."""


@dataclass(frozen=True, slots=True)
class Claim:
    """That all conditions of `open` hold, and that of each transition in `closed` one does not."""

    open: Way = ()
    closed: tuple[Way, ...] = ()

    @property
    def conditions(self) -> tuple[e.Value, ...]:
        return (*self.open, *(condition for way in self.closed for condition in way))

    def is_true(self, values: Values, vocabulary: Vocabulary) -> bool | None:
        """Whether it is true in a snapshot; None where what is known does not decide it."""
        found = [holds(condition, values, vocabulary) for condition in self.open]
        for way in self.closed:
            parts = [holds(condition, values, vocabulary) for condition in way]
            found.append(True if False in parts else None if None in parts else False)
        return False if False in found else None if None in found else True


@dataclass(frozen=True, slots=True)
class Assumptions:
    """What is taken for granted of the snapshots that are looked at."""

    raising: bool = False
    """Whether functions may raise."""
    functions: bool = True
    """Whether what declared functions return may decide: if not, it counts as absent."""
    present: bool = False
    """Whether every message is there of which no condition asks whether it is (`has`)."""
    late: bool = False
    """Whether all the time has passed that can matter: timers have run out, what is there is old."""
    timers: frozenset[str] = frozenset()
    """The timers that do run out, if late: the others were never started."""


ANY = Assumptions()


@dataclass(frozen=True, slots=True)
class Witness:
    """Values that make a claim true: all of them, and the least part that decides, with its words."""

    values: Values
    decisive: tuple[Unknown, ...]
    facts: tuple[str, ...]

    def __str__(self) -> str:
        return ", ".join(self.facts)


class Snapshot:
    """What a set of conditions sees at one moment, encoded once for all questions about it.

    Raises ImportError without z3.
    """

    def __init__(
        self,
        conditions: Sequence[e.Value],
        vocabulary: Vocabulary,
        context: object,
        facts: Sequence[e.Value] = (),
    ) -> None:
        """`facts` hold always; they read nothing that the conditions do not read."""
        import z3

        self._z3 = z3
        self._vocabulary = vocabulary
        self._encoder = Encoder(z3, context, vocabulary, conditions)
        self._conditions = tuple(conditions)
        self._asked = {
            key
            for item in conditions
            for part in e.walk(item)
            if isinstance(part, e.Has)
            for key in presences(part.message, vocabulary)
        }
        self._holds: dict[int, Formula] = {}
        self._solver = z3.SimpleSolver(ctx=context)
        self._solver.set("random_seed", 0)
        self._solver.set("rlimit", BUDGET)
        for fact in (*self._encoder.facts, *(self._encoder.holds(item) for item in facts)):
            self._solver.add(fact)
        numbers = [
            part.value
            for item in conditions
            for part in e.walk(item)
            if isinstance(part, e.Literal) and isinstance(part.value, int | float)
        ]
        self._numbers = [number for number in numbers if not isinstance(number, bool)]
        durations = [
            abs(int(part.value))
            for item in conditions
            for part in e.walk(item)
            if isinstance(part, e.Literal) and part.type.kind is Kind.DURATION
        ]
        self._late = 2 * max(durations, default=_SECOND // 2)

    # ---- questions --------------------------------------------------------------------------

    def is_possible(self, claim: Claim, assumptions: Assumptions = ANY) -> bool:
        """Whether some snapshot makes the claim true. Raises Undecided."""
        self._solver.push()
        try:
            return self._assert(claim, assumptions) and self._check()
        finally:
            self._solver.pop()

    def witness(self, claim: Claim, assumptions: Assumptions = ANY) -> Witness | None:
        """The simplest values that make the claim true, or None if there are none. Raises Undecided."""
        self._solver.push()
        try:
            if not self._assert(claim, assumptions) or not self._check():
                return None
            values = self._simplest(claim, assumptions)
        finally:
            self._solver.pop()
        if claim.is_true(values, self._vocabulary) is not True:
            raise Undecided
        return self._least(claim, values, assumptions)

    def _holding(self, condition: e.Value) -> Formula:
        if id(condition) not in self._holds:
            self._holds[id(condition)] = self._encoder.holds(condition)
        return self._holds[id(condition)]

    def _assert(self, claim: Claim, assumptions: Assumptions) -> bool:
        """Give the claim to the solver; False where it is false as it stands."""
        encoder = self._encoder
        parts = [self._holding(condition) for condition in claim.open]
        parts += [
            encoder.terms.not_(encoder.terms.and_(*(self._holding(condition) for condition in way)))
            for way in claim.closed
        ]
        if encoder.calls:
            parts.append(
                encoder.functions if assumptions.functions else encoder.terms.not_(encoder.functions)
            )
        for key, symbol in encoder.symbols.items():
            if key[0] == RAISES and not assumptions.raising:
                parts.append(encoder.terms.not_(symbol))
            elif key[0] in (HAS, THERE) and assumptions.present and key not in self._asked:
                parts.append(symbol)
            elif key[0] == AGE and assumptions.late:
                parts.append(symbol >= self._late)
            elif key[0] == EXPIRED and assumptions.late:
                parts.append(symbol if key[1] in assumptions.timers else encoder.terms.not_(symbol))
        for part in parts:
            if part is False:
                return False
            if part is not True:
                self._solver.add(part)
        return True

    def _check(self) -> bool:
        found = self._solver.check()
        if found == self._z3.unknown:
            raise Undecided
        return bool(found == self._z3.sat)

    # ---- the simplest values ------------------------------------------------------------------

    def _simplest(self, claim: Claim, assumptions: Assumptions) -> dict[Key, object]:
        """Fix one unknown after the other to the first candidate that leaves the claim possible."""
        model = self._solver.model()
        values: dict[Key, object] = {}
        for unknown in self._unknowns(claim):
            if any(values.get(need) is False for need in unknown.needs):
                continue
            if unknown.key[0] == CALL and not assumptions.functions:
                continue
            symbol = self._encoder.symbols[unknown.key]
            for candidate in self._candidates(unknown, assumptions):
                wanted = symbol == self._encoder.literal(candidate, unknown.type)
                if self._z3.is_true(model.eval(wanted, model_completion=True)):
                    break
                self._solver.push()
                self._solver.add(wanted)
                if self._check():
                    model = self._solver.model()
                    self._solver.pop()
                    break
                self._solver.pop()
            else:
                candidate = self._read(model.eval(symbol, model_completion=True))
                wanted = symbol == (
                    self._encoder.terms.real(candidate) if isinstance(candidate, Fraction) else candidate
                )
            self._solver.add(wanted)
            values[unknown.key] = candidate
        return self._as_they_run(values)

    def _unknowns(self, claim: Claim) -> list[Unknown]:
        found: dict[Key, Unknown] = {}
        for condition in claim.conditions:
            for unknown in unknowns_of(condition, self._vocabulary):
                found.setdefault(unknown.key, unknown)
        return list(found.values())

    def _candidates(self, unknown: Unknown, assumptions: Assumptions) -> list[Any]:
        match unknown.type.kind:
            case Kind.BOOL:
                return [True, False] if unknown.key[0] in PRESENCES else [False, True]
            case Kind.ENUM:
                enum = self._vocabulary.enums.get(unknown.type.name)
                return [number for _, number in enum.constants] if enum is not None else []
            case Kind.OUTCOME:
                return list(range(len(self._vocabulary.outcomes[unknown.type.name])))
            case Kind.STRING | Kind.BYTES | Kind.AGENT:
                return list(self._encoder.texts)
            case Kind.DURATION:
                lengths = [int(number) for number in self._numbers if isinstance(number, int)]
                found = [0, *(n for length in lengths for n in (length, length + _MILLISECOND))]
                found += [length - _MILLISECOND for length in lengths] + [_SECOND]
                return [self._late] if assumptions.late and unknown.key[0] == AGE else _few(found)
            case Kind.INT:
                whole = [int(number) for number in self._numbers]
                return _few([0, 1, *(n for number in whole for n in (number, number + 1, number - 1))])
            case Kind.DOUBLE | Kind.MESSAGE | Kind.LIST:
                ordered = sorted({Fraction(repr(number)) for number in self._numbers})
                middles = [(one + two) / 2 for one, two in pairwise(ordered)]
                around = [n for number in self._numbers for n in (number, number + 1, number - 1)]
                return [float(number) for number in _few([0, 1, *around, *middles])]
            case _:
                assert_never(unknown.type.kind)

    def _read(self, value: Any) -> Any:
        """What z3 has chosen itself. Raises Undecided for a number that has no digits to write."""
        z3 = self._z3
        if z3.is_int_value(value):
            return int(value.as_long())
        if z3.is_rational_value(value):
            return Fraction(value.numerator_as_long(), value.denominator_as_long())
        raise Undecided

    def _as_they_run(self, values: dict[Key, object]) -> dict[Key, object]:
        """Real numbers as floats; places among the texts as texts."""
        between: dict[int, set[Fraction]] = {}
        for key, value in values.items():
            if isinstance(value, Fraction) and self._is_text(key) and value != self._below(value):
                between.setdefault(self._below(value), set()).add(value)
        found = {}
        for key, value in values.items():
            if not isinstance(value, Fraction):
                found[key] = value
            elif self._is_text(key):
                found[key] = self._text(value, sorted(between.get(self._below(value), ())))
            else:
                try:
                    found[key] = float(value)
                except OverflowError as problem:
                    raise Undecided from problem
        return found

    def _is_text(self, key: Key) -> bool:
        return self._encoder.unknowns[key].type.kind in (Kind.STRING, Kind.BYTES, Kind.AGENT)

    def _below(self, place: Fraction) -> int:
        """Which of the written texts is the last at or before a place."""
        return min(int(place), len(self._encoder.texts) - 1)

    def _text(self, place: Fraction, neighbours: list[Fraction]) -> str:
        """A text at a place; `neighbours` are all that lie between the same two that are written."""
        texts, below = self._encoder.texts, self._below(place)
        if place == below:
            return str(texts[below])
        found = str(texts[below]) + "a" * (neighbours.index(place) + 1)
        if below + 1 < len(texts) and found >= texts[below + 1]:
            raise Undecided
        return found

    # ---- what of it decides --------------------------------------------------------------------

    def _least(self, claim: Claim, values: dict[Key, object], assumptions: Assumptions) -> Witness:
        """Leave out what does not matter: what is written last, and what functions return, goes first."""
        known = dict(values)
        given = {RAISES} if not assumptions.raising else set()
        order = sorted(reversed(list(values)), key=lambda key: key[0] not in (CALL, RAISES))
        for key in order:
            if key[0] in given or self._is_assumed(key, known[key], assumptions):
                continue
            rest = {other: value for other, value in known.items() if other != key}
            if claim.is_true(rest, self._vocabulary):
                known = rest
        unknowns = self._encoder.unknowns
        said = [
            unknowns[key]
            for key, value in values.items()
            if key in known
            and key[0] not in given
            and not self._is_assumed(key, value, assumptions)
            and not (value is True and key[0] in PRESENCES and self._follows(key, known))
        ]
        facts = tuple(self._fact(unknown, values[unknown.key]) for unknown in said)
        return Witness(values, tuple(said), facts)

    def _is_assumed(self, key: Key, value: object, assumptions: Assumptions) -> bool:
        """Whether it goes without saying: that a message is there, in a question about messages that are."""
        return (
            assumptions.present and value is True and key[0] in (HAS, SET, THERE) and key not in self._asked
        )

    def _follows(self, key: Key, known: dict[Key, object]) -> bool:
        """Whether a presence follows from a value that is said."""
        return any(key in self._encoder.unknowns[other].needs for other in known)

    def _fact(self, unknown: Unknown, value: object) -> str:
        word, text = unknown.key[0], unknown.text
        if word in (HAS, THERE):
            return f"{text} is there" if value else f"no {text}"
        if word == SET:
            return f"{text} is set" if value else f"{text} is not set"
        if word == RAISES:
            return f"{text} {'raises' if value else 'does not raise'}"
        if word == EXPIRED:
            return text if value else f"!{text}"
        return f"{text} = {self._shown(unknown, value)}"

    def _shown(self, unknown: Unknown, value: Any) -> str:
        match unknown.type.kind:
            case Kind.BOOL:
                return "true" if value else "false"
            case Kind.ENUM:
                constants = self._vocabulary.enums[unknown.type.name].constants
                return next(f"{unknown.type}.{name}" for name, number in constants if number == value)
            case Kind.OUTCOME:
                return str(self._vocabulary.outcomes[unknown.type.name][value])
            case Kind.DURATION:
                return e.duration_text(value)
            case Kind.STRING | Kind.BYTES:
                escaped = str(value).replace("\\", "\\\\").replace('"', '\\"')
                return f'"{escaped}"'
            case Kind.AGENT:
                return f"agent {len(value) + 1}"
            case Kind.DOUBLE:
                return format(Decimal(repr(value)).normalize(), "f")
            case Kind.INT | Kind.MESSAGE | Kind.LIST:
                return str(value)
            case _:
                assert_never(unknown.type.kind)


def _few(candidates: Iterable[_T]) -> list[_T]:
    return list(dict.fromkeys(candidates))[:_MOST_CANDIDATES]


def calls_in(witness: Witness, conditions: Iterable[e.Value]) -> tuple[e.Call, ...]:
    """The calls of declared functions whose results decide the witness."""
    decisive = {unknown.key for unknown in witness.decisive}
    found: dict[Key, e.Call] = {}
    for condition in conditions:
        for part in e.walk(condition):
            if is_unknown_function(part) and identity(part) in decisive:
                assert isinstance(part, e.Call)
                found.setdefault(identity(part), part)
    return tuple(found.values())


__all__ = ["ANY", "Assumptions", "Claim", "Snapshot", "Undecided", "Way", "Witness", "calls_in"]
