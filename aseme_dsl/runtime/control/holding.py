"""Holding: a thread holds agents between the phases of a swap, and decides alone if it hears nothing."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import field
from queue import Empty, SimpleQueue
from typing import TYPE_CHECKING

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.control.replies import Reply

if TYPE_CHECKING:
    from aseme_dsl.runtime.team.swap import Swap

_LOOK_SECONDS = 0.002


class NotHeld(Exception):
    """What was said came too late, or could not be done; the text says why."""


@dataclass
class Said:
    """Something that is said to who holds the agents, and the reply."""

    phase: str
    reason: str
    reply: Reply = field(default_factory=Reply)
    refused: str = ""
    done: threading.Event = field(default_factory=threading.Event)


@dataclass(frozen=True, slots=True)
class Keep:
    """What is done about the epoch of a swap when it is committed, rolled back, or done."""

    commit: Callable[[], None]
    undo: Callable[[], None]
    finished: Callable[[], None]


class Held(threading.Thread):
    """Holds the agents between prepare and finish: locks are for one thread."""

    def __init__(self, swap: Swap, number: int, within: float, hold: float, keep: Keep) -> None:
        super().__init__(name="aseme swap", daemon=True)
        self.number = number
        self.state = "waiting"
        self.prepared = threading.Event()
        self._swap = swap
        self._within = within
        self._hold = hold
        self._keep = keep
        self._said: SimpleQueue[Said] = SimpleQueue()

    def say(self, phase: str, reason: str) -> Reply:
        """Say what comes next, and wait until it has been done."""
        said = Said(phase, reason)
        self._said.put(said)
        if not said.done.wait(self._hold + 5.0) or said.refused:
            raise NotHeld(said.refused or "no answer")
        return said.reply

    def run(self) -> None:
        try:
            if self._prepare():
                self._obey()
        finally:
            self.prepared.set()
            while True:  # no request waits for ever
                try:
                    late = self._said.get_nowait()
                except Empty:
                    return
                late.refused = f"the swap {self.number} is {self.state}"
                late.done.set()

    def _prepare(self) -> bool:
        swap = self._swap
        deadline = time.monotonic() + self._within
        while not swap.hold():
            if swap.state != "waiting":
                self.state = swap.state
                return False
            if time.monotonic() >= deadline:
                self.state = "busy"
                return False
            time.sleep(_LOOK_SECONDS)
        self.state = "prepared"
        self.prepared.set()
        return True

    def _obey(self) -> None:
        until = time.monotonic() + self._hold
        while self.state in ("prepared", "committed"):
            try:
                said = self._said.get(timeout=max(0.0, until - time.monotonic()))
            except Empty:
                silence = f"no supervisor has confirmed it within {self._hold:g} s"
                said = Said("finish" if self.state == "committed" else "rollback", silence)
            try:
                if said.phase == "commit":
                    self._keep.commit()  # so that a restart from now on begins in the new version
                    self.state = "committed"
                    until = time.monotonic() + self._hold
                elif said.phase == "finish" and self.state == "committed":
                    self.state = "done"
                    self._swap.finish()
                    self._keep.finished()
                elif said.phase == "finish":
                    said.refused = "it has not been committed"
                else:
                    if self.state == "committed":
                        self._keep.undo()
                    self.state = "rolled back"
                    self._swap.roll_back(said.reason)
            except Exception as error:  # of a new version's code, say: the operator must hear of it
                said.refused = f"{type(error).__name__}: {error}"
            said.reply = {"state": self.state}
            said.done.set()
