"""Questions: what is asked of all states of a team: waits that nothing ends, and what has to come."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import replace
from functools import partial

from aseme_dsl.proofs.explore.deciding.staging import raised_by
from aseme_dsl.proofs.explore.explored import Explored, Letter
from aseme_dsl.proofs.explore.search import CROSSED, NEW, Edge, Graph, Kind, Step
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.agent.agent import Agent
from aseme_dsl.runtime.team.ending import Waiting, waits_of
from aseme_dsl.runtime.team.outside import Need, wait_for_input


@dataclass(frozen=True, slots=True)
class Stuck:
    """An agent that waits for ever, and where, from a state on. `past` is another one, if there is one: each
    has sent the other a message that nothing takes."""

    agent: str
    waiting: Waiting
    state: int
    past: str | None = None


def stuck(explored: Explored, graph: Graph) -> Stuck | None:
    """The nearest wait that nothing ends; not one for a conversation to begin, or for an outer input."""
    found: list[Stuck] = []
    back = _back(graph)
    for place, agent in enumerate(explored.agents):
        for region in range(len(agent.chart.REGIONS)):
            for state in _for_ever(graph, back, place, region, agent):
                if found and found[0].state <= state:
                    break
                waiting = _waits(explored, graph, state, place, region)
                if waiting is not None:
                    found = [Stuck(agent.name, waiting, state, _past(explored, agent))]
                    break
    return found[0] if found else None


def _back(graph: Graph) -> dict[int, list[int]]:
    """The states from which a move leads to a state."""
    found: dict[int, list[int]] = {}
    for source, edges in graph.edges.items():
        for edge in edges:
            found.setdefault(edge.target, []).append(source)
    return found


def _for_ever(
    graph: Graph, back: Mapping[int, list[int]], place: int, region: int, agent: Agent
) -> Iterator[int]:
    """The states from which on a region of an agent stays where it is in all continuations."""
    where = [_leaf(places[place], region) for places in graph.places]
    label = agent.chart.REGIONS[region]
    moving = [
        state
        for state in range(len(where))
        if state not in graph.edges
        or any(_moves(edge, where, state, agent, label) for edge in graph.edges[state])
    ]
    can = set(moving)
    todo = deque(moving)
    while todo:
        for source in back.get(todo.popleft(), ()):
            if source not in can:
                can.add(source)
                todo.append(source)
    return (state for state in range(len(where)) if state not in can and where[state] >= 0)


def _leaf(places: tuple[int, ...], region: int) -> int:
    return places[region] if region < len(places) else -2


def _moves(edge: Edge, where: list[int], state: int, agent: Agent, label: str) -> bool:
    """Whether a region moves on an edge: it is elsewhere, or an activity in it has ended."""
    if where[edge.target] != where[state]:
        return True
    plan = agent.plan
    return any(
        name == agent.name and any(plan.transitions[number].source.startswith(f"{label}.") for number in way)
        for name, way in edge.taken
    )


def _waits(explored: Explored, graph: Graph, state: int, place: int, region: int) -> Waiting | None:
    """What an agent waits for in a region, if it should not wait for ever."""
    explored.take_back(graph.pictures[state])
    agent = explored.agents[place]
    label = agent.chart.LEAVES[region][graph.places[state][place][region]]
    plan = agent.plan
    leaf = plan.by_label[label]
    is_over = leaf.type == "END" and leaf.parent == agent.chart.REGIONS[region]
    if is_over or any(item.waits for item in plan.activities if item.name == leaf.activity):
        return None
    found = {other.name: tuple(_needed(explored, other)) for other in explored.agents}
    # What waits behind a part that has ended is the part.
    own = (label, leaf.parent) if leaf.type == "END" else (label,)
    mine = next((item for item, _ in found[agent.name] if item.state in own), None)
    if mine is None or mine.free:
        return None
    raised = {other.name: raised_by(other.plan) for other in explored.agents}
    needs = {
        name: [replace(need, events=need.events - raised[name]) for item, need in own if not item.free]
        for name, own in found.items()
    }
    return None if agent.name in wait_for_input(needs, explored.writers()) else mine


def _needed(explored: Explored, agent: Agent) -> Iterator[tuple[Waiting, Need]]:
    """What an agent waits for, where that matters to what is asked."""
    needed = explored.needed
    for waiting, need in waits_of(agent):
        if needed is None or waiting.state in needed.states[agent.role]:
            yield waiting, need


def stuck_alone(explored: Explored, graph: Graph) -> bool:
    """Whether the only agent that is explored has a wait that it does not end itself, once others say nothing
    more."""
    (agent,) = explored.agents
    back = _back(graph)
    for region, label in enumerate(agent.chart.REGIONS):
        if explored.needed is not None and label not in explored.needed.regions[agent.role]:
            continue
        where = [_leaf(places[0], region) for places in graph.places]

        def ends(edge: Edge, can: Set[int], state: int, where: list[int] = where, label: str = label) -> bool:
            return edge.target in can or _moves(edge, where, state, agent, label)

        can: set[int] = set()
        todo = deque(range(len(where)))
        while todo:
            state = todo.popleft()
            if state not in can and any(
                _surely(edges, 0, partial(ends, can=can, state=state), explored.order.is_exact)
                for edges in _own(graph.edges.get(state, ()))
            ):
                can.add(state)
                todo.extend(back.get(state, ()))
        if any(
            where[state] >= 0 and state not in can and _waits(explored, graph, state, 0, region)
            for state in range(len(where))
        ):
            return True
    return False


def _own(edges: Iterable[Edge]) -> Iterable[list[Edge]]:
    """What comes of each move that an agent makes itself."""
    found: dict[int, list[Edge]] = {}
    for edge in edges:
        if edge.is_own:
            found.setdefault(edge.step.number, []).append(edge)
    return found.values()


def _surely(edges: Sequence[Edge], place: int, is_good: Callable[[Edge], bool], is_exact: bool) -> bool:
    """Whether a move, from its decision `place` on, may turn out well for each decision of others. If what
    decisions follow is not exact, each of them has to."""
    if len(edges) == 1 and place >= len(edges[0].step.way):
        return is_good(edges[0])
    ways: dict[int, list[Edge]] = {}
    for edge in edges:
        ways.setdefault(edge.step.way[place], []).append(edge)
    found = (_surely(some, place + 1, is_good, is_exact) for some in ways.values())
    return all(found) if place in edges[0].of_others or not is_exact else any(found)


def _past(explored: Explored, agent: Agent) -> str | None:
    """The agent with which one has sent past each other."""
    senders = {other.name: _unread(explored, other) for other in explored.agents}
    return next(
        (name for name in senders[agent.name] if agent.name in senders.get(name, ())),
        None,
    )


def _unread(explored: Explored, agent: Agent) -> frozenset[str]:
    """Of whom agent messages wait for an agent, or are on their way to it."""
    mail = {item.sender for waiting in agent.chart.mail.values() for item in waiting}
    coming = {
        sender
        for (sender, receiver), items in explored.ways.ways.items()
        if receiver == agent.name and any(item.kind == "mail" for item in items)
    }
    return frozenset(mail | coming | {item.sender for item in explored.invitations(agent)})


# ---- messages that wait for ever ---------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Untouched:
    """An agent message that nothing ever takes from a state on. `is_due`: it should be taken, as nothing has
    crossed it, no agent has crashed, and no deadline has passed in the two agents. `is_past`: it has crossed
    another one that nothing takes either, and no agent has crashed."""

    letter: Letter
    state: int
    is_due: bool
    is_past: bool

    @property
    def text(self) -> str:
        letter = self.letter
        return f"{letter.receiver} never takes {letter.performative} {letter.message} of {letter.sender}"


def untouched(explored: Explored, graph: Graph) -> Iterator[Untouched]:
    """The agent messages that wait for ever, the nearest first.

    Each message is followed from state to state. One waits for ever if no way leads to a state in which it
    waits no more.
    """
    before: dict[_Place, list[_Place]] = {}
    after: dict[_Place, list[_Place]] = {}
    new: set[_Place] = set()
    crossed: set[_Place] = set()
    goes: list[_Place] = []
    for state, letters in enumerate(graph.letters):
        if state not in graph.edges:
            goes += [(state, place) for place in range(len(letters))]
        for edge in graph.edges.get(state, ()):
            goes += [(state, place) for place in range(len(letters)) if place not in edge.letters]
            for place, former in enumerate(edge.letters):
                now = edge.target, place
                if former == NEW:
                    new.add(now)
                elif former == CROSSED:
                    crossed.add(now)
                else:
                    before.setdefault(now, []).append((state, former))
                    after.setdefault((state, former), []).append(now)
    going = _reached(goes, before)
    new, crossed = _reached(new, after), _reached(crossed, after)
    stays = [
        (state, place)
        for state, letters in enumerate(graph.letters)
        for place in range(len(letters))
        if (state, place) not in going
    ]
    past = {
        (state, graph.letters[state][place].sender, graph.letters[state][place].receiver)
        for state, place in stays
        if (state, place) in crossed
    }
    for state, place in stays:
        letter = graph.letters[state][place]
        explored.take_back(graph.pictures[state])
        has_crashed = bool(explored.crashed)
        pair = letter.receiver, letter.sender
        is_due = (state, place) in new and not has_crashed and explored.late.isdisjoint(pair)
        is_past = (
            (state, place) in crossed
            and not has_crashed
            and ((state, *pair) in past or pair in explored.spurned)
        )
        yield Untouched(letter, state, is_due, is_past)


_Place = tuple[int, int]
"""A state, and the place of a message among those that wait there."""


def _reached(some: Iterable[_Place], ways: Mapping[_Place, Iterable[_Place]]) -> set[_Place]:
    """These, and all to which ways lead from them."""
    found = set(some)
    todo = list(found)
    while todo:
        for item in ways.get(todo.pop(), ()):
            if item not in found:
                found.add(item)
                todo.append(item)
    return found


# ---- what has to come -------------------------------------------------------------------------------


def unmet(graph: Graph, expectation: int) -> tuple[int, tuple[int, ...]] | None:
    """A state from which on something that is awaited may never come, and the states that are gone round.

    Fair: what can happen all the time happens some time.
    """
    pending = {state for state in graph.edges if expectation in graph.awaited[state]}
    if not pending:
        return None  # mostly so, and then no library is imported
    ends = [state for state in pending if not graph.enabled[state]]
    if ends:
        return min(ends), ()
    for circle in sorted(_circles(graph, pending), key=min):
        if _is_fair(graph, circle):
            return min(circle), tuple(sorted(circle))
    return None


def _circles(graph: Graph, states: set[int]) -> Iterator[set[int]]:
    """The strongly connected parts in which one can go round."""
    import networkx

    net = networkx.DiGraph(
        [(state, edge.target) for state in states for edge in graph.edges[state] if edge.target in states]
    )
    for part in networkx.strongly_connected_components(net):
        if len(part) > 1 or any(net.has_edge(state, state) for state in part):
            yield part


def _is_fair(graph: Graph, circle: Iterable[int]) -> bool:
    """Whether a fair run may stay: each move that is always possible there is made there."""
    circle = set(circle)
    always = frozenset.intersection(*(graph.enabled[state] for state in circle))
    made = {edge.kind for state in circle for edge in graph.edges[state] if edge.target in circle}
    return always <= made


def around(graph: Graph, circle: Sequence[int]) -> list[Step]:
    """One way round a circle that a fair run may go for ever, from its first state back to it."""
    if not circle:
        return []
    inside = frozenset(circle)
    wanted = frozenset.intersection(*(graph.enabled[state] for state in circle))
    steps: list[Step] = []
    state = first = min(circle)
    while True:
        edges = _to(graph, inside, state, partial(_is_of, wanted))
        if not edges:
            break
        steps += [edge.step for edge in edges]
        wanted -= {edge.kind for edge in edges}
        state = edges[-1].target
    if state != first or not steps:
        edges = _to(graph, inside, state, lambda edge: edge.target == first)
        steps += [edge.step for edge in edges]
    return steps


def _is_of(kinds: frozenset[Kind], edge: Edge) -> bool:
    return edge.kind in kinds


def _to(graph: Graph, inside: frozenset[int], state: int, is_wanted: Callable[[Edge], bool]) -> list[Edge]:
    """The shortest way inside a circle that ends with a move that is wanted; empty if there is none."""
    ways: dict[int, list[Edge]] = {state: []}
    todo = deque([state])
    while todo:
        here = todo.popleft()
        for edge in graph.edges[here]:
            if edge.target not in inside:
                continue
            way = [*ways[here], edge]
            if is_wanted(edge):
                return way
            if edge.target not in ways:
                ways[edge.target] = way
                todo.append(edge.target)
    return []


__all__ = ["Stuck", "around", "stuck", "stuck_alone", "unmet"]
