"""Layout: the one canonical form of an `.aseme` file (`asemec fmt`)."""

from __future__ import annotations

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.syntax.entries import Hole
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source

__all__ = ["Formatted", "format_source"]


@dataclass(frozen=True, slots=True)
class Formatted:
    """A source and its text in the canonical layout.

    Where the source has syntax errors, they are in `diagnostics`, and `text` is the source's own.
    """

    source: Source
    text: str
    diagnostics: tuple[Diagnostic, ...] = ()

    @property
    def changed(self) -> bool:
        return self.text != self.source.text


def format_source(source: Source) -> Formatted:
    """The canonical layout of a file: the same tokens in the same order, and all comments.

    Left out are the separators between fields and between constants; `ω` becomes `~`. Lines end as the first
    line of the source does, and a byte-order mark stays. What is formatted already comes back as it is. Any
    text at all is formatted or has diagnostics: nothing is raised.
    """
    from aseme_dsl.grammar.layout.reading import read_blocks
    from aseme_dsl.grammar.layout.writing import write_blocks
    from aseme_dsl.grammar.parsing.parse import parse_with_leaves

    tree, comments, diagnostics = parse_with_leaves(source)
    if any(not isinstance(item.problem, Hole) for item in diagnostics):  # holes are laid out as operators are
        return Formatted(source, source.text, diagnostics)
    text = write_blocks(read_blocks(source, tree, comments))
    if _ends_lines_as_windows(source.text):
        text = text.replace("\n", "\r\n")
    return Formatted(source, "\ufeff" * source.text.startswith("\ufeff") + text)


def _ends_lines_as_windows(text: str) -> bool:
    end = text.find("\n")
    return end > 0 and text[end - 1] == "\r"
