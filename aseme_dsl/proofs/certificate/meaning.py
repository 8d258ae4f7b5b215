"""Meaning: what the names of a formula, a participant or an instance mean where it stands in a statechart."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field, fields, is_dataclass, replace

from aseme_dsl.amola.expression import (
    INSTANCE,
    Conditional,
    Element,
    Literal,
    Member,
    Named,
    Outcome,
    ParameterValue,
    StateValue,
    TransitionExpression,
    Value,
    VariableValue,
    rewritten,
    rewritten_expression,
    substituted,
    substituted_expression,
)
from aseme_dsl.amola.liveness import Formula
from aseme_dsl.amola.messages import INT, Type
from aseme_dsl.amola.statechart import Origin, OriginKind
from aseme_dsl.proofs.certificate.claim import Play, Process
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True, eq=False)
class Context:
    """Whose formula it is, with what the parameters stand for (`values`).

    In a participant, `label` is that of its subchart, and `play` says what is bound. `outer` is who plays it,
    and `inputs` is what it is given, in terms of the chart.
    """

    process: Process
    origin: Origin
    values: Mapping[str, Value] = field(default_factory=dict)
    label: str | None = None
    play: Play | None = None
    outer: Context | None = None
    inputs: Mapping[str, Value] = field(default_factory=dict)
    variables: frozenset[str] = frozenset()
    """The variables of the participant."""

    @property
    def instance(self) -> dict[str, Value]:
        number = self.values.get(INSTANCE)
        return {} if number is None else {INSTANCE: number}

    def numbered(self, number: int, span: Span) -> Context:
        """The context of an instance."""
        return replace(self, values={**self.values, INSTANCE: Literal(number, INT, span)})

    def own(self, activity: str) -> str:
        """What the outermost player calls an activity."""
        context: Context | None = self
        while context is not None and context.play is not None:
            bound = context.play.bindings.get(activity)
            if bound is None:
                return activity
            activity, context = bound, context.outer
        return activity

    def given(self, term: Formula) -> tuple[Value, ...]:
        """The arguments of a name, in which the parameters have been replaced."""
        given = self.process.given.get(term, ())
        return tuple(substituted(item.value, self.values) if self.values else item.value for item in given)

    def given_in_chart(self, term: Formula) -> tuple[Value, ...]:
        return tuple(self.value(item) for item in self.given(term))

    def inside(self, term: Formula) -> Context:
        """The context of the formula that a name of this process stands for."""
        parameters = self.process.parameters.get(term.name, ())
        values = {**dict(zip(parameters, self.given(term), strict=False)), **self.instance}
        origin = self.origin
        if self.label is None:
            origin = Origin(OriginKind.FORMULA, self.process.owner, term.name)
        return replace(self, values=values, origin=origin)

    def bound(self, term: Formula) -> tuple[Formula, Context] | None:
        """The formula of a player that is bound to an activity, with its context."""
        name, context = term.name, self
        while context.play is not None and context.outer is not None:
            bound = context.play.bindings.get(name)
            if bound is None:
                return None
            name, context = bound, context.outer
            formula = context.process.formulas.get(name)
            if formula is not None:
                parameters = context.process.parameters.get(name, ())
                values = {**self.instance, **dict(zip(parameters, self.given_in_chart(term), strict=False))}
                origin = Origin(OriginKind.FORMULA, context.process.owner, name)
                return formula, replace(context, origin=origin, values=values)
        return None

    def entered(self, play: Play, label: str, *, by_role: bool = True) -> Context:
        """The context of a participant whose subchart is `label`; its own chart supplies no inputs."""
        process = play.process
        inputs: dict[str, Value] = {}
        for item in process.inputs:
            supplied = play.inputs.get(item.name)
            if supplied is None:
                inputs[item.name] = VariableValue(f"{item.name}@{label}", item.type, item.span)
            else:
                supplied = self.value(substituted(supplied, self.values))
                inputs[item.name] = Named(item.name, supplied, item.type, supplied.span)
        origin = Origin(OriginKind.PROTOCOL, process.protocol, process.participant)
        variables = frozenset(item.name for item in process.variables)
        outer = self if by_role else None
        return Context(process, origin, self.instance, label, play, outer, inputs, variables)

    def expression(self, written: TransitionExpression) -> TransitionExpression:
        """A transition expression in terms of the chart."""
        if self.values:
            written = substituted_expression(written, self.values)
        return written if self.label is None else rewritten_expression(written, self._meant)

    def value(self, value: Value) -> Value:
        """A value in terms of the chart."""
        return value if self.label is None else rewritten(value, self._meant)

    def _meant(self, value: Value) -> Value:
        match value:
            case VariableValue(name=name) if name in self.variables:
                return replace(value, name=f"{name}@{self.label}")
            case ParameterValue(name=name, path=path) if name in self.inputs:
                supplied = replace(self.inputs[name], span=value.span)
                return member(supplied, path, value.type) if path else supplied
            case Outcome(activity=activity):
                return replace(value, activity=self.own(activity))
            case StateValue(state=state):
                return replace(value, state=self.own(state))
        return value


def member(message: Value, path: tuple[str, ...], kind: Type) -> Value:
    """A member of the message that an input stands for."""
    match message:
        case Named(expression=inner):
            return member(replace(inner, span=message.span), path, kind)
        case Conditional(yes=yes, no=no):
            return replace(message, yes=member(yes, path, kind), no=member(no, path, kind), type=kind)
        case VariableValue(message=of, type=whole):
            return replace(message, path=(*message.path, *path), type=kind, message=of or whole.name)
        case Member() | Element() | ParameterValue():
            return replace(message, path=(*message.path, *path), type=kind)
    raise TypeError(type(message).__name__)


_FIELDS: dict[type, tuple[str, ...]] = {}
"""The fields of each class that count: all but the place in the source; none for what is compared by `==`."""


def same(one: object, other: object) -> bool:
    """Whether two expressions, parts of expressions or tuples of them are equal, wherever they stand."""
    waiting = [(one, other)]
    while waiting:
        one, other = waiting.pop()
        if one is other:
            continue
        kind = type(one)
        if kind is not type(other):
            return False
        if isinstance(one, tuple) and isinstance(other, tuple):
            if len(one) != len(other):
                return False
            waiting += zip(one, other, strict=True)
            continue
        names = _FIELDS.get(kind)
        if names is None:
            names = tuple(item.name for item in fields(one)) if is_dataclass(one) else ()
            names = _FIELDS[kind] = tuple(name for name in names if name != "span")
        if names:
            waiting += [(getattr(one, name), getattr(other, name)) for name in names]
        elif one != other:
            return False
    return True


__all__ = ["Context", "member", "same"]
