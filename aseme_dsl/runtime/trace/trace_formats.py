"""Trace formats: which kind of file a trace is written to, by its name."""

from __future__ import annotations

from pathlib import Path

from aseme_dsl.runtime.trace.trace_files import GZIP_SUFFIX, MCAP_SUFFIX, Format, JsonLines


def format_for(path: Path, part: Path) -> Format:
    """A new file at `part`, of the kind that the name `path` says.

    Raises:
        OSError: there cannot be a file.
        TraceError: the kind needs a package that is not installed.
    """
    if path.suffix == MCAP_SUFFIX:
        from aseme_dsl.runtime.trace.trace_mcap import McapFile

        return McapFile(part)
    if path.suffix == GZIP_SUFFIX:
        from aseme_dsl.runtime.trace.trace_gzip import GzipFile

        return GzipFile(part)
    return JsonLines(part)
