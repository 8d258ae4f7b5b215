"""The age of what goes by radio: it counts from the arrival plus the delay that the topic declares."""

from __future__ import annotations

import json
from typing import Any

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.team.network import Network
from aseme_dsl.runtime.trace.trace import Record
from aseme_dsl.worlds.field.match import Match
from aseme_dsl.worlds.field.radio import RadioSettings
from aseme_dsl.worlds.field.team import team_sheet
from tests.runtime.playing import MS, SECOND, play
from tests.support.generated import generate
from tests.support.networks import runs

TEXT = """
system S
message M {{ int n }}
topic air {clauses} {{ state M  data M }}
topic line {{ state M }}
srm sayer {{
  liveness {{ sayer = Say }}
  activities {{ Say writes air.state.M, air.data.M, line.state.M }}
}}
srm hearer {{
  liveness {{ hearer = Wait . Note }}
  activities {{
    Wait takes 1min simulated  Note takes 1ms reads air.state.M, air.data.M for 5s, line.state.M
  }}
  control hearer {{ enter Note : when [age(air.state.M) >= 1s] }}
}}
team T {{ ann : sayer  bob : hearer }}
"""


def activities(generated: Any) -> dict[str, type]:
    class Say:
        def execute(self, context: Context) -> None:
            context.wait(0.5)
            for channel in ("air.data.M", "line.state.M", "air.state.M"):
                context.publish(channel, generated.message("M", n=1))

    class Note:
        def execute(self, context: Context) -> None:
            ages = {name: context.age(name) for name in ("air.state.M", "air.data.M", "line.state.M")}
            context.log(json.dumps(ages))

    return {"Say": Say, "Note": Note}


def noted(clauses: str, **options: Any) -> tuple[int, dict[str, float], list[Record]]:
    """When bob finds the message to be 1 s old (ms), how old he finds all then, and the records."""
    generated = generate(TEXT.format(clauses=clauses))
    run = play(generated, activities(generated), until=5 * SECOND, **options)
    (log,) = run.of("log")
    (start,) = run.of("activity", activity="Note", what="start")
    return start["time"] // MS, json.loads(log["text"]), run.records


def test_without_a_delay_it_is_as_old_as_its_arrival() -> None:
    moment, ages, records = noted("radio 10")
    assert (moment, set(ages.values())) == (1500, {1.0})
    assert not [r for r in records if r["kind"] == "arrived"]


def test_a_declared_delay_is_added() -> None:
    moment, ages, records = noted("radio 10 delay 200ms")
    assert moment == 1300
    assert ages == {"air.state.M": 1.0, "air.data.M": 1.0, "line.state.M": 0.8}
    measured = {(r["agent"], r["channel"], r["measured"]) for r in records if r["kind"] == "arrived"}
    assert measured == {("bob", "air.state.M", 300 * MS), ("bob", "air.data.M", 300 * MS)}


def test_over_a_slow_network_only_other_messages_know_when_they_were_sent() -> None:
    slow = Network(50 * MS, 50 * MS).faults(1)
    moment, ages, _ = noted("radio 10", faults=slow)
    assert (moment, ages) == (1550, {"air.state.M": 1.0, "air.data.M": 1.0, "line.state.M": 1.05})
    moment, ages, _ = noted("radio 10 delay 200ms", faults=slow)
    assert (moment, ages) == (1350, {"air.state.M": 1.0, "air.data.M": 1.0, "line.state.M": 0.85})


def test_in_a_world_with_a_radio() -> None:
    radio = RadioSettings(loss=0.0)
    sheet = team_sheet(1, "Ours", ("ann", "bob"), goalie="dan")
    found = [
        noted(clauses, world=Match(1, home=sheet, radio=radio))
        for clauses in ("radio 10", "radio 10 delay 200ms")
    ]
    (plain, _, _), (delayed, ages, records) = found
    assert plain - delayed == 200
    assert ages["line.state.M"] < 1 and ages["air.state.M"] == 1.0
    heard = [r for r in records if r["kind"] == "radio_received"]
    assert heard and all(r["measured"] == r["time"] - 200 * MS for r in heard)


CENTER = """
system Center
message Assignment {{ int center }}
topic team radio 10 {delay} {{ state Assignment }}
srm boss {{
  liveness {{ boss = Assign~ }}
  activities {{ Assign every 1400ms writes team.state.Assignment }}
}}
srm player {{
  var number : int = 0
  liveness {{ player = (Rest . Attack . Pause)~ }}
  activities {{ Rest takes 1ms simulated  Attack takes 60min simulated  Pause takes 1ms simulated }}
  let is_center = age(team.state.Assignment) < 1200ms && team.state.Assignment.center == number
  control player {{
    enter Attack : [is_center]
    enter Pause  : when [!is_center]
  }}
}}
team T {{
  lead : boss
  one  : player with number = 1
  two  : player with number = 2
}}
"""


def both_attack(delay: str, seed: int) -> bool:
    """Whether both players are the center at one moment: the boss appoints another one every 1.4 s."""
    generated = generate(CENTER.format(delay=delay))

    class Assign:
        def execute(self, context: Context) -> None:
            number = 1 + context.now_ns // (1400 * MS) % 2
            context.publish("team.state.Assignment", generated.message("Assignment", center=number))

    found = runs(
        generated, "delay=0..300ms,reorder", seeds=[seed], until=60 * SECOND, activities={"Assign": Assign}
    )
    attacking: set[str] = set()
    for record in next(found).records:
        if record["kind"] == "activity" and record["activity"] == "Attack":
            (attacking.add if record["what"] == "start" else attacking.discard)(record["agent"])
            if len(attacking) == 2:
                return True
    return False


@pytest.mark.parametrize("seed", range(3))
def test_two_robots_are_the_center_unless_the_radio_declares_its_delay(seed: int) -> None:
    """M5: an assignment is void after 1.2 s, and the other one comes after 1.4 s at the earliest."""
    assert both_attack("", seed)
    assert not both_attack("delay 300ms", seed)
