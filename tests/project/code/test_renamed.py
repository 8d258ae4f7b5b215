"""Names that were others in earlier versions: told in the Python of activities, and mended."""

from __future__ import annotations

from pathlib import Path

from aseme_dsl import runtime
from aseme_dsl.project.code.renamed import ARGUMENTS, METHODS, NAMES
from aseme_dsl.project.editing.fix import fix, write_fixed
from aseme_dsl.project.files.inputs import Inputs
from aseme_dsl.runtime import Context

TEAM = """\
system Team
message Ball { double x }
topic eyes { state Ball from camera }
suc { role camera : external }
srm player {
  var goals : int = 0
  liveness { player = Count }
  activities { Count reads eyes.state.Ball writes goals }
}
"""

BEFORE = """\
from aseme_dsl.runtime import BodyLost, Context


class Count:
    def execute(self, context: Context) -> None:
        try:
            ball = context.state("eyes.state.Ball", host="one")
            context.set("goals", 1 if ball else 0)
        except BodyLost:
            context.check()
"""

AFTER = """\
from aseme_dsl.runtime import BodyConnectionError, Context


class Count:
    def execute(self, context: Context) -> None:
        try:
            ball = context.latest_message("eyes.state.Ball", sender="one")
            context.set_variable("goals", 1 if ball else 0)
        except BodyConnectionError:
            context.raise_if_cancelled()
"""


def project(folder: Path, code: str | bytes) -> Inputs:
    (folder / "activities").mkdir()
    (folder / "team.aseme").write_text(TEAM)
    settings = '[tool.asemec]\nfiles = ["team.aseme"]\nactivities = "activities"\n'
    (folder / "pyproject.toml").write_text(settings)
    data = code if isinstance(code, bytes) else code.encode()
    (folder / "activities" / "count.py").write_bytes(data)
    return Inputs((folder / "team.aseme",), (), ())


def test_old_names_are_mended_in_the_code_of_activities(tmp_path: Path) -> None:
    fixed = fix(project(tmp_path, BEFORE))
    assert [(item.code, item.hint) for item in fixed.mended] == [
        ("E546", "it is called `BodyConnectionError` now"),
        ("W530", "it is called `latest_message` now"),
        ("W530", "it is called `sender` now"),
        ("W530", "it is called `set_variable` now"),
        ("W530", "it is called `raise_if_cancelled` now"),
    ]
    assert fixed.checked.diagnostics == ()
    write_fixed(fixed)
    assert (tmp_path / "activities" / "count.py").read_text() == AFTER


def test_code_whose_lines_end_otherwise_is_told_and_left(tmp_path: Path) -> None:
    code = BEFORE.replace("\n", "\r\n").encode()
    fixed = fix(project(tmp_path, code))
    assert fixed.mended == () and len(fixed.checked.diagnostics) == 5
    assert (tmp_path / "activities" / "count.py").read_bytes() == code


def test_every_new_name_is_there_and_every_old_one_is_not() -> None:
    for old, new in METHODS.items():
        assert hasattr(Context, new) and not hasattr(Context, old)
    for old, new in NAMES.items():
        assert new in runtime.__all__ and old not in runtime.__all__
    for (method, old), new in ARGUMENTS.items():
        arguments = getattr(Context, method).__annotations__
        assert new in arguments and old not in arguments


def test_the_page_of_renamed_names_has_them_all() -> None:
    page = (Path(__file__).parents[3] / "docs" / "project" / "renamed.md").read_text("utf-8")
    for old, new in METHODS.items():
        assert f"| `Context.{old}` | `Context.{new}` |" in page
    for old, new in NAMES.items():
        assert f"| `aseme_dsl.runtime.{old}` | `aseme_dsl.runtime.{new}` |" in page
