"""Which regions of a chart read and write what: messages, signals, variables, events."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property

from aseme_dsl.amola.expression import (
    Age,
    Arithmetic,
    At,
    Call,
    Has,
    Holds,
    Mean,
    Member,
    Raised,
    TransitionExpression,
    Value,
    VariableValue,
    values_of,
    walk,
)
from aseme_dsl.amola.messages import ChannelKind
from aseme_dsl.amola.statechart import Statechart, StateType, TransitionKind
from aseme_dsl.amola.system import System
from aseme_dsl.codegen.program.flat import FlatChart
from aseme_dsl.codegen.program.moves import assigned
from aseme_dsl.codegen.program.registers import constant


class Uses:
    """What the regions of a flattened chart use."""

    def __init__(self, flat: FlatChart) -> None:
        self._flat = flat
        self._chart = flat.chart

    @cached_property
    def members(self) -> dict[int, tuple[Member, ...]]:
        """The messages that the expressions of each region look at, fields and senders included."""
        found: dict[int, dict[tuple[str, str | None], Member]] = {}
        for place, value in self._chart.values():
            if isinstance(value, Member):
                of_region = found.setdefault(self._flat.region_number[place], {})
                of_region.setdefault((str(value.channel), value.host), value)
        return {
            region: tuple(uses[key] for key in sorted(uses, key=_by_channel))
            for region, uses in found.items()
        }

    @cached_property
    def aged(self) -> frozenset[tuple[int, str, str | None]]:
        """(region, channel, sender) of each message whose time of measurement an expression reads."""
        return frozenset(
            (self._flat.region_number[place], str(v.message.channel), v.message.host)
            for place, v in self._chart.values()
            if isinstance(v, Age) and isinstance(v.message, Member)
        )

    @cached_property
    def variable_regions(self) -> dict[str, tuple[int, ...]]:
        """The regions whose expressions read, write or renew each variable, and one around inner ones."""
        found: dict[str, set[int]] = {variable.name: set() for variable in self._chart.variables}
        for variable in self._chart.variables:
            if variable.scope is not None:
                found[variable.name].add(self._flat.region_number[variable.scope])
        for number, transition in enumerate(self._chart.transitions):
            region = self._flat.region_number[transition.source]
            for name in _variables(transition.expression):
                found[name].add(region)
            for name in assigned(transition.expression):
                found[name].update(self._flat.places(number))
        for place, value in self._chart.values():
            if isinstance(value, VariableValue):
                found[value.name].add(self._flat.region_number[place])
        for variable in self._chart.variables:
            # a region that is entered again starts with the copy around it, so there must be one
            if variable.scope is None and any(self._is_entered_again(n) for n in found[variable.name]):
                found[variable.name].add(0)
        return {name: tuple(sorted(regions)) for name, regions in found.items()}

    @cached_property
    def awaited(self) -> dict[int, frozenset[str]]:
        """The raised events that transitions of each region wait for."""
        found: dict[int, set[str]] = {}
        for transition in self._chart.transitions:
            names = {event.name for event in transition.expression.events if isinstance(event, Raised)}
            found.setdefault(self._flat.region_number[transition.source], set()).update(names)
        return {region: frozenset(names) for region, names in found.items() if names}

    @cached_property
    def asked_signals(self) -> dict[int, frozenset[str]]:
        """The channels of the signals that the expressions of each region look at."""
        return {
            region: frozenset(str(use.channel) for use in uses if use.channel.comm is ChannelKind.SIGNAL)
            for region, uses in self.members.items()
        }

    @cached_property
    def wakes(self) -> dict[str, dict[int, tuple[str, ...]]]:
        """Of each variable that one region writes and a condition of another reads: the regions that read it
        so, with the sources of these transitions.

        A region that is entered after the write of one around it starts with what was written: only what is
        done without leaving it can wake it.
        """
        found: dict[str, dict[int, dict[str, None]]] = {}
        for source in self._flat.sources:
            for transition in self._flat.segments(source):
                condition = transition.expression.guard
                for value in walk(condition) if condition is not None else ():
                    if isinstance(value, VariableValue):
                        readers = found.setdefault(value.name, {})
                        readers.setdefault(self._flat.region_number[source], {}).setdefault(source)
        writers: dict[str, set[tuple[int, bool]]] = {}
        for number, transition in enumerate(self._chart.transitions):
            stays = transition.kind is TransitionKind.ON
            for name in assigned(transition.expression):
                writers.setdefault(name, set()).update((place, stays) for place in self._flat.places(number))
        woken: dict[str, dict[int, tuple[str, ...]]] = {}
        for name, readers in found.items():
            for region, sources in readers.items():
                others = (item for item in writers.get(name, ()) if item[0] != region)
                if any(stays or writer not in self._flat.regions_around(region) for writer, stays in others):
                    woken.setdefault(name, {})[region] = tuple(sources)
        return woken

    @cached_property
    def missed(self) -> dict[str, dict[int, tuple[str, ...]]]:
        """Of each signal: the regions with a condition that may hold because the signal is consumed, with the
        sources of these transitions.

        In three-valued logic an absent value makes nothing true that was not true before. Only what is
        two-valued, and what raises with the signal, tells that it is consumed.
        """
        found: dict[str, dict[int, dict[str, None]]] = {}
        for source in self._flat.sources:
            for transition in self._flat.segments(source):
                condition = transition.expression.guard
                parts = list(walk(condition)) if condition is not None else []
                if not any(_tells_absence(part) for part in parts):
                    continue
                for channel, _ in signals(parts):
                    readers = found.setdefault(channel, {})
                    readers.setdefault(self._flat.region_number[source], {}).setdefault(source)
        return {
            channel: {region: tuple(sources) for region, sources in readers.items()}
            for channel, readers in found.items()
        }

    def _is_entered_again(self, region: int) -> bool:
        """Whether a region may be entered after it was left: its AND can be reached from itself."""
        and_state = self._chart.node(self._flat.regions[region].label).parent
        if and_state is None:
            return False
        inside = f"{and_state}."
        leaving = (self._flat.transition(number).source for number in self._flat.leading_out)
        stack = [and_state, *(source for source in leaving if source.startswith(inside))]
        seen = {*stack}
        while stack:
            active = stack.pop()
            for source in (active, *(around.label for around in self._chart.ancestors(active))):
                for transition in self._chart.outgoing(source):
                    entered = [transition.target, *self._chart.entries_of(transition)]
                    while entered:
                        state = entered.pop()
                        if state == and_state or (state.startswith(inside) and not source.startswith(inside)):
                            return True
                        start = self._chart.start_of(state)
                        if start is not None:
                            entered.append(start.label)
                        elif self._chart.node(state).type is StateType.AND:
                            entered += [inner.label for inner in self._chart.children(state)]
                        elif state not in seen:
                            seen.add(state)
                            stack.append(state)
        return False

    @cached_property
    def retention(self) -> dict[str, int]:
        """How long the expressions look back at each data channel, in ns."""
        found: dict[str, int] = {}
        for _, value in self._chart.values():
            match value:
                case At(message=message, offset=extent) | Mean(message=message, window=extent):
                    channel = str(message.channel)
                    found[channel] = max(found.get(channel, 0), _extent(extent))
        return found


def _by_channel(key: tuple[str, str | None]) -> tuple[str, str]:
    return key[0], key[1] or ""


def _variables(expression: TransitionExpression) -> Iterator[str]:
    for value in values_of(expression):
        if isinstance(value, VariableValue):
            yield value.name
    yield from assigned(expression)


def _tells_absence(value: Value) -> bool:
    """Whether a value is true or false even if messages are absent, or may raise."""
    match value:
        case Has() | Holds():
            return True
        case Call(function=function):
            return function.is_of_document
        case Arithmetic(operator=operator):
            return operator in ("*", "/", "%")
    return False


def signals(values: Iterable[Value]) -> tuple[tuple[str, str | None], ...]:
    """The signals (channel, sender) among values, each once."""
    found = {
        (str(v.channel), v.host): None
        for v in values
        if isinstance(v, Member) and v.channel.comm is ChannelKind.SIGNAL
    }
    return tuple(found)


_MINUTE = 60_000_000_000


def _extent(value: Value) -> int:
    """How far back a history is asked for; a minute where the document computes it."""
    amount = constant(value)
    return _MINUTE if amount is None else abs(amount)


def retention(system: System, chart: Statechart, uses: Uses | None = None) -> dict[str, int]:
    """How long each data channel must be kept, in ns: the longest history that anything asks for."""
    found = dict((uses or Uses(FlatChart(chart))).retention)
    used = {node.activity for node in chart.states if node.activity}
    activities = [item for item in system.activities if item.name in used]
    for activity in (*activities, *(module.statement for module in chart.modules)):
        for subscription in activity.reads:
            if subscription.channel is not None and subscription.channel.comm is ChannelKind.DATA:
                channel = str(subscription.channel)
                found[channel] = max(found.get(channel, 0), subscription.history)
    return {channel: found[channel] for channel in sorted(found)}


__all__ = ["Uses", "retention", "signals"]
