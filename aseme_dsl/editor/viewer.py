"""Viewer: a page in a browser of this machine that shows a picture, and another one as soon as there is one.

It shows a JSON document that the page understands (`page_state`, `viewer.html`). It hands the actions of
users there to the program that has opened it.
"""

from __future__ import annotations

import contextlib
import json
import secrets
import socket
import threading
from collections.abc import Callable, Mapping, Sequence
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from importlib import resources
from io import BufferedReader
from typing import TYPE_CHECKING
from urllib.parse import parse_qsl

from aseme_dsl import outside
from aseme_dsl.runtime.control.connections import MOST, Places, Timely

if TYPE_CHECKING:
    from aseme_dsl.editor.answers.diagram import LiveDrawing

LOOPBACK = "127.0.0.1"
PATIENCE = 20.0
"""How long a page waits for something new before it asks again, in seconds."""

_POLICY = "default-src 'none'; style-src 'unsafe-inline'; connect-src 'self'"

MOST_TABS = 32
"""So many tabs may show something of their own; one that asks for more takes the place of the oldest."""
NO_TAB = ""
"""Stands for a tab in which nothing has been selected."""

_LARGEST = 10_000
"""The most bytes that a page may send at once."""


class Viewer:
    """A page at `url`. `on_act` gets the actions of users there, in a thread of its own.

    No other machine can reach it, and no page from elsewhere: the address has a secret in it.
    """

    def __init__(self, on_act: Callable[[Mapping[str, object]], None], port: int = 0) -> None:
        """Raises OSError if the port is taken."""
        self._on_act = on_act
        self._news = threading.Condition()
        self._version = 0
        self._states: dict[str, tuple[int, bytes]] = {NO_TAB: (0, b"null")}
        self._ended = False
        self._secret = secrets.token_urlsafe(12)
        self._server = _Server((LOOPBACK, port), _Handler, self)
        self.port = int(self._server.server_address[1])
        self.url = f"http://{LOOPBACK}:{self.port}/{self._secret}/"
        self._thread = threading.Thread(target=self._server.serve_forever, args=(0.1,), daemon=True)
        self._thread.start()

    def show(self, state: Mapping[str, object], tab: str = NO_TAB) -> None:
        """Show this from now on: in one tab, or in all that show nothing of their own."""
        text = json.dumps(state, ensure_ascii=False).encode("utf-8", "backslashreplace")
        with self._news:
            if tab not in self._states or text != self._states[tab][1]:
                self._version += 1
                self._states[tab] = self._version, text
                if len(self._states) > MOST_TABS + 1:
                    del self._states[next(name for name in self._states if name != NO_TAB)]
                self._news.notify_all()

    def tabs(self) -> tuple[str, ...]:
        """The tabs that show something of their own, and `NO_TAB`."""
        with self._news:
            return tuple(self._states)

    def close(self) -> None:
        """End it; pages say that it has ended."""
        with self._news:
            self._ended = True
            self._news.notify_all()
        self._server.shutdown()
        self._thread.join()
        self._server.server_close()

    # ---- what the page asks --------------------------------------------------------------------------

    def wait(self, version: int, tab: str = NO_TAB) -> tuple[int, bytes] | None:
        """What a tab shows once it is another version than this one; None if that takes too long."""
        with self._news:
            self._news.wait_for(lambda: self._shown(tab)[0] != version or self._ended, PATIENCE)
            shown = self._shown(tab)
            return shown if shown[0] != version else None

    def _shown(self, tab: str) -> tuple[int, bytes]:
        return self._states.get(tab) or self._states[NO_TAB]

    def act(self, said: Mapping[str, object]) -> None:
        self._on_act(said)

    def is_asked(self, host: str, path: str) -> str | None:
        """The part of the page that a request asks for; None where it is not for this page."""
        start = f"/{self._secret}/"
        hosts = (f"{LOOPBACK}:{self.port}", f"localhost:{self.port}")
        return path.removeprefix(start) if host in hosts and path.startswith(start) else None


_BUSY = b"HTTP/1.1 503 Service Unavailable\r\nContent-Length: 0\r\nConnection: close\r\n\r\n"


class _Server(ThreadingHTTPServer):
    """Serves few connections at once. Those that have not said the secret make room for others."""

    daemon_threads = True
    block_on_close = False
    request_queue_size = MOST
    """With few, who connects while others do would wait for seconds."""

    def __init__(
        self, address: tuple[str, int], handler: type[BaseHTTPRequestHandler], viewer: Viewer
    ) -> None:
        self.viewer = viewer
        self.places = Places()
        super().__init__(address, handler)

    def process_request(
        self, request: socket.socket | tuple[bytes, socket.socket], client_address: object
    ) -> None:
        """Serve a connection in a thread of its own."""
        assert isinstance(request, socket.socket)  # the other is of UDP
        if self.places.take(request, socket.SHUT_RDWR):
            super().process_request(request, client_address)
            return
        with contextlib.suppress(OSError):
            request.settimeout(0.0)
            request.sendall(_BUSY)
        self.shutdown_request(request)

    def shutdown_request(self, request: socket.socket | tuple[bytes, socket.socket]) -> None:
        """End a connection."""
        assert isinstance(request, socket.socket)
        self.places.leave(request)
        super().shutdown_request(request)

    def handle_error(self, request: object, client_address: object) -> None:
        """A page that goes away in the midst of something is none."""


def page_state(
    drawing: LiveDrawing | None = None,
    *,
    title: str = "",
    here: str | None = None,
    models: Sequence[str] = (),
    model: str = "",
    part: bool = False,
    text: str = "",
) -> dict[str, object]:
    """What the page shows: a picture with the element that is marked, or only a title.

    `models` may be chosen there, `model` is the one that is; `part`: the picture is of a part of it. `text`
    stands below.
    """
    return {
        "name": drawing.name if drawing is not None else "",
        "title": drawing.title if drawing is not None else title,
        "note": drawing.note if drawing is not None else "",
        "svg": drawing.svg if drawing is not None else "",
        "elements": sorted(drawing.elements) if drawing is not None else [],
        "here": here,
        "models": list(models),
        "model": model,
        "part": part,
        "text": text,
    }


def page(nonce: str) -> bytes:
    """The page, whose script runs only with this word."""
    text = resources.files("aseme_dsl.editor").joinpath("viewer.html").read_text("utf-8")
    return text.replace("NONCE", nonce).encode()


class _Handler(BaseHTTPRequestHandler):
    """Answers the page of the server's viewer."""

    protocol_version = "HTTP/1.1"
    server: _Server

    def setup(self) -> None:
        super().setup()
        self.rfile.close()
        self._coming = Timely(self.connection)
        self.rfile = BufferedReader(self._coming)

    def handle_one_request(self) -> None:
        self._coming.next()
        super().handle_one_request()
        self.server.places.wait(self.connection, socket.SHUT_RDWR)

    def _asked(self) -> str | None:
        """What is asked for by who knows the secret, and keeps the place while it is answered."""
        asked = self.server.viewer.is_asked(self.headers.get("Host", ""), self.path)
        return asked if asked is not None and self.server.places.answer(self.connection) else None

    def do_GET(self) -> None:
        asked = self._asked()
        name, _, question = (asked or "").partition("?")
        if asked is None or name not in ("", "state"):
            self._answer(HTTPStatus.NOT_FOUND)
        elif name == "":
            nonce = secrets.token_urlsafe(12)
            policy = f"{_POLICY}; script-src 'nonce-{nonce}'"
            self._answer(HTTPStatus.OK, page(nonce), "text/html", {"Content-Security-Policy": policy})
        else:
            said = dict(parse_qsl(question[:_LARGEST]))
            number = said.get("after", "")
            found = self.server.viewer.wait(
                int(number[:18]) if number.isdecimal() else 0, said.get("tab", NO_TAB)
            )
            if found is None:
                self._answer(HTTPStatus.NO_CONTENT)
            else:
                self._answer(HTTPStatus.OK, found[1], "application/json", {"X-Version": str(found[0])})

    def do_POST(self) -> None:
        asked = self._asked()
        length = self.headers.get("Content-Length", "")
        if asked != "act" or not length.isdecimal() or int(length[:18]) > _LARGEST:
            self.close_connection = True
            self._answer(HTTPStatus.NOT_FOUND)
            return
        try:
            said = outside.loads(self.rfile.read(int(length)))
        except ValueError:
            said = None
        if not isinstance(said, dict):
            self._answer(HTTPStatus.BAD_REQUEST)
            return
        self.server.viewer.act(said)
        self._answer(HTTPStatus.NO_CONTENT)

    def log_message(self, format: str, *args: object) -> None:
        """Log nothing: requests of pages are of no interest."""

    def _answer(
        self,
        status: HTTPStatus,
        content: bytes = b"",
        kind: str = "text/plain",
        more: Mapping[str, str] | None = None,
    ) -> None:
        self.send_response(status)
        if status is not HTTPStatus.NO_CONTENT:
            self.send_header("Content-Type", f"{kind}; charset=utf-8")
            self.send_header("Content-Length", str(len(content)))
        self.send_header("Cache-Control", "no-store")
        self.send_header("Referrer-Policy", "no-referrer")
        for name, value in (more or {}).items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(content)


__all__ = ["Viewer", "page_state"]
