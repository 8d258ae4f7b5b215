"""Phases: all of them in their order; an error in one part neither hides nor causes errors in another."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain
from pathlib import Path
from typing import TypeVar

from aseme_dsl.amola.liveness import names
from aseme_dsl.amola.sag import Sag
from aseme_dsl.amola.srm import Activity, Module, Plays, Srm
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.suc import Suc
from aseme_dsl.amola.system import System
from aseme_dsl.compiler.analysis import Analysis, Options
from aseme_dsl.compiler.chart.aip_to_eac import Protocol, aip_to_eac, read_protocol
from aseme_dsl.compiler.chart.chart import World
from aseme_dsl.compiler.chart.flow import check_flow, check_reach, check_timers
from aseme_dsl.compiler.chart.srm_to_iac import Role, read_role, srm_to_iac
from aseme_dsl.compiler.chart.statecharts import GivenChart, build_statechart, read_statechart
from aseme_dsl.compiler.checks.activity_use import (
    all_activities,
    check_described,
    close_names,
    unplayed,
    used_activities,
    used_in,
)
from aseme_dsl.compiler.checks.conditions import (
    FROM_CONDITIONS,
    check_conditions,
    contradiction,
    vocabulary_of,
)
from aseme_dsl.compiler.checks.consequences import without_consequences
from aseme_dsl.compiler.checks.dialogue import check_multiplicity, check_waits
from aseme_dsl.compiler.checks.outcomes import check_deadlines, check_outcomes
from aseme_dsl.compiler.checks.unused import check_agents, check_exchange, check_unused
from aseme_dsl.compiler.checks.unwritten import check_unwritten
from aseme_dsl.compiler.checks.use import check_use
from aseme_dsl.compiler.checks.waking import check_waking
from aseme_dsl.compiler.formula.holes import apart_from_holes
from aseme_dsl.compiler.names.inclusion import Inclusion, errors_alone, include
from aseme_dsl.compiler.names.renamed import renamed, renamed_roles
from aseme_dsl.compiler.names.resolve import resolve
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.names.usecases import UseCases, use_cases
from aseme_dsl.compiler.read.allow import allow
from aseme_dsl.compiler.read.blocks import Blocks, blocks_of
from aseme_dsl.compiler.read.damage import Damaged, damage
from aseme_dsl.compiler.read.load import Loaded, Read, load
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.missing import Missing
from aseme_dsl.compiler.read.pieces import InPieces, finished
from aseme_dsl.compiler.requirements.goals import not_played, out_of_reach, without_functionality
from aseme_dsl.compiler.requirements.sag_to_suc import read_sag, sag_to_suc
from aseme_dsl.compiler.requirements.suc_to_aip import read_aip, suc_to_aip
from aseme_dsl.compiler.requirements.suc_to_srm import read_srm, suc_to_srm
from aseme_dsl.compiler.types.activities import by_name, merge_activity, type_activity
from aseme_dsl.compiler.types.modules import also_activities, read_modules
from aseme_dsl.compiler.types.scopes import (
    TypedParticipant,
    TypedRole,
    global_scope,
    protocol_scopes,
    role_scope,
)
from aseme_dsl.compiler.types.settings import settle
from aseme_dsl.compiler.types.state_values import check_states
from aseme_dsl.diagnostics import Diagnostic, Edit, has_errors
from aseme_dsl.grammar.text import tree
from aseme_dsl.proofs.prover import Prover
from aseme_dsl.source import Source, Span

_T = TypeVar("_T")


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
    """The same with what each phase has found on the way.

    With a `memory`, what an earlier analysis of the same root has found is taken again where nothing that it
    depends on has changed; `read` does the same for the texts (see `load`). What comes out is the same.
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


def _inspecting(
    root: Source | Path | str,
    sources: Mapping[str, str] | None,
    options: Options,
    memory: Memory,
    read: Read | None,
) -> InPieces[Inspection]:
    recall, each = memory.recall, memory.each_in_pieces
    found: list[Diagnostic] = []

    def keep(result: tuple[_T, tuple[Diagnostic, ...]]) -> _T:
        found.extend(result[1])
        return result[0]

    def keep_all(results: Iterable[tuple[_T, tuple[Diagnostic, ...]]]) -> list[_T]:
        return [keep(result) for result in results]

    # The files, and what their declarations mean.
    loaded = load(root, sources, read=read, protos=memory.protos)
    found += loaded.diagnostics
    unread = has_errors(apart_from_holes(loaded.diagnostics))
    is_damaged = damage(apart_from_holes(found))
    resolved = keep(resolve(loaded))
    symbols = memory.shared("symbols", resolved)
    all_blocks = keep(blocks_of(loaded.files))
    inclusion = keep(include(all_blocks, symbols.is_excused, not unread))
    roles_now = tuple(memory.same(("role", item.name.text), item) for item in inclusion.blocks.roles)
    blocks = replace(inclusion.blocks, roles=roles_now)
    is_damaged = inclusion.damaged(is_damaged)
    top = keep(recall(global_scope, symbols))
    yield

    # Requirements: goals and use cases.
    sag = keep(read_sag(blocks.sags, symbols))
    suc = keep(sag_to_suc(sag, blocks.sucs, _places_of_roles(blocks), _places(inclusion.abstract), symbols))
    yield

    # Analysis: protocols and roles, with the activities that they describe.
    largest = options.largest
    parties = keep_all((yield from each(protocol_scopes, [(item,) for item in blocks.aips], top)))
    participants = {item.name.text: scope for item, scope in zip(blocks.aips, parties, strict=True)}
    in_protocols = [(item, participants[item.name.text]) for item in blocks.aips]
    read_aips = keep_all((yield from each(read_protocol, in_protocols, largest, is_damaged)))
    protocols = {item.name.text: protocol for item, protocol in zip(blocks.aips, read_aips, strict=True)}
    in_parts = [(*both, protocols[both[0].name.text].parts) for both in in_protocols]
    aips = keep_all((yield from each(read_aip, in_parts, is_damaged)))
    typed = keep_all((yield from each(role_scope, [(item,) for item in blocks.roles], top)))
    scopes = {item.name.text: scope for item, scope in zip(blocks.roles, typed, strict=True)}
    teams = keep(settle(symbols.teams, loaded.files, scopes, top))
    yield
    in_roles = [(item, scopes[item.name.text]) for item in blocks.srms]
    written = keep_all((yield from each(read_role, in_roles, protocols, largest, is_damaged)))
    roles = {item.name.text: role for item, role in zip(blocks.srms, written, strict=True)}
    yield
    found += [
        problem
        for item in inclusion.unused
        for problem in errors_alone(_problems_alone(item, top, protocols, largest, is_damaged))
    ]
    given = [
        keep(recall(read_statechart, item, scopes[item.name.text], is_damaged)) for item in blocks.statecharts
    ]
    yield
    in_scopes = [(item, scopes[item.name.text], roles.get(item.name.text)) for item in blocks.roles]
    stated = keep_all((yield from each(_typed_activities, in_scopes)))
    of_roles = keep_all((yield from each(_read_modules, in_scopes, is_damaged)))
    modules = {item.name.text: of_role for item, of_role in zip(blocks.roles, of_roles, strict=True)}
    of_names = memory.same_values("statements", by_name(chain.from_iterable(stated)))
    merged = keep_all((yield from each(merge_activity, zip(of_names.values()))))
    described = memory.same_values("described", dict(zip(of_names, merged, strict=True)))

    # Design: the statecharts.
    name = symbols.system.name.text if symbols.system is not None else ""
    world = (name, symbols, described, modules)
    yield
    built = yield from each(_eac, zip(protocols.values()), *world)
    eacs = {item.name: chart for item, chart in zip(protocols.values(), built, strict=True)}
    built = yield from each(_iac, zip(roles.values()), *world)
    iacs = {item.name: chart for item, chart in zip(roles.values(), built, strict=True)}
    built = yield from each(_given_chart, zip(given), *world)
    iacs |= {item.name: chart for item, chart in zip(given, built, strict=True)}
    charts = [chart for chart in (*eacs.values(), *iacs.values()) if chart is not None]
    prover = recall(Prover, memory.same("vocabulary", vocabulary_of(resolved)))
    for problems in (yield from each(_flow, zip(charts), prover)):
        found += problems
    found += yield from check_outcomes(charts, described, memory)
    found += yield from check_states(charts, memory)
    yield

    # What is used but not declared, described but not used, expected but not written.
    looked_at = (*_built(iacs), *_built(eacs))
    used_by = yield from each(used_in, zip(looked_at))
    by_roles = used_by[: len(_built(iacs))]
    used = used_activities(used_by)
    formulas = _formulas(blocks)
    named = yield from each(_named, [(block,) for block in (*blocks.srms, *blocks.aips)])
    # Every activity that a formula or a binding names, even where an error keeps it from being used.
    activities_named = set(chain.from_iterable(named)).difference(item.name.text for item in formulas)
    bindings = (item for block in blocks.srms for play in block.plays for item in play.bindings)
    activities_named.update(item.own.text for item in bindings)
    if len(charts) == len(eacs) + len(iacs):
        found += check_described(_described_in(blocks), {*used, *activities_named}, formulas, is_damaged)
    yield
    found += close_names(used, described, formulas, _unused_plays(roles.values()))
    found += also_activities({block.name.text: block.modules for block in blocks.roles}, used)
    role_names = (chart.name for chart in _built(iacs))
    found += unplayed(dict(zip(role_names, by_roles, strict=True)), blocks.aips)
    yield
    capabilities = [item.name.text for block in blocks.srms for item in block.capabilities]
    # Formulas with holes have no chart that uses their activities.
    names_written = (
        *protocols,
        *(item.name.text for item in formulas),
        *used,
        *sorted(activities_named.difference(used)),
        *capabilities,
    )
    cases = recall(use_cases, memory.same("use cases", suc), memory.same("written", names_written))
    cases = memory.same("cases", keep(renamed(cases, blocks.aips, blocks.srms)))
    missing = [*suc_to_aip(cases, blocks.aips)]
    in_charts = [
        (role, iacs[role.name], modules[role.name], memory.same((name, "has"), tuple(inclusion.names(name))))
        for name, role in roles.items()
    ]
    srms = keep_all((yield from each(_srm, in_charts, cases)))
    elsewhere = _not_looked_into(given, inclusion)
    whole = [item for item in blocks.srms if item.name.text not in elsewhere]
    others, problems = renamed_roles(cases, whole, {*roles, *elsewhere})
    found += () if unread else problems
    missing += suc_to_srm(cases, roles, {*elsewhere, *others}, blocks.aips)
    missing += [item for protocol in protocols.values() for item in protocol.missing]
    missing += [item for role in roles.values() for item in role.missing]
    missing = _once(missing)
    if unread:
        missing = []  # it may be among what could not be read
    found += [item.note for item in missing]
    if symbols.system is None:
        found += _no_system(loaded)
    elif not has_errors(found):
        found += out_of_reach(cases, roles, formulas)
        found += not_played(blocks.aips, roles.values(), symbols.system.span.source, found)
        found += yield from without_functionality(list(roles.values()), described, memory)

    yield
    unchecked = 0
    if not has_errors(found):  # else the line that starts a timer may be what is missing
        for problems in (yield from each(_timers, zip(charts))):
            found += problems
        found += check_deadlines(charts, described)
        yield
        if symbols.system is not None and len(charts) == len(eacs) + len(iacs):
            found += yield from check_use(
                _built(iacs), _built(eacs), described, list(_statements(blocks)), symbols, memory
            )
        yield
        if symbols.system is not None:
            found += check_unused(loaded.files, symbols, memory)
            too_few = list(check_multiplicity(aips, srms, teams))
            found += check_agents(_alone(inclusion), symbols, too_few)
            found += check_exchange(blocks.aips)
            found += yield from check_waits(aips, eacs, srms, described, memory)
            found += too_few
        yield
        settings = [
            (agent.role, name) for team in teams for agent in team.agents for name, _ in agent.settings
        ]
        known = memory.same("settings", tuple(dict.fromkeys(settings)))
        if symbols.teams:  # without one, a program around a plain statechart may set them
            found += check_unwritten(_built(iacs), srms, described, known)
        for problems in (yield from each(_wakes, zip(_built(iacs)), described, known, prover)):
            found += problems
        compared, unchecked = yield from check_conditions(charts, prover, memory)
        found += compared

    yield
    not_looked_for = _OF_CODE | FROM_CONDITIONS if unchecked else _OF_CODE
    layout = loaded.layout
    placed = {id(item): layout.diagnostic(item) for item in inclusion.once(found)}
    missing = [
        Missing(
            placed.get(id(item.note), item.note),
            item.skeleton,
            None if item.inside is None else layout.whole(item.inside),
            tuple(Edit(layout.whole(edit.span), edit.text) for edit in item.edits),
        )
        for item in missing
    ]
    kept = without_consequences(placed.values())
    diagnostics, suppressed = allow(loaded.files, kept, not_looked_for, layout)
    diagnostics = options.policy.apply(diagnostics)
    accepted = {id(item.diagnostic) for item in suppressed}
    missing = [item for item in missing if id(item.note) not in accepted]

    def inspected(analysis: Analysis) -> Inspection:
        return Inspection(
            analysis,
            loaded,
            resolved,
            blocks,
            top,
            sag,
            suc,
            participants,
            protocols,
            scopes,
            roles,
            described,
            eacs,
            iacs,
        )

    files = tuple(loaded.paths.values())
    if has_errors(diagnostics) or symbols.system is None:
        analysis = Analysis(None, diagnostics, tuple(missing), _is_library(loaded), suppressed, files=files)
        return inspected(analysis)
    performed = {item.name: item for item in all_activities(by_roles, described)}
    system = System(
        name=name,
        enums=symbols.enums,
        messages=symbols.messages,
        topics=symbols.topics,
        functions=symbols.functions,
        activities=tuple(memory.same_values("activities", performed).values()),
        sag=sag,
        suc=suc,
        aips=tuple(aips),
        srms=tuple(srms),
        eacs=_built(eacs),
        iacs=_built(iacs),
        teams=teams,
        protos=symbols.protos,
        sources=tuple(file.source for file in loaded.files),
        span=symbols.system.name.span,
    )
    analysis = Analysis(
        system, diagnostics, tuple(missing), suppressed=suppressed, unchecked=unchecked, files=files
    )
    return inspected(analysis)


_Charted = tuple[str, Symbols, Mapping[str, Activity], Mapping[str, tuple[Module, ...]]]


def _eac(protocol: Protocol, *world: *_Charted) -> Statechart | None:
    return aip_to_eac(protocol, World(*world))


def _iac(role: Role, *world: *_Charted) -> Statechart | None:
    return srm_to_iac(role, World(*world))


def _given_chart(chart: GivenChart, *world: *_Charted) -> Statechart | None:
    return build_statechart(chart, World(*world))


def _flow(chart: Statechart, prover: Prover) -> tuple[Diagnostic, ...]:
    return (*check_flow(chart, contradiction(prover)), *check_reach(chart))


def _wakes(
    chart: Statechart,
    activities: Mapping[str, Activity],
    settings: tuple[tuple[str, str], ...],
    prover: Prover,
) -> tuple[Diagnostic, ...]:
    written = {name for role, name in settings if role == chart.name}
    performed = [activities[name] for node in chart.nodes if (name := node.activity or "") in activities]
    for activity in (*performed, *(module.statement for module in chart.modules)):
        written.update(activity.writes_variables)
    return tuple(check_waking(chart, frozenset(written), prover.vocabulary))


def _timers(chart: Statechart) -> tuple[Diagnostic, ...]:
    return tuple(check_timers(chart))


def _typed_activities(
    block: tree.Srm | tree.Statechart, typed_role: TypedRole, role: Role | None
) -> tuple[tuple[Activity, ...], tuple[Diagnostic, ...]]:
    played = _played_variables(role)
    typed = [type_activity(item, typed_role.scope, played) for item in block.activities]
    return tuple(item for item, _ in typed), tuple(problem for _, found in typed for problem in found)


def _read_modules(
    block: tree.Srm | tree.Statechart, typed_role: TypedRole, role: Role | None, is_damaged: Damaged
) -> tuple[tuple[Module, ...], tuple[Diagnostic, ...]]:
    return read_modules(block.modules, typed_role.scope, is_damaged(block.span))


def _srm(
    role: Role,
    chart: Statechart | None,
    modules: tuple[Module, ...],
    included: tuple[str, ...],
    cases: UseCases,
) -> tuple[Srm, tuple[Diagnostic, ...]]:
    return read_srm(role, chart, modules, cases, included)


def _places_of_roles(blocks: Blocks) -> dict[str, Span]:
    return _places(blocks.roles)


def _places(roles: Iterable[tree.Srm | tree.Statechart]) -> dict[str, Span]:
    return {item.name.text: item.name.span for item in roles}


def _alone(inclusion: Inclusion) -> list[tree.Srm | tree.Statechart]:
    """The roles that are not part of another one: those that agents should have."""
    parts = {part.name.text for parts in inclusion.included.values() for part in parts}
    return [item for item in inclusion.blocks.roles if item.name.text not in parts]


def _not_looked_into(given: Iterable[GivenChart], inclusion: Inclusion) -> list[str]:
    return [*(item.name for item in given), *(item.name.text for item in inclusion.abstract)]


def _problems_alone(
    item: tree.Srm, top: Scope, protocols: Mapping[str, Protocol], largest: int, is_damaged: Damaged
) -> Iterable[Diagnostic]:
    """What is wrong with a role that no other one completes."""
    typed, problems = role_scope(item, top)
    yield from problems
    yield from read_role(item, typed, protocols, largest, is_damaged)[1]


def _once(missing: Iterable[Missing]) -> list[Missing]:
    """What is missing in a text that several roles take over is missing once."""
    found: dict[object, Missing] = {}
    for item in missing:
        found.setdefault((item.note.code, item.note.span, item.skeleton), item)
    return list(found.values())


def _played_variables(role: Role | None) -> frozenset[str]:
    """The variables of the participants that a role plays."""
    parts = role.parts.values() if role is not None else ()
    return frozenset(variable.name for part in parts for variable in part.variables)


def _unused_plays(roles: Iterable[Role]) -> dict[str, Plays]:
    """What roles play and no formula of theirs uses, by the names that the formulas would use."""
    return {item.name: item for role in roles for item in role.unused}


def _built(charts: Mapping[str, Statechart | None]) -> tuple[Statechart, ...]:
    return tuple(chart for chart in charts.values() if chart is not None)


def _formulas(blocks: Blocks) -> list[tree.NamedFormula]:
    found = [item for block in blocks.srms for item in _formulas_of(block)]
    return found + [item for block in blocks.aips for item in _formulas_of(block)]


def _formulas_of(block: tree.Srm | tree.Aip) -> Sequence[tree.NamedFormula]:
    if isinstance(block, tree.Srm):
        return block.formulas
    return [item for part in block.participants for item in part.formulas]


def _statements(blocks: Blocks) -> Iterable[tree.Activity]:
    """What is said of activities and modules."""
    yield from _described_in(blocks)
    yield from (module.activity for block in blocks.roles for module in block.modules)


def _described_in(blocks: Blocks) -> Iterable[tree.Activity]:
    return (item for block in blocks.roles for item in block.activities)


def _named(block: tree.Srm | tree.Aip) -> frozenset[str]:
    """What the formulas of a block name."""
    return frozenset(node.name for item in _formulas_of(block) for node in names(item.formula))


_OF_CODE = frozenset(("N726", "W542", "W556"))
"""What is found only where the activities' code is at hand (project/code/activity_code.py)."""

_IMPORTABLE = (
    tree.Import,
    tree.Enum,
    tree.Message,
    tree.Topic,
    tree.Function,
    tree.Let,
    tree.Aip,
)
"""What a file may declare for others to import."""


def _is_library(loaded: Loaded) -> bool:
    declared = [item for file in loaded.files for item in file.declarations]
    return bool(declared) and all(isinstance(item, _IMPORTABLE) for item in declared)


def _no_system(loaded: Loaded) -> Iterable[Diagnostic]:
    """E008, unless the declaration may be among what could not be read."""
    if loaded.files and not has_errors(apart_from_holes(loaded.diagnostics)):
        source = loaded.files[-1].source
        yield Diagnostic(
            "E008",
            f"{source.path} declares no system",
            None,
            hint="name it in the first line: `system Kouretes`",
            path=source.path,
        )
