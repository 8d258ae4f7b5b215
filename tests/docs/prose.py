"""The prose of a page: its words without code, quoted output, comments, and the targets of links.

And the prose of a Python file: what it shows (`shown_texts`), and what it says to its readers (`notes`).
"""

from __future__ import annotations

import ast
import inspect
import math
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
STYLE = ROOT / "docs" / "project" / "style.md"

_FENCED = re.compile(r"^( *)(`{3,}|~{3,}).*?^\1?\2[`~]*[ ]*$", re.MULTILINE | re.DOTALL)
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)
_CODE = re.compile(r"(`+)(.+?)\1", re.DOTALL)
_QUOTE = re.compile(r"^>.*$", re.MULTILINE)
_LINK = re.compile(r"!?\[([^][]*)\]\([^)\s]*\)")
_BLOCK = re.compile(r"\n\s*\n|\n(?=\s*(?:[-*]|\d+\.) )|\n(?=#)")
_LISTING = re.compile(r"(?<=:\n\n)(?: {4}.*(?:\n|\Z)|\n(?= {4}))+")
"""An indented block after a colon: code, or a list of names, in a docstring."""
_SENTENCE = re.compile(r"(?<=[.!?])\s+(?=[A-Z_*(])|(?<=:)\s*$")

_RIGHT = re.compile(r"\bthere (is|are) no\b|\bno longer\b", re.IGNORECASE)
"""Words of these are not looked for."""


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


def may_be_avoided(text: str, words: dict[str, str]) -> bool:
    """False if a text has none of the words, which is found quickly."""
    return _any_of(tuple(words)).search(text) is not None


def avoided(text: str, words: dict[str, str]) -> list[str]:
    """The words to avoid that a text has, each with what to write."""
    if not may_be_avoided(text, words):
        return []
    text = _RIGHT.sub("", text)
    return [f"{word!r}: write {instead}" for word, instead in words.items() if _pattern(word).search(text)]


@cache
def _any_of(words: tuple[str, ...]) -> re.Pattern[str]:
    return re.compile("|".join(_pattern(word).pattern for word in words), re.IGNORECASE)


@cache
def _pattern(word: str) -> re.Pattern[str]:
    spaced = r"\s+".join(re.escape(part) for part in word.split())
    return re.compile(rf"(?<![\w-]){spaced}(?:s|es|d|ed)?(?![\w-])", re.IGNORECASE)


def shown_texts(python: str) -> Iterator[str]:
    """The strings of more than one word that are no docstrings; what an f-string inserts stands as `_`."""
    tree = ast.parse(python)
    parts = {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for part in node.values}
    docstrings = {id(constant) for constant in _docstrings(tree)}
    for node in ast.walk(tree):
        match node:
            case ast.Constant(value=str(text)) if id(node) not in parts | docstrings:
                pass
            case ast.JoinedStr(values=values):
                text = "".join(
                    str(part.value) if isinstance(part, ast.Constant) else "`_`" for part in values
                )
            case _:
                continue
        if " " in text.strip():
            yield text


def _docstrings(tree: ast.AST) -> Iterator[ast.Constant]:
    """The strings that stand alone: of modules, classes and functions, and below a name that they explain."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            yield node.value


def notes(python: str) -> Iterator[str]:
    """The docstrings without indented listings, and the comments.

    A comment goes on through the lines below that have nothing else.
    """
    tree = ast.parse(python)
    for constant in _docstrings(tree):
        if isinstance(constant.value, str):
            yield _LISTING.sub("\n", inspect.cleandoc(constant.value))
    comment: list[str] = []
    last = 0
    lines = python.splitlines()
    for number, text in _comments(python, tree):
        stands_alone = lines[number - 1].lstrip().startswith("#")
        if comment and not (stands_alone and number == last + 1):
            yield "\n".join(comment)
            comment = []
        comment.append(text.lstrip("#:! "))
        last = number
    if comment:
        yield "\n".join(comment)


def _comments(python: str, tree: ast.AST) -> Iterator[tuple[int, str]]:
    """The comments with the numbers of their lines. `tokenize` finds the same in five times the time."""
    strings: dict[int, list[tuple[int, float]]] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr) or (
            isinstance(node, ast.Constant) and isinstance(node.value, str | bytes)
        ):
            assert node.end_lineno is not None and node.end_col_offset is not None
            for line in range(node.lineno, node.end_lineno + 1):
                begin = node.col_offset if line == node.lineno else 0
                end = node.end_col_offset if line == node.end_lineno else math.inf
                strings.setdefault(line, []).append((begin, end))
    for number, text in enumerate(python.splitlines(), 1):
        if "#" not in text:
            continue
        line_bytes = text.encode()
        for place in (index for index, byte in enumerate(line_bytes) if byte == ord("#")):
            if not any(begin <= place < end for begin, end in strings.get(number, ())):
                yield number, line_bytes[place:].decode()
                break
