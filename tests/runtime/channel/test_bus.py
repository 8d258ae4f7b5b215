"""The bus: who receives what is published, and the rules of channels."""

from __future__ import annotations

import json
import threading
from pathlib import Path
from typing import Any

from aseme_dsl.runtime import Context
from tests.runtime.held import play_held
from tests.runtime.playing import MS, SECOND, play
from tests.support.generated import Generated, generate
from tests.support.waiting import LONG


def publishing(
    generated: Generated, channel: str, *moments: tuple[float, dict[str, Any]], host: Any = None
) -> type:
    """An activity that publishes at these moments, given in milliseconds."""
    message = channel.split(".")[2]

    class Publishing:
        def execute(self, context: Context) -> None:
            for moment, members in moments:
                context.wait(max(0, moment / 1000 - context.now_ns / SECOND))
                context.publish(channel, generated.message(message, **members), host)

    return Publishing


SPEAKER = """
system S
message M {{ int n }}
topic t {{ {rules} }}
srm Speaker {{ liveness {{ Speaker = Say }} activities {{ Say writes {channel} }} }}
srm Listener {{ liveness {{ Listener = Hear }} activities {{ Hear takes 1s reads {channel} }} }}
team T {{ ann : Speaker  bob, cat : Listener }}
"""


def speaker(rules: str, channel: str) -> Generated:
    return generate(SPEAKER.format(rules=rules, channel=channel))


def test_what_one_agent_publishes_others_receive_in_the_next_step_of_the_instant() -> None:
    generated = speaker("state M", "t.state.M")
    run = play(generated, {"Say": publishing(generated, "t.state.M", (100, {"n": 1}))})
    assert run.received("bob", "t.state.M") == ["100 from ann n=1"]
    assert run.received("cat", "t.state.M") == ["100 from ann n=1"]


def test_a_message_to_a_host_goes_to_that_host_alone() -> None:
    generated = speaker("signal M", "t.signal.M")
    say = publishing(generated, "t.signal.M", (100, {"n": 1}), host="cat")
    run = play(generated, {"Say": say})
    assert run.received("bob", "t.signal.M") == []
    assert run.received("cat", "t.signal.M") == ["100 from ann n=1"]


def test_a_message_to_a_host_that_is_not_there_is_refused() -> None:
    generated = speaker("signal M", "t.signal.M")
    run = play(generated, {"Say": publishing(generated, "t.signal.M", (100, {"n": 1}), host="dan")})
    assert run.of("refused")[0]["reason"] == "there is no agent dan"


ROBOTS = """
system S
message M {{ int n }}
topic vision {{ state M }}
srm Robot {{
  liveness {{ Robot = See || Look }}
  activities {{ See writes vision.state.M  Look takes 1s reads vision.state.M }}
  {control}
}}
team T {{ ann, bob : Robot }}
"""


class See:
    """Publishes the length of the agent's name, which is its number here."""

    generated: Generated

    def execute(self, context: Context) -> None:
        n = 1 if context.agent == "ann" else 2
        context.publish("vision.state.M", self.generated.message("M", n=n))


def test_what_each_robot_has_of_its_own_stays_at_home() -> None:
    """Two robots of one role both see a ball; neither takes the other's for its own."""
    generated = generate(ROBOTS.format(control=""))
    see = type("See", (See,), {"generated": generated})
    run = play(generated, {"See": see})
    assert run.received("ann", "vision.state.M") == ["0 from ann n=1"]
    assert run.received("bob", "vision.state.M") == ["0 from bob n=2"]


def test_what_is_read_under_a_hosts_name_comes_from_that_host() -> None:
    control = "control Robot { finish (See || Look) : when [bob.vision.state.M.n == 2] }"
    generated = generate(ROBOTS.format(control=control))
    see = type("See", (See,), {"generated": generated})
    run = play(generated, {"See": see})
    assert run.received("ann", "vision.state.M") == ["0 from ann n=1", "0 from bob n=2"]
    assert run.received("bob", "vision.state.M") == ["0 from bob n=2"]
    assert (run.result.reason, run.result.end_ns) == ("finished", 0)


def test_an_activity_may_read_under_a_hosts_name_too() -> None:
    text = ROBOTS.format(control="").replace("reads vision", "reads bob.vision")
    generated = generate(text)
    see = type("See", (See,), {"generated": generated})

    class Look:
        def execute(self, context: Context) -> None:
            context.wait(0.1)
            context.log(str(context.latest_message("vision.state.M", sender="bob").n))

    run = play(generated, {"See": see, "Look": Look})
    assert run.received("ann", "vision.state.M") == ["0 from ann n=1", "0 from bob n=2"]
    assert [record["text"] for record in run.of("log")] == ["2", "2"]
    assert not run.of("fault")


def test_from_names_who_may_publish_and_makes_the_channel_the_teams() -> None:
    text = ROBOTS.format(control="").replace("state M", "state M from bob")
    generated = generate(text)
    see = type("See", (See,), {"generated": generated})
    run = play(generated, {"See": see})
    (refused,) = run.of("refused")
    assert refused["agent"] == "ann"
    assert refused["reason"] == "only bob may publish on vision.state.M, not ann (Robot, See)"
    assert run.received("ann", "vision.state.M") == ["0 from bob n=2"]


def test_from_may_name_a_role_or_an_activity() -> None:
    for source in ("Robot", "See"):
        generated = generate(ROBOTS.format(control="").replace("state M", f"state M from {source}"))
        see = type("See", (See,), {"generated": generated})
        run = play(generated, {"See": see})
        assert not run.of("refused")
        received = run.received("ann", "vision.state.M")
        both = ["0 from ann n=1", "0 from bob n=2"]
        assert received == (both if source == "Robot" else both[:1])


def test_every_holds_a_state_back_and_the_newest_wins() -> None:
    generated = speaker("state M every 100ms", "t.state.M")
    moments = [(0, {"n": 0}), (10, {"n": 1}), (20, {"n": 2}), (250, {"n": 3})]
    run = play(generated, {"Say": publishing(generated, "t.state.M", *moments)})
    assert run.received("bob", "t.state.M") == ["0 from ann n=0", "100 from ann n=2", "250 from ann n=3"]
    assert [(r["kind"], r["message"]["n"]) for r in run.records if r["kind"] in ("delayed", "replaced")] == [
        ("delayed", 1),
        ("replaced", 1),
        ("delayed", 2),
    ]


def test_every_drops_data_that_comes_too_soon() -> None:
    generated = speaker("data M every 100ms", "t.data.M")
    moments = [(0, {"n": 0}), (10, {"n": 1}), (100, {"n": 2})]
    run = play(generated, {"Say": publishing(generated, "t.data.M", *moments)})
    assert run.received("bob", "t.data.M") == ["0 from ann n=0", "100 from ann n=2"]
    assert [r["message"]["n"] for r in run.of("dropped")] == [1]


def test_every_lets_queued_signals_out_one_at_a_time() -> None:
    generated = speaker("signal M every 100ms queued", "t.signal.M")
    moments = [(0, {"n": 0}), (10, {"n": 1}), (20, {"n": 2})]
    run = play(generated, {"Say": publishing(generated, "t.signal.M", *moments)})
    assert run.received("bob", "t.signal.M") == ["0 from ann n=0", "100 from ann n=1", "200 from ann n=2"]


PERSIST = """
system S
message M {{ int n  string s  bytes b  double d }}
topic t {{ state M persist }}
srm R {{ liveness {{ R = {formula} }} activities {{ Say writes t.state.M  Hear reads t.state.M }} }}
"""


def test_a_state_that_persists_is_there_after_a_restart(tmp_path: Path) -> None:
    """ "`persist` keeps a state over a restart" """
    generated = generate(PERSIST.format(formula="Say . Hear"))
    members = {"n": 5, "s": "ü\n", "b": b"\x00\xff", "d": float("inf")}
    say = publishing(generated, "t.state.M", (0, members))
    play(generated, {"Say": say}, state_directory=tmp_path / "state")
    kept = json.loads((tmp_path / "state" / "me.json").read_text("utf-8"))
    assert kept["states"][0]["message"] == {"n": 5, "s": "ü\n", "b": "AP8=", "d": "Infinity"}

    seen: list[Any] = []

    class Hear:
        def execute(self, context: Context) -> None:
            seen.append(context.latest_message("t.state.M"))

    again = generate(PERSIST.format(formula="Hear . Say"))
    play(again, {"Hear": Hear, "Say": type("Say", (), {})}, state_directory=tmp_path / "state")
    assert seen == [again.message("M", **members)]


def test_a_kept_state_that_cannot_be_read_is_told(tmp_path: Path) -> None:
    generated = generate(PERSIST.format(formula="Say . Hear"))
    for text in ("{", "[]", '{"states": [{"channel": "t.state.M", "host": null, "message": {"n": "x"}}]}'):
        (tmp_path / "me.json").write_text(text)
        run = play(generated, {}, state_directory=tmp_path)
        assert any("kept state" in fault["reason"] for fault in run.of("fault"))


def test_a_state_directory_that_cannot_be_written_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    generated = generate(PERSIST.format(formula="Say . Hear"))
    say = publishing(generated, "t.state.M", (0, {"n": 5}))
    run = play(generated, {"Say": say}, state_directory=tmp_path / "file" / "state")
    assert any("not kept" in fault["reason"] for fault in run.of("fault"))
    assert run.result.reason == "finished"


def test_regions_share_by_publishing() -> None:
    """ "Within the sender, a region sees its own write at once; others see it in their next step." """
    text = """
    system S
    message M { int n }
    topic t { state M }
    srm R {
      liveness { R = (A . B) || (C . D) }
      activities { A takes 10ms  B takes 10ms  C takes 5ms  D takes 10ms }
      control R {
        enter B : / t.state.M.n = 3 ; write_messages.t.state.M
        enter D : [t.state.M.n == 3]
      }
    }
    """
    run = play(text)
    assert run.order("start") == ["start A", "start C", "start B", "start D"]
    (message,) = run.of("message")
    assert message["region"] == "0.2.1"
    assert run.received("me", "t.state.M") == ["10 from me n=3"]


def test_the_variables_of_a_participant_need_not_be_declared_by_who_plays_it() -> None:
    generated = generate("""
    system S
    aip p {
      participant a { var x : int = 0  process = A . B }
      participant b { process = C }
      control a { enter B : [x == 2] }
    }
    srm R { plays p.a  liveness { R = a }  activities { B takes 1s } }
    """)

    class A:
        def execute(self, context: Context) -> None:
            context.set_variable("x", 2)

    run = play(generated, {"A": A})
    assert run.order("start") == ["start A", "start B"]
    assert run.of("fault") == []


def test_what_means_nothing_is_an_error_of_the_activity() -> None:
    generated = generate("""
    system S
    message M { int n }
    message N { int n }
    topic t { state M }
    srm R { var x : int = 0  liveness { R = A } activities { A reads t.state.M writes t.state.M, x } }
    """)

    def attempt(what: str) -> str:
        class A:
            def execute(self, context: Context) -> None:
                match what:
                    case "message":
                        context.publish("t.state.M", generated.message("N"))
                    case "channel":
                        context.publish("t.M", generated.message("M"))
                    case "variable":
                        context.set_variable("y", 1)
                    case "value":
                        context.set_variable("x", True)
                    case "body":
                        context.body.sense()
                    case "kind":
                        context.read("t.state.M", str)

        script = [{"at": 0, "channel": "t.state.M"}]
        return play(generated, {"A": A}, script=script).result.agents[0].failure or ""

    assert "t.state.M carries M, not N" in attempt("message")
    assert "'t.M' is not a channel" in attempt("channel")
    assert "no variable y here; R has x" in attempt("variable")
    assert "variable x is a int, not True" in attempt("value")
    assert "agent me has no body here" in attempt("body")
    assert "t.state.M carries M, not str" in attempt("kind")


def test_signals_are_taken_once_by_an_activity() -> None:
    generated = speaker("signal M queued", "t.signal.M")
    taken: list[Any] = []

    class Hear:
        def execute(self, context: Context) -> None:
            for _ in range(4):
                context.wait(0.05)
                while (signal := context.consume("t.signal.M")) is not None:
                    taken.append((context.agent, context.now_ns // MS, signal.n))

    moments = [(60, {"n": 1}), (70, {"n": 2})]
    run = play(generated, {"Say": publishing(generated, "t.signal.M", *moments), "Hear": Hear})
    assert taken == [("bob", 100, 1), ("bob", 100, 2), ("cat", 100, 1), ("cat", 100, 2)]
    assert len(run.of("consumed")) == 4


def test_messages_reach_others_in_real_time() -> None:
    generated = speaker("state M", "t.state.M")
    say = publishing(generated, "t.state.M", (1, {"n": 1}), (2, {"n": 2}))

    class Hear:
        async def execute(self, context: Context) -> None:
            while getattr(context.latest_message("t.state.M"), "n", 0) < 2:
                await context.sleep(0.001)

    run = play(generated, {"Say": say, "Hear": Hear}, clock="real", until=60 * SECOND)
    assert run.result.reason == "finished"
    assert [line.partition(" ")[2] for line in run.received("bob", "t.state.M")] == [
        "from ann n=1",
        "from ann n=2",
    ]


def test_read_messages_shows_what_has_arrived_since_the_step_began(tmp_path: Path) -> None:
    """ "`read_messages` renews the executing region's snapshot for the later rounds of the step" """
    _, result, records = play_held(tmp_path)
    assert result.reason == "finished"
    assert [r["activity"] for r in records if r.get("what") == "start"] == ["A", "B"]
    (step,) = [r for r in records if r.get("ahead")]
    assert step["ahead"] == [["input", 1]]
    assert sum(["input", 1] in r.get("inputs", []) for r in records) == 1


def test_nothing_is_lost_between_threads_in_real_time() -> None:
    """Many threads publish to many agents; every signal is an input of exactly one step of each reader."""
    count = 150
    generated = generate("""
    system S
    message M { int n }
    topic t { signal M queued from R }
    srm R {
      liveness { R = Say || Say2 || Hear }
      activities { Say writes t.signal.M  Say2 writes t.signal.M  Hear reads t.signal.M }
    }
    team T { a, b, c : R }
    """)

    entered = threading.Barrier(9)  # a region that is not entered yet does not hear

    class Say:
        def execute(self, context: Context) -> None:
            entered.wait(LONG)
            for n in range(count):
                context.publish("t.signal.M", generated.message("M", n=n))

    class Hear:
        def execute(self, context: Context) -> None:
            entered.wait(LONG)
            heard = 0
            while heard < 6 * count:
                if context.consume("t.signal.M") is None:
                    context.wait(0.001)
                else:
                    heard += 1

    run = play(generated, {"Say": Say, "Say2": Say, "Hear": Hear}, clock="real", until=round(LONG) * SECOND)
    assert run.result.reason == "finished"
    for agent in ("a", "b", "c"):
        assert len(run.received(agent, "t.signal.M")) == 6 * count
        for sender in ("a", "b", "c"):  # in the order in which they were published
            numbers = [
                identity[1]
                for step in run.of("step", agent=agent)
                for identity in step["inputs"]
                if identity[0] == sender != agent
            ]
            assert numbers == sorted(numbers)
