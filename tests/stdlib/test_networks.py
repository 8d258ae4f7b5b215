"""The protocols of the library over random networks: every part ends, and the agents agree on how."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from random import Random
from typing import Any

import pytest

from tests.stdlib.hostile import LIMIT, ended
from tests.stdlib.library import PROTOCOLS, Act, Protocol, disagreement, generated, kind_of, protocol
from tests.support.networks import BAD, SEEDS, NetworkRun, runs

SLOW = "delay=0..4s,loss=20%,reorder"
"""A message may take longer than an agent waits for it."""


WITHDRAWING = {
    "request": ("AwaitOutcome",),
    "query": ("AwaitAnswer",),
    "request_when": ("AwaitOutcome",),
    "propose": ("AwaitReply",),
    "contract_net": ("CollectProposals", "AwardContract", "AwaitOutcome"),
    "iterated_contract_net": ("DecideRound", "AwaitOutcome"),
    "brokering": ("AwaitResult",),
    "recruiting": ("AwaitResult",),
}
"""The activities of the one who begins that may take back what was begun."""


def varied(item: Protocol, seed: int) -> dict[str, Act]:
    """The activities of a protocol, some of which last long, decide otherwise, or withdraw."""
    random = Random(f"{item.name} {seed}")
    found = {}
    for name, what in item.acts.items():
        sets = {key: _otherwise(item, key, value, random) for key, value in what.sets.items()}
        if name in WITHDRAWING.get(item.name, ()) and random.random() < 0.3:
            sets["withdrawn"] = True
        takes = random.choice((0.0, 0.05, 0.3, 1.0, 3.0, 12.0, 70.0)) if random.random() < 0.4 else what.takes
        if name.startswith(("Learn", "Close", "Leave", "End")):
            takes = random.choice((0.0, 0.1, 1.0, 8.0))
        elif name == "WatchSource":  # again and again
            takes = random.choice((2.0, 12.0))
        found[name] = Act(takes, sets, what.says)
    return found


def _otherwise(item: Protocol, name: str, value: Any, random: Random) -> Any:
    if isinstance(value, Mapping):
        return {agent: _otherwise(item, name, here, random) for agent, here in value.items()}
    if name != "withdrawn" and isinstance(value, bool) and random.random() < 0.15:
        return not value
    return value


FOUND = (
    # The provider has agreed, the recruiter and the client give up at once, and its result is on the way.
    ("recruiting", SLOW, 1064),
)
"""Runs among 2 000 in which the agents disagreed once."""


@pytest.mark.parametrize(("network", "first"), [(BAD, 0), (SLOW, 1)], ids=["bad", "slow"])
@pytest.mark.parametrize("item", PROTOCOLS, ids=str)
def test_every_part_ends_and_all_agree(item: Protocol, network: str, first: int) -> None:
    """Half of the seeds over each of the networks."""
    assert wrongs(item, network, SEEDS[first::2]) == []


@pytest.mark.parametrize(("name", "network", "seed"), FOUND, ids=str)
def test_they_agree_where_they_did_not(name: str, network: str, seed: int) -> None:
    assert wrongs(protocol(name), network, [seed]) == []


def wrongs(item: Protocol, network: str, seeds: Iterable[int]) -> list[str]:
    """What is wrong in the runs with these seeds."""
    made = generated(item.name)

    def activities(seed: int) -> dict[str, type[Any]]:
        return {name: kind_of(made, name, what) for name, what in varied(item, seed).items()}

    wrong = []
    for run in runs(made, network, seeds=seeds, until=LIMIT, activities=activities):
        wrong += problems(item, run)
    return wrong


def problems(item: Protocol, run: NetworkRun) -> list[str]:
    """What no run may show."""
    said = ended(run.records)
    found = []
    if run.open or run.failures or run.faults:
        found += [f"open {run.open}, failed {run.failures}, faults {run.faults}"]
    if "NONE" in said.values():
        found += [f"no end: {said}"]
    if wrong := disagreement(item, said):
        found += [wrong]
    return [f"seed {run.seed}: {text}\n{run}" for text in found]
