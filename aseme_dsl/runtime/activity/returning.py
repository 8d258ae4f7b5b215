"""Returning: how the code of an activity has come to its end, as text."""

from __future__ import annotations

import traceback
from pathlib import Path

_CANCELLATIONS = ("Cancelled", "CancelledError", "GeneratorExit")
"""How a cancelled activity may end without having failed."""
_RUNTIME = str(Path(__file__).parents[1])


def as_outcome(result: object) -> str | None:
    """What an activity has returned as the name of an outcome; for any other value, its type: `<int>`."""
    if result is None or isinstance(result, str):
        return result if result is None else str.__str__(result)
    return f"<{type(result).__name__}>"


def is_cancellation(error: BaseException) -> bool:
    """Whether something that was cancelled may end like this without having failed."""
    return type(error).__name__ in _CANCELLATIONS


def reason_of(error: BaseException) -> str:
    """An exception in one line."""
    text = str(error)
    if hasattr(error, "frames"):  # reported by another process: the text is the whole
        return text
    return f"{type(error).__name__}: {text}" if text else type(error).__name__


def frames_of(error: BaseException, own: bool = False) -> list[dict[str, object]] | None:
    """Where an exception was raised, outermost first; the runtime's own frames only if it is asked to."""
    frames: list[dict[str, object]] = [
        {"file": Path(frame.filename).name, "line": frame.lineno, "function": frame.name}
        for frame in traceback.extract_tb(error.__traceback__)
        if own or not frame.filename.startswith(_RUNTIME)
    ]
    return frames or getattr(error, "frames", None)
