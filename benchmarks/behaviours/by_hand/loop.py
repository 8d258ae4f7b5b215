"""`(A . B)~`, by hand: two activities in turn."""

from __future__ import annotations

from typing import Any


class Machine:
    """Goes from one activity to the other when it has ended."""

    __slots__ = ("bb", "is_b")

    def __init__(self, bb: dict[str, Any]) -> None:
        self.bb = bb
        self.is_b = False

    def start(self) -> None:
        """Begin with the first one."""
        self.is_b = False
        bb = self.bb
        bb["entered_A"] = bb["entered_A"] + 1

    def done(self, activity: str) -> bool:
        """Take the end of an activity; say whether anything was done."""
        if self.is_b:
            if activity == "B":
                self.is_b = False
                bb = self.bb
                bb["entered_A"] = bb["entered_A"] + 1
                return True
        elif activity == "A":
            self.is_b = True
            bb = self.bb
            bb["entered_B"] = bb["entered_B"] + 1
            return True
        return False

    def leaves(self) -> tuple[str, ...]:
        """The active state."""
        return ("B",) if self.is_b else ("A",)
