"""Runs with seeded faults: loss, duplication, delay, reordering, partitions, crashes; and swaps among them.

`FAULT_RUNS=1000 pytest tests/faults/test_seeded.py` plays a thousand of them; `python3 dev.py long` does.
"""

from __future__ import annotations

import os
import random
from typing import Any

import pytest

from aseme_dsl.runtime.activity.context import Context
from aseme_dsl.runtime.team.faults import Crash, Faults, Partition
from aseme_dsl.runtime.trace.trace import Record
from tests.faults.changing import version
from tests.faults.test_swap import NET, NODDING
from tests.runtime.playing import MS, SECOND, make
from tests.support.generated import Generated, generate

RUNS = int(os.environ.get("FAULT_RUNS", "50"))
GROUPS = 5

TALK = """\
system Talk
message Note { int n }
topic line { signal Note queued  state Note  data Note }
srm speaker {
  liveness { speaker = Speak~ }
  activities { Speak every 20ms writes line.signal.Note, line.state.Note, line.data.Note }
}
srm hearer {
  liveness { hearer = Hear~ }
  activities { Hear every 20ms reads line.signal.Note, line.state.Note, line.data.Note for 400ms }
}
team Talk { one : speaker  two : speaker  ear : hearer }
"""


def faults(chance: random.Random, names: list[str], crashes: bool = True) -> Faults:
    """A run's faults: some of each sort."""
    cuts = [
        Partition(
            frozenset(chance.sample(names, 1)), chance.randint(0, 900) * MS, chance.randint(1, 300) * MS
        )
        for _ in range(chance.randint(0, 2))
    ]
    fallen = [
        Crash(name, chance.randint(1, 900) * MS, chance.randint(1, 200) * MS)
        for name in names
        if crashes and chance.random() < 0.3
    ]
    return Faults(
        chance.randint(1, 10**6),
        chance.random() * 0.4,
        chance.choice((0.0, 0.1, 0.3)),
        chance.choice((0, 5, 30, 80)) * MS,
        tuple(fallen),
        tuple(cuts),
    )


def run(made: Generated, what: Faults, activities: Any = None, changes: Any = None) -> list[Record]:
    team, records = make(made, activities, until=6 * SECOND, faults=what)
    if changes is not None:
        changes(team)
    assert team.run().reason == "time"  # no hang, and nobody stops
    return records


@pytest.mark.parametrize("group", range(GROUPS))
def test_signals_are_neither_lost_nor_doubled_nor_overtaken(group: int) -> None:
    made = generate(TALK)
    for seed in range(group, RUNS, GROUPS):
        chance = random.Random(f"talk {seed}")
        heard: dict[str, list[int]] = {"one": [], "two": []}
        said = {"one": 0, "two": 0}
        states: list[int] = []
        sampled: dict[str, set[int]] = {"one": set(), "two": set()}

        class Speak:
            def execute(self, context: Context, said: dict[str, int] = said) -> None:
                if context.now_ns > 2 * SECOND:
                    return
                said[context.agent] += 1
                for kind in ("signal", "state", "data"):
                    context.publish(f"line.{kind}.Note", made.message("Note", n=said[context.agent]))

        class Hear:
            def execute(
                self,
                context: Context,
                heard: dict[str, list[int]] = heard,
                states: list[int] = states,
                sampled: dict[str, set[int]] = sampled,
            ) -> None:
                for sender, numbers in heard.items():
                    while (note := context.read("line.signal.Note", sender=sender)) is not None:
                        numbers.append(note.n)
                newest = context.latest_message("line.state.Note", sender="one")
                if newest is not None:
                    states.append(newest.n)
                for sender, found in sampled.items():
                    samples = [item.message.n for item in context.history("line.data.Note", sender=sender)]
                    assert len(samples) == len(set(samples))
                    found.update(samples)

        what = faults(chance, ["one", "two", "ear"], crashes=seed % 2 == 0)
        records = run(made, what, {"Speak": Speak, "Hear": Hear})
        for sender, numbers in heard.items():
            assert numbers == sorted(set(numbers)), (seed, sender)
            missing = set(range(1, said[sender] + 1)) - set(numbers)
            if not any(crash.agent == "ear" for crash in what.crashes):
                assert not missing, (seed, sender, what)
        if not what.crashes:
            assert states == sorted(states), seed
            assert states[-1] == said["one"], (seed, what)
        told = [r for r in records if r["kind"] == "lost"]
        faults_told = [r["reason"] for r in records if r["kind"] == "fault"]
        assert all("is lost" in reason for reason in faults_told), seed  # what comes for one that is down
        if not what.crashes:  # a sample comes, or it is told that it was lost
            for sender, found in sampled.items():
                lost = [r for r in told if (r["agent"], r["peer"]) == (sender, "ear")]
                assert len(found) + len(lost) == said[sender], (seed, what)


@pytest.mark.parametrize("group", range(GROUPS))
def test_no_run_of_a_protocol_has_two_versions(group: int) -> None:
    old = generate(NET)
    new, back = version(generate(NODDING)), version(generate(NET))
    models = {kind.PLAN.model: "new" for kind in new.charts.values()}
    done = 0
    for seed in range(group, RUNS, GROUPS):
        chance = random.Random(f"net {seed}")
        moments = sorted(chance.randint(1, 1500) * MS for _ in range(2))

        def change(team: Any, moments: list[int] = moments) -> None:
            for item, moment in zip((new, back), moments, strict=True):
                team.swap(item, at=moment, within=2 * SECOND)

        records = run(old, faults(chance, ["chief", "aide"]), changes=change)
        versions = {"chief": "old", "aide": "old"}
        parts: dict[str, set[str]] = {}
        for record in records:
            if record["kind"] == "swap" and record["what"] == "done":
                versions[record["agent"]] = models.get(record["model"], "old")
                done += 1
            elif record["kind"] == "conversation":
                parts.setdefault(record["conversation"], set()).add(versions[record["agent"]])
        assert all(len(found) == 1 for found in parts.values()), (seed, parts)
        assert parts
    assert done


def test_the_same_seed_is_the_same_run() -> None:
    made = generate(NET)
    what = faults(random.Random(7), ["chief", "aide"])
    assert run(made, what) == run(made, what)
    assert run(made, what) != run(made, Faults())
