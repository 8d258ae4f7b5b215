"""No drawing lacks a state, a transition or a text, and every line ends where it should."""

from __future__ import annotations

from functools import cache

import pytest

from aseme_dsl.amola.expression import expression_text
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.diagrams import Expressions, Layout, Options, draw_statechart, render
from tests.diagrams.building import FIGURE_4, random_statechart, statechart
from tests.diagrams.pictures import Picture, by_graphviz, distance_to_border, is_deep_inside

SEEDS = range(36)


@cache
def random_chart(seed: int) -> Statechart:
    return random_statechart(seed, size=3 + seed % 3, extra=seed % 5)


@cache
def picture(seed: int, layout: Layout) -> Picture:
    (drawing,) = draw_statechart(random_chart(seed), Options(layout=layout))
    return Picture(render(drawing, "svg"))


def test_the_random_charts_are_what_they_should_be() -> None:
    charts = [random_chart(seed) for seed in SEEDS]
    assert max(len(chart.states) for chart in charts) <= 60
    assert sum(any(node.type is StateType.AND for node in chart.states) for chart in charts) >= 10
    loops = [sum(t.source == t.target and bool(c.children(t.source)) for t in c.transitions) for c in charts]
    assert sum(loops) >= 20


@pytest.mark.parametrize("seed", SEEDS)
def test_everything_is_drawn(seed: int) -> None:
    chart = random_chart(seed)
    for layout in (Layout.NESTED, Layout.TREE):
        shown = picture(seed, layout)
        assert {f"n{node.label}" for node in chart.states} <= shown.ids
        assert {f"t{place}" for place in range(len(chart.transitions))} <= shown.ids
        for node in chart.states:
            if node.type is StateType.BASIC:
                assert node.name in shown.says(f"n{node.label}")
            assert node.label in shown.tip(f"n{node.label}")
        for place, transition in enumerate(chart.transitions):
            assert expression_text(transition.expression) in shown.tip(f"t{place}")


@pytest.mark.parametrize("seed", SEEDS)
def test_states_are_inside_the_states_that_hold_them(seed: int) -> None:
    chart = random_chart(seed)
    shown = picture(seed, Layout.NESTED)
    for node in chart.states:
        if node.parent is not None:
            left, top, right, bottom = shown.frame(f"n{node.label}")
            around = shown.frame(f"n{node.parent}")
            assert around[0] < left and around[1] < top and right < around[2] and bottom < around[3]


@pytest.mark.parametrize("seed", SEEDS)
def test_lines_do_not_run_into_the_composites_that_they_join(seed: int) -> None:
    chart = random_chart(seed)
    shown = picture(seed, Layout.NESTED)
    for place, transition in enumerate(chart.transitions):
        for label, other in ((transition.source, transition.target), (transition.target, transition.source)):
            if not chart.children(label) or other.startswith(f"{label}."):
                continue
            frame = shown.frame(f"n{label}")
            parts = [part for part in (f"t{place}", f"t{place}.rest") if part in shown.ids]
            points = [point for part in parts for point in shown.line(part)]
            if other != label and label.startswith(f"{other}."):
                continue
            assert min(distance_to_border(frame, point) for point in points) < 3
            assert not any(is_deep_inside(frame, point, 3) for point in points)


@pytest.mark.parametrize("expressions", list(Expressions))
def test_the_player_of_figure_4_is_drawn_whole(expressions: Expressions) -> None:
    chart = statechart(FIGURE_4)
    assert (len(chart.states), len(chart.transitions), chart.levels) == (124, 92, 19)
    for drawing in by_graphviz(chart, expressions=expressions):
        shown = Picture(render(drawing, "svg"))
        assert {f"n{node.label}" for node in chart.states} <= shown.ids
        assert {f"t{place}" for place in range(92)} <= shown.ids
