"""Constructs: what the words and signs of the language mean, from the table of its reference.

The table is docs/reference/language/constructs.md, which a wheel carries as
`aseme_dsl/_constructs.md`. A test sees to it that no word and no operator is missing there.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.amola.operators import OTHER_SPELLINGS
from aseme_dsl.compiler.formula.staying import ABANDON
from aseme_dsl.compiler.read.builtins import ACTIONS, FORMS
from aseme_dsl.grammar.formulas.words import RESERVED
from aseme_dsl.grammar.parsing.expected import words_of
from aseme_dsl.grammar.parsing.terminals import all_rules, parser_model
from aseme_dsl.grammar.syntax.contexts import EXPRESSION_WORDS
from aseme_dsl.grammar.text.lexer import Tokens
from aseme_dsl.records import dataclass

MOST = 4
"""How many constructs are shown of a word that several have."""

_ROW = re.compile(r"\| (`.*?)(?<!\\) \| (.*) \|$")
_LINK = re.compile(r"\[((?:[^\]`]|`[^`]*`)+)\]\([^)]*\)")
_PUNCTUATION = frozenset("{}():,=")


@dataclass(frozen=True, slots=True)
class Construct:
    """A row of the table: how it is written, what it means, and the section it is in."""

    section: str
    written: tuple[str, ...]
    means: str

    @property
    def text(self) -> str:
        """As Markdown."""
        return f"{' '.join(f'`{item}`' for item in self.written)}: {self.means}"


@cache
def constructs() -> tuple[Construct, ...]:
    """All rows of the table."""
    package = Path(__file__).resolve().parents[2]
    in_checkout = package.parent / "docs" / "reference" / "language" / "constructs.md"
    places = (package / "_constructs.md", in_checkout)
    found: list[Construct] = []
    section = ""
    for line in outside.read_text(next(filter(Path.is_file, places))).splitlines():
        if line.startswith("## "):
            section = line.removeprefix("## ")
        row = _ROW.match(line)
        if row is not None:
            written = re.findall(r"`([^`]+)`", row[1].replace("\\|", "|"))
            found.append(Construct(section, tuple(written), _LINK.sub(r"\1", row[2])))
    return tuple(found)


@cache
def words() -> frozenset[str]:
    """The words of the language: those of the grammar, and of formulas and expressions."""
    rules = [rule for rule, _ in all_rules(parser_model())]
    found = {
        word.removesuffix(r"\b") for rule in rules if hasattr(rule, "to_match") for word in words_of(rule)
    }
    return frozenset(word for word in found if word.isidentifier()) | {
        *EXPRESSION_WORDS,
        *RESERVED,
        *ACTIONS,
        *FORMS,
    }


@cache
def _by_token() -> dict[str, list[tuple[bool, Construct]]]:
    """The constructs that each word or sign is part of, and whether one begins with it."""
    found: dict[str, dict[Construct, bool]] = {}
    for item in constructs():
        for written in item.written:
            tokens = Tokens(written)
            for index in range(len(tokens)):
                own = found.setdefault(tokens.word(index), {})
                own[item] = own.get(item, False) or index == 0
    return {word: [(first, item) for item, first in own.items()] for word, own in found.items()}


def meanings(token: str, sections: Sequence[str]) -> tuple[Construct, ...]:
    """What a word or sign of the language means, in the first of these sections that has it, else anywhere.

    Nothing of names, numbers and punctuation.
    """
    token = OTHER_SPELLINGS.get(token, token)
    if token[:1] in _PUNCTUATION and token not in ("==",):
        return ()
    if (token[:1].isalnum() or token[:1] in '_"') and token not in words() | {ABANDON, "index"}:
        return ()
    found = _by_token().get(token, [])
    for section in sections:
        inside = [(first, item) for first, item in found if item.section == section]
        if inside:
            found = inside
            break
    ordered = sorted(found, key=lambda pair: (not pair[0], len(pair[1].written)))
    return tuple(item for _, item in ordered[:MOST])


__all__ = ["Construct", "constructs", "meanings", "words"]
