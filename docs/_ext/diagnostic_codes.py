"""`{diagnostic-codes}`: every code of a diagnostic with its title, from the compiler's own table."""

from __future__ import annotations

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective
from tables import table

from aseme_dsl.diagnostics import CODES

GROUPS = {
    "0": "Files and projects",
    "1": "Syntax",
    "2": "Names and declarations",
    "3": "Formulas",
    "4": "Control",
    "5": "Types",
    "6": "Statecharts",
    "7": "What is not said yet",
}


class DiagnosticCodes(SphinxDirective):
    """A section for each group of codes."""

    def run(self) -> list[nodes.Node]:
        found: list[nodes.Node] = []
        for digit, title in GROUPS.items():
            codes = [code for code in CODES.values() if code.code[1] == digit]
            section = nodes.section(ids=[f"codes-{digit}"], names=[f"codes-{digit}"])
            section += nodes.title("", title)
            rows = [[f"`{item.code}`", item.severity, item.title] for item in codes]
            section += table(["code", "", "means"], rows, [10, 12, 78])
            found.append(section)
        assert {code[1] for code in CODES} == set(GROUPS), "a group of codes has no title here"
        return found


def setup(app: Sphinx) -> dict[str, bool]:
    """Make the directive known to Sphinx."""
    app.add_directive("diagnostic-codes", DiagnosticCodes)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
