"""What comes twice costs the same each time, however much came before it and whatever waits."""

from __future__ import annotations

import time
from collections.abc import Callable

import pytest

from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.envelope import Envelope, EnvelopeError
from aseme_dsl.runtime.transport.stream import (
    AGAIN,
    EARLY,
    WAITING,
    WINDOW,
    WINDOW_BYTES,
    Incoming,
    Letter,
    Outgoing,
    Samples,
)
from tests.faults.test_network import TEAM, Mouth
from tests.runtime.transport.net import Air, Part, part
from tests.support.generated import Generated, generate
from tests.support.waiting import wait_until
from tests.support.work import instructions


def incoming(received: int) -> Incoming[int]:
    """A receiver that has had so many letters, and as many early ones as it may keep."""
    found: Incoming[int] = Incoming()
    for place in range(1, received + 1):
        found.take(place, place, 10)
    for place in range(received + 2, received + EARLY):
        found.take(place, place, 10)
    return found


@pytest.mark.parametrize("place", [1, 999, 1003], ids=["first", "last", "early"])
def test_a_duplicate_costs_no_more_after_many(place: int) -> None:
    few, many = incoming(1000), incoming(1000)
    for _ in range(5000):
        assert many.take(place, 0, 10) is None
    assert instructions(lambda: many.take(place, 0, 10)) == instructions(lambda: few.take(place, 0, 10))


def sender(flying: int) -> Outgoing[int]:
    out: Outgoing[int] = Outgoing()
    for number in range(flying):
        out.put(Letter(number, 10))
    assert len(list(out.ready(0))) == flying
    return out


def test_an_acknowledgement_that_comes_again_costs_nothing_of_what_is_on_its_way() -> None:
    few, many = sender(2), sender(WINDOW)
    assert instructions(lambda: many.acknowledge(0, (), 0)) == instructions(lambda: few.acknowledge(0, (), 0))


def test_what_is_said_to_be_missing_many_times_is_sent_again_once() -> None:
    out = sender(3)
    again = out.acknowledge(1, [2] * 100_000, AGAIN)
    assert [place for place, _ in again] == [2]
    assert out.acknowledge(1, [2] * 100_000, AGAIN) == []


def test_a_new_state_costs_nothing_of_what_else_waits() -> None:
    few: Outgoing[int] = Outgoing()
    many: Outgoing[int] = Outgoing()
    for number in range(WAITING // 2):
        many.put(Letter(number, 10))
    for out in (few, many):
        out.put(Letter(-1, 10, "state"))
        out.put(Letter(-2, 10, "state"))

    def work(out: Outgoing[int]) -> int:
        return instructions(lambda: out.put(Letter(-3, 10, "state")))

    assert work(many) == work(few)
    assert [letter.item for letter in many.put(Letter(-4, 10, "state"))] == [-3]


def test_early_letters_have_a_largest_size_together() -> None:
    into: Incoming[bytes] = Incoming()
    large = bytes(WINDOW_BYTES)
    kept = [place for place in range(2, 100) if into.take(place, large, len(large)) is not None]
    assert 1 <= len(kept) < 10
    assert into.take(1, b"", 0) == [b"", *[large] * len(kept)]
    assert into.take(into.upto + 2, large, len(large)) == []  # there is room again


def test_a_sample_that_comes_again_costs_no_more_after_many() -> None:
    few, many = Samples(), Samples()
    for samples in (few, many):
        for number in range(1, 3000):
            samples.take(number)
    for _ in range(5000):
        many.take(2500)
    assert instructions(lambda: many.take(2500)) == instructions(lambda: few.take(2500))


def test_an_envelope_says_no_more_to_be_missing_than_can_be_on_its_way() -> None:
    data = envelopes.written(Envelope(envelopes.ACKNOWLEDGE, missing=tuple(range(EARLY + 1))), b"")
    with pytest.raises(EnvelopeError, match="missing"):
        envelopes.read(data, b"")


# ---- a robot ---------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def wire() -> Generated:
    return generate(TEAM)


Again = Callable[[Part, Part], tuple[Envelope, bytes]]


def a_signal(ann: Part, bob: Part, wire: Generated) -> tuple[Envelope, bytes]:
    payload = wire.messages.SCHEMA.encode(wire.message("M", n=1))
    return (
        Envelope(
            envelopes.MESSAGE, bob.post.contract, ann.post.incarnation, bob.post.incarnation, 1, sequence=1,
            time=time.monotonic_ns(), clock=ann.post.state.clock, channel="team.signal.M",
        ),
        payload,
    )  # fmt: skip


def a_ping(ann: Part, bob: Part, wire: Generated) -> tuple[Envelope, bytes]:
    return Envelope(
        envelopes.PING, bob.post.contract, ann.post.incarnation, time=1, clock=ann.post.state.clock
    ), b""


def an_acknowledgement(ann: Part, bob: Part, wire: Generated) -> tuple[Envelope, bytes]:
    return Envelope(
        envelopes.ACKNOWLEDGE, bob.post.contract, ann.post.incarnation, clock=ann.post.state.clock
    ), b""


def of_another_life(ann: Part, bob: Part, wire: Generated) -> tuple[Envelope, bytes]:
    return Envelope(envelopes.MESSAGE, bob.post.contract, 1, channel="team.signal.M"), b""


@pytest.mark.parametrize("what", [a_signal, a_ping, an_acknowledgement, of_another_life])
def test_twice_as_many_duplicates_are_twice_the_work_of_a_robot(
    wire: Generated, what: Callable[[Part, Part, Generated], tuple[Envelope, bytes]]
) -> None:
    mouth = Mouth(wire)
    air = Air()
    ann = part(wire, ["ann"], mouth.activities, air.link()).start()
    bob = part(wire, ["bob"], mouth.activities, air.link()).start()
    wait_until(lambda: bob.team.transport.is_there("ann") and ann.team.transport.is_there("bob"))
    envelope, payload = what(ann, bob, wire)

    def flood(times: int) -> int:
        def send() -> None:
            for _ in range(times):
                bob.post.inbox.arrived("bob", "ann", envelope, payload)

        return instructions(send)

    flood(500)
    once, twice = flood(1000), flood(2000)
    mouth.over.set()
    ann.stop()
    bob.stop()
    assert twice < 2.1 * once
    assert once < 1000 * 1000  # a thousand instructions each, whatever came before
