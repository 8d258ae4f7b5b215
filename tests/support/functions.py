"""Python functions that the texts of the tests call."""

from __future__ import annotations

from typing import Any


def bright(room: Any) -> bool:
    return bool(room.lux > 50)
