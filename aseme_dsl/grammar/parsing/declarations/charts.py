"""Statecharts that are written as such, from the objects that textX makes to the tree."""

from __future__ import annotations

from typing import Any

from aseme_dsl.grammar.parsing.declarations.activities import activity, module
from aseme_dsl.grammar.parsing.declarations.control import labelled_way, transition
from aseme_dsl.grammar.parsing.declarations.formulas import let, var
from aseme_dsl.grammar.parsing.declarations.pieces import Pieces, by_kind
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.recovery import BLOCKS

_CHART_WAYS = ("LabelledWay", "StandingWay")
"""The transitions of a `statechart`; their order counts."""


def statechart(pieces: Pieces, node: Any) -> tree.Statechart:
    """A statechart that is written as such."""
    words = BLOCKS["JunkChart"].words
    kinds = by_kind(node.entries)
    return tree.Statechart(
        pieces.new_name(node.name, "statechart"),
        pieces.all(lambda pieces, entry: var(pieces, entry, words), kinds["Var"]),
        pieces.all(lambda pieces, entry: let(pieces, entry, words), kinds["Let"]),
        pieces.all(_chart_node, kinds["ChartNode"]),
        pieces.all(_chart_way, (entry for entry in node.entries if type(entry).__name__ in _CHART_WAYS)),
        pieces.all(activity, (item for entry in kinds["Activities"] for item in entry.activities)),
        pieces.all(module, (item for entry in kinds["Modules"] for item in entry.modules)),
        pieces.span(node),
    )


def _chart_way(pieces: Pieces, node: Any) -> tree.LabelledWay | tree.StandingWay | None:
    if type(node).__name__ == "LabelledWay":
        return labelled_way(pieces, node)
    expression = transition(pieces, node)
    if expression is None:
        return None
    return tree.StandingWay(pieces.name(node.verb), pieces.name(node.state), expression, pieces.span(node))


def _chart_node(pieces: Pieces, node: Any) -> tree.ChartNode:
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
