"""Valid programs, and what the parser says of each of their words."""

from __future__ import annotations

import random
import re
from bisect import bisect_right
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from typing import Any

from aseme_dsl.grammar.formulas.words import BUILT_IN_TYPES, RESERVED
from aseme_dsl.grammar.layout import format_source
from aseme_dsl.grammar.layout.rules import EXPRESSIONS, FORMULAS
from aseme_dsl.grammar.parsing.parse import parse_with_leaves
from aseme_dsl.grammar.syntax.shape import Choice, Repeated, Series, Shape, Terminal, grammar
from aseme_dsl.source import Source

ROOT = Path(__file__).parents[3]
EVERYTHING = ROOT / "tests/grammar/layout/everything.aseme"
ACCEPTANCE = sorted((ROOT / "tests/acceptance").glob("*.aseme"))
PROGRAMS = [
    *ACCEPTANCE,
    EVERYTHING,
    *sorted((ROOT / "stdlib").glob("*.aseme")),
    *sorted((ROOT / "examples").rglob("*.aseme")),
]

_LISTS = FORMULAS | EXPRESSIONS | {"Word"}


@lru_cache(maxsize=1)
def terminals() -> tuple[Terminal, ...]:
    return tuple(dict.fromkeys(_terminals(grammar())))


def _terminals(shape: Shape) -> Iterator[Terminal]:
    if isinstance(shape, Terminal):
        yield shape
    elif isinstance(shape, Series):
        for item in shape.items:
            yield from _terminals(item)
    elif isinstance(shape, Choice):
        for option in shape.options:
            yield from _terminals(option)
    else:
        assert isinstance(shape, Repeated)
        yield from _terminals(shape.item)
        if shape.separator is not None:
            yield shape.separator


@lru_cache(maxsize=1)
def words() -> list[str]:
    """Every word of the language."""
    return sorted({word for terminal in terminals() for word in terminal.words})


@lru_cache(maxsize=1)
def words_of_blocks() -> dict[str, set[str]]:
    """By the rule of a block: the words that are in it, and in what stands in it."""
    found = {"File": set(words())}
    todo: list[Shape] = [grammar()]
    for shape in todo:
        if isinstance(shape, Series):
            if any(isinstance(item, Terminal) and item.pattern == r"\{" for item in shape.items):
                found[shape.rule] = {word for terminal in _terminals(shape) for word in terminal.words}
            todo += shape.items
        elif isinstance(shape, Choice):
            todo += shape.options
        elif isinstance(shape, Repeated):
            todo.append(shape.item)
    return found


@lru_cache(maxsize=256)
def words_of_text(text: str) -> list[tuple[int, str, bool, str]] | None:
    """Place, word, whether it is one of the language, and the rule around it; outside lists of tokens.

    None if the text has mistakes.
    """
    tree, _, diagnostics = parse_with_leaves(Source("program.aseme", text))
    if diagnostics:
        return None
    rules_with_words = {terminal.rule for terminal in terminals() if terminal.words}
    found: list[tuple[int, str, bool, str]] = []
    todo: list[tuple[Any, str]] = [(tree, "File")]
    for node, around in todo:
        rule = node.rule
        if isinstance(node, list):
            inside = rule.rule_name if rule.root and rule.rule_name in words_of_blocks() else around
            todo += [(part, inside) for part in node]
            continue
        value = str(node.value)
        if rule.rule_name in _LISTS or not re.match(r"[A-Za-z_]", value):
            continue
        found.append((node.position, value, not rule.root or rule.rule_name in rules_with_words, around))
    return sorted(found)


def words_as_names(count: int, seed: int) -> list[str]:
    """Declarations in which a word of the language is a name, where the language lets it be one.

    Each with the one before it and the one behind it, to which the word might belong.
    """
    text = EVERYTHING.read_text("utf-8")
    begins = [found.start() for found in re.finditer(r"^(?=\w)", text, re.MULTILINE)]
    chance = random.Random(seed)
    taken = words_of_blocks()
    names = [
        (place, name, around) for place, name, is_word, around in words_of_text(text) or () if not is_word
    ]
    never = {*RESERVED, *BUILT_IN_TYPES}
    found: list[str] = []
    while len(found) < count:
        place, name, around = chance.choice(names)
        word = chance.choice(words())
        if word in never or word in taken[around] or "." in name:
            continue
        own = bisect_right(begins, place)
        begin, end = [0, *begins][max(0, own - 1)], [*begins, len(text), len(text)][own + 1]
        changed = text[begin:place] + word + text[place + len(name) : end]
        if words_of_text(changed) is not None:
            found.append(changed)
    return found


TRICKY = """\
// A brace in a comment: {
system Tricky  /* and { in
  a long one { */

message M { string s }

topic t { signal M  state M }

srm r {
  goal "a { brace in a \\\\" text"
  liveness { r = (A . B) [> [C] }
  control r {
    enter B : [t.state.M.s == "{{"]
              / t.signal.M.s = "}";
                write_messages.t.signal.M
    enter C : when [t.state.M.s == "{"]
  }
}
"""
"""A text in which braces are not what they seem to be."""


def laid_out(folder: Path) -> dict[Path, str]:
    """Copies of files that are laid out as `asemec fmt` does, each with its text."""
    texts = {path.name: path.read_text("utf-8") for path in PROGRAMS}
    texts["tricky.aseme"] = TRICKY
    found: dict[Path, str] = {}
    for name, text in texts.items():
        copy = folder / name
        canonical = format_source(Source(name, text)).text or text
        copy.write_text(canonical, "utf-8")
        found[copy] = canonical
    return found
