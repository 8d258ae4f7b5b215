"""Waking: concurrent regions that wake each other with variables, for ever, as soon as their AND is entered.

What is looked at is what surely happens: the first entry of an AND, with the initial values of the variables,
at one instant. The regions are run as the semantics says. Where something takes part that is not known here
(a message, a timer, a function), nothing is said, and the bound of the runtime stays. Regions that change one
list are reported wherever they do.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field

from aseme_dsl.amola.expression import (
    After,
    Assign,
    Changed,
    Failed,
    Random,
    Value,
    VariableValue,
    walk,
)
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition, TransitionKind
from aseme_dsl.compiler.formula.formulas import cut
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.control import ListOfTwoRegions, RegionsWakeEachOther
from aseme_dsl.proofs.evaluate import value_of
from aseme_dsl.proofs.unknowns import VARIABLE, Vocabulary
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

_ROUNDS = 1000
"""So many rounds without rest are for ever, as they are for the runtime."""

Values = dict[str, object]
"""The values of variables by name, as one region sees them."""


class _Unknown(Exception):
    """Something takes part of which nothing is known."""


def check_waking(chart: Statechart, written: frozenset[str], vocabulary: Vocabulary) -> Iterator[Diagnostic]:
    """W436: regions of one AND that wake each other without an end.

    `written` are the variables that something else than the transitions of the chart may write.
    """
    for node in chart.states:
        if node.type is StateType.AND:
            found = _Regions(chart, node, written, vocabulary).cycle()
            if found:
                yield _wake_each_other(chart, found)


def check_lists(chart: Statechart) -> Iterator[Diagnostic]:
    """W440: two regions of one AND change the same list, of which one change is lost in a common step."""
    changes: dict[str, list[tuple[str, Span]]] = {}
    for transition in chart.transitions:
        for action in transition.expression.actions:
            if isinstance(action, Assign) and isinstance(action.value, Changed):
                place = (transition.source, action.span)
                changes.setdefault(action.value.list.name, []).append(place)
    for node in chart.states:
        if node.type is not StateType.AND:
            continue
        regions = [child.label for child in chart.children(node.label)]
        for name, places in changes.items():
            first = [
                next((span for source, span in places if _is_inside(source, region)), None)
                for region in regions
            ]
            found = [span for span in first if span is not None]
            if len(found) > 1:
                problem = ListOfTwoRegions(name.partition("@")[0])
                yield Diagnostic(problem, found[1], (Related(found[0], "and here"),))


def _wake_each_other(chart: Statechart, found: Sequence[Transition]) -> Diagnostic:
    first, *others = found
    sources = [chart.node(transition.source) for transition in found]
    named = dict.fromkeys(node.name for node in sources if node.type in (StateType.BASIC, StateType.OR))
    problem = RegionsWakeEachOther(tuple(cut(name) for name in named))
    return Diagnostic(problem, first.span, tuple(Related(other.span, "by this") for other in others))


@dataclass
class _Regions:
    """The regions of an AND that is entered, until they rest or something unknown takes part."""

    chart: Statechart
    node: State
    foreign: frozenset[str]
    vocabulary: Vocabulary
    active: dict[str, str] = field(default_factory=dict)
    """The active leaf of each region."""
    seen: dict[str, Values] = field(default_factory=dict)
    """What each region sees of the variables."""
    writes: list[tuple[str, object]] = field(default_factory=list)
    taken: list[tuple[str, Transition]] = field(default_factory=list)
    """The region and transition of each round."""

    def cycle(self) -> tuple[Transition, ...]:
        """The transitions that are taken round and round; none if the regions rest or nothing is known."""
        regions = [child.label for child in self.chart.children(self.node.label)]
        writing = [label for label in regions if self._assigned(label)]
        if len(writing) < 2 or self._may_be_left():
            return ()
        for label in writing:
            start = self.chart.start_of(label)
            if start is None:
                return ()
            self.active[label] = start.label
            self.seen[label] = {}
        try:
            return self._run()
        except _Unknown:
            return ()

    def _assigned(self, region: str) -> bool:
        """Whether a region writes variables."""
        return any(
            isinstance(action, Assign) and isinstance(action.target, VariableValue)
            for transition in self.chart.transitions
            if _is_inside(transition.source, region)
            for action in transition.expression.actions
        )

    def _may_be_left(self) -> bool:
        """Whether what is around may end it at once, as far as is known."""
        around = [self.node, *self.chart.ancestors(self.node.label)]
        if any(self.chart.outgoing(child.label) for child in self.chart.children(self.node.label)):
            return True
        return any(
            transition.expression.when or any(map(_is_there_at_once, transition.expression.events))
            for state in around
            for transition in self.chart.outgoing_edges(state.label)
        )

    def _run(self) -> tuple[Transition, ...]:
        steps = 0
        for _ in range(_ROUNDS):
            if any([self._round(region) for region in self.active]):
                continue
            if not self._spread():
                return ()
            steps += 1
        last = self.taken[-_ROUNDS // 2 :]
        if not steps or len({region for region, _ in last}) < 2:
            return ()  # a region that does not rest by itself is W403
        asking = [transition for _, transition in last if transition.expression.condition is not None]
        return tuple({id(transition): transition for transition in asking}.values())

    def _spread(self) -> bool:
        """Let all regions see what was written; whether that is news to one."""
        found = dict(self.writes)
        self.writes.clear()
        news = False
        for values in self.seen.values():
            for name, value in found.items():
                news = news or self._of(values, name) != value
                values[name] = value
        return news

    def _round(self, region: str) -> bool:
        """One round of a region; whether it has moved."""
        leaf = self.chart.node(self.active[region])
        complete = leaf.type is StateType.START
        sources = [leaf]
        for state in self.chart.ancestors(leaf.label):
            if state.label == region:
                break
            sources.append(state)
        for first in (True, False):
            for source in reversed(sources) if first else sources:
                is_complete = (complete and source is leaf) or self._is_ended(source, leaf)
                way = self._open(source.label, is_complete, first=first)
                if way:
                    self._take(region, leaf, way)
                    return True
        return False

    def _is_ended(self, source: State, leaf: State) -> bool:
        return leaf.type is StateType.END and leaf.parent == source.label

    def _open(self, source: str, complete: bool, *, first: bool = False) -> tuple[Transition, ...]:
        """The first enabled outgoing transition of a state, with the branches of a choice behind it."""
        region = next(label for label in self.active if _is_inside(source, label))
        for transition in self.chart.outgoing(source):
            expression = transition.expression
            if transition.first is not first:
                continue
            if any(map(_is_there_at_once, expression.events)) or expression.every == 0:
                raise _Unknown
            if expression.every or (expression.events and not expression.when):
                continue  # nothing of that is there at the instant
            if not expression.when and not complete:
                continue
            if not self._holds(expression.condition, region):
                continue
            if transition.kind is TransitionKind.ON:
                raise _Unknown
            if self.chart.node(transition.target).type is not StateType.CONDITION:
                return (transition,)
            rest = self._open(transition.target, True)
            if rest:
                return (transition, *rest)
        return ()

    def _take(self, region: str, leaf: State, way: tuple[Transition, ...]) -> None:
        for transition in way:
            self.taken.append((region, transition))
            for action in transition.expression.actions:
                if isinstance(action, Assign) and isinstance(action.target, VariableValue):
                    self._write(region, action.target.name, action.value)
        left = [leaf, *self.chart.ancestors(leaf.label)]
        if any(self.chart.exits_of(state.label) or state.label in self.chart.abandons for state in left):
            raise _Unknown
        target = self.chart.node(way[-1].target)
        if self.chart.region_of(target.label) != region:
            raise _Unknown  # it leads out of the AND, or into a region
        while target.type is StateType.OR:
            start = self.chart.start_of(target.label)
            if start is None or way[-1].resume:
                raise _Unknown
            target = start
        if target.type is StateType.AND or self.chart.is_branch(target):
            raise _Unknown
        self.active[region] = target.label

    # ---- values -----------------------------------------------------------------------------

    def _holds(self, condition: Value | None, region: str) -> bool:
        return condition is None or self._value(condition, region) is True

    def _write(self, region: str, name: str, value: Value) -> None:
        found = self._value(value, region)
        self.seen[region][name] = found
        self.writes.append((name, found))

    def _value(self, value: Value, region: str) -> object:
        """What a value is now. Raises _Unknown where that is not known."""
        known: dict[tuple[object, ...], object] = {}
        for part in walk(value):
            if isinstance(part, Changed | Random):
                raise _Unknown
            if isinstance(part, VariableValue):
                known[VARIABLE, part.name] = self._of(self.seen[region], part.name)
        found = value_of(value, known, self.vocabulary)
        if found is None:
            raise _Unknown
        return found

    def _of(self, values: Mapping[str, object], name: str) -> object:
        """The value of a variable; its initial value if no action has written it."""
        if name in values:
            return values[name]
        if name in self.foreign or self._is_written_outside(name):
            raise _Unknown
        variable = next(item for item in self.chart.variables if item.name == name)
        found = None if variable.scope is not None else value_of(variable.initial, {}, self.vocabulary)
        if found is None:
            raise _Unknown
        return found

    def _is_written_outside(self, name: str) -> bool:
        """Whether a transition writes a variable that is not in one of these regions."""
        return any(
            isinstance(action, Assign)
            and isinstance(action.target, VariableValue)
            and action.target.name == name
            for transition in self.chart.transitions
            if not _is_inside(transition.source, self.node.label) or transition.source == self.node.label
            for action in transition.expression.actions
        )


def _is_inside(label: str, state: str) -> bool:
    return label == state or label.startswith(f"{state}.")


def _is_there_at_once(event: object) -> bool:
    """Whether an event may be there at the instant in which a state is entered, without an input."""
    return isinstance(event, Failed) or (isinstance(event, After) and event.duration == 0)


__all__ = ["check_lists", "check_waking"]
