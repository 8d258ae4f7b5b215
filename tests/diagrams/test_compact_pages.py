"""Compact drawings of parts, closed from a depth on, and divided into pages."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

import aseme_dsl
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.diagrams import (
    Drawing,
    Layout,
    NoSuchState,
    Options,
    PageSize,
    draw_statechart,
    render,
    writes_pdf,
)
from aseme_dsl.diagrams.compact.check import faults
from aseme_dsl.diagrams.compact.elements import SIZES, Text
from aseme_dsl.diagrams.compact.pages import divided, whole
from tests.diagrams.pictures import SVG, text_of
from tests.diagrams.texts import compiled
from tests.support.lanes import kept

EXAMPLES = Path(__file__).parents[2] / "examples"

PARTS = """\
system S
srm r {
  liveness {
    r     = first . (work [> halt)
    first = A . B
    work  = (fetch . bring)~
    fetch = C . [D]
    bring = deep || E
    deep  = F . G . H
    halt  = I . J
  }
  control r { enter halt : after(5s) }
}
"""


def chart() -> Statechart:
    return compiled(PARTS).iacs[0]


def drawn(**options: object) -> list[Drawing]:
    return draw_statechart(chart(), Options(layout=Layout.COMPACT, **options))  # type: ignore[arg-type]


def text(drawing: Drawing) -> str:
    return text_of(ElementTree.fromstring(render(drawing, "svg")))


def label(name: str) -> str:
    return next(state.label for state in chart().states if state.name == name)


def test_depth_counts_formulas() -> None:
    (one,) = drawn(depth=1)
    shown = text(one)
    assert "fetch" in shown and "2 activities" in shown
    assert "H" not in shown.split()
    (all_,) = drawn()
    assert "2 activities" not in text(all_)


def test_a_part_is_drawn_alone() -> None:
    (drawing,) = drawn(at=label("fetch"))
    assert drawing.name == f"iac.r.{label('fetch')}"
    assert "C" in text(drawing) and "F" not in text(drawing).split()
    assert drawn(at="fetch") == [drawing]
    with pytest.raises(NoSuchState, match="no state 9"):
        drawn(at="9")
    (nested,) = drawn(at=label("A"))
    assert nested.note.endswith("is not an OR state")


@pytest.mark.parametrize(("file", "name"), [("robocup/kouretes", "player"), ("hospital/hospital", "robot")])
def test_a_large_chart_is_divided_into_pages_that_lead_to_each_other(file: str, name: str) -> None:
    system = aseme_dsl.compile(EXAMPLES / f"{file}.aseme")
    chart = next(item for item in system.iacs if item.name == name)
    pages = draw_statechart(chart, Options(layout=Layout.COMPACT, page=PageSize.A4), system.activities)
    assert pages[0].name == f"iac.{name}" and len(pages) > 1
    leads = {}
    for page in pages:
        root = ElementTree.fromstring(render(page, "svg"))
        leads[f"{page.name}.svg"] = {link.get("href") for link in root.iter(f"{SVG}a")}
    first, *others = leads
    assert set().union(*leads.values()) == set(leads)
    assert all(first in leads[other] for other in others), "each page leads back to the first"
    assert not any(page in found for page, found in leads.items())


@pytest.mark.parametrize("size", kept(PageSize, lambda size: size is PageSize.A4))
@pytest.mark.parametrize(
    "file",
    kept(sorted(EXAMPLES.rglob("*.aseme")), lambda file: file.stem != "warehouse"),
    ids=lambda file: file.stem,
)
def test_every_chart_of_the_examples_fits_on_pages(file: Path, size: PageSize) -> None:
    if file.stem == "relief":
        pytest.skip("it is a part of another file")
    system = aseme_dsl.compile(file)
    for chart in system.statecharts:
        for page in divided(chart, system.activities, chart.root.label, size.room):
            for picture in (page.picture, *page.picture.texts):
                assert picture.width <= size.room[0] and picture.height <= size.room[1], chart.name
                assert faults(chart, picture, system.activities) == []


def test_the_smallest_text_has_11_px_on_screen_and_8_points_on_paper() -> None:
    assert min(SIZES.values()) == 11
    (drawing,) = drawn(page=PageSize.A4)
    sizes = [int(size) for size in re.findall(r"font-size:(\d+)px", render(drawing, "svg").decode())]
    assert sizes and min(sizes) == 11
    inch, paper = 72.0, PageSize.A4.paper
    assert paper is not None
    found = re.search(r'size="([\d.]+),([\d.]+)"', drawing.dot)
    assert found is not None
    assert 11 * float(found[1]) * inch / paper[0] == pytest.approx(8, abs=0.01)
    assert float(found[1]) * 25.4 == pytest.approx(297, abs=0.2)
    assert float(found[2]) * 25.4 == pytest.approx(210, abs=0.2)


def test_a_sign_without_a_text_leaves_the_other_texts_on_paper() -> None:
    file = EXAMPLES / "hospital" / "hospital.aseme"
    system = aseme_dsl.compile(file)
    chart = next(item for item in system.iacs if item.name == "robot")
    (drawing,) = draw_statechart(chart, Options(layout=Layout.COMPACT))
    lengths = [int(length) for length in re.findall(r"T \S+ \S+ -1 \d+ (\d+) -", drawing.dot)]
    assert len(lengths) > 3 and min(lengths) > 0, "Graphviz reads nothing behind an empty text"


def test_pages_have_what_the_whole_has() -> None:
    pages = drawn(page=PageSize.SCREEN)
    assert [item.name for item in pages] == ["iac.r"]
    shown = ElementTree.fromstring(render(pages[0], "svg"))
    places = sorted(int(place) for item in shown.iter() for place in item.get("data-t", "").split())
    assert places == list(range(len(chart().transitions)))


def test_a_closed_part_that_is_repeated_has_room_for_what_is_said_of_it() -> None:
    name = "rounds_of_all_players"
    control = f"repeat part : after(5s) / {name} = {name} + 1\n leave part : [{name} > 7]"
    chart = compiled(
        f"system S\nsrm r {{ var {name} : int = 0\n liveness {{ r = part+ . E  part = A . B . D }}\n"
        f"control r {{ {control} }} }}"
    ).iacs[0]
    picture = whole(chart, (), chart.root.label, 0).picture
    assert any(item.text == "3 activities, 6 states" for item in picture.elements if isinstance(item, Text))
    assert faults(chart, picture) == []


@pytest.mark.parametrize("size", list(PageSize))
def test_the_protocols_of_the_library_are_divided_by_participants(size: PageSize) -> None:
    file = Path(__file__).parents[2] / "examples" / "hospital" / "hospital.aseme"
    system = aseme_dsl.compile(file)
    chart = next(item for item in system.eacs if item.name == "resource")
    first, *others = draw_statechart(chart, Options(layout=Layout.COMPACT, page=size), system.activities)
    assert first.note == "" and others


def test_compact_drawings_are_written_in_all_formats() -> None:
    (drawing,) = drawn()
    assert render(drawing, "png").startswith(b"\x89PNG")
    assert b"_background" in render(drawing, "dot")
    if writes_pdf():
        assert render(drawing, "pdf").startswith(b"%PDF")


def test_the_texts_below_a_small_chart_on_a_page_are_as_wide_as_the_chart() -> None:
    guard = " && ".join(f"number_{n} > {n}" for n in range(12))
    variables = " ".join(f"var number_{n} : int = 0" for n in range(12))
    control = f"enter A : [{guard}]\n skip A : else"
    text = f"system S\nsrm r {{ {variables} liveness {{ r = [A] }} control r {{ {control} }} }}"
    (page,) = draw_statechart(compiled(text).iacs[0], Options(page=PageSize.SCREEN))
    assert page.size[0] < 700
