"""Charts that are too much for one picture."""

from __future__ import annotations

from dataclasses import replace

import pytest

import aseme_dsl
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.diagrams import Layout, Options, draw, draw_statechart
from aseme_dsl.diagrams.models.division import PIECE
from aseme_dsl.source import Source
from tests.diagrams.building import random_statechart, statechart
from tests.diagrams.pictures import Picture, by_graphviz


def deep(depth: int) -> Statechart:
    formula = "[" * depth + "A" + "]" * depth
    system = aseme_dsl.compile(
        Source("deep.aseme", f"system Deep\nsrm r {{ liveness {{ r = {formula} }} }}\n")
    )
    return system.iacs[0]


def test_pieces_are_small_and_together_they_are_the_whole() -> None:
    chart = random_statechart(7, size=40, extra=10)
    for drawing in by_graphviz(chart):
        assert drawing.pieces is not None
        index, *pieces = drawing.pieces()
        assert index.name == drawing.name
        assert all(piece.states <= PIECE for piece in pieces)
        ids = [item.id for piece in pieces for item in piece.shown]
        for node in chart.states:
            assert f"n{node.label}" in ids
        for place in range(len(chart.transitions)):
            assert f"t{place}" in ids
        assert len({piece.name for piece in pieces}) == len(pieces)


def test_a_closed_state_leads_to_the_file_that_shows_its_inside() -> None:
    (drawing,) = draw_statechart(random_statechart(7, size=40, extra=0), Options(layout=Layout.NESTED))
    assert drawing.pieces is not None
    names = {f"{piece.name}.svg" for piece in drawing.pieces()[1:]}
    top = drawing.pieces()[1]
    inside = draw(top, "svg").files[0][1]
    links = {part.split('"')[0] for part in inside.decode().split('xlink:href="')[1:]}
    assert links
    assert links <= names


def test_a_part_that_is_asked_for_is_divided_like_a_whole() -> None:
    chart = random_statechart(7, size=40, extra=0)
    at = next(
        node.label for node in chart.states if node.label.count(".") == 2 and chart.children(node.label)
    )
    (drawing,) = draw_statechart(chart, Options(layout=Layout.NESTED, at=at))
    assert drawing.pieces is not None
    index, top, *_ = drawing.pieces()
    assert (index.name, top.name) == (f"iac.Test.nested.{at}", f"iac.Test.nested.{at}.{at}")


def test_what_nobody_can_read_is_not_attempted_in_one_picture() -> None:
    (drawing,) = draw_statechart(statechart("(A . B) | C"), Options(layout=Layout.NESTED))
    drawn = draw(replace(drawing, states=5000), "svg")
    assert [name for name, _ in drawn.files] == ["iac.Test.nested.svg", "iac.Test.nested.0.svg"]
    assert drawn.notes == (
        "iac.Test.nested has 5000 states, which is too much for one picture; "
        "it is drawn in 2 files, iac.Test.nested.svg is where to begin",
    )


@pytest.mark.long
def test_a_thousand_operands_are_one_picture() -> None:
    chart = statechart(" | ".join(f"A{n}" for n in range(1000)))
    drawn = draw(draw_statechart(chart, Options(layout=Layout.NESTED))[0], "svg")
    assert len(drawn.files) == 1
    shown = Picture(drawn.files[0][1])
    assert {f"t{place}" for place in range(len(chart.transitions))} <= shown.ids


@pytest.mark.long
def test_a_deep_chart_is_drawn_in_pieces_whose_names_files_can_have() -> None:
    chart = deep(400)
    assert len(chart.states) > 1500
    for drawing in by_graphviz(chart):
        drawn = draw(drawing, "svg")
        assert len(drawn.files) > 10
        assert len(drawn.notes) == 1
        assert all(len(name.encode()) < 150 for name, _ in drawn.files)
        assert len({name for name, _ in drawn.files}) == len(drawn.files)
