"""A participant that plays in another protocol: a conversation inside a conversation, with one end."""

from __future__ import annotations

from typing import Any

from aseme_dsl.runtime.team.faults import Crash, Faults
from tests.runtime.hospital import LATE, RIDE, ends, starts
from tests.runtime.playing import SECOND, Played, play
from tests.support.generated import generate

TEXT = (
    RIDE
    + """\
aip delivery {
  participant desk {
    sends    request Parcel, cancel Parcel
    receives inform Parcel, failure Parcel
    process  = Ask . Wait . (Thank | Complain)
  }
  participant courier {
    plays ride.passenger with destination = floor, arrived = up
    var floor : Floor = Floor.WARD
    var up    : bool
    sends    inform Parcel, failure Parcel
    receives request Parcel, cancel Parcel
    process  = (Fetch . passenger . (Bring | Return)) LATE
  }
  control desk {
    enter Ask      : / send request Parcel { id = "p" } to courier
    enter Wait     : DESK
    enter Thank    : inform Parcel from courier
    enter Complain : failure Parcel from courier or lost courier
  }
  control courier {
    enter Fetch  : request Parcel from desk
    enter Bring  : [up]
    enter Return : else
    leave Bring  : / send inform Parcel { id = "p" } to desk
    leave Return : / send failure Parcel { id = "p" } to desk
    COURIER
  }
}
srm porter {
  plays delivery.courier PLAYS
  var stops : int
  liveness { porter = PORTER  PHONE }
  activities {
    Fetch takes 1s  Call takes 1s  StepOut takes 1s  Bring takes 1s  Return takes 1s  LATES  Halt takes 4s
    PHONES
  }
  control porter { CONTROL }
}
srm clerk {
  plays delivery.desk
  liveness { clerk = desk }
  activities { Ask takes 1s  Wait takes 1s  Thank takes 1s  Complain takes 1s }
}
"""
)

STOPS = "enter Halt : after(3s)"


def text_of(**parts: str) -> str:
    """The hospital with these parts."""
    known = {
        "PORTER": "courier [> Halt",
        "CONTROL": LATE,
        "DESK": "[true]",
        "PLAYS": "",
        "LATE": "",
        "LATES": "",
        "PHONE": "",
        "PHONES": "",
        "COURIER": "",
        **parts,
    }
    text = TEXT
    for name, part in known.items():
        text = text.replace(f" {name} ", f" {part} ").replace(f" {name}\n", f" {part}\n")
    return text


def hospital(*, until: int = 30 * SECOND, faults: Any = None, **parts: str) -> Played:
    options = {"faults": faults} if faults is not None else {}
    return play(generate(text_of(**parts)), {}, until=until, **options)


def test_a_ride_in_a_delivery() -> None:
    run = hospital()
    assert starts(run, "agv") == ["0 Fetch", "1000 Call", "4000 StepOut", "5000 Bring"]
    assert starts(run, "ann") == ["0 Ask", "1000 Wait", "6000 Thank"]
    assert run.of("fault") == []


def test_the_inner_conversation_ends_with_the_outer_one() -> None:
    run = hospital(CONTROL=STOPS)
    assert ends(run)[:4] == [
        "3000 agv leave ride-agv-1 left",
        "3000 otis gone ride-agv-1 left",
        "3000 agv leave delivery-ann-1 left",
        "3000 ann gone delivery-ann-1 left",
    ]
    assert starts(run, "ann")[-1].endswith("Complain")
    assert starts(run, "otis")[-1] == "4000 Stay"


def test_both_are_suspended_and_go_on() -> None:
    run = hospital(
        PORTER="(courier [> Halt)~",
        CONTROL="enter Halt : after(3s) [stops < 1] / stops = 1  "
        "resume courier : [stops > 0]  enter courier : else",
        until=16 * SECOND,
    )
    lines = ends(run)
    assert [line for line in lines if "suspend" in line] == [
        "3000 agv suspend ride-agv-1",
        "3000 agv suspend delivery-ann-1",
    ]
    assert [line for line in lines if "resume" in line] == [
        "7000 agv resume delivery-ann-1",
        "7000 agv resume ride-agv-1",
    ]
    assert starts(run, "ann")[-1].endswith("Thank")


def test_a_crash_is_seen_in_both() -> None:
    run = hospital(faults=Faults(crashes=(Crash("agv", 3 * SECOND, 60 * SECOND),)))
    gone = {line.split(" ", 1)[1] for line in ends(run) if " gone " in line}
    assert gone == {"otis gone ride-agv-1 crashed", "ann gone delivery-ann-1 crashed"}


def test_who_is_lost_inside_is_not_lost_outside() -> None:
    """The passenger is told that the lift is lost; its part goes on, and so does the delivery."""
    run = hospital(faults=Faults(crashes=(Crash("otis", 2 * SECOND, 60 * SECOND),)))
    assert starts(run, "agv") == ["0 Fetch", "1000 Call", "2000 Return"]
    assert starts(run, "ann")[-1] == "3000 Complain"
    branches = {item.protocol: item for item in generate(text_of()).plan("porter").branches}
    assert branches["ride"].loses == ("lift",)
    assert branches["delivery"].loses == ()


def test_a_message_of_the_outer_conversation_ends_the_inner_one() -> None:
    run = hospital(
        DESK='after(2s) / send cancel Parcel { id = "p" } to courier',
        COURIER="enter Late : cancel Parcel from desk\n"
        '    leave Late : / send failure Parcel { id = "p" } to desk',
        LATE="[> Late",
        LATES="Late takes 1s",
    )
    assert "2000 agv leave ride-agv-1 left" in ends(run)
    assert starts(run, "otis")[-1] == "4000 Stay"
    assert run.of("fault") == []


def test_a_role_binds_what_stands_inside() -> None:
    """The participant gives the activity a name of its own, to which the role binds a formula."""
    text = text_of(
        PLAYS="with Ring = phone", PHONE="phone = Dial . Speak", PHONES="Dial takes 1s  Speak takes 1s"
    ).replace("arrived = up", "arrived = up, Call = Ring")
    run = play(generate(text), {}, until=30 * SECOND)
    assert starts(run, "agv") == ["0 Fetch", "1000 Dial", "2000 Speak", "4000 StepOut", "5000 Bring"]


def test_the_outer_protocol_is_the_same_as_with_an_activity() -> None:
    """What is said inside does not count for the compatibility of the protocol around it."""
    nested = text_of()
    plain = nested.replace("plays ride.passenger with destination = floor, arrived = up", "").replace(
        "Fetch . passenger .", "Fetch . Travel ."
    )
    versions = [
        next(item.version for item in generate(text).plan("clerk").branches if item.protocol == "delivery")
        for text in (nested, plain)
    ]
    assert versions[0] == versions[1]


def test_who_talks_inside_has_joined_outside() -> None:
    """At the end of a run it is told where each agent of an open conversation waits."""
    text = text_of().replace("skip  StepOut : lost lift", "skip  StepOut : [false]")
    run = play(
        generate(text),
        {},
        until=20 * SECOND,
        faults=Faults(crashes=(Crash("otis", 2 * SECOND, 60 * SECOND),)),
    )
    delivery = next(item for item in run.result.conversations if item.protocol == "delivery")
    waits = {item.participant: [one.name for one in item.waits] for item in delivery.members}
    assert waits["courier"] == ["[StepOut]"]
