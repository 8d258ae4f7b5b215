"""Measures: what a process says of itself in numbers, and as the text that Prometheus reads."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field
from typing import TYPE_CHECKING

from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.project.operating.health import Health
    from aseme_dsl.runtime.control.replies import Reply

CONTENT_TYPE = "text/plain; version=0.0.4; charset=utf-8"


@dataclass(frozen=True, slots=True)
class Measure:
    """A number of a family; a counter only grows in one incarnation of the process."""

    name: str
    value: float
    labels: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Family:
    """A family of measures: its unit is part of its name."""

    name: str
    is_counter: bool
    help: str


_GAUGES = {
    "asemec_ready": "Whether the process is ready (1) or not (0).",
    "asemec_agent_running": "Whether the agent has not ended.",
    "asemec_agent_state": "1 for each active state.",
    "asemec_agent_waiting_inputs": "Inputs that wait for the next step.",
    "asemec_agent_waiting_messages": "Agent messages that wait.",
    "asemec_peer_connected": "Whether the agent elsewhere is connected.",
    "asemec_peer_waiting_messages": "Messages to the agent elsewhere that are not acknowledged.",
    "asemec_clock_difference_seconds": "Difference of the clock of the agent elsewhere.",
    "process_resident_memory_bytes": "Memory of the process.",
    "process_threads": "Threads of the process.",
}
_COUNTERS = {
    "asemec_agent_steps_total": "Steps.",
    "asemec_faults_total": "Faults.",
    "asemec_records_total": "Recent records by kind.",
    "asemec_peer_messages_total": "Messages from and to the agent elsewhere, by what became of them.",
    "process_cpu_seconds_total": "Processor time of the process.",
    "asemec_uptime_seconds_total": "Time since the start of the process.",
}
FAMILIES = (
    *(Family(name, False, text) for name, text in _GAUGES.items()),
    *(Family(name, True, text) for name, text in _COUNTERS.items()),
)
"""All that is measured."""


def measures(status: Reply, health: Health) -> Iterator[Measure]:
    """The numbers of a process, each of a family of `FAMILIES`."""
    yield Measure("asemec_ready", health.is_ready)
    for agent in status["agents"]:
        of = {"agent": agent["name"]}
        yield Measure("asemec_agent_running", not agent["over"], {**of, "role": agent["role"]})
        for label, state in zip(agent["configuration"], agent["states"], strict=False):
            yield Measure("asemec_agent_state", 1, {**of, "state": state, "label": label})
        yield Measure("asemec_agent_waiting_inputs", agent["waiting"], of)
        yield Measure("asemec_agent_waiting_messages", agent["unread"], of)
        yield Measure("asemec_agent_steps_total", agent["steps"], of)
    for name, peer in status["peers"].items():
        of = {"peer": name}
        yield Measure("asemec_peer_connected", peer["connected"], of)
        yield Measure("asemec_peer_waiting_messages", peer["waiting"], of)
        counts = {"received": peer["received"], "refused": peer["refused"], "lost": peer["lost"]}
        counts |= {"dropped": peer["dropped"], "unreadable": peer["unreadable"], "late": peer["late"]}
        counts |= {"duplicated": peer["duplicated"], "reordered": peer["reordered"]}
        for what, count in counts.items():
            yield Measure("asemec_peer_messages_total", count, {**of, "what": what})
    for name, clock in status["clocks"].items():
        if clock["difference"] is not None:
            yield Measure("asemec_clock_difference_seconds", clock["difference"] / 1e9, {"peer": name})
    yield Measure("asemec_faults_total", status["faults"])
    for kind, count in status["counts"].items():
        yield Measure("asemec_records_total", count, {"kind": kind})
    process = status["process"]
    if process["memory"] is not None:
        yield Measure("process_resident_memory_bytes", process["memory"])
    yield Measure("process_threads", process["threads"])
    yield Measure("process_cpu_seconds_total", process["cpu"])
    yield Measure("asemec_uptime_seconds_total", process["uptime"])


def as_text(found: Iterable[Measure]) -> str:
    """The numbers in the text format of Prometheus, version 0.0.4."""
    by_name: dict[str, list[Measure]] = {}
    for measure in found:
        by_name.setdefault(measure.name, []).append(measure)
    lines: list[str] = []
    for family in FAMILIES:
        if family.name not in by_name:
            continue
        lines.append(f"# HELP {family.name} {family.help}")
        lines.append(f"# TYPE {family.name} {'counter' if family.is_counter else 'gauge'}")
        for measure in by_name[family.name]:
            labels = ",".join(f'{name}="{_escaped(text)}"' for name, text in measure.labels.items())
            lines.append(f"{family.name}{f'{{{labels}}}' if labels else ''} {_number(measure.value)}")
    return "\n".join(lines) + "\n"


def _escaped(text: str) -> str:
    return text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n")


def _number(value: float) -> str:
    return str(int(value)) if value == int(value) else repr(float(value))


__all__ = ["CONTENT_TYPE", "FAMILIES", "Family", "Measure", "as_text", "measures"]
