"""The communication automaton of a participant: what it sends and receives, in which order.

Two participants with equal automata are the same for all others: activities, conditions, time and the
nesting of states do not count. The participant's statechart is explored as configurations of leaves, and
steps without a message are silent. The result is deterministic and minimal: equal behaviour is equal data.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cached_property

from aseme_dsl.amola.aip import Participant
from aseme_dsl.amola.expression import Received, Send, TransitionExpression
from aseme_dsl.amola.statechart import State, Statechart, StateType, Transition
from aseme_dsl.codegen.moves import moves_of, subchart_of
from aseme_dsl.records import dataclass

LARGEST = 3000
"""So many configurations, and states of the automaton, are explored at the most."""

Letter = tuple[str, str, str, str]
"""A message that a participant sends or receives: sign, performative, message and the other participant.

The sign is `!` (sends) or `?` (receives); `!+` if an activity may send it any number of times. The other
participant is "" for an activity, and for an agent that a value names.
"""
Configuration = frozenset[str]
"""The active leaves; an OR without active leaves inside does not occur."""


@dataclass(frozen=True, slots=True)
class Automaton:
    """Deterministic and minimal. State 0 is the first; `ways` has for each state what leads where."""

    ways: tuple[tuple[tuple[Letter, int], ...], ...]
    ends: frozenset[int]
    """The states in which the participant's part may be completed."""


class TooManyStates(Exception):
    """The automaton is too large to be made."""


def automaton_of(eac: Statechart, participant: Participant) -> Automaton:
    """The automaton of a participant of a protocol.

    Raises:
        TooManyStates: it would have more than `LARGEST`.
    """
    subchart = subchart_of(eac, participant.name)
    if subchart is None:
        return Automaton(((),), frozenset({0}))
    return _minimal(_deterministic(_Explorer(eac, subchart.label, participant)))


# ---- configurations ------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Explorer:
    """The steps of a participant's subchart."""

    eac: Statechart
    subchart: str
    participant: Participant

    @cached_property
    def first(self) -> Configuration:
        return self._entered(self.subchart)

    @cached_property
    def _sent(self) -> Mapping[str, tuple[Letter, ...]]:
        """What activities send, by the label of their state."""
        found: dict[str, tuple[Letter, ...]] = {}
        for move in moves_of(self.eac, self.participant):
            letter = ("!+" if move.repeatedly else "!", move.performative, move.message, "")
            for state in move.states:
                label = self.subchart + state
                found[label] = (*found.get(label, ()), letter)
        return found

    @cached_property
    def _received(self) -> tuple[Letter, ...]:
        """What only activities take, whenever one is active."""
        by_lines = {
            (event.performative, event.message)
            for item in self.eac.transitions
            if self.eac.branch_of(item.source) == self.subchart
            for event in item.expression.events
            if isinstance(event, Received)
        }
        kinds = [(item.performative, item.message) for item in self.participant.receives]
        return tuple(("?", *kind, "") for kind in kinds if kind not in by_lines)

    def is_end(self, configuration: Configuration) -> bool:
        return self._is_complete(self.subchart, configuration)

    def steps(self, configuration: Configuration) -> Iterable[tuple[tuple[Letter, ...], Configuration]]:
        """What can come next: what is received and sent on the way (nothing in a silent step), and where."""
        for leaf in sorted(configuration):
            if self.eac.node(leaf).type is StateType.BASIC:
                for letter in (*self._received, *self._sent.get(leaf, ())):
                    yield (letter,), configuration
        for label in self._active(configuration):
            if label == self.subchart:
                continue
            for item in self.eac.outgoing(label):
                yield from self._step(item, configuration)

    def _step(
        self, item: Transition, configuration: Configuration
    ) -> Iterable[tuple[tuple[Letter, ...], Configuration]]:
        expression = item.expression
        waits = not expression.events and not expression.when
        if waits and not self._is_complete(item.source, configuration):
            return
        target, sent = configuration, _sends(expression)
        if item.changes_state:
            scope = self.eac.scope_of(item)
            left = {leaf for leaf in configuration if leaf.startswith(f"{scope}.")}
            exited = sorted(
                (state for state in self._active(configuration) if state.startswith(f"{scope}.")),
                key=lambda state: -state.count("."),
            )
            sent = (
                *(
                    letter
                    for state in exited
                    for way in self.eac.exits_of(state)
                    for letter in _sends(way.expression)
                ),
                *sent,
            )
            target = (configuration - left).union(*map(self._entered, self.eac.entries_of(item)))
        received = [event for event in expression.events if isinstance(event, Received)]
        for event in received:
            yield (("?", event.performative, event.message, event.participant), *sent), target
        if waits or expression.when or len(received) < len(expression.events):
            yield sent, target

    def _active(self, configuration: Configuration) -> list[str]:
        """The active states inside the subchart, with it."""
        found: dict[str, None] = {}
        for leaf in sorted(configuration):
            found[leaf] = None
            for around in self.eac.ancestors(leaf):
                if not around.label.startswith(self.subchart):
                    break
                found[around.label] = None
        return list(found)

    def _entered(self, label: str) -> Configuration:
        leaves: set[str] = set()
        todo = [label]
        while todo:
            node = self.eac.node(todo.pop())
            if node.type is StateType.AND:
                todo += [child.label for child in self.eac.children(node.label)]
            elif self._is_nested(node):
                leaves.add(node.label)
            elif node.type is StateType.OR and (start := self.eac.start_of(node.label)) is not None:
                todo.append(start.label)
            else:
                leaves.add(node.label)
        return frozenset(leaves)

    def _is_nested(self, node: State) -> bool:
        """Whether a conversation of another protocol is inside: a leaf here, which may be complete."""
        return node.label != self.subchart and self.eac.is_branch(node)

    def _is_complete(self, label: str, configuration: Configuration) -> bool:
        node = self.eac.node(label)
        if self._is_nested(node):
            return True
        if node.type is StateType.OR:
            end = self.eac.end_of(label)
            return end is not None and end.label in configuration
        if node.type is StateType.AND:
            return all(self._is_complete(child.label, configuration) for child in self.eac.children(label))
        return True


def _sends(expression: TransitionExpression) -> tuple[Letter, ...]:
    return tuple(
        ("!", action.performative, action.message, action.participant)
        for action in expression.actions
        if isinstance(action, Send)
    )


# ---- to one automaton ----------------------------------------------------------------------------

_Point = tuple[Configuration, tuple[Letter, ...]]
"""A configuration, and what is still to be said on the way to it."""
_Set = frozenset[_Point]


def _deterministic(explorer: _Explorer) -> Automaton:
    """By subsets: what can be reached by the same letters is one state."""
    known: dict[Configuration, tuple[tuple[tuple[Letter, ...], Configuration], ...]] = {}

    def steps(configuration: Configuration) -> tuple[tuple[tuple[Letter, ...], Configuration], ...]:
        if configuration not in known:
            if len(known) >= LARGEST:
                raise TooManyStates
            known[configuration] = tuple(explorer.steps(configuration))
        return known[configuration]

    def closed(points: Iterable[_Point]) -> _Set:
        found: set[_Point] = set()
        todo = list(points)
        while todo:
            point = todo.pop()
            if point in found:
                continue
            found.add(point)
            if not point[1]:
                todo += [(target, ()) for said, target in steps(point[0]) if not said]
        return frozenset(found)

    first = closed([(explorer.first, ())])
    numbers: dict[_Set, int] = {first: 0}
    ways: list[tuple[tuple[Letter, int], ...]] = []
    ends: set[int] = set()
    todo = [first]
    for state in todo:
        if len(numbers) > LARGEST:
            raise TooManyStates
        if any(not rest and explorer.is_end(configuration) for configuration, rest in state):
            ends.add(numbers[state])
        reached: dict[Letter, set[_Point]] = {}
        for configuration, rest in state:
            ahead = ((rest, configuration),) if rest else steps(configuration)
            for said, target in ahead:
                if said:
                    reached.setdefault(said[0], set()).add((target, said[1:]))
        found = []
        for letter in sorted(reached):
            target_set = closed(reached[letter])
            if target_set not in numbers:
                numbers[target_set] = len(numbers)
                todo.append(target_set)
            found.append((letter, numbers[target_set]))
        ways.append(tuple(found))
    return Automaton(tuple(ways), frozenset(ends))


def _minimal(automaton: Automaton) -> Automaton:
    """States that cannot be told apart are one; numbered as they are met from the first."""
    count = len(automaton.ways)
    group = [int(state in automaton.ends) for state in range(count)]
    groups = len(set(group))
    while True:
        keys = [
            (group[state], tuple((letter, group[target]) for letter, target in automaton.ways[state]))
            for state in range(count)
        ]
        order: dict[object, int] = {}
        group = [order.setdefault(key, len(order)) for key in keys]
        if len(order) == groups:
            break
        groups = len(order)
    numbers = {group[0]: 0}
    members = {group[state]: state for state in reversed(range(count))}
    ways: list[tuple[tuple[Letter, int], ...]] = []
    todo = [group[0]]
    for item in todo:
        found = []
        for letter, target in automaton.ways[members[item]]:
            if group[target] not in numbers:
                numbers[group[target]] = len(numbers)
                todo.append(group[target])
            found.append((letter, numbers[group[target]]))
        ways.append(tuple(found))
    ends = frozenset(numbers[group[state]] for state in automaton.ends if group[state] in numbers)
    return Automaton(tuple(ways), ends)


__all__ = ["Automaton", "Letter", "TooManyStates", "automaton_of"]
