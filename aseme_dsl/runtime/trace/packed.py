"""Packed sources: the texts of a model as one member of a line, compressed."""

from __future__ import annotations

import base64
import json
import zlib
from collections.abc import Mapping

from aseme_dsl import outside

LARGEST = 64 << 20
"""So many bytes the texts of a model have at most."""


def packed(sources: Mapping[str, str]) -> str | None:
    """Texts by their paths as one text; None if there are none."""
    if not sources:
        return None
    data = json.dumps(dict(sources), ensure_ascii=False).encode("utf-8", "backslashreplace")
    return base64.b64encode(zlib.compress(data, 9)).decode("ascii")


def unpacked(text: str) -> dict[str, str]:
    """The texts by their paths, in their order.

    Raises:
        ValueError: it is not what `packed` gives.
    """
    reader = zlib.decompressobj()
    try:
        data = reader.decompress(base64.b64decode(text, validate=True), LARGEST)
    except zlib.error as problem:
        raise ValueError(str(problem)) from problem
    found = outside.loads(data, LARGEST) if reader.eof else None
    if not isinstance(found, dict) or not all(isinstance(value, str) for value in found.values()):
        raise ValueError("texts by their paths are wanted")
    return {str(path): value for path, value in found.items()}
