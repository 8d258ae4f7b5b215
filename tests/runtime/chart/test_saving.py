"""The state of a chart as a value: what it has in it, and how fast it is saved and loaded.

`tests/oracle` saves and loads random charts in the middle of random games.
"""

from __future__ import annotations

import re
import timeit
from pathlib import Path

import pytest

from aseme_dsl.runtime.chart.inputs import Addressed, AgentMessage, Completed, Sample, Start
from aseme_dsl.runtime.chart.saving import OtherModel
from tests.runtime.conversation.test_counting_answers import AUCTION
from tests.support.generated import generate

KOURETES = Path(__file__).parents[2] / "acceptance" / "kouretes.aseme"


def test_who_was_addressed_and_who_has_answered() -> None:
    made = generate(AUCTION.replace("ACTIVITIES", ""))
    chart = made.chart("desk", "shop")
    first = chart.step(0, [])
    branch = made.plan("desk").branches[0].label
    (start,) = first.of(Start)
    bids = [
        AgentMessage(branch, "propose", "Bid", made.message("Bid"), "bidder", name, (name, 1))
        for name in ("r1", "r2")
    ]
    chart.step(1, [Completed(start.label, start.token)])
    chart.step(2, [Addressed(branch, "bidder", ("r1", "r2"), "t1"), bids[0]])
    other = made.chart("desk", "shop")
    other.load(chart.save())
    for one in (chart, other):
        assert one.invited(branch, "bidder") == 2
        assert one.answered(branch, "bidder") == 1
        assert one.step(3, [bids[1]]).taken
    assert chart.save() == other.save()


def test_a_state_of_another_model_is_refused() -> None:
    one = generate("system One  srm r { liveness { r = A } }").chart("r")
    other = generate("system One  srm r { liveness { r = B } }").chart("r")
    with pytest.raises(OtherModel, match=re.escape(f"not of {other.PLAN.model}")):
        other.load(one.save())


@pytest.mark.parametrize("kind", ["state", "data", "signal"])
@pytest.mark.parametrize("before", [0, 1])
def test_what_was_saved_stays_as_it_is(kind: str, before: int) -> None:
    made = generate(f"""
        system One
        message M {{ int n }}
        topic t {{ {kind} M }}
        srm r {{
          liveness {{ r = A . B }}
          activities {{ A waits }}
          control r {{ enter B : when [t.{kind}.M.n > 9] }}
        }}
    """)
    chart, other = made.chart("r"), made.chart("r")
    samples = [Sample(f"t.{kind}.M", made.message("M", n=n), "x", n, ("x", n)) for n in range(3)]
    chart.step(0, [])
    other.step(0, [])
    for sample in samples[:before]:
        chart.step(sample.time, [sample])
        other.step(sample.time, [sample])
    saved = chart.save()
    for sample in samples[before:]:
        chart.step(sample.time, [sample])
    chart.load(saved)
    assert chart.save() == other.save()
    assert chart.boards()[0].newest(f"t.{kind}.M") == other.boards()[0].newest(f"t.{kind}.M")


def test_a_class_inside_a_generated_one_saves_all_of_it() -> None:
    """Scenarios and coverage make such classes."""
    kind = generate("system One  srm r { var n : int = 3  liveness { r = A } }").charts["r"]
    inner = type("Inner", (kind,), {"__slots__": ()})
    assert inner("r").save() == kind("r").save()
    assert "n" in " ".join(inner.places)
    assert inner.places == kind.places


@pytest.mark.parametrize("name", ["kouretes", "contract_net"])
def test_the_values_are_those_of_the_places(name: str) -> None:
    made = generate((KOURETES.parent / f"{name}.aseme").read_text("utf-8"))
    for kind in made.charts.values():
        chart = kind("one")
        chart.step(5, [])
        assert chart.values() == tuple(getattr(chart, place) for place in chart.places)
        assert chart.all_boards() == tuple(getattr(chart, f"b{n}") for n in range(len(chart.REGIONS)))


def test_a_chart_is_saved_and_loaded_within_ten_microseconds() -> None:
    """The player of the papers, after a game has begun; a slow machine is given ten times as long."""
    made = generate(KOURETES.read_text("utf-8"))
    chart = made.chart("player", "robot1")
    channels = [(info.name, getattr(made.messages, info.message)) for info in made.plan("player").channels]
    chart.step(0, [])
    for number, (channel, kind) in enumerate(channels):
        chart.step(number, [Sample(channel, kind(), "robot2", number, ("robot2", number))])
    best = min(timeit.repeat(lambda: chart.load(chart.save()), number=200, repeat=20)) / 200
    assert best < 100e-6
