"""Waiting for what other threads and processes do: as long as a busy machine may take, in one place."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from typing import TypeVar

T = TypeVar("T")

LONG = 180.0
"""How long, in seconds, anything may take before it counts as never. Where all is well nobody waits so."""


def wait_until(condition: Callable[[], T], seconds: float = LONG, pause: float = 0.002) -> T:
    """Wait for something to become true, and return it; fails loudly if it does not.

    `pause`, in seconds, lies between two looks: longer where looking costs something.
    """
    end = time.monotonic() + seconds
    while not (found := condition()):
        assert time.monotonic() < end, "it did not happen in time"
        time.sleep(pause)
    return found


def long_enough(
    run: Callable[[int], T], came_so_far: Callable[[T], bool], seconds: Sequence[int] = (3, 20, 90)
) -> T:
    """What a run in real time gave that was so many seconds long; a longer one where the machine is too busy.

    What is to be found in the result is looked at by the test; `came_so_far` says whether it can be expected.
    """
    *shorter, longest = seconds
    for length in shorter:
        if came_so_far(found := run(length)):
            return found
    return run(longest)
