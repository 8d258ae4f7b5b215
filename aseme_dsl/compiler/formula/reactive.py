"""Reactive: choices that are re-evaluated while a branch is active.

Each branch gets a transition back to the choice, with the condition that another branch would now be taken.
It also gets a transition to each branch that an event selects, with that event.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Sequence
from dataclasses import replace

from aseme_dsl.amola.expression import Holds, Logic, Not, TransitionExpression, Value
from aseme_dsl.amola.liveness import Formula, ungrouped
from aseme_dsl.amola.operators import is_choice
from aseme_dsl.amola.statechart import State, StateType, Transition
from aseme_dsl.compiler.formula.terms import Terms
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.control import ReactiveWithoutChoice
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span


def choices_in(terms: Terms) -> frozenset[Formula]:
    """The branches of all choices, options and `T*` of a formula."""
    return frozenset(
        ungrouped(operand) for term in terms.parents if is_choice(term.operator) for operand in term.operands
    )


def no_choice(control: tree.Control, reactive: Span, formula: tree.NamedFormula) -> Diagnostic:
    """E425 for a reactive control of a formula without a choice."""
    problem = ReactiveWithoutChoice(control.name.text)
    return Diagnostic(problem, reactive, (Related(formula.formula.span, "its text"),))


def reconsidered(
    found: Sequence[Transition], nodes: Iterable[State], choices: Container[str]
) -> tuple[Transition, ...]:
    """What the branches of the `choices` (labels of CONDITION states) get, after all their transitions."""
    kinds = {node.label: node for node in nodes}
    outgoing: dict[str, list[Transition]] = {}
    for transition in found:
        if transition.changes_state:
            outgoing.setdefault(transition.source, []).append(transition)
    made: list[Transition] = []
    for choice, node in kinds.items():
        if node.type is not StateType.CONDITION or choice not in choices:
            continue
        ways = sorted(outgoing.get(choice, []), key=lambda way: way.priority)
        for branch in dict.fromkeys(way.target for way in ways):
            if kinds[branch].type is StateType.END:
                continue
            last = max((item.priority for item in found if item.source == branch), default=-1)
            for place, item in enumerate(_back(ways, kinds[branch], node), last + 1):
                made.append(replace(item, priority=place))
    return tuple(made)


def _back(ways: Sequence[Transition], branch: State, choice: State) -> Iterator[Transition]:
    """The transitions of one branch, without their places."""
    first = next(way for way in ways if way.target == branch.label)
    for way in ways:
        events = way.expression.events
        if events and way.target != branch.label:
            name = way.name.replace(choice.name, branch.name, 1)
            expression = replace(way.expression, when=False)
            yield replace(way, name=name, source=branch.label, expression=expression, reactive=True)
    condition = _another(ways, branch.label, first.span)
    if condition is not None:
        expression = TransitionExpression(when=True, condition=condition)
        name = f"{branch.name}TO{choice.name}"
        yield replace(
            first,
            name=name,
            source=branch.label,
            target=choice.label,
            expression=expression,
            resume=False,
            reactive=True,
        )


def _another(ways: Sequence[Transition], branch: str, span: Span) -> Value | None:
    """When choosing again would take another branch; None if that can never be."""
    failing: list[Value] = []
    cases: list[Value] = []
    for way in ways:
        written = way.expression
        if written.events and not written.when:
            continue
        condition = written.condition
        if way.target == branch:
            if condition is None:
                break  # it is open, and comes before all that follow
            failing.append(Not(Holds(condition, span), span))
            continue
        case = [*([] if condition is None else [Holds(condition, span)]), *failing]
        if case:
            cases.append(case[0] if len(case) == 1 else Logic("&&", tuple(case), span))
    if not cases:
        return None
    return cases[0] if len(cases) == 1 else Logic("||", tuple(cases), span)


__all__ = ["choices_in", "no_choice", "reconsidered"]
