"""A language server that is sent what no editor sends: it says so, and goes on where it can."""

from __future__ import annotations

import json
import subprocess

import pytest

from tests.cli.support import command

pytest.importorskip("pygls")


def message(content: bytes) -> bytes:
    return b"Content-Length: %d\r\n\r\n" % len(content) + content


INITIALIZE = {
    "jsonrpc": "2.0",
    "id": 1,
    "method": "initialize",
    "params": {"processId": None, "rootUri": None, "capabilities": {}},
}
GOOD = message(json.dumps(INITIALIZE).encode()) + message(b'{"jsonrpc":"2.0","id":2,"method":"shutdown"}')


def served(given: bytes) -> tuple[str, str]:
    done = subprocess.run(command("lsp"), input=given, capture_output=True, timeout=600)
    return done.stdout.decode(), done.stderr.decode()


def test_bad_messages_are_left_out_and_the_next_is_answered() -> None:
    deep = json.dumps({**INITIALIZE, "id": 7})[:-1] + ', "initializationOptions": ' + "[" * 100_000
    given = b"".join(
        message(content)
        for content in (deep.encode(), b'{"method": "\xe9"}', b"[]", b"{", b"9" * 10_000, b'{"a":' * 100_000)
    )
    out, err = served(given + GOOD)
    assert out.count('"capabilities"') == 1 and '"id":2' in out.replace(" ", "")
    assert err.count("a message of the editor is left out: ") == 6
    assert "more than 100 lists and objects in each other" in err
    assert "Traceback" not in err


@pytest.mark.parametrize("length", [b"9" * 5000, b"9" * 15, b"1" + b"0" * 8])
def test_an_endless_message_ends_the_server(length: bytes) -> None:
    _, err = served(b"Content-Length: " + length + b"\r\n\r\n{}" + GOOD)
    assert "the server ends" in err
    assert "Traceback" not in err
