"""View: the part of a statechart that a drawing shows, and where its transitions begin and end there."""

from __future__ import annotations

from collections.abc import Mapping

from aseme_dsl.amola.statechart import OriginKind, State, Statechart, StateType, Transition, label_key
from aseme_dsl.diagrams.look.drawing import NoSuchState
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Way:
    """A transition as it is drawn, between the drawn states with the labels `source` and `target`.

    If one end is inside a closed state, the line ends at that state. If it is outside the view,
    `source_outside` or `target_outside` is true, and the label is that of the drawn state that stands for it.
    `place` is the index of the transition in the statechart.

    A line into several regions of its target forks to the drawn states `forks`. Where its source is outside
    the view, each of them has a way of its own, of which all but the first have a `part`.
    """

    place: int
    transition: Transition
    source: str
    target: str
    source_outside: bool = False
    target_outside: bool = False
    forks: tuple[str, ...] = ()
    part: int = 0

    @property
    def id(self) -> str:
        """The id that the transition has in every drawing and in the SVG."""
        return self.leg(self.part)

    def leg(self, part: int) -> str:
        """The id of one of its lines."""
        return f"t{self.place}.{part}" if part else f"t{self.place}"

    @property
    def is_back(self) -> bool:
        """Whether it leads against the order of the document."""
        return label_key(self.source) > label_key(self.target)


@dataclass(frozen=True)
class View:
    """The states of `chart` from `top` downwards, but for those inside the states that are `closed`.

    `states` are in document order; `closed` says how many states are in each closed state.
    """

    chart: Statechart
    top: str
    states: tuple[State, ...]
    closed: Mapping[str, int]
    ways: tuple[Way, ...]

    def inside(self, label: str) -> tuple[State, ...]:
        """The drawn states directly inside a drawn state."""
        return () if label in self.closed else self.chart.children(label)

    def is_group(self, label: str) -> bool:
        """Whether a state is drawn with others inside."""
        return bool(self.inside(label))

    def holds(self, outer: str, inner: str) -> bool:
        """Whether one state is the other or is around it."""
        return inner == outer or inner.startswith(outer + ".")

    def first(self, label: str) -> str:
        """The innermost state where a drawn state begins: a state without others inside."""
        while inside := self.inside(label):
            label = next((node.label for node in inside if node.type is StateType.START), inside[0].label)
        return label

    def last(self, label: str) -> str:
        """The innermost state where a drawn state ends."""
        while inside := self.inside(label):
            label = next((node.label for node in inside if node.type is StateType.END), inside[-1].label)
        return label

    def branch(self, label: str) -> str | None:
        """`attack.center` if the state is the first of a branch that a protocol gave to a role's chart."""
        node = self.chart.node(label)
        if not self.is_from_protocol(label):
            return None
        parent = node.parent
        if label != self.top and parent is not None and self.chart.node(parent).origin == node.origin:
            return None
        return f"{node.origin.owner}.{node.origin.name}" if node.origin.name else node.origin.owner

    def is_from_protocol(self, label: str) -> bool:
        """Whether a state of a role's chart came from a protocol."""
        return self.chart.kind == "IAC" and self.chart.node(label).origin.kind is OriginKind.PROTOCOL


def _sizes(chart: Statechart) -> dict[str, int]:
    """How many states are inside each state, at any depth."""
    found = dict.fromkeys((node.label for node in chart.states), 0)
    for node in reversed(chart.states):
        if node.parent is not None:
            found[node.parent] += found[node.label] + 1
    return found


def view(
    chart: Statechart,
    *,
    at: str | None = None,
    depth: int | None = None,
    closed: frozenset[str] = frozenset(),
) -> View:
    """The part of the chart at `at`, open for `depth` levels, with the states of `closed` closed as well.

    Raises NoSuchState if the chart has no state `at`.
    """
    top = chart.root.label if at is None else at
    if top not in chart.by_label:
        raise NoSuchState(f"the statechart {chart.name} has no state {top}")
    counts = _sizes(chart)
    states: list[State] = []
    shut: dict[str, int] = {}
    stack = [(chart.node(top), 0)]
    while stack:
        node, level = stack.pop()
        states.append(node)
        children = chart.children(node.label)
        if children and (node.label in closed or level == depth):
            shut[node.label] = counts[node.label]
        else:
            stack.extend((child, level + 1) for child in reversed(children))
    drawn = {node.label for node in states}
    return View(chart, top, tuple(states), shut, _ways(chart, drawn))


def _forks(
    transition: Transition, target: str | None, shown_at: Mapping[str | None, str | None]
) -> tuple[str, ...]:
    """The drawn states to which a line into several regions forks; none where the target is closed."""
    found = dict.fromkeys(shown_at[label] for label in transition.into)
    return tuple(label for label in found if label is not None and target is not None and label != target)


def _ways(chart: Statechart, drawn: set[str]) -> tuple[Way, ...]:
    """The transitions with an end among the drawn states, but for those hidden inside a closed one."""
    shown_at: dict[str | None, str | None] = {None: None}
    for node in chart.states:  # each after its parent
        shown_at[node.label] = node.label if node.label in drawn else shown_at[node.parent]
    found: list[Way] = []
    for place, transition in enumerate(chart.transitions):
        source, target = shown_at[transition.source], shown_at[transition.target]
        if transition.into and source is None:
            led = dict.fromkeys(shown_at[label] for label in transition.into if shown_at[label] != target)
            parts = [label for label in led if label is not None and chart.node(label).parent in drawn]
            found += (
                Way(place, transition, transition.source, label, source_outside=True, part=part)
                for part, label in enumerate(parts)
            )
            if parts:
                continue
        if source is None and target is None:
            continue
        if source is None or target is None:
            # The view's own neighbours belong to the state around it; what reaches into it is shown.
            inner = transition.target if source is None else transition.source
            if chart.node(inner).parent not in drawn:
                continue
        elif source == target and (source, target) != (transition.source, transition.target):
            continue
        found.append(
            Way(
                place,
                transition,
                source or transition.source,
                target or transition.target,
                source is None,
                target is None,
                _forks(transition, target, shown_at) if source is not None else (),
            )
        )
    return tuple(found)
