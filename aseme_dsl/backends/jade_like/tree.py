"""Tree: the behaviours of a role as in JADE, one for each state except START, CONDITION and END.

| state | behaviour |
| --- | --- |
| BASIC | OneShotBehaviour; TickerBehaviour where its activity has a pace (`every`) |
| AND | ParallelBehaviour |
| OR that runs its states one after the other (`A . B`) | SequentialBehaviour |
| OR that goes round and has no END (`A~`) | CyclicBehaviour; TickerBehaviour if paced (`repeat A every D`) |
| any other OR (`A \\| B`, `[A]`, `A*`, `A+`, `A [> B`, given state by state) | FSMBehaviour |
| START, CONDITION, END | points of the behaviour that is around them |
| `after(D)` on a transition | WakerBehaviour |

An OR that only wraps one state, which it enters at once and with which it ends, is one behaviour with it.
Nothing here recurses: charts may be nested hundreds deep.
"""

from __future__ import annotations

import keyword
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from enum import StrEnum
from typing import assert_never

from aseme_dsl.amola.expression import After, duration_text
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition, label_key
from aseme_dsl.amola.system import System
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.naming import class_name

POINTS = {StateType.START: "START", StateType.CONDITION: "CHOICE", StateType.END: "END"}
"""The types of state that have no behaviour of their own, and their names in the behaviour around them."""


class Kind(StrEnum):
    """The class of the runtime that a behaviour is of."""

    ONE_SHOT = "OneShotBehaviour"
    TICKER = "TickerBehaviour"
    CYCLIC = "CyclicBehaviour"
    SEQUENTIAL = "SequentialBehaviour"
    FSM = "FSMBehaviour"
    PARALLEL = "ParallelBehaviour"


@dataclass(frozen=True, slots=True)
class Waker:
    """An `after` of a transition: how long, in ns, and the states of which one has been active so long."""

    name: str
    timeout: int
    waits_in: tuple[str, ...]
    transition: Transition


@dataclass(frozen=True, slots=True)
class Behaviour:
    """A behaviour: `states` are the labels of the states that it stands for, the outermost first.

    `implied` are the transitions inside it that follow from its kind. `shown` are the others, and the actions
    of `on` and `exit` lines. `period` is in ns.
    """

    name: str
    kind: Kind
    node: State
    states: tuple[str, ...]
    inside: tuple[str, ...]
    """The labels by which the behaviours in it are known."""
    shown: tuple[Transition, ...]
    implied: tuple[Transition, ...]
    wakers: tuple[Waker, ...]
    branch: tuple[str, str] | None
    """The protocol and the participant whose part it is."""
    period: int | None = None

    @property
    def label(self) -> str:
        """The state by whose label it is known: the outermost."""
        return self.states[0]


@dataclass(frozen=True, slots=True)
class Tree:
    """The behaviours of a role in document order, the outermost first."""

    behaviours: tuple[Behaviour, ...]
    by_state: Mapping[str, Behaviour]
    """The behaviour that stands for each state; points are not among them."""


def behaviour_tree(system: System, chart: Statechart, reserved: Iterable[str] = ()) -> Tree:
    """The behaviours of a role. Their names are neither Python keywords nor among those in `reserved`."""
    return _Planter(system, chart, frozenset(reserved)).plant()


class _Planter:
    def __init__(self, system: System, chart: Statechart, reserved: frozenset[str]) -> None:
        self.chart = chart
        self.reserved = reserved
        self.taken = set(reserved)
        """The names that no other behaviour may have."""
        self.activities: dict[str, Activity] = {item.name: item for item in system.activities}
        self.from_inside: dict[str, list[Transition]] = {}
        """The transitions whose source is directly inside a state; those of the root are its own."""
        self.to: Counter[str] = Counter()
        for transition in chart.transitions:
            home = chart.node(transition.source).parent or transition.source
            self.from_inside.setdefault(home, []).append(transition)
            if transition.changes_state:
                self.to[transition.target] += 1

    def plant(self) -> Tree:
        chains: list[tuple[State, ...]] = []
        stack = [self.chart.root]
        while stack:
            chain = self.chain(stack.pop())
            chains.append(chain)
            stack += [node for node in reversed(self.chart.children(chain[-1].label)) if not _is_point(node)]
        kinds = {chain[0].label: self.kind(chain[-1]) for chain in chains}
        names = self.names(chains, kinds)
        found = tuple(self.behaviour(chain, kinds[chain[0].label], names) for chain in chains)
        return Tree(found, {label: item for item in found for label in item.states})

    # ---- which states are one behaviour ------------------------------------------------------

    def chain(self, node: State) -> tuple[State, ...]:
        """A state, and those inside it that are one behaviour with it."""
        found = [node]
        while (inside := self.wrapped(found[-1])) is not None:
            found.append(inside)
        return tuple(found)

    def wrapped(self, node: State) -> State | None:
        """The state that an OR only wraps, if it wraps one."""
        if node.type is not StateType.OR:
            return None
        children = self.chart.children(node.label)
        inner = [child for child in children if not _is_point(child)]
        types = [child.type for child in children if _is_point(child)]
        if len(inner) != 1 or types not in ([StateType.START, StateType.END], [StateType.START]):
            return None
        start, end = self.chart.start_of(node.label), self.chart.end_of(node.label)
        assert start is not None
        ways = [(start.label, inner[0].label)]
        if end is not None:
            ways.append((inner[0].label, end.label))
        own = [item for item in self.from_inside.get(node.label, ()) if item.source != node.label]
        plain = all(_is_plain(item) for item in own)
        alone = sum(self.to[child.label] for child in children) == len(own)
        if not (plain and alone and sorted((item.source, item.target) for item in own) == sorted(ways)):
            return None
        return inner[0]

    # ---- kinds -------------------------------------------------------------------------------

    def kind(self, node: State) -> Kind:
        """How the states inside a state follow on each other."""
        if node.type is StateType.BASIC:
            return Kind.ONE_SHOT if self.pace(node) is None else Kind.TICKER
        if node.type is StateType.AND:
            return Kind.PARALLEL
        pairs = self.pairs(node)
        inner = [child.label for child in self.chart.children(node.label) if not _is_point(child)]
        start, end = self.chart.start_of(node.label), self.chart.end_of(node.label)
        if start is None or not inner or any(item.first for item in self.ways(node)):
            return Kind.FSM
        if end is None and pairs == {(start.label, inner[0]), (inner[0], inner[0])}:
            return Kind.CYCLIC if self.round(node) is None else Kind.TICKER
        if end is not None and pairs == {*zip([start.label, *inner], [*inner, end.label], strict=True)}:
            return Kind.SEQUENTIAL
        return Kind.FSM

    def ways(self, node: State) -> list[Transition]:
        """The transitions that lead somewhere from what is directly inside a state."""
        return [
            item
            for item in self.from_inside.get(node.label, ())
            if item.changes_state and item.source != node.label  # else a transition of the root itself
        ]

    def pairs(self, node: State) -> set[tuple[str, str]]:
        return {(item.source, item.target) for item in self.ways(node)}

    def round(self, node: State) -> int | None:
        """The pace, in ns, at which a state goes round that goes round for ever."""
        paces = {item.expression.every for item in self.ways(node) if item.source == item.target}
        return paces.pop() if len(paces) == 1 else None

    def pace(self, node: State) -> int | None:
        """The pace, in ns, of the activity of a BASIC state."""
        activity = self.activities.get(node.activity or "")
        return activity.every if activity is not None else None

    # ---- names -------------------------------------------------------------------------------

    def names(self, chains: Sequence[tuple[State, ...]], kinds: Mapping[str, Kind]) -> dict[str, str]:
        """A class name for each behaviour: of those that would have the same, the later ones are numbered."""
        wished = {chain[0].label: self.wish(chain, kinds[chain[0].label]) for chain in chains}
        self.taken |= {*wished.values()}
        seen: set[str] = set(self.reserved)
        names: dict[str, str] = {}
        for label, wish in wished.items():
            names[label] = wish if wish not in seen else _numbered(wish, self.taken)
            seen.add(wish)
        return names

    def wish(self, chain: Sequence[State], kind: Kind) -> str:
        node = next((node for node in chain if node.name != node.label), chain[-1])
        if re.fullmatch(r"[A-Za-z_]\w*", node.name):
            return _usable(class_name(node.name))
        if node.type is StateType.BASIC:
            return _usable(class_name(node.activity or node.name.partition("(")[0]))
        inner = [self.word(child) for child in self.chart.children(chain[-1].label) if not _is_point(child)]
        first = inner[0] if inner else "Empty"
        match kind:
            case Kind.ONE_SHOT | Kind.TICKER if not inner:
                return self.word(chain[-1])
            case Kind.CYCLIC | Kind.TICKER:
                return f"{first}Forever"
            case Kind.SEQUENTIAL:
                return _joined(inner, "Then", "Sequence")
            case Kind.PARALLEL:
                same = len(set(inner)) == 1 and len(inner) > 1
                return f"{first}Times{len(inner)}" if same else _joined(inner, "And", "Parallel")
            case Kind.ONE_SHOT | Kind.FSM:
                return self._machine(chain, inner, first)
            case _:
                assert_never(kind)

    def _machine(self, chain: Sequence[State], inner: Sequence[str], first: str) -> str:
        """What a state machine is called, by the operator that it is."""
        ways = self.ways(chain[-1])
        loops = any(item.source == item.target for item in ways)
        choice = any(child.type is StateType.CONDITION for child in self.chart.children(chain[-1].label))
        if any(item.first for item in ways):
            return _joined(inner, "Until", "Disabling")
        if choice and len(inner) > 1:
            return _joined(inner, "Or", "Choice")
        if choice:
            return f"{first}AnyTimes" if loops else f"{first}OrNot"
        return f"{first}Repeatedly" if loops and len(inner) == 1 else f"{first}Machine"

    def word(self, node: State) -> str:
        """The first name in what a state is called; of one that is called by its label, in what it wraps."""
        while node.name == node.label:
            inside = [child for child in self.chart.children(node.label) if not _is_point(child)]
            if not inside:
                return f"State{node.label.replace('.', '_')}"
            node = inside[0]
        found = re.search(r"[A-Za-z_]\w*", node.name)
        return class_name(found[0]) if found else f"State{node.label.replace('.', '_')}"

    # ---- behaviours --------------------------------------------------------------------------

    def behaviour(self, chain: Sequence[State], kind: Kind, names: Mapping[str, str]) -> Behaviour:
        core = chain[-1]
        implied = [item for node in chain[:-1] for item in self.from_inside.get(node.label, ())]
        shown: list[Transition] = []
        wanted = kind in (Kind.SEQUENTIAL, Kind.CYCLIC)
        several = Counter((item.source, item.target) for item in self.from_inside.get(core.label, ()))
        for item in self.from_inside.get(core.label, ()):
            alone = several[item.source, item.target] == 1
            (implied if wanted and alone and _is_plain(item) else shown).append(item)
        own = [item for item in implied if item.source == chain[0].label]  # actions of the root
        implied = [item for item in implied if item.source != chain[0].label]
        shown = sorted([*own, *shown], key=_in_order)
        period = self.round(core) if kind is Kind.TICKER else None
        branch = next((node for node in chain if self.chart.is_branch(node)), None)
        return Behaviour(
            names[chain[0].label],
            kind,
            next((node for node in chain if node.name != node.label), core),
            tuple(node.label for node in chain),
            tuple(node.label for node in self.chart.children(core.label) if not _is_point(node)),
            tuple(shown),
            tuple(implied),
            tuple(self.wakers(shown, names)),
            (branch.origin.owner, branch.origin.name) if branch is not None else None,
            self.pace(core) if core.type is StateType.BASIC else period,
        )

    def wakers(self, shown: Iterable[Transition], names: Mapping[str, str]) -> Iterator[Waker]:
        """The `after`s of transitions, called like what they wait in."""
        for transition in shown:
            for event in transition.expression.events:
                if isinstance(event, After):
                    waits_in = self.waiting(transition.source)
                    home = self.chart.node(transition.source).parent or transition.source
                    name = self.around(names, waits_in[0] if len(waits_in) == 1 else home)
                    wish = f"{name}After{re.sub(r'[^A-Za-z0-9]', '_', duration_text(event.duration))}"
                    yield Waker(_numbered(wish, self.taken), event.duration, waits_in, transition)

    def waiting(self, label: str) -> tuple[str, ...]:
        """The states that are active while a transition from here is waited for: a choice is never."""
        found: list[str] = []
        stack, seen = [label], {label}
        while stack:
            at = stack.pop()
            if self.chart.node(at).type is not StateType.CONDITION:
                found.append(at)
                continue
            for item in self.chart.transitions:
                if item.changes_state and item.target == at and item.source not in seen:
                    seen.add(item.source)
                    stack.append(item.source)
        return tuple(sorted(found, key=label_key))

    def around(self, names: Mapping[str, str], label: str) -> str:
        """The name of the behaviour that stands for a state, or for the nearest one around it."""
        at: str | None = label
        while at is not None:
            if at in names:
                return names[at]
            at = self.chart.node(at).parent
        return "State"


def _is_point(node: State) -> bool:
    return node.type in POINTS


def _in_order(transition: Transition) -> tuple[tuple[int, ...], bool, int]:
    """Transitions by their sources, in the order in which they are tried; what stays comes last."""
    return label_key(transition.source), not transition.changes_state, transition.priority


def _is_plain(transition: Transition) -> bool:
    """Whether a transition is only taken because its source is complete, and does nothing."""
    said = transition.expression
    decided = said.is_unconditional and not said.when and said.every is None
    return (
        transition.changes_state
        and not transition.into
        and decided
        and not said.actions
        and not transition.first
        and not transition.resume
    )


def _usable(name: str) -> str:
    return f"{name}_" if keyword.iskeyword(name) else name


def _numbered(wish: str, taken: set[str]) -> str:
    """`wish`, or with the first number behind it that makes a name that is not taken; it is taken then."""
    name, number = wish, 2
    while name in taken:
        name, number = f"{wish}{number}", number + 1
    taken.add(name)
    return name


def _joined(words: Sequence[str], between: str, kind: str) -> str:
    """`SendBidOrDecline`; of more than three, the first and what it is: `ScanSequence`."""
    if len(words) > 3 or not words:
        return f"{words[0] if words else 'Empty'}{kind}"
    return between.join(words)


__all__ = ["POINTS", "Behaviour", "Kind", "Tree", "Waker", "behaviour_tree"]
