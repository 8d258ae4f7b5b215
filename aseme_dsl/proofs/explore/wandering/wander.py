"""Wander: long runs of a team, each from where something may be near that was not reached yet.

Where there are too many states, a search of the nearest ones does not come far. So one move after another is
drawn here, until nothing new has come for some time. Each run has its own favourites: in one the moves of an
agent are rare, in another one deadlines pass often. What is drawn is the same on each machine.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from random import Random

from aseme_dsl.proofs.explore.explored import Explored, Letter, Move
from aseme_dsl.proofs.explore.search import ENOUGH, Edge, Eyes, Graph, Limits, Monitors, Search
from aseme_dsl.proofs.explore.wandering.tries import Tries
from aseme_dsl.proofs.guide import FAR, distances
from aseme_dsl.proofs.wording import states_text

Goal = tuple[str, str]
"""A role and the label of a state of it, at which something was not reached yet."""

_LIKELY = {
    **dict.fromkeys(("input", "event"), 0.3),
    **dict.fromkeys(("act", "lose", "fail"), 0.1),
    **dict.fromkeys(("time", "timer", "pace", "pause"), 0.05),
    **dict.fromkeys(("crash",), 0.02),
}
"""How likely some moves are, where others have 1: most of these end what the agents are about."""
_LAST = 0.02
"""The same of a move like one with which an agent has ended."""
_FAVOUR = (0.05, 0.3, 1.0)
_FAVOUR_OF_AGENT = (0.05, 1.0, 1.0)
"""How much less likely a move, or all those of one agent, may be in one run."""
_PATIENCE = 20
"""A run ends after so many moves without anything new."""
_PICKED = 200
"""From so many kinds of states, at the most, the nearest one is picked."""
_MORE = 3
"""As long as something was not reached yet, there may be so many times as many states."""
_BEGIN, _NEWS, _GOAL = 0.05, 0.3, 0.8
"""A run begins at the beginning, where something new was seen, or near a goal, if a number below is drawn."""

_Cell = tuple[tuple[str, tuple[int, ...]], ...]
"""Where the agents of each role are: states that look alike."""


def wander(
    explored: Explored,
    eyes: Eyes,
    monitors: Monitors | None,
    limits: Limits,
    is_enough: Callable[[Graph, Sequence[Goal]], bool],
    goals: Callable[[Graph], Sequence[Goal]],
) -> Graph:
    """The states of long runs, as many as the limits allow, or as are enough. `goals` are the places where
    something was not reached yet; `is_enough` is given these, too."""
    return _Wander(explored, eyes, monitors or Monitors(), limits, is_enough, goals).run()


class _Wander(Search):
    def __init__(
        self,
        explored: Explored,
        eyes: Eyes,
        monitors: Monitors,
        limits: Limits,
        is_enough: Callable[[Graph, Sequence[Goal]], bool],
        goals: Callable[[Graph], Sequence[Goal]],
    ) -> None:
        super().__init__(explored, eyes, monitors, limits, lambda graph: is_enough(graph, self._left()), None)
        self._goals = goals
        self._random = Random(1).random
        self._tries: dict[int, dict[int, Tries]] = {}
        """Of each state that was left, what was tried of its moves."""
        self._edges: dict[int, list[Edge]] = {}
        self._cells: dict[_Cell, list[int]] = {}
        """The states from which there is more to try."""
        self._runs: dict[_Cell, int] = {}
        """How many runs have begun in such states."""
        self._ends: set[tuple[str, ...]] = set()
        """The moves with which an agent has ended."""
        self._news: list[int] = []
        """The states in which something new was seen."""
        self._known: tuple[int, Sequence[Goal]] | None = None
        """What was not reached, when so much was seen."""
        self._ways: dict[Goal, dict[str, int]] = {}
        self._far: dict[tuple[_Cell, Goal], int] = {}

    def run(self) -> Graph:
        """Long runs, one after another."""
        graph = self._graph
        self._begin()
        self._open(0)
        reason = None
        while self._cells and (reason := self._is_over()) is None:
            self._run(*self._beginning())
        graph.cut = reason
        graph.met = self._monitors.met()
        return graph

    def _is_over(self) -> str | None:
        states = len(self._graph.parents)
        if self._is_enough(self._graph):
            return ENOUGH
        if states >= self._limits.states and (states >= _MORE * self._limits.states or not self._left()):
            return states_text(states)
        return self._limits.time if self._clock.is_over() else None

    def _left(self) -> Sequence[Goal]:
        """What was not reached yet."""
        seen = self._seen()
        if self._known is None or self._known[0] != seen:
            self._known = seen, self._goals(self._graph)
        return self._known[1]

    def _draw(self, width: int) -> int:
        return int(self._random() * width)

    # ---- where runs begin --------------------------------------------------------------------

    def _beginning(self) -> tuple[int, Goal | None]:
        """The state in which a run begins, with what is near."""
        drawn = self._random()
        if drawn < _BEGIN and 0 in self._cells.get(self._cell(0), ()):
            return 0, None
        if drawn < _NEWS:
            news = [state for state in self._news if state in self._cells.get(self._cell(state), ())]
            if news:
                return news[self._draw(len(news))], None
        goals = self._left() if drawn < _GOAL else ()
        goal = goals[self._draw(len(goals))] if goals else None
        cells = list(self._cells)
        if len(cells) > _PICKED:
            cells = [cells[self._draw(len(cells))] for _ in range(_PICKED)]
        ranks = [
            (
                (0 if goal is None else self._distance(cell, goal)) + self._runs.get(cell, 0),
                len(self._cells[cell]),
                self._random(),
            )
            for cell in cells
        ]
        cell = cells[ranks.index(min(ranks))]
        self._runs[cell] = self._runs.get(cell, 0) + 1
        states = self._cells[cell]
        return states[self._draw(len(states))], goal

    def _cell(self, state: int) -> _Cell:
        agents = self._explored.agents
        places = self._graph.places[state]
        return tuple(sorted((agent.role, place) for agent, place in zip(agents, places, strict=True)))

    def _open(self, state: int) -> None:
        """There is more to try in a state."""
        self._cells.setdefault(self._cell(state), []).append(state)

    def _close(self, state: int) -> None:
        """There is nothing more to try in a state."""
        cell = self._cell(state)
        states = self._cells[cell]
        states.remove(state)
        if not states:
            del self._cells[cell]

    def _distance(self, cell: _Cell, goal: Goal) -> int:
        """How many activities have to end, by a guess, before an agent is where something is near."""
        if (cell, goal) not in self._far:
            role, label = goal
            agent = next(agent for agent in self._explored.agents if agent.role == role)
            if goal not in self._ways:
                self._ways[goal] = distances(agent.plan, frozenset((label,)))
            self._far[cell, goal] = min(
                (
                    self._ways[goal].get(agent.chart.LEAVES[region][leaf], FAR)
                    for name, places in cell
                    if name == role
                    for region, leaf in enumerate(places)
                    if leaf >= 0
                ),
                default=FAR,
            )
        return self._far[cell, goal]

    # ---- runs ----------------------------------------------------------------------------------

    def _run(self, state: int, goal: Goal | None) -> None:
        """A run from a state on, until nothing new has come for some time, or nothing is near any more."""
        favour: dict[tuple[str, ...], float] = {}
        quiet = 0
        can_reach = goal is not None and self._distance(self._cell(state), goal) < FAR
        while quiet < _PATIENCE and self._is_over() is None:
            before = self._seen()
            found = self._go_on(state, favour)
            if found is None or self._eyes.seen:  # an agent has failed: little comes of that
                return
            state, is_new = found
            quiet += 1
            if self._seen() > before:
                self._news.append(state)
                quiet = 0
            elif is_new and len(self._cells.get(self._cell(state), ())) == 1:
                quiet = max(0, quiet - 5)
            if can_reach and goal is not None and self._distance(self._cell(state), goal) >= FAR:
                return

    def _seen(self) -> int:
        graph = self._graph
        return sum(map(len, graph.visited.values())) + sum(map(len, graph.taken.values()))

    def _go_on(self, state: int, favour: dict[tuple[str, ...], float]) -> tuple[int, bool] | None:
        """The state behind one more move, and whether it is new; None: there is no move left to try."""
        explored, graph = self._explored, self._graph
        tries = self._tries.get(state)
        if state in self._crowded or (tries is not None and all(item.is_over for item in tries.values())):
            return None
        letters, moves = self._moves_of(state)
        if tries is None:
            first = explored.first(moves)
            tries = self._tries[state] = {
                number: Tries() for number, move in enumerate(moves) if first is None or move is first
            }
            self._edges[state] = []
        number = self._drawn(moves, [number for number, item in tries.items() if not item.is_over], favour)
        if number is not None:
            found = self._try(state, number, moves[number], letters, tries[number])
        if all(item.is_over for item in tries.values()):
            graph.edges[state] = tuple(self._edges.pop(state))
            self._close(state)
        return None if number is None else found

    def _drawn(
        self, moves: Sequence[Move], numbers: Sequence[int], favour: dict[tuple[str, ...], float]
    ) -> int | None:
        """One of the moves with these numbers."""
        if not numbers:
            return None
        weights = [self._weight(moves[number], favour) for number in numbers]
        drawn = self._random() * sum(weights)
        for number, weight in zip(numbers, weights, strict=True):
            drawn -= weight
            if drawn < 0:
                return number
        return numbers[-1]

    def _weight(self, move: Move, favour: dict[tuple[str, ...], float]) -> float:
        if move.kind not in favour:
            favour[move.kind] = _FAVOUR[self._draw(len(_FAVOUR))] * _LIKELY.get(move.kind[0], 1.0)
        agent = ("", move.agent)
        if agent not in favour:
            favour[agent] = _FAVOUR_OF_AGENT[self._draw(len(_FAVOUR_OF_AGENT))] if move.agent else 1.0
        return favour[move.kind] * favour[agent] * (_LAST if move.kind in self._ends else 1.0)

    def _try(
        self, state: int, number: int, move: Move, letters: Mapping[Letter, int], tries: Tries
    ) -> tuple[int, bool]:
        """Make a move, on a way on which it was not made, if that can be known."""
        explored = self._explored
        known = len(self._graph.parents)
        explored.take_back(self._graph.pictures[state])
        explored.choices.begin()
        if not move.is_idle or tries.has_begun:
            explored.choices.draw = lambda before, width: tries.next(before, width, self._draw)
        try:
            (edge,) = self._make(state, number, move, letters)
        finally:
            explored.choices.draw = None
        way, widths = explored.choices.kept()
        tries.add(way, widths)
        if move.is_idle and edge.target == state:
            tries.is_over = True
        if self._graph.places[edge.target].count((-2,)) > self._graph.places[state].count((-2,)):
            self._ends.add(move.kind)
        if edge not in self._edges[state]:
            self._edges[state].append(edge)
        if edge.target == known and known not in self._crowded:
            self._open(known)
        return edge.target, edge.target == known


__all__ = ["Goal", "wander"]
