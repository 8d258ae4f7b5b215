"""Roles: capabilities, functionalities and what they play, from the objects that textX makes to the tree."""

from __future__ import annotations

from aseme_dsl.grammar.parsing import nodes
from aseme_dsl.grammar.parsing.declarations.activities import activity, module
from aseme_dsl.grammar.parsing.declarations.control import control
from aseme_dsl.grammar.parsing.declarations.formulas import formula, let, var
from aseme_dsl.grammar.parsing.declarations.pieces import Kinds, Once, Pieces
from aseme_dsl.grammar.parsing.declarations.protocols import plays
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.recovery import BLOCKS


def srm(pieces: Pieces, node: nodes.Srm) -> tree.Srm:
    """A role."""
    words = BLOCKS["JunkSrm"].words
    kinds = Kinds(node.entries)
    return tree.Srm(
        pieces.new_name(node.name, "role"),
        tuple(plays(pieces, part) for entry in kinds.of(nodes.Plays) for part in entry.parts),
        pieces.all(_capability, kinds.of(nodes.Capability)),
        pieces.all(lambda pieces, entry: var(pieces, entry, words), kinds.of(nodes.Var)),
        pieces.all(lambda pieces, entry: let(pieces, entry, words), kinds.of(nodes.Let)),
        pieces.all(formula, (formula for entry in kinds.of(nodes.Liveness) for formula in entry.formulas)),
        pieces.all(activity, (item for entry in kinds.of(nodes.Activities) for item in entry.activities)),
        pieces.all(module, (item for entry in kinds.of(nodes.Modules) for item in entry.modules)),
        pieces.all(_functionality, kinds.of(nodes.Functionality)),
        pieces.all(control, kinds.of(nodes.Control)),
        pieces.span(node),
        tuple(pieces.name(role) for entry in kinds.of(nodes.Inclusion) for role in entry.roles),
        bool(node.abstract),
    )


def _capability(pieces: Pieces, node: nodes.Capability) -> tree.Capability:
    description = pieces.text(node.description) if node.description else None
    return tree.Capability(
        pieces.new_name(node.name, "capability"),
        description,
        pieces.names(node.activities),
        pieces.span(node),
    )


def _functionality(pieces: Pieces, node: nodes.Functionality) -> tree.Functionality:
    texts: dict[str, tree.Text] = {}
    said = Once(pieces)
    for entry in node.entries:
        if not isinstance(entry, str):
            said.check(str(entry.kind), pieces.span(entry))
            texts[str(entry.kind)] = pieces.text(entry.text)
    return tree.Functionality(
        pieces.new_name(node.name, "functionality"),
        texts.get("technology"),
        texts.get("permissions"),
        texts.get("environment"),
        texts.get("algorithm"),
        pieces.span(node),
    )
