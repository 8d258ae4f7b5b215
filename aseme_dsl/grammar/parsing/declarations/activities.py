"""Activities and modules, from the objects that textX makes to the tree."""

from __future__ import annotations

from typing import Any

from aseme_dsl.grammar.formulas.expression import read_path
from aseme_dsl.grammar.parsing.declarations.pieces import Once, Pieces
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span


def activity(pieces: Pieces, node: Any) -> tree.Activity:
    """An activity."""
    uses: tuple[tree.Name, ...] = ()
    durations: dict[str, tree.Duration | None] = {}
    kind: tree.Name | None = None
    ends: tuple[tree.Name, ...] = ()
    reads: list[tree.ActivityRead] = []
    writes: list[tree.Path] = []
    simulated: Span | None = None
    said = Once(pieces)
    for clause in node.clauses:
        match type(clause).__name__:
            case "Every":
                said.check("every", pieces.span(clause))
                durations["every"] = pieces.duration(clause.duration)
            case "Takes":
                said.check("takes", pieces.span(clause))
                durations["takes"] = pieces.duration(clause.duration)
            case "Simulated":
                said.check("simulated", pieces.span(clause))
                simulated = pieces.span(clause)
            case "Within":
                said.check("within", pieces.span(clause))
                durations["within"] = pieces.duration(clause.duration)
            case "Ends":
                ends += pieces.names(clause.outcomes)
            case "As":
                said.check("as", pieces.span(clause))
                kind = pieces.name(clause.kind)
            case "Uses":
                uses += pieces.names(clause.functionalities)
            case "Reads":
                reads += [_read(pieces, item) for item in clause.reads]
            case _:
                writes += [read_path(pieces.source, path) for path in clause.paths]
    return tree.Activity(
        pieces.new_name(node.name, "activity"),
        uses,
        durations.get("every"),
        durations.get("takes"),
        kind,
        tuple(reads),
        tuple(writes),
        pieces.span(node),
        durations.get("within"),
        ends,
        pieces.all(_activity_parameter, getattr(node, "parameters", ())),  # a module has none
        simulated,
    )


def _activity_parameter(pieces: Pieces, node: Any) -> tree.ActivityParameter:
    name = pieces.new_name(node.name, "parameter")
    return tree.ActivityParameter(name, pieces.name(node.type), pieces.span(node))


def module(pieces: Pieces, node: Any) -> tree.Module:
    """A module."""
    target = pieces.text(node.code.target) if node.code else None
    return tree.Module(activity(pieces, node), target, pieces.span(node))


def _read(pieces: Pieces, node: Any) -> tree.ActivityRead:
    history = pieces.duration(node.history) if node.history else None
    return tree.ActivityRead(
        str(node.reach) if node.reach else "on",
        read_path(pieces.source, node.path),
        history,
        pieces.span(node),
    )
