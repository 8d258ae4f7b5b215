"""MkDocs: the plugin `aseme`, which draws what fenced blocks of the pages ask for.

To be named in `mkdocs.yml`: `plugins: [search, aseme]`.
"""

from __future__ import annotations

import os
import zlib
from collections.abc import Callable
from pathlib import Path

from aseme_dsl.records import dataclass

try:
    from mkdocs.config import base
    from mkdocs.config.config_options import Optional, Type
    from mkdocs.config.defaults import MkDocsConfig
    from mkdocs.livereload import LiveReloadServer
    from mkdocs.plugins import BasePlugin, event_priority, get_plugin_logger
    from mkdocs.structure.files import File, Files
    from mkdocs.structure.pages import Page
except ImportError as missing:
    raise ImportError('the plugin needs MkDocs: pip install "aseme-dsl[mkdocs]"') from missing

from aseme_dsl.diagrams.rendering.store import Store
from aseme_dsl.documents import html
from aseme_dsl.documents.fences import DIAGRAM, Fence, WrongFence, fences
from aseme_dsl.documents.figures import Drawer, Picture
from aseme_dsl.documents.request import Request, WrongOption, request_of
from aseme_dsl.source import Source

_LOGGER = get_plugin_logger("aseme")

_FOLDER = "assets/aseme"
"""Where pictures beside the pages are, in the site."""


class AsemeConfig(base.Config):  # type: ignore[no-untyped-call]
    """What `mkdocs.yml` may say of the plugin."""

    cache = Optional(Type(str))
    """A folder where pictures are kept from one build to the next, relative to `mkdocs.yml`."""


class AsemePlugin(BasePlugin[AsemeConfig]):  # type: ignore[no-untyped-call]
    """Finds the blocks in the Markdown of a page, and puts the figures into its HTML."""

    def __init__(self) -> None:
        self._drawer = Drawer()
        self._pages: dict[str, dict[str, str]] = {}
        """The figures of each page, by the words that stand for them until the page is HTML."""
        self._files: set[Path] = set()
        self._watch: Callable[[str], None] | None = None

    def on_config(self, config: MkDocsConfig) -> MkDocsConfig:
        """Begin a build; pictures of earlier ones are kept."""
        if self.config.cache and self._drawer.store.folder is None:
            folder = Path(config.config_file_path or ".").parent / self.config.cache
            self._drawer = Drawer(Store(folder))
        return config

    @event_priority(100)  # before others change the text, so that lines are those of the file
    def on_page_markdown(self, markdown: str, *, page: Page, config: MkDocsConfig, files: Files) -> str:
        """Draw what the blocks of the page ask for, and leave a word in the place of each."""
        lines = markdown.split("\n")
        figures = self._pages[page.file.src_uri] = {}
        above = _lines_above(page, markdown)
        found = list(fences(lines))
        for number, fence in enumerate(found, 1):
            place = _Place(page, None if above is None else above + fence.first + 1)
            figures[_word(page, number)] = self._figure(fence, place, f"aseme-{number}", config, files)
        for number, fence in reversed(list(enumerate(found, 1))):
            shown = ["", f"{fence.indent}{_word(page, number)}", ""]
            if fence.language != DIAGRAM:
                listing = [fence.indent + line if line else "" for line in fence.content]
                ends = f"{fence.indent}{fence.fence}"
                shown = [f"{ends}{fence.language}", *listing, ends, *shown]
            lines[fence.first : fence.last + 1] = shown
        return "\n".join(lines)

    def on_page_content(self, html: str, *, page: Page, config: MkDocsConfig, files: Files) -> str:
        """Put the figures where their words are."""
        for word, figure in self._pages.pop(page.file.src_uri, {}).items():
            html = html.replace(f"<p>{word}</p>", figure).replace(word, figure)
        return html

    def on_serve(self, server: LiveReloadServer, **more: object) -> LiveReloadServer:
        """Build again when a file changes that something was drawn from."""
        self._watch = server.watch
        for path in sorted(self._files):
            server.watch(str(path))
        return server

    def _figure(self, fence: Fence, place: _Place, prefix: str, config: MkDocsConfig, files: Files) -> str:
        """The figure of a block, or what is wrong with it."""
        try:
            request, root = _asked(fence, place, config)
        except (WrongFence, WrongOption) as problem:
            place.warn(str(problem))
            return html.problem(str(problem))
        figures = self._drawer.figures(root, request)
        self._depends(figures.files)
        if figures.problems:
            for item in figures.problems:
                place.warn(item.text, item.line)
            return html.problem(figures.report)
        ids = {f"{item.name}.svg": f"{prefix}-{number}" for number, item in enumerate(figures.pictures, 1)}
        pictures = "\n".join(
            _beside(picture, place.page, config, files)
            if request.beside
            else html.inline(picture.svg, picture.alt, ids[f"{picture.name}.svg"], ids)
            for picture in figures.pictures
        )
        return html.figure(pictures, request.caption)

    def _depends(self, paths: tuple[Path, ...]) -> None:
        for path in paths:
            if path not in self._files and path.is_file():
                self._files.add(path)
                if self._watch is not None:
                    self._watch(str(path))


def _word(page: Page, number: int) -> str:
    """The placeholder of a figure in the text of a page: Markdown keeps it, and no author writes it."""
    return f"asemediagram{number}of{zlib.crc32(page.file.src_uri.encode()):08x}"


@dataclass(frozen=True, slots=True)
class _Place:
    """A block's page, and its first line there; None where other plugins have moved the lines before."""

    page: Page
    line: int | None

    @property
    def path(self) -> str:
        return os.path.relpath(self.page.file.abs_src_path or self.page.file.src_uri)

    def warn(self, text: str, line: int | None = None) -> None:
        """Warn of something in a line of the page, else of the block."""
        line = line if self.line is not None and line is not None else self.line
        _LOGGER.warning("%s: %s", f"{self.path}:{line}" if line is not None else self.path, text)


def _asked(fence: Fence, place: _Place, config: MkDocsConfig) -> tuple[Request, Path | Source]:
    """What a block asks for, and of which source.

    Raises:
        WrongFence, WrongOption: it cannot be understood.
    """
    options = fence.options()
    file = None
    if fence.language == DIAGRAM:
        file = options.pop("file", None)
    elif diagram := options.pop("diagram", ""):
        options["model"] = diagram
    request = request_of(options)
    text = "\n".join(fence.content)
    if file is None:
        if not text.strip():
            raise WrongOption("a diagram needs a file, or the text of a system")
        return request, Source(place.path, "\n" * (place.line or 0) + text + "\n")
    if text.strip():
        raise WrongOption("a diagram has a file or a text, not both")
    folder = Path(config.docs_dir) if file.startswith("/") else Path(place.path).parent
    return request, Path(os.path.relpath(folder / file.lstrip("/")))


def _lines_above(page: Page, markdown: str) -> int | None:
    """How many lines of the page's file MkDocs has left out above the text; None where this was changed."""
    whole = page.file.content_string
    if not whole.endswith(markdown):
        return None
    return whole.count("\n", 0, len(whole) - len(markdown))


def _beside(picture: Picture, page: Page, config: MkDocsConfig, files: Files) -> str:
    """A picture as a file of the site, and the element that shows it."""
    address = f"{_FOLDER}/{picture.name}-{picture.key[:12]}.svg"
    if files.get_file_from_path(address) is None:
        files.append(File.generated(config, address, content=picture.svg))
    file = files.get_file_from_path(address)
    assert file is not None
    return html.image(file.url_relative_to(page.file), picture.alt)
