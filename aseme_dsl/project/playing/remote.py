"""Remote: a team's robots as its operator reaches them over their network, with a key."""

from __future__ import annotations

import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.project.settings.configuration import Configuration
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from aseme_dsl.runtime.control.operator_key import Key
    from aseme_dsl.runtime.control.replies import Reply
    from aseme_dsl.runtime.transport.over_zenoh import ZenohLink

_PAUSE = 0.05


class RemoteError(Exception):
    """Robots cannot be reached over their network; the text says why."""


@dataclass(frozen=True, eq=False, slots=True)
class Robot:
    """A robot, as far as an operator is concerned."""

    name: str
    system: str
    key: Key
    _link: ZenohLink

    def __str__(self) -> str:
        return self.name

    def ask(self, request: dict[str, object], timeout: float) -> Reply:
        """Its reply, if it proves that it knows the key. Raises RemoteError if there is none."""
        from aseme_dsl.runtime.control.operator_gate import GateError, ask
        from aseme_dsl.runtime.transport import TransportError

        deadline = time.monotonic() + timeout

        def send(data: bytes) -> Iterable[bytes]:
            while True:  # a connection may be on its way
                left = deadline - time.monotonic()
                found = self._link.ask(self.name, "control", data, max(left, _PAUSE))
                if found or left <= 0:
                    return [payload for _, payload in found]
                time.sleep(_PAUSE)

        try:
            return ask(send, self.system, self.name, self.key, request)
        except (GateError, TransportError) as problem:
            raise RemoteError(str(problem)) from problem


@contextmanager
def robots_of(
    system: str, team: Iterable[str], configuration: Configuration, keys: Path
) -> Iterator[tuple[Robot, ...]]:
    """The robots of a team, which are there or not; inside, they can be asked.

    `keys` is a file of keys, of which the last one is used.

    Raises:
        RemoteError: it cannot be used, or the network cannot.
    """
    from aseme_dsl.project.settings.deployment import network_of
    from aseme_dsl.runtime.control.operator_key import KeyFileError, newest_key
    from aseme_dsl.runtime.transport import TransportError
    from aseme_dsl.runtime.transport.access import OPERATOR
    from aseme_dsl.runtime.transport.over_zenoh import ZenohLink

    names = tuple(team)
    try:
        key = newest_key(keys)
        link = ZenohLink(system, network_of(configuration.deploy, OPERATOR, names))
        link.visit(OPERATOR)
    except (KeyFileError, TransportError) as problem:
        raise RemoteError(str(problem)) from problem
    try:
        yield tuple(Robot(name, system, key, link) for name in names)
    finally:
        link.close()
