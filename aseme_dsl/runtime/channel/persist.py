"""Kept states: what `persist` channels said last, in one JSON file per agent.

If the process or the machine stops, a file is either the old one or the new one. It is written beside,
brought to the disk (fsync), and then renamed (with fsync of the folder). It is written outside of the agents'
steps. In real time a thread writes at once, and again only after a pause, in which newer states replace older
ones. What was said since then is lost with the process.
"""

from __future__ import annotations

import io
import json
import os
import threading
from collections.abc import Callable, Mapping
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.runtime.message.as_json import from_json, to_json

PAUSE = 0.05
"""How long, in seconds, at least passes between two writings: a disk stands only so many."""
AGAIN = 0.25
"""After how many seconds what could not be written is tried again."""


class Kept:
    """The files of a state directory."""

    def __init__(self, directory: Path) -> None:
        self._directory = directory
        self._states: dict[str, dict[tuple[str, str | None], object]] = {}
        self._changed: set[str] = set()
        self._told: dict[str, str] = {}
        self._saving = threading.Lock()
        self._news = threading.Event()
        self._over = threading.Event()
        self._writer: threading.Thread | None = None

    def begin(self, failed: Callable[[str, str], None]) -> None:
        """Write from now on what changes, in a thread of its own; `failed` is called with (agent, reason)."""

        def work() -> None:
            while not self._over.is_set():
                self._news.wait(AGAIN if self._changed else None)
                self._news.clear()
                for agent, reason in self.save():
                    failed(agent, reason)
                self._over.wait(PAUSE)

        self._writer = threading.Thread(target=work, name="aseme kept states", daemon=True)
        self._writer.start()

    def end(self, seconds: float) -> None:
        """Write no more by itself; wait for what is being written, so long at the most."""
        self._over.set()
        self._news.set()
        if self._writer is not None:
            self._writer.join(seconds)

    def put(self, agent: str, channel: str, host: str | None, message: object) -> str | None:
        """Note what an agent said last; the reason why it cannot be kept, or None."""
        try:
            value = to_json(message)
        except TypeError as error:
            return f"the state {channel} is not kept: {error}"
        self._states.setdefault(agent, {})[channel, host] = value
        self._changed.add(agent)
        self._news.set()
        return None

    def save(self) -> list[tuple[str, str]]:
        """Write what has changed; for each agent where that failed, why.

        What could not be written is tried again; the same reason is given once.
        """
        with self._saving:
            return self._save()

    def _save(self) -> list[tuple[str, str]]:
        failed: list[tuple[str, str]] = []
        again: set[str] = set()
        while self._changed:
            agent = min(self._changed)
            self._changed.discard(agent)
            path = self._path(agent)
            part = path.with_name(path.name + ".part")
            states = [
                {"channel": channel, "host": host, "message": value}
                for (channel, host), value in sorted(
                    # a copy: agents continue to publish while this is written
                    self._states[agent].copy().items(),
                    key=lambda item: (item[0][0], item[0][1] or ""),
                )
            ]
            try:
                self._directory.mkdir(parents=True, exist_ok=True)
                with io.TextIOWrapper(outside.new_file(part), "utf-8") as file:
                    json.dump({"format": 1, "agent": agent, "states": states}, file, indent=1)
                    file.write("\n")
                    file.flush()
                    os.fsync(file.fileno())
                part.replace(path)
                _settle(self._directory)
            except OSError as error:
                again.add(agent)
                reason = f"its states are not kept in {path}: {error.strerror or error}"
                if self._told.get(agent) != reason:
                    failed.append((agent, reason))
                    self._told[agent] = reason
            else:
                self._told.pop(agent, None)
        self._changed |= again
        return failed

    def load(
        self, agent: str, messages: Mapping[str, type[object]]
    ) -> tuple[list[tuple[str, str | None, object]], list[str]]:
        """What an agent published last as (channel, receiver, message), and what could not be read of it."""
        path = self._path(agent)
        try:
            text = outside.read_text(path)
        except FileNotFoundError:
            return [], []
        except (OSError, UnicodeDecodeError) as error:
            return [], [f"{path} cannot be read: {error}"]
        try:
            document = outside.loads(text)
            if not isinstance(document, dict):
                raise TypeError("it is not an object")
            states = document["states"]
            entries = [(str(s["channel"]), s["host"], s["message"]) for s in states]
        except (ValueError, KeyError, TypeError) as error:
            return [], [f"{path} is not a file of kept states: {error!r}"]
        found: list[tuple[str, str | None, object]] = []
        errors: list[str] = []
        for channel, host, value in entries:
            kind = messages.get(channel.rpartition(".")[2])
            try:
                if kind is None:
                    raise ValueError("there is no such message any more")
                message = from_json(kind, value)
            except ValueError as error:
                errors.append(f"the kept state {channel} is left out: {error}")
                continue
            self._states.setdefault(agent, {})[channel, host] = value
            found.append((channel, host, message))
        return found, errors

    def _path(self, agent: str) -> Path:
        return self._directory / f"{agent}.json"


def _settle(folder: Path) -> None:
    """Bring to the disk which files a folder has. Windows has no such call, and needs none."""
    if os.name == "nt":
        return
    number = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(number)
    finally:
        os.close(number)
