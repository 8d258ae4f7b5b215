"""The page of every code: its wrong example has the problem, and its right example has not."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import pytest

from aseme_dsl.build.examples import diagnostics_of
from aseme_dsl.diagnostics import CODES, has_errors, render_text
from aseme_dsl.diagnostics.pages import Example, page
from tests.docs.pages import run_console

WITHOUT_PAGE = frozenset(
    (
        "E001 E002 E003 E004 E005 E006 E007 E008 E009 E010 "
        "W001 W002 W003 "
        "E100 E101 E102 E103 E104 E105 E106 E107 E108 E109 E110 E111 E112 E113 E114 E115 "
        "E201 E202 E203 E204 E205 E206 E207 E208 E209 E210 E211 E212 E213 E214 E215 E216 E217 "
        "W200 W201 W202 "
        "E300 E301 E302 E303 E304 E305 E306 E307 "
        "W300 W301 "
        "E400 E401 E402 E403 E404 E405 E406 E407 E408 E409 E410 E411 E412 "
        "W400 W401 W402 W403 "
        "E500 E501 E502 E503 E504 E505 E506 E507 E508 E509 E510 E511 E512 E513 E514 E515 E516 E517 "
        "W500 W501 "
        "E600 E601 E602 E603 E604 E605 E606 E607 E608 "
        "W600 W601 W602 "
        "N700 N701 N702 N703 N704 "
    ).split()
)
"""Codes whose page is still to be written."""

PAGES = sorted(set(CODES) - WITHOUT_PAGE)


def test_every_code_has_a_page_and_every_page_a_code() -> None:
    folder = resources.files("aseme_dsl.diagnostics") / "pages"
    written = {file.name.removesuffix(".md") for file in folder.iterdir()}
    assert written == set(PAGES)
    assert set(CODES) >= WITHOUT_PAGE


@pytest.mark.parametrize("code", PAGES)
def test_a_page_explains_in_a_few_sentences(code: str) -> None:
    text = page(code).text
    assert text.endswith("."), "the explanation ends with a sentence"
    assert 100 < len(text) < 1500


@pytest.mark.parametrize("code", PAGES)
def test_the_wrong_example_has_the_problem_and_no_other_error(
    code: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    example = page(code).wrong
    if example.console:
        assert f"[{code}]" in example.console
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
        assert f"[{code}]" not in example.console
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
