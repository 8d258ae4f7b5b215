"""Hosts over ssh: copying a bundle, and running the installer there with Python's standard library.

The system's `ssh` and `scp` are called with lists of arguments. What the shell on the host reads is quoted,
and consists of names that were checked before.
"""

from __future__ import annotations

import re
import shlex
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

from aseme_dsl.project.deploying import install
from aseme_dsl.project.deploying.bundle import Bundle
from aseme_dsl.records import dataclass

DESTINATION = re.compile(r"(?:[A-Za-z_][\w.-]*@)?[A-Za-z0-9][\w.:-]*")
"""What may be given to ssh as a host: it cannot be taken for an option."""
_SECONDS = 900


class RemoteError(Exception):
    """A host cannot be reached, or refuses; the text says why."""


@dataclass(frozen=True, slots=True)
class Host:
    """A host, the folder of the team there, and the agents that run on it."""

    destination: str
    folder: str
    agents: tuple[str, ...]

    def deploy(self, bundle: Bundle, private: bytes, start: bool, keep: int = install.KEEP) -> str:
        """Copy, unpack and activate a bundle; what the installer says. Raises RemoteError."""
        incoming = self._run("prepare", "--to", self.folder).strip()
        with tempfile.TemporaryDirectory() as here:
            archive, secret = Path(here) / bundle.name, Path(here) / "private.tar"
            archive.write_bytes(bundle.archive)
            secret.touch(0o600)
            secret.write_bytes(private)
            user, at, host = self.destination.rpartition("@")
            place = f"{user}{at}[{host}]" if ":" in host else self.destination  # an IPv6 address
            _call(["scp", "-q", "-p", "-B", "--", str(archive), str(secret), f"{place}:{incoming}/"])
        words = ["install", f"{incoming}/{bundle.name}", "--to", self.folder]
        words += ["--private", f"{incoming}/private.tar", "--keep", str(keep)]
        return self._run(*words, *self._started(start))

    def rollback(self, start: bool) -> str:
        """Activate the version before; what the installer says. Raises RemoteError."""
        return self._run("rollback", "--to", self.folder, *self._started(start))

    def _started(self, start: bool) -> list[str]:
        return [word for agent in self.agents for word in ("--start", agent)] if start else []

    def _run(self, *words: str) -> str:
        command = shlex.join(["python3", "-", *words])
        script = Path(install.__file__).read_bytes()
        return _call(["ssh", "-o", "BatchMode=yes", "--", self.destination, command], script)


def _call(command: Sequence[str], given: bytes = b"") -> str:
    try:
        done = subprocess.run(command, input=given, capture_output=True, timeout=_SECONDS)
    except FileNotFoundError:
        raise RemoteError(f"`{command[0]}` is not installed") from None
    except subprocess.TimeoutExpired:
        raise RemoteError(f"`{command[0]}` has not ended within {_SECONDS} s") from None
    if done.returncode != 0:
        said = done.stderr.decode("utf-8", "replace").strip().splitlines()
        raise RemoteError((said or [f"`{command[0]}` ended with exit code {done.returncode}"])[-1])
    return done.stdout.decode("utf-8", "replace")
