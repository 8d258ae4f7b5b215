"""Load: a file and all that it imports, from disk or from an editor's buffers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar import tree
from aseme_dsl.interop.proto import ProtoImport
from aseme_dsl.source import Source

LARGEST = 20_000_000
"""The size limit of one file, in bytes, unless told otherwise."""


@dataclass(frozen=True, slots=True)
class Loaded:
    """What was read. `files` come in import order, each after those that it imports, the root last.

    A file that could not be read is missing and has a diagnostic; `protos` are the imported .proto files.
    """

    files: tuple[tree.File, ...]
    protos: tuple[ProtoImport, ...]
    diagnostics: tuple[Diagnostic, ...]


def load(
    root: Source | Path | str, sources: Mapping[str, str] | None = None, *, largest: int = LARGEST
) -> Loaded:
    """Read and parse `root` (a path, or a text that was read already) and everything that it imports.

    A path that is a key of `sources` (texts of an editor, say) is taken from there and not from the disk.
    """
    raise NotImplementedError
