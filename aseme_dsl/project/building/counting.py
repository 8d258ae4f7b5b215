"""Counting: how much of the code is generated and how much is written by hand (P1 Table 2, P2 §4.1)."""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Amount:
    """Some code: files, lines that are not blank, and bytes."""

    files: int = 0
    lines: int = 0
    bytes: int = 0

    def __add__(self, other: Amount) -> Amount:
        return Amount(self.files + other.files, self.lines + other.lines, self.bytes + other.bytes)


@dataclass(frozen=True, slots=True)
class Count:
    """The code of a system: what backends generated, the activities people wrote, and the `.aseme` text.

    An activity that is still as it was generated counts as generated. The papers compare the first two.
    """

    generated: Amount = Amount()
    by_hand: Amount = Amount()
    source: Amount = Amount()

    @property
    def lines(self) -> int:
        """The lines of generated code and activities together."""
        return self.generated.lines + self.by_hand.lines

    @property
    def bytes(self) -> int:
        """The bytes of generated code and activities together."""
        return self.generated.bytes + self.by_hand.bytes


def amount(contents: Iterable[bytes]) -> Amount:
    """How much these files are."""
    total = Amount()
    for content in contents:
        lines = sum(1 for line in content.splitlines() if line.strip())
        total += Amount(1, lines, len(content))
    return total
