"""Notifying: what the service manager of a machine (systemd) is notified of, as sd_notify(3) describes it."""

from __future__ import annotations

import contextlib
import os
import socket
from collections.abc import MutableMapping

from aseme_dsl.project.operating.health import Health

LONGEST = 200
"""A status has at most so many characters."""


class Notifier:
    """Notifies the service manager, if there is one. Never waits and never fails."""

    def __init__(self, environment: MutableMapping[str, str] | None = None) -> None:
        """Take what the environment says of the service manager: other processes are not to use it."""
        found = os.environ if environment is None else environment
        self._address = _address(found.pop("NOTIFY_SOCKET", ""))
        usec, pid = found.pop("WATCHDOG_USEC", ""), found.pop("WATCHDOG_PID", "")
        ours = pid in ("", str(os.getpid()))
        self.watchdog = int(usec) / 1e6 if ours and usec.isascii() and usec.isdigit() and int(usec) else None
        """After how many seconds without a ping we are restarted; None: never."""
        self._ready = False
        self._status = ""

    @property
    def is_wanted(self) -> bool:
        """Whether there is a service manager."""
        return self._address is not None

    def see(self, health: Health) -> None:
        """Notify of what is new, and that we are alive if we are."""
        lines = []
        if health.begun and not self._ready:
            self._ready = True
            lines.append("READY=1")
        status = "; ".join((*health.reasons(), *health.notes)) or "ready"
        if status != self._status:
            self._status = status
            lines.append(f"STATUS={_line(status)}")
        if self.watchdog is not None and health.is_alive:
            lines.append("WATCHDOG=1")
        if lines:
            self.send("\n".join(lines))

    def stopping(self) -> None:
        """Notify of the end."""
        self.send("STOPPING=1")

    def send(self, text: str) -> None:
        """Send lines; what cannot be sent at once is left out."""
        if self._address is None:
            return
        with contextlib.suppress(OSError), socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as connection:
            connection.setblocking(False)
            connection.sendto(text.encode("utf-8", "replace"), self._address)


def _address(text: str) -> str | None:
    """The address of a Unix socket, which may be an abstract one; None if it is none, or there are none."""
    if not hasattr(socket, "AF_UNIX") or not text or "\0" in text:
        return None
    if text.startswith("@"):
        return f"\0{text[1:]}"
    return text if text.startswith("/") else None


def _line(text: str) -> str:
    plain = "".join(letter if letter.isprintable() else " " for letter in text)
    return plain if len(plain) <= LONGEST else f"{plain[: LONGEST - 1]}…"


__all__ = ["Notifier"]
