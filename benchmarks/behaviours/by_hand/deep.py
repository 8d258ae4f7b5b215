"""Two towers of eight states in each other, by hand: the place at the bottom says where one is."""

from __future__ import annotations

from typing import Any

A8, A8B, B8, B8B = range(4)
NAMES = ("a8", "a8b", "b8", "b8b")


class Machine:
    """`leaf` toggles at the bottom of a tower, `cross` leads to the top of the other one."""

    __slots__ = ("bb", "state")

    def __init__(self, bb: dict[str, Any]) -> None:
        self.bb = bb
        self.state = A8

    def start(self) -> None:
        """Enter the first tower."""
        bb = self.bb
        for level in range(1, 9):
            bb[f"entered_a{level}"] += 1
        self.state = A8

    def send(self, event: str) -> bool:
        """Take one event; say whether anything was done."""
        state = self.state
        if event == "leaf":
            if state == A8:
                self.state = A8B
                bb = self.bb
                bb["entered_a8b"] = bb["entered_a8b"] + 1
            elif state == A8B:
                self.state = A8
                bb = self.bb
                bb["entered_a8"] = bb["entered_a8"] + 1
            elif state == B8:
                self.state = B8B
                bb = self.bb
                bb["entered_b8b"] = bb["entered_b8b"] + 1
            else:
                self.state = B8
                bb = self.bb
                bb["entered_b8"] = bb["entered_b8"] + 1
            return True
        if event == "cross":
            bb = self.bb
            if state <= A8B:
                bb["entered_b1"] = bb["entered_b1"] + 1
                bb["entered_b2"] = bb["entered_b2"] + 1
                bb["entered_b3"] = bb["entered_b3"] + 1
                bb["entered_b4"] = bb["entered_b4"] + 1
                bb["entered_b5"] = bb["entered_b5"] + 1
                bb["entered_b6"] = bb["entered_b6"] + 1
                bb["entered_b7"] = bb["entered_b7"] + 1
                bb["entered_b8"] = bb["entered_b8"] + 1
                self.state = B8
            else:
                bb["entered_a1"] = bb["entered_a1"] + 1
                bb["entered_a2"] = bb["entered_a2"] + 1
                bb["entered_a3"] = bb["entered_a3"] + 1
                bb["entered_a4"] = bb["entered_a4"] + 1
                bb["entered_a5"] = bb["entered_a5"] + 1
                bb["entered_a6"] = bb["entered_a6"] + 1
                bb["entered_a7"] = bb["entered_a7"] + 1
                bb["entered_a8"] = bb["entered_a8"] + 1
                self.state = A8
            return True
        return False

    def leaves(self) -> tuple[str, ...]:
        """The state at the bottom."""
        return (NAMES[self.state],)
