"""A participant that a `resume` line can continue is suspended: its conversation waits for it."""

from __future__ import annotations

import re
from typing import Any

import pytest

from aseme_dsl.project.playing.run_end import end_lines
from aseme_dsl.runtime import Context
from aseme_dsl.runtime.team.faults import Crash, Faults
from tests.runtime.outside import Outside
from tests.runtime.playing import MS, SECOND, Played, make, play
from tests.runtime.transport.net import Air, part
from tests.support.generated import generate
from tests.support.waiting import wait_until

TEXT = """
system Kitchen
message Order { string id }
message Meal { string id }
aip serving {
  participant waiter {
    sends request Order, cancel Order
    receives inform Meal, agree Order
    process = Ask . (Serve | Gone) . Say . Rest
  }
  participant cook {
    sends inform Meal, agree Order by Cook
    receives request Order, cancel Order
    process = Cook . Ring . (Bow | Late)
  }
  control waiter {
    enter Ask : / send request Order { id = "1" } to cook
    enter Serve : inform Meal from cook
    enter Gone : lost cook
    enter Say : / send cancel Order { id = "1" } to cook
  }
  control cook {
    enter Cook : request Order from waiter
    enter Ring : / send inform Meal { id = "1" } to waiter
    enter Bow : cancel Order from waiter
    enter Late : after(2s)
  }
}
srm human {
  plays serving.waiter
  liveness { human = waiter }
  activities { Ask takes 1s  Serve takes 100ms  Gone takes 100ms  Say takes 100ms  Rest takes 20s }
}
srm robot {
  plays serving.cook
  var tries : int = 0
  var back : bool = true
  liveness { robot = (shift [> Charge)~  shift = Look . cook . Sweep }
  activities { Look takes 0s  Cook takes 5s  Ring takes 500ms  Charge takes 4s
    Sweep takes 100s  Bow takes 1s  Late takes 1s }
  control robot {
    enter Charge : after(2s) [tries < 1] / tries = 1
    resume shift : [back]
    enter shift : else
  }
}
team T { ann : human  bob : robot }
"""


def kitchen(text: str = TEXT, activities: Any = (), **options: Any) -> Played:
    return play(generate(text), dict(activities), until=20 * SECOND, **options)


def whats(run: Played, agent: str = "bob") -> list[str]:
    return [f"{r['time'] // MS} {r['what']}" for r in run.of("conversation", agent=agent)]


def test_the_end_of_the_run_says_what_is_suspended() -> None:
    run = play(generate(TEXT), {}, until=3 * SECOND)
    (conversation,) = run.result.conversations
    assert {item.agent: item.suspended for item in conversation.members} == {"ann": False, "bob": True}
    lines = [line for line in end_lines(run.result) if "as cook" in line]
    assert lines == ["  bob as cook is suspended"]


def did(run: Played, agent: str, what: str = "start") -> list[str]:
    return [
        f"{r['time'] // MS} {r['activity']}" for r in run.of("activity", agent=agent) if r["what"] == what
    ]


def test_a_conversation_is_suspended_and_ends_as_if_nothing_had_been() -> None:
    run = kitchen()
    assert whats(run)[:3] == ["0 join", "2000 suspend", "6000 resume"]
    assert did(run, "bob") == [
        "0 Look",
        "0 Cook",
        "2000 Charge",
        "6000 Cook",
        "11000 Ring",
        "11500 Bow",
        "12500 Sweep",
    ]
    assert did(run, "ann") == ["0 Ask", "11000 Serve", "11100 Say", "11200 Rest"]
    assert not run.of("unexpected")


def test_mail_waits_and_deadlines_stand_still() -> None:
    text = (
        TEXT.replace("after(2s) [tries < 1]", "after(6s) [tries < 1]")
        .replace("Say takes 100ms", "Say takes 2s")
        .replace("enter Say : /", "enter Rest : /")
    )
    run = kitchen(text)
    # Late is due 2 s after Ring; 500 ms of that pass before Charge, the rest after it.
    assert did(run, "bob")[-3:] == ["6000 Charge", "10000 Bow", "11000 Sweep"]


def test_a_deadline_goes_on_where_it_stood() -> None:
    text = TEXT.replace("after(2s) [tries < 1]", "after(6s) [tries < 1]").replace(
        "Say takes 100ms", "Say takes 20s"
    )
    text = text.replace("enter Say : /", "enter Rest : /")
    run = kitchen(text)
    assert did(run, "bob")[-3:] == ["6000 Charge", "11500 Late", "12500 Sweep"]


def test_by_enter_it_is_left() -> None:
    run = kitchen(TEXT.replace("back : bool = true", "back : bool = false"))
    assert whats(run)[:3] == ["0 join", "2000 suspend", "6000 leave"]
    (leave,) = run.of("conversation", what="leave", agent="bob")
    assert leave["reason"] == "left"
    assert did(run, "ann")[1] == "6000 Gone"


@pytest.mark.parametrize("restart", [SECOND, 2 * SECOND])
def test_a_crash_ends_what_is_suspended(restart: int) -> None:
    run = kitchen(faults=Faults(crashes=(Crash("bob", 3 * SECOND, restart),)))
    assert whats(run)[:3] == ["0 join", "2000 suspend", "3000 leave"]
    (leave,) = run.of("conversation", what="leave", agent="bob")
    assert leave["reason"] == "crashed"
    assert did(run, "ann")[1] == "3000 Gone"


class Fails:
    def execute(self, context: Context) -> None:
        raise RuntimeError("no current")


def test_a_failure_ends_what_is_suspended() -> None:
    run = kitchen(activities={"Charge": Fails})
    assert [r["reason"] for r in run.of("conversation", what="leave", agent="bob")] == ["failed"]
    assert did(run, "ann")[1] == "2000 Gone"


@pytest.mark.parametrize(("repeatedly", "times"), [("", 1), (" repeatedly", 2)])
def test_what_was_sent_is_not_sent_again(repeatedly: str, times: int) -> None:
    generated = generate(TEXT.replace("Cook takes 5s  ", "").replace("by Cook", f"by Cook{repeatedly}"))

    class Cook:
        """Agrees at once, and then cooks."""

        def execute(self, context: Context) -> None:
            context.send("agree", generated.message("Order", id="1"), "waiter")
            context.wait(5.0)

    run = play(generated, {"Cook": Cook}, until=20 * SECOND)
    assert [r["time"] // MS for r in run.of("agent_message", performative="agree")] == [0, 6000][:times]
    assert len(run.of("unsent", performative="agree")) == 2 - times
    assert did(run, "ann")[1] == "11000 Serve"


def test_one_that_is_suspended_is_not_invited() -> None:
    """It waits without a conversation, and takes one when it goes on."""
    text = TEXT.replace("human = waiter", "human = Wait . waiter").replace(
        "Ask takes", "Wait takes 3s  Ask takes"
    )
    run = kitchen(text)
    assert whats(run)[0] == "6000 join"


def test_between_processes_a_suspended_part_is_nobody_s_loss() -> None:
    text = re.sub(r"takes (\d+)s\b", r"takes \g<1>0ms", TEXT).replace(
        "after(2s) [tries", "after(20ms) [tries"
    )
    made, air = generate(text), Air()
    ann = part(made, ["ann"], {}, air.link()).start()
    bob = part(made, ["bob"], {}, air.link()).start()
    wait_until(lambda: bob.of("conversation", what="suspend"))
    wait_until(lambda: bob.of("conversation", what="resume"))
    wait_until(lambda: ann.of("activity", what="start", activity="Serve"))
    wait_until(lambda: bob.of("activity", what="start", activity="Sweep"))
    ann.stop()
    bob.stop()
    assert not ann.of("activity", what="start", activity="Gone")


def test_an_external_agent_waits_for_a_suspended_part() -> None:
    team, records = make(generate(TEXT), agents=[("bob", "robot")], until=20 * SECOND)
    alice = Outside(team)
    alice.say(100, "request", {"id": "1"}, protocol="serving", conversation="c1", reply_with="a")
    alice.say(3000, "cancel", {"id": "1"}, protocol="serving", conversation="c1", reply_with="b")
    team.run()
    assert alice.answers() == [("inform", {"id": "1"})]
    whats = [r["what"] for r in records if r["kind"] == "conversation" and r["agent"] == "bob"]
    assert whats[:3] == ["join", "suspend", "resume"]
    assert "Bow" in [r["activity"] for r in records if r["kind"] == "activity" and r["what"] == "start"]
