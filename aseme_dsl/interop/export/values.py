"""Conditions and values in the terms of a machine: three-valued logic as two-valued conditions."""

from __future__ import annotations

from dataclasses import field, replace

from aseme_dsl.amola.expression import (
    Age,
    Arithmetic,
    At,
    Bound,
    Call,
    Compare,
    Conditional,
    EnumConstant,
    Expired,
    Has,
    Holds,
    Index,
    Literal,
    Logic,
    LossReason,
    Mean,
    Member,
    Named,
    Negate,
    Not,
    Outcome,
    Random,
    RoundValue,
    Sender,
    StateValue,
    Value,
    VariableValue,
    value_text,
    walk,
)
from aseme_dsl.amola.meant import performers, states_meant
from aseme_dsl.amola.messages import BOOL, DOUBLE, DURATION, INT, ChannelKind, Kind, Type
from aseme_dsl.amola.statechart import State, Statechart, StateType
from aseme_dsl.diagnostics.problems.exporting import Foreign
from aseme_dsl.interop.export.machine import (
    ALWAYS,
    NEVER,
    Cond,
    Const,
    Datum,
    In,
    Op,
    Pick,
    Present,
    Ref,
    Sign,
    Term,
    Test,
    Truth,
    asks_for_states,
    both,
    either,
    opposite,
)
from aseme_dsl.interop.export.names import Names
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

PLAIN = (Kind.BOOL, Kind.INT, Kind.DOUBLE, Kind.STRING, Kind.DURATION, Kind.ENUM)
"""The types of which every engine has values."""

_BUILT_IN = {"abs": Sign.ABSOLUTE, "min": Sign.SMALLEST, "max": Sign.LARGEST}
_LISTED = (Kind.LIST, Kind.BYTES)


@dataclass
class Values:
    """The values of one chart. What cannot be said is noted in `refused`, with its place."""

    chart: Statechart
    names: Names
    changed: frozenset[str]
    """The variables that the chart itself changes."""
    published: frozenset[str]
    """The channels that it publishes on."""
    refused: dict[tuple[Foreign, str, int], tuple[Foreign, Span]] = field(default_factory=dict)
    inputs: dict[str, Datum] = field(default_factory=dict)

    def refuse(self, feature: Foreign, span: Span) -> None:
        self.refused.setdefault((feature, span.source.path, span.start), (feature, span))

    # ---- conditions ---------------------------------------------------------------------

    def truth(self, value: Value, source: str) -> Cond:
        """Whether the value, in a transition out of `source`, is true: neither false nor absent."""
        return self._is(value, source, True)

    def _is(self, value: Value, source: str, wanted: bool) -> Cond:
        match value:
            case Literal(value=constant):
                return ALWAYS if constant is wanted else NEVER
            case Named(expression=inner):
                return self._is(inner, source, wanted)
            case Not(operand=inner):
                return self._is(inner, source, not wanted)
            case Logic(operator=operator, operands=parts):
                join = both if (operator == "&&") is wanted else either
                return join(*(self._is(part, source, wanted) for part in parts))
            case Holds(operand=inner):
                found = self._is(inner, source, True)
                return found if wanted else opposite(found)
            case Has(message=message):
                found = self.presence(message, source)
                return found if wanted else opposite(found)
            case StateValue():
                found = self._state(value, source)
                return found if wanted else opposite(found)
            case Conditional(condition=condition, yes=yes, no=no):
                return either(
                    both(self._is(condition, source, True), self._is(yes, source, wanted)),
                    both(self._is(condition, source, False), self._is(no, source, wanted)),
                )
        found = Truth(self.term(value, source))
        return both(self.presence(value, source), found if wanted else opposite(found))

    def presence(self, value: Value, source: str) -> Cond:
        """Whether a value is there."""
        match value:
            case Literal() | EnumConstant() | Has() | Holds() | StateValue() | Expired() | Index():
                return ALWAYS
            case Named(expression=inner) | Negate(operand=inner):
                return self.presence(inner, source)
            case Not() | Logic():
                return either(self._is(value, source, True), self._is(value, source, False))
            case Conditional(condition=condition, yes=yes, no=no):
                return either(
                    both(self._is(condition, source, True), self.presence(yes, source)),
                    both(self._is(condition, source, False), self.presence(no, source)),
                )
            case Compare(left=left, right=right) | Arithmetic(left=left, right=right):
                return both(self.presence(left, source), self.presence(right, source))
            case Call(arguments=arguments) if _built_in(value) is not None:
                return both(*(self.presence(item, source) for item in arguments))
            case VariableValue():
                return ALWAYS
        term = self.term(value, source)
        return Present(term) if isinstance(term, Ref) else ALWAYS

    def complete(self, state: State) -> Cond:
        """Whether an active state is complete."""
        match state.type:
            case StateType.BASIC:
                return NEVER if state.waits else Truth(Ref(self.names.flag("done", state)))
            case StateType.OR:
                end = self.chart.end_of(state.label)
                return In(self.names.id_of(end)) if end is not None else NEVER
            case StateType.AND:
                return both(*(self.complete(region) for region in self.chart.children(state.label)))
            case StateType.START | StateType.CONDITION:
                return ALWAYS
            case StateType.END:
                return NEVER

    def _state(self, value: StateValue, source: str) -> Cond:
        """`in(T)` and `done(T)`."""
        if value.question == "count":
            self.refuse(Foreign.COUNTING, value.span)
            return NEVER
        found = []
        for state in states_meant(self.chart, source, value.state):
            if self._is_beside(state, source):
                self.refuse(Foreign.INSIDE, value.span)
            active = In(self.names.id_of(state))
            found.append(active if value.question == "in" else both(active, self.complete(state)))
        return either(*found)

    def _is_beside(self, state: State, source: str) -> bool:
        """Whether a state is in a region concurrent to that of `source`: which moves first then counts."""
        one, other = self.chart.region_of(source), self.chart.region_of(state.label)
        return not (one == other or one.startswith(f"{other}.") or other.startswith(f"{one}."))

    # ---- values -------------------------------------------------------------------------

    def term(self, value: Value, source: str) -> Term:
        """The value itself, where it is there."""
        match value:
            case Literal(value=constant, type=kind):
                return Const(constant) if self._is_plain(kind, value.span) else Const(None)
            case EnumConstant(constant=name):
                return Const(name)
            case Named(expression=inner):
                return self.term(inner, source)
            case VariableValue(name=name, type=kind, path=path):
                plain = not path and self._is_plain(kind, value.span)
                if path:
                    self.refuse(Foreign.MESSAGES, value.span)
                return Ref(self.names.variable(name)) if plain else Const(None)
            case Negate(operand=inner):
                return Op(Sign.NEGATIVE, (self.term(inner, source),))
            case Compare(operator=operator, left=left, right=right):
                self._is_plain(left.type, value.span)
                return Op(Sign(operator), (self.term(left, source), self.term(right, source)))
            case Arithmetic():
                return self._arithmetic(value, source)
            case Conditional(condition=condition, yes=yes, no=no) if value.type != BOOL:
                chosen = self._tested(condition, value, source)
                return Pick(chosen, self.term(yes, source), self.term(no, source))
            case Not() | Logic() | Has() | Holds() | StateValue() | Conditional():
                return Test(self._tested(value, value, source))
            case Expired(timer=timer):
                return Ref(self.names.timer(self.chart.region_of(source), timer))
            case Outcome(activity=activity):
                return self._outcome(value, activity, source)
            case Member():
                return self._member(value)
            case Call(arguments=arguments):
                sign = _built_in(value)
                if sign is not None:
                    return Op(sign, tuple(self.term(item, source) for item in arguments))
                return self._fact(value)
            case Age(message=message) if isinstance(message, Member):
                return self._fact(value)
            case At() | Mean():
                return self._fact(value)
            case Index():
                return self._input("index", 1, "the number of the agent", INT, value)
            case Bound() | Sender() | LossReason() | RoundValue() | Age():
                self.refuse(Foreign.AGENT_MESSAGES, value.span)
            case Random():
                self.refuse(Foreign.RANDOM, value.span)
            case _:
                self.refuse(Foreign.LISTS, value.span)
        return Const(None)

    def _tested(self, condition: Value, value: Value, source: str) -> Cond:
        """A condition inside a value, where not every engine can ask for states."""
        found = self.truth(condition, source)
        if asks_for_states(found):
            self.refuse(Foreign.INSIDE_VALUE, value.span)
        return found

    def _is_plain(self, kind: Type, span: Span) -> bool:
        if kind.kind in PLAIN or kind.kind is Kind.OUTCOME:
            return True
        self.refuse(Foreign.LISTS if kind.kind in _LISTED else Foreign.MESSAGES, span)
        return False

    def _arithmetic(self, value: Arithmetic, source: str) -> Term:
        left, right = self.term(value.left, source), self.term(value.right, source)
        operator = value.operator
        if operator in ("/", "%") and not (isinstance(right, Const) and right.value):
            self.refuse(Foreign.DIVISION, value.span)
        if value.type == DURATION and operator == "/" and value.right.type == INT:
            return Op(Sign.FLOOR, (left, right))
        found = Op(Sign(operator), (left, right))
        cut = value.type == DURATION and DOUBLE in (value.left.type, value.right.type)
        return Op(Sign.WHOLE, (found,)) if cut else found

    def _outcome(self, value: Outcome, activity: str, source: str) -> Term:
        found = performers(self.chart, source, activity)
        if len(found) != 1:
            self.refuse(Foreign.OUTCOMES, value.span)
            return Const(None)
        return Ref(self.names.flag("outcome", found[0]))

    def _member(self, value: Member) -> Term:
        """A message on the blackboard, which is an input."""
        channel = value.channel
        if channel.comm is ChannelKind.SIGNAL:
            self.refuse(Foreign.SIGNALS, value.span)
        if str(channel) in self.published:
            self.refuse(Foreign.OWN_MESSAGES, value.span)
        if value.path and value.type.kind not in PLAIN and value.type.kind is not Kind.MESSAGE:
            self.refuse(Foreign.LISTS, value.span)
        host = f"{value.host}." if value.host else ""
        whose = f" of {value.host}" if value.host else ""
        text = f"the newest {channel.message} of {channel.topic}{whose}"
        whole = replace(value, path=())
        kind = Type(Kind.MESSAGE, channel.message)
        name = self._input(f"{host}{channel}", None, text, kind, whole).name
        return Ref(name, value.path)

    def _fact(self, value: Value) -> Term:
        """What the environment works out, and gives."""
        for part in walk(value):
            match part:
                case VariableValue(name=name) if name in self.changed:
                    self.refuse(Foreign.FUNCTIONS, value.span)
                case Member() if part.channel.comm is ChannelKind.SIGNAL:
                    self.refuse(Foreign.SIGNALS, part.span)
                case Member() if str(part.channel) in self.published:
                    self.refuse(Foreign.OWN_MESSAGES, part.span)
                case StateValue() | Outcome() | Expired() | Holds():
                    self.refuse(Foreign.FUNCTIONS, value.span)
                case Random():
                    self.refuse(Foreign.RANDOM, part.span)
                case Bound() | Sender() | LossReason() | RoundValue():
                    self.refuse(Foreign.AGENT_MESSAGES, part.span)
        text = value_text(value, expand=True)
        return self._input(text, None, text, value.type, value)

    def _input(self, key: str, initial: int | None, text: str, kind: Type, given: Value | None) -> Ref:
        known = self.inputs.get(key)
        if known is None:
            known = self.inputs[key] = Datum(self.names.input(key), initial, text, True, str(kind), given)
        return Ref(known.name)


def _built_in(value: Value) -> Sign | None:
    """The sign of a built-in function that every engine can compute."""
    if not isinstance(value, Call) or not value.function.target.startswith("builtin:"):
        return None
    return _BUILT_IN.get(value.function.name)
