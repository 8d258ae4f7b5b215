"""How examples are kept up to date: what `pytest tests/docs --snapshot-update` writes into a page."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.docs.pages import Page

USAGE = "Usage: asemec fmt [OPTIONS] [TARGET]..."


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    return tmp_path


def page(folder: Path, text: str) -> Path:
    path = folder / "page.md"
    path.write_text(text, "utf-8")
    return path


def console(command: str, *output: str) -> str:
    return "\n".join(["```console", f"$ {command}", *output, "```", ""])


def test_the_help_of_a_command_is_written_though_it_has_three_dots(folder: Path) -> None:
    path = page(folder, console("asemec fmt --help", USAGE, "", "  Said before."))
    with pytest.raises(AssertionError, match="says something else"):
        Page(path, folder, update=False).run()
    Page(path, folder, update=True).run()
    text = path.read_text("utf-8")
    assert USAGE in text and "Said before." not in text and "--check" in text
    Page(path, folder, update=False).run()


def test_three_dots_in_a_help_stand_for_nothing_else(folder: Path) -> None:
    path = page(folder, console("asemec fmt --help", "Usage: ...", "..."))
    with pytest.raises(AssertionError, match="says something else"):
        Page(path, folder, update=False).run()


def test_elsewhere_they_stand_for_anything_and_are_kept(folder: Path) -> None:
    text = console("echo one; echo two", "one", "...")
    path = page(folder, text)
    Page(path, folder, update=True).run()
    assert path.read_text("utf-8") == text


def test_what_can_be_written_is_written_though_something_else_cannot(folder: Path) -> None:
    text = console("echo one", "two") + console("echo three", "thr... four") + console("echo five", "six")
    path = page(folder, text)
    with pytest.raises(AssertionError, match=r"page\.md:6: `echo three` says something else"):
        Page(path, folder, update=True).run()
    assert path.read_text("utf-8") == text.replace("\ntwo", "\none")
