"""Flow: finds states that cannot complete or be reached, and cycles without a wait, for any conditions."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from aseme_dsl.amola.expression import (
    NEVER,
    After,
    Age,
    Assign,
    Expired,
    Has,
    Member,
    Outcome,
    Publish,
    ReadMessages,
    RoundValue,
    StartTimer,
    StateValue,
    TransitionExpression,
    Value,
    VariableValue,
    walk,
)
from aseme_dsl.amola.messages import ChannelKind
from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import OriginKind, State, Statechart, StateType, Transition, TransitionKind
from aseme_dsl.compiler.chart.asking import NOTHING_ASKED, Asked, asked_in, waits_for
from aseme_dsl.compiler.formula.formulas import cut
from aseme_dsl.diagnostics import Diagnostic, Edit, Related, closest, surely
from aseme_dsl.diagnostics.problems.control import (
    ChoicesInCircle,
    CycleNeverRests,
    LeftByTimeOnly,
    LoopWithoutPause,
    NeverCompletes,
    NeverHappens,
)
from aseme_dsl.diagnostics.problems.statecharts import StateNotLeft, StateNotReached
from aseme_dsl.diagnostics.problems.use import TimerNotStarted
from aseme_dsl.proofs.unknowns import identity
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

_POINTS = (StateType.START, StateType.CONDITION)


@dataclass(frozen=True, slots=True)
class _Edge:
    """A transition between two children of one OR state; its own ends may lie deeper inside them."""

    source: str
    target: str
    transition: Transition


Contradict = Callable[[Sequence[Value], Sequence[Value]], bool]
"""Whether it can surely not be that the first conditions hold at one moment and the second do not."""


def check_flow(chart: Statechart, contradict: Contradict = lambda _, __: False) -> tuple[Diagnostic, ...]:
    """Waits for what never completes (W402) and cycles that never rest (W403, E412).

    A cycle whose conditions `contradict` each other comes to rest. States are called by their names, not by
    their labels: what a formula does that is expanded in several places is said once.
    """
    edges = _edges(chart)
    found = list(_endless_waits(chart, edges))
    for circle, at_once in _cycles(_Search(chart, edges, contradict)):
        found.append(_restless(chart, circle, at_once))
    return tuple(found)


def check_pace(chart: Statechart, quick: Mapping[str, Activity]) -> Iterator[Diagnostic]:
    """W439 for a loop all of whose activities are `quick`: they return at once, and nothing else waits.

    What the activities write, and how they end, may be what ends the loop.
    """
    labels = {node.label: node for node in chart.states if node.activity in quick}
    if not labels:
        return
    written: set[object] = set()
    for node in labels.values():
        written.update((*quick[node.activity or ""].writes, *quick[node.activity or ""].writes_variables))
    edges = {
        scope: [edge for edge in found if not _may_change(edge.transition.expression, written)]
        for scope, found in _edges(chart).items()
    }
    told: set[Span] = set()
    for circle, _ in _cycles(_Search(chart, edges, _plainly, labels)):
        sources = [edge.source for edge in circle]
        inside = [
            node
            for label, node in labels.items()
            if any(label == source or label.startswith(f"{source}.") for source in sources)
        ]
        last = circle[-1].transition
        if inside and last.span not in told:
            told.add(last.span)
            names = tuple(dict.fromkeys(node.activity or "" for node in inside))
            term = cut(chart.node(circle[-1].target).name)
            related = tuple(
                Related(node.span, f"`{node.activity}` returns at once")
                for node in inside[:5]
                if len(inside) > 1
            )
            yield Diagnostic(LoopWithoutPause(names, term), last.span, related)


def _plainly(holding: Sequence[Value], failing: Sequence[Value]) -> bool:
    """What contradicts itself without a proof: a condition and its own `else`."""
    return bool({identity(item) for item in holding} & {identity(item) for item in failing})


def _may_change(expression: TransitionExpression, written: Container[object]) -> bool:
    """Whether a condition reads what the activities of a loop change."""
    if expression.condition is None:
        return False
    for value in walk(expression.condition):
        match value:
            case Member(channel=channel) if channel in written:
                return True
            case VariableValue(name=name) if name.partition("@")[0] in written or "@" in name:
                return True
            case Outcome() | StateValue() | RoundValue() | Has():
                return True
    return False


def check_reach(chart: Statechart) -> Iterator[Diagnostic]:
    """States that nothing leads to (W600) and states that nothing leads out of (W601)."""
    edges = _edges(chart)
    entered = _entered(chart)
    left = {transition.source for transition in chart.transitions if transition.changes_state}
    for node in chart.states:
        if node.type is not StateType.OR:
            continue
        start = chart.start_of(node.label)
        if start is None:
            continue
        seen = {start.label, *entered.get(node.label, ())}
        waiting = list(seen)
        following: dict[str, list[str]] = {}
        for edge in edges.get(node.label, ()):
            following.setdefault(edge.source, []).append(edge.target)
        while waiting:
            for label in following.get(waiting.pop(), ()):
                if label not in seen:
                    seen.add(label)
                    waiting.append(label)
        for child in chart.children(node.label):
            if child.label not in seen:
                yield Diagnostic(StateNotReached(child.label, _own_name(child)), child.span)
            elif child.type is not StateType.END and not _is_left(chart, child, left):
                yield Diagnostic(StateNotLeft(child.label, _own_name(child)), child.span)


def check_timers(chart: Statechart) -> Iterator[Diagnostic]:
    """W501 for a timer that a region asks for and does not start: it belongs to the region that starts it."""
    started: dict[str, set[str]] = {}
    for transition in chart.transitions:
        for action in transition.expression.actions:
            if isinstance(action, StartTimer):
                started.setdefault(action.timer, set()).add(chart.acts_in(transition))
    found: dict[tuple[str, str], Diagnostic] = {}
    edits: tuple[Edit, ...]
    for place, value in chart.values():
        if isinstance(value, Expired):
            region = chart.region_of(place)
            if region not in started.get(value.timer, ()):
                first = found.get((region, value.timer))
                if first is not None:
                    also = (*first.related, Related(value.span, "also here"))
                    edits = (*first.edits, *_renamed(value, first.edits[0].text)) if first.edits else ()
                    found[region, value.timer] = replace(first, related=also, edits=edits)
                    continue
                elsewhere = value.timer in started
                near = None if elsewhere else closest(value.timer, started)
                edits = ()
                if near is not None and near == surely(value.timer, started):
                    edits = _renamed(value, near)
                problem = TimerNotStarted(value.timer, elsewhere, near)
                found[region, value.timer] = Diagnostic(problem, value.span, edits=edits)
    yield from found.values()


def _renamed(value: Expired, name: str) -> tuple[Edit, ...]:
    """The timer of `expired(timer)` by another name, where it is written so."""
    written = re.search(rf"\b{value.timer}\b", value.span.text)
    if written is None:
        return ()
    start = value.span.start + written.start()
    return (Edit(Span(value.span.source, start, start + len(value.timer)), name),)


def check_completion(chart: Statechart) -> Iterator[Diagnostic]:
    """N724 for a state that may complete and is then left by time only.

    A line with an event or `when` takes the place of the completion transition. A message, an event, an
    `error` or a `when` is plainly meant to be waited for; time alone may be meant besides completion.
    """
    completes = _completions(chart, _edges(chart))[0]
    for node in chart.states:
        if node.type not in (StateType.BASIC, StateType.OR) or not completes[node.label]:
            continue
        ways = chart.outgoing_edges(node.label)
        if node.origin.kind is OriginKind.STATECHART:
            continue  # there is no template whose completion transition was replaced
        if not ways or not all(_is_limit(item.expression) for item in ways):
            continue
        name, line = cut(node.name), ways[0].span.text.partition(":")[0].strip()
        problem = LeftByTimeOnly(name, line if "\n" not in line and len(line) < 60 else None)
        yield Diagnostic(problem, ways[0].span, (Related(node.span, f"`{name}`"),))


def _is_limit(expression: TransitionExpression) -> bool:
    return bool(expression.events) and all(isinstance(event, After) for event in expression.events)


def _is_left(chart: Statechart, node: State, left: set[str]) -> bool:
    """Whether the state, one around it or (of a composite) one in it is the source of a transition."""
    if node.type in _POINTS:
        return node.label in left
    inside = node.label + "."
    return (
        node.label in left
        or any(outer.label in left for outer in chart.ancestors(node.label))
        or (node.type in (StateType.OR, StateType.AND) and any(label.startswith(inside) for label in left))
    )


def _own_name(node: State) -> str | None:
    """The name of a state as a message quotes it; None where it is only its label."""
    return None if node.name == node.label else cut(node.name)


def _edges(chart: Statechart) -> dict[str, list[_Edge]]:
    """The transitions of each OR state, between its children; what stays in a state is none."""
    found: dict[str, list[_Edge]] = {}
    nodes = chart.by_label
    for transition in chart.transitions:
        if not transition.changes_state:
            continue
        source, target = nodes[transition.source], nodes[transition.target]
        if source.parent is not None and source.parent == target.parent:
            found.setdefault(source.parent, []).append(_Edge(source.label, target.label, transition))
        else:
            scope = chart.scope_of(transition)
            ends = (_child(scope, source.label), _child(scope, target.label))
            found.setdefault(scope, []).append(_Edge(*ends, transition))
    return found


def _entered(chart: Statechart) -> dict[str, list[str]]:
    """The children of each OR state that a transition from outside enters directly, past its START."""
    found: dict[str, list[str]] = {}
    for transition in chart.transitions:
        if not transition.changes_state:
            continue
        inside = chart.scope_of(transition) + "."
        for target in transition.targets:
            child = chart.node(target)
            while child.parent is not None and child.parent.startswith(inside):
                found.setdefault(child.parent, []).append(child.label)
                child = chart.node(child.parent)
    return found


def _child(scope: str, label: str) -> str:
    """The child of `scope` that is or holds `label`; the scope itself for itself."""
    if not label.startswith(scope + "."):
        return label
    return scope + "." + label[len(scope) + 1 :].split(".", 1)[0]


# ---- waiting for ever ----------------------------------------------------------------------------


def _needs_completion(expression: TransitionExpression) -> bool:
    return not expression.events and not expression.when


def _endless_waits(chart: Statechart, edges: dict[str, list[_Edge]]) -> Iterator[Diagnostic]:
    """W402: a transition that waits for the completion of a state that can never complete.

    A transition to an END that has no line is not reported: endless processes are meant to be endless.
    What follows from a reported wait is not reported again.
    """
    completes, in_vain = _completions(chart, edges)
    for transition, target in in_vain:
        yield _endless_wait(chart, transition, target)
    for transition in chart.transitions:
        is_on = transition.kind is TransitionKind.ON
        if is_on and _needs_completion(transition.expression) and not completes[transition.source]:
            yield _endless_wait(chart, transition, chart.node(transition.source))


def _completions(
    chart: Statechart, edges: dict[str, list[_Edge]]
) -> tuple[dict[str, bool], list[tuple[Transition, State]]]:
    """Which states may complete; and the transitions, with their targets, that wait in vain for that."""
    in_vain: list[tuple[Transition, State]] = []
    completes: dict[str, bool] = {}
    entered = _entered(chart)
    for node in reversed(chart.states):
        if node.type is StateType.AND:
            completes[node.label] = all(completes[child.label] for child in chart.children(node.label))
        elif node.type is not StateType.OR:
            completes[node.label] = not node.waits
        else:
            start = chart.start_of(node.label)
            if start is None:
                completes[node.label] = True  # reported by its structure
                continue
            following: dict[str, list[_Edge]] = {}
            for edge in edges.get(node.label, ()):
                following.setdefault(edge.source, []).append(edge)
            seen = {start.label, *entered.get(node.label, ())}
            waiting = list(seen)
            ended = any(chart.by_label[label].type is StateType.END for label in seen)
            while waiting:
                for edge in following.get(waiting.pop(), ()):
                    target = chart.by_label[edge.target]
                    transition = edge.transition
                    cuts_short = transition.first  # E420 says what is wrong with it
                    waits = _needs_completion(transition.expression) and not cuts_short
                    if waits and not completes[transition.source]:
                        if target.type is StateType.END and transition.expression.span is None:
                            continue
                        in_vain.append((transition, target))
                    if target.label not in seen:
                        seen.add(target.label)
                        waiting.append(target.label)
                        ended = ended or target.type is StateType.END
            completes[node.label] = ended
    return completes, in_vain


def _endless_wait(chart: Statechart, transition: Transition, target: State) -> Diagnostic:
    source = chart.by_label[transition.source]
    name = cut(source.name)
    what: NeverHappens = "entry"
    if not transition.changes_state:
        what = "action"
    elif transition.source == transition.target:
        what = "repetition"
    elif target.type is StateType.END:
        what = "end"
    related = (Related(source.span, f"`{name}`"),) if source.span != transition.span else ()
    is_before_choice = source.waits and what == "entry" and target.type is StateType.OR
    problem = NeverCompletes(name, what, cut(target.name), is_before_choice)
    return Diagnostic(problem, transition.span, related)


# ---- cycles --------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Through:
    """The transitions by which a state completes without an activity, an event or time.

    `certain` are those of its only way; with several ways there are none. `example` are those of one way.
    """

    certain: tuple[Transition, ...] = ()
    example: tuple[Transition, ...] = ()


AtOnce = dict[str, _Through]
"""The states that complete without an activity, an event or time."""


@dataclass(frozen=True, slots=True)
class _Search:
    """What a search for cycles knows: `quick_states` complete at once, and `asked` has no answer yet."""

    chart: Statechart
    edges: Mapping[str, list[_Edge]]
    contradict: Contradict
    quick_states: Collection[str] = ()
    asked: Asked = NOTHING_ASKED


def _cycles(search: _Search) -> Iterator[tuple[list[_Edge], AtOnce]]:
    """The cycles that repeat without a wait, each with the states that complete at once.

    A cycle that sends or starts a timer, and then needs the answer or the end of the timer, waits for it.
    """
    chart, at_once = search.chart, _at_once(search)
    for node in reversed(chart.states):
        if node.type is not StateType.OR:
            continue
        for circle in _circles(_quick(search, node, at_once)):
            asked = asked_in(chart, [edge.transition for edge in circle], [edge.source for edge in circle])
            if not asked:
                restless = _restless_walk(search, node, circle, at_once)
                if restless is not None:
                    yield restless, at_once
                continue
            waiting = replace(search, asked=asked)
            sources = {edge.source for edge in circle}
            still = _at_once(waiting)
            for other in _circles(_quick(waiting, node, still)):
                if sources & {edge.source for edge in other}:
                    restless = _restless_walk(waiting, node, other, still)
                    if restless is not None:
                        yield restless, still
                        break


def _restless_walk(search: _Search, node: State, circle: list[_Edge], at_once: AtOnce) -> list[_Edge] | None:
    """A circle, or another walk round its states, whose conditions do not contradict each other."""
    if _is_bare(search.chart, circle) or not _comes_to_rest(search, _all_of(circle, at_once)):
        return circle
    quick = _quick(search, node, at_once)
    others = (_walks(search, quick, edge.source, edge.source, at_once) for edge in circle)
    other = next((walks[0] for walks in others if walks), None)
    return None if other is None else other or circle


def _at_once(search: _Search) -> AtOnce:
    """The OR and AND states that complete at once, inner ones first."""
    chart = search.chart
    found: AtOnce = {label: _Through() for label in search.quick_states}
    for node in reversed(chart.states):
        if node.type is StateType.AND:
            inside = [found.get(child.label) for child in chart.children(node.label)]
            if None not in inside:
                certain = tuple(item for way in inside if way is not None for item in way.certain)
                example = tuple(item for way in inside if way is not None for item in way.example)
                found[node.label] = _Through(certain, example)
        if node.type is not StateType.OR:
            continue
        start, end = chart.start_of(node.label), chart.end_of(node.label)
        if start is not None and end is not None:
            ways = _walks(search, _quick(search, node, found), start.label, end.label, found)
            if ways:
                example = _all_of(ways[0], found, certain=False)
                found[node.label] = _Through(_all_of(ways[0], found) if len(ways) == 1 else (), example)
    return found


def _quick(search: _Search, node: State, at_once: AtOnce) -> dict[str, list[_Edge]]:
    """Of each child of an OR state: the transitions that may be taken without a wait."""
    found: dict[str, list[_Edge]] = {}
    for edge in search.edges.get(node.label, ()):
        if _is_quick(search, edge, at_once):
            found.setdefault(edge.source, []).append(edge)
    return found


def _is_quick(search: _Search, edge: _Edge, at_once: AtOnce) -> bool:
    """Whether a transition may be taken again and again while nothing arrives and no time passes."""
    expression = edge.transition.expression
    never = expression is NEVER or edge.transition.reactive
    if expression.events or expression.every or never or _rests(expression):
        return False
    if waits_for(search.chart, edge.transition, search.asked):
        return False
    source = search.chart.by_label[edge.transition.source]
    return expression.when or source.type in _POINTS or source.label in at_once


def _rests(expression: TransitionExpression) -> bool:
    """Whether a condition reads what a step uses up: a signal, time, or what its own actions change."""
    if expression.condition is None:
        return False
    changed = {
        action.target.name
        for action in expression.actions
        if isinstance(action, Assign) and isinstance(action.target, VariableValue)
    }
    started = {action.timer for action in expression.actions if isinstance(action, StartTimer)}
    for value in walk(expression.condition):
        match value:
            case Member(channel=channel) if channel.comm is ChannelKind.SIGNAL:
                return True
            case Age():
                return True
            case Expired(timer=timer) if timer in started:
                return True
            case VariableValue(name=name) if name in changed:
                return True
    return False


def _circles(following: dict[str, list[_Edge]]) -> Iterator[list[_Edge]]:
    """Circles of edges, no state being in two of them."""
    done: set[str] = set()
    for root in list(following):
        if root in done:
            continue
        path: list[_Edge] = []
        on_path = {root}
        stack: list[tuple[str, Iterator[_Edge]]] = [(root, iter(following[root]))]
        while stack:
            label, remaining = stack[-1]
            edge = next(remaining, None)
            if edge is None:
                stack.pop()
                on_path.discard(label)
                done.add(label)
                if path:
                    path.pop()
            elif edge.target in on_path:
                labels = [item.source for item in path] + [label]
                circle = [*path[labels.index(edge.target) :], edge]
                yield circle
                done.update(item.source for item in circle)
            elif edge.target not in done:
                path.append(edge)
                on_path.add(edge.target)
                stack.append((edge.target, iter(following.get(edge.target, ()))))


_MOST_WALKS = 1000
"""How many beginnings of walks through one composite are looked at."""


def _walks(
    search: _Search, following: dict[str, list[_Edge]], start: str, end: str, at_once: AtOnce
) -> list[list[_Edge]]:
    """Ways from one state to another (round, to itself) whose conditions may hold together: at most two.

    An empty one stands for what was too much to look at.
    """
    reached: set[str] = set()
    waiting = [start]
    while waiting:
        for edge in following.get(waiting.pop(), ()):
            if edge.target not in reached:
                reached.add(edge.target)
                waiting.append(edge.target)
    if end not in reached:
        return []
    found: list[list[_Edge]] = []
    stack = [[edge] for edge in reversed(following[start])]
    for _ in range(_MOST_WALKS):
        if not stack or len(found) == 2:
            return found
        path = stack.pop()
        target = path[-1].target
        if target == end:
            if not _comes_to_rest(search, _all_of(path, at_once)):
                found.append(path)
        elif target not in [edge.source for edge in path]:
            stack += [[*path, edge] for edge in reversed(following.get(target, []))]
    return found or [[]]


def _all_of(walk_of: Sequence[_Edge], at_once: AtOnce, *, certain: bool = True) -> tuple[Transition, ...]:
    """The transitions of a walk, with those inside the states that complete on the way.

    With `certain`, only those that it surely takes.
    """
    found: list[Transition] = []
    for edge in walk_of:
        transition = edge.transition
        if _needs_completion(transition.expression):
            through = at_once.get(transition.source, _Through())
            found += through.certain if certain else through.example
        found.append(transition)
    return tuple(found)


def _comes_to_rest(search: _Search, transitions: Sequence[Transition]) -> bool:
    """Whether the conditions contradict each other, and none of the actions changes what they read."""
    changed: set[object] = set()
    read: set[object] = set()
    holding: list[Value] = []
    failing: list[Value] = []
    for transition in transitions:
        expression = transition.expression
        for action in expression.actions:
            match action:
                case Assign(target=VariableValue(name=name)):
                    changed.add(name)
                case Publish(channel=channel):
                    changed.add(channel)
                case StartTimer(timer=timer):
                    changed.add((timer,))
                case ReadMessages():
                    return False
        holding += [expression.condition] if expression.condition is not None else []
        failing += _before_else(search.chart, transition)
    for condition in (*holding, *failing):
        for value in walk(condition):
            match value:
                case Member(channel=channel):
                    read.add(channel)
                case VariableValue(name=name):
                    read.add(name)
                case Expired(timer=timer):
                    read.add((timer,))
    return not changed & read and search.contradict(holding, failing)


def _before_else(chart: Statechart, transition: Transition) -> Iterator[Value]:
    """What does not hold where an `else` is taken; a transition to another choice may be shut further on."""
    if not transition.expression.otherwise:
        return
    for other in chart.outgoing_edges(transition.source):
        expression = other.expression
        if (
            expression.condition is not None
            and not expression.events
            and not expression.when
            and chart.node(other.target).type is not StateType.CONDITION
        ):
            yield expression.condition


def _is_bare(chart: Statechart, circle: Sequence[_Edge]) -> bool:
    """Whether a cycle consists of CONDITION states only (E412)."""
    return all(chart.by_label[edge.source].type is StateType.CONDITION for edge in circle)


def _restless(chart: Statechart, circle: Sequence[_Edge], at_once: AtOnce) -> Diagnostic:
    nodes = [chart.by_label[edge.source] for edge in circle]
    last = circle[-1].transition
    related = tuple(Related(edge.transition.span, "by this") for edge in circle[:-1])
    if all(node.type is StateType.CONDITION for node in nodes):
        labels = (*(node.label for node in nodes), nodes[0].label)
        return Diagnostic(ChoicesInCircle(labels), last.span, related)
    round_trip = {edge.transition for edge in circle}
    passed = _all_of(circle, at_once, certain=False)
    inside = [item for item in passed if item not in round_trip and item.expression.when]
    related += tuple(Related(item.span, "this `when` does not wait for completion") for item in inside)
    names = tuple(cut(name) for name in _names([*nodes, nodes[0]]))
    return Diagnostic(CycleNeverRests(names), last.span, related)


def _names(nodes: Iterable[State]) -> Iterator[str]:
    return (
        node.name if node.type in (StateType.OR, StateType.AND, StateType.BASIC) else "·" for node in nodes
    )


__all__ = ["check_completion", "check_flow", "check_pace", "check_reach", "check_timers"]
