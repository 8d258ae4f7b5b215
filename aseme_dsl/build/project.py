"""Project: roots compiled with the configuration that applies to them."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl.build.configuration import FILE, Configuration, find_configuration, read_configuration
from aseme_dsl.build.inputs import Inputs, find_inputs
from aseme_dsl.compiler import Options, analyse
from aseme_dsl.diagnostics import Diagnostic, has_errors, in_order
from aseme_dsl.source import Source

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System


@dataclass(frozen=True, slots=True)
class Compiled:
    """A root with what is known of it; `system` is None if anything is an error, in its configuration too."""

    root: Path | Source
    configuration: Configuration
    system: System | None
    diagnostics: tuple[Diagnostic, ...]
    files: tuple[str, ...] = ()
    """The paths of what was read."""
    is_library: bool = False
    """Whether the file declares no system, only what other files import."""


def inputs_of(
    arguments: Sequence[str], read_standard_input: Callable[[], bytes], *, as_project: bool = False
) -> Inputs:
    """The files that a command line means; without any, those that the project here names, or else has.

    `as_project`: a folder means the files that its own pyproject.toml names, if it does.
    """
    if not arguments:
        configuration, diagnostics = find_configuration(Path())
        arguments = [str(path) for path in configuration.files] or [str(configuration.folder)]
    elif as_project and len(arguments) == 1 and (Path(arguments[0]) / FILE).is_file():
        configuration, diagnostics = read_configuration(Path(arguments[0]) / FILE)
        arguments = [str(path) for path in configuration.files] or arguments
    else:
        diagnostics = ()
    if has_errors(diagnostics):
        return Inputs((), (), diagnostics)
    return find_inputs(arguments, read_standard_input)


def compile_root(root: Path | Source, *, max_states: int | None = None) -> Compiled:
    """Compile a root; `max_states` goes before what the configuration says."""
    folder = Path(root.path).parent if isinstance(root, Source) else root.parent
    configuration, problems = find_configuration(folder)
    if configuration.files and os.path.realpath(_path(root)) not in map(
        os.path.realpath, configuration.files
    ):
        # The project plays its own files; this one is a neighbour.
        configuration = replace(configuration, run=None)
    largest = max_states or configuration.max_states
    analysis = analyse(root, options=Options(largest=largest) if largest else None)
    diagnostics = in_order((*problems, *analysis.diagnostics))
    system = None if has_errors(diagnostics) else analysis.system
    files = tuple(source.path for source in system.sources) if system else ()
    return Compiled(root, configuration, system, diagnostics, files, analysis.is_library)


def check(inputs: Inputs) -> tuple[tuple[Diagnostic, ...], int]:
    """Every diagnostic of all inputs, and how many files were looked at.

    A file of a folder that declares no system is looked at through those that import it, or else by itself,
    and need not declare one; nor does a file that declares only what other files import.
    """
    found = list(inputs.diagnostics)
    compiled = [compile_root(root) for root in inputs.roots]
    for item in compiled:
        found += [one for one in item.diagnostics if not (item.is_library and one.code == "E008")]
    seen = {os.path.realpath(path) for item in compiled for path in item.files}
    files = {_path(root) for root in inputs.roots}
    files |= {item.span.source.path for item in found if item.span is not None}
    for path in inputs.others:
        files.add(str(path))
        if os.path.realpath(path) not in seen:
            alone = compile_root(path).diagnostics
            found += [item for item in alone if item.code != "E008"]
    return in_order(found), len(files)


def _path(root: Path | Source) -> str:
    return root.path if isinstance(root, Source) else str(root)
