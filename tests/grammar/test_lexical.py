"""Comments, names, numbers, texts, blanks and line ends."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.grammar.text import tree
from tests.grammar.reading import ACCEPTANCE, condition, declared, mistakes, nodes, places, read, short


def test_an_empty_file_is_a_file() -> None:
    for text in ("", "\n\n", "// only a comment", "\ufeff", "\ufeff\r\n/* x */\r\n"):
        assert read(text).declarations == ()


def test_comments_are_kept_with_their_marks_and_places() -> None:
    text = '// one\nsystem /* two\n lines */ A // three\r\n/**/// "no text"\n'
    file = read(text)
    assert [comment.text for comment in file.comments] == [
        "// one",
        "/* two\n lines */",
        "// three",
        "/**/",
        '// "no text"',
    ]
    assert all(comment.span.text == comment.text for comment in file.comments)


def test_comments_stand_between_any_tokens() -> None:
    text = "srm a { liveness { a /* x */ = // y\n A /**/ . B /* c */ d /* x */ = C } }"
    assert short(declared(text).formulas) == (("NamedFormula", "a", "A . B"), ("NamedFormula", "d", "C"))


def test_marks_of_comments_mean_nothing_in_texts() -> None:
    assert short(declared('sag { actor a { goal g "// no /* comment */" } }').actors[0].goals[0]) == (
        "Goal",
        "g",
        (),
        '"// no /* comment */"',
    )


def test_texts_have_their_escapes_resolved() -> None:
    text = r'import "a\\b\"c"'
    target = declared(text).target
    assert target.text == 'a\\b"c'
    assert target.span.text == r'"a\\b\"c"'


def test_a_byte_order_mark_and_either_line_end_change_no_place() -> None:
    text = "system A\nenum B { C }\n"
    for variant in (text, text.replace("\n", "\r\n"), "\ufeff" + text):
        names = [node for node in nodes(read(variant)) if isinstance(node, tree.Name)]
        assert sorted(name.text for name in names) == ["A", "B", "C"]
        assert all(name.span.text == name.text for name in names)


@pytest.mark.parametrize("path", ACCEPTANCE, ids=lambda path: path.stem)
def test_everything_knows_where_it_stands(path: Path) -> None:
    text = path.read_text("utf-8")
    for node in nodes(read(text)):
        assert 0 <= node.span.start < node.span.end <= len(text)
        assert not node.span.text[0].isspace() and not node.span.text[-1].isspace()
        if isinstance(node, tree.Name):
            assert node.span.text == node.text
        elif isinstance(node, tree.Text):
            assert node.span.text == f'"{node.text}"'
        elif isinstance(node, tree.Duration | tree.Number | tree.Path):
            assert node.span.text[0].isalnum() and node.span.text[-1].isalnum()


@pytest.mark.parametrize(
    ("text", "nanoseconds"),
    [
        ("200ms", 200_000_000),
        ("1.5s", 1_500_000_000),
        ("2min", 120_000_000_000),
        ("0s", 0),
        ("0.000000001s", 1),
        ("0.1ms", 100_000),
        ("001.50s", 1_500_000_000),
    ],
)
def test_durations_are_whole_nanoseconds(text: str, nanoseconds: int) -> None:
    value = condition(f"{text}")
    assert isinstance(value, tree.Duration)
    assert value.nanoseconds == nanoseconds


@pytest.mark.parametrize(("text", "value"), [("12", 12), ("1.5", 1.5), ("0", 0), ("007", 7), ("2.0", 2.0)])
def test_numbers(text: str, value: float) -> None:
    number = condition(text)
    assert isinstance(number, tree.Number)
    assert number.value == value
    assert type(number.value) is type(value)


@pytest.mark.parametrize(
    "text",
    ["200 ms", "5h", "10sec", "12abc", "1e5", "1.2.3", "0.0000000001s", "9" * 5000, "9" * 30 + "ms"],
)
def test_malformed_numbers(text: str) -> None:
    assert places(f"let x = {text[:60]}") in (["E108 1:9"], ["E108 1:10"])


@pytest.mark.parametrize(("text", "meant"), [("1h", "60min"), ("1.5hours", "90min"), ("2us", "0.002ms")])
def test_another_unit_of_time_has_the_same_duration_in_its_hint(text: str, meant: str) -> None:
    [mistake] = mistakes(f"srm a {{ activities {{ A takes {text} }} }}")
    assert (mistake.code, mistake.hint) == ("E108", f"write {meant}")


def test_a_blank_before_a_unit_has_a_fix_everywhere() -> None:
    clause = "topic t { state M every 33 ms }"
    activity = "srm a { activities { A every 33 ms } }"
    event = "srm a { control a { enter A : after(33 ms) } }"
    for text in (clause, activity, event):
        [mistake] = mistakes(text)
        assert (mistake.code, mistake.fix) == ("E108", "33ms")
        assert mistake.span is not None and mistake.span.text == "33 ms"


def test_labels_keep_their_text() -> None:
    chart = declared("statechart C { state 0 OR state 0.10 BASIC A state 0.1 START 0.1 -> 0.10 : }")
    assert [node.label.text for node in chart.nodes] == ["0", "0.10", "0.1"]
    assert (chart.transitions[0].source.text, chart.transitions[0].targets[0].text) == ("0.1", "0.10")


def test_blanks_around_the_points_of_a_path_mean_nothing() -> None:
    assert short(condition("vision . state\n.Ball/* */.\n x > 1")) == "(vision.state.Ball.x > 1)"


def test_names_are_ascii() -> None:
    for text, fix in (("VisionΩ", "Vision~"), ("größe", None), ("Δx", None)):
        [mistake] = mistakes(f"srm a {{ liveness {{ a = A . {text} . B }} }}")
        assert (mistake.code, mistake.fix) == ("E105", fix)
        assert mistake.span is not None and mistake.span.text == text


@pytest.mark.parametrize("odd", ["§", "$", "\0", "\u00a0", "\ud800", "😀", "¬", "–", "\f", "`"])
def test_odd_characters_are_told_once_and_where(odd: str) -> None:
    assert places(f"system A\n  {odd} enum B {{ C }}\n") == ["E105 2:3"]


def test_typographic_characters_have_a_fix() -> None:
    fixes = {"“a”": '"a"', "'a'": '"a"', "≤": "<=", "≠": "!=", "∧": "&&"}
    for written, fix in fixes.items():
        expression = f"a {written} b" if len(written) == 1 else written
        [mistake] = mistakes(f"let x = {expression}")
        assert (mistake.code, mistake.fix) == ("E105", fix)


def test_an_unknown_escape() -> None:
    assert places(r'import "a\n"') == ["E105 1:10"]


def test_an_unclosed_text_ends_with_its_line() -> None:
    assert places('aip a {\n  outcome "one\n  outcome "two"\n  outcome three\n}') == [
        "E104 2:11",
        "E100 4:11",
    ]


def test_an_unclosed_text_leaves_the_braces_behind_it() -> None:
    assert places('sag { actor a { goal b "x } }\nsag { }') == ["E104 1:24"]


def test_an_unclosed_comment_is_one_mistake() -> None:
    assert places("aip a {\n  /* here\n  outcome 3 }\n") == ["E110 2:3"]


def test_language_stands_first() -> None:
    number = read("// c\nlanguage 1\nsystem A").language
    assert number is not None and (number.value, number.span.line) == (1, 2)
    assert read("system A").language is None
    assert places("system A\nlanguage 1") == ["E100 2:1"]
