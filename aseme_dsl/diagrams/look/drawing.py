"""What can be asked of a drawing, and what a drawing is before Graphviz has seen it."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import field, replace
from enum import StrEnum

from aseme_dsl.diagrams.look import dot
from aseme_dsl.diagrams.look.dot import Sheet, Shown
from aseme_dsl.display import Displayed
from aseme_dsl.records import dataclass


class Expressions(StrEnum):
    """How transition expressions appear: numbers and a legend, the text at each transition, or not at all."""

    NUMBERED = "numbered"
    INLINE = "inline"
    NONE = "none"


class Layout(StrEnum):
    """The views of a statechart: compact, states in states, or the labelled tree (P1, Figures 7 and 5)."""

    COMPACT = "compact"
    NESTED = "nested"
    TREE = "tree"


class PageSize(StrEnum):
    """What a page of a drawing has to fit on."""

    A4 = "a4"
    SCREEN = "screen"

    @property
    def room(self) -> tuple[float, float]:
        """How wide and high a drawing on it may be, in px.

        On A4, 1079 px are the 277 mm between margins of 10 mm: the smallest text, of 11 px, has 8 points.
        """
        return (1079.0, 740.0) if self is PageSize.A4 else (1920.0, 1080.0)

    @property
    def paper(self) -> tuple[float, float] | None:
        """How wide and high the paper is, in the same px; None if it is not for paper."""
        return (1157.6, 818.5) if self is PageSize.A4 else None


class NoSuchState(ValueError):
    """`Options.at` names a state that no statechart has."""


@dataclass(frozen=True, slots=True)
class Options:
    """How statecharts are drawn.

    `at` is the label of the state to draw, with the states inside it, or the name of a formula. `depth` is
    the number of nested levels that are drawn open; composites below are closed and show how many states
    they have. `layout` None means all three. With a `page`, the compact one is divided into pages of this
    size. In a compact drawing `depth` counts formulas, and `expressions` mean nothing. Raises ValueError for
    a depth below 1.
    """

    expressions: Expressions = Expressions.NUMBERED
    at: str | None = None
    depth: int | None = None
    layout: Layout | None = Layout.COMPACT
    page: PageSize | None = None

    def __post_init__(self) -> None:
        if self.depth is not None and self.depth < 1:
            raise ValueError("the depth of a drawing is at least 1")


DEFAULT = Options()

STATE_GAPS = (
    ("0.35", "0.34"),
    ("0.25", "0.5"),
    ("0.5", "0.4"),
    ("0.6", "0.6"),
    ("0.3", "0.75"),
    ("0.8", "0.5"),
)
"""Between states and rows of a statechart, in inches: other layouts, to be tried in this order."""

_LONG_LABEL = 80


@dataclass(frozen=True, slots=True)
class Drawing(Displayed):
    """A drawing: its name as files will be called (`iac.player`), its DOT text, and what it must show.

    `pieces` makes the same drawing in smaller ones, the first of them an index, for when Graphviz cannot
    draw it whole; None where there is nothing to divide. `states` is how many states are in it. `picture` is
    the SVG of a drawing that needs no Graphviz, `note` what must be said of the drawing, and `about` what it
    shows, for readers who cannot see it. `closed` are the labels of the states that a compact drawing shows
    as boxes without what is inside, and `size` is how wide and high it is, in px. `wider` are other layouts
    in DOT, for when lines run on one another or over texts.
    """

    name: str
    dot: str
    shown: tuple[Shown, ...] = ()
    states: int = 0
    pieces: Callable[[], tuple[Drawing, ...]] | None = field(default=None, compare=False, repr=False)
    picture: str = ""
    note: str = ""
    about: str = ""
    closed: tuple[str, ...] = ()
    size: tuple[float, float] = (0.0, 0.0)
    wider: Callable[[], Iterator[str]] | None = field(default=None, compare=False, repr=False)


def piece_name(name: str, label: str) -> str:
    """The name of the drawing that shows the state `label` of the drawing `name`; short enough for a file."""
    if len(label) > _LONG_LABEL:
        label = f"{label[:_LONG_LABEL]}-{hashlib.sha256(label.encode()).hexdigest()[:8]}"
    return f"{name}.{label}"


def of_sheet(
    sheet: Sheet,
    *,
    states: int = 0,
    pieces: Callable[[], tuple[Drawing, ...]] | None = None,
    gaps: Sequence[tuple[str, str]] = (),
) -> Drawing:
    """The drawing that a sheet describes; `gaps` are those of other layouts."""

    def wider() -> Iterator[str]:
        for boxes, ranks in gaps:
            yield dot.text(replace(sheet, graph={**sheet.graph, "nodesep": boxes, "ranksep": ranks}))

    return Drawing(
        sheet.name,
        dot.text(sheet),
        dot.shown(sheet),
        states,
        pieces,
        about=sheet.about,
        wider=wider if gaps else None,
    )
