"""Fix: files with what their diagnostics have one right answer for, fixed until nothing is left to fix."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.changes import UNSURE, apply, by_file, choose
from aseme_dsl.project.building.project import Checked, check
from aseme_dsl.project.files.difference import unified
from aseme_dsl.project.files.inputs import Inputs
from aseme_dsl.project.files.write import DISK, Disk, Written, write_over
from aseme_dsl.records import dataclass
from aseme_dsl.source import STANDARD_INPUT, Source, is_library_path

ROUNDS = 50
"""How often files are checked again, at most: each fixed mistake may uncover others."""

_BYTE_ORDER_MARK = "\ufeff".encode()


@dataclass(frozen=True, slots=True)
class Fixed:
    """What was fixed, in the order of fixing, and what is to be said of the files when all of it is.

    `before` and `after` are the texts of the changed files, by path.
    """

    mended: tuple[Diagnostic, ...]
    checked: Checked
    before: Mapping[str, str]
    after: Mapping[str, str]


def fix(inputs: Inputs) -> Fixed:
    """Fix in memory what can be fixed; nothing is written.

    Of changes that overlap, the first counts; then everything is checked again. Files on disk are fixed, and
    none of the standard library. Python is fixed last, once: checked again, there may be more to fix in it.
    """
    checked = check(inputs)
    mended: list[Diagnostic] = []
    before: dict[str, str] = {}
    texts: dict[str, str] = {}
    seen = {_state(texts)}
    for _ in range(ROUNDS):
        chosen = choose(item for item in checked.diagnostics if is_mendable(item, ".aseme"))
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
    of_code = choose(item for item in checked.diagnostics if is_mendable(item, ".py"))
    for path, edits in by_file(of_code).items():
        before[path] = edits[0].span.source.text
        texts[path] = apply(before[path], edits)
    mended += of_code
    left = tuple(item for item in checked.diagnostics if item not in of_code)
    checked = replace(checked, diagnostics=left)
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


def is_mendable(item: Diagnostic, suffix: str = "") -> bool:
    """Whether `fix` would fix it, in files whose names end with `suffix`."""
    sources = [edit.span.source for edit in item.changes]
    return bool(sources) and item.code not in UNSURE and all(_is_ours(source, suffix) for source in sources)


def _is_ours(source: Source, suffix: str) -> bool:
    path = source.path
    if not path.endswith(suffix) or path == STANDARD_INPUT or is_library_path(path):
        return False
    if path.endswith(".py"):  # what ends its lines with \r\n was read with \n
        return source.text == _text_of(path)
    return path.endswith(".aseme")


def _text_of(path: str) -> str | None:
    try:
        return outside.read_bytes(path).decode("utf-8-sig")
    except (OSError, UnicodeDecodeError):
        return None


def _state(texts: Mapping[str, str]) -> tuple[tuple[str, str], ...]:
    return tuple(sorted(texts.items()))


__all__ = ["Fixed", "difference", "fix", "is_mendable", "write_fixed"]
