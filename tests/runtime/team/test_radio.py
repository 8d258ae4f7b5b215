"""Radio: messages that travel as bytes through the bodies, get lost there, and are refused when too many."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import Any

from aseme_dsl.runtime import BodyConnectionError, Context, RadioMessage
from aseme_dsl.worlds.field.match import Match
from aseme_dsl.worlds.field.radio import RadioSettings
from aseme_dsl.worlds.field.team import team_sheet
from tests.runtime.playing import MS, SECOND, Played, play
from tests.support.generated import Generated, generate
from tests.support.waiting import LONG

TEXT = """
system S
message M { int n  bool b }
message Big { double d }
topic team radio 10 { state M  signal M queued  data M  state Big }
srm R {
  liveness { R = Say || Hear }
  activities {
    Say writes team.state.M, team.signal.M, team.data.M, team.state.Big
    Hear takes 10s reads team.state.M, team.signal.M, team.data.M, team.state.Big
  }
}
team T { ann, bob, cat : R }
"""


def saying(
    generated: Generated, channel: str, count: int, pause: float = 0.0, host: str | None = None
) -> type:
    """An activity of which ann's publishes `count` messages."""

    class Say:
        def execute(self, context: Context) -> None:
            for n in range(count if context.agent == "ann" else 0):
                context.publish(channel, generated.message("M", n=n, b=True), host)
                context.wait(pause)

    return Say


def match(**settings: Any) -> Match:
    """Ann, bob and cat on the field."""
    radio = RadioSettings(**{"loss": 0.0, **settings})
    return Match(1, home=team_sheet(1, "Ours", ("ann", "bob", "cat"), goalie="dan"), radio=radio)


def told(run: Played, agent: str, channel: str) -> list[str]:
    return [line.partition(" ")[2] for line in run.received(agent, channel)]


def test_a_message_travels_through_the_air_and_is_heard_at_home_at_once() -> None:
    generated = generate(TEXT)
    run = play(generated, {"Say": saying(generated, "team.state.M", 1)}, world=match(), until=500 * MS)
    assert run.received("ann", "team.state.M") == ["0 from ann n=0 b=True"]
    (heard,) = run.of("radio_received", agent="bob")
    assert 10 * MS <= heard["time"] <= 80 * MS
    assert told(run, "bob", "team.state.M") == told(run, "cat", "team.state.M") == ["from ann n=0 b=True"]
    assert run.of("message")[0]["via"] == "radio"


def test_a_message_to_one_robot_is_heard_by_that_one() -> None:
    generated = generate(TEXT)
    say = saying(generated, "team.state.M", 1, host="cat")
    run = play(generated, {"Say": say}, world=match(), until=500 * MS)
    assert told(run, "cat", "team.state.M") == ["from ann n=0 b=True"]
    assert not run.of("radio_received", agent="bob") and not told(run, "ann", "team.state.M")


def test_what_the_air_loses_is_lost_and_the_same_for_one_seed() -> None:
    generated = generate(TEXT)
    say = saying(generated, "team.data.M", 40, pause=0.1)
    runs = [play(generated, {"Say": say}, world=match(loss=0.5), until=5 * SECOND) for _ in range(2)]
    heard = told(runs[0], "bob", "team.data.M")
    assert 5 < len(heard) < 35
    assert runs[0].records == runs[1].records


def test_of_a_state_that_the_radio_refuses_the_newest_is_said_later() -> None:
    generated = generate(TEXT)
    say = saying(generated, "team.state.M", 9)
    run = play(generated, {"Say": say}, world=match(burst=2), until=SECOND)
    assert told(run, "ann", "team.state.M") == [f"from ann n={n} b=True" for n in range(9)]
    assert [r["message"]["n"] for r in run.of("radio_received", agent="bob")][-1] == 8
    assert len(run.of("radio_received", agent="bob")) == 3
    assert [r["message"]["n"] for r in run.of("replaced")] == [2, 3, 4, 5, 6, 7]
    assert [r["message"]["n"] for r in run.of("delayed")] == [2, 3, 4, 5, 6, 7, 8]


def test_queued_signals_that_the_radio_refuses_are_all_said_later() -> None:
    generated = generate(TEXT)
    say = saying(generated, "team.signal.M", 6)
    run = play(generated, {"Say": say}, world=match(burst=2), until=2 * SECOND)
    assert sorted(r["message"]["n"] for r in run.of("radio_received", agent="bob")) == list(range(6))
    assert not run.of("replaced")


def test_without_bodies_the_bus_carries_it() -> None:
    generated = generate(TEXT)
    run = play(generated, {"Say": saying(generated, "team.state.M", 1)}, until=500 * MS)
    assert run.received("bob", "team.state.M") == ["0 from ann n=0 b=True"]


@dataclass
class Tin:
    """A body at hand: what it is to hear, what it has said, and when it is lost."""

    name: str
    heard: list[RadioMessage] = field(default_factory=list)
    said: list[bytes] = field(default_factory=list)
    payload_limit: int = 10
    lost: bool = False

    def sense(self) -> None: ...

    def act(self, command: Any) -> None: ...

    def say(self, payload: bytes) -> bool:
        if self.lost:
            raise BodyConnectionError("the wire is cut")
        if len(payload) > self.payload_limit:
            raise ValueError("too long")
        self.said.append(payload)
        return True

    def hear(self) -> list[RadioMessage]:
        if self.lost:
            raise BodyConnectionError("the wire is cut")
        heard, self.heard = self.heard, []
        return heard


def test_what_cannot_be_read_is_told_and_nothing_breaks() -> None:
    generated = generate(TEXT)
    noise = [b"", b"\xff", b"\x02", b"\x00\x00", bytes(10), bytes(range(11))]
    tin = Tin("ann", [RadioMessage("", payload) for payload in noise])
    run = play(generated, {}, bodies={"ann": tin}, until=100 * MS)
    reasons = [fault["reason"] for fault in run.of("fault") if "radio message" in fault["reason"]]
    assert 4 <= len(reasons) <= len(noise)
    assert run.result.reason == "time" and not run.result.failed


def test_a_message_that_is_too_long_for_the_body_is_told() -> None:
    generated = generate(TEXT)
    tin = Tin("ann", payload_limit=3)
    run = play(generated, {"Say": saying(generated, "team.state.M", 1)}, bodies={"ann": tin}, until=100 * MS)
    assert run.of("radio_failed")[0]["reason"] == "too long"


def test_a_body_that_is_lost_silences_the_radio_and_not_the_agent() -> None:
    generated = generate(TEXT)
    tin = Tin("ann", lost=True)
    run = play(
        generated, {"Say": saying(generated, "team.state.M", 2, 0.05)}, bodies={"ann": tin}, until=SECOND
    )
    assert [r["reason"] for r in run.of("radio_failed")] == ["the body is lost"] * 2
    assert any("BodyConnectionError: the wire is cut" in fault["reason"] for fault in run.of("fault"))
    assert not run.result.failed


def test_a_slow_radio_says_each_message_once() -> None:
    """Two threads at once: the activity that publishes and the one that says again what was refused."""
    generated = generate(TEXT)
    said: list[bytes] = []

    class Slow:
        name, payload_limit = "ann", 10

        def say(self, payload: bytes) -> bool:
            time.sleep(0.004)
            said.append(payload)
            return True

        def hear(self) -> list[RadioMessage]:
            return []

    say = saying(generated, "team.signal.M", 100, pause=0.001)
    run = play(
        generated,
        {"Say": say},
        clock="real",
        bodies={"ann": Slow()},
        until=round(LONG) * SECOND,
        stop=lambda team: "enough" if len(said) > 75 else None,
    )
    assert run.result.reason == "enough"
    assert run.of("activity", what="crash") == [] and not run.result.failed
    assert len(said) == len(set(said)) > 50
