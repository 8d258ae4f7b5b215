"""Program: everything that is known of one system and of all files in it, at one moment."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from functools import cached_property

from aseme_dsl.compiler import Analysis
from aseme_dsl.compiler.phases import Inspection
from aseme_dsl.compiler.read.memory import Recall
from aseme_dsl.compiler.read.pieces import InPieces
from aseme_dsl.diagnostics import Diagnostic, Severity, Suppressed
from aseme_dsl.editor.files.index import Index, Occurrence, World, occurrences, world_of
from aseme_dsl.grammar.parsing.parts import Layout
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

_OF_PYTHON = frozenset(f"E{number}" for number in range(540, 547))
"""Codes of what is wrong with the Python of a project, or is not there."""


def errors_in_texts(diagnostics: Iterable[Diagnostic]) -> list[Diagnostic]:
    """The errors of `.aseme` files: without those of Python files, a model is what its text says."""
    return [item for item in diagnostics if item.severity is Severity.ERROR and item.code not in _OF_PYTHON]


Indexer = Callable[[tree.Declaration, World], tuple[Occurrence, ...]]
"""`index.occurrences`, from memory if it can be."""


@dataclass(frozen=True)
class Program:
    """The files that a root brings together, and what every phase of the compiler has found in them.

    Trees and models keep the spans of the *parts* of files in which they were read (see `grammar.parts`);
    `whole` gives the place in the file. Diagnostics have whole places already.
    """

    root: str
    inspection: Inspection
    diagnostics: tuple[Diagnostic, ...]
    suppressed: tuple[Suppressed, ...] = ()
    indexer: Indexer = occurrences
    recall: Recall = lambda function, *inputs: function(*inputs)
    """What follows from a declaration alone, from memory if it can be (see `compiler.memory`)."""
    tried: Callable[[Mapping[str, str]], Analysis] | None = None
    """What the compiler says where some files, by where they really are, have other texts."""

    @property
    def layout(self) -> Layout:
        return self.inspection.loaded.layout

    @property
    def files(self) -> Mapping[str, tree.File]:
        """The files by where they really are, imports first."""
        loaded = self.inspection.loaded
        return {loaded.paths.get(file.source.path, file.source.path): file for file in loaded.files}

    def path_of(self, source: Source) -> str:
        """Where the file of a text (or of a part of one) really is."""
        return self.inspection.loaded.paths.get(source.path, source.path)

    def place_of(self, item: Diagnostic) -> str:
        """The file that there is something to say of; if that is none, it is the root."""
        shown = (item.path or self.root) if item.span is None else item.span.source.path
        known = self.inspection.loaded.paths.get(shown)
        return known if known is not None else os.path.realpath(shown)

    def whole(self, span: Span) -> Span:
        """The place in its file."""
        return self.layout.whole(span)

    def block_at(self, span: Span) -> tree.Declaration | None:
        """The declaration around a place in a part."""
        for file in self.inspection.loaded.files:
            for item in file.declarations:
                around = item.span
                if around.source is span.source and around.start <= span.start <= around.end:
                    return item
        return None

    def control_at(self, span: Span) -> tuple[tree.Aip | tree.Srm, tree.Control] | None:
        """The control block around a place in a part, with the role or protocol that it is in."""
        block = self.block_at(span)
        if isinstance(block, (tree.Aip, tree.Srm)):
            for control in block.controls:
                if control.span.start <= span.start <= control.span.end:
                    return block, control
        return None

    def controlled(self, block: tree.Aip | tree.Srm, control: tree.Control) -> tree.NamedFormula | None:
        """The formula that a control block is about; of a participant, its process."""
        owners: tuple[tree.Participant | tree.Srm, ...]
        if isinstance(block, tree.Aip):
            owners = block.participants
        else:
            owners = (block, *self.index.world.included.get(block.name.text, ()))
        for owner in owners:
            about_owner = isinstance(owner, tree.Participant) and owner.name.text == control.name.text
            name = "process" if about_owner else control.name.text
            for item in owner.formulas:
                if item.name.text == name:
                    return item
        return None

    def indexing(self) -> InPieces[None]:
        """Look up all names now, in pieces, so that later questions need not."""
        for part in self.index.parts:
            self.index.part(part)
            yield

    @cached_property
    def index(self) -> Index:
        """What every name in the files means."""
        known = self.inspection
        world = world_of(known.symbols, known.loaded.files)
        parts: dict[Source, list[tree.Declaration]] = {}
        for file in known.loaded.files:
            for item in file.declarations:
                parts.setdefault(item.span.source, []).append(item)
        return Index(world, parts, self.indexer)
