"""A network of machines for tests: `python switch.py SEED NAME=ADDRESS,… …`.

Each machine is a network namespace, and this program is the switch between them: it has the other ends of
their network cards (TAP devices), and loses, delays, doubles, reorders and blocks what goes between them.
No frame leaves these namespaces. They end with this program, which ends with its standard input.

It prints `{"NAME": PID, …}`: a process that holds the namespace of each machine. Then each line of its input
is a command in JSON, answered by a line:

    {"from": NAME, "to": NAME, "loss": 0.2, …}   what goes wrong from now on in this direction (`Way`)
    {"count": true}                              the frames of each direction: brought, lost

It uses nothing but the standard library, so any Python runs it.
"""

from __future__ import annotations

import contextlib
import ctypes
import fcntl
import heapq
import itertools
import json
import os
import random
import selectors
import struct
import subprocess
import sys
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path

CLONE_NEWNET = 0x40000000
TUNSETIFF = 0x400454CA
IFF_TAP_NO_PI = 0x0002 | 0x1000
FRAME = 2048
WAITING = 2000
"""So many frames wait in one direction, as in the buffer of a switch; further ones are lost."""
QUEUE = 0.1
"""Before a slow link so many seconds' worth of frames wait; further ones are lost."""


@dataclass
class Way:
    """What happens to the frames from one machine to another."""

    delay: float = 0.0
    """How long each takes, in seconds."""
    jitter: float = 0.0
    """How much longer it may take: they stay in order, unless one overtakes."""
    loss: float = 0.0
    """The part of them that is lost."""
    double: float = 0.0
    """The part of them that arrives twice."""
    overtake: float = 0.0
    """The part of them that may overtake earlier ones, by the `jitter`."""
    blocked: bool = False
    rate: float = 0.0
    """So many bytes pass in a second; 0: as many as come."""
    random: random.Random = field(default_factory=random.Random)
    latest: float = 0.0
    free: float = 0.0
    """When all that waits for the `rate` will have passed."""
    waiting: int = 0
    brought: int = 0
    lost: int = 0

    def times(self, now: float, size: int) -> list[float]:
        """When a frame of so many bytes that is sent now arrives: not at all, once or twice."""
        chance = self.random.random
        if self.blocked or self.waiting >= WAITING or (self.loss and chance() < self.loss):
            self.lost += 1
            return []
        if self.rate:
            if self.free - now > QUEUE:
                self.lost += 1
                return []
            self.free = now = max(now, self.free) + size / self.rate
        found = []
        for _ in range(2 if self.double and chance() < self.double else 1):
            moment = now + self.delay + (self.jitter * chance() if self.jitter else 0.0)
            if not (self.overtake and chance() < self.overtake):
                moment = self.latest = max(moment, self.latest)
            found.append(moment)
        return found


def network_card(pid: int, name: str) -> int:
    """The other end of a network card in the namespace of a process."""
    made: list[int | OSError] = []

    def make() -> None:
        # A namespace is that of a thread: this one ends with it.
        with Path(f"/proc/{pid}/ns/net").open("rb") as space:
            if ctypes.CDLL(None, use_errno=True).setns(space.fileno(), CLONE_NEWNET):
                made.append(OSError(ctypes.get_errno(), "setns"))
                return
        try:
            end = os.open("/dev/net/tun", os.O_RDWR | os.O_NONBLOCK)
            fcntl.ioctl(end, TUNSETIFF, struct.pack("16sH22x", name.encode(), IFF_TAP_NO_PI))
            made.append(end)
        except OSError as problem:
            made.append(problem)

    thread = threading.Thread(target=make)
    thread.start()
    thread.join()
    if isinstance(made[0], OSError):
        raise made[0]
    return made[0]


def machine(number: int, addresses: list[str]) -> tuple[subprocess.Popen[bytes], int]:
    """A process that holds a namespace with a network card, and the other end of that card."""
    holder = subprocess.Popen(
        ["unshare", "--net", "sh", "-c", "echo; exec sleep infinity"],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
    )
    assert holder.stdout is not None
    if not holder.stdout.readline():
        raise OSError(1, "unshare --net makes no namespace")
    end = network_card(holder.pid, "eth0")
    inside = ["nsenter", f"--net=/proc/{holder.pid}/ns/net", "ip"]
    for command in (
        ["link", "set", "lo", "up"],
        ["link", "set", "eth0", "address", mac(number).hex(":")],
        *(["addr", "add", one, "dev", "eth0", *(["nodad"] if ":" in one else [])] for one in addresses),
        ["link", "set", "eth0", "up"],
        ["route", "add", "224.0.0.0/4", "dev", "eth0"],
    ):
        subprocess.run([*inside, *command], check=True)
    return holder, end


def mac(number: int) -> bytes:
    return bytes((2, 0, 0, 0, 0, number + 1))


def main() -> None:
    seed, *given = sys.argv[1:]
    names = [one.partition("=")[0] for one in given]
    holders: list[subprocess.Popen[bytes]] = []
    try:
        ends: list[int] = []
        for number, one in enumerate(given):
            holder, end = machine(number, one.partition("=")[2].split(","))
            holders.append(holder)
            ends.append(end)
        print(json.dumps({name: holder.pid for name, holder in zip(names, holders, strict=True)}), flush=True)
        ways = {(a, b): Way(random=random.Random(f"{seed} {a} {b}")) for a in names for b in names if a != b}
        switch(names, ends, ways)
    finally:
        for holder in holders:
            holder.kill()
            holder.wait()


def switch(names: list[str], ends: list[int], ways: dict[tuple[str, str], Way]) -> None:
    """Bring frames until the standard input ends."""
    by_mac = {mac(number): number for number in range(len(names))}
    later: list[tuple[float, int, int, bytes, Way]] = []
    order = itertools.count()
    selector = selectors.DefaultSelector()
    selector.register(sys.stdin.fileno(), selectors.EVENT_READ, None)
    for number, end in enumerate(ends):
        selector.register(end, selectors.EVENT_READ, number)
    said = b""
    while True:
        wait = max(0.0, later[0][0] - time.monotonic()) if later else None
        for key, _ in selector.select(wait):
            if key.data is None:
                data = os.read(sys.stdin.fileno(), 65536)
                if not data:
                    return
                *lines, said = (said + data).split(b"\n")
                for line in lines:
                    print(json.dumps(obey(json.loads(line), ways)), flush=True)
                continue
            for _ in range(64):  # then the others have their turn
                try:
                    frame = os.read(key.fd, FRAME)
                except OSError:
                    break
                now = time.monotonic()
                known = by_mac.get(frame[:6])
                for to in range(len(ends)) if known is None else (known,):
                    if to == key.data:
                        continue
                    way = ways[names[key.data], names[to]]
                    for moment in way.times(now, len(frame)):
                        way.waiting += 1
                        heapq.heappush(later, (moment, next(order), ends[to], frame, way))
        now = time.monotonic()
        while later and later[0][0] <= now:
            _, _, end, frame, way = heapq.heappop(later)
            way.waiting -= 1
            way.brought += 1
            with contextlib.suppress(OSError):  # the machine's card takes no more
                os.write(end, frame)


def obey(command: dict[str, object], ways: dict[tuple[str, str], Way]) -> object:
    if "count" in command:
        return {f"{a} {b}": [way.brought, way.lost] for (a, b), way in ways.items()}
    way = ways[str(command.pop("from")), str(command.pop("to"))]
    for key, value in command.items():
        if not hasattr(way, key):
            return {"error": key}
        setattr(way, key, value)
    return {}


if __name__ == "__main__":
    main()
