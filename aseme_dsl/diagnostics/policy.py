"""Policy: how bad a project finds each kind of problem."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fnmatch import fnmatchcase
from pathlib import Path

from aseme_dsl.diagnostics.codes import CODES
from aseme_dsl.diagnostics.model import Diagnostic, Severity
from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Setting:
    """`severity` (None: not reported) for a code, or for all whose codes begin so (`W4`).

    `path` is a pattern (`*`, `?`, `[…]`) for the files that it is about, as seen from the project's folder;
    None is every file.
    """

    code: str
    severity: Severity | None
    path: str | None = None


@dataclass(frozen=True, slots=True)
class Policy:
    """The severities that the project in `folder` sets for diagnostics.

    If several settings match a diagnostic, the one with the longest code prefix applies. Among equal codes,
    settings for particular files precede the others, and later settings precede earlier ones. A setting never
    changes an error, since no code can be generated from a file with errors.
    """

    settings: tuple[Setting, ...] = ()
    folder: Path = Path()

    def apply(self, diagnostics: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
        """The diagnostics with the severities that the project gives them; without those that are off."""
        found = tuple(diagnostics)
        if not self.settings:
            return found
        kept = []
        for item in found:
            setting = self._setting(item)
            if setting is None:
                kept.append(item)
            elif setting.severity is not None:
                kept.append(replace(item, level=setting.severity))
        return tuple(kept)

    def _setting(self, item: Diagnostic) -> Setting | None:
        if CODES[item.code].severity == Severity.ERROR:
            return None
        fitting = [
            (len(setting.code), setting.path is not None, number, setting)
            for number, setting in enumerate(self.settings)
            if item.code.startswith(setting.code) and self._is_about(setting, item)
        ]
        return max(fitting)[-1] if fitting else None

    def _is_about(self, setting: Setting, item: Diagnostic) -> bool:
        if setting.path is None:
            return True
        path = item.span.source.path if item.span is not None else item.path
        if path is None:
            return False
        try:
            inside = Path(path).resolve().relative_to(self.folder.resolve())
        except (ValueError, OSError):  # elsewhere, or no path at all
            return False
        return fnmatchcase(inside.as_posix(), setting.path)


NO_POLICY = Policy()
"""Every code is as bad as its table says."""

__all__ = ["NO_POLICY", "Policy", "Setting"]
