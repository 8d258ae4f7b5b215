"""Statecharts: a chart that is given state by state, held to the structural rules of the papers' tools."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import count
from typing import assert_never

from aseme_dsl.amola.liveness import called
from aseme_dsl.amola.statechart import (
    Origin,
    OriginKind,
    State,
    Statechart,
    StateType,
    Transition,
    TransitionKind,
    Variable,
    label_key,
)
from aseme_dsl.compiler.chart.chart import World, waiting_states
from aseme_dsl.compiler.chart.regions import regions_of
from aseme_dsl.compiler.chart.targets import around_all, into_of, targets_problem
from aseme_dsl.compiler.control.choices import (
    Alternative,
    always_false,
    check_choice,
    check_group,
    check_source,
    never_taken,
)
from aseme_dsl.compiler.control.control import LabelledLine, Line, prioritised, structure_problem
from aseme_dsl.compiler.formula.staying import IGNORING, STAYING, check_ignoring, check_staying
from aseme_dsl.compiler.read.damage import Damaged
from aseme_dsl.compiler.types.scopes import TypedRole
from aseme_dsl.compiler.types.typecheck import type_expression
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.activities import ParametersInChart
from aseme_dsl.diagnostics.problems.control import WeightMisplaced
from aseme_dsl.diagnostics.problems.missing import ExpressionsMissing
from aseme_dsl.diagnostics.problems.statecharts import (
    ActivityOutsideBasic,
    BasicWithoutActivity,
    CannotHaveStates,
    LabelTwice,
    NoPlaceToStay,
    NoRegion,
    NoState,
    NoStateAround,
    NotOneRoot,
    NotOneStart,
    OneRegion,
    RegionNotOr,
    RootNotOr,
    SeveralEnds,
    TransitionOfRoot,
    Unsound,
)
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass

_COMPOSITE = (StateType.OR, StateType.AND)


@dataclass(frozen=True, slots=True)
class GivenChart:
    """A `statechart` block that has been read; `is_sound` tells whether it can be built."""

    written: tree.Statechart
    typed: TypedRole
    nodes: tuple[State, ...]
    lines: tuple[LabelledLine, ...]
    is_sound: bool

    @property
    def name(self) -> str:
        return self.written.name.text


def read_statechart(
    written: tree.Statechart, typed: TypedRole, is_damaged: Damaged
) -> tuple[GivenChart, tuple[Diagnostic, ...]]:
    """The states and transitions of a block, with all that breaks a rule."""
    origin = Origin(OriginKind.STATECHART, written.name.text, "")
    nodes: dict[str, State] = {}
    found: list[Diagnostic] = []
    for item in written.nodes:
        node, problem = _node(item, origin)
        if problem is not None:
            found.append(problem)
        form = typed.scope.symbols.activities.get(node.activity or "")
        if form is not None and form.parameters:
            found.append(
                Diagnostic(
                    ParametersInChart(called(form.name, map(str, form.parameters))),
                    (item.activity or item.name or item).span,
                    (Related(form.span, "what is said of it"),),
                )
            )
        first = nodes.setdefault(node.label, node)
        if first is not node:
            found.append(_labelled_twice(node, first, written))
    damaged = is_damaged(written.span)  # then what is missing may only be unreadable
    if not damaged:
        found += _structure(written, nodes)
        nodes = _with_root(nodes)
    lines: list[LabelledLine] = []
    for position, entry in enumerate(written.transitions):
        expression, problems = type_expression(entry.expression, typed.scope)
        found += (*problems, *check_ignoring(entry, expression))
        if entry.expression.weight is not None:
            found.append(Diagnostic(WeightMisplaced(), entry.expression.weight.span))
        rank = IGNORING if entry.expression.ignores else position
        line = Line(entry.expression, expression, rank, entry.span)
        if isinstance(entry, tree.StandingWay):
            found += check_staying(entry)
            if entry.state.text in nodes:
                problem = _no_place_to_stay(nodes[entry.state.text], entry)
                if problem is not None:
                    found.append(problem)
                else:
                    kind = STAYING[entry.verb.text]
                    lines.append(LabelledLine(entry.state, entry.state, line, kind))
            elif not damaged:
                found.append(_unknown(entry.state, nodes))
            continue
        missing = [name for name in (entry.source, *entry.targets) if name.text not in nodes]
        if missing:
            if not damaged:
                found += [_unknown(name, nodes) for name in missing]
            continue
        target, *others = entry.targets
        problem = targets_problem(nodes, entry.targets) if others else None
        entered = nodes.get(around_all(entry.targets))
        if problem is None and entered is None:
            continue  # that it is missing is said (E410, E600)
        if problem is None and entered is not None:
            problem = structure_problem(nodes, nodes[entry.source.text], entered, entry.ends)
        if problem is not None:
            found.append(problem)
            continue
        lines.append(LabelledLine(entry.source, target, line, others=tuple(others)))
    if not damaged:
        found += _decisions(written, nodes, lines)
    is_sound = not damaged and not any(isinstance(item.problem, Unsound) for item in found)
    is_sound = is_sound and not any(item.line.is_hole for item in lines)
    ordered = sorted(nodes.values(), key=lambda node: label_key(node.label))
    return GivenChart(written, typed, tuple(ordered), tuple(lines), is_sound), tuple(found)


def build_statechart(given: GivenChart, world: World) -> Statechart | None:
    """The chart of a block; None where it breaks a rule."""
    if not given.is_sound or not given.nodes:
        return None
    nodes = waiting_states(given.nodes, world.activities)
    names = {node.label: node.name for node in nodes}
    origin = Origin(OriginKind.STATECHART, given.name, "")
    drafts = [
        Transition(
            _transition_name(item, names),
            item.source.text,
            around_all((item.target, *item.others)),
            item.line.expression,
            0,
            origin,
            item.line.span,
            kind=item.kind,
            into=into_of(item),
        )
        for item in given.lines
    ]
    transitions = prioritised(drafts, [item.line.position for item in given.lines])
    variables = tuple(
        Variable(v.name, v.type, v.initial, None, v.span, v.bounds, v.length) for v in given.typed.variables
    )
    modules = world.modules.get(given.name, ())
    regions = regions_of(nodes, transitions, world.activities, modules, world.symbols)
    span = given.written.name.span
    return Statechart(given.name, world.system, "IAC", nodes, transitions, variables, regions, span, modules)


def _transition_name(item: LabelledLine, names: Mapping[str, str]) -> str:
    if item.kind is not TransitionKind.EXTERNAL:
        return f"{names[item.source.text]}{item.kind.name}"
    return f"{names[item.source.text]}TO{names[around_all((item.target, *item.others))]}"


def _no_place_to_stay(node: State, line: tree.StandingWay) -> Diagnostic | None:
    """E612 for a state in which an agent does not stay, E409 for the root."""
    if node.parent is None:
        return Diagnostic(TransitionOfRoot(), line.state.span)
    if node.type in (*_COMPOSITE, StateType.BASIC):
        return None
    problem = NoPlaceToStay(node.label, node.type, line.verb.text)
    return Diagnostic(problem, line.state.span, (Related(node.span, node.label),))


def _node(written: tree.ChartNode, origin: Origin) -> tuple[State, Diagnostic | None]:
    label, kind = written.label.text, StateType(written.type.text)
    name = written.name.text if written.name is not None else label
    parent = label.rpartition(".")[0] or None
    activity, problem = None, None
    if kind is StateType.BASIC:
        if written.activity is not None:
            activity = written.activity.text
        elif isinstance(written.name, tree.Name):
            activity = written.name.text
        else:
            problem = Diagnostic(BasicWithoutActivity(label), written.span)
    elif written.activity is not None:
        problem = Diagnostic(ActivityOutsideBasic(label, kind), written.activity.span)
    return State(label, name, kind, parent, activity, origin, written.span), problem


# ---- rules ---------------------------------------------------------------------------------------


def _structure(written: tree.Statechart, nodes: Mapping[str, State]) -> Iterator[Diagnostic]:
    """The rules of the papers' tools: one root, one START in an OR, at most one END, AND holds ORs."""
    roots = [node for node in nodes.values() if node.parent is None]
    if len(roots) != 1:
        yield Diagnostic(
            NotOneRoot(written.name.text, len(roots)),
            roots[1].span if roots else written.name.span,
            (Related(roots[0].span, "the first one"),) if roots else (),
        )
    elif roots[0].type is not StateType.OR:
        yield Diagnostic(RootNotOr(roots[0].label, roots[0].type), roots[0].span)
    children: dict[str, list[State]] = {}
    for node in sorted(nodes.values(), key=lambda node: label_key(node.label)):
        if node.parent is None:
            continue
        if node.parent in nodes:
            children.setdefault(node.parent, []).append(node)
        else:
            yield Diagnostic(NoStateAround(node.label, node.parent), node.span)
    for node in nodes.values():
        if node.parent is None and node.type is not StateType.OR:
            continue  # that is said (E600)
        inside = children.get(node.label, [])
        match node.type:
            case StateType.OR:
                yield from _or_rules(node, inside)
            case StateType.AND:
                yield from _and_rules(node, inside)
            case StateType.START | StateType.END | StateType.BASIC | StateType.CONDITION:
                if inside:
                    problem = CannotHaveStates(node.label, node.type)
                    yield Diagnostic(problem, inside[0].span, (Related(node.span, node.label),))
            case _:
                assert_never(node.type)


def _with_root(nodes: dict[str, State]) -> dict[str, State]:
    """The states with an OR as their only root: what is wrong with its type is said once (E600)."""
    roots = [node for node in nodes.values() if node.parent is None]
    if len(roots) != 1:
        return nodes
    return {**nodes, roots[0].label: replace(roots[0], type=StateType.OR, activity=None)}


def _labelled_twice(node: State, first: State, written: tree.Statechart) -> Diagnostic:
    around = node.label.rpartition(".")[0]
    labels = {item.label.text for item in written.nodes}
    free = next(label for number in count(1) if (label := f"{around}.{number}") not in labels)
    problem = LabelTwice(node.label, free if around else None)
    return Diagnostic(problem, node.span, (Related(first.span, "the first one"),))


def _or_rules(node: State, inside: Sequence[State]) -> Iterator[Diagnostic]:
    starts = [child for child in inside if child.type is StateType.START]
    ends = [child for child in inside if child.type is StateType.END]
    if len(starts) != 1:
        yield Diagnostic(
            NotOneStart(node.label, len(starts)),
            starts[1].span if starts else node.span,
            (Related(starts[0].span, "the first one"),) if starts else (),
        )
    if len(ends) > 1:
        problem = SeveralEnds(node.label, len(ends))
        yield Diagnostic(problem, ends[1].span, (Related(ends[0].span, "the first one"),))


def _and_rules(node: State, inside: Sequence[State]) -> Iterator[Diagnostic]:
    for child in inside:
        if child.type is not StateType.OR:
            problem = RegionNotOr(child.label, child.type)
            yield Diagnostic(problem, child.span, (Related(node.span, f"{node.label} is AND"),))
    if len(inside) < 2:
        yield Diagnostic(OneRegion(node.label) if inside else NoRegion(node.label), node.span)


def _unknown(name: tree.Name, nodes: Mapping[str, State]) -> Diagnostic:
    return Diagnostic(NoState(name.text, name.text.rpartition(".")[0] in nodes), name.span)


def _decisions(
    written: tree.Statechart, nodes: Mapping[str, State], lines: Sequence[LabelledLine]
) -> Iterator[Diagnostic]:
    """Whether the transitions of each source decide, and decide once.

    A statechart without any expression is not decided yet, as a formula without `control`: N704.
    """
    by_source: dict[str, list[Alternative]] = {}
    for item in lines:
        if item.kind is not TransitionKind.EXTERNAL:
            yield from always_false((item.line,))
            continue
        target = f"({', '.join(map(str, (item.target, *item.others)))})" if item.others else item.target
        name = f"{item.source} -> {target}"
        last = (item.target, *item.others)[-1]
        alternative = Alternative(name, (item.line,), item.source.span.to(last.span))
        by_source.setdefault(item.source.text, []).append(alternative)
    sources = tuple(label for label, alternatives in by_source.items() if len(alternatives) > 1)
    if sources and not any(_says_something(item.line.written) for item in lines):
        transition = by_source[sources[0]][0]
        yield Diagnostic(
            ExpressionsMissing(written.name.text, sources, transition.name),
            written.name.span,
            (Related(transition.place, f"`{transition.name}`"),),
        )
        return
    for label, alternatives in by_source.items():
        if nodes[label].type is not StateType.CONDITION:
            yield from always_false(item.lines[0] for item in alternatives)
        if len(alternatives) < 2:
            continue
        yield from check_group(alternatives)
        if nodes[label].type is StateType.CONDITION:
            yield from check_choice(alternatives)
        else:
            yield from check_source(alternatives)
            always = [alternative for alternative in alternatives if not alternative.is_decided]
            for other in always[1:]:
                yield never_taken(other.lines[0], always[0].span)


def _says_something(written: tree.TransitionExpression) -> bool:
    return bool(written.events or written.condition or written.otherwise or written.actions)


__all__ = ["GivenChart", "build_statechart", "read_statechart"]
