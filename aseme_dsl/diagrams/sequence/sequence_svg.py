"""A sequence diagram as SVG: drawn by itself, since there is nothing to lay out but rows and columns."""

from __future__ import annotations

from collections.abc import Iterator
from xml.sax.saxutils import escape

from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.sequence.sequence import DECLINING, Arrow, Mark, Row, SequenceDiagram, seconds

_LETTER = 6.0
"""How wide a letter of the text is at the most, on the average, in points: Arial's, a little more."""
_NARROW, _WIDE, _ROOMY = 112.0, 230.0, 780.0
"""How wide a column is at the least and at the most, and how wide all are together if they can."""
_TIME = 66.0
_ROW = 30.0
_TITLE = 30.0
_HEAD = 40.0
_EDGE = 14.0
_LONGEST = 90
"""Letters of a label."""
_FONTS = f"{style.FONT},Liberation Sans,Helvetica,sans-serif"
_NO = "#b3261e"
_COLOURS = ("#0057a8", "#8a3ffc", "#0b7a3b", "#a8510b", "#b0126b", "#00707a", "#5f5f5f", "#7a6a00")
"""Of the conversations, in turn. Each is written out, too."""


def drawn(diagram: SequenceDiagram) -> str:
    """The diagram as the text of an SVG file."""
    return "\n".join([*_Sheet(diagram).lines(), ""])


class _Sheet:
    """The measures of one diagram."""

    def __init__(self, diagram: SequenceDiagram) -> None:
        self.diagram = diagram
        conversations = diagram.conversations
        self.colours = {name: _COLOURS[i % len(_COLOURS)] for i, name in enumerate(conversations)}
        longest = max((len(name) for name in conversations), default=0)
        self.names = 0.0 if len(conversations) < 2 else 18 + 5.2 * longest
        widest = max(
            (_width(part) for line in diagram.lifelines for part in (line.name, line.role)), default=0
        )
        roomy = _ROOMY / max(1, len(diagram.lifelines))
        self.column = max(_NARROW, min(_WIDE, roomy), widest + 16)
        self.left = _EDGE + _TIME + self.names
        ends = [self._reach(row) for row in diagram.rows]
        remarks = [_EDGE + _width(text) for text in (diagram.title, *diagram.remarks)]
        lifelines = self.left + self.column * len(diagram.lifelines)
        self.width = max([lifelines, *ends, *remarks]) + _EDGE
        self.top = _TITLE + _HEAD
        self.bottom = self.top + _ROW * len(diagram.rows) + 16
        self.height = self.bottom + _HEAD + 18 + 15 * len(diagram.remarks)

    def x(self, name: str) -> float:
        """Where the lifeline of an agent is."""
        names = [line.name for line in self.diagram.lifelines]
        return self.left + self.column * (names.index(name) + 0.5)

    def _reach(self, row: Row) -> float:
        """How far to the right a row needs room."""
        x, anchor, label = self._label(row)
        return x + (_width(label) if anchor == "start" else 0)

    def _label(self, row: Row) -> tuple[float, str, str]:
        """Where the label of a row begins, or ends, which of both, and what it is."""
        if isinstance(row, Mark):
            return self.x(row.agent) + 12, "start", _short(row.text)
        content = f" ({row.content})" if row.content else ""
        label = _short(f"{row.text}{content}")
        start = self.x(row.sender)
        others = [self.x(name) for name in row.receivers]
        if others and max(others) <= start:  # to the left: it ends at the sender, if there is room
            if start - 10 - _width(label) > self.left - 30:
                return start - 10, "end", label
            return min(others) + 10, "start", label
        return start + 10, "start", label

    def lines(self) -> Iterator[str]:
        diagram = self.diagram
        yield (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width:.0f}" height="{self.height:.0f}"'
            f' viewBox="0 0 {self.width:.0f} {self.height:.0f}" font-family="{_FONTS}" font-size="11"'
            f' fill="{style.INK}">'
        )
        yield f"<title>{escape(diagram.title)}</title>"
        yield f'<rect width="100%" height="100%" fill="{style.PAPER}"/>'
        yield f'<text x="{_EDGE}" y="20" font-size="13" font-weight="bold">{escape(diagram.title)}</text>'
        yield from self._lifelines()
        for number, row in enumerate(diagram.rows):
            y = self.top + _ROW * (number + 1)
            yield from self._side(row, y, number)
            yield from self._arrow(row, y) if isinstance(row, Arrow) else self._mark(row, y)
        for number, text in enumerate(diagram.remarks):
            y = self.bottom + _HEAD + 22 + 15 * number
            yield f'<text x="{_EDGE}" y="{y:.0f}" fill="{style.PALE_INK}">{escape(text)}</text>'
        yield "</svg>"

    def _lifelines(self) -> Iterator[str]:
        over = self._ends()
        for line in self.diagram.lifelines:
            x = self.x(line.name)
            end = over.get(line.name, self.bottom)
            yield (
                f'<path d="M{x:.1f} {self.top:.1f}V{end:.1f}" stroke="{style.PARENT_COLOUR}"'
                ' stroke-dasharray="3 3" fill="none"/>'
            )
            for y in (_TITLE, self.bottom):
                wide = self.column - 10
                yield (
                    f'<rect x="{x - wide / 2:.1f}" y="{y:.1f}" width="{wide:.1f}" height="{_HEAD - 4:.0f}"'
                    f' rx="4" fill="{style.HEAD_COLOUR}" stroke="{style.LINE}"/>'
                )
                high = y + (15 if line.role else 22)
                yield (
                    f'<text x="{x:.1f}" y="{high:.1f}" text-anchor="middle" font-size="12"'
                    f' font-weight="bold">{escape(line.name)}</text>'
                )
                if line.role:
                    yield (
                        f'<text x="{x:.1f}" y="{y + 29:.1f}" text-anchor="middle"'
                        f' font-size="10">{escape(line.role)}</text>'
                    )

    def _ends(self) -> dict[str, float]:
        """Where the lifelines end of lost agents."""
        found: dict[str, float] = {}
        for number, row in enumerate(self.diagram.rows):
            y = self.top + _ROW * (number + 1)
            if isinstance(row, Mark) and row.ends:
                found[row.agent] = y
        return found

    def _side(self, row: Row, y: float, number: int) -> Iterator[str]:
        """The time of a row, where it is another one than above, and its conversation."""
        before = self.diagram.rows[number - 1] if number else None
        if before is None or seconds(before.moment) != seconds(row.moment):
            yield (
                f'<text x="{_EDGE + _TIME - 12}" y="{y + 4:.1f}" text-anchor="end"'
                f' fill="{style.PALE_INK}">{seconds(row.moment)}</text>'
            )
        if self.names and row.conversation:
            colour = self.colours[row.conversation]
            x = _EDGE + _TIME
            yield f'<circle cx="{x + 3:.1f}" cy="{y:.1f}" r="3.5" fill="{colour}"/>'
            if before is None or before.conversation != row.conversation:
                yield (
                    f'<text x="{x + 10:.1f}" y="{y + 3.5:.1f}" font-size="10"'
                    f' fill="{colour}">{escape(row.conversation)}</text>'
                )

    def _arrow(self, row: Arrow, y: float) -> Iterator[str]:
        colour = _NO if row.performative in DECLINING else style.INK
        dashes = ' stroke-dasharray="6 3"' if row.performative in DECLINING else ""
        start = self.x(row.sender)
        ends = [self.x(name) for name in row.receivers]
        to = ", ".join(row.receivers) or "nobody"
        whole = f"{seconds(row.moment)}  {row.sender} → {to}\n{row.text} {row.whole}".rstrip()
        yield f"<g><title>{escape(whole)}</title>"
        if ends == [start]:
            yield (
                f'<path d="M{start:.1f} {y - 8:.1f}h14v10h-12" stroke="{colour}" fill="none"{dashes}/>'
                f"{_head(start, y + 2, -1, colour)}"
            )
        elif ends:
            left, right = min([start, *ends]), max([start, *ends])
            yield f'<path d="M{left:.1f} {y:.1f}H{right:.1f}" stroke="{colour}" fill="none"{dashes}/>'
            for end in ends:
                if end != start:
                    yield _head(end, y, 1 if end > start else -1, colour)
            if len(ends) > 1 or left < start < right:
                yield f'<circle cx="{start:.1f}" cy="{y:.1f}" r="2.5" fill="{colour}"/>'
        else:
            yield f'<circle cx="{start:.1f}" cy="{y:.1f}" r="3" fill="none" stroke="{colour}"/>'
        x, anchor, label = self._label(row)
        said, rest = label[: len(row.text)], label[len(row.text) :]
        pale = f'<tspan font-weight="normal" fill="{style.PALE_INK}">{escape(rest)}</tspan>' if rest else ""
        given = f' font-weight="bold" fill="{colour}" text-anchor="{anchor}"'
        yield _text(x, y - 5, f"{escape(said)}{pale}", given)
        yield "</g>"

    def _mark(self, row: Mark, y: float) -> Iterator[str]:
        x = self.x(row.agent)
        yield f"<g><title>{escape(f'{seconds(row.moment)}  {row.agent}: {row.text}')}</title>"
        if row.ends:
            yield f'<path d="M{x - 5:.1f} {y - 5:.1f}l10 10m0 -10l-10 10" stroke="{_NO}" stroke-width="2"/>'
        else:
            yield f'<path d="M{x:.1f} {y - 5:.1f}l5 5l-5 5l-5 -5z" fill="{style.PAPER}" stroke="{_NO}"/>'
        yield _text(x + 12, y + 4, escape(_short(row.text)), f' font-style="italic" fill="{_NO}"')
        yield "</g>"


def _head(x: float, y: float, way: int, colour: str) -> str:
    """The head of an arrow that ends at x."""
    return f'<path d="M{x:.1f} {y:.1f}l{-7 * way} -3.5v7z" fill="{colour}"/>'


def _text(x: float, y: float, inside: str, attributes: str) -> str:
    """A text with a border of paper around it, so that lines behind it do not disturb."""
    halo = f' stroke="{style.PAPER}" stroke-width="3" paint-order="stroke"'
    return f'<text x="{x:.1f}" y="{y:.1f}"{halo}{attributes}>{inside}</text>'


def _width(text: str) -> float:
    return _LETTER * len(text)


def _short(text: str) -> str:
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 1]}…"


__all__ = ["drawn"]
