"""What the tests of security have in common."""

from __future__ import annotations

import subprocess
from collections.abc import Callable

import pytest

from tests.security.users import can_be_another, run_as_other

AsOther = Callable[..., "subprocess.CompletedProcess[str]"]


@pytest.fixture
def as_other() -> AsOther:
    """`tests.security.users.run_as_other`; the test is left out, loudly, where that cannot be."""
    if not can_be_another():
        pytest.skip("NOT TESTED: attacks by another user of this machine need tests that run as root")
    return run_as_other


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Say at the end what was left out: a list of dots does not show it."""
    skipped = terminalreporter.stats.get("skipped", [])
    reasons = {str(report.longrepr[2]) for report in skipped if isinstance(report.longrepr, tuple)}
    for reason in sorted(reason for reason in reasons if "NOT TESTED" in reason):
        terminalreporter.write_line(reason.removeprefix("Skipped: "), yellow=True, bold=True)
