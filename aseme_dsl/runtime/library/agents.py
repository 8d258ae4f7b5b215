"""Agents in texts: what the functions of `protocols` do with variables that hold several agents.

Each line is a number and a name as JSON, so that a name may have any characters.
"""

from __future__ import annotations

import json


def with_agent(agents: str, who: str) -> str:
    """The agents with one more behind them; the same ones if it is there already."""
    found = _read(agents)
    if any(name == who for _, name in found):
        return agents
    return _written([*found, (0.0, who)])


def ranked(agents: str, who: str, number: float) -> str:
    """The agents with one before the first whose number is greater; it has one place, its last."""
    found = [(number_there, name) for number_there, name in _read(agents) if name != who]
    place = next((index for index, (there, _) in enumerate(found) if there > number), len(found))
    return _written([*found[:place], (number, who), *found[place:]])


def without(agents: str, who: str) -> str:
    """The agents less one."""
    return _written([(number, name) for number, name in _read(agents) if name != who])


def lists(agents: str, who: str) -> bool:
    """Whether an agent is among them."""
    return any(name == who for _, name in _read(agents))


def how_many(agents: str) -> int:
    """How many agents they are."""
    return len(_read(agents))


def first_of(agents: str) -> str | None:
    """The first of the agents, or None."""
    found = _read(agents)
    return found[0][1] if found else None


def agent_called(name: str) -> str | None:
    """The agent with a name; None without one."""
    return name or None


def number_of(agents: str, who: str) -> float:
    """The number of an agent, or 0."""
    return next((number for number, name in _read(agents) if name == who), 0.0)


def _read(agents: str) -> list[tuple[float, str]]:
    return [(float(number), name) for number, name in map(json.loads, agents.splitlines())]


def _written(agents: list[tuple[float, str]]) -> str:
    return "\n".join(json.dumps(item) for item in agents)
