"""Fix: files with what their diagnostics have one right answer for, mended until nothing is left to mend."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from aseme_dsl.build.difference import unified
from aseme_dsl.build.inputs import STANDARD_INPUT, Inputs
from aseme_dsl.build.project import Checked, check
from aseme_dsl.build.write import DISK, Disk, Written, write_over
from aseme_dsl.diagnostics import Diagnostic, Edit

UNSURE = frozenset(("W200",))
"""Codes whose fix is for people to decide: two names may be meant to be close."""

ROUNDS = 50
"""How often files are checked again, at most: each mended mistake may uncover others."""

_BYTE_ORDER_MARK = "\ufeff".encode()


@dataclass(frozen=True, slots=True)
class Fixed:
    """What was mended, in the order of mending, and what is to be said of the files when all of it is.

    `before` and `after` are the texts of the changed files, by path.
    """

    mended: tuple[Diagnostic, ...]
    checked: Checked
    before: Mapping[str, str]
    after: Mapping[str, str]


def fix(inputs: Inputs) -> Fixed:
    """Mend in memory what can be mended; nothing is written.

    Of changes that overlap, the first counts; then everything is checked again. Only `.aseme` files on disk
    are mended, and none of the standard library.
    """
    checked = check(inputs)
    mended: list[Diagnostic] = []
    before: dict[str, str] = {}
    texts: dict[str, str] = {}
    seen = {_state(texts)}
    for _ in range(ROUNDS):
        chosen = choose(item for item in checked.diagnostics if is_mendable(item))
        changed = dict(texts)
        for path, edits in by_file(chosen).items():
            text = edits[0].span.source.text
            before.setdefault(path, text)
            changed[path] = apply(text, edits)
        if _state(changed) in seen:
            break  # nothing left to do, or answers that undo each other: then neither is the right one
        seen.add(_state(changed))
        texts = changed
        mended += chosen
        checked = check(inputs, texts)
    after = {path: text for path, text in texts.items() if text != before[path]}
    return Fixed(tuple(mended), checked, {path: before[path] for path in after}, after)


def write_fixed(fixed: Fixed, disk: Disk = DISK) -> Written:
    """Write the changed files, all or none; one that has changed meanwhile is an error (E009)."""
    files: dict[Path, tuple[bytes, bytes]] = {}
    for name, text in fixed.after.items():
        path = Path(name)
        content, mended = (item.encode("utf-8") for item in (fixed.before[name], text))
        try:
            marked = path.read_bytes().startswith(_BYTE_ORDER_MARK)
        except OSError:
            marked = False  # write_over says so
        mark = _BYTE_ORDER_MARK if marked else b""
        files[path] = (mark + content, mark + mended)
    return write_over(files, disk)


def difference(fixed: Fixed) -> str:
    """The change of all files as a unified diff."""
    return "".join(unified(path, fixed.before[path], text) for path, text in sorted(fixed.after.items()))


def choose(diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
    """Those whose changes do not overlap: of two that do, the first. All changes of one go together."""
    taken: dict[str, list[Edit]] = {}
    chosen = []
    for item in diagnostics:
        mine = by_file([item])
        if not any(
            _overlap(edit, other)
            for path, edits in mine.items()
            for edit in edits
            for other in taken.get(path, ())
        ):
            chosen.append(item)
            for path, edits in mine.items():
                taken.setdefault(path, []).extend(edits)
    return chosen


def by_file(diagnostics: Iterable[Diagnostic]) -> dict[str, list[Edit]]:
    """The changes of all, by the path of the file; several systems may have read it, each for itself."""
    names: dict[str, str] = {}
    found: dict[str, list[Edit]] = {}
    for item in diagnostics:
        for edit in item.changes:
            shown = edit.span.source.path
            found.setdefault(names.setdefault(os.path.realpath(shown), shown), []).append(edit)
    return found


def apply(text: str, edits: Sequence[Edit]) -> str:
    """The text with changes that do not overlap."""
    for edit in sorted(edits, key=lambda item: (item.span.start, item.span.end), reverse=True):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    return text


def _overlap(first: Edit, second: Edit) -> bool:
    a, b = first.span, second.span
    if a.start == a.end or b.start == b.end:
        return a.start <= b.end and b.start <= a.end
    return a.start < b.end and b.start < a.end


def is_mendable(item: Diagnostic) -> bool:
    """Whether `fix` would mend it."""
    paths = [edit.span.source.path for edit in item.changes]
    return bool(paths) and item.code not in UNSURE and all(map(_is_ours, paths))


def _is_ours(path: str) -> bool:
    return path.endswith(".aseme") and path != STANDARD_INPUT and not path.startswith("stdlib/")


def _state(texts: Mapping[str, str]) -> tuple[tuple[str, str], ...]:
    return tuple(sorted(texts.items()))


__all__ = ["Fixed", "apply", "by_file", "choose", "difference", "fix", "is_mendable", "write_fixed"]
