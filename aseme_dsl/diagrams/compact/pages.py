"""Pages: a compact drawing whose formulas are closed from a depth on, or divided among pages of a size."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace

from aseme_dsl.amola.srm import Activity
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.diagrams.compact.blocks import inside
from aseme_dsl.diagrams.compact.elements import Form, Nested, Picture, Shape
from aseme_dsl.diagrams.compact.layout import Wanted, layout, scale
from aseme_dsl.records import dataclass

_LARGE = 0.67
"""A formula that is more of a page than this is closed only if there is no smaller one."""

_AROUND = 80
"""How much room a page has at least to have for more than a nested part, in px."""

_SMALL = 3
"""A formula with fewer states is not worth a page."""


@dataclass(frozen=True, slots=True)
class Page:
    """The drawing of the state `top`."""

    top: str
    picture: Picture


def whole(
    chart: Statechart,
    activities: Iterable[Activity],
    top: str,
    depth: int | None,
    nested: Nested | None = None,
) -> Page:
    """One page of a state, with the formulas closed that are more than `depth` formulas deep.

    What has no compact form is drawn by `nested`. Raises NotCompact.
    """
    closed = frozenset(label for label, level in _formulas(chart, top) if depth is not None and level > depth)
    return Page(top, layout(chart, activities, Wanted(top, closed, nested=nested)))


def divided(
    chart: Statechart,
    activities: Iterable[Activity],
    top: str,
    size: tuple[float, float],
    nested: Nested | None = None,
) -> Iterator[Page]:
    """Pages of at most a size as far as formulas can be closed: each closed one has a page of its own.

    What has no compact form is drawn by `nested`, and closed as well. Raises NotCompact.
    """
    known = tuple(activities)
    waiting: list[tuple[str, ...]] = [(top,)]
    while waiting:
        *path, label = waiting.pop(0)
        wanted = Wanted(label, size=size, page=True, path=tuple(path), nested=nested)
        picture, closed = _fitting(chart, known, wanted)
        yield Page(label, picture)
        shapes = (item for item in picture.elements if isinstance(item, Shape) and item.form is Form.CLOSED)
        waiting += ((*path, label, item.state) for item in shapes if item.state in closed)


def _fitting(
    chart: Statechart, activities: tuple[Activity, ...], wanted: Wanted
) -> tuple[Picture, frozenset[str]]:
    """The picture of a page, and what has been closed for want of room.

    A nested part that has no room on any page is always closed. Then come formulas. If that is not enough,
    the texts below get pages of their own. At last, parts without a name are closed, and nested ones.
    """
    first = layout(chart, activities, wanted)
    nested = {
        item.state: item.width + _AROUND > wanted.size[0] or item.height + _AROUND > wanted.size[1]
        for item in first.elements
        if isinstance(item, Shape) and item.form is Form.NESTED and item.state != wanted.top
    }
    always = frozenset(label for label, is_large in nested.items() if is_large)
    formulas = _closings(chart, wanted.top, [label for label, _ in _formulas(chart, wanted.top)], ())
    order = (*formulas, *_closings(chart, wanted.top, list(_parts(chart, wanted.top)), formulas))
    order += tuple(label for label in nested if label not in {*always, *order})

    def with_closed(count: int) -> Picture:
        now = replace(wanted, closed=always | frozenset(order[:count]))
        picture = layout(chart, activities, now) if now.closed else first
        if scale(picture, wanted.size) >= 1 or count < len(formulas):
            return picture
        return max(picture, layout(chart, activities, replace(now, apart=True)), key=fit)

    def fit(picture: Picture) -> float:
        return scale(picture, wanted.size)

    count, picture = _fewest(len(order), with_closed, lambda picture: fit(picture) >= 1)
    return picture, always | frozenset(order[:count])


def _fewest(
    most: int, made: Callable[[int], Picture], fits: Callable[[Picture], bool]
) -> tuple[int, Picture]:
    """The smallest number up to `most` with which a picture fits, and that picture; else `most`.

    Few are tried first, then twice as many each time.
    """
    low, high = -1, 0
    picture = made(high)
    while not fits(picture) and high < most:
        low, high = high, min(most, max(1, 2 * high))
        picture = made(high)
    while fits(picture) and high - low > 1:
        middle = (low + high) // 2
        other = made(middle)
        if fits(other):
            high, picture = middle, other
        else:
            low = middle
    return high, picture


def _closings(chart: Statechart, top: str, names: list[str], closed: Sequence[str]) -> tuple[str, ...]:
    """What is closed one after the other, the most useful first, when others are `closed`."""
    found: list[str] = []
    while (label := _next(chart, top, names, {*closed, *found})) is not None:
        found.append(label)
    return tuple(found)


def _next(chart: Statechart, top: str, names: list[str], closed: set[str]) -> str | None:
    """The largest formula that may be closed next, but not one that is nearly all of the page."""
    sizes: dict[str, int] = {}
    hidden = {item for label in closed for item in inside(chart, label)}
    for label in (item for item in names if item not in hidden):
        sizes[label] = sum(item not in hidden for item in inside(chart, label))
    total = sum(item not in hidden for item in inside(chart, top))
    fit = [label for label, count in sizes.items() if _SMALL < count <= _LARGE * total]
    if fit:
        return max(fit, key=lambda label: (sizes[label], -names.index(label)))
    large = [label for label, count in sizes.items() if count > _SMALL]
    return min(large, key=lambda label: (sizes[label], names.index(label)), default=None)


def _formulas(chart: Statechart, top: str) -> Iterator[tuple[str, int]]:
    """The formulas with a name inside a state, with how many of them are around each, itself counted."""
    level = {top: 0}
    for label in inside(chart, top)[1:]:
        state = chart.node(label)
        assert state.parent is not None
        outer = chart.node(state.parent)
        named = state.type is StateType.OR and state.name != label and state.name.isidentifier()
        again = outer.name == state.name and not chart.is_region(outer.label)
        level[label] = level[state.parent] + (named and not again)
        if named and not again and not chart.is_region(label):
            yield label, level[label]


def _parts(chart: Statechart, top: str) -> Iterator[str]:
    """All ORs inside a state that a page may show."""
    for label in inside(chart, top)[1:]:
        if chart.node(label).type is StateType.OR and not chart.is_region(label):
            yield label


__all__ = ["Page", "divided", "whole"]
