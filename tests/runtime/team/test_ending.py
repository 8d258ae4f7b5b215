"""The end of a run: agents that wait and for what, open conversations, unread messages, faults (U2)."""

from __future__ import annotations

import asyncio
from typing import Any

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.team.team import Setup, Team
from tests.runtime.playing import MS, SECOND, Played, play
from tests.support.generated import generate
from tests.support.waiting import long_enough

TRADE = """
system Trade
message Offer {{ int price }}
message Go {{ }}
topic t {{ signal Go }}
aip trade {{
  participant buyer {{
    sends request Offer
    receives agree Offer
    process = Ask . Got
  }}
  participant seller {{
    sends agree Offer
    receives request Offer
    process = Answer . Tell
  }}
  control buyer {{
    enter Ask : / send request Offer to seller
    enter Got : agree Offer from seller
  }}
  control seller {{
    enter Answer : request Offer from buyer
    enter Tell : {tell} / send agree Offer to buyer
  }}
}}
srm b {{ plays trade.buyer  liveness {{ b = buyer }}  activities {{ Ask takes 1s  Got takes 1s }} }}
srm s {{ plays trade.seller  liveness {{ s = {s} }}  activities {{ Answer takes 1s  Tell takes 1s }} }}
team Market {{ bob : b  sue : s }}
"""


def trade(tell: str = "", s: str = "seller~", **options: Any) -> Played:
    return play(TRADE.format(tell=tell, s=s), **options)


def waits(run: Played) -> list[str]:
    """`bob after Ask for agree Offer from seller`: each active state and what is awaited there."""
    return [
        f"{agent.name} {item.where} {item.name} for {' | '.join(found.what for found in item.awaits)}"
        for agent in run.result.agents
        for item in agent.waits
    ]


# ---- conversations -------------------------------------------------------------------------------


@pytest.mark.parametrize("until", [None, 60 * SECOND])
def test_agents_that_wait_for_each_other_for_ever_are_stuck(until: int | None) -> None:
    run = trade("[has(t.signal.Go)]", until=until)
    assert run.result.stuck == ("bob", "sue")
    assert run.result.idle_since == SECOND
    assert not run.result.failed
    assert waits(run) == [
        "bob after Ask for agree Offer from seller",
        "sue after Answer for [has(t.signal.Go)]",
    ]
    assert [found.at for agent in run.result.agents for found in agent.waits[0].awaits] == [
        "test.aseme:19:5",
        "test.aseme:23:5",
    ]


def test_an_open_conversation_says_who_is_in_it_and_what_each_waits_for() -> None:
    run = trade("[has(t.signal.Go)]")
    (conversation,) = run.result.conversations
    assert (conversation.name, conversation.protocol) == ("trade-bob-1", "trade")
    assert [(m.agent, m.participant, m.here) for m in conversation.members] == [
        ("bob", "buyer", True),
        ("sue", "seller", True),
    ]
    assert [item.awaits[0].what for m in conversation.members for item in m.waits] == [
        "agree Offer from seller",
        "[has(t.signal.Go)]",
    ]


def test_a_server_that_waits_for_its_next_customer_is_fine() -> None:
    run = trade()
    assert run.result.stuck == ()
    assert run.result.conversations == ()
    (waiting,) = run.result.agents[1].waits
    assert waiting.free
    assert run.result.agents[0].waits == ()  # it has finished


def test_a_server_is_stuck_when_another_part_of_it_is() -> None:
    text = TRADE.format(tell="", s="seller~ || (Rest . Work)").replace(
        "Tell takes 1s } }",
        "Tell takes 1s  Rest takes 1s  Work takes 1s }  control s { enter Work : [has(t.signal.Go)] } }",
    )
    run = play(text)
    assert run.result.stuck == ("sue",)
    assert [item.free for item in run.result.agents[1].waits] == [True, False]


def test_one_that_has_not_opened_its_conversation_is_stuck() -> None:
    text = TRADE.format(tell="", s="seller").replace("enter Ask : /", "enter Ask : [has(t.signal.Go)] /")
    run = play(text)
    assert run.result.stuck == ("bob",)  # sue waits for her first customer, which is fine
    assert waits(run)[0] == "bob before buyer for [has(t.signal.Go)]"


def test_a_message_that_nobody_takes_is_unread() -> None:
    text = TRADE.format(tell="", s="Rest . seller").replace(
        "Tell takes 1s } }",
        "Tell takes 1s  Rest takes 1s }  control s { enter seller : [has(t.signal.Go)] } }",
    )
    run = play(text)
    (unread,) = run.result.unread
    assert (unread.agent, unread.participant, unread.performative, unread.message, unread.sender) == (
        "sue",
        "seller",
        "request",
        "Offer",
        "bob",
    )
    (conversation,) = run.result.conversations
    assert [(m.agent, bool(m.waits)) for m in conversation.members] == [("bob", True), ("sue", False)]
    assert run.result.stuck == ("bob", "sue")


# ---- what is pending -----------------------------------------------------------------------------


def plain(formula: str, control: str = "", **options: Any) -> Played:
    """One agent of a formula over A, B and C."""
    takes = "".join(f"{name} takes 1s  " for name in "ABC" if name in formula)
    text = f"""
system Plain
message Go {{ int n }}
topic t {{ signal Go  state Go }}
srm r {{
  liveness {{ r = {formula} }}
  activities {{ {takes} }}
  control r {{
    {control}
  }}
}}
"""
    activities = options.pop("activities", None)
    return play(text, activities, **options)


@pytest.mark.parametrize(
    ("formula", "control", "waiting"),
    [
        ("A . B", "enter B : [has(t.signal.Go)]", ["me after A for [has(t.signal.Go)]"]),
        (
            "A . B",
            "enter B : [t.state.Go.n / 2 > 1] / write_messages.t.signal.Go",
            ["me after A for [t.state.Go.n / 2 > 1]"],
        ),
        (
            "A . (B | C)",
            "enter B : [t.state.Go.n > 1]\n    enter C : [t.state.Go.n < 1]",
            ["me before (B | C) for [t.state.Go.n > 1] | [t.state.Go.n < 1]"],
        ),
        (
            "(A . B) [> C",
            "enter B : [t.state.Go.n > 1]\n"
            "    enter C : when [t.state.Go.n < 1] / write_messages.t.signal.Go",
            ["me after A for [t.state.Go.n > 1] | [> when [t.state.Go.n < 1]"],
        ),
        (  # what is complete: a loop, an AND, an AND in a loop
            "(A . B)~",
            "repeat (A . B) : [has(t.signal.Go)]",
            ["me after (A . B) for [has(t.signal.Go)]"],
        ),
        (
            "(A || B) . C",
            "enter C : [has(t.signal.Go)]",
            ["me after (A || B) for [has(t.signal.Go)]"],
        ),
        (
            "((A . B) || C)~",
            "repeat ((A . B) || C) : [has(t.signal.Go)]",
            ["me after ((A . B) || C) for [has(t.signal.Go)]"],
        ),
    ],
)
def test_an_agent_that_waits_for_what_nobody_says_is_stuck(
    formula: str, control: str, waiting: list[str]
) -> None:
    run = plain(formula, control)
    assert run.result.stuck == ("me",)
    assert waits(run) == waiting


@pytest.mark.parametrize("control", ["enter B : after(1min)", "enter B : [age(t.state.Go) > 1min]"])
def test_who_waits_for_a_time_is_not_stuck(control: str) -> None:
    script = [{"at": "1ms", "channel": "t.state.Go", "message": {"n": 1}}] if "age" in control else ()
    run = plain("A . B", control, until=10 * SECOND, script=script)
    assert (run.result.reason, run.result.stuck, run.result.idle_since) == ("time", (), None)
    assert len(run.result.agents[0].waits) == 1


def test_an_input_that_is_still_to_come_is_pending() -> None:
    script = [{"at": "20s", "channel": "t.signal.Go", "message": {}}]
    control = "enter B : [has(t.signal.Go)]"
    assert plain("A . B", control, until=10 * SECOND, script=script).result.stuck == ()
    assert plain("A . B", control, script=script).result.reason == "finished"


def test_an_activity_that_runs_is_pending_and_named() -> None:
    run = plain("A . B", until=500 * MS)
    assert (run.result.stuck, waits(run)) == ((), ["me in A for A"])
    assert run.result.agents[0].waits[0].awaits[0].kind == "activity"


def test_one_whose_code_waits_for_ever_is_stuck() -> None:
    class A:
        async def execute(self, context: Context) -> None:
            await asyncio.get_running_loop().create_future()

    run = plain("A . B", activities={"A": A})
    assert (run.result.stuck, waits(run)) == (("me",), ["me in A for A"])


@pytest.mark.parametrize("end", ["stop", "interrupted"])
def test_what_ends_a_run_from_outside_leaves_nobody_stuck(end: str) -> None:
    text = TRADE.format(tell="[has(t.signal.Go)]", s="seller").replace("Answer takes 1s", "Answer takes 2s")

    def stop(team: Any) -> str | None:
        if team.driver.clock.now() < 1500 * MS:
            return None
        if end == "stop":
            return "enough"
        team.driver.stop("interrupted")
        return None

    script = [{"at": at, "channel": "t.signal.Go", "message": {}} for at in ("1500ms", "1600ms")]
    run = play(text, stop=stop, script=script)
    assert run.result.stuck == ()
    assert run.result.idle_since is None
    assert [item.name for item in run.result.conversations] == ["trade-bob-1"]


def test_in_real_time_nobody_is_stuck_but_all_that_is_open_is_listed() -> None:
    text = TRADE.format(tell="[has(t.signal.Go)]", s="seller").replace("takes 1s", "takes 1ms")
    wanted = ["bob after Ask for agree Offer from seller", "sue after Answer for [has(t.signal.Go)]"]
    run = long_enough(
        lambda seconds: play(text, clock="real", until=seconds * SECOND),
        lambda run: waits(run) == wanted,
        (1, 9, 90),
    )
    assert (run.result.stuck, run.result.idle_since) == ((), None)
    assert waits(run) == wanted
    assert [item.name for item in run.result.conversations] == ["trade-bob-1"]


# ---- since when a region waits -------------------------------------------------------------------


DOG = """
system Dog
message Ball {{ int x }}
topic t {{ state Ball  signal Ball }}
srm r {{
  liveness {{
    r = search || rest
    search = {search}
    rest = Lie~
  }}
  activities {{ Look takes 1s  Chase takes 1s  Lie takes 7s }}
  control search {{
    {control}
  }}
}}
"""


def dog(search: str, control: str, **options: Any) -> Played:
    return play(DOG.format(search=search, control=control), until=60 * SECOND, **options)


@pytest.mark.parametrize(
    ("search", "control", "since"),
    [
        ("Look . Chase", "enter Chase : [t.state.Ball.x > 3]", 1),  # its activity has returned
        ("Look . Chase", "enter Look : [t.state.Ball.x > 3]", 0),  # nothing was taken yet
        ("(Look . Chase)~", "enter Chase : [has(t.signal.Ball)]", 4),  # in its second round
    ],
)
def test_a_region_waits_since_it_came_to_rest(search: str, control: str, since: int) -> None:
    script = [{"at": "2s", "channel": "t.signal.Ball", "message": {"x": 1}}] if "signal" in control else ()
    run = dog(search, control, script=script)
    waiting, lying = run.result.agents[0].waits
    assert (waiting.since, waiting.timed) == (since * SECOND, False)
    assert lying.since == 56 * SECOND  # the run of its activity that goes on
    assert run.of("finish")[0]["agents"][0]["waits"][0]["since"] == since * SECOND


@pytest.mark.parametrize("control", ["enter Chase : after(2min)", "repeat (Look . Chase) every 2min :"])
def test_a_region_that_waits_for_a_time_is_marked(control: str) -> None:
    run = dog("(Look . Chase)~", control)
    assert [item.timed for item in run.result.agents[0].waits] == [True, False]


def test_a_guard_beside_the_time_is_not_a_wait_for_a_time() -> None:
    (waiting, _) = dog("Look . Chase", "enter Chase : after(10s) [t.state.Ball.x > 3]").result.agents[0].waits
    assert not waiting.timed


# ---- faults, and the trace -----------------------------------------------------------------------


def test_faults_are_counted_by_reason_and_place_also_where_nobody_reads_the_trace() -> None:
    generated = generate(TRADE.format(tell="", s="seller"))
    members = [("bob", generated.charts["b"]), ("sue", generated.charts["s"])]
    team = Team(members, {}, Setup(path=[generated.folder]))
    team.trace.fault(5, "me", "no battery", "x.aseme:1:1")
    team.trace.fault(7, "you", "no battery", "x.aseme:1:1")
    team.trace.fault(8, "me", "no light", activity="See")
    assert [(f.reason, f.agent, f.at, f.activity, f.time, f.count) for f in team.run().faults] == [
        ("no battery", "me", "x.aseme:1:1", "", 5, 2),
        ("no light", "me", "", "See", 8, 1),
    ]


def test_an_action_that_cannot_be_done_is_counted_at_its_place() -> None:
    run = plain("A . B", "enter B : / t.signal.Go.n = t.state.Go.n; write_messages.t.signal.Go")
    (fault,) = run.result.faults
    assert (fault.agent, fault.at, fault.count) == ("me", "test.aseme:9:5", 1)
    assert len(run.of("fault", at=fault.at)) == 1


def test_the_last_record_of_the_trace_has_the_same_facts() -> None:
    run = trade("[has(t.signal.Go)]")
    (finish,) = run.of("finish")
    assert finish["idle_since"] == SECOND
    assert [agent["stuck"] for agent in finish["agents"]] == [True, True]
    assert finish["agents"][0]["waits"][0]["awaits"] == [
        {"kind": "message", "what": "agree Offer from seller", "at": "test.aseme:19:5"}
    ]
    assert [item["name"] for item in finish["conversations"]] == ["trade-bob-1"]


def test_a_clean_end_has_none_of_them() -> None:
    finish = trade(s="seller").of("finish")[0]
    assert finish.keys() == {"kind", "time", "reason", "agents"}
    assert all(agent.keys() == {"name", "finished", "failure", "configuration"} for agent in finish["agents"])
