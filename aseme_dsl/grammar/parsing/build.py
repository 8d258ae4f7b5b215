"""From the objects that textX makes of a file to the tree."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar.parsing.declarations.charts import statechart
from aseme_dsl.grammar.parsing.declarations.deployment import property_, scenario, team
from aseme_dsl.grammar.parsing.declarations.formulas import let
from aseme_dsl.grammar.parsing.declarations.messages import enum, function, message, topic
from aseme_dsl.grammar.parsing.declarations.pieces import Pieces
from aseme_dsl.grammar.parsing.declarations.protocols import aip
from aseme_dsl.grammar.parsing.declarations.requirements import sag, suc
from aseme_dsl.grammar.parsing.declarations.roles import srm
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Source


def build(
    source: Source, file: Any, comments: tuple[tree.Comment, ...]
) -> tuple[tree.File, list[Diagnostic]]:
    """The tree of a file, and what is wrong inside formulas, expressions, numbers and names."""
    pieces = Pieces(source)
    declarations: tuple[tree.Declaration, ...] = pieces.all(_declaration, file.declarations)
    language = pieces.integer_number(file.language) if file.language else None
    return tree.File(source, language, declarations, comments), pieces.diagnostics


def _declaration(pieces: Pieces, node: Any) -> tree.Declaration | None:
    return _MAKES[type(node).__name__](pieces, node)


def _system(pieces: Pieces, node: Any) -> tree.System:
    return tree.System(pieces.new_name(node.name, "system"), pieces.span(node))


def _import(pieces: Pieces, node: Any) -> tree.Import:
    target = pieces.text(node.path) if node.path else pieces.name(node.library)
    return tree.Import(target, pieces.span(node))


_MAKES: Mapping[str, Callable[[Pieces, Any], tree.Declaration | None]] = {
    "System": _system,
    "Import": _import,
    "Let": let,
    "Enum": enum,
    "Message": message,
    "Topic": topic,
    "Function": function,
    "Sag": sag,
    "Suc": suc,
    "Aip": aip,
    "Srm": srm,
    "Statechart": statechart,
    "Team": team,
    "Scenario": scenario,
    "Property": property_,
}
"""What makes a declaration, by its rule of the grammar."""
