"""While the compiler works: answers from what was known, at the right places, and the same in the end."""

from __future__ import annotations

from itertools import islice
from pathlib import Path

from hypothesis import example, given, settings
from hypothesis import strategies as st

from aseme_dsl.compiler import analyse
from aseme_dsl.editor.answers.hover import hover
from aseme_dsl.editor.answers.navigation import definition, highlights
from aseme_dsl.editor.files.carrying import carry
from aseme_dsl.editor.files.view import View
from aseme_dsl.editor.files.workspace import Workspace
from aseme_dsl.source import Source, Span
from tests.support.edits import Edit, edited, edits

PATH = "/nowhere/team.aseme"

TEXT = """\
language 1
system Twins
import soccer
message Note { int number }
topic board { state Note }
let low = board.state.Note.number < 3 // a small number
srm robot {
  liveness { robot = (walk | Wait)~ walk = Step . Rest }
  control robot { enter walk : [low] enter Wait : else }
}
team Twins { r1, r2 : robot }
"""


def typed_into(before: str, after: str) -> tuple[View, Workspace]:
    """What is known right after an edit, when the compiler has not begun."""
    workspace = Workspace()
    workspace.open(PATH, before)
    workspace.view(PATH)
    workspace.open(PATH, after)
    view = workspace.recent(PATH)
    assert view is not None and view.source.text == after
    return view, workspace


def hovered(view: View, marked: str) -> tuple[str, str] | None:
    """What is shown for the `^` in a piece of the text, and the text that it is shown for."""
    offset = view.source.text.index(marked.replace("^", "")) + marked.index("^")
    found = hover(view, offset)
    return None if found is None else (found.span.text, found.text.split("\n")[1])


def test_names_around_an_edit_are_found_where_they_are_now() -> None:
    after = TEXT.replace("language 1\n", "language 1\n\n// a comment\n").replace("Wait : else", "Wait : els")
    view, _ = typed_into(TEXT, after)
    assert hovered(view, "enter ^walk") == ("walk", "walk = Step . Rest")
    assert hovered(view, "board { state ^Note") == ("Note", "message Note {")
    (place,) = definition(view, after.index("low]"))
    assert place.span.text in ("low", after[place.span.start : place.span.end])
    assert {span.text for span, _ in highlights(view, after.index("walk :"))} == {"walk"}


def test_behind_an_edit_names_are_found() -> None:
    after = TEXT.replace("liveness {", "liveness { more = Look")
    view, _ = typed_into(TEXT, after)
    assert hovered(view, "walk = ^Step") is not None
    (place,) = definition(view, after.index("low]"))
    assert place.span.text == "low"


def test_a_name_that_is_being_typed_means_what_it_says() -> None:
    view, _ = typed_into(TEXT.replace("[low]", "[lo]"), TEXT)
    assert hovered(view, "[lo^w]") is None  # nothing in its block was called so
    view, _ = typed_into(
        TEXT.replace("Step . Rest", "Step . wal"), TEXT.replace("Step . Rest", "Step . walk")
    )
    assert hovered(view, "Step . wal^k") == ("walk", "walk = Step . wal")
    view, _ = typed_into(TEXT, TEXT.replace("enter walk", "enter walks"))
    assert hovered(view, "enter walk^s") is None
    assert "walks" not in {span.text for span, _ in highlights(view, TEXT.index("walk |"))}


def test_a_code_in_a_comment_that_is_being_typed_is_explained() -> None:
    view, _ = typed_into(TEXT, TEXT.replace("// a small number", "// asemec: allow(W300) it is"))
    found = hover(view, view.source.text.index("W300") + 1)
    assert found is not None and found.span.text == "W300"


@given(st.text("ab\n", max_size=20), st.text("ab\n", max_size=20), st.integers(0, 20))
def test_what_is_outside_of_the_stretch_that_changed_stays_what_it_is(
    before: str, after: str, offset: int
) -> None:
    if before == after:
        return
    moved = carry(before, after)
    assert before[: moved.start] == after[: moved.start]
    assert before[moved.old_end :] == after[moved.new_end :]
    assert moved.start <= min(moved.old_end, moved.new_end)
    if offset < len(before) and not moved.start <= offset < moved.old_end:
        span = moved.span(Span(Source("a", before), offset, offset + 1), Source("a", after))
        assert span.text == before[offset]
        assert moved.back(span.end) == offset + 1


@settings(max_examples=40, deadline=None)
@given(edits, edits)
def test_no_name_is_ever_found_at_a_wrong_place(first: Edit, second: Edit) -> None:
    after = edited(edited(TEXT, first, TEXT), second, TEXT).removeprefix("\ufeff")
    view, _ = typed_into(TEXT, after)
    for offset in range(0, len(after), 3):
        found = view.occurrence_at(offset)
        if found is not None:
            span = view.whole(found.span)
            assert span.source.text == after and span.start <= offset <= span.end
            assert span.text == found.span.text
        hover(view, offset)
        definition(view, offset)
        highlights(view, offset)


@settings(max_examples=25, deadline=None)
@given(st.lists(st.tuples(edits, st.integers(0, 25)), min_size=1, max_size=4))
@example([(Edit("drop line", 0, 0, ""), 0), (Edit("other word", 24, 48, ""), 0)])
def test_work_that_an_edit_interrupts_leaves_nothing_behind(steps: list[tuple[Edit, int]]) -> None:
    workspace = Workspace()
    workspace.open(PATH, TEXT)
    workspace.view(PATH)
    text = TEXT
    work = None
    for change, pieces in steps:
        text = edited(text, change, TEXT)
        workspace.open(PATH, text)
        work = work or workspace.viewing(PATH)  # the same goes on with the new text, or a new one begins
        if sum(1 for _ in islice(work, pieces)) < pieces:
            work = None
    view = workspace.view(PATH)
    cold = analyse(Source(PATH, text))
    assert view is not None
    warm = view.program.inspection.analysis.diagnostics
    assert [(item.code, item.message) for item in warm] == [
        (item.code, item.message) for item in cold.diagnostics
    ]


def test_a_file_that_another_one_changes_in_between_is_read_anew(tmp_path: Path) -> None:
    shared, team = tmp_path / "shared.aseme", tmp_path / "team.aseme"
    shared.write_text("message Note { int number }\n", "utf-8")
    team.write_text('system T\nimport "shared.aseme"\ntopic board { state Note }\n', "utf-8")
    workspace = Workspace()
    workspace.open(str(team), team.read_text("utf-8"))
    work = workspace.viewing(str(team))
    next(work)
    workspace.open(str(shared), "message Other { int number }\n")
    for _ in work:
        pass
    cold = analyse(team, {str(shared): "message Other { int number }\n"}).diagnostics
    said = [item.code for item in workspace.diagnostics(str(team))]
    assert said == [item.code for item in cold] and "Note" in cold[0].message
