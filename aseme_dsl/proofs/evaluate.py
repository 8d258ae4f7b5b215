"""Evaluate: whether a condition holds when some unknowns are known, by the rules that generated code follows.

With everything known it is the truth about one snapshot, floating point included; with a part of it, it says
whether that part decides.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import cast

from aseme_dsl.amola import expression as e
from aseme_dsl.amola.messages import Kind
from aseme_dsl.proofs.unknowns import (
    RAISES,
    THERE,
    Key,
    Vocabulary,
    identity,
    is_of_messages,
    presences,
    written_size,
)

Values = Mapping[Key, object]
"""What is known: booleans for presences, an enum's number, ns for a duration, else the value itself."""


class Fault(Exception):
    """A function or division that raises: the whole condition does not hold."""


_UNKNOWN = object()


def holds(condition: e.Value, values: Values, vocabulary: Vocabulary) -> bool | None:
    """Whether the condition holds; None where `values` do not decide it."""
    try:
        return _is(True, condition, values, vocabulary)
    except Fault:
        return False


def value_of(value: e.Value, values: Values, vocabulary: Vocabulary) -> object:
    """What the value is; None where `values` do not decide it, or where it raises."""
    try:
        if not _is_there(value, values, vocabulary):
            return None
        found = _value(value, values, vocabulary)
    except Fault:
        return None
    return None if found is _UNKNOWN else found


def _is(truth: bool, value: e.Value, values: Values, vocabulary: Vocabulary) -> bool | None:
    """Whether the value is true (false): None if not known. Raises Fault where it is sure to."""
    match value:
        case e.Named(expression=inner):
            return _is(truth, inner, values, vocabulary)
        case e.Not(operand=operand):
            return _is(not truth, operand, values, vocabulary)
        case e.Holds(operand=operand):
            held = _is(True, operand, values, vocabulary)
            return None if held is None else held is truth
        case e.Logic(operator=word, operands=operands):
            every = (word == "&&") is truth
            return _decided(every, truth, operands, values, vocabulary)
    there = _is_there(value, values, vocabulary)
    if not there:
        return there
    found = _value(value, values, vocabulary)
    return None if found is _UNKNOWN else bool(found) is truth


def _decided(
    every: bool, truth: bool, operands: Iterable[e.Value], values: Values, vocabulary: Vocabulary
) -> bool | None:
    """Whether all (or any) of the operands are so, from the left.

    An operand behind an unknown one decides only if the unknown one cannot fail.
    """
    unsure = doubtful = False
    for operand in operands:
        try:
            found = _is(truth, operand, values, vocabulary)
        except Fault:
            if unsure:
                return None
            raise
        if found is None:
            unsure = True
            doubtful = doubtful or _may_fail(operand)
        elif found is not every:
            return None if doubtful else found
    return None if unsure else every


def _may_fail(value: e.Value) -> bool:
    return any(
        isinstance(part, e.Call) or (isinstance(part, e.Arithmetic) and part.operator in ("/", "%"))
        for part in e.walk(value)
    )


def _is_there(value: e.Value, values: Values, vocabulary: Vocabulary) -> bool | None:
    """Whether everything that the value reads is there."""
    match value:
        case e.Named(expression=inner):
            return _is_there(inner, values, vocabulary)
        case e.Member() | e.Bound():
            return _is_known_there(identity(value), presences(value, vocabulary), values)
        case e.Age(message=message):
            return _is_known_there(identity(value), presences(message, vocabulary)[:1], values)
        case e.At() | e.Mean():
            key = identity(value)
            return _is_known_there(key, ((THERE, *key),), values)
        case e.VariableValue() if value.may_be_unset:
            return _is_known_there(identity(value), presences(value, vocabulary), values)
        case (
            e.Literal()
            | e.EnumConstant()
            | e.VariableValue()
            | e.Expired()
            | e.Outcome()
            | e.StateValue()
            | e.RoundValue()
            | e.Index()
            | e.Has()
            | e.Holds()
            | e.Sender()
            | e.LossReason()
        ):
            return True
        case e.Not() | e.Logic():
            yes = _is(True, value, values, vocabulary)
            if yes is not False:
                return yes
            return _is(False, value, values, vocabulary)
        case e.Conditional(condition=condition):
            there = _is_there(condition, values, vocabulary)
            chosen = _chosen(value, values, vocabulary) if there else None
            return _is_there(chosen, values, vocabulary) if chosen is not None else there and None
    if isinstance(value, e.Call) and identity(value) in values:
        return True
    unsure = False
    for operand in e.operands(value):
        try:
            found = _is_there(operand, values, vocabulary)
        except Fault:
            if unsure:
                return None
            raise
        if found is False:
            return None if unsure else False
        unsure = unsure or found is None
    return None if unsure else True


def _chosen(value: e.Conditional, values: Values, vocabulary: Vocabulary) -> e.Value | None:
    """What a condition chooses, if it is decided. Raises Fault where that is sure to."""
    found = _value(value.condition, values, vocabulary)
    return None if found is _UNKNOWN else value.yes if found else value.no


def _is_known_there(key: Key, needs: Iterable[Key], values: Values) -> bool | None:
    if key in values:
        return True
    known = [values.get(need) for need in needs]
    return False if False in known else None if None in known else True


def _value(value: e.Value, values: Values, vocabulary: Vocabulary) -> object:
    """The value of something that is there."""
    match value:
        case e.Named(expression=inner):
            return _value(inner, values, vocabulary)
        case e.Literal(value=constant, type=kind):
            if kind.kind is Kind.ENUM:
                return vocabulary.enums[kind.name].number(str(constant))
            if kind.kind is Kind.OUTCOME:
                return vocabulary.outcomes[kind.name].index(str(constant))
            return constant
        case e.EnumConstant(number=number):
            return number
        case e.Not() | e.Logic() | e.Holds():
            found = _is(True, value, values, vocabulary)
            return _UNKNOWN if found is None else found
        case e.Has(message=message):
            known_there = [values.get(key) for key in presences(message, vocabulary)]
            return False if False in known_there else _UNKNOWN if None in known_there else True
        case e.Call(function=function) if function.target.startswith("builtin:"):
            known = [_value(argument, values, vocabulary) for argument in value.arguments]
            return _UNKNOWN if _UNKNOWN in known else _built_in(function.target[8:], known)
        case e.Call():
            for argument in value.arguments:
                _value(argument, values, vocabulary)
            key = identity(value)
            if values.get((RAISES, *key)):
                raise Fault
            return values.get(key, _UNKNOWN)
        case e.Size() if (count := written_size(value)) is not None:
            return count
        case e.Compare(operator=word) if is_of_messages(value):
            same = values.get(identity(value), _UNKNOWN)
            return same if same is _UNKNOWN else bool(same) is (word == "==")
        case e.Compare(operator=word):
            left = _value(value.left, values, vocabulary)
            right = _value(value.right, values, vocabulary)
            return _UNKNOWN if _UNKNOWN in (left, right) else e.COMPARE[word](_number(left), _number(right))
        case e.Arithmetic():
            return _arithmetic(value, values, vocabulary)
        case e.Conditional():
            chosen = _chosen(value, values, vocabulary)
            return _UNKNOWN if chosen is None else _value(chosen, values, vocabulary)
        case e.Negate(operand=operand):
            negated = _value(operand, values, vocabulary)
            return _UNKNOWN if negated is _UNKNOWN else -_number(negated)
    return values.get(identity(value), _UNKNOWN)


def _number(value: object) -> float:
    """A value that is compared or computed with: the compiler lets only values of one type meet."""
    return cast(float, value)


def _built_in(name: str, arguments: Iterable[object]) -> float:
    numbers = [_number(item) for item in arguments]
    return abs(numbers[0]) if name == "abs" else min(numbers) if name == "min" else max(numbers)


def _arithmetic(value: e.Arithmetic, values: Values, vocabulary: Vocabulary) -> object:
    left = _value(value.left, values, vocabulary)
    right = _value(value.right, values, vocabulary)
    if right is not _UNKNOWN and value.operator in ("/", "%") and right == 0:
        raise Fault
    if left is _UNKNOWN or right is _UNKNOWN:
        return _UNKNOWN
    try:
        return e.computed(value, _number(left), _number(right))
    except (ArithmeticError, ValueError) as problem:
        raise Fault from problem


__all__ = ["Fault", "Values", "holds", "value_of"]
