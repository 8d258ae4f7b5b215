"""Goals, use cases and their actors, from the objects that textX makes to the tree."""

from __future__ import annotations

from aseme_dsl.grammar.parsing import nodes
from aseme_dsl.grammar.parsing.declarations.pieces import Kinds, Once, Pieces, is_a
from aseme_dsl.grammar.text import tree


def sag(pieces: Pieces, node: nodes.Sag) -> tree.Sag:
    """The goals of actors."""
    return tree.Sag(pieces.all(_actor, node.actors), pieces.span(node))


def _actor(pieces: Pieces, node: nodes.Actor) -> tree.Actor:
    return tree.Actor(
        pieces.new_name(node.name, "actor", ("actor", "goal")),
        pieces.all(_goal, node.goals),
        pieces.span(node),
    )


def _goal(pieces: Pieces, node: nodes.Goal) -> tree.Goal:
    depends: tuple[tree.Name, ...] = ()
    requirements: tree.Text | None = None
    said = Once(pieces)
    for clause in node.clauses:
        if is_a(clause, nodes.Depends):
            said.check("depends on", pieces.span(clause))
            depends = pieces.names(clause.actors)
        elif is_a(clause, nodes.Requirements):
            said.check(None, pieces.span(clause))
            requirements = pieces.text(clause.text)
    return tree.Goal(
        pieces.new_name(node.name, "goal", ("goal", "depends")), depends, requirements, pieces.span(node)
    )


def suc(pieces: Pieces, node: nodes.Suc) -> tree.Suc:
    """Use cases and the roles that take part."""
    kinds = Kinds(node.entries)
    roles = pieces.all(_roles, kinds.of(nodes.Roles))
    return tree.Suc(roles, pieces.all(_usecase, kinds.of(nodes.UseCase)), pieces.span(node))


def _roles(pieces: Pieces, node: nodes.Roles) -> tree.Roles:
    type_ = pieces.name(node.type) if node.type else None
    return tree.Roles(
        tuple(pieces.new_name(text, "role", ("role", "usecase")) for text in node.names),
        type_,
        pieces.span(node),
    )


def _usecase(pieces: Pieces, node: nodes.UseCase) -> tree.UseCase:
    lists: dict[str, tuple[tree.Name, ...]] = {}
    requirements: tree.Text | None = None
    said = Once(pieces)
    for clause in node.clauses:
        if is_a(clause, nodes.By):
            said.check("by", pieces.span(clause))
            lists["by"] = pieces.names(clause.roles)
        elif is_a(clause, nodes.Includes):
            said.check("includes", pieces.span(clause))
            lists["includes"] = pieces.names(clause.usecases)
        elif is_a(clause, nodes.Realises):
            said.check("realises", pieces.span(clause))
            lists["realises"] = pieces.names(clause.names)
        elif is_a(clause, nodes.Requirements):
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
