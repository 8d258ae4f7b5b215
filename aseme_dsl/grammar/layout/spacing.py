"""Blanks and places to break in formulas and expressions, which the grammar has as flat lists of tokens."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from aseme_dsl.amola.operators import BRACKETS, INFIX_SIGNS, OTHER_SPELLINGS, POSTFIX, Operator, parts
from aseme_dsl.grammar.layout.pieces import GLUED, Piece

LEVELS = 16
"""How many levels there are to a depth."""

_POSTFIX = {parts(sign)[0]: len(parts(sign)) for sign in POSTFIX}
"""How many tokens a postfix operator has, by its first."""

_SLASH, _CONDITION, _EVENT, _COMMA = 0, 1, 2, 0
_INFIX = (
    {"?": 3, ":": 3, "||": 3, "or": 3, "&&": 4, "and": 4}
    | dict.fromkeys(("<", "<=", ">", ">=", "==", "!="), 5)
    | dict.fromkeys(("+", "-"), 6)
    | dict.fromkeys(("*", "/", "%"), 7)
)
_OPERAND_FOLLOWS = frozenset((*_INFIX, "!", "not", "(", "[", ",", ";", "=", "+=", "-=", "*=", "when", "else"))


def level_of(depth: int, precedence: int) -> int:
    """The level of a place to break: deeper is tighter, and at one depth what binds more tightly."""
    return depth * LEVELS + precedence


def formula(tokens: Sequence[str], depth: int) -> list[Piece]:
    """The pieces of a formula whose first token is at `depth`."""
    pieces: list[Piece] = []
    brackets: list[str] = []
    operand_expected = True
    glued = True  # the next piece has no blank before it
    index = 0
    while index < len(tokens):
        token = tokens[index]
        if operand_expected and token in BRACKETS:
            touches = glued and not (token == "|" and index > 0 and tokens[index - 1] == "|")
            pieces.append(Piece(token, 0 if touches else 1, GLUED, depth))
            brackets.append(token)
            depth += 1
            glued = True
        elif operand_expected:
            pieces.append(Piece(token, 0 if glued else 1, GLUED, depth))
            operand_expected = False
            if tokens[index + 1 : index + 2] == ["("]:  # in a formula without mistakes: arguments
                inside = _arguments(tokens, index + 1)
                pieces += _given(tokens[index + 1 : inside], depth)
                index = inside - 1
        elif token in _POSTFIX:
            after = index + _POSTFIX[token]
            written = (OTHER_SPELLINGS.get(text, text) for text in tokens[index:after])
            pieces += [Piece(text, 0, GLUED, depth) for text in written]
            index = after - 1
        elif brackets and (token in (")", "]") or (token == "|" and _closes_bar(tokens, index, brackets))):
            brackets.pop()
            depth -= 1
            pieces.append(Piece(token, 0, GLUED, depth))
            if token == "|":
                index += 1
                pieces.append(Piece(tokens[index], 0, GLUED, depth))
        else:
            pieces.append(
                Piece(
                    token, 1, level_of(depth, INFIX_SIGNS.get(token, Operator.SEQUENCE).row.precedence), depth
                )
            )
            operand_expected = True
            glued = False
        index += 1
    return pieces


def _given(tokens: Sequence[str], depth: int) -> list[Piece]:
    """The pieces of arguments in parentheses: a formula's tokens are smaller than an expression's."""
    pieces = expression(tokens, depth, transition=False)
    pieces[0].blanks = 0
    for before, piece in pairwise(pieces):
        joins = "." in (before.text, piece.text) or (piece.text == "=" and before.text in "=<>!")
        if joins:
            piece.blanks, piece.level = 0, GLUED
    return pieces


def _arguments(tokens: Sequence[str], opening: int) -> int:
    """The place behind the parentheses that open at `opening`."""
    depth = 0
    for index in range(opening, len(tokens)):
        depth += (tokens[index] == "(") - (tokens[index] == ")")
        if depth == 0:
            return index + 1
    return len(tokens)


def _closes_bar(tokens: Sequence[str], index: int, brackets: Sequence[str]) -> bool:
    """Whether a `|` is the second of `|A~|3`."""
    return brackets[-1] == "|" and index + 1 < len(tokens) and tokens[index + 1].isdigit()


def expression(tokens: Sequence[str], depth: int, *, transition: bool) -> list[Piece]:
    """The pieces of an expression, or of a transition expression, whose first token is at `depth`."""
    pieces: list[Piece] = []
    outside = transition  # of the condition and the actions
    brackets = 0
    previous = ""
    unary = False  # the token before is a sign or `!`
    for token in tokens:
        blanks, level = 1, GLUED
        operand = not previous or previous in _OPERAND_FOLLOWS
        is_unary = False
        at = depth
        if not previous or previous in ("(", "[") or unary:
            blanks = 0
        if token in ("(", "["):
            if not operand and (token == "(" or brackets or not outside):
                blanks = 0  # of a call, or of an element
            if token == "[" and outside and not brackets and previous and previous != "when":
                level = level_of(depth, _CONDITION)
            brackets += 1
            depth += 1
        elif token in (")", "]"):
            brackets -= 1
            depth -= 1
            at = depth
            blanks = 0
        elif token == "{":
            brackets += 1
            depth += 1
        elif token == "}":
            brackets -= 1
            depth -= 1
            at = depth
        elif token in (",", ";"):
            blanks = 0
        elif token == "/" and outside and brackets == 0:
            outside = False
            level = level_of(depth, _SLASH) if previous else GLUED
            depth += 1
            at = depth - 1
            operand = True
        elif token in ("!", "-", "+") and operand:
            is_unary = True
        elif token in ("or", "||") and outside and brackets == 0:
            level = level_of(depth, _EVENT)
        elif token in _INFIX:
            level = level_of(depth, _INFIX[token])
        is_rest = previous == ".." and token not in ("}", ",")
        if is_rest or "." in (token, previous):  # the message of `..m`, a member of an element
            blanks = 0
        if previous in (",", ";"):
            level = level_of(at, _COMMA)
        pieces.append(Piece(token, blanks, level, at))
        unary = is_unary
        previous = token
    return pieces
