"""Large messages: those that would hold up signals are refused to their sender."""

from __future__ import annotations

import threading

import pytest

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.transport import Network
from aseme_dsl.runtime.transport.over_zenoh import ZenohLink
from aseme_dsl.runtime.transport.settings import LARGEST, LARGEST_IN_ORDER
from tests.runtime.transport.net import part
from tests.support.generated import generate
from tests.support.network import own_name
from tests.support.waiting import LONG, wait_until

pytest.importorskip("zenoh")
WIRE = own_name("Wire")
LOADED = """
system Wire
message M { int n }
message Load { bytes load }
topic team { signal M queued  state Load  data Load }
srm Speaker {
  liveness { Speaker = Say }
  activities { Say writes team.signal.M, team.state.Load, team.data.Load }
}
srm Ear { liveness { Ear = Hear } activities { Hear reads team.signal.M, team.state.Load, team.data.Load } }
team T { ann : Speaker  bob : Ear }
"""


def test_messages_that_would_hold_up_signals_are_refused_to_their_sender() -> None:
    """(finding O7)"""
    made = generate(LOADED)
    over = threading.Event()
    load = made.messages.Load

    class Say:
        def execute(self, context: Context) -> None:
            context.publish("team.data.Load", load(load=bytes(LARGEST + 1)))
            context.publish("team.state.Load", load(load=bytes(LARGEST_IN_ORDER + 1)))
            for way in ("data", "state"):
                context.publish(f"team.{way}.Load", load(load=bytes(LARGEST_IN_ORDER - 100)))
            context.publish("team.signal.M", made.message("M", n=1))
            over.wait(LONG)

    class Hear:
        def execute(self, context: Context) -> None:
            over.wait(LONG)

    parts = [
        part(made, [name], {"Say": Say, "Hear": Hear}, ZenohLink(WIRE, Network())).start()
        for name in ("bob", "ann")
    ]
    bob, ann = parts
    try:
        wait_until(lambda: bool(bob.of("arrived", channel="team.signal.M")))
    finally:
        over.set()
        for one in parts:
            one.stop()
    reasons = sorted(record["reason"] for record in ann.of("fault"))
    assert len(reasons) == 2
    assert reasons[0].startswith("team.data.Load cannot be sent to other robots: it has 83886")
    assert reasons[1].endswith(f"at the most {LARGEST_IN_ORDER} travel here, unless as data")
    assert len(bob.of("arrived", channel="team.state.Load")) == 1
