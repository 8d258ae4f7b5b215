"""The simulated links: what they lose, double and put out of order, and what comes of it above them."""

from __future__ import annotations

import pytest

from aseme_dsl.runtime.driver.virtual import VirtualDriver
from aseme_dsl.runtime.team.faults import Faults, Links, Partition
from aseme_dsl.runtime.trace.trace import Record, Trace
from tests.runtime.playing import MS, SECOND


def sent(kind: str, faults: Faults, count: int = 200) -> tuple[list[int], list[Record], int]:
    """The numbers that arrive of those sent, one each 10 ms, what is told, how often the link was used."""
    records: list[Record] = []
    driver = VirtualDriver()
    links = Links(faults, driver, Trace(None, [records.append]))
    got: list[int] = []
    used = 0
    whole = links._transmit

    def counted(*arguments: object) -> bool:
        nonlocal used
        used += 1
        return whole(*arguments)  # type: ignore[arg-type]

    links._transmit = counted  # type: ignore[method-assign]

    def send(number: int) -> None:
        links.carry("a", "b", kind, "t.c.M", ("a", number), lambda: got.append(number))

    for number in range(count):
        driver.at(number * 10 * MS, lambda number=number: send(number))  # type: ignore[misc]
    driver.run()
    return got, records, used


@pytest.mark.parametrize("kind", ["signal", "state", "mail"])
def test_the_stream_brings_all_once_and_in_order(kind: str) -> None:
    bad = Faults(
        3, loss=0.4, duplication=0.3, delay=80 * MS, partitions=(Partition(frozenset("a"), SECOND, SECOND),)
    )
    got, told, used = sent(kind, bad)
    assert got == list(range(200))
    assert not told
    assert used > 400  # much was lost, and sent again


def test_on_a_good_link_nothing_is_sent_twice() -> None:
    got, _, used = sent("signal", Faults(), 100)
    assert got == list(range(100))
    assert used < 200  # with the acknowledgements


def test_of_samples_some_are_lost_and_none_is_doubled() -> None:
    got, told, used = sent("data", Faults(3, loss=0.3, duplication=0.3, delay=80 * MS))
    assert used == 200
    assert len(set(got)) == len(got) < 200
    assert got != sorted(got)
    assert {*got, *(line["input"][1] for line in told)} == set(range(200))
    assert len(got) + len(told) == 200


def test_nothing_is_left_to_do_when_all_has_arrived() -> None:
    """Else a run without a time limit would not end."""
    got, _, _ = sent("signal", Faults(1, loss=0.4), 1)
    assert got == [0]
