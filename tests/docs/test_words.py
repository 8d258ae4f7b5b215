"""Prose keeps the rules of docs/project/style.md: no word to avoid, and no sentence of more than 30 words."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import click
import pytest

from aseme_dsl.cli.program import program
from aseme_dsl.diagnostics import CODES
from tests.docs.prose import (
    ROOT,
    avoided,
    may_be_avoided,
    notes,
    number_of_words,
    prose,
    sentences,
    shown_texts,
    words_to_avoid,
)

MOST_WORDS = 30
MOST_WORDS_OF_A_TITLE = 8
WORDS = words_to_avoid()
PAGES = sorted(
    path
    for path in (
        ROOT / "README.md",
        *(ROOT / "docs").rglob("*.md"),
        *(ROOT / "aseme_dsl/diagnostics/pages").rglob("*.md"),
    )
    if "_build" not in path.parts
    and path.parent != ROOT / "docs/reference/diagnostics"  # made from the pages of the codes
)
PACKAGE = ROOT / "aseme_dsl"
PRINTED = ("codegen/", "grammar/parsing/prepared.py", "grammar/syntax/", "pygments_lexer.py")
"""What prints code: its strings are parts of it."""
MODULES = sorted(
    path.relative_to(PACKAGE).as_posix()
    for path in PACKAGE.rglob("*.py")
    if not path.relative_to(PACKAGE).as_posix().startswith(PRINTED)
)


def _problems(texts: Iterator[str]) -> list[str]:
    found = []
    for text in texts:
        found += [f"{problem}, in {text!r}" for problem in avoided(text, WORDS)]
        for sentence in sentences(text):
            number = number_of_words(sentence)
            if number > MOST_WORDS:
                found.append(f"a sentence of {number} words: {sentence!r}")
    return found


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_the_words_of_a_page(path: Path) -> None:
    assert _problems(prose(path.read_text("utf-8"))) == []


def _help(command: click.Command) -> Iterator[str]:
    yield from prose(command.help or "")
    yield command.short_help or ""
    for parameter in command.params:
        if isinstance(parameter, click.Option) and not parameter.hidden:
            yield from prose(parameter.help or "")
    if isinstance(command, click.Group):
        for name in command.list_commands(click.Context(command)):
            inner = command.get_command(click.Context(command), name)
            if inner is not None:
                yield from _help(inner)


def test_the_words_of_help_texts() -> None:
    assert _problems(_help(program)) == []


def test_the_words_of_titles() -> None:
    assert _problems(prose("\n\n".join(code.title for code in CODES.values()))) == []


def test_the_words_of_messages() -> None:
    """All strings of the package: messages, hints, what commands print, what stands in logs."""
    found = {}
    for module in MODULES:
        strings = shown_texts((PACKAGE / module).read_text("utf-8"))
        texts = [text for text in strings if may_be_avoided(text, WORDS) or text.count(" ") >= MOST_WORDS]
        if problems := _problems(part for text in texts for part in prose(text)):
            found[module] = problems
    assert found == {}


def test_the_words_of_docstrings_and_comments() -> None:
    found = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        name = path.relative_to(PACKAGE).as_posix()
        texts = (part for text in notes(path.read_text("utf-8")) for part in prose(text))
        if problems := _problems(texts):
            found[name] = problems
    assert found == {}


def test_a_title_is_short() -> None:
    long = {
        item.code: item.title
        for item in CODES.values()
        if number_of_words(item.title) > MOST_WORDS_OF_A_TITLE
    }
    assert long == {}


def test_the_table_of_words_is_read() -> None:
    assert WORDS["mend"] == "*fix*" and len(WORDS) > 20


@pytest.mark.parametrize(
    ("python", "problems"),
    [
        ('print("We mend it.")', 1),
        ('"""We mend it."""', 0),
        ('print("mend")', 0),
        ("print(f'We {mend} it.', '`mend` it')", 0),
        ("print(f'We mend {it}.')", 1),
        ("print('It is no ' 'channel.')", 1),
        ("print('This is no longer a channel.')", 0),
    ],
)
def test_what_is_found_in_strings(python: str, problems: int) -> None:
    assert len(_problems(part for text in shown_texts(python) for part in prose(text))) == problems


@pytest.mark.parametrize(
    ("python", "problems"),
    [
        ('"""We mend it."""', 1),
        ('def f():\n    """Text.\n\n    We\n    mend it.\n    """', 1),
        ('name = 1\n"""Mended."""', 1),
        ('"""Keys:\n\n    mend   a key\n\n    mended\n\nWe mend it.\n"""', 1),
        ("name = 1  # `mend` it\n# A way\n# in\n", 1),
        ("text = '# mend'", 0),
        ("a = 1  # a way\nb = 2  # in\n", 0),
    ],
)
def test_what_is_found_in_docstrings_and_comments(python: str, problems: int) -> None:
    assert len(_problems(part for text in notes(python) for part in prose(text))) == problems


@pytest.mark.parametrize(
    ("markdown", "problems"),
    [
        ("We mend\nit.", 1),
        ('It was mended, and `mend` and "[mend](mend.md)" stand here.', 1),
        ("```text\nmend\n```\n\n> mend\n", 0),
        ("It is no channel.", 1),
        ("There is no channel.", 0),
        ("A recommendation.", 0),
        ("| a | mend |\n", 1),
        ("word " * 31 + ".", 1),
        ("word " * 30 + ".", 0),
        ("word " * 20 + ". " + "Word " * 20, 0),
        ("- " + "word " * 20 + "\n- " + "word " * 20, 0),
    ],
)
def test_what_is_found(markdown: str, problems: int) -> None:
    assert len(_problems(prose(markdown))) == problems
