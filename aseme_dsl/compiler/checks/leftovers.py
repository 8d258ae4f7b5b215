"""Leftovers: what the actions of a chart begin and nothing takes up: drafts, timers and variables."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from aseme_dsl.amola.expression import (
    Assign,
    Expired,
    Member,
    Publish,
    StartTimer,
    VariableValue,
    values_of,
    walk,
)
from aseme_dsl.amola.messages import Channel
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Origin, Statechart, Transition
from aseme_dsl.compiler.read.library import is_of_library
from aseme_dsl.diagnostics import Diagnostic, Related, closest
from aseme_dsl.diagnostics.problems.use import (
    DraftNotPublished,
    ResultNotTaken,
    TimerNotRead,
    VariableNotRead,
)
from aseme_dsl.source import Span

LeftOut = Mapping[tuple[str, str, str, str], Span]
"""Where (role, protocol, participant, result) is played without taking the result.

The role is empty where a participant plays another one.
"""


def check_leftovers(
    chart: Statechart, activities: Mapping[str, Activity], left_out: LeftOut
) -> Iterator[Diagnostic]:
    """W421 for drafts that are never published, W423 for timers that nothing asks, N725 for variables."""
    acting = [item for item in chart.transitions if item.expression.actions]
    if not acting:
        return
    yield from _drafts(chart, acting)
    yield from _timers(chart, acting)
    yield from _variables(chart, acting, activities, left_out)


def _drafts(chart: Statechart, acting: Iterable[Transition]) -> Iterator[Diagnostic]:
    """A draft belongs to the region that fills it."""
    filled: dict[tuple[str, Channel], Span] = {}
    published: set[tuple[str, Channel]] = set()
    places: dict[Channel, Span] = {}
    for transition in acting:
        region = chart.region_of(transition.source)
        for action in transition.expression.actions:
            if isinstance(action, Assign) and isinstance(action.target, Member):
                filled.setdefault((region, action.target.channel), action.span)
            elif isinstance(action, Publish):
                published.add((region, action.channel))
                places.setdefault(action.channel, action.span)
    for (region, channel), span in filled.items():
        if (region, channel) in published:
            continue
        related = (Related(places[channel], "in another region"),) if channel in places else ()
        yield Diagnostic(DraftNotPublished(str(channel), bool(related)), span, related)


def _timers(chart: Statechart, acting: Iterable[Transition]) -> Iterator[Diagnostic]:
    """One that another region asks for, or that is misspelt where it is asked for, is W501 there."""
    started: dict[str, Span] = {}
    for transition in acting:
        for action in transition.expression.actions:
            if isinstance(action, StartTimer):
                started.setdefault(action.timer, action.span)
    if not started:
        return
    asked = {value.timer for _, value in chart.values() if isinstance(value, Expired)}
    meant = {closest(timer, started) for timer in asked - started.keys()}
    for timer, span in started.items():
        if timer not in asked and timer not in meant:
            yield Diagnostic(TimerNotRead(timer), span)


def _variables(
    chart: Statechart,
    acting: Iterable[Transition],
    activities: Mapping[str, Activity],
    left_out: LeftOut,
) -> Iterator[Diagnostic]:
    """Variables of a played participant are one for every place where it is played.

    What a protocol of the standard library writes is for the activities of those who play it.
    """
    written: dict[str, tuple[Span, Origin]] = {}
    for transition in acting:
        for action in transition.expression.actions:
            if isinstance(action, Assign) and isinstance(action.target, VariableValue):
                name = action.target.name.partition("@")[0]
                written.setdefault(name, (action.target.span, transition.origin))
    if not written:
        return
    read = {
        value.name.partition("@")[0]
        for node in chart.states
        for argument in node.arguments
        for value in walk(argument.value)
        if isinstance(value, VariableValue)
    }
    performed = {*(node.activity for node in chart.states), *(module.name for module in chart.modules)}
    read.update(
        name for item in activities.values() if item.name in performed for name in item.reads_variables
    )
    for transition in chart.transitions:
        own = {
            action.target.name: action
            for action in transition.expression.actions
            if isinstance(action, Assign) and isinstance(action.target, VariableValue)
        }
        for value in values_of(transition.expression):
            if isinstance(value, VariableValue) and not _counts_only(value, own.get(value.name)):
                read.add(value.name.partition("@")[0])
    for name, (span, origin) in written.items():
        if name in read or is_of_library(span.source):
            continue
        part = (origin.owner, origin.name, name)
        played = left_out.get((chart.name, *part)) or left_out.get(("", *part))
        if played is not None:
            yield Diagnostic(ResultNotTaken(name, origin.name), played, (Related(span, "written here"),))
        else:
            yield Diagnostic(VariableNotRead(name), span)


def _counts_only(value: VariableValue, action: Assign | None) -> bool:
    """Whether a variable is read only to give it its next value, as in `count = count + 1`."""
    return action is not None and action.span.start <= value.span.start <= action.span.end


__all__ = ["check_leftovers"]
