"""How a problem looks on a terminal and as JSON."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator

import pytest

from aseme_dsl.diagnostics import (
    CODES,
    Related,
    closest,
    has_errors,
    in_order,
    render_json,
    render_text,
)
from aseme_dsl.source import Source, Span
from tests.support.worded import worded

SOURCE = Source("team.aseme", "srm player {\n\tleiveness { 球 = A }\n}\n")


def span(text: str, source: Source = SOURCE) -> Span:
    start = source.text.index(text)
    return Span(source, start, start + len(text))


def test_the_place_is_underlined_below_tabs_and_wide_characters() -> None:
    problem = worded(
        "E100",
        "expected `liveness`",
        span("leiveness"),
        (Related(span("player"), "in this role"),),
        "`liveness`",
    )
    wide = worded("E105", "a name is made of ASCII letters", span("球"))
    assert render_text([problem, wide]) == (
        "team.aseme:2:2: error[E100]: expected `liveness`\n"
        " 2 |     leiveness { 球 = A }\n"
        "   |     ^^^^^^^^^\n"
        "   team.aseme:1:5: in this role\n"
        " 1 | srm player {\n"
        "   |     ------\n"
        "   hint: `liveness`\n"
        "\n"
        "team.aseme:2:14: error[E105]: a name is made of ASCII letters\n"
        " 2 |     leiveness { 球 = A }\n"
        "   |                 ^^\n"
    )


def test_every_line_of_a_hint_is_indented() -> None:
    problem = worded("N701", "not written yet", span("player"), hint="start from\naip attack {\n}")
    assert render_text([problem]).splitlines()[-3:] == [
        "   hint: start from",
        "         aip attack {",
        "         }",
    ]


def test_a_very_long_line_is_cut_around_the_place() -> None:
    source = Source("long.aseme", "x" * 5000 + "HERE" + "y" * 5000)
    lines = render_text([worded("E100", "no", span("HERE", source))]).splitlines()
    assert max(map(len, lines)) < 220
    column = lines[2].index("^")
    assert lines[1][column : column + 4] == "HERE"


def test_of_several_lines_the_first_and_the_last_are_shown() -> None:
    source = Source("team.aseme", "".join(f"line {n}\n" for n in range(1, 12)))
    long = worded("W300", "long", Span(source, 62 - 6, 62 + 14))
    assert render_text([long]) == (
        "team.aseme:9:1: warning[W300]: long\n"
        "  9 | line 9\n"
        "    | ^^^^^^\n"
        "    | …\n"
        " 11 | line 11\n"
        "    | ^^^^^\n"
    )
    assert "line 2" not in render_text([worded("W300", "to the end of its line", Span(source, 0, 7))])


def test_nothing_in_a_file_moves_the_cursor() -> None:
    source = Source("odd.aseme", "a \x1b[31m\r \u202e \x00 e\u0301 HERE\n")
    text = render_text([worded("E100", "no", span("HERE", source))])
    assert text.replace("\n", "").isprintable()
    line, mark = (item.split(" | ")[1] for item in text.splitlines()[1:])
    assert line.replace("\u0301", "")[mark.index("^") :] == "HERE"


def test_a_code_is_a_link_to_its_page_on_a_terminal() -> None:
    pages = {"W300": "file:///pages/W300.md"}
    text = render_text([worded("W300", "mixed", None), worded("W301", "never", None)], link=pages.get)
    assert text == (
        "<input>: warning[\x1b]8;;file:///pages/W300.md\x1b\\W300\x1b]8;;\x1b\\]: mixed\n"
        "\n"
        "<input>: warning[W301]: never\n"
    )


def test_a_file_that_cannot_be_read_has_no_line() -> None:
    problem = worded("E001", "no such file", None, path="nowhere.aseme")
    assert render_text([problem]) == "nowhere.aseme: error[E001]: no such file\n"


def test_colour_is_only_added() -> None:
    problem = worded("W300", "mixed", span("A"))
    coloured = render_text([problem], colour=True)
    assert "\x1b[33;1mwarning[W300]\x1b[0m" in coloured


def test_json_has_the_range() -> None:
    (item,) = render_json([worded("E100", "no", span("A"), fix="B")])
    assert item["severity"] == "error"
    assert item["fix"] == "B"
    assert item["edits"] == [{"place": item["place"], "text": "B"}]
    assert item["place"] == {"file": "team.aseme", "line": 2, "column": 18, "end_line": 2, "end_column": 19}


def test_problems_are_in_the_order_of_the_text_and_once() -> None:
    first = worded("E100", "one", span("player"))
    second = worded("W300", "two", span("A"))
    assert in_order([second, first, second]) == (first, second)
    assert has_errors([second, first])
    assert not has_errors([second])


def test_an_unknown_code_is_our_mistake() -> None:
    with pytest.raises(ValueError, match="unknown diagnostic code"):
        worded("E999", "no", None)


def test_every_code_has_a_severity_that_its_letter_says() -> None:
    letters = {"E": "error", "W": "warning", "N": "note"}
    assert all(letters[code[0]] == item.severity for code, item in CODES.items())


@pytest.mark.parametrize(
    ("name", "known", "expected"),
    [
        ("wordl", ["world", "vision"], "world"),
        ("walktowardsball", ["WalkTowardsBall", "KickBall"], "WalkTowardsBall"),
        ("kick_ball", ["KickBall"], "KickBall"),
        ("zzz", ["world"], None),
        ("world", [], None),
    ],
)
def test_did_you_mean(name: str, known: list[str], expected: str | None) -> None:
    assert closest(name, known) == expected


LONG = "f(x); " * 20 + "HERE" + " + g(y)" * 20
WIDE = "日本" * 40 + "\tHERE" + "é" * 90


@pytest.mark.parametrize("text", [LONG, WIDE, "HERE" + " x" * 90, " x" * 90 + "HERE", "x " + "HERE" * 60])
@pytest.mark.parametrize("columns", [30, 80, 81, 120])
def test_lines_are_cut_to_the_width_of_the_terminal(text: str, columns: int) -> None:
    source = Source("wide.aseme", text + "\n")
    place = Span(source, text.index("HERE"), text.rindex("HERE") + 4)
    shown = render_text([worded("E100", "no", place)], columns=columns)
    _, line, marks = shown.splitlines()
    assert columns_of(line) <= columns and columns_of(marks) <= columns
    assert "…" in line and "\t" not in line
    begin = columns_of(marks[: marks.index("^")])
    marked = "".join(char for at, char in placed(line) if begin <= at < begin + marks.count("^"))
    assert marked == "HERE" if "HEREHERE" not in text else marked.startswith("HEREHERE")


def columns_of(text: str) -> int:
    return sum(2 if unicodedata.east_asian_width(char) in "WF" else 1 for char in text)


def placed(text: str) -> Iterator[tuple[int, str]]:
    """Each character with the column in which it begins."""
    at = 0
    for char in text:
        yield at, char
        at += columns_of(char)


def test_a_short_line_stays_as_it_is() -> None:
    problem = worded("W300", "mixed", span("A"))
    assert render_text([problem], columns=80) == render_text([problem])
