"""Counting answers between whole agents: all bids are collected, and nobody waits for who cannot answer."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.message.acl import FipaMessage
from tests.runtime.outside import Outside
from tests.runtime.playing import MS, Played, make, play
from tests.support.generated import generate

AUCTION = """
system Market
message Task { string id }
message Bid { double cost }
aip auction {
  participant seller {
    var bids : int = 0
    sends cfp Task, reject_proposal Task
    receives propose Bid
    process = Announce . Collect+ . Choose
  }
  participant bidder [1..*] {
    sends propose Bid, refuse Task
    receives cfp Task, reject_proposal Task
    process = Consider . [Wait]
  }
  control seller {
    enter  Collect+ : / send cfp Task { id = "t1" } to bidder
    leave  Collect  : when [all_answered(bidder)]
    leave  Collect  : after(1min)
    repeat Collect  : propose Bid from bidder / bids = bids + 1
    leave  Choose   : / send reject_proposal Task { id = "t1" } to bidder
  }
  control bidder {
    enter Consider : cfp Task from seller
    enter Wait     : [index < 3] / send propose Bid { cost = index } to seller
    skip  Wait     : else
    leave Wait     : reject_proposal Task from seller
  }
}
srm desk   { plays auction.seller  liveness { desk = seller } }
srm robot  { plays auction.bidder  liveness { robot = bidder }  ACTIVITIES }
srm rude   { plays auction.bidder  liveness { rude = bidder } }
team T { shop : desk  r[1..3] : robot }
"""


def auction(activities: str = "", faults: Iterable[object] = ()) -> Played:
    return play(generate(AUCTION.replace("ACTIVITIES", activities)))


def collected(run: Played) -> list[str]:
    return [line for line in run.activities("start") if "Choose" in line]


def test_who_leaves_without_an_answer_is_not_waited_for() -> None:
    """r3 completes its part in silence: two bids, and no wait for the deadline."""
    run = auction("activities { Consider takes 2s }")
    assert collected(run) == ["2100 start Choose"]
    assert len(run.of("agent_message", performative="propose")) == 2
    assert not run.of("conversation", what="leave", agent="shop")[0].get("untaken")


def test_who_fails_is_not_waited_for() -> None:
    class Consider:
        def execute(self, context: Context) -> None:
            context.wait(1)
            if context.agent != "r1":
                raise RuntimeError("no battery")

    run = play(generate(AUCTION.replace("ACTIVITIES", "")), {"Consider": Consider})
    assert collected(run) == ["1100 start Choose"]


def test_an_unexpected_answer_is_an_answer() -> None:
    """The seller does not list `refuse Task`: it is answered not_understood, and counts."""
    text = AUCTION.replace(
        "skip  Wait     : else", "skip  Wait     : else / send propose Bid { cost = 1 } to seller"
    )
    text = text.replace("ACTIVITIES", "activities { Consider takes 1s }")
    run = play(generate(text))
    assert collected(run) == ["1100 start Choose"]


def test_mail_that_an_activity_takes_counts_and_wakes() -> None:
    text = AUCTION.replace(
        "repeat Collect  : propose Bid from bidder / bids = bids + 1", "repeat Collect  : else"
    )
    text = text.replace("[index < 3] /", "/").replace("skip  Wait     : else\n", "")
    text = text.replace("repeat Collect  : else", "repeat Collect  : [bids > 9]").replace("[Wait]", "Wait")

    class Collect:
        def execute(self, context: Context) -> None:
            for _ in range(12):
                context.receive("propose")
                context.wait(1)

    run = play(generate(text.replace("ACTIVITIES", "activities { Consider takes 1s }")), {"Collect": Collect})
    assert collected(run) == ["4100 start Choose"]


@pytest.mark.parametrize("late", [3, 5])
def test_an_agent_that_stays_silent_is_waited_for(late: int) -> None:
    class Consider:
        def execute(self, context: Context) -> None:
            context.wait(late if context.agent == "r2" else 1)

    run = play(generate(AUCTION.replace("ACTIVITIES", "")), {"Consider": Consider})
    assert collected(run) == [f"{late * 1000 + 100} start Choose"]


STRANGE = {
    "it does not understand": ("not-understood", "{}", {}),
    "it shouts": ("shout", "no", {}),
    "its bid is no bid": ("propose", '{"price": 3}', {}),
    "it refuses what nobody asks": ("refuse", "{}", {}),
    "it names the message alone": ("not-understood", "what?", {"conversation": "", "in_reply_to": "asked"}),
}


@pytest.mark.parametrize("case", STRANGE)
def test_an_external_agent_whose_answer_means_nothing_is_not_waited_for(case: str) -> None:
    act, content, more = STRANGE[case]
    generated = generate(AUCTION.replace("ACTIVITIES", "activities { Consider takes 1s }"))
    team, records = make(generated)
    alice = Outside(team)
    services = {"description": {"services": [{"type": "auction.bidder"}]}, "action": "register"}
    team.conversations.receive_external("df", FipaMessage("request", alice.me, (), json.dumps(services)))

    def answer() -> None:
        asked = alice.heard[-1]
        known: dict[str, Any] = {"conversation": asked.conversation, **more}
        if known.get("in_reply_to"):
            known["in_reply_to"] = asked.reply_with
        team.conversations.receive_external("shop", FipaMessage(act, alice.me, (), content, **known))

    team.driver.at(2000 * MS, answer)
    result = team.run()
    run = Played(team, result, records)
    assert collected(run) == ["2000 start Choose"]
    (told,) = run.of("unexpected", sender="alice@elsewhere")
    assert told["agent"] == "shop"


def test_an_external_agent_that_was_not_asked_answers_for_nobody() -> None:
    generated = generate(AUCTION.replace("ACTIVITIES", "activities { Consider takes 1s }"))
    team, records = make(generated, agents=[("shop", "desk"), ("r1", "robot"), ("r4", "rude")])
    carol = Outside(team, "carol@elsewhere")
    services = {"description": {"services": [{"type": "auction.bidder"}]}, "action": "register"}
    team.conversations.receive_external("df", FipaMessage("request", carol.me, (), json.dumps(services)))
    mallory = Outside(team, "mallory@elsewhere")
    mallory.say(2000, "not-understood", {}, to="shop", conversation="auction-shop-1")
    run = Played(team, team.run(), records)
    assert collected(run) == ["61100 start Choose"]  # carol is waited for until the deadline
