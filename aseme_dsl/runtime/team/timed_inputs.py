"""TimedInput inputs: messages and events that agents are given at set moments, from JSON lines or a test.

One line is an object:

    {"at": "1.5s", "agent": "robot1", "channel": "vision.state.Ball", "message": {"visible": true}}
    {"at": "2s", "event": "Bumped"}

`at` is a duration as in a document, or whole nanoseconds (a millisecond or more). Without `agent` every agent
of the team that reads the channel is given it; `sender` says whose message it is to be (for `host.`
conditions).
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from decimal import Decimal

from aseme_dsl import outside
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.as_json import from_json

_UNITS = {"ns": 1, "us": 1_000, "ms": 1_000_000, "s": 1_000_000_000, "min": 60_000_000_000}
_MEMBERS = {"at", "agent", "channel", "message", "event", "sender"}
_LEAST = 1_000_000
"""The smallest number of nanoseconds that needs no unit: a smaller one is rather meant in seconds."""


class InputFileError(ValueError):
    """Lines of a script mean nothing; the text says which and why, `lines` the same by their numbers."""

    def __init__(self, lines: Mapping[int, str]) -> None:
        super().__init__("\n".join(f"line {number}: {text}" for number, text in lines.items()))
        self.lines = lines


@dataclass(frozen=True, slots=True)
class TimedInput:
    """A message on a channel, or an event, for one agent or (None) for all, at a moment in ns."""

    at: int
    agent: str | None
    channel: str = ""
    message: object = None
    event: str = ""
    sender: str = "input"


def duration(text: str) -> int:
    """A duration as in a document (`200ms`, `1.5s`) in ns. Raises ValueError for anything else."""
    match = re.fullmatch(r"(\d+(?:\.\d+)?)\s*(ns|us|ms|s|min)", text.strip())
    if match is None:
        raise ValueError(f"{text!r} is not a duration: it is written like 200ms or 1.5s")
    return int(Decimal(match[1]) * _UNITS[match[2]])


def read_inputs(lines: Iterable[str], messages: Mapping[str, object]) -> tuple[TimedInput, ...]:
    """The inputs of a script; `messages` are the classes by name. Empty lines are passed over.

    Raises:
        InputFileError: a line means nothing; all such lines are named.
    """
    found: list[TimedInput] = []
    errors: dict[int, str] = {}
    for number, line in enumerate(lines, 1):
        if line.strip():
            try:
                found.append(_read(line, messages))
            except ValueError as error:
                errors[number] = str(error)
    if errors:
        raise InputFileError(errors)
    return tuple(found)


def _read(line: str, messages: Mapping[str, object]) -> TimedInput:
    try:
        data = outside.loads(line)
    except json.JSONDecodeError as error:
        raise ValueError(f"not JSON: {error.msg} at column {error.colno}") from error
    if not isinstance(data, dict):
        raise ValueError("an object is wanted")
    strangers = sorted(set(data) - _MEMBERS)
    if strangers:
        raise ValueError(f"unknown member {strangers[0]!r}; there are {', '.join(sorted(_MEMBERS))}")
    moment = data.get("at", 0)
    if isinstance(moment, str):
        moment = duration(moment)
    if not isinstance(moment, int) or isinstance(moment, bool) or moment < 0:
        raise ValueError(f'`at` is a duration like "1.5s" or whole ns, not {moment!r}')
    if isinstance(data.get("at"), int) and 0 < moment < _LEAST:
        raise ValueError(f'`at` without a unit is in ns: write "{moment}s", "{moment}ms" or "{moment}ns"')
    for name in ("agent", "channel", "event", "sender"):
        if not isinstance(data.get(name, ""), str):
            raise ValueError(f"`{name}` is a text, not {data[name]!r}")
    agent = data.get("agent")
    if "event" in data:
        if "channel" in data or "message" in data:
            raise ValueError("a line gives a message on a channel, or an event, not both")
        return TimedInput(moment, agent, event=data["event"])
    if "channel" not in data:
        raise ValueError("a `channel` with a `message`, or an `event`, is wanted")
    channel = data["channel"]
    kind = messages.get(channel.rpartition(".")[2])
    if channel.count(".") != 2 or kind is None:
        known = ", ".join(sorted(messages)) or "none"
        raise ValueError(
            f"{channel!r} is not a channel: written like vision.state.Ball, with a message of {known}"
        )
    message = from_json(kind, data.get("message", {}))
    return TimedInput(moment, agent, channel, message, sender=data.get("sender", "input"))
