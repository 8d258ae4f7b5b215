"""Scopes: the teams in which something is proved: that of the system, and one for each protocol alone."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Set
from dataclasses import replace
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.amola.aip import Aip, Participant
from aseme_dsl.amola.messages import Kind
from aseme_dsl.amola.system import System
from aseme_dsl.play.sight.story import Happened
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, is_library_path

_PREFIX = "proved_"

_PLACES = re.compile(r" \(([^\s()]+:\d+(?:, [^\s()]+:\d+)*)\)")
"""The places in a line of a story."""

TEAM = "team"
"""What the scope of the team is called."""


@dataclass(frozen=True, slots=True)
class Scope:
    """A team to explore: `what` it is for readers, its source, and its agents with their roles."""

    what: str
    root: Path | Source
    team: tuple[tuple[str, str], ...]
    protocol: str | None = None
    roles: str = ""
    """The roles that the source has beside those of the file."""
    lines: int = 0
    """The number of lines of the file, if the source has more."""

    @property
    def agents(self) -> str:
        """`1 manager, 2 contractor`."""
        counts = Counter(role if self.protocol is None else self.participant(role) for _, role in self.team)
        return ", ".join(f"{count} {role}" for role, count in counts.items())

    def participant(self, role: str) -> str:
        """The participant that a role plays, in a protocol alone."""
        return role.removeprefix(f"{_PREFIX}{self.protocol}_")

    def in_the_file(self, story: Iterable[Happened]) -> tuple[Happened, ...]:
        """A story without the places that are beyond the end of the file."""
        if not self.lines or not isinstance(self.root, Source):
            return tuple(story)
        name = Path(self.root.path).name

        def is_there(place: str) -> bool:
            file, _, line = place.rpartition(":")
            return file != name or int(line) <= self.lines

        def shown(text: str) -> str:
            return _PLACES.sub(lambda found: _in_parentheses(filter(is_there, found[1].split(", "))), text)

        return tuple(
            replace(
                item,
                text=shown(item.text),
                at=shown(f" ({item.at})")[2:-1],
                details=tuple(map(shown, item.details)),
            )
            for item in story
        )


def scopes_of(root: Path | Source, system: System, robots: int) -> Iterator[Scope]:
    """The team, and each protocol of which the file itself tells."""
    team = _team(system, robots)
    if team:
        yield Scope(TEAM, root, team)
    names = frozenset(agent.name for item in system.teams for agent in item.agents)
    for aip in system.aips:
        if not is_library_path(aip.span.source.path):
            yield scope_of(root, aip, robots, names)


def scope_of(root: Path | Source, aip: Aip, robots: int, names: Set[str] = frozenset()) -> Scope:
    """A protocol alone: agents that play a participant once each, and do nothing else.

    None is called like an agent of the team: these `names` are taken.
    What a participant is given comes from outside, as a state that may change at any time.
    """
    source = root if isinstance(root, Source) else Source(str(root), outside.read_text(root))
    texts = [_role(aip.name, part) for part in aip.participants]
    team = tuple(
        (_free(f"{part.name}{number}" if count > 1 else part.name, names), role_of(aip.name, part.name))
        for part in aip.participants
        for count in (_count(part, robots),)
        for number in range(1, count + 1)
    )
    there = _in_one_line(source.text)
    missing = [text for text in texts if _in_one_line(text) not in there]  # a saved counterexample has them
    whole = Source(source.path, f"{source.text}\n\n{''.join(missing)}")
    lines = len(source.text.splitlines())
    return Scope(f"protocol {aip.name}", whole, team, aip.name, "".join(texts), lines)


def _in_parentheses(texts: Iterable[str]) -> str:
    said = ", ".join(texts)
    return f" ({said})" if said else ""


def _in_one_line(text: str) -> str:
    return " ".join(text.split())


def role_of(protocol: str, participant: str) -> str:
    """The role that plays a participant and nothing else."""
    return f"{_PREFIX}{protocol}_{participant}"


def agents_of(system: System) -> dict[str, str]:
    """The agents of the system, with their roles: without a team also none for a saved counterexample."""
    if any(team.agents for team in system.teams):
        return system.agents
    return {name: role for name, role in system.agents.items() if not is_for_a_run(role)}


def is_for_a_run(role: str) -> bool:
    """Whether a role is there for a counterexample only, by its name."""
    return role.startswith(_PREFIX)


def _free(name: str, names: Set[str]) -> str:
    """A name that is not taken."""
    while name in names:
        name = f"a_{name}"
    return name


def _role(protocol: str, part: Participant) -> str:
    """A role that plays a participant and nothing else. Its inputs, but for agents, come in a message."""
    role = role_of(protocol, part.name)
    inputs = [item for item in part.inputs if item.type.kind is not Kind.AGENT]
    declared = supplied = ""
    if inputs:
        members = "  ".join(f"{item.type} {item.name}" for item in inputs)
        declared = f"message {role}_inputs {{ {members} }}\ntopic {role}_given {{ state {role}_inputs }}\n"
        values = (f"{item.name} = {role}_given.state.{role}_inputs.{item.name}" for item in inputs)
        supplied = f" with {', '.join(values)}"
    plays = f"plays {protocol}.{part.name}{supplied}"
    return f"{declared}srm {role} {{ {plays} liveness {{ {role} = {part.name} }} }}\n"


def _count(part: Participant, robots: int) -> int:
    """How many agents play a participant."""
    wanted = max(part.least, robots if part.most != 1 else 1)
    return wanted if part.most is None else min(wanted, part.most)


def _team(system: System, robots: int) -> tuple[tuple[str, str], ...]:
    """The agents of the system, so many of each role that has several."""
    counts: Counter[str] = Counter()
    kept = []
    for name, role in agents_of(system).items():
        counts[role] += 1
        if counts[role] <= robots:
            kept.append((name, role))
    return tuple(kept)


__all__ = ["TEAM", "Scope", "agents_of", "is_for_a_run", "role_of", "scope_of", "scopes_of"]
