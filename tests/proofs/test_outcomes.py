"""Conditions of a move are looked at once for the same answers, and split what may be so all the same."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import cast

from aseme_dsl.proofs.explore.deciding.choosing import Choices
from aseme_dsl.proofs.explore.deciding.outcomes import Outcomes
from aseme_dsl.runtime.chart.chart import Chart

CHART = cast(Chart, SimpleNamespace(effects=[]))
Way = tuple[tuple[bool, ...], tuple[object, ...]]


def ways_of(
    conditions: list[Callable[[Callable[[str], int]], object]], *, hears: bool
) -> tuple[list[Way], int]:
    """Every way through some conditions, which ask for members, with how often these were asked for."""
    choices = Choices()
    outcomes = Outcomes(choices)
    asked: list[str] = []

    def member(name: str) -> int:
        asked.append(name)
        return outcomes.of(name, range(4), f"{name} is {{}}")

    found: list[Way] = []
    choices.begin()
    while True:
        choices.heard = [] if hears else None
        outcomes.begin()
        truths = tuple(outcomes.holds(CHART, lambda it=it: it(member)) for it in conditions)  # type: ignore[misc]
        outcomes.mark()
        found.append((truths, (*outcomes.end(lambda question: question == "b"), *choices.said)))
        if not choices.again():
            return found, len(asked)


def test_what_is_asked_twice_is_looked_at_once() -> None:
    conditions: list[Callable[[Callable[[str], int]], object]] = [
        lambda of: of("a") < 2 and of("b") < 3,
        lambda of: of("c") == of("b"),
        lambda of: of("a") == 1 or of("c") < 2,
        lambda of: of("b") > 0,
    ]
    every, often = ways_of(conditions, hears=True)
    once, seldom = ways_of(conditions, hears=False)
    assert once == every
    assert len(every) > 10
    assert seldom < 0.6 * often
