"""Where a parser that has lost its way finds it again."""

from __future__ import annotations

import re
from functools import cache, lru_cache

from aseme_dsl.diagnostics import closest
from aseme_dsl.grammar.text.lexer import Tokens
from aseme_dsl.records import dataclass

_NAME = r"[A-Za-z_]\w*"
# How declarations begin: such that nothing in a block begins so, and others, which count at the margin only.
_CLOSED_DECLARATION = (
    rf"(?:enum|message|topic|aip|(?:abstract\s+)?srm|statechart|team)\s+{_NAME}\s*(?:under\b|radio\b|\{{)|(?:sag|suc)\s*\{{"
    r'|(?:scenario|property)\s*"'
)
_OPEN_DECLARATION = (
    rf'system\s+{_NAME}|import\s+(?:{_NAME}|")|function\s+{_NAME}\s*\(|let\s+{_NAME}\s*=(?!=)|language\s+[0-9]'
    rf"|(?:enum|message|topic|aip|(?:abstract\s+)?srm|statechart|team)\s+{_NAME}|(?:sag|suc)\b"
)
_FORMULA = rf"{_NAME}\s*(?:\([\w\s,:]*\)\s*)?=(?!=)"
_LABELS = r"[0-9]+(?:\.[0-9]+)*\s*[-=]"
_BEGINS_BY_NAME = rf"{_FORMULA}|{_LABELS}"

CLOSED_DECLARATION = re.compile(_CLOSED_DECLARATION)
"""What begins a declaration even where a brace before it is not closed."""
_DECLARATION_AT_MARGIN = re.compile(_OPEN_DECLARATION)


@dataclass(frozen=True, slots=True)
class Block:
    """A kind of block, and how to recognise where its next entry begins.

    `words` begin entries, `clauses` continue them. `entry` is None where an entry begins with any name: then
    the next line, or what follows one of `separators`, is taken for the next entry. `around` names the
    blocks in which this one stands.
    """

    words: tuple[str, ...]
    entry: str | None
    clauses: tuple[str, ...] = ()
    around: tuple[str, ...] = ()
    separators: tuple[str, ...] = ()


def _words(words: str) -> str:
    return rf"(?:{'|'.join(words.split())})\b"


def _block(words: str, entry: str = "", clauses: str = "", around: str = "") -> Block:
    patterns = [pattern for pattern in (_words(words) if words else "", entry) if pattern]
    return Block(tuple(words.split()), "|".join(patterns), tuple(clauses.split()), tuple(around.split()))


def _names(clauses: str = "", around: str = "", separators: str = "") -> Block:
    return Block((), None, tuple(clauses.split()), tuple(around.split()), tuple(separators))


BLOCKS: dict[str, Block] = {
    "JunkDeclaration": Block(
        tuple(
            "language system import enum message topic function let sag suc aip srm statechart team scenario"
            " property".split()
        ),
        rf"{_CLOSED_DECLARATION}|{_OPEN_DECLARATION}",
    ),
    "JunkConstant": _names(separators=",;"),
    "JunkField": _names("optional repeated", separators=",;"),
    "JunkTopic": _block("signal state data", clauses="from every expires queued persist"),
    "JunkActor": _block("actor"),
    "JunkGoal": _block("goal", clauses="depends on", around="JunkActor"),
    "JunkSuc": _block("role usecase", clauses="by includes realises"),
    "JunkAip": _block("participant outcome clause let control"),
    "JunkParticipant": _block(
        "engage plays var given result let sends receives process", _FORMULA, around="JunkAip"
    ),
    "JunkControl": _block(
        "enter skip repeat leave start finish on exit resume", _LABELS, around="JunkAip JunkSrm"
    ),
    "JunkSrm": _block("includes plays capability var let liveness activities modules functionality control"),
    "JunkFormula": _block("", _FORMULA, around="JunkSrm"),
    "JunkActivity": _names(
        "every takes simulated waits within as uses reads writes ends guarantees", around="JunkSrm"
    ),
    "JunkModule": _names(
        "every takes simulated waits within as uses reads writes ends guarantees", around="JunkSrm"
    ),
    "JunkFunctionality": _block("technology permissions environment algorithm", around="JunkSrm"),
    "JunkChart": _block("state var let activities modules", _LABELS, clauses="activity"),
    "JunkAgents": _names("with"),
}
"""The blocks, by the name of the Junk terminal that skips text in them."""

_ENTRY_WORDS = frozenset(("abstract", *(word for block in BLOCKS.values() for word in block.words)))

# What begins an entry of a block around and cannot be an entry of the block itself.
_OUTER = {
    "JunkActor": rf"actor\s+{_NAME}\s*\{{",
    "JunkAip": (
        rf'participant\s+{_NAME}\s*[\[{{]|outcome\s*"|clause\s+(?:at\s+most|every|\(|{_NAME}\s*@)|control\s+{_NAME}(?:\s+reactive)?(?:\s+first)?\s*\{{'
    ),
    "JunkSrm": (
        rf"includes\s+{_NAME}|plays\s+{_NAME}\s*\.|liveness\s*\{{|activities\s*\{{|modules\s*\{{|functionality\s+{_NAME}\s*\{{|control\s+{_NAME}(?:\s+reactive)?(?:\s+first)?\s*\{{"
        rf'|capability\s+{_NAME}\s*["=]|var\s+{_NAME}\s*:'
    ),
}


@cache
def _pattern(text: str) -> re.Pattern[str]:
    """Compiled where something is wrong; a file without mistakes needs none of them."""
    return re.compile(text)


def declaration_begins(text: str, line: int) -> int | None:
    """Where on the line that begins at `line` a declaration of the file begins; None if none does."""
    start = line
    while text[start : start + 1] in (" ", "\t"):
        start += 1
    if CLOSED_DECLARATION.match(text, start) or (start == line and _DECLARATION_AT_MARGIN.match(text, start)):
        return start
    return None


def begins_declaration(tokens: Tokens, index: int) -> bool:
    """Whether a declaration of the file begins here, and not an entry of a block."""
    if not tokens.begins_line(index):
        return False
    start = tokens.starts[index]
    if CLOSED_DECLARATION.match(tokens.text, start):
        return True
    return tokens.column(index) == 0 and _DECLARATION_AT_MARGIN.match(tokens.text, start) is not None


def is_outside(tokens: Tokens, index: int, block: Block) -> bool:
    """Whether the token begins an entry of a block around `block`."""
    if block is BLOCKS["JunkDeclaration"]:
        return False
    start = tokens.starts[index]
    if any(_pattern(_OUTER[name]).match(tokens.text, start) for name in block.around):
        return True
    return begins_declaration(tokens, index)


@lru_cache(maxsize=1000)
def _is_close(word: str, words: tuple[str, ...]) -> bool:
    """Whether `word` may be meant for one of `words`."""
    return len(word) < 20 and closest(word, words) is not None


def is_stray_brace(tokens: Tokens, index: int) -> bool:
    """Whether a `}` behind something on its line cannot be meant to close a block of several lines.

    It cannot if what follows on the line begins no entry of any block.
    """
    following = index + 1
    if following >= len(tokens) or tokens.begins_line(following):
        return False
    word = tokens.word(following)
    if word == "}" or word in _ENTRY_WORDS:
        return False
    return not _pattern(_BEGINS_BY_NAME).match(tokens.text, tokens.starts[following])


def _begins_entry(tokens: Tokens, index: int, block: Block) -> bool:
    if block is BLOCKS["JunkDeclaration"]:
        return begins_declaration(tokens, index)
    if block.entry is None:
        return tokens.begins_line(index) or tokens.word(index - 1) in block.separators
    return _pattern(block.entry).match(tokens.text, tokens.starts[index]) is not None


def end_of_junk(tokens: Tokens, first: int, wrong: int, block: Block) -> tuple[int, bool]:
    """Where an entry ends that begins with token `first` and has gone wrong at token `wrong`.

    Returns the offset behind it, and whether another entry seems to begin there.
    """
    count = len(tokens)
    wrong = min(wrong, count - 1)
    margin = tokens.indentation(first)
    index = first
    another = False
    while index < count:
        word = tokens.word(index)
        if index > first:
            if word == "}" and block is not BLOCKS["JunkDeclaration"]:
                break
            if is_outside(tokens, index, block):
                break
            beside = tokens.begins_line(index) and tokens.column(index) == margin
            begins = _begins_entry(tokens, index, block) or (beside and _is_close(word, block.words))
            if index >= wrong and begins:
                another = True
                break
        closing = _matching_brace(tokens, index, block) if word == "{" else None
        index = index + 1 if closing is None else closing + 1
    return tokens.ends[index - 1], another


def _matching_brace(tokens: Tokens, opening: int, block: Block) -> int | None:
    """The `}` that belongs to a `{` in junk; None if the `{` itself seems to be what is too much.

    It is when an entry of the block, or of a block around it, begins inside on a line that is not indented.
    """
    closing = tokens.closing.get(opening)
    if closing is None or opening < tokens.doubtful_before < closing:
        return None
    indentation = tokens.indentation(opening)
    for index in range(opening + 1, closing):
        if (
            tokens.begins_line(index)
            and tokens.column(index) <= indentation
            and (_begins_entry(tokens, index, block) or is_outside(tokens, index, block))
        ):
            tokens.doubtful_before = index
            return None
    return closing


def end_of_header(tokens: Tokens, wrong: int, start: int) -> int:
    """The offset behind the `{` that ends a header; `start` if there is none on the line."""
    for index in range(wrong, len(tokens)):
        word = tokens.word(index)
        if word == "}" or tokens.begins_line(index) or word in _ENTRY_WORDS:
            return start
        if word == "{":
            return tokens.ends[index]
    return start
