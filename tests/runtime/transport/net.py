"""A team in several parts in one process: each part as if it were a process of its own.

Between them is `Air`, which loses, doubles and delays what goes through it, or real Zenoh sessions.
"""

from __future__ import annotations

import heapq
import itertools
import random
import threading
import time
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from aseme_dsl.runtime.message.acl import FipaMessage
from aseme_dsl.runtime.team.team import RunResult, Team
from aseme_dsl.runtime.trace.trace import Record
from aseme_dsl.runtime.transport.envelope import Envelope
from aseme_dsl.runtime.transport.link import Answer, Hears, Link, Stamp
from aseme_dsl.runtime.transport.reliable_delivery import Post
from aseme_dsl.runtime.transport.stream import PATIENCE
from tests.runtime.playing import check_line, make
from tests.support.generated import Generated
from tests.support.waiting import LONG


@dataclass
class _End:
    """One process's end."""

    agents: tuple[str, ...]
    incarnation: int
    hears: Hears


@dataclass
class Air:
    """What is between the processes. `loss` and `doubling` are shares, `delay` is in seconds at most."""

    seed: int = 1
    loss: float = 0.0
    doubling: float = 0.0
    delay: float = 0.0
    ends: list[_End] = field(default_factory=list)
    cut: set[str] = field(default_factory=set)
    """Agents that nothing comes to or from."""

    def __post_init__(self) -> None:
        self.chance = random.Random(self.seed)
        self.lock = threading.Condition()
        self.queue: list[tuple[float, int, Any]] = []
        self.numbers = itertools.count()
        self.last = 0.0
        threading.Thread(target=self._carry, daemon=True).start()

    def link(self) -> Link:
        return _AirLink(self)

    def later(self, call: Any, ordered: bool = False) -> None:
        with self.lock:
            moment = time.monotonic() + (0 if ordered else self.chance.random() * self.delay)
            heapq.heappush(self.queue, (moment, next(self.numbers), call))
            self.lock.notify()

    def _carry(self) -> None:
        while True:
            with self.lock:
                while not self.queue or self.queue[0][0] > time.monotonic():
                    self.lock.wait(0.001 if self.queue else None)
                _, _, call = heapq.heappop(self.queue)
            call()

    def part(self, name: str) -> None:
        """Cut an agent off; everybody notices after a while."""
        self.cut.add(name)
        self._tell(name, "vanished")

    def join(self, name: str) -> None:
        """Undo it."""
        self.cut.discard(name)
        self._tell(name, "appeared")

    def _tell(self, name: str, what: str) -> None:
        mine = next(end for end in self.ends if name in end.agents)
        for end in tuple(self.ends):
            if end is not mine:
                self.later(lambda end=end: getattr(end.hears, what)(name, mine.incarnation), ordered=True)
                for other in end.agents:
                    self.later(
                        lambda end=end, other=other: getattr(mine.hears, what)(other, end.incarnation),
                        ordered=True,
                    )


class _AirLink:
    readable = False
    patience = PATIENCE
    datagrams = ()
    lease = None
    largest = None

    def __init__(self, air: Air) -> None:
        self.air = air
        self.mine: _End | None = None

    def open(self, agents: Sequence[str], incarnation: int, hears: Hears) -> None:
        self.mine = _End(tuple(agents), incarnation, hears)
        with self.air.lock:  # of two that begin at once, one is the second
            for end in tuple(self.air.ends):
                for agent in agents:
                    self.air.later(lambda e=end, a=agent: e.hears.appeared(a, incarnation), ordered=True)
                for agent in end.agents:
                    self.air.later(lambda e=end, a=agent: hears.appeared(a, e.incarnation), ordered=True)
            self.air.ends.append(self.mine)

    def send(
        self, to: str, sender: str, way: str, envelope: Envelope, stamp: Stamp, payload: bytes, sure: bool
    ) -> None:
        air = self.air
        stamped = envelope._replace(**stamp._asdict())
        with air.lock:
            lost = air.chance.random() < air.loss
            copies = 2 if air.chance.random() < air.doubling else 1
        for _ in range(0 if lost else copies):
            air.later(lambda: self._arrive(to, sender, stamped, payload))

    def _arrive(self, to: str, sender: str, envelope: Envelope, payload: bytes) -> None:
        if {to, sender} & self.air.cut:
            return
        for end in tuple(self.air.ends):
            if to in end.agents:
                end.hears.arrived(to, sender, envelope, payload)

    def say(self, to: str, sender: str, message: FipaMessage) -> bool:
        return False

    def ask(
        self, to: str, what: str, question: bytes, timeout: float, life: int | None = None
    ) -> list[Answer]:
        for end in tuple(self.air.ends):
            if to in end.agents:
                return list(end.hears.asked(to, what, question))
        return []

    def renew(self, name: str, again: bool = False) -> None:
        pass

    def close(self) -> None:
        with self.air.lock:
            if self.mine in self.air.ends:
                self.air.ends.remove(self.mine)
                for end in tuple(self.air.ends):
                    for agent in self.mine.agents:
                        self.air.later(
                            lambda e=end, a=agent: e.hears.vanished(a, self.mine.incarnation), ordered=True
                        )


@dataclass
class Part:
    """One part of a team, running in a thread."""

    team: Team
    post: Post
    records: list[Record]
    generated: Generated
    thread: threading.Thread | None = None
    result: RunResult | None = None
    error: BaseException | None = None

    def start(self) -> Part:
        self.thread = threading.Thread(target=self._run, daemon=True)
        self.thread.start()
        return self

    def _run(self) -> None:
        try:
            self.result = self.team.run()
        except BaseException as error:
            self.error = error

    def stop(self) -> None:
        self.team.driver.stop("test")
        self.join()

    def join(self) -> None:
        assert self.thread is not None
        self.thread.join(LONG)
        assert not self.thread.is_alive(), "the team does not end"
        if self.error is not None:
            raise self.error
        for record in self.records:
            check_line(record)

    def of(self, kind: str, **members: Any) -> list[Record]:
        return [
            r
            for r in list(self.records)
            if r["kind"] == kind and all(r.get(k) == v for k, v in members.items())
        ]

    def news(self, *what: str) -> list[str]:
        """What was told of peers: `bob there`."""
        return [f"{r['peer']} {r['what']}" for r in self.of("peer") if not what or r["what"] in what]


def part(
    generated: Generated,
    here: Iterable[str],
    activities: Mapping[str, type[Any]],
    link: Link,
    *,
    model: str | None = None,
    **options: Any,
) -> Part:
    """A part of a generated team, with the agents `here`."""
    schema = generated.messages.SCHEMA
    plans = [chart.PLAN for chart in generated.charts.values()]
    post = Post(link, schema, generated.package.MODEL if model is None else model, plans)
    team, records = make(generated, activities, here=tuple(here), transport=post, clock="real", **options)
    return Part(team, post, records, generated)
