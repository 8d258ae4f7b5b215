"""Swaps of a team on four machines while robots or their operator are unreachable, killed or slow.

NETWORK_RUNS=N has N teams suffer each fault in each phase, and prints what became of it: `dev.py long` does.
"""

from __future__ import annotations

import contextlib
import json
import os
import random
import signal
import subprocess
import sys
import threading
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime.control.control_socket import ControlError, ask, endpoints, label_of
from tests.network.machines import machines
from tests.network.talkers import NAMES, OFFICE, TEAM, Talkers, deployed, project, talking
from tests.support.network import own_name
from tests.support.traces import records_of
from tests.support.waiting import LONG, wait_until

RUNS = int(os.environ.get("NETWORK_RUNS", "0"))
ONE_VERSION = 20.0
"""So many seconds after a fault has ended, all follow one version."""
PHASES = ("ready", "prepare", "commit", "finish")
NEW = TEAM.replace("message Tick { int n  string who }", "message Tick { int n  string who  int build }")
"""A version whose robots read no ticks of the other one: they lack `build`, which they need."""

pytest.importorskip("zenoh")
pytestmark = pytest.mark.skipif(not RUNS, reason="long: set NETWORK_RUNS, or run python3 dev.py long")


@dataclass(frozen=True, slots=True)
class Case:
    """What happens to whom when the operator is in a phase."""

    what: str
    """unreachable, killed, slow"""
    whom: str
    phase: str
    when: str
    how: int = 0
    """Which of two forms the fault has."""
    quorum: str = "all"

    def __str__(self) -> str:
        form = f"{self.what}/{self.how}"
        return f"{self.whom:7} {form:13} {self.when:6} {self.phase:7} quorum {self.quorum:3}"


@dataclass(slots=True)
class Outcome:
    """What became of it."""

    case: Case
    code: int | None
    """The operator's exit code; None: it was killed."""
    said: dict[str, Any]
    before: int
    after: int
    """The epoch that all follow."""
    seconds: float
    """So long after the end of the fault all followed it."""
    wrong: list[str] = field(default_factory=list)

    def __str__(self) -> str:
        code = "-" if self.code is None else self.code
        outcome = "new" if self.after > self.before else "old"
        return f"{self.case}: exit {code}, {outcome} version after {self.seconds:4.1f} s {self.wrong or ''}"


class Changing:
    """A team whose operator changes it to and fro between two versions."""

    def __init__(self, team: Talkers, name: str) -> None:
        self.team = team
        self.restarts: Counter[str] = Counter()
        self.new = False
        (team.folder / "old.aseme").write_text(TEAM.replace("TALK", name))
        (team.folder / "new.aseme").write_text(NEW.replace("TALK", name))
        (team.folder / "new").mkdir()
        for path in (team.folder / "activities").iterdir():
            if path.is_file():
                text = path.read_text().replace("who=context.agent", "who=context.agent, build=2")
                (team.folder / "new" / path.name).write_text(text)

    def statuses(self) -> dict[str, dict[str, Any]]:
        """What each robot says of itself on its own machine."""
        found: dict[str, dict[str, Any]] = {}
        for path in endpoints(self.team.folder / "out"):
            with contextlib.suppress(ControlError, OSError):
                reply = ask(path, {"request": "status"}, 1.0)
                if reply["ok"]:
                    found[label_of(path)] = dict(reply)
        return found

    def one_version(self) -> dict[str, Any] | None:
        """The epoch that all follow, if they do, and nothing is under way."""
        found = self.statuses()
        if set(found) != set(NAMES) or any(one["swap"] or one["held"] for one in found.values()):
            return None
        if not all(peer["connected"] for one in found.values() for peer in one["peers"].values()):
            return None
        epochs = [dict(one["epoch"]) for one in found.values()]
        models = {one["model"] for one in found.values()}
        return epochs[0] if len(models) == 1 and all(one == epochs[0] for one in epochs) else None

    def restart(self, robot: str) -> None:
        """Start a robot again that was killed; what it has traced stays."""
        out = self.team.folder / "out"
        for path in out.glob(f"trace.{robot}.jsonl.gz*"):
            path.rename(out / f"kept.{robot}.{self.restarts[robot]}.jsonl.gz")
        self.restarts[robot] += 1
        self.team.begin(robot)

    def traces(self, robot: str) -> Iterator[list[dict[str, Any]]]:
        """What each incarnation of a robot has traced."""
        for path in sorted((self.team.folder / "out").glob(f"kept.{robot}.*")):
            yield records_of(path)
        yield self.team.trace(robot)

    def suffer(self, case: Case) -> Outcome:
        """Swap, with a fault in the midst of it, until all is well again."""
        before = wait_until(self.one_version, ONE_VERSION, pause=0.2)
        target, activities = ("old", "activities") if self.new else ("new", "new")
        operator = self.team.network.start(
            OFFICE,
            *(sys.executable, str(Path(__file__).with_name("slow_operator.py")), case.phase, case.when),
            *("team", "swap", f"{target}.aseme", "-o", "out", "--activities", activities, "--json"),
            *("--key", "../operator.toml", "--within", "3s", "--quorum", case.quorum),
            cwd=self.team.folder,
            stdin=subprocess.PIPE,
        )
        assert operator.stdout is not None and operator.stdin is not None
        first = operator.stdout.readline()
        assert first == "now\n", first + operator.communicate()[0]
        code, text = None, ""
        with self.fault(case):
            if case.whom == OFFICE and case.what == "killed":
                operator.kill()
                operator.communicate()
            else:
                text, _ = operator.communicate("\n", timeout=LONG)
                code = operator.returncode
        healed = time.monotonic()
        after = wait_until(self.one_version, ONE_VERSION, pause=0.1)
        seconds = time.monotonic() - healed
        if after["number"] > before["number"]:
            self.new = not self.new
        said = json.loads(text) if text else {}
        outcome = Outcome(case, code, said, before["number"], after["number"], seconds)
        outcome.wrong = list(untrue(outcome))
        return outcome

    @contextlib.contextmanager
    def fault(self, case: Case) -> Iterator[None]:
        """Inside, it has happened."""
        network, whom = self.team.network, case.whom
        match case.what:
            case "unreachable":
                if case.how:  # the operator's requests arrive, the answers do not
                    network.towards(*((OFFICE, NAMES[0]) if whom == OFFICE else (whom, OFFICE)), blocked=True)
                else:
                    network.around(whom, blocked=True)
                try:
                    yield
                finally:
                    network.around(whom, blocked=False)
            case "killed" if whom == OFFICE:
                yield
            case "killed":
                process = self.team.processes[whom]
                process.kill()
                process.communicate()
                yield
                self.restart(whom)
            case "slow" if whom == OFFICE:
                time.sleep(1.0 if case.how else 4.0)
                yield
            case _:
                stopped = self.team.processes[whom]
                stopped.send_signal(signal.SIGSTOP)
                goes_on = threading.Timer(1.0 if case.how else 6.0, stopped.send_signal, [signal.SIGCONT])
                goes_on.start()
                yield
                goes_on.join()


def untrue(outcome: Outcome) -> Iterator[str]:
    """Where the operator has said what is not true."""
    changed, unchanged = outcome.said.get("changed", []), outcome.said.get("unchanged", {})
    has_changed = outcome.after > outcome.before
    match outcome.code:
        case 0:
            if not has_changed or sorted(changed) != sorted(NAMES):
                yield f"exit 0, but {changed} have changed"
        case 1:
            if has_changed:
                yield "exit 1, but the team has changed"
            if not (outcome.said.get("reasons") or unchanged):
                yield "no reason is said"
        case 3:
            if not has_changed and (changed or not outcome.said["unknown"]):
                yield "exit 3, but nobody has changed"
            if set(changed) | set(unchanged) != set(NAMES) or not unchanged:
                yield f"{changed} and {unchanged} are not the team"
        case None:
            pass
        case other:
            yield f"exit {other}"


def misread(changing: Changing) -> list[str]:
    """Ticks that a robot has read although its version does not, or that came not once and in order."""
    found = []
    for robot in NAMES:
        for records in changing.traces(robot):
            newest: dict[tuple[str, int | None], int] = {}
            for record in records:
                if record["kind"] == "swap":
                    newest = {}
                if record["kind"] != "arrived" or record.get("channel") != "team.signal.Tick":
                    continue
                tick = record["message"]
                if tick.get("build") == 0:
                    found.append(f"{robot} has read {tick}, which lacks its build")
                key = tick["who"], tick.get("build")
                before = newest.get(key)
                if before is not None and tick["n"] not in (before + 1, 1):  # 1: its activity has begun anew
                    found.append(f"{robot} has {tick['n']} of {tick['who']} after {before}")
                newest[key] = tick["n"]
    return found


def unreported(changing: Changing) -> list[str]:
    """Robots that do not read another one's ticks, of which that one has not heard."""
    news = {
        (robot, record["what"], record["peer"])
        for robot in NAMES
        for records in changing.traces(robot)
        for record in records
        if record["kind"] == "peer"
    }
    return [
        f"{robot} refuses {peer}, which does not know it"
        for robot, what, peer in sorted(news)
        if what == "refused" and (peer, "rejected", robot) not in news
    ]


@contextlib.contextmanager
def changing(folder: Path, seed: int = 1) -> Iterator[Changing]:
    """The team, when each hears each."""
    name = own_name("Swap")
    with machines((*NAMES, OFFICE), seed) as network:
        project(folder / "p", deployed(folder, network), name=name)
        with talking(folder / "p", network) as team:
            yield Changing(team, name)


def cases(run: int) -> Iterator[Case]:
    """Each fault in each phase; in ten runs, to each robot."""
    chance = random.Random(run)
    number = run
    for phase in PHASES:
        for what in ("unreachable", "killed", "slow"):
            number += 1
            for whom in (NAMES[number % 4], OFFICE):
                when = chance.choice(("before", "midst", "after"))
                yield Case(what, whom, phase, when, chance.randrange(2), chance.choice(("all", "3")))


def check(found: list[Outcome], changed: Changing) -> None:
    assert [str(outcome) for outcome in found if outcome.wrong] == []
    changed.team.end()
    assert misread(changed) == []
    assert unreported(changed) == []


def test_a_swap_with_a_robot_and_then_the_operator_gone(tmp_path: Path) -> None:
    with changing(tmp_path) as team:
        found = [
            team.suffer(Case("killed", "robot2", "prepare", "midst", quorum="3")),
            team.suffer(Case("killed", OFFICE, "commit", "midst")),
        ]
        assert [outcome.code for outcome in found] == [3, None]
        check(found, team)


@pytest.mark.parametrize("run", range(max(1, RUNS)))
def test_swaps_with_faults_in_each_phase(tmp_path: Path, run: int) -> None:
    found = []
    with changing(tmp_path, run) as team:
        for case in cases(run):
            found.append(team.suffer(case))
            print(found[-1], flush=True)
        check(found, team)
