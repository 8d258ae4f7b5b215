"""Evaluate: what an expression of a scenario comes to, with messages as the trace tells them.

An enum's constant is its name, a message a mapping of its members, a duration ns. What is absent is None, and
so is what is computed of it; logic is that of conditions (`absent || true` is true).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field
from functools import reduce
from operator import add
from typing import cast

from aseme_dsl.amola import expression as e
from aseme_dsl.amola.messages import DOUBLE, Function, Kind, Type
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.functions import FunctionError, find_function

Told = Mapping[str, object]
"""A message, as the trace tells it."""


def _nothing(*asked: object) -> None:
    return None


def _none(*asked: object) -> tuple[()]:
    return ()


@dataclass(frozen=True, slots=True)
class Known:
    """What expressions read: for one agent, at one moment."""

    now: int = 0
    inputs: Mapping[str, object] = field(default_factory=dict)
    """What the scenario is run with, by name."""
    newest: Callable[[str, str | None], tuple[Told, int] | None] = _nothing
    """The last message of a channel (of a sender), and when it was measured."""
    variable: Callable[[str], object] = _nothing
    bound: Told | None = None
    """The content of the message that a condition is about."""
    history: Callable[[str, str | None], Sequence[tuple[Told, int]]] = _none
    """The messages of a data channel (of a sender) with the times of measurement, the newest last."""
    state: Callable[[str, str], object] = _nothing
    """The value of `in`, `done` or `count` of a state."""
    outcome: Callable[[str], object] = _nothing
    """How an activity has ended last."""
    has_expired: Callable[[str], object] = _nothing
    """Whether a timer has run out."""
    index: int = 1


class NotEvaluated(Exception):
    """A function of the document cannot be called; the text says why."""


_PLAIN = frozenset((Kind.BOOL, Kind.INT, Kind.DOUBLE, Kind.STRING, Kind.DURATION))
"""What a function of the document is given and gives as it is."""

_BUILT_IN: dict[str, Callable[[Sequence[float]], float]] = {
    "abs": lambda numbers: abs(numbers[0]),
    "min": min,
    "max": max,
}


def not_evaluated(value: e.Value) -> Iterator[e.Value]:
    """The parts of an expression that no scenario evaluates yet."""
    for part in e.walk(value):
        match part:
            case e.Call(function=function):
                kinds = {kind.kind for _, kind in function.parameters} | {function.result.kind}
                is_built_in = function.target.startswith("builtin:")
                if not (function.target[8:] in _BUILT_IN if is_built_in else kinds <= _PLAIN):
                    yield part
            case e.Compare(left=left, right=right):
                ages = [side for side in (left, right) if isinstance(side, e.Age)]
                if ages and not any(isinstance(side, e.Literal) for side in (left, right)):
                    yield part
            case e.Arithmetic():
                yield from (side for side in (part.left, part.right) if isinstance(side, e.Age))
            case (
                e.Literal()
                | e.EnumConstant()
                | e.VariableValue()
                | e.ParameterValue()
                | e.Member()
                | e.Bound()
                | e.ListValue()
                | e.Element()
                | e.Size()
                | e.Contains()
                | e.Find()
                | e.Has()
                | e.Age()
                | e.Not()
                | e.Negate()
                | e.Logic()
                | e.Conditional()
                | e.Named()
                | e.At()
                | e.Mean()
                | e.Expired()
                | e.Outcome()
                | e.StateValue()
                | e.Index()
            ):
                pass
            case _:
                yield part


def ages(value: e.Value) -> Iterator[tuple[e.Member, int]]:
    """The messages whose age is compared, with the age (ns) at which time alone changes something."""
    for part in e.walk(value):
        if isinstance(part, e.Compare):
            for side, other in ((part.left, part.right), (part.right, part.left)):
                if isinstance(side, e.Age) and isinstance(side.message, e.Member):
                    assert isinstance(other, e.Literal) and isinstance(other.value, int)
                    yield side.message, other.value


def asked(value: e.Value, kind: type[e.At] | type[e.Mean]) -> Iterator[str]:
    """The channels whose history a value looks at in this way."""
    for part in e.walk(value):
        if isinstance(part, kind):
            yield str(part.message.channel)


def counted(value: e.Value) -> Iterator[str]:
    """The states whose entries a value counts."""
    for part in e.walk(value):
        if isinstance(part, e.StateValue) and part.question == "count":
            yield part.state


def timers(value: e.Value) -> Iterator[str]:
    """The timers that a value asks for."""
    return (part.timer for part in e.walk(value) if isinstance(part, e.Expired))


def value_of(value: e.Value, known: Known) -> object:
    """What the value comes to; None where something that it needs is absent, or cannot be computed.

    Raises:
        NotEvaluated: a function of the document is not there, or raises.
    """
    try:
        return _value(value, known)
    except (ArithmeticError, TypeError, ValueError):
        return None


def _value(value: e.Value, known: Known) -> object:
    match value:
        case e.Named(expression=inner):
            return _value(inner, known)
        case e.Literal(value=constant):
            return constant
        case e.EnumConstant(constant=constant):
            return constant
        case e.ParameterValue(name=name, path=path, type=kind):
            return _member(known.inputs[name], path, kind) if path else known.inputs[name]
        case e.VariableValue(name=name, path=path, type=kind):
            return _member(known.variable(name), path, kind)
        case e.Bound(path=path, type=kind):
            return _member(known.bound, path, kind)
        case e.Member(channel=channel, host=host, path=path, type=kind):
            found = known.newest(str(channel), host)
            return None if found is None else _member(found[0], path, kind)
        case e.Has(message=message):
            return _value(message, known) is not None
        case e.Age(message=e.Member(channel=channel, host=host)):
            found = known.newest(str(channel), host)
            return None if found is None else known.now - found[1]
        case e.At(message=message, offset=offset, type=kind):
            moment = known.now + cast(int, _value(offset, known))
            past = known.history(str(message.channel), message.host)
            then = next((content for content, measured in reversed(past) if measured <= moment), None)
            return _member(then, message.path, kind)
        case e.Mean(message=message, window=window):
            moment = known.now - cast(int, _value(window, known))
            past = known.history(str(message.channel), message.host)
            members = [_member(content, message.path, DOUBLE) for content, at in past if at >= moment]
            values = cast("list[float]", [item for item in members if item is not None])
            return reduce(add, values) / len(values) if values else None
        case e.Expired(timer=timer):
            return known.has_expired(timer)
        case e.Outcome(activity=activity):
            return known.outcome(activity)
        case e.StateValue(question=question, state=state):
            return known.state(question, state)
        case e.Index():
            return known.index
        case e.Not(operand=operand):
            truth = _value(operand, known)
            return None if truth is None else not truth
        case e.Logic(operator=word, operands=operands):
            return _logic(word == "&&", [_value(item, known) for item in operands])
        case e.Conditional(condition=condition, yes=yes, no=no):
            truth = _value(condition, known)
            return None if truth is None else _value(yes if truth else no, known)
    parts = [_value(item, known) for item in e.operands(value)]
    return None if None in parts else _computed(value, parts)


def _logic(needs_all: bool, truths: Sequence[object]) -> object:
    """`&&` or `||`: one that decides counts more than one that is absent."""
    if (not needs_all) in truths:
        return not needs_all
    return None if None in truths else needs_all


def _member(message: object, path: Sequence[str], kind: Type) -> object:
    found = message
    for name in path:
        found = cast(Told, found).get(name) if found is not None else None
    return float(found) if kind == DOUBLE and isinstance(found, str) else found  # not-a-number


def _computed(value: e.Value, parts: Sequence[object]) -> object:
    """What a value comes to whose parts are there."""
    numbers = cast("Sequence[float]", parts)
    match value:
        case e.Compare(operator=word):
            return e.COMPARE[word](*numbers)
        case e.Arithmetic():
            return e.computed(value, *numbers)
        case e.Negate():
            return -numbers[0]
        case e.Call(function=function) if function.target.startswith("builtin:"):
            return _BUILT_IN[function.target.removeprefix("builtin:")](numbers)
        case e.Call(function=function):
            return _called(function, parts)
        case e.ListValue():
            return list(parts)
        case e.Size():
            return len(cast("Sequence[object]", parts[0]))
        case e.Contains(path=path, list=whole):
            return parts[1] in _searched(whole, parts[0], path)
        case e.Find(path=path, list=whole):
            searched = _searched(whole, parts[0], path)
            return searched.index(parts[1]) if parts[1] in searched else None
        case e.Element(path=path, type=kind):
            elements, place = cast("Sequence[object]", parts[0]), cast(int, parts[1])
            return _member(elements[place], path, kind) if 0 <= place < len(elements) else None
    raise LookupError(f"{e.value_text(value)} is not evaluated")  # see `not_evaluated`


def _searched(whole: e.Value, elements: object, path: Sequence[str]) -> list[object]:
    """What is looked at in a list: its elements, or the members of them at a path."""
    return [_member(item, path, whole.type) for item in cast("Sequence[object]", elements)]


def _called(function: Function, parts: Sequence[object]) -> object:
    try:
        return find_function(function.target)(*parts)
    except FunctionError as problem:
        raise NotEvaluated(str(problem)) from problem
    except Exception as problem:  # it is the user's
        raise NotEvaluated(f"{function.name} raises {type(problem).__name__}: {problem}") from problem


__all__ = [
    "Known",
    "NotEvaluated",
    "Told",
    "ages",
    "asked",
    "counted",
    "not_evaluated",
    "timers",
    "value_of",
]
