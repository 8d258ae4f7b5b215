"""Search with times: all states of a team, each with as many times at once as possible.

A state is what all objects hold, together with a zone: what is known of the times since those moves from
which something is still counted. Two ways to one state with other times are two states, unless the zone of
one covers that of the other. So a search ends, however many times there are.

Nothing happens later than it must: from a state, time passes at most until the first of what is due.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from aseme_dsl.proofs.explore.explored import Circling, Explored, Move
from aseme_dsl.proofs.explore.search import (
    ENOUGH,
    Agenda,
    Arrival,
    Clock,
    Eyes,
    Graph,
    Limits,
    Monitors,
    Sighting,
    Step,
)
from aseme_dsl.proofs.timed.stamp import Mark, Window
from aseme_dsl.proofs.timed.zone import (
    Zone,
    at_most,
    begun,
    begun_before,
    covers,
    kept,
    later,
    narrowed,
    shown,
)
from aseme_dsl.proofs.wording import states_text
from aseme_dsl.records import dataclass

_Rows = tuple[tuple[int, ...], ...]


@dataclass(frozen=True, slots=True)
class Due:
    """A moment after which an expectation is broken (`breaks`), or does not wait any more.

    Until `last` ns after the move `origin`, it waits; later, `pass_` is called.
    """

    number: int
    mark: Mark
    last: int
    breaks: bool
    pass_: Callable[[], None]


@dataclass(frozen=True, slots=True)
class Watching:
    """What is watched. `dues` are what expectations wait for in the present state, and `begins` is called at
    each new moment."""

    monitors: Monitors = Monitors()
    dues: Callable[[], Sequence[Due]] = tuple
    begins: Callable[[], None] = lambda: None
    noted: Callable[[Zone], None] = lambda zone: None
    """Called with what is known of times after each move."""
    far: Callable[[], int] | None = None
    """A guess how many moves are left until an expectation is broken."""
    stays: Callable[[Zone], None] = lambda zone: None
    """Called in each state, with what is known of times as long as nothing happens."""


def search_with_times(
    explored: Explored, eyes: Eyes, watching: Watching, limits: Limits, horizon: int | None
) -> Graph:
    """All states up to the first in which an expectation is broken, or as many as the limits allow; without
    what comes after the `horizon`, if there is one. If nothing is watched, up to the first failure."""
    return _Search(explored, eyes, watching, limits, horizon).run()


@dataclass(frozen=True, slots=True)
class _Known:
    """A state, with its zone as bounds of the times that are counted there."""

    number: int
    rows: _Rows


class _Search:
    def __init__(
        self,
        explored: Explored,
        eyes: Eyes,
        watching: Watching,
        limits: Limits,
        horizon: int | None,
    ) -> None:
        self._explored = explored
        self._eyes = eyes
        self._wants_failures = watching.monitors.broken is tuple
        self._monitors = watching.monitors
        self._dues = watching.dues
        self._begins = watching.begins
        self._watching = watching
        self._limits = limits
        self._horizon = horizon
        self._graph = Graph()
        self._agenda = Agenda(watching.far)
        self._zones: list[Zone] = []
        self._crowded: set[int] = set()
        self._known: dict[tuple[bytes, tuple[str, ...]], list[_Known]] = {}
        self._clock = Clock(limits.seconds)

    def run(self) -> Graph:
        graph = self._graph
        self._begins()
        self._explored.settle()
        try:
            self._explored.begin()
        except Circling as problem:
            graph.cut = f"the first step, in which agents step without end: {problem}"
            return graph
        self._note(begun(Zone(), 0), None)
        while (place := self._agenda.take()) is not None:
            if graph.broken or graph.sightings:
                graph.cut = ENOUGH
            elif len(graph.parents) >= self._limits.states:
                graph.cut = states_text(self._limits.states)
            elif self._clock.is_over():
                graph.cut = self._limits.time
            if graph.cut is not None:
                break
            if place not in self._crowded:
                self._expand(place)
                if place:
                    del graph.pictures[place]
        graph.met = self._monitors.met()
        return graph

    # ---- the moves of a state --------------------------------------------------------------------

    def _expand(self, state: int) -> None:
        explored, picture = self._explored, self._graph.pictures[state]
        explored.take_back(picture)
        moves = list(explored.moves())
        windows = [self._window(self._zones[state], move) for move in moves]
        dues = self._dues()
        bounds = [Window(item.origin, 0, item.high) for item in windows if item is not None]
        if self._horizon is not None:
            bounds.append(Window(0, 0, self._horizon))
        there = _within(later(self._zones[state]), bounds)
        waiting = [Window(due.mark.origin, 0, due.mark.offset + due.last) for due in dues]
        for due in dues:
            others = [item for item, other in zip(waiting, dues, strict=True) if other is not due]
            own = Window(due.mark.origin, due.mark.offset + due.last + 1, None)
            late = _from(_within(there, others), own)
            if late is not None:
                self._pass(state, due, late, (*bounds, *others, own))
        there = _within(there, waiting)
        if there is not None:
            self._watching.stays(there)
        for number, (move, own_window) in enumerate(zip(moves, windows, strict=True)):
            zone = there if own_window is None else _from(there, own_window)
            if zone is None:
                continue
            limits = (*bounds, *waiting, *(() if own_window is None else (own_window,)))
            explored.choices.begin()
            while True:
                explored.take_back(picture)
                self._make(state, number, move, zone, limits)
                if not explored.choices.again():
                    break

    def _window(self, zone: Zone, move: Move) -> Window | None:
        """When a move is made. It has no end if that may have passed before it could be made."""
        item = move.window
        place = None if item is None else zone.place(item.origin)
        if item is None or place is None:
            return None
        is_over = item.high is not None and zone.rows[place][0] > at_most(item.high)
        return Window(item.origin, item.low, None) if is_over else item

    def _pass(self, state: int, due: Due, zone: Zone, windows: tuple[Window, ...]) -> None:
        """What an expectation waits for has not come in time; or that which it forbids."""
        explored, graph = self._explored, self._graph
        explored.moved += 1
        text = "what is awaited has not come in time" if due.breaks else "what is forbidden is so no longer"
        step = Step(-1, (), text, True, explored.moved, windows)
        if due.breaks:
            graph.broken.setdefault(due.number, (state, step))
            return
        explored.take_back(graph.pictures[state])
        explored.memory.touch(-1)
        due.pass_()
        self._note(begun(zone, explored.moved), (state, step))

    def _make(
        self, state: int, number: int, move: Move, zone: Zone | None, windows: tuple[Window, ...]
    ) -> None:
        explored, graph = self._explored, self._graph
        self._eyes.clear()
        graph.moves += 1
        explored.next_moment()
        self._begins()
        met = set(self._monitors.met())
        try:
            explored.make(move)
        except Circling as problem:
            graph.cut = f"agents step without end at one moment: {problem}"
            return
        for item in explored.windows:
            zone = _within(_from(zone, item), [item])
        if zone is None:  # at no moment
            self._monitors.met().intersection_update(met)
            return
        text = "; ".join((move.text, *explored.choices.said))
        way = explored.choices.way()
        windows = (*windows, *explored.windows)
        step = Step(number, way, text, move.passes, explored.moved, windows, move.kind)
        if self._wants_failures:
            seen = (Sighting(kind, text, (state, step)) for kind, text, _ in self._eyes.seen)
            graph.sightings += [item for item in seen if item.kind == "failure"]
        zone = begun(zone, explored.moved)
        for sent in explored.sent:
            zone = begun_before(zone, sent.origin, sent.least, sent.most)
        self._note(zone, (state, step))

    def _note(self, zone: Zone, before: Arrival) -> None:
        explored, graph = self._explored, self._graph
        for number in self._monitors.broken():
            graph.broken.setdefault(number, before)
        self._watching.noted(zone)
        picture = explored.picture()
        marks = sorted(
            (
                mark
                for mark in (*explored.marks(), *(due.mark for due in self._dues()))
                if mark.origin in zone.clocks
            ),
            key=lambda mark: mark.name,
        )
        is_first = self._horizon is not None or before is None
        origins = {mark.origin for mark in marks} | ({0} if is_first else set())
        zone = kept(zone, sorted(origins))
        shows = [(mark.origin, mark.offset) for mark in marks]
        if self._horizon is not None:
            shows.append((0, 0))
        rows = shown(zone, shows)
        key = explored.memory.key(picture), tuple(mark.name for mark in marks)
        others = self._known.setdefault(key, [])
        if any(covers(other.rows, rows) for other in others):
            return
        others[:] = [other for other in others if not covers(rows, other.rows)]
        number = len(graph.parents)
        others.append(_Known(number, rows))
        if explored.longest() > self._limits.queue:
            graph.is_queue_cut = True
            self._crowded.add(number)
        graph.parents.append(before)
        graph.pictures[number] = picture
        self._agenda.add(number, None if before is None else before[0])
        self._zones.append(zone)


def _within(zone: Zone | None, windows: Sequence[Window]) -> Zone | None:
    """Not later than windows end. Of those that are counted from what is forgotten, nothing is known."""
    for item in windows:
        place = None if zone is None else zone.place(item.origin)
        if zone is not None and place is not None and item.high is not None:
            zone = narrowed(zone, place, 0, at_most(item.high))
    return zone


def _from(zone: Zone | None, item: Window) -> Zone | None:
    """Not earlier than a window begins."""
    place = None if zone is None else zone.place(item.origin)
    return zone if zone is None or place is None else narrowed(zone, 0, place, at_most(-item.low))


__all__ = ["Due", "search_with_times"]
