"""Lines of a log are read in the same way with msgspec and without it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.project.observing.log_lines import MessageLog
from aseme_dsl.project.observing.talks import Message
from aseme_dsl.runtime.trace.trace_files import TraceError

pytest.importorskip("msgspec")

USUAL: dict[str, Any] = {
    "time": 1.5,
    "sender": "ann",
    "receiver": "bob",
    "performative": "request",
    "protocol": "serving",
    "conversation": "c1",
}


def _line(**more: Any) -> str:
    return json.dumps(USUAL | more, ensure_ascii=False)


LINES = {
    "usual": _line(message="Cup", content={"size": "small"}),
    "an integer as the time": _line(time=3),
    "a date": _line(time="2026-11-23T10:00:00Z"),
    "no date": _line(time="soon"),
    "true as the time": _line(time=True),
    "too late": _line(time=1e30),
    "an integer that is too late": _line(time=10**40),
    "several receivers": _line(receiver=["bob", "eve", "bob"]),
    "no receiver": _line(receiver=[]),
    "a number as a receiver": _line(receiver=["bob", 1]),
    "another spelling": _line(performative="accept-proposal"),
    "no performative": _line(performative="shout"),
    "an empty sender": _line(sender=""),
    "an empty conversation": _line(conversation=""),
    "null as the message": _line(message=None),
    "null as the participant": _line(participant=None),
    "a participant, an id": _line(participant="guest", id="m1"),
    "received": _line(received=2),
    "null as received": _line(received=None),
    "an empty text as received": _line(received=""),
    "any content": _line(content=[1, "two", 3.5, None, {"x": 10**30}]),
    "another member": _line(colour="red", shape=[1, 2]),
    "another alphabet": _line(sender="Änn", content={"name": "žluťoučký"}),
    "no number": _line(content=float("nan")),
    "half a surrogate": _line().replace("ann", "\\ud800"),
    "twice": _line().replace('"sender"', '"sender": "eve", "sender"'),
    "a comma too many": _line().replace("}", ",}"),
    "too deep": _line(content=json.loads("[" * 70 + "]" * 70)),
    "brackets in a text": _line(content="[" * 70),
    "a list": "[1, 2]",
    "nothing": "{}",
}


def _read(path: Path, *, is_quick: bool) -> list[Message] | str:
    log = MessageLog(path)
    assert log._quick is not None
    if not is_quick:
        log._quick = None
    try:
        return [*log]
    except TraceError as problem:
        return str(problem)


@pytest.mark.parametrize("name", LINES)
def test_a_line_says_the_same_to_both_parsers(tmp_path: Path, name: str) -> None:
    path = tmp_path / "log.jsonl"
    path.write_text(f"{_line(conversation='c0')}\n{LINES[name]}\n{_line(conversation='c2')}\n", "utf-8")
    quick, usual = (_read(path, is_quick=is_quick) for is_quick in (True, False))
    assert repr(quick) == repr(usual)


def test_bytes_that_are_no_utf8_are_refused_by_both(tmp_path: Path) -> None:
    path = tmp_path / "log.jsonl"
    path.write_bytes(_line(other="X").encode().replace(b"X", b"\xff") + b"\n" + _line().encode() + b"\n")
    assert _read(path, is_quick=True) == _read(path, is_quick=False)
    assert isinstance(_read(path, is_quick=True), str)


def test_usual_lines_are_read_quickly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "log.jsonl"
    path.write_text(f"{LINES['usual']}\n" * 3)
    slow: list[bytes] = []
    usual = MessageLog._message
    monkeypatch.setattr(MessageLog, "_message", lambda log, line: slow.append(line) or usual(log, line))
    assert len([*MessageLog(path)]) == 3
    assert len(slow) == 1  # the first one, with a performative that was not read before
