"""Parts: a file as a sequence of texts that are read one by one, so that only changed parts are read again.

The tree of a part has spans in the part; a `Layout` says where in the file each part begins. Texts that name
lines use unique numbers for the lines of a part (`Numbers`). So such a text does not change when the part
moves. Finally `Lines` replaces these numbers by lines of the file.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import field, replace
from itertools import count, pairwise

from aseme_dsl.diagnostics import Diagnostic, Edit, Related
from aseme_dsl.diagnostics.problems.syntax.entries import NotReadInTime
from aseme_dsl.grammar.parsing.copies import moved
from aseme_dsl.grammar.parsing.parse import MOST_MISTAKES, parse
from aseme_dsl.grammar.text import tree
from aseme_dsl.grammar.text.recovery import BLOCKS, CLOSED_DECLARATION
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span


@dataclass(frozen=True, slots=True)
class Layout:
    """The file of each part, and where in it the part is; other texts are their own files.

    A part that was read with what is around it has two offsets there: at which its text begins, and at which
    begins what it was read for.
    """

    places: Mapping[Source, tuple[Source, int, int]] = field(default_factory=dict)

    def whole(self, span: Span) -> Span:
        """The same place in the file."""
        place = self.places.get(span.source)
        if place is None:
            return span
        file, base, _ = place
        return Span(file, span.start + base, span.end + base)

    def parts_of(self, file: Source) -> tuple[tuple[int, int, Source], ...]:
        """The parts of a file, in its order, each with its two offsets; empty if it was read in one piece."""
        return tuple((base, own, part) for part, (other, base, own) in self.places.items() if other is file)

    def diagnostic(self, item: Diagnostic) -> Diagnostic:
        """The same with all its places in files."""
        spans = [item.span, *(other.span for other in item.related), *(edit.span for edit in item.edits)]
        if not any(span is not None and span.source in self.places for span in spans):
            return item
        return replace(
            item,
            span=None if item.span is None else self.whole(item.span),
            related=tuple(Related(self.whole(other.span), other.message) for other in item.related),
            edits=tuple(Edit(self.whole(edit.span), edit.text) for edit in item.edits),
        )


NO_PARTS = Layout()
"""Of files that were read in one piece."""


# ---- numbers of lines ---------------------------------------------------------------------------------


_DIGITS = 8
"""How many digits the number of a part has, and how many that of a line in it."""


@dataclass(frozen=True, slots=True, eq=False)
class Part(Source):
    """A part of a file, whose first line has the number `above` + 1."""

    above: int = 0

    def position(self, offset: int) -> tuple[int, int]:
        line, column = Source.position(self, offset)
        return line + self.above, column

    def line_start(self, number: int) -> int:
        return Source.line_start(self, number - self.above)

    def line(self, number: int) -> str:
        return Source.line(self, number - self.above)


class Numbers:
    """Gives each part its own numbers for its lines: so long ones, and so begun, that no text has them."""

    def __init__(self) -> None:
        import secrets

        self.beginning = 10**5 + secrets.randbelow(9 * 10**5)
        self._next = count()

    def part(self, path: str, text: str) -> Part:
        """A part with numbers that no other has."""
        above = (self.beginning * 10**_DIGITS + next(self._next)) * 10**_DIGITS
        return Part(path, text, above)


class Lines:
    """The lines of files in texts that were made from parts."""

    def __init__(self, numbers: Numbers) -> None:
        self._pattern = re.compile(rf"{numbers.beginning}(\d{{{_DIGITS}}})(\d{{{_DIGITS}}})")
        self._above: dict[str, int] = {}
        self._known: dict[str, tuple[frozenset[str], tuple[int, ...], str]] = {}
        self._used: dict[str, tuple[frozenset[str], tuple[int, ...], str]] = {}

    def lay_out(self, layout: Layout) -> None:
        """Use this layout from now on. Forget the texts that were not requested since the last call."""
        self._known, self._used = self._used, {}
        self._above = {
            str(part.above)[-2 * _DIGITS : -_DIGITS]: file.position(base)[0] - 1
            for part, (file, base, _) in layout.places.items()
            if isinstance(part, Part)
        }

    def whole(self, text: str) -> str:
        """The text with the lines of files; the same object as before if nothing has changed."""
        known = self._used.get(text) or self._known.get(text)
        parts = known[0] if known else frozenset(found[1] for found in self._pattern.finditer(text))
        above = tuple(self._above[item] for item in parts)
        if known is None or known[1] != above:
            filled = self._pattern.sub(lambda found: str(self._above[found[1]] + int(found[2])), text)
            known = (parts, above, filled if parts else text)
        self._used[text] = known
        return known[2]


# ---- reading ------------------------------------------------------------------------------------------

_BEGINNING = re.compile(
    rf"""
      //[^\n]*
    | /\*(?:[^*]|\*(?!/))*\*/
    | (?P<open>/\*)
    | "(?:[^"\\\n]|\\.)*"?
    | (?P<brace>[{{}}])
    | ^(?P<word>{"|".join(BLOCKS["JunkDeclaration"].words)})\b
    """,
    re.VERBOSE | re.MULTILINE,
)
"""Where a declaration may begin at the margin; what is in comments, texts and braces does not count."""


_NO_BEGINNING = re.compile(
    r"""(?x) \w+\s+ (?: and|or|let|var|control|participant|outcome|clause|engage|sends|receives|process
      |includes|plays|capability|liveness|activities|modules|functionality|state )\b"""
)
"""What an expression before it is not ended by, though it looks like a declaration (see expressions.tx)."""

_NO_NAME = re.compile(
    r"""(?x) system \b (?: \s | //[^\n]*\n | /\*(?:[^*]|\*(?!/))*\*/ )*
      (?: import|enum|message|topic|function|let|sag|suc|aip|srm|statechart|team|abstract ) \b"""
)
"""A system whose name is perhaps none: it depends on what is behind it (see aseme.tx)."""


@dataclass(frozen=True, slots=True)
class InParts:
    """A file that was read in parts. The comments have whole places, all else has those of the parts."""

    file: tree.File
    diagnostics: tuple[Diagnostic, ...]
    layout: Layout = NO_PARTS


Parse = Callable[[Source], tuple[tree.File, tuple[Diagnostic, ...]]]
"""`grammar.parse`, which may be made to raise `TooSlow`."""


class TooSlow(Exception):
    """A text has not been read, because that took too long; says how long."""


@dataclass(frozen=True, slots=True)
class _Read:
    """Declarations that were read from `part`, and what is wrong there; `base` is where their text begins.

    `in_time`: whether it was read; if not, the declarations are those of an earlier text.
    """

    part: Source
    base: int
    language: tree.Number | None
    declarations: tuple[tree.Declaration, ...]
    comments: tuple[tree.Comment, ...]
    diagnostics: tuple[Diagnostic, ...]
    in_time: bool = True


_HEAD = re.compile(r"\s*(\w+\s+\w+)")
"""By what a part is known while it is edited: the word and the name of its declaration."""


_Key = tuple[str, str, str, int]
"""The text before a part, its own and the one behind it, as far as they matter; and the how manieth it is."""


class Parts:
    """Reads the versions of one file, each with what it has read of the one before.

    With `numbers`, the lines of each part have their own. Of a part for which `parse` raises `TooSlow`, what
    was read last counts, and E116 says so. What else it raises is passed on; what was read up to there need
    not be read again.
    """

    def __init__(self, numbers: Numbers | None = None, parse: Parse = parse) -> None:
        self._part = Source if numbers is None else numbers.part
        self._parse = parse
        self._good: dict[str, _Read] = {}
        self._last: tuple[Source, InParts] | None = None
        self._before: dict[_Key, _Read] = {}
        self._now: dict[_Key, _Read] = {}

    def branch(self) -> Parts:
        """Knows the same, and reads what the file might become."""
        made = copy(self)
        made._before, made._good = dict(self._before), dict(self._good)
        return made

    def read(self, source: Source) -> InParts:
        """The tree of a file and what is wrong with its syntax: what `grammar.parse` says, in parts.

        A text that is the same as before is answered with the same objects, its source included.
        """
        if self._last is not None and self._last[0].text == source.text:
            return self._last[1]
        self._now = {}
        try:
            found = self._in_parts(source) or self._in_one(source)
        except Exception:
            self._before |= self._now
            raise
        self._before = self._now
        heads = {head[1] for _, text, _, _ in self._now if (head := _HEAD.match(text))}
        self._good = {head: known for head, known in self._good.items() if head in heads}
        self._last = (source, found)
        return found

    def _in_one(self, source: Source) -> InParts:
        try:
            return InParts(*self._parse(source))
        except TooSlow as slow:
            return InParts(tree.File(source, None, (), ()), (_not_in_time(source, 0, slow),))

    def _in_parts(self, source: Source) -> InParts | None:
        """None where the file cannot be read in parts without a doubt."""
        starts = begins(source.text)
        if starts is None:
            return None
        ends = [*starts[1:], len(source.text)]
        texts = [source.text[start:end] for start, end in zip(starts, ends, strict=True)]
        alone = [self._alone(source.path, text, number) for text, number in _numbered(texts)]
        read: list[tuple[int, _Read]] = []
        index = 0
        while index < len(texts):
            one, following = alone[index], index + 1
            if one.diagnostics and one.in_time:
                # What is broken is read with what is around it, from and to a part that is whole.
                while following < len(texts) and alone[following].diagnostics and alone[following].in_time:
                    following += 1
                around = self._broken(source.path, texts, alone, index, following)
                if around is None:
                    return None
                one = around
            elif index and one.language is not None:
                return None  # it stands at the beginning only
            read.append((starts[index], one))
            index = following
        return _joined(source, read)

    def _alone(self, path: str, text: str, number: int) -> _Read:
        key = ("", text, "", number)
        known = self._before.get(key)
        if known is None:
            part = self._part(path, text)
            try:
                file, diagnostics = self._parse(part)
                known = _Read(part, 0, file.language, file.declarations, file.comments, diagnostics)
            except TooSlow as slow:
                known = self._earlier(part, slow)
        self._now[key] = known
        if not known.diagnostics and (head := _HEAD.match(text)):
            self._good[head[1]] = known
        return known

    def _earlier(self, part: Source, slow: TooSlow) -> _Read:
        """A part that cannot be read now, as it was when it could be."""
        head = _HEAD.match(part.text)
        good = self._good.get(head[1]) if head else None
        said = (_not_in_time(part, 0, slow),)
        if good is None:
            return _Read(part, 0, None, (), (), said, in_time=False)
        language, declarations = moved((good.language, good.declarations), good.part, part)
        return _Read(part, 0, language, declarations, (), said, in_time=False)

    def _broken(
        self, path: str, texts: Sequence[str], alone: Sequence[_Read], first: int, following: int
    ) -> _Read | None:
        """The parts from `first` on, which are broken, up to `following`; None if they do not end there."""
        text = "".join(texts[first:following])
        before = texts[first - 1] if first and alone[first - 1].in_time else ""
        behind = texts[following] if following < len(texts) and alone[following].in_time else ""
        key = (before, text, behind, first)
        known = self._before.get(key)
        if known is None:
            part = self._part(path, before + text + behind)
            begin, end = len(before), len(before) + len(text)
            try:
                file, diagnostics = self._parse(part)
            except TooSlow as slow:
                known = _Read(part, begin, None, (), (), (_not_in_time(part, begin, slow),), in_time=False)
                self._now[key] = known
                return known
            own = tuple(item for item in file.declarations if begin <= item.span.start < end)
            expected = [
                (item.span.start + shift, item.span.end + shift)
                for index, shift in ((first - 1, 0), (following, end))
                if 0 <= index < len(texts) and alone[index].in_time
                for item in alone[index].declarations
            ]
            others = [(item.span.start, item.span.end) for item in file.declarations if item not in own]
            if others != expected or any(item.span.end > end for item in own):
                return None
            if any(not begin <= span.start <= span.end <= end for span in _spans(diagnostics)):
                return None
            comments = tuple(item for item in file.comments if begin <= item.span.start < end)
            known = _Read(part, begin, None if first else file.language, own, comments, diagnostics)
        self._now[key] = known
        return known


def _not_in_time(part: Source, begin: int, slow: TooSlow) -> Diagnostic:
    """E116, on the first line of what was not read."""
    text = part.text[begin:]
    start = begin + len(text) - len(text.lstrip())
    line = part.text.find("\n", start)
    span = Span(part, start, line if line >= 0 else len(part.text))
    return Diagnostic(NotReadInTime(str(slow)), span)


def _spans(diagnostics: Iterable[Diagnostic]) -> Iterator[Span]:
    for item in diagnostics:
        if item.span is not None:
            yield item.span
        yield from (other.span for other in item.related)
        yield from (edit.span for edit in item.edits)


def _numbered(texts: Sequence[str]) -> Iterator[tuple[str, int]]:
    """Each text, and how many before it are the same."""
    seen: dict[str, int] = {}
    for text in texts:
        number = seen[text] = seen.get(text, -1) + 1
        yield text, number


def _joined(source: Source, read: Sequence[tuple[int, _Read]]) -> InParts | None:
    """The file; None if it has more mistakes than are listed."""
    diagnostics = tuple(item for _, one in read for item in one.diagnostics)
    if len(diagnostics) > MOST_MISTAKES:
        return None
    layout = Layout({one.part: (source, start - one.base, start) for start, one in read})
    comments = tuple(
        tree.Comment(item.text, layout.whole(item.span)) for _, one in read for item in one.comments
    )
    declarations = tuple(item for _, one in read for item in one.declarations)
    language = read[0][1].language
    return InParts(tree.File(source, language, declarations, comments), diagnostics, layout)


def begins(text: str) -> list[int] | None:
    """Where the parts of a text begin, the first at 0; None where that cannot be said without a doubt."""
    found = _starts(text)
    if found is None:
        return None
    texts = [text[start:end] for start, end in pairwise([*found, len(text)])]
    if any(one.startswith("let") and _NO_BEGINNING.match(other) for one, other in pairwise(texts)):
        return None
    return None if any(_NO_NAME.match(one) for one in texts[:-1]) else found


def _starts(text: str) -> list[int] | None:
    """Where declarations seem to begin; None where a comment is not closed."""
    found = [0]
    depth = 0
    for item in _BEGINNING.finditer(text):
        if item["brace"] == "{":
            depth += 1
        elif item["brace"]:
            depth = max(0, depth - 1)
        elif item["open"]:
            return None
        elif item["word"] and item.start() and (depth == 0 or CLOSED_DECLARATION.match(text, item.start())):
            depth = 0
            found.append(item.start())
    return found
