"""Encoding: conditions as formulas of z3.

For each condition two formulas: when it holds, and when it raises instead. Absent messages, the order of
evaluation and divisions by zero are exact; doubles are real numbers, and strings are places in their order.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import combinations
from typing import Any, assert_never, cast

from aseme_dsl.amola import expression as e
from aseme_dsl.amola.messages import DOUBLE, DURATION, INT, Kind, Type
from aseme_dsl.proofs.terms import Formula, Terms
from aseme_dsl.proofs.unknowns import (
    AGE,
    AT,
    HAS,
    MEAN,
    RAISES,
    SET,
    SIZE,
    STATE,
    TAKEN,
    THERE,
    VALUE,
    WHOLE,
    Key,
    Unknown,
    Vocabulary,
    identity,
    is_of_messages,
    is_unknown_function,
    presences,
    signature,
    unknowns_of,
    written_size,
)
from aseme_dsl.records import dataclass

_INT_BITS = 63
_TEXTS = (Kind.STRING, Kind.BYTES, Kind.AGENT)


@dataclass(frozen=True, slots=True)
class Truth:
    """When something is so (`yes`), and when finding out raises (`fault`): never both."""

    yes: Formula
    fault: Formula


class Encoder:
    """The conditions of one snapshot in one context of z3: equal unknowns are one symbol."""

    def __init__(self, z3: Any, context: Any, vocabulary: Vocabulary, conditions: Sequence[e.Value]) -> None:
        self._z3 = z3
        self._context = context
        self.terms = Terms(z3, context)
        self._vocabulary = vocabulary
        self.unknowns: dict[Key, Unknown] = {}
        self.symbols: dict[Key, Any] = {}
        self.facts: list[Formula] = []
        """What holds of the unknowns independently of the conditions."""
        self.functions = z3.Bool("functions", context)
        """Whether what declared functions return may decide; if not, their values count as absent."""
        self.texts = _texts(conditions)
        self.calls: dict[Key, e.Call] = {}
        for condition in conditions:
            for unknown in unknowns_of(condition, vocabulary):
                self._add(unknown)
            for part in e.walk(condition):
                if is_unknown_function(part):
                    assert isinstance(part, e.Call)
                    self.calls.setdefault(identity(part), part)
        self._relate_histories()
        self._relate_hosts()
        self._relate_calls()

    # ---- unknowns ---------------------------------------------------------------------------

    def _add(self, unknown: Unknown) -> None:
        key = unknown.key
        if key in self.unknowns:
            return
        self.unknowns[key] = unknown
        symbol = self.symbols[key] = self._symbol(f"u{len(self.symbols)}", unknown.type)
        kind = unknown.type.kind
        if unknown.bounds is not None:
            least, most = (
                self._z3.RealVal(str(n), self._context) for n in (unknown.bounds.least, unknown.bounds.most)
            )
            self.facts.append(self._z3.And(symbol >= least, symbol <= most))
        if kind is Kind.ENUM:
            enum = self._vocabulary.enums.get(unknown.type.name)
            numbers = sorted({number for _, number in enum.constants}) if enum is not None else []
            if numbers:
                self.facts.append(self._z3.Or([symbol == number for number in numbers]))
        elif kind is Kind.OUTCOME:
            last = len(self._vocabulary.outcomes[unknown.type.name]) - 1
            self.facts.append(self._z3.And(symbol >= 0, symbol <= last))
        elif kind in _TEXTS or key[0] in (AGE, SIZE) or (key[0] == STATE and kind is Kind.INT):
            self.facts.append(symbol >= 0)
        elif kind is Kind.INT and key[0] in (VALUE, TAKEN):
            self.facts.append(self._z3.And(symbol >= -(2**_INT_BITS), symbol < 2**_INT_BITS))

    def _symbol(self, name: str, kind: Type) -> Any:
        if kind.kind is Kind.BOOL:
            return self._z3.Bool(name, self._context)
        if kind.kind in (Kind.DOUBLE, *_TEXTS):
            return self._z3.Real(name, self._context)
        return self._z3.Int(name, self._context)

    def _relate_histories(self) -> None:
        """A history that reaches back has a newest value, and a longer window has what a shorter one has."""
        extents: dict[Key, list[tuple[int, object]]] = {}
        for key in self.symbols:
            if key[0] != THERE:
                continue
            form, host, channel, path, last = key[1:]
            extent = cast(int, last)
            self.facts.append(self.terms.implies(self.symbols[key], self.symbols[HAS, host, channel]))
            extents.setdefault((form, host, channel, path), []).append((extent, self.symbols[key]))
            age = self.symbols.get((AGE, host, channel))
            if age is not None and form == AT:
                old = self.terms.and_(self.symbols[HAS, host, channel], age >= -extent)
                self._relate_old(key, old)
        for (form, *_), items in extents.items():
            for (one, first), (two, second) in combinations(items, 2):
                # at(x, -2s) there: so is at(x, -1s); mean(x, 1s) there: so is mean(x, 2s).
                lesser, greater = (first, second) if one < two else (second, first)
                assert form in (AT, MEAN)
                self.facts.append(self.terms.implies(lesser, greater))

    def _relate_old(self, there: Key, old: Formula) -> None:
        """When the newest value is older than the offset, it is what `at` gives."""
        host, channel, path = there[2:5]
        now = self.symbols.get((VALUE, host, channel, path))
        then = self.symbols.get(there[1:])
        if now is not None and then is not None:
            present = [self.symbols[need] for need in self.unknowns[VALUE, host, channel, path].needs]
            same = self.terms.and_(self.symbols[there], then == now)
            self.facts.append(self.terms.implies(self.terms.and_(old, *present), same))

    def _relate_hosts(self) -> None:
        """A message of one sender is a message of any."""
        for key in list(self.symbols):
            if key[0] == HAS and key[1] is not None and (HAS, None, key[2]) in self.symbols:
                self.facts.append(self.terms.implies(self.symbols[key], self.symbols[HAS, None, key[2]]))

    def _relate_calls(self) -> None:
        """A function gives equal results for equal arguments, or raises for both."""
        for (one, first), (two, second) in combinations(self.calls.items(), 2):
            if signature(first.function) != signature(second.function):
                continue
            equal: list[Formula] = []
            for left, right in zip(first.arguments, second.arguments, strict=True):
                if identity(left) == identity(right):
                    continue
                if Kind.MESSAGE in (left.type.kind, right.type.kind):
                    break  # two different messages: nothing is known of their being equal
                equal.append(self.terms.equal(self._compute(left)[0], self._compute(right)[0]))
            else:
                same = self.terms.and_(
                    self.terms.equal(self.symbols[one], self.symbols[two]),
                    self.symbols[RAISES, *one] == self.symbols[RAISES, *two],
                )
                self.facts.append(self.terms.implies(self.terms.and_(*equal), same))

    # ---- conditions -------------------------------------------------------------------------

    def holds(self, condition: e.Value) -> Formula:
        """When the condition holds."""
        return self._is(True, condition).yes

    def _is(self, truth: bool, value: e.Value) -> Truth:
        match value:
            case e.Named(expression=inner):
                return self._is(truth, inner)
            case e.Not(operand=operand):
                return self._is(not truth, operand)
            case e.Logic(operator=operator, operands=operands):
                parts = [self._is(truth, operand) for operand in operands]
                return self._all(parts) if (operator == "&&") is truth else self._any(parts)
            case e.Has():
                there = self._present(presences(value.message, self._vocabulary))
                return Truth(there if truth else self.terms.not_(there), False)
            case e.Holds(operand=operand):
                held = self._is(True, operand)
                return Truth(held.yes if truth else self.terms.not_(held.yes), held.fault)
            case e.Literal(value=constant):
                return Truth(bool(constant) is truth, False)
        there, missing = self._look(value)
        found, fault = self._compute(value)
        sure = self.terms.and_(there, self.terms.not_(fault))
        return Truth(
            self.terms.and_(sure, found if truth else self.terms.not_(found)),
            self.terms.or_(missing, self.terms.and_(there, fault)),
        )

    def _all(self, parts: Iterable[Truth]) -> Truth:
        yes: Formula = True
        fault: Formula = False
        for part in parts:
            fault = self.terms.or_(fault, self.terms.and_(yes, part.fault))
            yes = self.terms.and_(yes, part.yes)
        return Truth(yes, fault)

    def _any(self, parts: Iterable[Truth]) -> Truth:
        yes: Formula = False
        fault: Formula = False
        for part in parts:
            before = fault
            fault = self.terms.or_(fault, self.terms.and_(self.terms.not_(yes), part.fault))
            yes = self.terms.or_(yes, self.terms.and_(self.terms.not_(before), part.yes))
        return Truth(yes, fault)

    def _look(self, value: e.Value) -> tuple[Formula, Formula]:
        """When everything that the value reads is there, and when looking it up raises."""
        match value:
            case e.Named(expression=inner):
                return self._look(inner)
            case e.Member() | e.Bound() | e.VariableValue():
                return self._present(presences(value, self._vocabulary)), False
            case e.Age(message=message):
                return self._present(presences(message, self._vocabulary)[:1]), False
            case e.At() | e.Mean():
                return self.symbols[THERE, *identity(value)], False
            case e.Element() | e.Find():
                read = self._all(Truth(*self._look(operand)) for operand in e.operands(value))
                return self.terms.and_(read.yes, self.symbols[SET, *identity(value)]), read.fault
            case e.Holds():
                return True, self._is(True, value).fault
            case e.Not() | e.Logic():
                yes, no = self._is(True, value), self._is(False, value)
                there = self.terms.or_(yes.yes, self.terms.and_(self.terms.not_(yes.fault), no.yes))
                return there, self.terms.or_(yes.fault, self.terms.and_(self.terms.not_(yes.yes), no.fault))
            case e.Conditional(condition=condition):
                read = Truth(*self._look(condition))
                test, raised = self._compute(condition)
                (yes, one), (no, two) = self._look(value.yes), self._look(value.no)
                terms = self.terms
                held, failed = terms.and_(read.yes, test), terms.and_(read.yes, terms.not_(test))
                there = terms.and_(
                    terms.not_(raised), terms.or_(terms.and_(held, yes), terms.and_(failed, no))
                )
                missing = terms.or_(terms.and_(held, one), terms.and_(failed, two))
                return there, terms.or_(read.fault, terms.and_(read.yes, raised), missing)
        parts = [Truth(*self._look(operand)) for operand in e.operands(value)]
        if isinstance(value, e.Has):
            return True, False
        found = self._all(parts)
        if is_unknown_function(value):
            return self.terms.and_(found.yes, self.functions), found.fault
        return found.yes, found.fault

    def _present(self, keys: Iterable[Key]) -> Formula:
        return self.terms.and_(*(self.symbols[key] for key in keys))

    def _compute(self, value: e.Value) -> tuple[Any, Formula]:
        """The value of what is there, and when computing it raises."""
        match value:
            case e.Named(expression=inner):
                return self._compute(inner)
            case e.Literal(value=constant, type=kind):
                return self.literal(constant, kind), False
            case e.EnumConstant(number=number):
                return self._z3.IntVal(number, self._context), False
            case e.Not() | e.Logic() | e.Holds():
                return self._is(True, value).yes, False
            case e.Has():
                return self._present(presences(value.message, self._vocabulary)), False
            case e.Call() if is_unknown_function(value):
                faults = [self._compute(argument)[1] for argument in value.arguments if not _whole(argument)]
                key = identity(value)
                return self.symbols[key], self.terms.or_(*faults, self.symbols[RAISES, *key])
            case e.Call(function=function):
                parts = [self._compute(argument) for argument in value.arguments]
                found = self.terms.built_in(function.target[8:], [part for part, _ in parts])
                return found, self.terms.or_(*(fault for _, fault in parts))
            case e.Size() if (count := written_size(value)) is not None:
                return self._z3.IntVal(count, self._context), False
            case e.Size() | e.Contains() | e.Find() | e.Element() | e.ListValue() | e.NewMessage():
                faults = [self._compute(part)[1] for part in e.operands(value)]
                return True if _whole(value) else self.symbols[identity(value)], self.terms.or_(*faults)
            case e.Compare(operator=operator) if is_of_messages(value):
                faults = [self._compute(part)[1] for part in e.operands(value)]
                same = self.symbols[identity(value)]
                return same if operator == "==" else self.terms.not_(same), self.terms.or_(*faults)
            case e.Compare(operator=operator):
                (left, one), (right, two) = self._compute(value.left), self._compute(value.right)
                return self.terms.compared(operator, left, right), self.terms.or_(one, two)
            case e.Arithmetic():
                return self._arithmetic(value)
            case e.Conditional():
                test, raised = self._compute(value.condition)
                (yes, one), (no, two) = self._compute(value.yes), self._compute(value.no)
                if value.type == DOUBLE:
                    yes, no = self.terms.to_real(yes), self.terms.to_real(no)
                terms = self.terms
                fault = terms.or_(raised, terms.and_(test, one), terms.and_(terms.not_(test), two))
                return terms.chosen(test, yes, no), fault
            case e.Negate(operand=operand):
                found, fault = self._compute(operand)
                return -found, fault
        if _whole(value):
            return True, False  # only functions take a whole message: it is the same as itself
        return self.symbols[identity(value)], False

    # ---- values -----------------------------------------------------------------------------

    def literal(self, constant: Any, kind: Type) -> Any:
        """A constant as z3 writes it; that of a double is what is written, not the nearest float."""
        match kind.kind:
            case Kind.BOOL:
                return self._z3.BoolVal(bool(constant), self._context)
            case Kind.DOUBLE:
                return self.terms.real(Fraction(repr(constant)) if isinstance(constant, float) else constant)
            case Kind.STRING | Kind.BYTES | Kind.AGENT:
                return self.terms.real(self.texts.index(constant))
            case Kind.OUTCOME if isinstance(constant, str):
                number = self._vocabulary.outcomes[kind.name].index(constant)
                return self._z3.IntVal(number, self._context)
            case Kind.ENUM if isinstance(constant, str):
                return self._z3.IntVal(self._vocabulary.enums[kind.name].number(constant), self._context)
            case Kind.INT | Kind.DURATION | Kind.OUTCOME | Kind.ENUM | Kind.MESSAGE | Kind.LIST:
                return self._z3.IntVal(int(constant), self._context)
            case _:
                assert_never(kind.kind)

    def _arithmetic(self, value: e.Arithmetic) -> tuple[Any, Formula]:
        (left, one), (right, two) = self._compute(value.left), self._compute(value.right)
        fault = self.terms.or_(one, two)
        operator = value.operator
        if operator in ("/", "%"):
            fault = self.terms.or_(fault, right == 0)
        if operator == "/" and value.type == DURATION and value.right.type == INT:
            return self.terms.floor_division(left, right), fault
        if operator == "/":
            return self.terms.to_real(left) / self.terms.to_real(right), fault
        if operator == "%":
            return self.terms.modulo(left, right), fault
        left, right = self.terms.same_sort(left, right)
        found = left + right if operator == "+" else left - right if operator == "-" else left * right
        if value.type == DURATION and DOUBLE in (value.left.type, value.right.type):
            z3 = self._z3
            found = z3.If(found >= 0, z3.ToInt(found), -z3.ToInt(-found))
        return found, fault


def _whole(value: e.Value) -> bool:
    """Whether it is a whole message or list, which only functions and `size` take."""
    return value.type.kind in WHOLE


def _texts(conditions: Iterable[e.Value]) -> list[str]:
    """The texts that are written in the conditions, in order; the empty one is the least of all."""
    found = {""}
    for condition in conditions:
        for part in e.walk(condition):
            if isinstance(part, e.Literal) and part.type.kind in _TEXTS:
                found.add(str(part.value))
    return sorted(found)


__all__ = ["Encoder"]
