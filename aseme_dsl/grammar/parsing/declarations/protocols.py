"""Protocols and their participants, from the objects that textX makes to the tree."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from aseme_dsl.diagnostics.problems.syntax import entries as problems
from aseme_dsl.grammar.parsing.declarations.control import control
from aseme_dsl.grammar.parsing.declarations.formulas import formula, let, var
from aseme_dsl.grammar.parsing.declarations.pieces import Pieces, by_kind
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.recovery import BLOCKS
from aseme_dsl.source import Span

_ALSO_NAMES = ("given", "result")
"""Words that begin an entry only before a name and `:`; so names may be called so, too."""

_COUNTS = {"one": 1, "two": 2, "three": 3}


def aip(pieces: Pieces, node: Any) -> tree.Aip:
    """A protocol."""
    words = BLOCKS["JunkAip"].words
    kinds = by_kind(node.entries)
    return tree.Aip(
        pieces.new_name(node.name, "protocol"),
        pieces.all(_participant, kinds["Participant"]),
        tuple(pieces.text(entry.text) for entry in kinds["Outcome"]),
        pieces.all(lambda pieces, entry: let(pieces, entry, words), kinds["Let"]),
        pieces.all(_clause, kinds["Clause"]),
        pieces.all(control, kinds["Control"]),
        pieces.span(node),
    )


def _participant(pieces: Pieces, node: Any) -> tree.Participant:
    words = tuple(word for word in BLOCKS["JunkParticipant"].words if word not in _ALSO_NAMES)
    kinds = by_kind(node.entries)
    helpers = tuple(word for word in words if word != "process")
    return tree.Participant(
        pieces.new_name(node.name, "participant", BLOCKS["JunkAip"].words),
        _multiplicity(pieces, node) if node.least else None,
        tuple(pieces.text(entry.text) for entry in kinds["Engage"]),
        pieces.all(lambda pieces, entry: var(pieces, entry, words), kinds["Var"]),
        pieces.all(lambda pieces, entry: let(pieces, entry, words), kinds["Let"]),
        _sent_messages(pieces, kinds["Sends"]),
        _agent_messages(pieces, kinds["Receives"]),
        pieces.all(lambda pieces, entry: formula(pieces, entry, helpers), kinds["Process"]),
        pieces.span(node),
        pieces.all(_given, kinds["Given"]),
        pieces.all(lambda pieces, entry: var(pieces, entry, words), kinds["Result"]),
    )


def _given(pieces: Pieces, node: Any) -> tree.Given:
    return tree.Given(pieces.new_name(node.name, "input"), pieces.name(node.type), pieces.span(node))


def _multiplicity(pieces: Pieces, node: Any) -> tree.Multiplicity | None:
    least = pieces.integer(node.least)
    most = least
    if node.most == "*":
        most = None
    elif node.most:
        most = pieces.integer(node.most)
        if most is None:
            return None
    if least is None:
        return None
    end = node.most or node.least
    span = Span(pieces.source, node.least.start, end.end)
    if most is not None and (most < least or most == 0):
        pieces.report(problems.EmptyMultiplicity(least, most), span)
        return None
    return tree.Multiplicity(least, most, span)


def _sent_messages(pieces: Pieces, entries: Iterable[Any]) -> tuple[tree.AgentMessage, ...]:
    found = []
    for item in (item for entry in entries for item in entry.messages):
        performative, message = pieces.name(item.performative), pieces.name(item.message)
        span = performative.span.to(message.span)
        by, repeatedly = pieces.names(item.by), bool(item.repeatedly)
        found.append(tree.AgentMessage(performative, message, span, by, repeatedly))
    return tuple(found)


def _agent_messages(pieces: Pieces, entries: Iterable[Any]) -> tuple[tree.AgentMessage, ...]:
    return tuple(
        tree.AgentMessage(pieces.name(item.performative), pieces.name(item.message), pieces.span(item))
        for entry in entries
        for item in entry.messages
    )


def _clause(pieces: Pieces, node: Any) -> tree.Clause:
    rule, span = node.rule, pieces.span(node)
    match type(rule).__name__:
        case "AtMost":
            count = _COUNTS.get(rule.count) or pieces.integer(rule.count) or 0
            return tree.Clause("at most", _places(pieces, rule.first), (), count, None, span)
        case "LeadsTo":
            within = pieces.duration(rule.within) if rule.within else None
            return tree.Clause(
                "leads to", _places(pieces, rule.first), _places(pieces, rule.second), 0, within, span
            )
        case _:
            return tree.Clause(
                "before", _places(pieces, rule.first), _places(pieces, rule.second), 0, None, span
            )


def _places(pieces: Pieces, node: Any) -> tuple[tree.Place, ...]:
    return tuple(
        tree.Place(pieces.name(item.name), pieces.name(item.at) if item.at else None, pieces.span(item))
        for item in node.places
    )
