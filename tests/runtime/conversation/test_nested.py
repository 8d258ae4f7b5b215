"""Conversations inside conversations: a formula for an activity of one participant plays another."""

from __future__ import annotations

from typing import Any

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.team.faults import Crash, Faults
from tests.runtime.hospital import LATE, RIDE, ends, starts
from tests.runtime.playing import SECOND, Played, play
from tests.support.generated import generate

TEXT = (
    RIDE
    + """\
aip delivery {
  participant desk {
    sends    request Parcel
    receives agree Parcel, inform Parcel
    process  = Ask . (Thank | Complain)
  }
  participant courier {
    var floor : Floor = Floor.WARD
    sends    agree Parcel, inform Parcel by Bring
    receives request Parcel
    process  = Consider . travel
    travel   = Fetch(floor) . Bring
  }
  control desk {
    enter Ask      : / send request Parcel { id = "p" } to courier
    enter Thank    : inform Parcel from courier
    enter Complain : lost courier
  }
  control courier { enter Consider : request Parcel from desk / send agree Parcel { id = "p" } to desk }
  control travel  { enter Bring : [done(Fetch)] }
}
srm porter {
  plays delivery.courier with Fetch = fetch, Bring = bring
  plays ride.passenger with destination = floor, arrived = was_there
  var floor : Floor
  var was_there : bool
  var stops : int
  liveness {
    porter       = PORTER
    fetch(where) = Go(where) . passenger . [Load]
    bring        = Carry . HandOver
  }
  activities {
    Go(where : Floor) takes 1s  Fetch(where : Floor)  Call takes 1s  StepOut takes 1s  Load takes 1s
    Consider takes 1s  Carry takes 1s  HandOver takes 1s  Halt takes 4s
  }
  control porter { CONTROL }
  control fetch {
    enter passenger : / floor = where
    enter Load      : [was_there]
    skip  Load      : else
  }
}
srm clerk { plays delivery.desk  liveness { clerk = desk }  activities { Ask takes 1s  Thank takes 1s } }
"""
)


class HandOver:
    """Sends what the participant leaves to `Bring`, for which a formula stands."""

    def execute(self, context: Context) -> None:
        parcel = context.last_received("request", "Parcel")
        assert parcel is not None
        context.send("inform", parcel.content, parcel.sender)


class Load:
    """Sends what the protocol does not leave to it."""

    def execute(self, context: Context) -> None:
        parcel = context.last_received("request", "Parcel")
        assert parcel is not None
        context.send("inform", parcel.content, parcel.sender)


def hospital(
    porter: str = "courier [> Halt", control: str = LATE, activities: Any = (), **options: Any
) -> Played:
    text = TEXT.replace("PORTER", porter).replace("CONTROL", control)
    known = {"HandOver": HandOver, **dict(activities)}
    return play(generate(text), known, until=options.pop("until", 30 * SECOND), **options)


def test_a_ride_in_a_delivery() -> None:
    run = hospital()
    assert starts(run, "agv") == [
        "0 Consider",
        "1000 Go",
        "2000 Call",
        "5000 StepOut",
        "6000 Load",
        "7000 Carry",
        "8000 HandOver",
    ]
    assert starts(run, "ann") == ["0 Ask", "9000 Thank"]
    assert starts(run, "otis") == ["2000 Move", "5000 Open"]
    assert run.of("fault") == []
    given = [r["arguments"] for r in run.of("activity", activity="Go") if r["what"] == "start"]
    assert "WARD" in str(given)


def test_inner_conversations_end_with_the_outer_one() -> None:
    """The inner one ends first; each partner learns why."""
    run = hospital("courier [> Halt", "enter Halt : after(4s)")
    assert ends(run)[:4] == [
        "4000 agv leave ride-agv-1 left",
        "4000 otis gone ride-agv-1 left",
        "4000 agv leave delivery-ann-1 left",
        "4000 ann gone delivery-ann-1 left",
    ]
    assert starts(run, "ann")[-1] == "4000 Complain"
    assert starts(run, "otis")[-1] == "5000 Stay"


def test_both_are_suspended_and_go_on() -> None:
    run = hospital(
        "(courier [> Halt)~",
        "enter Halt : after(4s) [stops < 1] / stops = 1  resume courier : [stops > 0]  enter courier : else",
        until=16 * SECOND,
    )
    lines = ends(run)
    assert [line for line in lines if "suspend" in line] == [
        "4000 agv suspend ride-agv-1",
        "4000 agv suspend delivery-ann-1",
    ]
    assert [line for line in lines if "resume" in line] == [
        "8000 agv resume delivery-ann-1",
        "8000 agv resume ride-agv-1",
    ]
    assert starts(run, "ann")[-1] == "12000 Thank" or starts(run, "ann")[-1].endswith("Thank")
    assert not any("gone" in line and " left" in line for line in lines)


def test_a_crash_is_seen_in_both() -> None:
    run = hospital(faults=Faults(crashes=(Crash("agv", 4 * SECOND, 60 * SECOND),)))
    gone = [line for line in ends(run) if " gone " in line]
    assert {line.split(" ", 1)[1] for line in gone} == {
        "otis gone ride-agv-1 crashed",
        "ann gone delivery-ann-1 crashed",
    }


def test_a_formula_sends_no_more_than_its_activity_may() -> None:
    """`Load` stands in the formula for `Fetch`, and the protocol leaves the message to `Bring`."""
    run = hospital(activities={"Load": Load})
    assert any("leaves that to" in r.get("error", r.get("text", str(r))) for r in run.of("fault"))
    assert starts(run, "ann") == ["0 Ask"] or starts(run, "ann")[-1].endswith("Complain")


def test_the_protocol_is_the_same_as_without_a_formula() -> None:
    """What is bound does not count for the compatibility of a protocol."""
    text = TEXT.replace("PORTER", "courier [> Halt").replace("CONTROL", LATE)
    plain = text.replace(" with Fetch = fetch, Bring = bring", "").replace(
        "porter       = courier", "porter       = (fetch(Floor.WARD) . bring . courier)"
    )
    versions = [
        next(b.version for b in generate(one).plan("porter").branches if b.protocol == "delivery")
        for one in (text, plain)
    ]
    assert versions[0] == versions[1]
