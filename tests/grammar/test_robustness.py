"""No text, however broken, ends in an exception or in a tree that lies about its places."""

from __future__ import annotations

import json
import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.diagnostics import render_json, render_text
from aseme_dsl.grammar import parse
from aseme_dsl.source import Source
from tests.grammar.reading import ACCEPTANCE, nodes

KOURETES = next(path for path in ACCEPTANCE if path.stem == "kouretes").read_text("utf-8")
WORDS = [
    *"srm aip sag suc topic message enum control liveness activities participant scenario team".split(),
    *"enter leave skip repeat let var state every 33ms 0.1 1.5 3 a b c ω".split(),
    *'-> = == ( ) [ ] { } . | || ~ * : , ; # @ " // /* */ && ! /'.split(),
    "\n",
]


def survives(text: str) -> None:
    file, diagnostics = parse(Source("test.aseme", text))
    for node in nodes(file.declarations):
        assert 0 <= node.span.start <= node.span.end <= len(text)
    for item in diagnostics:
        assert item.span is not None
        assert 0 <= item.span.start <= item.span.end <= len(text)
    assert len(diagnostics) <= 101
    render_text(diagnostics)
    json.dumps(render_json(diagnostics))


@given(st.text(max_size=300))
def test_any_text(text: str) -> None:
    survives(text)


@given(st.binary(max_size=500))
def test_any_bytes(content: bytes) -> None:
    survives(content.decode("utf-8", "surrogateescape"))
    survives(content.decode("latin-1"))


@settings(max_examples=300)
@given(st.lists(st.sampled_from(WORDS), max_size=60).map(" ".join))
def test_any_words_of_the_language(text: str) -> None:
    survives(text)


@settings(max_examples=50)
@given(st.data())
def test_any_damage_to_a_real_file(data: st.DataObject) -> None:
    text = KOURETES
    for _ in range(data.draw(st.integers(1, 6))):
        start = data.draw(st.integers(0, len(text)))
        end = min(len(text), start + data.draw(st.integers(0, 40)))
        text = text[:start] + data.draw(st.sampled_from([*WORDS, "", "é", "\0"])) + text[end:]
    survives(text)


@pytest.mark.parametrize(
    "text",
    [
        KOURETES.replace("}", ""),
        KOURETES.replace("{", ""),
        KOURETES.replace("\n", " "),
        KOURETES.replace("\n", "\r"),
        KOURETES.replace('"', ""),
        KOURETES.replace(":", ""),
        KOURETES.replace("=", ""),
        KOURETES.replace(" ", ""),
        KOURETES.upper(),
        KOURETES[::-1],
        "\0" + KOURETES,
        KOURETES + "/*",
        *(KOURETES[:cut] for cut in range(0, len(KOURETES), 501)),
    ],
)
def test_a_real_file_maimed(text: str) -> None:
    survives(text)


@pytest.mark.parametrize(
    "unit",
    [
        "{", "}", "{ }", "(", "[", "|", "srm a {", "srm a {\n", "aip a { participant b {\n", "/*", '"', "'",
        "?", "ω", "ä", "a", "1", "1.", "\0", "\\", "a.", "\ud800 ", "enter A ", "x {\n",
        "srm a { control a { enter A . ", 'scenario "x" { a { ', "let a = (", "A . ", "\n", "\u2028",
        "srm a { liveness { a = ( ",
    ],
)  # fmt: skip
def test_much_of_the_same(unit: str) -> None:
    survives(unit * (20_000 // len(unit)))


def test_garbage() -> None:
    choose = random.Random(1)
    survives("".join(chr(choose.randrange(256)) for _ in range(200_000)))
    survives("".join(choose.choice('{}()[].,;:=<>!&|*+-/%~#@?"^ab 12\n\t') for _ in range(200_000)))
    survives(" ".join(choose.choice(WORDS) for _ in range(30_000)))


def test_time_grows_with_length_and_no_faster(monkeypatch: pytest.MonkeyPatch) -> None:
    """Counted in looks at tokens, as no clock is reliable: twice the text, about twice the work."""
    from aseme_dsl.grammar.text.lexer import Tokens

    calls = 0
    word = Tokens.word

    def counted(self: Tokens, index: int) -> str:
        nonlocal calls
        calls += 1
        return word(self, index)

    monkeypatch.setattr(Tokens, "word", counted)

    def work(text: str) -> int:
        nonlocal calls
        calls = 0
        parse(Source("test.aseme", text))
        return calls

    for unit in ("srm a { x { }\n", "}", "{\n", "enter A }\n", "control a { enter A [x]\n", "a - b { ( \n"):
        assert work(unit * 4000) < 2.5 * work(unit * 2000) + 1000, unit
