"""Typecheck: a written expression to a typed one; what does not fit is reported once, at its cause."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from aseme_dsl.amola import expression as amola
from aseme_dsl.amola.expression import Literal, Named, Value, operands, walk
from aseme_dsl.amola.messages import BOOL, DOUBLE, DURATION, INT, STRING, Kind, Type
from aseme_dsl.compiler.names.bounds import stays_inside
from aseme_dsl.compiler.names.checker import Checker
from aseme_dsl.compiler.names.paths import channel_of, member_of, through_optional, value_of_path
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.read.builtins import ACTIONS, FORMS, PERFORMATIVES, ROUND_QUESTIONS, STATE_QUESTIONS
from aseme_dsl.compiler.read.constants import LARGEST_INT, NotConstant, fold
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.compiler.types import exchange, lists
from aseme_dsl.compiler.types.calls import (
    assignable,
    call,
    constant_duration,
    function_name,
    timer,
)
from aseme_dsl.compiler.types.content import fill, new_message
from aseme_dsl.compiler.types.operators import (
    COMPARISONS,
    arithmetic,
    common_type,
    compare,
    is_condition,
    negate,
)
from aseme_dsl.compiler.types.outcome_values import NAMED_RESULTS, alone, compare_outcome, is_about_outcome
from aseme_dsl.compiler.types.state_values import round_value, state_value
from aseme_dsl.diagnostics import Diagnostic, Related, closest, surely
from aseme_dsl.diagnostics.problems.control import EventBesideWhen, IgnoredNoSignal
from aseme_dsl.diagnostics.problems.expressions import paths as problems
from aseme_dsl.diagnostics.problems.expressions import values
from aseme_dsl.diagnostics.problems.expressions.absences import NoAction
from aseme_dsl.diagnostics.problems.expressions.arguments import (
    DurationNotComputed,
    OtherKind,
    PartOfMessage,
    TimerAsValue,
)
from aseme_dsl.diagnostics.problems.talk import EventWithoutMessage
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span

LISTS = ("size", *lists.SEARCHES)
"""The forms that are about lists."""

DEEPEST = 100
"""How deep an expression may be nested, with its lets written out: everything after walks it by recursion."""

MOST_PARTS = 10_000
"""How many parts an expression may have, with its lets written out."""

LONGEST_SHOWN = 40
"""How many characters of a condition a hint repeats."""


def type_expression(
    written: tree.TransitionExpression, scope: Scope
) -> tuple[amola.TransitionExpression, tuple[Diagnostic, ...]]:
    """Type events, condition and actions. What is wrong is left out of the result and has a diagnostic.

    The duration of `after` and the second argument of `at` and `mean` are constants: `At.offset` and
    `Mean.window` are always `Literal`. A part that an error has removed may leave an expression that means
    something else, so nothing is to be generated from it.
    """
    checker = Checker(scope)
    events = [_event(checker, event) for event in written.events]
    taken = exchange.taken_by(checker, written)
    if taken is not None:
        checker.scope = replace(scope, taken=taken)
    condition = None
    if written.condition is not None:
        value = _condition(checker, written.condition)
        if written.ignores is not None:
            _name_signals(checker)
        if is_condition(checker, value, None) and _is_decided(checker, value):
            condition = value
    elif written.when:
        checker.report(values.WhenWithoutCondition(), written.span)
    if written.when and written.condition is not None and written.events and not checker.diagnostics:
        _report_beside_when(checker, written.events, written.condition)
    wanted = exchange.only_from(checker, written)
    if wanted is not None:
        both = (wanted,) if condition is None else (wanted, condition)
        condition = wanted if condition is None else amola.Logic("&&", both, condition.span)
    made = [tuple(_actions(checker, action)) for action in written.actions]
    typed = amola.TransitionExpression(
        tuple(event for event in events if event is not None),
        written.when,
        written.otherwise,
        condition,
        tuple(item for items in made for item in items),
        written.span,
        None if written.every is None else written.every.nanoseconds,
        None if written.weight is None else written.weight.value,
    )
    wholly = (
        None not in events
        and (condition is not None or written.condition is None)
        and all(len(items) == _parts(action) for action, items in zip(written.actions, made, strict=True))
    )
    if wholly:
        exchange.check_use(checker, taken, typed)
    return typed, tuple(checker.diagnostics)


def _condition(checker: Checker, written: tree.Expression) -> Value | None:
    """A condition as a value. That it is random is the cause also where a logic operator stands around."""
    before = len(checker.diagnostics)
    value = _whole(checker, written)
    for place, item in enumerate(checker.diagnostics[before:], before):
        if isinstance(item.problem, values.RandomInLogic):
            checker.diagnostics[place] = replace(item, problem=values.RandomInCondition())
    return value


def _report_beside_when(checker: Checker, events: tuple[tree.Event, ...], condition: tree.Expression) -> None:
    """`after(2s) or when [c]`: after two seconds the transition would still wait for `c` (W441)."""
    text = " ".join(condition.span.text.split())
    problem = EventBesideWhen(
        tuple(event.span.text for event in events), text if len(text) <= LONGEST_SHOWN else None
    )
    checker.report(problem, events[0].span.to(events[-1].span))


def _name_signals(checker: Checker) -> None:
    """Behind `ignores` stand signals, not what `has` takes (E435)."""
    for place, item in enumerate(checker.diagnostics):
        if isinstance(item.problem, PartOfMessage | OtherKind) and item.span is not None:
            whole = item.problem.whole if isinstance(item.problem, PartOfMessage) else None
            problem = IgnoredNoSignal(item.span.text, whole)
            checker.diagnostics[place] = replace(item, problem=problem, fix=whole)


def _is_decided(checker: Checker, value: Value | None) -> bool:
    """Whether a condition is random (E526): it would be another one each time it is looked at."""
    drawn = None if value is None else next((v for v in walk(value) if isinstance(v, amola.Random)), None)
    if drawn is not None:
        checker.report(values.RandomInCondition(), drawn.span)
    return drawn is None


def type_value(
    written: tree.Expression, scope: Scope, expected: Type | None = None
) -> tuple[Value | None, tuple[Diagnostic, ...]]:
    """Type a value; with `expected`, it must be assignable to that type. None when it is wrong."""
    checker = Checker(scope)
    value = _whole(checker, written)
    if expected is None:
        value = None if lists.is_empty(checker, value) else value
    elif value is not None and not assignable(checker, value, expected):
        value = None
    return value, tuple(checker.diagnostics)


def constant(
    written: tree.Expression, expected: Type, scope: Scope
) -> tuple[Literal | None, tuple[Diagnostic, ...]]:
    """The constant that an expression of literals, enum constants and lets comes to (E514 otherwise).

    The value of an enum's Literal is the constant's name.
    """
    checker = Checker(scope)
    value = _whole(checker, written)
    if value is None or not assignable(checker, value, expected):
        return None, tuple(checker.diagnostics)
    try:
        result = fold(value)
    except NotConstant as problem:
        checker.report(problems.InitialNotConstant(), problem.value.span)
        return None, tuple(checker.diagnostics)
    except ArithmeticError as problem:
        has_larger = isinstance(problem, OverflowError) and expected == INT
        checker.report(values.NotComputed(str(problem), has_larger), value.span)
        return None, tuple(checker.diagnostics)
    if expected == DOUBLE:
        assert not isinstance(result, str)
        result = float(result)
    return Literal(result, expected, written.span), tuple(checker.diagnostics)


# ---- size --------------------------------------------------------------------------------------


def measure(value: Value, scope: Scope) -> tuple[int, int]:
    """How deep a typed value is nested and how many parts it has, with its lets written out."""
    height, size = 0, 0
    stack = [(value, 1)]
    while stack:
        item, depth = stack.pop()
        size += 1
        if isinstance(item, Named):
            let = scope.lets[item.name]
            size += let.size
            depth += let.height
        else:
            stack.extend((part, depth + 1) for part in operands(item))
        height = max(height, depth)
    return height, size


def paths_in(written: tree.Expression) -> Iterator[tree.Path]:
    """Every dotted name of an expression that is a value (not the functions', nor the timers')."""
    stack = [written]
    while stack:
        item = stack.pop()
        match item:
            case tree.Path():
                yield item
            case tree.Binary() if is_about_outcome(item):
                pass  # it names an activity or an agent, and a result
            case tree.Call(arguments=arguments):
                if item.function.text in ("expired", "start_timer"):
                    arguments = arguments[1:]
                stack.extend(reversed(arguments))
            case tree.Unary(operand=operand):
                stack.append(operand)
            case tree.Binary(left=left, right=right):
                stack += [right, left]
            case tree.Logic(operands=parts):
                stack.extend(reversed(parts))
            case tree.Parenthesised(inner=inner):
                stack.append(inner)
            case tree.List(elements=parts):
                stack.extend(reversed(parts))
            case tree.Element(list=whole, index=index):
                stack += [index, whole]
            case tree.NewMessage(fills=fills, rest=rest):
                stack += [] if rest is None or rest.message is None else [rest.message]
                stack.extend(item.value for item in reversed(fills))


def _whole(checker: Checker, written: tree.Expression) -> Value | None:
    """A complete expression: typed, and not too deep or too large for what comes after."""
    value = _value(checker, written, 1)
    if value is None:
        return None
    height, size = measure(value, checker.scope)
    if height > DEEPEST:
        checker.report(problems.NestedTooDeep(height, DEEPEST), written.span)
        return None
    if size > MOST_PARTS:
        checker.report(problems.TooManyParts(size, MOST_PARTS), written.span)
        return None
    return value


# ---- values ------------------------------------------------------------------------------------


def _value(checker: Checker, written: tree.Expression, depth: int) -> Value | None:
    """Recursive: `depth` bounds the recursion even if the parser accepts deeper expressions."""
    while isinstance(written, tree.Parenthesised):
        written = written.inner
    if depth > DEEPEST:
        checker.report(problems.NestedTooDeep(None, DEEPEST), written.span)
        return None
    match written:
        case tree.Number(value=number, span=span):
            kind = INT if isinstance(number, int) else DOUBLE
            return _checked(checker, Literal(number, kind, span))
        case tree.Duration(nanoseconds=nanoseconds, span=span):
            return _checked(checker, Literal(nanoseconds, DURATION, span))
        case tree.Truth(value=truth, span=span):
            return Literal(truth, BOOL, span)
        case tree.Text(text=text, span=span):
            return Literal(text, STRING, span)
        case tree.Path():
            return value_of_path(checker, written)
        case tree.Call():
            return _call(checker, written, depth)
        case tree.List():
            elements = [_value(checker, part, depth + 1) for part in written.elements]
            sound = [item for item in elements if item is not None]
            return lists.literal(checker, written, sound) if len(sound) == len(elements) else None
        case tree.Element():
            whole = _value(checker, written.list, depth + 1)
            index = _value(checker, written.index, depth + 1)
            if whole is None or index is None:
                return None
            return lists.element(checker, written, whole, index)
        case tree.NewMessage():
            return new_message(checker, written, lambda inner, part: _value(inner, part, depth + 1))
        case tree.Hole():
            return None  # E109 says so; no chart is made of it
        case tree.Unary():
            return _unary(checker, written, depth)
        case tree.Binary() if is_about_outcome(written, checker.scope.symbols):
            return compare_outcome(checker, written)
        case tree.Binary():
            left = _value(checker, written.left, depth + 1)
            right = _value(checker, written.right, depth + 1)
            if left is None or right is None:
                return None
            typed = compare if written.operator in COMPARISONS else arithmetic
            return typed(checker, written, left, right)
        case tree.Conditional():
            return _conditional(checker, written, depth)
        case tree.Logic(operator=operator):
            parts = [_value(checker, part, depth + 1) for part in written.operands]
            fits = [is_condition(checker, part, operator) and _is_drawn_once(checker, part) for part in parts]
            if not all(fits):
                return None
            return amola.Logic(operator, tuple(part for part in parts if part is not None), written.span)


def _conditional(checker: Checker, written: tree.Conditional, depth: int) -> Value | None:
    condition = _value(checker, written.condition, depth + 1)
    yes, no = (_value(checker, part, depth + 1) for part in (written.yes, written.no))
    fits = (
        is_condition(checker, condition, "?") and condition is not None and _is_drawn_once(checker, condition)
    )
    if condition is None or yes is None or no is None or not fits:
        return None
    kind = common_type(yes.type, no.type)
    if kind is None:
        problem = values.DifferentBranches(str(yes.type), str(no.type))
        checker.report(problem, written.no.span, (Related(written.yes.span, str(yes.type)),))
        return None
    return amola.Conditional(condition, yes, no, kind, written.span)


def _is_drawn_once(checker: Checker, value: Value | None) -> bool:
    """Whether a part of a logic expression, which may be asked twice, is not random (E526)."""
    drawn = None if value is None else next((v for v in walk(value) if isinstance(v, amola.Random)), None)
    if drawn is not None:
        checker.report(values.RandomInLogic(), drawn.span)
    return drawn is None


def _checked(checker: Checker, literal: Literal) -> Value | None:
    """A number that fits where it is kept: 64 bits."""
    if isinstance(literal.value, int) and literal.value > LARGEST_INT:
        checker.report(values.TooLarge(literal.span.text, literal.type == DURATION), literal.span)
        return None
    return literal


def _unary(checker: Checker, written: tree.Unary, depth: int) -> Value | None:
    operand = _value(checker, written.operand, depth + 1)
    if operand is None:
        return None
    if written.operator != "!":
        return negate(checker, written, operand)
    fits = is_condition(checker, operand, "!") and _is_drawn_once(checker, operand)
    return amola.Not(operand, written.span) if fits else None


def _is_change(checker: Checker, name: str) -> bool:
    """Whether it is `append` or `remove` of the language, and no function of the file."""
    return name in lists.CHANGES and not checker.scope.symbols.overloads(name)


def _is_search(checker: Checker, name: str | None) -> bool:
    """Whether it is `contains` or `find` of the language, and no function of the file."""
    return name in lists.SEARCHES and not checker.scope.symbols.overloads(name)


def _apart(checker: Checker, written: tree.Call, depth: int) -> tuple[tree.Call, tuple[tree.Name, ...]]:
    """`find(orders.id, v)` with the list alone, `find(orders, v)`, and the members of its elements, `id`."""
    match written.arguments:
        case (tree.Path(segments=names), *others):
            first: list[tree.Expression] = [
                tree.Path(names[:count], names[0].span.to(names[count - 1].span))
                for count in range(1, len(names))
            ]
            members = [names[count:] for count in range(1, len(names))]
        case (tree.Element(members=names) as item, *others):
            first = [replace(item, members=names[:count]) for count in range(len(names))]
            members = [names[count:] for count in range(len(names))]
        case _:
            return written, ()
    for whole, rest in zip(first, members, strict=True):
        found = _value(Checker(checker.scope), whole, depth + 1)
        if found is not None and found.type.kind is Kind.LIST:
            return replace(written, arguments=(whole, *others)), rest
    return written, ()


def _call(checker: Checker, written: tree.Call, depth: int) -> Value | None:
    name = function_name(checker, written)
    if name == "expired":
        found = timer(checker, written, name, 1)
        return None if found is None else amola.Expired(found, written.span)
    if name is not None and (name == "start_timer" or _is_change(checker, name)):
        checker.report(TimerAsValue(name, FORMS[name]), written.span)
        return None
    if name in NAMED_RESULTS and not checker.scope.symbols.overloads(name):
        alone(checker, written)
        return None
    if name in STATE_QUESTIONS and not checker.scope.symbols.overloads(name):
        return state_value(checker, name, written)
    if name in ROUND_QUESTIONS and not checker.scope.symbols.overloads(name):
        return round_value(checker, name, written)
    if name is None and len(written.function.segments) == 1:
        near = closest(written.function.text, (*checker.scope.symbols.function_names, *FORMS))
        if near in ("expired", "start_timer") or "timer" in written.function.text.lower():
            return None  # its first argument is the name of a timer, and what is wrong has been said
    written, members = _apart(checker, written, depth) if _is_search(checker, name) else (written, ())
    arguments = [_value(checker, argument, depth + 1) for argument in written.arguments]
    typed = [argument for argument in arguments if argument is not None]
    if name is None or len(typed) < len(arguments):
        return None
    if name in LISTS and not checker.scope.symbols.overloads(name):
        if _is_search(checker, name):
            return lists.searched(checker, written, typed, members)
        return lists.size(checker, written, typed)
    return call(checker, name, written, typed)


# ---- events ------------------------------------------------------------------------------------


def _event(checker: Checker, written: tree.Event) -> amola.Event | None:
    match written:
        case tree.After(duration=duration, span=span):
            value = _whole(checker, duration)
            if value is None:
                return None
            nanoseconds = constant_duration(checker, "after", value, 0, None)
            return None if nanoseconds is None else amola.After(nanoseconds, span)
        case tree.Received():
            return exchange.received(checker, written)
        case tree.Lost():
            return exchange.lost(checker, written)
        case tree.Raised(name=name, span=span):
            if name.text == "error":
                return amola.Failed(span)
            if name.text in PERFORMATIVES:
                checker.report(EventWithoutMessage(name.text), span)
                return None
            if name.text in checker.scope.lets or name.text in checker.scope.variables:
                checker.report(problems.ValueAsEvent(name.text), span, fix=f"[{name}]")
                return None
            near = surely(name.text, (*checker.scope.lets, *checker.scope.variables))
            if near is not None:
                checker.report(problems.EventLikeValue(name.text, near), span)
            return amola.Raised(name.text, span)


def _may_be_raised(checker: Checker, name: tree.Name) -> bool:
    """Whether a name can be that of an event (E517): no value, no performative, and not `error`."""
    if name.text == "error" or name.text in PERFORMATIVES:
        checker.report(problems.NotRaised(name.text), name.span)
        return False
    if name.text in checker.scope.lets or name.text in checker.scope.variables:
        checker.report(problems.NotRaised(name.text, is_value=True), name.span)
        return False
    return True


# ---- actions -----------------------------------------------------------------------------------


def _actions(checker: Checker, written: tree.Action) -> Iterator[amola.Action]:
    """What an action stands for: a message that is filled where it is published, for several."""
    if isinstance(written, tree.Publish) and written.fills is not None:
        yield from _filled(checker, written, written.fills)
        return
    made = _action(checker, written)
    if made is not None:
        yield made


def _parts(written: tree.Action) -> int:
    """For how many actions a written one stands, if none of them is left out."""
    if not isinstance(written, tree.Publish):
        return 1
    return 1 + len(written.fills or ()) + (written.rest is not None)


def _filled(checker: Checker, written: tree.Publish, fills: tuple[tree.Fill, ...]) -> Iterator[amola.Action]:
    """`write_messages.t.state.M { f = v, ..m }`: fill the draft, then publish it."""
    publish = _publish(checker, written.path, written.span)
    if not isinstance(publish, amola.Publish):
        return
    if written.rest is not None and written.rest.message is not None:
        whole = Type(Kind.MESSAGE, publish.channel.message)
        source = _whole(checker, written.rest.message)
        if source is not None and assignable(checker, source, whole):
            draft = amola.Member(None, publish.channel, (), whole, written.rest.span)
            yield amola.Assign(draft, source, written.rest.span)
    for item in fill(checker, publish.channel.message, fills, _whole) or ():
        target = amola.Member(None, publish.channel, item.path, item.type, item.span)
        yield amola.Assign(target, item.value, item.span)
    yield publish


def _action(checker: Checker, written: tree.Action) -> amola.Action | None:
    match written:
        case tree.Assign():
            return _assign(checker, written)
        case tree.Publish(path=path, span=span):
            return _publish(checker, path, span)
        case tree.ReadMessages(span=span):
            return amola.ReadMessages(span)
        case tree.Send():
            return exchange.send(checker, written, _whole)
        case tree.Raise(name=name, span=span):
            return amola.Raise(name.text, span) if _may_be_raised(checker, name) else None
        case tree.Evaluate(expression=tree.Call(function=function) as inner, span=span) if (
            function.text == "start_timer"
        ):
            return _start_timer(checker, inner, span)
        case tree.Evaluate(expression=tree.Call(function=function) as inner) if _is_change(
            checker, function.text
        ):
            return lists.change(checker, inner, _whole)
        case tree.Evaluate(expression=inner, span=span):
            if _is_misspelt_action(checker, inner):
                return None
            value = _whole(checker, inner)
            if value is None:
                return None
            compares = isinstance(value, amola.Compare) and value.operator == "=="
            checker.report(problems.ValueDropped(compares), span)
            return amola.Evaluate(value, span)


def _is_misspelt_action(checker: Checker, written: tree.Expression) -> bool:
    """Whether what stands as an action is meant as `read_messages` or `write_messages…` (E200, E102)."""
    scope = checker.scope
    path = written.function if isinstance(written, tree.Call) else written
    if not isinstance(path, tree.Path):
        return False
    first = path.segments[0]
    symbols = scope.symbols
    known = (*scope.variables, *scope.lets, *symbols.function_names, *symbols.agents)
    if first.text in known or symbols.topic(first.text) or symbols.enum(first.text):
        return False
    if first.text in ACTIONS:
        if not isinstance(written, tree.Call):
            return False
        fix = first.text if first.text == "read_messages" else None
        checker.report(problems.ActionCalled(first.text), written.span, fix=fix)
        return True
    near = closest(first.text, ACTIONS)
    if near is None or closest(first.text, (*known, near)) != near:
        return False
    checker.diagnostics.append(unknown(NoAction, first, ACTIONS))
    return True


def _start_timer(checker: Checker, written: tree.Call, span: Span) -> amola.Action | None:
    found = timer(checker, written, "start_timer", 2)
    if found is None:
        return None
    duration = _whole(checker, written.arguments[1])
    if duration is None:
        return None
    if duration.type != DURATION:
        constant_duration(checker, "start_timer", duration, None, None)
        return None
    try:
        fold(duration)
    except NotConstant:
        return amola.StartTimer(found, duration, span)
    except ArithmeticError:
        checker.report(DurationNotComputed("start_timer"), duration.span)
        return None
    if constant_duration(checker, "start_timer", duration, 0, None) is None:
        return None
    return amola.StartTimer(found, duration, span)


def _publish(checker: Checker, path: tree.Path, span: Span) -> amola.Action | None:
    found = channel_of(checker, path)
    if found is None:
        return None
    host, channel, used = found
    if host is not None:
        checker.report(problems.PublishedForHost(host, str(channel)), path.segments[0].span)
        return None
    if len(path.segments) > used:
        checker.report(problems.MemberPublished(str(channel)), path.segments[used].span)
        return None
    return amola.Publish(channel, span)


def _assign(checker: Checker, written: tree.Assign) -> amola.Action | None:
    if written.index is not None:
        return lists.put(checker, written, _whole)
    target = _target(checker, written.target)
    value = _whole(checker, written.value)
    if target is None or value is None:
        return None
    operator = "" if written.operator is None else written.operator.text
    if written.operator is not None:
        if isinstance(target, amola.Member):
            checker.report(problems.MemberChanged(f"{operator}="), written.operator.span)
            return None
        sides = tree.Binary(operator, written.target, written.value, written.operator.span, written.span)
        value = arithmetic(checker, sides, target, value)
    if value is None or not assignable(checker, value, target.type):
        return None
    if isinstance(target, amola.VariableValue) and not stays_inside(checker, target, value):
        return None
    if isinstance(value, amola.VariableValue) and target == replace(value, span=target.span):
        checker.report(problems.AssignedItself(target.name), written.span)
    return amola.Assign(target, value, written.span, operator)


def _target(checker: Checker, path: tree.Path) -> amola.VariableValue | amola.Member | None:
    """What is assigned to: a variable, or a single member of a message (E507)."""
    first = path.segments[0]
    scope = checker.scope
    if first.text in scope.parameters:
        checker.report(problems.ParameterAssigned(first.text), path.span)
        return None
    if first.text in scope.variables:
        target = value_of_path(checker, path)
        assert target is None or isinstance(target, amola.VariableValue)
        if target is not None and target.path:
            checker.report(problems.MemberOfVariable(first.text, target.message), path.span)
            return None
        return target
    if first.text in scope.lets:
        related = (Related(scope.lets[first.text].span, "declared here"),)
        checker.report(problems.LetAssigned(first.text), path.span, related)
        return None
    if scope.symbols.enum(first.text) is not None:
        checker.report(problems.ConstantAssigned(path.text), path.span)
        return None
    if len(path.segments) == 1:
        value_of_path(checker, path)
        return None
    member = member_of(checker, path)
    if member is None:
        return None
    if member.type.kind is Kind.MESSAGE and member.path:
        checker.report(problems.MessageAssigned(), path.span)
        return None
    optional = through_optional(checker, member.channel.message, member.path)
    if optional is not None:
        checker.report(problems.OptionalAssigned(optional, is_sent=False), path.span)
        return None
    return member
