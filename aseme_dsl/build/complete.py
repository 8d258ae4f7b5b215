"""Complete: the skeletons of what is missing, put into the file itself."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from aseme_dsl.build.configuration import find_configuration
from aseme_dsl.build.difference import unified
from aseme_dsl.build.scaffold import scaffold
from aseme_dsl.build.write import DISK, Disk, write_file
from aseme_dsl.compiler import Options
from aseme_dsl.compiler.load import read_source
from aseme_dsl.diagnostics import Diagnostic, has_errors, in_order
from aseme_dsl.source import Source


@dataclass(frozen=True, slots=True)
class Completed:
    """A file with its skeletons: `added` are the notes that they answer, `diagnostics` what is left to say.

    `before` and `text` are the same if there was nothing to add, or an error.
    """

    path: str
    before: str
    text: str
    added: tuple[Diagnostic, ...]
    diagnostics: tuple[Diagnostic, ...]

    @property
    def difference(self) -> str:
        """What is added, as a unified diff."""
        return unified(self.path, self.before, self.text)


def complete(root: Path | Source, *, write: bool = True, disk: Disk = DISK) -> Completed:
    """Add to a file what its notes say is missing, and (with `write`) put it in the file's place.

    Every character that is there stays, line ends and byte-order mark included; a file with errors stays as
    it is.
    """
    path = Path(root.path) if isinstance(root, Source) else root
    configuration, problems = find_configuration(path.parent)
    options = Options(largest=configuration.max_states) if configuration.max_states else None
    if isinstance(root, Source):
        source = root
    else:
        found_source = read_source(path)
        if isinstance(found_source, Diagnostic):
            return Completed(str(path), "", "", (), in_order((*problems, found_source)))
        source = found_source
    result = scaffold(source, options=options)
    found = in_order((*problems, *result.diagnostics))
    if has_errors(found):
        return Completed(source.path, source.text, source.text, (), found)
    if write and not isinstance(root, Source) and result.text != source.text:
        written = write_file(path.resolve(), result.text.encode("utf-8"), disk)
        if written.diagnostics:
            return Completed(source.path, source.text, source.text, (), written.diagnostics)
    return Completed(source.path, source.text, result.text, result.added, found)
