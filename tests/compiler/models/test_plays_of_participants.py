"""What a participant plays itself: what may be wrong with it, and where that is told."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

import pytest

from aseme_dsl.diagnostics import Diagnostic
from tests.support.compiling import analysis

TEXT = """
system Hospital
message Ride { int floor }
message Parcel { string id }
aip ride {
  participant passenger {
    given  floor : int
    result there : bool
    sends request Ride
    receives inform Ride
    process = Call . StepOut
  }
  participant lift { sends inform Ride  receives request Ride  process = Move }
  control passenger {
    enter Call    : / send request Ride { floor = floor } to lift
    enter StepOut : inform Ride from lift or lost lift / there = true
  }
  control lift {
    enter Move : request Ride from passenger
    leave Move : / send inform Ride { floor = 1 } to passenger
  }
}
aip delivery {
  participant desk { sends request Parcel  receives inform Parcel  process = Ask }
  participant courier {
    PLAYS
    var there : bool
    sends inform Parcel
    receives request Parcel
    process = PROCESS
  }
  control desk {
    enter Ask : / send request Parcel { id = "p" } to courier
    leave Ask : inform Parcel from courier or lost courier
  }
  control courier {
    enter Fetch : request Parcel from desk
    leave Bring : [there] / send inform Parcel { id = "p" } to desk
    CONTROL
  }
  MORE
}
srm porter {
  plays delivery.courier WITH
  liveness { porter = courier  FORMULA }
  activities { Fetch takes 1s }
}
srm clerk { plays delivery.desk  liveness { clerk = desk } }
srm cabin { plays ride.lift  liveness { cabin = lift } }
team T { ann : clerk  agv : porter  otis : cabin }
"""

PLAYS = "plays ride.passenger with floor = 2, there = there"


def found(changes: Mapping[str, str] = MappingProxyType({}), **parts: str) -> list[Diagnostic]:
    """The errors, and the notes of something that is missing."""
    known = {
        "PLAYS": PLAYS,
        "PROCESS": "Fetch . passenger . Bring",
        "CONTROL": "",
        "MORE": "",
        "WITH": "",
        "FORMULA": "",
        **parts,
    }
    text = TEXT
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    for name, part in known.items():
        text = text.replace(f" {name} ", f" {part} ").replace(f" {name}\n", f" {part}\n")
    problems = analysis(text).diagnostics
    return [item for item in problems if item.code[0] == "E" or item.code == "N702"]


def test_it_may_play() -> None:
    assert found() == []


@pytest.mark.parametrize(
    ("code", "place", "parts"),
    [
        ("E205", "rode", {"PLAYS": PLAYS.replace("ride", "rode")}),
        ("E205", "rider", {"PLAYS": PLAYS.replace("passenger", "rider")}),
        ("E206", "Fly", {"PLAYS": f"{PLAYS}, Fly = Walk"}),
        ("E590", "ride.passenger", {"PLAYS": "plays ride.passenger"}),
        ("E591", "Fetch", {"PLAYS": PLAYS.replace("there = there", "there = Fetch")}),
        ("E408", "passenger", {"MORE": "control passenger { enter Call : [true] }"}),
        ("E408", "0.2.2.2.3.2.2 -> 0.2.2.2.4", {"CONTROL": "0.2.2.2.3.2.2 -> 0.2.2.2.4 : [there]"}),
        ("N702", PLAYS.removeprefix("plays "), {"PROCESS": "Fetch . Bring"}),
        ("E594", "delivery.desk", {"PLAYS": "plays delivery.desk", "PROCESS": "Fetch . desk . Bring"}),
        ("E306", "passenger", {"PROCESS": "Fetch . passenger . Bring\n    passenger = Call"}),
        ("E213", "passenger", {"PLAYS": f"{PLAYS} {PLAYS}"}),
        (
            "E593",
            "helper",
            {"PLAYS": f"{PLAYS}, Call = helper", "PROCESS": "Fetch . passenger . helper\n    helper = Bring"},
        ),
    ],
)
def test_what_is_wrong_has_a_place(code: str, place: str, parts: dict[str, str]) -> None:
    told = [(item.code, item.span.text) for item in found(**parts) if item.span is not None]
    assert (code, place) in told


def test_the_control_around_asks_for_the_part_as_a_whole() -> None:
    """The state that stands for the part and the part itself are one."""
    line = "on Bring : when [count(passenger) > 1 && done(passenger) && !in(passenger)] / there = false"
    told = found(PROCESS="Fetch . passenger+ . Bring", CONTROL=f"{line}  repeat passenger : [!there]")
    assert [item.code for item in told] == []


def test_a_formula_of_a_role_may_stand_for_what_the_participant_binds() -> None:
    bound = {"PLAYS": f"{PLAYS}, Call = Ring", "WITH": "with Ring = phone"}
    assert found(**bound, FORMULA="phone = Dial . Speak") == []


@pytest.mark.parametrize(
    ("old", "new", "formula"),
    [
        ("inform Ride from lift or lost lift /", "[outcome(Call) == ok] /", "phone = Dial"),
        ("process = Call . StepOut", "process = Call+ . StepOut", "phone = [Dial]"),
    ],
)
def test_a_formula_may_be_unfit_for_what_stands_inside(old: str, new: str, formula: str) -> None:
    """The protocol inside asks for an outcome of the activity, or repeats it."""
    bound = {"PLAYS": f"{PLAYS}, Call = Ring", "WITH": "with Ring = phone", "FORMULA": formula}
    described = {"  activities { Fetch": "  activities { Call ends ok, bad  Fetch"} if "ok" in new else {}
    told = [item for item in found({old: new, **described}, **bound) if item.code == "E593"]
    assert [item.span.text for item in told if item.span is not None] == ["phone"]


CIRCLES = """
system T
aip a { participant x { plays b.x as other  process = A . other } }
aip b { participant x { plays c.x as other  process = B . other } }
aip c { participant x { plays a.x as other  plays b.x as third  process = C . other . third } }
aip d { participant x { plays a.x as other  process = D . other } }
aip e { participant x { plays e.x as other  process = E . other } }
srm r { plays d.x  liveness { r = x } }
"""


def test_each_circle_of_protocols_is_told_once() -> None:
    told = [item for item in analysis(CIRCLES).diagnostics if item.code[0] == "E"]
    assert [item.code for item in told] == ["E594", "E594"]
    assert "b → c → b" in told[0].message
    assert "e → e" in told[1].message
