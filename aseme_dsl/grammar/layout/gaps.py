"""Gaps: the blanks and comments between two tokens of a file."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence

from aseme_dsl.grammar.layout.pieces import ORDER, Gap
from aseme_dsl.grammar.text.tree import Comment


class Gaps:
    """The gaps of one text, by the places of the tokens around them."""

    def __init__(self, text: str, comments: Sequence[Comment]) -> None:
        self._text = text
        self._comments = comments
        self._starts = [comment.span.start for comment in comments]

    def between(self, end: int, start: int) -> Gap:
        """The gap between the end of a token and the start of the next one."""
        first = bisect_left(self._starts, end)
        last = bisect_left(self._starts, start)
        if first == last:
            newlines = self._text.count("\n", end, start)
            return Gap(blank=newlines > 1, newline=newlines > 0)
        lines: list[tuple[bool, int, list[str]]] = [(False, 0, [])]
        at = end
        for comment in self._comments[first:last]:
            newlines = self._text.count("\n", at, comment.span.start)
            column = comment.span.start - self._text.rfind("\n", 0, comment.span.start)
            if newlines or not lines[-1][2]:
                line = (newlines > 1, column, [_comment(comment.text)])
                lines = [*lines, line] if newlines else [line]
            else:
                lines[-1][2].append(_comment(comment.text))
            at = comment.span.end
        newlines = self._text.count("\n", at, start)
        if newlines:
            lines.append((newlines > 1, 0, []))
        (_, column, trailing), *own = lines
        if not own:
            return Gap(leading=tuple(trailing))
        blank, _, leading = own.pop()
        hanging: list[str] = []
        while own and trailing and end and own[0][0] is False and own[0][1] == column:
            if ORDER.search(own[0][2][0]):
                break
            hanging.append(" ".join(own.pop(0)[2]))
        return Gap(
            tuple(trailing),
            tuple(hanging),
            tuple((above, " ".join(texts)) for above, _, texts in own),
            tuple(leading),
            blank,
            newline=True,
        )

    def after(self, end: int) -> Gap:
        """The gap between the end of a token and the next one: all blanks and comments up to that."""
        at = end
        index = bisect_left(self._starts, at)
        while at < len(self._text):
            if index < len(self._comments) and self._starts[index] == at:
                at = self._comments[index].span.end
                index += 1
            elif self._text[at].isspace():
                at += 1
            else:
                break
        return self.between(end, at)

    def has_comment(self, start: int, end: int) -> bool:
        """Whether a comment begins in this part of the text."""
        return bisect_left(self._starts, start) != bisect_left(self._starts, end)

    def find(self, part: str, start: int) -> int:
        """The place of a part of a token at or after `start`, outside of comments."""
        while True:
            found = self._text.index(part, start)
            index = bisect_left(self._starts, found + 1) - 1
            if index < 0 or self._comments[index].span.end <= found:
                return found
            start = self._comments[index].span.end


def _comment(text: str) -> str:
    if text.startswith("//"):
        return text.rstrip()
    return text.replace("\r\n", "\n")


__all__ = ["Gaps"]
