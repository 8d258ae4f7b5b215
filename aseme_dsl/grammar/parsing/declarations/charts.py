"""Statecharts that are written as such, from the objects that textX makes to the tree."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.grammar.parsing import nodes
from aseme_dsl.grammar.parsing.declarations.activities import activity, module
from aseme_dsl.grammar.parsing.declarations.control import labelled_way, transition
from aseme_dsl.grammar.parsing.declarations.formulas import let, var
from aseme_dsl.grammar.parsing.declarations.pieces import Kinds, Pieces, is_a
from aseme_dsl.grammar.parsing.nodes import Node
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.recovery import BLOCKS


def statechart(pieces: Pieces, node: nodes.Statechart) -> tree.Statechart:
    """A statechart that is written as such."""
    words = BLOCKS["JunkChart"].words
    kinds = Kinds(node.entries)
    return tree.Statechart(
        pieces.new_name(node.name, "statechart"),
        pieces.all(lambda pieces, entry: var(pieces, entry, words), kinds.of(nodes.Var)),
        pieces.all(lambda pieces, entry: let(pieces, entry, words), kinds.of(nodes.Let)),
        pieces.all(_chart_node, kinds.of(nodes.ChartNode)),
        pieces.all(_chart_way, _chart_ways(node)),
        pieces.all(activity, (item for entry in kinds.of(nodes.Activities) for item in entry.activities)),
        pieces.all(module, (item for entry in kinds.of(nodes.Modules) for item in entry.modules)),
        pieces.span(node),
    )


def _chart_ways(node: nodes.Statechart) -> Iterator[Node]:
    """The transitions of a `statechart`; their order counts."""
    for entry in node.entries:
        if isinstance(entry, str):
            continue
        if is_a(entry, nodes.LabelledWay) or is_a(entry, nodes.StandingWay):
            yield entry


def _chart_way(pieces: Pieces, node: Node) -> tree.LabelledWay | tree.StandingWay | None:
    if is_a(node, nodes.LabelledWay):
        return labelled_way(pieces, node)
    assert is_a(node, nodes.StandingWay)
    expression = transition(pieces, node)
    if expression is None:
        return None
    return tree.StandingWay(pieces.name(node.verb), pieces.name(node.state), expression, pieces.span(node))


def _chart_node(pieces: Pieces, node: nodes.ChartNode) -> tree.ChartNode:
    name: tree.Name | tree.Text | None = None
    if node.name:
        name = pieces.text(node.name) if node.name[0] == '"' else pieces.name(node.name)
    return tree.ChartNode(
        pieces.name(node.label),
        pieces.name(node.type),
        name,
        pieces.name(node.activity) if node.activity else None,
        pieces.span(node),
    )
