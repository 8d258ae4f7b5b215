"""Streams: whatever a link loses, doubles and reorders, all arrives once and in order."""

from __future__ import annotations

import itertools
import os
import random
import sys

from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.runtime.transport.stream import (
    EARLY,
    LONGEST,
    PATIENCE,
    RECENT,
    WAITING,
    WINDOW,
    Incoming,
    Letter,
    Outgoing,
    Samples,
)

EXAMPLES = int(os.environ.get("STREAM_EXAMPLES", "50"))
"""How many runs are tried; `python3 dev.py long` tries more."""


@settings(max_examples=EXAMPLES, deadline=None)
@given(
    count=st.integers(1, 700),
    seed=st.integers(0, 10**6),
    loss=st.floats(0, 0.4),
    doubling=st.floats(0, 0.3),
)
def test_all_arrive_once_and_in_order(count: int, seed: int, loss: float, doubling: float) -> None:
    chance = random.Random(seed)
    out, into = Outgoing[int](), Incoming[int]()
    got: list[int] = []
    air: list[tuple[int, int]] = []  # what is on its way
    now = 0

    def send(place: int, item: int) -> None:
        if chance.random() >= loss:
            air.append((place, item))
        if chance.random() < doubling:
            air.append((place, item))

    sent = 0
    for _ in range(100_000):
        if sent < count:
            assert out.put(Letter(sent, 100)) == []
            sent += 1
        for place, letter in out.ready(now):
            send(place, letter.item)
        while air and chance.random() < 0.7:
            place, item = air.pop(chance.randrange(len(air)))
            got += into.take(place, item) or []
        if chance.random() < 0.2 and chance.random() >= loss:
            for place, letter in out.acknowledge(into.upto, into.missing(), now):
                send(place, letter.item)
        now += PATIENCE // 20
        for place, letter in out.overdue(now):
            send(place, letter.item)
        if sent == count and not len(out):
            break
    assert got == list(range(count))


def test_only_so_much_is_on_its_way() -> None:
    out = Outgoing[int]()
    for number in range(2 * WINDOW):
        out.put(Letter(number, 1))
    assert len(list(out.ready(0))) == WINDOW
    assert list(out.ready(0)) == []
    out.acknowledge(10, (), 0)
    assert [place for place, _ in out.ready(0)] == list(range(WINDOW + 1, WINDOW + 11))


def test_a_large_letter_goes_alone() -> None:
    out = Outgoing[str]()
    out.put(Letter("small", 10))
    out.put(Letter("large", 10_000_000))
    assert [letter.item for _, letter in out.ready(0)] == ["small"]
    out.acknowledge(1, (), 0)
    assert [letter.item for _, letter in out.ready(0)] == ["large"]


def test_a_newer_state_takes_the_place_of_one_that_waits() -> None:
    out = Outgoing[str]()
    for number in range(WINDOW):
        out.put(Letter(str(number), 1))
    list(out.ready(0))
    out.put(Letter("old", 1, replaces="state"))
    assert [letter.item for letter in out.put(Letter("new", 1, replaces="state"))] == ["old"]


def test_the_oldest_is_given_up_when_too_many_wait() -> None:
    out = Outgoing[int]()
    for number in range(WAITING):
        assert out.put(Letter(number, 1)) == []
    assert [letter.item for letter in out.put(Letter(-1, 1))] == [0]


def test_a_new_life_begins_with_what_waits() -> None:
    out = Outgoing[int]()
    for number in range(WINDOW + 2):
        out.put(Letter(number, 1))
    list(out.ready(0))
    flying, waiting = out.restart()
    assert [letter.item for letter in flying] == list(range(WINDOW))
    assert [letter.item for letter in waiting] == [WINDOW, WINDOW + 1]
    out.put(waiting[0])
    assert [place for place, _ in out.ready(0)] == [1]


def test_attempts_become_rarer_until_something_arrives() -> None:
    out = Outgoing[int]()
    out.put(Letter(1, 1))
    list(out.ready(0))
    moments = [now for now in range(0, 8_000_000_000, 10_000_000) if out.overdue(now)]
    gaps = [later - earlier for earlier, later in itertools.pairwise(moments)]
    assert moments[0] == PATIENCE
    assert gaps == sorted(gaps) and gaps[-1] == LONGEST
    out.hurry()
    assert out.overdue(8_000_000_001)


def test_what_is_far_too_early_is_not_kept() -> None:
    into = Incoming[int]()
    assert into.take(EARLY + 1, 1) is None
    assert into.take(2, 2) == []
    assert into.missing() == (1,)
    assert into.take(1, 1) == [1, 2]


@given(st.lists(st.integers(1, 3 * RECENT), max_size=60), st.integers(0, 10**9))
def test_samples_are_taken_once_and_gaps_counted(steps: list[int], base: int) -> None:
    """Whatever comes in whatever order; what is too old to be remembered counts as known."""
    samples, come, newest = Samples(), set[int](), 0
    for step in steps:
        number = base + step
        found = samples.take(number)
        if number in come or number <= newest - RECENT:
            assert found is None
        elif number < newest:
            assert found == -1
        else:
            assert found == number - newest - 1
        come.add(number)
        newest = max(newest, number)


def test_what_is_remembered_of_samples_does_not_grow() -> None:
    samples = Samples()
    sizes = set()
    for number in range(1, 4 * RECENT):
        samples.take(number)
        if number >= RECENT // 8:
            sizes.add(sum(sys.getsizeof(getattr(samples, name)) for name in samples.__slots__))
    assert max(sizes) < 1000
