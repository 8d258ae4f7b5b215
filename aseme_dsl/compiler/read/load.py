"""Load: a file and all that it imports, from disk or from an editor's buffers."""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Callable, Iterable, Mapping
from dataclasses import field, replace
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl import outside
from aseme_dsl.compiler.read.aliases import Imported, qualified, spellings
from aseme_dsl.compiler.read.names import Spellings
from aseme_dsl.diagnostics import Diagnostic, Problem, Related, closest, has_errors, surely
from aseme_dsl.diagnostics.problems import files as problems
from aseme_dsl.diagnostics.problems.names import AliasOfProto
from aseme_dsl.grammar.parsing.parts import NO_PARTS, InParts, Layout
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, library_path
from aseme_dsl.standard_library import standard_library

if TYPE_CHECKING:
    from aseme_dsl.interop.proto import ProtoImport

LARGEST = 20_000_000
"""The size limit of one file, in bytes, unless told otherwise."""

LANGUAGE = 1
"""The version of the language that this compiler knows."""


_DECLARED = re.compile(
    r"\b(?:enum|message|topic|function|let|var|actor|role|usecase|aip|participant|srm)\s+(\w+)"
)


@dataclass(frozen=True, slots=True)
class Loaded:
    """What was read. `files` come in import order, each after those that it imports, the root last.

    A file that could not be read is missing and has a diagnostic; `protos` are the imported .proto files.
    """

    files: tuple[tree.File, ...]
    protos: tuple[ProtoImport, ...]
    diagnostics: tuple[Diagnostic, ...]
    lost: frozenset[str] = frozenset()
    """Names that a file with syntax errors declares where it could not be read."""
    complete: bool = True
    """Whether every file that is imported could be read."""
    paths: Mapping[str, str] = field(default_factory=dict)
    """Where each file that was looked for really is, by the path that its places show."""
    layout: Layout = NO_PARTS
    """Where the parts of files begin in them."""
    spellings: Spellings = field(default_factory=dict)
    """How each file writes the names that differ in the models, for the sake of an alias."""


@dataclass(frozen=True, slots=True)
class _Place:
    """A file: `key` says which one it is, `shown` is the path that people know it by."""

    key: str
    shown: str


@dataclass(slots=True)
class _Reading:
    """A file on the way from the root to the one that is being read, with the imports still to follow."""

    place: _Place
    parsed: tree.File
    waiting: list[tree.Import]
    entered_by: tree.Import | None


@dataclass(slots=True)
class _Loader:
    """The state of one `load`: what was read so far, and in which order."""

    sources: Mapping[str, str]
    buffers: Mapping[str, str]
    largest: int
    files: list[tuple[str, tree.File]] = field(default_factory=list)
    imports: list[Imported] = field(default_factory=list)
    protos: list[ProtoImport] = field(default_factory=list)
    diagnostics: list[Diagnostic] = field(default_factory=list)
    lost: set[str] = field(default_factory=set)
    paths: dict[str, str] = field(default_factory=dict)
    read: Read | None = None
    read_before: KnownProtos = field(default_factory=dict)
    places: dict[Source, tuple[Source, int, int]] = field(default_factory=dict)


Read = Callable[[Source], InParts]
"""Reads the text of a file, with what it knows of earlier versions of it."""

KnownProtos = dict[str, tuple[str, "ProtoImport"]]
"""The text of each .proto file that was read, by where it is, and what protoc has made of it."""


def load(
    root: Source | Path | str,
    sources: Mapping[str, str] | None = None,
    *,
    largest: int = LARGEST,
    read: Read | None = None,
    protos: KnownProtos | None = None,
) -> Loaded:
    """Read and parse `root` (a path, or a text that was read already) and everything that it imports.

    A path that is a key of `sources` (texts of an editor, say) is taken from there and not from the disk.
    Without `read`, every file is read in one piece. In `protos` is kept what .proto files have said: protoc
    is asked again only if one of them, or one that it imports, has changed.
    """
    sources = sources or {}
    loader = _Loader(sources, {_key(path): text for path, text in sources.items()}, largest, read=read)
    loader.read_before = {} if protos is None else protos
    place = _Place(_key(str(root.path)), root.path) if isinstance(root, Source) else _place(str(root))
    loader.paths[place.shown] = place.key
    parsed = _parsed(loader, root if isinstance(root, Source) else place, None)
    if parsed is not None:
        _follow(loader, _Reading(place, parsed, _imports(parsed), None))
    all_read = not has_errors(loader.diagnostics)
    files, found, lost = qualified(loader.files, loader.imports, all_read)
    loader.diagnostics += found
    loader.lost |= lost
    complete = not any(isinstance(item.problem, problems.Unread) for item in loader.diagnostics)
    return Loaded(
        files,
        tuple(loader.protos),
        tuple(loader.diagnostics),
        frozenset(loader.lost),
        complete,
        loader.paths,
        Layout(loader.places) if loader.places else NO_PARTS,
        spellings(loader.files, loader.imports),
    )


def _key(path: str) -> str:
    """The path of the file itself, with all links resolved."""
    try:
        return os.path.realpath(path)
    except ValueError:  # a NUL character: reading it says so
        return path


def _key_beside(folder: str, target: str) -> str:
    """The file that a path means from a folder, to which no links lead."""
    path = os.path.join(folder, target)  # noqa: PTH118
    is_simple = os.path.basename(target) == target and target not in ("", os.curdir, os.pardir)  # noqa: PTH119
    return path if is_simple and "\0" not in path and not os.path.islink(path) else _key(path)  # noqa: PTH114


def _place(path: str) -> _Place:
    # A file's name may be any bytes; where it is shown (a comment, JSON, SVG), it must be one line of text.
    return _Place(_key(path), "".join(char if char.isprintable() else "?" for char in path))


def _imports(parsed: tree.File) -> list[tree.Import]:
    """The imports of a file, the first one last (they are taken from the end)."""
    return [item for item in reversed(parsed.declarations) if isinstance(item, tree.Import)]


def _follow(loader: _Loader, root: _Reading) -> None:
    """Depth first, without recursion; the stack is the chain of imports from the root."""
    stack = [root]
    started = {root.place.key}
    while stack:
        reading = stack[-1]
        if not reading.waiting:
            loader.files.append((reading.place.key, reading.parsed))
            stack.pop()
            continue
        item = reading.waiting.pop()
        place = _target(item, reading.place)
        if place is not None:
            loader.imports.append(Imported(reading.place.key, place.key, item))
        if place is None or place.key in started:
            if place is None:
                loader.diagnostics.append(_not_found(item, _library()))
            elif any(other.place.key == place.key for other in stack):
                loader.diagnostics.append(_circle(stack, place, item))
            continue
        started.add(place.key)
        loader.paths[place.shown] = place.key
        if place.key.endswith(".proto"):
            if item.alias is not None:
                problem = AliasOfProto(item.alias.text)
                loader.diagnostics.append(Diagnostic(problem, item.alias.span))
            _load_proto(loader, place, item)
            continue
        parsed = _parsed(loader, place, item)
        if parsed is not None:
            stack.append(_Reading(place, parsed, _imports(parsed), item))


def _target(item: tree.Import, importer: _Place) -> _Place | None:
    """The file that an import means; None for a name that the standard library does not have."""
    if isinstance(item.target, tree.Name):
        path = standard_library() / f"{item.target.text}.aseme"
        if not outside.is_file(path):
            return None
        # People know it by the import's name: where it is installed differs from machine to machine.
        return _Place(_key(str(path)), library_path(f"{item.target.text}.aseme"))
    target = item.target.text
    key = _key_beside(os.path.dirname(importer.key), target)  # noqa: PTH120 (of many files)
    shown = os.path.join(os.path.dirname(importer.shown), target)  # noqa: PTH118, PTH120
    return _Place(key, os.path.normpath(shown))


def _library() -> list[str]:
    return [path.stem for path in standard_library().glob("*.aseme")]


def _circle(stack: list[_Reading], place: _Place, item: tree.Import) -> Diagnostic:
    first = next(index for index, other in enumerate(stack) if other.place.key == place.key)
    names = [Path(other.place.shown).name for other in stack[first:]]
    related = tuple(
        Related(other.entered_by.span, f"{Path(other.place.shown).name} is imported here")
        for other in stack[first + 1 :]
        if other.entered_by is not None
    )
    return Diagnostic(problems.ImportCycle(tuple(names)), item.target.span, related)


def _not_found(item: tree.Import, known: Iterable[str]) -> Diagnostic:
    name = item.target.text
    near = closest(name, known)
    is_neighbour = outside.is_file(Path(item.span.source.path).parent / f"{name}.aseme")
    fix = f'"{name}.aseme"' if is_neighbour else surely(name, known)
    problem = problems.NoLibrary(name, near, tuple(sorted(known)), is_neighbour)
    return Diagnostic(problem, item.target.span, fix=fix)


def _parsed(loader: _Loader, given: Source | _Place, item: tree.Import | None) -> tree.File | None:
    """The tree of a file, or None with a diagnostic; a root that cannot be read has no place but its path."""
    if isinstance(given, _Place):
        source = _read(loader, given, item)
    elif given.text.startswith("\ufeff"):
        source = Source(given.path, given.text[1:])
    else:
        source = given
    if source is None:
        return None
    if not source.text.strip():
        loader.diagnostics.append(_about(source.path, item, problems.EmptyFile(source.path)))
    if len(source.text) > loader.largest:
        loader.diagnostics.append(_too_large(source.path, item, len(source.text), loader.largest))
        return None
    parsed, found = _syntax(loader, source)
    newer = _language(parsed)
    if newer is not None:
        # What a newer language has would only look like mistakes here.
        loader.diagnostics.append(newer)
        return None
    loader.diagnostics.extend(found)
    if has_errors(found):
        loader.lost |= set(_DECLARED.findall(source.text)) - _declared(parsed)
    return parsed


def _syntax(loader: _Loader, source: Source) -> tuple[tree.File, tuple[Diagnostic, ...]]:
    """The tree of a text, and what is wrong with its syntax."""
    if loader.read is None:
        from aseme_dsl.grammar import parse

        return parse(source)
    found = loader.read(source)
    loader.places.update(found.layout.places)
    return found.file, found.diagnostics


def _declared(parsed: tree.File) -> set[str]:
    """The names that the tree declares at the top, in roles and in protocols."""
    found = set()
    for item in parsed.declarations:
        if isinstance(item, (tree.Enum, tree.Message, tree.Topic, tree.Function, tree.Let)):
            found.add(item.name.text)
        elif isinstance(item, (tree.Srm, tree.Statechart, tree.Aip)):
            found.add(item.name.text)
            found |= {let.name.text for let in item.lets}
            owners = item.participants if isinstance(item, tree.Aip) else (item,)
            for owner in owners:
                found.add(owner.name.text)
                found |= {variable.name.text for variable in owner.variables}
                found |= {let.name.text for let in owner.lets}
    return found


def _language(parsed: tree.File) -> Diagnostic | None:
    number = parsed.language
    if number is None or number.value == LANGUAGE:
        return None
    if number.value > LANGUAGE:
        return Diagnostic(problems.NewerLanguage(int(number.value), LANGUAGE), number.span)
    problem = problems.NoSuchLanguage(int(number.value), LANGUAGE)
    return Diagnostic(problem, number.span, fix=str(LANGUAGE))


def _about(path: str, item: tree.Import | None, problem: Problem, fix: str | None = None) -> Diagnostic:
    """A problem of a whole file: at the import that asks for it, or (the root) at no place in a text."""
    if item is None:
        return Diagnostic(problem, None, path=path)
    return Diagnostic(problem, item.target.span, fix=fix)


def _too_large(path: str, item: tree.Import | None, size: int, largest: int) -> Diagnostic:
    return _about(path, item, problems.SourceTooLarge(path, size, largest))


def _read(loader: _Loader, place: _Place, item: tree.Import | None) -> Source | None:
    """The text of a file, or None with a diagnostic."""
    text = loader.sources.get(place.shown, loader.buffers.get(place.key))
    if text is not None:
        return Source(place.shown, text.removeprefix("\ufeff"))
    content = _content(loader, place, item)
    if isinstance(content, Diagnostic):
        loader.diagnostics.append(content)
        return None
    return Source(place.shown, content)


def read_source(path: Path, *, largest: int = LARGEST) -> Source | Diagnostic:
    """A file as it is, its byte-order mark included; or what is wrong with it (E001, E002, E003)."""
    loader = _Loader({}, {}, largest)
    content = _content(loader, _Place(str(path), str(path)), None, "utf-8")
    return content if isinstance(content, Diagnostic) else Source(str(path), content)


def _content(
    loader: _Loader, place: _Place, item: tree.Import | None, encoding: str = "utf-8-sig"
) -> str | Diagnostic:
    def fail(problem: Problem, fix: str | None = None) -> Diagnostic:
        return _about(place.shown, item, problem, fix)

    try:
        found = Path(place.key).stat()
        if not stat.S_ISREG(found.st_mode):
            return fail(problems.NotRegularFile(place.shown, stat.S_ISDIR(found.st_mode)))
        if found.st_size > loader.largest:
            return _too_large(place.shown, item, found.st_size, loader.largest)
        content = outside.read_bytes(place.key, loader.largest)
    except FileNotFoundError:
        library = Path(place.key).name.removesuffix(".aseme")
        if item is not None and library in _library():
            return fail(problems.LibraryByPath(place.shown, library), library)
        missing = problems.NoFile if item is None else problems.ImportedFileMissing
        return fail(missing(place.shown, _neighbour(place)))
    except (OSError, ValueError) as problem:  # ValueError: a path with a NUL character
        reason = problem.strerror if isinstance(problem, OSError) and problem.strerror else str(problem)
        return fail(problems.CannotBeRead(place.shown, reason))
    if b"\0" in content:
        return fail(problems.NotText(place.shown, content.index(0)))
    try:
        return content.decode(encoding)
    except UnicodeDecodeError as problem:
        line = content.count(b"\n", 0, problem.start) + 1
        return fail(problems.NotUtf8(place.shown, content[problem.start], line))


def _neighbour(place: _Place) -> str | None:
    """The file of the folder whose name is spelt alike."""
    folder = Path(place.key).parent
    try:
        return closest(Path(place.key).name, [path.name for path in folder.iterdir() if path.is_file()])
    except (OSError, ValueError):
        return None


def _load_proto(loader: _Loader, place: _Place, item: tree.Import) -> None:
    source = _read(loader, place, item)
    if source is None:
        return
    from aseme_dsl.interop.proto import is_current, read_proto

    buffers = {Path(path): text for path, text in loader.buffers.items()}
    text, known = loader.read_before.get(place.key, ("", None))
    if known is not None and text == source.text and is_current(known, source, Path(place.key), buffers):
        known = known if known.at == item.target.span else replace(known, at=item.target.span)
        loader.read_before[place.key] = (text, known)
        loader.protos.append(known)
        return
    loader.read_before.pop(place.key, None)
    found, diagnostics = read_proto(source, Path(place.key), buffers, item.target.span)
    loader.diagnostics.extend(diagnostics)
    if found is not None:
        loader.protos.append(found)
        if not diagnostics:
            loader.read_before[place.key] = (source.text, found)
