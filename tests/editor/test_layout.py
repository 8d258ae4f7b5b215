"""A file that is laid out piece by piece: as it is laid out in one go, whatever stands in it."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from aseme_dsl.editor.changes.layout import _cuts, layout
from aseme_dsl.editor.changes.rewriting import after
from aseme_dsl.grammar.layout import format_source
from aseme_dsl.source import Source
from tests.support.edits import Edit, edited, edits

ROOT = Path(__file__).parents[2]
FILES = sorted(path for name in ("examples", "stdlib", "tests") for path in ROOT.glob(f"{name}/**/*.aseme"))

TEXT = """\
// A comment at the top.

language 1
system T
import soccer


// Two messages.
message Note { int number } // short
message Longer { int number  string text }
// above the topic

topic board { state Note  signal Longer }
/* a block
   comment */

let low = board.state.Note.number < 3
let high = board.state.Note.number   > 30

srm robot {

  liveness { robot = (walk | Wait)~  walk = Step . Rest }
  control robot { enter walk : [low]  enter Wait : else }
} // behind it
// a comment between

// another one


srm other { liveness { other = A } }

team T { r1 : robot
  r2 : other }
// the end
"""


def is_the_same(text: str) -> None:
    source = Source("t.aseme", text)
    assert after(text, layout(source)) == format_source(source).text


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(ROOT)))
def test_every_file(path: Path) -> None:
    text = path.read_text("utf-8")
    is_the_same(text)
    # … and where its lines are not where they belong.
    is_the_same("\n".join(" " * (len(line) % 3) + line.replace("  ", " ") for line in text.split("\n")))
    is_the_same(text.replace("\n\n", "\n\n\n"))
    is_the_same(text.replace("\n", "\r\n"))


def test_what_is_cut() -> None:
    assert len(_cuts(TEXT)) - 1 == 6


@settings(max_examples=150, deadline=None)
@given(st.lists(edits, min_size=1, max_size=3))
@example([Edit("drop line", 0, 0, "")])
def test_every_edit(steps: list[Edit]) -> None:
    text = TEXT
    for step in steps:
        text = edited(text, step, TEXT)
    is_the_same(text.removeprefix("\ufeff"))


def test_some_lines() -> None:
    text = TEXT.replace("message Note", "message  Note").replace("topic board", "topic   board")
    number = 1 + text[: text.index("topic ")].count("\n")
    changed = after(text, layout(Source("t", text), number, number))
    assert "message  Note" in changed and "topic board" in changed
