"""Runs packer of Warehouse: one integer a region says which state is active.

Generated from a.aseme by asemec; edit that file, not this one. The comment above each test says which
transition it is, what was written, and where.
"""

# Conditions stand on one line, branches inside the way to them, names are the document's, and its functions
# may raise anything.
# ruff: noqa: E501, SIM102, N801, N999, BLE001, RUF100
from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar

from aseme_dsl.runtime.chart.board import Board
from aseme_dsl.runtime.chart.chart import INACTIVE, Chart

from ..messages import Order
from .plan import PLAN


class Board0(Board):
    """What region 0 knows."""

    __slots__ = ("desk_signal_Order",)
    CHANNELS = frozenset(["desk.signal.Order"])
    QUEUED = frozenset(["desk.signal.Order"])
    SLOTS: ClassVar[Mapping[str, tuple[tuple[str, str | None], ...]]] = {
        "desk.signal.Order": (("desk_signal_Order", None),)
    }
    desk_signal_Order: Order | None


class PackerStep(Chart):
    """Runs the statechart packer of Warehouse."""

    __slots__ = (
        "b0",
        "k0",
        "r0",
    )

    PLAN = PLAN
    REGIONS = ("0",)
    READERS: ClassVar[Mapping[str, tuple[int, ...]]] = {"desk.signal.Order": (0,)}
    RUNNING: ClassVar[Mapping[str, tuple[str, str, int]]] = {"0.2": ("r0", "k0", 1)}
    VARIABLES: ClassVar[Mapping[str, tuple[str, ...]]] = {}
    MESSAGES: ClassVar[Mapping[str, Any]] = {}
    TIMES: ClassVar[Mapping[str, str]] = {}
    WAITING: ClassVar[frozenset[str]] = frozenset(["0.2"])
    LEAVES: ClassVar[tuple[tuple[str, ...], ...]] = (("0.1", "0.2", "0.2", "0.3"),)

    def __init__(self, agent: str) -> None:
        super().__init__(agent)
        self.r0: int = INACTIVE
        self.k0: int = 0
        self.b0: Board0 = Board0()

    def _region_0(self, now: int) -> bool:
        """One round of region 0."""
        b = self.b0
        r = self.r0
        if r == 0:  # 0.1 START
            # 0.1 -> 0.2 Idle  (a.aseme:24:23)
            self.taken.append((0,))
            self.r0 = 1
            self.k0 = self.begin("0.2", "Idle")
            return True
        elif r == 1:  # 0.2 Idle runs
            # 0.2 -> 0.3  when [desk.signal.Order.item == "last"]  (a.aseme:26:20)
            b.ask("desk.signal.Order", None)
            if (m1_1 := b.desk_signal_Order) is not None and m1_1.item == "last":
                self.taken.append((1,))
                self.cancel("0.2", "Idle", self.k0)
                self.r0 = 3
                b.spend("desk.signal.Order", None)
                return True
        elif r == 2:  # 0.2 Idle is complete
            # 0.2 -> 0.3  when [desk.signal.Order.item == "last"]  (a.aseme:26:20)
            b.ask("desk.signal.Order", None)
            if (m2_1 := b.desk_signal_Order) is not None and m2_1.item == "last":
                self.taken.append((1,))
                self.r0 = 3
                b.spend("desk.signal.Order", None)
                return True
        return False

    def _leave_leaf_0(self) -> None:
        """Leave the active leaf of region 0."""
        r = self.r0
        running = _RUNNING_0.get(r)
        if running is not None:
            self.cancel(*running, self.k0)

    def _leave_0(self) -> None:
        """Leave region 0."""
        self._leave_leaf_0()
        self.r0 = INACTIVE

    def enter(self) -> None:
        """Enter the root."""
        self.r0 = 0

    def round(self) -> bool:
        """One round over all regions."""
        return self._region_0(self.now)

    def leave(self) -> None:
        """Leave everything."""
        self._leave_0()

    def is_finished(self) -> bool:
        """Whether the root's END is active."""
        return self.r0 == 3

    def boards(self) -> tuple[Board | None, ...]:
        """The blackboard of each region."""
        return (self.b0,)

    def due(self, now: int) -> int | None:
        """The next moment at which time alone may matter."""
        return None

    def configuration(self) -> tuple[str, ...]:
        """The labels of the active leaves."""
        numbers = (self.r0,)
        return tuple(labels[n] for labels, n in zip(self.LEAVES, numbers, strict=True) if n >= 0)


_RUNNING_0: dict[int, tuple[str, str]] = {1: ("0.2", "Idle")}
