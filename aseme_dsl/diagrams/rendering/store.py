"""Store: pictures that were made before, by the text they were made of."""

from __future__ import annotations

import contextlib
import hashlib
import os
import tempfile
from collections import OrderedDict
from dataclasses import field
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.diagrams.look.drawing import Drawing
from aseme_dsl.diagrams.rendering.layout import TIME_LIMIT, program, render
from aseme_dsl.records import dataclass

_REVISION = 3
"""To be raised when the same DOT text becomes another picture."""


@dataclass(slots=True)
class Store:
    """Pictures in memory, the `most` that were wanted last, and in a folder if one is given.

    A folder that cannot be written to only costs time.
    """

    folder: Path | None = None
    most: int = 64
    _pictures: OrderedDict[str, bytes] = field(default_factory=OrderedDict)

    def render(self, drawing: Drawing, format: str, *, time_limit: float = TIME_LIMIT) -> bytes:
        """The drawing as `layout.render` makes it, made only if it was not before.

        Raises what `render` raises; failures are not kept.
        """
        key = f"{key_of(drawing)}.{format}"
        made = self._pictures.get(key) or self._read(key)
        if made is None:
            made = render(drawing, format, time_limit=time_limit)
            self._write(key, made)
        self._pictures[key] = made
        self._pictures.move_to_end(key)
        while len(self._pictures) > self.most:
            self._pictures.popitem(last=False)
        return made

    def _read(self, key: str) -> bytes | None:
        if self.folder is None:
            return None
        try:
            return outside.read_bytes(self.folder / key) or None
        except OSError:
            return None

    def _write(self, key: str, made: bytes) -> None:
        """Whole or not at all: several processes may draw at the same time."""
        if self.folder is None:
            return
        with contextlib.suppress(OSError):
            self.folder.mkdir(parents=True, exist_ok=True)
            handle, name = tempfile.mkstemp(dir=self.folder)
            with os.fdopen(handle, "wb") as file:
                file.write(made)
            Path(name).replace(self.folder / key)


def key_of(drawing: Drawing) -> str:
    """What stays the same as long as the picture does: a hash of its texts and of what draws it.

    Raises GraphvizMissing where nothing draws.
    """
    by = drawing.picture or program()
    text = f"{_REVISION}\n{by}\n{drawing.about}\n{drawing.dot}"
    return hashlib.sha256(text.encode("utf-8", "backslashreplace")).hexdigest()[:40]


__all__ = ["Store", "key_of"]
