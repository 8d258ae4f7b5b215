"""The health endpoint: small HTTP answers on a Unix socket or on this machine's loopback address."""

from __future__ import annotations

import contextlib
import ipaddress
import json
import os
import re
import socket
import stat
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from io import BufferedReader
from pathlib import Path

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.control.connections import Places, Timely

LARGEST = 8192
"""A request has at most so many bytes; its body is not read."""
_REASONS = {200: "OK", 400: "Bad Request", 403: "Forbidden", 404: "Not Found", 405: "Method Not Allowed"}
_REASONS |= {503: "Service Unavailable"}
_REQUEST = re.compile(rb"(GET|HEAD|[A-Z]{1,16}) (/[!-~]{0,1000}) HTTP/1\.[01]\r?\n")
_LOCAL = re.compile(r"(localhost|127(\.\d{1,3}){3}|\[::1\])(:\d{1,5})?")


class AddressError(ValueError):
    """An address cannot be one of a health endpoint; the text says why."""


@dataclass(frozen=True, slots=True)
class Address:
    """A Unix socket's path, or a loopback address with a port (0: any that is free)."""

    path: Path | None = None
    host: str = ""
    port: int = 0

    def __str__(self) -> str:
        return f"unix:{self.path}" if self.path is not None else f"{self.host}:{self.port}"


@dataclass(frozen=True, slots=True)
class Page:
    """An answer: its HTTP status, its type and its text."""

    status: int
    type: str
    text: str


Pages = Mapping[str, Callable[[], Page]]
"""What makes the answer for each path."""


def address_of(text: str) -> Address:
    """The address that `unix:PATH` or `HOST:PORT` means.

    Raises:
        AddressError: it is none, or others than this machine could reach it.
    """
    if text.startswith("unix:"):
        path = text.removeprefix("unix:")
        if not path or "\0" in path or len(os.fsencode(path)) > 100:
            raise AddressError("the path of a Unix socket has 1 to 100 bytes")
        if not hasattr(socket, "AF_UNIX"):
            raise AddressError("this system has no Unix sockets: use 127.0.0.1:PORT")
        return Address(Path(path))
    host, colon, port = text.rpartition(":")
    if not colon or not (port.isascii() and port.isdigit()) or int(port) > 65535:
        raise AddressError(f"{text!r} is neither unix:PATH nor HOST:PORT")
    host = "127.0.0.1" if host == "localhost" else host.removeprefix("[").removesuffix("]")
    try:
        if not ipaddress.ip_address(host).is_loopback:
            raise AddressError(f"{host} is not a loopback address: use 127.0.0.1, or unix:PATH")
    except ValueError as problem:
        if isinstance(problem, AddressError):
            raise
        raise AddressError(f"{host!r} is not a loopback address: use 127.0.0.1, or unix:PATH") from None
    return Address(None, host, int(port))


def json_page(status: int, value: object) -> Page:
    """An answer in JSON."""
    return Page(status, "application/json", json.dumps(value, ensure_ascii=False) + "\n")


@contextmanager
def serving(address: Address, pages: Pages) -> Iterator[Address]:
    """Inside, the pages are served; gives the address with its port.

    Raises:
        OSError: it cannot be used.
    """
    server = _listen(address)
    mine = address
    if address.path is None:
        mine = Address(None, address.host, server.getsockname()[1])
    thread = threading.Thread(target=_serve, args=(server, pages), name="aseme endpoint", daemon=True)
    thread.start()
    try:
        yield mine
    finally:
        if address.path is not None:
            with contextlib.suppress(OSError):
                address.path.unlink(missing_ok=True)
        with contextlib.suppress(OSError):
            server.shutdown(socket.SHUT_RDWR)
        server.close()
        thread.join(1.0)


def _listen(address: Address) -> socket.socket:
    if address.path is None:
        family = socket.AF_INET6 if ":" in address.host else socket.AF_INET
        server = socket.socket(family, socket.SOCK_STREAM)
        try:
            server.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            server.bind((address.host, address.port))
            server.listen(16)
        except OSError:
            server.close()
            raise
        return server
    _remove_left(address.path)
    server = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    before = os.umask(0o177)
    try:
        server.bind(str(address.path))
        server.listen(16)
    except OSError:
        server.close()
        raise
    finally:
        os.umask(before)
    return server


def _remove_left(path: Path) -> None:
    """Remove a socket that a killed process has left. Raises OSError if something else is there."""
    try:
        found = path.lstat()
    except FileNotFoundError:
        return
    if not stat.S_ISSOCK(found.st_mode):
        raise FileExistsError(17, "it is there already, and is not a socket", str(path))
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as probe:
        probe.settimeout(1.0)
        try:
            probe.connect(str(path))
        except ConnectionRefusedError:
            path.unlink(missing_ok=True)
            return
        except FileNotFoundError:
            return
    raise FileExistsError(17, "another process listens there", str(path))


def _serve(server: socket.socket, pages: Pages) -> None:
    places = Places()
    while True:
        try:
            connection, _ = server.accept()
        except OSError:  # it was closed
            return
        if not places.take(connection, socket.SHUT_RDWR):
            connection.close()
            continue
        threading.Thread(
            target=_answer, args=(connection, places, pages), name="aseme endpoint answer", daemon=True
        ).start()


def _answer(connection: socket.socket, places: Places, pages: Pages) -> None:
    """Answer one request, and close."""
    with connection, contextlib.suppress(OSError):
        try:
            head = _head(BufferedReader(Timely(connection)))
            if head is None or not places.answer(connection):
                return
            connection.sendall(_response(head, pages))
        finally:
            places.leave(connection)


def _head(coming: BufferedReader) -> list[bytes] | None:
    """The lines of a request up to the empty one; None if there is no whole one."""
    lines: list[bytes] = []
    left = LARGEST
    while line := coming.readline(left + 1):
        left -= len(line)
        if left < 0:
            return [b""]
        if line in (b"\r\n", b"\n"):
            return lines
        lines.append(line)
    return None


def _response(lines: list[bytes], pages: Pages) -> bytes:
    match = _REQUEST.fullmatch(lines[0]) if lines else None
    hosts = [line[5:].decode("latin-1").strip() for line in lines[1:] if line[:5].lower() == b"host:"]
    if match is None:
        page = json_page(400, {"error": "not an HTTP request"})
    elif any(host and not _LOCAL.fullmatch(host) for host in hosts):  # a page of the web asks
        page = json_page(403, {"error": "the host is not this machine"})
    elif match[1] not in (b"GET", b"HEAD"):
        page = json_page(405, {"error": "only GET and HEAD are answered"})
    else:
        make = pages.get(match[2].decode("ascii").partition("?")[0])
        page = json_page(404, {"error": f"there are {', '.join(pages)}"}) if make is None else make()
    body = page.text.encode("utf-8", "replace")
    head = (
        f"HTTP/1.1 {page.status} {_REASONS[page.status]}\r\nContent-Type: {page.type}\r\n"
        f"Content-Length: {len(body)}\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n"
    ).encode("ascii")
    return head if match is not None and match[1] == b"HEAD" else head + body


__all__ = ["Address", "AddressError", "Page", "Pages", "address_of", "json_page", "serving"]
