"""Grammar: the textX grammar of `.aseme`, and the tree of a file with a place for everything.

textX is imported when something is parsed, not with this package.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from aseme_dsl.grammar.parsing.parse import parse

if TYPE_CHECKING:
    from aseme_dsl.grammar.parsing.language import aseme_language

__all__ = ["aseme_language", "parse"]


def __getattr__(name: str) -> object:
    if name == "aseme_language":
        from aseme_dsl.grammar.parsing.language import aseme_language

        return aseme_language
    raise AttributeError(name)
