"""Status: what a process says of its agents, of the others as it sees them, and of itself."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.runtime.control.recent import Recent
from aseme_dsl.runtime.control.replies import AgentStatus, HeldSwap, PeerStatus, Reply
from aseme_dsl.runtime.control.usage import usage
from aseme_dsl.runtime.trace.state_names import titles_of

if TYPE_CHECKING:
    from aseme_dsl.runtime.agent.agent import Agent
    from aseme_dsl.runtime.team.team import Team
    from aseme_dsl.runtime.transport import Peer


def status_of(team: Team, activities: Path | None, recent: Recent | None, held: HeldSwap | None) -> Reply:
    """The reply to `status`."""
    peers = team.peers()
    unread = Counter(item[0] for item in team.conversations.unread())
    return {
        "system": team.system,
        "model": team.version.model,
        "activity_folder": None if activities is None else str(activities.absolute()),
        "plans": list(team.version.charts),
        "time": team.driver.clock.now(),
        "agents": [_agent(agent, unread[agent.name]) for agent in team.agents],
        "elsewhere": sorted(team.elsewhere),
        "clocks": {
            name: {"difference": peer.difference, "uncertainty": peer.uncertainty}
            for name, peer in sorted(peers.items())
        },
        "peers": {name: _peer(peer) for name, peer in sorted(peers.items())},
        "process": usage(),
        "faults": sum(item.count for item in team.trace.faults.counts()),
        "counts": {} if recent is None else recent.counts(),
        "trace_error": team.trace.error,
        "swap": held,
    }


def _agent(agent: Agent, unread: int) -> AgentStatus:
    chart, names = agent.chart, agent.plan.by_label
    labels = chart.configuration() if chart.started else ()
    titles = titles_of(agent.plan)
    return {
        "name": agent.name,
        "role": agent.role,
        "system": agent.plan.system,
        "model": agent.plan.model,
        "over": agent.over,
        "failure": chart.failure,
        "steps": agent.steps,
        "configuration": list(labels),
        "states": [titles.get(label, label) for label in labels],
        "activities": [name for x in labels if x in names and (name := names[x].activity)],
        "waiting": len(agent.intake),
        "unread": unread,
    }


def _peer(peer: Peer) -> PeerStatus:
    return {
        "connected": peer.alive,
        "model": peer.model or None,
        "incompatible": list(peer.incompatible),
        "received": peer.taken,
        "refused": peer.refused,
        "rejected": peer.rejected,
        "lost": peer.lost,
        "dropped": peer.dropped,
        "duplicated": peer.duplicated,
        "reordered": peer.reordered,
        "unreadable": peer.unreadable,
        "late": peer.late,
        "waiting": peer.unacknowledged,
    }
