"""Robots on several machines, each in a network of its own: who has no certificate of theirs gets nowhere.

A machine is a network namespace (`ip netns`), and a switch connects them; only root may make them. That takes
a while: `dev.py long` sets MACHINES.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import psutil
import pytest

from tests.cli.support import asemec
from tests.faults.team import NAME, ROOT, TEAM, Started, project, signals_from
from tests.faults.test_network import certify
from tests.support.network import own_name
from tests.support.waiting import LONG, wait_until

MACHINES = ("robot1", "robot2", "mallory")
ADDRESSES = {name: f"10.99.0.{number}" for number, name in enumerate(MACHINES, 1)}


@pytest.fixture
def machines() -> Iterator[dict[str, str]]:
    """The network namespaces of `MACHINES`, by name, which reach each other and nothing else."""
    if not os.environ.get("MACHINES"):
        pytest.skip("robots on several machines: set MACHINES, or run python3 dev.py long")
    pytest.importorskip("zenoh")
    if shutil.which("ip") is None or os.geteuid() != 0:
        pytest.skip("NOT TESTED: machines of their own need `ip` (iproute2), and tests that run as root")
    switch = own_name("asw")
    found = {name: own_name("am") for name in MACHINES}

    def ip(*arguments: str) -> None:
        done = subprocess.run(["ip", *arguments], capture_output=True, text=True)
        if done.returncode != 0:
            pytest.skip(f"NOT TESTED: ip {' '.join(arguments)}: {done.stderr.strip()}")

    try:
        ip("netns", "add", switch)
        ip("-n", switch, "link", "add", "br0", "type", "bridge")
        ip("-n", switch, "link", "set", "br0", "up")
        for name, space in found.items():
            ip("netns", "add", space)
            ip("-n", space, "link", "add", "eth0", "type", "veth", "peer", "name", name, "netns", switch)
            ip("-n", switch, "link", "set", name, "master", "br0", "up")
            ip("-n", space, "addr", "add", f"{ADDRESSES[name]}/24", "dev", "eth0")
            ip("-n", space, "link", "set", "lo", "up")
            ip("-n", space, "link", "set", "eth0", "up")
        yield found
    finally:
        for space in (switch, *found.values()):
            subprocess.run(["ip", "netns", "del", space], capture_output=True)


@dataclass(slots=True)
class Machines:
    """A team of two robots, each on its machine."""

    folder: Path
    spaces: dict[str, str]
    processes: dict[str, psutil.Popen]

    def command(self, machine: str, *command: str) -> psutil.Popen:
        """Begin something on a machine."""
        return psutil.Popen(
            ["ip", "netns", "exec", self.spaces[machine], sys.executable, *command],
            cwd=self.folder,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env={**os.environ, "PYTHONPATH": str(ROOT)},
        )

    def trace(self, robot: str) -> list[dict[str, object]]:
        """What is in a robot's trace so far."""
        return Started.trace(self, robot)  # type: ignore[arg-type]  # of a run, it needs the folder only

    def heard(self, robot: str) -> list[int]:
        """The numbers that a robot has heard from the other one."""
        (other,) = {"robot1", "robot2"} - {robot}
        return signals_from(self.trace(robot), other)

    def wait_for_more(self) -> None:
        """Until both have heard 20 more signals."""
        before = {robot: len(self.heard(robot)) for robot in self.processes}

        def is_heard() -> bool:
            for robot, process in self.processes.items():
                assert process.poll() is None, process.communicate()[0]
                if len(self.heard(robot)) < before[robot] + 20:
                    return False
            return True

        wait_until(is_heard, pause=0.2)

    def open_on(self, machine: str) -> list[str]:
        """Where anybody takes on a machine what others send, over TCP and UDP."""
        said, _ = self.command(machine, "-c", OPEN).communicate(timeout=LONG)
        return sorted(set(said.splitlines()))

    def attack(self, how: str) -> list[str]:
        """Run `ATTACK` on the third machine; gives what it says."""
        process = self.command("mallory", "-c", ATTACK, how, NAME, ADDRESSES["robot2"])
        try:
            said, _ = process.communicate(timeout=LONG)
        finally:
            with contextlib.suppress(psutil.Error):
                process.kill()
        assert process.returncode == 0, said
        return [line for line in said.splitlines() if line.startswith("= ")]


OPEN = """
import psutil
for item in psutil.net_connections("inet"):
    if item.status == psutil.CONN_LISTEN or item.status == psutil.CONN_NONE:
        print(item.laddr.ip, item.laddr.port)
"""

DEPLOYED = """
hosts = { robot1 = "10.99.0.1", robot2 = "10.99.0.2" }
tls = { authority = "certificates/team.pem", certificate = "certificates/ROBOT.pem", \
key = "certificates/ROBOT.key" }
"""


def two(folder: Path, deployed: str) -> Path:
    """A project with two robots on two machines."""
    text = TEAM.replace("robot[1..3]", "robot[1..2]").replace(
        "robot2.team.signal.Tick,\n      robot3.team.signal.Tick", "robot2.team.signal.Tick"
    )
    made = project(folder, text=text, configuration=deployed)
    (made / "certificates").mkdir()
    names = {"team": ("robot1", "robot2", "mallory"), "other": ("stranger",)}
    certify(made / "certificates", names, *ADDRESSES.values())
    return made


@pytest.fixture
def team(tmp_path: Path, machines: dict[str, str]) -> Iterator[Machines]:
    """The two robots, when each hears the other."""
    folder = two(tmp_path, DEPLOYED)
    assert asemec("build", cwd=folder).code == 0
    found = Machines(folder, machines, {})
    try:
        for robot in ("robot1", "robot2"):
            found.processes[robot] = found.command(
                robot, "-m", "aseme_dsl", "node", robot, "--from", "out", "--activities", "activities"
            )
        found.wait_for_more()
        yield found
    finally:
        for process in found.processes.values():
            with contextlib.suppress(psutil.Error):
                process.terminate()
        for process in found.processes.values():
            try:
                process.communicate(timeout=LONG)
            except subprocess.TimeoutExpired:
                process.kill()


ATTACK = """
import os, socket, sys, time
from pathlib import Path
import zenoh
from aseme_dsl.runtime.transport import Network, Tls
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.envelope import Envelope

sys.excepthook = lambda *error: (sys.__excepthook__(*error), os._exit(1))  # zenoh would wait
how, system, address = sys.argv[1:]
files = Path("certificates")
if how == "nonsense":
    held = []
    for number in range(200):
        one = socket.create_connection((address, 7447), 30)
        one.setblocking(False)
        if number % 2:
            one.send(os.urandom(200))
        held.append(one)
    time.sleep(5)
    print("= held", flush=True)
    sys.exit()
who = {"of another authority": "stranger", "of the team": "mallory"}.get(how, "mallory")
end = f"{'tcp' if how == 'no tls' else 'tls'}/{address}:7447"
tls = Tls(files / "team.pem", files / f"{who}.pem", files / f"{who}.key")
settings = dict(Network(connect=(f"tls/{address}:7447",), tls=tls).settings())
settings["connect/endpoints"] = f'["{end}"]'
if how == "no certificate":
    settings = {k: v for k, v in settings.items() if "connect_" not in k and "mtls" not in k}
config = zenoh.Config()
for key, value in settings.items():
    config.insert_json5(key, value)
config.insert_json5("connect/timeout_ms", "0")
session = zenoh.open(config)
root = f"asemec/{system}"
heard = []
session.declare_subscriber(f"{root}/to/robot1/**", lambda sample: heard.append(str(sample.key_expr)))
lives = (1, 2**63, time.time_ns())
tokens = [
    session.liveliness().declare_token(f"{root}/here/{name}/{life:x}")
    for name in ("robot1", "robot2")
    for life in lives
]
answers = 0
for number in range(200):
    for life in lives:
        envelope = Envelope(number % 5, incarnation=life, channel="team.signal.Tick")
        mark = envelopes.written(envelope, b"", place=number)
        for way in ("ping", "pong", "team/signal/Tick"):
            session.put(f"{root}/to/robot2/robot1/{way}", b"", attachment=mark)
    time.sleep(0.02)
for what in ("control", "history"):
    question = b'{"version":1,"request":"stop"}'
    answers += len(list(session.get(f"{root}/{what}/robot2", payload=question, timeout=2.0)))
print(f"= peers {len(list(session.info.peers_zid()))} heard {len(heard)} answers {answers}", flush=True)
for token in tokens:
    token.undeclare()
session.close()
"""


@pytest.mark.parametrize(
    ("how", "said"),
    [
        ("of another authority", "= peers 0 heard 0 answers 0"),
        ("no certificate", "= peers 0 heard 0 answers 0"),
        ("no tls", "= peers 0 heard 0 answers 0"),
        ("of the team", "= peers 1 heard 0 answers 0"),  # it is let in, and may say nothing for others
        ("nonsense", "= held"),
    ],
)
def test_a_third_machine_neither_joins_nor_impersonates_nor_delays(
    team: Machines, how: str, said: str
) -> None:
    assert team.attack(how) == [said]
    team.wait_for_more()
    for robot, process in team.processes.items():
        assert process.poll() is None and team.open_on(robot) == [f"{ADDRESSES[robot]} 7447"]
        numbers = team.heard(robot)
        assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))  # none lost, doubled or forged
        news = {str(r["what"]) for r in team.trace(robot) if r["kind"] == "peer"}
        assert not news & {"gone", "reconnected", "restarted", "replaced", "late", "unreadable", "reordered"}
        assert [r for r in team.trace(robot) if r["kind"] == "control"] == []


@pytest.mark.parametrize("how", ["another authority", "another name"])
def test_a_robot_with_the_wrong_certificate_is_nobody_to_the_others(team: Machines, how: str) -> None:
    """`asemec node robot1` on the third machine."""
    other = team.folder / "other"
    who = "stranger" if how == "another authority" else "mallory"
    text = DEPLOYED.replace("ROBOT.", f"{who}.").replace("certificates/", f"{team.folder}/certificates/")
    shutil.copytree(team.folder, other, ignore=shutil.ignore_patterns("out", "certificates", "other"))
    configured = (other / "pyproject.toml").read_text().replace(DEPLOYED, text)
    assert configured != (other / "pyproject.toml").read_text()
    # It listens at its own address: the robots would find it only if it finds them.
    (other / "pyproject.toml").write_text(configured.replace("10.99.0.1", "10.99.0.3"))
    impostor = Machines(other, team.spaces, {}).command(
        "mallory",
        "-m",
        "aseme_dsl",
        "node",
        "robot1",
        "talk.aseme",
        "--for",
        "10s",
        "--activities",
        "activities",
    )
    said, _ = impostor.communicate(timeout=LONG)
    team.wait_for_more()
    traced = Machines(other, team.spaces, {}).trace("robot1")
    assert [r for r in traced if r["kind"] == "arrived" and r["agent"] == "robot1" and r.get("peer")] == []
    assert signals_from(traced, "robot2") == [], said
    for robot, process in team.processes.items():
        assert process.poll() is None
        numbers = team.heard(robot)
        assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))
        news = {str(r["what"]) for r in team.trace(robot) if r["kind"] == "peer"}
        assert not news & {"gone", "reconnected", "restarted", "replaced", "late"}


def test_without_certificates_no_robot_starts_beyond_its_machine(
    tmp_path: Path, machines: dict[str, str]
) -> None:
    folder = two(tmp_path, 'hosts = { robot1 = "10.99.0.1", robot2 = "10.99.0.2" }\n')
    process = Machines(folder, machines, {}).command(
        "robot2",
        "-m",
        "aseme_dsl",
        "node",
        "robot2",
        "talk.aseme",
        "--for",
        "5s",
        "--activities",
        "activities",
    )
    said, _ = process.communicate(timeout=LONG)
    assert process.returncode == 1 and "E015" in said and "Traceback" not in said
