"""The outside of what travels between robots."""

from __future__ import annotations

import hmac
from typing import get_type_hints

import pytest

from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.envelope import Envelope, EnvelopeError


def test_every_member_travels() -> None:
    lists = {"parts": (("asker", ("ann", "cat")),), "missing": (4, 6)}
    given: dict[str, object] = {}
    for number, (name, type_) in enumerate(get_type_hints(Envelope).items(), 1):
        plain = number if type_ is int else f"text {number}"
        given[name] = lists.get(name, (f"a {number}", "b") if type_ not in (int, str) else plain)
    full = Envelope(**{**given, "kind": envelopes.MAIL})  # type: ignore[arg-type]
    assert envelopes.read(envelopes.written(full, b"x"), b"x").reply_to == full.reply_to
    sent = envelopes.written(full, b"x", addressee=full.addressee, place=full.place, sample=full.sample)
    assert envelopes.read(sent, b"x") == full


def test_numbers_of_members_never_change() -> None:
    """A robot of last year reads them by number."""
    numbers = {item.name: item.number for item in envelopes._proto().DESCRIPTOR.fields}
    assert [name for name, _ in sorted(numbers.items(), key=lambda item: item[1])] == (
        "format kind incarnation addressee place sample sequence time clock channel host check "
        "performative message protocol conversation participant to parts receivers upto missing asked heard "
        "in_reply_to reply_with reply_by reply_to language encoding ontology contract reason"
    ).split()
    # 3 was a field once, and 33 stands behind all others.
    assert sorted(numbers.values()) == [1, 2, *range(4, 33), 34, 35]


def test_another_payload_is_refused() -> None:
    with pytest.raises(EnvelopeError):
        envelopes.read(envelopes.written(Envelope(envelopes.MAIL), b"x"), b"y")


@pytest.mark.parametrize("size", [0, 32, 64, 65, 200])
def test_a_proof_is_an_hmac(size: int) -> None:
    secret = bytes(range(size))
    assert envelopes.mac(secret, b"a", b"", b"bc" * 99) == hmac.digest(secret, b"a" + b"bc" * 99, "sha256")
