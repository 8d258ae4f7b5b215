"""Search: all states of an explored team, the nearest first, and what happens on the way to each."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field
from heapq import heappop, heappush
from time import monotonic, process_time

from aseme_dsl.proofs.explore.deciding.others import NothingNew
from aseme_dsl.proofs.explore.explored import FAILS, Circling, Explored, Letter, Move
from aseme_dsl.proofs.explore.memory import Picture
from aseme_dsl.proofs.timed.stamp import Window
from aseme_dsl.proofs.wording import states_text
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.trace.records import Record

Kind = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Limits:
    """How far a search goes: so many states, and so many seconds of the processor's time."""

    states: int = 200_000
    seconds: float = 60.0
    queue: int = 4
    """So many agent messages, at the most, are on their way from one agent to another; half of topics."""
    moves: int = 10**12
    """So many moves are made at the most."""

    @property
    def time(self) -> str:
        """The seconds with two digits: `0.43 s`, `12 s`."""
        return f"{self.seconds:.2g} s" if self.seconds < 10 else f"{self.seconds:.0f} s"


@dataclass(frozen=True, slots=True)
class Step:
    """A move as it was made: which one of those that could be made, and by which decisions."""

    number: int
    way: tuple[int, ...]
    text: str
    passes: bool = False
    """Whether time passes."""
    origin: int = 0
    """With times: the number of the move, from which times are counted."""
    windows: tuple[Window, ...] = ()
    """With times: when it may be made."""
    kind: Kind = ()
    """That of the move; states that are the same may list their moves in another order."""

    def among(self, moves: Sequence[Move]) -> Move:
        """The move among those of a state."""
        if self.number < len(moves) and moves[self.number].kind == self.kind:
            return moves[self.number]
        return next(move for move in moves if move.kind == self.kind)


@dataclass(frozen=True, slots=True)
class Edge:
    """A move from one state to another."""

    target: int
    kind: Kind
    taken: frozenset[tuple[str, tuple[int, ...]]]
    """The transitions that agents have taken on it, those of a compound transition together."""
    step: Step
    letters: tuple[int, ...] = ()
    """Of each agent message that waits after it (see `Graph.letters`): its place among those that waited
    before; NEW or CROSSED if it has come with this move."""
    is_own: bool = True
    """Whether nothing has come of others (see `Others`) in it."""
    of_others: tuple[int, ...] = ()
    """Which of its decisions others make: how many have answered, and what they have published."""


ENOUGH = "what was asked for is refuted"
"""Why a search ended before it was asked to."""

NEW, CROSSED = -1, -2
"""An agent message has come now; the second, if it has crossed one of its receiver."""

Arrival = tuple[int, Step] | None
"""How a state was reached: a state, and the move that was made there; None for the first one."""


@dataclass(frozen=True, slots=True)
class Sighting:
    """Something that was seen for the first time, in a move."""

    kind: str
    text: str
    at: Arrival
    expects: tuple[str, ...] = ()
    """Statements of a scenario that do not hold in a run with it."""


@dataclass(slots=True)
class Graph:
    """What a search has found. States have numbers in the order of their finding; 0 is the first."""

    parents: list[Arrival] = field(default_factory=list)
    edges: dict[int, tuple[Edge, ...]] = field(default_factory=dict)
    """Of the states whose moves were all made."""
    enabled: dict[int, frozenset[Kind]] = field(default_factory=dict)
    """The kinds of the moves of a state that happen some time, if they can all the time."""
    places: list[tuple[tuple[int, ...], ...]] = field(default_factory=list)
    """Where each agent is in each state: the number of the active leaf of each region."""
    awaited: list[frozenset[int]] = field(default_factory=list)
    """The expectations for which something is still awaited in each state."""
    letters: list[tuple[Letter, ...]] = field(default_factory=list)
    """The agent messages that wait at agents in each state."""
    pictures: dict[int, Picture] = field(default_factory=dict)
    sightings: list[Sighting] = field(default_factory=list)
    broken: dict[int, Arrival] = field(default_factory=dict)
    """The move in which an expectation is broken first, by its number."""
    met: set[int] = field(default_factory=set)
    """The conditions that were met in some state."""
    visited: dict[str, set[str]] = field(default_factory=dict)
    """The labels of the states of each role in which an agent was."""
    taken: dict[str, set[int]] = field(default_factory=dict)
    """The transitions of each role that an agent has taken."""
    cut: str | None = None
    """Why the search was not finished, if it was not."""
    is_queue_cut: bool = False
    """Whether more messages were on their way than are looked at."""
    moves: int = 0

    def way_to(self, state: int) -> list[Step]:
        """The moves on the way on which a state was found."""
        return self.way_with(self.parents[state])

    def way_with(self, arrival: Arrival) -> list[Step]:
        """The moves on the way that ends with this one."""
        steps: list[Step] = []
        while arrival is not None:
            state, step = arrival
            steps.append(step)
            arrival = self.parents[state]
        return steps[::-1]


class Eyes:
    """Listens to the trace of a team that is explored."""

    def __init__(self) -> None:
        self.taken: set[tuple[str, tuple[int, ...]]] = set()
        self.seen: list[tuple[str, str, tuple[str, ...]]] = []
        """What is to be noted: its kind, what is to be said of it, and statements that it breaks."""
        self.untaken: list[tuple[str, str, str, str]] = []
        """Agent messages that nothing has taken: sender, receiver, what is to be said of it, and the type."""

    def clear(self) -> None:
        """A move is made."""
        self.taken.clear()
        self.seen.clear()
        self.untaken.clear()

    def wants(self, kind: str, what: str | None) -> bool:
        """Whether such a line is looked at; others are not made."""
        return kind in ("step", "unexpected", "error")

    def __call__(self, record: Record) -> None:
        match record["kind"]:
            case "step":
                for way in record["taken"]:
                    self.taken.add((record["agent"], tuple(way["transitions"])))
            case "unexpected":
                what = f"{record.get('performative', '')} {record.get('message', '')}".strip()
                text = f"{record['agent']} does not take {what} of {record['sender']}: {record['reason']}"
                if record.get("performative") != "not_understood":
                    message = str(record.get("message", ""))
                    self.untaken.append((record["sender"], record["agent"], text, message))
            case "error":
                why = record["reason"].replace(f" failed: RuntimeError: {FAILS}", " fails, as is assumed")
                self.seen.append(("failure", f"{record['agent']} fails: {why}", ()))


@dataclass(frozen=True, slots=True)
class Monitors:
    """What is watched in each state."""

    awaited: Callable[[], frozenset[int]] = frozenset
    broken: Callable[[], Sequence[int]] = tuple
    """The expectations that are broken now, and were not before; from now on they count as kept."""
    met: Callable[[], set[int]] = set


def never_untaken(message: str, receiver: str) -> str:
    """The statement of a scenario that an agent takes what comes to it of a type."""
    return f"never untaken {message} by {receiver}"


def search(
    explored: Explored,
    eyes: Eyes,
    monitors: Monitors | None,
    limits: Limits,
    is_enough: Callable[[Graph], bool] = lambda graph: False,
    far: Callable[[], int] | None = None,
) -> Graph:
    """All states, or as many as the limits allow, or as are enough.

    The nearest are looked at first. If `far` is given, it guesses in each state how many moves are left, and
    those of which it expects the most come first.
    """
    return Search(explored, eyes, monitors or Monitors(), limits, is_enough, far).run()


GREED = 3
"""So many moves more on the way are as good as one less that is left, by the guess."""


class Agenda:
    """The states that are still to be looked at, in the order in which they are."""

    def __init__(self, far: Callable[[], int] | None) -> None:
        self._far = far
        self._waiting: list[tuple[int, int]] = []
        self._ranks: list[int] = []
        self._depth: list[int] = []

    def add(self, number: int, before: int | None) -> None:
        """The team is in a new state, reached from the state `before`."""
        depth = 0 if before is None else self._depth[before] + 1
        self._depth.append(depth)
        self._ranks.append(0 if self._far is None else depth + GREED * self._far())
        self.put_back(number)

    def put_back(self, number: int) -> None:
        """There is more to look at in a state."""
        heappush(self._waiting, (self._ranks[number], number))

    def has_better(self, number: int) -> bool:
        """Whether another state comes before this one."""
        return bool(self._waiting) and self._waiting[0][0] < self._ranks[number]

    def take(self) -> int | None:
        """The next one; None if there is none."""
        return heappop(self._waiting)[1] if self._waiting else None


class Clock:
    """Tells when so many seconds of the processor's time have passed; it may be asked very often."""

    def __init__(self, seconds: float) -> None:
        self._until = process_time() + seconds
        self._next = 0.0
        self._is_over = False

    def is_over(self) -> bool:
        """Whether they have passed; that may be told a hundredth of a second later, and then always."""
        now = monotonic()
        if not self._is_over and now >= self._next:  # to ask for the processor's time takes long
            self._next = now + 0.01
            self._is_over = process_time() > self._until
        return self._is_over


class Search:
    """One search, by what its methods do with the states that are found."""

    def __init__(
        self,
        explored: Explored,
        eyes: Eyes,
        monitors: Monitors,
        limits: Limits,
        is_enough: Callable[[Graph], bool],
        far: Callable[[], int] | None,
    ) -> None:
        self._is_enough = is_enough
        self._agenda = Agenda(far)
        self._begun: dict[int, Iterator[None]] = {}
        """The states of which some moves have been made."""
        self._is_elsewhere = False
        """Whether another state was looked at since the last move of this one."""
        self._explored = explored
        self._eyes = eyes
        self._monitors = monitors
        self._limits = limits
        self._graph = Graph()
        self._numbers: dict[bytes, int] = {}
        self._crowded: set[int] = set()
        """The states from which the search does not continue, as too many messages are on their way."""
        self._clock = Clock(limits.seconds)

    def run(self) -> Graph:
        """All states, or as many as the limits allow, or as are enough."""
        graph = self._graph
        self._begin()
        while (place := self._agenda.take()) is not None:
            if reason := self._is_over():
                graph.cut = reason
                break
            if place not in self._crowded:
                self._look_at(place)
        graph.met = self._monitors.met()
        return graph

    def _begin(self) -> None:
        """The first state."""
        self._explored.settle()
        try:
            self._explored.begin()
        except Circling as problem:
            self._graph.sightings.append(Sighting("circling", str(problem), None))
        self._note(None)
        self._look(None)

    def _is_over(self) -> str | None:
        if self._is_enough(self._graph):
            return ENOUGH
        if len(self._graph.parents) >= self._limits.states:
            return states_text(self._limits.states)
        if self._graph.moves >= self._limits.moves:
            return f"{self._limits.moves} moves"
        if self._clock.is_over():
            return self._limits.time
        return None

    def _look_at(self, state: int) -> None:
        """Make the moves of a state, until one leads to a state that comes before it, or time is over."""
        self._is_elsewhere = state in self._begun
        begun = self._begun.pop(state, None) or self._expand(state)
        for _ in begun:
            if self._is_enough(self._graph):
                break
            if self._agenda.has_better(state) or self._clock.is_over():
                self._begun[state] = begun
                self._agenda.put_back(state)
                break

    def _expand(self, state: int) -> Iterator[None]:
        """Make every move of a state, one after another."""
        explored, graph = self._explored, self._graph
        picture = graph.pictures[state]
        letters, moves = self._moves_of(state)
        first = explored.first(moves)
        edges: list[Edge] = []
        for number, move in enumerate(moves):
            if first is not None and move is not first:
                continue
            explored.choices.begin()
            while True:
                explored.take_back(picture)
                edges += self._make(state, number, move, letters)
                if move.is_idle and edges and edges[-1].target == state:
                    break
                if explored.others is not None:
                    explored.others.close()
                kept = explored.choices.kept()
                yield
                if self._is_elsewhere:
                    self._is_elsewhere = False
                    explored.take_back(picture)
                    explored.coming.look()
                    explored.choices.take_back(kept)
                if not explored.choices.again():
                    break
        graph.edges[state] = tuple(edges)

    def _moves_of(self, state: int) -> tuple[Mapping[Letter, int], Sequence[Move]]:
        """Take the team back to a state: its agent messages that wait, with their places, and its moves."""
        explored = self._explored
        explored.take_back(self._graph.pictures[state])
        letters = {item: place for place, item in enumerate(explored.letters())}
        moves = list(explored.moves())
        self._graph.enabled[state] = frozenset(move.kind for move in moves if move.is_fair)
        return letters, moves

    def _make(self, state: int, number: int, move: Move, before: Mapping[Letter, int]) -> Iterator[Edge]:
        explored, graph, eyes = self._explored, self._graph, self._eyes
        eyes.clear()
        graph.moves += 1
        circling = None
        try:
            explored.make(move)
        except Circling as problem:
            circling = str(problem)
        except NothingNew:
            return
        text = "; ".join((move.text, *explored.choices.said))
        self._judge()
        passes = move.passes or any(came.least for came in explored.came)
        step = Step(number, explored.choices.way(), text, passes, kind=move.kind)
        target = self._note((state, step))
        self._look((state, step))
        if circling is not None:
            graph.sightings.append(Sighting("circling", circling, (state, step)))
        new = CROSSED if explored.arriving is not None and explored.arriving.crosses else NEW
        letters = tuple([before.get(item, new) for item in explored.letters()])
        taken, of_others = frozenset(eyes.taken), tuple(explored.choices.of_others)
        yield Edge(target, move.kind, taken, step, letters, explored.is_own(move.kind), of_others)

    def _judge(self) -> None:
        """Whether a message that nothing takes is more than late: its receiver has let no deadline pass.

        A message that crosses one of its receiver could not know better. If that is not taken either, both
        have chosen.
        """
        explored, eyes = self._explored, self._eyes
        if not explored.judges or explored.crashed:
            return
        for sender, receiver, text, message in eyes.untaken:
            expects = (never_untaken(message, receiver),)
            if explored.arriving is None or not explored.arriving.crosses:
                if not explored.late.intersection((sender, receiver)):
                    eyes.seen.append(("orphan", text, expects))
                continue
            if (receiver, sender) in explored.spurned:
                eyes.seen.append(("race", text, expects))
            explored.spurned.add((sender, receiver))

    def _note(self, before: Arrival) -> int:
        """The number of the state in which the team is."""
        explored, graph = self._explored, self._graph
        for place in self._monitors.broken():
            graph.broken.setdefault(place, before)
        picture = explored.picture()
        key = explored.memory.key(picture)
        number = self._numbers.get(key)
        if number is not None:
            return number
        number = self._numbers[key] = len(graph.parents)
        if explored.longest() > self._limits.queue:
            graph.is_queue_cut = True
            self._crowded.add(number)
        graph.parents.append(before)
        graph.pictures[number] = picture
        self._agenda.add(number, None if before is None else before[0])
        graph.places.append(tuple(_places(agent) for agent in explored.agents))
        graph.awaited.append(self._monitors.awaited())
        graph.letters.append(explored.letters())
        return number

    def _look(self, move: Arrival) -> None:
        """Note what was seen in a move."""
        graph = self._graph
        for agent in self._explored.agents:
            graph.visited.setdefault(agent.role, set()).update(
                agent.chart.configuration() if agent.chart.started and not agent.over else ()
            )
        roles = {agent.name: agent.role for agent in self._explored.agents}
        for name, way in self._eyes.taken:
            graph.taken.setdefault(roles[name], set()).update(way)
        known = {(item.kind, item.text) for item in graph.sightings}
        for kind, text, expects in self._eyes.seen:
            if (kind, text) not in known:
                graph.sightings.append(Sighting(kind, text, move, expects))
                self._explored.judged.discard(kind)


def _places(agent: Agent) -> tuple[int, ...]:
    chart = agent.chart
    if agent.over or agent.down:
        return (-2,)
    return tuple(getattr(chart, f"r{number}") for number in range(len(chart.REGIONS)))


__all__ = [
    "CROSSED",
    "ENOUGH",
    "NEW",
    "Agenda",
    "Clock",
    "Edge",
    "Eyes",
    "Graph",
    "Limits",
    "Monitors",
    "Search",
    "Sighting",
    "Step",
    "never_untaken",
    "search",
]
