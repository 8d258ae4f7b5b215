"""Envelopes and messages of outsiders as headers and a text, and these as XMPP stanzas: there and back."""

from __future__ import annotations

import json
from datetime import datetime
from typing import Any
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as some

from aseme_dsl.runtime.message.acl import PERFORMATIVES, AgentIdentifier, FipaMessage, fipa_name
from aseme_dsl.runtime.platform import acl_headers, stanza
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.envelope import Envelope, EnvelopeError
from aseme_dsl.runtime.transport.link import Stamp

SYSTEM = "Warehouse"
TEXT = some.text(max_size=30)
NAME = some.text("abcXYZ_é09", min_size=1, max_size=12)
NUMBER = some.integers(0, 2**63)
MOMENT = some.integers(-(2**62), 2**62)


def made(kind: int, **members: Any) -> Envelope:
    """An envelope with no other members than these."""
    return Envelope(kind, **members)


MAIL = some.builds(
    made,
    some.just(envelopes.MAIL),
    contract=NUMBER,
    incarnation=NUMBER,
    sequence=NUMBER,
    time=MOMENT,
    clock=NUMBER,
    performative=some.sampled_from(PERFORMATIVES),
    message=NAME,
    protocol=NAME,
    conversation=NAME,
    participant=NAME,
    to=NAME,
    parts=some.lists(some.tuples(NAME, some.lists(NAME).map(tuple)), max_size=3).map(tuple),
    receivers=some.lists(NAME, max_size=3).map(tuple),
    in_reply_to=TEXT,
    reply_with=some.one_of(some.just(""), NAME),
    reply_by=MOMENT,
    reply_to=some.lists(NAME, max_size=2).map(tuple),
    language=some.sampled_from(["", "fipa-sl"]),
    encoding=some.sampled_from(["", "utf-8"]),
    ontology=some.one_of(some.just(""), some.just("Elsewhere")),
)
OTHER = some.builds(
    made,
    some.sampled_from([envelopes.MESSAGE, envelopes.ACKNOWLEDGE, envelopes.PING, envelopes.PONG]),
    contract=NUMBER,
    incarnation=NUMBER,
    sequence=NUMBER,
    time=MOMENT,
    clock=NUMBER,
    channel=NAME,
    host=TEXT,
    upto=NUMBER,
    missing=some.lists(NUMBER, max_size=4).map(tuple),
    asked=MOMENT,
    heard=MOMENT,
)
STAMP = some.builds(Stamp, NUMBER, NUMBER, NUMBER)
PAYLOAD = some.dictionaries(TEXT, some.one_of(TEXT, some.integers()), max_size=3).map(
    lambda members: json.dumps(members).encode()
)


def through_xml(headers: dict[str, str], body: str) -> tuple[dict[str, str], str]:
    """What is read of what is written."""
    text = stanza.written("bob@localhost/x", headers, body, "chat")
    return stanza.read(ElementTree.fromstring(f"<s xmlns='jabber:client'>{text}</s>")[0])


@given(some.one_of(MAIL, OTHER), STAMP, PAYLOAD)
def test_an_envelope_is_the_same_at_the_other_end(envelope: Envelope, stamp: Stamp, payload: bytes) -> None:
    headers = acl_headers.letter(envelope, stamp, payload, "ann", SYSTEM)
    assert all(isinstance(value, str) for value in headers.values())
    read = acl_headers.read_letter(acl_headers.ours(headers), headers, payload, SYSTEM)
    wanted = envelope._replace(**stamp._asdict())
    if envelope.kind == envelopes.MAIL:
        wanted = wanted._replace(reply_with=read.reply_with)
        assert headers["reply-with"] == (envelope.reply_with or f"ann-{envelope.sequence}")
    assert read == wanted


def test_an_agent_message_is_one_for_everybody() -> None:
    envelope = Envelope(
        envelopes.MAIL,
        contract=0xA1B2,
        incarnation=7,
        sequence=3,
        performative="accept_proposal",
        message="Award",
        protocol="contract_net",
        conversation="contract_net-desk-1",
        participant="manager",
        to="contractor",
        in_reply_to="carrier1-5",
    )
    headers = acl_headers.letter(envelope, Stamp(), b'{"task":"t1"}', "desk", SYSTEM)
    del headers[acl_headers.OURS]
    assert headers == {
        "performative": "accept-proposal",
        "conversation-id": "contract_net-desk-1",
        "protocol": "fipa-contract-net",
        "ontology": "Warehouse",
        "language": "json",
        "reply-with": "desk-3",
        "in-reply-to": "carrier1-5",
        "X-message": "Award",
        "X-participant": "manager",
    }


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"aseme": "no JSON"}, "its header aseme is not JSON"),
        ({"aseme": "[1]"}, "not a JSON object"),
        ({"aseme": '{"kind":1}'}, "its checksum is another"),
        ({"aseme": '{"kind":9,"check":0}'}, "there is no kind 9"),
        ({"aseme": '{"kind":"1","check":0}'}, "its kind is not of the type int"),
        ({"aseme": '{"kind":true,"check":0}'}, "its kind is not of the type int"),
        ({"aseme": '{"kind":1,"check":0,"much":1}'}, "there is no much in an envelope"),
        ({"aseme": '{"kind":1,"check":0,"parts":[["a"]]}'}, "its parts are not participants"),
        ({"aseme": '{"kind":1,"check":0,"receivers":[1]}'}, "its receivers is not a list of str"),
        ({"aseme": '{"kind":1,"check":0}', "performative": "shout"}, "FIPA has no performative shout"),
        ({"aseme": "[" * 100_000}, "is not JSON"),
    ],
)
def test_what_is_no_envelope_is_refused_with_the_reason(change: dict[str, str], reason: str) -> None:
    headers = {"performative": "inform", **change}
    with pytest.raises(EnvelopeError) as problem:
        acl_headers.read_letter(acl_headers.ours(headers), headers, b"", SYSTEM)
    assert reason in str(problem.value)


OUTSIDE = some.builds(
    FipaMessage,
    some.one_of(some.sampled_from([fipa_name(name) for name in PERFORMATIVES]), NAME),
    some.just(AgentIdentifier("alice@localhost")),
    some.just((AgentIdentifier("bob"),)),
    TEXT,
    some.lists(NAME.map(AgentIdentifier), max_size=2).map(tuple),
    language=TEXT,
    ontology=TEXT,
    protocol=TEXT,
    conversation=TEXT,
    reply_with=TEXT,
    in_reply_to=TEXT,
    reply_by=some.one_of(some.none(), some.datetimes(datetime(1, 1, 1), datetime(9999, 1, 1))),
    parameters=some.dictionaries(NAME.map(lambda name: "X-" + name), TEXT, max_size=2).map(
        lambda found: tuple(found.items())
    ),
)


@given(OUTSIDE)
def test_what_an_outsider_says_and_hears_is_the_same(message: FipaMessage) -> None:
    headers, body = acl_headers.said(message)
    assert acl_headers.heard("alice@localhost", "bob", headers, body) == message


@given(some.dictionaries(NAME, some.text(max_size=20), max_size=5), some.text(max_size=50))
def test_a_stanza_says_what_was_written(headers: dict[str, str], body: str) -> None:
    def allowed(text: str) -> str:
        # What XML cannot say is a question mark, and a line ends in one way.
        clean = stanza._FORBIDDEN.sub("?", text)
        return clean.replace("\r\n", "\n").replace("\r", "\n")

    assert through_xml(headers, body) == ({k: allowed(v) for k, v in headers.items()}, allowed(body))


@pytest.mark.parametrize(
    ("xml", "wanted"),
    [
        ("<message/>", ({}, "")),
        ("<message><body>hello</body></message>", ({}, "hello")),
        ("<message><x xmlns='jabber:x:data'><title>another</title></x></message>", ({}, "")),
        (
            "<message><x xmlns='jabber:x:data'><title>spade:x:metadata</title><field/>"
            "<field var='a'/><field var='b'><value/></field></x></message>",
            ({"b": ""}, ""),
        ),
    ],
)
def test_any_message_is_read(xml: str, wanted: Any) -> None:
    assert stanza.read(ElementTree.fromstring(f"<s xmlns='jabber:client'>{xml}</s>")[0]) == wanted


def test_the_reason_why_something_came_back() -> None:
    xml = (
        "<s xmlns='jabber:client'><message type='error'><error type='cancel'>"
        "<service-unavailable xmlns='urn:ietf:params:xml:ns:xmpp-stanzas'/>"
        "<text xmlns='urn:ietf:params:xml:ns:xmpp-stanzas'>nobody</text></error></message></s>"
    )
    assert stanza.condition(ElementTree.fromstring(xml)[0]) == "service-unavailable (nobody)"
