"""The characters of a file: comments, what the language does not have, and the tokens for error messages."""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterable
from functools import cached_property

from aseme_dsl.amola.operators import INFIX_SIGNS, Operator
from aseme_dsl.diagnostics import Diagnostic, Problem
from aseme_dsl.diagnostics.problems.syntax import characters
from aseme_dsl.diagnostics.problems.syntax import entries as problems
from aseme_dsl.grammar.text.tree import Comment
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

HOLE = Operator.HOLE.value
"""What stands for an operator, or a condition, that is still to be chosen."""

_COMMON = r"""
    (?P<comment> //[^\n]* | /\*[\s\S]*?\*/ )
  | (?P<open_comment> /\* )
  | (?P<text> "(?:[^"\\\n]|\\.)*" )
  | (?P<open_text> "[^\n]* )
  | (?P<quoted> ‘[^’\n]*’ | “[^”\n]*” | '[^'\n]*' )
  | (?P<number> (?<![A-Za-z0-9_]) [0-9]\w* (?:\.[0-9]\w*)* )
  | (?P<placeholder> \?\w+\? )
  | (?P<odd> [^\t\n\r -~ω]+ | [$'`\\]+ )
"""
_ASCII = re.compile(_COMMON, re.VERBOSE)
_UNICODE = re.compile(r"(?P<word> [^\W\d]\w* ) | " + _COMMON, re.VERBOSE)

PLACEHOLDER = re.compile(r"\?\w+\?", re.ASCII)
"""A hole as the original tools write it: `?OP?`."""
_QUOTES = re.compile(r'[\\"]')
_END_OF_LINE = re.compile(r"[\s{}]*$")
_ESCAPE = re.compile(r"\\.")
_GOOD_NUMBER = re.compile(r"[0-9]+(?:\.[0-9]+)*|[0-9]+(?:\.[0-9]+)?(?:ms|s|min)", re.ASCII)
OTHER_UNITS = {
    "s": ("sec", "secs", "second", "seconds"),
    "ms": ("msec", "msecs", "millis", "millisecond", "milliseconds"),
    "min": ("mins", "minute", "minutes"),
}
"""What people call the units of durations, too."""
OTHER_TIMES = {
    **dict.fromkeys(("h", "hr", "hrs", "hour", "hours"), ("60", "min")),
    "d": ("1440", "min"),
    "us": ("0.001", "ms"),
    "ns": ("0.000001", "ms"),
}
"""Units of time that durations do not have, and how long each is."""

_NUMBER_AND_UNIT = re.compile(r"([0-9]+(?:\.[0-9]+)?)([^\W\d]+)")

# What people paste from texts, and what they meant; one character each, so that all places stay.
_MEANT = {
    "“": '"',
    "”": '"',
    "„": '"',
    "–": "-",
    "—": "-",
    "−": "-",
    "·": ".",
    "∥": "|",
    "‖": "|",
    "∧": "&",
    "∨": "|",
    "¬": "!",
    "≤": "<",
    "≥": ">",
    "≠": "<",
    "→": ">",
    "∼": "~",
    "˜": "~",
    "Ω": "~",
}
_WRITTEN = {"∥": "||", "‖": "||", "∧": "&&", "∨": "||", "≤": "<=", "≥": ">=", "≠": "!=", "→": "->"}


@dataclass(frozen=True)
class Lexed:
    """A file without comments and odd characters; `text` has the same places as the source."""

    source: Source
    text: str
    comments: tuple[Comment, ...]
    diagnostics: tuple[Diagnostic, ...]

    @cached_property
    def tokens(self) -> Tokens:
        """Only error messages need the tokens of the whole file."""
        return Tokens(self.text)


class Tokens:
    """Where the tokens of a text are."""

    _TOKEN = re.compile(
        r'"(?:[^"\\\n]|\\.)*"|[0-9]+(?:\.[0-9]+)*[A-Za-z_0-9]*|\w+|&&|[-+*<>=!]=|->|\.\.|'
        + "".join(f"{re.escape(sign)}|" for sign in INFIX_SIGNS if len(sign) > 1)
        + r"\S",
        re.ASCII,
    )

    def __init__(self, text: str) -> None:
        self.text = text
        self.starts: list[int] = []
        self.ends: list[int] = []
        for found in self._TOKEN.finditer(text):
            self.starts.append(found.start())
            self.ends.append(found.end())
        self.missing: list[int] = []  # before which token a `{` is missing (terminals.py)
        self.doubtful_before = -1  # braces that are closed beyond this token are not trusted (recovery.py)

    @cached_property
    def closing(self) -> dict[int, int]:
        """The index of the `}` of each `{` that has one."""
        return self._pairs(())

    @cached_property
    def closing_with_missing(self) -> dict[int, int]:
        """The same when each `{` that the parser has missed counts as written; ask when it has finished."""
        return self._pairs(self.missing)

    def _pairs(self, missing: Iterable[int]) -> dict[int, int]:
        pairs: dict[int, int] = {}
        open_: list[int] = []
        before = dict.fromkeys(missing)
        for index in range(len(self)):
            if index in before:
                open_.append(-1)
            word = self.word(index)
            if word == "{":
                open_.append(index)
            elif word == "}" and open_:
                pairs[open_.pop()] = index
        pairs.pop(-1, None)
        return dict(sorted(pairs.items()))

    def __len__(self) -> int:
        return len(self.starts)

    def at(self, offset: int) -> int:
        """The index of the first token that ends after `offset`; the number of tokens if there is none."""
        return bisect_right(self.ends, offset)

    def word(self, index: int) -> str:
        """The token as it is written; empty beyond the last one."""
        if not 0 <= index < len(self.starts):
            return ""
        return self.text[self.starts[index] : self.ends[index]]

    def begins_line(self, index: int) -> bool:
        """Whether nothing but blanks stands before the token on its line."""
        return index == 0 or "\n" in self.text[self.ends[index - 1] : self.starts[index]]

    def column(self, index: int) -> int:
        """The number of characters before the token on its line."""
        return self.starts[index] - (self.text.rfind("\n", 0, self.starts[index]) + 1)

    def indentation(self, index: int) -> int:
        """The column of the first token on the token's line."""
        line = self.text.rfind("\n", 0, self.starts[index]) + 1
        return self.column(bisect_left(self.starts, line))


def clean(source: Source) -> Lexed:
    """Blank out the comments, and report and replace what the language does not have."""
    return _Cleaner(source).run()


def _wrong_unit(number: str, unit: str) -> tuple[Problem, str | None]:
    """What is wrong with `6m` or `3sec`, and the fix where it is certain."""
    meant = next((known for known, others in OTHER_UNITS.items() if unit.lower() in (known, *others)), None)
    if meant is not None:
        length = f"{number}{meant}"
        return characters.NoUnitOfTime(number, unit, length), length
    if unit in OTHER_TIMES:
        from decimal import Decimal  # only for a mistake: a start of the command does not pay for it

        each, known = OTHER_TIMES[unit]
        length = f"{(Decimal(number) * Decimal(each)).normalize():f}{known}"
        return characters.NoUnitOfTime(number, unit, length), None
    return characters.NumberWithUnit(number, unit), None


class _Cleaner:
    def __init__(self, source: Source) -> None:
        self.source = source
        self.replaced: list[tuple[int, str]] = []
        self.comments: list[Comment] = []
        self.diagnostics: list[Diagnostic] = []

    def run(self) -> Lexed:
        text = self.source.text
        begin = 0
        if text.startswith("\ufeff"):
            self.replaced.append((0, " "))
            begin = 1
        pattern = _ASCII if text.isascii() else _UNICODE
        handlers: dict[str, Callable[[str, int], int | None]] = {
            "comment": self._comment,
            "open_comment": self._open_comment,
            "text": self._text,
            "open_text": self._open_text,
            "quoted": self._quoted,
            "number": self._number,
            "placeholder": self._placeholder,
            "word": self._word,
            "odd": self._odd,
        }
        offset = begin
        while (found := pattern.search(text, offset)) is not None:
            handle = handlers[found.lastgroup or ""]
            offset = handle(found.group(), found.start()) or found.end()
        return Lexed(self.source, self._cleaned(), tuple(self.comments), tuple(self.diagnostics))

    def _cleaned(self) -> str:
        text = self.source.text
        if not self.replaced:
            return text
        parts: list[str] = []
        done = 0
        for start, replacement in self.replaced:
            parts += [text[done:start], replacement]
            done = start + len(replacement)
        return "".join([*parts, text[done:]])

    def _span(self, start: int, end: int) -> Span:
        return Span(self.source, start, end)

    def _report(self, problem: Problem, start: int, end: int, fix: str | None = None) -> None:
        self.diagnostics.append(Diagnostic(problem, self._span(start, end), fix=fix))

    def _comment(self, text: str, start: int) -> None:
        self.comments.append(Comment(text.rstrip("\r"), self._span(start, start + len(text.rstrip("\r")))))
        self.replaced.append((start, _blank(text)))

    def _open_comment(self, text: str, start: int) -> int:
        self._report(problems.CommentNotClosed(), start, start + 2)
        end = len(self.source.text)
        self.replaced.append((start, _blank(self.source.text[start:])))
        return end

    def _text(self, text: str, start: int) -> None:
        if "\\" not in text:
            return
        for escape in _ESCAPE.finditer(text):
            if escape.group() not in ('\\"', "\\\\"):
                begin = start + escape.start()
                self._report(characters.NoEscape(escape.group()), begin, begin + 2)

    def _open_text(self, text: str, start: int) -> int:
        text = _END_OF_LINE.sub("", text)  # braces at its end are rather those of a block
        end = start + len(text)
        self._report(characters.TextNotClosed(), start, end)
        meant = " " if len(text) == 1 else '"' + _QUOTES.sub("_", text[1:-1]) + '"'
        self.replaced.append((start, meant))
        return end

    def _quoted(self, text: str, start: int) -> None:
        self._report(
            characters.TextInOtherQuotes(),
            start,
            start + len(text),
            fix='"' + text[1:-1].replace("\\", "\\\\").replace('"', '\\"') + '"',
        )
        self.replaced.append((start, '"' + _QUOTES.sub("_", text[1:-1]) + '"'))

    def _number(self, text: str, start: int) -> None:
        if _GOOD_NUMBER.fullmatch(text):
            return
        end = start + len(text)
        unit = _NUMBER_AND_UNIT.fullmatch(text)
        if unit is not None:
            problem, fix = _wrong_unit(unit[1], unit[2])
            self._report(problem, start, end, fix)
            self.replaced.append((start, "0" * (len(text) - 1) + "s"))
        else:
            self._report(characters.NeitherNumberNorName(text), start, end)
            self.replaced.append((start, "0" * len(text)))

    def _placeholder(self, text: str, start: int) -> None:
        """The `?OP?` of the original tools is a hole, as `?` is."""
        self.replaced.append((start, HOLE + " " * (len(text) - 1)))

    def _word(self, text: str, start: int) -> None:
        if text.isascii() or text == "ω":
            return
        if (
            text[-1] == "ω" and text[:-1].isascii()
        ):  # as the papers write it; names are ASCII, so it ends here
            self.replaced.append((start, text[:-1] + "~"))
            return
        end = start + len(text)
        meant = "".join(c if c.isascii() else "_" for c in text)
        forever = text[:-1] if text[-1] == "Ω" and text[:-1].isascii() else None
        if forever is not None:
            meant = forever + "~"
        fix = meant if forever is not None else None
        self._report(characters.CharactersInName(text, forever), start, end, fix)
        self.replaced.append((start, meant))

    def _odd(self, text: str, start: int) -> int:
        fix = None
        if text[0] in _MEANT:
            text = text[0]
            fix = _WRITTEN.get(text, _MEANT[text])
        elif text.isspace():
            fix = " "
        self._report(characters.OddCharacters(text, fix), start, start + len(text), fix)
        self.replaced.append((start, _MEANT.get(text, " " * len(text))))
        return start + len(text)


def _blank(text: str) -> str:
    return re.sub(r"[^\n]", " ", text)
