"""The scenarios of the examples pass."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.support import Here

EXAMPLES = Path(__file__).parent.parent.parent / "examples"


EACH = {
    "auction": 7,
    "cell": 9,
    "goalie": 8,
    "home": 9,
    "hospital": 7,
    "meetings": 8,
    "patrol": 10,
    "robocup": 8,
    "warehouse": 7,
}


@pytest.mark.parametrize(("example", "number"), EACH.items())
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


def test_every_example_has_some() -> None:
    assert {path.parent.name for path in EXAMPLES.glob("*/pyproject.toml")} == set(EACH)
    assert sum(EACH.values()) >= 60
