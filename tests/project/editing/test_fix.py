"""Mending what has one right answer."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import CODES, Diagnostic, Edit
from aseme_dsl.diagnostics.changes import UNSURE, apply, choose
from aseme_dsl.project.editing.fix import ROUNDS, difference, fix, write_fixed
from aseme_dsl.project.files.inputs import Inputs
from aseme_dsl.project.files.write import Disk
from aseme_dsl.source import Source, Span
from tests.support.compiling import analysis
from tests.support.worded import worded

ACCEPTANCE = Path(__file__).parents[2] / "acceptance"

ROBOT = """\
system Robot
message Seen { bool ball  int count  double far }
topic eyes { state Seen }
srm robot {
  var n : int = 0
  liveness { robot = (Walk | Stand)+ }
  control robot {
    enter  Walk           : [eyes.state.Seen.ball]
    enter  Stand          : else
    leave  (Walk | Stand) : [eyes.state.Seen.count > 3] / n = 0
    repeat (Walk | Stand) : else
  }
}
"""


def mended(text: str) -> str:
    """A text with its problems mended, as often as there are some."""
    for _ in range(ROUNDS):
        chosen = choose(item for item in analysis(text).diagnostics if item.changes)
        if not chosen:
            return text
        text = apply(text, [edit for item in chosen for edit in item.changes])
    raise AssertionError("it does not come to an end")


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("state.Seen.ball", "state.Sen.ball"),
        ("state.Seen.ball", "stat.Seen.ball"),
        ("state.Seen.ball", "data.Seen.ball"),
        ("state.Seen.ball", "Seen.ball"),
        ("enter  Stand", "enter  Stnad"),
        ("repeat (Walk", "repeat (Wlak"),
        ("enter  Walk", "entre  Walk"),
        ("control robot", "control robto"),
        ("int = 0", "integer = 0"),
        ("(Walk | Stand)+ }", "(Walk ∨ Stand)+ }"),
        ("[eyes.state.Seen.ball]", "[!(eyes.state.Seen.count == 3)]"),
        ("[eyes.state.Seen.ball]", "eyes.state.Seen.ball"),
        ("[eyes.state.Seen.ball]", "eyes.state.Seen.ball]"),
        ("count > 3]", "count = 3]"),
        ("[eyes.state.Seen.count > 3]", "[6 > eyes.state.Seen.count > 3]"),
        ("[eyes.state.Seen.ball]", "[!eyes.state.Seen.count == 2 + 1 || true]"),
        ("[eyes.state.Seen.ball]", "/ n = 3"),
        ("[eyes.state.Seen.ball]", "n = 3"),
        ("[eyes.state.Seen.ball]", "after(2 s)"),
        ("[eyes.state.Seen.ball]", "after(2sec)"),
        ("[eyes.state.Seen.ball]", "read_messages"),
        ("(Walk | Stand)+ }", "(Walk / Stand)+ }"),
    ],
)
def test_it_leaves_no_error(right: str, wrong: str) -> None:
    """But E404, where the text without the mistake has it."""
    assert right in ROBOT
    text = mended(ROBOT.replace(right, wrong))
    assert [item.code for item in analysis(text).diagnostics if item.code[0] == "E"] in ([], ["E404"])


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        ("!eyes.state.Seen.ball == true", "!(eyes.state.Seen.ball == true)"),
        ("(!n < eyes.state.Seen.count * 2) && true", "(!(n < eyes.state.Seen.count * 2)) && true"),
        ("0 < n <= 3", "0 < n && n <= 3"),
        ("!n == 1 == 2", "!n == 1 == 2"),
        ("0 < n > 3", "0 < n > 3"),
        ("!n + 1 == 2", "!n + 1 == 2"),
    ],
)
def test_parentheses(wrong: str, right: str) -> None:
    text = ROBOT.replace("eyes.state.Seen.ball", wrong, 1)
    assert mended(text) == ROBOT.replace("eyes.state.Seen.ball", right, 1)


def test_operators_of_other_languages() -> None:
    text = "system S\nsrm s { liveness { s = A -> B ; C, (D / E) [F] && G } }\n"
    assert "s = A . B . C. (D | E) . [F] || G }" in mended(text)


@pytest.mark.parametrize("formula", ["(A | B, C)", "(A, B | C)", "A | (B | C), D", "(A || B; C)"])
def test_what_may_be_another_operator_is_left(formula: str) -> None:
    text = f"system S\nsrm s {{ liveness {{ s = {formula} }} }}\n"
    assert mended(text) == text


def test_a_timer_that_another_is_meant_by() -> None:
    text = ROBOT.replace("/ n = 0", "/ start_timer(pause, 1s)")
    text = text.replace("ball]", "ball && expired( pasue )]").replace("leave ", "repeat", 1)
    text = text.replace("    repeat (Walk | Stand) : else", "    leave (Walk | Stand) : [n > 2]")
    assert "expired( pause )" in mended(text)


def test_parentheses_stay() -> None:
    assert mended(ROBOT.replace("leave  (Walk", "leave  (Wlak")) == ROBOT


def test_of_two_names_that_are_as_close_neither_is_taken() -> None:
    text = ROBOT.replace("bool ball", "bool balls  bool balla")
    (item,) = [item for item in analysis(text).diagnostics if item.code == "E501"]
    assert item.hint is not None
    assert item.changes == ()
    assert mended(text) == text


def test_changes_that_overlap_wait_for_the_first() -> None:
    source = Source("a.aseme", "abcdef")

    def change(start: int, end: int, text: str) -> Diagnostic:
        return worded("E200", text, Span(source, start, end), fix=text)

    first, second, third = change(0, 3, "X"), change(2, 4, "Y"), change(4, 6, "Z")
    at_once = worded(
        "E200", "two", None, edits=(Edit(Span(source, 5, 6), "!"), Edit(Span(source, 3, 3), "!"))
    )
    assert choose([first, second, third, at_once]) == [first, third]
    assert choose([second, at_once]) == [second]
    assert choose([at_once, first, third]) == [at_once]
    assert apply(source.text, [*first.changes, *third.changes]) == "XdZ"


class TestFiles:
    def write(self, folder: Path, text: str) -> Inputs:
        (folder / "robot.aseme").write_text(text)
        return Inputs((folder / "robot.aseme",), (), ())

    def test_all_that_can_be_mended_is(self, tmp_path: Path) -> None:
        wrong = (
            ROBOT.replace("Seen.ball", "Sen.ball")
            .replace("Seen.count", "Seen.cuont")
            .replace("r Wa", "r\tWa")
        )
        fixed = fix(self.write(tmp_path, wrong))
        assert write_fixed(fixed).diagnostics == ()
        assert (tmp_path / "robot.aseme").read_text() == ROBOT
        assert difference(fixed).count("\n-    ") == difference(fixed).count("\n+    ") == 2

    def test_a_file_that_has_changed_is_left_alone(self, tmp_path: Path) -> None:
        fixed = fix(self.write(tmp_path, ROBOT.replace("ball]", "bal]")))
        (tmp_path / "robot.aseme").write_text("system Other\n")
        (problem,) = write_fixed(fixed).diagnostics
        assert problem.code == "E009"
        assert "has changed since it was read" in problem.message
        assert (tmp_path / "robot.aseme").read_text() == "system Other\n"
        (tmp_path / "robot.aseme").unlink()
        assert [item.code for item in write_fixed(fixed).diagnostics] == ["E009"]

    def test_a_full_disk_changes_nothing(self, tmp_path: Path) -> None:
        class Full(Disk):
            def create(self, path: Path, content: bytes, mode: int | None) -> None:
                raise OSError(28, "No space left on device", str(path))

        text = ROBOT.replace("ball]", "bal]")
        fixed = fix(self.write(tmp_path, text))
        assert [item.code for item in write_fixed(fixed, Full()).diagnostics] == ["E009"]
        assert (tmp_path / "robot.aseme").read_text() == text
        assert [path.name for path in tmp_path.iterdir()] == ["robot.aseme"]

    def test_a_link_stays_one(self, tmp_path: Path) -> None:
        (tmp_path / "there").mkdir()
        self.write(tmp_path / "there", ROBOT.replace("ball]", "bal]"))
        link = tmp_path / "robot.aseme"
        link.symlink_to("there/robot.aseme")
        write_fixed(fix(Inputs((link,), (), ())))
        assert link.is_symlink()
        assert link.read_text() == ROBOT

    def test_line_ends_stay_what_they_are(self, tmp_path: Path) -> None:
        content = ROBOT.replace("\n", "\r\n")
        (tmp_path / "robot.aseme").write_bytes(content.replace("ball]", "bal]").encode())
        write_fixed(fix(Inputs((tmp_path / "robot.aseme",), (), ())))
        assert (tmp_path / "robot.aseme").read_bytes() == content.encode()

    def test_the_standard_library_and_names_that_may_be_meant_are_left_alone(self, tmp_path: Path) -> None:
        assert {CODES[code].severity for code in UNSURE} == {"warning"}
        text = "system A\nsrm robot { liveness { robot = Walking . Walkng } }\n"
        inputs = self.write(tmp_path, text)
        fixed = fix(inputs)
        assert [item.code for item in fixed.checked.diagnostics if item.fix] == ["W200"]
        assert fixed.after == {}

    def test_what_no_longer_is_needed_goes(self, tmp_path: Path) -> None:
        text = ROBOT.replace("  var", "  // asemec: allow(W300, W301) why not\n  var")
        write_fixed(fix(self.write(tmp_path, text)))
        assert (tmp_path / "robot.aseme").read_text() == ROBOT


TEXTS = [ROBOT, *(path.read_text("utf-8") for path in sorted(ACCEPTANCE.glob("*.aseme")))]


@settings(max_examples=60)
@given(data=st.data())
def test_mending_ends_and_what_is_mended_does_not_come_back(data: st.DataObject) -> None:
    """A text with small mistakes anywhere: no mended problem is there again at its place."""
    text = data.draw(st.sampled_from(TEXTS[:1] * 4 + TEXTS))
    for _ in range(data.draw(st.integers(1, 4))):
        place = data.draw(st.integers(0, len(text) - 1))
        text = (
            text[:place]
            + data.draw(st.sampled_from(["", "x", "!", "ω", " ", text[place] * 2]))
            + text[place + 1 :]
        )
    seen = {text}
    for _ in range(ROUNDS):
        found = analyse(Source("test.aseme", text)).diagnostics
        chosen = choose(item for item in found if item.changes)
        if not chosen:
            return
        for item in chosen:
            after = apply(text, item.changes)
            again = analyse(Source("test.aseme", after)).diagnostics
            places = {(other.code, other.message, other.span.start) for other in again if other.span}
            assert item.span is not None
            assert (item.code, item.message, item.span.start) not in places
        text = apply(text, [edit for item in chosen for edit in item.changes])
        assert text not in seen
        seen.add(text)
    raise AssertionError("it does not come to an end")
