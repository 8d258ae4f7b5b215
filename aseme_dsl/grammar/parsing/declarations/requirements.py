"""Goals, use cases and their actors, from the objects that textX makes to the tree."""

from __future__ import annotations

from typing import Any

from aseme_dsl.grammar.parsing.declarations.pieces import Once, Pieces
from aseme_dsl.grammar.text import tree


def sag(pieces: Pieces, node: Any) -> tree.Sag:
    """The goals of actors."""
    return tree.Sag(pieces.all(_actor, node.actors), pieces.span(node))


def _actor(pieces: Pieces, node: Any) -> tree.Actor:
    return tree.Actor(
        pieces.new_name(node.name, "actor", ("actor", "goal")),
        pieces.all(_goal, node.goals),
        pieces.span(node),
    )


def _goal(pieces: Pieces, node: Any) -> tree.Goal:
    depends: tuple[tree.Name, ...] = ()
    requirements: tree.Text | None = None
    said = Once(pieces)
    for clause in node.clauses:
        if type(clause).__name__ == "Depends":
            said.check("depends on", pieces.span(clause))
            depends = pieces.names(clause.actors)
        else:
            said.check(None, pieces.span(clause))
            requirements = pieces.text(clause.text)
    return tree.Goal(
        pieces.new_name(node.name, "goal", ("goal", "depends")), depends, requirements, pieces.span(node)
    )


def suc(pieces: Pieces, node: Any) -> tree.Suc:
    """Use cases and the roles that take part."""
    entries = [entry for entry in node.entries if not isinstance(entry, str)]
    roles = pieces.all(_roles, (entry for entry in entries if type(entry).__name__ == "Roles"))
    usecases = pieces.all(_usecase, (entry for entry in entries if type(entry).__name__ == "UseCase"))
    return tree.Suc(roles, usecases, pieces.span(node))


def _roles(pieces: Pieces, node: Any) -> tree.Roles:
    type_ = pieces.name(node.type) if node.type else None
    return tree.Roles(
        tuple(pieces.new_name(text, "role", ("role", "usecase")) for text in node.names),
        type_,
        pieces.span(node),
    )


def _usecase(pieces: Pieces, node: Any) -> tree.UseCase:
    lists: dict[str, tuple[tree.Name, ...]] = {}
    requirements: tree.Text | None = None
    said = Once(pieces)
    for clause in node.clauses:
        match type(clause).__name__:
            case "By":
                said.check("by", pieces.span(clause))
                lists["by"] = pieces.names(clause.roles)
            case "Includes":
                said.check("includes", pieces.span(clause))
                lists["includes"] = pieces.names(clause.usecases)
            case "Realises":
                said.check("realises", pieces.span(clause))
                lists["realises"] = pieces.names(clause.names)
            case _:
                said.check(None, pieces.span(clause))
                requirements = pieces.text(clause.text)
    return tree.UseCase(
        pieces.new_name(node.name, "use case", ("role", "usecase", "by", "includes", "realises")),
        lists.get("by", ()),
        lists.get("includes", ()),
        lists.get("realises", ()),
        requirements,
        pieces.span(node),
    )
