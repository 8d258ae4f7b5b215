"""The whole team in lines for a terminal."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from aseme_dsl.project.operating.whole_team import WholeTeam

if TYPE_CHECKING:
    from aseme_dsl.runtime.control.replies import AgentStatus, PeerStatus, Reply

UNSYNCHRONISED = "is not synchronised: dates in its traces and logs may be wrong"
"""What is said of a machine's clock; times between agents are measured, and do not depend on it."""
_COUNTED = (
    "lost",
    "refused",
    "rejected",
    "dropped",
    "unreadable",
    "late",
    "duplicated",
    "reordered",
    "waiting",
)
"""The counts of a peer that are shown where they are not 0."""


def status_lines(team: WholeTeam) -> Iterator[str]:
    """What each process says, and whether the agents follow one model."""
    for node in team.nodes:
        yield from _process_lines(node.status)
    models = team.models()
    if len(models) > 1:
        each = "; ".join(f"{', '.join(names)}: {model}" for model, names in models.items())
        yield f"the agents follow {len(models)} models: {each}"


def _process_lines(status: Reply) -> Iterator[str]:
    process = status["process"]
    where = f"{process['host']}, process {process['pid']}"
    taken = f"CPU {share(process['cpu'], process['uptime'])}, {size(process['memory'])}"
    seconds = status["time"] / 1e9
    yield f"{status['system']}  model {status['model']}  {seconds:.1f} s  {where}: {taken}"
    for agent in status["agents"]:
        yield f"  {agent['name']:<12} {agent['role']:<12} model {agent['model']}  {doing(agent)}"
        waits = counted({"input": agent["waiting"], "agent message": agent["unread"]})
        if waits:
            yield f"  {'':<12} {waits} waiting"
    for name, peer in status["peers"].items():
        yield f"  to {name:<9} {peer_text(peer)}"
        yield from (f"  {'':<12} not compatible: {text}" for text in peer["incompatible"])
    is_apart = any(clock["difference"] != 0 for clock in status["clocks"].values())
    if is_apart and process.get("synchronised") is False:
        yield f"  the clock of {process['host']} {UNSYNCHRONISED}"
    for name, clock in status["clocks"].items():
        if clock["difference"]:  # that of another machine
            off, wrong = clock["difference"] / 1e6, (clock["uncertainty"] or 0) / 1e6
            yield f"  {name:<12} clock differs by {off:.3f} ms, known to {wrong:.3f} ms"
    if status["counts"]:
        yield f"  records      {', '.join(f'{kind} {count}' for kind, count in status['counts'].items())}"
    if status["trace_error"] is not None:
        yield f"  {status['trace_error']}"
    epoch, held = status["epoch"], status["held"]
    if epoch["number"]:
        yield f"  epoch        {epoch['number']}, version {epoch['hash'][:12]}"
    if held is not None:
        why = "; ".join(held["reasons"]) or "it waits for the end of conversations"
        yield f"  held         until epoch {held['number']}, version {held['hash'][:12]}: {why}"
    for name, reason in status["doubted"].items():
        yield f"  {name:<12} is not followed: {reason}"
    swap = status["swap"]
    if swap is not None:
        yield f"  a swap is under way: {swap['state']}"


def doing(agent: AgentStatus) -> str:
    """What an agent is doing: its activities; if it has none, its innermost states."""
    if agent["over"]:
        return f"failed: {agent['failure']}" if agent["failure"] else "completed"
    if agent["activities"]:
        return ", ".join(agent["activities"])
    found = ", ".join(innermost(agent))
    return f"no activity, in {found}" if found else "no activity"


def innermost(agent: AgentStatus) -> list[str]:
    """The names of the active states in which no other is active."""
    labels = agent["configuration"]
    return [
        name
        for label, name in zip(labels, agent["states"], strict=False)
        if not any(other.startswith(f"{label}.") for other in labels)
    ]


def peer_text(peer: PeerStatus) -> str:
    """Whether a peer is connected, and what went wrong on the way from or to it."""
    counts = {"lost": peer["lost"], "refused": peer["refused"], "rejected": peer["rejected"]}
    counts |= {"dropped": peer["dropped"], "unreadable": peer["unreadable"], "late": peer["late"]}
    counts |= {"duplicated": peer["duplicated"], "reordered": peer["reordered"], "waiting": peer["waiting"]}
    told = [f"{counts[name]} {name}" for name in _COUNTED if counts[name]]
    return ", ".join(["connected" if peer["connected"] else "gone", f"{peer['received']} received", *told])


def counted(counts: dict[str, int]) -> str:
    """What there is of each, in words; empty if there is nothing."""
    return ", ".join(f"{number} {name}{'s' * (number != 1)}" for name, number in counts.items() if number)


def share(cpu: float, seconds: float) -> str:
    """So much processor time in so many seconds, as a share of one processor."""
    return f"{100 * cpu / seconds:.0f} %" if seconds > 0 else "0 %"


def size(count: int | None) -> str:
    """A number of bytes."""
    return "unknown memory" if count is None else f"{count / 2**20:.0f} MiB"


def record_text(record: dict[str, object]) -> str:
    """A recent record in one line, without its kind, time and agent."""
    reasons = record.get("reasons")
    first = record.get("reason") or ("; ".join(map(str, reasons)) if isinstance(reasons, list) else None)
    left_out = ("kind", "time", "agent", "what", "reason", "reasons")
    parts = [str(record["what"])] if "what" in record else []
    for name, value in record.items():
        if name not in left_out and isinstance(value, str | int | float):
            parts.append(f"{name} {value}")
    if isinstance(first, str):
        parts.append(first)
    return ", ".join(parts)


def record_agent(record: dict[str, object]) -> str:
    """Whom a record is about."""
    agents = record.get("agents")
    named: Iterable[object] = agents if isinstance(agents, list) else ()
    return str(record.get("agent") or ", ".join(map(str, named)))


__all__ = [
    "counted",
    "doing",
    "innermost",
    "peer_text",
    "record_agent",
    "record_text",
    "share",
    "size",
    "status_lines",
]
