"""Trace records: the members of the lines of a trace, with their types (`schemas/trace.schema.json`)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NotRequired, Required, TypeAlias, TypedDict, cast

InputName: TypeAlias = list[str | int]
"""An input as a trace names it: the agent that caused it, and its number there."""


class TracedAgent(TypedDict, total=False):
    """An agent in the first line of a trace (name, role, model, source) or in the last."""

    name: Required[str]
    role: str
    model: str
    source: str
    finished: bool
    failure: str | None
    configuration: list[str]


class Taken(TypedDict):
    """A transition that was taken, or the parts of a compound one."""

    transitions: list[int]
    source: str
    target: str
    into: NotRequired[list[str]]
    """The states in regions of the target that were entered instead of the STARTs there."""
    text: str


def targets_of(taken: Taken) -> tuple[str, ...]:
    """The states that a transition names as its targets."""
    return tuple(taken.get("into", ())) or (taken["target"],)


class Call(TypedDict):
    """What a function gave in a step."""

    function: str
    value: object


class Frame(TypedDict):
    """A place in the code of an activity that raised."""

    file: str
    line: int | None
    function: str


class Machine(TypedDict):
    """The clock of a machine, and its reading when the run began, in ns; whether it shows the right date."""

    clock: int
    origin: int
    synchronised: NotRequired[bool]


class MessageFormats(TypedDict):
    """The Protobuf formats of a system's messages: a `FileDescriptorSet` in base64, and names by channel."""

    descriptors: str
    channels: dict[str, str]


class Record(TypedDict, total=False):
    """A line of a trace. Which members a line has depends on its `kind`, as the schema says."""

    kind: Required[str]
    time: Required[int]
    # who and what
    agent: str
    what: str
    reason: str
    reasons: list[str]
    at: str
    sequence: int
    peer: str
    sender: str
    host: str
    to: list[str]
    input: InputName
    label: str
    region: str
    branch: str
    # the first line and the last
    format: int
    system: str
    seed: int
    clock: str
    agents: list[TracedAgent] | list[str]
    start: str
    machine: Machine
    queue: int
    names: dict[str, dict[str, str]]
    messages: MessageFormats
    sources: str
    # channels, variables and events
    channel: str
    message: object
    measured: int
    event: str
    variable: str
    value: object
    # steps
    step: int
    state: list[object]
    anew: bool
    parts: list[list[str]]
    functions: list[Call]
    agent_messages: list[InputName]
    again: bool
    finished: bool
    inputs: list[InputName]
    ahead: list[InputName]
    taken: list[Taken]
    configuration: list[str]
    # activities and modules
    activity: str
    module: str
    token: int
    started: bool
    arguments: dict[str, object]
    outcome: str
    traceback: list[Frame]
    text: str
    # conversations
    performative: str
    content: object
    protocol: str
    conversation: str
    participant: str
    receiver: str
    answers: list[InputName]
    in_reply_to: str
    sent: int
    untaken: list[InputName]
    played: str
    # changes of plan or version
    role: str
    plan: str
    model: str
    # other processes
    difference: int
    uncertainty: int
    # what is missing
    lines: int


def as_record(line: Mapping[str, object]) -> Record:
    """A line with the types that the schema gives its members, which are not checked."""
    return cast(Record, line)


def agents_of(record: Record) -> list[TracedAgent]:
    """The agents of the first or the last line.

    Raises:
        KeyError, TypeError: it has none.
    """
    return [_agent(item) for item in record["agents"]]


def _agent(item: TracedAgent | str) -> TracedAgent:
    if isinstance(item, str):
        raise TypeError("an agent is an object here")
    return item
