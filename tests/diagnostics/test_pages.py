"""The page of every code: its wrong example has the problem, and its right example has not."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import pytest

from aseme_dsl.diagnostics import CODES, has_errors, render_text
from aseme_dsl.diagnostics.pages import Example, page
from aseme_dsl.project.building.examples import diagnostics_of
from tests.docs.pages import run_console

WITHOUT_PAGE = frozenset[str]()
"""Codes whose page is still to be written."""

PAGES = sorted(set(CODES) - WITHOUT_PAGE)


def test_every_code_has_a_page_and_every_page_a_code() -> None:
    folder = resources.files("aseme_dsl.diagnostics") / "pages"
    written = {file.name.removesuffix(".md") for file in folder.iterdir()}
    assert written == set(PAGES)
    assert set(CODES) >= WITHOUT_PAGE


def test_a_title_is_a_noun_phrase_of_its_own() -> None:
    titles = [item.title for item in CODES.values()]
    assert [title for title in titles if len(title.split()) > 8] == []
    assert [title for title in titles if title.split()[0] in ("a", "an", "the")] == []
    assert len(set(titles)) == len(titles)


@pytest.mark.parametrize("code", PAGES)
def test_a_page_explains_in_a_few_sentences(code: str) -> None:
    text = page(code).text
    assert text.endswith((".", ".)")), "the explanation ends with a sentence"
    assert 100 < len(text) < 1500


@pytest.mark.parametrize("code", PAGES)
def test_the_wrong_example_has_the_problem_and_no_other_error(
    code: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    example = page(code).wrong
    if example.console:
        assert code in example.console
        play(example, tmp_path, monkeypatch)
        return
    found = diagnostics_of(example)
    says = render_text(found)
    assert code in {item.code for item in found}, says
    assert not has_errors(item for item in found if item.code != code), says


@pytest.mark.parametrize("code", PAGES)
def test_the_right_example_has_neither_the_problem_nor_an_error(
    code: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    example = page(code).right
    if example.console:
        assert code not in example.console
        play(example, tmp_path, monkeypatch)
        return
    found = diagnostics_of(example)
    says = render_text(found)
    assert code not in {item.code for item in found}, says
    assert not has_errors(found), says


def play(example: Example, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Write the files of an example and run its commands there."""
    for file in example.files:
        path = folder / file.name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(file.text, "utf-8")
    monkeypatch.chdir(folder)
    monkeypatch.setenv("COLUMNS", "80")
    run_console(example.console, folder)
