"""SPADE's own XMPP server, for one machine, in a process of its own (`python -m` this module).

SPADE's own way to start the server is unsafe for this purpose:

- It listens on the network, where any user can make accounts. Here it listens only on the loopback interface,
  on the given port.
- It serves pages on a fixed port. Here it serves none.
- It stores its keys in the folder of its package. Here the keys belong to one run.
- Its child processes outlive it and occupy its ports. Here it starts no processes.

The server ends when its standard input is closed.
"""

from __future__ import annotations

import asyncio
import os
import shutil
import signal
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

HOST = "localhost"
LISTENING = "listening "
"""What it says on its standard output when it is ready, followed by its port."""


class NotLoopback(Exception):
    """The server would be reachable from elsewhere."""


def main() -> int:
    """Serve until the standard input ends. The one argument is the port; 0 is any free one."""
    port = int(sys.argv[1]) if len(sys.argv) > 1 else 0
    threading.Thread(target=_end_with_input, daemon=True).start()
    with _keys() as folder:
        try:
            asyncio.run(_serve(port, folder))
        except (SystemExit, KeyboardInterrupt, asyncio.CancelledError):
            return 0
        except (OSError, NotLoopback) as problem:
            sys.stderr.write(f"the embedded XMPP server does not start: {problem}\n")
            return 1
    return 0


@contextmanager
def _keys() -> Iterator[Path]:
    """A folder of our own with what the certificate is made of: its package may not be writable."""
    import pyjabber.network

    brought = Path(next(iter(pyjabber.network.__path__))) / "certs"
    with tempfile.TemporaryDirectory(prefix="aseme-xmpp-") as name:
        for file in ("ca_key.pem", "ca_cert.pem"):
            shutil.copy(brought / file, name)
        yield Path(name)


async def _serve(port: int, keys: Path) -> None:
    import loguru
    from pyjabber import server as pyjabber
    from pyjabber.server_parameters import Parameters

    loguru.logger.remove()
    loguru.logger.add(sys.stderr, level="ERROR", format="{message}")
    # Processes would outlive a server that is killed, and hold its ports.
    pyjabber.ProcessPoolExecutor = ThreadPoolExecutor
    # It would listen on the address by which this machine is known to others.
    pyjabber.setup_query_local_ip = lambda: None
    # It would serve pages on port 9090, on which any user could make and delete accounts.
    pyjabber.HttpServer = lambda pages: None
    _keep_what_comes_early()
    server = pyjabber.Server(
        Parameters(
            host=HOST,
            client_port=port,
            server_port=0,
            database_in_memory=True,
            cert_path=str(keys),
        )
    )
    serving = asyncio.create_task(server.start())
    ready = asyncio.create_task(server.ready.wait())
    await asyncio.wait({serving, ready}, return_when=asyncio.FIRST_COMPLETED)
    if not ready.done():
        raise OSError(f"port {port} of {HOST} cannot be used")
    names = [_name(item) for item in (server._client_listener, server._server_listener)]
    elsewhere = [address for addresses in names for address, _ in addresses if not _is_loopback(address)]
    if elsewhere:
        serving.cancel()
        raise NotLoopback(f"it would be reachable from elsewhere, at {elsewhere[0]}")
    sys.stdout.write(f"{LISTENING}{names[0][0][1]}\n")
    sys.stdout.flush()
    await serving


def _keep_what_comes_early() -> None:
    """When a stream begins anew, as it does after TLS and after the password, the server forgets the old one.

    It does that a moment later than the new one may have begun, and then waits for it for ever.
    """
    from pyjabber.network.parsers.XMLParser import XMLParser

    begin, end, forget = XMLParser.startElementNS, XMLParser.endElementNS, XMLParser.reset_stack

    def startElementNS(self: Any, name: Any, qname: Any, attributes: Any) -> None:
        if name[1] == "stream":
            self._stack.clear()
            self.is_new = True
        begin(self, name, qname, attributes)

    def endElementNS(self: Any, name: Any, qname: Any) -> None:
        self.is_new = False
        end(self, name, qname)

    def reset_stack(self: Any) -> None:
        if not self.is_new:
            forget(self)

    XMLParser.startElementNS, XMLParser.endElementNS = startElementNS, endElementNS
    XMLParser.reset_stack = reset_stack


def _name(listener: Any) -> list[tuple[str, int]]:
    return [item.getsockname()[:2] for item in listener.sockets]


def _is_loopback(address: str) -> bool:
    return address == "::1" or address.startswith("127.")


def _end_with_input() -> None:
    while os.read(0, 4096):
        pass
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(2.0)
    os._exit(0)


if __name__ == "__main__":
    sys.exit(main())
