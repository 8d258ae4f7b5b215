"""Settings of the whole process that a piece of work needs: put back when the last that needs them has ended.

Several may need one at once, in threads of one process, and they end in any order. Where other code has
changed the setting meanwhile, it stays as it is.
"""

from __future__ import annotations

import gc
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager

_lock = threading.Lock()
_wanted: list[float] = []
"""The switch intervals that are needed now, in seconds."""
_usual = 0.0
"""The one that there was before."""
_ours = 0.0
"""The one that was set last here."""
_quiet = 0
"""How many need the collector of cycles to be off."""
_was_on = False


@contextmanager
def switching(seconds: float) -> Iterator[None]:
    """Inside, no thread keeps the interpreter from another for longer (`sys.setswitchinterval`)."""
    global _usual
    with _lock:
        if not _wanted:
            _usual = sys.getswitchinterval()
        _wanted.append(seconds)
        _apply()
    try:
        yield
    finally:
        with _lock:
            theirs = sys.getswitchinterval() != _ours
            _wanted.remove(seconds)
            if not theirs:
                _apply()


def _apply() -> None:
    """Called with the lock."""
    global _ours
    sys.setswitchinterval(min(_usual, *_wanted) if _wanted else _usual)
    _ours = sys.getswitchinterval()  # as the interpreter rounds it


@contextmanager
def uncollected() -> Iterator[None]:
    """Inside, Python does not look for cycles of objects (`gc.disable`), so that times can be measured."""
    global _quiet, _was_on
    with _lock:
        if not _quiet:
            _was_on = gc.isenabled()
        _quiet += 1
        gc.disable()
    try:
        yield
    finally:
        with _lock:
            _quiet -= 1
            if not _quiet and _was_on:
                gc.enable()
