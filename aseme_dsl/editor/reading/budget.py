"""Budget: a call that is given up after some time of computing, also inside of a regular expression.

A signal interrupts it. So that works in the main thread only, and not on Windows.
"""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable
from types import FrameType
from typing import ParamSpec, TypeVar

_T = TypeVar("_T")
_P = ParamSpec("_P")

AGAIN = 0.05
"""Seconds after which a call that has swallowed the exception gets another one."""


class OutOfTime(BaseException):
    """The budget of a call is exhausted. No `except Exception` on its way is meant."""


def may_interrupt() -> bool:
    """Whether a call can be given up here."""
    return hasattr(signal, "setitimer") and threading.current_thread() is threading.main_thread()


def within(seconds: float, function: Callable[_P, _T], *arguments: _P.args, **named: _P.kwargs) -> _T:
    """`function(*arguments, **named)`, given up when the process has computed for so many seconds.

    Raises:
        OutOfTime: It was given up.
    """
    before = signal.signal(signal.SIGVTALRM, _ring)
    try:
        signal.setitimer(signal.ITIMER_VIRTUAL, seconds, AGAIN)
        return function(*arguments, **named)
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


def _ring(number: int, frame: FrameType | None) -> None:
    while frame is not None:
        if frame.f_code is within.__code__:
            raise OutOfTime
        frame = frame.f_back
    signal.setitimer(signal.ITIMER_VIRTUAL, 0)  # it came late: the call is over


__all__ = ["OutOfTime", "may_interrupt", "within"]
