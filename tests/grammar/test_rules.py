"""The rules that are written down are those of the .tx files, and are read as textX reads them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from arpeggio import RegExMatch
from textx import metamodel_from_str
from textx.model_params import ModelParams

from aseme_dsl.grammar.parsing import parser, prepared, rules, terminals
from aseme_dsl.grammar.parsing.terminals import metamodel
from aseme_dsl.source import Source
from tests.docs.pages import ROOT

FOLDERS = ("tests/acceptance", "tests/grammar", "stdlib")
FILES = sorted(path for folder in FOLDERS for path in (ROOT / folder).rglob("*.aseme"))

SAME = ("rule_name", "root", "suppress", "to_match", "to_match_regex", "_attr_name", "eolterm")


def pairs(ours: Any, theirs: Any) -> Iterator[tuple[Any, Any]]:
    """The parsing expressions that stand at the same places of two grammars."""
    seen: set[int] = set()
    waiting = [(ours, theirs)]
    while waiting:
        pair = waiting.pop()
        if id(pair[0]) not in seen:
            seen.add(id(pair[0]))
            yield pair
            assert len(pair[0].nodes) == len(pair[1].nodes)
            waiting += zip(pair[0].nodes, pair[1].nodes, strict=True)
            separators = tuple(getattr(node, "sep", None) for node in pair)
            if separators != (None, None):
                waiting.append(separators)


def test_the_parser_is_the_one_that_textx_makes() -> None:
    ours = parser.parsing_expressions(rules.rules())
    theirs = rules.textx_metamodel()._parser_blueprint.parser_model
    met: dict[int, Any] = {}
    for one, other in pairs(ours, theirs):
        assert type(one) is type(other)
        for name in SAME:
            assert getattr(one, name, None) == getattr(other, name, None), (one, other, name)
        if isinstance(one, RegExMatch):
            one.compile()
            assert one.regex == other.regex
        assert met.setdefault(id(other), one) is one  # one rule, used twice, is one expression
    assert len(met) > 400


def values(made: Any) -> Any:
    """What has been read, as plain data."""
    if isinstance(made, list):
        return [values(item) for item in made]
    if made is None or isinstance(made, (str, bool)):
        return made, getattr(made, "start", None)
    own = {name: values(value) for name, value in vars(made).items() if name[0] != "_" and name != "parent"}
    return type(made).__name__, made._tx_position, made._tx_position_end, own


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name)
def test_the_objects_are_those_of_textx(path: Path) -> None:
    text = path.read_text("utf-8")
    made, _ = terminals.read(Source(str(path), text))
    theirs = (
        metamodel()
        ._parser_blueprint.clone()
        .get_model_from_str(
            text,
            pre_ref_resolution_callback=lambda model: setattr(model, "_tx_model_params", ModelParams({})),
        )
    )
    assert values(made) == values(theirs)


def test_a_changed_grammar_is_read_again(monkeypatch: pytest.MonkeyPatch) -> None:
    known = rules.rules()
    monkeypatch.setattr(prepared, "RULES", {})
    monkeypatch.setattr(prepared, "CHECKSUM", prepared.CHECKSUM + 1)
    assert rules.rules() == known
    assert list(rules.rules()) == list(known)


@pytest.mark.parametrize(
    "grammar",
    [
        "A: name=ID next=[A];",
        "A: 'a' ('b' 'c')#;",
        "A: !'a' name=ID;",
        "A: 'a'- name=ID;",
        "A: ('a' name=ID)+[eolterm];",
    ],
)
def test_what_is_not_provided_for_is_refused(grammar: str) -> None:
    with pytest.raises(NotImplementedError):
        rules.rules_of(
            metamodel_from_str(f"Top: a=A b=B?; {grammar}" + ("" if "B:" in grammar else " B: 'b';"))
        )


def test_nothing_of_textx_is_imported_to_parse() -> None:
    """Its import takes longer than to parse a small file."""
    assert not re.search(r"^(from|import) textx", Path(parser.__file__).read_text("utf-8"), re.MULTILINE)
