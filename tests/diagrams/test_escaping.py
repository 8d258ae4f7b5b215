"""Names and texts come out of every drawing as they went in, whatever is in them."""

from __future__ import annotations

from dataclasses import replace

import pytest

from aseme_dsl.amola.sag import Actor, Goal, Sag
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.diagrams import Drawing, Expressions, draw_statechart, render
from aseme_dsl.diagrams.look.drawing import of_sheet
from aseme_dsl.diagrams.look.labels import wrapped
from aseme_dsl.diagrams.models import sag as sag_drawing
from tests.diagrams.building import SPAN, says, statechart
from tests.diagrams.pictures import Picture, by_graphviz

AWKWARD = [
    'a "quoted" word',
    "a <b>bold</b> & <i>",
    "back\\slash \\N \\G \\E \\T \\n \\l",
    "ends in a backslash\\",
    "two at the end\\\\",
    "<html>",
    "&amp; &#38; &lt;",
    "{a|b} [c] \\{",
    "]]> --> <!-- x",
    "'single' `back` $HOME %s {0}",
    "γκολ ναι, Tor!, ゴール, 🥅",
    "Ünïcödé «x» → ω",
]


def drawing_of_goal(text: str) -> Drawing:
    model = Sag((Actor("player", SPAN),), (Goal("score", "player", (), text, SPAN),))
    return of_sheet(sag_drawing.sheet(model, "sag"))


def without_blanks(text: str) -> str:
    return "".join(text.split())


@pytest.mark.parametrize("text", AWKWARD)
def test_a_requirement_is_shown_as_it_is(text: str) -> None:
    shown = Picture(render(drawing_of_goal(text), "svg"))
    assert without_blanks(shown.says("goal.0")) == without_blanks(f"score{text}")
    assert shown.tip("goal.0") == f"goal score: {text}"


@pytest.mark.parametrize("expressions", [Expressions.NUMBERED, Expressions.INLINE])
@pytest.mark.parametrize("text", AWKWARD)
def test_a_string_in_an_expression_is_shown_as_it_is_written(text: str, expressions: Expressions) -> None:
    chart = statechart("A . B", {("0.2", "0.3"): says(text)})
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    (compact,) = draw_statechart(chart)
    assert without_blanks(f'[name == "{escaped}"]') in without_blanks(Picture(render(compact, "svg")).text)
    for drawing in by_graphviz(chart, expressions=expressions):
        shown = Picture(render(drawing, "svg"))
        assert without_blanks(f'[name == "{escaped}"]') in without_blanks(shown.text)
        assert f'[name == "{escaped}"]' in shown.tip("t1")


@pytest.mark.parametrize("text", AWKWARD)
def test_a_state_may_have_any_name(text: str) -> None:
    plain = statechart("A . (B . C)")
    names = {"0.2": text, "0.3": text}
    nodes = tuple(replace(node, name=names.get(node.label, node.name)) for node in plain.states)
    chart = Statechart(text, "Test", "IAC", nodes, plain.transitions)
    (compact,) = draw_statechart(chart)
    assert without_blanks(text) in without_blanks(Picture(render(compact, "svg")).text)
    for drawing in by_graphviz(chart):
        shown = Picture(render(drawing, "svg"))
        assert without_blanks(text) in without_blanks(shown.says("n0.2"))
        assert without_blanks(text) in without_blanks(shown.says("n0.3"))


def test_what_xml_cannot_hold_is_made_visible() -> None:
    shown = Picture(render(drawing_of_goal("bell\x07 nul\x00 tab\t lone\ud800 \uffff"), "svg"))
    assert "bell␇ nul␀ tab␉ lone\ufffd \ufffd" in shown.says("goal.0")


def test_no_sign_turns_the_text_around_it() -> None:
    shown = Picture(render(drawing_of_goal("one \u202e two \u2066 three"), "svg"))
    assert "one \ufffd two \ufffd three" in shown.says("goal.0")


@pytest.mark.parametrize(
    ("text", "width", "lines"),
    [
        ("one two three", 7, ("one two", "three")),
        ("WalkTowardsOpponentGoal", 12, ("WalkTowards", "OpponentGoal")),
        ("a_very_long_name", 7, ("a_very_", "long_", "name")),
        ("/ start_timer(patience, 30min)", 17, ("/ start_timer(", "patience, 30min)")),
        ("[outcome(Consider) == yes]", 17, ("[outcome(", "Consider) == yes]")),
        ("xxxxxxxxxx", 4, ("xxxx", "xxxx", "xx")),
        ("", 5, ("",)),
        ("one\ntwo", 9, ("one", "two")),
    ],
)
def test_lines_break_where_words_join(text: str, width: int, lines: tuple[str, ...]) -> None:
    assert wrapped(text, width) == lines


def test_a_name_of_a_thousand_words_is_cut() -> None:
    name = " || ".join(f"Activity{n}" for n in range(1000))
    chart = statechart(" || ".join(f"Activity{n}" for n in range(3)))
    nodes = tuple(replace(n, name=name) if n.label == "0.2" else n for n in chart.states)
    for drawing in by_graphviz(replace(chart, states=nodes)):
        shown = Picture(render(drawing, "svg"))
        assert len(shown.says("n0.2").split("\n")[0]) < 40
        assert shown.says("n0.2").count("…") == 1
        assert name[:2000] in shown.tip("n0.2")
