"""Staging: the generated statechart of a version, with all that comes from outside left open."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import field, replace
from functools import partial
from typing import cast

from aseme_dsl.proofs.compare.decisions import Decisions, Enums, Open
from aseme_dsl.proofs.compare.unread import unread
from aseme_dsl.proofs.explore.deciding.acting import Called
from aseme_dsl.proofs.explore.deciding.staging import with_open
from aseme_dsl.proofs.explore.deciding.values import enums_of
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.board import Board
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.functions import find_function, is_of_library
from aseme_dsl.runtime.chart.plan import BranchInfo, Plan

LONG_AGO = -(10**18)
"""The time of a message whose age nothing asks for: it never becomes due."""


@dataclass(frozen=True, slots=True)
class Version:
    """A role in one version: its generated statechart, and the messages and enums of its system by name."""

    chart: type[Chart]
    types: Mapping[str, type[object]]
    names: Mapping[str, str] = field(default_factory=dict)
    """What is called otherwise in the other version: its name there by that here."""
    parts: Mapping[str, str] = field(default_factory=dict)
    """The same for participants and protocols."""

    def name(self, own: str) -> str:
        """The name by which both versions know something."""
        return self.names.get(own, own)

    def part(self, own: str) -> str:
        """The name by which both versions know a participant or a protocol."""
        return self.parts.get(own, own)

    def own_part(self, name: str) -> str:
        """What a participant is called here."""
        return next((own for own, other in self.parts.items() if other == name), name)

    def part_of(self, info: BranchInfo) -> str:
        """The name by which both versions know the part of a branch."""
        return f"{self.part(info.protocol)}.{self.part(info.participant)}"

    @property
    def plan(self) -> Plan:
        return self.chart.PLAN


def published(plan: Plan) -> frozenset[str]:
    """The channels on which transitions publish."""
    return frozenset(
        str(action[1]) for item in plan.transitions for action in item.actions if action[0] == "publish"
    )


def open_channels(plans: Iterable[Plan]) -> frozenset[str]:
    """The channels whose latest message is decided when it is read: no transition publishes on them."""
    plans = tuple(plans)
    own = frozenset().union(*map(published, plans))
    read = {channel for plan in plans for region in plan.regions for channel in region.reads}
    return frozenset(item for item in read if item not in own and item.split(".", 2)[1] != "signal")


class Stage:
    """What a statechart asks that is decided."""

    def __init__(self, version: Version, decisions: Decisions, channels: frozenset[str]) -> None:
        """`channels` are those whose latest message is decided when it is read."""
        self.decisions = decisions
        self.open = channels
        self.messages = version.types
        self.enums: Enums = enums_of(version.types)
        self.now: int | None = None
        """The time of the present step; None between two of them, when nothing is decided."""
        self._draws = 0
        self._messages: dict[str, object] = {}
        """The messages that this move has shown."""
        self.version = version
        self._variables = {item.name: item for item in version.plan.variables}

    def begin(self, now: int) -> None:
        """A move begins: what is asked is decided until it ends."""
        self.now, self._draws = now, 0
        self._messages.clear()

    def as_own(self, value: object) -> object:
        """A value of both versions as one of this one."""
        return self.decisions.as_of(value, self.messages, self.enums)

    def latest(self, channel: str, host: str | None) -> object:
        """The latest message on a channel, or None."""
        if self.now is None or not self.decisions.is_there(channel, host):
            return None
        message = channel.rpartition(".")[2]
        name = channel if host is None else f"{host}.{channel}"
        if name in self._messages:
            return self._messages[name]

        def ask(path: tuple[str, ...], kind: object) -> object:
            return self.as_own(self.decisions.member(name, (message, path), kind))

        made = self._messages[name] = unread(cast(type, self.messages[message]), name, ask)
        return made

    def measured(self, channel: str, host: str | None) -> int:
        """When that was measured."""
        return LONG_AGO if self.now is None else self.now - int(self.decisions.age(channel, host))

    def written(self, variable: str, value: Open) -> object:
        """What an activity has written to a variable."""
        return self.as_own(self.decisions.variable(self._variables[variable], value, self.version.name))

    def draw(self) -> float:
        """A random number: the first that one version draws is the first of the other, too."""
        self._draws += 1
        return self.decisions.drawn(self._draws)

    def function(self, item: tuple[str, str, str, str]) -> Called:
        """What is called instead of a function of the document."""
        name, target, result, _ = item
        if is_of_library(target):
            return find_function(target)

        def answer(*arguments: object) -> object:
            return self.as_own(self.decisions.called(name, result, arguments))

        return answer


def staged(version: Version, agent: str, stage: Stage) -> Chart:
    """The statechart of a role, which asks `stage` for what comes from outside.

    Its blackboards are changed in place: the code of a version is loaded for one comparison.
    """
    chart = version.chart
    # Activities that the document simulates end when anything else does.
    activities = tuple(replace(info, simulated=False, takes=None) for info in chart.PLAN.activities)
    plan = replace(chart.PLAN, activities=activities, modules=())
    own: dict[str, object] = {"random": lambda chart: stage.draw()}
    kind = with_open(chart, plan, own, partial(_opened, stage))
    made = kind(agent)
    for number in range(len(kind.REGIONS)):
        _open_board(type(getattr(made, f"b{number}")), stage)
    made.stand_in({item[0]: stage.function(item) for item in plan.functions})
    return made


def _opened(stage: Stage, slot: str, variable: str) -> property:
    def read(chart: Chart) -> object:
        value = getattr(chart, slot)
        return stage.written(variable, value) if isinstance(value, Open) else value

    return property(read, lambda chart, value: setattr(chart, slot, value))


def _open_board(board: type[Board], stage: Stage) -> None:
    for channel, slots in board.SLOTS.items():
        if channel not in stage.open:
            continue
        for slot, host in slots:
            setattr(board, slot, _shown(stage.latest, channel, host))
            if slot in board.TIMED:
                setattr(board, slot + "_time", _shown(stage.measured, channel, host))


def _shown(read: Callable[[str, str | None], object], channel: str, host: str | None) -> property:
    return property(lambda board: read(channel, host), lambda board, value: None)


__all__ = ["Stage", "Version", "open_channels", "published", "staged"]
