"""Calls: functions chosen by the types of their arguments, and what only looks like a function."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from aseme_dsl.amola import expression as amola
from aseme_dsl.amola.expression import Literal, Member, Value
from aseme_dsl.amola.messages import AGENT, DOUBLE, DURATION, INT, STRING, ChannelKind, Function, Kind, Type
from aseme_dsl.compiler.names.checker import Checker, is_number
from aseme_dsl.compiler.names.paths import is_optional, unnamed
from aseme_dsl.compiler.read.builtins import FORMS, YIELDING
from aseme_dsl.compiler.read.constants import NotConstant, fold
from aseme_dsl.compiler.read.library import providers
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.diagnostics import Related
from aseme_dsl.diagnostics.problems.expressions import arguments as problems
from aseme_dsl.diagnostics.problems.expressions.absences import SIZES, EventAsFunction, NoFunction
from aseme_dsl.diagnostics.problems.expressions.paths import (
    AgeFromArrival,
    NoHistory,
    NotAFunction,
    SignalAge,
)
from aseme_dsl.diagnostics.problems.expressions.values import DoubleForInt, OtherTypeWanted
from aseme_dsl.diagnostics.problems.names import SeveralFunctions
from aseme_dsl.grammar.text import tree


def function_name(checker: Checker, written: tree.Call) -> str | None:
    """The name of what is called: a form of the language or a declared function."""
    name = written.function.segments[0]
    symbols = checker.scope.symbols
    if len(written.function.segments) > 1:
        checker.report(NotAFunction(written.function.text, _of_list(checker, written)), written.function.span)
        return None
    if name.text in FORMS or symbols.overloads(name.text):
        return name.text
    if name.text == "after":
        checker.report(EventAsFunction(name.text), written.span)
    elif name.text in SIZES and written.arguments:
        meant = f"size({written.arguments[0].span.text})"
        checker.report(NotAFunction(name.text, meant), name.span, fix="size")
    elif symbols.message(name.text) is not None:
        checker.report(NotAFunction(name.text, f"{name.text} {{ member = value, .. }}"), written.span)
    elif not symbols.is_excused(name.text):
        pool = (*symbols.function_names, *FORMS)
        checker.diagnostics.append(
            unknown(NoFunction, name, pool, libraries=providers(name.text, "function"))
        )
    return None


def _of_list(checker: Checker, written: tree.Call) -> str | None:
    """How the language writes what other languages write as `xs.append(v)` and `xs.length()`."""
    first, word = written.function.segments[0].text, written.function.segments[-1].text
    known = checker.scope.variables.get(first)
    if known is None or known[1].kind is not Kind.LIST or len(written.function.segments) != 2:
        return None
    if word in (*SIZES, "size"):
        return f"size({first})"
    if word == "clear":
        return f"{first} = []"
    if word == "index":
        word = "find"
    if word not in ("append", "remove", "contains", "find"):
        return None
    return f"{word}({', '.join((first, *(item.span.text for item in written.arguments)))})"


def call(checker: Checker, name: str, written: tree.Call, arguments: Sequence[Value]) -> Value | None:
    """A function or form with typed arguments."""
    if name in YIELDING and checker.scope.symbols.overloads(name):
        return _function(checker, name, written, arguments)
    match name:
        case "has":
            return _has(checker, written, arguments)
        case "sender":
            return _sender(checker, written, arguments)
        case "age":
            return _age(checker, written, arguments)
        case "random":
            if arguments:
                checker.report(
                    problems.WrongNumberForForm(name, FORMS[name], 0, len(arguments)), written.span
                )
                return None
            return amola.Random(written.span)
        case "at":
            return _at(checker, written, arguments)
        case "mean":
            return _mean(checker, written, arguments)
    return _function(checker, name, written, arguments)


# ---- functions ---------------------------------------------------------------------------------


def _function(checker: Checker, name: str, written: tree.Call, arguments: Sequence[Value]) -> Value | None:
    """The overload that fits exactly, else the one that needs the fewest conversions (see `_cost`)."""
    overloads = checker.scope.symbols.overloads(name)
    costs = {}
    for function in overloads:
        cost = _cost(function, arguments)
        if cost is not None:
            costs[function] = cost
    least = min(costs.values(), default=None)
    best = [function for function in overloads if costs.get(function) == least and least is not None]
    if not best:
        _no_overload(checker, name, written, arguments, overloads)
        return None
    if len(best) > 1:
        related = tuple(Related(function.span, _signature(function)) for function in best)
        checker.report(SeveralFunctions(name), written.function.span, related)
        return None
    return amola.Call(best[0], tuple(arguments), best[0].result, written.span)


def _cost(function: Function, arguments: Sequence[Value]) -> int | None:
    """How many ints are taken as doubles and agents as their names; None where it does not take them."""
    if len(function.parameters) != len(arguments):
        return None
    cost = 0
    for (_, kind), argument in zip(function.parameters, arguments, strict=True):
        if (argument.type, kind) in ((INT, DOUBLE), (AGENT, STRING)):
            cost += 1
        elif kind != argument.type:
            return None
    return cost


def _signature(function: Function) -> str:
    parameters = ", ".join(f"{kind} {name}" for name, kind in function.parameters)
    return f"{function.name}({parameters}) : {function.result}"


def _no_overload(
    checker: Checker,
    name: str,
    written: tree.Call,
    arguments: Sequence[Value],
    overloads: Sequence[Function],
) -> None:
    related = tuple(
        Related(function.span, _signature(function)) for function in overloads if function.is_of_document
    )
    signatures = () if related else tuple(map(_signature, overloads))
    fits = [function for function in overloads if len(function.parameters) == len(arguments)]
    if not fits:
        counts = tuple(sorted({len(function.parameters) for function in overloads}))
        problem = problems.WrongNumber(name, signatures, counts, len(arguments))
        checker.report(problem, written.span, related)
        return
    if len(fits) == 1:
        order = _order(fits[0], arguments)
        if order is not None:
            meant = tuple(arguments[index].span.text for index in order)
            checker.report(problems.OtherOrder(name, meant), written.span, related)
            return
        for (parameter, kind), argument in zip(fits[0].parameters, arguments, strict=True):
            if _cost(replace(fits[0], parameters=((parameter, kind),)), [argument]) is None:
                types = (str(kind), str(argument.type))
                wrong = problems.WrongArgument(name, signatures, parameter, *types)
                checker.report(wrong, argument.span, related)
        return
    given = tuple(str(argument.type) for argument in arguments)
    checker.report(problems.NoOverload(name, signatures, given), written.span, related)


def _order(function: Function, arguments: Sequence[Value]) -> list[int] | None:
    """The one order in which the arguments fit, each type being there once; None if there is none."""
    given = [argument.type for argument in arguments]
    kinds = [kind for _, kind in function.parameters]
    if len({*map(str, given)}) < len(given) or {*map(str, given)} != {*map(str, kinds)}:
        return None
    return [given.index(kind) for kind in kinds]


# ---- forms of the language ---------------------------------------------------------------------


def is_given(checker: Checker, name: str, written: tree.Call, count: int) -> bool:
    """Whether a form is given as many arguments as it takes (E504)."""
    given = len(written.arguments)
    if given != count:
        checker.report(problems.WrongNumberForForm(name, FORMS[name], count, given), written.span)
    return given == count


def only_name(
    checker: Checker, name: str, argument: tree.Expression, wanted: problems.Named
) -> tree.Name | None:
    """The name, with nothing before or after it, that a form wants as `wanted` (E504)."""
    if isinstance(argument, tree.Path) and len(argument.segments) == 1:
        return argument.segments[0]
    checker.report(problems.NoName(name, FORMS[name], wanted), argument.span)
    return None


def _message(
    checker: Checker, name: str, written: tree.Call, arguments: Sequence[Value], count: int
) -> Member | None:
    """The first of `count` arguments, which is a whole message on the blackboard."""
    if not is_given(checker, name, written, count):
        return None
    message = unnamed(arguments[0])
    if not isinstance(message, Member):
        other = problems.OtherKind(name, FORMS[name], "message", str(message.type))
        checker.report(other, arguments[0].span)
        return None
    if count == 1 and message.path:
        whole = ".".join(([message.host] if message.host else []) + [str(message.channel)])
        checker.report(problems.PartOfMessage(name, FORMS[name], whole), arguments[0].span)
        return None
    return replace(message, span=arguments[0].span)


def _has(checker: Checker, written: tree.Call, arguments: Sequence[Value]) -> Value | None:
    """Whether something is there that may be absent: a message, an optional member, an agent."""
    asked = unnamed(arguments[0]) if len(arguments) == 1 else None
    if isinstance(asked, amola.VariableValue) and asked.may_be_unset and not asked.path:
        return amola.Has(asked, written.span)
    if isinstance(asked, Member | amola.Bound | amola.VariableValue) and asked.path:
        message = asked.channel.message if isinstance(asked, Member) else asked.message
        if is_optional(checker, message, asked.path):
            return amola.Has(asked, written.span)
    if isinstance(asked, amola.Bound):
        there = problems.AlwaysThere("has", FORMS["has"], ".".join(asked.path))
        checker.report(there, arguments[0].span)
        return None
    found = _message(checker, "has", written, arguments, 1)
    return None if found is None else amola.Has(found, written.span)


def _sender(checker: Checker, written: tree.Call, arguments: Sequence[Value]) -> Value | None:
    """Who has sent the agent message that the transition takes."""
    if not is_given(checker, "sender", written, 1):
        return None
    message = arguments[0]
    if isinstance(message, amola.Bound) and not message.path:
        return amola.Sender(message.name, written.span)
    agent = message.name if isinstance(message, amola.Sender) and message.lost else None
    checker.report(problems.SenderOfOther("sender", FORMS["sender"], agent), written.span)
    return None


def _age(checker: Checker, written: tree.Call, arguments: Sequence[Value]) -> Value | None:
    """How old a message on the blackboard is, or the agent message that the transition takes."""
    taken = unnamed(arguments[0]) if len(arguments) == 1 else None
    if isinstance(taken, amola.Bound):
        if taken.path:
            checker.report(problems.PartOfMessage("age", FORMS["age"], taken.name), arguments[0].span)
            return None
        return amola.Age(replace(taken, span=arguments[0].span), written.span)
    message = _message(checker, "age", written, arguments, 1)
    if message is None or not _is_timed(checker, message):
        return None
    _note_radio(checker, message)
    return amola.Age(message, written.span)


def _is_timed(checker: Checker, message: Member) -> bool:
    if message.channel.comm is not ChannelKind.SIGNAL:
        return True
    checker.report(SignalAge(), message.span)
    return False


def _note_radio(checker: Checker, message: Member) -> None:
    """Note an age that counts from arrival, because nothing says how long the radio takes."""
    topic = checker.scope.symbols.topic(message.channel.topic)
    if topic is not None and topic.radio is not None and topic.delay is None:
        related = Related(topic.span, "it goes by radio, without a time")
        checker.report(AgeFromArrival(topic.name), message.span, (related,))


def _is_data(checker: Checker, name: str, message: Member) -> bool:
    if message.channel.comm is ChannelKind.DATA:
        return True
    problem = NoHistory(name, str(message.channel), str(message.channel.comm))
    checker.report(problem, message.span)
    return False


def constant_duration(
    checker: Checker, place: problems.DurationOf, value: Value, least: int | None, most: int | None
) -> int | None:
    """The ns of a constant duration that is not out of its range."""
    if value.type != DURATION:
        checker.report(problems.NotADuration(place, str(value.type)), value.span)
        return None
    try:
        nanoseconds = fold(value)
    except NotConstant as problem:
        checker.report(problems.DurationNotConstant(place), problem.value.span)
        return None
    except ArithmeticError:
        checker.report(problems.DurationNotComputed(place), value.span)
        return None
    assert isinstance(nanoseconds, int)
    if least is not None and nanoseconds < least:
        checker.report(problems.DurationTooShort(place, least == 0), value.span)
        return None
    if most is not None and nanoseconds > most:
        constant = value.span.text if isinstance(value, Literal) else None
        checker.report(problems.DurationInFuture(place, constant), value.span)
        return None
    return nanoseconds


def _at(checker: Checker, written: tree.Call, arguments: Sequence[Value]) -> Value | None:
    message = _message(checker, "at", written, arguments, 2)
    if message is None or not _is_data(checker, "at", message):
        return None
    offset = constant_duration(checker, "at", arguments[1], None, 0)
    if offset is None:
        return None
    return amola.At(message, Literal(offset, DURATION, arguments[1].span), message.type, written.span)


def _mean(checker: Checker, written: tree.Call, arguments: Sequence[Value]) -> Value | None:
    message = _message(checker, "mean", written, arguments, 2)
    if message is None or not _is_data(checker, "mean", message):
        return None
    if not is_number(message.type):
        kind = "message" if message.type.kind is Kind.MESSAGE else str(message.type)
        checker.report(problems.OtherKind("mean", FORMS["mean"], "number", kind), message.span)
        return None
    window = constant_duration(checker, "mean", arguments[1], 1, None)
    if window is None:
        return None
    return amola.Mean(message, Literal(window, DURATION, arguments[1].span), DOUBLE, written.span)


def timer(checker: Checker, written: tree.Call, name: str, count: int) -> str | None:
    """The timer that `expired` or `start_timer` names: a word of its own, declared by its use."""
    if not is_given(checker, name, written, count):
        return None
    first = written.arguments[0]
    while isinstance(first, tree.Parenthesised):
        first = first.inner
    found = only_name(checker, name, first, "timer")
    return None if found is None else found.text


def fits(kind: Type, expected: Type) -> bool:
    """Whether a value of one type may go where another is wanted; a list as its elements may."""
    if kind.kind is Kind.LIST is expected.kind:
        of, wanted = kind.element, expected.element
        return of is None or (wanted is not None and fits(of, wanted))
    return kind == expected or (kind, expected) in ((INT, DOUBLE), (AGENT, STRING))


def assignable(checker: Checker, value: Value, expected: Type) -> bool:
    """Whether a value may go where `expected` is wanted; an int may where a double is."""
    kind = value.type
    if fits(kind, expected):
        return True
    if expected == INT and kind == DOUBLE:
        checker.report(DoubleForInt(), value.span)
        return False
    fits_in_list = expected.element is not None and fits(kind, expected.element)
    listed = f"[{value.span.text}]" if fits_in_list else None
    problem = OtherTypeWanted(str(expected), str(kind), expected.kind is Kind.ENUM, listed)
    checker.report(problem, value.span)
    return False
