"""The whole team: what every process says of itself, and which members do not answer."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.project.playing.operate import Endpoint, Node, OperateError, ask_each, running_from
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.project.playing.remote import Robot
    from aseme_dsl.runtime.control.replies import Reply

SEVERAL = "team"
"""What a process with several agents is called."""
UNKNOWN = "it runs in no process that was asked"


@dataclass(frozen=True, slots=True)
class Silent:
    """What does not answer: an agent's name, or that of a process with several agents; and why."""

    name: str
    reason: str


@dataclass(frozen=True, slots=True)
class WholeTeam:
    """The processes that answer, what does not, and the names of all members."""

    nodes: tuple[Node, ...]
    silent: tuple[Silent, ...]
    members: tuple[str, ...]

    @property
    def missing(self) -> tuple[str, ...]:
        """The members that do not answer, in alphabetical order."""
        there = {name for node in self.nodes for name in node.agents}
        return tuple(name for name in self.members if name not in there)

    @property
    def is_whole(self) -> bool:
        """Whether all have answered."""
        return not self.silent and not self.missing

    def reasons(self) -> Iterator[str]:
        """A line for each that does not answer."""
        known = set()
        for item in self.silent:
            known.add(item.name)
            yield item.reason
        for name in self.missing:
            if name not in known:
                yield f"{name} does not answer: {UNKNOWN}"

    def models(self) -> dict[str, list[str]]:
        """The agents by the model of the whole team that their processes follow."""
        found: dict[str, list[str]] = {}
        for node in self.nodes:
            found.setdefault(node.status["model"], []).extend(node.agents)
        return found


def whole_team(output: Path, robots: Sequence[Robot] | None = None, seconds: float = 5.0) -> WholeTeam:
    """Ask all that runs from an output folder, or all robots over their network, for at most so long.

    Raises:
        OperateError: nothing runs.
    """
    found: Sequence[Endpoint] = running_from(output) if robots is None else robots
    replies = ask_each({endpoint: {"request": "status"} for endpoint in found}, seconds)
    nodes = tuple(Node(endpoint, reply) for endpoint, reply in replies.items() if reply["ok"])
    silent = tuple(
        Silent(name_of(endpoint), reason)
        for endpoint, reply in replies.items()
        if not reply["ok"]
        for reason in reply["reasons"][:1]
    )
    if robots is not None:
        members = [robot.name for robot in robots]
    else:
        members = [name for node in nodes for name in (*node.agents, *node.status["elsewhere"])]
        members += [item.name for item in silent if item.name != SEVERAL]
    return WholeTeam(nodes, silent, tuple(sorted(set(members))))


def name_of(endpoint: Endpoint) -> str:
    """The agent of an endpoint, or the name of a process that has several."""
    from aseme_dsl.runtime.control.control_socket import label_of

    return label_of(endpoint) if isinstance(endpoint, Path) else endpoint.name


def as_data(team: WholeTeam) -> dict[str, object]:
    """The team as JSON: the form that docs/reference/team-json.md describes."""
    return {
        "ok": team.is_whole,
        "members": list(team.members),
        "missing": list(team.missing),
        "silent": [{"name": item.name, "reason": item.reason} for item in team.silent],
        "processes": [{"endpoint": str(node.socket), **_said(node.status)} for node in team.nodes],
    }


def _said(status: Reply) -> dict[str, object]:
    """What a process says, without what is about the reply."""
    return {name: value for name, value in status.items() if name not in ("version", "ok")}


__all__ = ["UNKNOWN", "OperateError", "Silent", "WholeTeam", "as_data", "name_of", "whole_team"]
