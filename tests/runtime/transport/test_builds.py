"""Robots of two builds in one team: what both mean in the same way goes on, the rest is refused."""

from __future__ import annotations

import itertools
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.team.swap import Swap
from aseme_dsl.runtime.team.team import Team
from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
from aseme_dsl.runtime.transport.settings import Network
from tests.faults.changing import version
from tests.runtime.transport.net import Air, Part, part
from tests.support.generated import Generated, generate
from tests.support.network import own_name
from tests.support.waiting import LONG, wait_until

OLD = """
system Talk
enum Colour { RED  GREEN }
message Place { double x }
message M { int n  optional Colour colour  optional Place place }
message N { int n }
topic team { signal M queued  signal N  state M  data M }
srm Speaker {
  liveness { Speaker = Say }
  activities { Say takes 500ms writes team.signal.M, team.signal.N, team.state.M, team.data.M }
}
srm Listener {
  liveness { Listener = Hear }
  activities { Hear reads team.signal.M, team.signal.N, team.state.M, team.data.M }
}
team T { ann : Speaker  bob : Listener }
"""


class Mouth:
    """What ann says, and what bob has."""

    def __init__(self) -> None:
        self.say: list[tuple[str, object]] = []
        self.over = threading.Event()
        mouth = self

        class Say:
            def execute(self, context: Context) -> None:
                while not mouth.over.is_set():
                    while mouth.say:
                        context.publish(*mouth.say.pop(0))
                    context.wait(0.002)

        class Hear:
            def execute(self, context: Context) -> None:
                while not mouth.over.is_set():
                    context.wait(0.01)

        self.activities: dict[str, type[Any]] = {"Say": Say, "Hear": Hear}


@pytest.fixture
def mouth() -> Iterator[Mouth]:
    found = Mouth()
    yield found
    found.over.set()


@pytest.fixture(params=["air", "zenoh"])
def links(request: pytest.FixtureRequest) -> Any:
    if request.param == "air":
        return Air().link
    pytest.importorskip("zenoh")
    name = own_name("Talk")
    return lambda: ZenohLink(name, Network(lease_ms=round(1000 * LONG)))


def changed(old: str, new: str) -> Generated:
    assert old in OLD
    return generate(OLD.replace(old, new))


def met(ann: Generated, bob: Generated, mouth: Mouth, links: Any) -> tuple[Part, Part]:
    """The two robots, as soon as they can reach each other."""
    one = part(ann, ["ann"], mouth.activities, links()).start()
    other = part(bob, ["bob"], mouth.activities, links()).start()
    wait_until(lambda: one.team.transport.is_there("bob") and other.team.transport.is_there("ann"))
    return one, other


def said(generated: Generated, n: int, **members: object) -> object:
    return generated.message("M", n=n, **members)


def heard(bob: Part, channel: str = "team.signal.M") -> list[dict[str, Any]]:
    return [r["message"] for r in bob.of("arrived", channel=channel)]


def faults(part_: Part) -> list[str]:
    return [r["reason"] for r in part_.of("fault")]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("takes 500ms", "takes 501ms"),
        ("Listener = Hear", "Listener = Hear . Hear"),
        ("ann : Speaker  bob : Listener", "ann : Speaker  bob : Listener  cat : Listener"),
        ("message N { int n }", "message N { int n  optional int more }"),
        ("srm Speaker {", "srm Third { liveness { Third = X } }\nsrm Speaker {"),
        ("GREEN }", "GREEN  BLUE }"),
    ],
)
def test_what_others_do_not_notice_changes_nothing(old: str, new: str, mouth: Mouth, links: Any) -> None:
    """(O3: `takes 500ms`, 501 in another build, made a robot deaf and mute.)"""
    ann, bob = met(generate(OLD), changed(old, new), mouth, links)
    mouth.say += [("team.signal.M", said(ann.generated, n)) for n in range(3)]
    mouth.say += [("team.state.M", said(ann.generated, 3)), ("team.data.M", said(ann.generated, 4))]
    wait_until(lambda: heard(bob, "team.data.M") or bob.team.peers()["ann"].dropped)
    wait_until(lambda: len(heard(bob)) == 3 and heard(bob, "team.state.M"))
    is_other = ann.generated.package.MODEL != bob.generated.package.MODEL
    wait_until(lambda: not is_other or (bob.of("peer", what="build") and ann.of("peer", what="build")))
    ann.stop()
    bob.stop()
    assert [m["n"] for m in heard(bob)] == [0, 1, 2]
    assert not faults(ann) and not faults(bob)
    assert [r["reason"] for r in bob.of("peer", what="build")] == [
        f"ann is of another build ({ann.generated.package.MODEL})"
    ] * is_other


def test_a_new_field_is_ignored_and_a_missing_one_is_absent(mouth: Mouth, links: Any) -> None:
    new = changed("int n  optional", "int n  optional int speed = 9  repeated int trail = 10  optional")
    ann, bob = met(new, generate(OLD), mouth, links)
    mouth.say += [("team.signal.M", said(new, 1, speed=0, trail=(1, 2)))]
    wait_until(lambda: heard(bob))
    ann.stop()
    bob.stop()
    assert heard(bob) == [{"n": 1, "colour": None, "place": None}]
    back = Mouth()
    old = generate(OLD)
    ann, bob = met(old, new, back, links)
    back.say += [("team.signal.M", said(old, 0, colour=old.messages.Colour.RED))]
    wait_until(lambda: heard(bob))
    back.over.set()
    ann.stop()
    bob.stop()
    assert heard(bob) == [{"n": 0, "speed": None, "trail": [], "colour": "RED", "place": None}]


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        ("message M { int n", "message M { double n", "`n` is double here and int there"),
        ("message M { int n", "message M { duration n", "`n` is duration here and int there"),
        ("message M { int n", "message M { int n = 7", "`colour` has the number 1 here and 2 there"),
        ("message M { int n", "message M { int m", "the field 1 is `m` here and `n` there"),
        ("message M { int n ", "message M { int n  int k = 9 ", "`k` is not sent, and is not optional here"),
        ("message M { int n", "message M { repeated int n", "`n` is repeated here and required there"),
        ("Place { double x }", "Place { string x }", "in `place`: `x` is string here and double there"),
        ("{ RED  GREEN }", "{ GREEN  RED }", "`colour`: COLOUR_GREEN is 0 here and 1 there"),
        ("signal M queued", "signal M", "its signals queue"),
    ],
)
def test_what_is_not_compatible_is_refused_to_its_sender(
    old: str, new: str, reason: str, mouth: Mouth, links: Any
) -> None:
    ann, bob = met(generate(OLD), changed(old, new), mouth, links)
    mouth.say += [("team.signal.M", said(ann.generated, n)) for n in range(50)]
    mouth.say += [("team.signal.N", ann.generated.message("N", n=1))]
    began = time.monotonic()
    wait_until(lambda: ann.of("peer", what="rejected"))
    late = time.monotonic() - began
    wait_until(lambda: heard(bob, "team.signal.N"))
    wait_until(lambda: ann.team.peers()["bob"].rejected == 50)
    incompatible = wait_until(lambda: ann.team.peers()["bob"].incompatible)
    wait_until(lambda: bob.team.peers()["ann"].incompatible)
    ann.stop()
    bob.stop()
    assert late < 1 + LONG / 60
    assert bob.team.peers()["ann"].refused == 50
    assert heard(bob) == [] and len(heard(bob, "team.signal.N")) == 1
    assert f"team.signal.M to bob: {reason}" in incompatible
    assert [r["reason"] for r in ann.of("peer", what="rejected")] == [f"team.signal.M: {reason}"]
    assert [r["reason"] for r in bob.of("peer", what="refused")] == [
        f"team.signal.M is of another build: {reason}"
    ]
    # One of the message, one of the builds; not a line for each message.
    assert len(faults(ann)) == 2 and len(faults(bob)) == 1


def test_a_channel_that_a_build_does_not_have(mouth: Mouth, links: Any) -> None:
    new = generate(OLD.replace("signal M queued  ", "").replace("team.signal.M, ", ""))
    ann, bob = met(generate(OLD), new, mouth, links)
    mouth.say += [("team.signal.M", said(ann.generated, n)) for n in range(5)]
    wait_until(lambda: ann.team.peers()["bob"].rejected == 5)
    ann.stop()
    bob.stop()
    assert "team.signal.M to bob: there is no such channel" in ann.team.peers()["bob"].incompatible
    assert any("team.signal.M" in text for text in faults(ann))
    assert any("team.signal.M" in text for text in faults(bob))


def test_a_constant_that_is_not_known_is_absent_or_refused(mouth: Mouth, links: Any) -> None:
    new = changed("RED  GREEN }", "RED  GREEN  BLUE }")
    blue = new.messages.Colour.BLUE
    ann, bob = met(new, generate(OLD), mouth, links)
    mouth.say += [("team.signal.M", said(new, 1, colour=blue))]
    wait_until(lambda: heard(bob))
    ann.stop()
    bob.stop()
    assert heard(bob)[0]["colour"] is None
    always = [
        generate(OLD.replace("optional Colour", "Colour").replace("GREEN }", more))
        for more in ("GREEN  BLUE }", "GREEN }")
    ]
    plain = Mouth()
    ann, bob = met(always[0], always[1], plain, links)
    plain.say += [("team.signal.M", said(always[0], n, colour=colour)) for n, colour in enumerate((2, 1))]
    wait_until(lambda: heard(bob))
    wait_until(lambda: ann.team.peers()["bob"].rejected == 1)
    plain.over.set()
    ann.stop()
    bob.stop()
    assert [m["colour"] for m in heard(bob)] == ["GREEN"]
    assert [r["reason"] for r in ann.of("peer", what="rejected")] == [
        "team.signal.M: M.colour: Colour has no constant with the number 2"
    ]


def test_zero_is_not_absent_for_a_field_that_has_become_optional(mouth: Mouth, links: Any) -> None:
    old, new = generate(OLD), changed("message M { int n", "message M { optional int n")
    ann, bob = met(old, new, mouth, links)
    mouth.say += [("team.signal.M", said(old, 0))]
    wait_until(lambda: heard(bob))
    ann.stop()
    bob.stop()
    assert heard(bob)[0]["n"] == 0


def test_an_agent_that_a_build_does_not_know_is_told_so(mouth: Mouth) -> None:
    pytest.importorskip("zenoh")
    name = own_name("Talk")
    new = changed("ann : Speaker  bob", "ann, dan : Speaker  bob")
    one = part(new, ["dan"], mouth.activities, ZenohLink(name, Network())).start()
    bob = part(generate(OLD), ["bob"], mouth.activities, ZenohLink(name, Network())).start()
    wait_until(lambda: one.of("peer", what="rejected"))
    mouth.say += [("team.signal.M", said(new, n)) for n in range(3)]
    wait_until(lambda: sum(r.get("number", 1) for r in one.of("lost")) == 3)
    assert not one.team.transport.is_there("bob")
    one.stop()
    bob.stop()
    assert "dan unknown" in bob.news()
    assert faults(one) == ["bob is of another build: there is no agent dan in its team"]
    assert {r["reason"] for r in one.of("lost")} == {"it is of another build, which does not have its sender"}


# ---- conversations -----------------------------------------------------------------------------

DEAL = """
system Deal
message Job { int id }
message Price { int euros }
aip deal {
  participant asker {
    sends request Job
    receives inform Price, not_understood Job
    process = Ask . (Hear | Sorry | Puzzled)
  }
  participant teller {
    sends inform Price
    receives request Job
    process = Think . Tell
  }
  control asker {
    enter Ask   : / send request Job { id = 1 } to teller
    enter Hear  : inform Price from teller
    enter Sorry : WAY
    enter Puzzled : after(60s)
  }
  control teller {
    enter Think : request Job from asker
    leave Tell  : / send inform Price { euros = 5 } to asker
  }
}
srm chief { plays deal.asker  liveness { chief = asker }
  activities { Ask takes 10ms  Hear takes 10ms  Sorry takes 10ms  Puzzled takes 10ms } }
srm aide { plays deal.teller  liveness { aide = teller~ }  activities { Think takes 20ms  Tell takes 10ms } }
team T { ann : chief  bob : aide }
"""
LOST = DEAL.replace("WAY", "lost teller gone [reason(gone) == incompatible]")
ANSWERED = DEAL.replace("WAY", "not_understood Job from teller")


class Briefly:
    def execute(self, context: Context) -> None:
        context.wait(0.01)


SHORT: dict[str, type[Any]] = dict.fromkeys(
    ("Ask", "Hear", "Sorry", "Puzzled", "Think", "Nod", "Tell"), Briefly
)


def deal(ann: str, bob: str, links: Any) -> tuple[list[str], Part, Part]:
    """The states of ann, until she has ended."""
    one = part(generate(ann), ["ann"], SHORT, links())
    other = part(generate(bob), ["bob"], SHORT, links())
    other.start()
    one.start()
    one.join()
    other.stop()
    started = [r["activity"] for r in one.of("activity", what="start")]
    return started, one, other


@pytest.mark.parametrize("text", [LOST, ANSWERED])
@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("message Price { int euros }", "message Price { int euros  optional int cents }"),
        ("Think takes 20ms", "Think takes 21ms"),
        ("process = Think . Tell", "process = Think . Nod . Tell"),
    ],
)
def test_robots_of_two_builds_converse(text: str, old: str, new: str, links: Any) -> None:
    assert old in text
    found, one, other = deal(text, text.replace(old, new), links)
    assert found == ["Ask", "Hear"]
    assert not faults(one) and not faults(other)


@pytest.mark.parametrize("text", [LOST, ANSWERED])
@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("message Price { int euros }", "message Price { double euros }"),
        ("message Job { int id }", "message Job { string id }"),
        ("{ euros = 5 } to asker", "{ euros = 5 } to asker; send inform Price { euros = 6 } to asker"),
    ],
)
def test_another_version_of_a_protocol_is_refused_to_who_begins(
    text: str, old: str, new: str, links: Any
) -> None:
    assert old in text
    began = time.monotonic()
    other = text.replace(old, new)
    if "string id" in new:
        other = other.replace("{ id = 1 }", '{ id = "1" }')
    found, one, two = deal(text, other, links)
    assert found == ["Ask", "Sorry"], (one.records, two.records)
    assert time.monotonic() - began < LONG / 3
    if text is LOST:
        (gone,) = one.of("conversation", what="gone")
        assert gone["reason"] == "incompatible"
    (rejected,) = one.of("peer", what="rejected")
    assert rejected["reason"].startswith("Job: ")
    assert two.team.peers()["ann"].refused == 1


def test_what_is_said_in_the_midst_of_a_swap_is_of_one_of_both_versions(
    mouth: Mouth, links: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An activity speaks again and again, also while its agent changes."""
    old_text = OLD.replace("Say takes 500ms", "Say every 10ms").replace("Speaker = Say", "Speaker = Say~")
    old = generate(old_text)
    new = generate(old_text.replace("optional Place place }", "optional Place place  optional int build }"))
    said = itertools.count()

    def speaking(made: Generated, **members: Any) -> dict[str, type[Any]]:
        class Say:
            def execute(self, context: Context) -> None:
                context.publish("team.signal.M", made.message("M", n=next(said), **members))

        return {"Say": Say}

    for step in ("renew", "speak"):
        monkeypatch.setattr(Team, step, slowly(getattr(Team, step)))
    ann, bob = part(old, ["ann"], speaking(old), links()), part(new, ["bob"], mouth.activities, links())
    ann.start()
    bob.start()
    wait_until(lambda: heard(bob))
    swap = Swap(ann.team, version(new, speaking(new, build=7)))
    wait_until(lambda: swap.check() and swap.hold())
    swap.finish()
    wait_until(lambda: heard(bob)[-1]["build"])
    mouth.over.set()
    ann.stop()
    bob.stop()
    assert not faults(ann)
    found = [(m["n"], m["build"]) for m in heard(bob)]
    assert [n for n, _ in found] == list(range(len(found)))
    assert {build for _, build in found} == {None, 7}


def slowly(step: Callable[..., None]) -> Callable[..., None]:
    """A step, after which nothing else happens for a moment."""

    def slow(*what: Any) -> None:
        step(*what)
        time.sleep(0.2)

    return slow
