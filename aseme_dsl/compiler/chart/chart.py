"""Chart: an outline with its control lines, variables and regions as the statechart that all others read."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field, replace
from itertools import chain

from aseme_dsl.amola.aip import DeclaredVariable, Plays
from aseme_dsl.amola.expression import Assign, VariableValue, substituted_expression
from aseme_dsl.amola.liveness import Formula
from aseme_dsl.amola.messages import Type
from aseme_dsl.amola.srm import Activity, Module
from aseme_dsl.amola.statechart import (
    Argument,
    Origin,
    OriginKind,
    State,
    Statechart,
    StateType,
    Transition,
    TransitionKind,
    Variable,
)
from aseme_dsl.compiler.chart.regions import regions_of
from aseme_dsl.compiler.control.control import (
    LabelledLine,
    Line,
    Lines,
    Placed,
    transitions,
)
from aseme_dsl.compiler.formula.formula_to_statechart import Branch, Outline, Way
from aseme_dsl.compiler.formula.formulas import Formulas
from aseme_dsl.compiler.formula.renames import SAME, rename
from aseme_dsl.compiler.names.resolve import Symbols
from aseme_dsl.compiler.read.missing import Missing
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class RelativeLine:
    """A labelled line of a participant: its ends below the label of the participant's branch (`.2.1`)."""

    source: str
    target: str
    line: Line


@dataclass(frozen=True, slots=True)
class Part:
    """The process of a participant with its control: what is woven in wherever it is played."""

    protocol: str
    participant: str
    formulas: Formulas
    variables: tuple[DeclaredVariable, ...]
    lines: Lines
    labelled: tuple[RelativeLine, ...]
    span: Span
    count: int = 1
    """How many regions it has in the protocol's own chart."""
    inputs: tuple[DeclaredVariable, ...] = ()
    results: tuple[str, ...] = ()
    plays: tuple[Plays, ...] = ()
    """What it plays itself, in protocols of its own."""
    played: Mapping[str, Branch] = field(default_factory=dict)
    """The processes of that, by the names that its formulas use."""
    inside: Mapping[tuple[str, str], Part] = field(default_factory=dict)
    """The parts of all that stands in it, by protocol and participant."""

    @property
    def activities(self) -> frozenset[str]:
        """What it does itself."""
        return self.formulas.activities - self.played.keys()

    @property
    def bindable(self) -> frozenset[str]:
        """What who plays it can bind: with the names that it gives to activities of what it plays itself."""
        given = (own for branch in self.played.values() for own in branch.bindings.values())
        return self.activities.union(given)

    def branch(self, plays: Plays | None = None) -> Branch:
        """Its process, as it stands where it is played; without `plays` as in the protocol's own chart."""
        return Branch(
            self.protocol,
            self.participant,
            self.formulas,
            dict(plays.bindings) if plays is not None else {},
            tuple(item.name for item in self.variables),
            self.inputs,
            dict(plays.inputs) if plays is not None else {},
            dict(plays.results) if plays is not None else {},
            self.played,
            plays.span if plays is not None else None,
        )


@dataclass(frozen=True, slots=True)
class Protocol:
    """An `aip` whose processes have been read: the parts by name, and their chart.

    A participant whose process cannot be expanded is not in `parts`; `outline` is None if any is not.
    `missing` is what its control does not say yet.
    """

    written: tree.Aip
    parts: Mapping[str, Part]
    outline: Outline | None
    missing: tuple[Missing, ...]

    @property
    def name(self) -> str:
        return self.written.name.text


@dataclass(frozen=True, slots=True)
class World:
    """What every chart of the system shares: its name, its symbols and what is said of the activities."""

    system: str
    symbols: Symbols
    activities: Mapping[str, Activity]
    modules: Mapping[str, tuple[Module, ...]]
    """Of each role."""


def chart_of(
    name: str,
    kind: str,
    outline: Outline,
    parts: Mapping[tuple[str, str], Part],
    world: World,
    span: Span,
    lines: Lines | None = None,
    labelled: Sequence[LabelledLine] = (),
    variables: Sequence[DeclaredVariable] = (),
) -> Statechart | None:
    """The statechart of an outline; None where a condition is still to be written.

    `parts` are the participants whose subcharts are in it. The variables of a subchart are initialised at
    each entry of it; their names have its label as a suffix (`bids@0.2.3`).
    """
    by_way: dict[Way, tuple[Line, ...]] = dict(lines.by_way) if lines is not None else {}
    origin = Origin(OriginKind.FORMULA, name, "control")
    placed = [Placed(item.source.text, item.target.text, item.line, origin, None) for item in labelled]
    own = [Variable(v.name, v.type, v.initial, None, v.span, v.bounds, v.length) for v in variables]
    for label, branch in outline.branches.items():
        part = parts[branch.protocol, branch.participant]
        by_way.update(part.lines.by_way)
        placed += _placed(label, part, branch.origin)
        free = (item for item in part.inputs if item.name not in branch.supplied)
        own += [
            Variable(f"{v.name}@{label}", v.type, v.initial, label, v.span, v.bounds, v.length)
            for v in (*part.variables, *free)
        ]
    every_line = chain(
        chain.from_iterable(by_way.values()),
        (item.line for item in placed),
        *(part.lines.abandon for part in parts.values()),
    )
    if any(line.is_hole for line in every_line):
        return None
    reactive = frozenset[Formula]().union(
        *(part.lines.reactive for part in parts.values()), lines.reactive if lines is not None else ()
    )
    found = transitions(outline, by_way, placed, reactive)
    found = _giving_results(outline, found, {item.name: item.type for item in own})
    found = (*found, *_abandoning(outline, parts))
    nodes = waiting_states(_nodes(outline, world.symbols), world.activities)
    modules = world.modules.get(name, ()) if kind == "IAC" else ()
    regions = regions_of(nodes, found, world.activities, modules, world.symbols)
    return Statechart(name, world.system, kind, nodes, found, tuple(own), regions, span, modules)


def _nodes(outline: Outline, symbols: Symbols) -> tuple[State, ...]:
    """The states: the role's own activity in a branch calls its parameters as it likes."""
    nodes = list(outline.nodes)
    for place, node in enumerate(nodes):
        form = symbols.activities.get(node.activity) if node.activity is not None else None
        if node.arguments and form is not None:
            pairs = zip(form.parameters, node.arguments, strict=False)
            arguments = tuple(Argument(parameter.name, item.value) for parameter, item in pairs)
            nodes[place] = replace(node, arguments=arguments)
    return tuple(nodes)


def waiting_states(nodes: Iterable[State], activities: Mapping[str, Activity]) -> tuple[State, ...]:
    """The states, of which those wait whose activities do."""
    waiting = {name for name, item in activities.items() if item.waits}
    return tuple(replace(node, waits=True) if node.activity in waiting else node for node in nodes)


def _giving_results(
    outline: Outline, found: tuple[Transition, ...], types: Mapping[str, Type]
) -> tuple[Transition, ...]:
    """The transitions: those to the END of a branch give its results to the variables around it.

    The assignments have the place at which the participant is played: the role says where a result goes.
    """
    ends = {f"{label}.": results for label, results in outline.results.items() if results}
    if not ends:
        return found
    kinds = {node.label: node.type for node in outline.nodes}

    def given(item: Transition) -> Transition:
        around, dot, _ = item.target.rpartition(".")
        results = ends.get(around + dot)
        if results is None or kinds[item.target] is not StateType.END:
            return item
        span = outline.branches[around].played_at or item.span
        actions = tuple(
            Assign(VariableValue(target, kind, span), VariableValue(own, kind, span), span)
            for own, target in results.items()
            for kind in (types[own],)
        )
        expression = replace(item.expression, actions=(*item.expression.actions, *actions))
        return replace(item, expression=expression)

    return tuple(map(given, found))


def _abandoning(outline: Outline, parts: Mapping[tuple[str, str], Part]) -> Iterable[Transition]:
    """What the participants do when they are left before their END."""
    for label, branch in outline.branches.items():
        for line in parts[branch.protocol, branch.participant].lines.abandon:
            written = substituted_expression(line.expression, outline.instances[label])
            expression = rename(written, outline.names.get(label, SAME))
            name, kind = f"{branch.participant}ABANDON", TransitionKind.ABANDON
            yield Transition(name, label, label, expression, 0, branch.origin, line.span, kind=kind)


def _placed(label: str, part: Part, origin: Origin) -> Iterable[Placed]:
    for item in part.labelled:
        yield Placed(label + item.source, label + item.target, item.line, origin, label)


__all__ = ["Part", "Protocol", "RelativeLine", "World", "chart_of", "waiting_states"]
