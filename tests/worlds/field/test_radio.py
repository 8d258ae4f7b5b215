"""A team's radio: what it takes, what it loses, and when it delivers."""

from __future__ import annotations

import random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aseme_dsl.runtime.world.body import RadioMessage
from aseme_dsl.worlds.field.radio import Radio, RadioCount, RadioSettings

STEP_NS = 10_000_000
SECOND = 1_000_000_000
TEAM = ("a", "b", "c", "d")


@pytest.mark.parametrize("loss", [0.0, 0.1, 0.5, 1.0])
def test_as_many_messages_get_lost_as_stated_for_each_mate(loss: float) -> None:
    radio, chance = Radio(TEAM, RadioSettings(loss=loss)), random.Random(11)
    heard = dict.fromkeys(TEAM, 0)
    number = 1500
    for turn in range(number):
        now_ns = turn * SECOND
        assert radio.say("a", turn.to_bytes(2, "big"), now_ns)
        for step in range(1, 10):
            radio.carry(now_ns + step * STEP_NS, STEP_NS, chance)
        for name in TEAM:
            heard[name] += len(radio.hear(name))
    assert heard.pop("a") == 0
    for count in heard.values():
        assert count / number == pytest.approx(1 - loss, abs=0.04)
    assert radio.count == RadioCount(number, 0, sum(heard.values()), 3 * number - sum(heard.values()))


def test_a_message_comes_within_the_stated_delay() -> None:
    settings = RadioSettings(loss=0.0, interval_ns=0)
    radio, chance = Radio(TEAM, settings), random.Random(5)
    delays: list[int] = []
    for turn in range(300):
        said_ns = turn * SECOND
        radio.say("a", b"x", said_ns)
        for step in range(1, 12):
            now_ns = said_ns + step * STEP_NS
            radio.carry(now_ns, STEP_NS, chance)
            delays += [now_ns - said_ns] * sum(len(radio.hear(name)) for name in TEAM)
    assert len(delays) == 900
    # It is heard at the end of the step in which it arrived.
    assert settings.shortest_delay_ns <= min(delays)
    assert max(delays) <= settings.longest_delay_ns
    assert len(set(delays)) > 3


@given(st.lists(st.integers(0, 300_000_000), max_size=60), st.integers(1, 6))
def test_no_robot_says_more_than_its_rate(pauses: list[int], burst: int) -> None:
    settings = RadioSettings(burst=burst)
    radio = Radio(TEAM, settings)
    now_ns = 0
    said: list[int] = []
    for pause in pauses:
        now_ns += pause
        if radio.say("a", b"x", now_ns):
            said.append(now_ns)
    for first, start in enumerate(said):
        for last in range(first, len(said)):
            most = burst + (said[last] - start) // settings.interval_ns + 1
            assert last - first + 1 <= most
    # Each has its own rate.
    assert radio.say("b", b"x", now_ns)
    assert radio.count.said + radio.count.refused == len(pauses) + 1


def test_a_refused_robot_may_speak_again_after_the_interval() -> None:
    radio = Radio(TEAM, RadioSettings(burst=1))
    assert radio.say("a", b"", 0)
    assert not radio.say("a", b"", 99_999_999)
    assert radio.say("a", b"", 100_000_000)


def test_the_order_of_calls_within_a_step_does_not_matter() -> None:
    def hear(order: tuple[str, ...]) -> list[list[RadioMessage]]:
        radio, chance = Radio(TEAM, RadioSettings()), random.Random(9)
        for step in range(1, 40):
            for name in order:
                radio.say(name, bytes([step]), (step - 1) * STEP_NS)
            radio.carry(step * STEP_NS, STEP_NS, chance)
        return [radio.hear(name) for name in TEAM]

    assert hear(TEAM) == hear(TEAM[::-1])


def test_a_payload_that_is_too_long_is_refused_and_costs_nothing() -> None:
    radio = Radio(TEAM, RadioSettings(payload_limit=4, burst=1))
    with pytest.raises(ValueError, match="5 bytes; the radio takes 4"):
        radio.say("a", b"12345", 0)
    assert radio.say("a", b"1234", 0)


@pytest.mark.parametrize(
    "make",
    [
        lambda: RadioSettings(loss=1.5),
        lambda: RadioSettings(loss=-0.1),
        lambda: RadioSettings(shortest_delay_ns=2, longest_delay_ns=1),
        lambda: RadioSettings(shortest_delay_ns=-1),
        lambda: RadioSettings(payload_limit=0),
        lambda: RadioSettings(burst=0),
        lambda: RadioSettings(interval_ns=-1),
    ],
)
def test_settings_that_mean_nothing_are_refused(make: object) -> None:
    assert callable(make)
    with pytest.raises(ValueError):
        make()
