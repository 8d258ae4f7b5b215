"""What the project itself writes is in the canonical layout."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from aseme_dsl.grammar.layout import format_source
from aseme_dsl.project.editing.new import new_project
from aseme_dsl.source import Source

ROOT = Path(__file__).resolve().parents[2]
FILES = sorted([*ROOT.glob("examples/**/*.aseme"), *ROOT.glob("stdlib/*.aseme")])
PAGES = sorted(
    path
    for path in [*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md"), *ROOT.glob("examples/**/*.md")]
    if path.parent != ROOT / "docs" / "reference" / "diagnostics"  # made with the documentation
)
_EXAMPLE = re.compile(r"(?<!untidy\.aseme -->\n)^(```aseme\n)(.*?)(?=^```$)", re.MULTILINE | re.DOTALL)
"""A whole file in a page; not that which shows what the layout makes of one."""


def laid(text: str) -> str:
    """The layout of a text; pieces of files have none."""
    return format_source(Source("test.aseme", text)).text


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_examples_and_the_standard_library(path: Path) -> None:
    assert path.read_text("utf-8") == laid(path.read_text("utf-8")), f"asemec fmt {path.relative_to(ROOT)}"


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.name)
def test_whole_files_in_the_documentation(path: Path, pytestconfig: pytest.Config) -> None:
    page = path.read_text("utf-8")
    tidy = _EXAMPLE.sub(lambda found: found[1] + laid(found[2]), page)
    if pytestconfig.getoption("--snapshot-update") and tidy != page:
        path.write_text(tidy, "utf-8")
    else:
        assert page == tidy, "with --snapshot-update, this test lays the examples out"


def test_a_new_project(tmp_path: Path) -> None:
    new_project(tmp_path / "patrol", None)
    text = (tmp_path / "patrol" / "patrol.aseme").read_text("utf-8")
    assert text == laid(text)
