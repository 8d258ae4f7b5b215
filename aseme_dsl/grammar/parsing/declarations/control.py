"""Control: which transition expressions stand where, from the objects that textX makes to the tree."""

from __future__ import annotations

from dataclasses import replace

from aseme_dsl.diagnostics.problems.syntax import entries as problems
from aseme_dsl.grammar.formulas.formula import read_formula
from aseme_dsl.grammar.formulas.transition import read_transition
from aseme_dsl.grammar.parsing import nodes
from aseme_dsl.grammar.parsing.declarations.pieces import Pieces, is_a
from aseme_dsl.grammar.parsing.nodes import Node
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span


def control(pieces: Pieces, node: nodes.Control) -> tree.Control:
    """A `control` block."""
    reactive = pieces.name(node.reactive).span if node.reactive else None
    return tree.Control(
        pieces.name(node.name),
        pieces.all(_control_entry, node.entries),
        pieces.span(node),
        reactive,
        node.first is not None and bool(node.first),
    )


def _control_entry(pieces: Pieces, node: Node) -> tree.Way | tree.LabelledWay | None:
    if is_a(node, nodes.Way):
        return _way(pieces, node)
    assert is_a(node, nodes.LabelledWay)
    return labelled_way(pieces, node)


def _way(pieces: Pieces, node: nodes.Way) -> tree.Way | None:
    formula = pieces.tried(lambda: read_formula(pieces.source, node.term))
    expression = transition(pieces, node) if formula is not None else None
    if formula is None or expression is None:
        return None
    if node.every:
        expression = replace(expression, every=pieces.duration(node.every))
    span = formula.span
    occurrence = None
    if node.occurrence:
        occurrence = pieces.integer(node.occurrence)
        span = Span(pieces.source, span.start, node.occurrence.end)
    return tree.Way(
        tree.Name(str(node.verb), pieces.spot(node.verb)),
        tree.Term(formula, occurrence, span),
        expression,
        pieces.span(node),
    )


def labelled_way(pieces: Pieces, node: nodes.LabelledWay) -> tree.LabelledWay | None:
    """A line with the labels of its ends; None if its expression is malformed."""
    expression = transition(pieces, node)
    if expression is None:
        return None
    targets = tuple(map(pieces.name, [node.target] if node.target else node.targets))
    return tree.LabelledWay(pieces.name(node.source), targets, expression, pieces.span(node))


def transition(
    pieces: Pieces, node: nodes.Way | nodes.LabelledWay | nodes.StandingWay
) -> tree.TransitionExpression | None:
    """A transition expression; None if it is malformed."""
    end = pieces.span(node).end
    place = Span(pieces.source, end - 1, end)
    written = pieces.tried(lambda: read_transition(pieces.source, node.tokens, place))
    if written is not None and isinstance(written.condition, tree.Hole):
        pieces.report(problems.ConditionToWrite(), written.condition.span)
    return written
