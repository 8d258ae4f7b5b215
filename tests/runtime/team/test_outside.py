"""An agent that waits for input from outside is idle when a run ends; one that waits for another is not."""

from __future__ import annotations

import pytest

from tests.runtime.playing import play
from tests.support.generated import generate

SHOP = """
system Shop
message Order { int id }
message Open { bool door }
topic shop { signal Order queued  state Open }
aip delivery {
  participant desk {
    var now : int = 0
    sends request Order, cancel Order
    receives inform Order
    process = Serve
  }
  participant drone {
    sends inform Order
    receives request Order, cancel Order
    process = Fly . Wait
  }
  control desk {
    enter Serve : / send request Order { id = 1 } to drone
    LINE
  }
  control drone {
    enter Fly : request Order from desk
    enter Wait : cancel Order from desk
    leave Wait : / send inform Order { .. } to desk
  }
}
srm depot {
  plays delivery.desk
  liveness { depot = desk MORE }
  activities { Serve waits  STOP }
  control depot { LEAVING }
}
srm plane {
  plays delivery.drone
  liveness { plane = drone }
  activities { Fly takes 1s simulated  Wait takes 1s simulated }
}
srm watch {
  liveness { watch = Look . Close }
  activities { Look takes 1s simulated  Close takes 1s simulated }
  control watch { enter Close : [shop.state.Open.door] }
}
team T { d : depot  p : plane  WATCH }
"""

ORDERS = "on Serve : when [has(shop.signal.Order)] / now = 1; send cancel Order { .. } to drone"
INFORM = "leave Serve : inform Order from drone"


@pytest.mark.parametrize(
    ("line", "more", "leaving", "watch", "idle"),
    [
        (ORDERS, "", "", "", ["d", "p"]),
        (f"on Serve : called / send cancel Order {{ .. }} to drone {INFORM}", "", "", "", ["d", "p"]),
        (INFORM, "", "", "", []),
        (INFORM, "[> Stop", "enter Stop : when [has(shop.signal.Order)]", "", []),
        (INFORM, "", "", "w : watch", ["w"]),
        (
            ORDERS,
            "",
            "on desk : called / write_messages.shop.state.Open { door = true }",
            "w : watch",
            ["d", "p", "w"],
        ),
        (INFORM, "", "on desk : called / write_messages.shop.state.Open { door = true }", "w : watch", []),
    ],
)
def test_who_is_idle(line: str, more: str, leaving: str, watch: str, idle: list[str]) -> None:
    text = (
        SHOP.replace("LINE", line)
        .replace("MORE", more)
        .replace("LEAVING", leaving)
        .replace("WATCH", watch)
        .replace("STOP", "Stop waits" if more else "")
    )
    result = play(generate(text)).result
    assert list(result.stuck) == [agent.name for agent in result.agents], "nothing pending can wake them"
    assert [agent.name for agent in result.agents if agent.idle] == idle


def test_what_also_comes_from_outside_may_come() -> None:
    text = """
        system Line
        message Part { int to }
        topic belt { signal Part SOURCES }
        srm station {
          liveness { station = (Wait . Work)~ [> Halt }
          activities { Wait waits  Work takes 1s simulated  Halt takes 1s simulated }
          control station {
            enter Halt : emergency
            enter Work : when [belt.signal.Part.to == index]
            leave Work : / write_messages.belt.signal.Part { to = index + 1 }
          }
        }
        team Line { a : station  b : station }
    """
    for sources, idle in (("from outside, station", True), ("from station", False)):
        result = play(generate(text.replace("SOURCES", sources))).result
        assert [agent.idle for agent in result.agents] == [idle, idle], sources
