"""Complete: the skeletons of what is missing, put into the file itself."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from pathlib import Path

from aseme_dsl.compiler import Options, analyse
from aseme_dsl.compiler.read.load import read_source
from aseme_dsl.diagnostics import Diagnostic, has_errors, in_order
from aseme_dsl.project.code.activity_files import renewed_stubs, stubs
from aseme_dsl.project.editing.scaffold import scaffold
from aseme_dsl.project.files.difference import unified
from aseme_dsl.project.files.write import DISK, Disk, write_file, write_new, write_over
from aseme_dsl.project.settings.configuration import find_configuration
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source


@dataclass(frozen=True, slots=True)
class Completed:
    """A file with its skeletons: `added` are the notes that they answer, `diagnostics` what is left to say.

    `advised` are those that get a comment only. `before` and `text` are the same if there was nothing to add,
    or an error. `code` are the first versions of files of activities, by their paths; they `wait` as long as
    the file has holes.
    """

    path: str
    before: str
    text: str
    added: tuple[Diagnostic, ...]
    diagnostics: tuple[Diagnostic, ...]
    code: Mapping[Path, str] = field(default_factory=dict)
    wait: bool = False
    advised: tuple[Diagnostic, ...] = ()
    renewed: Mapping[Path, tuple[str, str]] = field(default_factory=dict)
    """Files of activities without an edit, as they were and as they are started now."""

    @property
    def difference(self) -> str:
        """What is added, as a unified diff."""
        differences = [unified(self.path, self.before, self.text)]
        differences += [unified(str(path), "", text) for path, text in self.code.items()]
        differences += [unified(str(path), before, after) for path, (before, after) in self.renewed.items()]
        return "".join(differences)


def complete(
    root: Path | Source, *, write: bool = True, activities: Path | None = None, disk: Disk = DISK
) -> Completed:
    """Add to a file what its notes say is missing, and (with `write`) put it in the file's place.

    Every character that is there stays, line ends and byte-order mark included; a file with errors stays as
    it is. Where the project has a folder for the code of activities, or `activities` is one, each that has no
    file there gets its first version. A first version that is not edited follows what the file says now.
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
    folder = activities or configuration.activities
    code: dict[Path, bytes] = {}
    changed: dict[Path, tuple[bytes, bytes]] = {}
    wait = False
    if folder is not None and not isinstance(root, Source):
        analysis = analyse(Source(source.path, result.text), options=options)
        wait = analysis.system is None or has_errors(analysis.diagnostics)
        if analysis.system is not None and not wait:
            code = stubs(analysis.system, folder, configuration.templates)
            changed = renewed_stubs(analysis.system, folder, configuration.templates)
    if write and code:
        found = in_order((*found, *write_new(code, disk).diagnostics))
        code = {} if has_errors(found) else code
    if write and changed:
        found = in_order((*found, *write_over(changed, disk).diagnostics))
        changed = {} if has_errors(found) else changed
    texts = {path: content.decode("utf-8") for path, content in code.items()}
    renewed = {path: (old.decode("utf-8"), new.decode("utf-8")) for path, (old, new) in changed.items()}
    return Completed(
        source.path, source.text, result.text, result.added, found, texts, wait, result.advised, renewed
    )
