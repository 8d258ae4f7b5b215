"""A drawing as PNG, PDF and DOT."""

from __future__ import annotations

import re
import zlib
from pathlib import Path

import pytest

from aseme_dsl.diagrams import DrawingFailed, Layout, Options, draw_statechart, drawings, program, render
from aseme_dsl.diagrams.rendering.pdf import from_svg
from tests.diagrams.building import condition, statechart
from tests.diagrams.test_escaping import drawing_of_goal
from tests.diagrams.texts import TEAM, compiled

PURE = Path(program()).name.startswith("graphviz-pure")


def content(pdf: bytes) -> str:
    """The operators on the page of one of our own PDF files."""
    match = re.search(rb"/Length (\d+) /Filter /FlateDecode >>\nstream\n", pdf)
    assert match is not None
    return zlib.decompress(pdf[match.end() : match.end() + int(match[1])]).decode("cp1252")


def test_every_drawing_can_be_a_png_and_a_pdf() -> None:
    for drawing in drawings(compiled(TEAM)):
        assert render(drawing, "png").startswith(b"\x89PNG\r\n")
        assert render(drawing, "pdf").startswith(b"%PDF-")


def test_dot_text_needs_no_graphviz(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    (drawing,) = draw_statechart(statechart("A . B"), Options(layout=Layout.NESTED))
    assert render(drawing, "dot") == drawing.dot.encode()
    assert drawing.dot.startswith('digraph "iac.Test" {\n')


def test_our_own_pdf_says_and_draws_what_the_svg_does() -> None:
    chart = statechart("(Walk . [Kick])+", {("0.2.3.2", "0.2.3.3"): condition("near")})
    (drawing,) = draw_statechart(chart, Options(layout=Layout.NESTED))
    svg = render(drawing, "svg")
    pdf = from_svg(svg)
    operators = content(pdf)
    for text in ("(Walk)", "(Kick)", "([Kick])", "([game.state.Ball.near == 1] / seen = true)"):
        assert f"{text} Tj" in operators
    assert operators.count(" c\n") >= svg.count(b"<ellipse") * 4
    assert pdf == from_svg(svg)


def test_our_own_pdf_has_its_objects_where_its_table_says() -> None:
    (drawing,) = draw_statechart(statechart("A . B"), Options(layout=Layout.NESTED))
    pdf = from_svg(render(drawing, "svg"))
    start = int(pdf.rsplit(b"startxref\n", 1)[1].split()[0])
    assert pdf[start : start + 5] == b"xref\n"
    places = [int(line[:10]) for line in pdf[start:].split(b"\n")[3:9]]
    assert [pdf[place : place + 7] for place in places] == [b"%d 0 obj" % n for n in range(1, 7)]


def test_our_own_pdf_escapes_parentheses_and_backslashes() -> None:
    svg = render(drawing_of_goal("a (b) \\ c)"), "svg")
    assert "(a \\(b\\) \\\\ c\\)) Tj" in content(from_svg(svg))


@pytest.mark.skipif(not PURE, reason="Graphviz' own dot writes every character")
def test_a_pdf_of_other_letters_needs_graphviz_own_dot() -> None:
    with pytest.raises(DrawingFailed, match=r"character 'γ'.*`dot`.*apt install graphviz"):
        render(drawing_of_goal("γκολ"), "pdf")
