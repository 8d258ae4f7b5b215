"""Format: files brought into the canonical layout."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from aseme_dsl.compiler.read.load import read_source
from aseme_dsl.diagnostics import Diagnostic, has_errors
from aseme_dsl.grammar.layout import format_source
from aseme_dsl.project.files.difference import unified
from aseme_dsl.project.files.inputs import Inputs, find_inputs
from aseme_dsl.project.files.write import DISK, Disk, write_over
from aseme_dsl.project.settings.configuration import find_configuration
from aseme_dsl.project.settings.target import sources_of
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source


@dataclass(frozen=True, slots=True)
class LaidOut:
    """A file before and after. Both are the same if it has errors, or has the canonical layout already."""

    path: str
    before: str
    text: str
    diagnostics: tuple[Diagnostic, ...] = ()

    @property
    def changed(self) -> bool:
        return self.text != self.before

    @property
    def difference(self) -> str:
        """What changes, as a unified diff."""
        return unified(self.path, self.before, self.text)


def files_to_format(arguments: Sequence[str], read_standard_input: Callable[[], bytes]) -> Inputs:
    """The files that a command line means; without any, all `.aseme` files of the project here."""
    if arguments:
        return sources_of(arguments, read_standard_input, all_files=True)
    configuration, diagnostics = find_configuration(Path())
    if has_errors(diagnostics):
        return Inputs((), (), diagnostics)
    return find_inputs([str(configuration.folder)], read_standard_input)


def format_file(file: Path | Source, *, write: bool, disk: Disk = DISK) -> LaidOut:
    """Lay a file out and (with `write`) write it; one with syntax errors stays as it is."""
    source = file if isinstance(file, Source) else read_source(file)
    if isinstance(source, Diagnostic):
        return LaidOut(str(file), "", "", (source,))
    laid = format_source(source)
    if laid.diagnostics or not laid.changed:
        return LaidOut(source.path, source.text, source.text, laid.diagnostics)
    if write and not isinstance(file, Source):
        written = write_over({file: (source.text.encode("utf-8"), laid.text.encode("utf-8"))}, disk)
        if written.diagnostics:
            return LaidOut(source.path, source.text, source.text, written.diagnostics)
    return LaidOut(source.path, source.text, laid.text)
