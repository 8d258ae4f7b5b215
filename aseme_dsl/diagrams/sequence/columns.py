"""Columns: where the lifelines of a sequence diagram stand, and the texts between them.

A text stands between two neighbouring lifelines, beside the one it is about: so it crosses none.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import pairwise

from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.labels import fitted, room_for
from aseme_dsl.diagrams.sequence.sequence import Mark, Row, SequenceDiagram, seconds
from aseme_dsl.records import dataclass

PITCH = 13.5
"""From base line to base line of two lines of text."""
EDGE = 14.0
_WIDEST = range(230, 95, -10)
"""How wide a gap between two lifelines becomes for its texts: the first that lets all fit on the page."""
_HEAD = 150.0
"""How wide a text at the head of a lifeline is at the most, if the gaps are not narrower."""
_BESIDE = 10.0
_BEYOND = 24.0
"""From a lifeline to a text: beside an arrow, and behind a mark or an arrow that leads back."""
_MOST = 3
"""A text of more lines is cut; the tip has all of it."""


@dataclass(frozen=True, slots=True)
class Text:
    """The texts of a row: `above` its line and `below` it, or for a mark all beside it.

    They begin at `x`, or end there if they stand left of their lifeline.
    """

    x: float
    ends: bool
    above: tuple[str, ...]
    below: tuple[str, ...]

    @property
    def up(self) -> float:
        """How much room it needs above the row's line."""
        return 9 + PITCH * len(self.above) if self.above else 13.0

    @property
    def down(self) -> float:
        return 8 + PITCH * len(self.below)


@dataclass(frozen=True, slots=True)
class Head:
    """The texts at the head of a lifeline."""

    name: tuple[str, ...]
    role: tuple[str, ...]

    @property
    def width(self) -> float:
        names = [room_for(line, style.NAME_SIZE, bold=True) for line in self.name]
        return max([*names, *(room_for(line, style.SMALL_SIZE) for line in self.role)]) + 16

    @property
    def height(self) -> float:
        return 8 + 15.0 * len(self.name) + PITCH * len(self.role)


class Columns:
    """The places of the lifelines of a diagram that is to be at most `room` wide."""

    def __init__(self, diagram: SequenceDiagram, room: float) -> None:
        self.diagram = diagram
        self._number = {line.name: number for number, line in enumerate(diagram.lifelines)}
        times = [room_for(seconds(row.moment), style.SMALL_SIZE) for row in diagram.rows]
        self.time = EDGE + max(times, default=0.0)
        """Where the times end."""
        names = [room_for(name, style.SMALL_SIZE) for name in diagram.conversations]
        self.left = self.time + 12 + (max(names) + 22 if len(names) > 1 else 0.0)
        needs = self._needs()
        for widest in _WIDEST:
            head = min(_HEAD, widest - 28)
            self.heads = [
                Head(
                    fitted(line.name, head, style.NAME_SIZE, bold=True),
                    fitted(line.role, head, style.SMALL_SIZE, most=_MOST) if line.role else (),
                )
                for line in diagram.lifelines
            ]
            self._gaps = self._gaps_of(widest, needs)
            if self.width <= room:
                break

    @cached_property
    def places(self) -> tuple[float, ...]:
        """The x of each lifeline, and of what is right of the last."""
        found = [self.left + (self.heads[0].width / 2 if self.heads else 0.0)]
        for gap in self._gaps:
            found.append(found[-1] + gap)
        return tuple(found)

    @property
    def width(self) -> float:
        return self.left + (self.heads[0].width / 2 if self.heads else 0.0) + sum(self._gaps) + EDGE

    @property
    def head_height(self) -> float:
        return max((head.height for head in self.heads), default=0.0)

    def x(self, name: str) -> float:
        """Where the lifeline of an agent is."""
        return self.places[self._number[name]]

    def text(self, row: Row) -> Text:
        """The texts of a row, in the lines that they take."""
        gap, beside, ends = self._place(row)
        room = self._gaps[gap] - beside - _BESIDE
        if isinstance(row, Mark):
            lines = fitted(row.text, room, style.TEXT_SIZE, most=_MOST + 1)
            return Text(self.places[gap] + beside, False, (), lines)
        below = fitted(row.content, room, style.SMALL_SIZE, most=_MOST) if row.content else ()
        above = fitted(row.text, room, style.TEXT_SIZE, bold=True, most=_MOST)
        x = self.places[gap + 1] - beside if ends else self.places[gap] + beside
        return Text(x, ends, above, below)

    def _gaps_of(self, widest: float, needs: Mapping[int, float]) -> Sequence[float]:
        """How wide the gaps right of the lifelines are."""
        halves = [head.width / 2 for head in self.heads]
        gaps = [one + other + 12 for one, other in pairwise(halves)] + halves[-1:]
        for gap, need in needs.items():
            gaps[gap] = max(gaps[gap], min(widest, need))
        return gaps

    def _needs(self) -> Mapping[int, float]:
        """How wide each gap would have to be for its texts in one line each."""
        needs: dict[int, float] = {}
        for row in self.diagram.rows:
            gap, beside, _ = self._place(row)
            if isinstance(row, Mark):
                said = room_for(row.text, style.TEXT_SIZE)
            else:
                said = room_for(row.text, style.TEXT_SIZE, bold=True)
                said = max(said, room_for(row.content, style.SMALL_SIZE))
            needs[gap] = max(needs.get(gap, 0.0), said + beside + _BESIDE + 1)
        return needs

    def _place(self, row: Row) -> tuple[int, float, bool]:
        """The gap in which the texts of a row are, how far from the lifeline, and whether left of it."""
        if isinstance(row, Mark):
            return self._number[row.agent], _BEYOND, False
        start = self._number[row.sender]
        others = [self._number[name] for name in row.receivers]
        if others and max(others) < start:
            return start - 1, _BESIDE, True
        back = start in others or not others
        return start, _BEYOND if back else _BESIDE, False


__all__ = ["EDGE", "PITCH", "Columns", "Head", "Text"]
