"""The lexer for Pygments says of every word what the parser says."""

from __future__ import annotations

import subprocess
import sys
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pygments.lexers import get_lexer_by_name, get_lexer_for_filename
from pygments.token import Error, Keyword, Operator, Text

from aseme_dsl.pygments_lexer import AsemeLexer
from tests.grammar.syntax.programs import ACCEPTANCE, EVERYTHING, PROGRAMS, words_as_names, words_of_text


def tokens(text: str) -> list[tuple[int, Any, str]]:
    """Place, kind and text of every token."""
    found = []
    place = 0
    for kind, value in AsemeLexer(stripnl=False, ensurenl=False).get_tokens(text):
        found.append((place, kind, value))
        place += len(value)
    return found


def is_keyword(kind: Any) -> bool:
    return (kind in Keyword and kind is not Keyword.Type) or kind is Operator.Word


def differences(text: str) -> list[str]:
    """Where the lexer takes a word for something else than the parser does."""
    kinds = {place: kind for place, kind, _ in tokens(text)}
    return [
        f"line {text.count(chr(10), 0, place) + 1}: {word} is {kinds.get(place)}"
        for place, word, is_word, _ in words_of_text(text) or ()
        if is_keyword(kinds.get(place, Error)) != is_word
    ]


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.name)
def test_a_word_is_a_keyword_where_the_parser_takes_it_for_one(path: Path) -> None:
    text = path.read_text("utf-8")
    assert words_of_text(text)
    assert differences(text) == []


def test_a_word_that_is_a_name_here_is_coloured_as_one() -> None:
    """A topic may be called `team`."""
    assert [found for text in words_as_names(100, seed=1) if (found := differences(text))] == []


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.name)
def test_every_token_of_a_program_is_one_of_the_language(path: Path) -> None:
    """`Text` is what the grammar has nowhere."""
    text = path.read_text("utf-8")
    found = tokens(text)
    assert "".join(value for _, _, value in found) == text
    assert [value for _, kind, value in found if kind in (Text, Error)] == []


@given(st.data())
def test_a_broken_text_keeps_all_its_characters(data: st.DataObject) -> None:
    """No token is an error: the mistakes of the documentation are shown in colours, too."""
    text = EVERYTHING.read_text("utf-8")
    start = data.draw(st.integers(0, len(text)))
    end = data.draw(st.integers(start, min(start + 400, len(text))))
    inserted = data.draw(st.text('{}()[]:=,."/* abc1\nω§', max_size=8))
    broken = text[max(0, start - 1500) : start] + inserted + text[end : end + 1500]
    found = tokens(broken)
    assert "".join(value for _, _, value in found) == broken
    assert not any(kind is Error for _, kind, _ in found)


def test_the_lexer_is_found_by_its_name() -> None:
    (entry,) = entry_points(group="pygments.lexers", name="aseme")
    assert entry.load().name == "ASEME"
    assert type(get_lexer_by_name("aseme")).__name__ == "AsemeLexer"
    assert type(get_lexer_for_filename("team.aseme")).__name__ == "AsemeLexer"


def test_the_lexer_needs_nothing_but_pygments() -> None:
    """Who only wants colours in a document need not have the compiler's libraries."""
    code = (
        "import sys; sys.modules.update(dict.fromkeys(['textx', 'arpeggio', 'click', 'google.protobuf']));"
        "from aseme_dsl.pygments_lexer import AsemeLexer;"
        "print(len(list(AsemeLexer().get_tokens('system A'))))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "4\n"


@pytest.mark.parametrize("path", ACCEPTANCE, ids=lambda path: path.name)
def test_the_colours_of_an_acceptance_file(path: Path, snapshot: Any) -> None:
    lines = [
        f"{str(kind).removeprefix('Token.'):20} {value}"
        for _, kind, value in tokens(path.read_text("utf-8"))
        if value.strip()
    ]
    snapshot("\n".join(lines) + "\n", f"{path.stem}.pygments.txt")
