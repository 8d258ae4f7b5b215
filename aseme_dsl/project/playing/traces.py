"""Traces after a run: which lines are looked at, what they say in sum, and another file made of them."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field, replace
from fnmatch import fnmatchcase
from pathlib import Path
from typing import TypedDict

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.trace.records import Record, Taken, agents_of, targets_of
from aseme_dsl.runtime.trace.state_names import StateNames
from aseme_dsl.runtime.trace.trace import format_for
from aseme_dsl.runtime.trace.trace_files import TraceError, part_of, reason_of
from aseme_dsl.runtime.trace.trace_reading import Line

_FRAME = ("header", "finish")
"""The lines that every trace has."""
_DIFFERENT = 1000
"""So many different faults are counted one by one; the rest is counted together."""


# ---- which lines -------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Filter:
    """Which lines are wanted; what is empty or None leaves all. Times are in ns, and both ends belong to it.

    Channels may have `*` in them. A state is a label or a name, each for all inside it, or an activity.
    `places` are the states with these names, as (agent, label).
    """

    agents: tuple[str, ...] = ()
    kinds: tuple[str, ...] = ()
    channels: tuple[str, ...] = ()
    states: tuple[str, ...] = ()
    since: int | None = None
    until: int | None = None
    places: frozenset[tuple[str, str]] = frozenset()

    def of_run(self, header: Record) -> Filter:
        """The filter for a run: its header has the names of states."""
        if not self.states:
            return self
        names = header.get("names", {})
        places = {
            (agent["name"], label)
            for agent in agents_of(header)
            for label, name in names.get(agent.get("role", ""), {}).items()
            if name in self.states
        }
        return replace(self, places=frozenset(places))

    def wants(self, record: Record) -> bool:
        """Whether a line is wanted."""
        if self.kinds and record["kind"] not in self.kinds:
            return False
        if self.since is not None and record["time"] < self.since:
            return False
        if self.until is not None and record["time"] > self.until:
            return False
        if self.agents and not _agents(record) & set(self.agents):
            return False
        if self.channels:
            channel = record.get("channel")
            if channel is None or not any(fnmatchcase(channel, pattern) for pattern in self.channels):
                return False
        return not self.states or any(
            _is_at(record, state) for state in (*self.states, *self._labels(record))
        )

    def _labels(self, record: Record) -> list[str]:
        agent = record.get("agent")
        return [label for name, label in self.places if name == agent]


def _agents(record: Record) -> set[str]:
    """Whom a line is about."""
    found = {str(record.get("agent", ""))}
    if isinstance(record.get("to"), list):
        found.update(record["to"])
    for name in ("sender", "peer"):
        if isinstance(record.get(name), str):
            found.add(record[name])
    return found


def _is_at(record: Record, state: str) -> bool:
    """Whether a line is about a state, or something inside it."""
    if record.get("activity") == state:
        return True
    labels = [record[name] for name in ("label", "region", "branch") if isinstance(record.get(name), str)]
    if isinstance(record.get("configuration"), list):
        labels += record["configuration"]
    for way in record.get("taken", ()) if isinstance(record.get("taken"), list) else ():
        labels += [way["source"], way["target"], *way.get("into", ())]
    return any(label == state or label.startswith(f"{state}.") for label in labels)


# ---- in sum ------------------------------------------------------------------------------------


@dataclass(slots=True)
class _Visits:
    name: str = ""
    times: int = 0
    lasted: int = 0
    entered: int | None = None


@dataclass(slots=True)
class _Agent:
    role: str = ""
    steps: int = 0
    starts: int = 0
    crashes: int = 0
    faults: int = 0
    error: str | None = None
    active: frozenset[str] = frozenset()
    states: dict[str, _Visits] = field(default_factory=dict)


class StateSum(TypedDict):
    """How often an agent was in a state, and how long."""

    label: str
    name: str
    times: int
    lasted: int


class AgentSum(TypedDict):
    """What an agent did."""

    name: str
    role: str
    steps: int
    activities: int
    crashes: int
    faults: int
    error: str | None
    states: list[StateSum]


ChannelSum = TypedDict("ChannelSum", {"channel": str, "messages": int, "from": dict[str, int]})
"""How many messages a channel carried, and from whom."""


class ProtocolSum(TypedDict):
    """How often agents took part in conversations of a protocol, and how many messages they exchanged."""

    protocol: str
    open: int
    join: int
    leave: int
    messages: int


class FaultSum(TypedDict):
    """How often a fault happened."""

    reason: str
    times: int


TraceSum = TypedDict(
    "TraceSum",
    {
        "system": str | None,
        "format": int | None,
        "seed": int | None,
        "clock": str | None,
        "start": str | None,
        "from": int,
        "to": int,
        "lines": int,
        "missing": int,
        "reason": str | None,
        "kinds": dict[str, int],
        "agents": list[AgentSum],
        "channels": list[ChannelSum],
        "protocols": list[ProtocolSum],
        "faults": list[FaultSum],
    },
)
"""What a trace says in sum; times are in ns."""


class FileSum(TraceSum):
    """The sum of a trace file, and what is wrong with the file."""

    file: str
    problem: str | None


class Summary:
    """What the lines of a trace say in sum; they are given one at a time, and none is kept."""

    def __init__(self) -> None:
        self._header: Record = {"kind": "header", "time": 0}
        self._lines = 0
        self._first: int | None = None
        self._last = 0
        self._reason: str | None = None
        self._kinds: Counter[str] = Counter()
        self._agents: dict[str, _Agent] = {}
        self._channels: dict[str, Counter[str]] = {}
        self._faults: Counter[str] = Counter()
        self._protocols: dict[str, Counter[str]] = {}
        self._missing = 0

    def begin(self, header: Record, wanted: Filter) -> None:
        """The header, whether it is wanted or not: it says whose trace it is."""
        self._header = header
        for item in agents_of(header):
            if not wanted.agents or item["name"] in wanted.agents:
                self._agents[item["name"]] = _Agent(item["role"])

    def add(self, record: Record) -> None:
        """A line that is wanted."""
        kind, moment = str(record["kind"]), int(record["time"])
        self._lines += 1
        self._kinds[kind] += 1
        if kind != "header":
            self._first = moment if self._first is None else self._first
        self._last = max(self._last, moment)
        agent = self._agents.get(str(record.get("agent", "")))
        if kind == "message":
            self._channels.setdefault(record["channel"], Counter())[record["agent"]] += 1
        elif kind == "gap":
            self._missing += record["lines"]
        elif kind == "finish":
            self._reason = record["reason"]
        elif kind == "conversation":
            protocol = str(record.get("protocol") or record["conversation"].partition("-")[0])
            self._protocols.setdefault(protocol, Counter())[record["what"]] += 1
        elif kind == "agent_message" and record["protocol"]:
            self._protocols.setdefault(record["protocol"], Counter())["messages"] += 1
        elif kind in ("fault", "error"):
            self._fault(record, agent)
        if agent is None:
            return
        if kind == "step":
            agent.steps += 1
            if "configuration" in record:
                _moved(agent, frozenset(record["configuration"]), moment)
        elif kind == "activity":
            self._activity(record, agent)

    def _fault(self, record: Record, agent: _Agent | None) -> None:
        reason = str(record["reason"])
        if reason not in self._faults and len(self._faults) >= _DIFFERENT:
            reason = "others"
        self._faults[reason] += 1
        if agent is not None:
            agent.faults += 1
            if record["kind"] == "error":
                agent.error = reason

    def _activity(self, record: Record, agent: _Agent) -> None:
        what = record["what"]
        visits = agent.states.setdefault(record["label"], _Visits())
        visits.name = record["activity"]
        # A state is entered with the start of its activity, or with one that is cancelled before it began.
        if what == "start" or (what == "cancel" and record.get("started") is False):
            visits.times += 1
        agent.starts += what == "start"
        if what == "crash":
            agent.crashes += 1

    def result(self) -> TraceSum:
        """The sum, as data; times are in ns."""
        for agent in self._agents.values():
            _moved(agent, frozenset(), self._last)
        first = self._first or 0
        header = self._header
        return {
            "system": header.get("system"),
            "format": header.get("format"),
            "seed": header.get("seed"),
            "clock": header.get("clock"),
            "start": header.get("start"),
            "from": first,
            "to": self._last,
            "lines": self._lines,
            "missing": self._missing,
            "reason": self._reason,
            "kinds": dict(sorted(self._kinds.items())),
            "agents": [
                {
                    "name": name,
                    "role": agent.role,
                    "steps": agent.steps,
                    "activities": agent.starts,
                    "crashes": agent.crashes,
                    "faults": agent.faults,
                    "error": agent.error,
                    "states": [
                        {"label": label, "name": item.name, "times": item.times, "lasted": item.lasted}
                        for label, item in sorted(agent.states.items(), key=lambda pair: _order(pair[0]))
                        if item.name
                    ],
                }
                for name, agent in self._agents.items()
            ],
            "channels": [
                {"channel": channel, "messages": sum(counts.values()), "from": dict(sorted(counts.items()))}
                for channel, counts in sorted(self._channels.items())
            ],
            "protocols": [
                {
                    "protocol": name,
                    "open": counts["open"],
                    "join": counts["join"],
                    "leave": counts["leave"],
                    "messages": counts["messages"],
                }
                for name, counts in sorted(self._protocols.items())
            ],
            "faults": [{"reason": reason, "times": times} for reason, times in self._faults.most_common()],
        }


def _moved(agent: _Agent, active: frozenset[str], moment: int) -> None:
    """An agent is in other states now."""
    for label in agent.active - active:
        visits = agent.states[label]
        visits.lasted += moment - (visits.entered or 0)
        visits.entered = None
    for label in active - agent.active:
        agent.states.setdefault(label, _Visits()).entered = moment
    agent.active = active


def _order(label: str) -> tuple[int, ...]:
    return tuple(int(part) for part in label.split(".") if part.isdigit())


# ---- for people --------------------------------------------------------------------------------


def told(record: Record, names: StateNames) -> str:
    """What a line says, beside its time, agent and kind, in a short text. States have their names."""
    agent = str(record.get("agent", ""))
    match record["kind"]:
        case "step":
            ways = [_way(way, agent, names) for way in record["taken"]]
            leaves = [names.name(agent, label) for label in record.get("configuration", ())]
            where = f"  in {', '.join(leaves)}" if leaves else ""
            return f"step {record['step']}: {'; '.join(ways) or 'no transition'}{where}"
        case "activity":
            given = record.get("arguments", {}).items()
            more = record.get("outcome", record.get("reason"))
            if given:
                more = ", ".join(f"{name} = {_short(value)}" for name, value in given)
            reason = f": {more}" if more is not None else ""
            return f"{record['what']} {_activity(record, agent, names)}{reason}"
        case "message" | "radio_received" | "arrived":
            to = f"  to {', '.join(record['to']) or 'nobody'}" if "to" in record else ""
            return f"{record['channel']} {_short(record['message'])}{to}"
        case "agent_message":
            to = ", ".join(record["to"]) or "nobody"
            what = f"{record['performative']} {record['message']} {_short(record['content'])}"
            return f"{what}  to {to}  in {record['conversation']}"
        case "fault" | "error":
            return f"{record['reason']}{f' ({at})' if (at := record.get('at')) else ''}"
    further = [
        (name, names.name(agent, str(value)) if name in _PLACES else value)
        for name, value in record.items()
        if name not in _UNTOLD
    ]
    return "  ".join(
        f"{name} {value if isinstance(value, str) else _short(value)}" for name, value in further
    )


_UNTOLD = ("kind", "time", "agent", "names", "sources")
_PLACES = ("label", "region", "branch")


def _way(way: Taken, agent: str, names: StateNames) -> str:
    """A transition that was taken; one that stays in its state has that alone."""
    source, *targets = (names.name(agent, label) for label in (way["source"], *targets_of(way)))
    target = targets[0] if len(targets) == 1 else f"({', '.join(targets)})"
    return f"{source} -> {target} {way['text']}".rstrip()


def _activity(record: Record, agent: str, names: StateNames) -> str:
    """An activity: the name of its state, which begins with its own, or both."""
    name = names.name(agent, record["label"])
    return name if name.startswith(record["activity"]) else f"{record['activity']} ({name})"


def _short(value: object) -> str:
    text = json.dumps(value, ensure_ascii=False)
    return text if len(text) <= 200 else f"{text[:200]}…"


# ---- into another file -------------------------------------------------------------------------


def convert(lines: Iterable[Line], wanted: Filter, path: Path) -> int:
    """Write the lines that are wanted, and the first and the last, into a new trace; gives their number.

    It is of the kind that its name says, and has its name only when it is complete.

    Raises:
        TraceError: it cannot be written.
    """
    part = part_of(path)
    number = 0

    def chosen() -> Iterator[str]:
        nonlocal number
        nonlocal wanted
        for line in lines:
            if line.record["kind"] == "header":
                wanted = wanted.of_run(line.record)
            if line.record["kind"] in _FRAME or wanted.wants(line.record):
                number += 1
                yield line.text

    try:
        file = format_for(path, part)
        try:
            for text in chosen():
                file.put((text,))
            file.finish()
        except BaseException:
            file.abandon()
            part.unlink(missing_ok=True)
            raise
        part.replace(path)
    except OSError as problem:
        raise TraceError(f"{path} cannot be written: {reason_of(problem)}") from problem
    return number


def kinds() -> Mapping[str, str]:
    """Every kind of line with what it means."""
    from aseme_dsl.runtime.trace.trace_schema import lines_of, schema

    return {str(line["title"]): str(line.get("description", "")) for line in lines_of(schema())}
