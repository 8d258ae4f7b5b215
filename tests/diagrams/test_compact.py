"""The compact drawings of statecharts: right for the examples, and every planted fault is noticed."""

from __future__ import annotations

import contextlib
import os
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from itertools import islice
from pathlib import Path
from xml.etree import ElementTree

import pytest

import aseme_dsl
from aseme_dsl.amola.expression import Logic
from aseme_dsl.amola.statechart import Statechart, StateType, Transition
from aseme_dsl.diagrams import Layout, Options, draw_statechart, render
from aseme_dsl.diagrams.compact.blocks import NotCompact
from aseme_dsl.diagrams.compact.check import faults
from aseme_dsl.diagrams.compact.elements import Form, Line, Picture, Shape, Text
from aseme_dsl.diagrams.compact.ink.svg import svg
from aseme_dsl.diagrams.compact.layout import layout
from aseme_dsl.diagrams.compact.pages import divided, whole
from aseme_dsl.diagrams.compact.words import ICONS
from aseme_dsl.diagrams.look.labels import text_width
from tests.diagrams.drawn_svg import elements_of
from tests.diagrams.texts import TEAM, compiled
from tests.oracle.charts import text
from tests.oracle.choices import Choices
from tests.support.lanes import kept

EXAMPLES = Path(__file__).parents[2] / "examples"

SMALL = "system Small\nsrm r { liveness { r = %s } }\n"

FORMULAS = (
    "A",
    "A . B . C",
    "A | B . C",
    "[A] . B",
    "A* . B+",
    "(A | B)~",
    "A~ || B || (C . D)",
    "A || (B | C)+",
    "A [> B",
    "(A . B [> C) . D",
    "[(A . [B])*]",
)


def chart_of(text: str) -> Statechart:
    return compiled(text).iacs[0]


@cache
def example(name: str) -> tuple[Statechart, ...]:
    files = (EXAMPLES / name).glob("*.aseme")
    (main,) = (item for item in files if "\nsystem " in item.read_text(encoding="utf-8"))
    return aseme_dsl.compile(main).statecharts


@pytest.mark.parametrize("formula", FORMULAS)
def test_every_operator_is_drawn_rightly(formula: str) -> None:
    chart = chart_of(SMALL % formula)
    assert faults(chart, layout(chart)) == []


@pytest.mark.parametrize("name", sorted(folder.name for folder in EXAMPLES.iterdir()))
def test_the_charts_of_examples_are_drawn_rightly(name: str) -> None:
    for chart in example(name):
        picture = layout(chart)
        assert faults(chart, picture) == [], chart.name
        assert not any(isinstance(item, Shape) and item.form is Form.CLOSED for item in picture.elements)


def test_the_branches_of_an_interrupt_with_triggers_of_their_own_leave_side_by_side() -> None:
    control = " control r { enter B : after(1s)\n enter C : after(2s) } }"
    chart = chart_of((SMALL % "A [> (B | C)").replace("} }", "}" + control))
    assert faults(chart, layout(chart)) == []


def planted(picture: Picture) -> Iterator[tuple[str, Picture]]:
    """The picture with one fault each."""
    items = picture.elements
    lines = [number for number, item in enumerate(items) if isinstance(item, Line)]
    labels = [number for number, item in enumerate(items) if isinstance(item, Text) and item.of is not None]

    def changed(number: int, *new: Line | Text) -> Picture:
        return replace(picture, elements=(*items[:number], *new, *items[number + 1 :]))

    for place, number in enumerate(lines):
        line, other = items[number], items[lines[place - 1]]
        assert isinstance(line, Line) and isinstance(other, Line)
        yield "line removed", changed(number)
        yield "line doubled", changed(number, line, line)
        x, y = line.points[-1]
        yield "end moved", changed(number, replace(line, points=(*line.points[:-1], (x + 9, y + 17))))
        if line.chain != other.chain:
            swapped = list(items)
            swapped[number] = replace(line, chain=other.chain)
            swapped[lines[place - 1]] = replace(other, chain=line.chain)
            yield "lines swapped", replace(picture, elements=tuple(swapped))
    for place, number in enumerate(labels):
        label, before = items[number], items[labels[place - 1]]
        assert isinstance(label, Text) and isinstance(before, Text)
        yield "label removed", changed(number)
        if label.text != before.text:
            yield "label exchanged", changed(number, replace(label, text=before.text))


def reread(chart: Statechart, picture: Picture) -> Picture:
    """What the finished SVG of a picture shows."""
    root = ElementTree.fromstring(svg(chart, picture))
    return replace(picture, elements=tuple(elements_of(root)))


@pytest.mark.parametrize(
    "name",
    kept(sorted(file.name for file in EXAMPLES.iterdir() if file.is_dir()), lambda name: name < "d"),
)
def test_planted_faults_are_noticed_in_finished_drawings(name: str) -> None:
    missed: list[str] = []
    count = 0
    for chart in (*example(name), chart_of(TEAM)):
        finished = reread(chart, layout(chart))
        assert faults(chart, finished) == []
        step = int(os.environ.get("COMPACT_FAULTS", "2" if len(chart.states) < 40 else "19"))
        for kind, picture in islice(planted(finished), 0, None, step):
            count += 1
            if not faults(chart, picture):
                missed.append(f"{chart.name}: {kind}")
    assert count > 10
    assert len(missed) <= count / 100, missed


def test_a_sign_that_a_choice_is_tried_again_is_needed_and_not_invented() -> None:
    (chart,) = (item for item in example("goalie") if item.kind == "IAC")
    picture = layout(chart)
    (sign,) = (item for item in picture.elements if isinstance(item, Text) and item.text == "↻")
    without = tuple(item for item in picture.elements if item is not sign)
    assert faults(chart, replace(picture, elements=without)) != []
    elsewhere = replace(sign, x=sign.x + 300)
    assert faults(chart, replace(picture, elements=(*picture.elements, elsewhere))) != []


def test_a_row_of_a_table_stands_in_its_state() -> None:
    (chart,) = (item for item in example("hospital") if item.name == "robot")
    picture = layout(chart)
    row = next(
        item for item in picture.elements if isinstance(item, Text) and item.text.startswith("→ refuse")
    )
    below = tuple(replace(item, y=item.y + 400) if item is row else item for item in picture.elements)
    assert faults(chart, replace(picture, elements=below)) != []


def test_a_line_that_comes_to_a_state_has_a_head() -> None:
    (chart,) = (item for item in example("hospital") if item.name == "robot")
    picture = layout(chart)
    drawn = (StateType.BASIC, StateType.CONDITION)
    count = 0
    for line in (item for item in picture.elements if isinstance(item, Line) and item.chain):
        if chart.node(chart.transitions[line.chain[-1][0]].target).type in drawn and line.arrow:
            count += 1
            others = tuple(replace(item, arrow=False) if item is line else item for item in picture.elements)
            assert faults(chart, replace(picture, elements=others)) != [], line
    assert count > 10


SEEDS = range(int(os.environ.get("COMPACT_FIRST", "0")), int(os.environ.get("COMPACT_CHARTS", "2")))


@pytest.mark.parametrize("seed", SEEDS)
def test_random_charts_are_drawn_rightly_or_with_a_reason(seed: int) -> None:
    system = compiled(text(Choices(seed)))
    for chart in system.statecharts:
        with contextlib.suppress(NotCompact):
            pages = [whole(chart, system.activities, chart.root.label, depth) for depth in (None, 1)]
            if seed < 2 or seed % 10 == 0:  # they take most of the time
                pages += divided(chart, system.activities, chart.root.label, (600, 400))
            for page in pages:
                assert faults(chart, page.picture, system.activities) == []
                assert not re.search(f".[{ICONS}]", said(page.picture)), "a sign is drawn only in front"


@pytest.mark.parametrize(
    "first", range(SEEDS.start, SEEDS.stop, 50) if "COMPACT_CHARTS" in os.environ else ()
)
def test_planted_faults_are_noticed_in_random_charts(first: int) -> None:
    missed: list[str] = []
    count = 0
    for seed in range(first, min(first + 50, SEEDS.stop)):
        for chart in compiled(text(Choices(seed))).statecharts:
            with contextlib.suppress(NotCompact):
                finished = reread(chart, layout(chart))
                assert faults(chart, finished) == [], seed
                for kind, picture in islice(planted(finished), seed % 7, None, len(finished.elements)):
                    count += 1
                    if not faults(chart, picture):
                        missed.append(f"{seed}, {chart.name}: {kind}")
    assert len(missed) <= count / 100, missed


def test_the_svg_shows_each_transition_once_and_no_text_on_another() -> None:
    (chart,) = (item for item in example("cell") if item.kind == "IAC")
    (drawing,) = draw_statechart(chart, Options(layout=Layout.COMPACT))
    root = ElementTree.fromstring(render(drawing, "svg"))
    shown = sorted(int(place) for item in root.iter() for place in item.get("data-t", "").split())
    assert shown == list(range(len(chart.transitions)))
    assert root.get("role") == "graphics-document document"
    boxes = []
    for item in root.iter("{http://www.w3.org/2000/svg}text"):
        x, y, width = float(item.get("x", "")), float(item.get("y", "")), text_width(item.text or "", 12)
        boxes.append((x, y - 9, x + width, y + 2))
    for place, one in enumerate(boxes):
        for other in boxes[place + 1 :]:
            apart = one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]
            assert apart, (one, other)


def test_a_drawing_is_the_same_each_time() -> None:
    options = Options(layout=Layout.COMPACT)
    chart = chart_of(TEAM)
    assert draw_statechart(chart, options) == draw_statechart(chart_of(TEAM), options)


def test_a_chart_that_is_no_formula_is_drawn_nested_with_the_reason() -> None:
    chart = chart_of(SMALL % "A . B . C")
    first, *others = chart.transitions
    odd = replace(first, target=chart.transitions[-1].target, priority=1)
    other = replace(chart, transitions=(first, odd, *others))
    with pytest.raises(NotCompact, match="2 ways onward"):
        layout(other)
    (drawing,) = draw_statechart(other, Options(layout=Layout.COMPACT))
    assert not drawing.picture
    assert "is drawn nested" in drawing.note


def shapes(picture: Picture, form: Form) -> list[str]:
    return [item.state for item in picture.elements if isinstance(item, Shape) and item.form is form]


def said(picture: Picture) -> str:
    return "\n".join(item.text for item in picture.elements if isinstance(item, Text))


def test_a_region_that_repeats_one_activity_is_a_pill_in_document_order() -> None:
    chart = chart_of(SMALL % "A~ || B~ || (C . D) || E~")
    picture = layout(chart)
    assert faults(chart, picture) == []
    assert [chart.node(label).name for label in shapes(picture, Form.PILL)] == ["A", "B", "E"]
    rows = {item.text: item.y for item in picture.elements if isinstance(item, Text)}
    assert rows["A"] == rows["B"] < rows["C"] < rows["E"]


def test_equal_regions_are_drawn_once() -> None:
    chart = chart_of(SMALL % "(A . B)[4]")
    picture = layout(chart)
    assert faults(chart, picture) == []
    assert len(shapes(picture, Form.ACTIVITY)) == 2
    assert "× 4" in said(picture)
    other = replace(picture, copies=(picture.copies[0][:-1],))
    assert faults(chart, other) != []


def test_a_formula_that_is_one_frame_has_one_border() -> None:
    text = "system S\nsrm r { liveness { r = A . part . D  part = B || C } }"
    chart = chart_of(text)
    picture = layout(chart)
    assert faults(chart, picture) == []
    assert len(shapes(picture, Form.PARALLEL)) == 1 and shapes(picture, Form.FRAME) == []
    assert "part" in said(picture)


def test_what_is_never_taken_stands_at_the_sign_of_what_never_ends() -> None:
    chart = chart_of(SMALL % "A . (B . C)~")
    (sign,) = (
        item for item in layout(chart).elements if isinstance(item, Shape) and item.form is Form.ENDLESS
    )
    assert [chart.transitions[place].target for place in sign.marks] == [chart.end_of("0").label]  # type: ignore[union-attr]


def test_the_rank_is_written_where_a_state_may_be_repeated_or_left() -> None:
    control = "repeat A : [n > 1]\n leave A : [n > 0]"
    text = f"system S\nsrm r {{ var n : int = 0  liveness {{ r = A+ . B }} control r {{ {control} }} }}"
    shown = said(layout(chart_of(text)))
    assert "1: [n > 1]" in shown and "2: [n > 0]" in shown
    plain = text.replace("leave A : [n > 0]", "leave A : else")
    assert "1: " not in said(layout(chart_of(plain)))


def test_long_texts_stand_below_in_full() -> None:
    guard = " && ".join(f"number_{n} > {n}" for n in range(12))
    variables = " ".join(f"var number_{n} : int = 0" for n in range(12))
    control = f"enter A : [{guard}]\n skip A : else"
    text = f"system S\nsrm r {{ {variables} liveness {{ r = [A] }} control r {{ {control} }} }}"
    chart = chart_of(text)
    picture = layout(chart)
    assert faults(chart, picture) == []
    assert "… (1)" in said(picture) and "(1)\n" in said(picture)
    assert "number_11 > 11" in said(picture)


def test_a_part_that_is_no_formula_is_a_box_that_says_why() -> None:
    chart = chart_of(SMALL % "A . ((B . C) || D)")
    odd = next(item for item in chart.transitions if chart.node(item.source).name == "B")
    extra = replace(odd, target=odd.source.rsplit(".", 1)[0] + ".4", priority=1)
    other = replace(chart, transitions=(*chart.transitions, extra))
    picture = layout(other)
    assert faults(other, picture) == []
    (box,) = shapes(picture, Form.CLOSED)
    assert other.node(box).type is StateType.OR
    assert "2 ways\nonward" in said(picture)


@pytest.mark.parametrize("inner", ["%s", "(%s)~ || Z", "Z . (%s | Y)+ . X", "(%s [> Z)~"])
def test_a_long_line_goes_on_in_rows_below(inner: str) -> None:
    names = " . ".join(f"Activity{number}" for number in range(200))
    chart = chart_of(SMALL % (inner % f"({names})"))
    picture = layout(chart)
    assert faults(chart, picture) == []
    assert picture.width <= 1920
    rows = {item.text: item.y for item in picture.elements if isinstance(item, Text)}
    assert rows["Activity0"] == rows["Activity1"] < rows["Activity30"] < rows["Activity59"]


def test_a_guard_changes_nothing_outside_its_region() -> None:
    text = (
        "system S\nsrm r { var n : int = 0  liveness { r = one || two  one = (A . [B])~  two = (C . [D])~ }\n"
        "control one { enter B : [n > 0]\n skip B : else }\n"
        "control two { enter D : [%s]\n skip D : else } }"
    )
    before = layout(chart_of(text % "n > 0"))
    after = layout(chart_of(text % " && ".join(f"n > {number}" for number in range(20))))
    assert after.height > before.height

    def first_region(picture: Picture) -> list[Text]:
        items = [item for item in picture.elements if isinstance(item, Text)]
        (second,) = (item.y for item in items if item.text == "two")
        return [item for item in items if item.y < second]

    assert first_region(before) == first_region(after)


def rows(chart: Statechart, picture: Picture) -> dict[str, list[object]]:
    """What is drawn in each outermost region, seen from its top; pills stand in one row and move along it."""
    found: dict[str, list[tuple[str, tuple[tuple[float, float], ...]]]] = {}
    for item in picture.elements:
        match item:
            case Shape() if item.form not in (Form.PARALLEL, Form.FIELD, Form.STACK, Form.PILL):
                state, points = item.state, ((item.x, item.y),)
            case Line() if item.chain:
                state, points = chart.transitions[item.chain[0][0]].source, item.points
            case Text(of=int(place)):
                state, points = chart.transitions[place].source, ((item.x, item.y),)
            case _:
                continue
        if region := outermost(chart, state):
            found.setdefault(region, []).append((type(item).__name__ + state, points))
    tops = {region: min(y for _, points in items for _, y in points) for region, items in found.items()}
    return {
        region: sorted(
            (name, tuple((round(x, 1), round(y - tops[region], 1)) for x, y in points))
            for name, points in items
        )
        for region, items in found.items()
    }


def outermost(chart: Statechart, label: str) -> str:
    around = [label, *(item.label for item in chart.ancestors(label))]
    return next((item for item in reversed(around) if item != chart.root.label and chart.is_region(item)), "")


def edited(chart: Statechart) -> Iterator[tuple[set[str], Statechart]]:
    """The chart with one activity renamed, longer or shorter, or one guard four times as long; and where."""
    for activity in dict.fromkeys(item.activity for item in chart.states if item.activity is not None):
        for name in (f"{activity}WithMoreWords", activity[:2]):
            states = [
                replace(item, name=name, activity=name) if item.activity == activity else item
                for item in chart.states
            ]
            places = {item.label for item in chart.states if item.activity == activity}
            yield places, replace(chart, states=tuple(states))
    for item in chart.transitions:
        guard = item.expression.condition
        if guard is not None:
            longer = Logic("&&", (guard,) * 4, guard.span)
            new = replace(item, expression=replace(item.expression, condition=longer))
            same = [other for other in chart.transitions if other.expression == item.expression]
            others = (replace(new, **ends(other)) if other in same else other for other in chart.transitions)
            yield {other.source for other in same}, replace(chart, transitions=tuple(others))


def ends(item: Transition) -> dict[str, str]:
    return {"source": item.source, "target": item.target}


@pytest.mark.parametrize("name", ["auction", "hospital", "meetings", "patrol", "robocup", "warehouse"])
def test_an_edit_changes_no_row_and_no_column_outside_its_region(name: str) -> None:
    step = int(os.environ.get("COMPACT_EDITS", "149"))
    count = 0
    for chart in example(name):
        before = rows(chart, layout(chart))
        if len(before) < 2:
            continue
        for labels, new in islice(edited(chart), 0, None, step):
            after = rows(new, layout(new))
            count += 1
            for region in before.keys() - {outermost(chart, label) for label in labels}:
                assert after[region] == before[region], (chart.name, labels, region)
    assert count


def test_two_transitions_without_a_word_between_two_states_are_both_shown() -> None:
    chart = chart_of("system S\nsrm r { liveness { r = part . B  part = A } }")
    place = next(n for n, item in enumerate(chart.transitions) if chart.node(item.target).name == "A")
    twice = replace(chart.transitions[place], priority=1)
    other = replace(chart, transitions=(*chart.transitions, twice))
    assert faults(other, layout(other)) == []


def test_what_interrupts_a_frame_has_its_sign_in_a_table_too() -> None:
    exits = "\n".join(f"leave part : when [n > {number}]" for number in range(5))
    control = f"control r {{ repeat part : else\n {exits} }}"
    text = "system S\nsrm r { var n : int = 0\n liveness { r = part+ . C  part = A . B }\n %s }"
    chart = chart_of(text % control)
    picture = layout(chart)
    assert faults(chart, picture) == []
    signs = [item for item in picture.elements if isinstance(item, Text) and item.text.startswith("↯")]
    assert len(signs) == 5
    (frame,) = (item for item in picture.elements if isinstance(item, Shape) and item.form is Form.FRAME)
    assert all(frame.y < item.y < frame.y + frame.height for item in signs)


def test_a_page_is_only_as_wide_as_its_chart_and_its_texts() -> None:
    control = "control r { enter B : [t.state.M.n > 1] }"
    text = "system S\nmessage M { int n }\ntopic t { state M }\nsrm r { liveness { r = A . B } %s }"
    assert layout(chart_of(text % control)).width < 400


def test_an_activity_that_is_all_of_a_chart_and_repeats_has_the_sign_of_what_never_ends() -> None:
    chart = chart_of(SMALL % "A~")
    picture = layout(chart)
    assert faults(chart, picture) == []
    assert len(shapes(picture, Form.ENDLESS)) == 1


def test_a_loop_that_events_leave_has_no_sign_of_what_never_ends() -> None:
    control = "repeat part : [n > 1]\n leave part : when [n > 2]"
    formulas = "r = part+ . C  part = A . B"
    chart = chart_of(
        f"system S\nsrm r {{ var n : int = 0\n liveness {{ {formulas} }}\n control r {{ {control} }} }}"
    )
    picture = layout(chart)
    assert faults(chart, picture) == []
    assert shapes(picture, Form.ENDLESS) == []


def spoken(text: str) -> list[str]:
    """What a screen reader says of the drawing, in its order."""
    (drawing,) = draw_statechart(chart_of(text))
    root = ElementTree.fromstring(render(drawing, "svg"))
    found = [root.get("aria-label", "")]
    for item in root:
        if item.get("role") == "img":
            title = item.find("{http://www.w3.org/2000/svg}title")
            found.append(item.get("aria-label") or (title.text or "" if title is not None else ""))
        elif not item.get("aria-hidden") and item.text and item.tag.endswith("}text"):
            found.append(item.text)
    return found


def test_a_screen_reader_says_each_state_and_then_the_lines_that_leave_it() -> None:
    said = spoken(
        "system S\nsrm r { var n : int = 0  liveness { r = part || (D | E)~  part = A . B }\n"
        "control r { enter D : [n > 1]\n enter E : else } }"
    )
    assert said[:3] == ["IAC r of S", "r", "IAC of S: 23 states, 16 transitions"]
    assert "parallel regions part || (D | E)~" in said
    first = said.index("activity A, in part")
    assert said[first + 1 : first + 3] == ["A to B: when complete", "activity B, in part"]
    assert said.index("region 2 of part || (D | E)~") > said.index("activity B, in part")
    choice = said.index("choice of (D | E)")
    assert said[choice + 1 : choice + 3] == [
        "choice of (D | E) to D: [n > 1]",
        "choice of (D | E) to E: else",
    ]
    assert "[n > 1]" not in said, "the text at a line is said with it"
    assert all(said)


def test_a_screen_reader_says_words_for_signs_and_what_stays_in_a_state() -> None:
    said = spoken(
        'system S\nsrm r { var n : int = 0 var s : string = ""  liveness { r = work [> C  work = A . B }\n'
        'control r { enter C : when [n > 1 && s != "&&" && !(n == 3)]\n'
        'on work : e / n = 2\n on A : [n > 2] / s = "x" } }'
    )
    assert "group work; on e / n = 2" in said
    assert 'activity A, in work; on [n > 2] / s = "x"' in said
    assert 'work to C: at once, when [n > 1 and s != "&&" and not (n == 3)]' in said
    assert "B to end of r: when complete" in said
    assert not re.search(r"\d\.\d|→", "".join(said)), "no labels of states, no arrows"


def test_a_screen_reader_says_a_frame_before_what_is_inside_and_after_what_is_before_it() -> None:
    said = spoken("system S\nsrm r { liveness { r = A . work . E  work = B . inner  inner = C || D } }")
    order = [
        "activity A",
        "group work",
        "activity B, in work",
        "parallel regions inner",
        "activity C, in inner",
        "activity E",
    ]
    assert [item for item in said if item in order] == order


@pytest.mark.parametrize("name", ["hospital", "robocup"])
def test_a_screen_reader_finds_each_activity_and_each_line_of_a_large_chart(name: str) -> None:
    for chart in example(name):
        (drawing,) = draw_statechart(chart)
        root = ElementTree.fromstring(render(drawing, "svg"))
        named = {item for item in root.iter() if item.get("role") == "img"}
        for item in root.iter():
            kinds = item.get("class", "").split()
            title = item.find("{http://www.w3.org/2000/svg}title")
            if item.get("aria-hidden"):  # a frame, which is read before what is inside it
                assert item.get("data-n") or "state" not in kinds
            elif "state" in kinds or ("line" in kinds and item.get("data-t")):
                assert item in named and (item.get("aria-label") or (title is not None and title.text))
