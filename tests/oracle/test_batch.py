"""Thousands at once do what one does: random charts, and inputs that differ from instance to instance.

The examples are the same in every run; `ORACLE_EXAMPLES=2000` looks at more of them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest

from aseme_dsl.amola.expression import (
    Arithmetic,
    Assign,
    Call,
    Conditional,
    Literal,
    Member,
    TransitionExpression,
    Value,
    rewritten_expression,
    values_of,
)
from aseme_dsl.amola.messages import DURATION, STRING, Kind
from aseme_dsl.amola.statechart import Statechart, Transition
from aseme_dsl.amola.system import System
from aseme_dsl.backends.batch.generate import problems_of
from aseme_dsl.codegen.program import sizes
from aseme_dsl.runtime.plain.plain import Unsettled
from tests.oracle.charts import MS, text
from tests.oracle.choices import Choices
from tests.oracle.examples import agree, how_many
from tests.oracle.plain import without_limits
from tests.oracle.playing import like
from tests.support.batches import Together, made, without_compiling
from tests.support.generated import system_of

EXAMPLES = how_many(40)
GROUPS = 2
SIZE = 12
STEPS = 12


def with_numbers_only(system: System) -> System | None:
    """The system with a constant wherever a batch would refuse; None where that is not enough."""
    plain = without_limits(system)
    if plain is None:
        return None
    changed = replace(plain, iacs=tuple(map(_tamed, plain.iacs)))
    return None if any(any(problems_of(chart, changed)) for chart in changed.iacs) else changed


def _tamed(chart: Statechart) -> Statechart:
    texts = {item.name for item in chart.variables if item.type.kind is Kind.STRING}
    variables = tuple(item for item in chart.variables if item.name not in texts)
    return replace(chart, transitions=tuple(map(_tame, chart.transitions)), variables=variables)


def _tame(transition: Transition) -> Transition:
    expression = rewritten_expression(transition.expression, _number)
    actions = tuple(
        action for action in expression.actions if not _speaks(TransitionExpression(actions=(action,)))
    )
    condition = expression.condition
    if _speaks(TransitionExpression(condition=condition)):
        condition = None
    changed = replace(expression, actions=actions, condition=condition)
    # What is NEVER stays it.
    return transition if changed == transition.expression else replace(transition, expression=changed)


def _speaks(expression: TransitionExpression) -> bool:
    """Whether a text is in it."""
    targets = [action.target for action in expression.actions if isinstance(action, Assign)]
    values = [*values_of(expression), *targets]
    return any(getattr(value, "type", None) == STRING for value in values)


def _number(value: Value) -> Value:
    match value:
        case Member() | Call() | Conditional():
            return _constant(value)
        case Arithmetic(operator="/" | "%", right=by):
            return replace(value, right=Literal(by.span.start % 5 - 2 or 3, by.type, by.span))
        case Arithmetic(operator="*", type=kind) if kind == DURATION:
            return _constant(value)
    return value


def _constant(value: Value) -> Value:
    chance = value.span.start % 4
    known = {
        Kind.BOOL: chance % 2 == 0,
        Kind.INT: chance,
        Kind.DOUBLE: chance / 2,
        Kind.DURATION: chance * 10**6,
    }
    found = known.get(value.type.kind)
    return value if found is None else Literal(found, value.type, value.span)


def play(folder: Path, choices: Choices) -> Iterator[Together]:
    """A game with a random chart, if there is one that batches can do.

    Raises:
        AssertionError: an instance of a batch differs from the plain chart.
    """
    written = text(choices)
    system = with_numbers_only(system_of(written))
    if system is None:
        return
    plain, batch = made(system, folder, "R")
    together = Together(plain, batch, SIZE, ("numpy", "numba"))
    labels = list(batch.RUNNING)
    try:
        together.start()
        now = 0
        for _ in range(STEPS):
            now += choices.one_of((0, MS, 5 * MS, 10 * MS))
            together.time(now)
            for _ in range(choices.number(0, 6)) if together.values else ():
                instance, name = choices.number(0, SIZE - 1), choices.one_of(together.values)
                old = getattr(together.scalars[instance].bb, name)
                together.set(instance, name, like(old, choices.number(0, 3)))
            if labels and choices.one_in(3):
                which = [choices.one_in(2) for _ in range(SIZE)]
                together.done(choices.one_of(labels), which)
            elif choices.one_in(3):
                which = [choices.one_in(2) for _ in range(SIZE)]
                together.send(choices.one_of(together.events), which)
            elif choices.one_in(4):
                together.step([choices.one_in(2) for _ in range(SIZE)])
            else:
                together.send(choices.one_of(together.events))
    except Unsettled:
        pass
    except AssertionError as error:
        raise AssertionError(f"{error}\n\n{written}") from error
    yield together


@pytest.mark.parametrize("shared", [sizes.SHARED, 0], ids=["", "shared"])
@pytest.mark.parametrize("group", range(GROUPS))
def test_batches_do_what_the_plain_class_does(
    group: int, shared: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sizes, "SHARED", shared)
    with without_compiling():
        assert agree(partial(play, tmp_path), EXAMPLES, group, GROUPS) > 0
