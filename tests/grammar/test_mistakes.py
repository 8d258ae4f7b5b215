"""What the parser says of mistakes: every text in `mistakes/` with its diagnostics in `snapshots/`.

In these texts a line that is marked with `//!` has one mistake, and the others have none.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from aseme_dsl.diagnostics import render_text
from aseme_dsl.grammar import parse
from aseme_dsl.source import Source
from tests.grammar.reading import mistakes, read

TEXTS = sorted((Path(__file__).parent / "mistakes").glob("*.aseme"))
MARKED = [path for path in TEXTS if "//!" in path.read_text("utf-8")]


@pytest.mark.parametrize("path", TEXTS, ids=lambda path: path.stem)
def test_messages(path: Path, snapshot: Callable[[str, str], None]) -> None:
    _, diagnostics = parse(Source(path.name, path.read_text("utf-8")))
    snapshot(render_text(diagnostics), f"{path.stem}.txt")


@pytest.mark.parametrize("path", MARKED, ids=lambda path: path.stem)
def test_every_mistake_is_told_once_on_its_line(path: Path) -> None:
    text = path.read_text("utf-8")
    marked = [number for number, line in enumerate(text.split("\n"), 1) if "//!" in line]
    assert [item.span.line for item in mistakes(text) if item.span] == marked


@pytest.mark.parametrize("path", MARKED, ids=lambda path: path.stem)
def test_what_is_right_beside_mistakes_is_read(path: Path) -> None:
    """Every declaration that has begun rightly is in the tree, with its right entries."""
    text = path.read_text("utf-8")
    file, _ = parse(Source(path.name, text))
    read_kinds = [type(item).__name__.lower() for item in file.declarations]
    for word in ("sag", "suc", "aip", "srm", "team", "statechart"):
        assert read_kinds.count(word) == sum(line.startswith(word + " ") for line in text.split("\n"))


def test_one_mistake_at_a_time() -> None:
    """Each marked line alone in an otherwise right block is one mistake, too."""
    control = (Path(__file__).parent / "mistakes" / "control.aseme").read_text("utf-8").split("\n")
    formulas = (Path(__file__).parent / "mistakes" / "formulas.aseme").read_text("utf-8").split("\n")
    for line in (line for line in control if "//!" in line):
        text = f"srm a {{\n control a {{\n  enter X : [x]\n{line}\n  leave X : / x = 1\n }}\n}}\nsystem A\n"
        assert [item.span.line for item in mistakes(text) if item.span] == [4], line
    for line in (line for line in formulas if "//!" in line):
        text = f"srm a {{\n liveness {{\n  x = A . B\n{line}\n  y = C | D\n }}\n}}\nsystem A\n"
        assert [item.span.line for item in mistakes(text) if item.span] == [4], line


def test_nothing_is_said_of_right_texts() -> None:
    for path in TEXTS:
        lines = path.read_text("utf-8").split("\n")
        if path in MARKED and path.stem in ("control", "formulas"):
            read("\n".join(line for line in lines if "//!" not in line))


def test_a_file_full_of_mistakes_lists_the_first_hundred() -> None:
    found = mistakes("srm a { control a {\n" + "enter A [x]\n" * 500 + "} }")
    assert [item.code for item in found] == ["E100"] * 100 + ["E113"]


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("statechart r { state 0 OR  0.1 -> 0.2 : enter }", "expected 'on', 'exit' or the next entry"),
        ("srm r { plays p.q when busy }", "expected 'queue' or 'refuse' after 'busy'"),
        ("srm r { var n : int in }", "expected a number, '=' or the next entry after 'int'"),
    ],
)
def test_what_is_expected_is_said_in_words(text: str, wanted: str) -> None:
    """Not as the pattern that the grammar has for it."""
    assert wanted in next(item.message for item in mistakes(text) if item.code == "E100")
