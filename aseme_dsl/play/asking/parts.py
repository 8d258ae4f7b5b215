"""Parts: a system whose conditions tell what each part of them comes to, and take what it shall come to.

It does the same as before as long as nothing else is asked for. A part is what `&&` and `||` join, apart from
its negation. All parts of a condition are evaluated each time, but for those that may raise.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import assert_never

from aseme_dsl.amola.expression import (
    Age,
    Arithmetic,
    Bound,
    Call,
    Has,
    Holds,
    Literal,
    Logic,
    LossReason,
    Member,
    Not,
    Outcome,
    RoundValue,
    Sender,
    StateValue,
    Value,
    operands,
    rewritten,
    value_text,
    walk,
)
from aseme_dsl.amola.meant import performers, states_meant
from aseme_dsl.amola.messages import BOOL
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.play.conditions import around, is_probe, meant, normal_form, shown_as
from aseme_dsl.records import dataclass

Fact = tuple[str, ...]
"""What a part says, without its negation: the same one wherever it means the same."""


@dataclass(frozen=True, slots=True)
class Part:
    """A part of the condition of a transition, by the number of its probe; `value` is without a negation.

    It is evaluated in a region, and in a branch of a participant or in none (""), given by their labels.
    """

    number: int
    fact: Fact
    value: Value
    negated: bool
    transition: int
    region: str
    branch: str
    said: tuple[tuple[str, str | None], ...] = ()
    """The channels of which it asks what a message says, with their senders."""
    asks_letter: bool = False
    """Whether it asks what the agent message says that the transition takes."""


@dataclass(frozen=True, slots=True)
class Joined:
    """Parts that all have to hold, or one of which has to."""

    needs_all: bool
    parts: tuple[Tree, ...]


@dataclass(frozen=True, slots=True)
class Denied:
    """What must not hold; it may be absent."""

    part: Tree


Tree = Part | Joined | Denied


def parts_in(tree: Tree | None) -> Iterator[Part]:
    """The parts of a condition, from left to right; of none, if there is no condition."""
    match tree:
        case None:
            return
        case Part():
            yield tree
        case Joined(parts=parts):
            for item in parts:
                yield from parts_in(item)
        case Denied(part=part):
            yield from parts_in(part)
        case _:
            assert_never(tree)


@dataclass(frozen=True, slots=True)
class Asked:
    """A system with a probe around each part of a condition.

    `conditions` are those of the transitions, by role and number; `parts` are by the numbers of the probes.
    """

    system: System
    conditions: Mapping[tuple[str, int], Tree]
    parts: tuple[Part, ...]


def asked(system: System) -> Asked:
    """The system with a probe around each part of each condition of its roles."""
    parts: list[Part] = []
    conditions: dict[tuple[str, int], Tree] = {}
    charts = []
    for chart in system.iacs:
        transitions = list(chart.transitions)
        for number, item in enumerate(transitions):
            reader = _Reader(chart, number, parts)
            written = item.expression
            if written.draw is not None:
                if written.condition is not None:
                    conditions[chart.name, number] = reader.condition(written.condition)[1]
                changed = replace(written, draw=rewritten(written.draw, reader.inside))
            elif written.condition is not None:
                condition, tree = reader.condition(written.condition)
                conditions[chart.name, number] = tree
                looked_at = _with_all(condition, tree)
                changed = replace(written, condition=shown_as(looked_at, value_text(written.condition)))
            else:
                continue
            transitions[number] = replace(item, expression=changed)
        charts.append(replace(chart, transitions=tuple(transitions)))
    return Asked(replace(system, iacs=tuple(charts)), conditions, tuple(parts))


class _Reader:
    """Puts probes into the condition of one transition."""

    def __init__(self, chart: Statechart, number: int, parts: list[Part]) -> None:
        self._chart = chart
        self._number = number
        self._source = chart.transitions[number].source
        self._region = chart.region_of(self._source)
        self._branch = chart.branch_of(self._source) or ""
        self._parts = parts
        self._known: dict[Value, tuple[Value, Tree]] = {}

    def condition(self, value: Value) -> tuple[Value, Tree]:
        """A condition with its probes, and its parts."""
        if value not in self._known:
            self._known[value] = self._read(normal_form(value))
        return self._known[value]

    def inside(self, value: Value) -> Value:
        """The conditions in a draw, each with its probes."""
        return replace(value, operand=self.condition(value.operand)[0]) if isinstance(value, Holds) else value

    def _read(self, normal: Value) -> tuple[Value, Tree]:
        """What is in normal form, with its probes, and its parts."""
        if isinstance(normal, Logic):
            read = [self._read(item) for item in normal.operands]
            joined = replace(normal, operands=tuple(item for item, _ in read))
            return joined, Joined(normal.operator == "&&", tuple(tree for _, tree in read))
        negated = isinstance(normal, Not)
        value = normal.operand if isinstance(normal, Not) else normal
        inner = meant(value)
        if isinstance(inner, Holds):
            inside, tree = self._read(normal_form(inner.operand))
            holds = replace(inner, operand=inside)
            return (Not(holds, holds.span), Denied(tree)) if negated else (holds, tree)
        said = tuple(dict.fromkeys((str(item.channel), item.host) for item in _said(value)))
        asks = any(isinstance(item, Bound | Sender | LossReason) for item in walk(value))
        place = (self._number, self._region, self._branch)
        part = Part(len(self._parts), self._fact(value), value, negated, *place, said, asks)
        self._parts.append(part)
        return around(normal, part.number), part

    def _fact(self, value: Value) -> Fact:
        """Where something in it depends on the transition, or on its source, that belongs to the fact."""
        place: list[str] = []
        for item in walk(value):
            match item:
                case Bound() | Sender() | LossReason():
                    place.append(str(self._number))
                case StateValue(state=state):
                    place += (node.label for node in states_meant(self._chart, self._source, state))
                case Outcome(activity=activity):
                    place += (node.label for node in performers(self._chart, self._source, activity))
                case RoundValue():
                    place.append(self._branch)
        return (self._chart.name, self._region, value_text(rewritten(value, meant)), *place)


def _said(value: Value) -> Iterator[Member]:
    """The messages of channels of which a value depends on what they say; that they are there is not that."""
    if isinstance(value, Has | Age):
        return
    if isinstance(value, Member):
        yield value
    for item in operands(value):
        yield from _said(item)


def _with_all(condition: Value, tree: Tree) -> Value:
    """The condition, behind its parts, which are all looked at; they decide nothing there."""
    if isinstance(tree, Part):
        return condition
    span = condition.span
    asked = [item for item in walk(condition) if is_probe(item) and not _may_raise(item)]
    looked_at = (Logic("||", (item, Literal(True, BOOL, span)), span) for item in asked)
    return Logic("&&", (*looked_at, condition), span)


def _may_raise(value: Value) -> bool:
    for item in walk(value):
        if isinstance(item, Call) and item.function.is_of_document:
            return True
        if isinstance(item, Arithmetic) and item.operator in ("/", "%"):
            return True
    return False


__all__ = ["Asked", "Denied", "Fact", "Joined", "Part", "Tree", "asked", "parts_in"]
