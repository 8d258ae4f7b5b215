"""Agent messages as text (FIPA SC00070), both ways: what is read, what is written, and what is neither."""

from __future__ import annotations

import os
from datetime import UTC, datetime, timedelta, timezone
from typing import Any

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from aseme_dsl.runtime.message.acl import AgentIdentifier, FipaMessage, Span, Word
from aseme_dsl.runtime.message.acl_text import AclTextError, dumps, loads

EXAMPLES = int(os.environ.get("ACL_EXAMPLES", "100"))

ALICE = AgentIdentifier("alice@host:1099/JADE", ("http://host:7778/acc",))
CAROL = b"(agent-identifier :name carol :resolvers (sequence (agent-identifier :name df)) :X-age 3)"
FULL = FipaMessage(
    "accept-proposal",
    ALICE,
    (AgentIdentifier("bob"), AgentIdentifier("carol", (), (AgentIdentifier("df"),), (("X-age", 3),))),
    'he said "yes"',
    (AgentIdentifier("dave"),),
    "fipa-sl",
    "utf-8",
    "stock market",
    "fipa-contract-net",
    "c 1",
    "r1",
    "7",
    datetime(2026, 1, 31, 12, 30, 5, 250_000, UTC),
    (("X-list", (Word("a"), "b c", -1, 2.5, (Word("d"),))), ("X-bytes", b"\xff")),
)


def test_every_parameter_is_written() -> None:
    assert (
        dumps(FULL)
        == rb"""(accept-proposal
 :sender (agent-identifier :name alice@host:1099/JADE :addresses (sequence http://host:7778/acc))
 :receiver (set (agent-identifier :name bob) CAROL)
 :content "he said \"yes\""
 :reply-with r1
 :reply-by 20260131T123005250Z
 :in-reply-to "7"
 :reply-to (set (agent-identifier :name dave))
 :language fipa-sl
 :encoding utf-8
 :ontology "stock market"
 :protocol fipa-contract-net
 :conversation-id "c 1"
 :X-list (a "b c" -1 2.5 (d))
 :X-bytes #1"XX)""".replace(b"XX", b"\xff").replace(b"CAROL", CAROL)
    )


def test_every_parameter_is_read() -> None:
    assert loads(dumps(FULL)) == FULL


def test_as_jade_writes_it() -> None:
    """In capitals, with blanks inside parentheses, each parameter after a blank and a line."""
    text = """(REQUEST
 :sender  ( agent-identifier :name da0@h:1099/JADE  :addresses (sequence http://h:7778/acc http://h/2 ))
 :receiver  (set ( agent-identifier :name df@h:1099/JADE ) )
 :content  "((action (agent-identifier :name df) (search (df-agent-description) )))"
 :reply-with  R1_2  :language  fipa-sl0  :ontology  FIPA-Agent-Management  :protocol  fipa-request
 :conversation-id  C14 :Reply-By 20021224T235959999 )"""
    message = loads(text)
    assert message.performative == "request"
    assert message.sender == AgentIdentifier("da0@h:1099/JADE", ("http://h:7778/acc", "http://h/2"))
    assert message.receivers == (AgentIdentifier("df@h:1099/JADE"),)
    assert message.content == "((action (agent-identifier :name df) (search (df-agent-description) )))"
    assert (message.reply_with, message.ontology) == ("R1_2", "FIPA-Agent-Management")
    assert message.reply_by == datetime(2002, 12, 24, 23, 59, 59, 999_000)
    assert message.parameters == ()


def value(text: str | bytes) -> Any:
    data = text if isinstance(text, bytes) else text.encode()
    ((_, found),) = loads(b"(inform :X-v " + data + b")").parameters
    return found


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ('""', ""),
        (r'"a \" b"', 'a " b'),
        (r'"a \n b"', r"a \n b"),
        (r'"\\"b"', '\\"b'),
        ('"two\nlines ()"', "two\nlines ()"),
        ('#7"a"b)\\ c', 'a"b)\\ c'),
        ('#2"ä', "ä"),
        (b'#2"\xff\x00', b"\xff\x00"),
        ('#0"', ""),
        ("word", Word("word")),
        ("a:b@c#d-e\"f'", Word("a:b@c#d-e\"f'")),
        ("42", 42),
        ("-0042", -42),
        ("+7", 7),
        ("1.5", 1.5),
        (".5e1", 5.0),
        ("-2.", -2.0),
        ("1E3", 1000.0),
        ("()", ()),
        ("(a (b) ())", ("a", ("b",), ())),
        ("20260131T123005250", datetime(2026, 1, 31, 12, 30, 5, 250_000)),
        ("20260131T123005250Z", datetime(2026, 1, 31, 12, 30, 5, 250_000, UTC)),
        ("20260131T123005250b", datetime(2026, 1, 31, 12, 30, 5, 250_000, timezone(timedelta(hours=2)))),
        ("20260131T123005250Y", datetime(2026, 1, 31, 12, 30, 5, 250_000, timezone(timedelta(hours=-12)))),
        ("20260131T123005250j", datetime(2026, 1, 31, 12, 30, 5, 250_000)),
        ("+00000001T000130000", Span(days=1, milliseconds=90_000)),
        ("-00010200T000000001", Span(1, 2, 0, 1, -1)),
    ],
)
def test_values(text: str | bytes, wanted: Any) -> None:
    found = value(text)
    assert (found, type(found)) == (wanted, type(wanted))


def test_a_string_that_quotes_cannot_hold_is_written_with_its_length() -> None:
    message = FipaMessage("inform", content='a "b"\\')
    assert dumps(message) == b'(inform\n :content #6"a "b"\\)'
    assert loads(dumps(message)) == message


def test_zones_without_a_letter_are_written_in_utc() -> None:
    half = datetime(2026, 1, 31, 12, 0, 0, 0, timezone(timedelta(hours=5, minutes=30)))
    assert b":reply-by 20260131T063000000Z" in dumps(FipaMessage("inform", reply_by=half))


@pytest.mark.parametrize(
    ("text", "place", "reason"),
    [
        ("", (1, 1), "a message begins with '('"),
        ("inform", (1, 1), "a message begins with '('"),
        ("()", (1, 2), "an act such as inform is wanted here, not ')'"),
        ('("inform")', (1, 2), "an act such as inform is wanted here, not a string"),
        ("(7)", (1, 2), "an act such as inform is wanted here, not 7"),
        ("(inform", (1, 8), "a parameter such as :content, or ')', is wanted here, not the end"),
        ("(inform\n content)", (2, 2), "a parameter such as :content, or ')', is wanted here, not content"),
        ("(inform ( ))", (1, 9), "a parameter such as :content, or ')', is wanted here, not '('"),
        ("(inform :)", (1, 9), "the parameter has no name"),
        ("(inform) x", (1, 10), "something follows after the message"),
        ("(inform :content x)", (1, 18), "the content is a string in quotes, or one with its length"),
        ('(inform :content "x)', (1, 18), "the string has no end"),
        (r'(inform :content "x\")', (1, 18), "the string has no end"),
        ('(inform :content #3"a)', (1, 18), "the string has 3 bytes, but only 2 follow"),
        ("(inform :content #x)", (1, 18), "after # there are the length of a string in bytes and a quote"),
        ('(inform :content "a" :Content "b")', (1, 22), ":Content is given twice"),
        ("(inform :X-a 1 :x-A 2)", (1, 16), ":x-A is given twice"),
        ("(inform :sender bob)", (1, 17), "an agent identifier begins with '('"),
        ("(inform :sender (agent :name a))", (1, 18), "the word agent-identifier is wanted here, not agent"),
        ("(inform :sender (agent-identifier))", (1, 17), "the agent identifier has no :name"),
        (
            '(inform :sender (agent-identifier :name "a"))',
            (1, 41),
            "the agent's name as a word is wanted here, not a string",
        ),
        (
            "(inform :receiver (agent-identifier :name a))",
            (1, 20),
            "the word set is wanted here, not agent-identifier",
        ),
        ("(inform :receiver set)", (1, 19), "'(' and the word set are wanted here"),
        ("(inform :receiver (set a))", (1, 24), "an agent identifier begins with '('"),
        ("(inform :reply-by soon)", (1, 19), "a moment such as 20260131T120000000Z is wanted here, not soon"),
        (
            "(inform :reply-by 20261331T120000000)",
            (1, 19),
            "20261331T120000000 is not a moment: month must be in 1..12",
        ),
        ("(inform :protocol 3)", (1, 19), "the protocol's name as a word is wanted here, not 3"),
        ("(inform :X-a 1e999)", (1, 14), "the number is too large"),
        ("(inform :X-a " + "9" * 5000 + ")", (1, 14), "the number has too many digits"),
        ("(inform :X-a -)", (1, 14), "a word, a string, a number, a moment or '(' is wanted here, not -"),
        ("(inform :X-a " + "(" * 100_000, (1, 63), "it is nested more than 50 deep"),
        (b"(inform :X-a \xff)", (1, 14), "it is not UTF-8: invalid start byte"),
        (b'(inform :language #1"\xff)', (1, 19), "what stands here is not a text in UTF-8"),
    ],
)
def test_what_is_no_message_is_told_with_its_place(
    text: str | bytes, place: tuple[int, int], reason: str
) -> None:
    with pytest.raises(AclTextError) as problem:
        loads(text)
    assert problem.value.reason == reason
    assert (problem.value.line, problem.value.column) == place


@pytest.mark.parametrize(
    ("message", "reason"),
    [
        (FipaMessage("in form"), "'in form' is not a word"),
        (FipaMessage("inform", AgentIdentifier("7up")), "'7up' is not a word"),
        (FipaMessage("inform", AgentIdentifier("a", ("x y",))), "'x y' cannot be an address"),
        (FipaMessage("inform", protocol="a b"), "'a b' is not a word"),
        (FipaMessage("inform", parameters=(("a b", 1),)), "'a b' cannot be the name"),
        (FipaMessage("inform", parameters=(("Sender", 1),)), "'Sender' cannot be the name"),
        (FipaMessage("inform", parameters=(("X-a", 1), ("x-a", 1))), "'x-a' cannot be the name"),
        (
            FipaMessage("inform", parameters=(("X-a", float("inf")),)),
            "inf is nothing that a parameter can be",
        ),
        (FipaMessage("inform", parameters=(("X-a", 10**5000),)), "a number is too large"),
        (FipaMessage("inform", parameters=(("X-a", None),)), "None is nothing that a parameter can be"),
        (FipaMessage("inform", content="\ud800"), "is not a text: surrogates not allowed"),
        (FipaMessage("inform", reply_by=Span(days=100)), "has more than FIPA's digits can say"),
    ],
)
def test_what_has_no_text_is_told(message: FipaMessage, reason: str) -> None:
    with pytest.raises(AclTextError, match=reason.replace("(", r"\(")):
        dumps(message)


def test_what_is_nested_for_ever_has_no_text() -> None:
    deep: Any = ()
    agent = AgentIdentifier("a")
    for _ in range(1000):
        deep, agent = (deep,), AgentIdentifier("a", (), (agent,))
    for message in (FipaMessage("inform", agent), FipaMessage("inform", parameters=(("X-a", deep),))):
        with pytest.raises(AclTextError, match="nested more than"):
            dumps(message)


# ---- there and back ------------------------------------------------------------------------------

texts = st.text(st.characters(exclude_categories=["Cs"]), max_size=20)
words = st.from_regex(r'[^\x00-\x20()#0-9\-@":+][^\x00-\x20()]{0,10}', fullmatch=True).filter(
    lambda text: not any("\ud800" <= letter <= "\udfff" for letter in text)
)
names = words.map(lambda text: "X-" + text)
moments = st.datetimes(
    timezones=st.one_of(st.none(), st.integers(-12, 12).map(lambda hours: timezone(timedelta(hours=hours))))
).map(lambda moment: moment.replace(microsecond=moment.microsecond // 1000 * 1000))
spans = st.builds(
    Span,
    st.integers(0, 9999),
    st.integers(0, 99),
    st.integers(0, 99),
    st.integers(0, 99 * 3_600_000),
    st.sampled_from([1, -1]),
)
atoms = st.one_of(
    texts,
    words.map(Word),
    st.binary(max_size=20).map(lambda data: _text_or_bytes(data)),
    st.integers(),
    st.floats(allow_nan=False, allow_infinity=False),
    moments,
    spans,
)
values = st.recursive(atoms, lambda inner: st.lists(inner, max_size=4).map(tuple), max_leaves=8)


def _text_or_bytes(data: bytes) -> str | bytes:
    try:
        return data.decode()
    except UnicodeDecodeError:
        return data


def parameters() -> st.SearchStrategy[tuple[tuple[str, Any], ...]]:
    return st.lists(st.tuples(names, values), max_size=3, unique_by=lambda item: item[0].lower()).map(tuple)


addresses = st.from_regex(r"http://[a-z0-9.:/]{1,10}", fullmatch=True)
agents = st.recursive(
    st.builds(AgentIdentifier, words, st.lists(addresses, max_size=2).map(tuple)),
    lambda inner: st.builds(
        AgentIdentifier,
        words,
        st.lists(addresses, max_size=2).map(tuple),
        st.lists(inner, max_size=2).map(tuple),
        parameters(),
    ),
    max_leaves=4,
)
messages = st.builds(
    FipaMessage,
    st.from_regex("[a-z][a-z-]{0,10}", fullmatch=True),
    st.none() | agents,
    st.lists(agents, max_size=3).map(tuple),
    st.none() | texts | st.binary(max_size=20).map(_text_or_bytes),
    st.lists(agents, max_size=2).map(tuple),
    texts,
    texts,
    texts,
    st.just("") | words,
    texts,
    texts,
    texts,
    st.none() | moments | spans,
    parameters(),
)


@settings(max_examples=EXAMPLES, deadline=None)
@given(messages)
def test_what_is_written_is_read(message: FipaMessage) -> None:
    assert loads(dumps(message)) == message


@settings(max_examples=200, deadline=None)
@given(st.binary(max_size=200) | texts)
@example(b'(a :x "\\')
def test_whatever_comes_is_a_message_or_told(data: bytes | str) -> None:
    try:
        message = loads(data)
    except AclTextError as problem:
        assert problem.reason and 0 <= problem.position <= len(
            data.encode() if isinstance(data, str) else data
        )
    else:
        assert loads(dumps(message)) == message


@settings(max_examples=EXAMPLES, deadline=None)
@given(
    messages,
    st.lists(
        st.tuples(
            st.integers(0, 10**6),
            st.integers(0, 10),
            st.sampled_from([b"", b"(", b")", b'"', b"\\", b'#9"', b":", b" ", b"\xff"]),
        ),
        min_size=1,
        max_size=4,
    ),
)
def test_a_damaged_message_is_a_message_or_told(
    message: FipaMessage, damage: list[tuple[int, int, bytes]]
) -> None:
    data = dumps(message)
    for place, length, instead in damage:
        place %= len(data) + 1
        data = data[:place] + instead + data[place + length :]
    try:
        found = loads(data)
    except AclTextError as problem:
        assert problem.reason and 0 <= problem.position <= len(data)
    else:
        assert isinstance(found, FipaMessage)


def test_long_texts_are_read() -> None:
    text = b'(inform :content "' + b'\\"a' * 100_000 + b'" :X-a (' + b'b "c" 1 ' * 100_000 + b"))"
    message = loads(text)
    assert message.content == '"a' * 100_000
    assert message.parameters == (("X-a", (Word("b"), "c", 1) * 100_000),)
