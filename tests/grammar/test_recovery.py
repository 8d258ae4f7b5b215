"""One mistake gives one message on its line: measured on seeded mutations of the acceptance files."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

from aseme_dsl.grammar.text.lexer import clean
from aseme_dsl.source import Source
from tests.grammar.reading import ACCEPTANCE, mistakes

STEP = 7  # one token of so many is changed: all of them take a minute


def mutations(path: Path, kind: str) -> Iterator[tuple[int, str]]:
    """Texts that differ in one token, each with the line of that token."""
    text = path.read_text("utf-8")
    tokens = clean(Source(path.name, text)).tokens
    words = [tokens.word(index) for index in range(len(tokens))]
    choose = random.Random(f"{path.name} {kind}")
    for index in range(choose.randrange(STEP), len(words), STEP):
        start, end, word = tokens.starts[index], tokens.ends[index], words[index]
        match kind:
            case "deleted":
                changed = text[:start] + text[end:]
            case "doubled":
                changed = f"{text[:end]} {word}{text[end:]}"
            case "replaced":
                changed = text[:start] + choose.choice(words) + text[end:]
            case "inserted":
                changed = f"{text[:start]}{choose.choice(words)} {text[start:]}"
            case _:  # misspelt
                if not word.islower() or len(word) < 4:
                    continue
                cut = choose.randrange(1, len(word))
                changed = text[: start + cut] + text[start + cut + 1 :]
        if changed != text:
            yield text.count("\n", 0, start) + 1, changed


@pytest.mark.parametrize("kind", ["deleted", "doubled", "replaced", "inserted", "misspelt"])
def test_one_mistake_is_one_message_on_its_line(kind: str, record_property: pytest.RecordProperty) -> None:
    count: Counter[str] = Counter()
    for path in ACCEPTANCE:
        for line, text in mutations(path, kind):
            found = mistakes(text)
            if found:  # some changes give another right text
                assert found[0].span is not None
                count["all"] += 1
                count["one"] += len(found) == 1
                count["on the line"] += found[0].span.line == line
                count["near"] += abs(found[0].span.line - line) <= 1
    record_property("figures", dict(count))
    assert count["all"] > 15
    assert count["one"] >= 0.95 * count["all"], count
    assert count["on the line"] >= 0.92 * count["all"], count
    assert count["near"] >= 0.98 * count["all"], count


def test_what_stands_around_a_mistake_is_read() -> None:
    text = ACCEPTANCE[0].read_text("utf-8")
    assert not mistakes(text)
    for old, new in (("sends    cfp", "sendz    cfp"), ("outcome", "outcom"), ("plays", "play")):
        assert len(mistakes(text.replace(old, new))) == text.count(old)


def test_two_mistakes_in_neighbouring_entries_are_two() -> None:
    text = "aip a {\n  clause at most x\n  clause A befor B\n  outcom x\n  participnt b { process = A }\n}\n"
    assert [item.span.line for item in mistakes(text) if item.span] == [2, 3, 4, 5]
