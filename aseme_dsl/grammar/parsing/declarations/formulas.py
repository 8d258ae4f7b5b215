"""Formulas, named expressions and variables, from the objects that textX makes to the tree."""

from __future__ import annotations

from collections.abc import Sequence

from aseme_dsl.amola.liveness import Formula, walk
from aseme_dsl.amola.operators import USUAL
from aseme_dsl.diagnostics.problems.syntax import entries as problems
from aseme_dsl.grammar.formulas.expression import read_expression
from aseme_dsl.grammar.formulas.formula import read_formula
from aseme_dsl.grammar.parsing import nodes
from aseme_dsl.grammar.parsing.declarations.pieces import Pieces, is_a
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.lexer import HOLE, PLACEHOLDER
from aseme_dsl.grammar.text.token import Token
from aseme_dsl.source import Span


def let(pieces: Pieces, node: nodes.Let, words: Sequence[str] = ()) -> tree.Let | None:
    """A named expression; none of `words` can be its name."""
    name = pieces.checked_name(node.name, "let", words)
    expression = pieces.tried(lambda: read_expression(pieces.source, node.tokens))
    return tree.Let(name, expression, pieces.span(node)) if expression is not None else None


def var(pieces: Pieces, node: nodes.Var | nodes.Result, words: Sequence[str] = ()) -> tree.Var:
    """A variable; none of `words` can be its name."""
    name = pieces.checked_name(node.name, "variable", words)
    initial = pieces.tried(lambda: read_expression(pieces.source, node.tokens)) if node.tokens else None
    bounds = _bounds(pieces, node.least, node.most) if node.least and node.most else None
    if is_a(node, nodes.Var) and node.element:
        length = pieces.integer_number(node.length) if node.length else None
        element = pieces.name(node.element)
        return tree.Var(name, element, initial, pieces.span(node), bounds, is_list=True, length=length)
    assert node.type is not None
    return tree.Var(name, pieces.name(node.type), initial, pieces.span(node), bounds)


def _bounds(pieces: Pieces, least: Token, most: Token) -> tree.VarBounds | None:
    first, last = pieces.signed(least), pieces.signed(most)
    if first is None or last is None:
        return None
    return tree.VarBounds(first, last, Span(pieces.source, least.start, most.end))


def formula(
    pieces: Pieces, node: nodes.Formula | nodes.Process, words: Sequence[str] = ()
) -> tree.NamedFormula | None:
    """A named formula; none of `words` can be its name."""
    name = pieces.new_name(node.name, "formula", words)
    written = pieces.tried(lambda: read_formula(pieces.source, node.tokens))
    parameters = pieces.all(_formula_parameter, node.parameters)
    if written is None:
        return None
    _report_holes(pieces, node.tokens, written)
    return tree.NamedFormula(name, written, pieces.span(node), parameters)


def _report_holes(pieces: Pieces, tokens: Sequence[Token], written: Formula) -> None:
    """E109 for each operator of a formula that is still to be chosen; in an argument `c ? a : b` chooses."""
    holes = [token for token in tokens if token == HOLE]
    given = [argument.span for part in walk(written) for argument in part.arguments] if holes else []
    for token in holes:
        if not any(span.start <= token.start < span.end for span in given):
            named = PLACEHOLDER.match(pieces.source.text, token.start)
            end = named.end() if named is not None else token.end
            usual = tuple((item.value, item.row.meaning) for item in USUAL)
            pieces.report(problems.OperatorToChoose(usual), Span(pieces.source, token.start, end))


def _formula_parameter(pieces: Pieces, node: nodes.FormulaParameter) -> tree.FormulaParameter:
    name = pieces.new_name(node.name, "parameter")
    return tree.FormulaParameter(name, pieces.name(node.type) if node.type else None, pieces.span(node))
