"""Analyse: all phases in their order; an error in one part neither hides nor causes errors in another."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.system import System
from aseme_dsl.compiler import Analysis, Options
from aseme_dsl.compiler.activities import merge_activities, type_activity
from aseme_dsl.compiler.activity_use import all_activities, check_described, close_names, used_activities
from aseme_dsl.compiler.aip_to_eac import Protocol, aip_to_eac, read_protocol
from aseme_dsl.compiler.blocks import blocks_of
from aseme_dsl.compiler.chart import World
from aseme_dsl.compiler.damage import damage
from aseme_dsl.compiler.load import load
from aseme_dsl.compiler.resolve import resolve
from aseme_dsl.compiler.sag_to_suc import read_sag, sag_to_suc
from aseme_dsl.compiler.scopes import global_scope, protocol_scopes, role_scope
from aseme_dsl.compiler.srm_to_iac import Role, read_role, srm_to_iac
from aseme_dsl.compiler.suc_to_aip import read_aip, suc_to_aip
from aseme_dsl.compiler.suc_to_srm import read_srm, suc_to_srm
from aseme_dsl.compiler.usecases import use_cases
from aseme_dsl.diagnostics import Diagnostic, has_errors, in_order
from aseme_dsl.source import Source


def analyse_files(root: Source | Path | str, sources: Mapping[str, str] | None, options: Options) -> Analysis:
    """The system of a file, and every diagnostic of it and of what it imports."""
    loaded = load(root, sources)
    found: list[Diagnostic] = list(loaded.diagnostics)
    is_damaged = damage(found)

    symbols, problems = resolve(loaded)
    found += problems
    blocks, problems = blocks_of(loaded.files)
    found += problems
    scope, problems = global_scope(symbols)
    found += problems

    sag, problems = read_sag(blocks.sags)
    found += problems
    role_names = {item.name.text: item.name.span for item in (*blocks.srms, *blocks.statecharts)}
    suc, problems = sag_to_suc(sag, blocks.sucs, role_names)
    found += problems

    protocols: dict[str, Protocol] = {}
    aips = []
    for aip in blocks.aips:
        participants, problems = protocol_scopes(aip, scope)
        found += problems
        protocols[aip.name.text], problems = read_protocol(aip, participants, options.largest, is_damaged)
        found += problems
        model, problems = read_aip(aip, participants, is_damaged)
        found += problems
        aips.append(model)

    roles: dict[str, Role] = {}
    statements: list[Activity] = []
    for srm in blocks.srms:
        typed, problems = role_scope(srm, scope)
        found += problems
        roles[srm.name.text], problems = read_role(srm, typed, protocols, options.largest, is_damaged)
        found += problems
        for written in srm.activities:
            statement, problems = type_activity(written, typed.scope)
            found += problems
            statements.append(statement)
    merged, problems = merge_activities(statements)
    found += problems
    described = {item.name: item for item in merged}

    name = symbols.system.name.text if symbols.system is not None else ""
    world = World(name, symbols, described)
    eacs = [aip_to_eac(protocol, world) for protocol in protocols.values()]
    iacs = {role.name: srm_to_iac(role, world) for role in roles.values()}

    eac_charts = tuple(chart for chart in eacs if chart is not None)
    iac_charts = tuple(chart for chart in iacs.values() if chart is not None)
    used = used_activities((*iac_charts, *eac_charts))
    formulas = [item for block in blocks.srms for item in block.formulas]
    formulas += [item for aip in blocks.aips for part in aip.participants for item in part.formulas]
    if len(eac_charts) == len(eacs) and len(iac_charts) == len(iacs):
        written_activities = [item for block in blocks.srms for item in block.activities]
        found += check_described(written_activities, used, is_damaged)
    found += close_names(used, described, formulas)

    names = [*protocols, *(item.name.text for item in formulas), *used]
    cases = use_cases(suc, names)
    found += suc_to_aip(cases, blocks.aips)
    srms = []
    for role in roles.values():
        srm_model, problems = read_srm(role, iacs[role.name], cases)
        found += problems
        srms.append(srm_model)
    found += suc_to_srm(cases, roles, [item.name.text for item in blocks.statecharts], blocks.aips)

    diagnostics = in_order(found)
    if has_errors(diagnostics):
        return Analysis(None, diagnostics)
    system = System(
        name,
        symbols.enums,
        symbols.messages,
        symbols.topics,
        symbols.functions,
        all_activities(iac_charts, described),
        sag,
        suc,
        tuple(aips),
        tuple(srms),
        eac_charts,
        iac_charts,
        symbols.teams,
        symbols.protos,
        tuple(file.source for file in loaded.files),
        symbols.system.name.span if symbols.system is not None else None,
    )
    return Analysis(system, diagnostics)
