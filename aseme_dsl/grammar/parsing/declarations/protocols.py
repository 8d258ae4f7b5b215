"""Protocols and their participants, from the objects that textX makes to the tree."""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.diagnostics.problems.syntax import entries as problems
from aseme_dsl.grammar.formulas.expression import read_expression
from aseme_dsl.grammar.formulas.transition import read_busy
from aseme_dsl.grammar.parsing import nodes
from aseme_dsl.grammar.parsing.declarations.control import control
from aseme_dsl.grammar.parsing.declarations.formulas import formula, let, var
from aseme_dsl.grammar.parsing.declarations.pieces import Kinds, Pieces, is_a
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.recovery import BLOCKS
from aseme_dsl.grammar.text.token import Token
from aseme_dsl.source import Span

_ALSO_NAMES = ("given", "result", "plays")
"""Words that begin an entry only before a name and `:` or `.`; so names may be called so, too."""

_COUNTS = {"one": 1, "two": 2, "three": 3}


def aip(pieces: Pieces, node: nodes.Aip) -> tree.Aip:
    """A protocol."""
    words = BLOCKS["JunkAip"].words
    kinds = Kinds(node.entries)
    return tree.Aip(
        pieces.new_name(node.name, "protocol"),
        pieces.all(_participant, kinds.of(nodes.Participant)),
        tuple(
            tree.Outcome(pieces.text(entry.text), _places(pieces, entry.when) if entry.when else ())
            for entry in kinds.of(nodes.Outcome)
        ),
        pieces.all(lambda pieces, entry: let(pieces, entry, words), kinds.of(nodes.Let)),
        pieces.all(_clause, kinds.of(nodes.Clause)),
        pieces.all(control, kinds.of(nodes.Control)),
        pieces.span(node),
    )


def _participant(pieces: Pieces, node: nodes.Participant) -> tree.Participant:
    words = tuple(word for word in BLOCKS["JunkParticipant"].words if word not in _ALSO_NAMES)
    kinds = Kinds(node.entries)
    helpers = tuple(word for word in words if word != "process")
    return tree.Participant(
        pieces.new_name(node.name, "participant", BLOCKS["JunkAip"].words),
        _multiplicity(pieces, node.least, node.most) if node.least else None,
        tuple(pieces.text(entry.text) for entry in kinds.of(nodes.Engage)),
        pieces.all(lambda pieces, entry: var(pieces, entry, words), kinds.of(nodes.Var)),
        pieces.all(lambda pieces, entry: let(pieces, entry, words), kinds.of(nodes.Let)),
        _sent_messages(pieces, kinds.of(nodes.Sends)),
        _agent_messages(pieces, kinds.of(nodes.Receives)),
        pieces.all(lambda pieces, entry: formula(pieces, entry, helpers), kinds.of(nodes.Process)),
        pieces.span(node),
        pieces.all(_given, kinds.of(nodes.Given)),
        pieces.all(lambda pieces, entry: var(pieces, entry, words), kinds.of(nodes.Result)),
        tuple(plays(pieces, part) for entry in kinds.of(nodes.Plays) for part in entry.parts),
    )


def plays(pieces: Pieces, node: nodes.Part) -> tree.Plays:
    """A participant that a role or another participant plays."""
    return tree.Plays(
        pieces.name(node.protocol),
        pieces.name(node.participant),
        pieces.new_name(node.alias, "participant", ("with",)) if node.alias else None,
        pieces.all(_binding, node.bindings),
        pieces.span(node),
        _busy(pieces, node.busy) if node.busy is not None else None,
    )


def _busy(pieces: Pieces, node: nodes.Busy) -> tree.Busy | None:
    return pieces.tried(lambda: read_busy(pieces.source, node.answer, pieces.span(node)))


def _binding(pieces: Pieces, node: nodes.Binding) -> tree.Binding | None:
    value = pieces.tried(lambda: read_expression(pieces.source, node.tokens))
    if value is None:
        return None
    name = value.segments[0] if isinstance(value, tree.Path) and len(value.segments) == 1 else None
    return tree.Binding(pieces.name(node.abstract), name, None if name else value, pieces.span(node))


def _given(pieces: Pieces, node: nodes.Given) -> tree.Given:
    return tree.Given(pieces.new_name(node.name, "input"), pieces.name(node.type), pieces.span(node))


def _multiplicity(pieces: Pieces, first: Token, last: Token | None) -> tree.Multiplicity | None:
    least = pieces.integer(first)
    most = least
    if last == "*":
        most = None
    elif last:
        most = pieces.integer(last)
        if most is None:
            return None
    if least is None:
        return None
    span = Span(pieces.source, first.start, (last or first).end)
    if most is not None and (most < least or most == 0):
        pieces.report(problems.EmptyMultiplicity(least, most), span)
        return None
    return tree.Multiplicity(least, most, span)


def _sent_messages(pieces: Pieces, entries: Iterable[nodes.Sends]) -> tuple[tree.AgentMessage, ...]:
    found = []
    for item in (item for entry in entries for item in entry.messages):
        performative, message = pieces.name(item.performative), pieces.name(item.message)
        span = performative.span.to(message.span)
        by, repeatedly = pieces.names(item.by), bool(item.repeatedly)
        found.append(tree.AgentMessage(performative, message, span, by, repeatedly))
    return tuple(found)


def _agent_messages(pieces: Pieces, entries: Iterable[nodes.Receives]) -> tuple[tree.AgentMessage, ...]:
    return tuple(
        tree.AgentMessage(pieces.name(item.performative), pieces.name(item.message), pieces.span(item))
        for entry in entries
        for item in entry.messages
    )


def _clause(pieces: Pieces, node: nodes.Clause) -> tree.Clause:
    rule, span = node.rule, pieces.span(node)
    first = _places(pieces, rule.first)
    if is_a(rule, nodes.AtMost):
        count = _COUNTS.get(rule.count) or pieces.integer(rule.count) or 0
        return tree.Clause("at most", first, (), count, None, span)
    if is_a(rule, nodes.LeadsTo):
        within = pieces.duration(rule.within) if rule.within else None
        return tree.Clause("leads to", first, _places(pieces, rule.second), 0, within, span)
    assert is_a(rule, nodes.Before)
    return tree.Clause("before", first, _places(pieces, rule.second), 0, None, span)


def _places(pieces: Pieces, node: nodes.Places) -> tuple[tree.Place, ...]:
    return tuple(
        tree.Place(pieces.name(item.name), pieces.name(item.at) if item.at else None, pieces.span(item))
        for item in node.places
    )
