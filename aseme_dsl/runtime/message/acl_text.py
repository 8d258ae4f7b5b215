"""Agent messages as text, in the string representation of FIPA (SC00070), both ways.

    (inform
     :sender (agent-identifier :name bob)
     :receiver (set (agent-identifier :name alice :addresses (sequence http://host/acc)))
     :content "{\\"cost\\": 3.0}"
     :language json
     :in-reply-to alice-7)

Names of parameters, acts and the words `set`, `sequence` and `agent-identifier` may be in any case. Between
tokens there may be any blanks. A string ends at the first quote without a backslash before it; nothing else
is escaped. A string that such quotes cannot hold is written with its length in bytes: `#3"a"\\`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator
from datetime import UTC, datetime, timedelta, timezone
from typing import NoReturn, TypeVar

from aseme_dsl.runtime.message.acl import AgentIdentifier, FipaMessage, Span, Word
from aseme_dsl.runtime.message.by_name import made

_T = TypeVar("_T")

DEEPEST = 50
"""So deep may lists and agent identifiers be nested."""

_BLANK = re.compile(rb"[\x00-\x20]*")
_TOKEN = re.compile(rb"[^\x00-\x20()]+")
_STRING = re.compile(rb'"(.*?)(?<!\\)"', re.DOTALL)
_LENGTH = re.compile(rb'#(\d{1,18})"')
_WORD = re.compile(r'[^\x00-\x20()#0-9\-@":+][^\x00-\x20()]*')
_PARAMETER = re.compile(r"[^\x00-\x20()]+")
_INTEGER = re.compile(r"[+-]?\d+", re.ASCII)
_FLOAT = re.compile(r"[+-]?(\d+\.\d*|\.\d+|\d+)([eE][+-]?\d+)?", re.ASCII)
_MOMENT = re.compile(r"([+-]?)(\d{4})(\d\d)(\d\d)T(\d\d)(\d\d)(\d\d)(\d{3})([A-Za-z]?)", re.ASCII)
_ZONES = {letter: hours for hours, letter in enumerate("ABCDEFGHIKLM", 1)} | {
    letter: -hours for hours, letter in enumerate("NOPQRSTUVWXY", 1)
}
_ZONES["Z"] = 0
_LETTERS = {hours: letter for letter, hours in _ZONES.items()}


class AclTextError(ValueError):
    """A text that is not a message, or a message without a text; `position` is the place in bytes, from 0."""

    def __init__(self, reason: str, position: int = 0, line: int = 1, column: int = 1) -> None:
        super().__init__(f"line {line}, column {column}: {reason}")
        self.reason = reason
        self.position = position
        self.line = line
        self.column = column


# ---- reading -----------------------------------------------------------------------------------


def loads(text: bytes | str) -> FipaMessage:
    """The message that a text is, from its first parenthesis to its last.

    A content with its length in bytes is text if it is UTF-8.

    Raises:
        AclTextError: it is none; the error says why, and where.
    """
    reader = Reader(text.encode("utf-8", "surrogatepass") if isinstance(text, str) else text)
    message = reader.message()
    reader.end()
    return message


def read_moment(text: str) -> datetime | Span:
    """A moment as FIPA writes it (`20260131T120000000Z`), or a span from now (`+00000000T000010000`).

    Raises:
        AclTextError: it is none.
    """
    reader = Reader(text.encode("utf-8", "replace"))
    found = reader.moment()
    reader.end()
    return found


def moment_text(moment: datetime | Span) -> bytes:
    """A moment or a span as FIPA writes it. Raises AclTextError if it has more than FIPA's digits can say."""
    return _span(moment) if isinstance(moment, Span) else _moment(moment)


class Reader:
    """Reads a text from its beginning to its end. Each method raises AclTextError where that is not there."""

    def __init__(self, data: bytes) -> None:
        self.data = data
        self.at = 0
        self.depth = 0

    # ---- the message

    def message(self) -> FipaMessage:
        self.open("a message begins with '('")
        act = self.word("an act such as inform")
        given: dict[str, object] = {}
        others: list[tuple[str, object]] = []
        for name, place in self.parameters():
            known = _PARAMETERS.get(name.lower())
            if known is None:
                others.append((name, self.expression()))
                continue
            field, reading = known
            if field in given:
                self.fail(f":{name.lower()} is given twice", place)
            given[field] = reading(self)
        return made(FipaMessage, act.lower(), **given, parameters=tuple(others))

    def parameters(self) -> Iterator[tuple[str, int]]:
        """The names of the parameters up to the closing parenthesis, with their places."""
        seen: set[str] = set()
        while True:
            self.blanks()
            place = self.at
            if self.take(b")"):
                return
            name = self.token("a parameter such as :content, or ')',")
            if not name.startswith(":"):
                self.fail(f"a parameter such as :content, or ')', is wanted here, not {shown(name)}", place)
            name = name[1:]
            if not name:
                self.fail("the parameter has no name", place)
            if name.lower() in seen:
                self.fail(f":{shown(name)} is given twice", place)
            seen.add(name.lower())
            yield name, place

    def agent(self) -> AgentIdentifier:
        place = self.open("an agent identifier begins with '('")
        self.keyword("agent-identifier")
        given: dict[str, object] = {}
        others: list[tuple[str, object]] = []
        for name, _ in self.parameters():
            match name.lower():
                case "name":
                    given["name"] = str(self.word("the agent's name as a word"))
                case "addresses":
                    given["addresses"] = tuple(self.items("sequence", lambda: self.token("an address")))
                case "resolvers":
                    given["resolvers"] = tuple(self.items("sequence", self.agent))
                case _:
                    others.append((name, self.expression()))
        self.depth -= 1
        if "name" not in given:
            self.fail("the agent identifier has no :name", place)
        return made(AgentIdentifier, **given, parameters=tuple(others))

    def agents(self) -> tuple[AgentIdentifier, ...]:
        return tuple(self.items("set", self.agent))

    def items(self, keyword: str, item: Callable[[], _T]) -> Iterator[_T]:
        self.open(f"'(' and the word {keyword} are wanted here")
        self.keyword(keyword)
        self.depth -= 1
        while True:
            self.blanks()
            if self.take(b")"):
                return
            yield item()

    # ---- values

    def content(self) -> str | bytes:
        self.blanks()
        found = self.string()
        if found is None:
            self.fail("the content is a string in quotes, or one with its length", self.at)
        return found

    def text(self) -> str:
        """An expression where one word or text is meant."""
        self.blanks()
        place = self.at
        found = self.expression()
        if isinstance(found, str):
            return found
        if isinstance(found, bytes):
            self.fail("what stands here is not a text in UTF-8", place)
        return _expression(found).decode()

    def moment(self) -> datetime | Span:
        self.blanks()
        place = self.at
        token = self.token("a moment such as 20260131T120000000Z")
        found = self.as_moment(token, place)
        if found is None:
            self.fail(f"a moment such as 20260131T120000000Z is wanted here, not {shown(token)}", place)
        return found

    def protocol(self) -> str:
        return str(self.word("the protocol's name as a word"))

    def expression(self) -> object:
        self.blanks()
        string = self.string()
        if string is not None:
            return string
        place = self.at
        if self.data[self.at : self.at + 1] == b"(":
            self.open("")
            found: list[object] = []
            while True:
                self.blanks()
                if self.take(b")"):
                    self.depth -= 1
                    return tuple(found)
                found.append(self.expression())
        token = self.token("a word, a string, a number, a moment or '('")
        moment = self.as_moment(token, place)
        if moment is not None:
            return moment
        number = self.as_number(token, place)
        if number is not None:
            return number
        return self.as_word(token, place, "a word, a string, a number, a moment or '('")

    def as_number(self, token: str, place: int) -> int | float | None:
        if _INTEGER.fullmatch(token):
            try:
                return int(token)
            except ValueError:
                self.fail("the number has too many digits", place)
        if _FLOAT.fullmatch(token):
            number = float(token)
            return number if math.isfinite(number) else self.fail("the number is too large", place)
        return None

    def string(self) -> str | bytes | None:
        """A string of either kind, if there is one here."""
        start = self.data[self.at : self.at + 1]
        if start == b'"':
            found = _STRING.match(self.data, self.at)
            if found is None:
                self.fail("the string has no end", self.at)
            place, self.at = self.at, found.end()
            return self.decoded(found[1].replace(b'\\"', b'"'), place)
        if start == b"#":
            head = _LENGTH.match(self.data, self.at)
            if head is None:
                self.fail("after # there are the length of a string in bytes and a quote", self.at)
            begin, end = head.end(), head.end() + int(head[1])
            if end > len(self.data):
                there = len(self.data) - begin
                self.fail(f"the string has {int(head[1])} bytes, but only {there} follow", self.at)
            self.at = end
            data = self.data[begin:end]
            try:
                return data.decode()
            except UnicodeDecodeError:
                return data
        return None

    def as_moment(self, token: str, place: int) -> datetime | Span | None:
        found = _MOMENT.fullmatch(token)
        if found is None:
            return None
        sign, letter = found[1], found[9].upper()
        year, month, day, hour, minute, second, milli = (int(found[n]) for n in range(2, 9))
        if sign:
            length = ((hour * 60 + minute) * 60 + second) * 1000 + milli
            return Span(year, month, day, length, -1 if sign == "-" else 1)
        try:
            zone = timezone(timedelta(hours=_ZONES[letter])) if letter in _ZONES else None
            return datetime(year, month, day, hour, minute, second, milli * 1000, zone)
        except ValueError as problem:
            self.fail(f"{token} is not a moment: {problem}", place)

    def as_word(self, token: str, place: int, wanted: str) -> Word:
        if token[0] in "#-@:0123456789":
            self.fail(f"{wanted} is wanted here, not {shown(token)}", place)
        return Word(token)

    def word(self, wanted: str) -> Word:
        self.blanks()
        place = self.at
        token = self.token(wanted)
        if token[0] == '"':
            self.fail(f"{wanted} is wanted here, not a string", place)
        return self.as_word(token, place, wanted)

    # ---- tokens

    def blanks(self) -> None:
        found = _BLANK.match(self.data, self.at)
        assert found is not None
        self.at = found.end()

    def token(self, wanted: str) -> str:
        self.blanks()
        found = _TOKEN.match(self.data, self.at)
        if found is None:
            what = "the end" if self.at >= len(self.data) else f"'{chr(self.data[self.at])}'"
            self.fail(f"{wanted} is wanted here, not {what}", self.at)
        place, self.at = self.at, found.end()
        return self.decoded(found[0], place)

    def take(self, what: bytes) -> bool:
        if self.data.startswith(what, self.at):
            self.at += len(what)
            return True
        return False

    def open(self, wanted: str) -> int:
        """Go over '(', and one level deeper; its place."""
        self.blanks()
        place = self.at
        if not self.take(b"("):
            self.fail(wanted, place)
        self.depth += 1
        if self.depth > DEEPEST:
            self.fail(f"it is nested more than {DEEPEST} deep", place)
        return place

    def keyword(self, wanted: str) -> None:
        self.blanks()
        place = self.at
        token = self.token(f"the word {wanted}")
        if token.lower() != wanted:
            self.fail(f"the word {wanted} is wanted here, not {shown(token)}", place)

    def end(self) -> None:
        self.blanks()
        if self.at < len(self.data):
            self.fail("something follows after the message", self.at)

    def decoded(self, data: bytes, place: int) -> str:
        try:
            return data.decode()
        except UnicodeDecodeError as problem:
            self.fail(f"it is not UTF-8: {problem.reason}", place)

    def fail(self, reason: str, place: int) -> NoReturn:
        before = self.data[:place]
        line = before.count(b"\n") + 1
        column = len(before[before.rfind(b"\n") + 1 :].decode("utf-8", "replace")) + 1
        raise AclTextError(reason, place, line, column)


def shown(token: str) -> str:
    """A token as a message of an error has it."""
    return token if len(token) <= 40 else token[:40] + "…"


_PARAMETERS: dict[str, tuple[str, Callable[[Reader], object]]] = {
    "sender": ("sender", Reader.agent),
    "receiver": ("receivers", Reader.agents),
    "content": ("content", Reader.content),
    "reply-to": ("reply_to", Reader.agents),
    "language": ("language", Reader.text),
    "encoding": ("encoding", Reader.text),
    "ontology": ("ontology", Reader.text),
    "protocol": ("protocol", Reader.protocol),
    "conversation-id": ("conversation", Reader.text),
    "reply-with": ("reply_with", Reader.text),
    "in-reply-to": ("in_reply_to", Reader.text),
    "reply-by": ("reply_by", Reader.moment),
}


# ---- writing -----------------------------------------------------------------------------------


def dumps(message: FipaMessage) -> bytes:
    """The text of a message, in UTF-8, a parameter a line. Parameters that are empty are left out.

    Moments are cut to the millisecond; those of a zone that FIPA has no letter for are written in UTC.

    Raises:
        AclTextError: it has no text: a name that is not a word, or an address with blanks or parentheses.
    """
    lines = [b"(" + _as_word(message.performative, "act")]

    def add(name: str, value: bytes) -> None:
        lines.append(f" :{name} ".encode() + value)

    if message.sender is not None:
        add("sender", _agent(message.sender))
    if message.receivers:
        add("receiver", _list("set", map(_agent, message.receivers)))
    if message.content is not None:
        add("content", string_text(message.content))
    if message.reply_with:
        add("reply-with", _word_or_string(message.reply_with))
    if message.reply_by is not None:
        add("reply-by", _expression(message.reply_by))
    if message.in_reply_to:
        add("in-reply-to", _word_or_string(message.in_reply_to))
    if message.reply_to:
        add("reply-to", _list("set", map(_agent, message.reply_to)))
    for name, value in (
        ("language", message.language),
        ("encoding", message.encoding),
        ("ontology", message.ontology),
    ):
        if value:
            add(name, _word_or_string(value))
    if message.protocol:
        add("protocol", _as_word(message.protocol, "protocol"))
    if message.conversation:
        add("conversation-id", _word_or_string(message.conversation))
    for name, further in _named(message.parameters, _PARAMETERS):
        add(name, _expression(further))
    return b"\n".join(lines) + b")"


def _agent(agent: AgentIdentifier, depth: int = 0) -> bytes:
    if depth > DEEPEST // 3:
        raise AclTextError(f"the resolvers of {agent.name} are nested more than {DEEPEST // 3} deep")
    parts = [b"(agent-identifier :name " + _as_word(agent.name, "agent")]
    if agent.addresses:
        parts.append(b":addresses " + _list("sequence", (_token(item) for item in agent.addresses)))
    if agent.resolvers:
        parts.append(
            b":resolvers " + _list("sequence", (_agent(item, depth + 1) for item in agent.resolvers))
        )
    for name, value in _named(agent.parameters, ("name", "addresses", "resolvers")):
        parts.append(f":{name} ".encode() + _expression(value))
    return b" ".join(parts) + b")"


def _named(parameters: Iterable[tuple[str, object]], known: Iterable[str]) -> Iterator[tuple[str, object]]:
    taken = set(known)
    for name, value in parameters:
        if not _PARAMETER.fullmatch(name) or name.lower() in taken:
            raise AclTextError(f"{name!r} cannot be the name of a further parameter")
        taken.add(name.lower())
        yield name, value


def _list(keyword: str, items: Iterable[bytes]) -> bytes:
    return b"(" + b" ".join((keyword.encode(), *items)) + b")"


def _expression(value: object, depth: int = 0) -> bytes:
    if depth > DEEPEST // 2:
        raise AclTextError(f"a value is nested more than {DEEPEST // 2} deep")
    if isinstance(value, Word):
        return _as_word(value, "word")
    if isinstance(value, (str, bytes)):
        return string_text(value)
    if isinstance(value, datetime):
        return _moment(value)
    if isinstance(value, Span):
        return _span(value)
    if isinstance(value, (tuple, list)):
        return b"(" + b" ".join(_expression(item, depth + 1) for item in value) + b")"
    try:
        if type(value) is int or (type(value) is float and math.isfinite(value)):
            return repr(value).encode()
    except ValueError as problem:
        raise AclTextError(f"a number is too large: {problem}") from None
    raise AclTextError(f"{value!r} is nothing that a parameter can be")


def _moment(value: datetime) -> bytes:
    letter = ""
    offset = value.utcoffset()
    if offset is not None:
        hours = offset / timedelta(hours=1)
        if hours not in _LETTERS:
            value, hours = value.astimezone(UTC), 0
        letter = _LETTERS[int(hours)]
    milli = value.microsecond // 1000
    return (
        f"{value.year:04}{value.month:02}{value.day:02}T"
        f"{value.hour:02}{value.minute:02}{value.second:02}{milli:03}{letter}"
    ).encode()


def _span(value: Span) -> bytes:
    seconds, milli = divmod(value.milliseconds, 1000)
    minutes, second = divmod(seconds, 60)
    hour, minute = divmod(minutes, 60)
    if not (
        0 <= value.years < 10_000 and 0 <= value.months < 100 and 0 <= value.days < 100 and 0 <= hour < 100
    ):
        raise AclTextError(f"{value!r} has more than FIPA's digits can say")
    sign = "-" if value.sign < 0 else "+"
    return (
        f"{sign}{value.years:04}{value.months:02}{value.days:02}T{hour:02}{minute:02}{second:02}{milli:03}"
    ).encode()


def _word_or_string(text: str) -> bytes:
    return _encoded(text) if _is_word(text) else string_text(text)


def _is_word(text: str) -> bool:
    return _WORD.fullmatch(text) is not None


def _as_word(text: str, what: str) -> bytes:
    if not _is_word(text):
        raise AclTextError(f"{text!r} is not a word, as the name of the {what} has to be")
    return _encoded(text)


def _token(text: str) -> bytes:
    if not _PARAMETER.fullmatch(text):
        raise AclTextError(f"{text!r} cannot be an address: it has blanks or parentheses")
    return _encoded(text)


def string_text(value: str | bytes) -> bytes:
    """A string in quotes, or with its length where quotes cannot hold it."""
    data = _encoded(value) if isinstance(value, str) else value
    if isinstance(value, bytes) or data.endswith(b"\\"):
        return f'#{len(data)}"'.encode() + data
    return b'"' + data.replace(b'"', b'\\"') + b'"'


def _encoded(text: str) -> bytes:
    try:
        return text.encode()
    except UnicodeEncodeError as problem:
        raise AclTextError(f"{text!r} is not a text: {problem.reason}") from None
