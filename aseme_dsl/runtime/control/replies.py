"""Replies: the members of what a running team answers to its operator, with their types."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypedDict, cast

from aseme_dsl.runtime.control.usage import Usage


class AgentStatus(TypedDict):
    """What `status` says of an agent."""

    name: str
    role: str
    system: str
    model: str
    over: bool
    failure: str | None
    steps: int
    configuration: list[str]
    states: list[str]
    """The names of the configuration's states, as people call them."""
    activities: list[str]
    waiting: int
    """Inputs that wait for its next step."""
    unread: int
    """Agent messages that wait for it."""


class PeerStatus(TypedDict):
    """What a process knows of an agent that runs in another: counts of messages from it, and to it."""

    connected: bool
    model: str | None
    """The hash of the models that it follows; None until it has said that."""
    incompatible: list[str]
    """What does not work between its build and this one."""
    received: int
    refused: int
    rejected: int
    """By it: messages to it."""
    lost: int
    """To it."""
    dropped: int
    duplicated: int
    reordered: int
    unreadable: int
    late: int
    waiting: int
    """To it."""


class LogRecord(TypedDict):
    """A record of `logs`: its number, the time by the machine's clock (s since 1970), and what is traced."""

    number: int
    at: float
    record: dict[str, object]


class ClockDifference(TypedDict):
    """How much another machine's clock differs, and how wrong that may be, in ns; None if it is not known."""

    difference: int | None
    uncertainty: int | None


class EpochStatus(TypedDict):
    """The epoch that a process follows: its number, the hash of its version, the model of the build."""

    number: int
    hash: str
    base: str


class MissedEpoch(TypedDict):
    """A newer epoch that a process is held for, and why it cannot follow it yet."""

    number: int
    hash: str
    reasons: list[str]


class HeldSwap(TypedDict):
    """A swap that is under way."""

    id: int
    state: str


class Reply(TypedDict, total=False):
    """A reply. Which members it has depends on the request, as `control` says; a refusal has `reasons`."""

    version: int
    ok: bool
    reasons: list[str]
    # status
    system: str
    model: str
    activity_folder: str | None
    plans: list[str]
    time: int
    agents: list[AgentStatus]
    elsewhere: list[str]
    clocks: dict[str, ClockDifference]
    peers: dict[str, PeerStatus]
    process: Usage
    faults: int
    counts: dict[str, int]
    trace_error: str | None
    swap: HeldSwap | None
    epoch: EpochStatus
    doubted: dict[str, str]
    held: MissedEpoch | None
    # logs
    records: list[LogRecord]
    next: int
    missed: int
    # select
    agent: str
    plan: str
    # swap
    state: str
    id: int
    notes: list[str]
    # over the network
    life: str
    nonce: str
    answer: str
    proof: str


def as_reply(found: Mapping[str, object]) -> Reply:
    """An answer with the types that `control` gives its members, which are not checked."""
    return cast(Reply, found)
