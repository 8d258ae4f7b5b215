"""A second process of an agent that ends at once: the first one does not run on without its team."""

from __future__ import annotations

import threading
import time
from unittest import mock

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.transport import Network
from aseme_dsl.runtime.transport import envelope as envelopes
from aseme_dsl.runtime.transport.envelope import Envelope
from aseme_dsl.runtime.transport.link import Stamp
from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
from tests.runtime.transport.net import part
from tests.support.generated import generate
from tests.support.network import own_name
from tests.support.waiting import LONG, wait_until

pytest.importorskip("zenoh")
WIRE = own_name("Wire")
TEXT = """
system Wire
message M { int n }
topic team { signal M queued }
srm Speaker { liveness { Speaker = Say~ } activities { Say every 50ms writes team.signal.M } }
srm Ear { liveness { Ear = Hear } activities { Hear reads team.signal.M } }
team T { ann : Speaker  bob : Ear }
"""


def test_an_agent_whose_newer_process_has_ended_ends_too() -> None:
    made = generate(TEXT)
    over = threading.Event()

    class Say:
        def execute(self, context: Context) -> None:
            context.publish("team.signal.M", made.message("M", n=1))

    class Hear:
        def execute(self, context: Context) -> None:
            over.wait(LONG)

    activities = {"Say": Say, "Hear": Hear}
    bob, ann = (
        part(made, [name], activities, ZenohLink(WIRE, Network(lease_ms=500))).start()
        for name in ("bob", "ann")
    )
    newer, hears, life = ZenohLink(WIRE, Network(lease_ms=500)), mock.Mock(), time.time_ns()
    hears.asked.return_value = []  # it ends before it answers ann
    try:
        wait_until(lambda: len(bob.of("arrived")) > 5)
        newer.open(("ann",), life, hears)

        def followed() -> bool:
            """Whether bob follows it."""
            lives = [call.args[1] for call in hears.appeared.mock_calls if call.args[0] == "bob"]
            for bobs in lives:
                ping = Envelope(envelopes.PING, incarnation=life)
                newer.send("bob", "ann", "ping", ping, Stamp(bobs), b"", True)
            return "restarted" in [record["what"] for record in bob.of("peer", peer="ann")]

        wait_until(followed, pause=0.1)
        newer.close()
        wait_until(lambda: ann.result is not None)
        assert ann.result is not None and ann.result.reason == "outlived"
        assert ann.of("peer", what="outlived")
    finally:
        over.set()
        newer.close()
        for one in (bob, ann):
            one.stop()
