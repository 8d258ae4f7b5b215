"""Parts of statecharts that have no compact form: drawn nested in their place, and checked there too."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from itertools import islice
from pathlib import Path
from xml.etree import ElementTree

import pytest

from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.diagrams import Layout, Options, PageSize, draw_statechart, render, writes_pdf
from aseme_dsl.diagrams.compact.blocks import NotCompact
from aseme_dsl.diagrams.compact.check import faults
from aseme_dsl.diagrams.compact.elements import Form, Picture, Shape
from aseme_dsl.diagrams.compact.ink.svg import svg
from aseme_dsl.diagrams.compact.pages import whole
from aseme_dsl.diagrams.look.dot import Kind
from aseme_dsl.diagrams.look.inset import Outline, Part, Piece, Words
from aseme_dsl.diagrams.look.places import places
from aseme_dsl.diagrams.rendering.inset import region
from tests.diagrams.building import random_statechart
from tests.diagrams.drawn_svg import elements_of
from tests.diagrams.overlaps import hidden_texts
from tests.diagrams.texts import compiled

ODD = """\
system Odd
message Seen { int n }
topic eyes { state Seen }
srm robot {
  var tries : int = 0
  let near = eyes.state.Seen.n > 3
  liveness { robot = Start . (work || Report~)  work = Search . grab . (Walk | Kick)+  grab = Open . Close }
  activities { Search takes 30s  Walk takes 3s }
  control robot {
    0.3.2.1.2.2 -> 0.3.2.1.2.4 : after(10s)
  }
  control work {
    enter Walk : [near] / tries = tries + 1
    enter Kick : else
    repeat (Walk | Kick) : [tries < 3]
    leave (Walk | Kick) : else
    on grab : when [near] / tries = 0
  }
}
"""
"""Its formula `work` has an arrow by label, from the first activity to the last part."""


def odd(text: str = ODD) -> Statechart:
    return compiled(text).iacs[0]


def drawn(chart: Statechart) -> Picture:
    return whole(chart, (), chart.root.label, None, partial(region, chart)).picture


def nested(picture: Picture) -> list[Shape]:
    return [item for item in picture.elements if isinstance(item, Shape) and item.form is Form.NESTED]


def reread(chart: Statechart, picture: Picture) -> Picture:
    """What the finished SVG of a picture shows."""
    root = ElementTree.fromstring(svg(chart, picture))
    return replace(picture, elements=tuple(elements_of(root)))


def planted(picture: Picture) -> Iterator[tuple[str, Picture]]:
    """The picture with one fault each in a nested part."""
    for number, shape in enumerate(picture.elements):
        if isinstance(shape, Shape) and shape.inset is not None:
            for kind, pieces in _planted(shape.inset.pieces):
                wrong = replace(shape, inset=replace(shape.inset, pieces=pieces))
                yield (
                    kind,
                    replace(
                        picture, elements=(*picture.elements[:number], wrong, *picture.elements[number + 1 :])
                    ),
                )


def _planted(pieces: tuple[Piece, ...]) -> Iterator[tuple[str, tuple[Piece, ...]]]:
    lines = [number for number, item in enumerate(pieces) if item.kind is Kind.LINE]
    labels = [number for number, item in enumerate(pieces) if item.id[:1] == "t" and item.text]

    def changed(number: int, *new: Piece) -> tuple[Piece, ...]:
        return (*pieces[:number], *new, *pieces[number + 1 :])

    for number, item in enumerate(pieces):
        if item.id[:1] == "n":
            yield "state removed", changed(number)
    for place, number in enumerate(lines):
        item, other = pieces[number], pieces[lines[place - 1]]
        yield "line removed", changed(number)
        yield "line doubled", changed(number, item, item)
        yield "end moved", changed(number, replace(item, parts=tuple(map(_moved, item.parts))))
        headless = tuple(part for part in item.parts if not _is_head(part))
        if headless != item.parts:
            yield "head removed", changed(number, replace(item, parts=headless))
        if item.id.partition(".")[0] != other.id.partition(".")[0]:
            swapped = {number: replace(item, id=other.id), lines[place - 1]: replace(other, id=item.id)}
            yield "lines swapped", tuple(swapped.get(at, one) for at, one in enumerate(pieces))
    for place, number in enumerate(labels):
        item, other = pieces[number], pieces[labels[place - 1]]
        bare = tuple(part for part in item.parts if not isinstance(part, Words))
        yield "label removed", changed(number, replace(item, parts=bare))
        if item.text != other.text:
            texts = tuple(part for part in other.parts if isinstance(part, Words))
            yield "label exchanged", changed(number, replace(item, parts=(*bare, *texts)))


def _is_head(part: object) -> bool:
    return isinstance(part, Outline) and part.is_head


def _moved(part: Part) -> Part:
    """A line with its end elsewhere."""
    if not isinstance(part, Outline):
        return part
    points = [(x + 9, y + 17) for x, y in part.points]
    return replace(part, points=tuple(points) if part.is_head else (*part.points[:-1], points[-1]))


def test_a_nested_part_is_drawn_where_its_letters_are_wider(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fonts = Path("/usr/share/fonts/truetype/dejavu")
    if not fonts.is_dir():
        pytest.skip("the fonts of DejaVu are not installed: apt install fonts-dejavu-core")
    settings = tmp_path / "fonts.conf"
    settings.write_text(
        f"<fontconfig><dir>{fonts}</dir><cachedir>{tmp_path}</cachedir></fontconfig>", encoding="utf-8"
    )
    (usual,) = nested(drawn(odd()))
    monkeypatch.setenv("FONTCONFIG_FILE", str(settings))
    chart = odd(ODD.replace("robot", "b0b0b"))  # a drawing that was made before is not made again
    picture = drawn(chart)
    assert faults(chart, picture) == []
    (wide,) = nested(picture)
    assert usual.inset is not None and wide.inset is not None
    assert wide.inset.width > usual.inset.width


def test_a_part_that_is_no_formula_is_drawn_nested_in_its_place() -> None:
    chart = odd()
    picture = drawn(chart)
    assert faults(chart, picture) == []
    (part,) = nested(picture)
    assert chart.node(part.state).name == "work"
    assert part.inset is not None
    forms = [item.form for item in picture.elements if isinstance(item, Shape)]
    assert forms.count(Form.ACTIVITY) == 1 and forms.count(Form.PILL) == 1
    (drawing,) = draw_statechart(chart)
    assert drawing.note == (
        f"state {part.state} of iac.robot is drawn nested: state Search (0.3.2.1.2.2) has 2 ways onward"
    )


def test_every_fault_in_a_nested_part_is_noticed() -> None:
    chart = odd()
    finished = reread(chart, drawn(chart))
    assert faults(chart, finished) == []
    found = list(planted(finished))
    missed = [kind for kind, wrong in found if not faults(chart, wrong)]
    assert len(missed) <= len(found) / 100, (missed, len(found))


def test_a_finished_drawing_shows_the_transitions_of_its_nested_part_once() -> None:
    chart = odd()
    (drawing,) = draw_statechart(chart)
    root = ElementTree.fromstring(render(drawing, "svg"))
    shown = [int(place) for item in root.iter() for place in item.get("data-t", "").split()]
    staying = [place for place, item in enumerate(chart.transitions) if not item.changes_state]
    assert sorted([*shown, *staying]) == list(range(len(chart.transitions)))
    ids = [item.get("id") for item in root.iter() if item.get("id")]
    assert len(ids) == len(set(ids))
    sizes = re.findall(r"font-size:([\d.]+)px", drawing.picture)
    assert min(map(float, sizes)) >= 11
    assert hidden_texts(drawing.picture) == []


def test_a_nested_part_has_tips_names_and_places_in_the_source() -> None:
    team = compiled(ODD)
    (drawing,) = draw_statechart(team.iacs[0])
    root = ElementTree.fromstring(drawing.picture)
    by_name = {item.get("id"): item for item in root.iter() if item.get("id")}
    (way,) = (n for n, item in enumerate(team.iacs[0].transitions) if item.expression.events)
    line = by_name[f"t{way}"]
    assert line.get("aria-label") == "Search to (Walk | Kick)+: after(10s)"
    assert line.find("{http://www.w3.org/2000/svg}title") is not None
    span = places(team, drawing)[f"t{way}"]
    assert ODD[span.start : span.end].startswith("0.3.2.1.2.2 -> 0.3.2.1.2.4")
    assert {f"n{state.label}" for state in team.iacs[0].states if state.type is StateType.BASIC} <= set(
        by_name
    )


def test_without_graphviz_the_box_says_so(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("sysconfig.get_path", lambda name: str(tmp_path))
    chart = odd()
    (drawing,) = draw_statechart(chart)
    assert "is without the inside of state" in drawing.note
    assert "Graphviz, which would draw it nested, is not installed" in drawing.note
    said = "".join("".join(item.itertext()) for item in ElementTree.fromstring(drawing.picture).iter())
    assert "not drawn: " in said and "is not installed" in said.replace("\n", " ")


def test_a_nested_part_that_is_too_large_for_a_page_has_a_page_of_its_own() -> None:
    chart = odd()
    first, *others = draw_statechart(chart, Options(page=PageSize.A4))
    (other,) = others
    assert other.name == "iac.robot.0.3.2.1.2"
    assert f'<a href="{other.name}.svg">' in first.picture
    assert 'class="inset"' not in first.picture and 'class="inset"' in other.picture


def test_a_nested_part_is_in_pictures_of_other_formats() -> None:
    (drawing,) = draw_statechart(odd())
    assert "Kick" in drawing.dot and "after(10s)" in drawing.dot
    for format in ("png", "pdf") if writes_pdf() else ("png",):
        assert len(render(drawing, format)) > 1000


CHARTS = int(os.environ.get("COMPACT_CHARTS", "6"))


@pytest.mark.parametrize("first", range(0, CHARTS, 50))
def test_random_charts_with_arrows_by_label_are_drawn_rightly(first: int) -> None:
    count = parts = missed = 0
    for seed in range(first, min(first + 50, CHARTS)):
        chart = random_statechart(seed, size=8, extra=1)
        try:
            picture = drawn(chart)
        except NotCompact:
            continue
        finished = reread(chart, picture)
        assert faults(chart, finished) == [], seed
        parts += len(nested(picture))
        for _, wrong in islice(planted(finished), seed % 19, None, 19):
            count += 1
            missed += not faults(chart, wrong)
    assert parts and missed <= count / 100, (missed, count)


@pytest.mark.parametrize("seed", [22])
def test_a_nested_drawing_has_the_first_layout_whose_texts_are_under_no_line(seed: int) -> None:
    (drawing,) = draw_statechart(random_statechart(seed, size=8, extra=3), Options(layout=Layout.NESTED))
    assert hidden_texts(render(replace(drawing, wider=None), "svg")) != []
    assert hidden_texts(render(drawing, "svg")) == []
