"""Foreign files on a disk: read with what goes wrong as diagnostics."""

from __future__ import annotations

from pathlib import Path

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.source import Source


def imported_modules(path: Path) -> tuple[str, tuple[Diagnostic, ...]]:
    """The `modules` block that a Monas `agents.xml` stands for."""
    from aseme_dsl.interop.monas_agents import modules_of

    try:
        text = path.read_bytes().decode("utf-8-sig")
    except OSError as problem:
        message = f"{path} cannot be read: {problem.strerror or problem}"
        return "", (Diagnostic("E001", message, None, path=str(path)),)
    except UnicodeDecodeError:
        return "", (Diagnostic("E002", f"{path} is not UTF-8", None, path=str(path)),)
    return modules_of(Source(str(path), text.replace("\r\n", "\n")))
