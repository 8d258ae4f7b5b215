"""Control: transition expressions from the `control` blocks onto the transitions of a chart.

A line is read once, for its formula; the chart has it wherever the formula is expanded, and a protocol's
lines go wherever the protocol is played.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace

from aseme_dsl.amola.expression import EMPTY, NEVER, TransitionExpression, substituted_expression
from aseme_dsl.amola.liveness import Formula
from aseme_dsl.amola.statechart import Origin, State, StateType, Transition, TransitionKind
from aseme_dsl.compiler.control.weights import with_draws
from aseme_dsl.compiler.formula.formula_to_statechart import Arrow, Outline, Standing, Way
from aseme_dsl.compiler.formula.formulas import Formulas
from aseme_dsl.compiler.formula.reactive import choices_in, no_choice, reconsidered
from aseme_dsl.compiler.formula.renames import SAME, rename
from aseme_dsl.compiler.formula.resuming import RESUME, check_resuming
from aseme_dsl.compiler.formula.staying import IGNORING, STAYING, check_ignoring, check_staying, is_abandon
from aseme_dsl.compiler.formula.terms import Played, Terms, home, terms_of, way
from aseme_dsl.compiler.names.scope import Scope
from aseme_dsl.compiler.types.given import inside_formula
from aseme_dsl.compiler.types.typecheck import type_expression
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.absences import NoTerm
from aseme_dsl.diagnostics.problems.control import (
    ControlTwice,
    LineInBranch,
    PeriodOfLoopNotPositive,
    PeriodOutsideLoop,
    TransitionNotOfFormula,
    WeightMisplaced,
)
from aseme_dsl.diagnostics.problems.statecharts import (
    NoStateOfFormula,
    OutsideOfBranch,
    TargetsInFormula,
    TransitionIntoRegion,
    TransitionIntoStart,
    TransitionOfRoot,
    TransitionOutOfEnd,
    TransitionToOtherChoice,
    TransitionToRegion,
)
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Line:
    """A control line: as written, typed, and its place among all lines of its owner."""

    written: tree.TransitionExpression
    expression: TransitionExpression
    position: int
    span: Span
    resume: bool = False

    @property
    def is_hole(self) -> bool:
        """Whether its condition is still to be written."""
        return isinstance(self.written.condition, tree.Hole)


@dataclass(frozen=True, slots=True)
class LabelledLine:
    """`0.2.3 -> 0.2.4 : …`; of a `statechart` also `on 0.2.3 : …`, whose source is its target, too.

    `others` are the further targets of a transition into several regions, which only a `statechart` has.
    """

    source: tree.Name
    target: tree.Name
    line: Line
    kind: TransitionKind = TransitionKind.EXTERNAL
    others: tuple[tree.Name, ...] = ()


@dataclass(frozen=True, slots=True)
class Lines:
    """All control lines of a role or participant: by way, in the order in which they are written.

    `blocks` gives each formula that has a `control` block its block; of those in `unsure` a line could not be
    placed, so that a missing one means nothing. `reactive` are the branches of reactive choices.
    """

    by_way: Mapping[Way, tuple[Line, ...]] = field(default_factory=dict)
    labelled: tuple[LabelledLine, ...] = ()
    blocks: Mapping[str, tree.Control] = field(default_factory=dict)
    unsure: frozenset[str] = frozenset()
    reactive: frozenset[Formula] = frozenset()
    abandon: tuple[Line, ...] = ()
    """What a participant does when it is left before its END."""

    def of(self, verb_and_term: Way) -> tuple[Line, ...]:
        return self.by_way.get(verb_and_term, ())


def read_lines(
    formulas: Formulas,
    controls: Iterable[tuple[tree.Control, str]],
    scope: Scope,
    played: Played | None = None,
    played_names: Iterable[str] = (),
    *,
    of_participant: bool = False,
) -> tuple[Lines, tuple[Diagnostic, ...]]:
    """The lines of `controls`, each given with the name of the formula that it is about.

    A line whose term stands in one other formula only is a line of that formula.
    `played` are the formulas of the participants that a role plays, which have control of their own, and
    `played_names` what its formulas call them.
    Reports E400, E401, E402, E411 and what is wrong with the expressions.
    """
    by_way: dict[Way, list[Line]] = {}
    labelled: list[LabelledLine] = []
    blocks: dict[str, tree.Control] = {}
    elsewhere: dict[str, tree.Control] = {}
    found: list[Diagnostic] = []
    unsure: set[str] = set()
    reactive: set[Formula] = set()
    abandon: list[Line] = []
    position = 0
    controls = tuple(controls)
    decided_again = {name for control, name in controls if control.reactive is not None}

    def of_formula(name: str) -> Terms:
        title = scope.participant if of_participant and name == formulas.root else None
        return terms_of(formulas, name, title or name, played)

    for control, owner in controls:
        first = blocks.setdefault(owner, control)
        if first is not control:
            found.append(
                Diagnostic(
                    ControlTwice(control.name.text),
                    control.name.span,
                    (Related(first.name.span, "the first one"),),
                )
            )
        own = of_formula(owner)
        if control.reactive is not None:
            branches = choices_in(own)
            reactive.update(branches)
            if not branches:
                found.append(no_choice(control, control.reactive, formulas.named[owner]))
        for entry in control.entries:
            written = entry.expression
            name, terms = owner, own
            if isinstance(entry, tree.Way) and not (of_participant and is_abandon(entry)):
                other = home(own, entry.verb, entry.term)
                if other is not None:
                    name, terms = other, of_formula(other)
                    elsewhere.setdefault(name, control)
            inner = inside_formula(scope, formulas, name)
            if isinstance(entry, tree.Way) and (paces := tuple(_pace(entry))):
                found += paces
                written = replace(written, every=None)
            typed, problems = type_expression(written, inner)
            found += problems
            found += check_ignoring(entry, typed)
            line = Line(written, typed, IGNORING if written.ignores else position, entry.span)
            position += 1
            if written.weight is not None and (name in decided_again or isinstance(entry, tree.LabelledWay)):
                found.append(Diagnostic(WeightMisplaced(), written.weight.span))
            if isinstance(entry, tree.LabelledWay):
                if len(entry.targets) > 1:
                    found.append(Diagnostic(TargetsInFormula(), entry.ends))
                    continue
                labelled.append(LabelledLine(entry.source, entry.targets[0], line))
                continue
            key, problem = way(terms, entry.verb, entry.term)
            if problem is not None and of_participant and is_abandon(entry):
                found += check_staying(entry, abandons=True)
                abandon.append(line)
                continue
            if entry.verb.text in STAYING:
                found += check_staying(entry)
            elif entry.verb.text == RESUME:
                line = replace(line, resume=True)
                if key is not None:
                    found += check_resuming(entry, formulas, frozenset(played_names), key[0])
            if problem is not None:
                if isinstance(problem.problem, NoTerm) and is_abandon(entry):
                    problem = replace(problem, problem=problem.problem.but(is_abandon=True))
                found.append(problem)
                unsure.add(name)
            elif key is not None:
                by_way.setdefault(key, []).append(line)
    placed = {key: tuple(items) for key, items in by_way.items()}
    blocks |= {
        name: control for name, control in elsewhere.items() if name not in blocks or not blocks[name].entries
    }
    lines = Lines(placed, tuple(labelled), blocks, frozenset(unsure), frozenset(reactive), tuple(abandon))
    return lines, tuple(found)


def _pace(entry: tree.Way) -> Iterator[Diagnostic]:
    """E432 for an `every` with a period of zero, or on a line that is not a `repeat`."""
    pace = entry.expression.every
    if pace is None:
        return
    if entry.verb.text != "repeat":
        yield Diagnostic(PeriodOutsideLoop(entry.verb.text), pace.span)
    elif pace.nanoseconds == 0:
        yield Diagnostic(PeriodOfLoopNotPositive(), pace.span)


# ---- onto the chart -----------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Placed:
    """A labelled line with the labels that it means in one chart."""

    source: str
    target: str
    line: Line
    origin: Origin
    branch: str | None


def transitions(
    outline: Outline,
    lines: Mapping[Way, tuple[Line, ...]],
    placed: Sequence[Placed] = (),
    reactive: frozenset[Formula] = frozenset(),
) -> tuple[Transition, ...]:
    """The transitions of a chart, in the template's order; several lines of one way are parallel ones.

    What `placed` lines add to the formula comes last.
    """
    by_ends: dict[tuple[str, str], list[Placed]] = {}
    for item in placed:
        by_ends.setdefault((item.source, item.target), []).append(item)
    drafts: list[Transition] = []
    positions: list[int | None] = []

    def typed(line: Line, of: Arrow | Standing | Placed) -> TransitionExpression:
        values = {} if isinstance(of, Placed) else of.values
        names = outline.names.get(of.branch, SAME) if of.branch is not None else SAME
        return rename(substituted_expression(line.expression, values), names)

    def add(arrow: Arrow | Placed, name: str, line: Line | None, span: Span) -> None:
        cuts_short = isinstance(arrow, Arrow) and arrow.first
        expression = NEVER if cuts_short else EMPTY
        if line is not None:
            expression = typed(line, arrow)
        ends, resume = (arrow.source, arrow.target), line is not None and line.resume
        # Errors take their turn as everywhere, also beside another event of the line.
        for part in expression.apart_from_errors if cuts_short else (expression,):
            first = cuts_short and not part.is_for_errors
            drafts.append(Transition(name, *ends, part, 0, arrow.origin, span, first, resume=resume))
            positions.append(line.position if line is not None else None)

    for arrow in outline.arrows:
        own = lines.get(arrow.way, ())
        extra = by_ends.pop((arrow.source, arrow.target), None) if by_ends else None
        if extra:
            own = tuple(sorted((*own, *(item.line for item in extra)), key=lambda line: line.position))
        for line in own:
            add(arrow, arrow.name, line, line.span)
        if not own:
            add(arrow, arrow.name, None, arrow.span)
    names_of = {node.label: node.name for node in outline.nodes} if by_ends else {}
    for items in by_ends.values():
        for item in items:
            add(item, f"{names_of[item.source]}TO{names_of[item.target]}", item.line, item.line.span)
    for state, kind, line in _staying(outline.standing, lines):
        expression, name = typed(line, state), f"{state.name}{kind.name}"
        ends = state.label, state.label
        drafts.append(Transition(name, *ends, expression, 0, state.origin, line.span, kind=kind))
        positions.append(line.position)
    found = with_draws(prioritised(drafts, positions))
    choices = {arrow.source: arrow for arrow in outline.arrows if arrow.way[1] in reactive}
    return (*found, *reconsidered(found, outline.nodes, choices)) if choices else found


def _staying(
    standing: Iterable[Standing], lines: Mapping[Way, tuple[Line, ...]]
) -> Iterable[tuple[Standing, TransitionKind, Line]]:
    """The `on` and `exit` lines of each state, by state."""
    if any(verb in STAYING for verb, _ in lines):
        for state in standing:
            for verb, kind in STAYING.items():
                for line in lines.get((verb, state.term), ()):
                    yield state, kind, line


def prioritised(drafts: Sequence[Transition], positions: Sequence[int | None]) -> tuple[Transition, ...]:
    """The transitions with the places that they have among those of their sources.

    `positions` are those of their control lines, None for a transition without one. What cuts the source
    short comes first, then written lines, in their order, then the template's; without a condition later, and
    `else` last.
    """
    by_source: dict[str, list[int]] = {}
    for index, draft in enumerate(drafts):
        if draft.kind is not TransitionKind.EXIT:
            by_source.setdefault(draft.source, []).append(index)

    def order(index: int) -> tuple[int, bool, int]:
        expression, position = drafts[index].expression, positions[index]
        rank = 2 if expression.otherwise else 1 if expression.is_unconditional else 0
        rank = -1 if drafts[index].first else rank
        return rank, position is None, index if position is None else position

    found = list(drafts)
    for indices in by_source.values():
        if len(indices) > 1:
            for place, index in enumerate(sorted(indices, key=order)):
                if place:
                    found[index] = replace(drafts[index], priority=place)
    return tuple(found)


# ---- lines that name labels ---------------------------------------------------------------------


def check_labels(
    outline: Outline, labelled: Iterable[LabelledLine], inside: str | None = None
) -> tuple[tuple[LabelledLine, ...], tuple[Diagnostic, ...]]:
    """The labelled lines that the chart can take, and what is wrong with the others.

    `inside` is the label of the participant's branch that the lines belong to; without it they are a role's,
    and may not touch a branch.
    """
    nodes = {node.label: node for node in outline.nodes}
    ends = {(arrow.source, arrow.target) for arrow in outline.arrows}
    good: list[LabelledLine] = []
    found: list[Diagnostic] = []
    for item in labelled:
        missing = [name for name in (item.source, item.target) if name.text not in nodes]
        if missing:
            found += [_unknown_label(name, nodes) for name in missing]
            continue
        source, target = nodes[item.source.text], nodes[item.target.text]
        place = item.source.span.to(item.target.span)
        problem = structure_problem(nodes, source, target, place)
        if problem is None and inside is not None:
            problem = _outside_branch(inside, source, target, place)
        if problem is None:
            problem = _inside_branch(outline, source, target, place, inside)
        if problem is not None:
            found.append(problem)
            continue
        good.append(item)
        if (source.label, target.label) not in ends:
            found.append(
                Diagnostic(
                    TransitionNotOfFormula(source.label, target.label),
                    place,
                    (Related(source.span, source.label), Related(target.span, target.label)),
                )
            )
    return tuple(good), tuple(found)


def including_labels(lines: Lines, outline: Outline, labelled: Iterable[LabelledLine]) -> Lines:
    """The lines with those by label under the ways that they mean, for checks of choices and loops."""
    ends = {(item.source.text, item.target.text): item.line for item in labelled}
    if not ends:
        return lines
    by_way = dict(lines.by_way)
    for arrow in outline.arrows:
        line = ends.get((arrow.source, arrow.target))
        if line is not None:
            by_way[arrow.way] = tuple(
                sorted((*by_way.get(arrow.way, ()), line), key=lambda item: item.position)
            )
    return replace(lines, by_way=by_way)


def structure_problem(
    nodes: Mapping[str, State], source: State, target: State, place: Span
) -> Diagnostic | None:
    """What forbids a transition between two states: E603, E604 (rules of the papers' tools), E409."""
    if source.parent is None or target.parent is None:
        return Diagnostic(TransitionOfRoot(), place)
    if target.type is StateType.START:
        return Diagnostic(TransitionIntoStart(target.label, target.parent), place)
    if source.type is StateType.END:
        return Diagnostic(TransitionOutOfEnd(source.label, source.parent), place)
    return _region_problem(nodes, source, target, place)


def _region_problem(
    nodes: Mapping[str, State], source: State, target: State, place: Span
) -> Diagnostic | None:
    """E409 for what leads from one region into another, to a region itself, or out of it into a choice.

    A transition may lead out of an AND, whose regions are all left, and into a region of one, whose other
    regions are entered at their STARTs. Between two regions of one AND it may not: both are active together.
    """
    into, out = regions_around(nodes, target), regions_around(nodes, source)
    parent = nodes.get(target.parent or "")  # there may be no such state
    if parent is not None and parent.type is StateType.AND:
        return Diagnostic(TransitionToRegion(target.label, parent.label), place)
    for entered in into:
        around = nodes[entered].parent or ""
        if source.label.startswith(f"{around}.") and (entered not in out or entered == source.label):
            return Diagnostic(TransitionIntoRegion(source.label, target.label, entered, around), place)
    if into != out and target.type is StateType.CONDITION:
        return Diagnostic(TransitionToOtherChoice(source.label, target.label, target.parent or ""), place)
    return None


def regions_around(nodes: Mapping[str, State], node: State) -> tuple[str, ...]:
    """The regions of ANDs in which `node` is, innermost first; a region is in itself."""
    found: list[str] = []
    inside: State | None = node
    while inside is not None and inside.parent is not None:
        around = nodes.get(inside.parent)
        if around is not None and around.type is StateType.AND:
            found.append(inside.label)
        inside = around
    return tuple(found)


def _unknown_label(name: tree.Name, nodes: Mapping[str, State]) -> Diagnostic:
    parent = name.text
    while parent and parent not in nodes:
        parent = parent.rpartition(".")[0]
    inside = tuple(label for label, node in nodes.items() if node.parent == parent)
    return Diagnostic(NoStateOfFormula(name.text, parent or None, inside), name.span)


def _inside_branch(
    outline: Outline, source: State, target: State, place: Span, own: str | None
) -> Diagnostic | None:
    """What is wrong with a line inside a branch that is not the owner's `own`."""
    for label, branch in outline.branches.items():
        if own is not None and not label.startswith(f"{own}."):
            continue
        if source.label.startswith(label + ".") or target.label.startswith(label + "."):
            related = (Related(branch.formulas.named[branch.formulas.root].name.span, "the process"),)
            return Diagnostic(LineInBranch(branch.protocol, branch.participant, label), place, related)
    return None


def _outside_branch(inside: str, source: State, target: State, place: Span) -> Diagnostic | None:
    for node in (source, target):
        if not node.label.startswith(inside + "."):
            return Diagnostic(OutsideOfBranch(node.label, inside), place)
    return None


__all__ = [
    "LabelledLine",
    "Line",
    "Lines",
    "Placed",
    "check_labels",
    "including_labels",
    "prioritised",
    "read_lines",
    "regions_around",
    "structure_problem",
    "transitions",
]
