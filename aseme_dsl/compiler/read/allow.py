"""Allow: comments in a source that say which warnings and notes are right as they are, and why.

    // asemec: allow(W300) read from left to right, as in the paper
    robot = A . B | C

At the end of a line the comment is about the problems that begin on the line. On a line of its own it is
about the next line that has something on it: about all that begins there, a whole declaration or block
included. `allow-file`, above the first declaration, is about the file.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import fields, is_dataclass

from aseme_dsl.diagnostics import (
    CODES,
    Diagnostic,
    Edit,
    Severity,
    Suppressed,
    closest,
    has_errors,
    in_order,
)
from aseme_dsl.diagnostics.problems import settings as problems
from aseme_dsl.grammar.parsing.parts import NO_PARTS, Layout
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

_ADDRESSED = re.compile(r"(?://|/\*)\s*asemec\s*:\s*(.*)", re.DOTALL)
_ALLOW = re.compile(r"//\s*asemec\s*:\s*(?P<verb>allow|allow-file)\s*\((?P<codes>[^()]*)\)\s*(?P<reason>.*)")
_VERB = re.compile(r"[\w-]+")
_CODE = re.compile(r"[^\s,]+")
OWN = frozenset(("W010", "W011", "W012", "W013", "W014"))
"""What is wrong with the comments themselves; a comment cannot allow that."""


@dataclass(frozen=True, slots=True)
class _Allow:
    """One code that a comment names, at `place`; it is about what begins in `start … end` of the source."""

    code: str
    place: Span
    comment: tree.Comment
    reason: str
    start: int
    end: int


def allow(
    files: Iterable[tree.File],
    diagnostics: Sequence[Diagnostic],
    unchecked: frozenset[str] = frozenset(),
    layout: Layout = NO_PARTS,
) -> tuple[tuple[Diagnostic, ...], tuple[Suppressed, ...]]:
    """The diagnostics that no comment suppresses, including those of the comments; and the suppressed ones.

    A comment that suppresses nothing is reported only if all checks were made: not if there are errors, and
    not for the codes in `unchecked`, whose checks were left out.
    """
    found: list[Diagnostic] = []
    allows: dict[Source, list[_Allow]] = {}
    for file in files:
        comments = [item for item in file.comments if _ADDRESSED.match(item.text)]
        if comments:
            read = _read(file, layout, comments, [item.code for item in diagnostics], found)
            allows[file.source] = list(read)
    if not allows:
        return tuple(diagnostics), ()
    kept: list[Diagnostic] = []
    suppressed: list[Suppressed] = []
    used: set[int] = set()
    for item in diagnostics:
        fitting = _fitting(item, allows)
        if fitting is None:
            kept.append(item)
        else:
            suppressed.append(Suppressed(item, fitting.place, fitting.reason))
            used.add(id(fitting))
    if not has_errors(diagnostics):
        for known in allows.values():
            found += _useless(known, used, unchecked)
    return in_order((*kept, *found)), tuple(suppressed)


def _fitting(item: Diagnostic, allows: dict[Source, list[_Allow]]) -> _Allow | None:
    """The comment that allows a problem; of several the one that is about the least."""
    if item.span is None or item.severity is Severity.ERROR:
        return None
    fitting = [
        known
        for known in allows.get(item.span.source, ())
        if known.code == item.code and known.start <= item.span.start < known.end
    ]
    return min(fitting, key=lambda known: known.end - known.start, default=None)


def _read(
    file: tree.File,
    layout: Layout,
    comments: Sequence[tree.Comment],
    present: Sequence[str],
    found: list[Diagnostic],
) -> Iterator[_Allow]:
    """Every code that the comments name and that can be allowed; `found` gets what is wrong with them."""
    lines = _Lines(file, layout)
    for comment in comments:
        written = _ALLOW.fullmatch(comment.text)
        if written is None:
            found.append(_not_understood(comment))
            continue
        whole = written["verb"] == "allow-file"
        if whole and lines.first < comment.span.start:
            found.append(Diagnostic(problems.LateAllowFile(), comment.span))
            continue
        start, end = (0, len(file.source.text) + 1) if whole else lines.about(comment)
        reason = written["reason"].strip()
        if not reason:
            found.append(Diagnostic(problems.NoReason(), comment.span))
        codes = [
            (code.group(), _within(comment, written.start("codes") + code.start(), len(code.group())))
            for code in _CODE.finditer(written["codes"])
        ]
        if not codes:
            found.append(_not_understood(comment))
        for code, place in codes:
            problem = _cannot_allow(code, place, present)
            if problem is not None:
                found.append(problem)
            else:
                yield _Allow(code, place, comment, reason, start, end)


def _within(comment: tree.Comment, offset: int, length: int) -> Span:
    start = comment.span.start + offset
    return Span(comment.span.source, start, start + length)


def _not_understood(comment: tree.Comment) -> Diagnostic:
    found = _ADDRESSED.match(comment.text)
    verb = _VERB.match(found[1]) if found is not None else None
    if verb is not None and found is not None and comment.text.startswith("//"):
        near = closest(verb.group(), ("allow", "allow-file"))
        if near is not None and verb.group() not in ("allow", "allow-file"):
            place = _within(comment, found.start(1), len(verb.group()))
            return Diagnostic(problems.CommentNotUnderstood(near), place, fix=near)
    return Diagnostic(problems.CommentNotUnderstood(None), comment.span)


def _cannot_allow(code: str, place: Span, present: Sequence[str]) -> Diagnostic | None:
    if code not in CODES:
        # What is reported in these files is more likely meant than anything else of that look.
        near = closest(code, present)
        likely = near or closest(code, CODES)
        return Diagnostic(problems.NoSuchCode(code, likely), place, fix=near)
    if CODES[code].severity == Severity.ERROR:
        return Diagnostic(problems.ErrorAllowed(code), place)
    if code in OWN:
        return Diagnostic(problems.CommentAllowed(code), place)
    return None


def _useless(allows: Sequence[_Allow], used: set[int], unchecked: frozenset[str]) -> Iterator[Diagnostic]:
    """W011 for what has allowed nothing, with the edit that takes it away."""
    by_comment: defaultdict[tree.Comment, list[_Allow]] = defaultdict(list)
    for item in allows:
        by_comment[item.comment].append(item)
    for comment, items in by_comment.items():
        idle = [item for item in items if id(item) not in used and item.code not in unchecked]
        for item in idle:
            edit = _without(comment) if len(idle) == len(items) else _without_code(comment, item.place)
            yield Diagnostic(problems.NothingToAllow(item.code), item.place, edits=(edit,))


def _without(comment: tree.Comment) -> Edit:
    """Without the comment: with its line if it is alone there, else with the blanks before it."""
    text, start, end = comment.span.source.text, comment.span.start, comment.span.end
    begin = len(text[:start].rstrip(" \t"))
    if begin == 0 or text[begin - 1] == "\n":
        after = re.compile(r"[ \t\r]*\n?").match(text, end)
        end = after.end() if after is not None else end
    return Edit(Span(comment.span.source, begin, end), "")


def _without_code(comment: tree.Comment, place: Span) -> Edit:
    """Without one of several codes, and one of the commas beside it."""
    text = comment.span.source.text
    after = re.compile(r"\s*,\s*").match(text, place.end)
    if after is not None:
        return Edit(Span(place.source, place.start, after.end()), "")
    before = re.search(r"\s*,\s*$", text[comment.span.start : place.start])
    start = comment.span.start + before.start() if before is not None else place.start
    return Edit(Span(place.source, start, place.end), "")


class _Lines:
    """What stands on the lines of a file, and how far that goes which begins on one."""

    def __init__(self, file: tree.File, layout: Layout) -> None:
        from aseme_dsl.grammar.text.lexer import clean

        self.file = file
        self.layout = layout
        self.tokens = clean(file.source).tokens
        self.first = self.tokens.starts[0] if len(self.tokens) else len(file.source.text)

    def about(self, comment: tree.Comment) -> tuple[int, int]:
        """The range in which a problem must begin for the comment to be about it."""
        text, here = self.file.source.text, comment.span.start
        index = self.tokens.at(here)
        line = text.rfind("\n", 0, here) + 1
        if index > 0 and self.tokens.ends[index - 1] > line:
            return line, _end_of_line(text, here)  # something stands before it
        if index == len(self.tokens):
            return here, here  # nothing follows
        start = self.tokens.starts[index]
        end = stop = _end_of_line(text, start)
        while index < len(self.tokens) and self.tokens.starts[index] < stop:
            closing = self.tokens.closing.get(index)
            if closing is not None:
                end = max(end, self.tokens.ends[closing])
            index += 1
        return start, max(end, self._end_of_node(start))

    def _end_of_node(self, start: int) -> int:
        """The end of the largest part of the tree that begins there."""
        end = start
        waiting: list[object] = list(self.file.declarations)
        while waiting:
            node = waiting.pop()
            if isinstance(node, tuple):
                waiting += node
            elif is_dataclass(node) and not isinstance(node, (Source, Span)):
                span = getattr(node, "span", None)
                if isinstance(span, Span):
                    span = self.layout.whole(span)
                if isinstance(span, Span) and not span.start <= start < span.end:
                    continue
                if isinstance(span, Span) and span.start == start:
                    end = max(end, span.end)
                waiting += (getattr(node, item.name) for item in fields(node))
        return end


def _end_of_line(text: str, offset: int) -> int:
    end = text.find("\n", offset)
    return len(text) + 1 if end < 0 else end


__all__ = ["allow"]
