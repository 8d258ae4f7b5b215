"""What expressions mean: every case is a document, and its snapshot says what is wrong with it."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.conftest import Snapshot
from tests.support.compiling import printed

CASES = sorted((Path(__file__).parent / "types").glob("*.aseme"))


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.stem)
def test_diagnostics(case: Path, snapshot: Snapshot) -> None:
    snapshot(printed(case.read_text("utf-8")), f"types/{case.stem}.txt")
