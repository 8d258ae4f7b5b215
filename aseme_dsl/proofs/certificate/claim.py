"""Claim: what a source says of a statechart, as data: formulas, control lines, what is played."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from aseme_dsl.amola.aip import DeclaredVariable
from aseme_dsl.amola.expression import TransitionExpression, Value
from aseme_dsl.amola.liveness import Formula
from aseme_dsl.amola.statechart import Argument
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True, eq=False)
class Line:
    """A control line: of which formula's block it is, the verb and term as written, and its expression.

    `occurrence` is the n of `T#n`. `is_abandon` is a line of a participant that reads `on abandon`.
    """

    formula: str
    verb: str
    term: Formula
    occurrence: int | None
    expression: TransitionExpression
    span: Span
    ignores: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class LabelLine:
    """`0.2.3 -> 0.2.4 : …`; the labels of a participant's lines are below that of its subchart (`.2.1`)."""

    formula: str
    source: str
    target: str
    expression: TransitionExpression
    span: Span


@dataclass(frozen=True, slots=True, eq=False)
class Play:
    """A participant that formulas name, with what its player supplies."""

    process: Process
    bindings: Mapping[str, str] = field(default_factory=dict)
    inputs: Mapping[str, Value] = field(default_factory=dict)
    results: Mapping[str, str] = field(default_factory=dict)
    span: Span | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Process:
    """The formulas of a role (`player`) or of a participant (`attack`, `center`) with their control lines.

    `title` is what control calls the formula `root`. `given` has the arguments of the names in formulas,
    `reactive` the formulas whose choices are reactive. `lines` are in the order in which they are written.
    """

    owner: str
    protocol: str
    participant: str
    root: str
    title: str
    formulas: Mapping[str, Formula]
    parameters: Mapping[str, tuple[str, ...]]
    given: Mapping[Formula, tuple[Argument, ...]]
    lines: tuple[Line | LabelLine, ...]
    reactive: frozenset[str]
    plays: Mapping[str, Play]
    variables: tuple[DeclaredVariable, ...]
    inputs: tuple[DeclaredVariable, ...] = ()


@dataclass(frozen=True, slots=True)
class Region:
    """A region of a protocol's statechart: its participant, and the place that its states point to."""

    name: str
    process: Process
    span: Span


@dataclass(frozen=True, slots=True)
class Claims:
    """All that the sources of one system say: a process for each role, the regions of each protocol.

    `waiting` are the activities that never complete by themselves.
    """

    roles: Mapping[str, Process]
    protocols: Mapping[str, tuple[Region, ...]]
    waiting: frozenset[str]


__all__ = ["Claims", "LabelLine", "Line", "Play", "Process", "Region"]
