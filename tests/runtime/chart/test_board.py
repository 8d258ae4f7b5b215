"""Blackboards: what is kept of a data channel, at a cost that does not grow with it; what was seen ahead."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any, ClassVar

from hypothesis import given
from hypothesis import strategies as st

from aseme_dsl.runtime.activity.snapshot import BoardCopy
from aseme_dsl.runtime.chart.board import Board
from aseme_dsl.runtime.chart.inputs import Completed, Sample
from tests.support.generated import generate

CHANNEL = "eyes.data.Seen"


class Eyes(Board):
    """A board that keeps a channel for a while."""

    __slots__ = ("ann", "seen")
    CHANNELS = frozenset({CHANNEL})
    RETENTION: ClassVar = {CHANNEL: 100}
    SLOTS: ClassVar = {CHANNEL: (("seen", None), ("ann", "ann"))}


class Short(Eyes):
    """The same without a history."""

    __slots__ = ()
    RETENTION: ClassVar = {}


def seen(sender: str, moment: int, number: int) -> Sample:
    return Sample(CHANNEL, number, sender, moment, (sender, number))


def kept(history: Sequence[Sample], item: Sample, oldest: int) -> Sequence[Sample]:
    """By the book: with `item` in its place in time, what is in the window, and one of each sender before."""
    place = len(history)
    while place and history[place - 1].time > item.time:
        place -= 1
    history = (*history[:place], item, *history[place:])
    found: list[Sample] = []
    before: set[str] = set()
    for entry in reversed(history):
        if entry.time >= oldest:
            found.append(entry)
        elif entry.sender not in before:
            before.add(entry.sender)
            found.append(entry)
    return tuple(reversed(found))


@given(
    kind=st.sampled_from([Eyes, Short]),
    arrivals=st.lists(
        st.tuples(st.sampled_from(["ann", "bob", "eve"]), st.integers(0, 60), st.integers(0, 250)),
        max_size=16,
    ),
)
def test_what_is_kept_is_the_window_and_one_of_each_sender_before_it(
    kind: type[Eyes], arrivals: list[tuple[str, int, int]]
) -> None:
    """Also when measurements come late, as over a network."""
    board: Any = kind()
    book: Sequence[Sample] = ()
    now = 0
    for number, (sender, passed, late) in enumerate(arrivals):
        now += passed
        item = seen(sender, max(0, now - late), number)
        book = kept(book, item, now - kind.RETENTION.get(CHANNEL, 0))
        board.put(item, now)
        assert board.history(CHANNEL) == book
        assert board.history(CHANNEL, "bob") == tuple(i for i in book if i.sender == "bob")
        assert board.newest(CHANNEL) == book[-1]
        for host in ("ann", "bob"):
            assert board.newest(CHANNEL, host) == next((i for i in reversed(book) if i.sender == host), None)
        assert board.seen == book[-1].message
        for moment in (now, now - 50, now - 150):
            found = next((i.message for i in reversed(book) if i.time <= moment), None)
            assert board.at(CHANNEL, None, moment) == found


def test_a_snapshot_and_a_region_inside_keep_what_they_have() -> None:
    board, inner = Eyes(), Eyes()
    for number in range(5):
        board.put(seen("ann", number * 10, number), number * 10)
    told = board.history(CHANNEL)
    copy = BoardCopy(board, [CHANNEL])
    inner.inherit(board)
    for number in range(5, 40):
        board.put(seen("ann", number * 10, number), number * 10)
    assert [item.message for item in told] == [0, 1, 2, 3, 4]
    assert copy.history(CHANNEL) == inner.history(CHANNEL) == told
    assert [item.message for item in board.history(CHANNEL)] == list(range(28, 40))


def test_a_snapshot_puts_nothing_on_other_boards() -> None:
    board = Eyes()
    board.put(seen("ann", 1, 1), 1)
    assert BoardCopy(board, [CHANNEL]).newest(CHANNEL) is not None
    assert Board().newest(CHANNEL) is None


def test_to_take_in_a_message_costs_the_same_however_many_are_kept() -> None:
    looks = 0

    class Counted(Sample):
        __slots__ = ()

        def __getattribute__(self, name: str) -> Any:
            nonlocal looks
            looks += name == "time"
            return super().__getattribute__(name)

    class Long(Eyes):
        __slots__ = ()
        RETENTION: ClassVar = {CHANNEL: 10**9}

    board = Long()
    for number in range(3000):
        board.put(Counted(CHANNEL, number, "ann", number, ("ann", number)), number)
    assert len(board.history(CHANNEL)) == 3000
    assert looks < 20 * 3000


def test_what_was_read_ahead_and_never_comes_is_forgotten() -> None:
    """In a flood a newer message takes the place of one that waits."""
    text = """
    system S
    message M { int x }
    topic t { state M }
    srm R {
      var n : int = 0
      liveness { R = A+ }
      activities { A takes 1s }
      control R { repeat A : [t.state.M.x < 1000] / n = n + 1; read_messages  leave A : else }
    }
    """
    generated = generate(text)
    chart = generated.chart("R")
    message = generated.messages.M
    first = Sample("t.state.M", message(x=0), "ann", 0, ("ann", 0))
    chart.step(0, [first])
    for number in range(1, 100):
        waits = Sample("t.state.M", message(x=number), "ann", number, ("ann", number))
        chart.pending = partial(tuple, [waits])
        chart.step(number, [Completed("0.2", number)])
    assert chart.variable("n") == 99
    assert sum(len(board.ahead) for board in chart.boards() if board is not None) == 1
