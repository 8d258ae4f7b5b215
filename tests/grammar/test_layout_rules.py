"""The layout knows every rule of the grammar, and the example of everything has every alternative of it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from arpeggio import EndOfFile, Match, OneOrMore, Optional, ZeroOrMore
from textx.lang import ALL_TYPE_NAMES

from aseme_dsl.grammar.layout import format_source
from aseme_dsl.grammar.layout.rules import DROPPED, EXPRESSIONS, FORMULAS, SHAPES, Line
from aseme_dsl.grammar.parsing.parse import parse_with_leaves
from aseme_dsl.grammar.parsing.terminals import all_rules, metamodel, parser_model
from aseme_dsl.source import Source

EVERYTHING = Path(__file__).parent / "layout" / "everything.aseme"


def grammar_rules() -> dict[str, Any]:
    """The rules of the .tx files, by name, as textX has them."""
    spaces = metamodel().namespaces.values()
    return {name: rule for space in spaces for name, rule in space.items() if name not in ALL_TYPE_NAMES}


def of_kind(kind: str) -> set[str]:
    """The names of the rules of which textX makes objects (`common`), or `abstract` or `match` ones."""
    return {name for name, rule in grammar_rules().items() if rule._tx_type == kind}


def nodes(tree: Any) -> list[Any]:
    found = [tree]
    for item in found:
        if isinstance(item, list):
            found.extend(item)
    return found


def test_every_rule_has_a_layout() -> None:
    """A new rule is entered in aseme_dsl/grammar/layout/rules.py; one that is gone is taken out."""
    assert set(SHAPES) == of_kind("common")


def test_every_list_of_tokens_has_a_layout() -> None:
    """Terminals that come in lists without a separator need blanks of their own (spacing.py)."""
    assert of_kind("match") >= FORMULAS | EXPRESSIONS | DROPPED
    lists = {
        rule.nodes[0].rule_name
        for rule, _ in all_rules(parser_model())
        if isinstance(rule, (OneOrMore, ZeroOrMore))
        and not isinstance(rule, Optional)
        and rule.sep is None
        and isinstance(rule.nodes[0], Match)
    }
    assert lists == FORMULAS | EXPRESSIONS | {"Word"}


def test_layouts_name_what_there_is() -> None:
    """A part of a rule is one of its attributes, of its keywords, or another rule."""
    for name, shape in SHAPES.items():
        named = set(getattr(shape, "breaks", ()))
        if isinstance(shape, Line):
            named |= {*shape.columns, *shape.clauses} | ({shape.loose} if shape.loose else set())
        unknown = named - set(grammar_rules()[name]._tx_attrs) - keywords(name) - set(SHAPES)
        assert not unknown, f"{name}: {unknown}"


def keywords(name: str) -> set[str]:
    """The keywords and signs that stand in a rule."""
    top = parser_model()
    return {
        rule.to_match.removeprefix(r"\b").removesuffix(r"\b")
        for rule, owner in all_rules(top)
        if owner == name and isinstance(rule, Match)
    }


def test_the_example_has_every_alternative_of_the_grammar() -> None:
    """A construct that is added is added to layout/everything.aseme, too, so that its layout is seen."""
    source = Source("everything.aseme", EVERYTHING.read_text("utf-8"))
    tree, _, diagnostics = parse_with_leaves(source)
    assert not diagnostics
    met = {id(node.rule) for node in nodes(tree)}
    missing = [
        f"{rule.to_match!r} in {owner}"
        for rule, owner in all_rules(parser_model())
        if isinstance(rule, Match)
        and not isinstance(rule, EndOfFile)
        and not rule.rule_name.startswith("Junk")
        and id(rule) not in met
    ]
    assert not missing


def test_the_example_laid_out(snapshot: Any) -> None:
    source = Source("everything.aseme", EVERYTHING.read_text("utf-8"))
    snapshot(format_source(source).text, "everything.aseme")
