"""The page of certificates says what `asemec prove` says now of the library and the examples.

A few small cases are proved again in each run; all of them with `CERTIFICATES=1`, as `dev.py long` does.
`--snapshot-update` writes what is proved now into the page.
"""

from __future__ import annotations

import os
import re

import pytest

from tests.proofs.certificates import PAGE, QUICK, Case, cases, counted, section, written

PAGE_TEXT = PAGE.read_text("utf-8")
SECTIONS = written(PAGE_TEXT)
IS_LONG = "CERTIFICATES" in os.environ


def _is_looked_at(case: Case) -> bool:
    return IS_LONG or (case.name in QUICK and not case.harsh)


@pytest.mark.parametrize(
    "case", [case for case in cases() if _is_looked_at(case)], ids=lambda case: case.title.replace(" ", "_")
)
def test_a_certificate_is_what_is_proved_now(case: Case, pytestconfig: pytest.Config) -> None:
    now = section(case).rstrip()
    before = SECTIONS.get(case.title)
    if pytestconfig.getoption("--snapshot-update") and before != now:
        text = PAGE.read_text("utf-8")
        PAGE.write_text(text.replace(before, now) if before else f"{text.rstrip()}\n\n{now}\n", "utf-8")
        return
    assert before == now


def test_the_page_has_all_cases_and_says_how_many_answers_there_are() -> None:
    assert list(SECTIONS) == [case.title for case in cases()]
    found = re.search(r"[0-9]+ proved, [0-9]+ refuted, [0-9]+ undecided", PAGE_TEXT)
    assert found is not None and found[0] == counted(PAGE_TEXT)
