"""Renamed: names that activities use and that were others before 0.1.0 (docs/project/renamed.md has all)."""

from __future__ import annotations

from collections.abc import Mapping

METHODS: Mapping[str, str] = {
    "check": "raise_if_cancelled",
    "latest": "latest_sample",
    "now": "now_ns",
    "received": "last_received",
    "set": "set_variable",
    "state": "latest_message",
    "take": "consume",
    "variable": "get_variable",
}
"""Of `Context`."""

_READ = "read latest_message latest_sample consume age history at interpolated mean".split()
ARGUMENTS: Mapping[tuple[str, str], str] = {
    ("publish", "host"): "to",
    ("send", "within"): "reply_within",
    **{(method, "host"): "sender" for method in _READ},
}
"""Of the methods of `Context`, by today's names of the methods."""

NAMES: Mapping[str, str] = {
    "Arrived": "Sample",
    "BodyLost": "BodyConnectionError",
    "Heard": "RadioMessage",
    "Mail": "AgentMessage",
    "ScriptError": "InputFileError",
    "Scripted": "TimedInput",
    "read_script": "read_inputs",
}
"""Of `aseme_dsl.runtime`."""

__all__ = ["ARGUMENTS", "METHODS", "NAMES"]
