"""The TextMate grammar in the engine of VS Code says of every character what the lexer for Pygments says."""

from __future__ import annotations

import json
import subprocess
from functools import lru_cache
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.grammar.syntax.contexts import KEYWORDS
from aseme_dsl.grammar.syntax.textmate import SCOPES
from tests.grammar.syntax.kinds import differences, same
from tests.grammar.syntax.programs import ACCEPTANCE, PROGRAMS, ROOT, words_as_names
from tests.support.node import packages

HERE = Path(__file__).parent
GRAMMAR = ROOT / "editors/vscode/syntaxes/aseme.tmLanguage.json"
KINDS = {scope: same(kind) for kind, scope in SCOPES.items()}


def tokens(texts: list[str]) -> list[list[tuple[int, int, int, str]]]:
    """Line, start, end and innermost scope of the tokens of each text; afterwards every block is closed."""
    order = {"grammar": str(GRAMMAR), "packages": str(packages(HERE / "node")), "texts": texts}
    done = subprocess.run(
        ["node", str(HERE / "node/tokens.cjs")], input=json.dumps(order), capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    return [
        [(line, start, end, scope) for line, start, end, scope in found] for found in json.loads(done.stdout)
    ]


@lru_cache(maxsize=1)
def tokens_of_programs() -> dict[Path, list[tuple[int, int, int, str]]]:
    return dict(zip(PROGRAMS, tokens([path.read_text("utf-8") for path in PROGRAMS]), strict=True))


def kinds(text: str, found: list[tuple[int, int, int, str]]) -> list[str]:
    """The kind of every character of a text."""
    lines = text.split("\n")
    rows = [[""] * len(line) for line in lines]
    for line, start, end, scope in found:
        kind = "comment" if scope.startswith("comment") else KINDS.get(scope, f"without a scope ({scope})")
        for column in range(start, end):
            rows[line][column] = "" if lines[line][column].isspace() else kind
    return [kind for row in rows for kind in [*row, ""]][:-1]


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.name)
def test_the_scopes_are_those_of_the_lexer(path: Path) -> None:
    text = path.read_text("utf-8")
    assert differences(text, kinds(text, tokens_of_programs()[path])) == []


def test_a_word_that_is_a_name_here_has_no_scope_of_a_keyword() -> None:
    """A topic may be called `team`."""
    texts = words_as_names(25, seed=2)
    found = tokens(texts)
    assert [differences(text, kinds(text, each)) for text, each in zip(texts, found, strict=True)] == [
        []
    ] * 25


def test_a_phrase_on_several_lines() -> None:
    text = (
        "system\n  A\nenum // what it is\n  B\n{\n  X,\n  Y\n}\ntopic t under\n u {\n state M, // and\n"
        "  N from\n  camera every 20ms\n}\nsrm r { plays\n a.b\n activities { A reads t.state.M, // and\n"
        " u.state.N writes\n v } }\n"
    )
    (found,) = tokens([text])
    lines = text.split("\n")
    names = {scope for kind, scope in SCOPES.items() if kind in KEYWORDS}
    keywords = [lines[line][start:end] for line, start, end, scope in found if scope in names]
    assert keywords == ("system enum topic under state from every srm plays activities reads writes".split())


@pytest.mark.parametrize("path", ACCEPTANCE, ids=lambda path: path.name)
def test_the_scopes_of_an_acceptance_file(path: Path, snapshot: Any) -> None:
    lines = path.read_text("utf-8").split("\n")
    shown = [
        f"{line + 1:4} {scope.removesuffix('.aseme'):32} {lines[line][start:end].strip()}"
        for line, start, end, scope in tokens_of_programs()[path]
    ]
    snapshot("\n".join(shown) + "\n", f"{path.stem}.textmate.txt")
