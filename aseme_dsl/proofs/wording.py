"""Wording: how numbers stand in answers."""

from __future__ import annotations


def states_text(count: int) -> str:
    """`1 state`, `76 states`."""
    return f"{count} state" if count == 1 else f"{count} states"


__all__ = ["states_text"]
