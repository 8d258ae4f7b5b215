"""Eight loops of two activities, by hand: in the first, the second activity waits for the ball.

`is_b1` and so on say whether the second activity of a loop runs. A table of methods says what the end of
which activity means: among sixteen, that is faster than comparing.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


class Machine:
    """Goes on in the loop of which an activity has ended."""

    __slots__ = ("bb", "has_ended", "is_b1", "is_b2", "is_b3", "is_b4", "is_b5", "is_b6", "is_b7", "is_b8")

    def __init__(self, bb: dict[str, Any]) -> None:
        self.bb = bb
        self.start_loops()

    def start_loops(self) -> None:
        """Begin with the first activity of each loop."""
        self.has_ended = False  # A1, which is still there until the ball is near
        self.is_b1 = self.is_b2 = self.is_b3 = self.is_b4 = False
        self.is_b5 = self.is_b6 = self.is_b7 = self.is_b8 = False

    def start(self) -> None:
        """Start the first activity of each loop."""
        bb = self.bb
        self.start_loops()
        for number in range(1, 9):
            bb[f"entered_A{number}"] += 1

    def done(self, activity: str) -> bool:
        """Take the end of an activity; say whether anything was done."""
        bb = self.bb
        moved = ENDS[activity](self, bb)
        if self.has_ended:
            ball = bb["ball"]
            if ball is not None and ball.near:
                self.has_ended = False
                self.is_b1 = True
                bb["entered_B1"] = bb["entered_B1"] + 1
                return True
        return moved

    def a1_ended(self, bb: dict[str, Any]) -> bool:
        """The first activity of loop 1 has ended: the second one may have to wait."""
        if not self.is_b1:
            self.has_ended = True
        return False

    def b1_ended(self, bb: dict[str, Any]) -> bool:
        """The second activity of loop 1 has ended."""
        if self.is_b1:
            self.is_b1 = False
            bb["entered_A1"] = bb["entered_A1"] + 1
            return True
        return False

    def a2_ended(self, bb: dict[str, Any]) -> bool:
        """The first activity of loop 2 has ended."""
        if not self.is_b2:
            self.is_b2 = True
            bb["entered_B2"] = bb["entered_B2"] + 1
            return True
        return False

    def b2_ended(self, bb: dict[str, Any]) -> bool:
        """The second activity of loop 2 has ended."""
        if self.is_b2:
            self.is_b2 = False
            bb["entered_A2"] = bb["entered_A2"] + 1
            return True
        return False

    def a3_ended(self, bb: dict[str, Any]) -> bool:
        """The first activity of loop 3 has ended."""
        if not self.is_b3:
            self.is_b3 = True
            bb["entered_B3"] = bb["entered_B3"] + 1
            return True
        return False

    def b3_ended(self, bb: dict[str, Any]) -> bool:
        """The second activity of loop 3 has ended."""
        if self.is_b3:
            self.is_b3 = False
            bb["entered_A3"] = bb["entered_A3"] + 1
            return True
        return False

    def a4_ended(self, bb: dict[str, Any]) -> bool:
        """The first activity of loop 4 has ended."""
        if not self.is_b4:
            self.is_b4 = True
            bb["entered_B4"] = bb["entered_B4"] + 1
            return True
        return False

    def b4_ended(self, bb: dict[str, Any]) -> bool:
        """The second activity of loop 4 has ended."""
        if self.is_b4:
            self.is_b4 = False
            bb["entered_A4"] = bb["entered_A4"] + 1
            return True
        return False

    def a5_ended(self, bb: dict[str, Any]) -> bool:
        """The first activity of loop 5 has ended."""
        if not self.is_b5:
            self.is_b5 = True
            bb["entered_B5"] = bb["entered_B5"] + 1
            return True
        return False

    def b5_ended(self, bb: dict[str, Any]) -> bool:
        """The second activity of loop 5 has ended."""
        if self.is_b5:
            self.is_b5 = False
            bb["entered_A5"] = bb["entered_A5"] + 1
            return True
        return False

    def a6_ended(self, bb: dict[str, Any]) -> bool:
        """The first activity of loop 6 has ended."""
        if not self.is_b6:
            self.is_b6 = True
            bb["entered_B6"] = bb["entered_B6"] + 1
            return True
        return False

    def b6_ended(self, bb: dict[str, Any]) -> bool:
        """The second activity of loop 6 has ended."""
        if self.is_b6:
            self.is_b6 = False
            bb["entered_A6"] = bb["entered_A6"] + 1
            return True
        return False

    def a7_ended(self, bb: dict[str, Any]) -> bool:
        """The first activity of loop 7 has ended."""
        if not self.is_b7:
            self.is_b7 = True
            bb["entered_B7"] = bb["entered_B7"] + 1
            return True
        return False

    def b7_ended(self, bb: dict[str, Any]) -> bool:
        """The second activity of loop 7 has ended."""
        if self.is_b7:
            self.is_b7 = False
            bb["entered_A7"] = bb["entered_A7"] + 1
            return True
        return False

    def a8_ended(self, bb: dict[str, Any]) -> bool:
        """The first activity of loop 8 has ended."""
        if not self.is_b8:
            self.is_b8 = True
            bb["entered_B8"] = bb["entered_B8"] + 1
            return True
        return False

    def b8_ended(self, bb: dict[str, Any]) -> bool:
        """The second activity of loop 8 has ended."""
        if self.is_b8:
            self.is_b8 = False
            bb["entered_A8"] = bb["entered_A8"] + 1
            return True
        return False

    def leaves(self) -> tuple[str, ...]:
        """The active state of each loop."""
        second = (
            self.is_b1,
            self.is_b2,
            self.is_b3,
            self.is_b4,
            self.is_b5,
            self.is_b6,
            self.is_b7,
            self.is_b8,
        )
        return tuple(f"{'B' if is_b else 'A'}{number}" for number, is_b in enumerate(second, start=1))


ENDS: dict[str, Callable[[Machine, dict[str, Any]], bool]] = {
    "A1": Machine.a1_ended,
    "B1": Machine.b1_ended,
    "A2": Machine.a2_ended,
    "B2": Machine.b2_ended,
    "A3": Machine.a3_ended,
    "B3": Machine.b3_ended,
    "A4": Machine.a4_ended,
    "B4": Machine.b4_ended,
    "A5": Machine.a5_ended,
    "B5": Machine.b5_ended,
    "A6": Machine.a6_ended,
    "B6": Machine.b6_ended,
    "A7": Machine.a7_ended,
    "B7": Machine.b7_ended,
    "A8": Machine.a8_ended,
    "B8": Machine.b8_ended,
}
