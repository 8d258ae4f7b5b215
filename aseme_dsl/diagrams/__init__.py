"""Diagrams: every model of a system as drawings: of our own or by Graphviz, in the look of the papers.

`drawings` runs Graphviz only for parts of statecharts that have no compact form. `render` and `draw` run it,
and check what it has drawn.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import partial
from typing import Literal, assert_never

from aseme_dsl.amola.aip import Aip
from aseme_dsl.amola.sag import Sag
from aseme_dsl.amola.srm import Activity, Srm
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.amola.suc import Suc
from aseme_dsl.amola.system import System
from aseme_dsl.diagrams.look.drawing import (
    DEFAULT,
    STATE_GAPS,
    Drawing,
    Expressions,
    Layout,
    NoSuchState,
    Options,
    PageSize,
    of_sheet,
    piece_name,
)
from aseme_dsl.diagrams.look.view import view
from aseme_dsl.diagrams.models import aip, division, sag, srm, statechart, suc, tree
from aseme_dsl.diagrams.rendering.drawn import Drawn, draw
from aseme_dsl.diagrams.rendering.inset import region
from aseme_dsl.diagrams.rendering.layout import (
    FORMATS,
    DrawingFailed,
    GraphvizMissing,
    program,
    render,
    writes_pdf,
)

__all__ = [
    "FORMATS",
    "Drawing",
    "DrawingFailed",
    "Drawn",
    "Expressions",
    "GraphvizMissing",
    "Layout",
    "Maker",
    "NoSuchState",
    "Options",
    "PageSize",
    "draw",
    "draw_model",
    "draw_one",
    "draw_statechart",
    "drawings",
    "label_of",
    "makers",
    "names",
    "program",
    "render",
    "writes_pdf",
]


_GAPS = (("0.55", "0.8"), ("0.8", "0.8"), ("0.45", "1.2"), ("1", "1.2"))
"""Between boxes and ranks, in inches: other layouts of goals and use cases, to be tried in this order."""


def drawings(system: System, options: Options = DEFAULT) -> list[Drawing]:
    """A drawing of every model that the system has, named as its file will be.

    `sag`, `suc`, `aip.<protocol>`, `srm.<role>`, `eac.<protocol>`, `iac.<role>`, and with other layouts than
    the compact one `iac.<role>.nested`, `iac.<role>.tree`. With `options.at`, only statecharts that have this
    state are drawn, and its label is added to the name; raises NoSuchState if none has.
    """
    if options.at is not None:
        charts = [chart for chart in system.statecharts if label_of(chart, options.at) in chart.by_label]
        if not charts:
            raise NoSuchState(f"no statechart of {system.name} has a state {options.at}")
        return [drawing for chart in charts for drawing in draw_statechart(chart, options, system.activities)]
    return [drawing for make, inputs in makers(system, options) for drawing in make(*inputs)]


def label_of(chart: Statechart, at: str) -> str:
    """The label of the state that `at` means: a label, or the name of a formula, where that comes first."""
    if at in chart.by_label:
        return at
    return next((state.label for state in chart.called(at) if state.type is StateType.OR), at)


def _placed(chart: Statechart, options: Options) -> Options:
    return options if options.at is None else replace(options, at=label_of(chart, options.at))


def draw_model(model: Sag | Suc | Aip | Srm | Statechart) -> Drawing:
    """The drawing of a model alone: a role or a statechart without what its activities say elsewhere."""
    match model:
        case Sag():
            (drawing,) = _goals(model)
        case Suc():
            (drawing,) = _use_cases(model)
        case Aip():
            (drawing,) = _protocol(model)
        case Srm():
            (drawing,) = _role(model, (None,) * len(model.activities))
        case Statechart():
            (drawing,) = draw_statechart(model)
        case _:
            assert_never(model)
    return drawing


Maker = tuple[Callable[..., list[Drawing]], tuple[object, ...]]
"""What makes drawings, and of what: of nothing else, so that they need not be made again for the same."""


def makers(system: System, options: Options = DEFAULT) -> list[Maker]:
    """What makes the drawings of a system, in their order; `options.at` is nothing that they care for."""
    known = system.activities if options.layout in (Layout.COMPACT, None) else ()
    charts = [(draw_statechart, (chart, options, known)) for chart in system.statecharts]
    return [*_sheets(system).values(), *charts]


def draw_one(system: System, name: str, options: Options = DEFAULT) -> Drawing | None:
    """The drawing of one model: `sag`, `suc`, `aip.<protocol>`, `srm.<role>`, `eac.<protocol>`, `iac.<role>`.

    A statechart is drawn as `options` say, with all layouts as the compact one; of several pages, it is the
    first. None if the system has no such model. Raises NoSuchState if the statechart has no state
    `options.at`.
    """
    chart = system.chart(name)
    if chart is not None:
        options = _placed(chart, options)
        if options.page is not None:
            return _compact(chart, options, system.activities, alone=True)[0]
        return draw_statechart(chart, options, system.activities)[0]
    maker = _sheets(system).get(name)
    return maker[0](*maker[1])[0] if maker is not None else None


def names(system: System) -> tuple[str, ...]:
    """What `draw_one` can draw of a system."""
    charts = (f"{chart.kind.lower()}.{chart.name}" for chart in system.statecharts)
    return (*_sheets(system), *charts)


def _sheets(system: System) -> dict[str, Maker]:
    """The function that draws each model that is not a statechart, with its arguments, by name."""
    made: dict[str, Maker] = {}
    if system.sag.actors:
        made["sag"] = (_goals, (system.sag,))
    if system.suc.roles or system.suc.usecases:
        made["suc"] = (_use_cases, (system.suc,))
    for protocol in system.aips:
        made[f"aip.{protocol.name}"] = (_protocol, (protocol,))
    known = {item.name: item for item in system.activities}
    for role in system.srms:
        made[f"srm.{role.name}"] = (_role, (role, tuple(known.get(name) for name in role.activities)))
    return made


def _goals(goals: Sag) -> list[Drawing]:
    return [of_sheet(sag.sheet(goals, "sag"), gaps=_GAPS)]


def _use_cases(cases: Suc) -> list[Drawing]:
    return [of_sheet(suc.sheet(cases, "suc"), gaps=_GAPS)]


def _protocol(protocol: Aip) -> list[Drawing]:
    return [of_sheet(aip.sheet(protocol, f"aip.{protocol.name}"))]


def _role(role: Srm, activities: tuple[Activity | None, ...]) -> list[Drawing]:
    return [of_sheet(srm.sheet(role, activities, f"srm.{role.name}"))]


def _compact(
    chart: Statechart, options: Options, activities: Iterable[Activity], alone: bool = False
) -> list[Drawing]:
    """The compact drawing, or its first page `alone`; the nested one with a note where none is right."""
    from aseme_dsl.diagrams import compact  # here: no other drawing needs it

    found = compact.drawings(chart, options, activities, alone, partial(region, chart))
    if isinstance(found, list):
        return found
    nested = _by_graphviz(chart, options, Layout.NESTED, "")
    return [replace(nested, note=f"{nested.name} is drawn nested: {found}")]


def _by_graphviz(
    chart: Statechart, options: Options, layout: Literal[Layout.NESTED, Layout.TREE], ending: str
) -> Drawing:
    shown = view(chart, at=options.at, depth=options.depth)
    name = f"{chart.kind.lower()}.{chart.name}{ending}"
    name = piece_name(name, options.at) if options.at is not None else name
    sheet = tree.sheet if layout is Layout.TREE else statechart.sheet
    drawer = partial(sheet, expressions=options.expressions)
    pieces = partial(division.pieces, shown, name, drawer)
    gaps = STATE_GAPS if layout is Layout.NESTED else ()
    return of_sheet(drawer(shown, name, {}), states=len(shown.states), pieces=pieces, gaps=gaps)


def draw_statechart(
    chart: Statechart, options: Options = DEFAULT, activities: tuple[Activity, ...] = ()
) -> list[Drawing]:
    """The drawings of a statechart in the layout that `options` ask for, or in all.

    A compact drawing says what is known of the `activities`.
    Raises NoSuchState if the chart has no state `options.at`.
    """
    options = _placed(chart, options)
    made: list[Drawing] = []
    for layout in Layout if options.layout is None else (options.layout,):
        match layout:
            case Layout.COMPACT:
                made += _compact(chart, options, activities)
            case Layout.NESTED | Layout.TREE:
                made.append(_by_graphviz(chart, options, layout, f".{layout}"))
            case _:
                assert_never(layout)
    return made
