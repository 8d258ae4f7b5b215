"""A world in one process and bodies in others."""

from __future__ import annotations

import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime.transport.meeting import private_folder
from aseme_dsl.runtime.world.body import BodyConnectionError, RadioMessage
from aseme_dsl.runtime.world.shared_world import FarBody, WorldServer
from aseme_dsl.worlds.field.match import Match
from aseme_dsl.worlds.field.team import team_sheet
from tests.support.waiting import wait_until

KEY = b"only for us"


@pytest.fixture
def match() -> Match:
    return Match(1, home=team_sheet(1, "Us", ("one", "two"), goalie="three"))


@pytest.fixture
def server(match: Match) -> Iterator[WorldServer]:
    found = WorldServer(match, KEY)
    yield found
    found.close()


def test_a_body_far_away_is_a_body(match: Match, server: WorldServer) -> None:
    one, two = (FarBody(name, server.address, KEY) for name in ("one", "two"))
    over = threading.Event()
    running = threading.Thread(target=server.run, args=(time.monotonic_ns(), over.is_set))
    running.start()
    assert one.payload_limit == match.bodies["one"].payload_limit
    assert one.say(b"hello")

    def hear() -> list[RadioMessage]:
        one.say(b"hello")
        return two.hear()

    heard = wait_until(hear)
    over.set()
    running.join()
    assert heard[0].payload == b"hello"
    assert one.sense() == match.bodies["one"].sense()
    with pytest.raises(ValueError, match="the radio takes"):
        one.say(bytes(1000))
    one.tell((("Walk",),))
    assert server.doing == {"one": (("Walk",),)}
    one.close()
    two.close()


def test_a_world_that_ends_takes_its_bodies_with_it(match: Match) -> None:
    server = WorldServer(match, KEY)
    body = FarBody("one", server.address, KEY)
    server.close()
    with pytest.raises(BodyConnectionError):
        FarBody("one", server.address, KEY)
    body.close()
    with pytest.raises(BodyConnectionError, match="given back"):
        body.sense()


def test_who_has_no_key_gets_no_body(server: WorldServer) -> None:
    with pytest.raises(BodyConnectionError, match="cannot be reached"):
        FarBody("one", server.address, b"another")
    FarBody("one", server.address, KEY).close()  # and the others are served


def test_who_says_nothing_keeps_nobody_waiting(server: WorldServer) -> None:
    with socket.socket(socket.AF_UNIX) as silent:
        silent.connect(server.address)
        FarBody("one", server.address, KEY).close()


def test_a_body_that_there_is_not(server: WorldServer) -> None:
    with pytest.raises(BodyConnectionError, match="no body called nobody"):
        FarBody("nobody", server.address, KEY)


def test_a_world_that_does_not_answer_is_lost(
    server: WorldServer, match: Match, monkeypatch: pytest.MonkeyPatch
) -> None:
    body: Any = FarBody("one", server.address, KEY)
    monkeypatch.setattr("aseme_dsl.runtime.world.shared_world.PATIENCE", 0.05)
    with server._lock, pytest.raises(BodyConnectionError, match="has not answered for"):
        body.sense()
    with pytest.raises(BodyConnectionError):
        body.sense()
    body.close()


def test_a_world_listens_in_a_folder_of_the_user_s_own(match: Match) -> None:
    folder = private_folder("worlds")
    ended = subprocess.Popen([sys.executable, "-c", ""])
    ended.wait()
    (folder / f"{ended.pid}-0.sock").touch()  # as a world that was killed leaves it
    server = WorldServer(match, KEY)
    place = Path(server.address)
    assert place.parent == folder
    assert folder.stat().st_mode & 0o777 == 0o700
    assert not (folder / f"{ended.pid}-0.sock").exists()
    assert place.exists()
    server.close()
    assert not place.exists()
