"""Target: what commands work on. A file, a project's folder, or the output folder of a build."""

from __future__ import annotations

from pathlib import Path

from aseme_dsl.build.configuration import OUTPUT, find_configuration


def project_here() -> str:
    """What commands work on that are given nothing: the folder of the project around the current folder."""
    configuration, _ = find_configuration(Path())
    return str(configuration.folder)


def traces_of(target: Path, *, following: bool = False) -> list[Path]:
    """The traces that a target means, read or (`following`) still to be written.

    A trace is itself; of a `.aseme` file, a project or an output folder they are those of the last run. A run
    with a process for each agent leaves one trace each.
    """
    if target.suffix != ".aseme" and not target.is_dir():
        return [target]
    folder = target if target.is_dir() else target.parent
    if target.is_file() or (folder / "pyproject.toml").is_file() or any(folder.glob("*.aseme")):
        configuration, _ = find_configuration(folder)
        if configuration.run is not None and configuration.run.trace is not None:
            return [configuration.run.trace]
        folder = configuration.output or folder / OUTPUT
    whole = folder / "trace.jsonl"
    each = sorted(folder.glob("trace.*.jsonl"))
    if following or not each:
        return [whole]
    last = max(item.stat().st_mtime for item in each)
    return [whole] if whole.is_file() and whole.stat().st_mtime > last else each


__all__ = ["project_here", "traces_of"]
