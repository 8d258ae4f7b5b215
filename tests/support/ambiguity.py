"""Whether a regular expression can be matched in exponentially many ways, decided on its automaton.

A matcher that goes back tries every way of matching before it gives up. There are exponentially many exactly
if some place of the expression can be reached again from itself, by one and the same text, in two ways. The
automaton is Glushkov's: its places are the characters of the expression. Of what stands between two
characters, `\\b` and what looks one character ahead are respected; other conditions count as always met, so
that the answer may be "yes" where it is "no", and never the other way round.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from re import _constants as op  # type: ignore[attr-defined]
from re import _parser  # type: ignore[attr-defined]
from typing import Any

import networkx as nx

ALPHABET = frozenset([*range(128), 0x80, 0xA0, 0xE9, 0x3C9, 0x2026])
"""All of ASCII, and one of each other kind."""
_WORD = {"ascii": frozenset(c for c in ALPHABET if c < 128 and (chr(c).isalnum() or c == 95))}
_WORD["unicode"] = frozenset(c for c in ALPHABET if chr(c).isalnum() or c == 95)

Edge = tuple[int, frozenset[int], int]
"""To which place, by which characters, and whether at a word boundary (1), at none (-1), or anywhere (0)."""


@dataclass
class _Automaton:
    is_ascii: bool
    dot_all: bool
    sets: list[frozenset[int]] = field(default_factory=list)
    empty: dict[int, list[tuple[int, frozenset[int], int]]] = field(default_factory=dict)
    nodes: int = 0
    at: dict[int, int] = field(default_factory=dict)  # the node in front of a place
    behind: dict[int, int] = field(default_factory=dict)  # the node behind it
    inner: list[Any] = field(
        default_factory=list
    )  # what is looked at ahead or behind: expressions of their own

    def node(self) -> int:
        self.nodes += 1
        self.empty[self.nodes] = []
        return self.nodes

    def link(self, start: int, end: int, allowed: frozenset[int] = ALPHABET, boundary: int = 0) -> None:
        self.empty[start].append((end, allowed, boundary))

    # ---- building

    def sequence(self, parts: Any, start: int) -> int:
        for part in parts:
            start = self.part(part, start)
        return start

    def part(self, part: Any, start: int) -> int:
        what, value = part
        characters = self.characters(what, value)
        end = self.node()
        if characters is not None:
            place = len(self.sets)
            self.sets.append(characters)
            self.at[place], self.behind[place] = start, end
            return end
        match what:
            case op.SUBPATTERN:
                self.link(self.sequence(value[3], start), end)
            case op.BRANCH:
                for branch in value[1]:
                    first = self.node()
                    self.link(start, first)
                    self.link(self.sequence(branch, first), end)
            case op.MAX_REPEAT | op.MIN_REPEAT:
                least, most, body = value
                for _ in range(min(least, 2)):
                    start = self.sequence(body, start)
                if most != least and most <= 2:
                    for _ in range(most - least):
                        self.link(start, end)
                        start = self.sequence(body, start)
                    self.link(start, end)
                elif most != least:
                    loop = self.node()
                    self.link(start, loop)
                    self.link(self.sequence(body, loop), loop)
                    self.link(loop, end)
                else:
                    self.link(start, end)
            case op.AT:
                boundary = {op.AT_BOUNDARY: 1, op.AT_NON_BOUNDARY: -1}.get(value, 0)
                self.link(start, end, boundary=boundary)
            case op.ASSERT | op.ASSERT_NOT:
                direction, body = value
                self.inner.append(body)
                allowed = ALPHABET
                if direction > 0 and len(body) == 1 and (one := self.characters(*body[0])) is not None:
                    allowed = one if what is op.ASSERT else ALPHABET - one
                self.link(start, end, allowed)
            case op.FAILURE:
                pass
            case _:
                raise NotImplementedError(f"{what} of a regular expression")
        return end

    def characters(self, what: Any, value: Any) -> frozenset[int] | None:
        match what:
            case op.LITERAL:
                return frozenset([value]) & ALPHABET
            case op.NOT_LITERAL:
                return ALPHABET - {value}
            case op.ANY:
                return ALPHABET if self.dot_all else ALPHABET - {10}
            case op.IN:
                found: set[int] = set()
                for kind, item in value:
                    match kind:
                        case op.LITERAL:
                            found.add(item)
                        case op.RANGE:
                            found |= {c for c in ALPHABET if item[0] <= c <= item[1]}
                        case op.CATEGORY:
                            found |= self.category(item)
                return frozenset(ALPHABET - found if value[0][0] is op.NEGATE else ALPHABET & found)
            case _:
                return None

    @property
    def words(self) -> frozenset[int]:
        return _WORD["ascii" if self.is_ascii else "unicode"]

    def category(self, item: Any) -> frozenset[int]:
        digits = frozenset(c for c in ALPHABET if chr(c).isdigit())
        blanks = frozenset(
            c for c in ALPHABET if chr(c).isspace() and not 28 <= c <= 31 and (c < 128 or not self.is_ascii)
        )
        known = {op.CATEGORY_WORD: self.words, op.CATEGORY_DIGIT: digits, op.CATEGORY_SPACE: blanks}
        others = {
            op.CATEGORY_NOT_WORD: ALPHABET - self.words,
            op.CATEGORY_NOT_DIGIT: ALPHABET - digits,
            op.CATEGORY_NOT_SPACE: ALPHABET - blanks,
        }
        return (known | others)[item]

    # ---- asking

    def following(self, place: int) -> Iterator[Edge]:
        """The places that may come next, one for each way."""
        before = {node: index for index, node in self.at.items()}
        todo = [(self.behind[place], ALPHABET, 0, frozenset[tuple[int, int]]())]
        while todo:
            node, allowed, boundary, seen = todo.pop()
            if node in before:
                characters = allowed & self.sets[before[node]]
                if characters:
                    yield before[node], characters, boundary
            for index, (end, more, other) in enumerate(self.empty[node]):
                if (node, index) not in seen and not (boundary and other and boundary != other):
                    todo.append((end, allowed & more, boundary or other, seen | {(node, index)}))


def exponential(text: str | bytes, flags: int = 0) -> str | None:
    """What in an expression, or in what it looks ahead for, can be matched in two ways time and again."""
    parsed = _parser.parse(text, flags)
    todo: list[Any] = [parsed]
    flags = parsed.state.flags
    while todo:
        automaton = _Automaton(bool(flags & re.ASCII) or isinstance(text, bytes), bool(flags & re.DOTALL))
        body = todo.pop()
        automaton.sequence(body, automaton.node())
        todo += automaton.inner
        found = _ambiguous(automaton)
        if found is not None:
            return found
    return None


def _ambiguous(automaton: _Automaton) -> str | None:
    words = automaton.words
    graph: nx.DiGraph = nx.DiGraph()
    # A place is taken apart by whether its character is one of a word, so that boundaries are exact.
    edges: dict[tuple[int, bool], list[tuple[tuple[int, bool], frozenset[int]]]] = {}
    for place, characters in enumerate(automaton.sets):
        following = list(automaton.following(place))
        for is_word in (True, False):
            if not (characters & words if is_word else characters - words):
                continue
            ways = edges[place, is_word] = []
            for end, allowed, boundary in following:
                for next_is_word in (True, False):
                    if boundary and (boundary > 0) == (is_word == next_is_word):
                        continue
                    by = allowed & words if next_is_word else allowed - words
                    if by:
                        ways.append(((end, next_is_word), by))
                        graph.add_edge((place, is_word), (end, next_is_word))
    for component in nx.strongly_connected_components(graph):
        pairs: nx.DiGraph = nx.DiGraph()
        for first in component:
            for end, count in Counter(end for end, _ in edges[first]).items():
                if count > 1 and end in component:
                    ways = [by for other, by in edges[first] if other == end]
                    both = [a & b for i, a in enumerate(ways) for b in ways[:i] if a & b]
                    if both:
                        return f"after {_shown(automaton.sets[first[0]])} {_shown(both[0])} in two ways"
            for second in component:
                for end, by in edges[first]:
                    for other, also in edges[second]:
                        if end in component and other in component and by & also:
                            pairs.add_edge((first, second), (end, other))
        for loop in nx.strongly_connected_components(pairs):
            twice = next((pair for pair in loop if pair[0][0] != pair[1][0]), None)
            if twice is not None and any(first == second for first, second in loop):
                return " and ".join(_shown(automaton.sets[place]) for place, _ in twice)
    return None


def _shown(characters: frozenset[int]) -> str:
    if len(characters) > 70:
        return "[^" + "".join(map(chr, sorted(ALPHABET - characters))) + "]"
    return repr("".join(map(chr, sorted(characters))))
