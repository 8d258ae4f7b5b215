"""An agent that no `lost` line tells that a part is over learns it by a message of the protocol."""

from __future__ import annotations

import pytest

from tests.runtime.playing import MS, SECOND, Played, play
from tests.runtime.transport.net import Air, part
from tests.support.generated import generate
from tests.support.waiting import wait_until

TEXT = """
system Kitchen
message Order {{ string id }}
aip serving {{
  participant waiter {{
    sends request Order, cancel Order
    receives inform Order
    process = Ask . Serve
  }}
  participant cook [1..*] {{
    sends inform Order
    receives request Order, cancel Order
    process = Cook . [Stop] . [Clean]
  }}
  control waiter {{
    enter Ask : / send request Order {{ id = "1" }} to cook
    enter Serve : {serve}
  }}
  control cook {{
    enter Cook : request Order from waiter
    enter Stop : cancel Order from waiter
    skip Stop : after(4s) / send inform Order {{ id = "1" }} to waiter
    {line}
    skip Clean : else
  }}
}}
srm human {{ plays serving.waiter  liveness {{ {human} }}
  activities {{ Ask takes 1s  Serve takes 1s }}  {control} }}
srm robot {{ plays serving.cook  liveness {{ robot = cook }}
  activities {{ Cook takes 1ms  Stop takes 1s  Clean takes 1s }} }}
team T {{ ann : human  bob : robot }}
"""
EARLY = "human = waiter [> Rest"
CUT = "activities { Rest takes 1ms }  control human { enter Rest : after(2s) }"


def kitchen(serve: str, human: str = "human = waiter", control: str = "", line: str = "") -> Played:
    line = line or "enter Clean : [false]"
    text = TEXT.format(serve=serve, human=human, control=control, line=line)
    return play(generate(text), until=20 * SECOND)


def said(run: Played) -> list[str]:
    return [f"{r['time'] / MS:g} {r['agent']} {r['performative']}" for r in run.of("agent_message")]


INFORM = "inform Order from cook"


def test_who_is_left_is_sent_what_the_protocol_has() -> None:
    run = kitchen(INFORM, EARLY, CUT)
    assert said(run) == ["0 ann request", "2000 ann cancel"]
    assert "2000 start Stop" in run.activities("start")


def test_who_was_asked_and_has_not_answered_is_sent_it_too() -> None:
    run = kitchen("after(1s)")
    assert said(run) == ["0 ann request", "2000 ann cancel"]
    assert "2000 start Stop" in run.activities("start")


def test_who_has_answered_is_not() -> None:
    assert said(kitchen(INFORM)) == ["0 ann request", "4001 bob inform"]


def test_who_has_a_line_for_it_gets_that_alone() -> None:
    run = kitchen(INFORM, EARLY, CUT, line="enter Clean : lost waiter")
    assert "cancel" not in " ".join(said(run))


@pytest.mark.parametrize("serve", [INFORM, "after(1s)"])
def test_it_is_the_same_between_processes(serve: str) -> None:
    human, control = (EARLY, CUT) if serve == INFORM else ("human = waiter", "")
    text = TEXT.format(serve=serve, human=human, control=control, line="enter Clean : [false]")
    made, air = generate(text.replace("takes 1s", "takes 10ms").replace("4s", "1min")), Air()
    ann = part(made, ["ann"], {}, air.link()).start()
    bob = part(made, ["bob"], {}, air.link()).start()
    wait_until(lambda: bob.of("activity", what="start", activity="Stop"))
    ann.stop()
    bob.stop()
