"""Guards: what the conditions of transitions read at a moment, and where the names in them are defined."""

from __future__ import annotations

import json
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from aseme_dsl.amola import expression as e
from aseme_dsl.amola.messages import DURATION, STRING, Message
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.statechart import Transition as Drawn
from aseme_dsl.play.evaluate import Known, NotEvaluated, value_of
from aseme_dsl.play.sight.words import Said, cut
from aseme_dsl.runtime.chart.plan import Plan, Transition
from aseme_dsl.runtime.time.clock import readable, shown
from aseme_dsl.source import without_column

_READ = e.VariableValue | e.Member | e.Age | e.Outcome | e.StateValue | e.Expired | e.Bound
"""The parts of a condition whose values say why it holds or not."""
_LIBRARY = "<stdlib>"
"""So the places in the standard library begin, of which a story says less."""
_LONGEST = 60
"""A longer value is cut off (characters)."""
_MOST = 5
"""A story lists so many of the conditions before the transition that was taken."""


class Guards:
    """The conditions of the roles of a system, by their statecharts, its activities and messages."""

    def __init__(
        self,
        charts: Mapping[str, Statechart],
        activities: Iterable[Activity] = (),
        messages: Iterable[Message] = (),
    ) -> None:
        self._charts = charts
        self.durations = {
            item.name: frozenset(member.name for member in item.fields if member.type == DURATION)
            for item in messages
        }
        """Which members of messages are durations."""
        self.declared = {item.name: without_column(str(item.span)) for item in activities}
        """Where the activities are declared."""
        self._plans: dict[str, Plan] = {}
        self._inside: dict[str, str] = {}
        self._variables: dict[str, frozenset[str]] = {}

    def begin(self, plans: Mapping[str, Plan], inside: Mapping[str, str]) -> None:
        """What agents follow, by their names, and in which states they are."""
        self._plans.update(plans)
        self._inside.update(inside)

    def missing(self, plan: Plan, number: int, known: Known) -> Iterator[str]:
        """Which agents publish what the condition of a transition reads, but which has not come."""
        drawn = self.of(plan, number)
        guard = None if drawn is None else drawn.expression.guard
        from aseme_dsl.play.asking.sending import places  # only who reads a story asks for it

        channels = dict.fromkeys(
            str(part.channel)
            for part in (() if guard is None else e.walk(guard))
            if isinstance(part, e.Member) and known.newest(str(part.channel), part.host) is None
        )
        for channel in channels:
            names = [name for name, other in self._plans.items() if any(places(other, ("", channel)))]
            told = [f"{name} may publish it, and is in {self._inside[name]}" for name in names[:_MOST]]
            yield f"{channel} has not come: {'; '.join(told) or 'no role of these agents sends it'}"

    def refused(self, plan: Plan, number: int, known: Known, came: Mapping[str, Said]) -> Iterator[str]:
        """Which agent message came that a transition would take, were it not for its condition.

        `came` is the last agent message of each kind that was sent to the agent.
        """
        drawn = self.of(plan, number)
        guard = None if drawn is None else drawn.expression.guard
        for event in plan.transitions[number].events:
            said = came.get(f"{event[1]} {event[2]}") if event[0] == "received" else None
            if said is not None and guard is not None:
                parts = unmet(guard, replace(known, bound=said.content))
                if parts:
                    sent = f"the last {said.what} was sent by {said.sender} at {readable(said.moment)}"
                    yield f"{sent}, but {parts}"

    def of(self, plan: Plan, number: int) -> Drawn | None:
        """A transition of a role as it is in its statechart; None of one that is not known."""
        chart = self._charts.get(plan.name)
        if chart is None or len(chart.transitions) != len(plan.transitions):
            return None
        return chart.transitions[number]

    def variables(self, plan: Plan) -> frozenset[str]:
        """The variables that conditions of a role read."""
        known = self._variables.get(plan.name)
        if known is None:
            chart = self._charts.get(plan.name)
            guards = () if chart is None else (item.expression.guard for item in chart.transitions)
            parts = (part for guard in guards if guard is not None for part in e.walk(guard))
            known = frozenset(part.name for part in parts if isinstance(part, e.VariableValue))
            self._variables[plan.name] = known
        return known

    def explained(
        self, plan: Plan, number: int, known: Known, changed: Collection[str] | None = None
    ) -> Iterator[str]:
        """What the condition of a transition reads, and what its names stand for.

        If a step has taken it, `changed` are the variables and timers whose values then are not known.
        """
        drawn = self.of(plan, number)
        if drawn is not None and drawn.expression.guard is not None:
            yield from explained(drawn.expression.guard, known, changed)

    def passed_over(
        self, plan: Plan, number: int, known: Known, changed: Collection[str] | None = None
    ) -> Iterator[str]:
        """The conditions of the transitions that would have come before one without a condition."""
        taken, own = plan.transitions[number], self.of(plan, number)
        if own is None or str(own.span).startswith(_LIBRARY):
            return
        if taken.condition is not None or taken.events or taken.weight is not None:
            return
        before: list[tuple[int, Transition]] = []
        for other, item in plan.outgoing(taken.source):
            if other == number:
                break
            if item.condition is not None and item.kind == "external" and not item.events:
                before.append((other, item))
        for other, item in before[:_MOST]:
            drawn = self.of(plan, other)
            if drawn is not None and not drawn.reactive and drawn.expression.guard is not None:
                text = cut(e.value_text(drawn.expression.guard))
                told = "; ".join(explained(drawn.expression.guard, known, changed))
                target = plan.called_all(item.targets)
                read = f", {told}" if told else ""
                yield f"not to {target}, as not [{text}] ({without_column(item.at)}){read}"
        if len(before) > _MOST:
            yield f"and {len(before) - _MOST} more did not hold"


def explained(guard: e.Value, known: Known, changed: Collection[str] | None = None) -> Iterator[str]:
    """What a condition reads, and what its names stand for: `where late is n > 2 (a.aseme:4)`."""
    read = values(guard, known, changed)
    if read:
        yield f"with {', '.join(read)}"
    for item in dict.fromkeys(_named(guard)):
        text, at = cut(e.value_text(item.expression)), str(item.expression.span)
        if text != item.name and not at.startswith(_LIBRARY):
            yield f"where {item.name} is {text} ({without_column(at)})"


def _named(value: e.Value) -> Iterator[e.Named]:
    return (item for item in e.walk(value) if isinstance(item, e.Named))


def values(guard: e.Value, known: Known, changed: Collection[str] | None = None) -> Sequence[str]:
    """What a condition reads, with the values. After a step, what cannot be known any more is left out."""
    found: dict[str, None] = {}
    waiting = [guard]
    while waiting:
        part = waiting.pop(0)
        if isinstance(part, e.Has) and isinstance(part.message, e.Member):
            newest = known.newest(str(part.message.channel), part.message.host)
            if newest is None:
                found[f"no {part.message.channel} so far"] = None
            elif ".signal." in str(part.message.channel):
                found[f"the last {part.message.channel} at {readable(newest[1])}"] = None
            continue
        if isinstance(part, e.Bound) and (known.bound is None or not part.path):
            continue
        if isinstance(part, _READ) and not _is_past(part, changed):
            found[f"{e.value_text(part)} = {told(part, _value(part, known))}"] = None
        if not isinstance(part, e.Age):
            waiting = [*e.operands(part), *waiting]
    return tuple(found)


def unmet(guard: e.Value, known: Known) -> str:
    """The parts of a condition that do not hold, with what they read; nothing if each one does."""
    parts = guard.operands if isinstance(guard, e.Logic) and guard.operator == "&&" else (guard,)
    found = []
    for part in parts:
        if _value(part, known) is not True:
            text, read = cut(e.value_text(part)), ", ".join(values(part, known))
            found.append(f"not [{text}]{f': {read}' if read and read != text else ''}")
    return ", ".join(found)


def _is_past(part: e.Value, changed: Collection[str] | None) -> bool:
    """Whether a part was another one when a step was taken."""
    match part:
        case e.StateValue():
            return changed is not None
        case e.Expired(timer=name) | e.VariableValue(name=name):
            return changed is not None and name in changed
    return False


def _value(part: e.Value, known: Known) -> object:
    try:
        return value_of(part, known)
    except (NotEvaluated, LookupError):
        return None


def told(part: e.Value, value: object) -> str:
    """A value as people read it."""
    if value is None:
        return "absent"
    if isinstance(part, e.Age) and isinstance(value, int):
        return shown(value)
    if isinstance(value, str) and part.type != STRING:
        return value  # a constant of an enum, an outcome
    return cut(json.dumps(value, ensure_ascii=False, default=repr), _LONGEST)


__all__ = ["Guards", "explained", "told", "unmet", "values"]
