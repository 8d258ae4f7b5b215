"""Teams, scenarios and properties, from the objects that textX makes to the tree."""

from __future__ import annotations

import re

from aseme_dsl.diagnostics.problems.syntax import entries as problems
from aseme_dsl.diagnostics.problems.syntax.entries import Wanted
from aseme_dsl.diagnostics.problems.syntax.formulas import AgentsBehindQuestion
from aseme_dsl.grammar.formulas.expression import read_expression
from aseme_dsl.grammar.parsing import nodes
from aseme_dsl.grammar.parsing.declarations.pieces import Pieces
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.token import Token
from aseme_dsl.source import Span

_BEGUN = re.compile(r"\s*([A-Za-z_]\w*)\s*:")
"""What begins the next agents."""


def team(pieces: Pieces, node: nodes.Team) -> tree.Team:
    """A team."""
    return tree.Team(pieces.new_name(node.name, "team"), pieces.all(_agents, node.entries), pieces.span(node))


def _agents(pieces: Pieces, node: nodes.Agents) -> tree.TeamAgents:
    names = tuple(
        (pieces.new_name(item.name, "agent"), _agent_range(pieces, item.least, item.most))
        for item in node.names
    )
    settings = pieces.all(_setting, node.settings)
    return tree.TeamAgents(names, pieces.name(node.role), pieces.span(node), settings)


def _setting(pieces: Pieces, node: nodes.Setting) -> tree.Setting | None:
    last = node.tokens[-1]
    begun = _BEGUN.match(pieces.source.text, last.end) if last == "?" else None
    if begun is not None:
        span = Span(pieces.source, begun.start(1), begun.end(1))
        fix = f"({begun[1]})"
        pieces.report(AgentsBehindQuestion((Wanted.VALUE,), last, begun[1], name=begun[1]), span, fix=fix)
        return None
    value = pieces.tried(lambda: read_expression(pieces.source, node.tokens))
    return tree.Setting(pieces.name(node.name), value, pieces.span(node)) if value is not None else None


def _agent_range(pieces: Pieces, first: Token | None, last: Token | None) -> tuple[int, int] | None:
    if not first or not last:
        return None
    least, most = pieces.integer(first), pieces.integer(last)
    if least is None or most is None:
        return None
    if most < least:
        span = Span(pieces.source, first.start, last.end)
        pieces.report(problems.EmptyRange(least, most), span, fix=f"{most}..{least}")
        return None
    return least, most


def scenario(pieces: Pieces, node: nodes.Scenario) -> tree.Scenario:
    """A scenario, as its statements."""
    statements: list[list[tree.Name]] = []
    depth = 0
    for name, first_on_line in _body_tokens(pieces, node):
        begins = depth == 0 and first_on_line and (name.text[0].isalpha() or name.text[0] == "_")
        if begins or not statements:
            statements.append([])
        statements[-1].append(name)
        depth += (name.text in ("{", "(", "[")) - (name.text in ("}", ")", "]"))
    return tree.Scenario(pieces.text(node.title), tuple(map(tuple, statements)), pieces.span(node))


def property_(pieces: Pieces, node: nodes.Property) -> tree.Property:
    """A property, as its words."""
    return tree.Property(
        pieces.text(node.title), tuple(name for name, _ in _body_tokens(pieces, node)), pieces.span(node)
    )


def _body_tokens(pieces: Pieces, node: nodes.Scenario | nodes.Property) -> list[tuple[tree.Name, bool]]:
    """The tokens between the braces, and whether each is the first on its line."""
    found: list[tuple[tree.Name, bool]] = []
    text = pieces.source.text
    todo: list[nodes.Token | nodes.Token2 | nodes.Token3] = list(reversed(node.tokens))
    end = node.title.end
    while todo:
        item = todo.pop()
        if not isinstance(item, Token):
            todo += [item.close, *reversed(item.tokens), item.open]
            continue
        found.append((tree.Name(str(item), pieces.spot(item)), "\n" in text[end : item.start]))
        end = item.end
    return found
