"""Messages between behaviours of agents in different processes: text and messages, once and in order."""

from __future__ import annotations

from typing import Any

import pytest

from aseme_dsl.backends.jade_like import BACKEND
from aseme_dsl.runtime.jade import ACLMessage, CyclicBehaviour, MessageTemplate, OneShotBehaviour
from aseme_dsl.runtime.platform.over_platform import PlatformLink
from aseme_dsl.runtime.transport import Network
from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
from tests.runtime.platform.square import Square
from tests.runtime.transport.net import Air, Part, part
from tests.support.generated import Generated, generate
from tests.support.network import own_name
from tests.support.waiting import LONG, wait_until

TEAM = """
system Free
message Price { int euros }
srm asks {
  liveness { asks = Live . End }
  activities { Live takes 10ms  End takes 10ms }
  control asks { enter End : stop }
}
srm answers {
  liveness { answers = Live . End }
  activities { Live takes 10ms  End takes 10ms }
  control answers { enter End : stop }
}
srm silent {
  liveness { silent = Live . End }
  activities { Live takes 10ms  End takes 10ms }
  control silent { enter End : stop }
}
team Free { ann : asks  bob : answers  cat : silent }
"""
MANY = 10


@pytest.fixture(scope="module")
def free() -> Generated:
    return generate(TEAM, backend=BACKEND)


@pytest.fixture(params=["air", "platform", "zenoh"])
def links(request: pytest.FixtureRequest) -> Any:
    if request.param == "air":
        return Air(1, loss=0.2, doubling=0.2, delay=0.002).link
    if request.param == "platform":
        team = ("ann", "bob", "cat")
        square = Square(team)
        return lambda: PlatformLink(square.platform(), "Free", team, lease=LONG)
    pytest.importorskip("zenoh")
    name = own_name("Free")
    return lambda: ZenohLink(name, Network(lease_ms=round(1000 * LONG)))


class Ask(OneShotBehaviour):
    def action(self) -> Any:
        for number in range(MANY):
            asked = self.send(ACLMessage("query_ref", f"{number} äé", ("bob",), conversation_id="c"))
            answer = MessageTemplate.match_in_reply_to(asked.reply_with)
            message = yield from self.blocking_receive(answer)
            self.log(f"{message.content.euros} {message.ontology} {message.conversation_id}")
        self.send(ACLMessage("inform", "anybody?", ("cat",)))
        message = yield from self.blocking_receive()
        self.log(f"{message.performative} {message.content} of {message.sender}")


def logs(of: Part) -> list[str]:
    return [str(r["text"]) for r in of.of("log")]


def test_behaviours_talk_between_processes(free: Generated, links: Any) -> None:
    price = free.messages.Price

    class Answer(CyclicBehaviour):
        def action(self) -> Any:
            message = yield from self.blocking_receive()
            self.log(message.content)
            self.send(message.create_reply("inform", price(euros=int(message.content.split()[0]))))

    def own(role: str, kind: type[Any]) -> dict[str, type[Any]]:
        generated: Any = free.package.AGENTS[role]
        setup = {"setup": lambda agent: agent.add_behaviour(kind())}
        return {generated.own: type(generated.own, (generated,), setup)}

    found = {**own("asks", Ask), **own("answers", Answer)}
    ann = part(free, ["ann"], found, links()).start()
    rest = part(free, ["bob", "cat"], found, links()).start()
    wait_until(lambda: len(logs(ann)) > MANY)
    ann.stop()
    rest.stop()
    assert logs(rest) == [f"{number} äé" for number in range(MANY)]
    assert logs(ann) == [f"{number} Free c" for number in range(MANY)] + ["not_understood anybody? of cat"]
    assert not ann.of("fault") + rest.of("fault")
