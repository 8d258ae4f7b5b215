"""A team on a platform with others: who is there, what outsiders say and hear, who pretends."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Sequence
from typing import Any

import pytest

from aseme_dsl.runtime.platform.over_platform import PlatformLink
from aseme_dsl.runtime.platform.platform import Receives
from tests.runtime.platform.square import Square
from tests.runtime.transport.net import part
from tests.runtime.transport.test_parts import NET
from tests.support.generated import Generated, generate
from tests.support.waiting import LONG, wait_until

TEAM = ("ann", "bob", "cat")
ALICE = "alice@square/1"


@pytest.fixture(scope="module")
def net() -> Generated:
    return generate(NET)


@pytest.fixture
def square() -> Square:
    return Square(TEAM)


def link(square: Square, lease: float = LONG) -> PlatformLink:
    return PlatformLink(square.platform(), "Net", TEAM, lease=lease)


def said_to(square: Square, who: str) -> list[tuple[dict[str, str], Any]]:
    return [
        (headers, json.loads(body or "null"))
        for _, to, headers, body in list(square.heard)
        if to.startswith(who)
    ]


def test_an_outsider_takes_part_in_a_conversation(net: Generated, square: Square) -> None:
    bob = part(net, ["bob"], {}, link(square)).start()
    wait_until(lambda: square.sites)
    cfp = {"performative": "cfp", "protocol": "net", "conversation-id": "c1", "reply-with": "q1"}
    square.say(ALICE, "bob@square", cfp, '{"n": 3}')
    wait_until(lambda: said_to(square, "alice"))
    bob.stop()
    ((headers, content),) = said_to(square, "alice")
    assert content == {"cost": 0}
    assert headers["performative"] == "propose"
    assert (headers["conversation-id"], headers["protocol"], headers["in-reply-to"]) == ("c1", "net", "q1")
    (received,) = bob.of("received")
    assert received["input"][0] == "alice@square" and received["content"] == {"n": 3}


@pytest.mark.parametrize(
    ("said", "reason"),
    [("soon", "'soon' is not a date and time"), ("0001-01-01", "0001-01-01 00:00:00 is out of reach")],
)
def test_a_deadline_that_cannot_be_read_is_told(
    net: Generated, square: Square, monkeypatch: pytest.MonkeyPatch, said: str, reason: str
) -> None:
    monkeypatch.setenv("TZ", "Asia/Tokyo")  # where the year 1 began before the year 1
    time.tzset()
    bob = part(net, ["bob"], {}, link(square)).start()
    wait_until(lambda: square.sites)
    square.say(ALICE, "bob@square", {"performative": "cfp", "protocol": "net", "reply-by": said}, '{"n": 3}')
    wait_until(lambda: said_to(square, "alice"))
    bob.stop()
    monkeypatch.undo()
    time.tzset()
    ((answer, _),) = said_to(square, "alice")
    assert answer["performative"] == "propose"  # a deadline is a wish: the message means the same without
    (received,) = bob.of("received")
    assert "reply_by" not in received
    (fault,) = bob.of("fault")
    assert fault["agent"] == "bob"
    assert fault["reason"] == f"cfp of alice@square is taken without its deadline: {reason} (reply-by)"


@pytest.mark.parametrize(
    ("headers", "body", "reason"),
    [
        ({"performative": "shout"}, "{}", "FIPA has no performative shout"),
        ({}, "hello", "FIPA has no performative"),
        ({"performative": "cfp", "protocol": "net"}, '{"n": "three"}', "n: a int is wanted"),
        ({"performative": "cfp", "protocol": "net"}, "n = 3", "the content is not JSON"),
        ({"performative": "inform", "protocol": "net"}, "{}", "worker receives no inform"),
        ({"performative": "cfp", "protocol": "chess"}, "{}", "bob plays no part in chess"),
    ],
)
def test_what_means_nothing_is_not_understood(
    net: Generated, square: Square, headers: dict[str, str], body: str, reason: str
) -> None:
    bob = part(net, ["bob"], {}, link(square)).start()
    wait_until(lambda: square.sites)
    square.say(ALICE, "bob@square", {**headers, "reply-with": "q7"}, body)
    wait_until(lambda: said_to(square, "alice"))
    bob.stop()
    ((answer, content),) = said_to(square, "alice")
    assert answer["performative"] == "not-understood" and answer["in-reply-to"] == "q7"
    assert reason in content["reason"]
    (unexpected,) = bob.of("unexpected")
    assert reason in unexpected["reason"]


def test_a_stranger_that_speaks_as_if_of_the_team_is_refused_and_told(net: Generated, square: Square) -> None:
    boss = part(net, ["ann"], {}, link(square)).start()
    workers = part(net, ["bob"], {}, link(square)).start()
    wait_until(lambda: boss.of("received", performative="propose"))
    # Mallory has heard what is said on the square, and says it again from an address of his own.
    envelope = {"kind": 1, "check": 0, "incarnation": 1}
    copy = {"performative": "cfp", "reply-with": "ann-1", "aseme": json.dumps(envelope)}
    square.say("mallory@square/1", "bob@square", copy, "{}")
    square.say("mallory@square/1", "bob@square", {"aseme": json.dumps({"bye": 1})})
    wait_until(lambda: said_to(square, "mallory"))
    workers.stop()
    boss.stop()
    ((answer, _),) = said_to(square, "mallory")
    assert answer["performative"] == "not-understood" and answer["in-reply-to"] == "ann-1"
    assert "mallory@square untrusted" in workers.news()
    assert len(workers.of("received")) == 1


def test_who_says_nothing_for_a_lease_is_gone_and_comes_back(net: Generated, square: Square) -> None:
    bob = part(net, ["bob"], {}, link(square, lease=1.0)).start()
    cat = part(net, ["cat"], {}, link(square, lease=1.0)).start()
    wait_until(lambda: cat.team.transport.is_there("bob") and bob.team.transport.is_there("cat"))
    square.silent = True
    wait_until(lambda: not cat.team.transport.is_there("bob") and not bob.team.transport.is_there("cat"))
    square.silent = False
    wait_until(lambda: cat.team.transport.is_there("bob") and bob.team.transport.is_there("cat"))
    bob.stop()
    wait_until(lambda: not cat.team.transport.is_there("bob"))  # it has taken leave
    cat.stop()
    there, *between, left = cat.news("connected", "gone", "reconnected")
    assert (there, left) == ("bob connected", "bob gone")
    # more than once where the machine stood still for a lease
    assert between and between == ["bob gone", "bob reconnected"] * (len(between) // 2)


@pytest.mark.parametrize(
    "said",
    [
        "[",
        "{}",
        '{"here": {"bob": 1}, "life": 1}',
        '{"here": {"cat": "mallory@square/1"}, "life": 1}',
        '{"here": [], "life": 1}',
        '{"question": 1}',
        '{"answer": "x"}',
        '{"bye": []}',
        '{"kind": 1}',
        '{"here": {}, "life": "1"}',
    ],
)
def test_nonsense_from_an_address_of_the_team_is_harmless(net: Generated, square: Square, said: str) -> None:
    bob = part(net, ["bob"], {}, link(square)).start()
    wait_until(lambda: square.sites)
    square.say("cat@square/9", "bob@square", {"aseme": said})
    cat = part(net, ["cat"], {}, link(square)).start()
    wait_until(lambda: bob.team.transport.is_there("cat"))
    cat.stop()
    bob.stop()
    assert bob.result is not None and not bob.result.failed


def test_what_is_too_large_is_told_and_not_sent(square: Square) -> None:
    long = "x" * 20_000
    text = NET.replace("message Task { int n }", "message Task { string n }")
    net = generate(text.replace("send cfp Task { .. } to", f'send cfp Task {{ n = "{long}" }} to'))
    boss = part(net, ["ann"], {}, link(square)).start()
    wait_until(lambda: boss.of("fault"))
    boss.stop()
    assert "at the most 10000 travel here" in str(boss.of("fault")[0])


def test_what_comes_while_others_of_the_process_connect_waits(net: Generated, square: Square) -> None:
    """The thread that brings it may be the one that connects them: it must not wait for the beginning."""
    boss = part(net, ["ann"], {}, link(square)).start()
    wait_until(lambda: square.sites)
    platform = square.platform()
    start = platform.start
    heard = threading.Event()

    def slow(agents: Sequence[str], receives: Receives) -> None:
        start(agents[:1], receives)
        said = {"performative": "cfp", "protocol": "net", "reply-with": "q1"}
        receives.came("bob", "alice@square/1", said, '{"n": 1}')
        heard.set()
        start(agents[1:], receives)

    platform.start = slow  # type: ignore[method-assign]
    workers = part(net, ["bob", "cat"], {}, PlatformLink(platform, "Net", TEAM, lease=LONG)).start()
    wait_until(lambda: workers.of("received"))
    assert heard.is_set() and workers.of("received")[0]["input"][0] == "alice@square"
    wait_until(lambda: boss.of("received"))
    workers.stop()
    boss.stop()
