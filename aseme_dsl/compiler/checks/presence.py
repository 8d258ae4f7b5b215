"""Presence: messages that a transition needs and that may not have come yet."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TypeVar

from aseme_dsl.amola.expression import (
    Assign,
    Bound,
    Compare,
    Conditional,
    Evaluate,
    Has,
    Holds,
    Logic,
    Member,
    Named,
    Not,
    Publish,
    Send,
    StartTimer,
    Value,
    operands,
)
from aseme_dsl.amola.messages import Channel, ChannelKind
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition, TransitionKind
from aseme_dsl.compiler.checks.message_use import members_in
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.use import ActionNeedsMessage, ElseWithoutMessage, SentWithoutMember
from aseme_dsl.source import Span

Channels = frozenset[Channel]
NONE: Channels = frozenset()

Paths = frozenset[tuple[str, tuple[str, ...]]]
"""Members of agent messages: the type of the message, and the path of the member."""
NO_PATHS: Paths = frozenset()

Found = TypeVar("Found")


def check_presence(
    chart: Statechart, activities: Mapping[str, Activity], symbols: Symbols
) -> Iterator[Diagnostic]:
    """N720: an action that reads a message that may be absent, or an `else` that absence makes true.

    A condition over an absent message does not hold, and the agent waits, as intended. There are two cases in
    which absence matters. An action that needs the message is not performed. And if a choice has a negated
    condition (`!seen`) and an `else`, the `else` is taken before the first message.
    """
    needing = [
        (item, found)
        for item in chart.transitions
        if item.expression.actions and (found := list(_needed(item)))
    ]
    if needing:
        known = _known(chart, activities, {member.channel for _, found in needing for member, _, _ in found})
        for transition, found in needing:
            yield from _in_actions(chart, transition, found, known, activities)
    yield from _beside_else(chart, activities)
    yield from _in_content(chart, symbols)


# ---- what is sent --------------------------------------------------------------------------------


def _in_content(chart: Statechart, symbols: Symbols) -> Iterator[Diagnostic]:
    """Optional members of the message that a transition takes, in what it sends without asking for them."""
    for transition in chart.transitions:
        sent = [action for action in transition.expression.actions if isinstance(action, Send)]
        if not sent:
            continue
        condition = transition.expression.condition
        there = NO_PATHS if condition is None else _sure(True, condition, _optional, _asked_optional)
        for action in sent:
            for value in action.values:
                for item in sorted(_optional(value) - there):
                    if _is_optional(symbols, *item):
                        text = ".".join(item[1])
                        yield Diagnostic(SentWithoutMember(item[0], text), value.span)


def _optional(value: Value) -> Paths:
    """The members of the taken message that a value needs."""
    return frozenset(
        (item.message, item.path[:length])
        for item in _needs(value)
        if isinstance(item, Bound)
        for length in range(1, len(item.path) + 1)
    )


def _asked_optional(value: Has) -> Paths:
    message = value.message
    return frozenset(((message.message, message.path),)) if isinstance(message, Bound) else NO_PATHS


def _is_optional(symbols: Symbols, message: str, path: tuple[str, ...]) -> bool:
    """Whether the last member of a path is optional."""
    label = ""
    for name in path:
        owner = symbols.message(message)
        member = owner.field(name) if owner is not None else None
        if member is None:
            return False
        message, label = member.type.name, member.label
    return label == "optional"


# ---- what a condition says of what is there ------------------------------------------------------


def there_if_holds(value: Value) -> Channels:
    """The channels of which a message is there if the condition holds."""
    return _sure(True, value, _read, _asked)


def _sure(
    holds: bool,
    value: Value,
    read: Callable[[Value], frozenset[Found]],
    asked: Callable[[Has], frozenset[Found]],
) -> frozenset[Found]:
    """What is there for sure if the condition holds, or if it fails, by Kleene's logic.

    `read` gives what a value needs, and `asked` what is there where a `has` holds. Nesting of expressions is
    bounded (E103), so this may recurse.
    """
    match value:
        case Not(operand=operand):
            return _sure(not holds, operand, read, asked)
        case Logic(operator=operator, operands=parts):
            found = [_sure(holds, part, read, asked) for part in parts]
            is_all = (operator == "&&") == holds
            return frozenset().union(*found) if is_all else frozenset.intersection(*found)
        case Named(expression=inner):
            return _sure(holds, inner, read, asked)
        case Has():
            return asked(value) if holds else frozenset()
        case Holds(operand=operand):
            return _sure(True, operand, read, asked) if holds else frozenset()
    return read(value)


def _needs(value: Value) -> Iterator[Value]:
    """All that a value needs to be there, but for what it only asks after."""
    stack = [value]
    while stack:
        item = stack.pop()
        if isinstance(item, Conditional):
            stack.append(item.condition)
        elif not isinstance(item, (Has, Holds, Logic)):
            yield item
            stack += operands(item)


def _read(value: Value) -> Channels:
    return frozenset(item.channel for item in _needs(value) if isinstance(item, Member))


def _asked(value: Has) -> Channels:
    return frozenset((value.message.channel,)) if isinstance(value.message, Member) else NONE


# ---- actions -------------------------------------------------------------------------------------


def _needed(transition: Transition) -> Iterator[tuple[Member, Span, bool]]:
    """What actions read, whether it is sent, where the condition of the line does not make sure of it."""
    condition = transition.expression.condition
    there = set(there_if_holds(condition)) if condition is not None else set()
    for action in transition.expression.actions:
        match action:
            case Assign(value=value) | Evaluate(value=value) | StartTimer(duration=value):
                values: Sequence[Value] = (value,)
            case Send():
                values = action.values
            case _:
                values = ()
        for value in values:
            needed = _read(value)
            for member, span in members_in([value]):
                if member.channel in needed and member.channel not in there:
                    yield member, span, isinstance(action, Send)
        if isinstance(action, Publish):
            there.add(action.channel)


def _in_actions(
    chart: Statechart,
    transition: Transition,
    needed: Iterable[tuple[Member, Span, bool]],
    known: Mapping[str, Channels],
    activities: Mapping[str, Activity],
) -> Iterator[Diagnostic]:
    there = known.get(transition.source, NONE) | _after(
        chart.by_label[transition.source], transition, activities
    )
    for member, span, is_sent in needed:
        if member.channel not in there:
            yield Diagnostic(ActionNeedsMessage(str(member.channel), is_sent), span)


def _after(source: State, transition: Transition, activities: Mapping[str, Activity]) -> Channels:
    """What the activity of the source has published if the transition waits for its completion."""
    said = activities.get(source.activity) if source.activity is not None else None
    is_exit = transition.kind in (
        TransitionKind.EXIT,
        TransitionKind.ABANDON,
    )  # it may be left while its activity runs
    if said is None or transition.expression.events or transition.expression.when or is_exit:
        return NONE
    return frozenset(said.writes)


def _known(
    chart: Statechart, activities: Mapping[str, Activity], wanted: set[Channel]
) -> dict[str, Channels]:
    """Of which of the `wanted` channels there is a message for sure when a state is entered.

    A state or history that is there once stays, and a region starts with what is around it; a signal does not
    stay. So this is what all ways to a state have in common, found by going round until nothing changes.
    """
    wanted = {channel for channel in wanted if channel.comm is not ChannelKind.SIGNAL}
    everything = frozenset(wanted)
    known = {node.label: everything for node in chart.states}
    known[chart.root.label] = NONE
    incoming: dict[str, list[Transition]] = {}
    for transition in chart.transitions:
        if transition.changes_state:
            for label in (transition.target, *transition.into):
                incoming.setdefault(label, []).append(transition)
    ends = {node.parent: node.label for node in chart.states if node.type is StateType.END}

    def left(transition: Transition) -> Channels:
        source = chart.by_label[transition.source]
        there = known[source.label] | _after(source, transition, activities)
        completed = not (transition.expression.events or transition.expression.when)
        if completed and source.label in ends:
            there |= known[ends[source.label]]
        elif completed and source.type is StateType.AND:
            for child in chart.children(source.label):
                there |= known[ends[child.label]] if child.label in ends else NONE
        if transition.expression.condition is not None:
            there |= there_if_holds(transition.expression.condition)
        for action in transition.expression.actions:
            if isinstance(action, Publish):
                there |= {action.channel}
        return there & everything

    changed = bool(wanted)
    while changed:
        changed = False
        for node in chart.states:
            if node.parent is None:
                continue
            ways = [left(item) for item in incoming.get(node.label, ())]
            if node.type is StateType.START or chart.by_label[node.parent].type is StateType.AND:
                ways.append(known[node.parent])
            found = frozenset.intersection(*ways) if ways else everything
            if found != known[node.label]:
                known[node.label] = found
                changed = True
    return known


# ---- beside an else ------------------------------------------------------------------------------


def _beside_else(chart: Statechart, activities: Mapping[str, Activity]) -> Iterator[Diagnostic]:
    """A condition that is only the opposite of something, beside an `else`.

    What the role itself publishes is not reported: it comes soon.
    """
    groups: dict[str, list[Transition]] = {}
    for transition in chart.transitions:
        if transition.expression.otherwise:
            groups[transition.source] = []
    if not groups:
        return
    for transition in chart.transitions:
        if transition.source in groups and transition.changes_state and not transition.reactive:
            groups[transition.source].append(transition)
    own: set[Channel] = set()
    for node in chart.states:
        if node.activity is not None and node.activity in activities:
            own.update(activities[node.activity].writes)
    for transition in chart.transitions:
        own.update(a.channel for a in transition.expression.actions if isinstance(a, Publish))
    for group in groups.values():
        yield from _negated(group, own)


def _negated(group: Sequence[Transition], own: set[Channel]) -> Iterator[Diagnostic]:
    otherwise = next(item for item in group if item.expression.otherwise)
    opposed: dict[Channel, Span] = {}
    asserted: set[Channel] = set()
    for transition in group:
        condition = transition.expression.condition
        if condition is not None:
            _signs(condition, {}, asserted)
            for part in _alternatives(condition):
                if isinstance(part, Not) or (isinstance(part, Compare) and part.operator == "!="):
                    _signs(part, opposed, asserted, condition.span if isinstance(condition, Named) else None)
    for channel, span in opposed.items():
        if channel in asserted or channel in own or channel.comm is ChannelKind.SIGNAL:
            continue
        related = (Related(otherwise.span, "the `else`"),)
        yield Diagnostic(ElseWithoutMessage(str(channel)), span, related)


def _alternatives(condition: Value) -> Iterator[Value]:
    """The parts of a condition each of which is enough: those that `||` joins."""
    stack = [condition]
    while stack:
        item = stack.pop()
        if isinstance(item, Named):
            stack.append(item.expression)
        elif isinstance(item, Logic) and item.operator == "||":
            stack += reversed(item.operands)
        else:
            yield item


def _signs(
    condition: Value, opposed: dict[Channel, Span], asserted: set[Channel], place: Span | None = None
) -> None:
    """The channels whose readings stand with `!` or `!=`, and those that stand without or are asked for.

    `place` is where the condition is named, if it stands elsewhere.
    """
    stack: list[tuple[Value, bool, Span | None]] = [(condition, True, place)]
    while stack:
        value, sign, place = stack.pop()
        match value:
            case Not(operand=operand):
                stack.append((operand, not sign, place))
            case Logic(operands=parts):
                stack += [(part, sign, place) for part in reversed(parts)]
            case Named(expression=inner, span=span):
                stack.append((inner, sign, place or span))
            case Has(message=message):
                if isinstance(message, Member):
                    asserted.add(message.channel)
            case Compare(operator="!=") | Compare(operator="=="):
                positive = sign == (value.operator == "==")
                _sign(value, positive, place, opposed, asserted)
            case _:
                _sign(value, sign, place, opposed, asserted)


def _sign(
    value: Value, positive: bool, place: Span | None, opposed: dict[Channel, Span], asserted: set[Channel]
) -> None:
    for channel in sorted(_read(value)):
        if positive:
            asserted.add(channel)
        else:
            opposed.setdefault(channel, place or value.span)


__all__ = ["check_presence", "there_if_holds"]
