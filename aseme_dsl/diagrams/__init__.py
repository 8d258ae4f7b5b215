"""Diagrams: every model of a system as Graphviz drawings in the look of the papers.

`drawings` is pure and needs no Graphviz; `render` and `draw` run it and check what it has drawn.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from aseme_dsl.amola.aip import Aip
from aseme_dsl.amola.srm import Srm
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.diagrams import aip, division, sag, srm, statechart, suc, tree
from aseme_dsl.diagrams.drawing import (
    DEFAULT,
    Drawing,
    Expressions,
    Layout,
    NoSuchState,
    Options,
    of_sheet,
)
from aseme_dsl.diagrams.drawn import Drawn, draw
from aseme_dsl.diagrams.layout import FORMATS, DrawingFailed, GraphvizMissing, program, render
from aseme_dsl.diagrams.view import view

__all__ = [
    "FORMATS",
    "Drawing",
    "DrawingFailed",
    "Drawn",
    "Expressions",
    "GraphvizMissing",
    "Layout",
    "NoSuchState",
    "Options",
    "draw",
    "draw_one",
    "draw_statechart",
    "drawings",
    "names",
    "program",
    "render",
]


def drawings(system: System, options: Options = DEFAULT) -> list[Drawing]:
    """A drawing of every model that the system has, named as its file will be.

    `sag`, `suc`, `aip.<protocol>`, `srm.<role>`, `eac.<protocol>`, `iac.<role>`, and for the trees of the
    statecharts `eac.<protocol>.tree`, `iac.<role>.tree`. With `options.at`, only statecharts that have this
    state are drawn, and its label is added to the name; raises NoSuchState if none has.
    """
    if options.at is not None:
        charts = [chart for chart in system.statecharts if options.at in chart.by_label]
        if not charts:
            raise NoSuchState(f"no statechart of {system.name} has a state {options.at}")
        return [drawing for chart in charts for drawing in draw_statechart(chart, options)]
    made = [draw() for draw in _sheets(system).values()]
    for chart in system.statecharts:
        made += draw_statechart(chart, options)
    return made


def draw_one(system: System, name: str, options: Options = DEFAULT) -> Drawing | None:
    """The drawing of one model: `sag`, `suc`, `aip.<protocol>`, `srm.<role>`, `eac.<protocol>`, `iac.<role>`.

    Statecharts are drawn as `options` say, with both layouts as the nested one. None if the system has no
    such model. Raises NoSuchState if the statechart has no state `options.at`.
    """
    chart = system.chart(name)
    if chart is not None:
        return draw_statechart(chart, options)[0]
    draw = _sheets(system).get(name)
    return draw() if draw is not None else None


def names(system: System) -> tuple[str, ...]:
    """What `draw_one` can draw of a system."""
    charts = (f"{chart.kind.lower()}.{chart.name}" for chart in system.statecharts)
    return (*_sheets(system), *charts)


def _sheets(system: System) -> dict[str, Callable[[], Drawing]]:
    """What draws each model that is no statechart, by name."""
    made: dict[str, Callable[[], Drawing]] = {}
    if system.sag.actors:
        made["sag"] = lambda: of_sheet(sag.sheet(system.sag, "sag"))
    if system.suc.roles or system.suc.usecases:
        made["suc"] = lambda: of_sheet(suc.sheet(system.suc, "suc"))
    for protocol in system.aips:
        name = f"aip.{protocol.name}"
        made[name] = partial(_protocol, protocol, name)
    for role in system.srms:
        name = f"srm.{role.name}"
        made[name] = partial(_role, system, role, name)
    return made


def _protocol(protocol: Aip, name: str) -> Drawing:
    return of_sheet(aip.sheet(protocol, name))


def _role(system: System, role: Srm, name: str) -> Drawing:
    return of_sheet(srm.sheet(system, role, name))


def draw_statechart(chart: Statechart, options: Options = DEFAULT) -> list[Drawing]:
    """The nested drawing and the tree of a statechart, or the one that `options.layout` asks for.

    Raises NoSuchState if the chart has no state `options.at`.
    """
    shown = view(chart, at=options.at, depth=options.depth)
    made = []
    for layout in Layout if options.layout is None else (options.layout,):
        name = f"{chart.kind.lower()}.{chart.name}{'.tree' if layout is Layout.TREE else ''}"
        name = division.piece_name(name, options.at) if options.at is not None else name
        sheet = tree.sheet if layout is Layout.TREE else statechart.sheet
        drawer = partial(sheet, expressions=options.expressions)
        pieces = partial(division.pieces, shown, name, drawer)
        made.append(of_sheet(drawer(shown, name, {}), states=len(shown.states), pieces=pieces))
    return made
