"""How an agent's part in a conversation ends, and what others are told of it."""

from __future__ import annotations

from typing import Any

import pytest

from aseme_dsl.amola.expression import LOSS_REASONS
from aseme_dsl.runtime import Context
from aseme_dsl.runtime.chart.inputs import REASONS
from aseme_dsl.runtime.team.faults import Crash, Faults
from aseme_dsl.runtime.trace.trace_schema import schema
from tests.runtime.playing import MS, SECOND, Played, play
from tests.runtime.transport.net import Air, part
from tests.support.generated import generate
from tests.support.waiting import wait_until

TEXT = """
system Kitchen
message Order {{ string id }}
message Meal {{ string id }}
aip serving {{
  participant waiter {{
    sends request Order, cancel Order
    receives inform Meal
    process = Ask . (Serve | Left | Failed | Crashed | Replaced | Completed)
  }}
  participant cook {{
    sends inform Meal
    receives request Order, cancel Order
    process = Cook . [Ring]
  }}
  control waiter {{
    enter Ask : / send request Order {{ id = "1" }} to cook
    enter Serve : inform Meal from cook
    enter Left : lost cook gone [reason(gone) == left]
    enter Failed : lost cook gone [reason(gone) == failed]
    enter Crashed : lost cook gone [reason(gone) == crashed]
    enter Replaced : lost cook gone [reason(gone) == replaced]
    enter Completed : lost cook gone [completed == reason(gone)]
  }}
  control cook {{
    enter Cook : request Order from waiter
    enter Ring : [{rings}] / send inform Meal {{ id = "1" }} to waiter
    skip Ring : else
  }}
}}
srm human {{
  plays serving.waiter
  liveness {{ human = waiter }}
  activities {{ Ask takes 1s }}
}}
srm robot {{
  plays serving.cook
  liveness {{ {robot} }}
  activities {{ Cook takes 5s }}
  {control}
}}
srm idle {{ liveness {{ idle = Idle }} activities {{ Idle takes 1s }} }}
team T {{ ann : human  bob : robot }}
"""


def kitchen(
    robot: str = "robot = cook", control: str = "", rings: str = "true", **options: Any
) -> tuple[str, Played]:
    """What the waiter did at last."""
    text = TEXT.format(robot=robot, control=control, rings=rings)
    run = play(generate(text), options.pop("activities", {}), until=20 * SECOND, **options)
    started = [r["activity"] for r in run.of("activity", what="start", agent="ann")]
    return started[-1], run


class Breaks:
    def execute(self, context: Context) -> None:
        raise RuntimeError("the pan is on fire")


def test_a_part_that_is_cut_short_is_lost_with_its_reason() -> None:
    last, run = kitchen("robot = cook [> Flee", "control robot { enter Flee : after(2s) }")
    assert last == "Left"
    (leave,) = run.of("conversation", what="leave", agent="bob")
    (gone,) = run.of("conversation", what="gone", agent="ann")
    assert (leave["reason"], gone["reason"], gone["time"]) == ("left", "left", 2000 * MS)


def test_a_part_that_an_outer_transition_leaves_is_lost() -> None:
    control = "control robot { enter Rest : after(2s) }"
    assert kitchen("robot = work . Rest  work = cook", control)[0] == "Left"


def test_a_part_that_an_error_leaves_is_lost() -> None:
    control = "control robot { enter Rest : error }"
    assert kitchen("robot = cook . Rest", control, activities={"Cook": Breaks})[0] == "Left"


def test_the_part_of_an_agent_that_fails_is_lost() -> None:
    assert kitchen(activities={"Cook": Breaks})[0] == "Failed"


def test_the_part_of_an_agent_that_crashes_is_lost_and_it_comes_back_without_it() -> None:
    crashes = (Crash("bob", 2 * SECOND, 3 * SECOND),)
    last, run = kitchen(faults=Faults(crashes=crashes))
    assert last == "Crashed"
    assert [r["what"] for r in run.of("conversation", agent="bob")] == ["join", "leave"]


def test_a_part_that_completes_without_an_answer_is_lost() -> None:
    last, run = kitchen(rings="false")
    assert last == "Completed"
    (leave,) = run.of("conversation", what="leave", agent="bob")
    assert "reason" not in leave


def test_what_a_part_has_sent_comes_before_its_loss() -> None:
    assert kitchen()[0] == "Serve"
    faults = Faults(delay=900 * MS, least_delay=10 * MS, loss=0.2, seed=4)
    assert kitchen(faults=faults)[0] == "Serve"


def test_an_agent_that_was_gone_before_is_lost_for_who_joins() -> None:
    """The waiter asks two; the second joins when the first has left the conversation."""
    text = """
system Pair
message Task { string id }
aip sharing {
  participant desk { sends request Task  receives inform Task  process = Ask . Wait }
  participant first { receives request Task  sends inform Task  process = Look . Work }
  participant second { receives request Task  sends inform Task  process = See . (Alone | Both) }
  control desk {
    enter Ask : / send request Task { id = "1" } to first; send request Task { id = "1" } to second
  }
  control first { enter Look : request Task from desk }
  control second {
    enter See : request Task from desk
    enter Alone : lost first gone [reason(gone) == failed]
    enter Both : after(10s)
  }
}
srm d { plays sharing.desk liveness { d = desk } activities { Ask takes 1s Wait takes 30s } }
srm f { plays sharing.first liveness { f = first } }
srm s { plays sharing.second liveness { s = Sleep . second } activities { Sleep takes 3s } }
team T { a : d  b : f  c : s }
"""
    run = play(generate(text), {"Look": Breaks}, until=40 * SECOND)
    assert run.order("start").count("start Alone") == 1


def test_messages_of_an_opener_that_has_left_open_nothing() -> None:
    text = """
system Late
message Task { string id }
aip work {
  participant desk { sends request Task  receives inform Task  process = Ask . Wait }
  participant hand { receives request Task  sends inform Task  process = Do . Tell }
  control hand { enter Do : request Task from desk  enter Tell : / send inform Task { id = "1" } to desk }
  control desk { enter Ask : / send request Task { id = "1" } to hand  enter Wait : inform Task from hand }
}
srm d { plays work.desk liveness { d = desk [> Quit } activities { Ask takes 30s }
  control d { enter Quit : after(1s) } }
srm h { plays work.hand liveness { h = Sleep . hand } activities { Sleep takes 3s } }
team T { a : d  b : h }
"""
    run = play(text, {}, until=10 * SECOND)
    assert "start Do" not in run.order("start")
    (unexpected,) = run.of("unexpected")
    assert unexpected["reason"] == "a has left the conversation: left"


@pytest.mark.parametrize(
    ("robot", "control", "last"),
    [
        ("robot = cook [> Flee", "control robot { enter Flee : after(300ms) }", "Left"),
        ("robot = cook", "", "Completed"),
    ],
)
def test_losses_are_told_between_processes(robot: str, control: str, last: str) -> None:
    text = (
        TEXT.format(robot=robot, control=control, rings="false").replace("5s", "600ms").replace("1s", "1ms")
    )
    made, air = generate(text), Air()
    ann = part(made, ["ann"], {}, air.link()).start()
    bob = part(made, ["bob"], {}, air.link()).start()
    wait_until(lambda: ann.of("activity", what="start", activity=last))
    ann.stop()
    bob.stop()


def test_the_language_the_runtime_and_the_trace_know_the_same_reasons() -> None:
    assert LOSS_REASONS == REASONS
    record = next(item for item in schema()["oneOf"] if item["title"] == "conversation")
    assert tuple(record["properties"]["reason"]["enum"]) == REASONS
