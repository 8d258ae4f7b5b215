"""Seeded slips: a program with one token deleted, doubled, swapped with its neighbour, or misspelt."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from dataclasses import dataclass

KINDS = ("deleted", "doubled", "swapped", "misspelt")

_TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\d[\w.]*|\w+|->|&&|\|\||[<>=!]=|\S', re.DOTALL)
_LETTERS = "abcdefghijklmnopqrstuvwxyz"


@dataclass(frozen=True, slots=True)
class Slip:
    """A text with one slip, the kind of slip, the token it happened to and the token's line (from 1)."""

    kind: str
    token: str
    line: int
    text: str


def slips(text: str, seed: int) -> Iterator[Slip]:
    """Slips without end, the same for the same seed; the four kinds take turns. Comments are left alone.

    A text with fewer than three tokens, or without a word, has none.
    """
    chance = random.Random(seed)
    tokens = [match for match in _TOKEN.finditer(text) if not match[0].startswith(("//", "/*"))]
    words = [match for match in tokens if len(match[0]) > 2 and match[0].isidentifier()]
    while words and len(tokens) > 2:
        for kind in KINDS:
            match = chance.choice(words if kind == "misspelt" else tokens[:-1])
            start, end, token = match.start(), match.end(), match[0]
            if kind == "deleted":
                changed = text[:start] + text[end:]
            elif kind == "doubled":
                changed = f"{text[:end]} {token}{text[end:]}"
            elif kind == "swapped":
                after = tokens[tokens.index(match) + 1]
                between = text[end : after.start()]
                changed = f"{text[:start]}{after[0]}{between or ' '}{token}{text[after.end() :]}"
            else:
                changed = text[:start] + _misspelt(token, chance) + text[end:]
            yield Slip(kind, token, text.count("\n", 0, start) + 1, changed)


def _misspelt(word: str, chance: random.Random) -> str:
    """The word with a letter left out, put in, changed, or exchanged with the next."""
    while True:
        place = chance.randrange(len(word) - 1)
        before, after = word[:place], word[place:]
        slip = chance.choice(
            [
                before + after[1:],
                before + chance.choice(_LETTERS) + after,
                before + chance.choice(_LETTERS) + after[1:],
                before + after[1] + after[0] + after[2:],
            ]
        )
        if slip != word and slip.isidentifier():
            return slip
