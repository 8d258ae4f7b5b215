"""A running team of several processes, and a thousand generated requests for each of its sockets and keys."""

from __future__ import annotations

import contextlib
import json
import random
import socket
from collections import Counter
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import Any, cast

import pytest

from aseme_dsl.runtime.chart.board import NEVER
from aseme_dsl.runtime.control.control_socket import ask, endpoints
from aseme_dsl.runtime.trace.trace_reading import TraceReader
from aseme_dsl.runtime.transport import Network
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport import meeting as meetings
from aseme_dsl.runtime.transport.envelope import Envelope
from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
from tests.faults.team import NAME, Started, project, signals_from, started
from tests.security.conftest import AsOther
from tests.security.lines import line
from tests.support.lanes import IS_LONG
from tests.support.waiting import LONG, wait_until

zenoh = pytest.importorskip("zenoh")

MANY = 1000 if IS_LONG else 300
ROBOTS = ("robot1", "robot2", "robot3")

KNOCK = """
import socket
paths, refused = sys.argv[2:], 0
for number in range(int(sys.argv[1])):
    for path in paths:
        try:
            socket.socket(socket.AF_UNIX).connect(path)
        except PermissionError:
            refused += 1
print(refused)
"""


def noise(chance: random.Random) -> bytes:
    """Bytes of no sense, or JSON of a request's shape that no request has."""
    shapes = (
        lambda: chance.randbytes(chance.randrange(1, 200)),
        lambda: b"[" * chance.randrange(1, 20_000),
        lambda: json.dumps({"version": 1, "request": chance.choice(("swap", "select", "x"))}).encode(),
        lambda: json.dumps({"version": chance.randrange(2, 9), "request": "stop"}).encode(),
        lambda: json.dumps({"version": 1, "request": "stop", "x": chance.random()}).encode(),
        lambda: json.dumps({"version": 1, "request": "swap", "folder": "/tmp"}).encode(),
    )
    return chance.choice(shapes)().replace(b"\n", b" ")


def wishes(chance: random.Random) -> bytes:
    """The same, or a request as an operator would make it."""
    if chance.random() < 0.5:
        return noise(chance)
    plan = {"agent": chance.choice(ROBOTS), "plan": "robot"}
    swap = {"phase": chance.choice(("ready", "prepare")), "hash": chance.randbytes(32).hex()}
    kinds: tuple[dict[str, object], ...] = (
        {"request": "stop"},
        {"request": "status"},
        {"request": "select", **plan},
        {"request": "swap", **swap},
        {"request": "swap", "phase": "commit", "id": chance.randrange(3)},
        {"control": "challenge"},
    )
    return json.dumps({"version": 1, **chance.choice(kinds)}).encode()


def forged(chance: random.Random, robot: str) -> tuple[str, bytes]:
    """A key to a robot with an envelope that another one might have sent, but for the proof."""
    sender = chance.choice([name for name in ROBOTS if name != robot])
    life = chance.choice((0, 1, 2**64 - 1, chance.getrandbits(64)))
    data = envelopes.written(
        Envelope(chance.randrange(5), chance.choice((0, 7)), life, channel="team.signal.Tick"), b""
    )
    if chance.random() < 0.5:
        data = envelopes.proven(data, b"", chance.randbytes(32), f"asemec/{NAME} {robot} {sender}")
    way = chance.choice(("ping", "pong", "ack", "mail", "team/signal/Tick"))
    return f"asemec/{NAME}/to/{robot}/{sender}/{way}", data[: chance.randrange(1, 200)]


def token(chance: random.Random) -> str:
    """A key that says that a robot is there, but for the proof."""
    name = chance.choice((*ROBOTS, "mallory", "x" * 200, "\x1b[31mred"))
    life = chance.choice(("0", "ffffffffffffffff", f"{chance.getrandbits(64):x}", "whenever", "-"))
    return f"asemec/{NAME}/here/{name}/{life}{chance.choice(('', '-', '-' + chance.randbytes(32).hex()))}"


def latest(run: Started, robot: str) -> dict[str, int]:
    """The last signal that has come from each other robot, by the end of a long trace."""
    reader = TraceReader(run.folder / "out" / f"trace.{robot}.jsonl.gz.part")
    records = [cast("dict[str, Any]", line.record) for line in islice(reader.before(NEVER), 1000)][::-1]
    found = {other: signals_from(records, other)[-1:] for other in ROBOTS if other != robot}
    return {other: numbers[0] for other, numbers in found.items() if numbers}


def goes_on(run: Started) -> None:
    """Each robot hears each other one say more."""
    before = {robot: latest(run, robot) for robot in ROBOTS}
    run.wait_for(
        lambda: all(
            latest(run, mine).get(other, -1) > before[mine].get(other, -1)
            for mine in ROBOTS
            for other in ROBOTS
            if mine != other
        )
    )


def state(run: Started) -> dict[str, object]:
    """What an operator may change of each agent: what it follows, and whether it is over or has failed."""
    found: dict[str, object] = {}
    for path in endpoints(run.folder / "out"):
        reply = ask(path, {"request": "status"}, LONG)
        for agent in reply["agents"]:
            found[agent["name"]] = (
                reply["model"],
                *(agent[x] for x in ("role", "system", "model", "over", "failure")),
            )
    return found


def kinds(run: Started) -> set[str]:
    """What kinds of things have happened to the robots."""
    found = {record["kind"] for robot in ROBOTS for record in run.trace(robot)}
    return found - {"control", "peer", "checkpoint"}  # which come by themselves


def nobody_was_ended_or_late(run: Started) -> bool:
    news = {entry.split()[1] for robot in ROBOTS for entry in run.news(robot)}
    return not news & {"gone", "restarted", "replaced", "late", "reconnected"} and not run.said(
        "is started again"
    )


def refusals(run: Started, robot: str) -> Counter[str]:
    """How many control requests were refused, by origin, floods summed up; none but `status` was accepted."""
    found: Counter[str] = Counter()
    for record in run.trace(robot):
        if record["kind"] == "control":
            if record["what"] == "accepted":
                assert record.get("request") == "status", record
                continue
            assert record["what"] == "refused", record
            found[record["origin"]] += record.get("count", 1)
    return found


@pytest.fixture
def run(tmp_path: Path) -> Iterator[Started]:
    with started(project(tmp_path)) as found:
        found.wait_for_talk()
        yield found


def sockets(run: Started) -> tuple[list[Path], list[Path]]:
    """Those of the bus, and those for control."""
    return sorted(meetings.meeting_place(NAME).glob("*.sock")), endpoints(run.folder / "out")


@line("another user of this machine", "open any socket of a running team, 1 000 times")
def test_another_user_opens_nothing(run: Started, as_other: AsOther) -> None:
    bus, control = sockets(run)
    assert len(bus) == 3 and len(control) >= 3
    found = [str(path) for path in (*bus, *control)]
    done = as_other(KNOCK, str(MANY), *found, modules=("socket",))
    assert done.stdout.strip() == str(MANY * len(found)), done.stderr
    goes_on(run)
    assert nobody_was_ended_or_late(run)
    assert run.end() == 130


@line("a process without the secret", "send 1 000 generated requests to the sockets and keys of a team")
def test_a_flood_from_the_same_user_changes_nothing_and_is_traced(run: Started) -> None:
    chance = random.Random(1)
    bus, control = sockets(run)
    assert len(bus) == len(ROBOTS)
    before, happened = state(run), kinds(run)
    for path in bus:
        for _ in range(MANY):
            with socket.socket(socket.AF_UNIX) as raw:
                raw.connect(str(path))
                with contextlib.suppress(ConnectionError):  # the robot has hung up already
                    raw.sendall(noise(chance)[:500])
    for path in control:
        with socket.socket(socket.AF_UNIX) as asking:
            asking.settimeout(LONG)
            asking.connect(str(path))
            replies = asking.makefile("rb")
            for _ in range(MANY):
                asking.sendall(noise(chance) + b"\n")
                assert json.loads(replies.readline())["ok"] is False
    with ZenohLink(NAME, Network()).connected("mallory") as session:
        wait_until(lambda: len(list(session.info.peers_zid())) == len(bus))
        names = {token(chance) for _ in range(4 * MANY)}
        tokens = [session.liveliness().declare_token(name) for name in sorted(names)[:MANY]]
        for robot in ROBOTS:
            for _ in range(MANY):
                key, data = forged(chance, robot)
                session.put(key, b"", attachment=data, congestion_control=zenoh.CongestionControl.BLOCK)
                asked = session.get(f"asemec/{NAME}/control/{robot}", payload=wishes(chance), timeout=LONG)
                assert all(b"off" in reply.ok.payload.to_bytes() for reply in asked if reply.ok)
                what = chance.choice(("history", "here", "*", "swap"))
                mark = chance.choice((None, chance.randbytes(48)))
                key = f"asemec/{NAME}/{what}/{robot}"
                asked = session.get(key, payload=noise(chance), attachment=mark, timeout=LONG)
                assert list(asked) == []
        goes_on(run)
        assert state(run) == before
        for item in tokens:
            item.undeclare()
    goes_on(run)
    assert state(run) == before and kinds(run) == happened
    assert nobody_was_ended_or_late(run)
    assert run.end() == 130
    for robot in ROBOTS:
        assert refusals(run, robot) == {"bus": MANY, "socket": MANY}
        counts = [r["counts"] for r in run.trace(robot) if r["kind"] == "peer" and r["what"] == "count"]
        count = Counter(what for found in counts for what in found for _ in range(found[what]))
        assert count["unreadable"] + count["refused"] == 3 * MANY  # messages, questions and tokens
        assert len([r for r in run.trace(robot) if r["kind"] == "control"]) < 2 * MANY
        assert len([r for r in run.trace(robot) if r["kind"] == "peer"]) < MANY
        assert "late" not in count
