"""Mistakes of protocols that were found by reading: each is refuted, by a run that plays on the runtime."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.support import Here
from tests.cli.test_prove import FORGED, LATE, MEET

ENGLISH = """\
system English
message Lot { int price }
aip auction {
  participant auctioneer { process = Open . Collect . Sell }
  participant bidder [1..*] { process = Think . Wait . (Win | Lose) }
  control auctioneer {
    enter Collect : / send cfp Lot { price = 1 } to bidder
    enter Sell    : propose Lot offer from bidder / send accept_proposal Lot { price = 1 } to sender(offer)
  }
  control bidder {
    enter Think : cfp Lot from auctioneer
    enter Wait  : / send propose Lot { price = 1 } to auctioneer
    enter Win   : accept_proposal Lot from auctioneer
    enter Lose  : reject_proposal Lot from auctioneer
  }
}
"""
"""The first of two bidders at one price wins, and the other one is never told."""

DUTCH = """\
system Dutch
message Lot { int price }
aip auction {
  participant auctioneer { process = Call . Collect . [Sell] }
  participant bidder { process = Think . Bid . (Win | Lose) }
  control auctioneer {
    enter Call : / send cfp Lot { price = 1 } to bidder
    on    Call : propose Lot early from bidder / send reject_proposal Lot { price = 1 } to sender(early)
    enter Sell : propose Lot offer from bidder / send accept_proposal Lot { price = 1 } to sender(offer)
    skip  Sell : after(5s)
  }
  control bidder {
    enter Think : cfp Lot from auctioneer
    enter Bid   : / send propose Lot { price = 1 } to auctioneer
    enter Win   : accept_proposal Lot from auctioneer
    enter Lose  : reject_proposal Lot from auctioneer or after(1min)
  }
}
srm house { plays auction.auctioneer liveness { house = auctioneer } }
srm guest { plays auction.bidder liveness { guest = bidder } }
team Room { house : house  ann : guest }
property "who bids buys" { every ann in Bid leads to ann in Win }
"""
"""Bids that come while the price is still called are rejected: nobody buys."""

BROKER = """\
system Broker
message Errand { int number }
aip broker {
  participant broker { process = First . Second . (Thank | GiveUp) }
  participant provider { process = Weigh . Rest . Work . Report }
  control broker {
    enter First  : / send request Errand { number = 1 } to provider
    enter Second : after(5s) / send request Errand { number = 2 } to provider
    enter Thank  : inform Errand from provider
    enter GiveUp : refuse Errand from provider
  }
  control provider {
    enter Weigh  : request Errand from broker
    enter Rest   : / send refuse Errand { number = 1 } to broker
    enter Work   : request Errand from broker
    enter Report : / send inform Errand { number = 2 } to broker
  }
  clause Work@provider before GiveUp@broker
}
"""
"""The refusal of the first errand comes late, and is taken for that of the second one."""

FINDINGS = {
    "P1, a forged move": (FORGED, "Carry@carrier before Settle@manager", ()),
    "P2, English auction": (ENGLISH, "orphan messages", ("--robots", "2", "--states", "600")),
    "P2, Dutch auction": (DUTCH, "who bids buys", ()),
    "P2, brokering": (BROKER, "Work@provider before GiveUp@broker", ()),
    "P3, both send first": (MEET, "non-local choice", ()),
    "P4, two outcomes": (LATE, "agreement", ()),
}


@pytest.mark.parametrize("finding", FINDINGS)
def test_a_finding_is_refuted_by_a_run_that_plays(here: Here, folder: Path, finding: str) -> None:
    text, name, options = FINDINGS[finding]
    (folder / "it.aseme").write_text(text)
    done = here("prove", "it.aseme", name, *options, "--save", "found.aseme", "--json")
    verdicts = [(item["verdict"], item["reason"]) for item in done.json["results"]]
    assert (done.code, [verdict for verdict, _ in verdicts]) == (1, ["REFUTED"]), verdicts
    played = here("test", "found.aseme")
    assert played.code == 1 and "failed" in played.out and "error" not in played.out, played.out
