"""Resolve: what the declarations of all files mean: enums, messages, topics, functions, agents."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace

from aseme_dsl.amola.messages import AGENT, Function, Type
from aseme_dsl.amola.system import Agent, Team
from aseme_dsl.compiler.names.activity_forms import activity_forms
from aseme_dsl.compiler.names.inclusion import includers
from aseme_dsl.compiler.names.message_types import enums, imported_types, messages
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.names.topics import check_radio, topics
from aseme_dsl.compiler.read.builtins import FORMS, FUNCTIONS, YIELDING, reserved
from aseme_dsl.compiler.read.collector import Collector, type_named
from aseme_dsl.compiler.read.load import Loaded
from aseme_dsl.compiler.read.names import declared_twice, unknown
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems import names as problems
from aseme_dsl.diagnostics.problems.absences import NoRoleOfAgent
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span

__all__ = ["Symbols", "resolve"]

MOST_AGENTS = 1000

_TARGET = re.compile(r"[A-Za-z_]\w*(\.[A-Za-z_]\w*)*:[A-Za-z_]\w*(\.[A-Za-z_]\w*)*", re.ASCII)


def resolve(loaded: Loaded) -> tuple[Symbols, tuple[Diagnostic, ...]]:
    """Collect the declarations of all files; duplicates, unknown types, reserved names, … are reported.

    Also checked here: that there is at most one `system`, and that every agent's role is an `srm` or a
    `statechart` (E207).
    """
    collector = Collector(loaded.files, lost=loaded.lost, complete=loaded.complete)
    imported_enums, imported_messages, imported_files = imported_types(collector, loaded.protos)
    all_enums = imported_enums + enums(collector)
    own_messages = messages(collector, {item.name for item in all_enums}, imported_messages)
    system, teams = _system(collector), _teams(collector)
    symbols = Symbols(
        system=system,
        enums=all_enums,
        messages=imported_messages + own_messages,
        protos=imported_files,
        teams=teams,
        roles=frozenset() if teams else frozenset(_roles(collector)),
        wrong=frozenset(collector.wrong),
        lost=loaded.lost,
        complete=loaded.complete,
    )
    symbols = replace(
        symbols,
        topics=topics(collector, symbols),
        functions=_functions(collector, symbols),
        lets=_lets(collector),
        activities=activity_forms(
            collector, {item.name for item in symbols.enums}, {item.name for item in symbols.messages}
        ),
    )
    check_radio(collector, symbols)
    return replace(symbols, wrong=frozenset(collector.wrong)), tuple(collector.diagnostics)


def _system(collector: Collector) -> tree.System | None:
    first = None
    for item in collector.every(tree.System):
        if first is None:
            first = item
            continue
        twice = problems.SystemTwice(first.span.source.path != item.span.source.path)
        collector.report(twice, item.name.span, Related(first.name.span, "first declared here"))
    return first


def _functions(collector: Collector, symbols: Symbols) -> tuple[Function, ...]:
    found: dict[tuple[str, tuple[Type, ...]], Function] = {}
    built_in = {item.name for item in FUNCTIONS} | (set(FORMS) - YIELDING)
    enum_names = [item.name for item in symbols.enums]
    message_names = [item.name for item in symbols.messages]
    for item in collector.every(tree.Function):
        name = item.name.text
        reason = "built in" if name in built_in else reserved(name)
        if reason is not None:
            collector.report(problems.ReservedName("function", name, reason), item.name.span)
            continue
        kinds = [
            type_named(collector, parameter.type, enum_names, message_names) for parameter in item.parameters
        ]
        result = (
            AGENT  # who an agent is, is known by its name; an argument that is one is a string
            if item.result.text == str(AGENT)
            else type_named(collector, item.result, enum_names, message_names)
        )
        if not _TARGET.fullmatch(item.target.text):
            collector.report(problems.NoTarget("function", item.target.text), item.target.span)
        seen: dict[str, Span] = {}
        for parameter in item.parameters:
            if parameter.name.text in seen:
                first = seen[parameter.name.text]
                collector.diagnostics.append(declared_twice("parameter", parameter.name, first))
            seen.setdefault(parameter.name.text, parameter.name.span)
        if result is None or None in kinds:
            collector.wrong.add(name)
            continue
        types = tuple(kind for kind in kinds if kind is not None)
        function = Function(
            name,
            tuple(zip((parameter.name.text for parameter in item.parameters), types, strict=True)),
            result,
            item.target.text,
            item.name.span,
        )
        first_one = found.setdefault((name, types), function)
        if first_one is not function:
            twice = problems.FunctionTwice(name, tuple(str(kind) for kind in types))
            collector.report(twice, item.name.span, Related(first_one.span, "first declared here"))
    return tuple(found.values())


def _lets(collector: Collector) -> tuple[tree.Let, ...]:
    found: dict[str, tree.Let] = {}
    for item in collector.every(tree.Let):
        reason = reserved(item.name.text)
        if reason is not None:
            collector.report(problems.ReservedName("let", item.name.text, reason), item.name.span)
        first = found.setdefault(item.name.text, item)
        if first is not item:
            collector.diagnostics.append(declared_twice("let", item.name, first.name.span))
    return tuple(found.values())


def _roles(collector: Collector) -> set[str]:
    """What an agent can have as its role."""
    roles = {item.name.text for item in collector.every(tree.Srm) if not item.abstract}
    return roles | {item.name.text for item in collector.every(tree.Statechart)}


def _teams(collector: Collector) -> tuple[Team, ...]:
    roles = _roles(collector)
    srms = collector.every(tree.Srm)
    abstract = {item.name.text: item for item in srms if item.abstract and item.name.text not in roles}
    found: dict[str, Team] = {}
    for item in collector.every(tree.Team):
        team = Team(item.name.text, _agents(collector, item, roles, abstract), item.name.span)
        first = found.setdefault(team.name, team)
        if first is not team:
            collector.diagnostics.append(declared_twice("team", item.name, first.span))
    return tuple(found.values())


def _is_abstract(name: tree.Name, role: tree.Srm, roles: set[str], collector: Collector) -> Diagnostic:
    including = [item for item in includers(collector.every(tree.Srm)).get(name.text, ()) if item in roles]
    problem = problems.AbstractRoleOfAgent(name.text, tuple(including))
    return Diagnostic(problem, name.span, (Related(role.name.span, "the abstract role"),))


def _agents(
    collector: Collector, team: tree.Team, roles: set[str], abstract: Mapping[str, tree.Srm]
) -> tuple[Agent, ...]:
    found: dict[str, Agent] = {}
    for line in team.agents:
        if line.role.text in abstract:
            collector.diagnostics.append(_is_abstract(line.role, abstract[line.role.text], roles, collector))
        elif line.role.text not in roles and not collector.is_excused(line.role.text):
            collector.diagnostics.append(unknown(NoRoleOfAgent, line.role, roles))
        for name, many in line.names:
            if many is not None and many[1] - many[0] >= MOST_AGENTS:
                collector.report(problems.TooManyAgents(name.text, *many, MOST_AGENTS), name.span)
                continue
            numbers = [None] if many is None else list(range(many[0], many[1] + 1))
            for number in numbers:
                own = name.text if number is None else f"{name.text}{number}"
                agent = Agent(own, line.role.text, name.span, 1 if number is None else number)
                first = found.setdefault(agent.name, agent)
                if first is not agent:
                    called = tree.Name(agent.name, name.span)
                    collector.diagnostics.append(declared_twice("agent", called, first.span))
    return tuple(found.values())
