"""Robots that cannot be reached: who notices it, how soon, and that nobody else suffers.

A short form runs always. NETWORK_RUNS=N repeats each fault N times, with the bounds of the documentation, and
prints what it has measured: `dev.py long` does.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from tests.network.machines import Machines, machines
from tests.network.talkers import LEASE, NAMES, Story, Talkers, deployed, misdelivered, project, talking

RUNS = int(os.environ.get("NETWORK_RUNS", "0"))
SILENCE = 0.3 if RUNS else 1.5
"""So much longer than without the fault may robots be silent that reach each other, in seconds."""
LATE = 0.5 if RUNS else 1.5
"""So much later than after the lease each side may notice."""
FAR = NAMES[-1]
"""Who becomes unreachable."""
NEAR = NAMES[:-1]
PAIRS = [(a, b) for a in NEAR for b in NEAR if a != b]
BROKEN = [*((FAR, a) for a in NEAR), *((a, FAR) for a in NEAR)]

MANY = pytest.mark.skipif(not RUNS, reason="many runs: set NETWORK_RUNS, or run python3 dev.py long")

pytest.importorskip("zenoh")


def cut(network: Machines) -> None:
    network.around(FAR, blocked=True)


def cut_from(network: Machines) -> None:
    """The others hear nothing of it; it hears them."""
    for other in NEAR:
        network.towards(FAR, other, blocked=True)


def cut_towards(network: Machines) -> None:
    for other in NEAR:
        network.towards(other, FAR, blocked=True)


def lossy(network: Machines) -> None:
    network.around(FAR, loss=0.2)


def healed(network: Machines) -> None:
    for name in NEAR:
        network.around(name, blocked=False, loss=0.0)


@dataclass(slots=True)
class Fault:
    """What happened from when to when."""

    name: str
    since: float
    until: float
    over: float
    """So long it was watched."""
    quiet: float = 0.0
    """Longest silence between robots that reached each other."""
    far: float = 0.0
    """Longest silence between them and the other one."""
    gone: list[float] = field(default_factory=list)
    """After which times it was noticed, of each side of each link."""
    back: list[float] = field(default_factory=list)
    outcomes: dict[str, dict[str, int]] = field(default_factory=dict)

    def measure(self, stories: dict[str, Story]) -> None:
        """Read what the robots have to tell."""
        self.quiet = max(stories[a].silence(b, self.since, self.over) for a, b in PAIRS)
        self.far = max(stories[a].silence(b, self.since, self.over) for a, b in BROKEN)
        for a, b in BROKEN:
            news = [(when, what) for when, what in stories[a].news(b) if self.since < when < self.over]
            self.gone += [when - self.since for when, what in news if what == "gone"]
            self.back += [when - self.until for when, what in news if what == "reconnected"]
        self.outcomes = {name: dict(stories[name].outcomes(self.since, self.over)) for name in NAMES}

    def __str__(self) -> str:
        def span(times: list[float]) -> str:
            return f"{min(times):5.2f} to {max(times):5.2f} ({len(times)})" if times else "-"

        return (
            f"{self.name:22} silence {self.quiet:5.2f}, of {FAR} {self.far:5.2f}; "
            f"gone {span(self.gone):22} back {span(self.back)}"
        )


def suffer(team: Talkers, name: str, fault: Callable[[Machines], None], seconds: float) -> Fault:
    """Let something go wrong for a time, and wait until all is well again."""
    since = time.monotonic()
    fault(team.network)
    time.sleep(seconds)
    until = time.monotonic()
    healed(team.network)
    time.sleep(5.0)
    return Fault(name, since, until, time.monotonic())


def flap(team: Talkers) -> Fault:
    """A link that breaks again and again, for shorter and for longer than the lease."""
    since = time.monotonic()
    for broken, whole in ((0.5, 0.5), (1.5, 0.3), (3.0, 0.5), (2.2, 1.0), (0.2, 0.2), (3.0, 0.2), (2.5, 0.5)):
        cut(team.network)
        time.sleep(broken)
        healed(team.network)
        time.sleep(whole)
    until = time.monotonic()
    time.sleep(5.0)
    return Fault("flapping", since, until, time.monotonic())


def check(faults: list[Fault], stories: dict[str, Story], before: float) -> None:
    """What the documentation promises."""
    for fault in faults:
        fault.measure(stories)
        print(fault, flush=True)
    print(f"silence without a fault {before:.2f}", flush=True)
    assert misdelivered(stories) == []
    for fault in faults:
        assert fault.quiet <= before + SILENCE, fault
        if fault.name.startswith("cut"):
            assert len(fault.gone) == len(fault.back) == len(BROKEN), fault
            assert max(fault.gone) <= LEASE + LATE, fault
        if fault.name == "loss":
            assert not fault.gone, fault
        for name in NAMES:  # they have gone on
            assert fault.outcomes[name].get("Compare", 0) > 0, fault.outcomes
    for a, b in PAIRS:
        told = [what for when, what in stories[a].news(b) if when < faults[-1].over]
        assert set(told) <= {"connected", "duplicated", "reordered"}, told


def suffered(folder: Path, what: Callable[[Talkers], list[Fault]], seed: int = 1) -> None:
    """A team to which that happens."""
    with machines(NAMES, seed) as network:
        project(folder / "p", deployed(folder, network))
        with talking(folder / "p", network) as team:
            begun = time.monotonic()
            time.sleep(5.0 if RUNS else 2.0)
            calm = time.monotonic()
            faults = what(team)
            stories = team.end()
    check(faults, stories, max(stories[a].silence(b, begun, calm) for a, b in PAIRS))


def test_a_robot_that_cannot_be_reached(tmp_path: Path) -> None:
    suffered(
        tmp_path,
        lambda team: [suffer(team, "cut for 3.5 s", cut, 3.5), suffer(team, "cut from it", cut_from, 3.0)],
    )


@MANY
@pytest.mark.parametrize("run", range(max(1, RUNS)))
def test_cut_off_and_back(tmp_path: Path, run: int) -> None:
    suffered(
        tmp_path,
        lambda team: [
            suffer(team, "cut for 5 s", cut, 5.0),
            suffer(team, "cut for 12 s", cut, 12.0),
            suffer(team, "cut for 60 s", cut, 60.0),
        ],
        run,
    )


@MANY
@pytest.mark.parametrize("run", range(max(1, RUNS)))
def test_half_cut_flapping_and_lossy(tmp_path: Path, run: int) -> None:
    suffered(
        tmp_path,
        lambda team: [
            suffer(team, "cut from it", cut_from, 5.0),
            suffer(team, "cut towards it", cut_towards, 5.0),
            flap(team),
            suffer(team, "loss", lossy, 15.0),
        ],
        run,
    )
