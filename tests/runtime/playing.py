"""From a text and some activities to a run: its records by kind, and what happened as lines to read."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from jsonschema import Draft202012Validator

from aseme_dsl.runtime.activity.activities import ActivityFinder
from aseme_dsl.runtime.team.team import RunResult, Setup, Team
from aseme_dsl.runtime.team.timed_inputs import read_inputs
from aseme_dsl.runtime.trace.trace import Record
from aseme_dsl.runtime.trace.trace_reading import TraceReader
from aseme_dsl.runtime.trace.trace_schema import schema
from tests.support.generated import Generated, generate

MS = 1_000_000
SECOND = 1000 * MS


@dataclass(frozen=True)
class Played:
    """A run that is over."""

    team: Team
    result: RunResult
    records: list[Record]

    def of(self, kind: str, **members: Any) -> list[Record]:
        """The records of a kind that have these members."""
        return [
            r for r in self.records if r["kind"] == kind and all(r.get(k) == v for k, v in members.items())
        ]

    def activities(self, *what: str) -> list[str]:
        """What happened to activities: `100 start A`, with the milliseconds."""
        return [
            f"{r['time'] / MS:g} {r['what']} {r['activity']}"
            for r in self.of("activity")
            if not what or r["what"] in what
        ]

    def order(self, *what: str) -> list[str]:
        """The same without times."""
        return [line.partition(" ")[2] for line in self.activities(*what)]

    def received(self, agent: str, channel: str) -> list[str]:
        """The messages of a channel that were inputs of an agent's steps: `100 from ann {…}`."""
        sent = {
            (r["agent"], r["sequence"]): r for r in self.records if r["kind"] in ("message", "radio_received")
        }
        lines = []
        for step in self.of("step", agent=agent):
            for identity in step["inputs"]:
                message = sent.get(tuple(identity))
                if message is not None and message["channel"] == channel:
                    who = message.get("sender") or message["agent"]
                    members = " ".join(f"{k}={v}" for k, v in message["message"].items())
                    lines.append(f"{step['time'] / MS:g} from {who} {members}")
        return lines

    def configuration(self, agent: str) -> list[str]:
        """Where an agent was last, by activity or label."""
        plan = self.team.agent(agent).plan
        last = self.of("step", agent=agent)[-1]["configuration"]
        states = [plan.by_label[label] for label in last]
        return [state.activity or state.label for state in states if state.type != "AND"]


def make(
    what: str | Generated,
    activities: Mapping[str, type[Any]] | ActivityFinder | None = None,
    *,
    agents: Iterable[tuple[str, str]] | None = None,
    script: Iterable[Mapping[str, Any]] = (),
    until: int | None = None,
    **options: Any,
) -> tuple[Team, list[Record]]:
    """A team that is ready to run, and the list that its records go to.

    The agents are those of the text's team, or one called `me` for each role.
    """
    generated = what if isinstance(what, Generated) else generate(what)
    package = generated.package
    members = list(agents or package.TEAM) or [
        ("me" if len(generated.charts) == 1 else role, role) for role in generated.charts
    ]
    messages = {name: kind for name, kind in vars(generated.messages).items() if isinstance(kind, type)}
    records: list[Record] = []
    team = Team(
        [(name, generated.charts[role]) for name, role in members],
        activities or {},
        Setup(
            messages=messages,
            schema=getattr(generated.messages, "SCHEMA", None),
            timed_inputs=read_inputs([json.dumps(line) for line in script], messages),
            until_ns=until,
            listeners=[records.append, *options.pop("listeners", ())],
            path=[generated.folder, *options.pop("path", ())],
            **options,
        ),
    )
    return team, records


def play(
    what: str | Generated, activities: Mapping[str, type[Any]] | ActivityFinder | None = None, **options: Any
) -> Played:
    """Run a team to its end; see `make`."""
    team, records = make(what, activities, **options)
    result = team.run()
    for record in records:
        check_line(record)
    return Played(team, result, records)


@cache
def _validators() -> dict[str, Draft202012Validator]:
    """A validator for each kind of line: one for all of them would only say that none fits."""
    whole = schema()
    Draft202012Validator.check_schema(whole)
    return {line["title"]: Draft202012Validator({**line, "$defs": whole["$defs"]}) for line in whole["oneOf"]}


def check_line(record: Record) -> None:
    """Fail for a line that is not as the schema says."""
    assert record["kind"] in _validators(), f"the schema does not know {record['kind']}"
    errors = list(_validators()[record["kind"]].iter_errors(record))
    assert not errors, f"{record}\n{errors[0].message}"


def lines_of(path: Path) -> list[Record]:
    """The records of a trace on disk."""
    return [line.record for line in TraceReader(path)]
