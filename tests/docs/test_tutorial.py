"""The tutorial, page after page, in one folder: as somebody works through it."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from tests.docs.pages import ROOT, Page

FOLDER = ROOT / "docs" / "tutorials"
PAGES = sorted(FOLDER.glob("[1-9]-*.md"))


@pytest.mark.long
def test_one_folder_serves_all_pages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.setenv("PYTHONDONTWRITEBYTECODE", "1")
    assert len(PAGES) == 8
    for path in PAGES:
        Page(path, tmp_path, update=False).run()
