"""Two states that lead to each other, by hand."""

from __future__ import annotations

from typing import Any

S1, S2 = range(2)


class Machine:
    """Goes from s1 to s2 on `ping` and back on `pong`."""

    __slots__ = ("bb", "state")

    def __init__(self, bb: dict[str, Any]) -> None:
        self.bb = bb
        self.state = S1

    def start(self) -> None:
        """Enter s1."""
        bb = self.bb
        bb["entered_s1"] = bb["entered_s1"] + 1
        self.state = S1

    def send(self, event: str) -> bool:
        """Take one event; say whether anything was done."""
        if self.state == S1:
            if event == "ping":
                self.state = S2
                bb = self.bb
                bb["entered_s2"] = bb["entered_s2"] + 1
                return True
        elif event == "pong":
            self.state = S1
            bb = self.bb
            bb["entered_s1"] = bb["entered_s1"] + 1
            return True
        return False

    def leaves(self) -> tuple[str, ...]:
        """The active state."""
        return ("s1",) if self.state == S1 else ("s2",)
