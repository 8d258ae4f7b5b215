"""From the objects that textX makes of a file to the tree."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TypeVar

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar.parsing import nodes
from aseme_dsl.grammar.parsing.declarations.charts import statechart
from aseme_dsl.grammar.parsing.declarations.deployment import property_, scenario, team
from aseme_dsl.grammar.parsing.declarations.formulas import let
from aseme_dsl.grammar.parsing.declarations.messages import enum, function, message, topic
from aseme_dsl.grammar.parsing.declarations.pieces import Pieces, is_a
from aseme_dsl.grammar.parsing.declarations.protocols import aip
from aseme_dsl.grammar.parsing.declarations.requirements import sag, suc
from aseme_dsl.grammar.parsing.declarations.roles import srm
from aseme_dsl.grammar.parsing.nodes import Node
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Source

_N = TypeVar("_N", bound=Node)


def build(
    source: Source, file: nodes.File, comments: tuple[tree.Comment, ...]
) -> tuple[tree.File, list[Diagnostic]]:
    """The tree of a file, and what is wrong inside formulas, expressions, numbers and names."""
    pieces = Pieces(source)
    declarations: tuple[tree.Declaration, ...] = pieces.all(_declaration, file.declarations)
    language = pieces.integer_number(file.language) if file.language else None
    return tree.File(source, language, declarations, comments), pieces.diagnostics


def _declaration(pieces: Pieces, node: Node) -> tree.Declaration | None:
    return _MAKES[type(node).__name__](pieces, node)


def _system(pieces: Pieces, node: nodes.System) -> tree.System:
    return tree.System(pieces.new_name(node.name, "system"), pieces.span(node))


def _import(pieces: Pieces, node: nodes.Import) -> tree.Import:
    if node.path:
        alias = pieces.new_name(node.alias, "alias") if node.alias else None
        return tree.Import(pieces.text(node.path), pieces.span(node), alias)
    assert node.library is not None  # the grammar has one or the other
    return tree.Import(pieces.name(node.library), pieces.span(node))


def _of(
    kind: type[_N], make: Callable[[Pieces, _N], tree.Declaration | None]
) -> tuple[str, Callable[[Pieces, Node], tree.Declaration | None]]:
    def made(pieces: Pieces, node: Node) -> tree.Declaration | None:
        assert is_a(node, kind)
        return make(pieces, node)

    return kind.__name__, made


_MAKES: Mapping[str, Callable[[Pieces, Node], tree.Declaration | None]] = dict(
    (
        _of(nodes.System, _system),
        _of(nodes.Import, _import),
        _of(nodes.Let, let),
        _of(nodes.Enum, enum),
        _of(nodes.Message, message),
        _of(nodes.Topic, topic),
        _of(nodes.Function, function),
        _of(nodes.Sag, sag),
        _of(nodes.Suc, suc),
        _of(nodes.Aip, aip),
        _of(nodes.Srm, srm),
        _of(nodes.Statechart, statechart),
        _of(nodes.Team, team),
        _of(nodes.Scenario, scenario),
        _of(nodes.Property, property_),
    )
)
"""What makes a declaration, by its rule of the grammar."""
