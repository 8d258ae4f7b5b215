"""Identifiers: names of the language for the names of foreign models, which may be any text."""

from __future__ import annotations

import keyword
import re
from dataclasses import field

from aseme_dsl.records import dataclass

_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*", re.ASCII)
_RESERVED = frozenset("activities activity aip and as below above around actor bool".split())
_RESERVED |= frozenset("bytes capability clause clear control data depends double duration each".split())
_RESERVED |= frozenset("else END engage enter enum error every exit expired false".split())
_RESERVED |= frozenset("finish first for from function functionality given goal has import".split())
_RESERVED |= frozenset("in includes repeated index int language leave let list liveness".split())
_RESERVED |= frozenset("lost message modules not on or OR AND BASIC CONDITION".split())
_RESERVED |= frozenset(
    "START outcome participant plays process property reads realises receives repeat".split()
)
_RESERVED |= frozenset("resume result role sag scenario send sends signal skip srm".split())
_RESERVED |= frozenset("start state statechart string suc system team takes to topic".split())
_RESERVED |= frozenset("true under usecase uses var when while with within writes".split())
"""Words that cannot be a name everywhere."""
INITIAL = {"bool": "false", "int": "0", "double": "0.0", "string": '""'}
"""The first value of a variable of which a file gives the type only."""


def is_name(text: str) -> bool:
    """Whether a text can be a name as it is."""
    return _NAME.fullmatch(text) is not None and not is_reserved(text)


def is_reserved(text: str) -> bool:
    """Whether a text is a word of the language or of Python."""
    return text in _RESERVED or keyword.iskeyword(text) or text.startswith("__")


def as_name(text: str, otherwise: str) -> str:
    """A name that is near the text: `score a goal` becomes `score_a_goal`."""
    found = re.sub(r"[^A-Za-z0-9_]+", "_", text).strip("_") if text else ""
    if not found.strip("_"):
        found = otherwise
    if found[0].isdigit():
        found = f"_{found}"
    return f"{found}_" if is_reserved(found) else found


def system_name(title: str) -> str:
    """The name of the system that a file becomes: `goalie_plan` becomes `GoaliePlan`."""
    words = as_name(title, "Imported").split("_")
    return as_name("".join(word[:1].upper() + word[1:] for word in words), "Imported")


@dataclass(slots=True)
class Names:
    """Names of one kind, each given once. The same foreign name gets the same name again."""

    taken: set[str] = field(default_factory=set)
    given: dict[str, str] = field(default_factory=dict)

    def of(self, text: str, otherwise: str = "x") -> str:
        if text not in self.given:
            self.given[text] = self.new(text, otherwise)
        return self.given[text]

    def new(self, text: str, otherwise: str = "x") -> str:
        """A name that no other has."""
        wanted = as_name(text, otherwise)
        name, number = wanted, 2
        while name in self.taken:
            name, number = f"{wanted}_{number}", number + 1
        self.taken.add(name)
        return name


__all__ = ["INITIAL", "Names", "as_name", "is_name", "is_reserved", "system_name"]
