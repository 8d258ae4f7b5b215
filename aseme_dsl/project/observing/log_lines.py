"""Log lines: agent messages in JSON lines that other programs have written.

{"time": 1.5, "sender": "ann", "receiver": "bob", "performative": "request", "message": "Dish",
 "content": {"name": "pie"}, "protocol": "ordering", "conversation": "ordering-ann-1"}
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from datetime import UTC, datetime
from pathlib import Path
from typing import cast

from aseme_dsl import outside
from aseme_dsl.project.observing.quick_lines import quick_reader
from aseme_dsl.project.observing.talks import Message
from aseme_dsl.runtime.message.acl import performative_of
from aseme_dsl.runtime.trace.trace_check import LATEST
from aseme_dsl.runtime.trace.trace_files import TraceError, reason_of
from aseme_dsl.runtime.trace.trace_gzip import MAGIC as GZIP_MAGIC
from aseme_dsl.runtime.trace.trace_gzip import unpacked_lines
from aseme_dsl.runtime.trace.trace_mcap import LONGEST, MAGIC, Torn

_SECOND = 1_000_000_000
_USUAL = 6
"""So many members a message has at least; what is optional stands beside them."""
_DEEPEST = 60
"""A content that is deeper than this is none of a message."""


class MessageLog:
    """The messages of a log. `problem` says afterwards what is not whole, `began` when it began."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.problem: str | None = None
        self.backwards: int | None = None
        """The first line whose time is before that of the line before it."""
        self._origin: int | None = None
        self._performatives: dict[str, str] = {}
        self._quick = quick_reader()

    def __iter__(self) -> Iterator[Message]:
        """The messages in the order of the lines.

        Raises:
            TraceError: a line that is not the last is not a message, or the file cannot be read.
        """
        number, last = 0, -LATEST
        try:
            with outside.open_file(self.path) as file:
                is_packed = file.peek(len(GZIP_MAGIC)).startswith(GZIP_MAGIC)
                for line in unpacked_lines(file) if is_packed else outside.lines(file, LONGEST):
                    number += 1
                    if line.isspace():
                        continue
                    found = self._usual(line) or self._message(line)
                    if isinstance(found, str):
                        if not line.endswith(b"\n"):
                            self.problem = f"{self.path}:{number}: the log breaks off here: {found}"
                            return
                        raise TraceError(f"{self.path}:{number}: {found}")
                    if found.moment < last and self.backwards is None:
                        self.backwards = number
                    last = found.moment
                    yield found
        except Torn as torn:
            self.problem = f"{self.path}:{number + 1}: the log breaks off here: {torn.reason}"
        except OSError as problem:
            raise TraceError(f"{self.path} cannot be read: {reason_of(problem)}") from problem

    def _usual(self, line: bytes) -> Message | None:
        """What a line says, read by the quick parser; None if that is not there, or leaves it to ours."""
        if self._quick is None or not line.isascii() or line.count(b"{") + line.count(b"[") > _DEEPEST:
            return None
        try:
            said = self._quick(line)
        except ValueError:
            return None
        performative = self._performatives.get(said.performative)
        moment = self._moment(said.time)
        if moment is None or performative is None or not said.sender or not said.conversation:
            return None
        receiver, received = said.receiver, None
        if type(receiver) is str:
            to: tuple[str, ...] = (receiver,)
        else:
            to = (receiver[0],) if len(receiver) == 1 else tuple(dict.fromkeys(receiver))
        if said.received is not None and (received := self._moment(said.received)) is None:
            return None
        return Message(
            moment,
            said.conversation,
            said.protocol,
            said.sender,
            to,
            performative,
            said.message,
            said.content,
            (said.participant, ""),
            False,
            said.id,
            received,
        )

    def _message(self, line: bytes) -> Message | str:
        """What a line says, or what is wrong with it."""
        try:
            found = outside.loads(line, LONGEST, _DEEPEST)
        except (ValueError, RecursionError) as problem:
            return f"this is not JSON: {problem}"
        if type(found) is not dict:
            return "a message is a JSON object"
        said = cast("dict[str, object]", found)
        get = said.get
        sender, receivers, conversation = get("sender"), get("receiver"), get("conversation")
        performative, protocol, message = get("performative"), get("protocol"), get("message")
        if type(receivers) is str:
            to: tuple[str, ...] = (receivers,)
        elif type(receivers) is list and all(type(item) is str for item in receivers):
            to = tuple(dict.fromkeys(receivers))
        else:
            return _wrong_in(said)
        moment = self._moment(get("time"))
        if (
            moment is None
            or type(sender) is not str
            or type(performative) is not str
            or type(protocol) is not str
            or type(conversation) is not str
            or not (message is None or type(message) is str)
            or not (sender and conversation)
        ):
            return _wrong_in(said)
        known = self._performatives.get(performative)
        if known is None:
            known = performative_of(performative)
            if known is None:
                return f"{performative[:40]!r} is not a performative of FIPA"
            self._performatives[performative] = known
        part: object = ""
        name: object = ""
        received = None
        if len(said) > _USUAL:
            part, name = get("participant", ""), get("id", "")
            if type(part) is not str or type(name) is not str:
                return _wrong_in(said)
            if "received" in said and (received := self._moment(get("received"))) is None:
                return _wrong_in(said)
        content = get("content")
        assert isinstance(part, str) and isinstance(name, str)
        parts = part, ""
        return Message(
            *(
                moment,
                conversation,
                protocol,
                sender,
                to,
                known,
                message,
                content,
                parts,
                False,
                name,
                received,
            )
        )

    def _moment(self, said: object) -> int | None:
        """A time in ns: seconds of the run, or a date, which counts from the first one."""
        if type(said) is int or type(said) is float:
            seconds = cast(float, said)
            return round(seconds * _SECOND) if abs(seconds) < LATEST / _SECOND else None
        if type(said) is not str:
            return None
        try:
            date = datetime.fromisoformat(said)
        except ValueError:
            return None
        date = date if date.tzinfo is not None else date.replace(tzinfo=UTC)
        since = date - datetime(1970, 1, 1, tzinfo=UTC)
        moment = (since.days * 86_400 + since.seconds) * _SECOND + since.microseconds * 1000
        if self._origin is None:
            self._origin = moment
        return moment - self._origin


_MEMBERS: Mapping[str, tuple[tuple[type, ...], str]] = {
    "time": ((int, float, str), "seconds, or a date"),
    "sender": ((str,), "a text"),
    "receiver": ((str, list), "a text, or a list of texts"),
    "performative": ((str,), "a text"),
    "protocol": ((str,), "a text"),
    "conversation": ((str,), "a text"),
    "message": ((str, type(None)), "a text"),
    "participant": ((str,), "a text"),
    "id": ((str,), "a text"),
    "received": ((int, float, str), "seconds, or a date"),
}


def _wrong_in(found: Mapping[str, object]) -> str:
    """Which member of a message is missing, or not as it should be."""
    for name, (types, wanted) in _MEMBERS.items():
        value = found.get(name)
        is_optional = name in ("message", "participant", "id", "received")
        if name not in found:
            if not is_optional:
                return f"a message has no `{name}`"
        elif type(value) not in types:
            return f"`{name}` is not {wanted}"
        elif value == "" and name in ("sender", "conversation"):
            return f"`{name}` is empty"
    for name in ("time", "received"):
        if isinstance(value := found.get(name), str):
            return f"`{name}` is not a date: {value[:40]!r}"
    return "`receiver` or `time` is not as it should be"


def is_trace(path: Path) -> bool:
    """Whether a file is a trace of asemec; otherwise its first line is a message of another program.

    Raises:
        TraceError: it cannot be read.
    """
    try:
        with outside.open_file(path) as file:
            start = file.peek(len(MAGIC))
            if start.startswith(MAGIC):
                return True
            lines = unpacked_lines(file) if start.startswith(GZIP_MAGIC) else outside.lines(file, LONGEST)
            first = next((line for line in lines if not line.isspace()), b"")
        found = outside.loads(first)
    except Torn:
        return True  # its reader says what is wrong
    except OSError as problem:
        raise TraceError(f"{path} cannot be read: {reason_of(problem)}") from problem
    except (ValueError, RecursionError):
        return False
    return isinstance(found, dict) and "kind" in found


__all__ = ["MessageLog", "is_trace"]
