"""The prose of a page: its words without code, quoted output, comments, and the targets of links."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
STYLE = ROOT / "docs" / "project" / "style.md"

_FENCED = re.compile(r"^( *)(`{3,}|~{3,}).*?^\1?\2[`~]*[ ]*$", re.MULTILINE | re.DOTALL)
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_CODE = re.compile(r"(`+)(.+?)\1", re.DOTALL)
_QUOTE = re.compile(r"^>.*$", re.MULTILINE)
_LINK = re.compile(r"!?\[([^][]*)\]\([^)\s]*\)")
_BLOCK = re.compile(r"\n\s*\n|\n(?=\s*(?:[-*]|\d+\.) )|\n(?=#)")
_SENTENCE = re.compile(r"(?<=[.!?])\s+(?=[A-Z_*(])|(?<=:)\s*$")


def prose(markdown: str) -> Iterator[str]:
    """The paragraphs, headings, items of lists and cells of tables of a page; code stands as `_`."""
    text = re.sub(r"\A---\n.*?\n---\n", "", markdown, flags=re.DOTALL)
    for pattern in (_FENCED, _COMMENT, _QUOTE):
        text = pattern.sub("\n", text)
    text = _CODE.sub("_", text)
    text = _LINK.sub(r"\1", text)
    for block in _BLOCK.split(text):
        if not block.lstrip().startswith("|"):
            yield from _cleaned(block.lstrip(" #-*\n"))
            continue
        for line in block.splitlines():
            for cell in re.split(r"(?<!\\)\|", line):
                yield from _cleaned(cell)


def _cleaned(text: str) -> Iterator[str]:
    words = " ".join(text.split())
    if re.search(r"\w", words):
        yield words


def sentences(text: str) -> list[str]:
    """The sentences of a paragraph."""
    return [part for part in _SENTENCE.split(text) if part]


def number_of_words(sentence: str) -> int:
    """How many words a sentence has; a piece of code is one."""
    return sum(bool(re.search(r"\w", word)) for word in sentence.split())


def words_to_avoid(page: Path = STYLE) -> dict[str, str]:
    """Each word to avoid with what to write, from the tables of the style guide."""
    found = {}
    for line in page.read_text("utf-8").splitlines():
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if len(cells) == 2 and cells[0].startswith("`"):
            found.update(dict.fromkeys(re.findall(r"`([^`]+)`", cells[0]), cells[1]))
    return found


def avoided(text: str, words: dict[str, str]) -> list[str]:
    """The words to avoid that a text has, each with what to write."""
    text = re.sub(r"\bthere (is|are) no\b", "", text, flags=re.IGNORECASE)
    return [f"{word!r}: write {instead}" for word, instead in words.items() if _pattern(word).search(text)]


def _pattern(word: str) -> re.Pattern[str]:
    spaced = r"\s+".join(re.escape(part) for part in word.split())
    return re.compile(rf"(?<![\w-]){spaced}(?:s|es|d|ed)?(?![\w-])", re.IGNORECASE)
