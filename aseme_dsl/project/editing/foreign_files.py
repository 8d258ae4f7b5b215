"""Foreign files: those that an import is given, and what lies beside them that it needs."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import field, replace
from pathlib import Path

from aseme_dsl import outside
from aseme_dsl.compiler.read.load import read_source
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems.files import FileTooLarge, ForeignNotRead
from aseme_dsl.interop.emf.meaning import Known
from aseme_dsl.interop.emf.system import MODELS
from aseme_dsl.interop.machines.system import MACHINES
from aseme_dsl.interop.proto import ProtoImport, files_behind, join, read_proto
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

LARGEST = 8_000_000
"""In bytes; the largest model of the originals has 26 thousand."""
_MOST_PROTOS = 500
"""How many .proto files beside a model are looked at."""
_SCXML = re.compile(r"<(?:\w+:)?scxml[\s>]")
_HEADERS = (".h", ".hh", ".hpp")
_MESSAGE = re.compile(r"\bmessage\s+(\w+)\s*\{", re.ASCII)
_USED = re.compile(r"\b_?\w+\.(?:State|Signal|Data)\.(\w+)", re.ASCII | re.IGNORECASE)
_DEFINED = re.compile(
    r"^[ \t]*(?:#[ \t]*define[ \t]+(\w+)[ \t]+\(?(-?[0-9]{1,9})\)?[ \t]*(?://.*|/\*.*)?$"
    r"|(?:static[ \t]+)?(?:const|constexpr)[ \t]+(?:static[ \t]+)?(?:unsigned[ \t]+)?int[ \t]+(\w+)"
    r"[ \t]*=[ \t]*(-?[0-9]{1,9})[ \t]*;)",
    re.MULTILINE | re.ASCII,
)
_ENUM = re.compile(r"\benum\b[^{};]{0,100}\{([^{}]{0,20000})\}", re.ASCII)
_ENUM_ITEM = re.compile(r"\s*(\w+)\s*(?:=\s*(-?[0-9]{1,9}))?\s*", re.ASCII)
_CPP_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


@dataclass(slots=True)
class ForeignFiles:
    """The files by kind, as texts. `protos` are those that models need."""

    models: list[Source] = field(default_factory=list)
    monas: list[Source] = field(default_factory=list)
    machines: list[Source] = field(default_factory=list)
    constants: dict[str, int] = field(default_factory=dict)
    protos: list[Path] = field(default_factory=list)
    imports: list[ProtoImport] = field(default_factory=list)
    diagnostics: list[Diagnostic] = field(default_factory=list)

    @property
    def known(self) -> Known:
        enums, messages, _ = join(self.imports, ())
        return Known(
            {item.name: item for item in messages}, {item.name: item for item in enums}, self.constants
        )

    def copies(self) -> Iterator[tuple[str, bytes]]:
        """The .proto files for the new project, with those that they import, by their names there."""
        done: set[str] = set()
        for path in self.protos:
            behind = sorted(files_behind(path.resolve()))
            for other in (path.resolve(), *behind):
                name = next(
                    (
                        file.name
                        for item in self.imports
                        for file in item.files
                        if other.as_posix().endswith(f"/{file.name}")
                    ),
                    other.name,
                )
                if name not in done and other.is_file():
                    done.add(name)
                    yield name, outside.read_bytes(other)


def gather(paths: Sequence[Path]) -> ForeignFiles:
    """Read the files of an import. What is wrong with one is a diagnostic."""
    found = ForeignFiles()
    protos: list[Path] = []
    for path in paths:
        ending = path.suffix.lower()
        if ending == ".proto":
            protos.append(path)
            continue
        source = _read(path)
        if isinstance(source, Diagnostic):
            found.diagnostics.append(source)
        elif ending in MODELS:
            found.models.append(source)
        elif ending in MACHINES or (ending == ".xml" and _SCXML.search(source.text) is not None):
            found.machines.append(source)
        elif ending == ".xml":
            found.monas.append(source)
        elif ending in _HEADERS:
            found.constants |= dict(_constants(source.text))
        else:
            reason = f"`{ending or path.name}` is not the ending of a known format"
            found.diagnostics.append(Diagnostic(ForeignNotRead(str(path), reason), None, path=str(path)))
    used = {name for source in found.models for name in _USED.findall(source.text)}
    beside = [
        path
        for folder in dict.fromkeys(Path(source.path).parent for source in found.models)
        for path in sorted(folder.glob("*.proto"))[:_MOST_PROTOS]
    ]
    _read_protos(found, protos, beside, used)
    return found


def _read(path: Path) -> Source | Diagnostic:
    source = read_source(path, largest=LARGEST)
    if isinstance(source, Diagnostic):
        problem = source.problem
        if isinstance(problem, FileTooLarge):  # without the advice for sources
            problem = FileTooLarge(problem.path, problem.size, problem.most)
        return replace(source, problem=problem)
    return Source(source.path, source.text.removeprefix("\ufeff").replace("\r\n", "\n"))


def _read_protos(found: ForeignFiles, given: Sequence[Path], beside: Iterable[Path], used: set[str]) -> None:
    """Read the .proto files that declare a message which is used: those that are given, then those beside."""
    declared: set[str] = set()
    for path in dict.fromkeys([*given, *beside]):
        source = _read(path)
        if isinstance(source, Diagnostic):
            found.diagnostics.append(source)
            continue
        names = set(_MESSAGE.findall(source.text)) & used - declared
        if not names or path.name in {other.name for other in found.protos}:
            continue
        read, problems = read_proto(source, path.resolve(), {}, Span(source, 0, min(1, len(source.text))))
        found.diagnostics += problems
        if read is not None:
            declared |= names
            found.protos.append(path)
            found.imports.append(read)


def _constants(text: str) -> Iterator[tuple[str, int]]:
    """The whole numbers that a header of C++ gives names to."""
    for first, value, second, other in _DEFINED.findall(text):
        yield first or second, int(value or other)
    for body in _ENUM.findall(_CPP_COMMENT.sub(" ", text)):
        number = 0
        for item in body.split(","):
            read = _ENUM_ITEM.fullmatch(item)
            if read is None:
                break
            number = int(read[2]) if read[2] else number
            yield read[1], number
            number += 1


__all__ = ["ForeignFiles", "gather"]
