"""How fast and how surely robots in several processes talk: `benchmarks/transport.py [--quick] [PART …]`.

Parts, each with its own processes on this machine's loopback interface:

    latency   a state from one robot's process to the other's and back, beside a bare Zenoh put and callback
    killed    how soon a robot that is killed is known
    late      how soon a robot that comes late has everybody's state
    sure      50 000 signals and agent messages while a third robot is killed: lost, doubled, out of order

Each prints what it measured. Figures that depend on the machine are compared within one run; what may never
happen (a lost signal) makes the exit code 1.
"""

from __future__ import annotations

import argparse
import itertools
import json
import os
import statistics
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

TEXT = """
system Bench
message Ball { double x  double y  int n  string text }
topic team { state Ball from one, other  signal Ball queued from one, other }
aip talk {
  participant asker { sends inform Ball  receives inform Ball  process = Ask }
  participant teller { sends inform Ball  receives inform Ball  process = Tell }
}
srm one   { plays talk.asker   liveness { one = (asker || Speak~ || Listen~) }
  activities { Speak reads team.state.Ball writes team.state.Ball, team.signal.Ball
               Listen reads team.state.Ball, team.signal.Ball } }
srm other { plays talk.teller  liveness { other = (teller || Listen~ || Speak~) }
  activities { Speak reads team.state.Ball writes team.state.Ball, team.signal.Ball
               Listen reads team.state.Ball, team.signal.Ball } }
team Bench { ann : one  bob, cat : other }
"""
BALL = {"x": 1.5, "y": -2.5, "text": "b" * 150}


# ---- the processes -----------------------------------------------------------------------------


class Robot:
    """One robot in this process, with its bus in our hands instead of its activities'."""

    def __init__(self, name: str, hear: Callable[[str, Any], None], mail: Callable[[Any], None]) -> None:
        from aseme_dsl.runtime.chart.inputs import AgentMessage, Sample
        from aseme_dsl.runtime.team.team import Setup, Team
        from aseme_dsl.runtime.transport import Network
        from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
        from aseme_dsl.runtime.transport.reliable_delivery import Post
        from tests.support.generated import generate

        generated = generate(TEXT)
        self.messages = generated.messages

        class Idle:
            def execute(self, context: Any) -> None:
                context.wait(3600)

        post = Post(ZenohLink("Bench", Network()), generated.messages.SCHEMA, "bench")
        self.team = Team(
            [(agent, generated.charts[role]) for agent, role in generated.package.TEAM],
            {"Speak": Idle, "Listen": Idle, "Ask": Idle, "Tell": Idle},
            Setup(
                clock="real",
                here=[name],
                transport=post,
                path=[generated.folder],
                schema=generated.messages.SCHEMA,
            ),
        )
        self.agent = self.team.agent(name)
        take = self.agent.post

        def post_and_tell(identity: Any, item: Any, *rest: Any, **named: Any) -> None:
            if isinstance(item, Sample) and item.sender != name:
                hear(item.sender, item)
            elif isinstance(item, AgentMessage):
                mail(item)
            take(identity, item, *rest, **named)

        self.agent.post = post_and_tell  # type: ignore[method-assign]
        self.thread = threading.Thread(target=self.team.run, daemon=True)

    def start(self) -> None:
        self.thread.start()
        self.until(lambda: self.agent.steps > 0)

    def until(self, condition: Callable[[], bool], seconds: float = 60.0) -> bool:
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                return False
            time.sleep(0.001)
        return True

    def ball(self, n: int) -> Any:
        return self.messages.Ball(n=n, **BALL)

    def publish(self, kind: str, n: int, host: str | None = None) -> None:
        self.team.bus.publish(self.agent, f"team.{kind}.Ball", self.ball(n), host)

    def send(self, n: int, to: str) -> None:
        branch = self.agent.plan.branches[0].label
        self.team.conversations.send(self.agent, branch, "inform", "Ball", self.ball(n), to)

    def stop(self) -> None:
        self.team.driver.stop("done")
        self.thread.join(10)


def child(role: str, *arguments: str) -> subprocess.Popen[str]:
    """Start this program as somebody else."""
    return subprocess.Popen(
        [sys.executable, __file__, "--as", role, *arguments],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )


def said(process: subprocess.Popen[str]) -> Any:
    """What a child says next."""
    assert process.stdout is not None
    line = process.stdout.readline()
    return json.loads(line) if line else None


def say(value: Any) -> None:
    """Tell whoever started us."""
    print(json.dumps(value), flush=True)


def await_end() -> None:
    """Until whoever started us closes our standard input."""
    sys.stdin.read()


# ---- latency -----------------------------------------------------------------------------------


def bare_session() -> Any:
    """A Zenoh session with our settings."""
    from aseme_dsl.runtime.transport import Network
    from aseme_dsl.runtime.transport.over_zenoh import ZenohLink

    return ZenohLink("Bench", Network()).connected("bare")


def be_echo() -> None:
    """Sends back what it gets: bare samples as bare samples, states as states."""
    session = bare_session()
    back = session.declare_publisher("bench/back")
    forth = session.declare_subscriber("bench/forth", lambda sample: back.put(sample.payload))
    robot = Robot("bob", lambda sender, item: robot.publish("state", item.message.n), lambda mail: None)
    robot.start()
    robot.until(lambda: robot.team.transport.is_there("ann"))
    say("ready")
    await_end()
    robot.stop()
    forth.undeclare()
    session.close()


def measure_latency(rounds: int) -> bool:
    """Ping-pong in turns, at 100 Hz as robots talk: the bare one first, then the robots' state, and again."""
    session = bare_session()
    came = threading.Event()
    subscriber = session.declare_subscriber("bench/back", lambda sample: came.set())
    forth = session.declare_publisher("bench/forth")
    echo = child("echo")
    robot = Robot("ann", lambda sender, item: came.set(), lambda mail: None)
    robot.start()
    assert said(echo) == "ready"
    robot.until(lambda: robot.team.transport.is_there("bob"))
    payload = robot.messages.SCHEMA.encode(robot.ball(1))
    bare: list[float] = []
    ours: list[float] = []
    time.sleep(0.3)

    def turn(send: Callable[[], None], into: list[float]) -> None:
        came.clear()
        began = time.perf_counter()
        send()
        if came.wait(2.0):
            into.append((time.perf_counter() - began) / 2)
        time.sleep(0.01)

    for n in range(rounds):
        turn(lambda: forth.put(payload), bare)
        turn(lambda n=n: robot.publish("state", n), ours)  # type: ignore[misc]
    assert echo.stdin is not None
    echo.stdin.close()
    robot.stop()
    subscriber.undeclare()
    session.close()
    echo.wait(10)
    for name, values in (("bare zenoh", bare), ("state", ours)):
        values.sort()
        middle, late = statistics.median(values), values[int(len(values) * 0.99)]
        said_so = f"one way: median {middle * 1e6:6.0f} us   99 % {late * 1e6:6.0f} us   n {len(values)}"
        print(f"  {name:<12} {said_so}")
    ratio = statistics.median(ours) / statistics.median(bare)
    print(f"  ratio of the medians {ratio:.2f} (wanted: at most 3)")
    return len(ours) == rounds


# ---- killed and late ---------------------------------------------------------------------------


def be_robot(name: str) -> None:
    """Is there, and has a state."""
    robot = Robot(name, lambda sender, item: None, lambda mail: None)
    robot.start()
    robot.publish("state", 7)
    say("ready")
    await_end()
    robot.stop()


def measure_killed(rounds: int) -> bool:
    """From the kill to the moment at which the other robot knows."""
    robot = Robot("ann", lambda sender, item: None, lambda mail: None)
    robot.start()
    taken: list[float] = []
    for _ in range(rounds):
        other = child("robot", "bob")
        said(other)
        robot.until(lambda: robot.team.transport.is_there("bob"))
        time.sleep(0.2)
        began = time.perf_counter()
        other.kill()
        robot.until(lambda: not robot.team.transport.is_there("bob"))
        taken.append(time.perf_counter() - began)
        other.wait()
    robot.stop()
    print(f"  known after: {', '.join(f'{value * 1e3:.1f} ms' for value in taken)} (wanted, idle: 50 ms)")
    return True


def _join_late() -> float | None:
    heard: dict[str, float] = {}
    robot = Robot("ann", lambda sender, _: heard.setdefault(sender, time.perf_counter()), lambda _: None)
    began = time.perf_counter()
    robot.start()
    whole = robot.until(lambda: len(heard) == 2, 10)
    robot.stop()
    return max(heard.values()) - began if whole else None


def measure_late(rounds: int) -> bool:
    """From opening the network to having the state of both others."""
    others = [child("robot", name) for name in ("bob", "cat")]
    for other in others:
        said(other)
    taken: list[float] = []
    whole = True
    for _ in range(rounds):
        seconds = _join_late()
        whole = whole and seconds is not None
        if seconds is not None:
            taken.append(seconds)
        time.sleep(0.1)
    for other in others:
        assert other.stdin is not None
        other.stdin.close()
        other.wait(10)
    print(f"  complete after: {', '.join(f'{value * 1e3:.1f} ms' for value in taken)} (wanted, idle: 100 ms)")
    return whole


# ---- none lost ---------------------------------------------------------------------------------


def be_listener(name: str, count: str) -> None:
    """Writes down which signals and agent messages have come, and says how many when all have."""
    signals: list[int] = []
    mails: list[int] = []
    robot = Robot(
        name,
        lambda sender, item: signals.append(item.message.n) if ".signal." in item.channel else None,
        lambda mail: mails.append(mail.content.n),
    )
    robot.start()
    say("ready")
    wanted = int(count)
    robot.until(lambda: len(signals) >= wanted and len(mails) >= wanted, 300)
    time.sleep(0.3)  # whatever comes twice comes now

    def judged(numbers: Sequence[int]) -> dict[str, int]:
        once = set(numbers)
        return {
            "came": len(numbers),
            "lost": wanted - len(once),
            "doubled": len(numbers) - len(once),
            "out of order": sum(later < earlier for earlier, later in itertools.pairwise(numbers)),
        }

    say({"signals": judged(signals), "agent messages": judged(mails)})
    await_end()
    robot.stop()


def measure_sure(count: int) -> bool:
    """Half are signals, half agent messages, to bob; cat gets the signals, too, and is killed half-way."""
    robot = Robot("ann", lambda sender, item: None, lambda mail: None)
    robot.start()
    half = count // 2
    bob, cat = child("listener", "bob", str(half)), child("listener", "cat", str(half))
    said(bob)
    said(cat)
    robot.until(lambda: robot.team.transport.is_there("bob") and robot.team.transport.is_there("cat"))
    began = time.perf_counter()
    for n in range(half):
        robot.publish("signal", n)
        robot.send(n, "bob")
        if n == half // 2:
            cat.kill()
        if n % 100 == 0:  # as fast as it is taken, but not faster than the backlog is long
            robot.until(lambda: robot.team.peers()["bob"].unacknowledged < 5000)
    result = said(bob)
    took = time.perf_counter() - began
    assert bob.stdin is not None
    bob.stdin.close()
    bob.wait(20)
    cat.wait()
    robot.stop()
    lost = robot.team.peers()["cat"].lost
    print(f"  {count} in {took:.1f} s ({count / took:.0f} a second)")
    print(f"  of those for the robot that was killed {lost} could not be brought, and were told as lost")
    for kind, judged in result.items():
        print(f"  {kind}: {', '.join(f'{what} {number}' for what, number in judged.items())}")
    return all(
        judged["lost"] == judged["doubled"] == judged["out of order"] == 0 for judged in result.values()
    )


# ---- all of them -------------------------------------------------------------------------------

PARTS: dict[str, tuple[Callable[[int], bool], int, int]] = {
    "latency": (measure_latency, 500, 50),
    "killed": (measure_killed, 5, 2),
    "late": (measure_late, 5, 2),
    "sure": (measure_sure, 50_000, 4_000),
}
ROLES: dict[str, Callable[..., None]] = {"echo": be_echo, "robot": be_robot, "listener": be_listener}


def main() -> int:
    """Measure; 1 if something happened that may never happen."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--quick", action="store_true", help="a tenth, to see that it works")
    parser.add_argument("--as", dest="role", choices=list(ROLES), help=argparse.SUPPRESS)
    parser.add_argument("parts", nargs="*", metavar="PART", help=", ".join(PARTS))
    options = parser.parse_args()
    if options.role:
        ROLES[options.role](*options.parts)
        return 0
    unknown = [part for part in options.parts if part not in PARTS]
    if unknown:
        parser.error(f"there is no part {unknown[0]}; there are {', '.join(PARTS)}")
    fine = True
    for name in options.parts or PARTS:
        measure, usual, quick = PARTS[name]
        print(f"{name}:", flush=True)
        fine = measure(quick if options.quick else usual) and fine
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
