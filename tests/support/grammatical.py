"""Seeded mutations that know the grammar: parts of programs are exchanged, left out, doubled, nested."""

from __future__ import annotations

import random
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from aseme_dsl.grammar import parse
from aseme_dsl.source import Source
from tests.grammar.reading import nodes
from tests.support.mutations import slips

KINDS = ("another", "foreign", "left out", "doubled", "exchanged", "odd", "nested", "slip")
"""What happens: another part of the same kind, one of any kind, none, twice, two trade places, a number or
name that is odd, brackets around it, and a slip of the fingers."""

_ODD = '0 -1 1e400 0.0 99999999999999999999h 0ns ? true "" [] () * ~ else self time x if §'.split()
_ODD += ['"\u00e9\u202e"', "9" * 5000, "a" * 3000, "x." * 200 + "x"]
_AROUND = (("(", ")"), ("[", "]"), ("{", "}"), ("!(", ")"), ("(", ")*"), ("(", ")~"), ("(a || ", ")"))


@dataclass(frozen=True, slots=True)
class Part:
    """A part of a program: the kind of its node, and where it is."""

    kind: str
    start: int
    end: int


def parts(text: str) -> tuple[Part, ...]:
    """All parts of a program, in the order of the text."""
    tree: Any = parse(Source("program.aseme", text))[0]
    found = {
        Part(type(node).__name__, node.span.start, node.span.end)
        for node in nodes(tree.declarations)
        if node.span.start < node.span.end
    }
    return tuple(sorted(found, key=lambda part: (part.start, part.end, part.kind)))


def mutants(texts: Sequence[str], seed: int) -> Iterator[tuple[int, str]]:
    """Mutants without end, the same for the same seed: which of the texts it was, and what became of it."""
    chance = random.Random(seed)
    known = [parts(text) for text in texts]
    pool: defaultdict[str, set[str]] = defaultdict(set)
    for text, there in zip(texts, known, strict=True):
        for part in there:
            pool[part.kind].add(text[part.start : part.end])
    kinds = sorted(pool)
    of_kind = {kind: sorted(pool[kind]) for kind in kinds}
    while True:
        which = chance.randrange(len(texts))
        text = texts[which]
        # From the end on, so that the places before stay what they are.
        before = len(text) + 1
        for part in sorted(chance.choices(known[which], k=chance.choice([1, 1, 1, 2, 3, 8])), key=_end)[::-1]:
            if part.end <= before:
                text, before = _mutated(text, part, known[which], kinds, of_kind, chance), part.start
        yield which, text


def _end(part: Part) -> tuple[int, int]:
    return part.end, part.start


def _mutated(
    text: str,
    part: Part,
    known: tuple[Part, ...],
    kinds: list[str],
    of_kind: dict[str, list[str]],
    chance: random.Random,
) -> str:
    own = text[part.start : part.end]
    kind = chance.choice(KINDS)
    if kind == "another":
        own = chance.choice(of_kind[part.kind])
    elif kind == "foreign":
        own = chance.choice(of_kind[chance.choice(kinds)])
    elif kind == "left out":
        own = ""
    elif kind == "doubled":
        own = chance.choice([" ", "\n", ", ", " . ", " | "]).join([own] * chance.choice([2, 2, 3, 50]))
    elif kind == "exchanged":
        others = [other for other in known if other.kind == part.kind and other.end <= part.start]
        if others:
            other = chance.choice(others)
            there = text[other.start : other.end]
            between = text[other.end : part.start]
            return text[: other.start] + own + between + there + text[part.end :]
    elif kind == "odd":
        own = chance.choice(_ODD)
    elif kind == "nested":
        opening, closing = chance.choice(_AROUND)
        depth = chance.choice([1, 1, 2, 30, 400])
        own = opening * depth + own + closing * depth
    else:
        slip = next(slips(own, chance.randrange(1 << 30)), None)
        own = slip.text if slip is not None else ""
    return text[: part.start] + own + text[part.end :]
