"""`on T : inform M from x` without an action takes the message out of the mailbox and drops it."""

from __future__ import annotations

import pytest

from aseme_dsl.amola.statechart import transition_text
from tests.runtime.playing import Played, play
from tests.support.compiling import codes, system
from tests.support.generated import generate

DEPOT = """
system Depot
message Order { int id }
aip delivery {
  participant desk {
    sends request Order
    receives inform Order
    process = Serve . Close
  }
  participant drone {
    var sent : int = 0
    sends inform Order
    receives request Order
    process = Fly . Report+
  }
  control desk {
    enter Serve : / send request Order { id = 1 } to drone
    enter Close : after(5s)
    LINE
  }
  control drone {
    enter  Fly    : request Order from desk
    enter  Report+ : / send inform Order { id = 1 } to desk; sent = 1
    repeat Report : [sent < 3] / sent += 1; send inform Order { id = sent } to desk
    leave  Report : else
  }
}
srm depot {
  plays delivery.desk
  liveness { depot = desk }
  activities { Serve waits  Close takes 1s simulated }
}
srm plane {
  plays delivery.drone
  liveness { plane = drone }
  activities { Fly takes 1s simulated  Report takes 500ms simulated }
}
team T { d : depot  p : plane }
"""


def left(line: str) -> tuple[int, Played]:
    """How many messages the desk has not taken at the end, and the run."""
    run = play(generate(DEPOT.replace("LINE", line)))
    [leave] = [item for item in run.of("conversation", what="leave") if item["agent"] == "d"]
    refused = run.of("agent_message", agent="d", performative="not_understood")
    return len(leave.get("untaken") or ()) + len(refused), run


@pytest.mark.parametrize(
    ("line", "untaken"),
    [
        ("", 3),
        ("on Serve : inform Order from drone", 0),
        ("on Serve : inform Order o from drone [o.id > 1]", 1),
        ("on Serve : inform Order from drone or lost drone", 0),
    ],
)
def test_what_a_line_hears_is_taken(line: str, untaken: int) -> None:
    found, run = left(line)
    assert found == untaken
    assert run.order("start")[-1] == "start Close", "the line does not leave the state"


def test_the_line_is_shown_as_it_is_written() -> None:
    line = "on Serve : inform Order o from drone [o.id > 1]"
    chart = system(DEPOT.replace("LINE", line)).iacs[0]
    [way] = [item for item in chart.transitions if item.kind.value == "on"]
    assert transition_text(way) == "on inform Order o from drone [o.id > 1]"


@pytest.mark.parametrize("line", ["on Serve : after(1s)", "on Serve : when [index > 3]"])
def test_what_takes_nothing_still_needs_an_action(line: str) -> None:
    assert "E423" in codes(DEPOT.replace("LINE", line))


DOORS = """
system Doors
message Order { int id }
aip talk {
  participant alice {
    var busy : bool = true
    sends request Order
    receives inform Order
    process = Ask . (Wait | (Left || Right))
  }
  participant bob {
    sends inform Order
    receives request Order
    process = Hear . Tell
  }
  control alice {
    enter Ask             : / send request Order { id = 1 } to bob
    enter Wait            : [busy]
    enter (Left || Right) : else
    enter Right           : inform Order from bob
    0.2.1.2.3.3 -> 0.2.1.2.3.4.2.1.2 : after(2s)  // from Wait to Left
  }
  control bob {
    enter Hear : request Order from alice
    enter Tell : / send inform Order { id = 1 } to alice
  }
}
srm one {
  plays talk.alice
  liveness { one = alice }
  activities { Ask takes 1s simulated  Wait waits  Left takes 1s simulated  Right takes 1s simulated }
}
srm two {
  plays talk.bob
  liveness { two = bob }
  activities { Hear takes 1s simulated  Tell takes 1s simulated }
}
team T { a : one  b : two }
"""


def test_a_message_waits_for_a_region_that_is_entered_beside_a_target() -> None:
    run = play(generate(DOORS))
    assert run.order("start") == [
        f"start {name}" for name in ("Ask", "Hear", "Wait", "Tell", "Left", "Right")
    ]
    assert run.of("agent_message", performative="not_understood") == []
