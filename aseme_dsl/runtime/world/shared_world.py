"""A simulated world in a process of its own, whose bodies agents in other processes drive.

Each robot's process has one connection for each of its bodies, on this machine, with a key that only the
team's processes know. Over it go the calls of the body's port, one answer each. So a call takes as long as
two processes need to hand something over: a fraction of a millisecond. The world's time is real: it follows
the clock that all processes of the machine share.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import secrets
import socket
import threading
import time
from collections.abc import Callable, Mapping
from multiprocessing import AuthenticationError
from multiprocessing.connection import Client, Connection, Listener, answer_challenge, deliver_challenge
from typing import cast

from aseme_dsl.runtime.time.clock import SECOND
from aseme_dsl.runtime.transport.meeting import private_folder
from aseme_dsl.runtime.transport.port import TransportError
from aseme_dsl.runtime.world.body import AnyBody, AnyWorld, BodyConnectionError, RadioMessage, fit_to_travel

PATIENCE = 5.0
"""How long, in seconds, a body may take to answer before it counts as lost."""
HURRY = 5
"""How many steps a world that is late makes at once before it lets others in."""

LOOPBACK = "127.0.0.1"

Doing = Mapping[str, tuple[tuple[str, ...], ...]]
"""What each agent is doing: its active states, region by region."""


def _place() -> str:
    """Where a world of this process listens; what worlds that were killed have left there goes.

    Raises:
        OSError: there is no folder of the user's own for it.
    """
    try:
        folder = private_folder("worlds")
    except TransportError as error:
        raise OSError(str(error)) from error
    for path in folder.glob("*.sock"):
        if not _is_alive(path.name.partition("-")[0]):
            path.unlink(missing_ok=True)
    return str(folder / f"{os.getpid()}-{secrets.token_hex(4)}.sock")


def _is_alive(process: str) -> bool:
    try:
        os.kill(int(process), 0)
    except (ValueError, ProcessLookupError, PermissionError):  # gone; or another user has its number now
        return False
    return True


def _listener() -> Listener:
    """Where bodies are asked for: a socket of the user's own or, where there are none, one of this machine.

    Raises:
        OSError: there is none.
    """
    if hasattr(socket, "AF_UNIX"):
        return Listener(_place(), "AF_UNIX")
    return Listener((LOOPBACK, 0), "AF_INET")


def _address(text: str) -> str | tuple[str, int]:
    host, colon, port = text.rpartition(":")
    return (host, int(port)) if colon and host == LOOPBACK and port.isdecimal() else text


class WorldServer:
    """Lets a world pass in real time, and lends its bodies to other processes."""

    def __init__(self, world: AnyWorld, key: bytes) -> None:
        """Raises OSError if no process could connect."""
        self.world = world
        self.doing: dict[str, tuple[tuple[str, ...], ...]] = {}
        """What the agents have told last of what they are doing."""
        self._key = key
        # Without a key: who does not answer must not keep others waiting.
        self._listener = _listener()
        at = self._listener.address
        self.address = at if isinstance(at, str) else f"{at[0]}:{at[1]}"
        """Where the bodies are: for `FarBody`."""
        self._lock = threading.Lock()
        threading.Thread(target=self._accept, name="aseme world", daemon=True).start()

    def run(self, origin: int, stop: Callable[[], bool]) -> None:
        """Let the world pass until `stop` says so; it is asked after every few steps.

        `origin` is when the world began, in ns of the machine's monotonic clock.
        """
        world = self.world
        while not stop():
            now = time.monotonic_ns() - origin
            due = world.now_ns + world.step_ns
            if now < due:
                time.sleep((due - now) / SECOND)
                continue
            with self._lock:
                world.advance(min(now, world.now_ns + HURRY * world.step_ns))

    def close(self) -> None:
        """Take the bodies away: who has one loses it."""
        with contextlib.suppress(OSError):
            self._listener.close()

    def _accept(self) -> None:
        while True:
            try:
                connection = self._listener.accept()
            except ConnectionError:
                continue  # the other end hung up
            except OSError:
                return
            threading.Thread(target=self._serve, args=(connection,), daemon=True).start()

    def _serve(self, connection: Connection[object, object]) -> None:
        with contextlib.suppress(OSError, EOFError, AuthenticationError), connection:
            deliver_challenge(connection, self._key)
            answer_challenge(connection, self._key)
            name = cast(str, connection.recv())
            body = self.world.bodies.get(name)
            if body is None:
                connection.send(("raise", BodyConnectionError(f"the world has no body called {name}")))
                return
            connection.send(("give", body.payload_limit))
            while True:
                what, argument = cast("tuple[str, object]", connection.recv())
                connection.send(self._call(name, body, what, argument))

    def _call(self, name: str, body: AnyBody, what: str, argument: object) -> tuple[str, object]:
        try:
            with self._lock:
                match what:
                    case "sense":
                        answer: object = body.sense()
                    case "act":
                        answer = None
                        body.act(argument)
                    case "say" if isinstance(argument, bytes):
                        answer = body.say(argument)
                    case "hear":
                        answer = body.hear()
                    case "doing" if isinstance(argument, tuple):
                        self.doing[name] = argument
                        answer = None
                    case _:
                        raise TypeError(f"{what} does not take {type(argument).__name__}")
            pickle.dumps(answer)
        except Exception as error:
            return "raise", fit_to_travel(error)
        return "give", answer


class FarBody:
    """A body in the world of another process. One call at a time is made; others wait for their turn."""

    def __init__(self, name: str, address: str, key: bytes) -> None:
        """Raises BodyConnectionError if there is no such world, or it has no such body."""
        self.name = name
        self._lock = threading.Lock()
        self._lost: str | None = None
        try:
            self._connection = Client(_address(address), authkey=key)
            self._connection.send(name)
            limit = self._answer()
            assert isinstance(limit, int)  # the first answer of a world
            self.payload_limit = limit
        except BodyConnectionError:
            raise
        except Exception as problem:  # OSError, EOFError, AuthenticationError
            raise BodyConnectionError(f"the world cannot be reached: {_text(problem)}") from problem

    def sense(self) -> object:
        """The newest percept."""
        return self._ask("sense")

    def act(self, command: object) -> None:
        """Put a command in force."""
        self._ask("act", command)

    def say(self, payload: bytes) -> bool:
        """Send a message by radio; whether the radio took it."""
        return bool(self._ask("say", payload))

    def hear(self) -> list[RadioMessage]:
        """What arrived since the last call."""
        found = self._ask("hear")
        assert isinstance(found, list)  # as every body gives it
        return found

    def tell(self, doing: tuple[tuple[str, ...], ...]) -> None:
        """Tell the world what the agent is doing, for those who watch."""
        self._ask("doing", doing)

    def close(self) -> None:
        """Give the body back."""
        self._lost = self._lost or "it was given back"
        with contextlib.suppress(OSError):
            self._connection.close()

    def _ask(self, what: str, argument: object = None) -> object:
        with self._lock:
            if self._lost is not None:
                raise BodyConnectionError(self._lost)
            try:
                self._connection.send((what, argument))
                return self._answer()
            except (OSError, EOFError) as problem:
                if isinstance(problem, BodyConnectionError) and self._lost is None:
                    raise  # the body says so itself
                self._lost = self._lost or f"the world has ended: {_text(problem)}"
                raise BodyConnectionError(self._lost) from problem

    def _answer(self) -> object:
        if not self._connection.poll(PATIENCE):
            self._lost = f"the world has not answered for {PATIENCE:g} s"
            raise BodyConnectionError(self._lost)
        how, answer = self._connection.recv()
        if how == "raise":
            raise answer
        return answer


def _text(problem: BaseException) -> str:
    return getattr(problem, "strerror", None) or str(problem) or type(problem).__name__
