"""Places: the labels of a machine's states in a statechart, and where its transitions lead.

A child of a parallel state is a region; one that holds no state, or is parallel itself, is wrapped in an OR.
All finals of a state are its END.
"""

from __future__ import annotations

from dataclasses import field
from itertools import combinations

from aseme_dsl.amola.statechart import StateType
from aseme_dsl.interop.machines.machine import Machine, Node, Shape, around
from aseme_dsl.records import dataclass


class Unreachable(Exception):
    """Why no transition of the language leads where one of the machine does."""


@dataclass(frozen=True, slots=True)
class Written:
    """A line `state LABEL TYPE`, for a state of the machine or (None) for what it needs besides."""

    label: str
    type: StateType
    node: Node | None


@dataclass(frozen=True, slots=True)
class Goal:
    """Where a transition leads: to a state, or into several regions of an AND, to the states `into`."""

    node: Node
    into: tuple[Node, ...] = ()

    @property
    def targets(self) -> tuple[Node, ...]:
        """The states that a line names as its targets."""
        return self.into or (self.node,)


@dataclass(slots=True)
class Places:
    """Where the states are. `label` is that of a state itself, also of one that is wrapped."""

    label: dict[str, str] = field(default_factory=dict)
    start: dict[str, str] = field(default_factory=dict)
    """The START of each composite, and of what wraps a state."""
    written: list[Written] = field(default_factory=list)


def inner(node: Node) -> list[Node]:
    """The states in one that can be active for themselves."""
    return [child for child in node.children if child.shape in (Shape.STATE, Shape.PARALLEL)]


def is_and(node: Node) -> bool:
    """Whether a state is an AND: several of its states are active together."""
    if node.shape is not Shape.PARALLEL:
        return False
    regions = (child for child in node.children if child.shape in (Shape.STATE, Shape.PARALLEL))
    return next(regions, None) is not None and next(regions, None) is not None


def is_composite(node: Node) -> bool:
    """Whether a state is an OR: one with states, of which one is active."""
    return not is_and(node) and any(child.shape is not Shape.HISTORY for child in node.children)


def is_region(node: Node) -> bool:
    """Whether a state is one of those that are active together."""
    return node.parent is not None and is_and(node.parent)


def is_wrapped(node: Node) -> bool:
    """Whether a region holds no state, or is an AND itself: it stands in an OR of its own."""
    return is_region(node) and not is_composite(node)


def performs(node: Node) -> bool:
    """Whether a state is an activity, which may end and fail."""
    return bool(node.activity) and not is_composite(node) and not is_and(node)


def places_of(machine: Machine) -> Places:
    """The places of all states."""
    found = Places()
    waiting: list[tuple[Node, str]] = [(machine.root, "0")]
    while waiting:
        node, label = waiting.pop()
        if is_wrapped(node):
            found.written.append(Written(label, StateType.OR, None))
            found.written.append(Written(f"{label}.1", StateType.START, None))
            found.start[node.id] = f"{label}.1"
            label = f"{label}.2"
        found.label[node.id] = label
        children = inner(node)
        if is_and(node):
            found.written.append(Written(label, StateType.AND, node))
            inside = [(child, f"{label}.{number}") for number, child in enumerate(children, 1)]
        elif is_composite(node):
            found.written.append(Written(label, StateType.OR, node))
            found.written.append(Written(f"{label}.1", StateType.START, None))
            found.start[node.id] = f"{label}.1"
            inside = [(child, f"{label}.{number}") for number, child in enumerate(children, 2)]
            finals = [child for child in node.children if child.shape is Shape.FINAL]
            end = f"{label}.{len(children) + 2}"
            for final in finals:
                found.label[final.id] = end
            if finals:
                found.written.append(Written(end, StateType.END, finals[0] if len(finals) == 1 else None))
        else:
            found.written.append(Written(label, StateType.BASIC, node))
            inside = []
        waiting += reversed(inside)
    return found


def first_of(node: Node) -> Node | None:
    """Where a composite begins, if it does not say so: at its first state."""
    return next((child for child in node.children if child.shape is not Shape.HISTORY), None)


def by_id(machine: Machine) -> dict[str, Node]:
    """The states of a machine by their ids."""
    return {node.id: node for node in machine.nodes()}


def is_inside(node: Node, other: Node) -> bool:
    """Whether a state is inside another one."""
    return any(item is other for item in around(node))


def region_in(node: Node, parallel: Node) -> Node:
    """The region of an AND that a state is in, or is."""
    while node.parent is not parallel:
        assert node.parent is not None
        node = node.parent
    return node


def is_begun_at(node: Node, state: Node, known: dict[str, Node]) -> bool:
    """Whether entering a state enters the other one, too, and nothing is done on the way."""
    while node is not state:
        if is_and(node):
            regions = [child for child in inner(node) if child is state or is_inside(state, child)]
            if not regions:
                return False
            node = regions[0]
            continue
        if len(node.initial) > 1 or node.initial_does or not is_composite(node):
            return False
        first = known[node.initial[0]] if node.initial else first_of(node)
        if first is None or not is_inside(first, node):
            return False
        if first is not state and not is_inside(state, first):
            return False
        node = first  # what lies between is entered on the way
    return True


def entered(
    source: Node, targets: tuple[Node, ...], known: dict[str, Node], *, is_start: bool = False
) -> Goal:
    """Where a transition leads. Of several targets in one AND, those do not count that begin of themselves.

    With `is_start` it begins at the START of the source.

    Raises:
        Unreachable: targets cannot be active together, or it leads from one region of an AND into another.
    """
    if any(target.shape is Shape.HISTORY for target in targets):
        raise Unreachable("a history remembers where a state was left; `resume` does that in formulas")
    if not targets:
        raise Unreachable("it names no state")
    left = [target for target in targets if len(targets) == 1 or not _begins_with(target, targets, known)]
    if len(left) > 1:
        return _into_regions(source, tuple(left))
    target = left[0] if left else _common(targets)
    while True:
        while is_region(target):
            assert target.parent is not None
            target = target.parent
        crossed = next((item for item in around(target) if is_and(item) and is_inside(source, item)), None)
        if crossed is None:
            return Goal(target)
        here, there = region_in(source, crossed), region_in(target, crossed)
        if here is there and (is_start or source is not here):
            outer = _crossing(source, target, crossed)
            if outer is None:
                return Goal(target)
            crossed, there = outer, region_in(target, outer)
        if not is_begun_at(there, target, known):
            return _again(crossed, target, known)
        target = crossed


def _again(parallel: Node, target: Node, known: dict[str, Node]) -> Goal:
    """An AND that is left from inside and entered again, with a target in one of its regions.

    Another region is named, too, so that it is the AND that is led to.
    """
    for region in inner(parallel):
        first = None if is_inside(target, region) else _begun(region, known)
        if first is not None:
            return Goal(parallel, (first, target))
    raise Unreachable("it leads from one region of a parallel state into another")


def _begun(region: Node, known: dict[str, Node]) -> Node | None:
    """The state in a region that is entered with it, if nothing is done on the way."""
    if is_wrapped(region):
        return None if region.entry else region
    first = known[region.initial[0]] if region.initial else first_of(region)
    plain = not region.initial_does and len(region.initial) < 2
    return first if plain and first is not None and first.parent is region and _is_active(first) else None


def _is_active(node: Node) -> bool:
    return node.shape in (Shape.STATE, Shape.PARALLEL)


def _into_regions(source: Node, targets: tuple[Node, ...]) -> Goal:
    """The AND around several targets, which do not begin of themselves."""
    for first, second in combinations(targets, 2):
        if not is_and(_lowest(first, second)):
            raise Unreachable("it leads to several states that cannot be active together")
    target = _common(targets)
    for item in around(target):
        if (
            is_and(item)
            and is_inside(source, item)
            and region_in(source, item) is not region_in(target, item)
        ):
            raise Unreachable("it leads from one region of a parallel state into another")
    return Goal(target, targets)


def _lowest(one: Node, other: Node) -> Node:
    """The innermost state that is both states, or is around them."""
    outer = [one, *around(one)]
    return next(item for item in (other, *around(other)) if any(item is found for found in outer))


def _crossing(source: Node, target: Node, innermost: Node) -> Node | None:
    """An AND further out whose regions a transition crosses."""
    for item in around(innermost):
        if is_and(item) and region_in(source, item) is not region_in(target, item):
            return item
    return None


def _common(targets: tuple[Node, ...]) -> Node:
    """The innermost AND around all targets."""
    for item in around(targets[0]):
        if is_and(item) and all(is_inside(target, item) for target in targets):
            return item
    raise Unreachable("it leads to several states that cannot be active together")


def _begins_with(target: Node, targets: tuple[Node, ...], known: dict[str, Node]) -> bool:
    """Whether the AND around all targets, once entered, enters this one of itself."""
    common = _common(targets)
    return is_begun_at(region_in(target, common), target, known)


def scope_of(source: Node, target: Node) -> Node:
    """The innermost composite around both ends, which stays active."""
    for item in around(source):
        if not is_and(item) and is_inside(target, item):
            return item
    return source  # of the root: it has no transition


def path(scope: Node, target: Node) -> list[Node]:
    """The states that are entered on the way to a target, the outermost first."""
    found = [target]
    for item in around(target):
        if item is scope:
            break
        found.append(item)
    return list(reversed(found))


__all__ = [
    "Goal",
    "Places",
    "Unreachable",
    "Written",
    "by_id",
    "entered",
    "first_of",
    "inner",
    "is_and",
    "is_begun_at",
    "is_composite",
    "is_inside",
    "is_region",
    "is_wrapped",
    "path",
    "performs",
    "places_of",
    "scope_of",
]
