"""A state that twenty conditions could end, by hand."""

from __future__ import annotations

from typing import Any


class Machine:
    """Waits until one of twenty flags is true at a `tick`."""

    __slots__ = ("bb", "is_woken")

    def __init__(self, bb: dict[str, Any]) -> None:
        self.bb = bb
        self.is_woken = False

    def start(self) -> None:
        """Begin to wait."""
        self.is_woken = False
        bb = self.bb
        bb["entered_Waiting"] = bb["entered_Waiting"] + 1

    def send(self, event: str) -> bool:
        """Take one event; say whether anything was done."""
        if event == "tick" and not self.is_woken:
            bb = self.bb
            if (
                bb["flag_1"]
                or bb["flag_2"]
                or bb["flag_3"]
                or bb["flag_4"]
                or bb["flag_5"]
                or bb["flag_6"]
                or bb["flag_7"]
                or bb["flag_8"]
                or bb["flag_9"]
                or bb["flag_10"]
                or bb["flag_11"]
                or bb["flag_12"]
                or bb["flag_13"]
                or bb["flag_14"]
                or bb["flag_15"]
                or bb["flag_16"]
                or bb["flag_17"]
                or bb["flag_18"]
                or bb["flag_19"]
                or bb["flag_20"]
            ):
                self.is_woken = True
                bb["entered_Woken"] = bb["entered_Woken"] + 1
                return True
        return False

    def leaves(self) -> tuple[str, ...]:
        """The active state."""
        return ("Woken",) if self.is_woken else ("Waiting",)
