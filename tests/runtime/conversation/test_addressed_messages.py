"""Agent messages to one agent, to all but some, and about agents that are gone: between whole agents."""

from __future__ import annotations

from aseme_dsl.runtime import Context
from tests.runtime.playing import MS, Played, play
from tests.support.generated import Generated, generate

AUCTION = """
system Market
message Task { string id }
message Bid { double cost }
message Award { string to  double price }
aip auction {
  participant seller {
    var best  : agent
    var price : double = 100
    sends cfp Task, accept_proposal Award, reject_proposal Award
    receives propose Bid, inform Task
    process = Announce . collect . Award . Wait
    collect = Listen+
  }
  participant bidder [1..*] {
    sends propose Bid, inform Task
    receives cfp Task, accept_proposal Award, reject_proposal Award
    process = Consider . Offer . (Deliver | Sulk)
  }
  control seller {
    enter Announce : / send cfp Task { id = "t1" } to bidder
    enter Award    : / send accept_proposal Award { to = best, price = price } to best;
                       send reject_proposal Award { to = best, .. } to bidder except best
    enter Wait     : inform Task t from bidder [t.id == "t1" && sender(t) == best]
    enter Wait     : lost bidder who [who == best]
  }
  control collect {
    repeat Listen : propose Bid b from bidder [b.cost < price] / price = b.cost; best = sender(b)
    leave  Listen : after(500ms)
  }
  control bidder {
    enter Consider : cfp Task from seller
    enter Deliver  : accept_proposal Award a from seller [a.price > 0]
    enter Sulk     : reject_proposal Award from seller
    leave Deliver  : / send inform Task { id = "t1" } to seller
    OFFER
  }
}
srm desk   { plays auction.seller  liveness { desk = seller . Rest } }
srm robot  { plays auction.bidder  liveness { robot = bidder }  activities { Deliver takes 1s } }
srm other  { liveness { other = Idle } }
team T { shop : desk  r1, r2, r3 : robot  bored : other }
"""
OFFER = "enter Offer : / send propose Bid { cost = 10 } to seller"


def auction(offer: str = OFFER, deliver: type | None = None) -> Played:
    generated = generate(AUCTION.replace("OFFER", offer))

    class Offer:
        def execute(self, context: Context) -> None:
            cost = float({"r1": 30, "r2": 20, "r3": 50}[context.agent])
            context.send("propose", generated.message("Bid", cost=cost), "seller")

    activities = {"Offer": Offer} if offer == "" else {}
    if deliver is not None:
        activities["Deliver"] = deliver
    return play(generated, activities)


def said(run: Played) -> list[str]:
    return [
        f"{r['time'] / MS:g} {r['agent']} {r['performative']} {r['message']} -> {' '.join(r['to'])}"
        for r in run.of("agent_message")
    ]


def test_the_best_bid_wins_and_its_agent_is_told() -> None:
    run = auction(offer="")
    assert run.result.reason == "finished", run.result
    told = said(run)
    assert "600 shop accept_proposal Award -> r2" in told
    assert "600 shop reject_proposal Award -> r1 r3" in told
    award = run.of("agent_message", performative="accept_proposal")[0]
    assert award["content"] == {"to": "r2", "price": 20.0}
    assert told[-1].endswith("r2 inform Task -> shop")
    assert [r for r in run.of("fault") if "code" not in r] == []


def test_a_robot_that_fails_is_lost() -> None:
    class Deliver:
        def execute(self, context: Context) -> None:
            context.wait(0.2)
            raise RuntimeError("stuck")

    run = auction(offer="", deliver=Deliver)
    (gone,) = run.of("conversation", what="gone", reason="failed")
    assert (gone["agent"], gone["peer"], gone["played"], gone["participant"]) == (
        "shop",
        "r2",
        "bidder",
        "seller",
    )
    step = next(r for r in run.of("step", agent="shop") if [gone["agent"], gone["sequence"]] in r["inputs"])
    assert any("lost bidder who" in way["text"] for way in step["taken"])


def test_who_plays_no_part_that_receives_it_is_not_told() -> None:
    text = AUCTION.replace("OFFER", OFFER).replace(
        "send accept_proposal Award { to = best, price = price } to best", "send cfp Task to best"
    )
    generated: Generated = generate(text)

    class Listen:
        def execute(self, context: Context) -> None:
            context.set_variable("best", "bored")

    run = play(generated, {"Listen": Listen})
    (fault,) = [r for r in run.of("fault", agent="shop") if "cfp Task" in r["reason"]]
    assert "bored plays no part of auction that receives it" in fault["reason"]
