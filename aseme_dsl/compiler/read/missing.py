"""Missing: what the analyst has not said yet, as a note with the text to start from and its place."""

from __future__ import annotations

from aseme_dsl.diagnostics import Diagnostic, Edit
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class Missing:
    """A note (N7xx) with its skeleton: lines for the end of the block `inside`, or (None) of the note's file.

    A skeleton that could not stand there without being used is written as a comment; unless `edits` say where
    it is used, too: they are insertions, which are made instead.
    """

    note: Diagnostic
    skeleton: str
    inside: Span | None = None
    edits: tuple[Edit, ...] = ()

    @property
    def place(self) -> Span | None:
        """What tells in which file it is written."""
        return self.edits[0].span if self.edits else self.inside or self.note.span

    @property
    def is_comment(self) -> bool:
        """Whether all that is written is a comment."""
        return not self.edits and all(line.startswith("//") for line in self.skeleton.split("\n"))


_STEP = "  "


def insertions(text: str, missing: Missing) -> list[tuple[int, str]]:
    """What is written into the text of its file, and where; nothing if it is there already."""
    if not missing.edits:
        found = _insertion(text, missing)
        return [] if found is None else [found]
    newline = "\r\n" if "\r\n" in text else "\n"
    return [(edit.span.start, edit.text.replace("\n", newline)) for edit in missing.edits]


def _insertion(text: str, missing: Missing) -> tuple[int, str] | None:
    """Where a skeleton goes in the text of its file, and what is written; None if it is there already."""
    lines = missing.skeleton.split("\n")
    around = text if missing.inside is None else text[missing.inside.start : missing.inside.end]
    if lines[0].startswith("//") and lines[0] in around:
        return None
    at, piece = _at_end(text, lines) if missing.inside is None else in_block(text, missing.inside, lines)
    return at, piece.replace("\n", "\r\n" if "\r\n" in text else "\n")


def _at_end(text: str, lines: list[str]) -> tuple[int, str]:
    """After an empty line at the end of the file."""
    gap = "\n" if text.endswith("\n") or not text else "\n\n"
    return len(text), gap + "\n".join(lines) + ("\n" if text.endswith("\n") else "")


def in_block(text: str, block: Span, lines: list[str]) -> tuple[int, str]:
    """Before the last brace of a block, as far in as what is already there."""
    brace = block.end - 1
    start = text.rfind("\n", 0, brace) + 1
    before = text[start:brace]
    indent = before[: len(before) - len(before.lstrip())]
    inner = _indent_inside(text[block.start : brace]) or indent + _STEP
    body = "".join(f"{inner}{line}\n" if line else "\n" for line in lines)
    if not before.strip():
        return start, body if lines[0].startswith("//") else "\n" + body
    # The brace shares its line: the skeleton and the brace get lines of their own.
    return brace, "\n" + body + indent


def _indent_inside(block: str) -> str:
    """The indentation of the first line inside a block; none where it begins on the line of its brace."""
    for line in block.split("\n")[1:]:
        if line.strip():
            return line[: len(line) - len(line.lstrip())]
    return ""


__all__ = ["Missing", "in_block", "insertions"]
