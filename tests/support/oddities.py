"""Programs in which sound declarations are used by nothing, or where nobody expects it."""

from __future__ import annotations

import random
import re
from pathlib import Path

_BASE = (Path(__file__).parent / "oddities.aseme").read_text("utf-8")
_WORD = re.compile(r"[A-Za-z_][A-Za-z_0-9]*")
_GIVEN = re.compile(r"(?<=\w)\([^()]*\)")
_TERM = re.compile(r"(?<== )[^\s{}][^{}\n]*$", re.MULTILINE)
_VALUES = (
    "1",
    "2.5",
    '"x"',
    "true",
    "1s",
    "Place.BELT",
    "index",
    "random()",
    "[1, 2]",
    "in(Sense)",
    "done(Sort)",
    "count(Sort)",
    "expired(pause)",
    "outcome(Grasp)",
    "held",
    "world.state.Box",
    "world.state.Box.at",
    "world.state.Box.weight",
    "age(world.data.Box)",
    "at(world.data.Box.number, -1s)",
    "world.signal.Ping.count",
    "mean(world.data.Box.number, 1s)",
    "has(world.state.Box)",
    "first.world.state.Box.number",
    "sender(b)",
    "b.at",
    "world.state.Box.stops",
    "world.state.Box.stops[0]",
    "near(Place.BELT, 2)",
    "busy",
    "tired",
    "best",
    "low(1)",
)


def odd_program(seed: int) -> str:
    """A sound program of all constructs with one to three of its uses and declarations changed by chance.

    A name becomes another one that is declared, or a value; what is given is left out or given elsewhere; a
    line is left out, or written again in another block.
    """
    chance = random.Random(seed)
    text = _BASE
    for _ in range(chance.randint(1, 3)):
        text = chance.choice((_renamed, _renamed, _valued, _not_given, _given, _without, _elsewhere))(
            text, chance
        )
    return text


def _renamed(text: str, chance: random.Random) -> str:
    names = list(_WORD.finditer(text))
    place, other = chance.choice(names), chance.choice(names)
    return text[: place.start()] + other[0] + text[place.end() :]


def _valued(text: str, chance: random.Random) -> str:
    place = chance.choice(list(_WORD.finditer(text)))
    return text[: place.start()] + chance.choice(_VALUES) + text[place.end() :]


def _not_given(text: str, chance: random.Random) -> str:
    place = chance.choice(list(_GIVEN.finditer(text)))
    return text[: place.start()] + text[place.end() :]


def _given(text: str, chance: random.Random) -> str:
    places = list(_GIVEN.finditer(text))
    place = chance.choice(places)
    given = f"({chance.choice(_VALUES)})" if chance.randrange(2) else chance.choice(places)[0]
    if chance.randrange(2):
        return text[: place.start()] + given + text[place.end() :]
    name = chance.choice(list(_WORD.finditer(text)))
    return text[: name.end()] + given + text[name.end() :]


def _without(text: str, chance: random.Random) -> str:
    lines = text.splitlines(keepends=True)
    whole = [number for number, line in enumerate(lines) if line.count("{") == line.count("}")]
    place = chance.choice(whole)
    return "".join(line for number, line in enumerate(lines) if number != place)


def _elsewhere(text: str, chance: random.Random) -> str:
    """A line again in another place, or what stands behind a `=` in place of another."""
    if chance.randrange(2):
        terms = list(_TERM.finditer(text))
        place = chance.choice(terms)
        return text[: place.start()] + chance.choice(terms)[0] + text[place.end() :]
    lines = text.splitlines(keepends=True)
    lines.insert(
        chance.randrange(len(lines)),
        chance.choice([line for line in lines if line.count("{") == line.count("}")]),
    )
    return "".join(lines)


__all__ = ["odd_program"]
