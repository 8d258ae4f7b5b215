"""Formulas: the liveness formulas of a chart, found by recognising the template of each operator.

What the tools drew from a formula is read back into it. A state with a name of its own is a formula.
One that is called like its term, or by its label, is a term of the formula around it. A chart that
differs from the templates anywhere has no formulas: the reason says where.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import pairwise

from aseme_dsl.amola.liveness import Formula, canonical, term_key, ungrouped
from aseme_dsl.amola.operators import INFIX, Operator
from aseme_dsl.amola.original_names import original_name
from aseme_dsl.amola.statechart import StateType
from aseme_dsl.interop.emf.charts import SPELLINGS, ForeignChart, ForeignState
from aseme_dsl.interop.emf.identifiers import is_name
from aseme_dsl.records import dataclass

Edge = tuple[str, str]
"""The labels of a transition's ends."""


class NoFormula(Exception):
    """Why a chart is not that of a formula."""


@dataclass(frozen=True, slots=True)
class Body:
    """What a state holds: an operator over the states of its operands, and the way that each edge is.

    A way is a verb and the operand that it concerns, -1 for the whole.
    """

    operator: Operator
    operands: tuple[ForeignState, ...]
    ways: Mapping[Edge, tuple[str, int]]
    repeated: frozenset[Edge] = frozenset()
    """Edges of which others have said the same: those of the further regions of `A[3]`."""


@dataclass(frozen=True, slots=True)
class Way:
    """`enter play` in the control of a formula."""

    formula: str
    verb: str
    term: str
    is_first: bool = True
    """Whether the formula stands here for the first time."""


@dataclass(frozen=True, slots=True)
class Reconstructed:
    """The formulas of a chart by name, the first for the root, and the way of each transition."""

    formulas: Mapping[str, str]
    ways: Mapping[Edge, Way]
    renamed: tuple[ForeignState, ...]
    """States that are called by a term that they no longer are: a model was edited by hand."""


def formulas_of(chart: ForeignChart) -> Reconstructed:
    """The formulas of a chart. Raises NoFormula."""
    return _Reconstruction(chart).result()


@dataclass(slots=True)
class _Level:
    """The children of a state by what they are, and the transitions between them."""

    start: ForeignState
    end: ForeignState | None
    choices: list[ForeignState]
    terms: list[ForeignState]
    edges: set[Edge]


def body_of(chart: ForeignChart, state: ForeignState) -> Body:
    """The operator whose template the inside of an OR is. Raises NoFormula."""
    level = _level(chart, state)
    for operator, ways in _templates(chart, level):
        if set(ways) == level.edges:
            terms = level.terms
            if operator is Operator.PARALLEL:
                terms = [_inside_region(chart, region) for region in chart.inside(level.terms[0].label)]
                for number, region in enumerate(chart.inside(level.terms[0].label)):
                    first, body, last = (child.label for child in chart.inside(region.label))
                    ways |= {(first, body): ("enter", number), (body, last): ("leave", number)}
            return Body(operator, tuple(terms), ways)
    raise NoFormula(f"the transitions inside {title(state)} are not those of an operator")


def _level(chart: ForeignChart, state: ForeignState) -> _Level:
    children = chart.inside(state.label)
    for number, child in enumerate(children, 1):
        if child.label != f"{state.label}.{number}":
            raise NoFormula(f"the labels inside {title(state)} have a gap")
    kinds = [child.type for child in children]
    if not children or kinds[0] is not StateType.START or StateType.START in kinds[1:]:
        raise NoFormula(f"{title(state)} does not begin with its START")
    has_end = kinds[-1] is StateType.END
    inner = children[1:-1] if has_end else children[1:]
    choices = [child for child in inner if child.type is StateType.CONDITION]
    terms = [child for child in inner if child.type in (StateType.OR, StateType.AND, StateType.BASIC)]
    if len(choices) + len(terms) != len(inner) or not terms or len(choices) > 1:
        raise NoFormula(f"the states inside {title(state)} are not those of an operator")
    if choices and inner[0] is not choices[0]:
        raise NoFormula(f"the choice inside {title(state)} is not its second state")
    labels = {child.label for child in children}
    edges = {(item.source, item.target) for label in labels for item in chart.outgoing.get(label, ())}
    if any(target not in labels for _, target in edges):
        raise NoFormula(f"a transition leads out of {title(state)}")
    return _Level(children[0], children[-1] if has_end else None, choices, terms, edges)


def _templates(chart: ForeignChart, level: _Level) -> Iterator[tuple[Operator, dict[Edge, tuple[str, int]]]]:
    """The operators that these states may be of, with the edges that each has."""
    start, end = level.start.label, level.end.label if level.end else ""
    terms = [term.label for term in level.terms]
    if level.terms[0].type is StateType.AND:
        if len(terms) == 1 and end and not level.choices:
            yield Operator.PARALLEL, {(start, terms[0]): ("start", -1), (terms[0], end): ("finish", -1)}
        return
    if any(term.type is StateType.AND for term in level.terms):
        return
    first = terms[0]
    loop, into = {(first, first): ("repeat", 0)}, {(start, first): ("start", -1)}
    if level.choices:
        choice = level.choices[0].label
        begin = {(start, choice): ("start", -1)}
        ins = {(choice, term): ("enter", number) for number, term in enumerate(terms)}
        outs = {(term, end): ("leave", number) for number, term in enumerate(terms)}
        if len(terms) > 1:
            yield Operator.CHOICE, begin | ins | outs
        else:
            skip = {(choice, end): ("skip", 0)}
            yield Operator.OPTION, begin | ins | outs | skip
            yield Operator.ZERO_OR_MORE, begin | ins | outs | skip | loop
        return
    if len(terms) == 1:
        out = {(first, end): ("leave", 0)}
        yield Operator.ONE_OR_MORE, into | loop | out
        if not end:
            yield Operator.FOREVER, into | loop
        if level.terms[0].type is StateType.BASIC:
            yield Operator.NAME, {(start, first): ("enter", 0), **out}
        return
    chain = {(start, first): ("enter", 0), (terms[-1], end): ("leave", len(terms) - 1)}
    chain |= {(a, b): ("enter", number) for number, (a, b) in enumerate(pairwise(terms), 1)}
    yield Operator.SEQUENCE, chain


def _inside_region(chart: ForeignChart, region: ForeignState) -> ForeignState:
    children = chart.inside(region.label)
    kinds = [child.type for child in children]
    labels = [child.label for child in children]
    edges = {(item.source, item.target) for label in labels for item in chart.outgoing.get(label, ())}
    is_one = len(kinds) == 3 and kinds[0] is StateType.START and kinds[2] is StateType.END
    if (
        region.type is not StateType.OR
        or not is_one
        or kinds[1] not in (StateType.OR, StateType.BASIC)
        or edges != {(labels[0], labels[1]), (labels[1], labels[2])}
        or labels != [f"{region.label}.{number}" for number in (1, 2, 3)]
    ):
        raise NoFormula(f"the region {title(region)} is not one term between START and END")
    return children[1]


def title(state: ForeignState) -> str:
    """A state in a message."""
    return f"`{state.name[:60]}` ({state.label})" if state.name not in ("", state.label) else state.label


@dataclass(slots=True)
class _Reconstruction:
    chart: ForeignChart
    formulas: dict[str, str] = field(default_factory=dict)
    said: dict[str, tuple[tuple[str, ...], ...]] = field(default_factory=dict)
    """What the transitions of a formula say: the same wherever it stands."""
    ways: dict[Edge, Way] = field(default_factory=dict)
    renamed: list[ForeignState] = field(default_factory=list)
    activities: set[str] = field(default_factory=set)
    around: list[str] = field(default_factory=list)

    def result(self) -> Reconstructed:
        root = self.chart.states[0]
        if root.type is not StateType.OR:
            raise NoFormula("the outermost state is not an OR")
        if not is_name(root.name):
            raise NoFormula(f"the outermost state has no name for a formula (`{root.name[:40]}`)")
        self._formula(root)
        clash = self.activities & set(self.formulas)
        if clash:
            raise NoFormula(f"`{min(clash)}` is an activity and a formula")
        missing = {(item.source, item.target) for item in self.chart.transitions} - set(self.ways)
        if missing:
            source, target = min(missing)
            raise NoFormula(f"the transition from {source} to {target} is not one of a formula")
        return Reconstructed(self.formulas, self.ways, tuple(self.renamed))

    def _formula(self, state: ForeignState) -> None:
        """Add the formula that a state is called by."""
        name = state.name
        if name in self.around:
            raise NoFormula(f"`{name}` is inside itself")
        order = dict.fromkeys([*self.formulas, name])
        self.formulas = {key: self.formulas.get(key, "") for key in order}
        self.around.append(name)
        bodies: dict[Formula, Body] = {}
        whole = self._term(state, bodies)
        self.around.pop()
        text = canonical(whole)
        said = self._ways(name, whole, bodies)
        if self.formulas[name] and (self.formulas[name] != text or self.said[name] != said):
            raise NoFormula(f"two states are called `{name}` and differ")
        self.formulas[name] = text
        self.said[name] = said

    def _term(self, state: ForeignState, bodies: dict[Formula, Body]) -> Formula:
        """The term that a state holds."""
        body = body_of(self.chart, state)
        operands = tuple(self._operand(item, body.operator, bodies) for item in body.operands)
        if body.operator is Operator.NAME:
            whole = operands[0]
        elif body.operator is Operator.PARALLEL and self._is_counted(state, body, operands):
            whole = Formula(Operator.INSTANCES, operands[:1], state.place, count=len(operands))
            ways = {edge: (verb, min(operand, 0)) for edge, (verb, operand) in body.ways.items()}
            repeated = frozenset(edge for edge, (_, operand) in body.ways.items() if operand > 0)
            body = replace(body, ways=ways, repeated=repeated)
        else:
            whole = Formula(body.operator, operands, state.place)
        if body.operator is Operator.PARALLEL:
            parallel = self.chart.inside(state.label)[1]
            if parallel.name not in ("", parallel.label, original_name(canonical(whole))):
                self.renamed.append(parallel)
        bodies[whole] = body
        return whole

    def _is_counted(self, state: ForeignState, body: Body, operands: Sequence[Formula]) -> bool:
        """Whether equal regions are `A[3]`: the name says so, and all of them say the same."""
        if not operands:
            return False
        first = operands[0]
        term = Formula(Operator.INSTANCES, (first,), state.place, count=len(operands))
        parallel = self.chart.inside(state.label)[1]
        if first.operator is not Operator.NAME or parallel.name != original_name(canonical(term)):
            return False
        said = {way: tuple(self._said(edge)) for edge, way in body.ways.items()}
        alike = all(text == said.get((verb, min(operand, 0))) for (verb, operand), text in said.items())
        return alike and all(item.name == first.name for item in operands)

    def _operand(
        self,
        state: ForeignState,
        around: Operator,
        bodies: dict[Formula, Body],
    ) -> Formula:
        name = Formula(Operator.NAME, (), state.place, state.name)
        if state.type is StateType.BASIC:
            if not is_name(state.name):
                raise NoFormula(f"the activity {title(state)} has no name for a formula")
            self.activities.add(state.name)
            return name
        if _is_own(state):
            self._formula(state)
            return name
        term = self._term(state, bodies)
        if term.operator is Operator.NAME:
            raise NoFormula(f"{title(state)} holds one activity and has no name of its own")
        grouped = Formula(Operator.GROUP, (term,), state.place)
        known = {original_name(canonical(item)): item for item in (grouped, term)}
        needs = _is_postfix(around) if _is_loop(term) else around is not Operator.OPTION
        needs = needs and (_is_loop(term) or term.operator in INFIX)
        found = known.get(state.name)
        if found is None and state.name not in ("", state.label):
            self.renamed.append(state)
        if found is None or needs:
            return grouped if needs else term
        return found

    def _ways(self, name: str, whole: Formula, bodies: dict[Formula, Body]) -> tuple[tuple[str, ...], ...]:
        """Name the way of each transition of a formula; what they all say, in order."""
        places: dict[str, list[Formula]] = {}
        waiting = [whole]
        while waiting:
            term = waiting.pop()
            places.setdefault(term_key(term), []).append(term)
            waiting += [ungrouped(operand) for operand in reversed(term.operands)]
        said: list[tuple[str, ...]] = []
        for term, body in bodies.items():
            for edge, (verb, operand) in body.ways.items():
                of = (
                    term
                    if operand < 0 or body.operator is Operator.NAME
                    else ungrouped(term.operands[operand])
                )
                if verb == "start" and of is whole and _is_plain_loop(of):
                    verb, of = "enter", ungrouped(of.operands[0])
                key = term_key(of)
                written = f"({key})" if of.operator in INFIX else key
                if len(places[key]) > 1:
                    number = next(index for index, place in enumerate(places[key], 1) if place is of)
                    written = f"{written}#{number}"
                is_first = name not in self.said and edge not in body.repeated
                self.ways[edge] = Way(name, verb, written, is_first)
                said.append((verb, written, *self._said(edge)))
        return tuple(sorted(said))

    def _said(self, edge: Edge) -> Iterator[str]:
        for item in self.chart.outgoing.get(edge[0], ()):
            if item.target == edge[1]:
                yield item.expression


def _is_own(state: ForeignState) -> bool:
    """Whether a state has a name of its own, not one that the tools made of its term."""
    if state.name == state.label or not is_name(state.name):
        return False
    return not any(sign in state.name for sign in SPELLINGS)


def _is_plain_loop(term: Formula) -> bool:
    return term.operator in (Operator.ONE_OR_MORE, Operator.FOREVER)


def _is_loop(term: Formula) -> bool:
    return _is_plain_loop(term) or term.operator is Operator.ZERO_OR_MORE


def _is_postfix(operator: Operator) -> bool:
    return operator in (Operator.ONE_OR_MORE, Operator.FOREVER, Operator.ZERO_OR_MORE)


__all__ = ["Body", "Edge", "NoFormula", "Reconstructed", "Way", "body_of", "formulas_of", "title"]
