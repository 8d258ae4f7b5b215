"""Agreement: a statechart against its formula, state by state in one walk through both.

Each state that holds others (and each region of an AND) is a level with a language of its own: the words of
steps from its START. Both languages are walked together: at every state, the transitions of the chart have to
be the derivatives of the formula, each with its expression, in their order. So they are equal, both ways.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Mapping
from dataclasses import field, replace
from typing import NoReturn, assert_never

from aseme_dsl.amola.aip import DeclaredVariable
from aseme_dsl.amola.expression import EMPTY, NEVER, Assign, TransitionExpression, Value, VariableValue
from aseme_dsl.amola.liveness import Formula, canonical, ungrouped
from aseme_dsl.amola.operators import Operator
from aseme_dsl.amola.statechart import (
    Origin,
    OriginKind,
    State,
    Statechart,
    StateType,
    Transition,
    TransitionKind,
    Variable,
    transition_text,
)
from aseme_dsl.proofs.certificate.again import LARGEST, is_compared, reactive_problem
from aseme_dsl.proofs.certificate.claim import Claims, LabelLine, Line, Play, Process, Region
from aseme_dsl.proofs.certificate.derivative import (
    Reached,
    Rest,
    Step,
    after,
    framed,
    region,
    rest_of,
    word_of,
)
from aseme_dsl.proofs.certificate.draws import draw_problem
from aseme_dsl.proofs.certificate.meaning import Context, same
from aseme_dsl.proofs.certificate.places import Placed, Places, places_of
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span


class NotCertified(Exception):
    """A statechart that is not what its source says: a bug of the compiler. The text says where."""


@dataclass(frozen=True, slots=True)
class Agreed:
    """What was compared: how many states and transitions, and the participants' subcharts in their contexts.

    `left_out` names what is not of a formula.
    """

    states: int
    transitions: int
    branches: Mapping[str, Context]
    left_out: tuple[str, ...]


@dataclass(frozen=True, slots=True, eq=False)
class _Level:
    """A state (or region) that holds others: the context and the word of what is in it.

    `run` are the names of what was done before.
    """

    label: str
    context: Context
    rest: Rest | None
    run: _Run | None


@dataclass(frozen=True, slots=True, eq=False)
class _Run:
    """What was done, the last first."""

    name: str
    before: _Run | None


@dataclass(frozen=True, slots=True)
class _Wanted:
    """A transition that a formula has: what it is, and what remains after it."""

    step: Step
    rest: Rest | None
    line: Line | LabelLine | None
    expression: TransitionExpression
    first: bool
    order: tuple[int, bool, int]
    span: Span


@dataclass(slots=True)
class Comparison:
    """One statechart and what its source says."""

    chart: Statechart
    claims: Claims
    places: dict[Process, Places]
    """Those of each process, shared by the charts of a system."""
    seen: set[str] = field(default_factory=set)
    """The labels of the states that the formula has."""
    followed: set[int] = field(default_factory=set)
    """The transitions that have been compared, by `id`."""
    branches: dict[str, Context] = field(default_factory=dict)
    left_out: list[str] = field(default_factory=list)
    waiting: deque[_Level] = field(default_factory=deque)
    reactive: dict[str, tuple[Transition, ...]] = field(default_factory=dict)
    """The branches of reactive choices, with the transitions of their choices."""
    staying: dict[str, list[Transition]] = field(default_factory=dict)
    """The transitions that lead nowhere, by state."""

    def __post_init__(self) -> None:
        for item in self.chart.transitions:
            if not item.changes_state:
                self.staying.setdefault(item.source, []).append(item)

    # ---- the whole ---------------------------------------------------------------------------

    def of_role(self, process: Process) -> Agreed:
        """Compare the chart with the formulas of its role."""
        origin = Origin(OriginKind.FORMULA, process.owner, process.root)
        context = Context(process, origin)
        self._root(process.root, origin)
        self._open("0", context, process.formulas[process.root], None)
        return self._finished(process.variables)

    def of_protocol(self, regions: tuple[Region, ...]) -> Agreed:
        """Compare the chart with the processes of the participants of its protocol."""
        name = self.chart.name
        origin = Origin(OriginKind.PROTOCOL, name, "")
        self._root(name, origin)
        assert self.chart.span is not None
        frame = Formula(Operator.PARALLEL, (), self.chart.span)
        empty = Process(name, name, "", "", "", {}, {}, {}, (), frozenset(), {}, ())
        start, parallel, end = self._children("0", (StateType.START, StateType.AND, StateType.END), origin)
        self._plain("0", "0.1", start, parallel, frame.span, origin)
        self._plain("0", "0.2", parallel, end, frame.span, origin)
        inside = self.chart.children(parallel.label)
        if len(inside) != len(regions):
            self._fail(parallel, f"it has {len(inside)} regions, and the protocol {len(regions)}", None)
        for state, item in zip(inside, regions, strict=True):
            term = Formula(Operator.NAME, (), item.span, item.name)
            context = Context(replace(empty, plays={item.name: Play(item.process)}), origin)
            self._region(state, context, term, term, None)
        return self._finished(())

    def _finished(self, variables: Iterable[DeclaredVariable]) -> Agreed:
        while self.waiting:
            self._walk(self.waiting.popleft())
        self._reactive()
        for state in self.chart.states:
            if state.label not in self.seen:
                self._fail(state, "no occurrence of the formula is this state", None)
        for transition in self.chart.transitions:
            if id(transition) not in self.followed:
                source = self.chart.node(transition.source)
                self._fail(source, f"no formula has its transition {self._shown(transition)}", None)
        self._variables(variables)
        return Agreed(
            len(self.chart.states), len(self.chart.transitions), self.branches, tuple(self.left_out)
        )

    def _root(self, name: str, origin: Origin) -> None:
        root = self.chart.root
        if root.label != "0" or root.type is not StateType.OR or root.name != name or root.origin != origin:
            self._fail(root, f"the root should be `{name}`", None)
        self.seen.add("0")

    def _children(self, label: str, kinds: tuple[StateType, ...], origin: Origin) -> tuple[State, ...]:
        inside = self.chart.children(label)
        if tuple(item.type for item in inside) != kinds or any(item.origin != origin for item in inside):
            self._fail(self.chart.node(label), f"it should hold {', '.join(kinds)}", None)
        self.seen.update(item.label for item in inside)
        return inside

    def _plain(self, level: str, name: str, source: State, target: State, span: Span, origin: Origin) -> None:
        """The only transition of a point of a protocol's own chart."""
        found = self.chart.outgoing(source.label)
        is_plain = len(found) == 1 and found[0].expression == EMPTY and not _is_special(found[0])
        if not is_plain or found[0].target != target.label:
            self._fail(source, f"it should lead to {target.label}", None)
        self._same_edge(found[0], span, origin, None)
        self.followed.add(id(found[0]))

    # ---- levels ------------------------------------------------------------------------------

    def _open(self, label: str, context: Context, formula: Formula, run: _Run | None) -> None:
        """The level of a state that holds a formula; the formula of a name stands in it directly."""
        formula = ungrouped(formula)
        while formula.operator is Operator.NAME and formula.name in context.process.formulas:
            inside = context.process.formulas[formula.name]
            context, formula = context.inside(formula), ungrouped(inside)
        word = word_of(formula, self._places(context).separate)
        self.waiting.append(_Level(label, context, rest_of(word), run))

    def _places(self, context: Context) -> Places:
        found = self.places.get(context.process)
        if found is None:
            found = self.places[context.process] = places_of(context.process)
        return found

    def _region(
        self, state: State, context: Context, operand: Formula, around: Formula, run: _Run | None
    ) -> None:
        if state.type is not StateType.OR or state.origin != context.origin:
            self._fail(state, "it should be a region", run)
        self.seen.add(state.label)
        self.waiting.append(_Level(state.label, context, rest_of(region(operand, around)), run))

    def _walk(self, level: _Level) -> None:
        """Compare the words of a level."""
        starts = [item for item in self.chart.children(level.label) if item.type is StateType.START]
        if len(starts) != 1 or starts[0].origin != level.context.origin:
            self._fail(self.chart.node(level.label), "it should have one START of its own", level.run)
        self.seen.add(starts[0].label)
        opened: dict[str, Step] = {}
        first = (starts[0].label, level.rest)
        todo: deque[tuple[State, Rest | None, _Run | None]] = deque([(starts[0], level.rest, level.run)])
        met = {first}
        while todo:
            state, rest, run = todo.popleft()
            for target, then, step in self._compared(state, rest, opened.get(state.label), level, run):
                done = run
                if step.reached in (Reached.TERM, Reached.FRAMED, Reached.AND):
                    done = _Run(target.name, run)
                if target.parent != level.label:
                    self._fail(state, f"it leads out of its formula, to {self._title(target.label)}", run)
                if target.label not in opened:
                    opened[target.label] = step
                    self._enter(target, step, level, done)
                if (target.label, then) not in met:
                    met.add((target.label, then))
                    todo.append((target, then, done))

    # ---- transitions -------------------------------------------------------------------------

    def _compared(
        self, state: State, rest: Rest | None, step: Step | None, level: _Level, run: _Run | None
    ) -> list[tuple[State, Rest | None, Step]]:
        """The states that a state leads to, each with what remains; they are what the formula says.

        `step` is how the state was reached, None for a START.
        """
        wanted, extra = self._wanted(state, rest, level)
        by_key: dict[tuple[Span, StateType, Span], list[_Wanted]] = {}
        for item in wanted:
            by_key.setdefault((item.span, _TYPES[item.step.reached], item.step.what.span), []).append(item)
        outgoing = self.chart.outgoing(state.label)
        order: list[tuple[tuple[int, bool, int], Transition]] = []
        pairs: list[tuple[State, _Wanted]] = []
        for transition in outgoing:
            if transition.reactive or not transition.changes_state:
                continue
            self.followed.add(id(transition))
            target = self.chart.by_label[transition.target]
            line = extra.pop(transition.span, None)
            if line is not None:
                order.append(self._beside(transition, line, level, run))
                continue
            kind = StateType.BASIC if target.type is StateType.OR else target.type
            same_key = by_key.get((transition.span, kind, target.span))
            if not same_key:
                self._cannot(state, transition, wanted, level, run)
            item = same_key.pop(0)
            self._same_transition(state, transition, item, level, run)
            order.append((item.order, transition))
            pairs.append((target, item))
        for left in by_key.values():
            for item in left:
                self._lacks(state, item, wanted, level, run)
        for line in extra.values():
            self._fail(state, f"it lacks the transition of line {line.line.span}", run)
        order += self._staying(state, step, level, run)
        self._in_order(state, outgoing, order, run)
        if state.type is StateType.CONDITION and step is not None:
            self._choice(state, step, level, run)
        return [(target, item.rest, item.step) for target, item in pairs]

    def _wanted(
        self, state: State, rest: Rest | None, level: _Level
    ) -> tuple[list[_Wanted], dict[Span, Placed]]:
        """The transitions that a formula has here, and the lines by label that are not of the formula."""
        places, context = self._places(level.context), level.context
        by_label = [item for item in places.labelled if self._source(item, context) == state.label]
        found: list[_Wanted] = []
        for step, then in after(rest):
            lines = places.by_edge.get(step.edge, ())
            if by_label:
                mine = [item for item in by_label if self._is_reached(item, step, context)]
                by_label = [item for item in by_label if item not in mine]
                lines = tuple(sorted((*lines, *mine), key=lambda item: item.position))
            given = self._results(level) if step.reached is Reached.END else ()
            for placed in lines:
                written = placed.line.expression
                for part in written.apart_from_errors if step.first else (written,):
                    expression = context.expression(part)
                    first = step.first and not part.is_for_errors
                    order = _rank(part, first), False, placed.position
                    if given:
                        expression = replace(expression, actions=(*expression.actions, *given))
                    found.append(_Wanted(step, then, placed.line, expression, first, order, placed.line.span))
            if not lines:
                expression = NEVER if step.first else EMPTY
                order = _rank(expression, step.first), True, len(found)
                if given:
                    expression = replace(expression, actions=given)
                found.append(_Wanted(step, then, None, expression, step.first, order, step.of.span))
        return found, {item.line.span: item for item in by_label}

    def _source(self, item: Placed, context: Context) -> str:
        assert isinstance(item.line, LabelLine)
        return f"{context.label or ''}{item.line.source}"

    def _is_reached(self, item: Placed, step: Step, context: Context) -> bool:
        """Whether the target of a line by label is what a step reaches."""
        assert isinstance(item.line, LabelLine)
        target = self.chart.by_label[f"{context.label or ''}{item.line.target}"]
        kind = StateType.BASIC if target.type is StateType.OR else target.type
        return kind is _TYPES[step.reached] and target.span == step.what.span

    def _results(self, level: _Level) -> tuple[Assign, ...]:
        """What the END of a participant's subchart gives to the variables around it."""
        context = level.context
        if context.play is None or context.outer is None or context.label != level.label:
            return ()
        span = context.play.span
        assert span is not None
        outer, types = context.outer, {item.name: item.type for item in context.process.variables}

        def around(name: str) -> str:
            is_own = outer.label is not None and any(item.name == name for item in outer.process.variables)
            return f"{name}@{outer.label}" if is_own else name

        return tuple(
            Assign(
                VariableValue(around(target), types[own], span),
                VariableValue(f"{own}@{level.label}", types[own], span),
                span,
            )
            for own, target in context.play.results.items()
        )

    def _same_transition(
        self, state: State, found: Transition, item: _Wanted, level: _Level, run: _Run | None
    ) -> None:
        """The transition has the expression, the name, the origin and the kind that the formula says."""
        expression = found.expression
        if expression.draw is not None:
            expression = replace(expression, draw=None)
        if not same(expression, item.expression):
            self._fail(
                state,
                f"its transition {self._shown(found)} should have the expression of {_line_text(item)}",
                run,
            )
        resume = isinstance(item.line, Line) and item.line.verb == "resume"
        if found.first is not item.first or found.resume is not resume:
            self._fail(state, f"its transition {self._shown(found)} is of another kind than the line", run)
        self._same_edge(found, item.span, level.context.origin, run)

    def _same_edge(self, found: Transition, span: Span, origin: Origin, run: _Run | None) -> None:
        source, target = self.chart.node(found.source), self.chart.node(found.target)
        name = f"{source.name}TO{target.name}"
        if found.span != span or found.origin != origin or found.name != name or found.into:
            self._fail(source, f"its transition {self._shown(found)} points to another place", run)

    def _beside(
        self, found: Transition, placed: Placed, level: _Level, run: _Run | None
    ) -> tuple[tuple[int, bool, int], Transition]:
        """A transition of a line by label that the formula does not have: only its expression is compared."""
        line = placed.line
        assert isinstance(line, LabelLine)
        target = f"{level.context.label or ''}{line.target}"
        expression = level.context.expression(line.expression)
        if found.target != target or not same(found.expression, expression) or _is_special(found):
            self._fail(self.chart.node(found.source), f"its transition is not that of line {line.span}", run)
        self.left_out.append(f"transition {found.source} -> {found.target}, which the formula does not have")
        return (_rank(line.expression, False), False, placed.position), found

    def _staying(
        self, state: State, step: Step | None, level: _Level, run: _Run | None
    ) -> list[tuple[tuple[int, bool, int], Transition]]:
        """The transitions that stay in a state, and its exit actions, are those of its lines."""
        found = self.staying.get(state.label, ())
        on = [item for item in found if item.kind is TransitionKind.ON]
        leaving = [item for item in found if item.kind is TransitionKind.EXIT]
        lines: tuple[Placed, ...] = ()
        last: tuple[Placed, ...] = ()
        if step is not None and step.reached in (Reached.TERM, Reached.FRAMED):
            places, term = self._places(level.context), ungrouped(step.what)
            lines, last = places.by_edge.get(("on", term), ()), places.by_edge.get(("exit", term), ())
        if not (on or leaving or lines or last):
            return []
        for kind, there, said in ((TransitionKind.ON, on, lines), (TransitionKind.EXIT, leaving, last)):
            if len(there) != len(said):
                self._fail(state, f"it has {len(there)} `{kind.value}` lines, not {len(said)}", run)
            for item, placed in zip(there, said, strict=True):
                expression = level.context.expression(placed.line.expression)
                if item.span != placed.line.span or not same(item.expression, expression):
                    self._fail(state, f"its {self._shown(item)} is not that of line {placed.line.span}", run)
                if item.origin != level.context.origin or item.target != state.label or _is_special(item):
                    self._fail(state, f"its {self._shown(item)} is of another formula or kind", run)
                self.followed.add(id(item))
        return [
            ((_rank(placed.line.expression, False), False, placed.position), item)
            for item, placed in zip(on, lines, strict=True)
        ]

    def _in_order(
        self,
        state: State,
        outgoing: tuple[Transition, ...],
        order: list[tuple[tuple[int, bool, int], Transition]],
        run: _Run | None,
    ) -> None:
        """The transitions are tried in the order of the lines; those of a reactive choice come last."""
        wanted = [item for _, item in sorted(order, key=lambda pair: pair[0])]
        found = [item for item in outgoing if not item.reactive]
        if any(one is not other for one, other in zip(wanted, found, strict=False)) or len(wanted) != len(
            found
        ):
            self._fail(state, "its transitions are not tried in the order of the lines", run)
        if any(item.reactive for item in outgoing[: len(found)]):
            self._fail(state, "a reactive transition is tried before others", run)
        priorities = [item.priority for item in outgoing]
        if priorities != sorted(set(priorities)):
            self._fail(state, "two of its transitions have the same priority", run)

    def _choice(self, state: State, step: Step, level: _Level, run: _Run | None) -> None:
        """The weights of a choice, and whether its branches make it again."""
        ways = self.chart.outgoing(state.label)
        problem = draw_problem(ways)
        if problem is not None:
            self._fail(state, problem, run)
        is_reactive = step.what in self._places(level.context).reactive
        for label in dict.fromkeys(way.target for way in ways):
            if is_reactive and self.chart.node(label).type is not StateType.END:
                self.reactive[label] = ways
                if not is_compared(ways):
                    self.left_out.append(f"the reactive choice {state.label}: more than {LARGEST} conditions")

    # ---- states ------------------------------------------------------------------------------

    def _enter(self, state: State, step: Step, level: _Level, run: _Run | None) -> None:
        """A state is what a step reaches; what is in it is another level."""
        context = level.context
        if state.label in self.seen:
            self._fail(state, "two occurrences of the formula are this state", run)
        self.seen.add(state.label)
        match step.reached:
            case Reached.CHOICE | Reached.END:
                if state.origin != context.origin:
                    self._fail(state, "it is of another formula", run)
            case Reached.AND:
                self._and(state, step.what, context, run)
            case Reached.TERM | Reached.FRAMED:
                self._term(state, step, context, run)
            case _:
                assert_never(step.reached)

    def _and(self, state: State, formula: Formula, context: Context, run: _Run | None) -> None:
        row = formula.operator.row
        operands = formula.operands * formula.count if row.counted else formula.operands
        inside = self.chart.children(state.label)
        if state.origin != context.origin:
            self._fail(state, "it is of another formula", run)
        if len(inside) != len(operands):
            self._fail(state, f"it has {len(inside)} regions, and its formula {len(operands)}", run)
        for number, (item, operand) in enumerate(zip(inside, operands, strict=True), 1):
            own = context.numbered(number, formula.span) if row.counted else context
            self._region(item, own, operand, formula, run)

    def _term(self, state: State, step: Step, context: Context, run: _Run | None) -> None:
        term = ungrouped(step.what)
        if term.operator is not Operator.NAME:
            self._is(state, StateType.OR, None, context.origin, (), run)
            self._open(state.label, context, term, run)
            return
        given = context.given_in_chart(term)
        process = context.process
        play = process.plays.get(term.name)
        if term.name in process.formulas:
            inside = context.inside(term)
            self._named(state, term.name, run)
            self._is(state, StateType.OR, None, inside.origin, given, run)
            self._open(state.label, inside, process.formulas[term.name], run)
        elif play is not None and context.label is not None and step.reached is not Reached.FRAMED:
            frame = Formula(Operator.PARALLEL, (), term.span)
            self._is(state, StateType.OR, None, context.origin, given, run)
            self.waiting.append(_Level(state.label, context, rest_of(framed(term, frame)), run))
        elif play is not None:
            inside = context.entered(play, state.label, by_role=bool(context.process.formulas))
            self.branches[state.label] = inside
            self._is(state, StateType.OR, None, inside.origin, given, run)
            self._abandoned(state, inside, run)
            self._open(state.label, inside, play.process.formulas[play.process.root], run)
        elif (bound := context.bound(term)) is not None:
            formula, inside = bound
            self._is(state, StateType.OR, None, inside.origin, given, run)
            self._open(state.label, inside, formula, run)
        else:
            activity = context.own(term.name)
            self._named(state, activity, run)
            self._is(state, StateType.BASIC, activity, context.origin, given, run)
            if state.waits is not (activity in self.claims.waiting):
                self._fail(state, "whether it waits is not what is said of its activity", run)

    def _named(self, state: State, name: str, run: _Run | None) -> None:
        if state.name.partition("(")[0] != name:
            self._fail(state, f"it should be called `{name}`", run)

    def _is(
        self,
        state: State,
        kind: StateType,
        activity: str | None,
        origin: Origin,
        given: tuple[Value, ...],
        run: _Run | None,
    ) -> None:
        if state.type is not kind or state.activity != activity:
            self._fail(state, f"it should be {f'`{activity}`' if activity else f'an {kind} state'}", run)
        if state.origin != origin:
            self._fail(state, f"it should come from {origin}, not from {state.origin}", run)
        if not same(tuple(item.value for item in state.arguments), given):
            self._fail(state, "its arguments are not those of its term", run)
        if (kind is StateType.BASIC) is bool(self.chart.children(state.label)):
            self._fail(state, "what is in it is not of its term", run)

    def _abandoned(self, state: State, context: Context, run: _Run | None) -> None:
        """What a participant does when it is left before its END."""
        lines = self._places(context).abandon
        found = [item for item in self.staying.get(state.label, ()) if item.kind is TransitionKind.ABANDON]
        if len(lines) != len(found):
            self._fail(state, f"it has {len(found)} `on abandon` lines, not {len(lines)}", run)
        for item, line in zip(found, lines, strict=True):
            expression = context.expression(line.expression)
            if item.span != line.span or not same(item.expression, expression) or _is_special(item):
                self._fail(state, f"its {self._shown(item)} is not that of line {line.span}", run)
            self.followed.add(id(item))

    # ---- what goes with the whole chart ------------------------------------------------------

    def _reactive(self) -> None:
        """The reactive transitions are those of the branches of reactive choices."""
        found: dict[str, list[Transition]] = {}
        for item in sorted(self.chart.transitions, key=lambda item: item.priority):
            if item.reactive:
                found.setdefault(item.source, []).append(item)
        for label in self.reactive.keys() | found.keys():
            state, there = self.chart.node(label), found.get(label, [])
            if label not in self.reactive:
                self._fail(state, "it is not a branch of a reactive choice", None)
            problem = reactive_problem(self.reactive[label], label, there)
            if problem is not None:
                self._fail(state, problem, None)
            for item in there:
                self._same_edge(item, item.span, self.reactive[label][0].origin, None)
                self.followed.add(id(item))

    def _variables(self, own: Iterable[DeclaredVariable]) -> None:
        """The variables of the role, and those of each participant's subchart."""
        wanted = [_variable(item, None) for item in own]
        for label, context in self.branches.items():
            process, supplied = context.process, context.play.inputs if context.play is not None else {}
            free = [item for item in process.inputs if item.name not in supplied]
            wanted += [_variable(item, label) for item in (*process.variables, *free)]
        found = [replace(item, span=_NOWHERE) for item in self.chart.variables]
        if sorted(found, key=lambda item: item.name) != sorted(wanted, key=lambda item: item.name):
            self._fail(self.chart.root, "its variables are not those of its role and participants", None)

    # ---- what is wrong -----------------------------------------------------------------------

    def _shown(self, found: Transition) -> str:
        text = transition_text(found) if found.expression.events or found.expression.condition else ""
        to = "" if found.source == found.target else f" to {self._title(found.target)}"
        return f"`{text}`{to}" if text else f"without a trigger or condition{to}"

    def _title(self, label: str) -> str:
        state = self.chart.node(label)
        title = self.chart.title(state)
        return f"`{title}` ({label})" if title != label else label

    def _cannot(
        self,
        state: State,
        found: Transition,
        wanted: list[_Wanted],
        level: _Level,
        run: _Run | None,
    ) -> NoReturn:
        can = ", ".join(_line_text(item) for item in wanted) or "nothing"
        self._fail(state, f"it has a transition {self._shown(found)}, and the formula has {can} there", run)

    def _lacks(
        self, state: State, item: _Wanted, wanted: list[_Wanted], level: _Level, run: _Run | None
    ) -> NoReturn:
        self._fail(state, f"it lacks the transition of {_line_text(item)}", run)

    def _fail(self, state: State, what: str, run: _Run | None) -> NoReturn:
        """Raises NotCertified, with the shortest run to the place."""
        names: list[str] = []
        while run is not None:
            names.append(run.name)
            run = run.before
        way = f" reached by {' . '.join(reversed(names))}" if names else ""
        raise NotCertified(
            f"the statechart of {self.chart.name} ({self.chart.kind}) is not what its source says:"
            f" at {self._title(state.label)}, {state.span}{way}: {what}"
        )


_TYPES = {
    Reached.TERM: StateType.BASIC,
    Reached.FRAMED: StateType.BASIC,
    Reached.CHOICE: StateType.CONDITION,
    Reached.AND: StateType.AND,
    Reached.END: StateType.END,
}
"""The type of what is reached; a term may be an OR state, too."""

_NOWHERE = Span(Source("", ""), 0, 0)


def _is_special(item: Transition) -> bool:
    """Whether a transition interrupts, resumes, makes a choice again, or has several targets."""
    return item.first or item.resume or item.reactive or bool(item.into)


def _variable(item: DeclaredVariable, label: str | None) -> Variable:
    name = item.name if label is None else f"{item.name}@{label}"
    return Variable(name, item.type, item.initial, label, _NOWHERE, item.bounds, item.length)


def _rank(expression: TransitionExpression, first: bool) -> int:
    """Interrupts come first, completion transitions after the others, `else` last."""
    if first:
        return -1
    return 2 if expression.otherwise else 1 if expression.is_unconditional else 0


def _line_text(item: _Wanted) -> str:
    """What a person finds in the source: the control line, or the term that has none."""
    verb, term = item.step.edge
    text = canonical(term, 60) if term.operands or term.name else "the participants"
    if item.line is None:
        return f"`{verb} {text}` (no line)"
    return f"`{verb} {text}` ({item.line.span})"


__all__ = ["Agreed", "Comparison", "NotCertified"]
