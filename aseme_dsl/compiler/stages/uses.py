"""Uses: what is used but not declared, described but not used, expected but not written."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import chain

from aseme_dsl.amola.aip import Plays
from aseme_dsl.amola.liveness import names
from aseme_dsl.amola.srm import Module, Srm
from aseme_dsl.amola.statechart import State, Statechart
from aseme_dsl.compiler.chart.srm_to_iac import Role
from aseme_dsl.compiler.checks.activity_use import (
    Used,
    check_described,
    check_reach,
    close_names,
    unplayed,
    used_activities,
    used_in,
)
from aseme_dsl.compiler.names.renamed import renamed, renamed_roles
from aseme_dsl.compiler.names.usecases import UseCases, use_cases
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.missing import Missing
from aseme_dsl.compiler.requirements.goals import not_played, out_of_reach, without_functionality
from aseme_dsl.compiler.requirements.suc_to_aip import suc_to_aip
from aseme_dsl.compiler.requirements.suc_to_srm import read_srm, suc_to_srm
from aseme_dsl.compiler.stages.charts import Charts
from aseme_dsl.compiler.stages.declarations import Declarations
from aseme_dsl.compiler.stages.found import Found, Stage, With
from aseme_dsl.compiler.stages.processes import Described, Processes, Requirements
from aseme_dsl.compiler.types.modules import also_activities
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Uses:
    """The activities that charts have (`by_roles`: of each role's) and the formulas of all blocks.

    `named` is every activity that a formula or a binding names, also where an error keeps it from being used.
    """

    by_roles: Sequence[Used]
    activities: Mapping[str, State]
    formulas: Sequence[tree.NamedFormula]
    named: frozenset[str]


@dataclass(frozen=True, slots=True)
class Fulfilment:
    """The use cases, and what of them is missing; `srms` are the roles with their capabilities."""

    cases: UseCases
    srms: tuple[Srm, ...]
    missing: tuple[Missing, ...]


def check_uses(
    declared: Declarations, processes: Processes, described: Described, charts: Charts, memory: Memory
) -> Stage[Uses]:
    """What charts use against what is described: names that are close, wrong or of no use."""
    found, each = Found(), memory.each_in_pieces
    blocks = declared.blocks
    used_by = yield from each(used_in, zip((*charts.of_roles, *charts.of_protocols)))
    by_roles = used_by[: len(charts.of_roles)]
    used = used_activities(used_by)
    with_formulas: list[tree.Srm | tree.Aip] = [*blocks.srms, *blocks.aips]
    formulas = [item for block in with_formulas for item in _formulas_of(block)]
    of_blocks = yield from each(_named, [(block,) for block in with_formulas])
    named = set(chain.from_iterable(of_blocks)).difference(item.name.text for item in formulas)
    bindings = (item for block in blocks.srms for play in block.plays for item in play.bindings)
    named.update(item.own.text for item in bindings if item.own is not None)
    if charts.are_complete:
        written = (item for block in blocks.roles for item in block.activities)
        found.add(check_described(written, {*used, *named}, formulas, declared.is_damaged))
        for block in blocks.roles:
            if (chart := charts.iacs.get(block.name.text)) is not None:
                found.add(check_reach(block.activities, chart))
    yield
    refined = _refined(processes.roles.values())
    own_names = {name: node for name, node in used.items() if name not in refined}
    unused = _unused_plays(processes.roles.values())
    found.add(close_names(own_names, described.activities, formulas, unused))
    found.add(also_activities({block.name.text: block.modules for block in blocks.roles}, used))
    role_names = (chart.name for chart in charts.of_roles)
    found.add(unplayed(dict(zip(role_names, by_roles, strict=True)), blocks.aips))
    return found.of(Uses(by_roles, used, formulas, frozenset(named)))


def compare_with_requirements(
    declared: Declarations,
    required: Requirements,
    processes: Processes,
    described: Described,
    charts: Charts,
    uses: Uses,
    memory: Memory,
) -> Stage[Fulfilment]:
    """Diagnostics for use cases without a formula or activity; none for parts that could not be read."""
    found, each = Found(), memory.each_in_pieces
    blocks, inclusion = declared.blocks, declared.inclusion
    protocols, roles = processes.protocols, processes.roles
    # Formulas with holes have no chart that uses their activities.
    written = (
        *protocols,
        *(item.name.text for item in uses.formulas),
        *uses.activities,
        *sorted(uses.named.difference(uses.activities)),
        *(item.name.text for block in blocks.srms for item in block.capabilities),
    )
    cases = memory.recall(use_cases, memory.same("use cases", required.suc), memory.same("written", written))
    cases = memory.same("cases", found.keep(renamed(cases, blocks.aips, blocks.srms)))
    in_charts = [
        (
            role,
            charts.iacs[role.name],
            described.modules[role.name],
            memory.same((name, "has"), tuple(inclusion.names(name))),
        )
        for name, role in roles.items()
    ]
    srms = found.keep_all((yield from each(_srm, in_charts, cases)))
    elsewhere = {*(item.name for item in processes.given), *(item.name.text for item in inclusion.abstract)}
    whole = [item for item in blocks.srms if item.name.text not in elsewhere]
    others, problems = renamed_roles(cases, whole, {*roles, *elsewhere})
    missing: list[Missing] = []
    if not declared.unread:  # else it may be among what could not be read
        found.add(problems)
        missing += suc_to_aip(cases, blocks.aips)
        missing += suc_to_srm(cases, roles, {*elsewhere, *others}, blocks.aips)
        missing += (item for protocol in protocols.values() for item in protocol.missing)
        missing += (item for role in roles.values() for item in role.missing)
        missing = _once(missing)
    found.add(item.note for item in missing)
    return found.of(Fulfilment(cases, tuple(srms), tuple(missing)))


def check_requirements(
    declared: Declarations,
    processes: Processes,
    described: Described,
    uses: Uses,
    fulfilment: Fulfilment,
    told: Sequence[Diagnostic],
    memory: Memory,
) -> Stage[None]:
    """Of a system without errors: what no role does, reaches or plays; `told` is what was said before."""
    found = Found()
    assert declared.symbols.system is not None
    roles, home = processes.roles, declared.symbols.system.span.source
    found.add(out_of_reach(fulfilment.cases, roles, uses.formulas))
    found.add(not_played(declared.blocks.aips, roles.values(), home, [*told, *found.diagnostics]))
    found.add((yield from without_functionality(list(roles.values()), described.activities, memory)))
    return found.of(None)


def _refined(roles: Iterable[Role]) -> frozenset[str]:
    """The activities of protocols that stand for a formula of a role: both may be called alike."""
    return frozenset(
        activity
        for role in roles
        for item in role.plays
        for activity, own in item.bindings
        if role.formulas is not None and own in role.formulas.named
    )


def _unused_plays(roles: Iterable[Role]) -> dict[str, Plays]:
    """What roles play and no formula of theirs uses, by the names that the formulas would use."""
    return {item.name: item for role in roles for item in role.unused}


def _formulas_of(block: tree.Srm | tree.Aip) -> Sequence[tree.NamedFormula]:
    if isinstance(block, tree.Srm):
        return block.formulas
    return [item for part in block.participants for item in part.formulas]


def _named(block: tree.Srm | tree.Aip) -> frozenset[str]:
    """What the formulas of a block name."""
    return frozenset(node.name for item in _formulas_of(block) for node in names(item.formula))


def _srm(
    role: Role,
    chart: Statechart | None,
    modules: tuple[Module, ...],
    included: tuple[str, ...],
    cases: UseCases,
) -> With[Srm]:
    return read_srm(role, chart, modules, cases, included)


def _once(missing: Iterable[Missing]) -> list[Missing]:
    """What is missing in a text that several roles take over is missing once."""
    found: dict[object, Missing] = {}
    for item in missing:
        found.setdefault((item.note.code, item.note.span, item.skeleton), item)
    return list(found.values())


__all__ = ["Fulfilment", "Uses", "check_requirements", "check_uses", "compare_with_requirements"]
