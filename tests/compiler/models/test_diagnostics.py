"""What the compiler says about files with mistakes: each case is a file, with the output that a user sees."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.conftest import Snapshot
from tests.support.compiling import printed

CASES = sorted((Path(__file__).parent / "cases").glob("*.aseme"))


@pytest.mark.parametrize("case", CASES, ids=lambda path: path.stem)
def test_what_is_said(case: Path, snapshot: Snapshot) -> None:
    snapshot(printed(case.read_text("utf-8")), f"{case.stem}.txt")


@pytest.mark.parametrize(
    "case", [path for path in CASES if path.stem[0] in "EWN"], ids=lambda path: path.stem
)
def test_the_case_is_about_its_code(case: Path) -> None:
    code = case.stem.split("_")[0]
    assert f"[{code}]" in printed(case.read_text("utf-8"))
