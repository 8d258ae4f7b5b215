"""Seeded mutations that know the grammar: parts of programs are exchanged, left out, doubled, nested."""

from __future__ import annotations

import random
import re
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from aseme_dsl.grammar import parse
from aseme_dsl.source import Source
from tests.grammar.reading import nodes
from tests.support.mutations import slips

GENTLE = ("another", "own", "exchanged", "left out", "doubled", "value")
"""What mostly leaves a program that can be read: another part of the same kind, from any program or from its
own, two trade places, an item of a list is left out or written twice, and another value. So the later phases
are reached, too."""

ROUGH = ("another", "foreign", "left out", "doubled", "exchanged", "odd", "nested", "slip")
"""What mostly does not: one of any kind, one that is just cut out or repeated, a number or name that is odd,
brackets around it, and a slip of the fingers."""

_ODD = '0 -1 1e400 0.0 99999999999999999999h 0ns ? true "" [] () * ~ else self time x if §'.split()
_ODD += ['"\u00e9\u202e"', "9" * 5000, "a" * 3000, "x." * 200 + "x"]
_NAMES = [*"class None self x _ __init__ é print match aux Agent a.b naïve Ω".split(), "a" * 200]
"""What a name becomes everywhere; some mean something in what is generated."""

_VALUES = {
    "Number": "0 1 -1 0.5 1e300 1e-300 2147483648 18446744073709551616".split(),
    "Duration": "0s 1ns 1ms 0.001s 3h 100000h 1e9s".split(),
    "Text": ['""', '"\\n"', '"{}%s"', '"</svg>&amp;"', '"\\\\"', '"é☃"', "\"'''\""],
    "Truth": ["true", "false"],
}

_SEPARATOR_AFTER = re.compile(r"[ \n]*(?:,|\.(?![\w.])|\|\|?|&&|;)[ \n]*|\n\s*")
_SEPARATOR_BEFORE = re.compile(r"\s*(?:,|\.|\|\|?|&&)\s*$")
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


@dataclass(frozen=True, slots=True)
class _Stock:
    """What mutants are made of: each program's parts, also by their kind, and all texts by kind."""

    known: tuple[tuple[Part, ...], ...]
    of_program: tuple[dict[str, list[Part]], ...]
    of_kind: dict[str, list[str]]


@cache
def _stock(texts: tuple[str, ...]) -> _Stock:
    known = tuple(parts(text) for text in texts)
    pool: defaultdict[str, set[str]] = defaultdict(set)
    own: list[dict[str, list[Part]]] = []
    for text, there in zip(texts, known, strict=True):
        grouped: defaultdict[str, list[Part]] = defaultdict(list)
        for part in there:
            pool[part.kind].add(text[part.start : part.end])
            grouped[part.kind].append(part)
        own.append(dict(sorted(grouped.items())))
    return _Stock(known, tuple(own), {kind: sorted(pool[kind]) for kind in sorted(pool)})


def mutants(
    texts: Sequence[str], seed: int, weights: Sequence[int] | None = None
) -> Iterator[tuple[int, str]]:
    """Mutants without end, the same for the same seed: which of the texts it was, and what became of it.

    Two of three are changed gently. `weights` says how often each text is chosen.
    """
    chance = random.Random(seed)
    stock = _stock(tuple(texts))
    while True:
        [which] = chance.choices(range(len(texts)), weights)
        text = texts[which]
        gentle, renamed = chance.random() < 2 / 3, chance.random() < 1 / 4
        number = chance.choice([1, 1, 1, 2] if gentle else [1, 1, 1, 2, 3, 8])
        if gentle and renamed:
            text, number = _renamed(text, which, stock, chance), 0
        chosen = [_chosen(which, stock, chance) for _ in range(number)]
        # From the end on, so that the places before stay what they are.
        before = len(text) + 1
        for part in sorted(chosen, key=_end)[::-1]:
            if part.end <= before:
                change = _gently if gentle else _roughly
                text, before = change(text, part, which, stock, chance), part.start
        if text != texts[which]:
            yield which, text


def _chosen(which: int, stock: _Stock, chance: random.Random) -> Part:
    """A part: as often by its kind, since most parts are names."""
    if chance.random() < 0.5:
        return chance.choice(stock.known[which])
    of_kind = stock.of_program[which]
    return chance.choice(of_kind[chance.choice(list(of_kind))])


def _end(part: Part) -> tuple[int, int]:
    return part.end, part.start


def _renamed(text: str, which: int, stock: _Stock, chance: random.Random) -> str:
    """The program with a name that is another one everywhere: an odd one, or that of something else."""
    names = sorted({text[part.start : part.end] for part in stock.of_program[which]["Name"]})
    before, after = chance.choice(names), chance.choice([*_NAMES, *names[: len(_NAMES)]])
    return re.sub(rf"\b{re.escape(before)}\b", lambda _: after, text)


def _gently(text: str, part: Part, which: int, stock: _Stock, chance: random.Random) -> str:
    own = text[part.start : part.end]
    kind = chance.choice(GENTLE)
    if kind == "another":
        own = chance.choice(stock.of_kind[part.kind])
    elif kind == "exchanged":
        return _exchanged(text, part, which, stock, chance)
    elif kind == "left out":
        # With what separates it from the next, or else from the one before.
        start, end = part.start, part.end
        if after := _SEPARATOR_AFTER.match(text, end):
            end = after.end()
        elif found := _SEPARATOR_BEFORE.search(text, max(0, start - 40), start):
            start = found.start()
        return text[:start] + text[end:]
    elif kind == "doubled":
        after = _SEPARATOR_AFTER.match(text, part.end)
        own += (after[0] if after else "\n") + own
    elif kind == "value" and part.kind in _VALUES:
        own = chance.choice(_VALUES[part.kind])
    else:
        # What stands before it is still as it was.
        other = chance.choice(stock.of_program[which][part.kind])
        if other.end <= part.start:
            own = text[other.start : other.end]
    return text[: part.start] + own + text[part.end :]


def _roughly(text: str, part: Part, which: int, stock: _Stock, chance: random.Random) -> str:
    own = text[part.start : part.end]
    kind = chance.choice(ROUGH)
    if kind == "another":
        own = chance.choice(stock.of_kind[part.kind])
    elif kind == "foreign":
        own = chance.choice(stock.of_kind[chance.choice(list(stock.of_kind))])
    elif kind == "left out":
        own = ""
    elif kind == "doubled":
        own = chance.choice([" ", "\n", ", ", " . ", " | "]).join([own] * chance.choice([2, 2, 3, 50]))
    elif kind == "exchanged":
        return _exchanged(text, part, which, stock, chance)
    elif kind == "odd":
        own = chance.choice(_ODD)
    elif kind == "nested":
        opening, closing = chance.choice(_AROUND)
        depth = chance.choice([1, 1, 2, 20, 20 if "||" in opening else 400])  # 400 regions are a slow chart
        own = opening * depth + own + closing * depth
    else:
        slip = next(slips(own, chance.randrange(1 << 30)), None)
        own = slip.text if slip is not None else ""
    return text[: part.start] + own + text[part.end :]


def _exchanged(text: str, part: Part, which: int, stock: _Stock, chance: random.Random) -> str:
    """The text with the part and one before it of the same kind in each other's place, if there is one."""
    others = [other for other in stock.of_program[which][part.kind] if other.end <= part.start]
    if not others:
        return text
    other = chance.choice(others)
    between = text[other.end : part.start]
    own, there = text[part.start : part.end], text[other.start : other.end]
    return text[: other.start] + own + between + there + text[part.end :]
