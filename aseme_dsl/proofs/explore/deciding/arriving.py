"""Arriving: messages that may have come at any time are there, or not, when something looks for them."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from types import CodeType, FunctionType, MemberDescriptorType
from typing import cast

from aseme_dsl.proofs.explore.deciding.outcomes import codes_of
from aseme_dsl.runtime.chart.board import Board
from aseme_dsl.runtime.chart.chart import Chart


def methods_of(
    chart: type[Chart],
    looked_for: Callable[[str], None],
    holds: Callable[[Chart, Callable[[], object]], bool] | None = None,
) -> dict[str, object]:
    """The methods of a chart, with boards that call `looked_for` with a channel when something looks for its
    newest message, or for a mean, and there is none yet. It may put one there. `holds` is asked for
    conditions, as far as they can be given as functions."""
    scope = vars(sys.modules[chart.__module__])
    boards = {
        name: _opened(kind, looked_for)
        for name, kind in scope.items()
        if isinstance(kind, type) and issubclass(kind, Board) and kind.SLOTS
    }
    known = {**scope, **boards}
    opened: Mapping[str, CodeType] = {} if holds is None else codes_of(cast(type, chart))
    own: dict[str, object] = {
        name: FunctionType(opened.get(name) or code, known, name, method.__defaults__, method.__closure__)
        for name, method in vars(chart).items()
        if isinstance(method, FunctionType) and (code := method.__code__)
    }
    return own if holds is None else {**own, "holds_open": holds}


def _opened(kind: type[Board], looked_for: Callable[[str], None]) -> type[Board]:
    own: dict[str, object] = {"__slots__": ()}
    held: dict[str, str] = {}
    for channel, slots in kind.SLOTS.items():
        for slot, sender in slots:
            if sender is None:
                held[slot] = f"held_{slot}"
                own[held[slot]] = vars(kind)[slot]
                own[slot] = _member(vars(kind)[slot], channel, looked_for)
    names = [held.get(slot, slot) for slot in cast("tuple[str, ...]", vars(kind)["__slots__"])]
    own["mean"] = _looking(kind.mean, looked_for)
    own["shown"] = lambda board: tuple([getattr(board, name) for name in names])
    return cast("type[Board]", type(kind.__name__, (kind,), own))


def _member(raw: MemberDescriptorType, channel: str, looked_for: Callable[[str], None]) -> property:
    def read(board: Board) -> object:
        message = raw.__get__(board)
        if message is None:
            looked_for(channel)
            message = raw.__get__(board)
        return message

    return property(read, raw.__set__)


_Mean = Callable[[Board, str, str | None, int, str], float | None]


def _looking(mean: _Mean, looked_for: Callable[[str], None]) -> _Mean:
    def look(board: Board, channel: str, host: str | None, since: int, member: str) -> float | None:
        if host is None and board.newest(channel) is None:
            looked_for(channel)
        return mean(board, channel, host, since, member)

    return look


__all__ = ["methods_of"]
