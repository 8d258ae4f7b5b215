"""The reference of the language has a page for each construct, and one table that names them all.

A word or a kind of node that is added to the grammar is missed here until
docs/reference/language/constructs.md has it, and until a program on the page that the table names uses it.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any

from aseme_dsl.amola.messages import BUILT_IN
from aseme_dsl.amola.operators import Operator
from aseme_dsl.compiler.read.builtins import ACTIONS, FORMS, FUNCTIONS
from aseme_dsl.grammar import parse
from aseme_dsl.grammar.parsing.expected import words_of
from aseme_dsl.grammar.parsing.terminals import all_rules, parser_model
from aseme_dsl.grammar.syntax.contexts import EXPRESSION_WORDS
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Source
from tests.docs.pages import ROOT, completed, examples

LANGUAGE = ROOT / "docs" / "reference" / "language"
TABLE = "constructs.md"
OVERVIEWS = {"index.md", "formulas.md", "messages.md", "agent-messages.md", "conditions.md", "layout.md"}
"""Pages that are about several constructs, or about how a file looks: the table need not name them."""
OF_SEVERAL = {
    "control.md",
    "expressions.md",
    "holes.md",  # nothing is drawn of a hole, or run
    "lexical.md",
    "protocols.md",
    "requirements.md",
    "roles.md",
    "scenarios.md",
}
"""Pages that the table names and that are overviews, or about what does not run."""
NOT_IN_A_PROGRAM = {"Comment"}
"""What no program of a page must have: the examples explain themselves."""


def _linked() -> list[str]:
    text = (LANGUAGE / TABLE).read_text("utf-8")
    return sorted({name for line in _rows(text) for name in re.findall(r"\]\(([\w-]+\.md)", line)})


def _rows(text: str) -> Iterator[str]:
    yield from (line for line in text.split("\n") if line.startswith("| `"))


def _words_of_the_grammar() -> set[str]:
    """Keywords, and the words of rules that are nothing but a choice between words."""
    rules = [rule for rule, _ in all_rules(parser_model())]
    words = {word for rule in rules if hasattr(rule, "to_match") for word in words_of(rule)}
    words = {word.removesuffix(r"\b") for word in words}
    return {word for word in words if word.isidentifier()}


def _nodes(top: Any) -> Iterator[Any]:
    todo = [top]
    while todo:
        item = todo.pop()
        if isinstance(item, tuple | list):
            todo += item
        elif is_dataclass(item) and type(item).__module__ == tree.__name__:
            yield item
            todo += [getattr(item, part.name) for part in fields(item)]


def test_the_table_has_every_word_of_the_grammar() -> None:
    words = _words_of_the_grammar()
    assert {"system", "enter", "queued", "async", "signal"} <= words, "the grammar is not read as it was"
    written = set(re.findall(r"[A-Za-z]\w*", " ".join(_written())))
    words |= {*EXPRESSION_WORDS, *ACTIONS, *FORMS, *(function.name for function in FUNCTIONS), *BUILT_IN}
    assert sorted(words - written) == [], f"{LANGUAGE / TABLE}: a line with a page for each of these"


def test_the_table_has_every_operator_of_formulas() -> None:
    written = " ".join(_written())
    signs = {sign for item in Operator for sign in re.findall(r"\[>|[^\w\s()]+", item.value)}
    assert [sign for sign in sorted(signs) if sign not in written] == []


def _written() -> Iterator[str]:
    for line in _rows((LANGUAGE / TABLE).read_text("utf-8")):
        cell = re.match(r"\| (.*?)(?<!\\) \| ", line)
        assert cell is not None, line
        yield " ".join(re.findall(r"`([^`]+)`", cell[1])).replace("\\|", "|")


def test_every_kind_of_node_stands_in_a_program_of_the_reference() -> None:
    kinds = {
        name
        for name, kind in inspect.getmembers(tree, inspect.isclass)
        if kind.__module__ == tree.__name__ and is_dataclass(kind)
    }
    used = set[str]()
    for page in _linked():
        for example in examples((LANGUAGE / page).read_text("utf-8").split("\n")):
            if example.language == "aseme":
                file, _ = parse(Source(page, completed(example)))
                used |= {type(item).__name__ for item in _nodes(file)}
    assert sorted(kinds - used - NOT_IN_A_PROGRAM) == []


def test_the_table_names_every_page() -> None:
    pages = {path.name for path in LANGUAGE.glob("*.md")}
    assert sorted(pages - {TABLE} - OVERVIEWS - set(_linked())) == []


def test_each_page_of_a_construct_has_all_its_parts() -> None:
    missing = []
    for name in sorted({*_linked()} - OF_SEVERAL):
        text = (LANGUAGE / name).read_text("utf-8")
        parts = ("```aseme", "<!-- drawn: ", "$ asemec run ", "\n## What it means\n")
        missing += [f"{name}: {part.strip()}" for part in parts if part not in text]
    assert missing == []


def test_what_a_page_quotes_is_what_the_semantics_says() -> None:
    semantics = _plain((ROOT / "docs" / "reference" / "semantics.md").read_text("utf-8"))
    wrong = []
    for path in sorted(LANGUAGE.glob("*.md")):
        for quote in re.findall(r"(?:^> .*\n)+", path.read_text("utf-8"), re.MULTILINE):
            text = _plain(re.sub("^> ", "", quote, flags=re.MULTILINE))
            if text not in semantics:
                wrong.append(f"{path.name}: {text}")
    assert wrong == []


def _plain(text: str) -> str:
    """Words without links and line breaks."""
    return " ".join(re.sub(r"\[([^][]*)\]\([^)]*\)", r"\1", text).split())
