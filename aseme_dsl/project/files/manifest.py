"""Manifest: which files in an output folder are ours; no others are ever overwritten or removed."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Mapping
from dataclasses import field
from functools import lru_cache
from pathlib import Path, PurePosixPath
from types import MappingProxyType

from aseme_dsl import outside
from aseme_dsl.records import dataclass
from aseme_dsl.source import STANDARD_INPUT

NAME = ".asemec.json"
FORMAT = 1


class DamagedManifest(Exception):
    """The manifest cannot be understood; the text says why."""


@dataclass(frozen=True, slots=True)
class Entry:
    """A generated file: the part of the build that it belongs to, and the hash of what was written."""

    part: str
    hash: str


@dataclass(frozen=True, slots=True)
class Manifest:
    """What the last builds wrote into a folder.

    `files` are keyed by their path in the folder, with `/`. `started` are files that became the user's when
    they were written (templates of activities, say). They are keyed by a name that does not depend on their
    place. Their hash tells whether anything was filled in since. `source` is the file that was built, as a
    path from the folder with `/`, or `<stdin>`.
    """

    system: str | None = None
    source: str | None = None
    files: MappingProxyType[str, Entry] = field(default_factory=lambda: MappingProxyType({}))
    started: MappingProxyType[str, str] = field(default_factory=lambda: MappingProxyType({}))
    certified: MappingProxyType[str, str] = field(default_factory=lambda: MappingProxyType({}))
    """What was proved of each statechart (`iac.player`)."""


def seen_from_here(folder: Path, source: str) -> str:
    """The source in the manifest of a folder, as people would write it."""
    if source == STANDARD_INPUT:
        return source
    path = os.path.normpath(os.path.join(os.path.realpath(folder), source))  # noqa: PTH118
    return path if folder.is_absolute() else os.path.relpath(path)


def hash_of(content: bytes) -> str:
    """The hash by which a manifest knows a file's content."""
    return hashlib.sha256(content).hexdigest()


def read_manifest(folder: Path) -> Manifest:
    """The manifest of an output folder; an empty one where there is none.

    Raises:
        DamagedManifest: there is something, but no manifest that this version knows.
        OSError: it cannot be read.
    """
    try:
        content = outside.read_bytes(folder / NAME)
    except (FileNotFoundError, NotADirectoryError):
        return Manifest()
    try:
        document = outside.loads(content)
        if not isinstance(document, dict):
            raise TypeError(document)
        number = document["format"]
        if number != FORMAT:
            raise DamagedManifest(f"it has format {number!r}, and this asemec knows format {FORMAT}")
        files = {
            path: Entry(_text(item["part"]), _text(item["hash"])) for path, item in document["files"].items()
        }
        started = {name: _text(value) for name, value in document["started"].items()}
        proved = {name: _text(value) for name, value in document.get("certified", {}).items()}
        system, source = _text(document["system"]), _text(document["source"])
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as problem:
        raise DamagedManifest(f"it is damaged ({type(problem).__name__})") from problem
    # A user may have edited it: no path in it may lead out of the folder.
    files = {path: entry for path, entry in files.items() if is_inside(path)}
    return Manifest(
        system, source, MappingProxyType(files), MappingProxyType(started), MappingProxyType(proved)
    )


def manifest_text(manifest: Manifest) -> str:
    """The manifest as it is written: the same one gives the same bytes."""
    files = {
        path: f'{{\n      "part": {_quoted(entry.part)},\n      "hash": {_quoted(entry.hash)}\n    }}'
        for path, entry in sorted(manifest.files.items())
    }
    document = {
        "format": str(FORMAT),
        "about": _quoted(
            "Written by asemec build: files with these hashes are generated and may be overwritten."
        ),
        "system": "null" if manifest.system is None else _quoted(manifest.system),
        "source": "null" if manifest.source is None else _quoted(manifest.source),
        "files": _object(files, "  "),
        "started": _object({path: _quoted(value) for path, value in sorted(manifest.started.items())}, "  "),
        "certified": _object({name: _quoted(value) for name, value in manifest.certified.items()}, "  "),
    }
    return _object(document, "") + "\n"


_quoted = json.JSONEncoder().encode


def _object(members: Mapping[str, str], margin: str) -> str:
    """JSON with a line for each member, as `json.dumps` indents it; that takes ten times as long."""
    lines = ",\n".join(f"{margin}  {_quoted(name)}: {value}" for name, value in members.items())
    return f"{{\n{lines}\n{margin}}}" if lines else "{}"


@lru_cache(100_000)
def is_inside(path: str) -> bool:
    """Whether a path with `/` stays in the folder that it is relative to."""
    parts = PurePosixPath(path).parts
    return bool(parts) and parts[0] != "/" and ".." not in parts and "\0" not in path and "\\" not in path


def _text(value: object) -> str:
    if not isinstance(value, str):
        raise TypeError(value)
    return value
