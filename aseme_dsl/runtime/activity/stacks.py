"""Stacks: where a thread is in its code just now, for the report of one that is stuck."""

from __future__ import annotations

import sys
import threading
import traceback
from pathlib import Path

_RUNTIME = str(Path(__file__).parents[1])
_THREADING = threading.__file__


def place_of(thread: int | None) -> str:
    """What a thread does: " (at walk.py:12 in execute)", of code that is not the runtime's; "" if unknown."""
    frame = sys._current_frames().get(thread) if thread is not None else None
    if frame is None:
        return ""
    for entry in reversed(traceback.extract_stack(frame)):
        if not entry.filename.startswith(_RUNTIME) and entry.filename != _THREADING:
            return f" (at {Path(entry.filename).name}:{entry.lineno} in {entry.name})"
    return ""


def activity_of(thread: int | None) -> tuple[str, ...]:
    """The agent and the activity whose code a thread runs; nothing if it runs none."""
    from aseme_dsl.runtime.activity.execution import Execution

    frame = sys._current_frames().get(thread) if thread is not None else None
    while frame is not None:
        if frame.f_code.co_filename.startswith(_RUNTIME):
            for name in ("self", "execution"):
                found = frame.f_locals.get(name)
                if isinstance(found, Execution):
                    return found.agent, found.activity
        frame = frame.f_back
    return ()
