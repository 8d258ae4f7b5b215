"""Nested: the inset of a part that is drawn as the papers draw, as SVG."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import assert_never
from xml.sax.saxutils import escape

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.diagrams.compact.elements import Line, Picture, Shape
from aseme_dsl.diagrams.compact.ink.reading import line_name, state_name
from aseme_dsl.diagrams.look.inset import Outline, Oval, Part, Piece, Point, Words
from aseme_dsl.diagrams.look.labels import printable, text_width

_ROUND = 8


def inset(chart: Statechart, shape: Shape) -> Iterator[str]:
    """The picture inside a nested state, each piece with what it stands for in its id and its tip."""
    if shape.inset is None:
        return
    x, y = shape.origin
    yield f'<g class="inset" data-in="{shape.state}" data-at="{x:.1f} {y:.1f}">'
    others: dict[str, list[Piece]] = {}
    for piece in shape.inset.pieces:
        name, dot, _ = piece.id.partition(".")
        if dot and name[:1] == "t":
            others.setdefault(name, []).append(piece)
    for piece in shape.inset.pieces:
        if piece.id[:1] != "t" or "." not in piece.id:
            yield from _piece(chart, piece, shape.state, (x, y), others.get(piece.id, ()))
    yield "</g>"


def _piece(chart: Statechart, piece: Piece, around: str, at: Point, others: Sequence[Piece]) -> Iterator[str]:
    """A piece, and in it the `others` that its line turns at."""
    said, own, kind = "", f' id="{piece.id}"', "piece"
    named = piece.id.removeprefix("n")
    if piece.id[:1] == "t":
        place = int(piece.id.removeprefix("t"))
        kind, own = "line", f'{own} data-t="{place}"'
        said = line_name(chart, Line((), ((place,),)))
    elif named in chart.by_label:
        # The border around the picture has the name of the outermost state.
        kind, own = "state", f'{own if named != around else ""} data-n="{named}"'
        said = state_name(chart, named)
    else:
        own = ""
    role = f' role="img" aria-label="{_text(said)}"' if said else ""
    yield f'<g{own} class="{kind}" data-kind="{piece.kind}"{role}>'
    if piece.tip:
        yield f"<title>{_text(piece.tip)}</title>"
    first = kind == "state"
    for part in piece.parts:
        yield _part(part, at, is_border=first, is_head=kind == "line")
        first = False
    for other in others:
        yield f'<g data-part="{other.id.partition(".")[2]}" data-kind="{other.kind}">'
        yield from (_part(part, at, is_border=False, is_head=False) for part in other.parts)
        yield "</g>"
    yield "</g>"


def _part(part: Part, at: Point, *, is_border: bool, is_head: bool) -> str:
    dx, dy = at
    look = f"f-{getattr(part, 'fill', '') or 'none'}"
    match part:
        case Words():
            long = text_width(part.text, part.size, bold=part.bold)
            more = ' text-anchor="middle"' if part.middle else ""
            more += ' font-weight="bold"' if part.bold else ""
            place = f'x="{part.x + dx:.1f}" y="{part.y + dy:.1f}"'
            fixed = f'textLength="{long:.1f}" lengthAdjust="spacingAndGlyphs"'
            return (
                f'<text class="f-{part.ink} s{part.size:.0f}" {place} {fixed}{more}>{_text(part.text)}</text>'
            )
        case Oval():
            round_ = f'cx="{part.x + dx:.1f}" cy="{part.y + dy:.1f}" rx="{part.rx:g}" ry="{part.ry:g}"'
            return f'<ellipse class="f-{part.fill or "none"} i-{part.ink or "none"}" {round_}/>'
        case Outline():
            look = f"f-{part.fill or 'none'} i-{part.ink or 'none'}"
            look += " dashed" * part.dashed + " thick" * (part.wide > 1)
            if is_border:
                return _border(part, look, at)
            if not part.ink:  # what only fills is not a path, so that pages which colour lines leave it
                points = " ".join(
                    f"{x + dx:.2f},{y + dy:.2f}" for x, y in part.points[:: 3 if part.curved else 1]
                )
                return f'<polygon class="{look}" points="{points}"/>'
            head = "head " if is_head and part.is_head else ""
            return f'<path class="{head}{look}" d="{path(part, at)}"/>'
        case _:
            assert_never(part)


def _border(part: Outline, look: str, at: Point) -> str:
    """The border of a state as a box, which pages that colour states know."""
    xs, ys = [x + at[0] for x, _ in part.points], [y + at[1] for _, y in part.points]
    left, top, wide, high = min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys)
    box = f'x="{left:.2f}" y="{top:.2f}" width="{wide:.2f}" height="{high:.2f}"'
    return f'<rect class="{look}" {box} rx="{_ROUND if part.curved else 0}"/>'


def path(part: Outline, at: Point) -> str:
    """An outline as the `d` of a path."""
    moved = [f"{x + at[0]:.2f} {y + at[1]:.2f}" for x, y in part.points]
    if part.curved:
        curves = (" ".join(moved[n : n + 3]) for n in range(1, len(moved), 3))
        return f"M{moved[0]}C{' '.join(curves)}"
    return f"M{'L'.join(moved)}"


def colours(picture: Picture) -> tuple[frozenset[str], frozenset[float]]:
    """The names of colours and the sizes of text in the insets."""
    shapes = (item for item in picture.elements if isinstance(item, Shape))
    parts = [part for shape in shapes if shape.inset for piece in shape.inset.pieces for part in piece.parts]
    inks = {part.ink for part in parts}
    fills = {part.fill for part in parts if not isinstance(part, Words)}
    return frozenset(inks | fills), frozenset(part.size for part in parts if isinstance(part, Words))


def _text(text: str) -> str:
    return escape(printable(text), {'"': "&quot;"})


__all__ = ["colours", "inset", "path"]
