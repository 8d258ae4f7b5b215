"""Stopping: the agents of a team end one after the other, and who does not is named."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.project.operating.whole_team import WholeTeam, whole_team
from aseme_dsl.project.playing.operate import Node, OperateError, ask_each, running_from, unknown_agent
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.project.playing.remote import Robot

_PAUSE = 0.05


@dataclass(frozen=True, slots=True)
class Stopped:
    """The agents that have ended, in this order, and why others have not or may not have."""

    ended: tuple[str, ...]
    problems: tuple[str, ...]


def stop(
    output: Path,
    robots: Sequence[Robot] | None = None,
    agents: Sequence[str] = (),
    *,
    within: float = 10.0,
    tell: Callable[[str], None] = lambda name: None,
) -> Stopped:
    """End the processes of these agents in this order; without `agents` all, in alphabetical order.

    A process has `within` seconds to end. `tell` is given the name of each agent that has ended. A process
    that has several agents ends with all of them.

    Raises:
        OperateError: nothing runs, or there is no such agent; nothing was stopped.
    """
    team = whole_team(output, robots)
    chosen = _chosen(team, agents)
    ended: list[str] = []
    problems = [] if agents else list(team.reasons())
    for node in chosen:
        (reply,) = ask_each({node.socket: {"request": "stop"}}, within).values()
        if not reply["ok"]:
            problems += reply["reasons"]
        elif not _has_ended(output, node, within):
            problems.append(f"{', '.join(node.agents)} did not end within {within:g} s")
        else:
            for name in node.agents:
                ended.append(name)
                tell(name)
    return Stopped(tuple(ended), tuple(problems))


def _chosen(team: WholeTeam, agents: Sequence[str]) -> list[Node]:
    """The processes of these agents, each once. Raises OperateError."""
    if not agents:
        return sorted(team.nodes, key=lambda node: node.agents)
    chosen: list[Node] = []
    for name in agents:
        node = next((node for node in team.nodes if name in node.agents), None)
        if node is None:
            lines = [f"{name} does not answer"] if name in team.missing else []
            raise OperateError(*(lines or [unknown_agent(name, team.nodes)]))
        others = [other for other in node.agents if other not in agents]
        if others:
            raise OperateError(f"{name} runs in one process with {', '.join(others)}: name them, too")
        if node not in chosen:
            chosen.append(node)
    return chosen


def _has_ended(output: Path, node: Node, within: float) -> bool:
    """Whether a process ends in so many seconds: nothing answers for it any more."""
    deadline = time.monotonic() + within
    while (left := deadline - time.monotonic()) > 0:
        if isinstance(node.socket, Path):
            try:
                if node.socket not in running_from(output):
                    return True
            except OperateError:  # nothing runs any more
                return True
        else:
            asked = min(1.0, left)
            (reply,) = ask_each({node.socket: {"request": "status"}}, asked).values()
            if not reply["ok"] or reply["process"]["pid"] != node.status["process"]["pid"]:
                return True
        time.sleep(_PAUSE)
    return False


__all__ = ["Stopped", "stop"]
