"""Inset: what Graphviz has drawn of a part, as plain data that stands in another drawing.

All measures are px, from the top left corner of the inset; texts stand on their base line. Colours are names
of `look.colours`, or "" for none.
"""

from __future__ import annotations

from aseme_dsl.diagrams.look.dot import Kind
from aseme_dsl.records import dataclass

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Outline:
    """Points of a polygon, or of a line; of one that is `curved`, two of three points are those of Bézier."""

    points: tuple[Point, ...]
    fill: str
    ink: str
    curved: bool = False
    dashed: bool = False
    wide: float = 1.0

    @property
    def is_head(self) -> bool:
        """Whether it is the head of an arrow, if it belongs to a line."""
        return not self.curved


@dataclass(frozen=True, slots=True)
class Oval:
    """A circle or an ellipse, by its middle."""

    x: float
    y: float
    rx: float
    ry: float
    fill: str
    ink: str


@dataclass(frozen=True, slots=True)
class Words:
    """A line of text; it begins at x, or has its `middle` there."""

    x: float
    y: float
    text: str
    size: float
    ink: str
    bold: bool = False
    middle: bool = False


Part = Outline | Oval | Words


@dataclass(frozen=True, slots=True)
class Piece:
    """What has one id (`n0.2`, `t5`, `t5.turn`; "" for what belongs to no state and no transition)."""

    id: str
    kind: Kind
    parts: tuple[Part, ...]
    tip: str = ""

    @property
    def text(self) -> str:
        """All that is written in it, without blanks."""
        return "".join("".join(part.text.split()) for part in self.parts if isinstance(part, Words))

    @property
    def frame(self) -> tuple[float, float, float, float] | None:
        """Left, top, right and bottom of its first shape; None if it has none."""
        for part in self.parts:
            match part:
                case Outline():
                    xs, ys = [x for x, _ in part.points], [y for _, y in part.points]
                    return min(xs), min(ys), max(xs), max(ys)
                case Oval():
                    # A double circle is the inner one and then the border.
                    ovals = [item for item in self.parts if isinstance(item, Oval)]
                    outer = max(ovals, key=lambda item: item.rx)
                    return (
                        outer.x - outer.rx,
                        outer.y - outer.ry,
                        outer.x + outer.rx,
                        outer.y + outer.ry,
                    )
                case Words():
                    continue
        return None


@dataclass(frozen=True, slots=True)
class Inset:
    """A picture of this size, from back to front."""

    width: float
    height: float
    pieces: tuple[Piece, ...]


__all__ = ["Inset", "Outline", "Oval", "Part", "Piece", "Point", "Words"]
