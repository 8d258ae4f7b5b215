"""`on abandon`: what a participant sends when it is left before its END."""

from __future__ import annotations

from typing import Any

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.team.faults import Crash, Faults
from tests.runtime.outside import Outside
from tests.runtime.playing import MS, SECOND, Played, make, play
from tests.runtime.transport.net import Air, part
from tests.support.generated import generate
from tests.support.waiting import wait_until

TEXT = """
system Kitchen
message Order {{ string id }}
message Meal {{ string id }}
message Reason {{ string why  int tries }}
aip serving {{
  participant waiter {{
    sends request Order, cancel Order
    receives inform Meal, failure Reason
    process = Ask . (Serve | Sorry | Lost)
  }}
  participant cook {{
    var tries : int = 0
    sends inform Meal, failure Reason
    receives request Order, cancel Order
    process = Cook . Ring
  }}
  control waiter {{
    enter Ask : / send request Order {{ id = "1" }} to cook
    enter Serve : inform Meal from cook
    enter Sorry : failure Reason from cook
    enter Lost : lost cook
  }}
  control cook {{
    enter Cook : request Order from waiter / tries = 1
    enter Ring : / send inform Meal {{ id = "1" }} to waiter
    on abandon : / send failure Reason {{ why = "left", tries = tries }} to waiter
  }}
}}
srm human {{
  plays serving.waiter
  liveness {{ human = waiter }}
  activities {{ Ask takes 1s  Serve takes 1s  Sorry takes 1s  Lost takes 1s }}
}}
srm robot {{
  plays serving.cook
  liveness {{ {robot} }}
  activities {{ Cook takes 5s  Ring takes 1s }}
  {control}
}}
team T {{ ann : human  bob : robot }}
"""


def kitchen(robot: str = "robot = cook", control: str = "", **options: Any) -> tuple[str, Played]:
    """What the waiter did at last."""
    text = TEXT.format(robot=robot, control=control)
    run = play(generate(text), options.pop("activities", {}), until=20 * SECOND, **options)
    started = [r["activity"] for r in run.of("activity", what="start", agent="ann")]
    return started[-1], run


def said(run: Played) -> list[str]:
    return [
        f"{r['time'] // MS} {r['performative']} {r['content']}"
        for r in run.of("agent_message", agent="bob")
        if r["performative"] == "failure"
    ]


class Breaks:
    def execute(self, context: Context) -> None:
        raise RuntimeError("the pan is on fire")


@pytest.mark.parametrize(
    ("robot", "control"),
    [
        ("robot = cook [> Flee", "control robot { enter Flee : after(2s) }"),
        ("robot = work . Rest  work = cook", "control robot { enter Rest : after(2s) }"),
        ("robot = (cook || Rest~) [> Flee", "control robot { enter Flee : after(2s) }"),
    ],
)
def test_it_is_sent_before_the_loss(robot: str, control: str) -> None:
    last, run = kitchen(robot, control)
    assert said(run) == ["2000 failure {'why': 'left', 'tries': 1}"]
    assert last == "Sorry"
    assert not run.of("unexpected")


def test_not_by_one_that_completes() -> None:
    last, run = kitchen()
    assert (last, said(run)) == ("Serve", [])


def test_by_an_error_and_by_a_failure_of_the_agent() -> None:
    last, run = kitchen(
        "robot = cook . Rest", "control robot { enter Rest : error }", activities={"Cook": Breaks}
    )
    assert (last, len(said(run))) == ("Sorry", 1)
    last, run = kitchen(activities={"Cook": Breaks})
    assert (last, len(said(run))) == ("Sorry", 1)
    (leave,) = run.of("conversation", what="leave", agent="bob")
    assert leave["reason"] == "failed"


def test_not_by_one_that_crashes() -> None:
    last, run = kitchen(faults=Faults(crashes=(Crash("bob", 2 * SECOND, SECOND),)))
    assert (last, said(run)) == ("Lost", [])


def test_not_before_it_takes_part() -> None:
    text = TEXT.format(robot="robot = cook [> Flee", control="control robot { enter Flee : after(2s) }")
    run = play(generate(text.replace("ann : human", "")), until=5 * SECOND)
    assert said(run) == []
    assert not run.of("fault", agent="bob", reason="failure Reason is not sent: its participant was left")


def test_a_farewell_that_lacks_a_value_fails_nothing() -> None:
    text = TEXT.format(robot="robot = cook [> Flee", control="control robot { enter Flee : after(2s) }")
    text = text.replace("var tries : int = 0", "var tries : int = 0  var asker : agent")
    text = text.replace("tries = tries } to waiter", "tries = tries } to asker")
    run = play(generate(text), until=5 * SECOND)
    assert said(run) == []
    assert run.of("fault", agent="bob", reason="failure Reason is not sent: a value is absent")
    assert run.of("activity", what="start", agent="bob")[-1]["activity"] == "Flee"


@pytest.mark.parametrize(("back", "sent"), [("resume", 0), ("enter", 1)])
def test_one_that_is_suspended_says_it_when_it_is_discarded(back: str, sent: int) -> None:
    last, run = kitchen(
        "robot = (work [> Flee)~  work = cook",
        f"var n : int = 0 control robot {{ enter Flee : after(2s) [n < 1] / n = 1  {back} work :"
        "  resume work : [n > 5] }",
    )
    assert len(said(run)) == sent
    assert last == ("Sorry" if sent else "Serve")


def test_one_that_fails_while_suspended_says_it() -> None:
    last, run = kitchen(
        "robot = (work [> Flee)~  work = cook",
        "control robot { enter Flee : after(2s)  resume work : }",
        activities={"Flee": Breaks},
    )
    assert (last, said(run)) == ("Sorry", ["2000 failure {'why': 'left', 'tries': 1}"])


def test_what_was_prepared_is_sent() -> None:
    text = TEXT.replace(' {{ why = "left", tries = tries }}', "")

    class Cook:
        def execute(self, context: Context) -> None:
            context.prepare(generated.message("Reason", why="oven"))
            context.wait(5.0)

    made = text.replace("Cook takes 5s  ", "")
    generated = generate(
        made.format(robot="robot = cook [> Flee", control="control robot { enter Flee : after(2s) }")
    )
    run = play(generated, {"Cook": Cook}, until=20 * SECOND)
    assert said(run) == ["2000 failure {'why': 'oven', 'tries': 0}"]


CUT_SHORT = "robot = cook [> Charge"
CHARGE = "control robot { enter Charge : after(200ms) } activities { Charge takes 1s }"


def test_between_processes_the_others_get_it_first() -> None:
    text = TEXT.format(robot=CUT_SHORT, control=CHARGE)
    made, air = generate(text.replace("takes 1s", "takes 10ms")), Air()
    ann = part(made, ["ann"], {}, air.link()).start()
    bob = part(made, ["bob"], {}, air.link()).start()
    wait_until(lambda: ann.of("activity", what="start", activity="Sorry"))
    ann.stop()
    bob.stop()
    assert not ann.of("activity", what="start", activity="Lost")


def test_an_external_agent_gets_it_and_no_other_farewell() -> None:
    text = TEXT.format(robot=CUT_SHORT, control=CHARGE)
    team, _ = make(generate(text), agents=[("bob", "robot")], until=5 * SECOND)
    alice = Outside(team)
    alice.say(100, "request", {"id": "1"}, protocol="serving", conversation="c1", reply_with="a")
    team.run()
    assert alice.answers() == [("failure", {"why": "left", "tries": 1})]
