"""Again: the transitions of a reactive choice, by which its branches are exited."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import product

from aseme_dsl.amola.expression import Holds, Logic, Not, Value
from aseme_dsl.amola.statechart import Transition
from aseme_dsl.proofs.certificate.meaning import same

LARGEST = 10
"""Of how many conditions all combinations are compared."""


def reactive_problem(ways: Sequence[Transition], branch: str, found: Sequence[Transition]) -> str | None:
    """What is wrong with the reactive transitions that a branch has; None if they are as they should be.

    `ways` are the transitions of the choice, and `found` those of the branch, both in the order in which they
    are tried. A branch has one transition to each branch that an event selects, and behind them one back to
    the choice for conditions.
    """
    choice = ways[0].source
    back = [item for item in found if item.target == choice]
    direct = [item for item in found if item.target != choice]
    chosen = [way for way in ways if way.expression.events and way.target != branch]
    if len(direct) != len(chosen):
        return f"{len(direct)} reactive transitions lead to other branches, not {len(chosen)}"
    for item, way in zip(direct, chosen, strict=True):
        wanted = replace(way.expression, when=False)
        if item.target != way.target or not same(item.expression, wanted) or item.resume is not way.resume:
            return f"the reactive transition to {item.target} should lead to {way.target}"
        if item.first or item.span != way.span:
            return f"the reactive transition to {item.target} is of another kind or place than the choice's"
    decided = [way for way in ways if way.expression.when or not way.expression.events]
    if len(back) > 1:
        return "several reactive transitions lead back to the choice"
    own = next(way for way in ways if way.target == branch)
    if back and (back[0] is not found[-1] or back[0].span != own.span):
        return "the reactive transition back to the choice is tried before others or points to another place"
    expression = back[0].expression if back else None
    if expression is not None:
        is_more = expression.events or expression.actions or back[0].resume or back[0].first
        if not expression.when or expression.condition is None or is_more:
            return "the reactive transition back to the choice should be `when [c]`"
    condition = None if expression is None else expression.condition
    return _back_problem(decided, branch, condition)


def _back_problem(ways: Sequence[Transition], branch: str, condition: Value | None) -> str | None:
    """What is wrong with the condition under which the choice is made again (None: never)."""
    asked: list[Value] = []
    numbers = [
        None if way.expression.condition is None else _number(way.expression.condition, asked) for way in ways
    ]
    known = len(asked)
    back = None if condition is None else _numbered(condition, asked)
    if len(asked) > known or (condition is not None and back is None):
        return "the condition of its reactive transition is not of those of the choice"
    if known > LARGEST:
        return None
    targets = [(way.target == branch, number) for way, number in zip(ways, numbers, strict=True)]
    for truth in product((False, True), repeat=known):
        if (back is not None and _holds(back, truth)) is not _is_another(targets, truth):
            return "the condition of its reactive transition is not that another branch would be taken"
    return None


def _is_another(ways: Sequence[tuple[bool, int | None]], truth: Sequence[bool]) -> bool:
    """Whether another branch than the own one would be taken; each way says whether it leads to the own one.

    What an event has selected is not exited for a branch that needs nothing.
    """
    by_condition = False
    for is_own, number in ways:
        if number is None or truth[number]:
            if is_own:
                return False
            if number is not None or by_condition:
                return True
        by_condition = by_condition or is_own
    return False


def is_compared(ways: Sequence[Transition]) -> bool:
    """Whether there are few enough conditions."""
    return sum(way.expression.condition is not None for way in ways) <= LARGEST


_Numbered = tuple[str, tuple["_Numbered | int", ...]]
"""A condition of `holds(…)`, by the numbers of what is asked."""


def _number(value: Value, asked: list[Value]) -> int:
    """The number of a condition among those that are asked for, to which it is added."""
    for number, other in enumerate(asked):
        if same(value, other):
            return number
    asked.append(value)
    return len(asked) - 1


def _numbered(condition: Value, asked: list[Value]) -> _Numbered | None:
    match condition:
        case Holds(operand=operand):
            return "holds", (_number(operand, asked),)
        case Not(operand=operand):
            inner = _numbered(operand, asked)
            return None if inner is None else ("!", (inner,))
        case Logic(operator=operator, operands=operands):
            parts = [_numbered(part, asked) for part in operands]
            whole = tuple(part for part in parts if part is not None)
            return (operator, whole) if len(whole) == len(parts) else None
    return None


def _holds(condition: _Numbered | int, truth: Sequence[bool]) -> bool:
    if isinstance(condition, int):
        return truth[condition]
    operator, parts = condition
    values = (_holds(part, truth) for part in parts)
    match operator:
        case "&&" | "holds":
            return all(values)
        case "!":
            return not all(values)
    return any(values)


__all__ = ["LARGEST", "is_compared", "reactive_problem"]
