"""The scenarios of the examples pass."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.support import Here

EXAMPLES = Path(__file__).parent.parent.parent / "examples"


@pytest.mark.parametrize(("example", "number"), [("goalie", 3), ("patrol", 3), ("robocup", 1)])
def test_they_pass(
    example: str,
    number: int,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:
    monkeypatch.chdir(tmp_path)
    done = Here(capsys)("test", EXAMPLES / example, "-j", "1", "--json")
    verdicts = [item["verdict"] for item in done.json["scenarios"]]
    assert verdicts == ["passed"] * number, done.out
