"""However a file is edited, the editor says what a cold check says, and keeps no more than it needs.

`EDITOR_EDITS` says how many edits are tried (`python3 dev.py long`: 10 000).
"""

from __future__ import annotations

import gc
import os
import re
from collections.abc import Iterable
from pathlib import Path

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from aseme_dsl.cli.lsp import project
from aseme_dsl.compiler import Analysis, analyse
from aseme_dsl.compiler.read.pieces import finished
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.editor.answers.hints import hints, lenses
from aseme_dsl.editor.answers.hover import hover
from aseme_dsl.editor.answers.navigation import PythonFolders, definition, links, references
from aseme_dsl.editor.answers.outline import folds, outline, selections
from aseme_dsl.editor.answers.tokens import encoded, tokens
from aseme_dsl.editor.changes.layout import layout
from aseme_dsl.editor.changes.rename import rename
from aseme_dsl.editor.files.view import View
from aseme_dsl.editor.files.workspace import Workspace
from aseme_dsl.project.building.project import compile_root
from aseme_dsl.source import Source, Span
from tests.support.edits import Edit, edited, edits
from tests.support.large import large_file

ROOT = Path(__file__).parents[2]
EDITS = int(os.environ.get("EDITOR_EDITS", "48"))
AT_ONCE = 8
COMPARED = 4
"""After every how many edits a cold check is made to compare with: it takes much longer than an edit."""

PATH = "/nowhere/team.aseme"

TEXTS = {
    **{path.stem: path.read_text("utf-8") for path in sorted((ROOT / "tests/acceptance").glob("*.aseme"))},
    "example": (ROOT / "examples/robocup/kouretes.aseme").read_text("utf-8"),
    "machines": large_file(250),
    "small": """\
language 1
system Twins
import soccer
let low = vision.state.Ball.distance < 3
message Note { int number }
message Note2 { int number }
topic board { state Note, Note2 }
abstract srm walker { liveness { walk = Step . Rest } activities { Step takes 1s } }
srm robot { includes walker liveness { robot = (walk | Wait)~ }
  control robot { enter walk : [low] enter Wait : else } }
// asemec: allow(N727) it is for later
let high = !low
team Twins { r1, r2 : robot }
""",
}


def place(span: Span | None) -> object:
    return None if span is None else (span.source.path, span.start, span.end)


def shown(diagnostics: Iterable[Diagnostic]) -> list[object]:
    return [
        (
            item.code,
            item.severity,
            item.message,
            place(item.span),
            tuple((place(other.span), other.message) for other in item.related),
            item.hint,
            item.fix,
            tuple((place(edit.span), edit.text) for edit in item.edits),
        )
        for item in diagnostics
    ]


def missing(analysis: Analysis) -> list[object]:
    return [(item.skeleton, place(item.inside), shown([item.note])) for item in analysis.missing]


def answer_all(view: View, offset: int, workspace: Workspace) -> None:
    """Nothing that an editor may ask for fails, whatever the text."""
    for item in view.occurrences:
        assert view.whole(item.span).text in (item.span.text, item.symbol.name)
    finished(encoded(view.lines, finished(tokens(view))))
    outline(view)
    finished(folds(view))
    links(view)
    lenses(view)
    layout(view.source)
    hints(view, 0, len(view.source.text))
    assert selections(view, offset)[-1].end == len(view.source.text)
    hover(view, offset)
    definition(view, offset)
    references(view, offset, PythonFolders())
    rename(workspace, view, offset, "renamed")


@settings(
    max_examples=max(EDITS // AT_ONCE, 1),
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large],
)
@given(st.sampled_from(sorted(TEXTS)), st.lists(edits, min_size=AT_ONCE, max_size=AT_ONCE))
@example("small", [Edit("insert", 300, 0, "/*"), Edit("insert", 700, 0, "*/"), Edit("undo", 0, 0, "")])
@example("small", [Edit("drop line", 0, 0, ""), Edit("copy line", 0, 999, ""), Edit("delete", 500, 11, "")])
def test_the_editor_says_what_a_cold_check_says(name: str, changes: list[Edit]) -> None:
    workspace = Workspace()
    text = original = TEXTS[name]
    workspace.open(PATH, text)
    workspace.view(PATH)
    for number, change in enumerate(changes):
        text = edited(text, change, original)
        workspace.open(PATH, text)
        warm = workspace.program(PATH).inspection.analysis
        if number % COMPARED and number != len(changes) - 1:
            continue
        cold = analyse(Source(PATH, text))
        assert shown(warm.diagnostics) == shown(cold.diagnostics)
        assert missing(warm) == missing(cold)
        assert [place(item.allow) for item in warm.suppressed] == [
            place(item.allow) for item in cold.suppressed
        ]
        if number == len(changes) - 1:
            view = workspace.view(PATH)
            assert view is not None and view.source.text == text.removeprefix("\ufeff")
            answer_all(view, change.place * len(text) // 999, workspace)


def test_what_the_code_of_activities_makes_of_a_file_is_said_as_by_a_check(tmp_path: Path) -> None:
    team = tmp_path / "count.aseme"
    (tmp_path / "pyproject.toml").write_text(
        '[tool.asemec]\nfiles = ["count.aseme"]\nactivities = "code"\n', "utf-8"
    )
    team.write_text(
        "system S\n\nmessage Ball { double x }\ntopic field { state Ball }\n"
        "srm r { var n : int = 0 var m : int = 0\n  liveness { r = Walk~ }\n"
        "  activities { Walk takes 1s reads field.state.Ball }\n"
        "  control r { repeat Walk : / n = n + 1; m = 2 } }\nteam T { one : r }\n",
        "utf-8",
    )
    (tmp_path / "code").mkdir()
    (tmp_path / "code" / "walk.py").write_text(
        "class Walk:\n    def execute(self, context):\n"
        '        context.log(context.get_variable("n"), context.topic("field.state.Bal"))\n',
        "utf-8",
    )
    workspace = Workspace(project())
    workspace.open(str(team), team.read_text("utf-8"))
    cold = compile_root(str(team)).diagnostics
    assert {item.span.text for item in cold if item.code == "N725" and item.span is not None} == {"m"}
    assert shown(workspace.program(str(team)).diagnostics) == shown(cold)


def test_what_stands_before_something_broken_is_found() -> None:
    text = TEXTS["small"].replace("srm robot {", "srm robot { control control")
    workspace = Workspace()
    workspace.open(PATH, text)
    view = workspace.view(PATH)
    assert view is not None and [item.code for item in view.diagnostics] == ["E100"]
    for name in ("low", "Note2 {", "walk =", "Step .", "robot {", "Twins {", "high"):
        found = view.occurrence_at(text.index(name))
        assert found is not None and view.whole(found.span).start == text.index(name)


def words_that_no_declaration_is_called() -> list[str]:
    """Those that the grammar of expressions takes for more of the expression."""
    grammar = (ROOT / "aseme_dsl/grammar/expressions.tx").read_text("utf-8")
    found = re.search(r"\(\?! \(\?: (and\|or\|[^)]*)\)", grammar)
    assert found is not None
    return [word.strip() for word in found[1].split("|")]


@pytest.mark.parametrize("word", words_that_no_declaration_is_called())
def test_what_only_looks_like_a_declaration_belongs_to_the_expression_before(word: str) -> None:
    text = TEXTS["small"].replace("< 3\n", f"< 3\nlet {word} = 4\n")
    workspace = Workspace()
    workspace.open(PATH, text)
    assert shown(workspace.program(PATH).inspection.analysis.diagnostics) == shown(
        analyse(Source(PATH, text)).diagnostics
    )


def words_that_no_system_is_called() -> list[str]:
    """Those with which the next declaration begins, so that the system has no name yet."""
    grammar = (ROOT / "aseme_dsl/grammar/aseme.tx").read_text("utf-8")
    found = re.search(r"SystemName: [^(]*\(\?x\)\s*\(\?! \(\?:([^)]*)\)", grammar)
    assert found is not None
    return [*found[1].split("|"), "abstract srm"]


@pytest.mark.parametrize("between", [" ", " // a comment\n", "\n\n", " /* */ "])
@pytest.mark.parametrize("word", words_that_no_system_is_called())
def test_a_system_that_is_called_like_the_declaration_behind_it(word: str, between: str) -> None:
    text = f"language 1\nsystem{between}{word}\nimport soccer\nsrm r {{ liveness {{ r = A }} }}\n"
    workspace = Workspace()
    workspace.open(PATH, text)
    assert shown(workspace.program(PATH).inspection.analysis.diagnostics) == shown(
        analyse(Source(PATH, text)).diagnostics
    )


@pytest.mark.parametrize(
    "typed", ["vision.Bdistance", "vision.", "vision.state.", "robot.x", "Ball.distance"]
)
def test_a_name_that_is_half_typed_is_answered(typed: str) -> None:
    text = TEXTS["small"].replace("vision.state.Ball.distance", typed)
    workspace = Workspace()
    workspace.open(PATH, text)
    view = workspace.view(PATH)
    assert view is not None
    for offset in range(text.index(typed), text.index(typed) + len(typed) + 1):
        answer_all(view, offset, workspace)


def test_files_that_import_each_other_say_what_a_cold_check_says(tmp_path: Path) -> None:
    shared = tmp_path / "shared.aseme"
    team = tmp_path / "team.aseme"
    shared.write_text("message Note { int number }\ntopic board { state Note }\n", "utf-8")
    team.write_text(
        'system T\nimport "shared.aseme"\nsrm r { liveness { r = (A | B)~ }\n'
        "  control r { enter A : [board.state.Note.number == 1] enter B : else } }\nteam T { x : r }\n",
        "utf-8",
    )
    workspace = Workspace(folders=[str(tmp_path)])
    for text in (shared.read_text("utf-8"), "message Note { int numero }\n", "message Note {", ""):
        workspace.open(str(shared), text)
        cold = analyse(team, {str(shared): text})
        assert shown(workspace.program(str(team)).inspection.analysis.diagnostics) == shown(cold.diagnostics)
    assert workspace.roots(str(shared)) == (str(team),)
    assert workspace.affected(str(shared)) == (str(shared),)


@pytest.mark.parametrize("name", ["small", *(["example"] if EDITS > 1000 else [])])
def test_what_is_kept_does_not_grow(name: str) -> None:
    workspace = Workspace()
    text = TEXTS[name]
    at = text.index("liveness")

    def type_and_correct(first: int, count: int) -> int:
        for number in range(first, first + count):
            workspace.open(
                PATH, f"{text[:at]}\n  let l{number} = {number} < 3 {'{' * (number % 3 == 0)}\n{text[at:]}"
            )
            workspace.view(PATH)
        workspace.open(PATH, text)
        workspace.view(PATH)
        gc.collect()
        return len(gc.get_objects())

    type_and_correct(0, 70)  # until as much is kept as ever
    before = type_and_correct(100, 40)
    after = type_and_correct(200, 80)
    assert after < before * 1.05
