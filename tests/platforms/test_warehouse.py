"""The warehouse over a real XMPP server: a process for the desk and for each of the eight carriers."""

from __future__ import annotations

import importlib.util
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.platforms.conftest import LANE

EXAMPLE = Path(__file__).parents[2] / "examples" / "warehouse"


@pytest.mark.skipif(importlib.util.find_spec("spade") is None, reason=f"SPADE is not installed; {LANE}")
def test_jobs_are_announced_awarded_and_done(tmp_path: Path) -> None:
    project = tmp_path / "warehouse"
    shutil.copytree(EXAMPLE, project, ignore=shutil.ignore_patterns("build", "__pycache__"))
    asemec = [sys.executable, "-m", "aseme_dsl"]
    options = ["--platform", "spade", "--process-per-agent", "--for", "50s"]
    done = subprocess.run(
        [*asemec, "run", str(project), *options], capture_output=True, encoding="utf-8", timeout=240
    )
    told = done.stdout + done.stderr
    assert "is at the gate: carrier" in told, told
    assert "(9 processes)" in told, told

    traces = sorted((project / "build").glob("trace.*.jsonl.gz"))
    said = subprocess.run(
        [*asemec, "sniff", *map(str, traces)], capture_output=True, encoding="utf-8", timeout=60
    ).stdout
    for text in (
        "desk      -- cfp Job",
        "-- propose Proposal",
        "-- accept_proposal Contract",
        "-- inform Outcome",
    ):
        assert text in said, said
