"""XMPP servers of a test's own, on the loopback interface: the one that SPADE brings, and Prosody."""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

from aseme_dsl.runtime.transport.settings import Xmpp
from tests.support.network import own_port
from tests.support.waiting import LONG

PROSODY = """\
pidfile = "{folder}/prosody.pid"
data_path = "{folder}/data"
certificates = "{folder}"
log = {{ warn = "{folder}/log" }}
run_as_root = true
interfaces = {{ "127.0.0.1" }}
c2s_ports = {{ {port} }}
s2s_ports = {{ }}
modules_enabled = {{ "roster", "saslauth", "tls", "disco", "ping", "offline", "register_ibr" }}
modules_disabled = {{ "s2s" }}
allow_registration = true
authentication = "internal_hashed"
c2s_require_encryption = true
ssl = {{ key = "{folder}/localhost.key", certificate = "{folder}/localhost.crt" }}
VirtualHost "localhost"
"""


@dataclass
class Server:
    """A server that can be stopped, killed and started again, at the same place."""

    kind: str
    folder: Path = field(default_factory=lambda: Path(tempfile.mkdtemp(prefix="aseme-xmpp-")))
    port: int = 0
    process: subprocess.Popen[str] | None = None
    held: contextlib.ExitStack = field(default_factory=contextlib.ExitStack)
    """The port, also while the server is stopped."""

    def settings(self, **further: object) -> Xmpp:
        """How agents reach it."""
        known: dict[str, object] = {"password": "secret", "register": True, "verify": False, **further}
        return Xmpp(port=self.port, **known)  # type: ignore[arg-type]

    def start(self) -> Server:
        """Start it, and wait until it is there."""
        self.port = self.port or self.held.enter_context(own_port())
        if self.kind == "prosody":
            self._configure()
            command = ["prosody", "--config", str(self.folder / "prosody.cfg.lua"), "-F"]
        else:
            command = [sys.executable, "-m", "aseme_dsl.runtime.platform.embedded_server", str(self.port)]
        with (self.folder / "errors").open("a") as errors:
            self.process = subprocess.Popen(
                command,
                stdin=subprocess.PIPE,
                stdout=subprocess.DEVNULL,
                stderr=errors,
                text=True,
                start_new_session=True,
            )
        until = time.monotonic() + LONG
        while True:
            with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", self.port), 0.5):
                return self
            assert self.process.poll() is None, (self.folder / "errors").read_text()
            assert time.monotonic() < until, f"{self.kind} does not start"
            time.sleep(0.05)

    def _configure(self) -> None:
        for name in ("data",):
            (self.folder / name).mkdir(exist_ok=True)
        if not (self.folder / "localhost.crt").exists():
            subprocess.run(
                [
                    *("openssl", "req", "-new", "-x509", "-days", "3", "-nodes", "-newkey", "rsa:2048"),
                    *("-out", "localhost.crt", "-keyout", "localhost.key", "-subj", "/CN=localhost"),
                    *("-addext", "subjectAltName=DNS:localhost"),
                ],
                cwd=self.folder,
                check=True,
                capture_output=True,
            )
        text = PROSODY.format(folder=self.folder, port=self.port)
        (self.folder / "prosody.cfg.lua").write_text(text)

    def stop(self, how: signal.Signals = signal.SIGTERM) -> None:
        """End it, at once with SIGKILL; whoever has its port has gone afterwards."""
        process, self.process = self.process, None
        if process is None:
            return
        process.send_signal(how)
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait(5)
        if process.stdin is not None:
            process.stdin.close()

    def freeze(self) -> None:
        """It does nothing any more, and holds all connections."""
        assert self.process is not None
        os.killpg(self.process.pid, signal.SIGSTOP)

    def thaw(self) -> None:
        """It goes on."""
        assert self.process is not None
        os.killpg(self.process.pid, signal.SIGCONT)

    def log(self) -> str:
        """What it has complained of."""
        return "".join(
            path.read_text() for name in ("errors", "log") if (path := self.folder / name).exists()
        )

    def close(self) -> None:
        """End it, and leave nothing."""
        with contextlib.suppress(ProcessLookupError):
            if self.process is not None:
                os.killpg(self.process.pid, signal.SIGCONT)
        self.stop()
        self.held.close()
        shutil.rmtree(self.folder, ignore_errors=True)
