"""Phases: all of them in their order; an error in one part neither hides nor causes errors in another."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.amola.sag import Sag
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.suc import Suc
from aseme_dsl.compiler.chart.chart import Protocol
from aseme_dsl.compiler.chart.srm_to_iac import Role
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.read.blocks import Blocks
from aseme_dsl.compiler.read.load import Loaded, Read
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.pieces import InPieces, finished
from aseme_dsl.compiler.stages.analysis import Analysis, Options
from aseme_dsl.compiler.stages.charts import build_charts
from aseme_dsl.compiler.stages.declarations import read_declarations
from aseme_dsl.compiler.stages.found import Found
from aseme_dsl.compiler.stages.processes import read_activities, read_processes, read_requirements
from aseme_dsl.compiler.stages.told import no_system, system_of, tell
from aseme_dsl.compiler.stages.uses import check_requirements, check_uses, compare_with_requirements
from aseme_dsl.compiler.stages.whole import check_whole
from aseme_dsl.compiler.types.scopes import TypedParticipant, TypedRole
from aseme_dsl.diagnostics import has_errors
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source

if TYPE_CHECKING:
    from aseme_dsl.play.scenario import Scenario


@dataclass(frozen=True, slots=True)
class Inspection:
    """What every phase has found, wherever there are errors, too: what an editor asks for.

    `scopes` are those of roles and statecharts, `participants` those of each protocol's participants, both by
    name as `protocols`, `roles`, `eacs` and `iacs` are. A chart that could not be built is None.
    """

    analysis: Analysis
    loaded: Loaded
    symbols: Symbols
    blocks: Blocks
    top: Scope
    sag: Sag
    suc: Suc
    participants: Mapping[str, Mapping[str, TypedParticipant]]
    protocols: Mapping[str, Protocol]
    scopes: Mapping[str, TypedRole]
    roles: Mapping[str, Role]
    activities: Mapping[str, Activity]
    eacs: Mapping[str, Statechart | None]
    iacs: Mapping[str, Statechart | None]


def analyse_files(root: Source | Path | str, sources: Mapping[str, str] | None, options: Options) -> Analysis:
    """The system of a file, and every diagnostic of it and of what it imports."""
    return inspect_files(root, sources, options).analysis


def inspect_files(
    root: Source | Path | str,
    sources: Mapping[str, str] | None,
    options: Options,
    memory: Memory | None = None,
    read: Read | None = None,
) -> Inspection:
    """The analysis, together with the results of each phase.

    With a `memory`, phases whose inputs have not changed since an earlier analysis of the same root reuse
    their results; `read` does the same for the texts (see `load`). Both only save time.
    """
    return finished(inspecting(root, sources, options, memory, read))


def inspecting(
    root: Source | Path | str,
    sources: Mapping[str, str] | None,
    options: Options,
    memory: Memory | None = None,
    read: Read | None = None,
) -> InPieces[Inspection]:
    """`inspect_files`, in pieces, between which something else may be done; it may be given up there."""
    memory = memory or Memory()
    found = yield from _inspecting(root, sources, options, memory, read)
    memory.end()
    return found


def scenarios_of(inspection: Inspection, bound: Mapping[str, str]) -> tuple[Scenario, ...]:
    """The scenarios of a system without errors, as they are played; agents are `bound` to roles for `any`."""
    from aseme_dsl.compiler.requirements.played import played
    from aseme_dsl.compiler.requirements.statements import known_by

    found, files = inspection, inspection.loaded.files
    known = known_by(files, found.top, found.scopes, found.blocks, (), found.iacs, found.activities)
    charts = {role: chart for role, chart in found.iacs.items() if chart is not None}
    return played(files, known, charts, found.blocks, bound)


def watched_of(inspection: Inspection, team: Mapping[str, str]) -> Scenario:
    """What the properties and clauses of a system without errors say of a team, as it is watched."""
    from aseme_dsl.compiler.requirements.played import watched
    from aseme_dsl.compiler.requirements.statements import known_by

    found, files = inspection, inspection.loaded.files
    known = known_by(files, found.top, found.scopes, found.blocks, (), found.iacs, found.activities)
    charts = {role: chart for role, chart in found.iacs.items() if chart is not None}
    return watched(files, known, charts, found.blocks, team)


def _inspecting(
    root: Source | Path | str,
    sources: Mapping[str, str] | None,
    options: Options,
    memory: Memory,
    read: Read | None,
) -> InPieces[Inspection]:
    found = Found()
    # What is written.
    declared = found.keep(read_declarations(root, sources, memory, read))
    yield
    # Requirements: goals and use cases.
    required = found.keep(read_requirements(declared))
    yield
    # Analysis: protocols and roles, with the activities that they describe.
    processes = found.keep((yield from read_processes(declared, options.largest, memory)))
    yield
    described = found.keep((yield from read_activities(declared, processes, memory)))
    yield
    # Design: the statecharts.
    charts = found.keep((yield from build_charts(declared, processes, described, memory)))
    yield
    # What scenarios and properties say of all that.
    files = declared.loaded.files
    if declared.symbols.system is not None and any(file.must_hold for file in files):
        # Imported here: most files have none.
        from aseme_dsl.compiler.requirements.statements import check_statements, known_by

        scopes, aips = processes.scopes, processes.aips
        known = known_by(
            files, declared.top, scopes, declared.blocks, aips, charts.iacs, described.activities
        )
        found.add(check_statements(files, known, declared.is_damaged, found.diagnostics))
        yield
    # What is used but not declared, described but not used, expected but not written.
    uses = found.keep((yield from check_uses(declared, processes, described, charts, memory)))
    yield
    everything = declared, required, processes, described, charts, uses
    fulfilment = found.keep((yield from compare_with_requirements(*everything, memory)))
    has_system = declared.symbols.system is not None
    if not has_system:
        found.add(no_system(declared.loaded))
    elif not has_errors(found.diagnostics):
        before = tuple(found.diagnostics)
        checked = check_requirements(declared, processes, described, uses, fulfilment, before, memory)
        found.keep((yield from checked))
    yield
    # The whole; with an error somewhere, what is asked here may be wrong for want of what is wrong there.
    unchecked = 0
    if not has_errors(found.diagnostics):
        whole = check_whole(declared, processes, described, charts, fulfilment, memory)
        unchecked = found.keep((yield from whole))
    yield
    analysis = tell(declared, fulfilment.missing, found.diagnostics, unchecked, options.policy)
    if has_system and not has_errors(analysis.diagnostics):
        analysis = replace(analysis, system=system_of(*everything, fulfilment, memory))
    return Inspection(
        analysis=analysis,
        loaded=declared.loaded,
        symbols=declared.resolved,
        blocks=declared.blocks,
        top=declared.top,
        sag=required.sag,
        suc=required.suc,
        participants=processes.participants,
        protocols=processes.protocols,
        scopes=processes.scopes,
        roles=processes.roles,
        activities=described.activities,
        eacs=charts.eacs,
        iacs=charts.iacs,
    )
