"""What is committed is what the grammar gives."""

from __future__ import annotations

import ast
import inspect
import re
from pathlib import Path

from aseme_dsl.grammar.formulas import expression, transition
from aseme_dsl.grammar.formulas.words import RESERVED
from aseme_dsl.grammar.syntax import files
from aseme_dsl.grammar.syntax.contexts import EXPRESSION_WORDS
from tests.grammar.syntax.programs import ROOT, words


def test_the_files_are_those_of_this_grammar() -> None:
    other = [name for name, made in files().items() if content(ROOT / name) != made]
    assert not other, "these are not what the grammar gives now: run python3 dev.py syntax, and commit them"


def content(path: Path) -> str | None:
    return path.read_text("utf-8") if path.exists() else None


def test_every_word_of_the_grammar_is_in_every_file() -> None:
    for name, made in files().items():
        if name == "aseme_dsl/grammar/parsing/nodes.py":
            continue  # it has the rules, and none of their words
        text = re.sub(r"\\+[vb]", " ", made)  # not the letters of \v and \b
        missing = [word for word in words() if not re.search(rf"(?<![A-Za-z_]){word}(?![A-Za-z_])", text)]
        assert not missing, name


NO_WORDS = {"if", "as"}
"""What transition.py compares with because people write it by mistake."""


def test_the_words_of_expressions_are_those_that_the_parser_asks_for() -> None:
    """Expressions are read by hand, so their words stand in a table of their own."""
    asked = {
        item.value
        for module in (expression, transition)
        for compared in ast.walk(ast.parse(inspect.getsource(module)))
        if isinstance(compared, ast.Compare)
        for item in ast.walk(compared)
        if isinstance(item, ast.Constant) and isinstance(item.value, str)
    }
    found = {word for word in asked if re.fullmatch(r"[a-z][a-z_]+", word)} - NO_WORDS
    assert found - set(EXPRESSION_WORDS) - set(RESERVED) == set(), "enter the new word in EXPRESSION_WORDS"
