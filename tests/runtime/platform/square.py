"""A square on which agents of several parts of a team, and others, hear each other: a platform for tests."""

from __future__ import annotations

import itertools
import threading
from collections.abc import Sequence
from dataclasses import dataclass, field
from queue import SimpleQueue

from aseme_dsl.runtime.platform.platform import Headers, Platform, Receives


@dataclass
class Square:
    """Addresses are `name@square/number`; what is for `name@square` goes to all who are called so."""

    team: tuple[str, ...]
    sites: dict[str, tuple[str, Receives]] = field(default_factory=dict)
    heard: list[tuple[str, str, dict[str, str], str]] = field(default_factory=list)
    """What was said to outsiders: sender, address, headers, text."""
    silent: bool = False
    """Whether what is said gets lost."""

    def __post_init__(self) -> None:
        self.numbers = itertools.count(1)
        self.queue: SimpleQueue[tuple[str, str, dict[str, str], str]] = SimpleQueue()
        threading.Thread(target=self._carry, daemon=True).start()

    def platform(self) -> Platform:
        """The end of one process."""
        return _End(self)

    def say(self, origin: str, to: str, headers: Headers, body: str = "") -> None:
        """Somebody at `origin` says something."""
        self.queue.put((origin, to, dict(headers), body))

    def _carry(self) -> None:
        while True:
            origin, to, headers, body = self.queue.get()
            if self.silent:
                continue
            found = [
                (name, receives)
                for address, (name, receives) in tuple(self.sites.items())
                if to in (address, address.partition("/")[0])
            ]
            for name, receives in found:
                receives.came(name, origin, headers, body)
            if not found:
                self.heard.append((origin, to, headers, body))


class _End:
    name = "square"
    largest = 10_000

    def __init__(self, square: Square) -> None:
        self.square = square
        self.mine: dict[str, str] = {}

    def start(self, agents: Sequence[str], receives: Receives) -> None:
        for name in agents:
            self.mine[name] = f"{name}@square/{next(self.square.numbers)}"
            self.square.sites[self.mine[name]] = (name, receives)

    def address_of(self, agent: str) -> str:
        return f"{agent}@square"

    def agent_at(self, address: str) -> str | None:
        name, _, rest = address.partition("@")
        return name if name in self.square.team and rest.partition("/")[0] == "square" else None

    def is_address(self, text: str) -> bool:
        return "@" in text

    def name_at(self, address: str) -> str:
        return address.partition("/")[0]

    def here(self) -> dict[str, str]:
        return dict(self.mine)

    def send(self, sender: str, address: str, headers: Headers, body: str, *, kept: bool) -> None:
        self.square.say(self.mine[sender], address, headers, body)

    def meet(self, address: str) -> None:
        pass

    def close(self) -> None:
        for address in self.mine.values():
            self.square.sites.pop(address, None)
