"""`asemec why` and `asemec whynot`, as people ask: what they say of recorded runs, and that it is so."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.cli.support import Here

DESK = """\
system Desk
message Ball { double distance  bool visible }
message Order { int n }
message Job { int n }
topic eyes { state Ball from outside }
topic shop { signal Order from outside }
aip hire {
  participant boss {
    sends    request Job
    receives inform Job
    process  = Ask . Listen
  }
  participant hand { sends inform Job  receives request Job  process = Do . Tell }
  control boss {
    enter Listen : / send request Job { n = 1 } to hand
    leave Listen : inform Job from hand
    leave Listen : after(20s)
  }
  control hand { enter Do : request Job from boss  enter Tell : / send inform Job { n = 2 } to boss }
}
srm boss {
  plays hire.boss
  var tries : int = 0
  liveness { boss = (boss . (Jab | Kick | Rest))~ [> Flee }
  activities {
    Ask takes 100ms simulated  Listen takes 1ms simulated
    Jab takes 1s simulated  Kick takes 1s simulated  Flee takes 1s simulated
    Rest takes 500ms simulated ends well, badly
  }
  let close = eyes.state.Ball.visible && eyes.state.Ball.distance < 2
  control boss {
    enter Jab  : [tries > 3] weight 3
    enter Kick : [tries > 3] weight 1
    enter Rest : else
    repeat (boss . (Jab | Kick | Rest)) : / tries += 1
    enter Flee : when [close]
  }
}
srm hand {
  plays hire.hand
  liveness { hand = hand~ || (Wait . Serve . Pack)~ }
  activities {
    Do takes 30s simulated  Tell takes 1ms simulated
    Wait waits  Serve takes 1s simulated ends served, empty  Pack takes 1s simulated
  }
  control hand {
    enter Serve : when [has(shop.signal.Order)] / start_timer(pause, 5s)
    on    Serve : ignores shop.signal.Order
    on    Pack  : ignores shop.signal.Order
    enter Pack  : [outcome(Serve) == served && expired(pause)]
  }
}
team Desk { ann : boss  bob : hand }
"""
"""Two agents with everything that a transition can wait for."""

INPUTS = """\
{"at": "1s", "channel": "eyes.state.Ball", "message": {"distance": 5, "visible": true}}
{"at": "8s", "channel": "shop.signal.Order", "message": {"n": 1}}
"""


_TRACE: list[bytes] = []
"""The trace of the run, which is made once."""


@pytest.fixture
def desk(here: Here, folder: Path) -> Here:
    (folder / "desk.aseme").write_text(DESK)
    (folder / "in.jsonl").write_text(INPUTS)
    if not _TRACE:
        arguments = ("--input", "in.jsonl", "--for", "60s", "--trace", "t.jsonl", "--quiet")
        here("run", "desk.aseme", *arguments)
        _TRACE.append((folder / "t.jsonl").read_bytes())
    (folder / "t.jsonl").write_bytes(_TRACE[0])
    return here


def asked(here: Here, command: str, agent: str, what: str, at: str, *more: str) -> str:
    found = here(command, agent, what, "--at", at, "t.jsonl", *more)
    assert found.code == 0, found.err
    return found.out


def test_an_activity_that_has_not_ended_and_a_timer(desk: Here) -> None:
    assert asked(desk, "whynot", "bob", "Pack", "8.5s") == (
        "at 8.5 s bob is in Serve since 8 s, beside Do\n"
        "`Pack` did not happen; it would have, if these 2 things were otherwise:\n"
        "  to Pack from Serve by `[outcome(Serve) == served && expired(pause)]` (desk.aseme:50:5)\n"
        "    Serve has not ended with `served`: its activity runs since 8 s, and takes 1 s\n"
        "    `expired(pause)` does not hold\n"
        "      timer pause runs out at 13 s\n"
    )


def test_a_message_that_has_not_come_its_sender_and_a_draw(desk: Here) -> None:
    assert asked(desk, "whynot", "ann", "Kick", "5s") == (
        "at 5 s ann is in Listen since 0.1 s\n"
        "`Kick` did not happen; it would have, if these 3 things were otherwise:\n"
        "  to Kick from Listen by `inform Job from hand`, `[tries > 3] weight 1` (desk.aseme:33:5)\n"
        "    `inform Job` from hand has not come, or was taken before\n"
        "      bob has never sent it; it does in Do -> Tell (desk.aseme:19:52), and is in Do since 0.1 s\n"
        "        to Tell from Do by `/ send inform Job { n = 2 } to boss` (desk.aseme:19:52)\n"
        "          Do has not ended: its activity runs since 0.1 s, and takes 30 s\n"
        "    `tries > 3` does not hold\n"
        "      tries is 0\n"
        "      tries is set in (hire_boss . (Jab | Kick | Rest)) -> (hire_boss . (Jab | Kick | Rest))"
        " (desk.aseme:35:5)\n"
        "    another branch may be drawn: this one has the weight 1, all together 4\n"
    )
    assert "to Tell" not in asked(desk, "whynot", "ann", "Kick", "5s", "--depth", "0")


def test_a_value_has_its_age_and_sender(desk: Here) -> None:
    assert asked(desk, "whynot", "ann", "Flee", "3s").splitlines()[2:] == [
        "  to Flee from (hire_boss . (Jab | Kick | Rest))~ by `[> when [close]` (desk.aseme:36:5)",
        "    `eyes.state.Ball.distance < 2` does not hold",
        "      eyes.state.Ball.distance is 5.0, 2 s old, from input",
    ]


def test_a_message_that_nobody_of_the_team_publishes(desk: Here) -> None:
    found = asked(desk, "whynot", "ann", "Flee", "500ms")
    assert "    `eyes.state.Ball.visible` does not hold\n" in found
    assert "      eyes.state.Ball.visible is absent: the message is not there\n" in found
    assert "no role of the team publishes it: it comes from outside" in found


def test_several_stages_and_what_was_done_instead(desk: Here) -> None:
    found = asked(desk, "whynot", "ann", "Jab", "20.3s").splitlines()
    assert [line for line in found if line.startswith("  ") and line[2] != " "] == [
        "  1. to Ask from Rest by `/ tries += 1` (desk.aseme:11:16)",
        "  2. to Listen from Ask by `/ send request Job { n = 1 } to hand` (desk.aseme:15:5)",
        "  3. to Jab from Listen by `inform Job from hand`, `[tries > 3] weight 3` (desk.aseme:32:5)",
    ]


def test_what_was_taken_at_that_moment_comes_first(desk: Here) -> None:
    found = asked(desk, "whynot", "ann", "Jab", "20.1s").splitlines()
    assert found[1] == "`Jab` did not happen; it would have, if this was otherwise:"
    rest = "to Rest from the start of (Jab | Kick | Rest) by `else` (desk.aseme:34:5)"
    assert found[2] == f"  at 20.1 s it went {rest} instead"
    assert found[3:5] == ["    `tries > 3` does not hold", "      tries is 0"]
    assert found[5].startswith("      tries is set in ")


def test_why_names_what_was_needed(desk: Here) -> None:
    assert asked(desk, "why", "bob", "Pack", "20s").splitlines()[1:] == [
        "`Pack` happened:",
        "  at 13 s it went to Pack from Serve by `[outcome(Serve) == served && expired(pause)]`"
        " (desk.aseme:50:5)",
        "    `outcome(Serve) == served` held",
        '      outcome(Serve) is "served"',
        "    `expired(pause)` held",
        "      timer pause has run out at 13 s",
    ]
    assert asked(desk, "why", "ann", "Rest", "30s").splitlines()[3:] == [
        "    20 s had passed since Listen was entered",
        "    `tries > 3` did not hold",
        "      tries is 0",
    ]
    assert "`request Job` from ann came" in asked(desk, "why", "bob", "Do", "40s")
    assert 'shop.signal.Order is {"n": 1}, 0 s old, from input' in asked(desk, "why", "bob", "Serve", "9s")


def test_transitions_messages_and_channels_can_be_asked_for(desk: Here) -> None:
    told = "Do has not ended: its activity runs since 0.1 s, and takes 30 s"
    for what in ("inform Job", "send inform Job", "Do -> Tell", "hire_hand.Tell"):
        assert told in asked(desk, "whynot", "bob", what, "10s"), what


def test_what_is_so_and_what_never_was(desk: Here) -> None:
    found = asked(desk, "whynot", "bob", "Serve", "9s")
    assert "it is so: ask `asemec why bob Serve --at 9s t.jsonl`" in found
    assert "it has never been there in this trace" in asked(desk, "why", "ann", "Flee", "60s")


def test_json_has_the_same_lines(desk: Here) -> None:
    found = json.loads(asked(desk, "whynot", "ann", "Flee", "3s", "--json"))
    assert found["format"] == 1 and found["is_so"] is False and found["time_ns"] == 3_000_000_000
    (way,) = found["said"]
    assert way["inside"][0]["text"] == "`eyes.state.Ball.distance < 2` does not hold"


def test_names_that_are_not_there(desk: Here) -> None:
    found = desk("whynot", "ann", "Kikc", "--at", "3s", "t.jsonl")
    assert found.code == 2 and "did you mean Kick?" in found.err
    found = desk("whynot", "carl", "Kick", "--at", "3s", "t.jsonl")
    assert found.code == 1 and "the team has ann, bob" in found.err
    found = desk("whynot", "ann", "Kick", "--at", "3s", "none.jsonl")
    assert found.code == 1 and "E001" in found.err
    found = desk("whynot", "ann", "Listen -> Jab", "--at", "3s", "t.jsonl")
    assert found.code == 2 and "ask for Jab" in found.err


# What is told to be otherwise is made otherwise, in a run with other inputs: then it happens.
OTHERWISE = [
    (
        "Flee",
        "3s",
        '{"at": "3s", "channel": "eyes.state.Ball", "message": {"distance": 1, "visible": true}}\n',
        ("`eyes.state.Ball.distance < 2` does not hold",),
    ),
    (
        "Flee",
        "500ms",
        '{"at": "500ms", "channel": "eyes.state.Ball", "message": {"distance": 1, "visible": true}}\n',
        ("`eyes.state.Ball.visible` does not hold",),
    ),
]


@pytest.mark.parametrize(("what", "at", "inputs", "facts"), OTHERWISE)
def test_it_happens_if_what_is_told_is_otherwise(
    desk: Here, folder: Path, what: str, at: str, inputs: str, facts: tuple[str, ...]
) -> None:
    found = asked(desk, "whynot", "ann", what, at)
    assert all(fact in found for fact in facts)
    (folder / "other.jsonl").write_text(inputs)
    arguments = ("--input", "other.jsonl", "--for", "60s", "--trace", "other-trace.jsonl", "--quiet")
    desk("run", "desk.aseme", *arguments)
    told = desk("why", "ann", what, "--at", at, "other-trace.jsonl")
    assert f"`{what}` happened" in told.out, told.out


LOSSY = """\
system Lossy
message Here { int n }
topic radio { state Here }
srm one { liveness { one = Tell~ }  activities { Tell every 1s writes radio.state.Here simulated } }
srm two {
  liveness { two = Idle . Go }
  activities { Idle takes 1s simulated  Go takes 1s simulated }
  control two { enter Go : [radio.state.Here.n == 0 && age(radio.state.Here) < 500ms] }
}
team Two { ann : one  bob : two }
"""


def test_a_sender_is_asked_back(here: Here, folder: Path) -> None:
    (folder / "lossy.aseme").write_text(LOSSY)
    assert here("run", "lossy.aseme", "--for", "5s", "--trace", "t.jsonl", "--quiet").code == 0
    found = asked(here, "whynot", "bob", "Go", "3s")
    assert "ann has never published it; it does in Tell, and is in Tell" in found


def test_a_trace_that_breaks_off_in_its_header(desk: Here, folder: Path) -> None:
    (folder / "torn.jsonl").write_bytes(_TRACE[0][:100])
    found = desk("whynot", "ann", "Flee", "--at", "3s", "torn.jsonl")
    assert found.code == 1 and "the trace breaks off here" in found.err


def test_a_name_of_many_parts(desk: Here) -> None:
    found = desk("whynot", "ann", "a." * 5000, "--at", "3s", "t.jsonl")
    assert found.code == 2 and "has no state" in found.err


GUARD = """\
system Guards
message Alarm { int zone }
message Battery { double percent }
topic env { signal Alarm from outside  state Battery from outside }
srm guard {
  liveness {
    guard = (duty [> Charge)~
    duty  = Patrol~ [> Run
  }
  activities { Patrol takes 3s simulated  Run takes 20s simulated  Charge takes 10s simulated }
  control guard {
    enter  Run    : when [env.signal.Alarm.zone == 1]
    enter  Charge : when [env.state.Battery.percent < 20]
    resume duty   :
    repeat (duty [> Charge) : [env.state.Battery.percent > 80]
  }
}
"""


def test_what_was_left_is_resumed(here: Here, folder: Path) -> None:
    (folder / "guard.aseme").write_text(GUARD)
    (folder / "in.jsonl").write_text(
        '{"at": "1s", "channel": "env.signal.Alarm", "message": {"zone": 1}}\n'
        '{"at": "2s", "channel": "env.state.Battery", "message": {"percent": 10}}\n'
        '{"at": "13s", "channel": "env.state.Battery", "message": {"percent": 90}}\n'
    )
    here("run", "guard.aseme", "--input", "in.jsonl", "--for", "15s", "--trace", "t.jsonl", "--quiet")
    found = asked(here, "whynot", "guard", "Run", "6s")
    assert "Charge has not ended" in found and "`env.state.Battery.percent > 80` does not hold" in found
    assert "`env.state.Battery.percent < 20` holds" in found
    found = asked(here, "why", "guard", "Run", "14s")
    assert "`env.state.Battery.percent > 80` held" in found
    assert "(guard.aseme:14:5), which resumed it where it was left at 2 s" in found


FAREWELL = """\
system Farewell
message Req { int n }
topic t { signal Stop from outside }
message Stop { int n }
aip talk {
  participant asker {
    sends request Req, failure Req
    receives inform Req
    process = Ask . Hear
  }
  participant helper { sends inform Req  receives request Req, failure Req  process = Help . Tell }
  control asker {
    enter Hear : / send request Req { n = 1 } to helper
    leave Hear : inform Req from helper
    on abandon : / send failure Req { n = 2 } to helper
  }
  control helper {
    enter Help : request Req from asker
    on Help : failure Req from asker
    enter Tell : / send inform Req { n = 1 } to asker
  }
}
srm one {
  plays talk.asker
  liveness { one = (asker [> Rest) }
  activities { Ask takes 1s simulated  Hear takes 1s simulated  Rest takes 1s simulated }
  control one { enter Rest : when [has(t.signal.Stop)] }
}
srm two {
  plays talk.helper
  liveness { two = helper~ }
  activities { Help takes 30s simulated  Tell takes 1s simulated }
}
team Two { ann : one  bob : two }
"""


def test_a_farewell_is_sent_where_its_part_is_left(here: Here, folder: Path) -> None:
    (folder / "farewell.aseme").write_text(FAREWELL)
    here("run", "farewell.aseme", "--for", "5s", "--trace", "t.jsonl", "--quiet")
    found = asked(here, "whynot", "ann", "failure Req", "3s")
    assert "`has(t.signal.Stop)` does not hold" in found, found


SEEING = """\
system Seeing
message Ball { double distance }
topic eyes { state Ball  signal Ball }
srm seer {
  liveness { seer = Stand }
  activities { Stand takes 30s simulated }
  modules { Vision every 1s as step writes eyes.state.Ball, eyes.signal.Ball }
}
srm kicker {
  liveness { kicker = Walk . (Kick | Wave) }
  activities { Walk takes 2500ms simulated  Kick takes 1s simulated  Wave takes 1s simulated }
  control kicker { enter Kick : [eyes.signal.Ball.distance > 0]  enter Wave : [eyes.state.Ball.distance < 0] }
}
team Seeing { ann : seer  bob : kicker }
"""

VISION = """\
from monas.Seeing.messages import Ball


class Vision:
    def execute(self, context):
        context.publish("eyes.state.Ball", Ball(distance=1.0))
"""


@pytest.fixture
def seeing(here: Here, folder: Path) -> Here:
    """An agent sees with a module, which is Python, and another one waits for what it sees."""
    (folder / "seeing.aseme").write_text(SEEING)
    (folder / "activities").mkdir()
    (folder / "activities" / "vision.py").write_text(VISION)
    arguments = ("--activities", "activities", "--for", "5s", "--trace", "t.jsonl", "--quiet")
    assert here("run", "seeing.aseme", *arguments).code == 0
    return here


def test_a_module_of_another_agent_publishes(seeing: Here) -> None:
    assert "ann has never published it; the module Vision does, and its code decides when" in asked(
        seeing, "whynot", "bob", "Kick", "3s"
    )
    for at, age in (("2800ms", "0.8 s"), ("3s", "0 s")):
        found = asked(seeing, "whynot", "bob", "Wave", at)
        assert f"eyes.state.Ball.distance is 1.0, {age} old, from ann" in found


def test_a_module_is_asked_itself(seeing: Here) -> None:
    assert asked(seeing, "whynot", "ann", "eyes.signal.Ball", "3s").splitlines()[1:] == [
        "`eyes.signal.Ball` did not happen:",
        "  the module Vision publishes it in any state: its code decides when",
    ]
    assert asked(seeing, "why", "ann", "eyes.state.Ball", "2500ms").splitlines()[1:] == [
        "`eyes.state.Ball` happened:",
        "  at 2 s the module Vision published it last, as its code decided",
    ]


def test_a_trace_whose_replay_differs_gives_no_answer(desk: Here, folder: Path) -> None:
    lines = [json.loads(line) for line in _TRACE[0].splitlines()]
    step = next(line for line in lines if line.get("agent") == "bob" and line["time"] == 8_000_000_000)
    step["taken"] = []
    (folder / "t.jsonl").write_text("".join(f"{json.dumps(line)}\n" for line in lines))
    for command in ("why", "whynot"):
        found = desk(command, "bob", "Pack", "--at", "20s", "t.jsonl")
        assert found.code == 1 and found.out == ""
        assert "its replay differs from what was recorded" in found.err
        assert "bob, step 3 at 8 s: transitions" in found.err, found.err


BAKERY = """\
system Bakery
message Order { int loaves }
message Offer { double price }
message Oven { bool warm }
topic oven { state Oven }
aip sale {
  participant customer {
    sends    request Order, accept_proposal Offer
    receives propose Offer
    process  = Choose . AwaitOffer . Decide . Agreed
  }
  participant baker {
    sends    propose Offer
    receives request Order, accept_proposal Offer
    process  = Reckon . AwaitYes . Bake
  }
  control customer {
    enter AwaitOffer : / send request Order { loaves = 3 } to baker
    enter Decide     : propose Offer from baker
    enter Agreed     : / send accept_proposal Offer { price = 1 } to baker
  }
  control baker {
    enter Reckon   : request Order from customer
    enter AwaitYes : / send propose Offer { price = 2 } to customer
    enter Bake     : accept_proposal Offer from customer
  }
}
srm shopper {
  plays sale.customer
  liveness { shopper = customer }
  activities {
    Choose takes 1s simulated  AwaitOffer takes 1ms simulated
    Decide takes 1s simulated  Agreed takes 10ms simulated
  }
}
srm cook {
  plays sale.baker
  liveness { cook = Rise . baker }
  activities {
    Rise takes 1s simulated  Reckon takes 500ms simulated
    AwaitYes takes 1ms simulated  Bake takes 20s simulated
  }
  control cook { enter baker : [has(oven.state.Oven)] }
}
srm stove {
  liveness { stove = Light . Warm~ }
  activities { Light takes 8s simulated  Warm every 1s takes 10ms writes oven.state.Oven simulated }
}
team Bakery { ann : shopper  bob : cook  gas : stove }
"""


def test_a_message_is_followed_back_through_the_team(here: Here, folder: Path) -> None:
    (folder / "bakery.aseme").write_text(BAKERY)
    here("run", "bakery.aseme", "--for", "5s", "--trace", "t.jsonl", "--quiet")
    found = asked(here, "whynot", "ann", "Agreed", "4s")
    assert [line.strip() for line in found.splitlines()[2:]] == [
        "1. to Decide from AwaitOffer by `propose Offer from baker` (bakery.aseme:19:5)",
        "`propose Offer` from baker has not come, or was taken before",
        "bob has never sent it; it does in Reckon -> AwaitYes (bakery.aseme:24:5), and is in Rise since 0 s",
        "to baker from Rise by `[has(oven.state.Oven)]` (bakery.aseme:43:18)",
        "`has(oven.state.Oven)` does not hold",
        "oven.state.Oven is absent: the message is not there",
        "gas has never published it; it does in Warm, and is in Light since 0 s",
        "to Warm from Light (bakery.aseme:46:30)",
        "Light has not ended: its activity runs since 0 s, and takes 8 s",
        "and behind that: Reckon, AwaitYes",
        "2. to Agreed from Decide by `/ send accept_proposal Offer { price = 1 } to baker`"
        " (bakery.aseme:20:5)",
        "Decide has not ended: its activity would run then",
    ]
    found = asked(here, "whynot", "bob", "Bake", "4s")
    assert "`request Order` from customer has not come in yet" in found
    assert "ann sent it at 1 s; it waits until bob enters baker" in found
    assert "so bob waits for what is asked for here" not in found
    found = asked(here, "whynot", "ann", "Agreed", "4s", "--depth", "1")
    assert "why not, says `asemec whynot gas oven.state.Oven --at 4s`" in found
