"""The kinds of tokens, whatever an engine calls them."""

from __future__ import annotations

from pygments.token import Comment, Whitespace, string_to_tokentype

from aseme_dsl.grammar.syntax.contexts import Kind
from aseme_dsl.grammar.syntax.pygments import TOKENS
from aseme_dsl.pygments_lexer import AsemeLexer

PYGMENTS = {str(string_to_tokentype(token)): kind for kind, token in reversed(TOKENS.items())}
"""The kind of each token type of Pygments; of two kinds with one type, the first."""

SAME = {kind: PYGMENTS[str(string_to_tokentype(token))] for kind, token in TOKENS.items()}
"""The kind that Pygments does not tell from a kind."""


def by_pygments(text: str) -> list[str]:
    """The kind of every character of a text, "" of blanks."""
    found: list[str] = []
    for token, value in AsemeLexer(stripnl=False, ensurenl=False).get_tokens(text):
        if token in Comment:
            name = "comment"
        elif token is Whitespace:
            name = ""
        else:
            kind = PYGMENTS.get(str(token))
            name = kind.name if kind else f"unknown to the language ({token})"
        found += ["" if character.isspace() else name for character in value]
    return found


def same(kind: Kind) -> str:
    """The name that `by_pygments` gives to a token of this kind."""
    return SAME[kind].name


def differences(text: str, found: list[str]) -> list[str]:
    """Where the kinds of the characters are not those of Pygments; one for each line."""
    by_line: dict[int, str] = {}
    for place, (expected, got) in enumerate(zip(by_pygments(text), found, strict=True)):
        if expected != got:
            line = text.count("\n", 0, place) + 1
            column = place - text.rfind("\n", 0, place)
            by_line.setdefault(line, f"{line}:{column} is {got or 'nothing'}, and {expected} for Pygments")
    return list(by_line.values())
