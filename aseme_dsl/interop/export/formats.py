"""The formats of other tools into which statecharts are exported, and the files of each."""

from __future__ import annotations

from collections.abc import Iterable
from enum import StrEnum
from pathlib import PurePath
from typing import assert_never

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.exporting import Foreign, NotExpressible
from aseme_dsl.interop.export.bpmn import bpmn, limits
from aseme_dsl.interop.export.lowering import Refusal, lowered
from aseme_dsl.interop.export.mermaid import mermaid
from aseme_dsl.interop.export.plantuml import plantuml
from aseme_dsl.interop.export.scxml import DataModel, scxml
from aseme_dsl.interop.export.sismic import limits as sismic_limits
from aseme_dsl.interop.export.sismic import sismic
from aseme_dsl.interop.export.sketch import crossings
from aseme_dsl.interop.export.stct import limits as stct_limits
from aseme_dsl.interop.export.stct import stct
from aseme_dsl.interop.export.xstate import xstate

File = tuple[str, str]
"""A file's name, and its text."""


class Format(StrEnum):
    """What `asemec export` writes, in the order of its help."""

    SCXML = "scxml"
    XSTATE = "xstate"
    STCT = "stct"
    SISMIC = "sismic"
    MERMAID = "mermaid"
    PLANTUML = "plantuml"
    BPMN = "bpmn"


def files_of(
    system: System, chart: Statechart, format_: Format, datamodel: DataModel = "ecmascript"
) -> tuple[tuple[File, ...], tuple[Diagnostic, ...]]:
    """The files of a statechart, or none and what the format cannot express."""
    name = f"{chart.kind.lower()}.{chart.name}"
    source = "" if chart.span is None else PurePath(chart.span.source.path).name
    about = f"asemec export {format_.value}: {chart.name} of {source}"
    match format_:
        case Format.SCXML | Format.XSTATE | Format.SISMIC:
            machine, refused = lowered(system, chart)
            if format_ is Format.SISMIC:
                refused = (*refused, *sismic_limits(chart))
        case Format.MERMAID | Format.PLANTUML:
            refused = crossings(chart)
        case Format.STCT:
            refused = stct_limits(system, chart)
        case Format.BPMN:
            refused = limits(chart)
        case _:
            assert_never(format_)
    if refused:
        return (), tuple(refusals(refused, chart, format_))
    match format_:
        case Format.SCXML:
            return ((f"{name}.scxml", scxml(machine, datamodel)),), ()
        case Format.XSTATE:
            made = xstate(machine, f"{name}.xstate.json")
            return ((f"{name}.xstate.json", made.config), (f"{name}.xstate.ts", made.module)), ()
        case Format.SISMIC:
            return ((f"{name}.sismic.yaml", sismic(machine)),), ()
        case Format.STCT:
            return ((f"{name}.stct", stct(chart, about)),), ()
        case Format.MERMAID:
            return ((f"{name}.mmd", mermaid(chart, about)),), ()
        case Format.PLANTUML:
            return ((f"{name}.puml", plantuml(chart, about)),), ()
        case Format.BPMN:
            return ((f"{name}.bpmn", bpmn(chart, about)),), ()
    assert_never(format_)


def refusals(found: Iterable[Refusal], chart: Statechart, format_: Format) -> Iterable[Diagnostic]:
    """One error for each construct, at its first place, with the others."""
    places: dict[Foreign, list[Refusal]] = {}
    for refusal in found:
        places.setdefault(refusal.feature, []).append(refusal)
    for feature, (first, *others) in places.items():
        related = tuple(Related(refusal.span, "and here") for refusal in others)
        yield Diagnostic(NotExpressible(chart.name, format_.value, feature), first.span, related)


__all__ = ["File", "Format", "files_of"]
