"""Settings: what variables hold at first in the agents of a team: `keeper : goalie with limit = 80`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from aseme_dsl.amola.aip import DeclaredVariable
from aseme_dsl.amola.expression import INSTANCE, Literal, Value, substituted
from aseme_dsl.amola.messages import DOUBLE, INT
from aseme_dsl.amola.system import Agent, Team
from aseme_dsl.compiler.names.bounds import outside
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.read.constants import NotConstant, fold
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.compiler.types.scopes import TypedRole
from aseme_dsl.compiler.types.typecheck import type_value
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.absences import NoVariableOfRole
from aseme_dsl.diagnostics.problems.expressions.paths import SettingNotConstant
from aseme_dsl.diagnostics.problems.expressions.values import NotComputed
from aseme_dsl.diagnostics.problems.names import SetTwice
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span


def settle(
    teams: Iterable[Team], files: Iterable[tree.File], roles: Mapping[str, TypedRole], top: Scope
) -> tuple[tuple[Team, ...], tuple[Diagnostic, ...]]:
    """The teams with what is set in their agents (E514, E610, E611)."""
    found: list[Diagnostic] = []
    settings: dict[Span, tuple[tuple[DeclaredVariable, Value], ...]] = {}
    for file in files:
        for team in file.declarations:
            if isinstance(team, tree.Team):
                for line in team.agents:
                    values = _line(line, roles, top, found) if line.settings else ()
                    settings.update((name.span, values) for name, _ in line.names)
    settled = []
    for group in teams:
        agents = (_settled(agent, settings.get(agent.span, ()), found) for agent in group.agents)
        settled.append(replace(group, agents=tuple(agents)))
    return tuple(settled), tuple(dict.fromkeys(found))


def _line(
    line: tree.TeamAgents, roles: Mapping[str, TypedRole], top: Scope, found: list[Diagnostic]
) -> tuple[tuple[DeclaredVariable, Value], ...]:
    """The variables that a line sets, with their values and types."""
    role = roles.get(line.role.text)
    if role is None:
        return ()
    variables = {item.name: item for item in role.variables}
    values: dict[str, tuple[DeclaredVariable, Value]] = {}
    first: dict[str, tree.Name] = {}
    for item in line.settings:
        name = item.name
        if first.setdefault(name.text, name) is not name:
            related = (Related(first[name.text].span, "first set here"),)
            found.append(Diagnostic(SetTwice(name.text), name.span, related))
            continue
        variable = variables.get(name.text)
        if variable is None:
            if not top.symbols.is_excused(name.text):
                found.append(unknown(NoVariableOfRole, name, variables, line.role.text))
            continue
        value, problems = type_value(item.value, top, variable.type)
        found += problems
        if value is not None:
            values[name.text] = (variable, value)
    return tuple(values.values())


def _settled(
    agent: Agent, values: Iterable[tuple[DeclaredVariable, Value]], found: list[Diagnostic]
) -> Agent:
    settings: list[tuple[str, Literal]] = []
    for variable, value in values:
        number = Literal(agent.index, INT, value.span)
        try:
            constant = fold(substituted(value, {INSTANCE: number}))
        except NotConstant as problem:
            found.append(Diagnostic(SettingNotConstant(), problem.value.span))
            continue
        except ArithmeticError as problem:
            found.append(Diagnostic(NotComputed(str(problem)), value.span))
            continue
        if variable.type == DOUBLE:
            assert not isinstance(constant, str)
            constant = float(constant)
        literal = Literal(constant, variable.type, value.span)
        wrong = outside(variable.name, variable.bounds, literal)
        if wrong is not None:
            found.append(wrong)
            continue
        settings.append((variable.name, literal))
    return replace(agent, settings=tuple(settings)) if settings else agent


__all__ = ["settle"]
