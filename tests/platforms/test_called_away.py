"""Over SPADE and mango conversations are suspended, go on, are discarded, and are lost."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path

import pytest

from aseme_dsl.runtime.platform.over_platform import PlatformLink
from aseme_dsl.runtime.transport.link import Link
from aseme_dsl.runtime.transport.settings import Mango
from tests.faults.kitchen import DISCARDING, NAMES, TEXT, Gates
from tests.platforms.conftest import xmpp_server
from tests.runtime.transport.net import Part, part
from tests.support.generated import generate
from tests.support.network import own_port
from tests.support.waiting import LONG, wait_until

Links = Callable[[], Link]


@pytest.fixture(params=["embedded", "prosody", "mango"])
def links(request: pytest.FixtureRequest) -> Iterator[Links]:
    """How each part is linked with the others: over SPADE with one server or another, or over mango."""
    if request.param == "mango":
        pytest.importorskip("mango", reason="mango is not installed: python3 dev.py long")
        from aseme_dsl.runtime.platform.over_mango import MangoPlatform

        with ExitStack() as taken:
            hosts = {name: ("127.0.0.1", taken.enter_context(own_port())) for name in NAMES}
            yield lambda: PlatformLink(MangoPlatform(Mango(hosts), NAMES), "Kitchen", NAMES, lease=2.0)
        return
    with xmpp_server(request.param) as server:
        from aseme_dsl.runtime.platform.over_spade import SpadePlatform

        yield lambda: PlatformLink(SpadePlatform(server.settings(), NAMES), "Kitchen", NAMES)


class Kitchen:
    """A waiter and a cook, each a part of its own."""

    def __init__(self, links: Links, text: str, folder: Path) -> None:
        self.gates = Gates(folder)
        made = generate(text)
        parts = [part(made, [name], self.gates.activities(), links()) for name in NAMES]
        self.ann, self.bob = [item.start() for item in parts]

    def suspend(self) -> None:
        """The cook is called away with an order in its hands, and the waiter hurries it meanwhile."""
        wait_until(has_begun(self.bob, "Cook"))
        self.gates.open("Clock")
        wait_until(lambda: self.bob.of("conversation", what="suspend"))
        self.gates.open("Ask")
        wait_until(lambda: self.bob.of("received", performative="cancel"))

    def close(self) -> None:
        for item in (self.ann, self.bob):
            if item.thread is not None and item.thread.is_alive():
                item.team.driver.stop("test")
                item.thread.join(LONG)


def has_begun(of: Part, activity: str) -> Callable[[], object]:
    return lambda: of.error or of.of("activity", what="start", activity=activity)


@pytest.fixture
def kitchen(links: Links, tmp_path: Path) -> Iterator[Callable[[str], Kitchen]]:
    running: list[Kitchen] = []

    def start(text: str) -> Kitchen:
        running.append(Kitchen(links, text, tmp_path))
        return running[-1]

    yield start
    for item in running:
        item.close()


def test_a_suspended_conversation_goes_on(kitchen: Callable[[str], Kitchen]) -> None:
    found = kitchen(TEXT)
    found.suspend()
    found.gates.open("Charge", "Cook")
    wait_until(has_begun(found.ann, "Serve"))
    wait_until(has_begun(found.bob, "Sweep"))
    for item in (found.ann, found.bob):
        assert [item.of(kind) for kind in ("unexpected", "fault", "error", "lost")] == [[]] * 4
    assert [r["what"] for r in found.bob.of("conversation")][:4] == ["join", "suspend", "resume", "leave"]
    assert [r["performative"] for r in found.bob.of("agent_message")] == ["inform"]
    assert [r["performative"] for r in found.ann.of("agent_message")] == ["request", "cancel"]


def test_what_is_discarded_is_told_before_the_loss(kitchen: Callable[[str], Kitchen]) -> None:
    found = kitchen(DISCARDING)
    found.suspend()
    found.gates.open("Charge")
    wait_until(has_begun(found.ann, "Sorry"))
    wait_until(lambda: found.bob.of("conversation", what="leave"))
    assert not found.ann.of("activity", what="start", activity="Gone")
    assert [r["performative"] for r in found.bob.of("agent_message")] == ["failure"]
    assert [r["reason"] for r in found.bob.of("conversation", what="leave")] == ["left"]


def test_a_suspended_one_that_ends_is_lost(kitchen: Callable[[str], Kitchen]) -> None:
    found = kitchen(TEXT)
    found.suspend()
    found.bob.stop()
    wait_until(has_begun(found.ann, "Gone"))
    assert found.bob.of("agent_message") == []
