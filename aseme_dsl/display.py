"""Display: models, drawings and results show themselves in a notebook, by IPython's methods.

What draws them is above their classes, so `aseme_dsl` says what it is: `shown_by`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Displays:
    """What gives a value as SVG and as HTML, None where the other form shows it, and as a short text."""

    svg: Callable[[object], str | None]
    html: Callable[[object], str | None]
    text: Callable[[object], str]


_chosen: list[Callable[[], Displays]] = []


def shown_by(displays: Callable[[], Displays]) -> None:
    """Say what gives the displays; it is asked when something is shown, not before."""
    _chosen[:] = [displays]


class Printer(Protocol):
    """What IPython prints with."""

    def text(self, text: str, /) -> None: ...


class Displayed:
    """A value that shows itself in a notebook."""

    __slots__ = ()

    def _repr_svg_(self) -> str | None:
        return _chosen[0]().svg(self)

    def _repr_html_(self) -> str | None:
        return _chosen[0]().html(self)

    def __init_subclass__(cls) -> None:
        # IPython takes what a class defines itself, and a dataclass defines its __repr__.
        cls._repr_pretty_ = _print_short  # type: ignore[attr-defined]


def _print_short(value: Displayed, printer: Printer, cycle: bool) -> None:
    printer.text(_chosen[0]().text(value))
