"""Messages of Warehouse. Generated: a change here is lost with the next build.

From a.aseme.
"""

from __future__ import annotations

import dataclasses

from aseme_dsl.runtime.message import wire


@dataclasses.dataclass(frozen=True, slots=True)
class Place:
    """a.aseme:3:9"""

    x: float = 0.0
    y: float = 0.0

    def __post_init__(self) -> None:
        wire.check(self)


@dataclasses.dataclass(frozen=True, slots=True)
class Order:
    """a.aseme:4:9"""

    id: int = 0
    item: str = ""
    place: Place = dataclasses.field(default_factory=Place)

    def __post_init__(self) -> None:
        wire.check(self)


CHANNELS: dict[str, type[object]] = {
    "desk.signal.Order": Order,
    "gate.state.Order": Order,
}
"""The class of the messages of each channel."""

_DESCRIPTORS = """
CocBCg9XYXJlaG91c2UucHJvdG8SCXdhcmVob3VzZSIdCgVQbGFjZRIJCgF4GAEgASgBEgkKAXkY
AiABKAEiQgoFT3JkZXISCgoCaWQYASABKAMSDAoEaXRlbRgCIAEoCRIfCgVwbGFjZRgDIAEoCzIQ
LndhcmVob3VzZS5QbGFjZWIGcHJvdG8z
"""

SCHEMA = wire.Schema(
    descriptors=_DESCRIPTORS,
    classes={
        Place: "warehouse.Place",
        Order: "warehouse.Order",
    },
    channels=CHANNELS,
    radio={},
)
"""How messages become bytes."""
