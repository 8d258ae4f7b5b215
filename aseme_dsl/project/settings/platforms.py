"""Platforms: what carries messages between the agents of a team, and what a project says about it.

`in_process` is this process; Zenoh is between the robots of a team alone; over SPADE and mango agents of
others take part, too.
"""

from __future__ import annotations

import contextlib
import os
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TYPE_CHECKING, TypedDict

from aseme_dsl.project.settings.platform_settings import (
    IN_PROCESS,
    MANGO,
    SPADE,
    ZENOH,
    SpadeConfiguration,
)
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    import subprocess

    from aseme_dsl.project.settings.configuration import Configuration
    from aseme_dsl.runtime.transport.link import Link
    from aseme_dsl.runtime.transport.settings import Xmpp
    from aseme_dsl.runtime.version.loading import Loaded

_here: ContextVar[str | None] = ContextVar("provided", default=None)
"""What `provided` gives here; the environment is the whole process's, and not changed."""
GIVEN = "ASEMEC_PLATFORM"
"""The environment variable that tells robots what their supervisor has started for them, as JSON."""
XMPP_PORT = 5222
START = 60.0
"""How long, in seconds, the embedded server may take to be there."""

Say = Callable[[str], None]


class PlatformError(Exception):
    """A platform cannot be used like that; the text says why."""


def link_of(platform: str, loaded: Loaded, configuration: Configuration, here: Sequence[str]) -> Link:
    """The link over a platform for some agents of a team; that of the rest of the team is elsewhere.

    Raises:
        PlatformError: the project does not say what is needed.
        TransportError: the platform is not installed, or its settings do not fit.
    """
    team = [name for name, _ in loaded.team] or list(here)
    return BETWEEN_PROCESSES[platform].link(loaded.name, team, configuration, here)


def check_installed(platform: str) -> None:
    """Raises TransportError, saying how to install it, if what a platform needs is missing."""
    if platform != IN_PROCESS:
        BETWEEN_PROCESSES[platform].check()


def _check_zenoh() -> None:
    from aseme_dsl.runtime.transport.over_zenoh import import_zenoh

    import_zenoh()


def _over_zenoh(system: str, team: Sequence[str], configuration: Configuration, here: Sequence[str]) -> Link:
    from aseme_dsl.project.settings.deployment import network_of
    from aseme_dsl.runtime.transport.over_zenoh import ZenohLink

    return ZenohLink(system, network_of(configuration.deploy, here[0], team))


def _check_spade() -> None:
    from aseme_dsl.runtime.platform.over_spade import import_spade

    import_spade()


def _over_spade(system: str, team: Sequence[str], configuration: Configuration, here: Sequence[str]) -> Link:
    from aseme_dsl.runtime.platform.over_platform import PlatformLink
    from aseme_dsl.runtime.platform.over_spade import SpadePlatform

    return PlatformLink(SpadePlatform(_xmpp(configuration), team), system, team)


def _check_mango() -> None:
    from aseme_dsl.runtime.platform.over_mango import import_mango

    import_mango()


def _over_mango(system: str, team: Sequence[str], configuration: Configuration, here: Sequence[str]) -> Link:
    from aseme_dsl.runtime.platform.over_mango import MangoPlatform
    from aseme_dsl.runtime.platform.over_platform import PlatformLink
    from aseme_dsl.runtime.transport.settings import Mango

    is_whole = len(team) <= len(here)
    hosts = {} if is_whole and configuration.mango is None else _mango_hosts(configuration)
    unknown = [name for name in team if name not in hosts and not is_whole]
    if unknown:
        raise PlatformError(
            f"no agent would find {unknown[0]}: say in [tool.asemec.mango] hosts where it listens"
        )
    return PlatformLink(MangoPlatform(Mango(hosts), team), system, team)


@dataclass(frozen=True, slots=True)
class _BetweenProcesses:
    """A platform that carries messages to other processes."""

    link: Callable[[str, Sequence[str], Configuration, Sequence[str]], Link]
    """Of a system, its team, the configuration, and the agents that are here. Raises what `link_of` does."""
    check: Callable[[], None]
    """Raises TransportError if something is not installed."""


BETWEEN_PROCESSES = {
    ZENOH: _BetweenProcesses(_over_zenoh, _check_zenoh),
    SPADE: _BetweenProcesses(_over_spade, _check_spade),
    MANGO: _BetweenProcesses(_over_mango, _check_mango),
}
"""Every platform but the one that is within a process."""


def _xmpp(configuration: Configuration) -> Xmpp:
    from aseme_dsl.runtime.transport.settings import ROBOT, Xmpp

    said = configuration.spade or SpadeConfiguration()
    account = said.account or ROBOT
    given = _given()
    if said.host is None:
        if "spade" not in given:
            raise PlatformError(
                "no XMPP server is known: name it in [tool.asemec.spade] of the pyproject.toml (host,"
                " password), or start the team with `asemec run --platform spade`, which brings one"
            )
        port, password = given["spade"]
        return Xmpp(port=port, account=account, password=password, register=True, verify=False)
    if said.password is None:
        raise PlatformError(
            f"[tool.asemec.spade] names the XMPP server {said.host}, and no file with a `password`"
        )
    return Xmpp(
        said.host,
        said.port or XMPP_PORT,
        said.domain or said.host,
        account,
        said.password,
        said.register,
        said.verify,
        said.authority,
    )


def _mango_hosts(configuration: Configuration) -> dict[str, tuple[str, int]]:
    said = configuration.mango.hosts if configuration.mango is not None else _given().get("mango", {})
    found: dict[str, tuple[str, int]] = {}
    for name, text in said.items():
        host, _, port = text.rpartition(":")
        found[name] = (host, int(port))
    return found


class _Given(TypedDict, total=False):
    """What a run has for its platform: a server for SPADE, the addresses of the agents for mango."""

    spade: tuple[int, str]
    """Port and password of the XMPP server of the run."""
    mango: dict[str, str]


def _given() -> _Given:
    import json

    found: _Given = json.loads(_here.get() or os.environ.get(GIVEN, "{}"))
    return found


def given_environment() -> dict[str, str]:
    """What the environment of a robot's process has to have besides: what `provided` gives."""
    given = _here.get()
    return {} if given is None else {GIVEN: given}


@contextmanager
def provided(platform: str, loaded: Loaded, configuration: Configuration, say: Say) -> Iterator[None]:
    """Inside, runs of this thread have what the platform needs and the project does not name, and so do
    processes that are started with `given_environment`.

    That is, for SPADE, a server of this run on the loopback interface; for mango, a port for each agent.

    Raises:
        PlatformError: it cannot be started.
    """
    import json
    import secrets

    given: _Given = {}
    server: EmbeddedServer | None = None
    if platform == SPADE and (configuration.spade is None or configuration.spade.host is None):
        port = configuration.spade.port if configuration.spade is not None else None
        server = EmbeddedServer(port or 0, say)
        given["spade"] = (server.port, secrets.token_hex(16))
    elif platform == MANGO and configuration.mango is None:
        given["mango"] = {name: f"127.0.0.1:{port}" for (name, _), port in _ports(loaded)}
    before = _here.set(json.dumps(given))
    try:
        yield
    finally:
        _here.reset(before)
        if server is not None:
            server.close()


def _ports(loaded: Loaded) -> Iterator[tuple[tuple[str, str], int]]:
    """A port for each agent that was free a moment ago."""
    import socket

    taken = [socket.create_server(("127.0.0.1", 0)) for _ in loaded.team]
    found = [item.getsockname()[1] for item in taken]
    for item in taken:
        item.close()
    return zip(loaded.team, found, strict=True)


class EmbeddedServer:
    """The XMPP server that SPADE brings, as a process that is started again where it was if it dies."""

    def __init__(self, port: int, say: Say) -> None:
        """Raises PlatformError if it does not start. The port 0 is any free one."""
        self._say = say
        self._closing = False
        self._process = self._start(port)
        self.port = port = self._listening()
        say(f"the embedded XMPP server listens on localhost:{port}")
        self._thread = threading.Thread(target=self._watch, name="aseme server", daemon=True)
        self._thread.start()

    def _start(self, port: int) -> subprocess.Popen[str]:
        import subprocess

        command = [sys.executable, "-m", "aseme_dsl.runtime.platform.embedded_server", str(port)]
        return subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            start_new_session=True,  # Ctrl-C is for us
        )

    def _listening(self) -> int:
        """The port, when it is ready. Raises PlatformError."""
        from aseme_dsl.runtime.platform.embedded_server import LISTENING

        process = self._process
        timer = threading.Timer(START, process.kill)
        timer.start()
        try:
            assert process.stdout is not None
            line = process.stdout.readline()
        finally:
            timer.cancel()
        if not line.startswith(LISTENING):
            self._end()
            raise PlatformError("the embedded XMPP server does not start")
        return int(line.removeprefix(LISTENING))

    def _watch(self) -> None:
        while True:
            self._process.wait()
            if self._closing:
                return
            self._say("the embedded XMPP server has ended; it is started again")
            self._end()
            self._process = self._start(self.port)
            try:
                self._listening()
            except PlatformError as problem:
                self._say(str(problem))
                return

    def _end(self) -> None:
        import subprocess

        process = self._process
        for stream in (process.stdin, process.stdout):
            if stream is not None:
                with contextlib.suppress(OSError):
                    stream.close()
        try:
            process.wait(5.0)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()

    def close(self) -> None:
        """End it."""
        self._closing = True
        self._end()
        self._thread.join(START)
