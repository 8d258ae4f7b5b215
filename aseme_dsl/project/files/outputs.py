"""Outputs: the files that a command was told to write. A file of the user's own is never written over."""

from __future__ import annotations

import os
import re
import zlib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Literal

from aseme_dsl import outside

Kind = Literal["bench", "coverage", "drawing", "metrics", "plot", "report", "study", "talk", "trace"]
"""What a file is.

In this order: the report of a bench, what runs have reached, a drawing of a model, a plot of metrics, another
plot, a report of diagnostics. Then the report of a study or its data, the messages between agents, a trace.
"""

_NAMES: Mapping[Kind, str] = {
    "bench": "the report of a bench",
    "coverage": "a measured coverage",
    "drawing": "a drawing",
    "metrics": "a plot of metrics",
    "plot": "a plot",
    "report": "a report",
    "study": "the report of a study",
    "talk": "a drawing of what agents say",
    "trace": "a trace",
}
_OURS: Mapping[Kind, re.Pattern[bytes]] = {
    "bench": re.compile(rb"\A# .*\n\n(?s:.{0,400}?)Times are CPU time of one thread"),
    "coverage": re.compile(rb'\A\{\s*"kind": "asemec coverage"|<title>[^<]*asemec coverage</title>'),
    "drawing": re.compile(
        rb"""class="aseme-(?:compact|drawing)"
        | class="graph"[^\n]*\n<title>(?:(?:aip|srm|eac|iac)\.|sag<|suc<)  # of earlier versions
        | \Adigraph\ "?(?:compact"|(?:aip|srm|eac|iac)\.|sag"?\ |suc"?\ )
        | asemec\ diagram""",
        re.VERBOSE,
    ),
    "metrics": re.compile(rb"<title>[^<]*asemec metrics</title>"),
    "plot": re.compile(rb"<dc:title>asemec (?:bench|optimise)</dc:title>"),
    "report": re.compile(
        rb"""\A\{\s*"format":\ \d+,  # what --json prints
        | "name":\ "asemec"          # SARIF
        | <testsuites\ name="asemec\ # JUnit
        | "check_name":\ "[A-Z]\d{3}"
        | \A\[\]\s*\Z                # code quality, of which there is nothing to say
        | ^::(?:error|warning|notice)\ (?:.*)title=[A-Z]\d{3}
        | \b(?:error|warning|note)\[[A-Z]\d{3}\]
        | ^no\ problems\ found\ in\ \d+\ files?\b
        | \ ->\ .*:\ (?:files:\ |no\ files)
        """,
        re.MULTILINE | re.VERBOSE,
    ),
    "study": re.compile(rb'\A(?:# .*\n\nMeasured: |\{\s*"format": (?s:.*)"less_is_better": )'),
    "talk": re.compile(
        rb"""\A<svg\ [^\n]*class="aseme-drawing\ aseme-talk"  # drawn
        | \A<svg\ [^\n]*font-family="Arial,Liberation\ Sans[^\n]*\n<title>  # by earlier versions
        | \A\ *[\d.]+\ s\ \ \S  # a line of text
        | asemec\ sniff""",
        re.VERBOSE,
    ),
    "trace": re.compile(rb'\A(?:\{"kind": ?"header"|\x89MCAP0\r\n(?s:.{9,30})aseme)'),
}
"""How a file is known that asemec wrote: by what is in it."""
_HEAD = 100_000
"""How much of its beginning is looked at, in bytes."""
_GZIP = 31
"""The window of zlib with which it reads gzip."""
_TAIL = 200
"""How much of its end, where a mark is."""


class NotOurs(Exception):
    """A file must not be written; the text says which, and why."""


def check_outputs(outputs: Iterable[tuple[Path, Kind]], inputs: Iterable[Path | str] = ()) -> None:
    """Refuse to write over a file that is not an earlier output of that kind, over an input, or twice.

    An empty file, a device and a pipe take everything.

    Raises:
        NotOurs: one of them must not be written.
    """
    read = {os.path.realpath(path): path for path in inputs}
    seen: dict[str, Path] = {}
    for path, kind in outputs:
        place = os.path.realpath(path)
        if path.exists() and not path.is_file():
            continue
        if place in read:
            raise NotOurs(f"{path} is read, and would be written over: give {_NAMES[kind]} another name")
        if place in seen:
            raise NotOurs(f"{path} would be written twice: give each its own name")
        seen[place] = path
        if not is_ours(path, kind):
            raise NotOurs(
                f"{path} is there already, and is not {_NAMES[kind]} that asemec wrote: choose another name,"
                " or remove it"
            )


def is_ours(path: Path, kind: Kind) -> bool:
    """Whether a file may be written over: it is none, it is empty, or asemec wrote it as one of that kind."""
    try:
        with outside.open_file(path) as file:
            head = file.read(_HEAD)
            file.seek(0, os.SEEK_END)
            file.seek(max(0, file.tell() - _TAIL))
            tail = file.read(_TAIL)
    except OSError:  # nothing there; or nothing that can be read, which writing will say
        return True
    return not head or any(_OURS[kind].search(part) is not None for part in (head, _unpacked(head), tail))


def _unpacked(head: bytes) -> bytes:
    """The beginning of what is compressed by gzip; nothing of another file."""
    if not head.startswith(b"\x1f\x8b"):
        return b""
    try:
        return zlib.decompressobj(_GZIP).decompress(head, _HEAD)
    except zlib.error:
        return b""


def marked(content: bytes, suffix: str, command: str) -> bytes:
    """A picture or a diagram with an invisible mark that says which command of asemec wrote it.

    Only kinds of files are marked that cannot be told from another's by how asemec writes them.
    """
    mark = f"asemec {command}".encode()
    match suffix:
        case ".png":
            return _with_chunk(content, b"tEXt", b"Software\0" + mark)
        case ".pdf" | ".mmd" | ".mermaid":  # both have comments that begin so
            return content.rstrip(b"\n") + b"\n%% " + mark + b"\n"
        case _:
            return content


def _with_chunk(content: bytes, kind: bytes, data: bytes) -> bytes:
    """A PNG with one more chunk, after its first (the signature has 8 bytes, the first chunk 25)."""
    check = zlib.crc32(kind + data).to_bytes(4, "big")
    return content[:33] + len(data).to_bytes(4, "big") + kind + data + check + content[33:]


__all__ = ["Kind", "NotOurs", "check_outputs", "is_ours", "marked"]
