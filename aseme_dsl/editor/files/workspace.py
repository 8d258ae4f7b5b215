"""Workspace: the files that are open in an editor, over those on disk, and which programs they belong to."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import field, replace
from pathlib import Path
from typing import TypeVar, cast

from aseme_dsl import outside
from aseme_dsl.amola.system import System
from aseme_dsl.compiler import Analysis, Options
from aseme_dsl.compiler.checks.consequences import without_told
from aseme_dsl.compiler.formula.holes import as_notes
from aseme_dsl.compiler.names.symbols import Symbols
from aseme_dsl.compiler.phases import Inspection, inspecting
from aseme_dsl.compiler.read.load import Read
from aseme_dsl.compiler.read.memory import Memory
from aseme_dsl.compiler.read.pieces import InPieces, finished
from aseme_dsl.diagnostics import Diagnostic, Suppressed, has_errors, in_order
from aseme_dsl.diagnostics.problems.files import NoSystem
from aseme_dsl.editor.files.carrying import Carry, carry
from aseme_dsl.editor.files.index import Occurrence, Symbol, World, occurrences
from aseme_dsl.editor.files.program import Indexer, Program
from aseme_dsl.editor.files.view import View, carried
from aseme_dsl.editor.reading.reading import parse
from aseme_dsl.grammar.parsing.parts import InParts, Parts
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source
from aseme_dsl.standard_library import standard_library

_T = TypeVar("_T")

MOST_FILES = 2000
"""How many files of a folder are looked at for what imports what."""

MOST_EDITS = 100
"""How many edits are kept one by one until the compiler has seen them."""


@dataclass(frozen=True, slots=True)
class Project:
    """What a project on disk says, as an editor needs it; the command line knows where to find it.

    - `options` gives the options for a root, and the diagnostics of the configuration.
    - `code` gives the diagnostics of the Python of the activities, and those that comments there allow.
    - `without_read` leaves out the diagnostics of a variable that only this code reads.
    """

    options: Callable[[Path], tuple[Options, tuple[Diagnostic, ...]]] = lambda root: (Options(), ())
    code: Callable[[Path, System], tuple[tuple[Diagnostic, ...], tuple[Suppressed, ...]]] = (
        lambda root, system: ((), ())
    )
    without_read: Callable[[Path, System, tuple[Diagnostic, ...]], tuple[Diagnostic, ...]] = (
        lambda root, system, found: found
    )


@dataclass(frozen=True, slots=True)
class Buffer:
    """The text of an open file."""

    text: str
    version: int | None


def _occurrences(declaration: tree.Declaration, *world: *_World) -> tuple[Occurrence, ...]:
    return occurrences(declaration, World(*world))


_World = tuple[
    Symbols,
    frozenset[str],
    Mapping[str, Symbol],
    Mapping[str, tuple[tree.Srm, ...]],
    frozenset[tuple[str, str]],
    Mapping[str, tuple[str, ...]],
]

_MAY_IMPORT = re.compile(r"^[ \t]*(?:import|system)\b[^\n]*(?:\n[^\n]*)?", re.MULTILINE)
_IMPORT = re.compile(
    r'//[^\n]*|/\*[\s\S]*?\*/|\bimport\s+(?:"([^"\n]*)"|([A-Za-z_]\w*))|\b(system)\s+\w|"[^"\n]*"'
)


@dataclass(frozen=True, slots=True)
class Header:
    """What a text says of other files: the paths that it imports (as written), and whether it is a system."""

    imports: tuple[str, ...]
    libraries: tuple[str, ...]
    is_system: bool


def header_of(text: str) -> Header:
    """What a text imports, and whether it declares a system."""
    # Most of a file is of no interest: look at all of it only if comments may hide something.
    lines = text if "/*" in text else "\n".join(_MAY_IMPORT.findall(text))
    found = list(_IMPORT.finditer(lines))
    return Header(
        tuple(item[1] for item in found if item[1]),
        tuple(item[2] for item in found if item[2]),
        any(item[3] for item in found),
    )


@dataclass
class Workspace:
    """The state of an editor's session: what is open, and what was found out last. For one thread."""

    project: Project = field(default_factory=Project)
    folders: list[str] = field(default_factory=list)
    buffers: dict[str, Buffer] = field(default_factory=dict)
    _programs: dict[str, Program] = field(default_factory=dict)
    _views: dict[str, View] = field(default_factory=dict)
    _good: dict[str, View] = field(default_factory=dict)
    _recent: dict[str, View] = field(default_factory=dict)
    _headers: dict[str, tuple[object, Header]] = field(default_factory=dict)
    _memories: dict[str, Memory] = field(default_factory=dict)
    _parts: dict[str, Parts] = field(default_factory=dict)
    _carried: dict[str, View] = field(default_factory=dict)
    _edits: dict[str, tuple[Carry, ...]] = field(default_factory=dict)
    _moment: int = 0

    # ---- what the editor says ------------------------------------------------------------------

    def open(self, path: str, text: str, version: int | None = None) -> None:
        """A file is open with this text now, or has changed to it."""
        path = os.path.realpath(path)
        known = self._recent.get(path)
        if known is not None:
            self._edits[path] = self._edited(path, known, text.removeprefix("\ufeff"))
        self.buffers[path] = Buffer(text, version)
        self.forget()

    def _edited(self, path: str, known: View, text: str) -> tuple[Carry, ...]:
        """What leads from the text that was compiled last to this one."""
        edits = self._edits.get(path, ())
        before = self.buffers[path].text.removeprefix("\ufeff") if edits else known.source.text
        if before == text:
            return edits
        if len(edits) < MOST_EDITS:
            return (*edits, carry(before, text))
        return (carry(known.source.text, text),) if known.source.text != text else ()

    def close(self, path: str) -> None:
        """The file counts as it is on disk again."""
        path = os.path.realpath(path)
        self.buffers.pop(path, None)
        for known in (
            self._good,
            self._recent,
            self._edits,
            self._carried,
            self._memories,
            self._parts,
            self._headers,
        ):
            known.pop(path, None)
        if not self.buffers:
            self._memories.clear()
            self._parts.clear()
        self.forget()

    def forget(self) -> None:
        """Something has changed, here or on disk."""
        self._moment += 1
        self._programs.clear()
        self._views.clear()

    # ---- what it gets to know ------------------------------------------------------------------

    def view(self, path: str) -> View | None:
        """The file as it is now; None if it is not open and cannot be read."""
        return finished(self.viewing(path))

    def viewing(self, path: str) -> InPieces[View | None]:
        """The same in pieces; if something changes in between, it begins anew."""
        path = os.path.realpath(path)
        return (yield from self._steadily(lambda: self._viewing(path)))

    def _steadily(self, begin: Callable[[], InPieces[_T]]) -> InPieces[_T]:
        """Work that counts for one moment: it begins anew if something changes in between."""
        while True:
            moment, work = self._moment, begin()
            while self._moment == moment:
                try:
                    next(work)
                except StopIteration as end:
                    return cast(_T, end.value)
                yield

    def recent(self, path: str) -> View | None:
        """The file as it is now, at once: with what was known when all was last compiled.

        Only a file that was never looked at is compiled for it.
        """
        path = os.path.realpath(path)
        known, text = self._recent.get(path), self.text(path)
        if known is None or text is None or path not in self.buffers:
            return self.view(path)
        edits = self._edits.get(path, ())
        found = self._carried.get(path, known)
        if found.program is not known.program or found.carry is not edits:
            found = self._carried[path] = carried(known, text.removeprefix("\ufeff"), edits)
        return found

    def is_known(self, path: str) -> bool:
        """Whether `recent` has something to go by."""
        return os.path.realpath(path) in self._recent

    def text(self, path: str) -> str | None:
        """The text of a file: as it is open, else as it is on disk."""
        path = os.path.realpath(path)
        if path in self.buffers:
            return self.buffers[path].text
        try:
            return outside.read_bytes(path).decode("utf-8-sig")
        except (OSError, UnicodeDecodeError, ValueError):
            return None

    def diagnostics(self, path: str) -> tuple[Diagnostic, ...]:
        """What there is to say of one file, in all programs that it is in."""
        view = self.view(path)
        return view.diagnostics if view is not None else ()

    def affected(self, path: str) -> tuple[str, ...]:
        """The open files of which there may be something else to say since `path` has changed."""
        path = os.path.realpath(path)
        roots = set(self.roots(path))
        return tuple(item for item in self.buffers if item == path or roots & set(self.roots(item)))

    def program(self, root: str) -> Program:
        """All that is known of a root."""
        return finished(self.programming(root))

    def programming(self, root: str) -> InPieces[Program]:
        """The same in pieces; if something changes in between, it begins anew."""
        return (yield from self._steadily(lambda: self._programming(root)))

    def _programming(self, root: str) -> InPieces[Program]:
        if root not in self._programs:
            self._programs[root] = yield from self._compiling(root)
        return self._programs[root]

    def trying(self, root: str, texts: Mapping[str, str], look: Callable[[Program], _T]) -> InPieces[_T]:
        """What there is to see of a root where some files have other texts; nothing is changed by it."""
        branches: dict[str, Parts] = {}

        def read(source: Source) -> InParts:
            known = self._parts.get(source.path)
            if source.path not in branches:
                branches[source.path] = Parts(parse=parse) if known is None else known.branch()
            return branches[source.path].read(source)

        with self._memories.setdefault(root, Memory()).trial():
            return look((yield from self._compiling(root, texts, read)))

    def _read(self, source: Source) -> InParts:
        return self._parts.setdefault(source.path, Parts(parse=parse)).read(source)

    def _compiling(
        self, root: str, others: Mapping[str, str] | None = None, read: Read | None = None
    ) -> InPieces[Program]:
        options, problems = self.project.options(Path(root))
        texts = {path: buffer.text for path, buffer in self.buffers.items()} | dict(others or {})
        memory = self._memories.setdefault(root, Memory())
        inspection = yield from inspecting(root, texts, options, memory, read or self._read)
        analysis = inspection.analysis
        diagnostics = as_notes(in_order((*problems, *analysis.diagnostics)))
        suppressed = analysis.suppressed
        yield
        if analysis.system is not None and not has_errors(diagnostics):
            found, allowed = self.project.code(Path(root), analysis.system)
            diagnostics = self.project.without_read(Path(root), analysis.system, diagnostics)
            found = options.policy.apply(tuple(map(inspection.loaded.layout.diagnostic, found)))
            diagnostics = in_order((*without_told(diagnostics, found), *found))
            suppressed += allowed
        is_root = self._header(root).is_system and not analysis.is_library
        if not is_root:
            diagnostics = tuple(item for item in diagnostics if not isinstance(item.problem, NoSystem))
        indexer = self._indexer(memory, inspection)

        def tried(texts: Mapping[str, str]) -> Analysis:
            return finished(self.trying(root, texts, lambda found: found.inspection.analysis))

        return Program(root, inspection, diagnostics, suppressed, indexer, memory.recall, tried)

    def _indexer(self, memory: Memory, inspection: Inspection) -> Indexer:
        """`occurrences`, with what is known of declarations that have not changed since."""
        symbols = memory.shared("symbols", inspection.symbols)

        def indexed(declaration: tree.Declaration, world: World) -> tuple[Occurrence, ...]:
            if memory.is_about("symbols", inspection.symbols):
                return memory.recall(
                    _occurrences,
                    declaration,
                    symbols,
                    world.roles,
                    world.realised,
                    world.included,
                    world.supplied,
                    world.participants,
                )
            return occurrences(declaration, world)  # of an earlier moment

        return indexed

    def _viewing(self, path: str) -> InPieces[View | None]:
        if path in self._views:
            return self._views[path]
        text = self.text(path)
        if text is None:
            return None
        programs = []
        for root in self.roots(path):
            programs.append((yield from self._programming(root)))
        found = in_order(
            item for program in programs for item in program.diagnostics if program.place_of(item) == path
        )
        buffer = self.buffers.get(path)
        program = programs[0]
        file = program.files.get(path)
        source = file.source if file is not None else Source(path, text)
        version = buffer.version if buffer is not None else None
        view = View(path, source, version, program, found)
        if any(item.code.startswith("E1") for item in found):
            view = replace(view, earlier=self._good.get(path))
        else:
            self._good[path] = view
        self._views[path] = self._recent[path] = view
        self._edits.pop(path, None)
        return view

    # ---- which files belong together -----------------------------------------------------------

    def roots(self, path: str) -> tuple[str, ...]:
        """The files through which `path` is looked at: systems that import it, or it alone."""
        path = os.path.realpath(path)
        header = self._header(path)
        if header.is_system:
            return (path,)
        importers = self._importers()
        found: dict[str, None] = {}
        seen = {path}
        waiting = [path]
        while waiting:
            for other in importers.get(waiting.pop(), ()):
                if other not in seen:
                    seen.add(other)
                    waiting.append(other)
                    if self._header(other).is_system:
                        found[other] = None
        return tuple(sorted(found)) or (path,)

    def _importers(self) -> Mapping[str, set[str]]:
        """Which of the files that are known import each file."""
        found: dict[str, set[str]] = {}
        for path in self.files():
            for target in imported(path, self._header(path)):
                found.setdefault(target, set()).add(path)
        return found

    def files(self) -> tuple[str, ...]:
        """Every file of the folders that are open, and of those in which open files are."""
        folders = dict.fromkeys(os.path.realpath(folder) for folder in self.folders)
        for path in self.buffers:
            if not any(Path(path).is_relative_to(folder) for folder in folders):
                folders[str(Path(path).parent)] = None
        found = dict.fromkeys(self.buffers)
        for folder in folders:
            for path in files_below(folder):
                if len(found) >= MOST_FILES:
                    return tuple(found)
                found[path] = None
        return tuple(found)

    def _header(self, path: str) -> Header:
        buffer = self.buffers.get(path)
        key: object = buffer.text if buffer is not None else _stamp(path)
        known = self._headers.get(path)
        if known is None or known[0] != key:
            known = self._headers[path] = (key, header_of(self.text(path) or ""))
        return known[1]


def imported(path: str, header: Header) -> Iterator[str]:
    """Where the files are that a file imports."""
    for target in header.imports:
        yield os.path.realpath(Path(path).parent / target)
    for name in header.libraries:
        yield os.path.realpath(standard_library() / f"{name}.aseme")


def files_below(folder: str) -> Iterator[str]:
    """Every `*.aseme` file at any depth, but for hidden folders and virtual environments."""
    for root, folders, names in os.walk(folder):
        folders[:] = sorted(
            name
            for name in folders
            if not name.startswith(".")
            and name != "node_modules"
            and not Path(root, name, "pyvenv.cfg").exists()
        )
        yield from (os.path.realpath(Path(root, name)) for name in sorted(names) if name.endswith(".aseme"))


def _stamp(path: str) -> object:
    """What changes when a file on disk does."""
    try:
        found = Path(path).stat()
    except (OSError, ValueError):
        return None
    return found.st_mtime_ns, found.st_size


__all__ = ["Buffer", "Header", "Project", "Workspace", "files_below", "header_of", "imported"]
