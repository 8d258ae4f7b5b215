"""Agents written by hand in SPADE and mango, with nothing of ours, play each role of each protocol."""

from __future__ import annotations

import gc
import importlib.util
import json
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from typing import Any

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.platform.over_platform import PlatformLink
from aseme_dsl.runtime.transport.link import Link
from aseme_dsl.runtime.transport.settings import Mango
from tests.platforms.by_hand import ROLES
from tests.platforms.servers import Server
from tests.runtime.transport.net import Part, part
from tests.stdlib.hostile import ENDINGS
from tests.stdlib.library import PROTOCOLS, Act, act, kind_of
from tests.support.generated import Generated, generate
from tests.support.network import own_port
from tests.support.waiting import LONG, wait_until

AWAIT_PROPOSAL = {"CollectProposals", "CollectOffers"}
"""What lasts until a proposal has come."""
OTHERWISE = {
    "OpenAuction": act(lot="fish", price=10.0),
    "DecideOffer": act(interested=True),
    "ReadNews": act(withdrawn=True),
}
"""What goes otherwise than in the library's tests: the first offer is enough, and so is the first news."""
HOSTILE = (
    "request.responder",
    "query.initiator",
    "contract_net.manager",
    "contract_net.contractor",
    "subscribe.responder",
    "auction.bidder",
    "propose.responder",
    "brokering.provider",
    "recruiting.provider",
    "recruiting.recruiter",
)
"""The roles of agents by hand that do not keep to the protocol. In one process there are all of them."""
FAST = 0.05
"""How long, in seconds, anything else lasts at the most."""


def test_each_role_of_the_library_is_there() -> None:
    assert {f"{item.name}.{part}" for item in PROTOCOLS for part in item.parts.values()} == set(ROLES)


def acting(
    generated: Generated, acts: dict[str, Act], first: str, role: str, ours: list[Part]
) -> dict[str, type[Any]]:
    """The activities of our parts: as in the library's tests, but quick, and they wait for the other."""

    def kind(name: str, what: Act) -> type[Any]:
        usual = kind_of(generated, name, replace(OTHERWISE.get(name, what), takes=0.0))

        class Activity(usual):  # type: ignore[misc]
            def execute(self, context: Context) -> None:
                if name == first or (name == "ChooseProvider" and role.endswith(".provider")):
                    while ("", 1) not in ROLES[role] and not context.directory.search(role):
                        context.wait(0.02)
                if name == "ChooseProvider" and role.endswith(".provider"):
                    context.set_variable("found", True)
                    context.set_variable("chosen", context.directory.search(role)[0].name)
                    return
                number = len(ours[0].of("agent_message", performative="cfp"))
                while name in AWAIT_PROPOSAL and len(ours[0].of("received", performative="propose")) < number:
                    context.wait(0.02)
                context.wait(FAST)
                super().execute(context)

        return Activity

    return {name: kind(name, what) for name, what in acts.items()}


@contextmanager
def by_hand(script: str, *arguments: str) -> Iterator[Callable[[], dict[str, Any]]]:
    """An agent in a process of its own; gives what it says at the end."""
    process = subprocess.Popen(
        [sys.executable, f"tests/platforms/{script}", *arguments],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None and process.stdin is not None
    lines: list[str] = []
    out = process.stdout
    thread = threading.Thread(target=lambda: lines.extend(out), daemon=True)
    thread.start()

    def said() -> dict[str, Any]:
        wait_until(lambda: bool(lines) or process.poll() is not None)
        found: dict[str, Any] = json.loads(lines[0])
        return found

    try:
        yield said
    finally:
        process.stdin.close()
        if not lines:  # its part is not over: it would go on
            process.kill()
        try:
            process.wait(LONG)
        finally:
            process.kill()
            thread.join(LONG)
            process.stdout.close()


def completes(
    role: str, link: Callable[[list[str]], Link], start: Callable[[dict[str, str], str], Any]
) -> None:
    """Our agents of a protocol with one by hand: the conversation takes place as the protocol has it."""
    team, found = played(role, link, start, "honest")
    assert found["refused"] == ""
    assert team.of("unexpected") == []
    assert [r for r in team.of("fault") if "code" not in r] == []
    # An agent by hand that has the last word has no message that says so.
    assert endings(team) <= {"DONE", "CANCELLED", "RETURNED", "UNCONFIRMED"}
    heard = [act for act in found["heard"] if act not in ("agree", "inform")]
    awaited = [act for act, _ in ROLES[role] if act not in ("", "agree", "inform")]
    assert heard == awaited or set(awaited) <= set(heard)


def endings(team: Part) -> set[str]:
    texts = [record["text"] for record in team.of("log")]
    return {text.removeprefix("ended ") for text in texts if text.startswith("ended ")}


def played(
    role: str, link: Callable[[list[str]], Link], start: Callable[[dict[str, str], str], Any], way: str
) -> tuple[Part, dict[str, Any]]:
    """Our agents with one by hand, to the end of all their parts; and what an honest one has heard."""
    name, _, theirs = role.partition(".")
    item = next(item for item in PROTOCOLS if item.name == name)
    parts = {part: agent for agent, part in reversed(item.parts.items()) if part != theirs}
    made = generate(replace(item, parts={agent: part for part, agent in parts.items()}).text())
    known = {node.activity for chart in made.charts.values() for node in chart.PLAN.states if node.activity}
    acts = {activity: what for activity, what in item.acts.items() if activity in known}
    ours: list[Part] = []
    agents = list(parts.values())
    ours.append(part(made, agents, acting(made, acts, item.first, role, ours), link(agents)))
    team = ours[0].start()
    try:
        wait_until(lambda: team.error or team.post.state.gate.is_set())
        with start(parts, agents[0]) as said:
            found = said() if way == "honest" else {}
            wait_until(lambda: team.error or all(_has_ended(team, agent) for agent in agents))
    finally:
        team.stop()
    return team, found


def _has_ended(team: Part, agent: str) -> bool:
    parts = team.of("conversation", agent=agent)
    return bool(parts) and parts[-1]["what"] == "leave"


def in_spade(server: Server, role: str, way: str) -> tuple[Any, Any]:
    """How our agents are linked over SPADE, and how the one by hand is started."""
    from aseme_dsl.runtime.platform.over_spade import SpadePlatform

    name = f"hand-{way}-" + role.replace(".", "-").replace("_", "-")

    def link(agents: list[str]) -> Link:
        settings = server.settings(account=f"{name}-ROBOT")
        return PlatformLink(SpadePlatform(settings, agents), "T", agents)

    def start(parts: dict[str, str], first: str) -> Any:
        addresses = {part: f"{name}-{agent}@localhost" for part, agent in parts.items()}
        directory = f"{name}-{first}@localhost"
        arguments = (str(server.port), f"{name}@localhost", role, json.dumps(addresses), directory, way)
        return by_hand("by_hand_spade.py", *arguments)

    return link, start


@pytest.mark.parametrize("role", ROLES)
def test_in_spade(role: str, spade_server: Server) -> None:
    completes(role, *in_spade(spade_server, role, "honest"))


@pytest.mark.parametrize("way", ["twice", "early", "lying"])
@pytest.mark.parametrize("role", HOSTILE)
def test_a_hostile_agent_in_spade(role: str, way: str, spade_server: Server) -> None:
    """Our agents' parts end, as their protocol has it; who only lies besides changes nothing.

    But where answers are counted, a message that means nothing is one.
    """
    team, _ = played(role, *in_spade(spade_server, role, way), way)
    assert team.of("error") == []
    ends = endings(team)
    assert ends and ends <= set(ENDINGS[1:])
    if way == "lying":
        counted = {"NOBODY"} if role.endswith((".contractor", ".bidder")) else set()
        assert ends <= {"DONE", "CANCELLED", "RETURNED", "UNCONFIRMED"} | counted
        assert team.of("unexpected") != []


# A container of mango that ends leaves open what others have connected to it.
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize("role", ROLES)
def test_in_mango(role: str) -> None:
    if importlib.util.find_spec("mango") is None:
        pytest.skip("mango is not installed: python3 dev.py long")
    from aseme_dsl.runtime.platform.over_mango import MangoPlatform

    with ExitStack() as taken:
        place = ("127.0.0.1", taken.enter_context(own_port()))

        def link(agents: list[str]) -> Link:
            return PlatformLink(MangoPlatform(Mango(dict.fromkeys(agents, place)), agents), "T", agents)

        def start(parts: dict[str, str], first: str) -> Any:
            addresses = {part: f"{place[0]}:{place[1]}/{agent}" for part, agent in parts.items()}
            directory = f"{place[0]}:{place[1]}/{first}"
            return by_hand("by_hand_mango.py", "hand", role, json.dumps(addresses), directory)

        completes(role, link, start)
    gc.collect()


@pytest.fixture(scope="module")
def spade_server() -> Iterator[Server]:
    if importlib.util.find_spec("spade") is None:
        pytest.skip("SPADE is not installed: python3 dev.py long")
    found = Server("embedded")
    try:
        yield found.start()
    finally:
        found.close()
