"""Transport: what carries messages between agents that run in different processes.

The bus and the conversations know only the interface in `port`. It has two implementations. `LOCAL` is for a
team in one process, where there is nothing to carry. `reliable_delivery`, with its parts in `delivery`, turns
messages into envelopes (`envelope`) and hands these to a `Link`; `over_zenoh` is the link for networks. No
envelope is lost, duplicated or reordered (`stream`).
"""

from __future__ import annotations

from aseme_dsl.runtime.transport.port import LOCAL, Peer, Transport, TransportError
from aseme_dsl.runtime.transport.settings import Access, Network, Tls

__all__ = ["LOCAL", "Access", "Network", "Peer", "Tls", "Transport", "TransportError"]
