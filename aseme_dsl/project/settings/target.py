"""Target: what commands work on. A file, a project's folder, or the output folder of a build."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from aseme_dsl.compiler.read.load import read_source
from aseme_dsl.diagnostics import Diagnostic, has_errors
from aseme_dsl.diagnostics.problems import files as wrong
from aseme_dsl.project.files.inputs import Inputs, find_inputs, is_folder
from aseme_dsl.project.settings.configuration import (
    FILE,
    OUTPUT,
    Configuration,
    find_configuration,
    read_configuration,
)
from aseme_dsl.runtime.trace.trace_files import GZIP_SUFFIX, USUAL, part_of
from aseme_dsl.source import STANDARD_INPUT

_EARLIER = "trace.jsonl"
"""What a trace of an earlier version is called."""


def project_here() -> str:
    """What commands work on that are given nothing: the folder of the project around the current folder."""
    configuration, _ = find_configuration(Path())
    return str(configuration.folder)


def sources_of(
    targets: Sequence[str], read_standard_input: Callable[[], bytes], *, all_files: bool = False
) -> Inputs:
    """The files that targets mean. Besides targets there may be patterns, and `-` for standard input.

    - A project's folder means the files that its pyproject.toml names (unless `all_files`).
    - An output folder means the file that was built into it.
    - Any other folder means all files in it.
    """
    outputs: dict[Path, Path] = {}
    arguments: list[str] = []
    for target in targets:
        found, problems = _sources(target, outputs, all_files)
        if has_errors(problems):
            return Inputs((), (), problems)
        arguments += found
    return replace(find_inputs(arguments, read_standard_input), outputs=outputs)


def _sources(
    target: str, outputs: dict[Path, Path], all_files: bool
) -> tuple[list[str], tuple[Diagnostic, ...]]:
    folder = Path(target)
    if target == "-" or not is_folder(folder):
        return [target], ()
    if (folder / FILE).is_file():
        if all_files:
            return [target], ()
        configuration, problems = read_configuration(folder / FILE)
        return [str(path) for path in configuration.files] or [target], problems
    found: list[str] = []
    for output in builds_in(folder):
        source = _source(output)
        if isinstance(source, Diagnostic):
            return [], (source,)
        outputs[source] = output
        found.append(str(source))
    return found or [target], ()


def builds_in(folder: Path) -> list[Path]:
    """The output folders that a folder is, or has for several systems; none for one with sources."""
    from aseme_dsl.project.files.manifest import NAME

    if any(folder.glob("*.aseme")):
        return []
    if (folder / NAME).is_file():
        return [folder]
    found = sorted(path.parent for path in folder.glob(f"*/{NAME}"))
    return [] if found and _has_sources(folder) else found


def _has_sources(folder: Path) -> bool:
    inputs = find_inputs([str(folder)], bytes)
    return bool(inputs.roots or inputs.others)


def _source(output: Path) -> Path | Diagnostic:
    """The file that was built into an output folder, or why it cannot be known."""
    from aseme_dsl.project.files.manifest import NAME, DamagedManifest, read_manifest, seen_from_here

    try:
        source = read_manifest(output).source
    except (DamagedManifest, OSError) as problem:
        reason = str(problem.strerror if isinstance(problem, OSError) else problem)
        unread = wrong.ManifestCannotBeRead(str(output / NAME), reason)
        return Diagnostic(unread, None, path=str(output))
    if source is None or source == STANDARD_INPUT:
        return Diagnostic(wrong.BuiltFromInput(str(output)), None, path=str(output))
    shown = seen_from_here(output, source)
    if not os.path.exists(shown):  # noqa: PTH110  raises nothing
        return Diagnostic(wrong.SourceGone(str(shown)), None, path=str(output))
    return Path(shown)


def configuration_of(target: Path) -> tuple[Configuration, tuple[Diagnostic, ...]]:
    """The configuration that applies to a target, which may be an output folder without its source, and what
    is wrong with the target. The configuration's own mistakes are for `check` to report.
    """
    problems: tuple[Diagnostic, ...] = ()
    if is_folder(target):
        if not (target / FILE).is_file() and not builds_in(target) and not _has_sources(target):
            problems = find_inputs([str(target)], bytes).diagnostics
        return find_configuration(target)[0], problems
    inputs = find_inputs([str(target)], bytes)
    source = read_source(target) if inputs.roots else None
    problems = (source,) if isinstance(source, Diagnostic) else inputs.diagnostics
    return find_configuration(target.parent)[0], problems


def traces_of(target: Path, *, following: bool = False) -> tuple[tuple[Path, ...], tuple[Diagnostic, ...]]:
    """The traces that a target means, read or (`following`) still to be written; or what is wrong with it.

    A trace is itself; of a `.aseme` file, a project or an output folder they are those of the last run. A run
    with a process for each agent leaves one trace each.
    """
    if not is_folder(target):
        if target.suffix != ".aseme" and (
            following or _is_there(target) or _is_there(target.with_name(f"{target.name}.part"))
        ):
            return (target,), ()
        source = read_source(target)
        if isinstance(source, Diagnostic):
            return (), (source,)
        folder = target.parent
        is_source = True
    else:
        folder = target
        is_source = (folder / FILE).is_file() or any(folder.glob("*.aseme"))
        if not is_source and not builds_in(folder) and not _traces_in(folder):
            is_source = _has_sources(folder)
            if not is_source and not following:
                return (), find_inputs([str(folder)], bytes).diagnostics
    if is_source:
        configuration, problems = find_configuration(folder)
        if has_errors(problems):
            return (), problems
        if configuration.run is not None and configuration.run.trace is not None:
            return (configuration.run.trace,), ()
        folder = configuration.output or Path(OUTPUT)
        if (other := _built_from_another(folder, target)) is not None:
            return (), (other,)
    whole = _newest(folder / USUAL, folder / _EARLIER)
    each = _of_each_agent(folder)
    if not following and not each and not _is_there(whole) and not _is_there(folder / f"{whole.name}.part"):
        return (), (Diagnostic(wrong.NoTrace(str(whole)), None, path=str(target)),)
    if following or not each:
        return (whole,), ()
    last = max(item.stat().st_mtime for item in each)
    return ((whole,) if whole.is_file() and whole.stat().st_mtime > last else tuple(each)), ()


def _built_from_another(output: Path, target: Path) -> Diagnostic | None:
    """That an output folder was built from another file than that which is meant; None if nothing says so."""
    if is_folder(target) or not builds_in(output):
        return None
    source = _source(output)
    if isinstance(source, Diagnostic) or source.suffix != ".aseme":
        return None
    if not target.exists() or source.samefile(target):
        return None
    return Diagnostic(wrong.TraceOfAnother(str(target), str(output), str(source)), None, path=str(target))


def _newest(*paths: Path) -> Path:
    """The newest of some traces, complete or still being written; the first one, if there is none."""
    times = {path: max(map(_time_of, (path, part_of(path)))) for path in paths}
    return max(paths, key=lambda path: times[path])


def _of_each_agent(folder: Path) -> list[Path]:
    """The traces of a run with a process for each agent; of an agent's compressed and plain one the newer."""
    found = [*folder.glob("trace.*.jsonl.gz"), *folder.glob("trace.*.jsonl")]
    names = sorted({path.name.removesuffix(GZIP_SUFFIX) for path in found})
    return [_newest(folder / f"{name}{GZIP_SUFFIX}", folder / name) for name in names]


def _time_of(path: Path) -> float:
    try:
        return path.stat().st_mtime
    except OSError:
        return 0.0


def _traces_in(folder: Path) -> bool:
    return any(folder.glob("trace*.jsonl*"))


def _is_there(path: Path) -> bool:
    return os.path.lexists(path)


def all_traces_of(
    targets: Sequence[str], *, following: bool = False
) -> tuple[tuple[Path, ...], tuple[Diagnostic, ...]]:
    """The traces that targets mean, each once, and what is wrong with them; without any, the project's."""
    found = [traces_of(Path(target), following=following) for target in targets or [project_here()]]
    paths = dict.fromkeys(path for traces, _ in found for path in traces)
    return tuple(paths), tuple(problem for _, problems in found for problem in problems)


__all__ = [
    "all_traces_of",
    "builds_in",
    "configuration_of",
    "project_here",
    "sources_of",
    "traces_of",
]
