"""Resolve: what the declarations of all files mean: enums, messages, topics, functions, agents."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from aseme_dsl.amola.messages import (
    Channel,
    ChannelRules,
    EnumType,
    Function,
    Message,
    ProtoFile,
    Topic,
    Type,
)
from aseme_dsl.amola.system import Team
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar import tree
from aseme_dsl.interop.proto import ProtoImport


@dataclass(frozen=True)
class Symbols:
    """Everything that has a name in the whole system. Sequences are in document order, imports first."""

    system: tree.System | None = None
    enums: tuple[EnumType, ...] = ()
    messages: tuple[Message, ...] = ()
    topics: tuple[Topic, ...] = ()
    functions: tuple[Function, ...] = ()  # the declared ones; built-in ones are in compiler/builtins.py
    lets: tuple[tree.Let, ...] = ()  # those of files; typed by scope.global_scope
    teams: tuple[Team, ...] = ()
    protos: tuple[ProtoFile, ...] = ()

    def enum(self, name: str) -> EnumType | None:
        raise NotImplementedError

    def message(self, name: str) -> Message | None:
        raise NotImplementedError

    def topic(self, name: str) -> Topic | None:
        raise NotImplementedError

    def type_named(self, name: str) -> Type | None:
        """The built-in type, enum or message of this name."""
        raise NotImplementedError

    def channel(self, channel: Channel) -> ChannelRules | None:
        raise NotImplementedError

    def overloads(self, name: str) -> tuple[Function, ...]:
        """The functions of this name, the built-in ones included."""
        raise NotImplementedError

    @property
    def agents(self) -> frozenset[str]:
        """The names of all agents of all teams: the hosts that a variable may name."""
        raise NotImplementedError

    def topics_reached(self, topic: str, reach: str) -> tuple[Topic, ...]:
        """The topics that `reach` ("on", "above", "below", "around") means, `topic` itself included."""
        raise NotImplementedError


def resolve(
    files: Sequence[tree.File], protos: Sequence[ProtoImport] = ()
) -> tuple[Symbols, tuple[Diagnostic, ...]]:
    """Collect the declarations of `files`, with every duplicate, unknown type, reserved name and bad number reported.

    Also checked here: that there is at most one `system`, and that every agent's role is an `srm` or a
    `statechart` (E207).
    """
    raise NotImplementedError
