"""The cost of a message of a conversation, in calls of functions: these do not depend on the load."""

from __future__ import annotations

import itertools
import sys
import threading
from types import FrameType

import pytest

from benchmarks import agents
from tests.support.generated import Generated, generate

BEFORE = 100
"""So many functions in Python a message called at 352b81e, before the moves of protocols were enforced."""


def calls(generated: Generated, passes: int, monkeypatch: pytest.MonkeyPatch) -> tuple[int, int]:
    """How many functions are called in the threads of a rally, and how many messages are sent in it."""
    monkeypatch.setattr(agents, "PASSES", passes)
    count = itertools.count()

    def note(frame: FrameType, event: str, _: object) -> None:
        if event == "call":
            next(count)

    threading.setprofile(note)  # the thread that runs the team only waits
    try:
        messages = len(agents.rally(generated))
    finally:
        threading.setprofile(None)
    return next(count), messages


def test_a_message_is_about_as_expensive_as_one_that_is_not_checked(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "agents", agents)  # so the functions of its text are called
    generated = generate(agents.TEXT)
    few, many = calls(generated, 50, monkeypatch), calls(generated, 3000, monkeypatch)
    each = (many[0] - few[0]) / (many[1] - few[1])
    assert 0 < each <= 1.15 * BEFORE, f"{each:.0f} calls a message"
