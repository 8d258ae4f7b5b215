"""What formulas and expressions have in common: the reserved words, and the exception of both."""

from __future__ import annotations

from aseme_dsl.amola.operators import OTHER_SPELLINGS
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar.text.token import Token

RESERVED = ("else", "when", "and", "or", "not", "true", "false")
BUILT_IN_TYPES = ("bool", "int", "double", "string", "bytes", "duration")
"""Words that cannot be names anywhere."""


class Malformed(Exception):
    """Carries the one diagnostic of a formula or expression."""

    def __init__(self, diagnostic: Diagnostic) -> None:
        super().__init__(diagnostic)
        self.diagnostic = diagnostic


def is_hyphen(before: Token, hyphen: Token, after: Token) -> bool:
    """Whether `-` joins two names without blanks, as in the papers' `center-for`."""
    return before.end == hyphen.start and hyphen.end == after.start and is_name(before) and is_name(after)


def is_name(token: str) -> bool:
    """Whether a token may be a name: it begins with a letter or `_`."""
    return (token[0].isalpha() and token not in OTHER_SPELLINGS) or token[0] == "_"
