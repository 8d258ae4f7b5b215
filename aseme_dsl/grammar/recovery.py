"""Where a parser that has lost its way finds it again."""

from __future__ import annotations

import re
from dataclasses import dataclass

from aseme_dsl.grammar.lexer import Tokens

_NAME = r"[A-Za-z_]\w*"
_CLOSED_DECLARATION = (
    rf"(?:enum|message|topic|aip|srm|statechart|team)\s+{_NAME}\s*(?:under\b|radio\b|\{{)|(?:sag|suc)\s*\{{"
    r'|(?:scenario|property)\s*"'
)
_OPEN_DECLARATION = (
    rf'system\s+{_NAME}|import\s+(?:{_NAME}|")|function\s+{_NAME}\s*\(|let\s+{_NAME}\s*=(?!=)|language\s+[0-9]'
    rf"|(?:enum|message|topic|aip|srm|statechart|team)\s+{_NAME}|(?:sag|suc)\b"
)
_FORMULA = rf"{_NAME}\s*=(?!=)"
_LABELS = r"[0-9]+(?:\.[0-9]+)*\s*->"
_BEGINS_BY_NAME = re.compile(rf"{_FORMULA}|{_LABELS}")

_DECLARATION = re.compile(_CLOSED_DECLARATION)
_DECLARATION_AT_MARGIN = re.compile(_OPEN_DECLARATION)


@dataclass(frozen=True, slots=True)
class Block:
    """A kind of block: the words that begin its entries, and how to recognise where the next one begins.

    `entry` is None where an entry begins with any name: then the next line, or what follows one of
    `separators`, is taken for the next entry.
    """

    words: tuple[str, ...]
    entry: re.Pattern[str] | None
    around: tuple[str, ...] = ()
    separators: str = ""


def _block(words: str, entry: str | None, *around: str) -> Block:
    return Block(tuple(words.split()), re.compile(entry) if entry else None, around)


def _any(words: str) -> str:
    return rf"(?:{'|'.join(words.split())})\b"


_AIP = "participant outcome clause let control"
_SRM = "plays capability var let liveness activities functionality control"
_PARTICIPANT = "engage var let sends receives process"
_VERBS = "enter skip repeat leave start finish"

BLOCKS: dict[str, Block] = {
    "JunkDeclaration": _block(
        "language system import enum message topic function let sag suc aip srm statechart team scenario"
        " property",
        rf"{_CLOSED_DECLARATION}|{_OPEN_DECLARATION}",
    ),
    "JunkConstant": Block((), None, separators=",;"),
    "JunkField": Block(("optional", "repeated"), None, separators=",;"),
    "JunkTopic": _block("signal state data from every queued persist", _any("signal state data")),
    "JunkActor": _block("actor", _any("actor")),
    "JunkGoal": _block("goal depends on", _any("goal"), "JunkActor"),
    "JunkSuc": _block("role usecase by includes realises", _any("role usecase")),
    "JunkAip": _block(_AIP, _any(_AIP)),
    "JunkParticipant": _block(_PARTICIPANT, rf"{_any(_PARTICIPANT)}|{_FORMULA}", "JunkAip"),
    "JunkControl": _block(_VERBS, rf"{_any(_VERBS)}|{_LABELS}", "JunkAip", "JunkSrm"),
    "JunkSrm": _block(_SRM, _any(_SRM)),
    "JunkFormula": _block("", _FORMULA, "JunkSrm"),
    "JunkActivity": _block("every takes as uses reads writes", None, "JunkSrm"),
    "JunkFunctionality": _block(
        "technology permissions environment algorithm",
        _any("technology permissions environment algorithm"),
        "JunkSrm",
    ),
    "JunkChart": _block(
        "state var let activities activity", rf"{_any('state var let activities')}|{_LABELS}"
    ),
    "JunkAgents": _block("", rf"{_NAME}\s*[,:\[]"),
}
"""By the name of the terminal that takes what is no entry."""

# What begins an entry of a block around and cannot be an entry of the block itself.
_OUTER = {
    "JunkActor": re.compile(rf"actor\s+{_NAME}\s*\{{"),
    "JunkAip": re.compile(
        rf'participant\s+{_NAME}\s*[\[{{]|outcome\s*"|clause\s+(?:at\s+most|every|\(|{_NAME}\s*@)|control\s+{_NAME}\s*\{{'
    ),
    "JunkSrm": re.compile(
        rf"plays\s+{_NAME}\s*\.|liveness\s*\{{|activities\s*\{{|functionality\s+{_NAME}\s*\{{|control\s+{_NAME}\s*\{{"
        rf'|capability\s+{_NAME}\s*["=]|var\s+{_NAME}\s*:'
    ),
}


def begins_declaration(tokens: Tokens, index: int) -> bool:
    """Whether a declaration of the file begins here, and not an entry of a block."""
    if not tokens.begins_line(index):
        return False
    start = tokens.starts[index]
    if _DECLARATION.match(tokens.text, start):
        return True
    return tokens.column(index) == 0 and _DECLARATION_AT_MARGIN.match(tokens.text, start) is not None


def _begins_outer(tokens: Tokens, index: int, block: Block) -> bool:
    if block is BLOCKS["JunkDeclaration"]:
        return False
    start = tokens.starts[index]
    if any(_OUTER[name].match(tokens.text, start) for name in block.around):
        return True
    return begins_declaration(tokens, index)


def is_outside(tokens: Tokens, index: int, block: Block) -> bool:
    """Whether the token begins an entry of a block around `block`."""
    return block is not BLOCKS["JunkDeclaration"] and _begins_outer(tokens, index, block)


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
    return not _BEGINS_BY_NAME.match(tokens.text, tokens.starts[following])


def _begins_entry(tokens: Tokens, index: int, block: Block) -> bool:
    if block is BLOCKS["JunkDeclaration"]:
        return begins_declaration(tokens, index)
    if block.entry is None:
        return tokens.begins_line(index) or tokens.word(index - 1) in tuple(block.separators)
    return block.entry.match(tokens.text, tokens.starts[index]) is not None


def end_of_junk(tokens: Tokens, first: int, wrong: int, block: Block) -> int:
    """The offset behind an entry that begins with token `first` and has gone wrong at token `wrong`."""
    count = len(tokens)
    wrong = min(wrong, count - 1)
    index = first
    while index < count:
        word = tokens.word(index)
        if index > first:
            if word == "}" and block is not BLOCKS["JunkDeclaration"]:
                break
            if index >= wrong and _begins_entry(tokens, index, block):
                break
            if _begins_outer(tokens, index, block):
                break
        closing = _matching_brace(tokens, index, block) if word == "{" else None
        index = index + 1 if closing is None else closing + 1
    return tokens.ends[index - 1]


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
            and (_begins_entry(tokens, index, block) or _begins_outer(tokens, index, block))
        ):
            tokens.doubtful_before = index
            return None
    return closing


def end_of_header(tokens: Tokens, wrong: int, start: int) -> int:
    """The offset behind the `{` that ends a header; `start` if there is none on the line."""
    for index in range(wrong, len(tokens)):
        word = tokens.word(index)
        if word == "}" or tokens.begins_line(index) or _is_entry_word(tokens, index):
            return start
        if word == "{":
            return tokens.ends[index]
    return start


def _is_entry_word(tokens: Tokens, index: int) -> bool:
    return tokens.word(index) in _ENTRY_WORDS


_ENTRY_WORDS = frozenset(
    word
    for block in BLOCKS.values()
    for word in block.words
    if word not in ("from", "every", "queued", "persist", "on")
)
