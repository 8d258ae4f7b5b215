"""Sphinx: the directive `aseme-diagram`, which draws models of a file or of its own text.

To be named in `conf.py`: `extensions = ["aseme_dsl.documents.sphinx"]`.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import ClassVar

try:
    from docutils import nodes
    from docutils.parsers.rst import directives
    from sphinx.application import Sphinx
    from sphinx.util import logging
    from sphinx.util.docutils import SphinxDirective
    from sphinx.util.typing import ExtensionMetadata, OptionSpec
    from sphinx.writers.html5 import HTML5Translator
    from sphinx.writers.latex import LaTeXTranslator
    from sphinx.writers.manpage import ManualPageTranslator
    from sphinx.writers.texinfo import TexinfoTranslator
    from sphinx.writers.text import TextTranslator
except ImportError as missing:
    raise ImportError('the directive needs Sphinx: pip install "aseme-dsl[sphinx]"') from missing

from aseme_dsl import outside
from aseme_dsl.diagrams import Drawing, DrawingFailed, writes_pdf
from aseme_dsl.diagrams.rendering.store import Store
from aseme_dsl.documents import html
from aseme_dsl.documents.figures import Drawer, Figures, Picture, Problem
from aseme_dsl.documents.request import OPTIONS, Request, WrongOption, request_of
from aseme_dsl.source import Source

_LOGGER = logging.getLogger(__name__)

_FOLDER = "aseme"
"""Where pictures are kept from one build to the next, beside what Sphinx keeps itself."""

_drawers: dict[Path, Drawer] = {}
"""One for each place where pictures are kept; a process may build several documentations."""


class aseme_picture(nodes.General, nodes.Element):
    """A picture in the tree of a page."""


class AsemeDiagram(SphinxDirective):
    """`.. aseme-diagram:: team.aseme` with options, or without a file and with a text."""

    has_content = True
    optional_arguments = 1
    final_argument_whitespace = True
    option_spec: ClassVar[OptionSpec] = {
        **dict.fromkeys(OPTIONS, directives.unchanged),
        "align": lambda text: directives.choice(text, ("left", "center", "right")),
        "class": directives.class_option,
        "name": directives.unchanged,
    }

    def run(self) -> list[nodes.Node]:
        """Draw; what is wrong becomes warnings of the build, and stands where the pictures would be."""
        own = ("align", "class", "name")
        try:
            request = request_of({key: value or "" for key, value in self.options.items() if key not in own})
            root = self._root()
        except WrongOption as problem:
            raise self.error(str(problem)) from None
        figures = _drawer(self.env.doctreedir).figures(root, request)
        for path in figures.files:
            self.env.note_dependency(str(path))
        if figures.problems:
            self._tell(figures.problems)
            return [self._shown(figures)]
        shown: list[nodes.Node] = []
        if request.source:
            shown.append(self._listing(root))
        return [*shown, self._figure(figures, request)]

    def _root(self) -> Path | Source:
        if self.arguments and self.content:
            raise WrongOption("a diagram has a file or a text, not both")
        if self.arguments:
            _, path = self.env.relfn2path(self.arguments[0])
            return Path(os.path.relpath(path))
        if not self.content:
            raise WrongOption("a diagram needs a file, or the text of a system")
        page, line = self._place()
        return Source(os.path.relpath(page), "\n" * (line - 1) + "\n".join(self.content) + "\n")

    def _place(self) -> tuple[str, int]:
        """The page and the line where the directive's own text begins."""
        page, line = self.get_source_info()
        offset = self.content.offset(0)
        if offset is not None and offset >= line:
            return page, offset + 1
        return page, line + self.content_offset + 1  # MyST counts from the directive

    def _tell(self, problems: tuple[Problem, ...]) -> None:
        self.env.note_reread()  # so that it is reported by every build until it is fixed
        page, line = self.get_source_info()
        for problem in problems:
            place = f"{page}:{problem.line or line}"
            _LOGGER.warning("%s", problem.text, location=place, type="aseme", subtype="diagram")

    def _shown(self, figures: Figures) -> nodes.Node:
        text = figures.report
        return nodes.literal_block(text, text, language="text", classes=[html.PROBLEM_CLASS])

    def _listing(self, root: Path | Source) -> nodes.Node:
        text = root.text if isinstance(root, Source) else outside.read_text(root, encoding="utf-8-sig")
        block = nodes.literal_block(text.strip("\n"), text.strip("\n"), language="aseme")
        self.set_source_info(block)
        return block

    def _figure(self, figures: Figures, request: Request) -> nodes.Node:
        figure = nodes.figure("", classes=[html.FIGURE_CLASS, *self.options.get("class", ())])
        if "align" in self.options:
            figure["align"] = self.options["align"]
        ids = {f"{item.name}.svg": f"aseme-{self.env.new_serialno(_FOLDER)}" for item in figures.pictures}
        for picture in figures.pictures:
            figure += _node(picture, ids, request.beside)
        if request.caption:
            inline, messages = self.parse_inline(request.caption)
            caption = nodes.caption(request.caption, "", *inline, *messages)
            self.set_source_info(caption)
            figure += caption
        self.set_source_info(figure)
        self.add_name(figure)
        return figure


def _node(picture: Picture, ids: dict[str, str], beside: bool) -> aseme_picture:
    """The picture with all that any builder needs of it, and the ids of those that its links lead to."""
    return aseme_picture(
        alt=picture.alt,
        svg=picture.svg.decode(),
        dot=picture.dot,
        prefix=ids[f"{picture.name}.svg"],
        links=ids,
        beside=beside,
        file=f"{picture.name}-{picture.key[:12]}",
    )


def _drawer(doctrees: str | Path) -> Drawer:
    folder = Path(doctrees) / _FOLDER
    return _drawers.setdefault(folder, Drawer(Store(folder)))


# ---- what builders make of it ---------------------------------------------------------------------


def _html(translator: HTML5Translator, node: aseme_picture) -> None:
    if node["beside"]:
        builder = translator.builder
        name = f"{node['file']}.svg"
        _write(Path(builder.outdir) / builder.imagedir / name, node["svg"].encode())
        translator.body.append(html.image(f"{builder.imgpath}/{name}", node["alt"]))
    else:
        translator.body.append(html.inline(node["svg"].encode(), node["alt"], node["prefix"], node["links"]))
    raise nodes.SkipNode


def _latex(translator: LaTeXTranslator, node: aseme_picture) -> None:
    store = _drawer(translator.builder.doctreedir).store
    try:
        form = "pdf" if writes_pdf() else "png"
        picture = store.render(Drawing(node["file"], node["dot"]), form)
    except DrawingFailed as problem:
        _LOGGER.warning("%s", problem, location=node, type="aseme", subtype="diagram")
        translator.body.append(translator.encode(node["alt"]))
        raise nodes.SkipNode from None
    name = f"{node['file'].replace('.', '-')}.{form}"  # TeX takes what follows a dot for the kind of file
    _write(Path(translator.builder.outdir) / name, picture)
    translator.body.append(f"\n\\sphinxincludegraphics[]{{{name}}}\n")
    raise nodes.SkipNode


def _text(translator: TextTranslator, node: aseme_picture) -> None:
    translator.add_text(f"[{node['alt']}]")
    raise nodes.SkipNode


def _body(translator: ManualPageTranslator | TexinfoTranslator, node: aseme_picture) -> None:
    translator.body.append(f"[{node['alt']}]")
    raise nodes.SkipNode


def _write(path: Path, content: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    if not outside.holds(path, content):
        path.write_bytes(content)


_VISITORS: dict[str, tuple[Callable[..., None], None]] = {
    "html": (_html, None),
    "latex": (_latex, None),
    "text": (_text, None),
    "man": (_body, None),
    "texinfo": (_body, None),
}


def setup(app: Sphinx) -> ExtensionMetadata:
    """Make the directive known to Sphinx."""
    app.add_node(aseme_picture, **_VISITORS)  # type: ignore[arg-type]
    app.add_directive("aseme-diagram", AsemeDiagram)
    return {"version": "1", "env_version": 1, "parallel_read_safe": True, "parallel_write_safe": True}
