"""Messages, topics and functions, from the objects that textX makes to the tree."""

from __future__ import annotations

from aseme_dsl.grammar.parsing import nodes
from aseme_dsl.grammar.parsing.declarations.pieces import Once, Pieces, is_a
from aseme_dsl.grammar.text import tree

COMM_TYPES = ("signal", "state", "data")


def enum(pieces: Pieces, node: nodes.Enum) -> tree.Enum:
    """An enumeration."""
    name = pieces.name(node.name)
    return tree.Enum(name, pieces.all(_constant, node.constants), pieces.span(node))


def _constant(pieces: Pieces, entry: nodes.EnumConstant) -> tree.EnumConstant:
    number = pieces.integer(entry.number) if entry.number else None
    return tree.EnumConstant(pieces.name(entry.name), number, pieces.span(entry))


def message(pieces: Pieces, node: nodes.Message) -> tree.Message:
    """A message type."""
    name = pieces.checked_name(node.name, "message", COMM_TYPES)
    return tree.Message(name, pieces.all(_field, node.fields), pieces.span(node))


def _field(pieces: Pieces, entry: nodes.Field) -> tree.Field:
    number = pieces.integer(entry.number) if entry.number else None
    return tree.Field(
        str(entry.label or ""),
        pieces.name(entry.type),
        pieces.name(entry.name),
        number,
        pieces.span(entry),
    )


def topic(pieces: Pieces, node: nodes.Topic) -> tree.Topic:
    """A topic with its channels."""
    name = pieces.name(node.name)
    under = pieces.name(node.under[0]) if node.under else None
    radio = pieces.integer_number(node.radio[0]) if node.radio else None
    delay = pieces.duration(node.delay[0]) if node.delay else None
    for clause, given in (("under", node.under), ("radio", node.radio), ("delay", node.delay)):
        if len(given) > 1:
            pieces.again(clause, pieces.spot(given[0]), pieces.spot(given[1]))
    return tree.Topic(name, under, radio, delay, pieces.all(_topic_entry, node.entries), pieces.span(node))


def _topic_entry(pieces: Pieces, node: nodes.TopicMessages) -> tree.TopicEntry:
    sources: tuple[tree.Name, ...] = ()
    every: tree.Duration | None = None
    expires: tree.Duration | None = None
    flags: set[str] = set()
    said = Once(pieces)
    for clause in node.clauses:
        if is_a(clause, nodes.TopicFrom):
            said.check("from", pieces.span(clause))
            sources = pieces.names(clause.sources)
        elif is_a(clause, nodes.TopicEvery):
            said.check("every", pieces.span(clause))
            every = pieces.duration(clause.every)
        elif is_a(clause, nodes.TopicExpires):
            said.check("expires", pieces.span(clause))
            expires = pieces.duration(clause.duration)
        elif is_a(clause, nodes.TopicFlag):
            said.check(str(clause.flag), pieces.span(clause))
            flags.add(str(clause.flag))
    return tree.TopicEntry(
        pieces.name(node.comm),
        pieces.names(node.messages),
        sources,
        every,
        "queued" in flags,
        "persist" in flags,
        expires,
        pieces.span(node),
    )


def function(pieces: Pieces, node: nodes.Function) -> tree.Function:
    """A function with its Python code."""
    return tree.Function(
        pieces.name(node.name),
        pieces.all(_parameter, node.parameters),
        pieces.name(node.result),
        pieces.text(node.target),
        pieces.span(node),
    )


def _parameter(pieces: Pieces, entry: nodes.Parameter) -> tree.Parameter:
    return tree.Parameter(
        pieces.name(entry.type), pieces.new_name(entry.name, "parameter"), pieces.span(entry)
    )
