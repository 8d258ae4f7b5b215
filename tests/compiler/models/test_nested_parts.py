"""A participant that plays in another protocol: the models, and what is wrong with them."""

from __future__ import annotations

import pytest

from aseme_dsl.amola.expression import expression_text
from aseme_dsl.codegen.plan import protocol_versions
from aseme_dsl.diagnostics import render_text
from tests.support.compiling import analysis, codes, system

HOSPITAL = """system Hospital
message Parcel { int floor }
message Ride { int level }
message Here { int level }

aip ride {
  participant passenger {
    given goal : int
    result level : int
    sends request Ride
    receives inform Here
    process = Call . Travel
  }
  participant lift {
    sends inform Here
    receives request Ride
    process = Come . Open
  }
  control passenger {
    enter Call   : / send request Ride { level = goal } to lift
    enter Travel : inform Here h from lift / level = h.level
  }
  control lift {
    enter Come : request Ride from passenger
    enter Open : / send inform Here { level = 3 } to passenger
  }
}

aip delivery {
  participant courier {
    plays ride.passenger PLAYS
    var floor : int
    var there : int
    sends inform Parcel
    receives request Parcel
    process = Consider . INSIDE . HandOver
    way = Walk
  }
  participant nurse {
    sends request Parcel
    receives inform Parcel
    process = Ask . Take
  }
  control courier {
    enter Consider : request Parcel p from nurse / floor = p.floor
    enter HandOver : [there == floor]
    enter HandOver : after(1min)
    leave HandOver : / send inform Parcel { floor = floor } to nurse
  }
  control nurse {
    enter Ask  : / send request Parcel { floor = 3 } to courier
    enter Take : inform Parcel from courier
  }
}

srm robot {
  plays delivery.courier BOUND
  liveness { robot = courier FORMULAS }
  activities { Consider takes 1s  HandOver takes 1s  Call takes 1s  Travel takes 1s }
}
srm ward { plays delivery.nurse liveness { ward = nurse } activities { Ask takes 1s  Take takes 1s } }
srm elevator { plays ride.lift liveness { elevator = lift } activities { Come takes 3s  Open takes 1s } }
team House { r : robot  w : ward  l : elevator }
"""


def hospital(
    plays: str = "with goal = floor, level = there",
    inside: str = "passenger",
    bound: str = "",
    formulas: str = "",
) -> str:
    text = HOSPITAL.replace("PLAYS", plays).replace("INSIDE", inside).replace("BOUND", bound)
    text = text.replace("FORMULAS", formulas)
    return text if " way" in inside else text.replace("    way = Walk\n", "")


def test_the_conversation_is_nested_in_the_models() -> None:
    assert codes(hospital(), notes=True) == []
    found = system(hospital())
    for chart, label in ((found.iac("robot"), "0.2"), (found.eac("delivery"), "0.2.1.2")):
        assert chart is not None
        branches = [node.label for node in chart.states if chart.is_branch(node)]
        assert branches[:2] == [label, f"{label}.3.2"]
        assert chart.branch_of(f"{label}.3") == label
        texts = {expression_text(item.expression) for item in chart.transitions}
        assert {"/ send request Ride { level = goal } to lift", "[there == floor]"} <= texts
        assert [text for text in texts if "there = level" in text] == ["/ there = level"]
    plays = found.aips[1].participants[0].plays
    assert [item.text for item in plays] == ["ride: passenger with goal = floor, level = there"]


def test_its_messages_are_not_those_of_the_protocol_around_it() -> None:
    nested = protocol_versions(system(hospital()))
    text = hospital(inside="Walk").replace("plays ride.passenger with goal = floor, level = there", "")
    assert protocol_versions(system(text))["delivery"] == nested["delivery"]


def test_an_activity_is_replaced_through_all_that_is_around() -> None:
    plays = "with goal = floor, level = there, Travel = Walk"
    for bound, formulas, named in (
        ("", "", {"Walk"}),
        ("with Walk = Run", "", {"Run"}),
        ("with Walk = moves", "moves = Run . Stop", {"Run", "Stop"}),
    ):
        text = hospital(plays, "passenger . Walk", bound, formulas)
        chart = system(text).iac("robot")
        assert chart is not None
        inside = {
            node.activity
            for node in chart.states
            if node.activity is not None and chart.branch_of(node.label) == "0.2.3.2"
        }
        assert inside == {"Call", *named}


def test_a_name_for_it() -> None:
    text = hospital("as rider with goal = floor, level = there", "rider")
    assert codes(text, notes=True) == []
    assert codes(hospital("as rider with goal = floor, level = there", "passenger"), notes=True) == []


@pytest.mark.parametrize(
    ("plays", "inside", "expected"),
    [
        ("with level = there", "passenger", "E590"),
        ("with goal = floor, level = nothing", "passenger", "E591"),
        ("with goal = flor, level = there", "passenger", "E200"),
        ("with goal = floor, Travle = Walk, level = there", "passenger", "E206"),
        ("with goal = floor, level = there, Travel = way", "passenger . way", "E593"),
        ("as way with goal = floor, level = there", "Walk . way", "E306"),
    ],
)
def test_what_is_wrong_is_told_where_it_is_written(plays: str, inside: str, expected: str) -> None:
    text = hospital(plays, inside)
    found = [item for item in analysis(text).diagnostics if item.code == expected]
    assert found, render_text(analysis(text).diagnostics)
    assert {item.span.line for item in found if item.span} <= {31, 36, 37}


@pytest.mark.parametrize("wrong", ["rode.passenger", "ride.pasenger"])
def test_a_protocol_or_participant_that_does_not_exist(wrong: str) -> None:
    text = hospital().replace("plays ride.passenger", f"plays {wrong}")
    found = [item for item in codes(text) if item.startswith("E")]
    assert found == ["E205"]


def test_protocols_cannot_contain_each_other() -> None:
    text = hospital().replace("  participant lift {", "  participant lift {\n    plays delivery.nurse", 1)
    shown = render_text(analysis(text).diagnostics)
    assert "error[E594]: a conversation cannot contain itself: delivery → ride → delivery" in shown
    assert [item for item in codes(text) if item.startswith("E")] == ["E594"]


def test_a_protocol_cannot_contain_itself() -> None:
    text = hospital().replace("plays ride.passenger with", "plays delivery.nurse as passenger with")
    assert "delivery → delivery" in render_text(analysis(text).diagnostics)


def test_the_size_of_what_is_nested_counts() -> None:
    text = hospital()
    chart = system(text).iac("robot")
    assert chart is not None
    size = len(chart.states)
    assert codes(text, largest=size) == []
    assert "E304" in codes(text, largest=size - 1)


def test_a_line_by_label_does_not_enter_the_conversation_inside() -> None:
    line = "0.2.1.2.3.2.2 -> 0.2.1.2.3.2.3 : [there == floor]"
    text = hospital().replace("enter HandOver : [there == floor]", line)
    assert "error[E408]: 0.2.1.2.3.2 is the branch of ride.passenger" in render_text(
        analysis(text).diagnostics
    )
