"""Every example of the documentation and of the README is run, page by page."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from aseme_dsl.cli.program import COMMANDS
from aseme_dsl.cli.team import NAMES as TEAM
from tests.docs.pages import ROOT, Page

PAGES = sorted(
    path
    for path in [ROOT / "README.md", *(ROOT / "docs").rglob("*.md")]
    if not {"_build", "_ext", "diagnostics", "ten-mistakes.md"} & set(path.relative_to(ROOT).parts)
)
"""Not those that a build makes: of the codes of diagnostics, whose examples tests/diagnostics compiles; nor
the comparison with other tools, which test_ten_mistakes.py looks at."""


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_the_examples_of_a_page_do_what_it_says(
    path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, pytestconfig: pytest.Config
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    monkeypatch.delenv("NO_COLOR", raising=False)
    # A page that lists a folder does not show what Python keeps there.
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.setenv("PYTHONDONTWRITEBYTECODE", "1")
    Page(path, tmp_path, update=pytestconfig.getoption("--snapshot-update")).run()


def test_every_command_has_its_help_in_the_reference() -> None:
    names = [*COMMANDS, *(f"team {name}" for name in TEAM)]
    text = (ROOT / "docs" / "reference" / "commands.md").read_text("utf-8")
    assert [name for name in names if f"$ asemec {name} --help\n" not in text] == []
