"""A sequence diagram as SVG: drawn by itself, since there is nothing to lay out but rows and columns."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from xml.sax.saxutils import escape

from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.colours import LIGHT, night
from aseme_dsl.diagrams.look.drawing import PageSize
from aseme_dsl.diagrams.look.labels import fitted, printable, room_for
from aseme_dsl.diagrams.sequence.columns import EDGE, PITCH, Columns, Text
from aseme_dsl.diagrams.sequence.sequence import DECLINING, PAGE, Arrow, Mark, Row, SequenceDiagram, seconds
from aseme_dsl.records import dataclass

_TITLE = 34.0
_LONG = 15
"""A picture with more rows has the names of the agents below, too."""
_COLOURS = tuple(LIGHT[name] for name in ("p0", "p1", "p2", "p3", "cut", "node-border"))
"""Of the conversations, in turn. Each is written out, too."""
_SOFT = f' fill="{style.PALE_INK}"'
_SMALL = f' font-size="{style.SMALL_SIZE}"'
_BOLD = ' font-weight="bold"'


def drawn(diagram: SequenceDiagram) -> str:
    """The diagram as the text of one SVG file."""
    sheet = _Sheet(diagram, PageSize.SCREEN.room[0])
    return sheet.svg(_Part(diagram.title, 0, diagram.rows))


def pictures(diagram: SequenceDiagram, page: PageSize | None = None) -> Iterator[str]:
    """The diagram as SVG files that follow each other.

    They are pages of this size, as far as one can be as narrow; without one, each has at most `PAGE` rows.
    """
    width, height = (page or PageSize.SCREEN).room
    sheet = _Sheet(diagram, width)
    parts = list(sheet.parts(height) if page is not None else sheet.parts_of_rows())
    for number, (first, last) in enumerate(parts, 1):
        title = diagram.title if len(parts) == 1 else f"{diagram.title} · page {number} of {len(parts)}"
        yield sheet.svg(_Part(title, first, diagram.rows[first:last]), width if page is not None else 0.0)


@dataclass(frozen=True, slots=True)
class _Part:
    """The rows of one picture, and how many are on those before it."""

    title: str
    before: int
    rows: Sequence[Row]


class _Sheet:
    """The measures of a diagram, and what is painted with them."""

    def __init__(self, diagram: SequenceDiagram, room: float) -> None:
        self.diagram = diagram
        self.columns = Columns(diagram, room)
        self.texts = [self.columns.text(row) for row in diagram.rows]
        conversations = diagram.conversations
        self.colours = {name: _COLOURS[i % len(_COLOURS)] for i, name in enumerate(conversations)}
        self.top = _TITLE + self.columns.head_height
        lines = [fitted(text, room - 2 * EDGE, style.SMALL_SIZE) for text in diagram.remarks]
        self.remarks = [line for text in lines for line in text]
        self.room = room

    # ---- pages -----------------------------------------------------------------------------------

    def parts_of_rows(self) -> Iterator[tuple[int, int]]:
        """The first row of each picture and the one after its last: equally many, at most `PAGE`."""
        total = len(self.texts)
        count = max(1, -(-total // PAGE))
        each = max(1, -(-total // count))
        yield from ((start, min(start + each, total)) for start in range(0, max(total, 1), each))

    def parts(self, height: float) -> Iterator[tuple[int, int]]:
        """The same for as many rows as fit in a height, at least one."""
        room = height - self.top - self._foot(_LONG + 1)
        first, used = 0, 0.0
        for number, text in enumerate(self.texts):
            if used + text.up + text.down > room and number > first:
                yield first, number
                first, used = number, 0.0
            used += text.up + text.down
        yield first, len(self.texts)

    def _foot(self, rows: int) -> float:
        """How high is what stands below that many rows."""
        names = self.columns.head_height if rows > _LONG else 0.0
        return 10 + names + 8 + PITCH * len(self.remarks) + (6 if self.remarks else 0)

    # ---- one picture -----------------------------------------------------------------------------

    def svg(self, part: _Part, page: float = 0.0) -> str:
        """The text of an SVG file; `page` is how wide it should be."""
        ys: list[float] = []
        y = self.top
        for text in self.texts[part.before : part.before + len(part.rows)]:
            ys.append(y + text.up)
            y += text.up + text.down
        remarks = list(self.remarks)
        if page and self.columns.width > page:
            remarks.append(f"this page fits at {page / self.columns.width:.0%}")
        room = max(self.room, self.columns.width) - 2 * EDGE
        (title,) = fitted(part.title, room, style.TITLE_SIZE, bold=True, most=1)
        wide = [room_for(line, style.SMALL_SIZE) for line in remarks]
        wide.append(room_for(title, style.TITLE_SIZE, bold=True))
        width = max(self.columns.width, max(wide) + 2 * EDGE)
        height = y + self._foot(len(part.rows)) + PITCH * (len(remarks) - len(self.remarks))
        about = escape(printable(part.title), {'"': "&quot;"})
        painted = [
            f'<rect width="{width:.0f}" height="{height:.0f}" fill="{style.PAPER}"/>',
            _text(EDGE, 22, title, f' font-size="{style.TITLE_SIZE}"{_BOLD}'),
            *self._lifelines(part, ys, y + 10),
        ]
        for number, row in enumerate(part.rows):
            before = part.rows[number - 1] if number else None
            text = self.texts[part.before + number]
            painted += self._side(row, ys[number], before)
            made = (
                self._arrow(row, ys[number], text)
                if isinstance(row, Arrow)
                else self._mark(row, ys[number], text)
            )
            painted += made
        first = height - 8 - PITCH * (len(remarks) - 1)
        painted += (_text(EDGE, first + PITCH * at, line, _SMALL + _SOFT) for at, line in enumerate(remarks))
        body = "\n".join([f'<g fill="{style.INK}">', *painted, "</g>"])
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}"'
            f' viewBox="0 0 {width:.0f} {height:.0f}" class="aseme-drawing aseme-talk" role="img"'
            f' aria-label="{about}" font-family="{style.FONTS}" font-size="{style.TEXT_SIZE}"'
            f">\n<title>{about}</title>\n<style>{night(body)}</style>\n{body}\n</svg>\n"
        )

    def _lifelines(self, part: _Part, ys: Sequence[float], bottom: float) -> Iterator[str]:
        over = {
            row.agent: 0.0 for row in self.diagram.rows[: part.before] if isinstance(row, Mark) and row.ends
        }
        over |= {
            row.agent: y for row, y in zip(part.rows, ys, strict=True) if isinstance(row, Mark) and row.ends
        }
        tops = [_TITLE] + ([bottom] if len(part.rows) > _LONG else [])
        for line, head in zip(self.diagram.lifelines, self.columns.heads, strict=True):
            x, end = self.columns.x(line.name), over.get(line.name, bottom)
            if end:
                yield (
                    f'<path d="M{x:.1f} {self.top:.1f}V{end:.1f}" stroke="{style.RULE_COLOUR}"'
                    ' stroke-dasharray="3 3" fill="none"/>'
                )
            for top in tops:
                yield from self._head(x, top, head.width, line.count > 1)
                y = top + (self.columns.head_height - head.height) / 2 + 2
                for text in head.name:
                    y += 15
                    given = f' font-size="{style.NAME_SIZE}"{_BOLD} text-anchor="middle"'
                    yield _text(x, y - 1, text, given)
                for text in head.role:
                    y += PITCH
                    yield _text(x, y - 1, text, f'{_SMALL}{_SOFT} text-anchor="middle"')

    def _head(self, x: float, y: float, wide: float, several: bool) -> Iterator[str]:
        """The box at the head of a lifeline; two for a group."""
        colours = f'fill="{LIGHT["pill"]}" stroke="{style.RULE_COLOUR}"'
        size = f'width="{wide:.1f}" height="{self.columns.head_height:.1f}" rx="8"'
        for off in (3.0, 0.0) if several else (0.0,):
            yield f'<rect x="{x - wide / 2 + off:.1f}" y="{y - off:.1f}" {size} {colours}/>'

    def _side(self, row: Row, y: float, before: Row | None) -> Iterator[str]:
        """The time of a row, where it is another one than above, and its conversation."""
        if before is None or seconds(before.moment) != seconds(row.moment):
            yield _text(self.columns.time, y + 4, seconds(row.moment), f'{_SMALL}{_SOFT} text-anchor="end"')
        if len(self.colours) > 1 and row.conversation:
            colour, x = self.colours[row.conversation], self.columns.time + 12
            yield f'<circle cx="{x + 3:.1f}" cy="{y:.1f}" r="3.5" fill="{colour}"/>'
            if before is None or before.conversation != row.conversation:
                yield _text(x + 11, y + 4, row.conversation, f'{_SMALL} fill="{colour}"')

    def _arrow(self, row: Arrow, y: float, text: Text) -> Iterator[str]:
        declines = row.performative in DECLINING
        colour = LIGHT["error"] if declines else style.INK
        line = f'stroke="{colour}" stroke-width="1.3" fill="none"' + (
            ' stroke-dasharray="5 3"' if declines else ""
        )
        start = self.columns.x(row.sender)
        ends = [self.columns.x(name) for name in row.receivers]
        to = ", ".join(row.receivers) or "nobody"
        whole = f"{seconds(row.moment)}  {row.sender} → {to}\n{row.text} {row.whole}".rstrip()
        yield f'<g class="edge"><title>{escape(printable(whole))}</title>'
        if start in ends:
            yield f'<path d="M{start:.1f} {y - 14:.1f}h14v10h-12" {line}/>{_point(start, y - 4, -1, colour)}'
        others = [end for end in ends if end != start]
        if others:
            left, right = min([start, *others]), max([start, *others])
            yield f'<path d="M{left:.1f} {y:.1f}H{right:.1f}" {line}/>'
            yield from (_point(end, y, 1 if end > start else -1, colour) for end in others)
        if len(ends) > 1:
            yield f'<circle cx="{start:.1f}" cy="{y:.1f}" r="2.5" fill="{colour}"/>'
        elif not ends:
            yield f'<circle cx="{start:.1f}" cy="{y:.1f}" r="3" fill="{style.PAPER}" stroke="{colour}"/>'
        anchor = ' text-anchor="end"' if text.ends else ""
        for number, said in enumerate(reversed(text.above)):
            yield _text(text.x, y - 5 - PITCH * number, said, f'{_BOLD}{anchor} fill="{colour}"')
        for number, said in enumerate(text.below):
            yield _text(text.x, y + 13 + PITCH * number, said, f"{_SMALL}{anchor}{_SOFT}")
        yield "</g>"

    def _mark(self, row: Mark, y: float, text: Text) -> Iterator[str]:
        x, colour = self.columns.x(row.agent), LIGHT["error" if row.ends else "cut"]
        whole = f"{seconds(row.moment)}  {row.agent}: {row.text}"
        yield f"<g><title>{escape(printable(whole))}</title>"
        if row.ends:
            cross = f"M{x - 5:.1f} {y - 5:.1f}l10 10m0 -10l-10 10"
            yield f'<path d="{cross}" stroke="{colour}" stroke-width="2"/>'
        else:
            yield f'<path d="M{x:.1f} {y - 5:.1f}l5 5l-5 5l-5 -5z" fill="{style.PAPER}" stroke="{colour}"/>'
        for number, said in enumerate(text.below):
            yield _text(text.x - 10, y + 4 + PITCH * number, said, f' font-style="italic" fill="{colour}"')
        yield "</g>"


def _point(x: float, y: float, way: int, colour: str) -> str:
    """The head of an arrow that ends at x."""
    corners = f"{x:.1f},{y:.1f} {x - 7 * way:.1f},{y - 3.5:.1f} {x - 7 * way:.1f},{y + 3.5:.1f}"
    return f'<polygon points="{corners}" fill="{colour}"/>'


def _text(x: float, y: float, said: str, attributes: str) -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}"{attributes}>{escape(printable(said))}</text>'


__all__ = ["drawn", "pictures"]
