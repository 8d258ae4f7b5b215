"""Fix: files with what their diagnostics have one right answer for, mended until nothing is left to mend."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.changes import UNSURE, apply, by_file, choose
from aseme_dsl.project.building.project import Checked, check
from aseme_dsl.project.files.difference import unified
from aseme_dsl.project.files.inputs import STANDARD_INPUT, Inputs
from aseme_dsl.project.files.write import DISK, Disk, Written, write_over
from aseme_dsl.source import is_library_path

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
            with outside.open_file(path) as file:
                marked = file.read(len(_BYTE_ORDER_MARK)) == _BYTE_ORDER_MARK
        except OSError:
            marked = False  # write_over says so
        mark = _BYTE_ORDER_MARK if marked else b""
        files[path] = (mark + content, mark + mended)
    return write_over(files, disk)


def difference(fixed: Fixed) -> str:
    """The change of all files as a unified diff."""
    return "".join(unified(path, fixed.before[path], text) for path, text in sorted(fixed.after.items()))


def is_mendable(item: Diagnostic) -> bool:
    """Whether `fix` would mend it."""
    paths = [edit.span.source.path for edit in item.changes]
    return bool(paths) and item.code not in UNSURE and all(map(_is_ours, paths))


def _is_ours(path: str) -> bool:
    return path.endswith(".aseme") and path != STANDARD_INPUT and not is_library_path(path)


def _state(texts: Mapping[str, str]) -> tuple[tuple[str, str], ...]:
    return tuple(sorted(texts.items()))


__all__ = ["Fixed", "difference", "fix", "is_mendable", "write_fixed"]
