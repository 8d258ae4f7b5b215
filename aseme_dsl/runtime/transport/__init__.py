"""Transport: what carries messages between agents that run in different processes.

The bus and the conversations know only the port in `port`; with `LOCAL` everybody is in one process and there
is nothing to carry. `reliable_delivery` is the port's other implementation, with its parts in `delivery`: it
turns messages into envelopes (`envelope`), sees to it that none is lost, doubled or overtaken (`stream`), and
hands them to a `Link`, of which `over_zenoh` is the real one.
"""

from __future__ import annotations

from aseme_dsl.runtime.transport.port import LOCAL, Peer, Transport, TransportError
from aseme_dsl.runtime.transport.settings import Access, Network, Tls

__all__ = ["LOCAL", "Access", "Network", "Peer", "Tls", "Transport", "TransportError"]
