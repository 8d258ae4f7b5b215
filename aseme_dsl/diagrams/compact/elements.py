"""Elements: what a compact drawing consists of, each with the states and transitions that it stands for.

All measures are px, from the top left corner; texts stand on their base line.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field, replace
from enum import StrEnum

from aseme_dsl.diagrams.look.inset import Inset
from aseme_dsl.records import dataclass

Point = tuple[float, float]
Link = tuple[int, ...]
Nested = Callable[[str], Inset | str]
"""Draws the inside of a composite as the papers do, or says why it cannot."""


class Look(StrEnum):
    """How a text is written."""

    NAME = "name"
    LABEL = "label"
    ACTION = "action"
    CUT = "cut"
    ERROR = "error"
    SMALL = "small"
    TITLE = "title"
    FIELD = "field"


SIZES = {
    Look.NAME: 13,
    Look.LABEL: 12,
    Look.ACTION: 12,
    Look.CUT: 12,
    Look.ERROR: 12,
    Look.SMALL: 11,
    Look.TITLE: 16,
    Look.FIELD: 12,
}


INSET_PAD = 4.0
"""Between a border and an inset, in px."""

STACKED = 4.0
"""How far the sheet behind a stack is seen, in px."""


class Stroke(StrEnum):
    """How a line is drawn: an ordinary one, an interrupt, one of errors, one never taken."""

    PLAIN = "plain"
    CUT = "cut"
    ERROR = "error"
    NEVER = "never"


class Form(StrEnum):
    """What a shape is."""

    ACTIVITY = "activity"
    PARALLEL = "parallel"
    FRAME = "frame"
    PROTOCOL = "protocol"
    PILL = "pill"
    CLOSED = "closed"
    NESTED = "nested"
    ENDLESS = "endless"
    CHOICE = "choice"
    INITIAL = "initial"
    FINAL = "final"
    FIELD = "field"
    STACK = "stack"


@dataclass(frozen=True, slots=True)
class Line:
    """A line from state or joint to the next: `chain` is the links that it stands for, one after the other.

    One with an empty chain only leads on from a joint.
    """

    points: tuple[Point, ...]
    chain: tuple[Link, ...]
    stroke: Stroke = Stroke.PLAIN
    arrow: bool = True


@dataclass(frozen=True, slots=True)
class Shape:
    """A state, or the border of a field (a dashed line above a region).

    A PILL is a region that repeats one activity, ENDLESS a state that is never complete. CLOSED is a state
    that is drawn without what is inside, NESTED one whose inside is drawn as the papers draw. STACK is the
    border of a region that is drawn once for several.
    """

    form: Form
    x: float
    y: float
    width: float
    height: float
    state: str
    marks: Link = ()
    """The transitions that it stands for itself: those that stay in it, and the reactive ones of a choice.

    A pill and a closed state stand for all inside, an endless state for those that are never taken.
    """
    also: tuple[str, ...] = ()
    """Other states that have the same border: the formula that is nothing but this frame."""
    reason: str = ""
    """Why what is inside has no compact drawing, if it has none."""
    inset: Inset | None = field(default=None, hash=False)
    """The picture of what is inside, if it is nested."""

    @property
    def origin(self) -> Point:
        """Where the inset has its top left corner."""
        high = self.inset.height if self.inset is not None else 0.0
        return self.x + INSET_PAD, self.y + self.height - INSET_PAD - high


@dataclass(frozen=True, slots=True)
class Text:
    """One line of text, with its left end; `of` is the transition that it belongs to, if to one.

    A text with a `state` is the name of a formula that has no border. One that `leads` to a state is the name
    of the page that shows it.
    """

    x: float
    y: float
    text: str
    look: Look
    width: float
    of: int | None = None
    state: str = ""
    leads: str = ""


Element = Line | Shape | Text


@dataclass(frozen=True, slots=True)
class Picture:
    """A compact drawing of the size `width` × `height`.

    It shows the state `top`. `copies` are regions that are drawn once: the drawn one, and the others that
    equal it. `notes` are the transitions whose text stands in full below, in the order of their numbers.
    `texts` are pages of what stands below if it has no room there.
    """

    width: float
    height: float
    elements: tuple[Element, ...]
    top: str = ""
    copies: tuple[tuple[str, ...], ...] = ()
    notes: Link = ()
    texts: tuple[Picture, ...] = ()


def moved(element: Element, dx: float, dy: float) -> Element:
    """The element at another place."""
    if isinstance(element, Line):
        return replace(element, points=tuple((x + dx, y + dy) for x, y in element.points))
    return replace(element, x=element.x + dx, y=element.y + dy)


__all__ = [
    "INSET_PAD",
    "SIZES",
    "STACKED",
    "Element",
    "Form",
    "Line",
    "Look",
    "Nested",
    "Picture",
    "Point",
    "Shape",
    "Stroke",
    "Text",
    "moved",
]
