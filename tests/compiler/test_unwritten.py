"""N437: conditions that never change, since nothing sets their variables."""

from __future__ import annotations

import pytest

from tests.support.compiling import analysis

TEXT = """system S
message M { int n }
topic t { state M from other }
suc { role other : external }
srm r {
  var found : bool = false
  var tries : int = 3
  var now : M
  liveness { r = Search+ . Rest }
  activities { Search takes 1s %s }
  control r { %s }
}
team T { a : r %s }
"""
ASK = "repeat Search : [!found]  leave Search : [found]"


def found(control: str, activity: str = "", team: str = "") -> list[str]:
    text = TEXT % (activity, control, team)
    return [item.span.text for item in analysis(text).diagnostics if item.code == "N437" and item.span]


@pytest.mark.parametrize(
    ("control", "places"),
    [
        (ASK, ["found"]),
        ("repeat Search : [tries < 2]  leave Search : else", ["tries"]),
        ("repeat Search : [t.state.M.n > 2 && tries < 2]  leave Search : else", ["tries"]),
        ("repeat Search : [t.state.M.n < tries]  leave Search : else", []),
        ("repeat Search : [!found] / found = true  leave Search : [found]", []),
        ("repeat Search : [tries > 0] / tries = tries - 1  leave Search : else", []),
        # What is only cleared is never there.
        ("repeat Search : [has(now)] / clear(now)  leave Search : else", ["now"]),
        ("repeat Search : [has(now)] / now = t.state.M  leave Search : else", []),
    ],
)
def test_what_nothing_sets(control: str, places: list[str]) -> None:
    assert found(control) == places


def test_what_an_activity_or_a_team_sets() -> None:
    assert found(ASK, activity="writes found") == []
    assert found(ASK, activity="simulated writes found") == []
    assert found(ASK, team="with found = true") == []


OWN = """system S
aip p {
  participant a { var found : bool = false  process = Ask . [Find] }
  participant b { process = Wait }
  control a { enter Find : [found]  skip Find : else }
}
srm x { plays p.a  liveness { x = a }  activities { Ask takes 1s %s  Find takes 1s simulated } }
srm y { plays p.b  liveness { y = b } }
team T { one : x  two : y }
"""


def test_a_variable_of_a_participant_is_set_by_the_code_of_its_activities() -> None:
    """Without `writes`; so nothing is certain before all of them are simulated."""
    assert "N437" not in {item.code for item in analysis(OWN % "").diagnostics}
    assert "N437" in {item.code for item in analysis(OWN % "simulated").diagnostics}
    assert "N437" not in {item.code for item in analysis(OWN % "simulated writes found").diagnostics}


LIBRARY = """system S
import protocols
srm i { plays request.initiator  liveness { i = initiator } }
srm p {
  plays request.responder
  liveness { p = responder }
  activities {
    ConsiderOrder takes 1s simulated %s
    PerformOrder takes 1s simulated
    ReportOutcome takes 1s simulated
    StopOrder takes 1s simulated
    CloseOrder takes 1s simulated
  }
}
team T { a : i  b : p }
"""


def test_a_protocol_of_the_library_is_told_where_it_is_played() -> None:
    items = [item for item in analysis(LIBRARY % "").diagnostics if item.code == "N437"]
    assert [item.span.text for item in items if item.span] == ["request.responder"]
    assert "`succeeded`" in items[0].message and "`willing`" in items[0].message
    said = [item for item in analysis(LIBRARY % "writes willing").diagnostics if item.code == "N437"]
    assert "`willing`" not in said[0].message


@pytest.mark.parametrize(
    ("first", "second", "codes"),
    [
        ("tries > 3", "tries < 3", ["N437"]),
        ("t.state.M.n > 0 && tries > 0", "tries < 0", ["N437"]),
        ("tries > 3", "t.state.M.n < 3", ["N437", "W411"]),
        ("t.state.M.n > 3", "t.state.M.n < 3", ["W411"]),
    ],
)
def test_a_gap_between_conditions_that_never_change_is_no_problem_of_its_own(
    first: str, second: str, codes: list[str]
) -> None:
    pytest.importorskip("z3")
    text = TEXT % ("", f"repeat Search : [{first}]  leave Search : [{second}]", "")
    said = sorted(item.code for item in analysis(text).diagnostics if item.code in ("N437", "W411"))
    assert said == codes
