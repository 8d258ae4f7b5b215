"""File names above examples: `<!-- file: team.aseme -->` becomes the caption of the block that follows.

The other comments that the tests of the examples read (tests/docs/pages.py) are left out of the pages.
"""

from __future__ import annotations

import re

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform

COMMENT = re.compile(r"<!-- ([\w ]+?): (.*?) -->")


class FileNames(SphinxTransform):
    """Takes the comments out, and puts the names of files above the blocks."""

    default_priority = 300

    def apply(self) -> None:
        for raw in list(self.document.findall(nodes.raw)):
            said = dict(COMMENT.findall(raw.astext()))
            if not said:
                continue
            block = raw.next_node(siblings=True, descend=False)
            raw.parent.remove(raw)
            while isinstance(block, nodes.raw) and COMMENT.search(block.astext()):
                said.update(COMMENT.findall(block.astext()))
                block = block.next_node(siblings=True, descend=False)
            if isinstance(block, nodes.literal_block):
                name = said.get("file") or said.get("part of") or said.get("change") or said.get("break")
                if name is not None and "with" not in said:
                    _caption(self.document, block, name)


def _caption(document: nodes.document, block: nodes.literal_block, name: str) -> None:
    wrapper = nodes.container(
        "", nodes.caption(name, "", nodes.Text(name)), literal_block=True, classes=["literal-block-wrapper"]
    )
    block.replace_self(wrapper)
    wrapper += block
    document.set_id(wrapper)


def setup(app: Sphinx) -> dict[str, bool]:
    """Let Sphinx do it when a page has been read."""
    app.add_transform(FileNames)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
