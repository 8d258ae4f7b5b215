"""Agents of the team that leave a protocol of the library before its end, in every way that there is."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.team.faults import Crash, Faults
from aseme_dsl.runtime.team.swap import Version
from aseme_dsl.runtime.team.team import Team
from tests.faults.changing import version
from tests.runtime.playing import MS, SECOND, Played, make
from tests.stdlib.hostile import LIMIT, finish
from tests.stdlib.library import PROTOCOLS, Act, Protocol, kind_of
from tests.support.generated import Generated, generate

ROLES = """
srm abandoning_{part} {{
{entries}
  var stop : bool = false
  liveness {{ abandoning_{part} = work || Clock  work = {term} [> Halt  {formulas} }}
  activities {{ Clock writes stop }}
  control work {{ enter Halt : when [stop] }}
}}
srm leaving_{part} {{
{entries}
  var stop : bool = false
  liveness {{ leaving_{part} = work || Clock  work = {term} . Halt  {formulas} }}
  activities {{ Clock writes stop }}
  control work {{ enter Halt : when [stop] }}
}}
srm idle_{part} {{
  liveness {{ idle_{part} = Halt~ }}
  activities {{ Halt takes 1min }}
}}
srm erring_{part} {{
{entries}
  liveness {{ erring_{part} = {term} . Halt  {formulas} }}
  control erring_{part} {{ enter Halt : error }}
}}
"""
"""Roles that leave their part: cut short from outside, by the way to what follows, for another role, and by
an error."""

AGENTS = [(item.name, agent) for item in PROTOCOLS for agent in item.parts]
"""Each agent of each protocol."""

Way = Callable[[Protocol, str, float], Played]
"""A run in which an agent leaves after so many seconds."""


@cache
def with_roles(name: str, text: str) -> Generated:
    """The package of a protocol's text, with the roles that leave."""
    return generate(text)


def of(item: Protocol) -> Generated:
    roles = []
    for part in dict.fromkeys(item.parts.values()):
        said = item.said_of(part)
        roles.append(ROLES.format(part=part, entries=said.entries, term=said.term, formulas=said.formulas))
    return with_roles(item.name, item.text() + "".join(roles))


def clock(seconds: float) -> type[Any]:
    class Clock:
        def execute(self, context: Context) -> None:
            context.wait(seconds)
            context.set_variable("stop", True)

    return Clock


def _run(
    item: Protocol,
    agent: str,
    role: str,
    acts: Mapping[str, Act],
    seconds: float,
    change: Callable[[Team], None] = lambda team: None,
    **options: Any,
) -> Played:
    made = of(item)
    begins = item.acts[item.first]
    acts = {**item.acts, item.first: Act(0.05, begins.sets, begins.says, begins.breaks), **acts}
    classes = {name: kind_of(made, name, what) for name, what in acts.items()}
    agents = [(name, role if name == agent else f"{part}_role") for name, part in item.parts.items()]
    classes["Clock"] = clock(seconds)
    whole = version(made, classes)
    team, records = make(made, classes, agents=agents, until=LIMIT, version=whole, **options)
    change(team)
    return finish(team, records)


def abandons(item: Protocol, agent: str, seconds: float) -> Played:
    return _run(item, agent, f"abandoning_{item.parts[agent]}", {}, seconds)


def leaves(item: Protocol, agent: str, seconds: float) -> Played:
    return _run(item, agent, f"leaving_{item.parts[agent]}", {}, seconds)


def crashes(item: Protocol, agent: str, seconds: float) -> Played:
    """It is gone for good."""
    return _crashing(item, agent, seconds, LIMIT)


def returns(item: Protocol, agent: str, seconds: float) -> Played:
    """It is gone, and begins anew."""
    return _crashing(item, agent, seconds, SECOND)


def changes_role(item: Protocol, agent: str, seconds: float) -> Played:
    """An operator has it play another role."""
    moment = int(seconds * 1000) * MS

    def change(team: Team) -> None:
        team.select(agent, f"idle_{item.parts[agent]}", at=moment)

    return _run(item, agent, f"{item.parts[agent]}_role", {}, 0, change=change)


def swaps(item: Protocol, agent: str, seconds: float) -> Played:
    """Another version of its role comes, which does not play the protocol, and waits a moment for it."""
    moment = int(seconds * 1000) * MS

    def change(team: Team) -> None:
        team.swap(_without_part(item, item.parts[agent]), at=moment, within=10 * MS, agents=[agent])

    return _run(item, agent, f"{item.parts[agent]}_role", {}, 0, change=change)


@cache
def _version(text: str) -> Version:
    return version(text)


def _without_part(item: Protocol, part: str) -> Version:
    """The protocol's text, but the role of a part does something else."""
    said = item.said_of(part)
    formulas = "  ".join(filter(None, (said.term, said.formulas)))
    mine = f"{said.entries}\n  liveness {{ {part}_role = {formulas} }}"
    other = f"  liveness {{ {part}_role = Halt~ }}\n  activities {{ Halt takes 1min }}"
    whole = item.text()
    assert mine in whole
    return _version(whole.replace(mine, other))


def _crashing(item: Protocol, agent: str, seconds: float, gone: int) -> Played:
    faults = Faults(crashes=(Crash(agent, int(seconds * 1000) * MS, gone),))
    return _run(item, agent, f"{item.parts[agent]}_role", {}, 0, faults=faults)


def ends_in_errors(item: Protocol, agent: str, activity: str, *, caught: bool) -> Played:
    """An activity of the agent fails; its role goes on with something else, or the agent stops."""
    what = item.acts[activity]
    breaks = {name: name == agent for name in item.parts}
    takes = what.takes or 0.05
    role = f"erring_{item.parts[agent]}" if caught else f"{item.parts[agent]}_role"
    return _run(item, agent, role, {activity: Act(takes, what.sets, what.says, breaks)}, 0)


WAYS: dict[str, Way] = {
    "abandons": abandons,
    "leaves": leaves,
    "crashes": crashes,
    "returns": returns,
    "changes role": changes_role,
}
ALL = "NETWORK_SEEDS" in os.environ
"""Whether `python3 dev.py long` asks for every moment of every agent."""
MOMENTS = (0.02, 0.06, 0.12, 0.25, 0.35, 0.5, 1.1, 1.6, 2.2, 2.6, 3.2, 4.2, 5.3, 7.4, 8.0)
"""In each phase of each protocol."""


def moments(name: str, agent: str, way: str) -> tuple[float, ...]:
    """When an agent leaves: every third moment, and others for another agent, or all."""
    step = 5 if way == "changes role" else 3  # which costs more
    return MOMENTS if ALL else MOMENTS[len(f"{name} {agent} {way}") % step :: step]
