"""Teams over mango: conversations between containers that end and begin again, agents of others, nonsense."""

from __future__ import annotations

import asyncio
import json
import pickle
import socket
import struct
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import psutil
import pytest

pytest.importorskip("mango", reason="mango is not installed: python3 dev.py long")

import mango

from aseme_dsl.runtime.platform.over_mango import MangoPlatform
from aseme_dsl.runtime.platform.over_platform import PlatformLink
from aseme_dsl.runtime.team.team import TeamError
from aseme_dsl.runtime.transport.settings import Mango
from tests.runtime.transport.net import Part, part
from tests.runtime.transport.test_parts import NET, TEAM, Box
from tests.security.lines import line
from tests.support.generated import Generated, generate
from tests.support.network import own_port
from tests.support.traces import records_of
from tests.support.waiting import LONG, wait_until

NAMES = ("ann", "bob", "cat")


@pytest.fixture(scope="module")
def net() -> Generated:
    return generate(NET)


@pytest.fixture
def hosts() -> Iterator[dict[str, tuple[str, int]]]:
    with ExitStack() as taken:
        yield {name: ("127.0.0.1", taken.enter_context(own_port())) for name in NAMES}


@pytest.fixture
def started(hosts: dict[str, tuple[str, int]]) -> Iterator[Callable[..., Part]]:
    running: list[Part] = []

    def start(generated: Generated, *here: str, **activities: Any) -> Part:
        link = PlatformLink(MangoPlatform(Mango(hosts), NAMES), "Net", NAMES, lease=2.0)
        running.append(part(generated, here, activities, link).start())
        return running[-1]

    yield start
    for item in running:
        if item.thread is not None and item.thread.is_alive():
            item.team.driver.stop("test")
            item.thread.join(LONG)


def test_a_conversation(net: Generated, started: Callable[..., Part]) -> None:
    boss, bob, cat = started(net, "ann"), started(net, "bob"), started(net, "cat")
    boss.join()
    wait_until(lambda: bob.of("agent_message") and cat.of("agent_message"))
    assert boss.result is not None and boss.result.reason == "finished"
    assert boss.of("received", performative="propose")
    for item in (boss, bob, cat):
        assert not item.of("fault")


@line("team", "`--platform mango` without `hosts`")
def test_an_agent_listens_on_the_loopback_interface_alone(started: Callable[..., Part]) -> None:
    talk = generate(TEAM)
    box = Box(talk)
    ann = started(talk, "ann", **box.activities)
    bob = started(talk, "bob", **box.activities)
    wait_until(lambda: ann.team.transport.is_there("bob"))
    found = [item for item in psutil.Process().net_connections("inet") if item.status == "LISTEN"]
    assert len(found) == 2 and {item.laddr.ip for item in found} == {"127.0.0.1"}
    box.stop.set()
    bob.stop()


def test_who_ends_is_gone_at_once_and_who_comes_again_gets_what_waits(started: Callable[..., Part]) -> None:
    talk = generate(TEAM)
    box = Box(talk)
    ann = started(talk, "ann", **box.activities)
    bob = started(talk, "bob", **box.activities)
    wait_until(lambda: ann.team.transport.is_there("bob"))
    box.say += [("team.signal.M", n, None) for n in range(20)]
    wait_until(lambda: len(bob.of("arrived", channel="team.signal.M")) == 20)
    bob.stop()
    wait_until(lambda: not ann.team.transport.is_there("bob"))
    box.say += [("team.signal.M", n, None) for n in range(20, 40)]
    wait_until(lambda: len(ann.of("message", channel="team.signal.M")) == 40)
    again = started(talk, "bob", **box.activities)
    # A connection that mango keeps would take all of it, and bring none.
    wait_until(lambda: len(again.of("arrived", channel="team.signal.M")) == 20)
    box.stop.set()
    found = [r["message"]["n"] for r in again.of("arrived", channel="team.signal.M")]
    assert found == list(range(20, 40))


def test_agents_in_one_process_have_one_address(
    net: Generated, started: Callable[..., Part], hosts: dict[str, tuple[str, int]]
) -> None:
    with pytest.raises(TeamError, match=r"ann, bob are in one process.*--process-per-agent"):
        started(net, "ann", "bob").join()
    hosts["bob"] = hosts["ann"]
    both = started(net, "ann", "bob")
    wait_until(lambda: both.team.transport.state.link._platform._place)  # type: ignore[attr-defined]


class Theirs(mango.Agent):
    """An agent of somebody else."""

    def __init__(self) -> None:
        super().__init__()
        self.heard: list[tuple[Any, dict[str, Any]]] = []

    def handle_message(self, content: Any, meta: dict[str, Any]) -> None:
        self.heard.append((content, meta))


def test_a_mango_agent_of_somebody_else_talks_with_ours(
    net: Generated, started: Callable[..., Part], hosts: dict[str, tuple[str, int]]
) -> None:
    bob = started(net, "bob")
    wait_until(lambda: bob.team.transport.state.link._platform._place)  # type: ignore[attr-defined]
    said = {"protocol": "net", "conversation_id": "c1", "reply_with": "q1"}

    async def talk() -> list[tuple[Any, dict[str, Any]]]:
        container = mango.create_tcp_container(addr=("127.0.0.1", 0), codec=mango.JSON(), auto_port=True)
        alice = container.register(Theirs(), suggested_aid="alice")
        async with mango.activate(container):
            to = mango.AgentAddress(hosts["bob"], "bob")
            for performative, content, further in (
                (mango.Performatives.cfp, '{"n": 3}', said),
                (mango.Performatives.cfp, {"n": 4}, {**said, "conversation_id": "c2", "reply_with": "q2"}),
                (mango.Performatives.inform, "{}", {"protocol": "net", "reply_with": "q3"}),
            ):
                message = mango.create_acl(content, to, alice.addr, {"performative": performative, **further})
                assert await container.send_message(message, to, sender_id="alice")
            for _ in range(500):
                if len(alice.heard) >= 2:
                    break
                await asyncio.sleep(0.02)
        return alice.heard

    heard = asyncio.run(talk())
    bob.stop()
    answers = {meta["in_reply_to"]: (content, meta) for content, meta in heard}
    content, meta = answers["q1"]
    assert json.loads(content) == {"cost": 0}
    assert meta["performative"] is mango.Performatives.propose
    assert (meta["conversation_id"], meta["protocol"], meta["ontology"]) == ("c1", "net", "Net")
    content, meta = answers["q3"]
    assert meta["performative"] is mango.Performatives.not_understood
    assert "worker receives no inform" in json.loads(content)["reason"]


class Bomb:
    def __reduce__(self) -> Any:
        return exec, ("raise SystemExit('a pickle was opened')",)


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"\xff\xfe",
        b"[" * 1000,
        b'"text"',
        b"{}",
        b"null",
        b'{"__type__": [1, {}]}',
        b'{"__type__": 1}',
        json.dumps({"content": "x", "meta": {"receiver_id": "bob", "sender_addr": 1}}).encode(),
        pickle.dumps(Bomb()),
    ],
)
def test_nonsense_makes_nobody_deaf(
    net: Generated, started: Callable[..., Part], hosts: dict[str, tuple[str, int]], data: bytes
) -> None:
    bob = started(net, "bob")
    wait_until(lambda: bob.team.transport.state.link._platform._place)  # type: ignore[attr-defined]
    with socket.create_connection(hosts["bob"]) as wire:
        wire.sendall(struct.pack("!L", len(data)) + data)
    boss = started(net, "ann")
    boss.join()
    assert boss.of("received", performative="propose")


def test_what_our_conversations_raise_makes_nobody_deaf(
    net: Generated, started: Callable[..., Part], monkeypatch: pytest.MonkeyPatch
) -> None:
    bob = started(net, "bob")
    wait_until(lambda: bob.team.transport.state.link._platform._place)  # type: ignore[attr-defined]
    inbox, failed = bob.team.transport.inbox, []  # type: ignore[attr-defined]
    arrived = inbox.arrived

    def fails(*arguments: Any) -> None:
        if not failed:
            failed.append(arguments)
            raise RuntimeError("once")
        arrived(*arguments)

    monkeypatch.setattr(inbox, "arrived", fails)
    boss = started(net, "ann")
    boss.join()
    assert failed and boss.of("received", performative="propose")
    assert any("RuntimeError: once" in r["reason"] for r in bob.of("peer", what="unreadable"))


def test_a_name_that_mango_keeps_for_itself() -> None:
    platform = MangoPlatform(Mango({"agent1": ("127.0.0.1", 5)}), ("agent1",))
    assert platform.address_of("agent1") == "127.0.0.1:5/agent1_"
    assert platform.agent_at("127.0.0.1:5/agent1_") == "agent1"
    assert platform.agent_at("127.0.0.1:6/agent1_") is None


def test_a_team_in_one_process(tmp_path: Path) -> None:
    """Nothing said of addresses, as a newcomer runs it."""
    contract_net = Path(__file__).parents[1] / "acceptance" / "contract_net.aseme"
    command = [sys.executable, "-m", "aseme_dsl", "run", str(contract_net), "--platform", "mango"]
    done = subprocess.run(
        [*command, "--for", "2s", "-q", "-o", str(tmp_path)], capture_output=True, text=True, timeout=60
    )
    assert done.returncode == 0, done.stdout + done.stderr
    trace = records_of(tmp_path / "trace.jsonl.gz")
    said = {record["performative"] for record in trace if record["kind"] == "agent_message"}
    assert {"cfp", "refuse"} <= said
