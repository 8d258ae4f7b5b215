"""Identity: by what a service knows a problem and its file again from one run to the next."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Iterable
from pathlib import Path, PurePath
from urllib.parse import quote

from aseme_dsl.diagnostics.model import Diagnostic


def fingerprints(diagnostics: Iterable[Diagnostic]) -> list[str]:
    """An identifier of each diagnostic, which stays the same when lines are added elsewhere in the file.

    It is a hash of the code, the path, and the text of the line and of the place. If several diagnostics have
    all of these in common, the hash also includes their number in order.
    """
    seen: Counter[str] = Counter()
    found: list[str] = []
    for item in diagnostics:
        parts = [item.code]
        if item.span is not None:
            line = item.span.source.line(item.span.line)
            parts += [uri(item.span.source.path), " ".join(line.split()), " ".join(item.span.text.split())]
        else:
            parts.append(uri(item.path or ""))
        base = "\0".join(parts)
        seen[base] += 1
        text = f"{base}\0{seen[base]}"
        found.append(hashlib.sha256(text.encode("utf-8", "replace")).hexdigest()[:32])
    return found


def uri(path: str) -> str:
    """Relative to the working directory where it is below that, else absolute."""
    inside = below_here(path)
    if inside is None:
        return Path(path).absolute().as_uri()
    return quote(inside.as_posix(), errors="replace")


def below_here(path: str) -> PurePath | None:
    """The path as seen from the working directory; None where it is not below that."""
    pure = PurePath(path)
    if not pure.is_absolute() and ".." not in pure.parts:
        return pure
    try:
        return Path(path).absolute().resolve().relative_to(Path.cwd().resolve())
    except (ValueError, OSError):
        return None


__all__ = ["below_here", "fingerprints", "uri"]
