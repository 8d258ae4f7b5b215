"""Races: two participants that may each send while the other does, and that then wait past each other.

A choice is non-local if two participants make it, each by what it sends. With messages that are under way for
a while, both may have chosen before either knows.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from itertools import chain, combinations

from aseme_dsl.amola.aip import Aip, Participant, plays_inside
from aseme_dsl.amola.expression import Send
from aseme_dsl.amola.srm import Srm
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.codegen.automaton import Automaton, Letter, TooManyStates, automaton_of
from aseme_dsl.codegen.moves import sent_by_transitions, subchart_of
from aseme_dsl.compiler.read.library import is_of_library
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.talk import SendsRace
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

LARGEST = 20_000
"""So many pairs of states are explored at the most."""


def check_races(
    aips: Iterable[Aip], eacs: Mapping[str, Statechart | None], srms: Iterable[Srm], memory: Memory
) -> InPieces[list[Diagnostic]]:
    """W575 for two messages that may cross, so that neither is received and one sender waits for ever.

    If both are the first message of their participant, W575 is reported even if both waits end: each message
    opens a conversation of its own. Protocols of the standard library are checked if a role plays them.
    """
    aips = list(aips)
    played = {item.protocol for srm in srms for item in plays_inside(srm.plays, aips)}
    looked_at = [
        (aip, chart)
        for aip in aips
        if (chart := eacs.get(aip.name)) is not None
        and (aip.name in played or not is_of_library(aip.span.source))
    ]
    return list(chain.from_iterable((yield from memory.each_in_pieces(_races, looked_at))))


@dataclass(frozen=True)
class _Side:
    """A participant with its automaton."""

    part: Participant
    automaton: Automaton

    @cached_property
    def later(self) -> tuple[frozenset[Letter], ...]:
        """What can still be received or sent, now or later, by state."""
        found = [{letter for letter, _ in ways} for ways in self.automaton.ways]
        changed = True
        while changed:
            changed = False
            for state, ways in enumerate(self.automaton.ways):
                before = len(found[state])
                for _, target in ways:
                    found[state] |= found[target]
                changed = changed or len(found[state]) > before
        return tuple(map(frozenset, found))

    @cached_property
    def ending(self) -> frozenset[int]:
        """The states from which the end can be reached without another message received."""
        found = set(self.automaton.ends)
        changed = True
        while changed:
            changed = False
            for state, ways in enumerate(self.automaton.ways):
                sends = (target for letter, target in ways if letter[0] != "?")
                if state not in found and not found.isdisjoint(sends):
                    found.add(state)
                    changed = True
        return frozenset(found)

    def can_take(self, state: int, said: Letter, sender: str) -> bool:
        """Whether a message of the sender can still be taken, now or later."""
        return any(_is_answered(item, said, sender) for item in self.later[state])


def _is_answered(letter: Letter, said: Letter, sender: str) -> bool:
    return letter[0] == "?" and letter[1:3] == said[1:3] and letter[3] in ("", sender)


def _races(aip: Aip, chart: Statechart) -> tuple[Diagnostic, ...]:
    try:
        sides = [_Side(part, automaton_of(chart, part)) for part in aip.participants]
    except TooManyStates:
        return ()
    found = (_race(one, other) for one, other in combinations(sides, 2))
    return tuple(
        _told(chart, one, first, other, second)
        for race in found
        if race is not None
        for one, first, other, second in [race]
    )


_Race = tuple[_Side, Letter, _Side, Letter]


def _race(one: _Side, other: _Side) -> _Race | None:
    """The first race of two participants, if there is any, in what they reach by talking in turns."""
    todo = [(0, 0)]
    seen = set(todo)
    for mine, theirs in todo:
        if len(seen) > LARGEST:
            return None
        for said, after in _sends_to(one, mine, other):
            for answer, behind in _sends_to(other, theirs, one):
                if one.can_take(after, answer, other.part.name):
                    continue
                if other.can_take(behind, said, one.part.name):
                    continue
                if (mine, theirs) == (0, 0) or not (after in one.ending and behind in other.ending):
                    return one, said, other, answer
        for pair in _next(one, mine, other, theirs):
            if pair not in seen:
                seen.add(pair)
                todo.append(pair)
    return None


def _sends_to(side: _Side, state: int, other: _Side) -> Iterator[tuple[Letter, int]]:
    """What a participant can send to the other one now, and its state then."""
    received = {(item.performative, item.message) for item in other.part.receives}
    for letter, target in side.automaton.ways[state]:
        if letter[0] != "?" and letter[3] in ("", other.part.name) and letter[1:3] in received:
            yield letter, target


def _next(one: _Side, mine: int, other: _Side, theirs: int) -> Iterator[tuple[int, int]]:
    """The next pairs of states: after a message between the two, or one that concerns a third participant."""
    for said, after in _sends_to(one, mine, other):
        for letter, behind in other.automaton.ways[theirs]:
            if _is_answered(letter, said, one.part.name):
                yield after, behind
    for said, behind in _sends_to(other, theirs, one):
        for letter, after in one.automaton.ways[mine]:
            if _is_answered(letter, said, other.part.name):
                yield after, behind
    for letter, after in one.automaton.ways[mine]:
        if letter[3] not in ("", other.part.name):
            yield after, theirs
    for letter, behind in other.automaton.ways[theirs]:
        if letter[3] not in ("", one.part.name):
            yield mine, behind


def _told(chart: Statechart, one: _Side, first: Letter, other: _Side, second: Letter) -> Diagnostic:
    texts = [" ".join(letter[1:3]) for letter in (first, second)]
    problem = SendsRace(one.part.name, texts[0], other.part.name, texts[1])
    related = (Related(_place(chart, other.part, second), f"`{other.part.name}` sends here"),)
    return Diagnostic(problem, _place(chart, one.part, first), related)


def _place(chart: Statechart, part: Participant, letter: Letter) -> Span:
    """Where a participant sends a message: the line, or, if activities do, the entry of its list."""
    subchart = subchart_of(chart, part.name)
    sent: Mapping[tuple[str, str], Send] = {}
    if subchart is not None:
        sent = sent_by_transitions(chart, subchart.label)
    action = sent.get((letter[1], letter[2]))
    listed = (item.span for item in part.sends if (item.performative, item.message) == letter[1:3])
    return action.span if action is not None else next(listed, part.span)


__all__ = ["check_races"]
