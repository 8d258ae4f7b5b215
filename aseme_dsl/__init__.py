"""ASEME in text: from a `.aseme` file through every AMOLA model to statecharts that run.

    import aseme_dsl

    system = aseme_dsl.compile("kouretes.aseme")
    player = system.iac("player")

`analyse` gives the warnings and notes as well, and raises nothing.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from aseme_dsl.display import Displays, shown_by

if TYPE_CHECKING:
    from collections.abc import Mapping
    from os import PathLike

    from aseme_dsl.amola.system import System
    from aseme_dsl.compiler import Analysis, Options, analyse
    from aseme_dsl.diagnostics import Diagnostic
    from aseme_dsl.source import Source

__version__ = "0.1.0"

__all__ = ["Analysis", "CompileError", "Options", "System", "__version__", "analyse", "compile"]


class CompileError(Exception):
    """A file has errors: `diagnostics` are all of them, with the warnings and notes, in order."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        super().__init__(diagnostics)
        self.diagnostics = diagnostics

    def __str__(self) -> str:
        from aseme_dsl.diagnostics import render_text

        return render_text(self.diagnostics)


def compile(
    path: str | PathLike[str] | Source,
    *,
    sources: Mapping[str, str] | None = None,
    options: Options | None = None,
) -> System:
    """Compile a file, with all that it imports, to the models of its system.

    `path` may be a `Source`, for a text that is not in a file. Texts in `sources`, by path, replace the files
    on disk. Raises `CompileError` if there is an error.
    """
    from pathlib import Path

    from aseme_dsl.compiler import analyse
    from aseme_dsl.source import Source

    analysis = analyse(path if isinstance(path, Source) else Path(path), sources, options)
    if analysis.system is None:
        raise CompileError(analysis.diagnostics)
    return analysis.system


def __getattr__(name: str) -> object:
    """Import names that need the compiler on first use: on a robot, the runtime works without it."""
    if name in ("Analysis", "Options", "analyse"):
        import aseme_dsl.compiler

        return getattr(aseme_dsl.compiler, name)
    if name == "System":
        from aseme_dsl.amola.system import System

        return System
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def _displays() -> Displays:
    """What a notebook shows is made with Graphviz: a robot does without it."""
    from aseme_dsl.documents.notebook import DISPLAYS

    return DISPLAYS


shown_by(_displays)
