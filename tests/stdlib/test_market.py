"""A market of 60 agents: each buyer has several winners, each seller several conversations at a time."""

from __future__ import annotations

from collections import Counter
from typing import Any

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.team.faults import Crash
from tests.support.generated import Generated, generate
from tests.support.lanes import kept
from tests.support.networks import BAD, runs

SECOND = 1_000_000_000
STOCK, WANTED, BUYERS, SELLERS = 2, 3, 20, 40

MARKET = f"""
system Market
import protocols

srm buyer {{
  plays contract_net.manager
  liveness {{ buyer = Wander . manager . Rest }}
  activities {{ Rest takes 1s  CollectProposals takes 1s }}
}}

srm seller {{
  plays contract_net.contractor with CarryOut = Sell
  liveness {{ seller = (contractor~)[8] }}
  activities {{ Sell takes 1s }}
}}

team Market {{ buyer[1..{BUYERS}] : buyer  seller[1..{SELLERS}] : seller }}
"""


def traders(market: Generated, sold: Counter[str], bought: Counter[str], endings: dict[str, str]) -> Any:
    """The code of a run, which counts what was sold, by seller, and what was bought, by buyer."""

    class Wander:
        def execute(self, context: Context) -> None:
            context.wait(20 * context.random.random())

    class AnnounceJob:
        def execute(self, context: Context) -> None:
            context.prepare(market.message("Job", id=context.agent, what="lamp"))
            context.set_variable("wanted", WANTED)

    class EvaluateJob:
        def execute(self, context: Context) -> None:
            context.wait(0.1 * context.random.random())
            context.set_variable("able", sold[context.agent] < STOCK)

    class MakeProposal:
        def execute(self, context: Context) -> None:
            job = context.last_received("cfp", "Job").content
            context.prepare(market.message("Proposal", job=job.id, cost=5 + 10 * context.random.random()))

    class Sell:
        def execute(self, context: Context) -> None:
            context.wait(0.5)
            done = sold[context.agent] < STOCK  # another buyer may have been quicker
            sold[context.agent] += done
            context.set_variable("succeeded", done)

    class ReportOutcome:
        def execute(self, context: Context) -> None:
            context.prepare(market.message("Outcome", id="", detail="a lamp"))

    class LearnOutcome:
        def execute(self, context: Context) -> None:
            bought[context.agent] += context.get_variable("succeeded")
            endings[context.agent] = context.get_variable("ending").name

    return {
        item.__name__: item
        for item in (Wander, AnnounceJob, EvaluateJob, MakeProposal, Sell, ReportOutcome, LearnOutcome)
    }


@pytest.fixture(scope="module")
def market() -> Generated:
    return generate(MARKET)


def test_what_is_sold_is_what_is_bought(market: Generated) -> None:
    sold, bought, endings = Counter[str](), Counter[str](), dict[str, str]()
    (run,) = runs(
        market, None, seeds=[1], until=60 * SECOND, activities=traders(market, sold, bought, endings)
    )
    assert sold.total() == bought.total() > BUYERS
    assert max(sold.values()) <= STOCK and max(bought.values()) <= WANTED
    assert len(endings) == BUYERS and set(endings.values()) <= {"DONE", "FAILED", "NOBODY"}
    assert all((bought[name] == WANTED) == (how == "DONE") for name, how in endings.items())
    assert all(item.finished for item in run.result.agents if item.name.startswith("buyer"))


@pytest.mark.parametrize("seed", kept([1, 2], lambda seed: seed == 2))
def test_on_a_bad_network_no_more_is_bought_than_was_sold(market: Generated, seed: int) -> None:
    """A seller crashes as well. Who does not know how it ended says so."""
    sold, bought, endings = Counter[str](), Counter[str](), dict[str, str]()
    list(
        runs(
            market,
            BAD,
            seeds=[seed],
            until=300 * SECOND,
            activities=traders(market, sold, bought, endings),
            crashes=lambda seed: [Crash("seller7", 5 * SECOND, 20 * SECOND)],
        )
    )
    assert len(endings) == BUYERS
    certain = {name for name, how in endings.items() if how in ("DONE", "FAILED", "NOBODY", "REFUSED")}
    unsure = {name for name in endings if name not in certain}
    assert {endings[name] for name in unsure} <= {"UNKNOWN", "LATE", "LOST", "TIMED_OUT", "NOT_UNDERSTOOD"}
    assert bought.total() <= sold.total() and max(bought.values()) <= WANTED
    assert max(sold.values()) <= STOCK
    if not unsure:
        assert bought.total() == sold.total()
