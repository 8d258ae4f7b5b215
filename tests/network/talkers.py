"""A team of four robots on four machines, all of which talk to each other all the time."""

from __future__ import annotations

import signal
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import psutil

from aseme_dsl.runtime.control.operator_key import write_key
from aseme_dsl.runtime.transport.access import OPERATOR
from tests.cli.support import asemec
from tests.faults.test_network import certify
from tests.network.machines import Machines
from tests.support.network import own_name
from tests.support.traces import records_of
from tests.support.waiting import LONG, wait_until

NAMES = ("robot1", "robot2", "robot3", "robot4")
PERIOD = 0.05
"""So often, in seconds, each robot says something to each other one."""
LEASE = 2.0
OFFICE = "office"
"""The operator's machine, where there is one."""

TEAM = """
system TALK
message Tick { int n  string who }
message Question { int n }
topic team { signal Tick queued }

aip ask {
  participant asker {
    sends    request Question
    receives inform Question
    process  = Ask . Wait . (Compare | Mourn | GiveUp)
  }
  participant helper [1..*] {
    sends    inform Question
    receives request Question
    process  = Think . Tell
  }
  control asker {
    enter Ask     : / send request Question to helper
    enter Compare : inform Question from helper
    enter Mourn   : lost helper
    enter GiveUp  : after(4s)
  }
  control helper {
    enter Think : request Question from asker
    leave Tell  : / send inform Question to asker
  }
}

srm robot {
  plays ask.asker, ask.helper
  liveness { robot = Say~ || Hear~ || asker~ || helper~ || helper~ || helper~ || helper~ }
  activities {
    Say every 50ms writes team.signal.Tick
    Hear every 50ms reads robot1.team.signal.Tick, robot2.team.signal.Tick, robot3.team.signal.Tick,
      robot4.team.signal.Tick
    Ask takes 10ms simulated  Wait takes 10ms simulated  Compare takes 200ms simulated
    Mourn takes 200ms simulated  GiveUp takes 200ms simulated
    Think takes 300ms simulated  Tell takes 10ms simulated
  }
}
team T { robot[1..4] : robot }
"""

SAY = """
from aseme_dsl.runtime import Context
from monas.TALK.messages import Tick


class Say:
    def execute(self, context: Context) -> None:
        Say.n = getattr(Say, "n", 0) + 1
        context.publish("team.signal.Tick", Tick(n=Say.n, who=context.agent))
"""

HEAR = """
class Hear:
    def execute(self, context) -> None:
        pass
"""


def project(
    folder: Path, deployed: str, team: str = TEAM, name: str = "", say: str = SAY, **more: str
) -> Path:
    """A built project of the team, whose system has a name of this test's own; `more`: other activities."""
    name = name or own_name("Talk")
    (folder / "activities").mkdir(parents=True)
    (folder / "pyproject.toml").write_text(
        '[tool.asemec]\nfiles = ["talk.aseme"]\noutput = "out"\nactivities = "activities"\n'
        f"[tool.asemec.deploy]\n{deployed}"
    )
    (folder / "talk.aseme").write_text(team.replace("TALK", name))
    for activity, text in {"say": say, "hear": HEAR, **more}.items():
        (folder / "activities" / f"{activity}.py").write_text(text.replace("TALK", name))
    built = asemec("build", cwd=folder)
    assert built.code == 0, built
    return folder


def deployed(folder: Path, network: Machines) -> str:
    """`[tool.asemec.deploy]`: each robot has a certificate and a host, the last one is found by multicast.

    The second one has an IPv6 address. If there is an operator's machine, the robots take the operator's key.
    """
    certificates = folder / "certificates"
    certificates.mkdir(parents=True)
    every = [address for both in network.addresses.values() for address in both]
    certify(certificates, {"team": (*NAMES, OPERATOR)}, *every)
    *named, _ = NAMES
    hosts = {name: network.addresses[name][0] for name in named}
    hosts[named[1]] = f"[{network.addresses[named[1]][1]}]"
    told = [f'{name} = "{host}"' for name, host in hosts.items()]
    control = ""
    if OFFICE in network.addresses:
        write_key(folder / "operator.toml")
        control = f'control = "{folder}/operator.toml"\n'
    return (
        f"hosts = {{ {', '.join(told)} }}\n"
        f'interface = "eth0"\nlease = "{LEASE:g}s"\n{control}'
        f'tls = {{ authority = "{certificates}/team.pem", certificate = "{certificates}/ROBOT.pem", '
        f'key = "{certificates}/ROBOT.key" }}\n'
    )


@dataclass(slots=True)
class Talkers:
    """The robots' processes, and what they have traced."""

    folder: Path
    network: Machines
    processes: dict[str, psutil.Popen]

    def trace(self, robot: str) -> list[dict[str, Any]]:
        """What is in a robot's trace so far."""
        whole = self.folder / "out" / f"trace.{robot}.jsonl.gz"
        return records_of(whole if whole.exists() else whole.with_name(f"{whole.name}.part"))

    def begin(
        self, robot: str, *options: str, machine: str = "", folder: Path | None = None, **environment: str
    ) -> None:
        """Start a robot, on its machine and from the team's folder if no other one is said."""
        self.processes[robot] = self.network.start(
            machine or robot, sys.executable, "-m", "aseme_dsl", "node", robot, "--from", "out", "-q",
            *options, cwd=folder or self.folder, **environment,
        )  # fmt: skip

    def end(self) -> dict[str, Story]:
        """End all robots; what each of them has to tell."""
        over = time.monotonic()
        for process in self.processes.values():
            process.send_signal(signal.SIGTERM)
        said = {robot: process.communicate(timeout=LONG)[0] for robot, process in self.processes.items()}
        for robot, text in said.items():
            assert "Traceback" not in text, f"{robot}: {text}"
        return {robot: Story(robot, self.trace(robot), over) for robot in self.processes}

    def wait_for_talk(self, seconds: float = LONG) -> None:
        """Until each robot has heard each other one."""

        def all_heard() -> bool:
            for robot, process in self.processes.items():
                assert process.poll() is None, process.communicate()[0]
                try:
                    found = self.trace(robot)
                except Exception:  # it is not there yet
                    return False
                heard = {r["input"][0] for r in found if r["kind"] == "arrived" and r["input"][0] != robot}
                if heard != set(self.processes) - {robot}:
                    return False
            return True

        wait_until(all_heard, seconds, pause=0.5)


class Story:
    """What a robot's trace tells, in seconds of the machines' clock."""

    def __init__(self, robot: str, records: list[dict[str, Any]], over: float) -> None:
        """`over` is when the robots were told to end."""
        self.robot = robot
        self.over = over
        self.records = records
        machine = records[0]["machine"]
        self.origin = machine["origin"]
        self.heard: dict[str, list[tuple[float, int]]] = defaultdict(list)
        """Of each other robot the signals that came: when, and their numbers."""
        for record in records:
            if record["kind"] == "arrived" and record.get("channel") == "team.signal.Tick":
                message = record["message"]
                if message["who"] != robot:
                    self.heard[message["who"]].append((self.at(record), message["n"]))

    def at(self, record: Mapping[str, Any]) -> float:
        """When something happened."""
        return float((self.origin + record["time"]) / 1e9)

    def news(self, peer: str, *what: str) -> list[tuple[float, str]]:
        """What became of a peer, and when."""
        return [
            (self.at(r), r["what"])
            for r in self.records
            if r["kind"] == "peer" and r["peer"] == peer and (not what or r["what"] in what)
        ]

    def silence(self, peer: str, since: float, until: float) -> float:
        """The longest time, in seconds, without a signal of a peer, of what lies between these moments."""
        times = [since, *(when for when, _ in self.heard[peer] if since < when < until), until]
        return max(b - a for a, b in pairwise(times))

    def misplaced(self, peer: str, since: float = 0.0) -> list[str]:
        """Where the signals of a peer are not what it has said since a moment, each once and in order."""
        numbers = [n for when, n in self.heard[peer] if when > since]
        return [f"{peer} said {b} after {a}" for a, b in pairwise(numbers) if b != a + 1]

    def outcomes(self, since: float, until: float) -> Counter[str]:
        """How the conversations that the robot began ended between two moments."""
        return Counter(
            r["activity"]
            for r in self.records
            if r["kind"] == "activity"
            and r["what"] == "start"
            and r["activity"] in ("Compare", "Mourn", "GiveUp")
            and since <= self.at(r) < until
        )


def misdelivered(stories: Mapping[str, Story]) -> list[str]:
    """The agent messages and signals that were lost, doubled or overtaken, up to 2 s before the end."""
    found: list[str] = []
    for sender, to in ((a, b) for a in stories for b in stories if a != b):
        found += [f"{to}: {wrong}" for wrong in stories[to].misplaced(sender)]
        last = stories[to].over - 2.0
        sent = [
            (r["sequence"], stories[sender].at(r))
            for r in stories[sender].records
            if r["kind"] == "agent_message" and to in r["to"] and r["performative"] in ("request", "inform")
        ]
        came = [
            r["input"][1]
            for r in stories[to].records
            if r["kind"] == "received"
            and r["input"][0] == sender
            and r["performative"] in ("request", "inform")
        ]
        if came != [number for number, _ in sent if number in set(came)]:
            found.append(f"{to} has messages of {sender} twice or in another order")
        lost = [number for number, when in sent if when < last and number not in set(came)]
        if lost:
            found.append(f"{to} lacks {len(lost)} messages of {sender}")
    return found


@contextmanager
def talking(folder: Path, network: Machines, **environment: str) -> Iterator[Talkers]:
    """The team, when each hears each."""
    team = Talkers(folder, network, {})
    for robot in NAMES:
        team.begin(robot, **environment)
    team.wait_for_talk(40)
    time.sleep(1.0)
    yield team
