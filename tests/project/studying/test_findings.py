"""Findings of a study: intervals, and what is told from chance."""

from __future__ import annotations

import random

import pytest

from aseme_dsl.project.studying.findings import estimate, student


@pytest.mark.parametrize(
    ("freedom", "quantile"),
    [(1, 12.7062047), (2, 4.3026527), (3, 3.1824463), (4, 2.7764451), (9, 2.2621572), (49, 2.0095752)],
)
def test_the_quantiles_are_those_of_the_tables(freedom: int, quantile: float) -> None:
    assert student(freedom) == pytest.approx(quantile, abs=1e-6)


@pytest.mark.parametrize("runs", [2, 3, 5, 10])
def test_intervals_of_95_percent_contain_the_mean_in_95_percent(runs: int) -> None:
    draw = random.Random(runs)
    found = [estimate([draw.gauss(10, 1) for _ in range(runs)]) for _ in range(2000)]
    hits = sum(item.low <= 10 <= item.high for item in found if item is not None)
    assert hits / 2000 == pytest.approx(0.95, abs=0.02)


def test_what_is_always_the_same_has_no_interval() -> None:
    same = estimate([2.0, 2.0, 2.0])
    assert same is not None and (same.low, same.mean, same.high, same.runs) == (2, 2, 2, 3)
    assert estimate([]) is None
