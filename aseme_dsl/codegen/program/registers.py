"""What must be remembered of the states of a chart: when and how often they were entered, how they ended."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property

from aseme_dsl.amola.expression import (
    After,
    Age,
    Arithmetic,
    Bound,
    Compare,
    Expired,
    Literal,
    Member,
    Named,
    Negate,
    Outcome,
    Received,
    StartTimer,
    StateValue,
    TransitionExpression,
    Value,
    values_of,
    walk,
)
from aseme_dsl.amola.meant import loop_of, performers, states_meant
from aseme_dsl.amola.messages import DURATION, Type
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import State
from aseme_dsl.codegen.program.flat import FlatChart
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Wait:
    """Something that time alone may change while a source is active.

    `kind` is "after" (`amount` ns after the entry of `source`), "within" (the same, while the activity of
    `source` runs) or "timer" (`name`). It is "age" where the message `member` becomes `amount` ns old, and
    "sent" where an agent message does that one of `events` can take.
    """

    source: str
    kind: str
    amount: int = 0
    name: str = ""
    member: Member | None = None
    events: tuple[Received, ...] = ()


class Registers:
    """What a flattened chart has to remember besides the leaves that are active."""

    def __init__(self, flat: FlatChart, activities: Iterable[Activity] = ()) -> None:
        """`activities` are those of the system: of those in the chart, what is said of them counts."""
        self._flat = flat
        self._chart = flat.chart
        self._activities = {activity.name: activity for activity in activities}

    @cached_property
    def waits(self) -> tuple[Wait, ...]:
        """Everything that time alone may change, by source."""
        found: dict[Wait, None] = {}
        for source in self._flat.sources:
            for transition in self._flat.segments(source):
                for wait in _waits(source, transition.expression):
                    found.setdefault(wait)
        for label, within in self.deadlines.items():
            found.setdefault(Wait(label, "within", within))
        return tuple(found)

    def said_of(self, node: State) -> Activity | None:
        """What is said of the activity of a BASIC state."""
        return self._activities.get(node.activity) if node.activity is not None else None

    @cached_property
    def deadlines(self) -> dict[str, int]:
        """The BASIC states whose activity has a deadline, with how long it has from their entry, in ns."""
        return {
            node.label: said.within
            for node in self._chart.states
            if (said := self.said_of(node)) is not None and said.within is not None
        }

    @cached_property
    def ending(self) -> frozenset[str]:
        """The BASIC states whose activity ends with an outcome."""
        return frozenset(
            node.label
            for node in self._chart.states
            if (said := self.said_of(node)) is not None and said.ends
        )

    def asked_of(self, source: str, activity: str) -> tuple[str, ...]:
        """The states of which `outcome(activity)` is the last outcome, in a transition out of `source`."""
        return tuple(node.label for node in performers(self._chart, source, activity))

    @cached_property
    def counted(self) -> dict[str, str]:
        """The states whose entries an expression counts, each with the state whose entry resets the count."""
        found = {
            node.label
            for place, value in self._chart.values()
            if isinstance(value, StateValue) and value.question == "count"
            for node in states_meant(self._chart, place, value.state)
        }
        return {
            node.label: loop_of(self._chart, node.label) for node in self._chart.states if node.label in found
        }

    @cached_property
    def timed(self) -> frozenset[str]:
        """The states whose time of entry is needed for `after` or `within`."""
        return frozenset(wait.source for wait in self.waits if wait.kind in ("after", "within"))

    @cached_property
    def timers(self) -> dict[int, tuple[str, ...]]:
        """The timers of the regions that have some."""
        found: dict[int, dict[str, None]] = {}
        for transition in self._chart.transitions:
            for item in (*transition.expression.actions, *values_of(transition.expression)):
                if isinstance(item, StartTimer | Expired):
                    region = self._flat.region_number[transition.source]
                    found.setdefault(region, {}).setdefault(item.timer)
        return {region: tuple(sorted(found[region])) for region in sorted(found)}

    def started_in(self, label: str) -> tuple[str, ...]:
        """The timers that transitions inside a state start."""
        return tuple(
            sorted(
                {
                    action.timer
                    for transition in self._chart.transitions
                    if transition.source.startswith(f"{label}.")
                    for action in transition.expression.actions
                    if isinstance(action, StartTimer)
                }
            )
        )

    @cached_property
    def outcomes(self) -> tuple[tuple[str, ...], ...]:
        """The groups of states for which an expression reads the outcome of the last one that was active."""
        return tuple(
            dict.fromkeys(
                self.asked_of(source, value.activity)
                for source, value in self._chart.values()
                if isinstance(value, Outcome)
            )
        )

    def parameters(self, node: State) -> dict[str, Type]:
        """The declared types of what the activity of a state is given, by parameter."""
        said = self.said_of(node)
        return {item.name: item.type for item in said.parameters} if said is not None else {}


def _waits(source: str, expression: TransitionExpression) -> Iterator[Wait]:
    for event in expression.events:
        if isinstance(event, After):
            yield Wait(source, "after", event.duration)
    if expression.every is not None:
        yield Wait(source, "after", expression.every)
    if expression.guard is None:
        return
    for value in walk(expression.guard):
        match value:
            case Expired(timer=timer):
                yield Wait(source, "timer", name=timer)
            case Compare(operator=operator, left=left, right=right):
                for message, amount in _crossings(operator, left, right):
                    if isinstance(message, Bound):
                        events = tuple(event for event in expression.events if isinstance(event, Received))
                        yield Wait(source, "sent", amount, events=events)
                    else:
                        yield Wait(source, "age", amount, member=message)


_FLIPPED = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "==": "==", "!=": "!="}


def _crossings(operator: str, left: Value, right: Value) -> Iterator[tuple[Member | Bound, int]]:
    """The message whose age is compared with a constant, and the ages in ns at which the answer changes."""
    left, right = _plain(left), _plain(right)
    if isinstance(right, Age):
        left, right, operator = right, left, _FLIPPED[operator]
    amount = constant(right)
    if not isinstance(left, Age) or amount is None:
        return
    if operator in ("<", ">=", "==", "!="):
        yield left.message, amount
    if operator in (">", "<=", "==", "!="):
        yield left.message, amount + 1


def _plain(value: Value) -> Value:
    while isinstance(value, Named):
        value = value.expression
    return value


def constant(value: Value) -> int | None:
    """The value of a duration that is a constant, in ns (`-200ms` and `2 * 100ms` too)."""
    if value.type != DURATION:
        return None
    amount = _folded(value)
    return None if amount is None else int(amount)


def _folded(value: Value) -> int | float | None:
    """A number or duration that is written down or computed from such: as the generated code computes it."""
    match value:
        case Literal(value=int() | float() as amount):
            return amount
        case Named(expression=inner):
            return _folded(inner)
        case Negate(operand=operand):
            positive = _folded(operand)
            return None if positive is None else -positive
        case Arithmetic(operator=operator, left=left, right=right, type=kind):
            one, other = _folded(left), _folded(right)
            if one is None or other is None or (operator in ("/", "%") and not other):
                return None
            match operator:
                case "+":
                    result = one + other
                case "-":
                    result = one - other
                case "*":
                    result = one * other
                case "%":
                    result = one % other
                case _:
                    result = one // other if kind == DURATION else one / other
            return int(result) if kind == DURATION else result
    return None


__all__ = ["Registers", "Wait", "constant"]
