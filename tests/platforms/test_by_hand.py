"""Agents written by hand in SPADE and mango, with nothing of ours, play each role of each protocol."""

from __future__ import annotations

import gc
import importlib.util
import json
import re
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.platform.over_platform import PlatformLink
from aseme_dsl.runtime.transport.link import Link
from aseme_dsl.runtime.transport.settings import Mango
from tests.platforms.by_hand import ROLES, WAYS
from tests.platforms.servers import Server
from tests.runtime.playing import Played
from tests.runtime.transport.net import Part, part
from tests.stdlib.hostile import ENDINGS, ended, openers_of, received_by, sent_by, taken
from tests.stdlib.library import Act, Protocol, act, disagreement, kind_of, of_the_library, protocol
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
HOSTILE = tuple(way for way in WAYS if way != "honest")
SERVED_FOR_EVER = (("subscribe.initiator", "silent"), ("subscribe.initiator", "foreign"))
LIBRARY = Path(__file__).parents[2] / "stdlib"
QUICKER = 20
"""All deadlines of a protocol are so much shorter where an agent is hostile: it may not answer at all."""
LONGEST = 6000
"""The longest deadline then, in ms: an hour is none to wait for."""
PATIENT = 1.0
"""How long, in seconds, a collection waits for a proposal of a hostile agent."""
FAST = 0.05
"""How long, in seconds, anything else lasts at the most."""


def test_each_role_of_the_library_is_there() -> None:
    """Also those of a protocol that is new in the library."""
    assert set(ROLES) == {f"{aip.name}.{part.name}" for aip in of_the_library() for part in aip.participants}


def acting(
    generated: Generated, acts: dict[str, Act], first: str, role: str, ours: list[Part], way: str
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
                until = time.monotonic() + (LONG if way == "honest" else PATIENT)
                while name in AWAIT_PROPOSAL and len(ours[0].of("received", performative="propose")) < number:
                    context.wait(0.02)
                    if time.monotonic() > until:
                        break
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
        if not lines or arguments[-1] != "honest":  # its part is not over: it would go on
            process.kill()
        with suppress(subprocess.TimeoutExpired):  # SPADE may wait for a server that it cannot reach
            process.wait(10)
        process.kill()
        process.wait(LONG)
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


def quicker(item: Protocol) -> str:
    """The text of a protocol with the library in it, and with short deadlines."""

    def less(found: re.Match[str]) -> str:
        shorter = int(found[1]) * {"ms": 1, "s": 1000, "min": 60_000}[found[2]] // QUICKER
        return f"{min(shorter, LONGEST)}ms"

    library = (LIBRARY / f"{item.library}.aseme").read_text("utf-8")
    text = item.text().replace(f"import {item.library}\n", library)
    return re.sub(r"\b(\d+)(ms|s|min)\b", less, text)


def played(
    role: str, link: Callable[[list[str]], Link], start: Callable[[dict[str, str], str], Any], way: str
) -> tuple[Part, dict[str, Any]]:
    """Our agents with one by hand, to the end of all their parts; and what an honest one has heard."""
    name, _, theirs = role.partition(".")
    item = protocol(name)
    parts = {part: agent for agent, part in reversed(item.parts.items()) if part != theirs}
    mine = replace(item, parts={agent: part for part, agent in parts.items()})
    made = generate(mine.text() if way in ("honest", "lying") else quicker(mine))
    known = {node.activity for chart in made.charts.values() for node in chart.PLAN.states if node.activity}
    acts = {activity: what for activity, what in item.acts.items() if activity in known}
    ours: list[Part] = []
    agents = list(parts.values())
    activities = acting(made, acts, item.first, role, ours, way)
    ours.append(part(made, agents, activities, link(agents)))
    team = ours[0].start()
    begins = theirs == next(iter(item.parts.values()))
    first = agents[0] if begins else next(agent for agent in item.parts if agent in agents)
    try:
        wait_until(lambda: team.error or team.post.state.gate.is_set())
        with start(parts, agents[0]) as said:
            found = said() if way == "honest" else {}
            needed = agents if way == "honest" else [first]
            wait_until(lambda: team.error or all(_takes_part(team, agent) is False for agent in needed))
            # A hostile agent may leave others out.
            wait_until(lambda: team.error or not any(_takes_part(team, agent) for agent in agents))
    finally:
        team.stop()
    return team, found


def _takes_part(team: Part, agent: str) -> bool | None:
    """Whether an agent is in a conversation; None if it never was."""
    parts = team.of("conversation", agent=agent)
    return parts[-1]["what"] != "leave" if parts else None


def wrong_with(role: str, team: Part) -> list[str]:
    """What may not be, whatever an agent by hand does.

    Each part of ours ends with an ending of the protocol and they agree, for some ending of the other; what
    is taken from the other may be said by its part. Only a broker knows what both it has told.
    """
    name, _, theirs = role.partition(".")
    item = protocol(name)
    said = ended(team.records)
    found = [str(record) for kind in ("error", "crash") for record in team.of(kind)]
    found += [f"{agent} ends with {ending}" for agent, ending in said.items() if ending not in ENDINGS[1:]]
    took_part = {record["agent"] for record in team.of("conversation")}
    found += [f"{agent} does not say how it ends" for agent in sorted(took_part - set(said))]
    other = next(agent for agent, part in item.parts.items() if part == theirs)
    apart = [disagreement(item, {**said, other: ending}) for ending in ENDINGS]
    if "" not in apart and theirs != "broker":
        found.append(f"they disagree: {apart[0]}")
    assert team.result is not None
    for _, taker, sender, kind in taken(Played(team.team, team.result, team.records)):
        if sender not in item.parts:
            # What opens is the beginning of a conversation of its own, in which it has another part.
            said_by = [*sent_by(item, theirs), *openers_of(item)]
            allowed = kind in received_by(item, item.parts[taker]) and kind in said_by
            found += [] if allowed else [f"{taker} takes {kind} from {theirs}"]
    return found


@contextmanager
def in_spade(server: Server, role: str, way: str) -> Iterator[tuple[Any, Any]]:
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

    yield link, start


@contextmanager
def in_mango(role: str, way: str) -> Iterator[tuple[Any, Any]]:
    """The same over mango."""
    if importlib.util.find_spec("mango") is None:
        pytest.skip("mango is not installed: python3 dev.py long")
    from aseme_dsl.runtime.platform.over_mango import MangoPlatform

    with ExitStack() as taken_ports:
        place, theirs = [("127.0.0.1", taken_ports.enter_context(own_port())) for _ in range(2)]

        def link(agents: list[str]) -> Link:
            return PlatformLink(MangoPlatform(Mango(dict.fromkeys(agents, place)), agents), "T", agents)

        def start(parts: dict[str, str], first: str) -> Any:
            addresses = {part: f"{place[0]}:{place[1]}/{agent}" for part, agent in parts.items()}
            directory = f"{place[0]}:{place[1]}/{first}"
            arguments = (str(theirs[1]), "hand", role, json.dumps(addresses), directory, way)
            return by_hand("by_hand_mango.py", *arguments)

        yield link, start
    gc.collect()


@pytest.mark.parametrize("role", ROLES)
def test_in_spade(role: str, spade_server: Server) -> None:
    with in_spade(spade_server, role, "honest") as found:
        completes(role, *found)


# A container of mango that ends leaves open what others have connected to it.
@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize("role", ROLES)
def test_in_mango(role: str) -> None:
    with in_mango(role, "honest") as found:
        completes(role, *found)


def endures(role: str, way: str, link: Any, start: Any) -> None:
    """Our agents' parts end, as their protocol has it; who only lies besides changes nothing.

    But where answers are counted, a message that means nothing is one.
    """
    team, _ = played(role, link, start, way)
    assert wrong_with(role, team) == []
    if way == "lying":
        counted = {"NOBODY"} if role.endswith((".contractor", ".bidder")) else set()
        assert endings(team) <= {"DONE", "CANCELLED", "RETURNED", "UNCONFIRMED"} | counted
        assert team.of("unexpected") != []


@pytest.mark.parametrize("way", HOSTILE)
@pytest.mark.parametrize("role", ROLES)
def test_a_hostile_agent_in_spade(role: str, way: str, spade_server: Server) -> None:
    if (role, way) in (*SERVED_FOR_EVER, ("subscribe.initiator", "leaving")):  # SPADE's server keeps its mail
        pytest.skip("who never cancels is told for ever")
    with in_spade(spade_server, role, way) as found:
        endures(role, way, *found)


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
@pytest.mark.parametrize("way", HOSTILE)
@pytest.mark.parametrize("role", ROLES)
def test_a_hostile_agent_in_mango(role: str, way: str) -> None:
    if (role, way) in SERVED_FOR_EVER:
        pytest.skip("who never cancels is told for ever")
    with in_mango(role, way) as found:
        endures(role, way, *found)


@pytest.fixture(scope="module")
def spade_server() -> Iterator[Server]:
    if importlib.util.find_spec("spade") is None:
        pytest.skip("SPADE is not installed: python3 dev.py long")
    found = Server("embedded")
    try:
        yield found.start()
    finally:
        found.close()
