"""Random networks: a system run with many seeds over a bad network, in virtual time and in this process.

    for run in runs(TEXT, "delay=0..300ms,loss=10%,reorder", until=60 * SECOND):
        assert run.ended("ann", "initiator") == ["Learn"], run

`NETWORK_SEEDS` is how many seeds are run where a test does not say: 24, and 2 000 by `python3 dev.py long`.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from aseme_dsl.grammar.text.network_words import read_network
from aseme_dsl.runtime import Context
from aseme_dsl.runtime.message.as_json import to_json
from aseme_dsl.runtime.team.faults import Crash
from aseme_dsl.runtime.team.network import Network
from aseme_dsl.runtime.team.team import RunResult
from aseme_dsl.runtime.trace.trace import Record
from tests.runtime.playing import make
from tests.support.generated import Generated, generate

BAD = "delay=0..300ms,loss=10%,reorder"
"""The network of issue J."""
SEEDS = range(1, int(os.environ.get("NETWORK_SEEDS", "12")) + 1)

Activities = Mapping[str, type[Any]]
"""The code of activities by name; the others only last."""


@dataclass(frozen=True)
class Part:
    """What one agent did as a participant in one conversation."""

    agent: str
    participant: str
    conversation: str
    activities: tuple[str, ...]
    """Those that were started after it opened or joined the conversation, in order."""
    left: bool
    """Whether it had left the conversation before the run ended."""
    untaken: int
    """How many messages it left unread."""

    @property
    def last(self) -> str:
        """The activity that it ended in; "" without one."""
        return self.activities[-1] if self.activities else ""


@dataclass(frozen=True)
class Outcome:
    """What an activity of `noting` saw when it started."""

    agent: str
    activity: str
    time: int
    values: Mapping[str, Any]


@dataclass(frozen=True)
class NetworkRun:
    """A run over a bad network that is over."""

    seed: int
    result: RunResult
    records: list[Record]

    @property
    def finished(self) -> bool:
        """Whether all agents completed."""
        return self.result.reason == "finished" and not self.result.failed

    @property
    def parts(self) -> list[Part]:
        """What each agent did in each conversation, in the order in which they opened and joined."""
        found: dict[tuple[str, str], list[Any]] = {}
        order: list[list[Any]] = []
        for record in self.records:
            if record["kind"] == "conversation" and record["what"] in ("open", "join"):
                entry = [record, [], None]
                found[record["agent"], record["branch"]] = entry
                order.append(entry)
            elif record["kind"] == "conversation" and record["what"] == "leave":
                entry = found.pop((record["agent"], record["branch"]))
                entry[2] = record
            elif record["kind"] == "activity" and record["what"] == "start":
                for (agent, branch), entry in found.items():
                    if agent == record["agent"] and f"{record['label']}.".startswith(f"{branch}."):
                        entry[1].append(record["activity"])
        return [
            Part(
                begin["agent"],
                begin["participant"],
                begin["conversation"],
                tuple(activities),
                end is not None,
                len((end or {}).get("untaken", ())),
            )
            for begin, activities, end in order
        ]

    def ended(self, agent: str, participant: str | None = None) -> list[str]:
        """The activities in which the parts of an agent ended, one each conversation."""
        return [
            part.last
            for part in self.parts
            if part.agent == agent and participant in (None, part.participant)
        ]

    @property
    def outcomes(self) -> list[Outcome]:
        """What the activities of `noting` saw."""
        return [
            Outcome(record["agent"], record["activity"], record["time"], json.loads(record["text"]))
            for record in self.records
            if record["kind"] == "log" and record["text"].startswith("{")
        ]

    @property
    def logs(self) -> list[str]:
        """What activities logged: `ann LearnOutcome: ended DONE`."""
        return [f"{r['agent']} {r['activity']}: {r['text']}" for r in self.records if r["kind"] == "log"]

    @property
    def faults(self) -> list[str]:
        """What could not be done, each reason once; a message lost on the network is none."""
        return [fault.reason for fault in self.result.faults]

    @property
    def failures(self) -> list[str]:
        """Why agents stopped: `ann: …`."""
        return [f"{agent.name}: {agent.failure}" for agent in self.result.agents if agent.failure is not None]

    @property
    def stuck(self) -> tuple[str, ...]:
        """The agents that wait for ever."""
        return self.result.stuck

    @property
    def open(self) -> list[str]:
        """The conversations that were open when the run ended."""
        return [item.name for item in self.result.conversations]

    @property
    def unexpected(self) -> list[str]:
        """Messages that no participant accepted: `bob: accept_proposal Contract from ann: closed`."""
        return [
            f"{r['agent']}: {r['performative']} {r.get('message', '')} from {r['sender']}: {r['reason']}"
            for r in self.records
            if r["kind"] == "unexpected"
        ]

    @property
    def messages(self) -> list[str]:
        """The agent messages as they were sent: `ann request Order to bob`."""
        return [
            f"{r['agent']} {r['performative']} {r['message']} to {', '.join(r['to'])}"
            for r in self.records
            if r["kind"] == "agent_message"
        ]

    def __str__(self) -> str:
        """What a failed assertion shows: the seed, how it ended, and what was said."""
        lines = [f"seed {self.seed}: {self.result.reason} after {self.result.end_ns / 1e9:g} s"]
        for part in self.parts:
            lines.append(f"  {part.agent} as {part.participant}: {' . '.join(part.activities)}")
        for record, line in zip(self._said(), self.messages, strict=True):
            lines.append(f"  {record['time'] / 1e6:g} ms {line}")
        lines += [f"  {text}" for text in (*self.unexpected, *self.faults, *self.failures)]
        return "\n".join(lines)

    __repr__ = __str__

    def _said(self) -> list[Record]:
        return [r for r in self.records if r["kind"] == "agent_message"]


def runs(
    what: str | Generated,
    network: str | None = BAD,
    *,
    seeds: Iterable[int] = SEEDS,
    until: int | None = None,
    activities: Activities | Callable[[int], Activities] | None = None,
    crashes: Callable[[int], Sequence[Crash]] | None = None,
    **options: Any,
) -> Iterator[NetworkRun]:
    """Run a system's team once for each seed over a network, to its end or `until` (ns).

    `network` are the words of `--network`; None is a perfect one. A function as `activities` or `crashes` is
    called with the seed. `options` are those of `make` (`agents`, `script`, …).
    """
    made = generate(what) if isinstance(what, str) else what
    words = Network() if network is None else read_network(network)
    for seed in seeds:
        faults = words.faults(seed)
        if crashes is not None:
            faults = replace(faults, crashes=tuple(crashes(seed)))
        code = activities(seed) if callable(activities) else activities
        simulated = None if network is None and crashes is None else faults
        team, records = make(made, code, until=until, seed=seed, faults=simulated, **options)
        yield NetworkRun(seed, team.run(), records)


def noting(*variables: str) -> type[Any]:
    """An activity without duration that notes these variables, for `NetworkRun.outcomes`."""

    class Noting:
        def execute(self, context: Context) -> None:
            values = {name: to_json(context.get_variable(name)) for name in variables}
            context.log(json.dumps(values))

    return Noting
