"""SAG, System Actors Goals (P1, section 4.1): who wants what, and on whom that depends."""

from __future__ import annotations

from aseme_dsl.display import Displayed
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Goal:
    """A goal of an actor; `dependees` are the actors it depends on, `requirements` is its text."""

    name: str
    depender: str
    dependees: tuple[str, ...]
    requirements: str
    span: Span


@dataclass(frozen=True, slots=True)
class Actor:
    name: str
    span: Span


@dataclass(frozen=True, slots=True)
class Sag(Displayed):
    actors: tuple[Actor, ...] = ()
    goals: tuple[Goal, ...] = ()
