"""Places: where in the source the elements of a drawing come from, by their ids in the SVG."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Protocol

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.diagrams.look.drawing import Drawing
from aseme_dsl.source import Span

_STATE = re.compile(r"n(\d+(?:\.\d+)*)")
_WAY = re.compile(r"t(\d+)(?:\.\w+)?")
_ITEM = re.compile(r"(?:role\.\d+\.in\.)?(actor|goal|role|usecase)\.(\d+)(?:\.\w.*)?")


class _Placed(Protocol):
    """What stands somewhere."""

    @property
    def span(self) -> Span: ...


def places(system: System, drawing: Drawing) -> dict[str, Span]:
    """The place of everything in a drawing of the system that stands somewhere; tables have no such elements.

    States and transitions of a statechart (`n0.2`, `t3`, and the parts of its line, such as `t3.turn`),
    actors, goals, roles and use cases with the lines that belong to them.
    """
    chart = system.chart(".".join(drawing.name.split(".")[:2]))
    if chart is not None:
        return _of_chart(chart, drawing)
    items: dict[str, Sequence[_Placed]] = {
        "actor": system.sag.actors,
        "goal": system.sag.goals,
        "role": system.suc.roles,
        "usecase": system.suc.usecases,
    }
    found: dict[str, Span] = {}
    for shown in drawing.shown:
        match = _ITEM.fullmatch(shown.id)
        if match is not None:
            found[shown.id] = items[match[1]][int(match[2])].span
    return found


def _of_chart(chart: Statechart, drawing: Drawing) -> dict[str, Span]:
    found: dict[str, Span] = {}
    for shown in drawing.shown:
        if state := _STATE.fullmatch(shown.id):
            found[shown.id] = chart.node(state[1]).span
        elif way := _WAY.fullmatch(shown.id):
            found[shown.id] = chart.transitions[int(way[1])].span
    return found


__all__ = ["places"]
