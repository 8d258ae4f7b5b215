"""Robots on machines of their own, with a switch between them (`switch.py`) that does what a test wants."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import psutil
import pytest

from tests.support.waiting import LONG

ROOT = Path(__file__).resolve().parents[2]
FIRST = ["nice", "-n", "-15"] if os.environ.get("NETWORK_RUNS") else []
"""What is measured has priority over what else the machine does."""


@dataclass(slots=True)
class Machines:
    """Machines by name, and the switch between them."""

    switch: subprocess.Popen[str]
    addresses: dict[str, list[str]]
    holders: dict[str, int]
    started: list[psutil.Popen] = field(default_factory=list)

    def between(self, a: str, b: str, **faults: float | bool) -> None:
        """What goes wrong from now on in both directions: the members of `switch.Way`."""
        self.towards(a, b, **faults)
        self.towards(b, a, **faults)

    def towards(self, a: str, b: str, **faults: float | bool) -> None:
        """What goes wrong from now on with what `a` sends to `b`."""
        self._tell({"from": a, "to": b, **faults})

    def around(self, one: str, **faults: float | bool) -> None:
        """What goes wrong between a machine and all others."""
        for other in self.addresses:
            if other != one:
                self.between(one, other, **faults)

    def counts(self) -> dict[str, list[int]]:
        """The frames of each direction (`a b`): brought, lost."""
        return self._tell({"count": True})

    def _tell(self, command: dict[str, object]) -> dict[str, Any]:
        assert self.switch.stdin is not None and self.switch.stdout is not None
        print(json.dumps(command), file=self.switch.stdin, flush=True)
        answer: dict[str, Any] = json.loads(self.switch.stdout.readline())
        assert "error" not in answer, answer
        return answer

    def start(
        self,
        machine: str,
        *command: str,
        cwd: Path | None = None,
        stdin: int | None = None,
        **environment: str,
    ) -> psutil.Popen:
        """Start a program on a machine; it is killed at the end."""
        process = psutil.Popen(
            [*FIRST, "nsenter", f"--net=/proc/{self.holders[machine]}/ns/net", *command],
            cwd=cwd,
            stdin=stdin,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env={**os.environ, "PYTHONPATH": str(ROOT), "PYTHONUNBUFFERED": "1", **environment},
        )
        self.started.append(process)
        return process

    def run(self, machine: str, *command: str) -> str:
        """Run a program on a machine; gives what it says."""
        said, _ = self.start(machine, *command).communicate(timeout=LONG)
        return str(said)


@contextmanager
def machines(names: Sequence[str], seed: int = 1) -> Iterator[Machines]:
    """Machines that reach each other and nothing else. Skips, loudly, where they cannot be made."""
    missing = [one for one in ("unshare", "nsenter", "ip") if shutil.which(one) is None]
    if missing:
        pytest.skip(f"NOT TESTED: a test network needs {', '.join(missing)} (util-linux, iproute2)")
    if os.geteuid() != 0:
        pytest.skip("NOT TESTED: only root can make a test network")
    addresses = {name: [f"10.99.0.{number}", f"fd99::{number:x}"] for number, name in enumerate(names, 1)}
    switch = subprocess.Popen(
        [
            *FIRST,
            sys.executable,
            str(Path(__file__).with_name("switch.py")),
            str(seed),
            *(f"{name}={four}/24,{six}/64" for name, (four, six) in addresses.items()),
        ],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert switch.stdin is not None and switch.stdout is not None and switch.stderr is not None
    said = switch.stdout.readline()
    if not said:
        pytest.skip(f"NOT TESTED: no test network can be made here: {switch.stderr.read().strip()[-300:]}")
    found = Machines(switch, addresses, json.loads(said))
    try:
        yield found
    finally:
        for process in found.started:
            with contextlib.suppress(psutil.Error):
                process.kill()
            process.wait()
        switch.stdin.close()
        switch.wait(LONG)
        switch.stdout.close()
        switch.stderr.close()
