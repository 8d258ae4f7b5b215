"""Statechart: the EAC of a protocol or the IAC of a role (P1, section 4.3): the waist of the house."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import field
from enum import StrEnum
from functools import cached_property
from itertools import takewhile

from aseme_dsl.amola.expression import (
    EMPTY,
    Has,
    Literal,
    Logic,
    TransitionExpression,
    Value,
    expression_text,
    value_text,
    values_of,
    walk,
)
from aseme_dsl.amola.messages import Bounds, Channel, Type
from aseme_dsl.amola.srm import Module
from aseme_dsl.display import Displayed
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


class StateType(StrEnum):
    """The six types of state."""

    START = "START"
    END = "END"
    OR = "OR"
    AND = "AND"
    BASIC = "BASIC"
    CONDITION = "CONDITION"


class OriginKind(StrEnum):
    FORMULA = "formula"
    PROTOCOL = "protocol"
    STATECHART = "statechart"


@dataclass(frozen=True, slots=True)
class Origin:
    """Where a state or transition came from: `formula` player.decision, `protocol` attack.center, …"""

    kind: OriginKind
    owner: str
    name: str

    def __str__(self) -> str:
        return (
            f"{self.kind.value} {self.owner}.{self.name}" if self.name else f"{self.kind.value} {self.owner}"
        )


@dataclass(frozen=True, slots=True)
class Argument:
    """What a state is given for the parameter `name` of its activity, or of the formula that it is."""

    name: str
    value: Value


@dataclass(frozen=True, slots=True)
class State:
    """A state. `label` is its place (`0.2.1`), `parent` the label around it, None for the root.

    One that `waits` is BASIC and never completes by itself.
    """

    label: str
    name: str
    type: StateType
    parent: str | None
    activity: str | None
    origin: Origin
    span: Span
    arguments: tuple[Argument, ...] = ()
    waits: bool = False


class TransitionKind(StrEnum):
    """Whether a transition leads somewhere (EXTERNAL), or belongs to its source, which is its target, too.

    ON does its actions without leaving the source; EXIT does them whenever the source is left. ABANDON does
    them when the source, the branch of a participant, is left for good before it is complete.
    """

    EXTERNAL = "external"
    ON = "on"
    EXIT = "exit"
    ABANDON = "abandon"


@dataclass(frozen=True, slots=True)
class Transition:
    """A transition between two states, given by their labels.

    `priority` is its rank among the transitions of its source; 0 is tried first. Transitions with neither
    event nor condition come after the others, and `else` comes last.

    - `into`: the states in regions of the target, an AND, that are entered instead of the STARTs of their
      regions, in document order; two at least, or none.
    - `first`: it interrupts its source (`A [> B`). It is tried before all transitions inside the source; of
      several such transitions, the outermost first.
    - `resume`: the target resumes the configuration in which it was exited before it was complete.
    - `reactive`: it is generated, and leads back to a choice that would now take another branch.
    """

    name: str
    source: str
    target: str
    expression: TransitionExpression
    priority: int
    origin: Origin
    span: Span
    first: bool = False
    kind: TransitionKind = TransitionKind.EXTERNAL
    resume: bool = False
    reactive: bool = False
    into: tuple[str, ...] = ()

    @property
    def targets(self) -> tuple[str, ...]:
        """The states that it names as its targets."""
        return self.into or (self.target,)

    @property
    def changes_state(self) -> bool:
        """Whether it leads somewhere: something is left and entered."""
        return self.kind is TransitionKind.EXTERNAL


def transition_text(transition: Transition) -> str:
    """The text of a transition for readers: its expression after a word for its kind.

    The word is `[>` for an interrupt, `on` or `exit` if the state stays active or for an exit action, and
    `resume` if the target is resumed. What does nothing in a state `ignores` the signals that it takes.
    """
    expression = transition.expression
    if transition.kind is TransitionKind.ON and not (expression.actions or expression.events):
        ignored = expression.condition
        parts = ignored.operands if isinstance(ignored, Logic) else (ignored,)
        names = [value_text(part.message) for part in parts if isinstance(part, Has)]
        if names:
            return f"on ignores {', '.join(names)}"
    word = "[>" if transition.first else "" if transition.changes_state else transition.kind.value
    word = "on abandon" if transition.kind is TransitionKind.ABANDON else word
    verb = "resume" if transition.resume else "reactive" if transition.reactive else ""
    return " ".join(filter(None, (word, verb, expression_text(expression))))


@dataclass(frozen=True, slots=True)
class Variable:
    """A variable of the agent.

    `scope` is the label of the participant subchart whose entry initialises it, or None. The name of such a
    variable has this label as a suffix: `bids@0.2.3`.
    """

    name: str
    type: Type
    initial: Literal
    scope: str | None
    span: Span
    bounds: Bounds | None = None
    length: int | None = None
    """How many elements a list has at most."""

    @property
    def is_limited(self) -> bool:
        """Whether there are values of its type that it cannot hold."""
        return self.bounds is not None or self.length is not None


@dataclass(frozen=True, slots=True)
class Region:
    """The root or an OR child of an AND, with the channels its conditions, actions and activities use.

    `reads` includes what the regions inside read but for signals: a region that is entered starts with the
    surrounding one's states and histories.
    """

    label: str
    reads: tuple[Channel, ...]
    writes: tuple[Channel, ...]


_IN_ANOTHER = {
    StateType.START: "start of ",
    StateType.END: "end of ",
    StateType.CONDITION: "choice in ",
}


def label_key(label: str) -> tuple[int, ...]:
    """Orders labels as places: 0.2 before 0.10."""
    return tuple(int(part) for part in label.split("."))


def lowest_around(labels: Sequence[str]) -> str:
    """The label of the lowest state that is all of some states or has them inside."""
    paths = [label.split(".") for label in labels]
    same = takewhile(lambda parts: len(set(parts)) == 1, zip(*paths, strict=False))
    return ".".join(parts[0] for parts in same)


def split_targets(region: str, into: Iterable[str]) -> tuple[str, tuple[str, ...]] | None:
    """What is entered inside a region of an AND whose targets are `into`: the target, and the targets in it.

    The second part is empty unless the first is an AND, too. None: the region is entered at its START.
    """
    inside = tuple(label for label in into if label.startswith(f"{region}."))
    if not inside:
        return None
    return (inside[0], ()) if len(inside) == 1 else (lowest_around(inside), inside)


@dataclass(frozen=True)
class Statechart(Displayed):
    """States in document order (each after its parent), transitions in the template's order.

    `kind` is "EAC" or "IAC". This is the reading interface of the model for all layers above. So it has many
    small methods, each of which answers one question about the states or the transitions.
    """

    name: str
    system: str
    kind: str
    states: tuple[State, ...]
    transitions: tuple[Transition, ...]
    variables: tuple[Variable, ...] = ()
    regions: tuple[Region, ...] = ()
    span: Span | None = field(default=None, compare=False)
    modules: tuple[Module, ...] = ()
    """What runs beside it in each agent of the role."""

    @cached_property
    def by_label(self) -> dict[str, State]:
        return {node.label: node for node in self.states}

    @cached_property
    def _children(self) -> dict[str | None, tuple[State, ...]]:
        found: dict[str | None, list[State]] = {}
        for node in self.states:
            found.setdefault(node.parent, []).append(node)
        return {label: tuple(nodes) for label, nodes in found.items()}

    @cached_property
    def _called(self) -> dict[str, tuple[State, ...]]:
        found: dict[str, list[State]] = {}
        for node in self.states:
            if self._is_framed(node):
                continue
            own = node.name.partition("(")[0] if node.arguments else node.name
            for name in dict.fromkeys((own, node.name, node.activity)):
                if name is not None:
                    found.setdefault(name, []).append(node)
        return {name: tuple(nodes) for name, nodes in found.items()}

    def _is_framed(self, node: State) -> bool:
        """Whether a state is the branch of a participant in a frame, which stands for it around."""
        parent = None if node.parent is None else self.by_label[node.parent]
        return (
            parent is not None
            and parent.name == node.name
            and parent.origin.kind is OriginKind.PROTOCOL
            and parent.origin.name != ""
            and self.is_branch(node)
        )

    @cached_property
    def _outgoing(self) -> dict[str, tuple[Transition, ...]]:
        found: dict[str, list[Transition]] = {}
        for transition in self.transitions:
            if transition.kind not in (TransitionKind.EXIT, TransitionKind.ABANDON):
                found.setdefault(transition.source, []).append(transition)
        return {
            label: tuple(sorted(items, key=lambda transition: transition.priority))
            for label, items in found.items()
        }

    @property
    def root(self) -> State:
        return self.states[0]

    def node(self, label: str) -> State:
        return self.by_label[label]

    def title(self, state: State) -> str:
        """What people call a state: by what it is in the state around it where its name is only its label."""
        around = state
        while around.parent is not None and around.name in ("", around.label):
            around = self.by_label[around.parent]
        if around is state or around.name in ("", around.label):
            return state.name or state.label
        return _IN_ANOTHER.get(state.type, "in ") + around.name

    def children(self, label: str) -> tuple[State, ...]:
        """The states directly inside `label`, in document order."""
        return self._children.get(label, ())

    def values(self) -> Iterator[tuple[str, Value]]:
        """Every value that transitions read and activities are given, with everything in it.

        Each comes with the state whose region's blackboard counts: the source, or the state of the activity.
        """
        return iter(self._values)

    @cached_property
    def _values(self) -> tuple[tuple[str, Value], ...]:
        found: list[tuple[str, Value]] = []
        for node in self.states:
            if node.type is StateType.BASIC:
                found += [(node.label, value) for item in node.arguments for value in walk(item.value)]
        for transition in self.transitions:
            found += [(transition.source, value) for value in values_of(transition.expression)]
        return tuple(found)

    def called(self, name: str) -> tuple[State, ...]:
        """The states that are called `name`, or whose activity is, in document order."""
        return self._called.get(name, ())

    @cached_property
    def _exits(self) -> dict[str, tuple[Transition, ...]]:
        found: dict[str, tuple[Transition, ...]] = {}
        for transition in self.transitions:
            if transition.kind is TransitionKind.EXIT:
                found[transition.source] = (*found.get(transition.source, ()), transition)
        return found

    def outgoing(self, label: str) -> tuple[Transition, ...]:
        """The transitions of a source in the order in which they are tried, with those that stay in it."""
        return self._outgoing.get(label, ())

    def outgoing_edges(self, label: str) -> tuple[Transition, ...]:
        """The transitions that lead out of a source, or to itself, in the order in which they are tried."""
        return self._edges.get(label, ())

    @cached_property
    def _edges(self) -> dict[str, tuple[Transition, ...]]:
        return {
            label: tuple(item for item in items if item.changes_state)
            for label, items in self._outgoing.items()
        }

    def exits_of(self, label: str) -> tuple[Transition, ...]:
        """What is done when a state is left, in that order."""
        return self._exits.get(label, ())

    @cached_property
    def abandons(self) -> dict[str, tuple[Transition, ...]]:
        """What is done when the branch of a participant is left before it is complete, by its label."""
        found: dict[str, tuple[Transition, ...]] = {}
        for transition in self.transitions:
            if transition.kind is TransitionKind.ABANDON:
                found[transition.source] = (*found.get(transition.source, ()), transition)
        return found

    def ancestors(self, label: str) -> Iterator[State]:
        """The states around `label`, from its parent to the root."""
        parent = self.by_label[label].parent
        while parent is not None:
            node = self.by_label[parent]
            yield node
            parent = node.parent

    def start_of(self, label: str) -> State | None:
        return next((node for node in self.children(label) if node.type is StateType.START), None)

    def end_of(self, label: str) -> State | None:
        return next((node for node in self.children(label) if node.type is StateType.END), None)

    def is_region(self, label: str) -> bool:
        """Whether `label` is the root or an OR child of an AND."""
        return label in self._regions

    @cached_property
    def _regions(self) -> frozenset[str]:
        known = self.by_label
        return frozenset(
            node.label
            for node in self.states
            if node.parent is None or known[node.parent].type is StateType.AND
        )

    def region_of(self, label: str) -> str:
        """The label of the innermost region around `label`; a region is its own."""
        while not self.is_region(label):
            parent = self.by_label[label].parent
            assert parent is not None
            label = parent
        return label

    def is_branch(self, node: State) -> bool:
        """Whether a state is the outermost of what came from a participant."""
        if node.origin.kind is not OriginKind.PROTOCOL or node.type is not StateType.OR:
            return False
        parent = None if node.parent is None else self.node(node.parent)
        return parent is not None and parent.origin != node.origin

    def branch_of(self, label: str) -> str | None:
        """The label of the innermost protocol branch around a state, or of the state itself."""
        node = self.node(label)
        if self.is_branch(node):
            return label
        return next((item.label for item in self.ancestors(label) if self.is_branch(item)), None)

    def conversation_of(self, transition: Transition) -> str | None:
        """The branch in whose conversation a transition is: of one that leaves a branch, that around it."""
        node = self.node(transition.source)
        if transition.changes_state and self.is_branch(node) and node.parent is not None:
            return self.branch_of(node.parent)
        return self.branch_of(node.label)

    def entries_of(self, transition: Transition) -> tuple[str, ...]:
        """The targets, and the regions of ANDs around them that are entered at their STARTs with them."""
        targets = transition.targets
        found = dict.fromkeys(targets)
        inside = f"{self.scope_of(transition)}."
        for target in targets:
            for around in self.ancestors(target):
                if around.type is StateType.AND and around.label.startswith(inside):
                    for region in self.children(around.label):
                        if split_targets(region.label, targets) is None:
                            found[region.label] = None
        return tuple(found)

    def scope_of(self, transition: Transition) -> str:
        """The lowest OR state that holds source and target (P1, section 4.3)."""
        around = {node.label for node in self.ancestors(transition.target)}
        for node in self.ancestors(transition.source):
            if node.type is StateType.OR and node.label in around:
                return node.label
        return self.root.label

    def acts_in(self, transition: Transition) -> str:
        """The region in which the actions of a transition count: that of its scope."""
        if not transition.changes_state:
            return self.region_of(transition.source)
        return self.region_of(self.scope_of(transition))

    @cached_property
    def levels(self) -> int:
        """The number of levels: the segments of the longest label."""
        return max(node.label.count(".") + 1 for node in self.states)


__all__ = [
    "EMPTY",
    "Argument",
    "Origin",
    "OriginKind",
    "Region",
    "State",
    "StateType",
    "Statechart",
    "Transition",
    "TransitionKind",
    "Variable",
    "label_key",
    "lowest_around",
    "split_targets",
    "transition_text",
]
