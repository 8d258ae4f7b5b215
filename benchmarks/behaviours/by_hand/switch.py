"""A small machine of which a program has very many, by hand."""

from __future__ import annotations

from typing import Any

DIM, BRIGHT, OFF = range(3)
NAMES = ("Dim", "Bright", "Off")


class Machine:
    """A lamp with two brightnesses that can be turned off."""

    __slots__ = ("bb", "state")

    def __init__(self, bb: dict[str, Any]) -> None:
        self.bb = bb
        self.state = DIM

    def start(self) -> None:
        """Turn it on, dim."""
        self.state = DIM
        bb = self.bb
        bb["entered_Dim"] = bb["entered_Dim"] + 1

    def send(self, event: str) -> bool:
        """Take one event; say whether anything was done."""
        state = self.state
        if state == OFF:
            if event == "turn_on":
                self.state = DIM
                bb = self.bb
                bb["entered_Dim"] = bb["entered_Dim"] + 1
                return True
        elif event == "toggle":
            if state == DIM:
                self.state = BRIGHT
                bb = self.bb
                bb["entered_Bright"] = bb["entered_Bright"] + 1
            else:
                self.state = DIM
                bb = self.bb
                bb["entered_Dim"] = bb["entered_Dim"] + 1
            return True
        elif event == "turn_off":
            self.state = OFF
            bb = self.bb
            bb["entered_Off"] = bb["entered_Off"] + 1
            return True
        return False

    def leaves(self) -> tuple[str, ...]:
        """The active state."""
        return (NAMES[self.state],)
