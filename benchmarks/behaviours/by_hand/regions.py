"""Eight regions that all move on one event, by hand."""

from __future__ import annotations

from typing import Any


class Machine:
    """A flag a region: whether its second state is active."""

    __slots__ = ("bb", "r1", "r2", "r3", "r4", "r5", "r6", "r7", "r8")

    def __init__(self, bb: dict[str, Any]) -> None:
        self.bb = bb
        self.start_regions()

    def start_regions(self) -> None:
        """Put all regions into their first state."""
        self.r1 = self.r2 = self.r3 = self.r4 = self.r5 = self.r6 = self.r7 = self.r8 = False

    def start(self) -> None:
        """Enter the first state of each region."""
        bb = self.bb
        self.start_regions()
        for number in range(1, 9):
            bb[f"entered_r{number}x"] += 1

    def send(self, event: str) -> bool:
        """Take one event; say whether anything was done."""
        if event != "toggle":
            return False
        bb = self.bb
        if self.r1:
            self.r1 = False
            bb["entered_r1x"] = bb["entered_r1x"] + 1
        else:
            self.r1 = True
            bb["entered_r1y"] = bb["entered_r1y"] + 1
        if self.r2:
            self.r2 = False
            bb["entered_r2x"] = bb["entered_r2x"] + 1
        else:
            self.r2 = True
            bb["entered_r2y"] = bb["entered_r2y"] + 1
        if self.r3:
            self.r3 = False
            bb["entered_r3x"] = bb["entered_r3x"] + 1
        else:
            self.r3 = True
            bb["entered_r3y"] = bb["entered_r3y"] + 1
        if self.r4:
            self.r4 = False
            bb["entered_r4x"] = bb["entered_r4x"] + 1
        else:
            self.r4 = True
            bb["entered_r4y"] = bb["entered_r4y"] + 1
        if self.r5:
            self.r5 = False
            bb["entered_r5x"] = bb["entered_r5x"] + 1
        else:
            self.r5 = True
            bb["entered_r5y"] = bb["entered_r5y"] + 1
        if self.r6:
            self.r6 = False
            bb["entered_r6x"] = bb["entered_r6x"] + 1
        else:
            self.r6 = True
            bb["entered_r6y"] = bb["entered_r6y"] + 1
        if self.r7:
            self.r7 = False
            bb["entered_r7x"] = bb["entered_r7x"] + 1
        else:
            self.r7 = True
            bb["entered_r7y"] = bb["entered_r7y"] + 1
        if self.r8:
            self.r8 = False
            bb["entered_r8x"] = bb["entered_r8x"] + 1
        else:
            self.r8 = True
            bb["entered_r8y"] = bb["entered_r8y"] + 1
        return True

    def leaves(self) -> tuple[str, ...]:
        """The active state of each region."""
        second = (self.r1, self.r2, self.r3, self.r4, self.r5, self.r6, self.r7, self.r8)
        return tuple(
            f"r{number}{'y' if is_second else 'x'}" for number, is_second in enumerate(second, start=1)
        )
