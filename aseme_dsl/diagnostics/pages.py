"""Pages: explain each diagnostic code to users, with an example that produces it and one that does not.

The page of a code is `pages/CODE.md`; its title and severity stand in the table of codes. A page has an
explanation in Markdown, and then fenced blocks. The words after the language of a block say its purpose:

    ```aseme wrong                      the file team.aseme of the example that has the problem
    ```aseme right                      the same file of the example that has it not
    ```aseme wrong file=other.aseme     another file of the example
    ```aseme both file=other.aseme      a file of both examples
    ```console wrong                    commands, and what they say, after the files are written

Without `file=`, a block of a language in `FILES` is the file named there. A console example is for
diagnostics that do not come from compiling a text alone; only the tests run its commands.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from importlib import resources
from pathlib import Path

from aseme_dsl.diagnostics.codes import CODES
from aseme_dsl.records import dataclass

FILES = {"aseme": "team.aseme", "toml": "pyproject.toml", "proto": "messages.proto"}
"""What the file of a block is called, by its language."""

_USES = ("wrong", "right", "both")


@dataclass(frozen=True, slots=True)
class File:
    """A file of an example; `language` is what colours it (`aseme`, `toml`, `proto`, `python`, `text`)."""

    name: str
    language: str
    text: str


@dataclass(frozen=True, slots=True)
class Example:
    """A small project. `console` are commands (`$ …`) with what they say, or empty: it is to be compiled."""

    files: tuple[File, ...]
    console: str = ""


@dataclass(frozen=True, slots=True)
class Page:
    """What there is to know of a code. `text` is Markdown: paragraphs with code in backquotes, and lists."""

    code: str
    severity: str
    title: str
    text: str
    wrong: Example
    right: Example


def file_of(code: str) -> Path | None:
    """The path of the page of a code; None if it has no page, or the package is not installed as files."""
    path = Path(__file__).parent / "pages" / f"{code}.md"
    return path if path.is_file() else None


@cache
def page(code: str) -> Page:
    """The page of a code.

    Raises:
        KeyError: There is no such code, or it has no page.
        ValueError: The page is malformed; the text says how.
    """
    entry = CODES[code]
    file = resources.files("aseme_dsl.diagnostics") / "pages" / f"{code}.md"
    if not file.is_file():
        raise KeyError(code)
    try:
        text, parts = _parts(file.read_text("utf-8"))
        wrong, right = (_example(parts, use) for use in ("wrong", "right"))
    except ValueError as problem:
        raise ValueError(f"{code}.md: {problem}") from None
    return Page(code, entry.severity, entry.title, text, wrong, right)


def markdown(page: Page) -> str:
    """A page as Markdown for other tools, without its title."""
    return "\n\n".join([page.text, "**Wrong**", *blocks(page.wrong), "**Right**", *blocks(page.right)])


def blocks(example: Example) -> list[str]:
    """The files of an example, with their names where one alone would not be clear, and its console."""
    found = []
    several = len(example.files) > 1 or any(file.language != "aseme" for file in example.files)
    for file in example.files:
        if several:
            found.append(f"`{file.name}`:")
        found.append(fenced(file.language, file.text))
    return [*found, *([fenced("console", example.console)] if example.console else [])]


def fenced(language: str, text: str) -> str:
    """A block of Markdown."""
    return f"```{language}\n{text.rstrip()}\n```"


@dataclass(frozen=True, slots=True)
class _Block:
    use: str
    language: str
    name: str
    text: str


def _parts(text: str) -> tuple[str, list[_Block]]:
    """The explanation and the blocks of a page."""
    before, *rest = re.split(r"^(?=```)", text, maxsplit=1, flags=re.MULTILINE)
    explanation = before.strip()
    if not explanation:
        raise ValueError("it begins with an explanation")
    return explanation, list(_blocks("".join(rest)))


def _blocks(text: str) -> Iterator[_Block]:
    lines = iter(text.splitlines())
    for line in lines:
        if not line.strip():
            continue
        fence = re.fullmatch(r"```(\w+) (\w+)(?: file=(\S+))?", line)
        if fence is None or fence[2] not in _USES:
            raise ValueError(f"`{line}`: expected a block such as ```aseme wrong")
        inside: list[str] = []
        for other in lines:
            if other == "```":
                break
            inside.append(f"{other}\n")
        else:
            raise ValueError(f"`{line}` is not closed")
        language = fence[1]
        name = fence[3] or FILES.get(language, "")
        if not name and language != "console":
            raise ValueError(f"`{line}`: which file is it?")
        yield _Block(fence[2], language, name, "".join(inside))


def _example(blocks: list[_Block], use: str) -> Example:
    """The blocks of one use, and those of both."""
    if not any(block.use == use for block in blocks):
        raise ValueError(f"it has no {use} example")
    mine = [block for block in blocks if block.use in (use, "both")]
    files = tuple(File(block.name, block.language, block.text) for block in mine if block.name)
    return Example(files, "".join(block.text for block in mine if not block.name))
