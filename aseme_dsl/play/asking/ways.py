"""Ways: which transitions lead from where a chart is to what is asked for, with the fewest conditions."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import replace
from heapq import heappop, heappush

from aseme_dsl.play.asking.changes import Ending
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.chart import INACTIVE, Chart
from aseme_dsl.runtime.chart.following import Shape
from aseme_dsl.runtime.chart.plan import Plan, Transition, is_in

Node = tuple[str, str | int]
"""("in", label): the state is active. ("done", label): and complete. ("took", number): it was taken.
("kept", label): it is active again when the state around it is resumed."""

_STEP = 1
"""What a transition costs."""
_FACT = 1000
"""What costs something that has to be otherwise."""
_MAYBE = 400
"""What costs something that may be so."""


@dataclass(frozen=True, slots=True)
class Goal:
    """What is asked for: that one of these states is entered, or one of these transitions taken.

    `by_code`: it is a message, and the activities of the states, or `modules`, decide whether they send it.
    """

    states: frozenset[str] = frozenset()
    transitions: frozenset[int] = frozenset()
    by_code: bool = False
    modules: tuple[str, ...] = ()
    channel: str = ""
    """What is published, if it is asked for a channel."""

    @property
    def is_for_modules(self) -> bool:
        """Whether only modules do it, in any state."""
        return bool(self.modules) and not self.states and not self.transitions

    @property
    def nodes(self) -> Iterator[Node]:
        yield from (("in", label) for label in self.states)
        yield from (("took", number) for number in self.transitions)


@dataclass(frozen=True, slots=True)
class Stage:
    """What one step does on the way, for which activities end first.

    Each transition has the branches of the choices behind it.
    """

    ways: tuple[tuple[int, ...], ...]
    endings: tuple[Ending, ...] = ()


@dataclass(frozen=True, slots=True)
class _Rule:
    needs: tuple[Node, ...]
    gives: tuple[Node, ...]
    cost: int
    what: int | Ending | None
    """The transition that is taken, or the activity that ends."""


class Map:
    """The ways through the statechart of a role."""

    def __init__(self, shape: Shape, chart: type[Chart]) -> None:
        self.plan = shape.plan
        self._shape = shape
        self._endings = dict(_endings(shape.plan, chart.WAITING))
        self._rules = tuple(self._all_rules())
        self._by_need: dict[Node, list[int]] = {}
        for index, rule in enumerate(self._rules):
            for need in set(rule.needs):
                self._by_need.setdefault(need, []).append(index)

    def _all_rules(self) -> Iterator[_Rule]:
        plan = self.plan
        for state in plan.states:
            done: Node = ("done", state.label)
            active: Node = ("in", state.label)
            match state.type:
                case "BASIC" if state.label in self._endings:
                    yield _Rule((active,), (done,), _FACT, self._endings[state.label])
                case "START" | "CONDITION":
                    yield _Rule((active,), (done,), 0, None)
                case "OR":
                    for child in plan.children(state.label):
                        if child.type == "END":
                            yield _Rule((("in", child.label),), (done,), 0, None)
                case "AND":
                    needs: tuple[Node, ...] = tuple(
                        ("done", child.label) for child in plan.children(state.label)
                    )
                    yield _Rule(needs, (done,), 0, None)
        for number, item in enumerate(plan.transitions):
            if item.kind == "external":
                yield from self._taking(number, item)
            elif item.kind == "on":
                yield _Rule((_need(item),), (("took", number),), _cost(item), number)
            else:
                yield from self._leaving(number, item)

    def _leaving(self, number: int, item: Transition) -> Iterator[_Rule]:
        """What is done when a state is left: by each transition that leaves it."""
        for other, way in enumerate(self.plan.transitions):
            scope = self._shape.way((other,))[0]
            if way.kind == "external" and scope and item.source.startswith(f"{scope}."):
                needs = (_need(way), ("in", item.source))
                yield _Rule(needs, (("took", number),), _cost(way), other)

    def _taking(self, number: int, item: Transition) -> Iterator[_Rule]:
        need, cost = _need(item), _cost(item)
        entered = self._shape.entered(self._shape.way((number,))[2])
        gives: tuple[Node, ...] = (("took", number), *(("in", label) for label in entered))
        yield _Rule((need,), gives, cost, number)
        if item.resume:
            for state in self.plan.states:
                if state.label.startswith(f"{item.target}."):
                    kept: Node = ("kept", state.label)
                    yield _Rule((("took", number), kept), (("in", state.label),), 0, None)

    def stages(
        self, known: Iterable[Node], goal: Goal, banned: Collection[int], ready: Collection[int]
    ) -> list[Stage]:
        """The cheapest way to a goal from what is known; empty if there is none, or it is there.

        None of the `banned` transitions is on it; what those wait for that are `ready` has happened.
        """
        best: dict[Node, int] = {}
        found_by: dict[Node, int | None] = {}
        waiting = [len(set(rule.needs)) for rule in self._rules]
        heap: list[tuple[int, int, Node, int | None]] = []
        for count, node in enumerate(known):
            heappush(heap, (0, count, node, None))
        wanted = set(goal.nodes)
        reached: Node | None = None
        count = len(heap)
        while heap:
            cost, _, node, rule_number = heappop(heap)
            if node in best:
                continue
            best[node], found_by[node] = cost, rule_number
            if node in wanted:
                reached = node
                break
            for index in self._by_need.get(node, ()):
                waiting[index] -= 1
                rule = self._rules[index]
                if waiting[index] or (isinstance(rule.what, int) and rule.what in banned):
                    continue
                total = rule.cost + sum(best[need] for need in set(rule.needs))
                total -= _FACT * (isinstance(rule.what, int) and rule.what in ready)
                for given in rule.gives:
                    count += 1
                    heappush(heap, (total, count, given, index))
        return [] if reached is None else self._staged(self._ordered(reached, found_by))

    def into(self, goal: Goal, active: Collection[str]) -> Iterator[Stage]:
        """The ways of one stage that lead to a goal from a state that is active."""
        plan = self.plan
        for number, item in enumerate(plan.transitions):
            if item.kind != "external":
                continue
            if leads(self._shape, goal, (number,)):
                yield from self._from_active((number,), active)

    def _from_active(self, way: tuple[int, ...], active: Collection[str]) -> Iterator[Stage]:
        source = self.plan.transitions[way[0]].source
        if self.plan.by_label[source].type == "CONDITION":
            for number, item in enumerate(self.plan.transitions):
                if item.kind == "external" and item.target == source and number not in way:
                    yield from self._from_active((number, *way), active)
        elif source in active:
            ending = self._endings.get(source)
            is_for_end = ending is not None and not _at_any_time(self.plan.transitions[way[0]])
            yield Stage((way,), (ending,) if ending is not None and is_for_end else ())

    def _ordered(self, reached: Node, found_by: dict[Node, int | None]) -> list[int | Ending]:
        """What happens, in order, until a node is reached."""
        order: dict[int, None] = {}
        stack: list[tuple[Node, bool]] = [(reached, False)]
        while stack:
            node, is_ready = stack.pop()
            index = found_by[node]
            if index is None or index in order:
                continue
            if is_ready:
                order[index] = None
            else:
                stack.append((node, True))
                stack += ((need, False) for need in reversed(self._rules[index].needs))
        return [what for index in order if (what := self._rules[index].what) is not None]

    def _staged(self, order: list[int | Ending]) -> list[Stage]:
        stages: list[Stage] = []
        endings: list[Ending] = []
        types = self.plan.by_label
        for what in order:
            if isinstance(what, Ending):
                endings.append(what)
                continue
            item = self.plan.transitions[what]
            if not stages or endings:
                stages.append(Stage(((what,),), tuple(endings)))
                endings = []
                continue
            last = stages[-1]
            before = self.plan.transitions[last.ways[-1][-1]].target
            if before == item.source and types[before].type == "CONDITION":
                stages[-1] = replace(last, ways=(*last.ways[:-1], (*last.ways[-1], what)))
            elif item.events or item.every is not None:
                stages.append(Stage(((what,),)))
            else:
                stages[-1] = replace(last, ways=(*last.ways, (what,)))
        return stages


def leads(shape: Shape, goal: Goal, way: tuple[int, ...]) -> bool:
    """Whether a transition is one that is asked for, or enters such a state; resuming one does not count."""
    path = shape.way(way)[2]
    enters = bool(path) and not goal.states.isdisjoint(shape.entered(path))
    return enters or not goal.transitions.isdisjoint(way)


def narrowed(shape: Shape, goal: Goal, way: tuple[int, ...]) -> Goal:
    """What a transition does of what is asked for; all of it, if it only resumes something."""
    entered = frozenset(shape.entered(shape.way(way)[2])) if shape.way(way)[2] else frozenset()
    states, numbers = goal.states & entered, goal.transitions & frozenset(way)
    return replace(goal, states=states, transitions=numbers) if states or numbers else goal


def may_lead(shape: Shape, goal: Goal, taken: Iterable[tuple[int, ...]]) -> bool:
    """Whether transitions that a step takes may lead to a goal."""
    transitions = shape.plan.transitions
    return any(leads(shape, goal, way) or transitions[way[-1]].resume for way in taken)


def leading(shape: Shape, goal: Goal) -> Iterator[int]:
    """The transitions, one of which is in each step that may lead to a goal."""
    for number, item in enumerate(shape.plan.transitions):
        is_inside = any(is_in(item.target, label) for label in goal.states)
        if is_inside or item.resume or leads(shape, goal, (number,)):
            yield number


def _endings(plan: Plan, waiting: Collection[str]) -> Iterator[tuple[str, Ending]]:
    """How the activities of states end, by label: with the first of their outcomes."""
    outcomes = {info.name: info.ends for info in plan.activities}
    for state in plan.states:
        if state.type == "BASIC" and state.label not in waiting:
            first = next(iter(outcomes.get(state.activity or "", ())), None)
            yield state.label, Ending(state.label, first)


def _need(item: Transition) -> Node:
    return ("in", item.source) if _at_any_time(item) else ("done", item.source)


def _cost(item: Transition) -> int:
    facts = bool(item.events) + (item.condition is not None)
    return _STEP + _FACT * facts + _MAYBE * (item.otherwise or item.weight is not None)


def _at_any_time(item: Transition) -> bool:
    """Whether it can be taken before its source is complete."""
    return bool(item.events) or item.when


def known_of(plan: Plan, chart: Chart) -> Iterator[Node]:
    """What a chart has reached: its active states, which of them are complete, and what may be resumed."""
    leaves = chart.configuration() if chart.started else ()
    for label in dict.fromkeys(around for leaf in leaves for around in _around(leaf)):
        yield "in", label
    for leaf in leaves:
        if plan.by_label[leaf].type == "BASIC":
            slot, _, number = chart.RUNNING[leaf]
            if getattr(chart, slot) == number + 1:
                yield "done", leaf
    for place in chart.KEPT.values():
        for region, number in (getattr(chart, place) or {}).items():
            if number != INACTIVE:
                yield from (("kept", label) for label in _around(chart.LEAVES[region][number]))


def _around(label: str) -> Iterator[str]:
    parts = label.split(".")
    return (".".join(parts[:end]) for end in range(1, len(parts) + 1))


__all__ = ["Goal", "Map", "Stage", "known_of", "leading", "leads", "may_lead", "narrowed"]
