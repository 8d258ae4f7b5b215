"""`asemec prove` on "at most one": by what each agent must have heard, and what activities guarantee."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.cli.support import Here

LEASE = """\
system Lease
message Order { int to }
message Identity { int number }
topic team { state Order }
topic my { state Identity }
srm boss {
  liveness { boss = Give~ }
  activities {
    Give takes 1s simulated writes team.state.Order
         guarantees no sent Order b [b.to != 0 && b.to != a.to] within 2s after sent Order a [a.to != 0]
  }
}
srm worker {
  liveness { worker = (Rest . Work)~ }
  let mine = age(team.state.Order) < 1700ms && team.state.Order.to == my.state.Identity.number
  control worker { enter Work : [mine]  repeat (Rest . Work) :  leave Work : when [!mine] }
  activities { Rest takes 100ms simulated  Work waits }
}
team Lease { one : boss  two, three : worker }
property "one works" {
  assume network delay 0..300ms
  assume two has [my.state.Identity.number == 2]
  assume three has [my.state.Identity.number == 3]
  at most one Work
}
"""
"""Who has heard an order that is not too old works."""

TOPIC = "topic team { state Order }"
PROMISE = "guarantees no sent Order b [b.to != 0 && b.to != a.to] within 2s after sent Order a [a.to != 0]"


def asked(here: Here, folder: Path, changes: tuple[str, ...]) -> tuple[str, str]:
    """The verdict on a changed file, and what the line says."""
    text = LEASE
    for old, new in zip(changes[::2], changes[1::2], strict=True):
        assert old in text
        text = text.replace(old, new)
    (folder / "lease.aseme").write_text(text)
    done = here("prove", "lease.aseme", "one works", "--budget", "1500ms", "--robots", "5")
    assert "one works of team" in done.out, done.out + done.err
    return done.out.split()[0], done.out


@pytest.mark.parametrize(
    "changes",
    [
        (),
        ("< 1700ms", "< 2s"),  # just long enough
        ("two, three : worker", "two, three, four, five : worker"),  # four and five: see below
        (TOPIC, "topic team radio 10 { state Order }"),
        (TOPIC, "topic team radio 10 delay 100ms { state Order }", "< 1700ms", "< 1800ms"),
        ("at most one Work", "assume at most 1 of worker crash  at most one Work"),
        # The age of a message counts from when it was sent, also of one that is late.
        ("0..300ms", "0..300ms loss 10%"),
        ("assume network delay 0..300ms", ""),
    ],
)
def test_it_is_proved_where_leases_do_not_overlap(here: Here, folder: Path, changes: tuple[str, ...]) -> None:
    if "four" in "".join(changes):
        numbers = " ".join(
            f"assume {name} has [my.state.Identity.number == {n}]" for n, name in ((4, "four"), (5, "five"))
        )
        changes = (*changes, "at most one Work", f"{numbers} at most one Work")
    verdict, text = asked(here, folder, changes)
    assert verdict == "PROVED", text
    assert "Give guarantees no sent Order b" in text
    assert "each agent alone" in text


FAULTS: list[tuple[str, ...]] = [
    ("< 1700ms", "< 2001ms"),
    ("< 1700ms", "<= 2s"),
    ("within 2s", "within 1699ms"),
    ("0..300ms", "0..2001ms", TOPIC, "topic team radio 10 { state Order }"),
    ("[b.to != 0 &&", "[b.to == 2 &&"),
    ("[a.to != 0]", "[a.to == 3]"),
    (PROMISE, ""),
    ("one : boss ", "one, other : boss "),
    ("assume three has [my.state.Identity.number == 3]", ""),
    ("three has [my.state.Identity.number == 3]", "three has [my.state.Identity.number == 2]"),
    ("three has [my.state.Identity.number == 3]", "three has [my.state.Identity.number > 2]"),
    ("leave Work : when [!mine]", ""),
    (TOPIC, "topic team radio 10 { state Order }", "< 1700ms", "< 1701ms"),
    (TOPIC, "topic team radio 10 delay 100ms { state Order }", "< 1700ms", "< 1801ms"),
    ("Rest takes 100ms simulated", "Rest takes 100ms simulated writes team.state.Order"),
    ("{ state Order }", "{ state Order from boss, outside }"),
    ("{ state Order }", "{ state Order persist }"),
    ("age(team.state.Order) < 1700ms &&", ""),
    ("age(team.state.Order) < 1700ms &&", "age(team.state.Order) < 1700ms ||"),
    ("enter Work : [mine]", "enter Work :", "leave Work : when [!mine]", ""),
    (
        "boss = Give~",
        "boss = Wait . Give~",
        "takes 1s simulated writes",
        "takes 1s simulated writes",
        "    Give takes",
        "    Wait waits\n    Give takes",
    ),
    ("enter Work : [mine]", "enter Work : [mine && team.state.Order.to == 9]"),
]


@pytest.mark.parametrize("changes", FAULTS if "CERTIFICATES" in os.environ else FAULTS[::3])
def test_planted_faults_are_never_proved(here: Here, folder: Path, changes: tuple[str, ...]) -> None:
    verdict, text = asked(here, folder, changes)
    assert verdict != "PROVED", text


def test_one_that_depends_on_a_signal_is_not_missed(here: Here, folder: Path) -> None:
    """A signal may be there at any look, also one that came before."""
    changes = (
        "age(team.state.Order) < 1700ms && team.state.Order.to == my.state.Identity.number",
        "go.signal.Start.now",
        "topic my",
        "message Start { bool now }\ntopic go { signal Start }\ntopic my",
        "leave Work : when [!mine]",
        "",
    )
    verdict, text = asked(here, folder, changes)
    assert verdict != "PROVED", text
