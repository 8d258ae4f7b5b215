"""Teams over SPADE: conversations through a server that stops, is killed, or hangs; agents that end."""

from __future__ import annotations

import asyncio
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from typing import Any

import psutil
import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.platform.over_platform import PlatformLink
from aseme_dsl.runtime.transport import TransportError
from tests.platforms.servers import Server
from tests.runtime.transport import net as parts
from tests.runtime.transport.net import Part
from tests.runtime.transport.test_parts import MOURNING, NET, TEAM, Box
from tests.security.lines import line
from tests.support.generated import Generated, generate
from tests.support.network import own_port
from tests.support.waiting import LONG, wait_until

pytest.importorskip("spade", reason="SPADE is not installed: python3 dev.py long")

from aseme_dsl.runtime.platform.over_spade import SpadePlatform

NAMES = ("ann", "bob", "cat")
_running: list[Part] = []


def part(*arguments: Any, **options: Any) -> Part:
    """A part of a team, which ends with the test."""
    found = parts.part(*arguments, **options)
    _running.append(found)
    return found


def finish(found: Part) -> None:
    """Wait for the end of a part."""
    wait_until(lambda: found.thread is not None and not found.thread.is_alive())
    found.join()


@pytest.fixture(autouse=True)
def no_part_is_left() -> Iterator[None]:
    yield
    while _running:
        found = _running.pop()
        if found.thread is not None and found.thread.is_alive():
            found.team.driver.stop("test")
            found.thread.join(LONG)


@pytest.fixture(scope="module")
def net() -> Generated:
    return generate(NET)


@pytest.fixture(scope="module")
def talk() -> Generated:
    return generate(TEAM)


def link(server: Server, **settings: Any) -> PlatformLink:
    return PlatformLink(SpadePlatform(server.settings(**settings), NAMES), "Net", NAMES)


def started(net: Generated, server: Server, *here: str, **activities: Any) -> Part:
    return part(net, here, activities, link(server)).start()


def test_a_conversation(net: Generated, server: Server) -> None:
    workers = started(net, server, "bob", "cat")
    boss = started(net, server, "ann")
    finish(boss)
    wait_until(lambda: len(workers.of("agent_message")) == 2)
    workers.stop()
    assert boss.result is not None and boss.result.reason == "finished"
    opened = boss.of("conversation", what="open")
    joined = workers.of("conversation", what="join")
    assert {r["conversation"] for r in joined} == {opened[0]["conversation"]}
    assert not boss.of("fault") and not workers.of("fault")


# ---- the server ends, and comes back -----------------------------------------------------------


@pytest.mark.parametrize("how", [signal.SIGTERM, signal.SIGKILL])
def test_nothing_is_lost_when_the_server_is_restarted(
    talk: Generated, server: Server, how: signal.Signals
) -> None:
    box = Box(talk)
    ann = part(talk, ["ann"], box.activities, link(server)).start()
    rest = part(talk, ["bob", "cat"], box.activities, link(server)).start()
    try:
        wait_until(lambda: ann.team.transport.is_there("bob") and ann.team.transport.is_there("cat"))
        box.say += [("team.signal.M", n, None) for n in range(100)]
        wait_until(lambda: len(arrived(rest, "bob")) > 20)
        server.stop(how)
        box.say += [("team.signal.M", n, None) for n in range(100, 200)]
        time.sleep(1.0)
        server.start()
        wait_until(lambda: len(arrived(rest, "bob")) >= 200)
        wait_until(lambda: len(arrived(rest, "cat")) >= 200)
    finally:
        box.stop.set()
        rest.stop()
        ann.stop()
    assert arrived(rest, "bob") == arrived(rest, "cat") == list(range(200))
    own = [item for item in ann.news("disconnected", "connected") if item.startswith("ann ")]
    assert own == ["ann disconnected", "ann connected"]


def arrived(found: Part, agent: str) -> list[int]:
    return [r["message"]["n"] for r in found.of("arrived", agent=agent, channel="team.signal.M")]


def test_a_conversation_goes_on_after_the_server_was_restarted(net: Generated, server: Server) -> None:
    class Await:
        def execute(self, context: Context) -> None:
            context.wait(60)

    boss = started(net, server, "ann")
    wait_until(lambda: boss.of("agent_message"))
    server.stop(signal.SIGKILL)
    workers = started(net, server, "bob", "cat", Await=Await)  # while there is no server
    time.sleep(0.5)
    server.start()
    finish(boss)
    workers.stop()
    assert boss.result is not None and boss.result.reason == "finished"
    assert boss.of("received", performative="propose")


def test_a_server_that_hangs_is_noticed(
    talk: Generated, server: Server, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("aseme_dsl.runtime.platform.spade_agent.SILENCE", 1.0)
    box = Box(talk)
    ann = part(talk, ["ann"], box.activities, link(server)).start()
    bob = part(talk, ["bob"], box.activities, link(server)).start()
    try:
        wait_until(lambda: ann.team.transport.is_there("bob"))
        server.freeze()
        box.say += [("team.signal.M", n, None) for n in range(5)]
        wait_until(lambda: ann.of("peer", what="disconnected"))
        assert "has said nothing" in ann.of("peer", what="disconnected")[0]["reason"]
        server.thaw()
        wait_until(lambda: len(arrived(bob, "bob")) >= 5)
    finally:
        box.stop.set()
        bob.stop()
        ann.stop()
    assert arrived(bob, "bob") == list(range(5))


# ---- agents end --------------------------------------------------------------------------------


def test_an_agent_that_is_killed_in_a_conversation_is_told_to_the_others(server: Server) -> None:
    boss = started(generate(MOURNING), server, "ann")
    code = f"""
import sys; sys.path.insert(0, {sys.path[0]!r})
from tests.platforms.test_spade import *
s = Server({server.kind!r}); s.port = {server.port}
class Offer:
    def execute(self, context): context.wait(3600)
part(generate(MOURNING), ["bob"], dict(Offer=Offer), link(s)).start().thread.join()
"""
    bob = subprocess.Popen([sys.executable, "-c", code])
    try:
        wait_until(lambda: boss.of("received", performative="propose"))
        bob.kill()
        finish(boss)
    finally:
        bob.kill()
        bob.wait()
    assert "bob gone" in boss.news()
    (gone,) = boss.of("conversation", what="gone")
    assert (gone["peer"], gone["played"]) == ("bob", "contractor")


def test_a_newer_process_of_the_same_agent_takes_over(net: Generated, server: Server) -> None:
    old = started(net, server, "bob")
    cat = started(net, server, "cat")
    wait_until(lambda: cat.team.transport.is_there("bob"))
    new = started(net, server, "bob")
    wait_until(lambda: "bob restarted" in cat.news())
    new.stop()
    cat.stop()
    old.stop()


# ---- an activity that blocks -------------------------------------------------------------------


def test_an_activity_that_blocks_holds_up_no_other_agent(net: Generated, server: Server) -> None:
    class Offer:
        def execute(self, context: Context) -> None:
            if context.agent == "bob":
                time.sleep(LONG)

    workers = started(net, server, "bob", "cat", Offer=Offer)
    boss = started(net, server, "ann")
    finish(boss)
    assert [r["input"][0] for r in boss.of("received", performative="propose")][:1]
    again = started(net, server, "ann")
    wait_until(lambda: any(r["input"][0] == "cat" for r in again.of("received")))
    assert not workers.of("activity", agent="bob", activity="Offer", what="done")
    again.stop()
    workers.stop()


# ---- a SPADE agent of somebody else ------------------------------------------------------------


class Outsider:
    """`outsider.py`, running."""

    def __init__(self, server: Server, name: str) -> None:
        import json

        self.json = json
        self.process = subprocess.Popen(
            [
                *(sys.executable, "tests/platforms/outsider.py"),
                *("127.0.0.1", str(server.port), f"{name}@localhost"),
            ],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )
        self.heard: list[dict[str, Any]] = []
        assert self.process.stdout is not None
        self.thread = threading.Thread(target=self._read, daemon=True)
        self.thread.start()
        wait_until(lambda: self.heard)
        self.heard.clear()

    def _read(self) -> None:
        assert self.process.stdout is not None
        for text in self.process.stdout:
            self.heard.append(self.json.loads(text))

    def say(self, to: str, metadata: dict[str, str], body: str) -> None:
        assert self.process.stdin is not None
        line = self.json.dumps({"to": to, "metadata": metadata, "body": body})
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()

    def close(self) -> None:
        self.process.kill()
        self.process.wait()
        self.thread.join()
        assert self.process.stdin is not None and self.process.stdout is not None
        self.process.stdin.close()
        self.process.stdout.close()


@pytest.fixture
def alice(server: Server) -> Iterator[Outsider]:
    found = Outsider(server, "alice")
    yield found
    found.close()


def test_a_hand_written_agent_talks_with_ours(net: Generated, server: Server, alice: Outsider) -> None:
    bob = started(net, server, "bob")
    wait_until(lambda: bob.team.transport.state.link._platform.here())  # type: ignore[attr-defined]
    cfp = {"performative": "cfp", "protocol": "net", "conversation-id": "c1", "reply-with": "q1"}
    alice.say("bob@localhost", cfp, '{"n": 3}')
    wait_until(lambda: alice.heard)
    (answer,) = alice.heard
    assert answer["from"].startswith("bob@localhost/")
    assert answer["body"] == '{"cost": 0}'
    said = answer["metadata"]
    assert (said["performative"], said["conversation-id"], said["protocol"]) == ("propose", "c1", "net")
    assert (said["in-reply-to"], said["ontology"], said["language"]) == ("q1", "Net", "json")
    assert said["reply-with"]
    # The same once more is no second message; nonsense is answered; somebody else's words, too.
    alice.say("bob@localhost", cfp, '{"n": 3}')
    for metadata, body, reason in (
        ({"performative": "shout"}, "{}", "FIPA has no performative shout"),
        ({"performative": "cfp", "protocol": "net", "reply-with": "q2"}, "{", "the content is not JSON"),
        ({"performative": "cfp", "protocol": "net", "reply-with": "q3"}, '{"m": 1}', "has no member m"),
        ({"performative": "cfp", "aseme": '{"kind": 1}', "reply-with": "q4"}, "{}", "none of the team"),
        ({}, "hello", "FIPA has no performative"),
    ):
        alice.heard.clear()
        alice.say("bob@localhost", metadata, body)
        wait_until(lambda: alice.heard)
        assert alice.heard[0]["metadata"]["performative"] == "not-understood"
        assert reason in alice.heard[0]["body"]
    bob.stop()
    assert any(r["reason"] == "it was received before" for r in bob.of("unexpected"))
    assert len(bob.of("received")) == 1
    assert "alice@localhost untrusted" in bob.news()


def test_what_cannot_be_brought_to_an_outsider_is_told(
    net: Generated, server: Server, alice: Outsider
) -> None:
    """Prosody says so; SPADE's own server stores it for whenever somebody of that name comes."""
    bob = started(net, server, "bob")
    wait_until(lambda: bob.team.transport.state.link._platform.here())  # type: ignore[attr-defined]
    cfp = {"performative": "cfp", "protocol": "net", "reply-to": "nobody@localhost", "reply-with": "q1"}
    alice.say("bob@localhost", cfp, '{"n": 3}')
    wait_until(lambda: bob.of("agent_message"))
    if server.kind == "prosody":
        wait_until(lambda: any("could not be brought to nobody@localhost" in str(r) for r in bob.of("fault")))
    bob.stop()


# ---- what does not begin -----------------------------------------------------------------------


def test_a_server_that_is_not_there_is_said(net: Generated, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("aseme_dsl.runtime.platform.over_spade.START", 1.0)
    nowhere = Server("embedded")
    with own_port() as nowhere.port:
        found = started(net, nowhere, "bob")
        place = f"127.0.0.1:{nowhere.port}"
        with pytest.raises(Exception, match=f"cannot be connected with the XMPP server {place}"):
            finish(found)
    nowhere.close()


def test_a_wrong_password_is_said_at_once(net: Generated, server: Server) -> None:
    first = started(net, server, "bob")
    wait_until(lambda: first.team.transport.state.link._platform.here())  # type: ignore[attr-defined]
    first.stop()
    wrong = PlatformLink(SpadePlatform(server.settings(password="other"), NAMES), "Net", NAMES)
    found = part(net, ["bob"], {}, wrong).start()
    with pytest.raises(Exception, match="does not let bob@localhost in with this password"):
        finish(found)


def test_a_certificate_that_nobody_trusts_is_refused(net: Generated, server: Server) -> None:
    found = part(
        net, ["bob"], {}, PlatformLink(SpadePlatform(server.settings(verify=True), NAMES), "Net", NAMES)
    ).start()
    with pytest.raises(Exception, match="its certificate is not trusted"):
        finish(found)


def test_the_certificate_of_the_project_is_trusted(net: Generated, server: Server) -> None:
    if server.kind != "prosody":
        pytest.skip("the embedded server makes its own, and nobody else knows it")
    settings = server.settings(verify=True, authority=server.folder / "localhost.crt")
    found = part(net, ["bob"], {}, PlatformLink(SpadePlatform(settings, NAMES), "Net", NAMES)).start()
    wait_until(lambda: found.team.transport.state.link._platform.here())  # type: ignore[attr-defined]
    found.stop()


def test_two_names_that_xmpp_does_not_tell_apart() -> None:
    with pytest.raises(TransportError, match="bob and Bob would have one account, bob@localhost"):
        SpadePlatform(Server("embedded").settings(), ("bob", "Bob"))


# ---- the embedded server -----------------------------------------------------------------------


@line("team", "`--platform spade` without a `host`")
def test_the_embedded_server_is_on_the_loopback_interface_alone_and_leaves_nothing(server: Server) -> None:
    assert server.process is not None
    process = psutil.Process(server.process.pid)
    if server.kind == "embedded":
        addresses = {item.laddr.ip for item in process.net_connections() if item.status == "LISTEN"}
        assert addresses == {"127.0.0.1"}
        assert process.children(recursive=True) == []
    server.stop(signal.SIGKILL)
    with socket.create_server(("127.0.0.1", server.port)):
        pass  # nobody holds its port


def test_the_embedded_server_ends_with_its_standard_input(server: Server) -> None:
    if server.kind != "embedded":
        pytest.skip("only of the embedded server")
    process = server.process
    assert process is not None and process.stdin is not None
    process.stdin.close()
    assert process.wait(LONG) == 0


def test_spades_event_loop_policy_is_not_left_behind(net: Generated, server: Server) -> None:
    before = asyncio.get_event_loop_policy()
    bob = started(net, server, "bob")
    wait_until(lambda: bob.team.transport.state.link._platform.here())  # type: ignore[attr-defined]
    bob.stop()
    assert asyncio.get_event_loop_policy() is before
