"""Runs clerk of Warehouse: one integer a region says which state is active.

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
from aseme_dsl.runtime.chart.chart import ABSENT, INACTIVE, Chart

from ..messages import Order
from .plan import PLAN


class Board0(Board):
    """What region 0 knows."""

    __slots__ = ("desk_signal_Order",)
    CHANNELS = frozenset(["desk.signal.Order", "gate.state.Order"])
    QUEUED = frozenset(["desk.signal.Order"])
    SLOTS: ClassVar[Mapping[str, tuple[tuple[str, str | None], ...]]] = {
        "desk.signal.Order": (("desk_signal_Order", None),)
    }
    desk_signal_Order: Order | None


class ClerkStep(Chart):
    """Runs the statechart clerk of Warehouse."""

    __slots__ = (
        "b0",
        "k0",
        "r0",
        "v_mine",
        "v_now",
        "v_sent",
    )

    PLAN = PLAN
    REGIONS = ("0",)
    READERS: ClassVar[Mapping[str, tuple[int, ...]]] = {"desk.signal.Order": (0,), "gate.state.Order": (0,)}
    RUNNING: ClassVar[Mapping[str, tuple[str, str, int]]] = {"0.2.2": ("r0", "k0", 2), "0.3": ("r0", "k0", 5)}
    VARIABLES: ClassVar[Mapping[str, tuple[str, ...]]] = {
        "sent": ("v_sent",),
        "mine": ("v_mine",),
        "now": ("v_now",),
    }
    MESSAGES: ClassVar[Mapping[str, Any]] = {"desk.signal.Order": Order}
    TIMES: ClassVar[Mapping[str, str]] = {}
    MISSED: ClassVar[Mapping[str, tuple[tuple[int, str, tuple[tuple[int, int], ...]], ...]]] = {
        "desk.signal.Order": ((0, "r0", ((1, 4),)),)
    }
    LEAVES: ClassVar[tuple[tuple[str, ...], ...]] = (
        ("0.1", "0.2.1", "0.2.2", "0.2.2", "0.2.3", "0.3", "0.3", "0.4"),
    )

    def __init__(self, agent: str) -> None:
        super().__init__(agent)
        self.r0: int = INACTIVE
        self.k0: int = 0
        self.b0: Board0 = Board0()
        self.v_sent: int = 0
        self.v_mine: tuple[Order, ...] = ()
        self.v_now: Order | None = None

    def _region_0(self, now: int) -> bool:
        """One round of region 0."""
        b = self.b0
        r = self.r0
        if r < 3:
            if r == 0:  # 0.1 START
                # 0.1 -> 0.2 Sell+  (a.aseme:14:22)
                self.taken.append((0,))
                self.r0 = 1
                return True
            elif r == 1:  # 0.2.1 START
                # 0.2.1 -> 0.2.2 Sell  (a.aseme:14:22)
                self.taken.append((3,))
                self.r0 = 2
                self.k0 = self.begin("0.2.2", "Sell")
                return True
        else:
            if r == 3:  # 0.2.2 Sell is complete
                # 0.2.2 -> 0.2.2 Sell  [sent < 3] / sent += 1; append(mine, Order { id = sent, item = "box", place.x = 1.5, place.y = 2 }); now = Order { id = now.id + 1, ..mine[0] }  (a.aseme:17:5)
                if self.v_sent < 3:
                    self.taken.append((4,))
                    self.v_sent = self.v_sent + 1
                    try:
                        self.v_mine = self.short(
                            "mine",
                            4,
                            self.appended(
                                self.v_mine,
                                self.made(
                                    Order,
                                    None,
                                    (),
                                    (("id",), self.v_sent),
                                    (("item",), "box"),
                                    (("place", "x"), 1.5),
                                    (("place", "y"), float(2)),
                                ),
                            ),
                        )
                    except Exception as error:
                        self.fault(4, error)
                    try:
                        if (m3_1 := self.v_now) is not None and len(m3_2 := self.v_mine) > (m3_3 := 0) >= 0:
                            self.v_now = self.made(
                                Order, m3_2[m3_3], ("item", "place"), (("id",), (m3_1.id + 1))
                            )
                        else:
                            self.fault(4, ABSENT)
                    except Exception as error:
                        self.fault(4, error)
                    self.r0 = 2
                    self.k0 = self.begin("0.2.2", "Sell")
                    return True
                # 0.2.2 -> 0.2.3  else / now = Order { item = "last", ..mine[0] }; mine[0] = Order { .. }; desk.signal.Order = now; write_messages.desk.signal.Order  (a.aseme:18:5)
                self.taken.append((5,))
                try:
                    if len(m3_4 := self.v_mine) > (m3_5 := 0) >= 0:
                        self.v_now = self.made(Order, m3_4[m3_5], ("id", "place"), (("item",), "last"))
                    else:
                        self.fault(5, ABSENT)
                except Exception as error:
                    self.fault(5, error)
                try:
                    self.v_mine = self.short(
                        "mine", 4, self.put("mine", self.v_mine, 0, self.made(Order, None, ()))
                    )
                except Exception as error:
                    self.fault(5, error)
                if (m3_6 := self.v_now) is not None:
                    b.fill("desk.signal.Order", None, (), m3_6)
                else:
                    self.fault(5, ABSENT)
                self.publish(0, b, "desk.signal.Order")
                self.r0 = 4
                return True
            elif r == 4:  # 0.2.3 END
                # 0.2 -> 0.3 Call  [has(desk.signal.Order)]  (a.aseme:19:5)
                b.ask("desk.signal.Order", None)
                if b.desk_signal_Order is not None:
                    self.taken.append((1,))
                    self.r0 = 5
                    self.k0 = self.begin("0.3", "Call")
                    b.spend("desk.signal.Order", None)
                    return True
            elif r == 6:  # 0.3 Call is complete
                # 0.3 -> 0.4  (a.aseme:14:30)
                self.taken.append((2,))
                self.r0 = 7
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
        return self.r0 == 7

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


_RUNNING_0: dict[int, tuple[str, str]] = {2: ("0.2.2", "Sell"), 5: ("0.3", "Call")}
