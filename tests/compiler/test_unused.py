"""What is declared and nothing uses; roles that no agent has; agent messages without a counterpart."""

from __future__ import annotations

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.source import Source

PLAIN = """system S
import math
enum Phase { GO STOP }
message Order { Phase phase  double angle }
topic base { state Order }
function ready(Order order) : bool = "m:ready"
let goes = base.state.Order.phase == Phase.GO
srm r {
  let turned = sin(base.state.Order.angle) > 0.5
  liveness { r = Base~ || act~  act = Go | Turn | Wait }
  activities {
    Base every 1s uses radio writes base.state.Order
    Go uses legs
    Turn uses legs
    Wait uses legs
  }
  functionality radio { technology "a radio" }
  functionality legs { technology "legs" }
  control act {
    enter Go : [goes && ready(base.state.Order)]
    enter Turn : [turned]
    enter Wait : else
  }
}
team T { a : r }
"""


def found(text: str) -> list[Diagnostic]:
    return list(analyse(Source("unused.aseme", text)).diagnostics)


def test_what_is_used_is_not_reported() -> None:
    assert found(PLAIN) == []


@pytest.mark.parametrize(
    ("before", "place", "text"),
    [
        ("enum Phase", "Colour", "enum Colour { RED }  // Colour"),
        ("enum Phase", "Lamp", "message Lamp { bool on }"),
        ("enum Phase", "near", 'function near(double x) : bool = "m:near"'),
        ("srm r", "stops", "let stops = !goes"),
        ("  liveness", "stops", "  let stops = !goes"),
        ("  control", "camera", '  functionality camera { technology "a camera" }'),
        ("enum Phase", "math", "import math"),
        ("enum Phase", "time", "import time"),
    ],
)
def test_what_nothing_uses(before: str, place: str, text: str) -> None:
    [item] = found(PLAIN.replace(before, f"{text}\n{before}", 1))
    assert item.code == "N727"
    assert item.span is not None and item.span.text == place


def test_a_functionality_that_is_misspelt_is_used() -> None:
    assert [item.code for item in found(PLAIN.replace("uses radio", "uses radoi"))] == ["W230"]


def test_a_role_that_no_agent_has() -> None:
    other = "srm keeper { liveness { keeper = Keep }  activities { Keep uses legs } }\nteam T"
    [item] = found(PLAIN.replace("team T", other))
    assert item.code == "N728"
    assert item.span is not None and item.span.text == "keeper"
    assert found(PLAIN.replace("team T { a : r }", "")) == []


EXCHANGE = """system S
message Order { string what }
aip sale {
  participant customer { sends request Order by Ask  receives agree Order  process = Ask }
  participant keeper { sends agree Order by Serve  receives request Order  process = Serve }
}
srm a { plays sale.customer  liveness { a = customer } }
srm b { plays sale.keeper  liveness { b = keeper } }
"""


def test_agent_messages_with_a_counterpart() -> None:
    assert found(EXCHANGE) == []


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("sends agree Order by Serve", "", "`customer` receives `agree Order`, and no participant sends it"),
        ("receives agree Order", "", "`keeper` sends `agree Order`, and no participant receives it"),
    ],
)
def test_agent_messages_without_a_counterpart(old: str, new: str, said: str) -> None:
    [item] = found(EXCHANGE.replace(old, new))
    assert (item.code, item.message) == ("W524", said)


SUPPLIED = """system S
aip talk {
  participant one {
    given loud : bool
    var heard : bool = false
    result much : int = 0
    process = Ask . [Shout]
  }
  participant other { process = Wait }
  control one {
    enter Shout : [loud && !heard] / heard = true; much = 3
    skip  Shout : else / much = 1
  }
}
srm r {
  plays talk.one with loud = false, much = last
  var last : int = 0
  liveness { r = one . (Rest | Run) }
  activities { Ask takes 1s  Shout takes 1s  Rest takes 1s  Run takes 1s }
  control r {
    enter Rest : [last == 0]
    enter Run  : else
  }
}
srm q {
  plays talk.other
  liveness { q = other }
  activities { Wait takes 1s }
}
team T { a : r  b : q }
"""


def test_a_constant_input_is_no_fault_of_the_protocol() -> None:
    assert found(SUPPLIED) == []


def test_a_result_that_nobody_reads_is_reported_where_it_is_taken() -> None:
    text = SUPPLIED.replace("[last == 0]", "[true]")
    (problem,) = (item for item in found(text) if item.code == "N725")
    assert problem.span is not None and problem.span.text == "talk.one with loud = false, much = last"


def test_a_result_that_the_role_leaves_out() -> None:
    text = SUPPLIED.replace(", much = last", "").replace("[last == 0]", "[true]")
    (problem,) = (item for item in found(text) if item.code == "N725")
    assert problem.span is not None and problem.span.text == "talk.one with loud = false"
    assert (problem.message, problem.hint) == (
        "nothing reads the result `much` of `one`",
        "give it to a variable: `with much = …`",
    )


def test_a_result_that_the_role_leaves_out_and_an_activity_reads() -> None:
    text = SUPPLIED.replace(", much = last", "").replace("[last == 0]", "[true]")
    text = text.replace("Shout takes 1s", "Shout takes 1s reads much")
    assert [item for item in found(text) if item.code == "N725"] == []


def test_a_fault_of_the_protocol_is_one_also_where_it_is_played() -> None:
    text = SUPPLIED.replace("var heard", "let mute = !heard && heard\n    var heard")
    text = text.replace("[loud && !heard]", "[mute]")
    assert [item.code for item in found(text) if item.code[0] == "W"] == ["W412"]


@pytest.mark.parametrize("block", ["scenario", "property"])
def test_a_variable_that_a_scenario_or_property_asks_for_is_read(block: str) -> None:
    text = """
system S
srm r {
  var rounds : int = 0
  liveness { r = Turn~ }
  activities { Turn takes 1s simulated }
  control r { repeat Turn : / rounds += 1 }
}
team T { a : r }
"""
    assert "N725" in {item.code for item in found(text)}
    asked = f'{block} "it counts" {{ always [rounds >= 0] }}'
    assert "N725" not in {item.code for item in found(text + asked)}
