"""A model of KSE and the ASEME IDE: EMF XMI of the metamodel `statechart` 1.0, as the tools of 2012 write it.

Expressions are those of KSE. Its engine tries the conditional transitions of a state from the last to the
first, and those without a condition after them: so the model has them in that order.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import assert_never
from xml.sax.saxutils import escape

from aseme_dsl.amola.expression import (
    Action,
    After,
    Arithmetic,
    Assign,
    Call,
    Compare,
    Element,
    EnumConstant,
    Evaluate,
    Event,
    Expired,
    Failed,
    Has,
    Literal,
    Logic,
    Lost,
    Member,
    Named,
    Negate,
    Not,
    Publish,
    Raise,
    Raised,
    ReadMessages,
    Received,
    Send,
    StartTimer,
    StateValue,
    Value,
    VariableValue,
)
from aseme_dsl.amola.messages import BOOL, DOUBLE, INT, STRING, Channel, Kind
from aseme_dsl.amola.original_names import labels_as_original
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition
from aseme_dsl.amola.system import System
from aseme_dsl.diagnostics.problems.exporting import Foreign
from aseme_dsl.interop.export.lowering import Refusal

NAMESPACE = "http://statechart/1.0"
_FIRST = {BOOL: False, INT: 0, DOUBLE: 0.0, STRING: ""}
"""The types that variables of a model may have, and the first value, which it does not say."""
_COMPOSITE = (StateType.OR, StateType.AND)
_MS = 1_000_000
_BREAKING = frozenset('[]/;"\\')
"""Characters at which KSE takes an expression apart, also in a text."""


def stct(chart: Statechart, about: str) -> str:
    """The model of a chart that has no limits; `about` says from what it comes."""
    return "\n".join([*_document(labels_as_original(chart), about), ""])


def limits(system: System, chart: Statechart) -> tuple[Refusal, ...]:
    """What a model of KSE cannot say."""
    used = {state.activity for state in chart.states}
    late = [
        Refusal(Foreign.DEADLINES, item.span)
        for item in system.activities
        if item.name in used and item.within
    ]
    found = dict.fromkeys([*late, *_of_states(chart), *_of_transitions(chart)])
    return tuple(sorted(found, key=lambda item: (item.span.source.path, item.span.start)))


# ---- the document ------------------------------------------------------------------------------


def _attribute(text: str) -> str:
    kept = "".join(c if c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in text)
    return escape(kept, {'"': "&quot;"})


def _document(chart: Statechart, about: str) -> Iterator[str]:
    yield '<?xml version="1.0" encoding="UTF-8"?>'
    yield f"<!-- {_attribute(about).replace('--', '- -').rstrip('-')} -->"
    yield (
        '<statechart:Model xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI"'
        f' xmlns:statechart="{NAMESPACE}" name="{_attribute(chart.name)}">'
    )
    yield from _node(chart, chart.root, "nodes", "  ")
    places = dict(_places(chart))
    for transition in _in_order(chart):
        said = _attribute(expression_of(transition))
        text = f' TE="{said}"' if said else ""
        yield (
            f'  <transitions name="{_attribute(transition.name)}"{text}'
            f' source="{places[transition.source]}" target="{places[transition.target]}"/>'
        )
    for variable in chart.variables:
        yield f'  <variables name="{_attribute(variable.name)}" type="{variable.type}"/>'
    yield "</statechart:Model>"


def _node(chart: Statechart, state: State, feature: str, indent: str) -> Iterator[str]:
    head = f'{indent}<{feature} name="{_attribute(state.name)}" label="{state.label}" type="{state.type}"'
    children = chart.children(state.label)
    if not children:
        yield f"{head}/>"
        return
    yield f"{head}>"
    for child in children:
        yield from _node(chart, child, "Children", indent + "  ")
    yield f"{indent}</{feature}>"


def _places(chart: Statechart) -> Iterator[tuple[str, str]]:
    """What EMF writes for each state: `//@nodes.0/@Children.1`."""
    known = {chart.root.label: "//@nodes.0"}
    yield from known.items()
    for state in chart.states:
        for number, child in enumerate(chart.children(state.label)):
            known[child.label] = f"{known[state.label]}/@Children.{number}"
            yield child.label, known[child.label]


def _in_order(chart: Statechart) -> Iterator[Transition]:
    """The transitions of each state: what asks for something from the last to the first, then the rest."""
    for state in chart.states:
        outgoing = chart.outgoing_edges(state.label)
        asked = [item for item in outgoing if _asks(item)]
        yield from reversed(asked)
        yield from (item for item in outgoing if not _asks(item))


def _asks(transition: Transition) -> bool:
    expression = transition.expression
    return expression.condition is not None or bool(expression.events)


def expression_of(transition: Transition) -> str:
    """The expression of a transition, as KSE has it; "" where it says nothing."""
    expression = transition.expression
    parts = ["".join(event.name for event in expression.events if isinstance(event, Raised))]
    if expression.condition is not None:
        parts.append(f"[{_condition(expression.condition)}]")
    done = ";".join(_actions(expression.actions))
    return "".join(filter(None, (*parts, f"/{done}" if done else "")))


_TIGHT = {"||": 0, "&&": 1}


def _condition(value: Value, least: int = 0) -> str:
    """A condition; `least` is how tight it must bind: 1 inside `&&`, 2 behind `!` and in a comparison."""
    match value:
        case Named(expression=inner):
            return _condition(inner, least)
        case Logic(operator=operator, operands=operands):
            own = _TIGHT[operator]
            text = f" {operator} ".join(_condition(item, own + 1) for item in operands)
            return f"({text})" if own < least else text
        case Not(operand=operand):
            return f"!{_condition(operand, 2)}"
        case Compare(operator=operator, left=left, right=right):
            text = f"{_condition(left, 2)}{operator}{_condition(right, 2)}"
            return f"({text})" if least > 1 else text
        case Has(message=message):
            return f"!({_condition(message)}==NULL)"
        case Expired(timer=timer):
            return f"TimeoutCheck({timer})"
        case Call(function=function, arguments=arguments):
            return f"{function.name}({', '.join(map(_condition, arguments))})"
        case Member(channel=channel, path=path):
            return ".".join([_path(channel), *(f"{name}()" for name in path)])
        case Element(list=Member(channel=channel, path=path), index=Literal(value=index), path=inside):
            names = [*(f"{name}()" for name in path[:-1]), f"{path[-1]}({index})"]
            return ".".join([_path(channel), *names, *(f"{name}()" for name in inside)])
        case EnumConstant(constant=constant):
            return constant
        case Negate(operand=operand):
            return f"-{_condition(operand, 2)}"
        case VariableValue(name=name):
            return name
        case Literal(value=bool() as truth):
            return "true" if truth else "false"
        case Literal(value=str() as text):
            return f'"{text}"'
        case Literal(value=number):
            return f"{number}"
    return ""  # `limits` names it


def _path(channel: Channel) -> str:
    return f"{channel.topic}.{channel.comm.value.capitalize()}.{channel.message}"


def _actions(actions: Iterable[Action]) -> Iterator[str]:
    filled: Assign | None = None
    for action in actions:
        match action:
            case StartTimer(timer=timer, duration=Literal(value=int() as amount)):
                yield f"TimeoutAction.{timer}.{amount // _MS}"
            case ReadMessages():
                yield "process_messages"
            case Assign():
                filled = action
            case Publish(channel=channel):
                setter = "" if filled is None else f".{_setter(filled)}"
                filled = None
                yield f"publish.{_path(channel)}{setter}"
            case StartTimer() | Send() | Raise() | Evaluate():
                pass  # `limits` names it
            case _:
                assert_never(action)


def _setter(action: Assign) -> str:
    assert isinstance(action.target, Member)
    return f"set_{action.target.path[0]}({_condition(action.value)})"


# ---- what a model cannot say -------------------------------------------------------------------


def _of_states(chart: Statechart) -> Iterator[Refusal]:
    for state in chart.states:
        if state.waits:
            yield Refusal(Foreign.WAITING, state.span)
        if state.activity is not None and state.activity != state.name:
            yield Refusal(Foreign.OTHER_ACTIVITY, state.span)
        if state.type is StateType.BASIC:
            for item in state.arguments:
                yield Refusal(Foreign.ARGUMENTS, item.value.span)
    for variable in chart.variables:
        if variable.type not in _FIRST:
            yield Refusal(Foreign.VARIABLES, variable.span)
        elif variable.initial.value != _FIRST[variable.type] or variable.scope is not None:
            yield Refusal(Foreign.FIRST_VALUES, variable.span)
        if variable.is_limited:
            yield Refusal(Foreign.BOUNDS, variable.span)


def _of_transitions(chart: Statechart) -> Iterator[Refusal]:
    for item in chart.transitions:
        span, expression = item.span, item.expression
        source = chart.node(item.source)
        if not item.changes_state:
            yield Refusal(Foreign.ACTIONS_INSIDE, span)
            continue
        if item.into:
            yield Refusal(Foreign.SEVERAL_TARGETS, span)
        if item.first:
            yield Refusal(Foreign.INTERRUPTS, span)
        if item.resume:
            yield Refusal(Foreign.RESUMING, span)
        if item.reactive:
            yield Refusal(Foreign.REACTIVE, span)
        if expression.weight is not None or expression.draw is not None:
            yield Refusal(Foreign.BRANCHING, span)
        if expression.every is not None:
            yield Refusal(Foreign.PACES, span)
        if len(expression.events) > 1:
            yield Refusal(Foreign.SEVERAL_EVENTS, span)
        for event in expression.events:
            yield from _of_event(event)
        if expression.condition is not None and not expression.events:
            waits = source.type in _COMPOSITE
            if expression.when and not waits:
                yield Refusal(Foreign.WHEN, span)
            if not expression.when and waits:
                yield Refusal(Foreign.COMPLETE_AND, span)
        if expression.when and expression.events:
            yield Refusal(Foreign.WHEN, span)
        if expression.condition is not None:
            yield from _of_value(expression.condition)
        yield from _of_actions(expression.actions)


def _of_event(event: Event) -> Iterator[Refusal]:
    match event:
        case Raised():
            return
        case After():
            yield Refusal(Foreign.TIMED, event.span)
        case Received() | Lost():
            yield Refusal(Foreign.AGENT_MESSAGES, event.span)
        case Failed():
            yield Refusal(Foreign.ERRORS, event.span)
        case _:
            assert_never(event)


def _of_value(value: Value) -> Iterator[Refusal]:
    parts: tuple[Value, ...] = ()
    match value:
        case Named(expression=inner):
            parts = (inner,)
        case Logic(operands=operands):
            parts = operands
        case Not(operand=operand):
            parts = (operand,)
        case Compare(left=left, right=right):
            parts = (left, right)
        case Call(function=function, arguments=arguments):
            parts = arguments
            if function.target.startswith("builtin:"):
                yield Refusal(Foreign.ARITHMETIC, value.span)
        case Has(message=Member(path=()) as message):
            parts = (message,)
        case Member(host=host, path=path, type=kind):
            if host is not None:
                yield Refusal(Foreign.HOSTS, value.span)
            if path and kind.kind not in (*(item.kind for item in _FIRST), Kind.ENUM):
                yield Refusal(Foreign.LISTS, value.span)
        case Element(list=Member(host=None, path=(_, *_)), index=Literal()):
            pass
        case Negate(operand=Literal(type=kind)) if kind in (INT, DOUBLE):
            pass
        case VariableValue(path=()) | EnumConstant() | Expired():
            pass
        case Literal(type=kind) if kind in _FIRST:
            if isinstance(value.value, str) and _BREAKING & set(value.value):
                yield Refusal(Foreign.TEXTS, value.span)
            if isinstance(value.value, float) and "e" in f"{value.value}":
                yield Refusal(Foreign.ARITHMETIC, value.span)
        case Arithmetic() | Negate():
            yield Refusal(Foreign.ARITHMETIC, value.span)
        case StateValue():
            yield Refusal(Foreign.STATES, value.span)
        case _:
            yield Refusal(Foreign.VALUES, value.span)
    for part in parts:
        yield from _of_value(part)


def _of_actions(actions: Iterable[Action]) -> Iterator[Refusal]:
    filled: Assign | None = None
    for action in actions:
        match action:
            case StartTimer(duration=Literal(value=int() as amount)) if amount % _MS == 0:
                pass
            case StartTimer():
                yield Refusal(Foreign.TIMES, action.span)
            case ReadMessages():
                pass
            case Assign(target=Member(host=None, path=(_,))) if filled is None:
                yield from _of_value(action.value)
                filled = action
                continue
            case Assign(target=Member()):
                yield Refusal(Foreign.SETTERS, action.span)
            case Publish(channel=channel):
                if filled is not None and _target(filled) != channel:
                    yield Refusal(Foreign.SETTERS, filled.span)
                filled = None
            case Send():
                yield Refusal(Foreign.AGENT_MESSAGES, action.span)
            case Raise():
                yield Refusal(Foreign.RAISING, action.span)
            case Assign() | Evaluate():
                yield Refusal(Foreign.ASSIGNING, action.span)
            case _:
                assert_never(action)
        if filled is not None:
            yield Refusal(Foreign.SETTERS, filled.span)
            filled = None
    if filled is not None:
        yield Refusal(Foreign.SETTERS, filled.span)


def _target(action: Assign) -> Channel:
    assert isinstance(action.target, Member)
    return action.target.channel


__all__ = ["expression_of", "limits", "stct"]
