"""Subcharts: a participant in a role's statechart is the one of the protocol's own statechart."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from aseme_dsl.amola.expression import (
    INSTANCE,
    Index,
    Outcome,
    StateValue,
    TransitionExpression,
    Value,
    VariableValue,
    rewritten,
    rewritten_expression,
)
from aseme_dsl.amola.statechart import Argument, State, Statechart, StateType, Transition
from aseme_dsl.amola.system import System
from aseme_dsl.proofs.certificate.agreement import NotCertified
from aseme_dsl.proofs.certificate.meaning import Context, member, same
from aseme_dsl.records import dataclass


def compare_subcharts(system: System, chart: Statechart, branches: Mapping[str, Context]) -> tuple[str, ...]:
    """The participants that stand in a role's chart, each as its protocol has it.

    Raises:
        NotCertified: a state or a transition of one is another one than that of the protocol.
    """
    found: list[str] = []
    for label, context in branches.items():
        process = context.process
        if context.outer is None or context.outer.label is not None:
            continue  # one that stands in another is compared with that
        original = system.eac(process.protocol)
        place = None if original is None else _place(original, process.participant)
        if original is None or place is None:
            raise NotCertified(f"{process.protocol} has no statechart with {process.participant}")
        _Pairs(chart, original, label, place, branches).compare()
        found.append(f"{process.protocol}.{process.participant} at {label}")
    return tuple(found)


def _place(original: Statechart, participant: str) -> str | None:
    """Where a participant stands in its protocol's own chart."""
    parallel = original.children(original.root.label)[1]
    for region in original.children(parallel.label):
        if region.name == participant:
            return original.children(region.label)[1].label
    return None


@dataclass(frozen=True, slots=True)
class _Pairs:
    """A subchart at `label` of a role's chart and the same at `place` of the protocol's chart."""

    chart: Statechart
    original: Statechart
    label: str
    place: str
    branches: Mapping[str, Context]

    def compare(self) -> None:
        """Walk through both, from the outermost state inwards."""
        pairs = [(self.chart.node(self.label), self.original.node(self.place))]
        while pairs:
            own, other = pairs.pop()
            self._states(own, other)
            if own.label != self.label:
                self._transitions(own, other)
            if own.type is StateType.OR and other.type is StateType.BASIC:
                continue  # a formula of the role stands for an activity
            inside, others = self.chart.children(own.label), self.original.children(other.label)
            if len(inside) != len(others):
                raise self._not_same(own, "holds other states")
            pairs += zip(inside, others, strict=True)

    def _states(self, own: State, other: State) -> None:
        if own.label == self.label:
            return  # it stands for the participant, in a formula of the role
        if own.span != other.span:
            raise self._not_same(own, "is another occurrence")
        if own.type is not other.type:
            is_bound = own.type is StateType.OR and other.activity is not None
            if not is_bound or self._own(other.activity or "") == other.activity:
                raise self._not_same(own, f"is {own.type}")
        elif own.activity != (None if other.activity is None else self._own(other.activity)):
            raise self._not_same(own, "has another activity")
        if not same(_values(own.arguments), tuple(map(self._value, _values(other.arguments)))):
            raise self._not_same(own, "has other arguments")

    def _transitions(self, own: State, other: State) -> None:
        there, wanted = self._of(self.chart, own), self._of(self.original, other)
        if len(there) != len(wanted):
            raise self._not_same(own, "has other transitions")
        for item, like in zip(there, wanted, strict=True):
            target = f"{self.label}{like.target[len(self.place) :]}"
            expected = self._expression(like.expression)
            extra = len(item.expression.actions) - len(expected.actions)
            actual = item.expression
            if item.target.rpartition(".")[0] == self.label and extra > 0:  # it gives the results
                actual = replace(actual, actions=actual.actions[:-extra])
            if (
                item.target != target
                or (item.kind, item.first, item.resume, item.reactive)
                != (like.kind, like.first, like.resume, like.reactive)
                or item.span != like.span
                or not same(actual, expected)
            ):
                raise self._not_same(own, f"has another transition to {item.target}")

    def _of(self, chart: Statechart, state: State) -> list[Transition]:
        staying = [item for item in chart.exits_of(state.label)]
        return [*chart.outgoing(state.label), *staying]

    def _expression(self, written: TransitionExpression) -> TransitionExpression:
        return rewritten_expression(written, self._meant)

    def _value(self, value: Value) -> Value:
        return rewritten(value, self._meant)

    def _meant(self, value: Value) -> Value:
        """What a value of the protocol's chart is in the role's chart."""
        match value:
            case VariableValue(name=name, path=path) if "@" in name:
                variable, _, place = name.partition("@")
                label = f"{self.label}{place[len(self.place) :]}"
                context = self.branches[label]
                supplied = context.inputs.get(variable)
                if supplied is None:
                    return replace(value, name=f"{variable}@{label}")
                return member(supplied, path, value.type) if path else supplied
            case Index():
                return self.branches[self.label].values.get(INSTANCE, value)
            case Outcome(activity=activity):
                return replace(value, activity=self._own(activity))
            case StateValue(state=state):
                return replace(value, state=self._own(state))
        return value

    def _own(self, activity: str) -> str:
        return self.branches[self.label].own(activity)

    def _not_same(self, own: State, what: str) -> NotCertified:
        context = self.branches[self.label]
        whole = f"{context.process.protocol}.{context.process.participant}"
        return NotCertified(
            f"the statechart of {self.chart.name}: {self.chart.title(own)} ({own.label}), {own.span}, {what}"
            f" than in {whole} of the protocol's statechart"
        )


def _values(arguments: tuple[Argument, ...]) -> tuple[Value, ...]:
    return tuple(item.value for item in arguments)


__all__ = ["compare_subcharts"]
