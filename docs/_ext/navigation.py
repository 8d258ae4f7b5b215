"""The navigation beside each page, made once a folder.

On all pages of a folder it is the same, but for the marks at the page and at those above it. Sphinx makes it
anew for each page from the contents of all pages, which takes longer than all the rest.
"""

from __future__ import annotations

import re
from functools import cached_property, lru_cache
from typing import Any

from furo.navigation import get_navigation_tree
from sphinx.application import Sphinx
from sphinx.environment.adapters.toctree import global_toctree_for_doc
from sphinx.util.osutil import relative_uri

_LINK = re.compile(r'(<a class="reference internal" href=")([^"]+)')
_LEVEL = re.compile(r'<li class="toctree-l(\d+)')
_APART = "search"
"""A page at the root that stands in no table of contents."""


class Navigation:
    """The navigation of the pages of a build, as the theme writes it."""

    def __init__(self, app: Sphinx) -> None:
        self._app = app
        self._in_folder = lru_cache(maxsize=None)(self._of_folder)

    @cached_property
    def _whole(self) -> str:
        builder = self._app.builder
        tree = global_toctree_for_doc(
            self._app.env,
            _APART,
            builder,
            tags=builder.tags,
            includehidden=True,
            maxdepth=-1,
            titles_only=True,
        )
        return get_navigation_tree(builder.render_partial(tree)["fragment"])

    def _of_folder(self, folder: str) -> list[str]:
        here = folder and f"{folder}/"
        return _LINK.sub(lambda found: found[1] + relative_uri(here, found[2]), self._whole).split("\n")

    def of(self, page: str) -> str:
        """Return the navigation beside a page."""
        folder, _, name = self._app.builder.get_target_uri(page).rpartition("/")
        lines = self._in_folder(folder)
        link = f'<a class="reference internal" href="{name}">'
        place = next((place for place, line in enumerate(lines) if link in line), None)
        if place is None:
            return "\n".join(lines)
        marked = list(lines)
        marked[place] = _as_current(lines[place], " current-page").replace(
            link, '<a class="current reference internal" href="#">'
        )
        for above in _above(lines, place):
            marked[above] = _as_current(lines[above], "").replace("<ul>", '<ul class="current">')
        return "\n".join(marked)


def _above(lines: list[str], place: int) -> list[int]:
    """Where the lists stand that contain an entry."""
    found, level = [], _level(lines[place])
    for above in range(place - 1, 0, -1):
        if 0 < _level(lines[above]) < level:
            found.append(above)
            level = _level(lines[above])
    return [*found, 0]


def _level(line: str) -> int:
    found = _LEVEL.match(line)
    return int(found[1]) if found is not None else 0


def _as_current(line: str, further: str) -> str:
    line = re.sub(r'^(<li class="toctree-l\d+)([^"]*)', rf"\1 current\2{further}", line)
    return line.replace(' class="toctree-checkbox"', ' checked="" class="toctree-checkbox"')


def setup(app: Sphinx) -> dict[str, bool]:
    """Give the theme nothing to make the navigation from, and put ours in its place."""
    navigation = Navigation(app)
    kept: list[Any] = []

    def before(app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: Any) -> None:
        kept.append(context.pop("toctree", None))

    def after(app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: Any) -> None:
        context["toctree"] = kept.pop()
        context["furo_navigation_tree"] = navigation.of(page)

    app.connect("html-page-context", before, priority=400)
    app.connect("html-page-context", after, priority=600)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
