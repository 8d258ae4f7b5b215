"""Beliefs: where in its part an agent may be, after what it has sent and what it was sent.

A message waits until its receiver takes it, which no log of messages shows. So there are several
explanations of what was seen. Each is a *place*: a participant, a state of its automaton, and what waits
there. A belief is the set of all places that explain it. What an agent sends is allowed if it is so in one of
them. Beliefs and what follows from them are made once: a log leads through few different ones.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field
from functools import partial

from aseme_dsl.codegen.automaton import Letter
from aseme_dsl.project.observing.contract import Contract, Kind, Part
from aseme_dsl.records import dataclass

MANY = 3
"""So many waiting messages of one kind, or more, are `many`: one more or less makes no difference then."""
MOST = 4000
"""A belief of more places is not followed any further."""
GONE = -1
"""The state of a part that has ended early, and said so."""

Waiting = tuple[tuple[tuple[Kind, ...], frozenset[str], int], ...]
"""What waits: what it may be, the participants that may have sent it, and how many there are."""
Place = tuple[str, int, "Waiting | None"]
"""A participant, the state of its automaton, and what waits; None: anything may wait."""


class TooMany(Exception):
    """There are too many explanations."""


@dataclass(eq=False, slots=True)
class Belief:
    """The places in which an agent may be, with what was worked out of them already."""

    places: frozenset[Place]
    parts: frozenset[str]
    said: dict[object, Said | None] = field(default_factory=dict)
    heard: dict[object, Belief | None] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Said:
    """What follows from a message: the belief about its sender, and the parts of sender and receivers.

    `is_early`: it is a farewell, with which a part ends early.
    """

    belief: Belief
    senders: frozenset[str]
    receivers: frozenset[str]
    is_early: bool = False


class Beliefs:
    """The beliefs about the agents of one protocol."""

    def __init__(self, contract: Contract) -> None:
        self.contract = contract
        self._known: dict[frozenset[Place], Belief] = {}
        self._later = {name: _later(part) for name, part in contract.parts.items()}
        names = frozenset(contract.parts)
        self.first = self._closed((name, 0, ()) for name in names)
        """Of an agent that has neither sent nor received anything."""
        self.anywhere = self._closed(
            (name, state, None)
            for name, part in contract.parts.items()
            for state in range(len(part.automaton.ways))
        )
        """Of an agent of which nothing is known."""

    def narrowed(self, belief: Belief, parts: frozenset[str]) -> Belief:
        """The same belief if the agent plays one of these participants."""
        if belief.parts <= parts:
            return belief
        return self._of(frozenset(place for place in belief.places if place[0] in parts))

    def joined(self, one: Belief, other: Belief) -> Belief:
        """One or the other is so."""
        return self._of(one.places | other.places)

    def said(
        self, belief: Belief, kinds: tuple[Kind, ...], to: frozenset[str], *, is_ours: bool
    ) -> Said | None:
        """What follows if the agent says this to agents that play one of these; None: it may not say it.

        `is_ours`: the runtime of asemec may have said it for the agent.

        Raises:
            TooMany: there are too many explanations.
        """
        key = kinds, to, is_ours
        if key not in belief.said:
            belief.said[key] = self._said(belief, kinds, to, is_ours)
        return belief.said[key]

    def heard(
        self, belief: Belief, kinds: tuple[Kind, ...], senders: frozenset[str], parts: frozenset[str]
    ) -> Belief | None:
        """The belief about an agent that is sent this, as one of `parts`; None: it plays none of them.

        Raises:
            TooMany: there are too many explanations.
        """
        key = kinds, senders, parts
        if key not in belief.heard:
            places = [self._sent(place, kinds, senders) for place in belief.places if place[0] in parts]
            belief.heard[key] = self._closed(places) if places else None
        return belief.heard[key]

    # ---- what a place allows ---------------------------------------------------------------------

    def _said(
        self, belief: Belief, kinds: tuple[Kind, ...], to: frozenset[str], is_ours: bool
    ) -> Said | None:
        farewells = partial(self._farewells, is_ours=is_ours)
        for find, is_early in ((self._moves, False), (self._busy, False), (farewells, True)):
            found = [item for place in belief.places for item in find(place, kinds, to)]
            if found:
                receivers = frozenset(other for _, _, others in found for other in others)
                senders = frozenset(name for name, _, _ in found)
                return Said(self._closed(place for _, place, _ in found), senders, receivers, is_early)
        return None

    def _moves(
        self, place: Place, kinds: tuple[Kind, ...], to: frozenset[str]
    ) -> Iterable[tuple[str, Place, frozenset[str]]]:
        """What the automaton has: each with the participant, the next place and whom it goes to."""
        name, state, waiting = place
        if state == GONE:
            return
        for letter, target in self.contract.parts[name].automaton.ways[state]:
            if letter[0] != "?" and letter[1:3] in kinds:
                others = self._takers(name, letter[1:3], letter[3], to)
                if others:
                    yield name, self._at(name, target, waiting), others

    def _takers(self, name: str, kind: Kind, named: str, to: frozenset[str]) -> frozenset[str]:
        """Those of some participants that such a message may go to."""
        if named:
            return to & {named}
        parts = self.contract.parts
        return frozenset(other for other in to if kind in parts[other].receives and self._may_go(name, other))

    def _may_go(self, name: str, other: str) -> bool:
        most = self.contract.parts[name].most
        return name != other or most is None or most > 1

    def _busy(
        self, place: Place, kinds: tuple[Kind, ...], to: frozenset[str]
    ) -> Iterable[tuple[str, Place, frozenset[str]]]:
        """An agent answers an invitation while it is busy, and does not begin its part."""
        name, state, _ = place
        if state == 0 and not self.contract.parts[name].busy.isdisjoint(kinds):
            yield name, (name, GONE, ()), to

    def _farewells(
        self, place: Place, kinds: tuple[Kind, ...], to: frozenset[str], *, is_ours: bool
    ) -> Iterable[tuple[str, Place, frozenset[str]]]:
        """The part ends early, and says so. Others may be told, too."""
        name, _, _ = place
        part = self.contract.parts[name]
        others = frozenset(
            other
            for other in to
            if not part.farewells[other].isdisjoint(kinds)
            or (is_ours and not part.chosen[other].isdisjoint(kinds))
        )
        if others:
            yield name, (name, GONE, ()), others

    def _sent(self, place: Place, kinds: tuple[Kind, ...], senders: frozenset[str]) -> Place:
        """A place with one more message that waits, if it can be taken there at all."""
        name, state, waiting = place
        if waiting is None or state == GONE or not self._may_take(name, state, kinds, senders):
            return place
        found = {item[:2]: item[2] for item in waiting}
        found[kinds, senders] = min(MANY, found.get((kinds, senders), 0) + 1)
        return name, state, _waiting(found)

    def _may_take(self, name: str, state: int, kinds: tuple[Kind, ...], senders: frozenset[str]) -> bool:
        return any(_fits(letter, kinds, senders) for letter in self._later[name][state])

    def _at(self, name: str, state: int, waiting: Waiting | None) -> Place:
        """A place without what can be taken nowhere behind it."""
        if waiting:
            waiting = tuple(item for item in waiting if self._may_take(name, state, item[0], item[1]))
        return name, state, waiting

    def _taken(self, place: Place) -> Iterable[Place]:
        """The places that follow if one of the messages that wait is taken, and changes the state."""
        name, state, waiting = place
        if state == GONE or waiting == ():
            return
        for letter, target in self.contract.parts[name].automaton.ways[state]:
            if letter[0] != "?" or target == state:
                continue
            if waiting is None:
                yield name, target, None
                continue
            for kinds, senders, count in waiting:
                if _fits(letter, kinds, senders):
                    found = {item[:2]: item[2] for item in waiting}
                    found[kinds, senders] = count if count == MANY else count - 1
                    yield self._at(name, target, _waiting(found))

    # ---- beliefs ---------------------------------------------------------------------------------

    def _closed(self, places: Iterable[Place]) -> Belief:
        """The belief of these places, and of all that follow if messages are taken."""
        found: dict[tuple[str, int], set[Waiting | None]] = {}
        todo = list(places)
        count = 0
        while todo:
            place = todo.pop()
            name, state, waiting = place
            there = found.setdefault((name, state), set())
            if any(_has_all(other, waiting) for other in there):
                continue  # where more waits, everything is possible that is possible with less
            less = {other for other in there if _has_all(waiting, other)}
            there -= less
            there.add(waiting)
            count += 1 - len(less)
            if count > MOST:
                raise TooMany
            todo += self._taken(place)
        return self._of(frozenset((*at, waiting) for at, there in found.items() for waiting in there))

    def _of(self, places: frozenset[Place]) -> Belief:
        if len(places) > MOST:
            raise TooMany
        belief = self._known.get(places)
        if belief is None:
            if len(self._known) >= MOST:
                self._forget()
            belief = self._known[places] = Belief(places, frozenset(place[0] for place in places))
        return belief

    def _forget(self) -> None:
        """Let go what was worked out: more is known than most logs lead to."""
        for item in self._known.values():
            item.said.clear()
            item.heard.clear()
        self._known.clear()

    # ---- for people ------------------------------------------------------------------------------

    def sends(self, belief: Belief) -> tuple[str, ...]:
        """What the agent may say now, in words: `inform Meal to waiter`."""
        return self._letters(belief, "!")

    def awaits(self, belief: Belief) -> tuple[str, ...]:
        """What the agent takes now, in words: `request Dish from waiter`."""
        return self._letters(belief, "?")

    def _letters(self, belief: Belief, sign: str) -> tuple[str, ...]:
        found: set[str] = set()
        for name, state, _ in belief.places:
            ways = self.contract.parts[name].automaton.ways[state] if state != GONE else ()
            for letter, _ in ways:
                if letter[0][0] == sign:
                    other = f" {'from' if sign == '?' else 'to'} {letter[3]}" if letter[3] else ""
                    found.add(f"{letter[1]} {letter[2]}{other}".strip())
        return tuple(sorted(found))


def _waiting(found: Mapping[tuple[tuple[Kind, ...], frozenset[str]], int]) -> Waiting:
    items = ((kinds, senders, count) for (kinds, senders), count in found.items() if count)
    return tuple(sorted(items, key=lambda item: (item[0], sorted(item[1]))))


def _has_all(one: Waiting | None, other: Waiting | None) -> bool:
    """Whether all that waits in one place waits in another one, too."""
    if one is None or other is None:
        return one is None
    found = {item[:2]: item[2] for item in one}
    return all(found.get(item[:2], 0) >= item[2] for item in other)


def _fits(letter: Letter, kinds: tuple[Kind, ...], senders: frozenset[str]) -> bool:
    return letter[0] == "?" and letter[1:3] in kinds and (not letter[3] or letter[3] in senders)


def _later(part: Part) -> tuple[frozenset[Letter], ...]:
    """What can still be received, now or later, by state."""
    ways = part.automaton.ways
    found = [{letter for letter, _ in items if letter[0] == "?"} for items in ways]
    changed = True
    while changed:
        changed = False
        for state, items in enumerate(ways):
            before = len(found[state])
            for _, target in items:
                found[state] |= found[target]
            changed = changed or len(found[state]) > before
    return tuple(map(frozenset, found))


__all__ = ["Belief", "Beliefs", "Said", "TooMany"]
