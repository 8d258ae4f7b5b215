"""Scope: the names that an expression may use where it stands, with the types they have."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from aseme_dsl.amola.aip import AgentMessage
from aseme_dsl.amola.expression import Value
from aseme_dsl.amola.messages import Bounds, Type
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Party:
    """A participant as the others see it: its messages, and the names of its variables, which are its own."""

    name: str
    sends: tuple[AgentMessage, ...]
    receives: tuple[AgentMessage, ...]
    variables: frozenset[str]
    span: Span
    wrong: frozenset[str] = frozenset()
    """The words of what it says it sends and receives, where that could not be understood."""
    lists: bool = True
    """Whether it says what it sends and receives; else its lines do."""


@dataclass(frozen=True, slots=True)
class TypedLet:
    """`let NAME = expression` after typing; `value` is None when the expression is wrong.

    `height` is how deep the expression is nested and `size` how many parts it has, with the lets that it uses
    written out.
    """

    name: str
    value: Value | None
    height: int
    size: int
    span: Span


@dataclass(frozen=True, slots=True)
class Taken:
    """What a transition takes, as its condition and actions know it: an agent message, or an agent (`lost`).

    Without a `name` it is called by its performative and type: `propose.Bid.cost`.
    """

    name: str
    performative: str
    message: str
    lost: bool
    span: Span


@dataclass(frozen=True, slots=True)
class Scope:
    """What is visible. `variables` gives each name its key in the statechart and its type.

    `participant` is the one whose control the expression stands in, `parties` all of its protocol; None and
    empty outside an `aip`. Scopes are made by compiler/types/scopes.py.
    """

    symbols: Symbols
    variables: Mapping[str, tuple[str, Type]] = field(default_factory=dict)
    lets: Mapping[str, TypedLet] = field(default_factory=dict)
    participant: str | None = None
    parties: Mapping[str, Party] = field(default_factory=dict)
    taken: Taken | None = None
    bounds: Mapping[str, Bounds] = field(default_factory=dict)
    """Of the variables that have some."""
    parameters: Mapping[str, Type | None] = field(default_factory=dict)
    """Those of the formula whose control, or whose arguments, the expression is in: they hide other names.

    None: the type is not known, which has been said.
    """
    inputs: frozenset[str] = frozenset()
    """Those of the parameters that are inputs of the participant."""
