"""Activities and modules, from the objects that textX makes to the tree."""

from __future__ import annotations

from collections.abc import Iterator

from aseme_dsl.grammar.formulas.expression import read_expression, read_path
from aseme_dsl.grammar.parsing import nodes
from aseme_dsl.grammar.parsing.declarations.pieces import Once, Pieces, is_a
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Span


def activity(pieces: Pieces, node: nodes.Activity | nodes.Module) -> tree.Activity:
    """An activity."""
    uses: tuple[tree.Name, ...] = ()
    durations: dict[str, tree.Duration | None] = {}
    kind: tree.Name | None = None
    ends: tuple[tree.Name, ...] = ()
    reads: list[tree.ActivityRead] = []
    writes: list[tree.Path] = []
    simulated: Span | None = None
    waits: Span | None = None
    guarantees: list[tree.Guarantee] = []
    said = Once(pieces)
    for clause in node.clauses:
        if is_a(clause, nodes.Every):
            said.check("every", pieces.span(clause))
            durations["every"] = pieces.duration(clause.duration)
        elif is_a(clause, nodes.Takes):
            said.check("takes", pieces.span(clause))
            durations["takes"] = pieces.duration(clause.duration)
        elif is_a(clause, nodes.Simulated):
            said.check("simulated", pieces.span(clause))
            simulated = pieces.span(clause)
        elif is_a(clause, nodes.Waits):
            said.check("waits", pieces.span(clause))
            waits = pieces.span(clause)
        elif is_a(clause, nodes.Within):
            said.check("within", pieces.span(clause))
            durations["within"] = pieces.duration(clause.duration)
        elif is_a(clause, nodes.Ends):
            ends += pieces.names(clause.outcomes)
        elif is_a(clause, nodes.As):
            said.check("as", pieces.span(clause))
            kind = pieces.name(clause.kind)
        elif is_a(clause, nodes.Uses):
            uses += pieces.names(clause.functionalities)
        elif is_a(clause, nodes.Reads):
            reads += [_read(pieces, item) for item in clause.reads]
        elif is_a(clause, nodes.Writes):
            writes += [read_path(pieces.source, path) for path in clause.paths]
        elif is_a(clause, nodes.Guarantees):
            guarantees += _guarantee(pieces, clause)
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
        pieces.all(_activity_parameter, node.parameters if is_a(node, nodes.Activity) else ()),
        simulated,
        waits,
        tuple(guarantees),
    )


def _guarantee(pieces: Pieces, node: nodes.Guarantees) -> Iterator[tree.Guarantee]:
    """What an activity guarantees, if it can be read."""
    said = _sent(pieces, node.said)
    limit = pieces.duration(node.limit) if node.limit else None
    earlier = _sent(pieces, node.earlier) if node.earlier else None
    if said is None or (node.limit and limit is None) or (node.earlier and earlier is None):
        return
    yield tree.Guarantee(said, limit, earlier, pieces.span(node))


def _sent(pieces: Pieces, node: nodes.Sent) -> tree.Sent | None:
    condition = None
    if node.tokens:
        condition = pieces.tried(lambda: read_expression(pieces.source, node.tokens))
        if condition is None:
            return None
    called = pieces.new_name(node.called, "message")
    return tree.Sent(read_path(pieces.source, node.message), called, condition, pieces.span(node))


def _activity_parameter(pieces: Pieces, node: nodes.ActivityParameter) -> tree.ActivityParameter:
    name = pieces.new_name(node.name, "parameter")
    return tree.ActivityParameter(name, pieces.name(node.type), pieces.span(node))


def module(pieces: Pieces, node: nodes.Module) -> tree.Module:
    """A module."""
    target = pieces.text(node.code.target) if node.code else None
    return tree.Module(activity(pieces, node), target, pieces.span(node))


def _read(pieces: Pieces, node: nodes.Read) -> tree.ActivityRead:
    history = pieces.duration(node.history) if node.history else None
    return tree.ActivityRead(
        str(node.reach) if node.reach else "on",
        read_path(pieces.source, node.path),
        history,
        pieces.span(node),
    )
