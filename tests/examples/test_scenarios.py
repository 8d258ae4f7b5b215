"""The scenarios of the examples and of the acceptance files pass, and reach nearly every state."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.cli.support import Here

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples"
ACCEPTANCE = ROOT / "tests" / "acceptance" / "scenarios"


SEEDS = os.environ.get("SCENARIO_SEEDS")
"""With the seeds 1 to this one they are played; else with that of the project."""

EACH = {
    EXAMPLES / "auction": 12,
    EXAMPLES / "cell": 14,
    EXAMPLES / "goalie": 15,
    EXAMPLES / "home": 15,
    EXAMPLES / "hospital": 14,
    EXAMPLES / "meetings": 19,
    EXAMPLES / "patrol": 20,
    EXAMPLES / "robocup": 31,
    EXAMPLES / "warehouse": 11,
    ACCEPTANCE / "contract_net.aseme": 11,
    ACCEPTANCE / "kouretes.aseme": 18,
    ACCEPTANCE / "testbehavior.aseme": 5,
}


@pytest.mark.parametrize(
    ("target", "number"), EACH.items(), ids=[str(path.relative_to(ROOT)) for path in EACH]
)
def test_they_pass_and_reach_nearly_every_state(
    target: Path,
    number: int,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
) -> None:
    monkeypatch.chdir(tmp_path)
    seeds = ("--seeds", SEEDS) if SEEDS else ()
    done = Here(capsys)("test", target, "-j", "1", "--json", "--fail-under", "95", *seeds)
    verdicts = [item["verdict"] for item in done.json["scenarios"]]
    assert verdicts == ["passed"] * number, done.out
    assert done.code == 0, done.err


def test_every_example_and_every_acceptance_file_has_some() -> None:
    assert set(EACH) == {
        *(path.parent for path in EXAMPLES.glob("*/pyproject.toml")),
        *(ACCEPTANCE / path.name for path in ACCEPTANCE.parent.glob("*.aseme")),
    }
    assert sum(number for path, number in EACH.items() if path.parent == EXAMPLES) >= 60
