"""Parsing: from a source to its tree, with all syntax errors of the file."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

from aseme_dsl.diagnostics import Diagnostic, in_order
from aseme_dsl.grammar.tree import File
from aseme_dsl.source import Source


def parse(source: Source) -> tuple[File, tuple[Diagnostic, ...]]:
    """The tree of `source` and what is wrong with its syntax, in the order of the text.

    Whatever could not be read is missing in the tree. Any text at all gives a tree: nothing is raised.
    """
    from aseme_dsl.grammar.build import build
    from aseme_dsl.grammar.explain import explain
    from aseme_dsl.grammar.terminals import read

    with _few_collections():
        model, progress = read(source)
        file, diagnostics = build(source, model, progress.lexed.comments)
        diagnostics += progress.lexed.diagnostics
        diagnostics += [explain(progress.lexed, mistake) for mistake in progress.mistakes]
    return file, in_order(diagnostics)


@contextmanager
def _few_collections() -> Iterator[None]:
    """A tree is many small objects without cycles: to look for cycles costs a third of the time."""
    threshold = gc.get_threshold()
    gc.set_threshold(100_000, 50, 100)
    try:
        yield
    finally:
        gc.set_threshold(*threshold)
