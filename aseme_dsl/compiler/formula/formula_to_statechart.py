"""Formula to statechart: the template of every operator (P1, section 4.3), expanded node by node.

The result is an outline: states, and arrows that say which way of which term they are. `control` turns the
arrows into transitions. Formulas may be nested hundreds deep, so nothing here recurses.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import field, replace
from types import MappingProxyType
from typing import assert_never

from aseme_dsl.amola.aip import DeclaredVariable
from aseme_dsl.amola.expression import INSTANCE, Literal, Named, Value, VariableValue, substituted, value_text
from aseme_dsl.amola.liveness import Formula, called, canonical, fold, names, ungrouped, walk
from aseme_dsl.amola.messages import INT
from aseme_dsl.amola.operators import Operator, Template
from aseme_dsl.amola.statechart import Argument, Origin, OriginKind, State, StateType
from aseme_dsl.compiler.formula.formulas import Formulas, dependencies_first
from aseme_dsl.compiler.formula.renames import SAME, Renames, rename_value
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.formulas import TooManyStates
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

FRAME = 3
"""So many states stand around a participant that another one plays."""

LARGEST = 50_000
"""The size limit of one statechart, in states, unless told otherwise."""

Way = tuple[str, Formula]
"""A verb and the term (without parentheses) that it concerns: what the arrow is called in `control`."""


@dataclass(frozen=True, slots=True)
class Arrow:
    """A transition without its expression. `branch` is the label of the protocol branch that it is in.

    One that is `first` leads to what cuts its source short. `values` are what the parameters of its formula
    stand for.
    """

    source: str
    target: str
    name: str
    way: Way
    branch: str | None
    origin: Origin
    span: Span
    first: bool = False
    values: Mapping[str, Value] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Branch:
    """The process of one participant of a protocol, as it stands in every chart where it is played.

    `bindings` gives the protocol's abstract activities the names of the role's own, `supplied` the values of
    its `inputs`, and `results` the variables that get its results. `played_at` is where a role plays it.
    """

    protocol: str
    participant: str
    formulas: Formulas
    bindings: Mapping[str, str] = field(default_factory=dict)
    variables: tuple[str, ...] = ()
    inputs: tuple[DeclaredVariable, ...] = ()
    supplied: Mapping[str, Value] = field(default_factory=dict)
    results: Mapping[str, str] = field(default_factory=dict)
    played: Mapping[str, Branch] = field(default_factory=dict)
    """The participants of other protocols that it plays itself."""
    played_at: Span | None = None

    @property
    def origin(self) -> Origin:
        return Origin(OriginKind.PROTOCOL, self.protocol, self.participant)

    def names_at(self, label: str, around: _Context) -> Renames:
        """The meaning of the participant's names in its subchart `label`, which stands in `around`.

        An input without an argument is a variable: this occurs only in the protocol's own statechart.
        """
        inputs: dict[str, Value] = {}
        for item in self.inputs:
            value = self.supplied.get(item.name)
            if value is None:
                inputs[item.name] = VariableValue(f"{item.name}@{label}", item.type, item.span)
            else:
                value = rename_value(substituted(value, around.values), around.names)
                inputs[item.name] = Named(item.name, value, item.type, value.span)
        activities = {name: around.own(own) for name, own in self.bindings.items()}
        return Renames({name: f"{name}@{label}" for name in self.variables}, activities, inputs)


@dataclass(frozen=True, slots=True)
class Standing:
    """A state that stands for a term (without parentheses); `branch` is the protocol branch that it is in.

    `values` are what the parameters of the formula stand for in which the term stands.
    """

    label: str
    name: str
    term: Formula
    branch: str | None
    origin: Origin
    values: Mapping[str, Value] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Outline:
    """States in document order, arrows in the template's order, and the protocol branches by label.

    `names` says for each branch what its names mean in the chart, `results` which variables of what is around
    it get those of the branch when it is complete. `instances` says in which instance each branch is.
    `standing` are the states of terms: all but the points, the regions and what is around them.
    """

    nodes: tuple[State, ...]
    arrows: tuple[Arrow, ...]
    branches: Mapping[str, Branch]
    standing: tuple[Standing, ...]
    names: Mapping[str, Renames] = field(default_factory=dict)
    results: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    instances: Mapping[str, Mapping[str, Value]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class _Context:
    """Whose formula is being expanded: what its names mean, and from where its states come."""

    formulas: Formulas
    origin: Origin
    played: Mapping[str, Branch]
    branch: str | None
    bindings: Mapping[str, str]
    values: Mapping[str, Value] = field(default_factory=dict)
    """What the parameters of the formula stand for."""
    names: Renames = SAME
    """What the names of the branch mean in the chart."""
    outer: _Context | None = None
    """Of a branch, the context of who plays it: what its bindings name is in terms of that."""

    @property
    def instance(self) -> dict[str, Value]:
        """The number of the instance that this is in, as one of `values`."""
        return {INSTANCE: self.values[INSTANCE]} if INSTANCE in self.values else {}

    def numbered(self, number: int, span: Span) -> _Context:
        """The context of an instance."""
        return replace(self, values={**self.values, INSTANCE: Literal(number, INT, span)})

    def given(self, term: Formula) -> tuple[Argument, ...]:
        """What a name is given, in terms of the chart."""
        found = self.formulas.given.get(term, ())
        if not self.values:
            return found
        return tuple(Argument(item.name, substituted(item.value, self.values)) for item in found)

    def given_in_chart(self, term: Formula) -> tuple[Argument, ...]:
        """The same, with the names that the chart has for what belongs to the branch."""
        return tuple(replace(item, value=rename_value(item.value, self.names)) for item in self.given(term))

    def own(self, name: str) -> str:
        """What an activity of this is called where the outermost participant is played."""
        bound = self.bindings.get(name)
        if bound is None:
            return name
        return bound if self.outer is None else self.outer.own(bound)

    def bound(self, term: Formula) -> tuple[Formula, _Context] | None:
        """The formula that is bound to an activity of the protocol, and the context that it is in."""
        name, context = term.name, self
        formula: Formula | None = None
        while formula is None:
            bound = context.bindings.get(name)
            if context.outer is None or bound is None:
                return None
            name, context = bound, context.outer
            formula = context.formulas.formula(name)
        values: dict[str, Value] = self.instance
        parameters = context.formulas.parameters.get(name, ())
        for parameter, item in zip(parameters, self.given_in_chart(term), strict=False):
            values[parameter.name] = item.value
        origin = Origin(OriginKind.FORMULA, context.formulas.owner, name)
        return formula, replace(context, origin=origin, values=values or _NOTHING)

    def inside(self, term: Formula) -> _Context:
        """The context of the formula that a name stands for."""
        values = {item.name: item.value for item in self.given(term)} | self.instance or _NOTHING
        if self.branch is not None:
            return self if values == self.values else replace(self, values=values)
        origin = Origin(OriginKind.FORMULA, self.formulas.owner, term.name)
        return _Context(self.formulas, origin, self.played, None, self.bindings, values)


@dataclass(frozen=True, slots=True)
class _Place:
    """A term that is to stand as the node `label`."""

    label: str
    parent: str | None
    term: Formula
    context: _Context
    framed: bool = False
    """Whether it stands in a frame of its own: see `_Builder.frame`."""


def expand_role(formulas: Formulas, played: Mapping[str, Branch], span: Span) -> Outline:
    """The chart of a role: its root formula, with the branches of the participants that it plays woven in."""
    origin = Origin(OriginKind.FORMULA, formulas.owner, formulas.root)
    context = _Context(formulas, origin, played, None, {})
    outline = _Builder()
    root = formulas.named[formulas.root].formula
    outline.nodes.append(State("0", formulas.root, StateType.OR, None, None, origin, span))
    outline.expand(outline.template("0", root, context))
    return outline.finish()


def expand_protocol(protocol: str, branches: Iterable[tuple[str, Branch, Span]], span: Span) -> Outline:
    """The chart of a protocol: an AND named after it, with a region for each participant (P1, Figure 5).

    `branches` are the participants' names and processes with the places that the states point to.
    """
    outline = _Builder()
    origin = Origin(OriginKind.PROTOCOL, protocol, "")

    def node(label: str, name: str, kind: StateType, parent: str | None, place: Span) -> State:
        return State(label, name, kind, parent, None, origin, place)

    items: list[State | _Place] = [
        node("0", protocol, StateType.OR, None, span),
        node("0.1", "0.1", StateType.START, "0", span),
        node("0.2", protocol, StateType.AND, "0", span),
    ]
    frame = Formula(Operator.PARALLEL, (), span)
    outline.arrow("0.1", "0.1", "0.2", protocol, ("start", frame), None, origin, span)
    outline.arrow("0.2", protocol, "0.3", "0.3", ("finish", frame), None, origin, span)
    for number, (name, branch, place) in enumerate(branches, 1):
        region = f"0.2.{number}"
        start, inside, end = f"{region}.1", f"{region}.2", f"{region}.3"
        term = Formula(Operator.NAME, (), place, name)
        context = _Context(Formulas(protocol, ""), origin, {name: branch}, None, {})
        items += [
            node(region, name, StateType.OR, "0.2", place),
            node(start, start, StateType.START, region, place),
            _Place(inside, region, term, context),
            node(end, end, StateType.END, region, place),
        ]
        outline.arrow(start, start, inside, name, ("enter", term), None, origin, place)
        outline.arrow(inside, name, end, end, ("leave", term), None, origin, place)
    items.append(node("0.3", "0.3", StateType.END, "0", span))
    outline.expand(items)
    return outline.finish()


_NOTHING: Mapping[str, Value] = MappingProxyType({})


class _Builder:
    """The outline while it grows."""

    def __init__(self) -> None:
        self.nodes: list[State] = []
        self.arrows: list[Arrow] = []
        self.branches: dict[str, Branch] = {}
        self.names: dict[str, Renames] = {}
        self.results: dict[str, dict[str, str]] = {}
        self.instances: dict[str, Mapping[str, Value]] = {}
        self.standing: list[Standing] = []
        self._spellings: dict[tuple[Formula, int, int], str] = {}

    def finish(self) -> Outline:
        return Outline(
            tuple(self.nodes),
            tuple(self.arrows),
            self.branches,
            tuple(self.standing),
            self.names,
            self.results,
            self.instances,
        )

    def arrow(
        self,
        source: str,
        source_name: str,
        target: str,
        target_name: str,
        way: Way,
        branch: str | None,
        origin: Origin,
        span: Span,
        first: bool = False,
        values: Mapping[str, Value] = _NOTHING,
    ) -> None:
        name = f"{source_name}TO{target_name}"
        self.arrows.append(Arrow(source, target, name, way, branch, origin, span, first, values))

    def expand(self, items: list[State | _Place]) -> None:
        """Add the nodes of `items` with everything in them, in document order."""
        stack = items[::-1]
        while stack:
            item = stack.pop()
            if isinstance(item, State):
                self.nodes.append(item)
            else:
                stack += self.place(item)[::-1]

    def place(self, place: _Place) -> list[State | _Place]:
        """Add the node of a term; what is to stand inside it."""
        label, parent, term, context = place.label, place.parent, ungrouped(place.term), place.context
        name = self.name_of(place.term, context)
        self.standing.append(Standing(label, name, term, context.branch, context.origin, context.values))
        inside: Formula | None = term
        kind, activity = StateType.OR, None
        given: tuple[Argument, ...] = ()
        if term.operator is Operator.NAME:
            given = context.given_in_chart(term)
            inside = context.formulas.formula(term.name)
            if inside is not None:
                context = context.inside(term)
            elif term.name in context.played:
                if context.branch is not None and not place.framed:
                    self.nodes.append(State(label, name, kind, parent, None, context.origin, term.span))
                    return self.frame(label, name, term, context)
                branch = context.played[term.name]
                context = self.enter(label, branch, context)
                inside = branch.formulas.named[branch.formulas.root].formula
            elif (bound := context.bound(term)) is not None:
                inside, context = bound
            else:
                kind, activity = StateType.BASIC, context.own(term.name)
        self.nodes.append(State(label, name, kind, parent, activity, context.origin, place.term.span, given))
        return self.template(label, inside, context) if inside is not None else []

    def frame(self, label: str, name: str, term: Formula, context: _Context) -> list[State | _Place]:
        """The states inside a participant that another one plays: its branch between two points.

        So the transitions of the participant around it begin and end at a state of that one's own.
        """
        start, inside, end = f"{label}.1", f"{label}.2", f"{label}.3"
        origin, span, branch = context.origin, term.span, context.branch
        frame = Formula(Operator.PARALLEL, (), span)
        self.arrow(start, start, inside, name, ("start", frame), branch, origin, span)
        self.arrow(inside, name, end, end, ("finish", frame), branch, origin, span)
        return [
            State(start, start, StateType.START, label, None, origin, span),
            _Place(inside, label, term, context, framed=True),
            State(end, end, StateType.END, label, None, origin, span),
        ]

    def enter(self, label: str, branch: Branch, around: _Context) -> _Context:
        """The context of the process of a participant that stands at `label`."""
        self.branches[label] = branch
        self.instances[label] = around.instance
        names = self.names[label] = branch.names_at(label, around)
        targets = around.names.variables
        self.results[label] = {
            names.variables[own]: targets.get(target, target) for own, target in branch.results.items()
        }
        return _Context(
            branch.formulas,
            branch.origin,
            branch.played,
            label,
            branch.bindings,
            around.instance,
            names,
            around,
        )

    def name_of(self, term: Formula, context: _Context) -> str:
        """A state is called like the formula or activity that it is, or like its term is written."""
        inner = ungrouped(term)
        if inner.operator is Operator.NAME:
            is_formula = context.formulas.formula(inner.name) is not None
            name = inner.name if is_formula else context.own(inner.name)
            return called(name, (value_text(item.value) for item in context.given(inner)))
        key = (term, id(context.bindings), id(context.values))
        spelling = self._spellings.get(key)
        if spelling is None:
            changes = context.bindings or context.formulas.given
            bound = fold(term, _bound(context)) if changes else term
            spelling = self._spellings[key] = canonical(bound)
        return spelling

    def template(self, label: str, formula: Formula, context: _Context) -> list[State | _Place]:
        """The children of the node `label` that holds `formula`, in order; their arrows are added."""
        formula = ungrouped(formula)
        while formula.operator is Operator.NAME:
            inside = context.formulas.formula(formula.name)
            if inside is None:
                break
            context, formula = context.inside(formula), ungrouped(inside)
        return _Level(self, label, formula, context).filled()


_Point = tuple[str, str]
"""The label and the name of a state."""


class _Level:
    """The children of one node, by the template of its formula's operator."""

    def __init__(self, builder: _Builder, label: str, formula: Formula, context: _Context) -> None:
        self._builder = builder
        self._label = label
        self._formula = formula
        self._context = context
        self._children: list[State | _Place] = []

    def filled(self) -> list[State | _Place]:
        """The children, in order; the transitions between them are added to the builder."""
        start = self._point(1, StateType.START)
        template = self._formula.operator.row.template
        match template:
            case Template.CHAIN:
                self._chain(start)
            case Template.BRANCHES:
                self._branches(start)
            case Template.CUT:
                self._cut(start)
            case Template.REGIONS:
                self._regions(start)
            case Template.BODY:
                self._body(start)
            case Template.ACTIVITY:
                self._activity(start)
            case Template.INSIDE | Template.UNDECIDED:
                raise AssertionError("neither parentheses nor holes are expanded")
            case _:
                assert_never(template)
        return self._children

    # ---- the templates -----------------------------------------------------------------------

    def _chain(self, start: _Point) -> None:
        operands = self._formula.operands
        before = start
        for number, operand in enumerate(operands, 2):
            after = self._term(number, operand)
            self._arrow(before, after, "enter", operand)
            before = after
        self._arrow(before, self._point(len(operands) + 2, StateType.END), "leave", operands[-1])

    def _branches(self, start: _Point) -> None:
        operands = self._formula.operands
        choice = self._point(2, StateType.CONDITION)
        terms = [self._term(number, operand) for number, operand in enumerate(operands, 3)]
        end = self._point(len(operands) + 3, StateType.END)
        self._arrow(start, choice, "start", self._formula)
        for operand, target in zip(operands, terms, strict=True):
            self._arrow(choice, target, "enter", operand)
        for operand, source in zip(reversed(operands), reversed(terms), strict=True):
            self._arrow(source, end, "leave", operand)

    def _cut(self, start: _Point) -> None:
        first, interrupts = self._formula.operands[0], self._context.formulas.interrupts(self._formula)
        body = self._term(2, first)
        others = [self._term(number, operand) for number, operand in enumerate(interrupts, 3)]
        end = self._point(len(interrupts) + 3, StateType.END)
        self._arrow(start, body, "enter", first)
        for operand, other in zip(interrupts, others, strict=True):
            self._arrow(body, other, "enter", operand, first=True)
        self._arrow(body, end, "leave", first)
        for operand, other in zip(interrupts, others, strict=True):
            self._arrow(other, end, "leave", operand)

    def _regions(self, start: _Point) -> None:
        formula, label = self._formula, self._label
        counted = formula.operator.row.counted
        parallel = f"{label}.2", self._builder.name_of(formula, self._context)
        end = f"{label}.3", f"{label}.3"
        self._arrow(start, parallel, "start", formula)
        self._arrow(parallel, end, "finish", formula)
        self._node(*parallel, StateType.AND, label)
        parts = formula.operands * formula.count if counted else formula.operands
        for number, operand in enumerate(parts, 1):
            context = self._context.numbered(number, formula.span) if counted else self._context
            self._region(f"{parallel[0]}.{number}", parallel[0], operand, context)
        self._node(*end, StateType.END, label)

    def _region(self, region: str, parallel: str, operand: Formula, context: _Context) -> None:
        first, last = (f"{region}.1", f"{region}.1"), (f"{region}.3", f"{region}.3")
        body = f"{region}.2", self._builder.name_of(operand, context)
        self._node(region, region, StateType.OR, parallel)
        self._node(*first, StateType.START, region)
        self._children.append(_Place(body[0], region, operand, context))
        self._node(*last, StateType.END, region)
        self._arrow(first, body, "enter", operand, inside=context)
        self._arrow(body, last, "leave", operand, inside=context)

    def _body(self, start: _Point) -> None:
        row, operand = self._formula.operator.row, self._formula.operands[0]
        choice = self._point(2, StateType.CONDITION) if row.skips else start
        body = self._term(len(self._children) + 1, operand)
        has_end = row.skips or row.leaves
        end = self._point(len(self._children) + 1, StateType.END) if has_end else start
        if row.skips:
            self._arrow(start, choice, "start", self._formula)
            self._arrow(choice, body, "enter", operand)
        else:
            self._arrow(start, body, "start", self._formula)
        if row.repeats:
            self._arrow(body, body, "repeat", operand)
        if row.skips:
            self._arrow(choice, end, "skip", operand)
        if row.leaves:
            self._arrow(body, end, "leave", operand)

    def _activity(self, start: _Point) -> None:
        """The whole is one activity, or one participant that is played."""
        body = self._term(2, self._formula)
        self._arrow(start, body, "enter", self._formula)
        self._arrow(body, self._point(3, StateType.END), "leave", self._formula)

    # ---- their pieces ------------------------------------------------------------------------

    def _node(self, child: str, name: str, kind: StateType, parent: str) -> None:
        span = self._formula.span
        self._children.append(State(child, name, kind, parent, None, self._context.origin, span))

    def _point(self, number: int, kind: StateType) -> _Point:
        child = f"{self._label}.{number}"
        self._node(child, child, kind, self._label)
        return child, child

    def _term(self, number: int, operand: Formula) -> _Point:
        child = f"{self._label}.{number}"
        self._children.append(_Place(child, self._label, operand, self._context))
        return child, self._builder.name_of(operand, self._context)

    def _arrow(
        self,
        source: _Point,
        target: _Point,
        verb: str,
        of: Formula,
        *,
        first: bool = False,
        inside: _Context | None = None,
    ) -> None:
        way = (verb, ungrouped(of))
        context = self._context
        values = (inside or context).values
        self._builder.arrow(*source, *target, way, context.branch, context.origin, of.span, first, values)


def _bound(context: _Context) -> Callable[[Formula, Sequence[Formula]], Formula]:
    """For `fold`: the formula with the role's own activities, and what they are given, as in the chart."""

    def combine(node: Formula, operands: Sequence[Formula]) -> Formula:
        name = node.name
        if node.operator is Operator.NAME and context.formulas.formula(name) is None:
            name = context.own(name)
        texts = [value_text(item.value) for item in context.given(node)]
        arguments = tuple(
            replace(argument, text=text) for argument, text in zip(node.arguments, texts, strict=False)
        )
        return replace(node, operands=tuple(operands), name=name, arguments=arguments)

    return combine


# ---- size ---------------------------------------------------------------------------------------


def sizes(
    formulas: Formulas,
    branches: Mapping[str, Branch],
    bound: Mapping[str, int] = MappingProxyType({}),
    frame: int = 0,
) -> dict[str, int]:
    """How many states each formula's own state has, itself included.

    `branches` are the participants that are played, each with `frame` states around it, `bound` the states of
    the formulas that are bound to activities.
    """
    inside: dict[str, int] = {}  # the states in a node that holds the formula

    def branch_size(name: str) -> int:
        branch = branches[name]
        own = {
            activity: inside[formula] + 1
            for activity, formula in branch.bindings.items()
            if formula in inside  # those come first: see `Formulas.through`
        }
        own |= {activity: bound[outer] for activity, outer in branch.bindings.items() if outer in bound}
        return sizes(branch.formulas, branch.played, own, FRAME)[branch.formulas.root]

    def of(node: Formula, operands: Sequence[tuple[int, int]]) -> tuple[int, int]:
        """(states of the term as an operand, states in a node that holds it)"""
        if node.operator is Operator.GROUP:
            return operands[0]
        if node.operator is Operator.NAME:
            if node.name not in inside:
                own = frame + branch_size(node.name) if node.name in branches else bound.get(node.name, 1)
                return own, own + 2
            within = inside[node.name]
        else:
            row = node.operator.row
            if node in formulas.separate:  # they stand beside what they interrupt
                states = sum(own for own, _ in operands)
                return states, states
            times = node.count if row.counted else 1
            within = times * sum(states + row.states_each for states, _ in operands) + row.states
        return within + 1, within

    for name in dependencies_first(formulas):
        inside[name] = fold(formulas.named[name].formula, of)[1]
    return {name: states + 1 for name, states in inside.items()}


def too_large(
    formulas: Formulas,
    branches: Mapping[str, Branch],
    largest: int,
    span: Span,
    regions: int = 1,
    frame: int = 0,
) -> Diagnostic | None:
    """E304 for a chart of more than `largest` states, with the chain of formulas that blows it up.

    `regions` is how often the whole stands in the chart, each time in a region of its own. `frame` is as in
    `sizes`.
    """
    states = sizes(formulas, branches, frame=frame)
    total = states[formulas.root] if regions == 1 else regions * (states[formulas.root] + 3)
    if total <= largest:
        return None
    heavy: list[tuple[str, int]] = []
    related: list[Related] = []
    name: str | None = formulas.root
    while name is not None:
        heavy.append((name, states[name]))
        heaviest, name = name, None
        shares: dict[str, int] = {}
        first: dict[str, Formula] = {}
        for node, times in _occurrences(formulas.named[heaviest].formula):
            if node.name in states:
                shares[node.name] = shares.get(node.name, 0) + times * states[node.name]
                first.setdefault(node.name, node)
        if shares:
            name = max(shares, key=lambda other: shares[other])
            if shares[name] * 2 < states[heaviest]:
                break
            times = shares[name] // states[name]
            how_often = "once" if times == 1 else f"{times} times"
            related.append(Related(first[name].span, f"`{heaviest}` uses `{name}` {how_often}"))
    problem = TooManyStates(formulas.owner, total, largest, tuple(heavy))
    return Diagnostic(problem, span, tuple(related))


def _occurrences(formula: Formula) -> Iterable[tuple[Formula, int]]:
    """The names in a formula, each with how often it is expanded (instances count)."""
    if not any(node.operator.row.counted for node in walk(formula)):
        return ((node, 1) for node in names(formula))
    found: list[tuple[Formula, int]] = []
    stack = [(formula, 1)]
    while stack:
        node, times = stack.pop()
        if node.operator is Operator.NAME:
            found.append((node, times))
        elif node.operator.row.counted:
            times *= node.count
        stack += [(operand, times) for operand in reversed(node.operands)]
    return found


__all__ = [
    "FRAME",
    "LARGEST",
    "Arrow",
    "Branch",
    "Outline",
    "Standing",
    "Way",
    "expand_protocol",
    "expand_role",
    "sizes",
    "too_large",
]
