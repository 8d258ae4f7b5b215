"""Clauses: what holds between the participants of a protocol, with every place in it checked."""

from __future__ import annotations

from collections.abc import Mapping

from aseme_dsl.amola.aip import Clause, Outcome
from aseme_dsl.amola.expression import duration_text
from aseme_dsl.amola.liveness import names
from aseme_dsl.compiler.read.blocks import participants_of
from aseme_dsl.compiler.read.damage import Damaged
from aseme_dsl.compiler.read.names import unknown
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.absences import NoParticipantOfClause, NoPlaceOfClause
from aseme_dsl.grammar.text import tree

_NUMBERS = {1: "one", 2: "two", 3: "three"}


def read_clauses(
    written: tree.Aip, is_damaged: Damaged
) -> tuple[tuple[Clause, ...], tuple[Outcome, ...], tuple[Diagnostic, ...]]:
    """The clauses and outcomes of a protocol; E212 for a place that is not its activity, formula or
    participant."""
    places = {item.name.text: _places(item) for item in participants_of(written)}
    sure = not is_damaged(written.span)
    clauses: list[Clause] = []
    found: list[Diagnostic] = []

    def texts(side: tuple[tree.Place, ...]) -> tuple[str, ...]:
        problems = (_problem(written, place, places) for place in side)
        found.extend(problem for problem in problems if problem is not None and sure)
        return tuple(map(_text, side))

    outcomes = tuple(Outcome(item.text.text, texts(item.when)) for item in written.outcomes)
    for item in written.clauses:
        sides = [texts(side) for side in (item.first, item.second)]
        within = item.within.nanoseconds if item.within is not None else None
        text = _clause_text(item.kind, sides[0], sides[1], item.count, within)
        clauses.append(Clause(item.kind, sides[0], sides[1], item.count, within, text, item.span))
    return tuple(clauses), outcomes, tuple(found)


def _places(participant: tree.Participant) -> frozenset[str]:
    """The activities and helper formulas of a participant."""
    own = {item.name.text for item in participant.formulas} - {"process"}
    return frozenset(own.union(node.name for item in participant.formulas for node in names(item.formula)))


def _text(place: tree.Place) -> str:
    return place.name.text if place.at is None else f"{place.name}@{place.at}"


def _problem(written: tree.Aip, place: tree.Place, places: Mapping[str, frozenset[str]]) -> Diagnostic | None:
    if place.at is None:
        if place.name.text in places:
            return None
        owners = [name for name, inside in places.items() if place.name.text in inside]
        return unknown(NoParticipantOfClause, place.name, places, written.name.text, tuple(owners))
    if place.at.text not in places:
        return unknown(NoParticipantOfClause, place.at, places, written.name.text)
    inside = places[place.at.text]
    if place.name.text in inside:
        return None
    owners = [name for name, others in places.items() if place.name.text in others]
    return unknown(NoPlaceOfClause, place.name, inside, place.at.text, tuple(owners))


def _clause_text(
    kind: str, first: tuple[str, ...], second: tuple[str, ...], count: int, within: int | None
) -> str:
    def side(places: tuple[str, ...]) -> str:
        return places[0] if len(places) == 1 else f"({' or '.join(places)})"

    match kind:
        case "at most":
            return f"at most {_NUMBERS.get(count, str(count))} {side(first)}"
        case "before":
            return f"{side(first)} before {side(second)}"
    limit = f" within {duration_text(within)}" if within is not None else ""
    return f"every {side(first)} leads to {side(second)}{limit}"


__all__ = ["read_clauses"]
