"""A team in several parts: the same rules as in one process, whatever the link does."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Iterator
from typing import Any

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.conversation.directory import Entry, Service
from aseme_dsl.runtime.message.acl import AclMessage
from aseme_dsl.runtime.platform.over_platform import PlatformLink
from aseme_dsl.runtime.team.team import TeamError
from aseme_dsl.runtime.transport import Network
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.envelope import Envelope
from aseme_dsl.runtime.transport.link import Link, Stamp
from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
from tests.runtime.platform.square import Square
from tests.runtime.playing import make
from tests.runtime.transport.net import Air, Part, _AirLink, part
from tests.support.generated import Generated, generate
from tests.support.network import own_name
from tests.support.waiting import LONG, wait_until

TEAM = """
system Talk
message M { int n }
topic home  { state M }
topic team  { signal M queued  signal N  state M from Speaker  data M }
message N { int n }
srm Speaker {
  liveness { Speaker = Say~ || Own~ }
  activities { Say writes team.signal.M, team.signal.N, team.state.M, team.data.M  Own writes home.state.M }
}
srm Listener {
  liveness { Listener = (Hear || Own~) }
  activities { Hear reads team.signal.M, team.signal.N, team.state.M, team.data.M, home.state.M
               Own writes home.state.M }
}
team T { ann : Speaker  bob, cat : Listener }
"""
DOUBLE = TEAM.replace("message M { int n }", "message M { double n }")
"""Another build, in which a field has another type."""


class Box:
    """What activities are told to say, and what they have heard."""

    def __init__(self, generated: Generated) -> None:
        self.generated = generated
        self.say: list[tuple[str, int, str | None]] = []
        self.heard: dict[str, list[int]] = {}
        self.stop = threading.Event()
        box = self

        class Say:
            def execute(self, context: Context) -> None:
                while not box.stop.is_set():
                    while box.say:
                        channel, n, host = box.say.pop(0)
                        message = generated.message(channel.split(".")[2], n=n)
                        context.publish(channel, message, host)
                    context.wait(0.002)

        class Own:
            def execute(self, context: Context) -> None:
                context.publish("home.state.M", generated.message("M", n=1))
                while not box.stop.is_set():
                    context.wait(0.02)

        class Hear:
            def execute(self, context: Context) -> None:
                while not box.stop.is_set():
                    context.wait(0.005)

        self.activities: dict[str, type[Any]] = {"Say": Say, "Own": Own, "Hear": Hear}


@pytest.fixture(scope="module")
def talk() -> Generated:
    return generate(TEAM)


@pytest.fixture
def box(talk: Generated) -> Iterator[Box]:
    found = Box(talk)
    yield found
    found.stop.set()


def arrived(part_: Part, agent: str, channel: str) -> list[int]:
    return [r["message"]["n"] for r in part_.of("arrived", agent=agent, channel=channel)]


@pytest.fixture(params=["air", "platform", "zenoh"])
def links(request: pytest.FixtureRequest) -> Any:
    """Makes links between parts: through the air of a test, over a platform, or over real sockets."""
    if request.param == "air":
        return Air().link
    if request.param == "platform":
        team = ("ann", "bob", "cat")
        square = Square(team)
        return lambda: PlatformLink(square.platform(), "Talk", team, lease=LONG)
    pytest.importorskip("zenoh")
    name = own_name("Talk")
    return lambda: ZenohLink(name, Network(lease_ms=round(1000 * LONG)))


def test_rules_hold_between_processes(talk: Generated, box: Box, links: Any) -> None:
    ann = part(talk, ["ann"], box.activities, links()).start()
    rest = part(talk, ["bob", "cat"], box.activities, links()).start()
    wait_until(lambda: ann.team.transport.is_there("bob") and ann.team.transport.is_there("cat"))
    box.say += [("team.state.M", 1, None), ("team.signal.M", 2, None), ("team.signal.M", 3, "cat")]
    box.say += [("team.data.M", 4, None)]
    wait_until(lambda: rest.of("arrived", agent="bob", channel="team.data.M"))
    wait_until(lambda: arrived(rest, "bob", "team.signal.M") and arrived(rest, "bob", "team.state.M"))
    wait_until(lambda: len(arrived(rest, "cat", "team.signal.M")) == 2)
    ann.stop()
    wait_until(lambda: "ann gone" in rest.news())
    rest.stop()
    assert arrived(rest, "bob", "team.state.M") == [1]
    assert arrived(rest, "bob", "team.signal.M") == [2]
    assert arrived(rest, "cat", "team.signal.M") == [2, 3]
    # each has its own: what is everybody's own stays at home
    assert rest.of("arrived", channel="home.state.M") == []
    assert ann.of("arrived") == []
    sent = {(r["agent"], r["sequence"]): r for r in ann.of("message")}
    for line in rest.of("arrived"):
        origin = sent[tuple(line["input"])]
        assert origin["message"] == line["message"] and line["agent"] in origin["to"]
    assert ann.of("header")[0]["elsewhere"] == ["bob", "cat"]
    assert ann.news("connected") == ["bob connected", "cat connected"] or ann.news("connected") == [
        "cat connected",
        "bob connected",
    ]


def test_who_comes_late_gets_the_latest_states_and_what_waits(talk: Generated, box: Box, links: Any) -> None:
    ann = part(talk, ["ann"], box.activities, links()).start()
    box.say += [("team.state.M", n, None) for n in range(5)]
    box.say += [("team.signal.M", n, None) for n in range(3)]
    box.say += [("team.signal.N", n, None) for n in range(3)]
    wait_until(lambda: len(ann.of("message", channel="team.signal.N")) == 3)
    bob = part(talk, ["bob"], box.activities, links()).start()
    wait_until(lambda: arrived(bob, "bob", "team.signal.N"))
    bob.stop()
    ann.stop()
    assert arrived(bob, "bob", "team.state.M") == [4]
    assert arrived(bob, "bob", "team.signal.M") == [0, 1, 2]  # queued
    assert arrived(bob, "bob", "team.signal.N") == [2]  # a newer one replaces one that nobody has looked at


def test_a_new_life_gets_the_states_again_and_what_was_on_its_way_is_lost(talk: Generated, box: Box) -> None:
    air = Air()
    ann = part(talk, ["ann"], box.activities, air.link()).start()
    bob = part(talk, ["bob"], box.activities, air.link()).start()
    wait_until(lambda: ann.team.transport.is_there("bob"))
    box.say += [("team.state.M", 7, None)]
    wait_until(lambda: arrived(bob, "bob", "team.state.M"))
    wait_until(lambda: not ann.team.peers()["bob"].unacknowledged)
    air.cut.add("bob")  # it stands still: nobody has noticed yet
    box.say += [("team.signal.M", 8, None)]
    wait_until(lambda: ann.team.peers()["bob"].unacknowledged)
    bob.stop()
    wait_until(lambda: not ann.team.transport.is_there("bob"))
    box.say += [("team.signal.M", 9, None)]
    wait_until(lambda: len(ann.of("message", channel="team.signal.M")) == 2)
    air.cut.clear()
    again = part(talk, ["bob"], box.activities, air.link()).start()
    wait_until(lambda: arrived(again, "bob", "team.signal.M"))
    again.stop()
    ann.stop()
    assert arrived(again, "bob", "team.state.M") == [7]
    assert arrived(again, "bob", "team.signal.M") == [9]
    (lost,) = ann.of("lost", peer="bob")
    assert lost["reason"] == "it ended while this was on its way"
    assert ann.news("connected", "gone", "restarted")[:3] == ["bob connected", "bob gone", "bob restarted"]


def test_a_new_life_uses_no_identity_of_an_earlier_one(talk: Generated, box: Box) -> None:
    air = Air()
    bob = part(talk, ["bob"], box.activities, air.link()).start()
    for life in range(3):
        ann = part(talk, ["ann"], box.activities, air.link()).start()
        wait_until(lambda ann=ann: ann.team.transport.is_there("bob"))
        box.say += [("team.signal.M", life, None)]
        wait_until(lambda life=life: arrived(bob, "bob", "team.signal.M") == list(range(life + 1)))
        ann.stop()
    bob.stop()
    identities = [r["input"] for r in bob.of("arrived")]
    assert len(identities) == 3
    assert identities == sorted(identities) and len({number for _, number in identities}) == 3
    assert all(number < 2**53 for _, number in identities)


def test_a_partition_loses_nothing(talk: Generated, box: Box) -> None:
    air = Air()
    ann = part(talk, ["ann"], box.activities, air.link()).start()
    bob = part(talk, ["bob"], box.activities, air.link()).start()
    wait_until(lambda: ann.team.transport.is_there("bob"))
    box.say += [("team.signal.M", n, None) for n in range(50)]
    wait_until(lambda: len(ann.of("message", channel="team.signal.M")) == 50)
    air.part("bob")
    wait_until(lambda: not ann.team.transport.is_there("bob"))
    box.say += [("team.state.M", n, None) for n in range(10)]
    box.say += [("team.signal.M", n, None) for n in range(50, 100)]
    # What is recorded is on its way a moment later; so the states are by the time of the signals behind them.
    wait_until(lambda: len(ann.of("message", channel="team.signal.M")) == 100)
    air.join("bob")
    wait_until(lambda: len(arrived(bob, "bob", "team.signal.M")) == 100)
    wait_until(lambda: arrived(bob, "bob", "team.state.M"))
    bob.stop()
    ann.stop()
    assert arrived(bob, "bob", "team.signal.M") == list(range(100))
    assert arrived(bob, "bob", "team.state.M") == [9]
    assert "bob reconnected" in ann.news()


@pytest.mark.parametrize("seed", range(4))
def test_nothing_is_lost_doubled_or_overtaken(talk: Generated, box: Box, seed: int) -> None:
    air = Air(seed, loss=0.4, doubling=0.2, delay=0.01)
    ann = part(talk, ["ann"], box.activities, air.link()).start()
    rest = part(talk, ["bob", "cat"], box.activities, air.link()).start()
    box.say += [("team.signal.M", n, None) for n in range(300)]
    wait_until(lambda: len(arrived(rest, "bob", "team.signal.M")) >= 300)
    wait_until(lambda: len(arrived(rest, "cat", "team.signal.M")) >= 300)
    ann.stop()
    rest.stop()
    assert arrived(rest, "bob", "team.signal.M") == list(range(300))
    assert arrived(rest, "cat", "team.signal.M") == list(range(300))
    (count,) = rest.of("peer", peer="ann", what="count")
    assert count["counts"]["duplicated"] > 0 and count["counts"]["reordered"] > 0
    assert "duplicated" in [r["what"] for r in rest.of("peer")]


def test_data_has_the_time_of_its_sender(talk: Generated, box: Box) -> None:
    air = Air(delay=0.0)
    began = time.monotonic_ns()
    ann = part(talk, ["ann"], box.activities, air.link(), origin=began - 10**9).start()
    bob = part(talk, ["bob"], box.activities, air.link(), origin=began).start()
    wait_until(lambda: ann.team.transport.is_there("bob"))
    box.say += [("team.data.M", 1, None)]
    wait_until(lambda: arrived(bob, "bob", "team.data.M"))
    box.say += [("team.data.M", 2, None)]
    wait_until(lambda: len(arrived(bob, "bob", "team.data.M")) == 2)
    ann_times = [r["time"] for r in ann.of("message", channel="team.data.M")]
    history = bob.team.history("ann", "team.data.M", 0, bob.team.driver.clock.now())
    ann.stop()
    bob.stop()
    measured = [r["measured"] for r in bob.of("arrived", channel="team.data.M")]
    assert measured == [moment - 10**9 for moment in ann_times]
    assert [(moment, message.n) for moment, message in history] == [(measured[0], 1), (measured[1], 2)]


class OtherMachine:
    """A link from a machine whose clock is ahead by `SKEW`."""

    SKEW = 3_600_000_000_000

    def __init__(self, link: Link) -> None:
        self.link = link

    def send(
        self, to: str, sender: str, way: str, envelope: Envelope, stamp: Stamp, payload: bytes, sure: bool
    ) -> None:
        heard = envelope.heard + self.SKEW if envelope.kind == envelopes.PONG else 0
        ahead = envelope._replace(time=envelope.time + self.SKEW, clock=42, heard=heard)
        self.link.send(to, sender, way, ahead, stamp, payload, sure)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.link, name)


class BehindMachine(OtherMachine):
    """A link from a machine whose clock is behind: a time that is not corrected is too early."""

    SKEW = -10_000_000_000


def test_the_clock_of_another_machine_is_measured(talk: Generated, box: Box) -> None:
    air = Air()
    began = time.monotonic_ns()
    ann = part(talk, ["ann"], box.activities, OtherMachine(air.link()), origin=began).start()
    bob = part(talk, ["bob"], box.activities, air.link(), origin=began).start()
    wait_until(lambda: ann.team.transport.is_there("bob"))
    box.say += [("team.data.M", 1, None)]
    before = wait_until(lambda: bob.team.peers()["ann"].uncertainty or 0)
    box.say += [("team.data.M", 2, None)]
    wait_until(lambda: 2 in arrived(bob, "bob", "team.data.M"))
    measured = wait_until(lambda: bob.of("peer", what="clock"))
    assert abs(measured[0]["difference"] + OtherMachine.SKEW) <= max(measured[0]["uncertainty"], 1_000_000)
    peer = bob.team.peers()["ann"]
    uncertainty = max(before, peer.uncertainty or 0)
    assert abs((peer.difference or 0) + OtherMachine.SKEW) <= max(uncertainty, 1_000_000)
    ann.stop()
    bob.stop()
    (sent,) = [r["time"] for r in ann.of("message", channel="team.data.M") if r["message"]["n"] == 2]
    (line,) = [r for r in bob.of("arrived", channel="team.data.M") if r["message"]["n"] == 2]
    (count,) = [r for r in bob.of("peer", what="count") if r["peer"] == "ann"]
    assert abs(count["difference"] + OtherMachine.SKEW) <= max(uncertainty, 1_000_000)
    assert "difference" in count and count["uncertainty"] >= 0
    assert abs(line["measured"] - sent) <= max(uncertainty, 1_000_000) and line["measured"] <= line["time"]


def test_an_agent_message_has_the_time_at_which_it_was_sent() -> None:
    """By the clock of the receiver's machine, once that of the sender's is known."""
    text = NET.replace("process = Announce", "process = Hold . Announce")
    net = generate(text.replace("Announce takes 1ms", "Hold takes 1ms  Announce takes 1ms"))
    air = Air()
    began = time.monotonic_ns()
    known, seen = threading.Event(), []

    class Hold:
        def execute(self, context: Context) -> None:
            known.wait(LONG)

    class Offer:
        def execute(self, context: Context) -> None:
            mail = context.last_received("cfp")
            assert mail is not None and mail.sent is not None
            seen.append((mail.sent, context.now_ns))

    ann = part(net, ["ann"], {"Hold": Hold}, BehindMachine(air.link()), origin=began).start()
    bob = part(net, ["bob"], {"Offer": Offer}, air.link(), origin=began).start()
    wait_until(lambda: ann.team.transport.is_there("bob"))
    before = wait_until(lambda: bob.team.peers()["ann"].uncertainty)
    known.set()
    wait_until(lambda: seen)
    uncertainty = max(before or 0, bob.team.peers()["ann"].uncertainty or 0, 1_000_000)
    ann.stop()
    bob.stop()
    (said,) = [r["time"] for r in ann.of("agent_message", performative="cfp")]
    (heard,) = [r for r in bob.of("received", performative="cfp")]
    # On a busy machine, some time passes from the record to the link.
    assert said - uncertainty <= heard["sent"] <= heard["time"]
    assert seen[0][0] == heard["sent"] <= seen[0][1]
    assert {part.of("header")[0]["machine"]["origin"] for part in (ann, bob)} == {began}


def test_another_build_is_refused_and_said_once(talk: Generated, box: Box) -> None:
    air = Air()
    ann = part(talk, ["ann"], box.activities, air.link()).start()
    bob = part(generate(DOUBLE), ["bob"], box.activities, air.link()).start()
    wait_until(lambda: ann.team.transport.is_there("bob"))
    box.say += [("team.signal.M", n, None) for n in range(5)] + [("team.state.M", 1, None)]
    wait_until(lambda: bob.team.peers()["ann"].refused == 6)
    wait_until(lambda: not ann.team.peers()["bob"].unacknowledged)
    ann.stop()
    bob.stop()
    assert bob.of("arrived") == []
    reasons = [r["reason"] for r in bob.of("peer", what="refused")]
    assert reasons == [
        "team.signal.M is of another build: `n` is double here and int there",
        "team.state.M is of another build: `n` is double here and int there",
    ]


def test_what_is_refused_and_comes_twice_is_counted_once_as_refused(talk: Generated, box: Box) -> None:
    """As what comes late does: it is sent again, and then both come."""
    air = Air(doubling=1.0)
    ann = part(talk, ["ann"], box.activities, air.link()).start()
    bob = part(generate(DOUBLE), ["bob"], box.activities, air.link()).start()
    wait_until(lambda: ann.team.transport.is_there("bob"))
    box.say += [("team.signal.M", n, None) for n in range(5)] + [("team.data.M", 1, None)]
    wait_until(lambda: bob.team.peers()["ann"].duplicated >= 6)
    wait_until(lambda: not ann.team.peers()["bob"].unacknowledged)
    ann.stop()
    bob.stop()
    assert bob.team.peers()["ann"].refused == 6


def test_a_newer_process_of_the_same_robot_takes_over(talk: Generated, box: Box) -> None:
    air = Air()
    old = part(talk, ["bob"], box.activities, air.link()).start()
    ann = part(talk, ["ann"], box.activities, air.link()).start()
    wait_until(lambda: ann.team.transport.is_there("bob"))
    new = part(talk, ["bob"], box.activities, air.link()).start()
    old.join()
    assert old.result is not None and old.result.reason == "replaced"
    wait_until(lambda: "bob restarted" in ann.news())
    box.say += [("team.signal.M", 1, None)]
    wait_until(lambda: arrived(new, "bob", "team.signal.M") == [1])
    new.stop()
    wait_until(lambda: len(ann.news("restarted", "gone")) == 3)
    ann.stop()
    assert ann.news("restarted", "gone") == ["bob gone", "bob restarted", "bob gone"]


def test_a_robot_whose_clock_was_set_back_is_known_again(talk: Generated, box: Box) -> None:
    air = Air()
    ann = part(talk, ["ann"], box.activities, air.link()).start()
    first = part(talk, ["bob"], box.activities, air.link()).start()
    wait_until(lambda: ann.team.transport.is_there("bob"))
    first.stop()
    wait_until(lambda: "bob gone" in ann.news())
    second = part(talk, ["bob"], box.activities, air.link())
    second.post.state.incarnation = 12345  # it is 1970 again
    second.start()
    wait_until(lambda: "bob restarted" in ann.news())
    box.say += [("team.signal.M", 1, None)]
    wait_until(lambda: arrived(second, "bob", "team.signal.M") == [1])
    second.stop()
    ann.stop()


def test_control_requests_come_through(talk: Generated, box: Box, links: Any) -> None:
    ann = part(talk, ["ann"], box.activities, links()).start()
    bob = part(talk, ["bob"], box.activities, links())
    bob.team.transport.answer(lambda agent, request: {"you asked": json.loads(request)["what"]})
    bob.start()
    wait_until(lambda: ann.team.transport.is_there("bob") and bob.team.transport.is_there("ann"))
    answer = ann.team.transport.ask("bob", {"what": "status"}, timeout=LONG)
    other = bob.team.transport.ask("ann", {"what": "status"}, timeout=LONG)
    ann.stop()
    bob.stop()
    assert answer == {"you asked": "status"}
    assert other == {"error": "ann takes no control requests"}


NET = """
system Net
message Task { int n }
message Bid { int cost }
aip net {
  participant manager {
    sends cfp Task
    receives propose Bid
    process = Announce . AwaitBids
  }
  participant contractor [1..*] {
    sends propose Bid
    receives cfp Task
    process = Await . Offer
  }
  control manager {
    enter Announce : / send cfp Task { .. } to contractor
    leave AwaitBids : propose Bid from contractor or after(20s)
  }
  control contractor {
    enter Offer : cfp Task from manager / send propose Bid { .. } to manager
  }
}
srm boss {
  plays net.manager
  liveness { boss = manager }
  activities { Announce takes 1ms AwaitBids takes 30s }
}
srm worker {
  plays net.contractor
  liveness { worker = contractor~ }
  activities { Await takes 10s Offer takes 1ms }
}
team T { ann : boss  bob, cat : worker }
"""


@pytest.fixture(scope="module")
def net() -> Generated:
    return generate(NET)


def test_a_conversation_between_processes(net: Generated, links: Any) -> None:
    workers = part(net, ["bob", "cat"], {}, links()).start()

    class Announce:
        """What it has said is lost for who comes only after it has ended."""

        def execute(self, context: Context) -> None:
            while not all(map(boss.team.transport.is_there, ("bob", "cat"))):
                context.wait(0.005)

    boss = part(net, ["ann"], {"Announce": Announce}, links()).start()
    boss.join()
    wait_until(lambda: len(workers.of("agent_message")) == 2)
    workers.stop()
    assert boss.result is not None and boss.result.reason == "finished"
    opened = boss.of("conversation", what="open")
    joined = workers.of("conversation", what="join")
    assert {r["conversation"] for r in joined} == {opened[0]["conversation"]}
    assert {r["agent"] for r in joined} == {"bob", "cat"}
    received = boss.of("received", performative="propose")
    assert received and received[0]["input"][0] in ("bob", "cat")
    (asked,) = boss.of("agent_message", performative="cfp")
    assert {r["in_reply_to"] for r in received} == {f"ann-{asked['sequence']}"}
    assert [r["answers"] for r in workers.of("agent_message")] == [[["ann", asked["sequence"]]]] * 2


def test_a_participant_that_is_gone_is_told(net: Generated) -> None:
    air = Air()
    boss = part(net, ["ann"], {}, air.link()).start()
    wait_until(lambda: boss.of("agent_message"))
    air.loss = 1.0  # what the worker offers does not come through
    bob = part(net, ["bob"], {}, air.link()).start()
    wait_until(lambda: boss.team.transport.is_there("bob"))
    directory = boss.team.conversations.directory
    bidders = Entry(services=(Service("net.contractor"),))
    wait_until(lambda: [entry.name for entry in directory.search(bidders)] == ["bob"])
    bob.stop()
    wait_until(lambda: boss.of("conversation", what="gone"))
    assert [(item.name, item.state) for item in directory.residents()] == [("ann", "active"), ("bob", "gone")]
    boss.stop()
    (gone,) = boss.of("conversation", what="gone")
    assert gone["peer"] == "bob" and gone["participant"] == "manager"


MOURNING = (
    NET.replace(
        "leave AwaitBids : propose Bid from contractor or after(20s)",
        "leave AwaitBids : lost contractor who [who == best]",
    )
    .replace("process = Announce . AwaitBids", "var best : agent  process = Announce . Collect . AwaitBids")
    .replace(
        "enter Announce : /",
        "enter AwaitBids : propose Bid b from contractor / best = sender(b)  enter Announce : /",
    )
    .replace("AwaitBids takes 30s", "AwaitBids takes 30min  Collect takes 30min")
    .replace("Offer takes 1ms", "Offer takes 30min")
)
"""A manager that waits to hear that the contractor with the best bid is gone."""


@pytest.fixture(scope="module")
def mourning() -> Generated:
    return generate(MOURNING)


def test_a_line_may_wait_to_hear_that_a_participant_is_gone(mourning: Generated) -> None:
    air = Air()
    boss = part(mourning, ["ann"], {}, air.link()).start()
    bob = part(mourning, ["bob"], {}, air.link()).start()
    wait_until(lambda: boss.of("received", performative="propose"))
    bob.stop()
    boss.join()
    boss.stop()
    (gone,) = boss.of("conversation", what="gone")
    assert (gone["peer"], gone["played"]) == ("bob", "contractor")
    assert boss.result is not None and boss.result.reason == "finished"


def test_who_begins_anew_before_it_was_seen_to_go_has_left_its_conversations(mourning: Generated) -> None:
    air = Air()
    boss = part(mourning, ["ann"], {}, air.link()).start()
    old = part(mourning, ["bob"], {}, air.link()).start()
    wait_until(lambda: boss.of("received", performative="propose"))
    new = part(mourning, ["bob"], {}, air.link()).start()
    boss.join()
    new.stop()
    old.join()
    assert [r["what"] for r in boss.of("peer", peer="bob")][:3] == ["connected", "gone", "restarted"]
    (gone,) = boss.of("conversation", what="gone")
    assert (gone["peer"], gone["played"]) == ("bob", "contractor")


class LateLink(_AirLink):
    """Brings what acknowledges only after it was told that who says so is gone, as two connections may."""

    def __init__(self, air: Air) -> None:
        super().__init__(air)
        self.kept: list[Any] = []

    def send(self, *arguments: Any) -> None:
        if arguments[3].kind == envelopes.ACKNOWLEDGE:
            self.kept.append(arguments)
        else:
            super().send(*arguments)

    def close(self) -> None:
        super().close()
        threading.Timer(1.0, lambda: [super(LateLink, self).send(*item) for item in self.kept]).start()


def test_what_was_taken_is_not_lost_though_its_receiver_has_ended_since(
    talk: Generated, box: Box, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("aseme_dsl.runtime.transport.reliable_delivery.LAST_WORDS", 5.0)
    air = Air()
    ann = part(talk, ["ann"], box.activities, air.link()).start()
    bob = part(talk, ["bob"], box.activities, LateLink(air)).start()
    wait_until(lambda: ann.team.transport.is_there("bob"))
    box.say += [("team.signal.M", 1, None)]
    wait_until(lambda: arrived(bob, "bob", "team.signal.M") == [1])
    bob.stop()
    wait_until(lambda: "bob gone" in ann.news())
    ann.stop()
    assert not ann.of("lost", peer="bob")


def test_what_was_not_taken_is_lost_soon_after_its_receiver_has_ended(talk: Generated, box: Box) -> None:
    air = Air()
    ann = part(talk, ["ann"], box.activities, air.link()).start()
    bob = part(talk, ["bob"], box.activities, air.link()).start()
    wait_until(lambda: ann.team.transport.is_there("bob"))
    air.loss = 1.0
    box.say += [("team.signal.M", 1, None)]
    wait_until(lambda: ann.of("message", channel="team.signal.M"))
    bob.stop()
    wait_until(lambda: "bob gone" in ann.news())
    ann.stop()
    (lost,) = ann.of("lost", peer="bob")
    assert lost["reason"] == "the run ended before it could be brought"


def test_what_cannot_be(talk: Generated, box: Box) -> None:
    with pytest.raises(TeamError, match="bob, cat cannot be reached: no transport"):
        make(talk, box.activities, here=["ann"], clock="real")
    with pytest.raises(TeamError, match="no agent dan in the team"):
        make(talk, box.activities, here=["dan"])
    with pytest.raises(TeamError, match="no virtual time in common"):
        part_ = part(talk, ["ann"], box.activities, Air().link())
        make(talk, box.activities, here=["ann"], transport=part_.post)


def test_an_agent_message_that_comes_twice_is_told_and_taken_once(net: Generated) -> None:
    """A link below the streams may do that: they take no letter twice; nor do the conversations."""
    air = Air()
    boss = part(net, ["ann"], {}, air.link()).start()
    bob = part(net, ["bob"], {}, air.link()).start()
    boss.join()
    wait_until(lambda: bob.of("received"))
    (got,) = bob.of("received")
    agent = bob.team.agent("bob")
    again = AclMessage(
        "cfp",
        "ann",
        ("bob",),
        "Task",
        net.message("Task"),
        "net",
        got["conversation"],
        "manager",
        "contractor",
        tuple(got["input"]),
    )
    bob.team.conversations.arrived(agent, again, {})
    wait_until(lambda: bob.of("unexpected", reason="it was received before"))
    bob.stop()
    assert len(bob.of("received")) == 1
    assert not bob.of("agent_message", performative="not_understood")


HEALING = (
    NET.replace(
        "leave AwaitBids : propose Bid from contractor or after(20s)",
        "leave AwaitBids : lost contractor who [reason(who) == failed]",
    )
    .replace("process = Announce . AwaitBids", "process = Announce . Collect . AwaitBids")
    .replace("enter Announce : /", "enter AwaitBids : propose Bid from contractor  enter Announce : /")
    .replace(
        "enter Offer : cfp", "leave Offer : lost manager gone [reason(gone) == failed]  enter Offer : cfp"
    )
    .replace("AwaitBids takes 30s", "AwaitBids takes 30min  Collect takes 30min")
    .replace("Offer takes 1ms", "Offer takes 30min")
    .replace("bob, cat : worker", "bob : worker")
)
"""Each waits to hear that the other one's part has failed; that it cannot be reached is not enough."""


@pytest.mark.parametrize("who", ["bob, afterwards", "ann, meanwhile"])
def test_a_peer_that_comes_back_takes_part_again(who: str) -> None:
    """A partition ends no part: its real end is told, also if it comes while the other is out of reach."""
    net = generate(HEALING)
    air, fails = Air(), threading.Event()

    class Fails:
        def execute(self, context: Context) -> None:
            while not fails.is_set():
                context.wait(0.01)
            raise RuntimeError("no battery")

    code = {"Offer": Fails} if who.startswith("bob") else {"AwaitBids": Fails}
    ann = part(net, ["ann"], code, air.link()).start()
    bob = part(net, ["bob"], code, air.link()).start()
    wait_until(lambda: ann.of("activity", activity="AwaitBids", what="start"))
    air.part("bob")
    wait_until(lambda: "bob gone" in ann.news() and "ann gone" in bob.news())
    wait_until(lambda: bob.of("conversation", what="gone") and ann.of("conversation", what="gone"))
    if who.endswith("meanwhile"):
        fails.set()
        wait_until(lambda: ann.of("conversation", what="leave"))
    air.join("bob")
    wait_until(lambda: bob.of("conversation", what="back"))
    if who.endswith("afterwards"):
        wait_until(lambda: ann.of("conversation", what="back"))
        fails.set()
    other, name = (ann, "bob") if who.startswith("bob") else (bob, "ann")
    wait_until(lambda: other.of("conversation", what="gone", peer=name, reason="failed"))
    wait_until(lambda: other.of("conversation", what="leave"))
    ann.stop()
    bob.stop()
    reasons = [r["reason"] for r in other.of("conversation", what="gone", peer=name)]
    assert reasons == ["crashed", "failed"]


def test_signals_that_are_too_many_are_counted_with_their_reason_and_the_sender_is_told(
    talk: Generated, box: Box, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in ("stream", "delivery.reports"):
        monkeypatch.setattr(f"aseme_dsl.runtime.transport.{module}.WAITING", 10)
    air = Air()
    ann = part(talk, ["ann"], box.activities, air.link()).start()
    bob = part(talk, ["bob"], box.activities, air.link()).start()
    wait_until(lambda: ann.team.transport.is_there("bob"))
    air.cut.add(frozenset(("ann", "bob")))
    bob.stop()
    wait_until(lambda: not ann.team.transport.is_there("bob"))
    box.say += [("team.signal.M", n, None) for n in range(110)]
    wait_until(lambda: len(ann.of("message", channel="team.signal.M")) == 110)
    ann.stop()
    lost = [(r["reason"], r.get("number", 1)) for r in ann.of("lost", peer="bob")]
    by_reason: dict[str, int] = {}
    for reason, number in lost:
        by_reason[reason] = by_reason.get(reason, 0) + number
    assert by_reason == {
        "too many messages wait for it": 100,
        "the run ended before it could be brought": 10,
    }
    assert len(lost) < 10
    told = [r["reason"] for r in ann.of("fault") if "wait for bob" in r["reason"]]
    assert told == ["10 messages wait for bob: of team.signal.M, the oldest are dropped"]
