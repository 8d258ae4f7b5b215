"""Processes: goals and use cases, protocols and roles, and the activities that they describe."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import chain

from aseme_dsl.amola.aip import Aip
from aseme_dsl.amola.sag import Sag
from aseme_dsl.amola.srm import Activity, Module
from aseme_dsl.amola.suc import Suc
from aseme_dsl.amola.system import Team
from aseme_dsl.compiler.chart.aip_to_eac import read_protocol
from aseme_dsl.compiler.chart.chart import Protocol
from aseme_dsl.compiler.chart.playing import in_order
from aseme_dsl.compiler.chart.srm_to_iac import Role, read_role
from aseme_dsl.compiler.chart.statecharts import GivenChart, read_statechart
from aseme_dsl.compiler.names.inclusion import errors_alone
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.read.damage import Damaged
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.compiler.requirements.sag_to_suc import read_sag, sag_to_suc
from aseme_dsl.compiler.requirements.suc_to_aip import read_aip
from aseme_dsl.compiler.stages.declarations import Declarations
from aseme_dsl.compiler.stages.found import Found, Stage, With
from aseme_dsl.compiler.types.activities import by_name, merge_activity, type_activity
from aseme_dsl.compiler.types.modules import read_modules
from aseme_dsl.compiler.types.scopes import TypedParticipant, TypedRole, protocol_scopes, role_scope
from aseme_dsl.compiler.types.settings import settle
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Requirements:
    """Goals and use cases, as written."""

    sag: Sag
    suc: Suc


@dataclass(frozen=True, slots=True)
class Processes:
    """Protocols, roles and teams.

    `scopes` are those of roles and statecharts, `participants` those of each protocol's participants, all by
    name. `given` are the charts that are written as they are.
    """

    participants: Mapping[str, Mapping[str, TypedParticipant]]
    protocols: Mapping[str, Protocol]
    aips: tuple[Aip, ...]
    scopes: Mapping[str, TypedRole]
    roles: Mapping[str, Role]
    given: tuple[GivenChart, ...]
    teams: tuple[Team, ...]


@dataclass(frozen=True, slots=True)
class Described:
    """Activities by name, and the modules of each role."""

    activities: Mapping[str, Activity]
    modules: Mapping[str, tuple[Module, ...]]


def read_requirements(declared: Declarations) -> With[Requirements]:
    """The goals, and the use cases that follow from them or are written."""
    found = Found()
    blocks, symbols = declared.blocks, declared.symbols
    sag = found.keep(read_sag(blocks.sags, symbols))
    roles, abstract = _places(blocks.roles), _places(declared.inclusion.abstract)
    suc = found.keep(sag_to_suc(sag, blocks.sucs, roles, abstract, symbols))
    return found.of(Requirements(sag, suc))


def read_processes(declared: Declarations, largest: int, memory: Memory) -> Stage[Processes]:
    """`largest` is the most states that a chart may have."""
    found, each = Found(), memory.each_in_pieces
    blocks, top, is_damaged = declared.blocks, declared.top, declared.is_damaged
    parties = found.keep_all((yield from each(protocol_scopes, [(item,) for item in blocks.aips], top)))
    participants = {item.name.text: scope for item, scope in zip(blocks.aips, parties, strict=True)}
    in_protocols = [(item, participants[item.name.text]) for item in blocks.aips]
    protocols = found.keep((yield from _read_protocols(in_protocols, largest, is_damaged, memory)))
    in_parts = [(*both, protocols[both[0].name.text].parts) for both in in_protocols]
    aips = found.keep_all((yield from each(read_aip, in_parts, is_damaged)))
    typed = found.keep_all((yield from each(role_scope, [(item,) for item in blocks.roles], top)))
    scopes = {item.name.text: scope for item, scope in zip(blocks.roles, typed, strict=True)}
    teams = found.keep(settle(declared.symbols.teams, declared.loaded.files, scopes, top))
    yield
    in_roles = [(item, scopes[item.name.text]) for item in blocks.srms]
    written = found.keep_all((yield from each(read_role, in_roles, protocols, largest, is_damaged)))
    roles = {item.name.text: role for item, role in zip(blocks.srms, written, strict=True)}
    yield
    for item in declared.inclusion.unused:
        found.add(errors_alone(_problems_alone(item, top, protocols, largest, is_damaged)))
    given = found.keep_all(
        memory.recall(read_statechart, item, scopes[item.name.text], is_damaged)
        for item in blocks.statecharts
    )
    return found.of(Processes(participants, protocols, tuple(aips), scopes, roles, tuple(given), teams))


def _read_protocols(
    written: Sequence[tuple[tree.Aip, Mapping[str, TypedParticipant]]],
    largest: int,
    is_damaged: Damaged,
    memory: Memory,
) -> InPieces[With[dict[str, Protocol]]]:
    """The protocols by name: those that play no part in others first, then each after what it plays."""
    found = Found()
    simple = [both for both in written if not any(party.plays for party in both[0].participants)]
    nothing: Mapping[str, Protocol] = {}
    read = found.keep_all(
        (yield from memory.each_in_pieces(read_protocol, simple, nothing, largest, is_damaged))
    )
    protocols = {item.name.text: protocol for (item, _), protocol in zip(simple, read, strict=True)}
    typed = {item.name.text: scopes for item, scopes in written}
    order, in_circle, problems = in_order([item for item, _ in written])
    found.add(problems)
    for item in order:
        name = item.name.text
        if name in in_circle:
            protocols[name] = Protocol(item, {}, None, ())
        elif name not in protocols:
            known = dict(protocols)
            protocols[name] = found.keep(
                memory.recall(read_protocol, item, typed[name], known, largest, is_damaged)
            )
    return found.of({item.name.text: protocols[item.name.text] for item, _ in written})


def read_activities(declared: Declarations, processes: Processes, memory: Memory) -> Stage[Described]:
    """What roles say of their activities, one for each name, and their modules."""
    found, each = Found(), memory.each_in_pieces
    blocks = declared.blocks
    in_scopes = [
        (item, processes.scopes[item.name.text], processes.roles.get(item.name.text)) for item in blocks.roles
    ]
    stated = found.keep_all((yield from each(_typed_activities, in_scopes)))
    of_roles = found.keep_all((yield from each(_read_modules, in_scopes, declared.is_damaged)))
    modules = {item.name.text: of_role for item, of_role in zip(blocks.roles, of_roles, strict=True)}
    of_names = memory.same_values("statements", by_name(chain.from_iterable(stated)))
    merged = found.keep_all((yield from each(merge_activity, zip(of_names.values()))))
    described = memory.same_values("described", dict(zip(of_names, merged, strict=True)))
    return found.of(Described(described, modules))


def _places(roles: Iterable[tree.Srm | tree.Statechart]) -> dict[str, Span]:
    return {item.name.text: item.name.span for item in roles}


def _problems_alone(
    item: tree.Srm, top: Scope, protocols: Mapping[str, Protocol], largest: int, is_damaged: Damaged
) -> Iterable[Diagnostic]:
    """What is wrong with a role that no other one completes."""
    typed, problems = role_scope(item, top)
    yield from problems
    yield from read_role(item, typed, protocols, largest, is_damaged)[1]


def _typed_activities(
    block: tree.Srm | tree.Statechart, typed_role: TypedRole, role: Role | None
) -> With[tuple[Activity, ...]]:
    played = _played_variables(role)
    typed = [type_activity(item, typed_role.scope, played) for item in block.activities]
    return tuple(item for item, _ in typed), tuple(problem for _, found in typed for problem in found)


def _played_variables(role: Role | None) -> frozenset[str]:
    """The variables of the participants that a role plays."""
    parts = role.parts.values() if role is not None else ()
    return frozenset(variable.name for part in parts for variable in part.variables)


def _read_modules(
    block: tree.Srm | tree.Statechart, typed_role: TypedRole, role: Role | None, is_damaged: Damaged
) -> With[tuple[Module, ...]]:
    return read_modules(block.modules, typed_role.scope, is_damaged(block.span))


__all__ = [
    "Described",
    "Processes",
    "Requirements",
    "read_activities",
    "read_processes",
    "read_requirements",
]
