"""Processes that a run leaves behind, such as what an activity has forked: they end with the run."""

from __future__ import annotations

import ctypes
import os
import signal
import sys
import time
from collections.abc import Callable, Iterator, Set
from contextlib import contextmanager, suppress
from pathlib import Path

_SET_CHILD_SUBREAPER, _GET_CHILD_SUBREAPER = 36, 37  # <linux/prctl.h>
_PATIENCE = 2.0
"""Seconds within which everything that is left must be dead; a process that the kernel holds is given up."""


@contextmanager
def ending_descendants(tell: Callable[[str], None]) -> Iterator[None]:
    """At the end, kill each process that was started meanwhile by this one or its children, and tell which.

    It makes this process the parent of its orphaned descendants, and so finds them. It leaves processes alone
    that ran before. It is for programs of our own: a program that embeds a run may start processes meanwhile.
    Systems other than Linux know no such parent: there nothing is killed.
    """
    if sys.platform != "linux":
        yield
        return
    before = set(_children())
    adopts = adopt_descendants()
    try:
        yield
    finally:
        kill_descendants(tell, before)
        ctypes.CDLL(None).prctl(_SET_CHILD_SUBREAPER, adopts, 0, 0, 0)


def adopt_descendants() -> int:
    """Make this process the parent of its orphaned descendants (on Linux); whether it was, as a number."""
    if sys.platform != "linux":
        return 0
    adopts = ctypes.c_int()
    prctl = ctypes.CDLL(None).prctl
    prctl(_GET_CHILD_SUBREAPER, ctypes.byref(adopts), 0, 0, 0)
    prctl(_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
    return adopts.value


def kill_descendants(tell: Callable[[str], None], spared: Set[int] = frozenset()) -> None:
    """Kill each child but the spared ones, and theirs as they are adopted; tell which they were."""
    if sys.platform == "linux":
        _kill(spared, tell)


def _kill(spared: Set[int], tell: Callable[[str], None]) -> None:
    """Kill our children, and theirs as they become ours, until there is none."""
    told: set[int] = set()
    deadline = time.monotonic() + _PATIENCE
    while left := [child for child in _children() if child not in spared]:
        for child in left:
            command = _command(child)
            with suppress(ProcessLookupError, PermissionError):
                os.kill(child, signal.SIGKILL)
            if command and child not in told:
                with suppress(OSError):  # the output has no reader: all the more reason to continue
                    tell(f"process {child} was left behind by the run and has been killed: {command}")
            told.add(child)
            with suppress(ChildProcessError):
                os.waitpid(child, os.WNOHANG)
        if time.monotonic() > deadline:
            return
        time.sleep(0.002)


def _children() -> Iterator[int]:
    """The processes whose parent is this one, dead ones that were not waited for included."""
    me = os.getpid()
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        with suppress(OSError):
            # The name in brackets may have any characters; state and parent follow its last bracket.
            status = (entry / "stat").read_bytes().rpartition(b")")[2].split()
            if int(status[1]) == me:
                yield int(entry.name)


def _command(process: int) -> str:
    """What it was started as, on one line; empty if it is dead."""
    try:
        words = Path(f"/proc/{process}/cmdline").read_bytes().split(b"\0")
    except OSError:
        return ""
    text = " ".join(b" ".join(words).decode("utf-8", "backslashreplace").split())
    return text if len(text) <= 80 else text[:79] + "…"
