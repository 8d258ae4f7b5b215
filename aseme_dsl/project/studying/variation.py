"""Variation: the same system with more or fewer agents, other settings of them, or quicker activities."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from aseme_dsl.diagnostics import closest
from aseme_dsl.project.files.duration import duration
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.amola.expression import Literal
    from aseme_dsl.amola.messages import Type
    from aseme_dsl.amola.system import Agent, System

_RANGE = re.compile(r"(\d+)\.\.(\d+)", re.ASCII)
_MOST_VALUES = 1000


class VariationError(ValueError):
    """The system cannot be varied like that; the text says why."""


@dataclass(frozen=True, slots=True)
class Knob:
    """Something to vary and its values, as written: `carrier=1..8`, `keeper.limit=60,80`.

    Without a point it is a range of the team (`carrier[1..8]`), and the values are how many agents it has.
    With one it is a variable of an agent, of a range, or of all agents of a role.
    """

    name: str
    values: tuple[str, ...]

    @property
    def counts(self) -> bool:
        """Whether it says how many agents there are."""
        return "." not in self.name


Variant = tuple[tuple[Knob, str], ...]
"""A value for each parameter."""


def knob(text: str) -> Knob:
    """The parameter that is written `carrier=1..8`, `carrier=2,4,8` or `keeper.limit=60,80`.

    Raises:
        VariationError: it is not written like that.
    """
    name, equals, written = text.partition("=")
    name = name.strip()
    if not equals or not all(part.isidentifier() for part in name.split(".")) or name.count(".") > 1:
        raise VariationError(f"{text!r} is not written carrier=1..8 or keeper.limit=60,80")
    values: list[str] = []
    for part in written.split(","):
        item = part.strip()
        span = _RANGE.fullmatch(item)
        if span is None:
            values.append(item)
            continue
        first, last = int(span[1]), int(span[2])
        if last < first:
            raise VariationError(f"{text!r}: {item} is not a range from the smaller to the larger")
        if last - first >= _MOST_VALUES:
            raise VariationError(f"{text!r}: {item} are more than {_MOST_VALUES} values, which is the most")
        values += [str(number) for number in range(first, last + 1)]
    if "" in values:
        raise VariationError(f"{text!r} lacks a value")
    if len(set(values)) < len(values):
        double = next(value for value in values if values.count(value) > 1)
        raise VariationError(f"{text!r} has the value {double} twice")
    found = Knob(name, tuple(values))
    if not found.counts:
        return found
    if not all(value.isdecimal() and int(value) > 0 for value in values):
        raise VariationError(f"{text!r}: how many agents there are is a number from 1 on, or a range as 1..8")
    # Sizes are compared step by step, upwards, however they are written.
    return replace(found, values=tuple(sorted(values, key=int)))


def variants(knobs: Sequence[Knob]) -> tuple[Variant, ...]:
    """Every combination of the parameters' values, the last parameter's changing fastest."""
    values = itertools.product(*(item.values for item in knobs))
    return tuple(tuple(zip(knobs, combination, strict=True)) for combination in values)


def varied(system: System, variant: Variant) -> System:
    """The system with these values. Ranges get their sizes first: a setting is for all who are there then.

    Raises:
        VariationError: there is no such range, agent, role or variable, or the value is not of its type.
    """
    if not any(team.agents for team in system.teams):
        raise VariationError(f"{system.name} has no team: nothing of it can be varied")
    for item, value in sorted(variant, key=lambda pair: not pair[0].counts):
        change = _sized if item.counts else _set
        system = change(system, item.name, value)
    return system


def quicker(system: System, activity: str, times: float) -> System:
    """The system with an activity that `takes` so many times less."""
    activities = tuple(
        replace(item, takes=max(1, round(item.takes / times)))
        if item.name == activity and item.takes is not None
        else item
        for item in system.activities
    )
    return replace(system, activities=activities)


def _base(agent: Agent) -> str:
    """The name of the range that an agent is of; its own, if it is of none."""
    number = str(agent.index)
    return agent.name[: -len(number)] if agent.name.endswith(number) else agent.name


def _sized(system: System, name: str, value: str) -> System:
    found = False
    teams = []
    for team in system.teams:
        members = [agent for agent in team.agents if agent.name != name and _base(agent) == name]
        agents: list[Agent] = []
        for agent in team.agents:
            if not members or agent not in members:
                agents.append(agent)
            elif agent is members[0]:
                agents += _range(name, members, int(value))
        found = found or bool(members)
        teams.append(replace(team, agents=tuple(agents)))
    if not found:
        ranges = _ranges(system)
        single = next((agent for team in system.teams for agent in team.agents if agent.name == name), None)
        if single is not None and _base(single) == name:
            written = f"`{name}[1..{max(2, int(value))}] : {single.role}`"
            raise VariationError(f"{name} is one agent of the team and no range: write {written}")
        raise VariationError(f"there is no range of the team called {name}; {instead(name, ranges)}")
    return replace(system, teams=tuple(teams))


def _range(name: str, members: Sequence[Agent], count: int) -> Iterable[Agent]:
    """So many agents of a range: those it has, and further ones like the last."""
    first = members[0].index
    for place in range(count):
        like = members[min(place, len(members) - 1)]
        yield replace(like, name=f"{name}{first + place}", index=first + place)


def _ranges(system: System) -> list[str]:
    agents = [agent for team in system.teams for agent in team.agents]
    return list(dict.fromkeys(_base(agent) for agent in agents if _base(agent) != agent.name))


def _set(system: System, name: str, value: str) -> System:
    who, _, variable = name.partition(".")
    agents = [agent for team in system.teams for agent in team.agents]
    meant = {agent.name for agent in agents if who in (agent.name, _base(agent), agent.role)}
    if not meant:
        known = list(dict.fromkeys(n for agent in agents for n in (agent.name, _base(agent), agent.role)))
        raise VariationError(
            f"there is no agent, range or role of the team called {who}; {instead(who, known)}"
        )
    settings = {role: _setting(system, role, variable, value) for role in _roles(agents, meant)}

    def of(agent: Agent) -> Agent:
        if agent.name not in meant:
            return agent
        others = tuple(item for item in agent.settings if item[0] != variable)
        return replace(agent, settings=(*others, (variable, settings[agent.role])))

    teams = tuple(replace(team, agents=tuple(map(of, team.agents))) for team in system.teams)
    return replace(system, teams=teams)


def _roles(agents: Iterable[Agent], meant: set[str]) -> list[str]:
    return list(dict.fromkeys(agent.role for agent in agents if agent.name in meant))


def _setting(system: System, role: str, name: str, written: str) -> Literal:
    chart = system.iac(role)
    variables = [item for item in chart.variables if item.scope is None] if chart is not None else []
    variable = next((item for item in variables if item.name == name), None)
    if variable is None:
        there = instead(name, [item.name for item in variables])
        raise VariationError(f"there is no variable of {role} called {name}; {there}")
    try:
        value = _value(system, variable.type, written)
    except ValueError:
        raise VariationError(
            f"{written!r} is not of the type {variable.type}, which {name} of {role} is"
        ) from None
    if variable.bounds is not None and not variable.bounds.hold(value):
        raise VariationError(f"{name} of {role} cannot be {written}: its bounds are {variable.bounds}")
    return replace(variable.initial, value=value)


def _value(system: System, kind: Type, written: str) -> bool | int | float | str:
    """Raises ValueError if what is written is not of this type."""
    enum = system.enum(kind.name)
    if enum is not None:
        constant = written.removeprefix(f"{enum.name}.")
        if enum.number(constant) is None:
            raise ValueError(written)
        return constant
    match str(kind):
        case "bool":
            return {"true": True, "false": False}[written] if written in ("true", "false") else _no(written)
        case "int":
            return int(written)
        case "double":
            return float(written)
        case "duration":
            return duration(written)
        case "string":
            return written
    return _no(written)


def _no(written: str) -> bool:
    raise ValueError(written)


def instead(name: str, known: Sequence[str]) -> str:
    """What may have been meant by a name that is not known, or what there is."""
    near = closest(name, known)
    if near is not None:
        return f"did you mean {near}?"
    if len(known) == 1:
        return f"there is only {known[0]}"
    return f"there are {', '.join(known)}" if known else "there is none"
