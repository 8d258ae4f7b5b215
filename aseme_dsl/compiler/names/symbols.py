"""Symbols: everything that the declarations of all files give a name to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from functools import cached_property

from aseme_dsl.amola.messages import (
    BUILT_IN,
    Channel,
    ChannelRules,
    EnumType,
    Function,
    Kind,
    Message,
    Parameter,
    ProtoFile,
    Topic,
    Type,
)
from aseme_dsl.amola.system import Team, agent_names
from aseme_dsl.compiler.read.builtins import FUNCTIONS, NOWHERE
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class ActivityForm:
    """What expressions and formulas need to know of an activity: what it is given and how it may end."""

    name: str
    parameters: tuple[Parameter, ...]
    ends: tuple[str, ...]
    span: Span


@dataclass(frozen=True)
class Symbols:
    """Everything that has a name in the whole system. Sequences are in document order, imports first."""

    system: tree.System | None = None
    enums: tuple[EnumType, ...] = ()
    messages: tuple[Message, ...] = ()
    topics: tuple[Topic, ...] = ()
    functions: tuple[Function, ...] = ()  # the declared ones; built-in ones are in compiler/read/builtins.py
    lets: tuple[tree.Let, ...] = ()  # those of files; typed by scope.global_scope
    activities: Mapping[str, ActivityForm] = field(default_factory=dict)
    """The activities that some role describes."""
    teams: tuple[Team, ...] = ()
    roles: frozenset[str] = frozenset()
    """Without a team: the roles."""
    protos: tuple[ProtoFile, ...] = ()
    wrong: frozenset[str] = frozenset()
    """Names whose declaration is wrong: their uses are not reported again."""
    lost: frozenset[str] = frozenset()
    """Names whose declaration could not be read, as it seems."""
    complete: bool = True
    """Whether every file was read: if not, a name that is not known may be declared in one that was not."""

    @cached_property
    def _enums(self) -> Mapping[str, EnumType]:
        return {item.name: item for item in self.enums}

    @cached_property
    def _messages(self) -> Mapping[str, Message]:
        return {item.name: item for item in self.messages}

    @cached_property
    def _topics(self) -> Mapping[str, Topic]:
        return {item.name: item for item in self.topics}

    @cached_property
    def _channels(self) -> Mapping[Channel, ChannelRules]:
        return {rules.channel: rules for topic in self.topics for rules in topic.channels}

    @cached_property
    def _functions(self) -> Mapping[str, tuple[Function, ...]]:
        found: dict[str, list[Function]] = {}
        for item in (*FUNCTIONS, *self.functions):
            found.setdefault(item.name, []).append(item)
        return {name: tuple(items) for name, items in found.items()}

    @cached_property
    def agents(self) -> frozenset[str]:
        """The names of all agents of all teams."""
        return frozenset(agent.name for team in self.teams for agent in team.agents)

    @cached_property
    def hosts(self) -> frozenset[str] | None:
        """The agents that a path may name; None if they are unknown.

        Other files, which have a team, may import a file without a `system`. And a part that could not be
        read may have been a team.
        """
        without = self.system is None or self.teams or self.lost or not self.complete
        return None if without and not self.agents else agent_names(self.teams, self.roles)

    @property
    def function_names(self) -> tuple[str, ...]:
        return tuple(self._functions)

    @property
    def type_names(self) -> tuple[str, ...]:
        """The names of all types: built-in ones, enums, messages."""
        return (*BUILT_IN, *self._enums, *self._messages)

    @property
    def nowhere(self) -> Span:
        """The place of what no document says."""
        return NOWHERE

    def is_excused(self, name: str) -> bool:
        """Whether it is a consequence of another problem that this name is not known."""
        return name in self.wrong or name in self.lost or not self.complete

    def enum(self, name: str) -> EnumType | None:
        return self._enums.get(name)

    def message(self, name: str) -> Message | None:
        return self._messages.get(name)

    def topic(self, name: str) -> Topic | None:
        return self._topics.get(name)

    def type_named(self, name: str) -> Type | None:
        """The built-in type, enum or message of this name."""
        if name in BUILT_IN:
            return BUILT_IN[name]
        if name in self._enums:
            return Type(Kind.ENUM, name)
        return Type(Kind.MESSAGE, name) if name in self._messages else None

    def channel(self, channel: Channel) -> ChannelRules | None:
        return self._channels.get(channel)

    def channels_of(self, message: str) -> tuple[Channel, ...]:
        """The channels on which a message travels."""
        return tuple(channel for channel in self._channels if channel.message == message)

    def overloads(self, name: str) -> tuple[Function, ...]:
        """The functions of this name, the built-in ones included."""
        return self._functions.get(name, ())

    def topics_reached(self, topic: str, reach: str) -> tuple[Topic, ...]:
        """The topics that `reach` ("on", "above", "below", "around") means, `topic` itself included."""
        return tuple(
            item
            for item in self.topics
            if item.name == topic
            or (reach in ("above", "around") and self._is_above(item.name, topic))
            or (reach in ("below", "around") and self._is_above(topic, item.name))
        )

    def _is_above(self, upper: str, lower: str) -> bool:
        seen = set()
        topic = self._topics.get(lower)
        while topic is not None and topic.under is not None and topic.name not in seen:
            if topic.under == upper:
                return True
            seen.add(topic.name)
            topic = self._topics.get(topic.under)
        return False
