"""Scope: the names that an expression may use where it stands, with the types they have."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from aseme_dsl.amola.aip import AgentMessage, DeclaredVariable
from aseme_dsl.amola.expression import Value
from aseme_dsl.amola.messages import Type
from aseme_dsl.compiler.resolve import Symbols
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar import tree
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Party:
    """A participant as its messages show it."""

    name: str
    sends: tuple[AgentMessage, ...]
    receives: tuple[AgentMessage, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class TypedLet:
    """`let NAME = expression` after typing; `value` is None when the expression is wrong."""

    name: str
    value: Value | None
    span: Span


@dataclass(frozen=True, slots=True)
class Scope:
    """What is visible. `variables` gives each name its key in the statechart and its type.

    `participant` is the one whose control the expression stands in, `parties` all of its protocol; None and
    empty outside an `aip`.
    """

    symbols: Symbols
    variables: Mapping[str, tuple[str, Type]] = field(default_factory=dict)
    lets: Mapping[str, TypedLet] = field(default_factory=dict)
    participant: str | None = None
    parties: Mapping[str, Party] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class TypedRole:
    """The scope of an `srm` or `statechart`, and its variables (their keys are their names)."""

    scope: Scope
    variables: tuple[DeclaredVariable, ...]


@dataclass(frozen=True, slots=True)
class TypedParticipant:
    """The scope of a participant's control, its variables (their keys are their names) and its messages."""

    scope: Scope
    variables: tuple[DeclaredVariable, ...]
    sends: tuple[AgentMessage, ...]
    receives: tuple[AgentMessage, ...]


def global_scope(symbols: Symbols) -> tuple[Scope, tuple[Diagnostic, ...]]:
    """The scope of a file's top: the symbols and the files' lets."""
    raise NotImplementedError


def role_scope(owner: tree.Srm | tree.Statechart, outer: Scope) -> tuple[TypedRole, tuple[Diagnostic, ...]]:
    """The scope inside a role: `outer` (the global one) with the role's variables and lets."""
    raise NotImplementedError


def protocol_scopes(
    protocol: tree.Aip, outer: Scope
) -> tuple[dict[str, TypedParticipant], tuple[Diagnostic, ...]]:
    """The scope of each participant of a protocol, by its name: the protocol's lets and its own names."""
    raise NotImplementedError


def type_variables(
    variables: Sequence[tree.Var], scope: Scope
) -> tuple[tuple[DeclaredVariable, ...], tuple[Diagnostic, ...]]:
    """Variables with their types and initial values; by default 0, false, "" or the first constant."""
    raise NotImplementedError
