"""Search: all states of two versions together, the nearest first, up to where they do not do the same."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import field
from time import process_time

from aseme_dsl.proofs.compare.decisions import Decisions
from aseme_dsl.proofs.compare.frozen import frozen
from aseme_dsl.proofs.compare.inputs import BEGIN, Move, Surroundings
from aseme_dsl.proofs.compare.normal import horizon, oldest
from aseme_dsl.proofs.compare.side import Seen, Side, Stand
from aseme_dsl.proofs.compare.staging import Version, open_channels
from aseme_dsl.proofs.explore.ages import asks_for_history, thresholds_of
from aseme_dsl.proofs.explore.deciding.staging import lists_of
from aseme_dsl.proofs.wording import states_text
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan

LOOKS = 50
"""So many moves are made between two looks at the clock."""
WAYS, MOST_WAYS = 16, 1024
"""So many ways of a move are tried at first, and at the most, where not all are."""
START = 10**15
"""The moment (ns) at which a run begins."""


@dataclass(frozen=True, slots=True)
class Bounds:
    """How far a search goes: so many states, so many seconds of the processor's time, so many differences."""

    states: int = 50_000
    seconds: float = 20.0
    differences: int = 3


@dataclass(frozen=True, slots=True)
class Event:
    """A step of a story: what happens, what was decided for it, and what both versions do."""

    move: Move
    time: int
    """When, in ns since the beginning."""
    decided: tuple[str, ...]
    seen: tuple[Seen, ...]


@dataclass(frozen=True, slots=True)
class Difference:
    """A run in which one version does what the other does not, at its end."""

    story: tuple[Event, ...]
    """The last one has what both do in it."""
    only_old: tuple[Seen, ...]
    only_new: tuple[Seen, ...]


@dataclass(frozen=True, slots=True)
class Found:
    """What a search has found; `cut` says why it was not finished, if it was not."""

    differences: tuple[Difference, ...]
    states: int
    cut: str = ""
    tried: tuple[str, ...] = ()
    """What is tried for a few values only."""
    left_out: str = ""
    is_partial: bool = False
    """Whether something is tried for a few values that do not stand for all."""


@dataclass(frozen=True, slots=True)
class _Node:
    old: Stand
    new: Stand
    now: int
    there: frozenset[str]
    written: int
    """What was written and not read has numbers up to this one."""
    before: int | None = None
    event: Event | None = None
    depth: int = 0


@dataclass(slots=True)
class _Search:
    old: Side
    new: Side
    decisions: Decisions
    bounds: Bounds
    nodes: list[_Node] = field(default_factory=list)
    known: set[object] = field(default_factory=set)
    differences: dict[object, Difference] = field(default_factory=dict)
    is_thin: bool = False
    """Whether states are the same that have both versions in the same places: few are looked at."""
    longest: int | None = None
    """No run of more moves is looked for."""
    around: Surroundings | None = None
    made: int = 0
    """How often a move was made."""
    looks: int = 0
    """When it is looked at the clock again."""

    def run(self, until: float) -> str:
        """Search, until the processor's time is this; why it was cut, if it was."""
        around = self.around = Surroundings(self.old, self.new, self.decisions)
        first = _Node(self.old.stand(), self.new.stand(), START, frozenset(), 0)
        if not self._make(around, None, first, BEGIN, START, until):
            return f"{self.bounds.seconds:g} s"
        place = 0
        while place < len(self.nodes):
            node = self.nodes[place]
            if self.longest is not None and node.depth >= self.longest:
                return ""
            self._take_back(node)
            due = min((item for item in (self.old.due(), self.new.due()) if item is not None), default=None)
            moves = [(move, node.now) for move in around.moves()]
            if due is not None:
                moves.append((Move("time", f"{_duration(due - node.now)} pass"), due))
            for move, now in moves:
                if not self._make(around, place, node, move, now, until):
                    return f"{self.bounds.seconds:g} s"
            if len(self.differences) >= self.bounds.differences:
                return ""
            if len(self.nodes) > self.bounds.states:
                return states_text(self.bounds.states)
            place += 1
        return ""

    def _is_late(self, until: float) -> bool:
        """Whether the time is over; asked now and then, for the clock is slow in some surroundings."""
        if self.made < self.looks:
            return False
        self.looks = self.made + LOOKS
        return process_time() > until

    def _take_back(self, node: _Node) -> None:
        self.old.take_back(node.old)
        self.new.take_back(node.new)

    def _make(
        self, around: Surroundings, place: int | None, node: _Node, move: Move, now: int, until: float
    ) -> bool:
        """Make a move in each way that it can be made; whether there was time for all of them."""
        decisions = self.decisions
        decisions.begin(node.there)
        while True:
            self._take_back(node)
            number = node.written + 1
            self.made += 1
            done = [side.make(now, around.inputs(side, move, now, number)) for side in (self.old, self.new)]
            if not decisions.is_impossible:
                self._note(place, node, move, now, done)
            if self._is_late(until):
                return False
            if len(self.differences) >= self.bounds.differences or not decisions.again(node.there):
                return True

    def _note(
        self, place: int | None, node: _Node, move: Move, now: int, done: Sequence[tuple[Seen, ...]]
    ) -> None:
        old, new = map(Counter, done)
        both = tuple((old & new).elements())
        event = Event(move, now - START, tuple(self.decisions.choices.said), both)
        if old != new:
            only_old, only_new = tuple((old - new).elements()), tuple((new - old).elements())
            what = tuple(tuple(sorted({s.subject for s in items})) for items in (only_old, only_new))
            if what not in self.differences:
                self.differences[what] = Difference((*self._story(place), event), only_old, only_new)
            return
        if self.old.is_over and self.new.is_over:
            return
        made = self.decisions.made
        for side in (self.old, self.new):
            side.take_over(made)
        numbers = {
            number: rank
            for rank, number in enumerate(dict.fromkeys((*self.old.opened(), *self.new.opened())), 1)
        }
        for side in (self.old, self.new):
            side.renumber(numbers)
        there = self.decisions.there
        key: object = (self.old.key(), self.new.key(), there)
        if self.is_thin:
            key = (self.old.place(), self.new.place())
        if key in self.known:
            return
        self.known.add(key)
        self.nodes.append(
            _Node(self.old.stand(), self.new.stand(), now, there, len(numbers), place, event, node.depth + 1)
        )

    def _story(self, place: int | None) -> tuple[Event, ...]:
        found: list[Event] = []
        while place is not None:
            node = self.nodes[place]
            if node.event is not None:
                found.append(node.event)
            place = node.before
        return tuple(found[::-1])


def compare(
    old: Version,
    new: Version,
    agents: tuple[str, str],
    bounds: Bounds,
) -> Found:
    """The shortest runs that one version of a role can do and the other cannot.

    `agents` are the names of the agent that plays it, in each version.
    """
    plans = old.plan, new.plan
    decisions = Decisions(plans, {**old.types, **new.types})
    channels = open_channels(plans)
    first, second = (
        Side(version, agent, decisions, channels) for version, agent in zip((old, new), agents, strict=True)
    )
    first.frozen, second.frozen = frozen(*plans)
    first.longest = second.longest = horizon((first.chart, second.chart))
    first.ages = second.ages = oldest((first.chart, second.chart))
    for side in (first, second):
        side.chart.settle()
    # Differences that are far away are found first, where most of the states on the way are passed over.
    start = first.stand(), second.stand()
    until = process_time() + bounds.seconds / 2
    ways = WAYS
    thin = _Search(first, second, decisions, bounds, is_thin=True)
    while not thin.differences and process_time() < until and ways <= MOST_WAYS:
        decisions.sample(ways)
        first.take_back(start[0])
        second.take_back(start[1])
        thin = _Search(first, second, decisions, bounds, is_thin=True)
        thin.run(until)
        ways *= 4
    decisions.sample(0)
    first.take_back(start[0])
    second.take_back(start[1])
    longest = min((len(item.story) - 1 for item in thin.differences.values()), default=None)
    search = _Search(first, second, decisions, bounds, longest=longest)
    cut = search.run(until + bounds.seconds / 2)
    found = {**search.differences}
    for what, item in sorted(thin.differences.items(), key=lambda pair: len(pair[1].story)):
        found.setdefault(what, item)
    left_out = _left_out(plans) or Surroundings(first, second, decisions).left_out
    values = dict(decisions.values.bounds)
    if search.around is not None and search.around.is_limited:
        values["early"] = "one agent message that comes early"
    return Found(
        tuple(found.values())[: bounds.differences],
        max(len(search.nodes), len(thin.nodes)),
        cut,
        tuple(sorted(values.values())),
        left_out,
        bool(values),
    )


def _left_out(plans: Sequence[Plan]) -> str:
    """What is not compared; empty if nothing is."""
    for plan in plans:
        if not thresholds_of(plan)[1]:
            return f"{plan.name} does more with an age than compare it with a constant"
        if lists := lists_of(plan):
            return f"nothing is tried for the list {lists[0]}, which activities may write"
        if asks_for_history(plan):
            return f"{plan.name} asks for the history of a channel"
    return ""


def _duration(time: int) -> str:
    return f"{time / 1_000_000_000:g} s" if time >= 1_000_000_000 else f"{time / 1_000_000:g} ms"


__all__ = ["Bounds", "Difference", "Event", "Found", "compare"]
