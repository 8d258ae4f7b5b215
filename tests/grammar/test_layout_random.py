"""Whatever is laid out keeps its tokens, its comments and its meaning, and is laid out then."""

from __future__ import annotations

import json
import os
import random
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.amola.as_json import models_json
from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import has_errors
from aseme_dsl.grammar import parse
from aseme_dsl.grammar.layout import format_source
from aseme_dsl.source import Source
from tests.grammar.reading import ACCEPTANCE, short
from tests.oracle import charts
from tests.oracle.choices import Choices
from tests.support.large import large_file
from tests.support.relaid import comments, lengthened, mutated, relaid, tokens

ROOT = Path(__file__).resolve().parents[2]
TEXTS = [
    path.read_text("utf-8")
    for path in (
        *ACCEPTANCE,
        *sorted(ROOT.glob("examples/*/*.aseme")),
        *sorted(ROOT.glob("stdlib/*.aseme")),
        ROOT / "tests" / "grammar" / "layout" / "everything.aseme",
    )
] + [large_file(100)]

EXAMPLES = int(os.environ.get("LAYOUT_EXAMPLES", "14"))
OFTEN = (0.01, 0.05, 0.3, 0.9)
COMMENTED = (0.0, 0.2, 0.6)


def laid(text: str) -> str:
    """The text in the canonical layout, with everything that must hold of it checked."""
    result = format_source(Source("test.aseme", text))
    assert not result.diagnostics
    assert tokens(result.text) == tokens(text)
    assert comments(result.text) == comments(text)
    assert tree_of(result.text) == tree_of(text)
    again = format_source(Source("test.aseme", result.text))
    assert not again.diagnostics
    assert again.text == result.text
    assert not any(line != line.rstrip() for line in code_lines(result.text))
    return result.text


def tree_of(text: str) -> Any:
    read = short(parse(Source("test.aseme", text))[0].declarations)
    # Statements of scenarios are separated by their words, so that their lines mean nothing.
    return [(*item[:2], sum(item[2], ())) if item[0] == "Scenario" else item for item in read]


def code_lines(text: str) -> list[str]:
    """The lines, but for those inside comments of several lines, which stay as they are."""
    return text.replace("\r\n", "\n").split("\n") if "/*" not in text else []


def model(text: str) -> Any:
    """The models of a system as JSON without places; None if it does not compile."""
    analysis = analyse(Source("test.aseme", text))
    if has_errors(analysis.diagnostics) or analysis.system is None:
        return None
    return without_places(json.loads(json.dumps(models_json(analysis.system))))


def without_places(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: without_places(item) for key, item in value.items() if key not in ("span", "source")}
    if isinstance(value, list):
        return [without_places(item) for item in value]
    return value


@pytest.mark.parametrize("text", TEXTS)
def test_programs_by_hand(text: str) -> None:
    laid(text)


@settings(max_examples=EXAMPLES)
@given(st.integers(0, 10**9))
def test_programs_with_anything_between_their_tokens(seed: int) -> None:
    choose = random.Random(seed)
    text = lengthened(choose.choice(TEXTS), choose.choice((1, 1, 2, 4)))
    rewritten = relaid(text, choose, choose.choice(OFTEN), choose.choice(COMMENTED))
    if choose.random() < 0.2:
        rewritten = rewritten.replace("\n", "\r\n")
    if not parse(Source("test.aseme", rewritten))[1]:
        laid(rewritten)


@settings(max_examples=max(EXAMPLES // 2, 1))
@given(st.integers(0, 10**9))
def test_random_programs_keep_their_models(seed: int) -> None:
    choose = random.Random(seed)
    text = charts.text(Choices(seed))
    rewritten = relaid(text, choose, choose.choice(OFTEN), choose.choice(COMMENTED))
    if not parse(Source("test.aseme", rewritten))[1]:
        before, after = model(rewritten), model(laid(rewritten))
        assert before is not None
        assert after == before


@settings(max_examples=EXAMPLES)
@given(st.integers(0, 10**9))
def test_broken_programs_are_laid_out_or_refused(seed: int) -> None:
    choose = random.Random(seed)
    text = choose.choice(TEXTS)
    for _ in range(choose.randrange(1, 3)):
        if parse(Source("test.aseme", text))[1]:
            break
        text = mutated(text, choose)
    result = format_source(Source("test.aseme", text))
    if result.diagnostics:
        assert result.text == text
    else:
        laid(text)


@given(st.text(max_size=200))
def test_any_text_is_laid_out_or_refused(text: str) -> None:
    result = format_source(Source("test.aseme", text))
    assert result.diagnostics or format_source(Source("test.aseme", result.text)).text == result.text


@cache
def systems() -> list[str]:
    """The texts that are whole systems."""
    return [text for text in TEXTS if model(text) is not None]


@pytest.mark.parametrize("seed", range(2))
def test_models_of_programs_by_hand(seed: int) -> None:
    choose = random.Random(seed)
    text = choose.choice(systems())
    rewritten = relaid(text, choose, 0.05, 0.3)
    if not parse(Source("test.aseme", rewritten))[1]:
        assert model(laid(rewritten)) == model(rewritten)
