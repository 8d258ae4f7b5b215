"""Faults of a compiler, planted in a statechart: each is a chart that it could have made instead."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import product

from aseme_dsl.amola.expression import Holds, Logic, Not, Value, value_text, walk
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition
from aseme_dsl.proofs.certificate.meaning import same


@dataclass(frozen=True, slots=True)
class Fault:
    """A wrong chart, and what is wrong with it."""

    kind: str
    text: str
    chart: Statechart


def faults(chart: Statechart) -> Iterator[Fault]:
    """Every fault of every kind; those that leave the chart as it was are not among them."""
    transitions = chart.transitions
    for place, item in enumerate(transitions):
        text = f"{item.source} -> {item.target}"

        def with_it(*instead: Transition, place: int = place) -> Statechart:
            return replace(chart, transitions=(*transitions[:place], *instead, *transitions[place + 1 :]))

        if not never_holds(item):
            yield Fault("dropped", text, with_it())
        yield Fault("doubled", text, with_it(item, replace(item, priority=item.priority + 100)))
        yield Fault("kind", f"{text} first", with_it(replace(item, first=not item.first)))
        if item.changes_state:
            for other in _beside(chart, item):
                yield Fault(
                    "retargeted", f"{text} to {other.label}", with_it(replace(item, target=other.label))
                )
            around = chart.node(item.source).parent
            inside = [state for state in chart.states if state.parent == item.source]
            first = [state.label for state in inside if state.type is not StateType.END][:1]
            for source in ([around] if around not in (None, "0") else []) + first:
                assert source is not None
                yield Fault("resourced", f"{text} from {source}", with_it(replace(item, source=source)))
        expression = item.expression
        if expression.condition is not None and not expression.when:
            yield Fault("when", text, with_it(replace(item, expression=replace(expression, when=True))))
        for number in range(len(expression.actions)):
            fewer = (*expression.actions[:number], *expression.actions[number + 1 :])
            yield Fault(
                "action lost", text, with_it(replace(item, expression=replace(expression, actions=fewer)))
            )
    yield from _exchanged(chart)
    for place, state in enumerate(chart.states):
        for made in _other_states(chart, state):
            states = (*chart.states[:place], made, *chart.states[place + 1 :])
            yield Fault("state", f"{state.label}: {made.activity}", replace(chart, states=states))


def never_holds(item: Transition) -> bool:
    """Whether the condition of a reactive transition is false, whatever holds: it is as good as dropped."""
    condition = item.expression.condition
    if not item.reactive or item.expression.events or condition is None:
        return False
    asked = sorted({value_text(part) for part in walk(condition) if isinstance(part, Holds)})
    truths = (dict(zip(asked, truth, strict=True)) for truth in product((False, True), repeat=len(asked)))
    return not any(_truth(condition, truth) for truth in truths)


def _truth(value: Value, truth: Mapping[str, bool]) -> bool:
    match value:
        case Holds():
            return truth[value_text(value)]
        case Not(operand=operand):
            return not _truth(operand, truth)
        case Logic(operator=operator, operands=operands):
            return (all if operator == "&&" else any)(_truth(part, truth) for part in operands)
    raise AssertionError(f"what a choice asks for again: {value_text(value)}")


def _beside(chart: Statechart, item: Transition) -> list[State]:
    """Where else a transition could lead: to other states of its level, or to its like in another one."""
    target = chart.node(item.target)
    own = [state for state in chart.children(target.parent or "") if state.label != target.label]
    like = [state for state in chart.states if state.span == target.span and state.parent != target.parent]
    found = [state for state in (*own, *like[:2]) if state.type is not StateType.START]
    return [state for state in found if state.label != item.target]


def _exchanged(chart: Statechart) -> Iterator[Fault]:
    """Guards, actions or priorities exchanged between a transition and the next ones."""
    transitions = chart.transitions
    for place, one in enumerate(transitions):
        for further in (1, 2, 7):
            if place + further >= len(transitions):
                continue
            other = transitions[place + further]
            pairs = [
                ("guards", *_swapped(one, other, "condition")),
                ("actions", *_swapped(one, other, "actions")),
            ]
            if one.source == other.source and one.changes_state and other.changes_state:
                pairs.append(
                    (
                        "priorities",
                        replace(one, priority=other.priority),
                        replace(other, priority=one.priority),
                    )
                )
            for kind, first, second in pairs:
                if same((first, second), (one, other)):
                    continue
                made = list(transitions)
                made[place], made[place + further] = first, second
                text = f"{one.source} -> {one.target} and {other.source} -> {other.target}"
                yield Fault(kind, text, replace(chart, transitions=tuple(made)))


def _swapped(one: Transition, other: Transition, part: str) -> tuple[Transition, Transition]:
    left, right = one.expression, other.expression
    return (
        replace(one, expression=replace(left, **{part: getattr(right, part)})),
        replace(other, expression=replace(right, **{part: getattr(left, part)})),
    )


def _other_states(chart: Statechart, state: State) -> Iterator[State]:
    if state.activity is None:
        return
    others = sorted({item.activity for item in chart.states if item.activity is not None} - {state.activity})
    yield replace(state, activity=others[0] if others else "Other")
    yield replace(state, waits=not state.waits)
