"""Request: which drawings of a source a page asks for, and how they look there."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from aseme_dsl.diagnostics import closest
from aseme_dsl.diagrams import Expressions, Layout, Options, PageSize
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.by_name import made

_LAYOUTS = {**{str(item): (item,) for item in Layout}, "both": (Layout.NESTED, Layout.TREE)}


class WrongOption(ValueError):
    """An option of a page's diagram cannot be understood; the text says what it may be."""


@dataclass(frozen=True, slots=True)
class Request:
    """What a page asks for.

    `models` are names as `asemec diagram` takes them, all if there are none. `expressions` and `labels` None
    mean what the project says. With a `size`, a statechart is divided into pictures of at most that.
    `source`: show the text above the drawing. `beside`: the picture is a file beside the page instead of a
    part of it.
    """

    models: tuple[str, ...] = ()
    expressions: str | None = None
    at: str | None = None
    depth: int | None = None
    layouts: tuple[Layout, ...] = (Layout.COMPACT,)
    size: PageSize | None = None
    labels: str | None = None
    caption: str = ""
    alt: str = ""
    source: bool = False
    beside: bool = False

    def options(self, expressions: str) -> tuple[Options, ...]:
        """What to draw, where `expressions` is what holds unless the page says something else."""
        shown = Expressions(self.expressions or expressions)
        return tuple(Options(shown, self.at, self.depth, layout, self.size) for layout in self.layouts)


def request_of(options: Mapping[str, str]) -> Request:
    """The request that options, as texts, mean.

    Raises:
        WrongOption: there is no such option, or not with this value, or not with the others.
    """
    known: dict[str, object] = {}
    for name, text in options.items():
        if name not in _READERS:
            near = closest(name, _READERS)
            hint = f"did you mean {near!r}?" if near else f"there are {', '.join(_READERS)}"
            raise WrongOption(f"a diagram has no option {name!r}; {hint}")
        field, read = _READERS[name]
        known[field] = read(name, text.strip())
    request = made(Request, **known)  # `_READERS` gives each field what it has to be
    if request.expressions and Layout.COMPACT in request.layouts:
        raise WrongOption(
            "'expressions' is for the layouts nested, tree and both: add one of them as 'layout'"
        )
    if request.size and (request.layouts != (Layout.COMPACT,) or request.depth):
        raise WrongOption("'page' is for the layout compact, without 'depth'")
    return request


OPTIONS = (
    "model",
    "at",
    "depth",
    "layout",
    "page",
    "expressions",
    "labels",
    "caption",
    "alt",
    "source",
    "embed",
)
"""The names of all options."""


def _models(name: str, text: str) -> tuple[str, ...]:
    models = tuple(re.split(r"[\s,]+", text)) if text else ()
    if not models:
        raise WrongOption(f"{name!r} names a model, such as iac.player")
    return models


def _text(name: str, text: str) -> str:
    return text


def _label(name: str, text: str) -> str:
    if not re.fullmatch(r"\d+(\.\d+)*|[^\W\d]\w*", text):
        raise WrongOption(
            f"{name!r} is the name of a formula or the label of a state, such as 0.2.1, and not {text!r}"
        )
    return text


def _depth(name: str, text: str) -> int:
    if not re.fullmatch(r"[1-9]\d{0,3}", text):
        raise WrongOption(f"{name!r} is a number of levels, at least 1, and not {text!r}")
    return int(text)


def _layout(name: str, text: str) -> tuple[Layout, ...]:
    return _LAYOUTS[_one_of(*_LAYOUTS)(name, text)]


def _page(name: str, text: str) -> PageSize:
    return PageSize(_one_of(*map(str, PageSize))(name, text))


def _one_of(*values: str) -> Callable[[str, str], str]:
    def read(name: str, text: str) -> str:
        if text not in values:
            raise WrongOption(f"{name!r} is {', '.join(values[:-1])} or {values[-1]}, and not {text!r}")
        return text

    return read


def _flag(name: str, text: str) -> bool:
    return _one_of("", "true", "false")(name, text) != "false"


def _embed(name: str, text: str) -> bool:
    return _one_of("inline", "file")(name, text) == "file"


_READERS: dict[str, tuple[str, Callable[[str, str], object]]] = {
    "model": ("models", _models),
    "at": ("at", _label),
    "depth": ("depth", _depth),
    "layout": ("layouts", _layout),
    "page": ("size", _page),
    "expressions": ("expressions", _one_of("numbered", "inline", "none")),
    "labels": ("labels", _one_of("plain", "original")),
    "caption": ("caption", _text),
    "alt": ("alt", _text),
    "source": ("source", _flag),
    "embed": ("beside", _embed),
}
