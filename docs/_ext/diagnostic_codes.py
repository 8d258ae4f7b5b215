"""The pages of the diagnostics, from the compiler's own table and pages.

`{diagnostic-codes}` is every code with its title. Before a build each code gets a page of its own,
`reference/diagnostics/CODE.md`, which shows what the compiler says now to the wrong example; git ignores
these files.
"""

from __future__ import annotations

from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective
from tables import table

from aseme_dsl.diagnostics import CODES, GROUPS, Code, render_text
from aseme_dsl.diagnostics.pages import blocks, fenced, page
from aseme_dsl.project.building.examples import diagnostics_of

FOLDER = "reference/diagnostics"
"""Where the pages of the codes stand, in the folder of the documentation."""


class DiagnosticCodes(SphinxDirective):
    """A section for each group of codes."""

    def run(self) -> list[nodes.Node]:
        found: list[nodes.Node] = []
        for digit, title in GROUPS.items():
            codes = [code for code in CODES.values() if code.code[1] == digit]
            section = nodes.section(ids=[f"codes-{digit}"], names=[f"codes-{digit}"])
            section += nodes.title("", title)
            rows = [[link(item), item.severity, item.title] for item in codes]
            section += table(["code", "", "means"], rows, [10, 12, 78])
            found.append(section)
        assert {code[1] for code in CODES} == set(GROUPS), "a group of codes has no title"
        return found


def link(code: Code) -> nodes.Node:
    """A link to the page of a code."""
    link = addnodes.pending_xref(
        "", refdomain="std", reftype="doc", reftarget=f"/{FOLDER}/{code.code}", refexplicit=True, refwarn=True
    )
    link += nodes.inline("", "", nodes.literal("", code.code))
    return link


def write_pages(app: Sphinx) -> None:
    """Write the page of every code that is not as it was, and remove those of codes that are no more."""
    folder = Path(app.srcdir) / FOLDER
    folder.mkdir(exist_ok=True)
    wanted = {f"{code}.md": markdown(code) for code in CODES}
    for old in folder.glob("*.md"):
        if old.name not in wanted:
            old.unlink()
    for name, text in wanted.items():
        path = folder / name
        if not path.is_file() or path.read_text("utf-8") != text:
            path.write_text(text, "utf-8")


def markdown(code: str) -> str:
    """The page of a code as MyST reads it."""
    found = page(code)
    parts = ["---\norphan: true\n---", f"# {code}: {found.title}", found.text]
    parts += ["## Wrong", *blocks(found.wrong)]
    says = render_text(diagnostics_of(found.wrong))
    if says:
        parts += ["The compiler says:", fenced("text", says)]
    parts += ["## Right", *blocks(found.right)]
    parts += [f"In a terminal, `asemec explain {code}` shows this page. [All codes](../diagnostics.md)"]
    return "\n\n".join(parts) + "\n"


def setup(app: Sphinx) -> dict[str, bool]:
    """Make the directive known to Sphinx, and the pages before it looks for them."""
    app.add_directive("diagnostic-codes", DiagnosticCodes)
    app.connect("builder-inited", write_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
