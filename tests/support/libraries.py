"""It takes a tenth of a second to read the largest library, which hundreds of tests import."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

from aseme_dsl.compiler.read import load
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.grammar import parse
from aseme_dsl.grammar.text import tree
from aseme_dsl.source import Source

STDLIB = Path(__file__).parents[2] / "stdlib"


def remember_libraries() -> None:
    """Have the trees of the library's files remembered, where nothing else remembers what was read."""
    texts = {path.read_text("utf-8") for path in STDLIB.glob("*.aseme")}
    read = load._syntax
    remembered = lru_cache(maxsize=32)(lambda path, text: parse(Source(path, text)))

    def syntax(loader: load._Loader, source: Source) -> tuple[tree.File, tuple[Diagnostic, ...]]:
        if loader.read is None and source.text in texts:
            return remembered(source.path, source.text)
        return read(loader, source)

    load._syntax = syntax
