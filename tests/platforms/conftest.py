"""What the tests of agent platforms stand on: a server that the test may stop and start."""

from __future__ import annotations

import importlib.util
import shutil
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from tests.platforms.servers import Server

LANE = "run them with: python3 dev.py long, or tests/platforms/lane.py"


@contextmanager
def xmpp_server(kind: str) -> Iterator[Server]:
    """A running XMPP server; the test is skipped where there is none."""
    if importlib.util.find_spec("spade") is None:
        pytest.skip(f"SPADE is not installed; {LANE}")
    if kind == "prosody" and shutil.which("prosody") is None:
        pytest.skip("Prosody is not installed: apt-get install prosody")
    found = Server(kind)
    try:
        yield found.start()
    finally:
        found.close()


@pytest.fixture(params=["embedded", "prosody"])
def server(request: pytest.FixtureRequest) -> Iterator[Server]:
    """A running XMPP server of its own for one test."""
    with xmpp_server(request.param) as found:
        yield found
